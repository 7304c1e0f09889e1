//! Why a motion is followed no farther.

use serde::{Deserialize, Serialize};

use crate::motion::flow::Obstacle;

/// Why there is no other event.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum RunEnd {
    /// The time asked for is reached; the run can go on.
    #[default]
    Reached,
    /// The limit of impacts is reached; the run stays where it is.
    ImpactLimit,
    /// A threshold that ends it is crossed.
    Event,
    /// The motion left every bound (negative stiffness, resonance); the run stays where it is.
    Escaped,
    /// The force has a pole here, or a root or a logarithm of 0; the run stays where it is.
    NotSmooth,
    /// The force is too steep here: it changes in less than the shortest step, or a forcing period takes more
    /// than 100,000 of them; the run stays where it is.
    TooSteep,
}

impl From<Obstacle> for RunEnd {
    fn from(obstacle: Obstacle) -> RunEnd {
        match obstacle {
            Obstacle::Escape => RunEnd::Escaped,
            Obstacle::Pole => RunEnd::NotSmooth,
            Obstacle::Steep => RunEnd::TooSteep,
        }
    }
}

impl RunEnd {
    /// Why, to follow "ended".
    pub fn why(self) -> &'static str {
        match self {
            RunEnd::Reached => "at the time asked for",
            RunEnd::ImpactLimit => "at the limit of impacts",
            RunEnd::Event => "at an event",
            RunEnd::Escaped => "when it left every bound",
            RunEnd::NotSmooth => "where its force is not smooth",
            RunEnd::TooSteep => "where its force is too steep",
        }
    }
}
