//! The machines that the tolerances of a scene's parameters allow.

use std::sync::Arc;

use num_rational::BigRational;
use num_traits::Zero;

use super::{
    expression::{Coefficient, Expression},
    scene::Scene,
    tolerance::{Tolerance, Tolerances},
};
use crate::{
    error::Result,
    tolerance::{Coefficients, ParameterBox, Sloped},
};

impl Coefficient for Sloped {}

/// A parameter that has a tolerance.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tolerated {
    pub name: String,
    /// Its least and greatest value.
    pub bounds: [BigRational; 2],
    /// Which coordinate of the box it is, if damping or stiffness depend on it.
    pub axis: Option<usize>,
}

/// The machines that a task's tolerances allow.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ToleratedMachines {
    pub parameters: Vec<Tolerated>,
    /// The parameters that damping and stiffness depend on; a second one is 0 where there is only one.
    pub of: ParameterBox,
}

/// Damping and stiffness of a scene with some parameters free.
#[derive(Debug)]
struct SceneCoefficients {
    damping: Expression,
    stiffness: Expression,
    values: Vec<BigRational>,
    free: Vec<usize>,
}

impl SceneCoefficients {
    fn evaluated<T: Coefficient<Context = ()>>(&self, free: &[T]) -> Result<[T; 2]> {
        let mut values: Vec<T> = self.values.iter().map(|value| T::ratio(value, &())).collect();
        for (place, value) in self.free.iter().zip(free) {
            values[*place] = value.clone();
        }
        let one = |name: &str, expression: &Expression| {
            let value = expression.evaluate(&values, &());
            value.map_err(|error| error.context(format_args!("the {name}, {expression}")))
        };
        Ok([one("damping", &self.damping)?, one("stiffness", &self.stiffness)?])
    }
}

impl Coefficients for SceneCoefficients {
    fn at(&self, point: &[BigRational]) -> Result<[BigRational; 2]> {
        self.evaluated(point)
    }

    fn over(&self, cell: &[Sloped]) -> Result<[Sloped; 2]> {
        self.evaluated(cell)
    }
}

impl Scene {
    /// The machines with damping and stiffness that tolerances allow, where one parameter, `varied`, has a
    /// value of its own; or why these are not covered.
    ///
    /// # Errors
    /// Where the engine is `many`.
    pub(crate) fn tolerated(
        &self,
        Tolerances(tolerances): &Tolerances,
        (varied, value): (&str, &BigRational),
    ) -> Result<std::result::Result<ToleratedMachines, String>> {
        let system = self.system()?;
        let moves = |name: &str| {
            let place = self.parameter(name)?;
            let in_it = |expression: &Expression| expression.mentions(&|other| other == place);
            Ok::<_, crate::Error>(in_it(&system.damping) || in_it(&system.stiffness))
        };
        if moves(varied)? && !tolerances.iter().any(|(name, _)| name == varied) {
            return Ok(Err(format!(
                "damping or stiffness change with {varied}, the task's own parameter, which is not the same \
                 where the machines touch: give {varied} a tolerance, too"
            )));
        }
        let mut values: Vec<BigRational> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        values[self.parameter(varied)?].clone_from(value);
        let (mut parameters, mut free): (Vec<Tolerated>, Vec<usize>) = (Vec::new(), Vec::new());
        for (name, tolerance) in tolerances {
            let place = self.parameter(name)?;
            let axis = moves(name)?.then_some(free.len());
            free.extend(axis.map(|_| place));
            parameters.push(Tolerated { name: name.clone(), bounds: tolerance.about(&values[place]), axis });
        }
        if let Some(Tolerated { name, .. }) = parameters
            .iter()
            .find(|one| one.name == varied && (one.bounds[0] > *value || *value > one.bounds[1]))
        {
            return Ok(Err(format!("the touch is not at a value of {name} within its tolerance")));
        }
        let moving = parameters.iter().filter(|one| one.axis.is_some());
        let bounds: Vec<_> = moving.map(|one| one.bounds.clone()).collect();
        let (damping, stiffness) = (system.damping.clone(), system.stiffness.clone());
        let of = ParameterBox::oscillator(
            Arc::new(SceneCoefficients { damping, stiffness, values, free }),
            &bounds,
        );
        Ok(of.map(|of| ToleratedMachines { parameters, of }).map_err(|error| error.to_string()))
    }

    /// Refuses tolerances that say nothing of a parameter's value, or do not hold it; not that of the task's
    /// own parameter, whose value is that at the touch.
    pub(super) fn check_tolerances(&self, all: &Tolerances, varied: &str, path: &str) -> Result<()> {
        for (name, tolerance) in all.0.iter().filter(|(name, _)| name != varied) {
            let value = &self.parameters[self.parameter(name)?].1;
            let [lower, upper] = tolerance.about(value);
            let wrong = match tolerance {
                Tolerance::Relative(_) if value.is_zero() => {
                    "is a part of 0, the parameter's value: write how far it may be off".to_string()
                }
                Tolerance::Between(_) if *value < lower || upper < *value => {
                    format!("does not hold the parameter's value, {value}")
                }
                _ => continue,
            };
            return Err(self.fail(&format!("{path}.{name}"), &wrong));
        }
        Ok(())
    }
}
