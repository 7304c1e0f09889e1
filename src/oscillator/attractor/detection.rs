//! Which attractor a start ends up on: its period and number of impacts, by recurrence and confirmation.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::{
    dynamics::{Motion, SectionState},
    section::{section, stops},
};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    oscillator::simulate::RunEnd,
};

/// Points of the section this close in q and in u recur, unless a [`Detection`] says otherwise.
pub const RECURRENCE: f64 = 1e-7;

/// Orbits whose points are this close in q and in u are the same attractor. Larger than [`RECURRENCE`],
/// because motions come from different sides to an attractor that they approach slowly.
pub const SAME: f64 = 1e-4;

/// How to look for recurrence in the section at `phase`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Detection {
    /// The phase of the section, in [0, 2π). Default 0.
    pub phase: f64,
    /// Forcing periods left out first. Default 1000.
    pub transient: u64,
    /// The longest period looked for, in forcing periods, at least 1. Default 64.
    pub longest: usize,
    /// Points this close in q and in u recur. Default [`RECURRENCE`].
    pub tolerance: f64,
    /// How many more times round the points must recur, with the same impacts, at least 1. Default 2.
    pub confirm: usize,
}

impl Default for Detection {
    fn default() -> Self {
        Detection { phase: 0.0, transient: 1000, longest: 64, tolerance: RECURRENCE, confirm: 2 }
    }
}

/// What a run ends up on.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Fate<P = [f64; 2]> {
    /// A periodic orbit: the least period by recurrence.
    Periodic(Cycle<P>),
    /// No recurrence up to the longest period: chaos, a long period, or a transient not over.
    Irregular,
    /// The run ended first.
    Ended(RunEnd),
}

impl<P: SectionState> Fate<P> {
    /// Whether another run ends up on the same attractor; all motions that are not periodic count as one.
    pub fn is(&self, other: &Fate<P>) -> bool {
        match (self, other) {
            (Fate::Periodic(one), Fate::Periodic(other)) => one.is(other),
            (Fate::Irregular, Fate::Irregular) => true,
            _ => false,
        }
    }
}

/// Passes `count` points of the section, asking `monitor` whether to go on.
///
/// # Errors
/// The monitor's; those of [`Motion::pass`].
pub fn wait<M: Motion>(run: &mut M, phase: f64, count: u64, monitor: &dyn Monitor) -> Result<RunEnd> {
    let mut left = count;
    while left > 0 {
        let some = left.min(M::CHUNK);
        let end = stops(run, phase, some, |_, _, _| true)?;
        if end != RunEnd::Reached {
            return Ok(end);
        }
        monitor.advance(0)?;
        left -= some;
    }
    Ok(RunEnd::Reached)
}

/// A periodic orbit as the section sees it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cycle<P = [f64; 2]> {
    /// Its points, from the one of least q (then least u) on; of machines, by the plane that is drawn.
    pub points: Vec<P>,
    /// Impacts in one time round.
    pub impacts: u64,
}

impl<P: SectionState> Cycle<P> {
    /// Whether a state of the section is one of its points, up to [`SAME`].
    pub fn passes(&self, state: &P) -> bool {
        self.points.iter().any(|point| point.near(state, SAME))
    }

    /// The period in forcing periods.
    pub fn period(&self) -> usize {
        self.points.len()
    }

    /// Whether the other is the same attractor: up to [`SAME`] in each coordinate, and where on it one began.
    pub fn is(&self, other: &Cycle<P>) -> bool {
        let same = |shift: usize| {
            let turned = other.points.iter().cycle().skip(shift);
            self.points.iter().zip(turned).all(|(a, b)| a.near(b, SAME))
        };
        self.points.len() == other.points.len()
            && self.impacts == other.impacts
            && (0..self.period()).any(same)
    }
}

impl Detection {
    /// # Errors
    /// A phase outside [0, 2π), a tolerance that is not positive, a count of 0.
    pub fn check(&self) -> Result<()> {
        if !(0.0..std::f64::consts::TAU).contains(&self.phase) {
            return Err(Error::input(format!("phase = {} is not in [0, 2π)", self.phase)));
        }
        if !(self.tolerance > 0.0 && self.tolerance.is_finite()) {
            return Err(Error::input(format!("tolerance = {} is not positive", self.tolerance)));
        }
        if self.longest == 0 || self.confirm == 0 {
            return Err(Error::input("longest and confirm must be at least 1"));
        }
        Ok(())
    }

    /// Follows the run for `transient` + `longest` · (1 + `confirm`) periods at most. The answer is numerical
    /// evidence, not proof.
    ///
    /// # Errors
    /// Those of [`check`](Self::check) and of [`Motion::pass`].
    pub fn detect<M: Motion>(&self, run: &mut M) -> Result<Fate<M::Point>> {
        self.check()?;
        let end = stops(run, self.phase, self.transient.saturating_add(1), |_, _, _| true)?;
        if end != RunEnd::Reached {
            return Ok(Fate::Ended(end));
        }
        let mut seen = Recurrence::new(self, run.point());
        let end = section(run, self.phase, self.most(), |point| seen.see(point.at, point.impacts))?;
        Ok(if end == RunEnd::Reached { seen.fate() } else { Fate::Ended(end) })
    }

    /// The most points that recurrence is looked for in.
    pub(super) fn most(&self) -> u64 {
        (self.longest * (1 + self.confirm)) as u64
    }
}

/// Points of a section as they come in: whether they recur.
#[derive(Debug, Clone)]
pub(super) struct Recurrence<'d, P> {
    detection: &'d Detection,
    /// Each with the impacts since the one before.
    points: Vec<(P, u64)>,
    period: Option<usize>,
}

impl<'d, P: SectionState> Recurrence<'d, P> {
    /// The first point, after the transient.
    pub fn new(detection: &'d Detection, first: P) -> Self {
        Recurrence { detection, points: vec![(first, 0)], period: None }
    }

    /// The next point; whether another is asked for.
    pub fn see(&mut self, at: P, impacts: u64) -> bool {
        let Detection { longest, confirm, tolerance, .. } = *self.detection;
        let points = &self.points;
        let here = points.len();
        let same = |n: usize| at.near(&points[here - n].0, tolerance);
        let mut more = true;
        match self.period {
            None if same(here) => self.period = Some(here),
            None => more = here < longest,
            // A chance encounter: on with the search.
            Some(n) if !same(n) || here > 2 * n && impacts != points[here - n].1 => {
                self.period = None;
                more = here < longest;
            }
            Some(n) => more = here < n * (1 + confirm),
        }
        self.points.push((at, impacts));
        more && (here as u64) < self.detection.most()
    }

    /// What the points amount to once no other is asked for.
    pub fn fate(&self) -> Fate<P> {
        let Some(n) = self.period else { return Fate::Irregular };
        let round = &self.points[1..=n];
        let impacts = round.iter().map(|point| point.1).sum();
        let mut points: Vec<_> = round.iter().map(|point| point.0.clone()).collect();
        let order = |&i: &usize, &j: &usize| {
            points[i].plane().partial_cmp(&points[j].plane()).unwrap_or(Ordering::Equal)
        };
        let least = (0..n).min_by(order).unwrap_or(0);
        points.rotate_left(least);
        Fate::Periodic(Cycle { points, impacts })
    }
}
