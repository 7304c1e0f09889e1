//! Which attractor a start ends up on: its period and number of impacts, by recurrence, and confirmed
//! (`confirm`). The one detector for oscillators and machines, whatever asks: sections, basins, diagrams,
//! maps, branches that start on an attractor.

use serde::Serialize;

use super::{
    confirm::{PATIENCE, Size, Tendency, tendency},
    cycle::{Cycle, ordered},
    dynamics::{Dynamics, Motion, SectionState},
    section::{section, stops},
    wander::wanders,
};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    motion::RunEnd,
};

/// Points of the section this close recur, unless a [`Detection`] says otherwise: relative to the extent of
/// the motion, the largest difference of one coordinate over a period.
pub(crate) const RECURRENCE: f64 = 1e-7;

/// Points farther apart than this, relative to the extent, are no sign of a period.
const LIKELY: f64 = 0.1;

/// How to look for recurrence in the section at `phase`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Detection {
    /// The phase of the section, in [0, 2π). Default 0.
    pub phase: f64,
    /// Forcing periods left out first. Default 1000.
    pub transient: u64,
    /// The longest period looked for, in forcing periods, at least 1. Default 64.
    pub longest: usize,
    /// Points this close, relative to the extent of the motion, recur. Default 1e-7.
    pub tolerance: f64,
    /// How many more times round the points must recur, with the same impacts, where Newton's method finds no
    /// orbit, at least 1. Default 2.
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
    /// A periodic orbit, confirmed: by Newton's method, or as the points recur to rounding.
    Periodic(Cycle<P>),
    /// No orbit up to the longest period is found, and the motion wanders: neighbours part, or it goes
    /// equally far for as long as it is looked at.
    Irregular,
    /// Not decided: a transient is not over, or points recur and no orbit is found.
    Unsettled,
    /// The run ended first.
    Ended(RunEnd),
}

impl<P: SectionState> Fate<P> {
    /// The cycle.
    ///
    /// # Errors
    /// An input error that says what the motion does instead.
    pub(crate) fn periodic(self, detection: &Detection) -> Result<Cycle<P>> {
        let Detection { longest, transient, .. } = detection;
        Err(Error::input(match self {
            Fate::Periodic(cycle) => return Ok(cycle),
            Fate::Irregular => format!(
                "the motion tends to no periodic orbit: after {transient} periods it has no period of at most {longest}"
            ),
            Fate::Unsettled => format!(
                "not settled: after {transient} periods it is not decided whether the motion tends to a periodic orbit"
            ),
            Fate::Ended(end) => format!("the motion ended before it settled, {}", end.why()),
        }))
    }
}

/// Passes `count` points of the section, asking `monitor` whether to go on.
///
/// # Errors
/// The monitor's; those of [`Motion::pass`].
pub(crate) fn wait<M: Motion>(run: &mut M, phase: f64, count: u64, monitor: &dyn Monitor) -> Result<RunEnd> {
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

    /// Follows the run of these dynamics for `transient` + `longest` · (1 + `confirm`) periods, and for 2,000
    /// more at most where it is not yet told to tend to an orbit nor to wander. Cost: besides, that of
    /// Newton's method for each period tried and of `wanders` once. The answer is numerical evidence, not
    /// proof.
    ///
    /// # Errors
    /// Those of [`check`](Self::check) and of [`Motion::pass`]; the monitor's.
    pub fn detect<'a, D: Dynamics>(
        &self,
        dynamics: &'a D,
        run: &mut D::Motion<'a>,
        monitor: &dyn Monitor,
    ) -> Result<Fate<D::Point>> {
        self.check()?;
        let end = stops(run, self.phase, self.transient.saturating_add(1), |_, _, _| true)?;
        if end != RunEnd::Reached {
            return Ok(Fate::Ended(end));
        }
        let mut seen = Recurrence::new(self, dynamics, run.point(), monitor)?;
        let mut failed = None;
        let end = section(run, self.phase, u64::MAX, |point| {
            seen.see(point.at, point.impacts).unwrap_or_else(|error| {
                failed = Some(error);
                false
            })
        })?;
        if let Some(error) = failed {
            return Err(error);
        }
        if end == RunEnd::Reached { seen.fate() } else { Ok(Fate::Ended(end)) }
    }
}

