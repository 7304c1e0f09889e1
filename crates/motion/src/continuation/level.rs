//! Functions of orbits beside those of bifurcations: told along a curve where they take a value, or held at
//! one along a curve in two parameters.

use super::Bifurcation;

/// A function of an orbit at its parameters; none where it is not defined.
pub type Measure<'a, O> = Box<dyn Fn(&O, &[f64]) -> Option<f64> + 'a>;

/// A value that a function of orbits takes.
pub struct Level<'a, O> {
    /// The function's name, of which labels are made.
    pub name: String,
    /// The function.
    pub of: Measure<'a, O>,
    /// The value.
    pub value: f64,
}

impl<O> Level<'_, O> {
    /// How far the function is from the value, as a part of it unless it is 0.
    pub(super) fn off(&self, orbit: &O, parameters: &[f64]) -> Option<f64> {
        let size = if self.value == 0.0 { 1.0 } else { self.value.abs() };
        (self.of)(orbit, parameters).map(|x| (x - self.value) / size).filter(|x| x.is_finite())
    }
}

/// What stays along a curve in two parameters.
pub enum Kept<'a, O> {
    /// A bifurcation.
    Event(Bifurcation),
    /// A function's value.
    Level(&'a Level<'a, O>),
}

impl<O> Kept<'_, O> {
    /// The bifurcation, if it is one.
    pub(super) fn event(&self) -> Option<Bifurcation> {
        match self {
            Kept::Event(event) => Some(*event),
            Kept::Level(_) => None,
        }
    }
}

/// Whether a function that changes its sign at a point has a zero there, its values at lengths along the
/// curve from it being given: where it jumps, or has a pole, it is as large as beside it.
pub(super) fn vanishes(at: impl Fn(f64) -> Option<f64>) -> bool {
    let size = |by: f64| at(by).map_or(f64::INFINITY, f64::abs);
    size(0.0) <= PASSED * size(-ASIDE).max(size(ASIDE))
}

/// So far beside an event it is looked whether a function jumps there.
const ASIDE: f64 = 1e-4;
/// A part of what a function is there: at a zero it is less.
const PASSED: f64 = 0.1;
