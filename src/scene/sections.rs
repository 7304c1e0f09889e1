//! The tasks that look at attractors: stroboscopic sections and basins.

use num_rational::BigRational;

use super::{
    Expression, Scene,
    keys::{keys, words},
    orbits::OrbitKeys,
    task::{Check, Start},
};
use crate::{
    error::Result,
    oscillator::{Side, System},
};

keys! {
    /// Draws the stroboscopic (Poincaré) section of the attractors that motions lead to: periods, impacts, Lyapunov exponents.
    pub struct SectionTask {
        /// where motions start
        starts: Vec<Start>,
        /// when to look, as a fraction of the forcing period: at t = 2π `phase` of every period
        phase: BigRational = "0",
        /// from where displacement and velocity are counted
        frame: Frame = "\"fixed\"",
        /// how many periods pass before
        transient: u64 = "1000",
        /// how many points a motion that is not periodic is shown by; over as many periods the Lyapunov exponent is taken
        points: u32 = "2000",
        /// the longest period told from none, in forcing periods
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
        /// displacements of the starts
        q: Values,
        /// velocities of the starts
        u: Values,
        /// when motions start and are looked at, as a fraction of the forcing period
        phase: BigRational = "0",
        /// how many periods pass before
        transient: u64 = "300",
        /// the longest period told from none, in forcing periods
        longest: u32 = "16",
        /// whether to go on from the checkpoint that an interrupted run left in the folder
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

/// How many points and periods may be looked at.
const LONGEST: u32 = 10_000;
const POINTS: u32 = 1_000_000;

impl Check for SectionTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        if self.starts.is_empty() {
            return Err(scene.fail(&format!("{path}.starts"), "is empty; a motion must start somewhere"));
        }
        for (i, start) in (1..).zip(&self.starts) {
            scene.check_start(start, system, &format!("{path}.starts[{i}]"))?;
        }
        let has = |side| match side {
            Side::Lower => system.lower.is_some(),
            Side::Upper => system.upper.is_some(),
        };
        if let Some(side) = self.frame.side().filter(|&side| !has(side)) {
            return Err(scene.fail(&format!("{path}.frame"), &format!("there is no {} wall", side.name())));
        }
        for (i, orbit) in (1..).zip(&self.orbits) {
            orbit.check(scene, system, &format!("{path}.orbits[{i}]"))?;
        }
        within(scene, path, "points", self.points, POINTS)?;
        within(scene, path, "longest", self.longest, LONGEST)
    }
}

impl Check for BasinsTask {
    fn check(&self, scene: &Scene, _: &System<f64>, path: &str) -> Result<()> {
        for (range, name) in [(&self.q, "q"), (&self.u, "u")] {
            if !(2..=4000).contains(&range.count) {
                return Err(scene.fail(&format!("{path}.{name}.count"), "is outside 2 to 4000"));
            }
            scene.number(&range.from)?;
            scene.number(&range.to)?;
        }
        within(scene, path, "longest", self.longest, LONGEST)
    }
}

fn within(scene: &Scene, path: &str, key: &str, value: u32, most: u32) -> Result<()> {
    if (1..=most).contains(&value) {
        return Ok(());
    }
    Err(scene.fail(&format!("{path}.{key}"), &format!("is outside 1 to {most}")))
}