/// Points of a section as they come in: whether they recur, and whether that is an orbit.
pub(crate) struct Recurrence<'d, D: Dynamics> {
    detection: &'d Detection,
    dynamics: &'d D,
    monitor: &'d dyn Monitor,
    size: Size,
    /// Each with the impacts since the one before.
    points: Vec<(D::Point, u64)>,
    /// A period at which points recur so far, and since which point.
    candidate: Option<(usize, usize)>,
    /// When Newton's method is tried again: there is an orbit that attracts.
    again: Option<usize>,
    settled: Option<Cycle<D::Point>>,
    /// Whether Newton's method found an orbit that attracts.
    found: bool,
    /// Once the window of points is over and no orbit is found, whether the motion wanders.
    wanders: Option<bool>,
}

impl<'d, D: Dynamics> Recurrence<'d, D> {
    /// The first point, after the transient.
    ///
    /// # Errors
    /// Those of [`Motion::pass`].
    pub fn new(
        detection: &'d Detection,
        dynamics: &'d D,
        first: D::Point,
        monitor: &'d dyn Monitor,
    ) -> Result<Self> {
        let size = Size::of(dynamics, first.coordinates(), detection.phase)?;
        let points = vec![(first, 0)];
        Ok(Recurrence {
            detection,
            dynamics,
            monitor,
            size,
            points,
            candidate: None,
            again: None,
            settled: None,
            found: false,
            wanders: None,
        })
    }

    /// The next point; whether another is asked for.
    ///
    /// # Errors
    /// Those of [`Motion::pass`]; the monitor's.
    pub fn see(&mut self, at: D::Point, impacts: u64) -> Result<bool> {
        let Detection { longest, confirm, tolerance, .. } = *self.detection;
        self.points.push((at, impacts));
        let here = self.points.len() - 1;
        match self.candidate {
            Some((n, since)) if self.recurs(n, tolerance) && (here <= since + n || self.hits_again(n)) => {
                let sure = here - since >= n * confirm;
                if sure && self.recurs_within(n, confirm, self.size.part(0.0)) {
                    // Points first recur, while a transient lasts, perhaps only after some rounds: where it
                    // changes sides with each, to rounding, too. The period is the least after which points
                    // are not told apart.
                    let rounds = |d: usize| n.is_multiple_of(d).then(|| confirm * (n / d));
                    let again = |d: &usize| {
                        rounds(*d).is_some_and(|all| self.recurs_within(*d, all, self.size.same()))
                    };
                    self.settled = Some(self.seen((1..n).find(again).unwrap_or(n)));
                } else if sure && self.again.is_none() {
                    // It recurs, and no orbit is found: perhaps later.
                    self.again = Some(here + n.max(here / 2));
                }
            }
            // A chance encounter: on with the search.
            Some(_) => (self.candidate, self.again) = (None, None),
            None if here <= longest && self.recurs(here, tolerance) => {
                self.candidate = Some((here, here));
                self.attempt(here)?;
            }
            None => {}
        }
        if self.settled.is_none() && self.again == Some(here) {
            self.again = None;
            match self.candidate {
                Some((n, _)) => self.attempt(n)?,
                None => self.guess()?,
            }
        }
        if self.settled.is_none() && here >= longest && self.candidate.is_none() && self.wanders.is_none() {
            self.guess()?;
            if self.settled.is_none() {
                self.decide()?;
            }
        }
        let most = longest * (1 + confirm) + PATIENCE as usize;
        let pending = self.again.is_some() || self.candidate.is_some() || here < longest;
        Ok(self.settled.is_none() && pending && here < most)
    }

    /// Whether the last point is near the one n before.
    fn recurs(&self, n: usize, tolerance: f64) -> bool {
        let here = self.points.len() - 1;
        here >= n && self.points[here].0.near(&self.points[here - n].0, self.size.part(tolerance))
    }

    fn hits_again(&self, n: usize) -> bool {
        let here = self.points.len() - 1;
        here < 2 * n || self.points[here].1 == self.points[here - n].1
    }

