//! Coefficients in which π stands, as functions of it: what is proved of all numbers near π is proved of it.

use std::{cell::Cell, sync::Arc};

use num_rational::BigRational;

use super::{
    expression::Expression,
    scene::{Body, Scene},
    tolerance::{Tolerance, Tolerances},
};
use crate::{
    error::{Error, Result},
    formula::Formula,
    number::{Ball, Elementary, Precision},
};

/// The name of π as a parameter: no scene can have one of that name.
pub(crate) const PI: &str = "\u{3c0}";

/// The bits to which π is known then.
const BITS: u32 = 128;

impl Scene {
    /// The same scene with π as one more parameter, and with these tolerances its own: between two numbers. None
    /// where π stands in no coefficient of its oscillator.
    ///
    /// # Errors
    /// Where the engine is `many`.
    pub(crate) fn with_pi(&self, Tolerances(given): &Tolerances) -> Result<Option<(Scene, Tolerances)>> {
        let (place, is_there) = (self.parameters.len(), Cell::new(false));
        let leaf = |leaf: &Formula| match leaf {
            Formula::Pi => {
                is_there.set(true);
                Formula::Variable(place)
            }
            other => other.clone(),
        };
        let replaced = |expression: &Expression| {
            let root = expression.root.replaced(&leaf);
            Ok::<_, Error>(Expression::of(&root, &expression.text, &expression.key))
        };
        // Nothing is proved of forces that are formulas, nor of velocities.
        let system = self.system()?.in_radians().try_map(replaced)?;
        let bounds = <Ball as Elementary>::pi(&Precision::new(BITS)).exact_bounds();
        let (true, Some((lower, upper))) = (is_there.get(), bounds) else { return Ok(None) };
        let mut scene = self.alone(&[])?;
        scene.body = Body::Oscillator(Arc::new(system));
        let middle = (&lower + &upper) / BigRational::from_integer(2.into());
        scene.parameters.push((PI.to_string(), middle));
        let hidden = (PI.to_string(), Tolerance::Between([lower, upper]));
        Ok(Some((scene, Tolerances(given.iter().cloned().chain([hidden]).collect()))))
    }
}
