//! Where a motion is, and what a motion without walls can be asked.

use crate::motion::algebra::Matrix2;

use serde::{Deserialize, Serialize};

/// Where the oscillator is: q, u = q′ at time t, the forcing period being 2π. Sines of t are as good as t is:
/// keep it within a few periods of 0 and count whole periods apart.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Time, dimensionless.
    pub t: f64,
    /// Displacement.
    pub q: f64,
    /// Velocity.
    pub u: f64,
}

/// The motion without walls, in f64.
pub trait Flow {
    /// q″ by the equation of motion.
    fn acceleration(&self, at: State) -> f64;

    /// The state after `duration`, which may be negative.
    fn advance(&self, from: State, duration: f64) -> State;

    /// The same with its derivative by the initial q and u.
    fn advance_linearised(&self, from: State, duration: f64) -> (State, Matrix2);
}
