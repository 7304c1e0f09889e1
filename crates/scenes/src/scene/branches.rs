//! The keys of the tasks over parameters: `branch`, `diagram`, `map`, `crisis`; the options of continuation.

use num_rational::BigRational;

use super::{
    keys::{keys, read_into, words},
    orbits::OrbitKeys,
    sections::Frame,
    simulate::Start,
};
use crate::{
    continuation::Options,
    error::{Error, Result},
    number::{Plain, Real},
};

grazing_motion::with_options!(read_into);

keys! {
    /// Where a branch starts: at an orbit, at the periodic attractor that a motion leads to, or at a label of
    /// a branch written before.
    pub struct BranchStart {
        /// the parameter's value at the start; the scene's if absent
        at: Option<BigRational>,
        /// orbits of a pattern: each starts a branch, unless it lies on one already followed
        orbit: Option<OrbitKeys>,
        /// a state whose motion leads to a periodic attractor
        attractor: Option<Start>,
        /// a labelled point of a branch
        restart: Option<Restart>,
    }
}

/// Where a branch starts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum BranchOrigin<'a> {
    /// At the orbits of a pattern.
    Orbit(&'a OrbitKeys),
    /// At the periodic attractor that a motion leads to.
    Attractor(&'a Start),
    /// At a label of a branch written before.
    Restart(&'a Restart),
}

impl BranchStart {
    /// Which of the three it is.
    ///
    /// # Errors
    /// An input error unless exactly one is given.
    pub fn origin(&self) -> Result<BranchOrigin<'_>> {
        match (&self.orbit, &self.attractor, &self.restart) {
            (Some(orbit), None, None) => Ok(BranchOrigin::Orbit(orbit)),
            (None, Some(attractor), None) => Ok(BranchOrigin::Attractor(attractor)),
            (None, None, Some(restart)) => Ok(BranchOrigin::Restart(restart)),
            _ => Err(Error::input("must have one of orbit, attractor and restart")),
        }
    }
}

keys! {
    /// A labelled point of a branch that was written before.
    pub struct Restart {
        /// the branch's JSON file, in the folder that this task writes into
        file: String,
        /// the label, such as "flip 1"
        label: String,
        /// whether to change to the branch that is born there (flip) or crosses
        switch: bool = "false",
    }
}

words! {
    /// Which way a branch is followed from its start.
    pub enum Way {
        /// Both ways.
        Both = "both",
        /// Towards larger values of the (last) parameter at first.
        Up = "up",
        /// Towards smaller ones.
        Down = "down",
    }
}

keys! {
    /// Follows branches of periodic orbits over a parameter by pseudo-arclength continuation, through
    /// saddle-nodes, and labels what happens: saddle-node, crossing, flip, neimark-sacker, grazing (a minimum
    /// of the gap is zero), fade (an impact's speed is zero); with dry friction crossing-sliding,
    /// grazing-sliding, switching-sliding, adding-sliding, friction-change.
    pub struct BranchTask {
        /// the parameter that varies
        parameter: String,
        /// its bounds
        range: Vec<f64>,
        /// where branches start
        starts: Vec<BranchStart>,
        /// which way they are followed
        direction: Way = "\"both\"",
        /// a second parameter: what happens at the label of a restart is followed in both
        second: Option<String>,
        /// the bounds of the second
        second_range: Vec<f64> = "[]",
        /// how they are followed
        options: Options = "{}",
        /// whether to prove the orbits, piece by piece between saddle-nodes, as a task `validate` over a
        /// range does, with a certificate for each piece; over one parameter, where the engine is `one`
        prove: bool = "false",
        /// when the picture's displacement, where the engine is `many` the gap to a stop, is taken, as a
        /// fraction of the forcing period
        phase: BigRational = "0",
        /// the frame in which it is measured
        frame: Frame = "\"fixed\"",
    }
}

words! {
    /// Which way a parameter is swept.
    pub enum SweepWay {
        /// From the least value to the greatest.
        Up = "up",
        /// From the greatest to the least.
        Down = "down",
        /// Up, and from what was reached down again.
        Both = "both",
    }
}

keys! {
    /// Draws what motions tend to over a parameter (a bifurcation diagram), from several starts at each
    /// value, in parallel. Every motion begins at one of these starts, unless the parameter is swept. Lists
    /// windows of periodic motion and values where attractors coexist; of a sweep, jumps and hysteresis. An
    /// interrupted task resumes from its checkpoint.
    pub struct DiagramTask {
        /// the parameter that varies
        parameter: String,
        /// its bounds
        range: Vec<BigRational>,
        /// how many values, evenly spaced, both bounds among them
        count: u32 = "400",
        /// where motions start, at every value; of a sweep, where the only one starts, at the first value
        starts: Vec<Start>,
        /// which way the parameter is swept: each motion goes on from what was settled on at the value before
        sweep: Option<SweepWay>,
        /// whether to prove of each periodic attractor at each value that it is a stable orbit, with a
        /// certificate for each, as a task `validate` does; without a sweep motions are followed twice
        prove: bool = "false",
        /// when to look, as a fraction of the forcing period
        phase: BigRational = "0",
        /// the frame in which the displacement is measured
        frame: Frame = "\"fixed\"",
        /// what of a state is kept, the first drawn: `q2` and `u2` are displacement and velocity of a
        /// coordinate, where the engine is `many` `gap NAME` and `rate NAME` the gap of a stop and how fast
        /// it opens; without it `q1` and `u1`
        plane: Vec<String> = "[]",
        /// how many periods pass first, unrecorded
        transient: u64 = "1000",
        /// how many periods are looked at
        points: u32 = "400",
        /// the longest period that counts as periodic, in forcing periods
        longest: u32 = "64",
        /// draw one point per this many periods, which shows one component of an attractor that has that many
        every: u32 = "1",
        /// branches to draw with it
        branches: Vec<BranchStart> = "[]",
        /// how these branches are followed
        options: Options = "{}",
        /// whether to continue from the checkpoint that an interrupted run left in the folder
        resume: bool = "true",
    }
}

keys! {
    /// Draws over two parameters what one motion tends to: period, impacts and largest Lyapunov exponent at
    /// every point of a grid, many motions at once. An interrupted task resumes from its checkpoint.
    pub struct MapTask {
        /// the parameter that varies along the picture
        parameter: String,
        /// its bounds
        range: Vec<BigRational>,
        /// how many values, evenly spaced, both bounds among them
        count: u32 = "200",
        /// the parameter that varies upwards
        second: String,
        /// its bounds
        second_range: Vec<BigRational>,
        /// how many values of it
        second_count: u32 = "200",
        /// where the motion starts, at every point
        start: Start,
        /// when to look, as a fraction of the forcing period
        phase: BigRational = "0",
        /// how many periods pass first, unrecorded
        transient: u64 = "1000",
        /// how many periods are looked at, at least three times `longest`; the exponent is taken over them
        points: u32 = "200",
        /// the longest period that counts as periodic, in forcing periods
        longest: u32 = "64",
        /// whether to continue from the checkpoint that an interrupted run left in the folder
        resume: bool = "true",
    }
}

keys! {
    /// Locates the end of an attractor. An unstable orbit's unstable manifold has a corner where it first
    /// comes to graze; the end is the parameter at which an image of this corner falls on the stable
    /// manifold. Also simulates on both sides of it.
    pub struct CrisisTask {
        /// the parameter that varies
        parameter: String,
        /// a value on each side
        bracket: Vec<f64>,
        /// the unstable orbit, by its pattern: the saddle among the orbits found in the middle of the bracket
        orbit: OrbitKeys,
        /// when the section is taken, as a fraction of the forcing period: not near an impact of the orbit
        phase: BigRational,
        /// which image of the corner, in periods of the orbit
        images: u32 = "2",
        /// how far from the orbit its unstable manifold is entered; the answers for each must agree. If
        /// empty, 5e-5, 5e-6 and 5e-7 of the size of the motion
        offsets: Vec<f64> = "[]",
        /// where simulated motions start
        start: Start,
        /// how far from the crisis the simulations are made, on either side
        margins: Vec<f64> = "[1e-5, 1e-6]",
        /// how many periods they last
        periods: u64 = "1000000",
        /// a motion without an impact for this many periods has escaped
        quiet: u64 = "100",
    }
}

impl CrisisTask {
    /// How far from the orbit its unstable manifold is entered, where motions have this size.
    pub(crate) fn offsets_at(&self, size: f64) -> Vec<f64> {
        if self.offsets.is_empty() {
            [5e-5, 5e-6, 5e-7].map(|x| x * size).to_vec()
        } else {
            self.offsets.clone()
        }
    }
}

impl DiagramTask {
    /// The bounds of the parameter.
    pub fn bounds(&self) -> (f64, f64) {
        (Plain::ratio(&self.range[0], &()).0, Plain::ratio(&self.range[1], &()).0)
    }
}
