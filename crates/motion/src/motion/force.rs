//! A force that is any smooth function of displacement, velocity and the phase of the forcing.

use std::sync::Arc;

use serde::Serialize;

use crate::formula::Formula;

/// A force a(t, q, u), smooth but for poles, roots of negative numbers and the like, 2π-periodic in t: a
/// formula with coefficients of any kind. Of an oscillator it is an acceleration; of a machine with n
/// coordinates a(t, q₁, …, q_n, u₁, …, u_n). Made by a scene from `force`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SmoothForce<T> {
    /// Variables: [`Q`], [`U`], [`T`](TIME), of n coordinates q₁ to q_n, u₁ to u_n and the time; then the
    /// coefficients.
    #[serde(skip)]
    pub formula: Arc<Formula>,
    /// As it was written, without spaces.
    pub text: String,
    /// The values of its coefficients.
    pub coefficients: Vec<T>,
}

/// The displacement's place among the variables.
pub const Q: usize = 0;
/// The velocity's.
pub const U: usize = 1;
/// That of the time, an angle of the forcing.
pub const TIME: usize = 2;

impl<T> SmoothForce<T> {
    /// The numbers and parameters in it, as far as they are joined by + − · / alone.
    pub(crate) fn coefficients(&self) -> &[T] {
        &self.coefficients
    }

    /// As it was written, without spaces.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether a variable of these, known by their places, stands in it.
    pub fn mentions(&self, which: &dyn Fn(usize) -> bool) -> bool {
        self.formula.mentions(which)
    }

    /// Whether it has kinks or jumps, or powers that need not be whole.
    pub fn has_kinks(&self) -> bool {
        self.formula.has_kinks()
    }

    /// The same force with these variables' signs turned.
    pub(crate) fn turned(&self, which: &dyn Fn(usize) -> bool) -> SmoothForce<T>
    where
        T: Clone,
    {
        let variables = |place: usize| {
            let variable = Formula::Variable(place);
            if which(place) { Formula::Negated(Box::new(variable)) } else { variable }
        };
        SmoothForce { formula: Arc::new(self.formula.substituted(&variables)), ..self.clone() }
    }

    /// The same with every coefficient converted.
    ///
    /// # Errors
    /// The first error of `convert`.
    pub fn try_map<U, E>(&self, convert: &mut impl FnMut(&T) -> Result<U, E>) -> Result<SmoothForce<U>, E> {
        Ok(SmoothForce {
            formula: self.formula.clone(),
            text: self.text.clone(),
            coefficients: self.coefficients.iter().map(convert).collect::<Result<_, E>>()?,
        })
    }
}
