//! The checks on the options of continuation; their names, units, meanings and defaults are declared as keys of a scene.

use super::curve::Corrector;
use crate::error::{Error, Result};
pub use crate::oscillator::scene::branches::Options;

impl Default for Options {
    fn default() -> Self {
        Options {
            step: 0.01,
            least_step: 1e-7,
            most_step: 0.1,
            turn: 0.2,
            points: 2000,
            tolerance: 1e-11,
            newton: 8,
            beyond: false,
        }
    }
}

impl Options {
    /// The options, if they make sense.
    ///
    /// # Errors
    /// An input error that names the option, its value and what it may be.
    pub fn checked(&self) -> Result<Options> {
        let positive = |x: f64| x > 0.0 && x.is_finite();
        let claims = [
            (positive(self.least_step), "least_step", self.least_step, "a positive number"),
            (positive(self.step) && self.step >= self.least_step, "step", self.step, "at least least_step"),
            (
                positive(self.most_step) && self.most_step >= self.step,
                "most_step",
                self.most_step,
                "at least step",
            ),
            (
                positive(self.turn) && self.turn <= 1.0,
                "turn",
                self.turn,
                "an angle of more than 0 and at most 1",
            ),
            (self.points > 0, "points", self.points.into(), "at least 1"),
            ((1e-14..=1e-4).contains(&self.tolerance), "tolerance", self.tolerance, "from 1e-14 to 1e-4"),
            (self.newton > 1, "newton", self.newton.into(), "at least 2"),
        ];
        match claims.into_iter().find(|claim| !claim.0) {
            Some((_, name, value, want)) => Err(Error::input(format!("{name} = {value} must be {want}"))),
            None => Ok(self.clone()),
        }
    }

    pub(super) fn corrector(&self) -> Corrector {
        Corrector { tolerance: self.tolerance, steps: self.newton }
    }
}
