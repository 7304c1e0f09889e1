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
    /// Draws the stroboscopic (Poincaré) section of the attractors that motions lead to: periods, impacts,
    /// Lyapunov exponents.
    pub struct SectionTask {
        /// where motions start
        starts: Vec<Start>,
        /// when to look, as a fraction of the forcing period: at t = 2π `phase` of every period
        phase: BigRational = "0",
        /// the frame in which displacement and velocity are measured: fixed, or moving as a stop does
        frame: Frame = "\"fixed\"",
        /// how many periods pass first, unrecorded; more, where the report says "not settled"
        transient: u64 = "1000",
        /// how many points show a motion that is not periodic; its Lyapunov exponent is taken over as many
        /// periods
        points: u32 = "2000",
        /// how many Lyapunov exponents are found, the largest first: at most twice as many as coordinates
        exponents: u32 = "1",
        /// by which two numbers of their state points are drawn: `q2` and `u2` are displacement and velocity
        /// of a coordinate, where the engine is `many` `gap NAME` and `rate NAME` the gap of a stop and how
        /// fast it opens; without it `q1` and `u1`
        plane: Vec<String> = "[]",
        /// the longest period that counts as periodic, in forcing periods
        longest: u32 = "64",
        /// orbits to mark, stable or not
        orbits: Vec<OrbitKeys> = "[]",
        /// whether to draw the stable and the unstable manifolds of the unstable orbits among them
        manifolds: bool = "false",
        /// whether to draw where the next period grazes a stop
        grazing_curve: bool = "false",
    }
}

keys! {
    /// Finds which starts lead to which attractor, on a grid.
    pub struct BasinsTask {
        /// displacements of the starts, ascending; with `plane`, values of its first axis
        q: Values,
        /// velocities of the starts; with `plane`, values of its second
        u: Values,
        /// which two numbers of a start are varied: displacements or velocities, as `q2` and `u2` of the
        /// second coordinate; where the engine is `one` `q`, `u` or `phase`, the time of the start as a
        /// fraction of the forcing period
        plane: Vec<String> = "[]",
        /// with `plane`, the other displacements and velocities of every start; without it 0
        start: Option<Start>,
        /// when motions start, unless that is varied, and are looked at, as a fraction of the forcing period
        phase: BigRational = "0",
        /// how many periods pass first, unrecorded
        transient: u64 = "300",
        /// the longest period that counts as periodic, in forcing periods
        longest: u32 = "16",
        /// whether to continue from the checkpoint that an interrupted run left in the folder
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
        /// how many, from 2 to 4000
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
