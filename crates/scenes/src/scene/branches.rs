//! The keys of the tasks over parameters: `branch`, `diagram`, `map`, `crisis`; the options of continuation.

use num_rational::BigRational;

use super::{
    keys::{keys, read_into, words},
    monitors::{Levels, Monitors},
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
    /// Where a branch starts; one of `orbit`, `attractor`, `restart`.
    pub struct BranchStart {
        /// the parameter there; the scene's if absent
        at: Option<BigRational>,
        /// each orbit starts a branch, unless it lies on one already
        orbit: Option<OrbitKeys>,
        /// a state whose motion leads to a periodic attractor
        attractor: Option<Start>,
        /// a label of a branch written before
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
    /// A point of a branch that was written before, along any parameter.
    pub struct Restart {
        /// its JSON file, in this task's folder
        file: String,
        /// such as "flip 1"; "row 7" is the seventh of the file's points
        label: String,
        /// change to the branch born there (flip), or crossing
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
    /// Follows periodic orbits over a parameter by pseudo-arclength, through saddle-nodes, and
    /// [labels](branches.md) what happens.
    pub struct BranchTask {
        /// what varies
        parameter: String,
        /// its bounds
        range: Vec<f64>,
        /// where branches start
        starts: Vec<BranchStart>,
        /// which way
        direction: Way = "\"both\"",
        /// a second parameter: the event at a restart's label is followed in both
        second: Option<String>,
        /// its bounds
        second_range: Vec<f64> = "[]",
        /// [functions of an orbit](branches.md#monitors), as `{ power = "impulse*speed/period" }`
        monitors: Monitors = "{}",
        /// values at which they are labelled, as `{ power = [0.2, 0.3] }`
        levels: Levels = "{}",
        /// over two parameters, the value that one keeps in place of an event
        hold: Levels = "{}",
        /// how branches are followed
        options: Options = "{}",
        /// prove each piece between saddle-nodes, with certificates; one parameter, engine `one`
        prove: bool = "false",
        /// when the picture's displacement (of `many`, gap) is taken, a fraction of the period
        phase: BigRational = "0",
        /// where it is measured
        frame: Frame = "\"fixed\"",
        /// draw that many orbits of each branch, 2 to 100, and those with labels, in the plane of (the first)
        /// displacement and velocity; one parameter
        drawn: u32 = "0",
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
    /// Draws what motions tend to over a parameter (a bifurcation diagram), from starts at each value or
    /// swept: windows, coexistence, jumps, hysteresis.
    pub struct DiagramTask {
        /// what varies
        parameter: String,
        /// its bounds
        range: Vec<BigRational>,
        /// values, both bounds among them
        count: u32 = "400",
        /// at every value; of a sweep the one at the first
        starts: Vec<Start>,
        /// go on from what was settled on at the value before
        sweep: Option<SweepWay>,
        /// prove each periodic attractor at each value, with certificates; without a sweep twice the motions
        prove: bool = "false",
        /// when to look, as a fraction of the forcing period
        phase: BigRational = "0",
        /// where the displacement is measured
        frame: Frame = "\"fixed\"",
        /// what is kept, the first drawn: as of a `section`
        plane: Vec<String> = "[]",
        /// periods that pass first, unrecorded
        transient: u64 = "1000",
        /// periods that are looked at
        points: u32 = "400",
        /// longest period that counts as periodic
        longest: u32 = "64",
        /// one point per this many periods: one component of an attractor
        every: u32 = "1",
        /// to draw with it
        branches: Vec<BranchStart> = "[]",
        /// how branches are followed
        options: Options = "{}",
        /// whether to continue from an interrupted run's checkpoint
        resume: bool = "true",
    }
}

keys! {
    /// Draws over two parameters what one motion tends to: period, impacts, largest Lyapunov exponent.
    pub struct MapTask {
        /// along the picture
        parameter: String,
        /// its bounds
        range: Vec<BigRational>,
        /// values, both bounds among them
        count: u32 = "200",
        /// upwards
        second: String,
        /// its bounds
        second_range: Vec<BigRational>,
        /// values of it
        second_count: u32 = "200",
        /// at every point
        start: Start,
        /// when to look, as a fraction of the forcing period
        phase: BigRational = "0",
        /// periods that pass first, unrecorded
        transient: u64 = "1000",
        /// periods looked at, at least three times `longest`, and of the exponent
        points: u32 = "200",
        /// longest period that counts as periodic
        longest: u32 = "64",
        /// whether to continue from an interrupted run's checkpoint
        resume: bool = "true",
    }
}

keys! {
    /// Locates the end of an attractor: where an image of the corner of an unstable orbit's unstable manifold
    /// falls on its stable manifold. Simulates on both sides.
    pub struct CrisisTask {
        /// what varies
        parameter: String,
        /// a value on each side
        bracket: Vec<f64>,
        /// the pattern: the saddle among its orbits mid-bracket
        orbit: OrbitKeys,
        /// of the section, a fraction of the period, away from impacts
        phase: BigRational,
        /// which image of the corner, in periods of the orbit
        images: u32 = "2",
        /// entries to the unstable manifold, whose answers must agree; without it 5e-5, 5e-6, 5e-7 of the
        /// motion's size
        offsets: Vec<f64> = "[]",
        /// of simulated motions
        start: Start,
        /// how far from the crisis they are, either side
        margins: Vec<f64> = "[1e-5, 1e-6]",
        /// how many they last
        periods: u64 = "1000000",
        /// periods without an impact that mean escape
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
