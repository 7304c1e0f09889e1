//! Many motions at once: linear systems with rigid walls, eight motions in a vector.
//!
//! Motions that are looked at at one phase of the forcing pass the same cells of their grids at the same
//! time. So a [`Batch`] takes all of them through a cell together. One pass over arrays of numbers tells who
//! is far from every wall; the others are packed, and looked at in full vectors, case by case: falling gap,
//! valley, hill, root, impact. The width of a vector is what the processor has (AVX-512, AVX2, SSE, NEON, or
//! none), chosen at run time.
//!
//! # What is promised
//!
//! The motion of each is bit for bit that of the scalar [`Run`]: the vector code does the same operations in
//! the same order, and IEEE arithmetic does the rest. What is rare (rest on a wall, a touch, a gap that
//! presses, an escape, a limit of impacts) is handed to the scalar code, from before the look that found it.
//! Motions of systems that the vector code does not know (not linear, without walls) are followed by the
//! scalar code throughout. Not here: what motions tend to (`attractor`).
//!
//! ```
//! use grazing_scenes::motion::{Harmonic, System, Time, Wall};
//! use grazing_scenes::one::simulate::{Settings, Simulator, batch::Batch};
//!
//! let harmonics = vec![Harmonic { k: 1, cos: 1.003, sin: 0.0 }];
//! let wall = Wall { offset: -1.0, harmonics, restitution: 1.0 };
//! let (damping, stiffness, cubic, force) = (0.245, 0.0416, 0.0, 0.0);
//! let (lower, upper, forcing, smooth) = (Some(wall), None, vec![], None);
//! let system = System { damping, stiffness, cubic, force, forcing, smooth, lower, upper, rate: None };
//! let simulator = Simulator::new(&system, &Settings::default())?;
//! let start = |i: u32| simulator.start(Time::new(0, 1.0), f64::from(i) / 10.0, 0.0);
//! let mut motions = Vec::new();
//! for i in 0..10 {
//!     motions.push((&simulator, start(i)?));
//! }
//! let mut batch = Batch::new(0.0, motions);
//! (0..100).for_each(|_| batch.pass());
//! let mut run = start(7)?;
//! run.finish(Time::new(100, 0.0));
//! assert_eq!((batch.impacts(7), batch.point(7)), (run.impacts(), [run.state().q, run.state().u]));
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod group;
mod queue;
mod search;
mod strike;
mod sweep;
mod tables;
mod vector;

use std::sync::Arc;

use fearless_simd::{Level, dispatch};

use super::{Event, Run, Simulator};
use crate::motion::{RunEnd, State, Time};
use group::{Each, Group, Kind};

/// Motions that are taken from one point of a stroboscopic section to the next together.
pub struct Batch<'a> {
    phase: f64,
    level: Level,
    groups: Vec<Group<'a>>,
    /// The group of each motion and its place there; the scalar ones have none.
    places: Vec<Option<(usize, usize)>>,
    scalar: Vec<Option<Scalar<'a>>>,
}

/// A motion with its place in the batch and its simulator.
type Numbered<'a> = (usize, &'a Simulator, Run<'a>);

/// A motion of a system that the vector code does not know.
struct Scalar<'a> {
    run: Run<'a>,
    period: i64,
    end: RunEnd,
}

/// The last forcing period whose point of the section a run has behind it or is at. A run that stopped there
/// may be before it by rounding.
fn before(run: &Run, phase: f64) -> i64 {
    let now = run.time();
    now.period - i64::from(now.phase < phase - 1e-12)
}

