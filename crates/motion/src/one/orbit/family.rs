//! Oscillators that differ in one parameter.

use super::Oscillator;
use crate::error::Result;

/// Oscillators that differ in one parameter.
pub trait Family: Sync {
    /// The oscillator at a parameter value; with a slope if derivatives in the parameter will be asked for.
    ///
    /// # Errors
    /// An input error where the system is not defined.
    fn at(&self, parameter: f64) -> Result<Oscillator>;
}

impl<F: Fn(f64) -> Result<Oscillator> + Sync> Family for F {
    fn at(&self, parameter: f64) -> Result<Oscillator> {
        self(parameter)
    }
}
