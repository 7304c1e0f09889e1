//! All machines that a task's tolerances allow, for its ranges: what is born of all of them, and which values
//! of the parameter have depths up to one for all.

use num_rational::BigRational;

use super::grazing::OscillatorGrazing;
use crate::{
    error::Result,
    motion::System,
    scene::{Coefficient, tolerated::ToleratedMachines},
    search::{
        chaos::Term,
        orbit::Quotient,
        range::{Born, MachineBox, ToleratedRange, born_of},
    },
    tolerance::Sloped,
};

/// The longest words that are followed.
const LETTERS: usize = 100;

/// The machines of a task's tolerances.
pub(super) struct AllMachines<'a> {
    point: &'a OscillatorGrazing<'a>,
    machines: ToleratedMachines,
    /// The places of the parameter and of those with tolerances among the scene's parameters.
    places: Vec<usize>,
}

impl<'a> AllMachines<'a> {
    /// Those of the task, or why their ranges are not looked for.
    ///
    /// # Errors
    /// Those of the scene.
    pub fn new(point: &'a OscillatorGrazing<'a>) -> Result<std::result::Result<AllMachines<'a>, String>> {
        let (task, scene) = (point.task, &point.tolerated.0);
        let machines = match point.machines()? {
            Ok(machines) => machines,
            Err(why) => return Ok(Err(why)),
        };
        let (varied, system) = (scene.parameter(&task.parameter)?, scene.system()?);
        let walls = [&system.lower, &system.upper].into_iter().flatten();
        let fixed = walls.map(|wall| &wall.restitution).chain([&system.damping, &system.stiffness]);
        let own = |name: &str| name == task.parameter;
        if fixed.into_iter().any(|expression| expression.mentions(&|place| place == varied)) {
            return Ok(Err(format!(
                "ranges over tolerances are proved where the task's own parameter, {}, changes neither damping nor \
                 stiffness nor restitution",
                task.parameter
            )));
        }
        let others =
            machines.parameters.iter().filter(|one| !own(&one.name)).map(|one| scene.parameter(&one.name));
        let places = std::iter::once(Ok(varied)).chain(others).collect::<Result<Vec<_>>>()?;
        Ok(Ok(AllMachines { point, machines, places }))
    }

    /// The system where the parameter and those with tolerances have these values.
    fn system<R: Coefficient<Context = ()>>(&self, at: &[R]) -> Result<System<R>> {
        let scene = &self.point.tolerated.0;
        let mut values: Vec<R> = scene.parameters.iter().map(|(_, value)| R::ratio(value, &())).collect();
        for (place, value) in self.places.iter().zip(at) {
            values[*place] = value.clone();
        }
        let system = scene.system()?.in_radians();
        system.try_map(|expression| expression.evaluate(&values, &()))
    }

    /// The system as a function of the parameter, of all of them.
    ///
    /// # Errors
    /// As a function of no numbers, the system's own.
    pub fn functions(&self) -> Result<System<Quotient>> {
        let own = &self.point.task.parameter;
        let others = self.machines.parameters.iter().filter(|one| one.name != *own);
        let others = others.map(|one| Quotient::between(one.bounds.each_ref()));
        let at: Vec<Quotient> = std::iter::once(Quotient::parameter()).chain(others).collect();
        self.system(&at)
    }

    /// Asks something of the box.
    fn asked<T>(&self, question: impl FnOnce(&MachineBox) -> T) -> T {
        let own = &self.point.task.parameter;
        let others = self.machines.parameters.iter().filter(|one| one.name != *own);
        let bounds = others.map(|one| one.bounds.clone()).collect();
        let sloped = |at: &[Sloped]| self.system(at);
        let exact = |at: &[BigRational]| self.system(at);
        question(&MachineBox { bounds, sloped: &sloped, exact: &exact })
    }

    /// The ranges of c, k and τ, and the wall's motion.
    ///
    /// # Errors
    /// What is not covered.
    pub fn oscillator(&self, start: &BigRational) -> Result<([[BigRational; 2]; 3], Vec<Term>)> {
        let number = |x: i64| [BigRational::from_integer(x.into()), BigRational::from_integer(x.into())];
        Ok((self.asked(|of| of.parameters(start))?, vec![(1, [number(1), number(0)])]))
    }

    /// What is born of all of them on one side; none where γ has not one sign.
    ///
    /// # Errors
    /// An interruption.
    pub fn born(&self, behind: bool, longest: u64) -> Result<Option<Born>> {
        let of = &self.machines.of;
        let Some(gamma) = of.gamma_is_positive() else { return Ok(None) };
        let word = of.word(!behind, LETTERS, self.point.job.monitor)?;
        born_of(&word, gamma, false, longest).map(Some)
    }

    /// The values of the parameter with depths up to one for all.
    ///
    /// # Errors
    /// What is not covered.
    pub fn range(
        &self,
        [at, unit]: [&BigRational; 2],
        depth: &BigRational,
        behind: bool,
    ) -> Result<Option<ToleratedRange>> {
        self.asked(|of| of.range([at, unit], depth, behind))
    }

    /// From where on all are at least as deep, up to `end`.
    pub fn deep_from(&self, end: &BigRational, depth: &BigRational, behind: bool) -> Option<BigRational> {
        let start = BigRational::from_float(self.point.event.parameter)?;
        self.asked(|of| of.deep_from(end, &start, depth, behind))
    }

    /// Whether all are as deep at a parameter.
    pub fn are_as_deep(&self, parameter: &BigRational, depth: &BigRational, behind: bool) -> bool {
        self.asked(|of| of.are_as_deep(parameter, depth, behind))
    }
}