    /// Whether the last rounds were this close to one another.
    fn recurs_within(&self, n: usize, rounds: usize, close: f64) -> bool {
        let here = self.points.len() - 1;
        here >= n * (rounds + 1)
            && (0..n * rounds).all(|i| self.points[here - i].0.near(&self.points[here - i - n].0, close))
    }

    /// The last round as a cycle.
    fn seen(&self, n: usize) -> Cycle<D::Point> {
        let round = &self.points[self.points.len() - n..];
        let impacts = round.iter().map(|point| point.1).sum();
        let points = ordered(round.iter().map(|point| point.0.clone()).collect(), SectionState::plane);
        Cycle { points, impacts, same: self.size.same(), multipliers: Vec::new() }
    }

    /// Looks for the orbit of a period at which points recur.
    fn attempt(&mut self, n: usize) -> Result<()> {
        let here = self.points.len() - 1;
        let (at, mean) = (self.points[here].0.coordinates(), self.mean(n));
        let found = tendency(self.dynamics, at, self.detection.phase, n, mean.as_deref(), &self.size)?;
        self.keep(found, here, n);
        Ok(())
    }

    /// The mean of every n-th point back from the last, of some.
    fn mean(&self, n: usize) -> Option<Vec<f64>> {
        let some: Vec<&[f64]> =
            self.points.iter().rev().step_by(n).take(AVERAGED).map(|point| point.0.coordinates()).collect();
        let sum = |i: usize| some.iter().map(|point| point[i]).sum::<f64>() / some.len() as f64;
        (some.len() >= FEW).then(|| (0..some[0].len()).map(sum).collect())
    }

    /// Looks for an orbit of period 1, or of the period at which the last point is nearest to one before: a
    /// transient may last, and not recur.
    fn guess(&mut self) -> Result<()> {
        let here = self.points.len() - 1;
        let (last, before) = self.points.split_last().expect("never empty");
        let apart = |n: usize| {
            let other = before[here - n].0.coordinates();
            last.0.coordinates().iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let longest = self.detection.longest.min(GUESSED).min(here);
        let nearest = (1..=longest).min_by(|&a, &b| apart(a).total_cmp(&apart(b))).unwrap_or(1);
        let likely = apart(nearest) <= LIKELY * self.size.extent;
        self.attempt(1)?;
        if self.settled.is_none() && nearest > 1 && likely {
            self.attempt(nearest)?;
        }
        Ok(())
    }

    /// Whether the motion wanders, once no orbit is found; if not, it is looked at again.
    fn decide(&mut self) -> Result<()> {
        let here = self.points.len() - 1;
        let at = self.points[here].0.coordinates();
        let lasted = self.detection.transient.saturating_add(here as u64);
        let wanders = wanders(self.dynamics, at, self.detection.phase, (lasted, self.found), self.monitor)?;
        self.wanders = Some(wanders);
        self.again = if wanders { None } else { self.again.or(Some(here + (here / 2).max(1))) };
        Ok(())
    }

    fn keep(&mut self, found: Tendency<D::Point>, here: usize, n: usize) {
        self.found |= matches!(found, Tendency::NotYet | Tendency::Elsewhere);
        match found {
            Tendency::Settled(cycle) => self.settled = Some(cycle),
            // Ever more rarely.
            Tendency::NotYet => self.again = Some(here + n.max(here / 2)),
            _ if self.wanders == Some(false) => self.again = Some(here + n.max(here / 2)),
            _ => {}
        }
    }

    /// What the points amount to once no other is asked for.
    ///
    /// # Errors
    /// Those of [`Motion::pass`]; the monitor's.
    pub fn fate(&mut self) -> Result<Fate<D::Point>> {
        if let Some(cycle) = self.settled.take() {
            return Ok(Fate::Periodic(cycle));
        }
        if self.wanders.is_none() && self.again.is_none() && self.candidate.is_none() {
            self.decide()?;
        }
        Ok(if self.wanders == Some(true) { Fate::Irregular } else { Fate::Unsettled })
    }
}

/// Points of which the mean is taken, at the most and at the least.
const AVERAGED: usize = 256;
const FEW: usize = 8;
/// The longest period that is guessed where points do not recur.
const GUESSED: usize = 16;
