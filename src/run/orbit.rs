//! Tasks of kind `orbit`: periodic orbits of a pattern.

use serde::Serialize;

use super::{Complex, Finding, Job, Judgement, Lines, Row, Status, row};
use crate::{
    continuation::Bifurcation,
    error::Result,
    number::{Plain, Real},
    one::orbit::{Admissibility, Orbit},
    scene::orbits::OrbitTask,
};

row! {
    /// A solution of the pattern equations.
    pub struct OrbitRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// The impact pattern.
        pub pattern: String,
        /// The times t_i of its impacts, as its pattern counts them: t_1 in [0, 2π), and impact i + 1 is 2π
        /// n_i + t_{i+1} − t_i after impact i.
        pub phases: Vec<f64>,
        /// Their incoming relative speeds.
        pub speeds: Vec<f64>,
        /// The larger multiplier.
        pub lambda1: Complex,
        /// The smaller.
        pub lambda2: Complex,
        /// Whether both are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit: impacts come in, no other contact.
        pub admissible: Judgement,
        /// Why not.
        pub reason: Option<String>,
        /// The least minimum of a gap away from the impacts.
        pub least_gap: Option<f64>,
        /// What is left of the equations.
        pub residual: f64,
    }
}

row! {
    /// A value without a solution.
    pub struct MissingRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// Why there is none.
        pub reason: String,
    }
}

/// The orbits that were found, and where there are none.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitList<R> {
    /// Solutions, by value, then by speed.
    pub orbits: Vec<R>,
    /// Values without any.
    pub missing: Vec<MissingRow>,
    /// How many values were asked for.
    #[serde(skip)]
    values: usize,
}

/// The orbits of an oscillator.
pub type OrbitFindings = OrbitList<OrbitRow>;

impl<R: Row + Serialize> Finding for OrbitList<R> {
    fn status(&self) -> Status {
        match self.missing.as_slice() {
            [] => Status::Done,
            [MissingRow { value: None, reason }] => Status::nothing(reason.clone()),
            [first, ..] => Status::nothing(format!(
                "no solution at {} of {} values; at {}: {}",
                self.missing.len(),
                self.values,
                first.value.unwrap_or(f64::NAN),
                first.reason
            )),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        lines.table("orbits", &self.orbits);
        if !self.missing.is_empty() {
            lines.table("missing", &self.missing);
        }
    }
}

impl<R> OrbitList<R> {
    /// The orbits that `find` finds at each value of the task's parameter, or once if it has none; the
    /// parameter and its value are what `find` is given. Its inner error says why there is no orbit at a
    /// value; the outer one ends the task.
    ///
    /// # Errors
    /// The outer ones of `find`; an interruption.
    pub(super) fn of(
        task: &OrbitTask,
        job: &Job,
        mut find: impl FnMut(Option<(&str, f64)>) -> Result<Result<Vec<R>>>,
    ) -> Result<OrbitList<R>> {
        let places: Vec<Option<(&str, f64)>> = match &task.parameter {
            None => vec![None],
            Some(name) => {
                task.values.iter().map(|value| Some((name.as_str(), Plain::ratio(value, &()).0))).collect()
            }
        };
        let mut found = OrbitList { orbits: Vec::new(), missing: Vec::new(), values: places.len() };
        job.monitor.begin(places.len() as u64, "values");
        for place in places {
            let value = place.map(|(_, value)| value);
            match find(place)? {
                Ok(orbits) if orbits.is_empty() => {
                    found.missing.push(MissingRow { value, reason: task.orbit.none() });
                }
                Ok(orbits) => found.orbits.extend(orbits),
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => found.missing.push(MissingRow { value, reason: error.to_string() }),
            }
            job.monitor.advance(1)?;
        }
        Ok(found)
    }
}

/// Finds the orbits of a pattern, at each value of a parameter if there is one.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub fn orbit(task: &OrbitTask, job: &Job) -> Result<OrbitFindings> {
    OrbitList::of(task, job, |place| {
        let system = match place {
            Some(place) => job.scene.plain(&[place])?,
            None => job.system()?.clone(),
        };
        let orbits = task.orbit.orbits(&job.oscillator(system)?);
        let row = |orbit: &Orbit| OrbitRow::of(orbit, place.map(|(_, value)| value));
        Ok(orbits.map(|orbits| orbits.iter().map(row).collect()))
    })
}