impl<'a> Batch<'a> {
    /// A batch of runs under way, each with its simulator, to be looked at at `phase` ∈ [0, 2π). Systems may
    /// differ; those with tables of one size keep step. Cost: 2 kB for each motion, more with many cells.
    pub fn new(phase: f64, motions: Vec<(&'a Simulator, Run<'a>)>) -> Batch<'a> {
        let count = motions.len();
        let mut sorted: Vec<(Kind, Vec<Numbered>)> = Vec::new();
        let mut scalar: Vec<Option<Scalar>> = (0..count).map(|_| None).collect();
        for (name, (simulator, run)) in motions.into_iter().enumerate() {
            let Some(kind) = Kind::of(simulator) else {
                let period = before(&run, phase);
                scalar[name] = Some(Scalar { run, period, end: RunEnd::Reached });
                continue;
            };
            let alike =
                |(other, all): &&mut (Kind, Vec<Numbered>)| *other == kind && same_tally(all[0].1, simulator);
            match sorted.iter_mut().find(alike) {
                Some((_, all)) => all.push((name, simulator, run)),
                None => sorted.push((kind, vec![(name, simulator, run)])),
            }
        }
        let mut places = vec![None; count];
        let groups = sorted.into_iter().enumerate().map(|(index, (kind, all))| {
            all.iter().enumerate().for_each(|(at, motion)| places[motion.0] = Some((index, at)));
            Group::new(kind, phase, all)
        });
        let groups = groups.collect();
        Batch { phase, level: Level::new(), groups, places, scalar }
    }

    /// All on to the next point of the section, but for those that have ended or were dropped.
    pub fn pass(&mut self) {
        self.advance(None);
    }

    /// The same, each event shown with the place of its motion in the batch: those of one motion in order.
    pub fn record(&mut self, mut each: impl FnMut(usize, Event)) {
        self.advance(Some(&mut each));
    }

    fn advance(&mut self, mut each: Each) {
        let level = self.level;
        for group in &mut self.groups {
            dispatch!(level, simd => group.sweep(simd, &mut each));
            group.periods.iter_mut().for_each(|period| *period += 1);
            group.gather(&mut each);
            group.tell();
        }
        for (name, scalar) in self.scalar.iter_mut().enumerate() {
            let Some(Scalar { run, period, end }) = scalar else { continue };
            if *end != RunEnd::Reached {
                continue;
            }
            *period += 1;
            let until = Time::new(*period, self.phase);
            *end = match &mut each {
                Some(each) => run.record(until, |event| each(name, event)),
                None => run.finish(until),
            };
        }
    }

    /// The motion's state (q, u) at the section, or where it ended; of one that was dropped nothing is known.
    pub fn point(&self, motion: usize) -> [f64; 2] {
        match (self.places[motion], &self.scalar[motion]) {
            (Some((group, at)), _) => self.groups[group].point(at),
            (None, Some(Scalar { run, .. })) => [run.state().q, run.state().u],
            (None, None) => [f64::NAN; 2],
        }
    }

    /// The forcing period in which it is at the section, or was when it last passed it.
    pub(crate) fn period(&self, motion: usize) -> i64 {
        match (self.places[motion], &self.scalar[motion]) {
            (Some((group, at)), _) => self.groups[group].periods[at],
            (None, scalar) => scalar.as_ref().map_or(0, |scalar| scalar.period),
        }
    }

    /// The same as [`point`](Self::point), with the phase that rounding makes of the section's.
    pub(crate) fn state(&self, motion: usize) -> State {
        match (self.places[motion], &self.scalar[motion]) {
            (Some((group, at)), _) => self.groups[group].state(at),
            (None, Some(Scalar { run, .. })) => State { t: run.time().phase, ..run.state() },
            (None, None) => State { t: f64::NAN, q: f64::NAN, u: f64::NAN },
        }
    }

    /// How many impacts it has had.
    pub fn impacts(&self, motion: usize) -> u64 {
        match (self.places[motion], &self.scalar[motion]) {
            (Some((group, at)), _) => self.groups[group].impacts[at],
            (None, scalar) => scalar.as_ref().map_or(0, |scalar| scalar.run.impacts()),
        }
    }

    /// [`RunEnd::Reached`] while it goes on, or why it has ended.
    pub fn end(&self, motion: usize) -> RunEnd {
        match (self.places[motion], &self.scalar[motion]) {
            (Some((group, at)), _) => self.groups[group].ends[at],
            (None, scalar) => scalar.as_ref().map_or(RunEnd::Reached, |scalar| scalar.end),
        }
    }

    /// Follows a motion no further.
    pub fn drop(&mut self, motion: usize) {
        match self.places[motion] {
            Some((group, at)) => self.groups[group].leave(at),
            None => self.scalar[motion] = None,
        }
    }
}

fn same_tally(one: &Simulator, other: &Simulator) -> bool {
    match (&one.tally, &other.tally) {
        (Some(one), Some(other)) => Arc::ptr_eq(one, other),
        (None, None) => true,
        _ => false,
    }
}
