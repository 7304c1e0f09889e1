//! The tasks that look at attractors: stroboscopic sections and basins.

use num_rational::BigRational;

use super::{
    expression::Expression,
    format::SceneFormat,
    keys::{Entry, StopName, Value, keys},
    orbits::OrbitKeys,
    simulate::Start,
};
use crate::{error::Result, motion::Side};

keys! {
    /// Draws the stroboscopic (Poincaré) section of attractors: periods, impacts, Lyapunov exponents.
    pub struct SectionTask {
        /// where motions start
        starts: Vec<Start>,
        /// when to look, as a fraction of the forcing period
        phase: BigRational = "0",
        /// where q and u are measured: fixed, or moving with a stop
        frame: Frame = "\"fixed\"",
        /// periods that pass first, unrecorded
        transient: u64 = "1000",
        /// points of a motion that is not periodic, and periods of its exponent
        points: u32 = "2000",
        /// Lyapunov exponents, the largest first: at most twice the coordinates
        exponents: u32 = "1",
        /// what is drawn: `q2` and `u2` of a coordinate; of `many` also `gap NAME`, `rate NAME`; without it
        /// `q1`, `u1`
        plane: Vec<String> = "[]",
        /// longest period that counts as periodic
        longest: u32 = "64",
        /// to mark, stable or not
        orbits: Vec<OrbitKeys> = "[]",
        /// draw those of the unstable orbits among them
        manifolds: bool = "false",
        /// draw where the next period grazes a stop
        grazing_curve: bool = "false",
    }
}

keys! {
    /// Finds which starts lead to which attractor, on a grid.
    pub struct BasinsTask {
        /// displacements, ascending; with `plane`, its first axis
        q: Values,
        /// velocities; with `plane`, its second axis
        u: Values,
        /// what is varied, as `q2`, `u2`; of `one` `q`, `u` or `phase`
        plane: Vec<String> = "[]",
        /// with `plane`, all other displacements and velocities; without it 0
        start: Option<Start>,
        /// when to look, as a fraction of the forcing period, and, unless varied, to start
        phase: BigRational = "0",
        /// periods that pass first, unrecorded
        transient: u64 = "300",
        /// longest period that counts as periodic
        longest: u32 = "16",
        /// whether to continue from an interrupted run's checkpoint
        resume: bool = "true",
    }
}

keys! {
    /// Evenly spaced values.
    pub struct Values {
        /// the first
        from: Expression,
        /// the last
        to: Expression,
        /// 2 to 4000
        count: u32 = "100",
    }
}

/// From where displacement and velocity are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// As in the equation of motion.
    Fixed,
    /// From the lower stop's motion about its mean: q − (Q₁ − offset), in which the stop stands still.
    Lower,
    /// From the upper stop's motion about its mean.
    Upper,
    /// A stop of the engine `many`, which has no frames.
    Other,
}

impl Value for Frame {
    fn shape() -> String {
        "`\"fixed\"` or name of a stop".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        if entry.scope.format != SceneFormat::Three {
            return entry.word(&[("fixed", Frame::Fixed), ("lower", Frame::Lower), ("upper", Frame::Upper)]);
        }
        if entry.text()? == "fixed" {
            return Ok(Frame::Fixed);
        }
        Ok(match StopName::read(entry)?.side {
            Some(Side::Lower) => Frame::Lower,
            Some(Side::Upper) => Frame::Upper,
            None => Frame::Other,
        })
    }
}

/// What of an oscillator's start is varied along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) enum StartAxis {
    /// The displacement.
    Place,
    /// The velocity.
    Speed,
    /// The time, as a fraction of the forcing period.
    Phase,
}

impl Frame {
    /// The wall whose motion is taken off.
    pub fn side(self) -> Option<Side> {
        match self {
            Frame::Fixed | Frame::Other => None,
            Frame::Lower => Some(Side::Lower),
            Frame::Upper => Some(Side::Upper),
        }
    }
}
