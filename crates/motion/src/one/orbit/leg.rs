//! What a passage between two impacts is made of: the motion without walls, and the wall at its end.

use crate::motion::{Contact, State, algebra::Matrix2};

/// Where a motion without impacts leads, with derivatives at fixed times.
#[derive(Debug, Clone, Copy)]
pub struct Leg {
    /// The state at its end.
    pub end: State,
    /// ∂(q, u)/∂(q₀, u₀).
    pub matrix: Matrix2,
    /// ∂(q, u)/∂p.
    pub slope: [f64; 2],
}

/// A wall at one time: where it is, how it moves, and what the parameter does to it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touch<'a> {
    /// The wall.
    pub wall: &'a Contact,
    /// Q, Q′, Q″.
    pub motion: [f64; 3],
    /// ∂(Q, Q′)/∂p.
    pub slope: [f64; 2],
    /// ∂τ/∂p.
    pub restitution_slope: f64,
}

impl Touch<'_> {
    /// The state at the wall with relative velocity `speed` away from it: −V before an impact, τV after it.
    pub fn leaving(&self, t: f64, speed: f64) -> State {
        State { t, q: self.motion[0], u: self.motion[1] + self.wall.side.sign() * speed }
    }
}