impl OrbitRow {
    fn of(orbit: &Orbit, value: Option<f64>) -> OrbitRow {
        let [lambda1, lambda2] = orbit.multipliers.values().map(Complex::from);
        OrbitRow {
            value,
            pattern: orbit.itinerary.to_string(),
            phases: phases(orbit),
            speeds: speeds(orbit),
            lambda1,
            lambda2,
            stable: stable(orbit, None),
            admissible: admissible(orbit, None),
            reason: obstacle(orbit, None),
            least_gap: orbit.least.map(|least| least.gap),
            residual: orbit.residual,
        }
    }
}

pub(super) fn phases(orbit: &Orbit) -> Vec<f64> {
    orbit.times()
}

pub(super) fn speeds(orbit: &Orbit) -> Vec<f64> {
    orbit.impacts().map(|impact| impact.speed).collect()
}

/// Closer than this to a bifurcation, rounding decides on which side of it an orbit is.
const MARGIN: f64 = 1e-11;

/// Whether both multipliers are inside the unit circle; marginal at a bifurcation at which one is on it.
pub(crate) fn stable(orbit: &Orbit, at: Option<Bifurcation>) -> Judgement {
    let multipliers = &orbit.multipliers;
    let test = |value: f64, here: bool| match () {
        () if here || value.abs() <= MARGIN * (1.0 + multipliers.trace.abs()) => Judgement::Marginal,
        () if value > 0.0 => Judgement::Yes,
        () => Judgement::No,
    };
    let tests = [
        test(multipliers.fold(), matches!(at, Some(Bifurcation::SaddleNode | Bifurcation::Crossing))),
        test(multipliers.flip(), at == Some(Bifurcation::Flip)),
        test(1.0 - multipliers.determinant, at == Some(Bifurcation::Torus)),
    ];
    match () {
        () if tests.contains(&Judgement::No) => Judgement::No,
        () if tests.contains(&Judgement::Marginal) => Judgement::Marginal,
        () => Judgement::Yes,
    }
}

/// Whether a solution is an orbit; marginal at a grazing or where an impact fades.
pub(super) fn admissible(orbit: &Orbit, at: Option<Bifurcation>) -> Judgement {
    let margin = MARGIN * orbit.unit;
    let grazes = orbit.least.is_some_and(|least| least.gap.abs() <= margin);
    let fades = orbit.impacts().any(|impact| impact.speed.abs() <= margin);
    let others = orbit.impacts().all(|impact| impact.speed > -margin)
        && orbit.least.is_none_or(|least| least.gap > -margin);
    match (at, orbit.admissibility) {
        (Some(Bifurcation::Grazing | Bifurcation::Fade), _) => Judgement::Marginal,
        _ if others && (grazes || fades) => Judgement::Marginal,
        (_, Admissibility::Admissible) => Judgement::Yes,
        _ => Judgement::No,
    }
}

/// Why a solution is not an orbit, or marginal where that is not the bifurcation's nature: what rounding
/// decides is not said of one wall or impact.
pub(super) fn obstacle(orbit: &Orbit, at: Option<Bifurcation>) -> Option<String> {
    match (admissible(orbit, at), at) {
        (Judgement::Marginal, Some(Bifurcation::Grazing | Bifurcation::Fade)) => return None,
        (Judgement::Marginal, _) => {
            return Some("touches a wall, or an impact has no speed, to rounding".into());
        }
        _ => {}
    }
    match orbit.admissibility {
        Admissibility::Admissible => None,
        Admissibility::Outgoing(i) => Some(format!("impact {} does not come in", i + 1)),
        Admissibility::Excursion(at) => {
            Some(format!("behind the {} wall {:.6} after impact {}", at.side.name(), at.after, at.leg + 1))
        }
    }
}
