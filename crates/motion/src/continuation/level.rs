//! Functions of orbits beside those of bifurcations: told along a curve where they take a value, or held at
//! one along a curve in two parameters.

/// A function of an orbit at its parameters; none where it is not defined.
type Measure<'a, O> = Box<dyn Fn(&O, &[f64]) -> Option<f64> + 'a>;

/// A value that a function of orbits takes.
pub struct Level<'a, O> {
    /// The function's name, of which labels are made.
    pub name: String,
    /// The function.
    pub of: Measure<'a, O>,
    /// The value.
    pub value: f64,
}

/// A function that changes its sign and is no smaller there, as a part of its value, jumps or has a pole.
const PASSED: f64 = 1e-6;

impl<O> Level<'_, O> {
    /// How far the function is from the value, as a part of it unless it is 0.
    pub(super) fn off(&self, orbit: &O, parameters: &[f64]) -> Option<f64> {
        let size = if self.value == 0.0 { 1.0 } else { self.value.abs() };
        (self.of)(orbit, parameters).map(|x| (x - self.value) / size).filter(|x| x.is_finite())
    }

    /// Whether the function has its value where it changes sides.
    pub(super) fn is_at(&self, orbit: &O, parameters: &[f64]) -> bool {
        self.off(orbit, parameters).is_some_and(|off| off.abs() <= PASSED)
    }
}
