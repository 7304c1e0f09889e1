//! Which wall, and where a wall is.

use std::fmt;

use super::{System, Wall};

/// One of the two walls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// Q₁, below.
    Lower,
    /// Q₂, above.
    Upper,
}

impl Side {
    /// Both.
    pub const BOTH: [Side; 2] = [Side::Lower, Side::Upper];

    /// 1 for the lower wall and −1 for the upper: the gap to the wall at Q is this times q − Q.
    pub fn sign(self) -> f64 {
        match self {
            Side::Lower => 1.0,
            Side::Upper => -1.0,
        }
    }

    /// The wall of a system on this side, if any.
    pub fn wall<T>(self, system: &System<T>) -> Option<&Wall<T>> {
        match self {
            Side::Lower => system.lower.as_ref(),
            Side::Upper => system.upper.as_ref(),
        }
    }
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Side::Lower => "lower",
            Side::Upper => "upper",
        })
    }
}

impl Wall<f64> {
    /// Q, Q′ and Q″ at time t.
    pub fn motion(&self, t: f64) -> [f64; 3] {
        let mut motion = [self.offset, 0.0, 0.0];
        for h in &self.harmonics {
            let k = f64::from(h.k);
            let (sin, cos) = (k * t).sin_cos();
            let (value, slope) = (h.cos * cos + h.sin * sin, h.sin * cos - h.cos * sin);
            motion[0] += value;
            motion[1] += k * slope;
            motion[2] -= k * k * value;
        }
        motion
    }
}
