//! What rounding leaves: one limit for a question, wherever it is asked.
//!
//! What stands here is asked in several places. A limit of one place stands there; all are in
//! docs/tolerances.md.

/// Sums of floats below this part of their terms have no sign, and numbers that differ by less of themselves
/// are one: to the rounding of some thousand operations.
pub const SUM: f64 = 1e-12;
/// Phases this near, in radians, are one: a minimum's place is known to the root of its value's rounding.
pub const PHASE: f64 = 1e-6;
/// Components of a unit vector below this are 0, after some eliminations.
pub const DIRECTION: f64 = 1e-9;
/// A multiplier of a motion without impacts this near the unit circle is on it; an orbit this near a
/// bifurcation is at it.
pub const CIRCLE: f64 = 1e-11;
/// Places on a parameter, and states of a limit cycle, that differ by less than this part of them are one.
pub const PLACE: f64 = 1e-9;
