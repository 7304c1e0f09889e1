//! The tasks that look at attractors: stroboscopic sections and basins.

use num_rational::BigRational;

use super::{
    expression::Expression,
    keys::{keys, words},
    orbits::OrbitKeys,
    simulate::Start,
};
use crate::motion::Side;

keys! {
    /// Draws the stroboscopic (Poincaré) section of the attractors that motions lead to: periods, impacts,
    /// Lyapunov exponents.
    pub struct SectionTask {
        /// where motions start
        starts: Vec<Start>,
        /// when to look, as a fraction of the forcing period: at t = 2π `phase` of every period
        phase: BigRational = "0",
        /// the frame in which displacement and velocity are measured
        frame: Frame = "\"fixed\"",
        /// how many periods pass first, unrecorded; more, where the report says "not settled"
        transient: u64 = "1000",
        /// how many points show a motion that is not periodic; its Lyapunov exponent is taken over as many
        /// periods
        points: u32 = "2000",
        /// how many Lyapunov exponents are found, the largest first; of a machine at most twice its
        /// coordinates
        exponents: u32 = "1",
        /// of a machine, by which two numbers of its state points are drawn: `q2` and `u2` are displacement
        /// and velocity of a coordinate, `gap NAME` and `rate NAME` the gap of a stop and how fast it opens
        plane: Vec<String> = "[]",
        /// the longest period that counts as periodic, in forcing periods
        longest: u32 = "64",
        /// orbits to mark, stable or not
        orbits: Vec<OrbitKeys> = "[]",
        /// whether to draw the stable and the unstable manifolds of the unstable orbits among them
        manifolds: bool = "false",
        /// whether to draw where the next period grazes a wall
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
        /// which two numbers of a start are varied: `q`, `u` or `phase`, the time of the start as a fraction
        /// of the forcing period; of a machine, two displacements or velocities: `q2` and `u2` are those of a
        /// coordinate
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

words! {
    /// From where displacement and velocity are counted.
    pub enum Frame {
        /// As in the equation of motion.
        Fixed = "fixed",
        /// From the lower wall's motion about its mean: q − (Q₁ − offset), in which the wall stands still.
        Lower = "lower",
        /// From the upper wall's motion about its mean.
        Upper = "upper",
    }
}

/// What of an oscillator's start is varied along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StartAxis {
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
            Frame::Fixed => None,
            Frame::Lower => Some(Side::Lower),
            Frame::Upper => Some(Side::Upper),
        }
    }
}
