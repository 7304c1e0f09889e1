//! What an attractor looks like: period, impacts, how far it goes, how hard it hits.
//!
//! By these an engineer tells two motions apart, and a sweep tells a jump from a change by and by. Found by
//! following a motion, so nothing is proved.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::{
    detection::wait,
    dynamics::{Motion, Range},
    observe::{Attraction, Observation, Observed},
};
use crate::{
    error::Result,
    monitor::Monitor,
    motion::{RunEnd, Time},
};

/// Looks per period for the extent. Between two of them, a smooth turn is missed by at most (π/256)²/2 of its
/// bend: less than a ten-thousandth of the swing of a sine.
const LOOKS: i64 = 256;

/// Periods that a motion which is not periodic is looked at for its extent and its impacts.
const SEEN: u32 = 128;

/// What an attractor looks like.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Portrait {
    /// Its period in forcing periods, if it is periodic.
    pub period: Option<u32>,
    /// Whether it was not decided if it is.
    pub undecided: bool,
    /// Impacts once round; of one that is not periodic, in [`looked`](Self::looked) periods.
    pub impacts: u64,
    /// Forcing periods looked at.
    pub looked: u32,
    /// How far it goes, over all phases, and how hard it hits.
    pub range: Range,
}

/// Where a motion has settled, and on what.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OnAttractor<S> {
    /// A state on it.
    pub start: S,
    /// What it looks like.
    pub portrait: Portrait,
    /// Its points on the section, as they are drawn.
    pub points: Vec<[f64; 2]>,
}

/// Where a motion came to, and how far it went, whatever it is on.
pub(super) struct Passing<S> {
    /// A state on its way.
    pub start: S,
    /// How far it goes from there, over all phases, and how hard it hits.
    pub range: Range,
}

impl<S: Clone> From<&OnAttractor<S>> for Passing<S> {
    fn from(on: &OnAttractor<S>) -> Passing<S> {
        Passing { start: on.start.clone(), range: on.portrait.range }
    }
}

impl Portrait {
    /// How differently two attractors go: see `Range::apart`.
    pub fn apart(&self, other: &Portrait) -> f64 {
        self.range.apart(&other.range)
    }

    /// In words: "period 2, 3 impacts".
    pub fn words(&self) -> String {
        let impacts = |count: u64| match count {
            0 => "no impact".to_string(),
            1 => "1 impact".to_string(),
            many => format!("{many} impacts"),
        };
        match self.period {
            Some(period) => format!("period {period}, {}", impacts(self.impacts)),
            None if self.undecided => {
                format!("not settled, {} in {} periods", impacts(self.impacts), self.looked)
            }
            None => format!("not periodic, {} in {} periods", impacts(self.impacts), self.looked),
        }
    }
}

/// What the motion from a start tends to; none where it starts behind a stop or leaves every bound. Cost:
/// that of the observation, and one time round in 256 steps (128 periods of a motion that is not periodic).
///
/// # Errors
/// Those of [`Attraction::observe`]; the monitor's.
pub(crate) fn settle<D: Attraction>(
    dynamics: &D,
    from: &D::Start,
    observation: &Observation,
    monitor: &dyn Monitor,
) -> Result<Option<OnAttractor<D::Start>>> {
    let Ok(run) = dynamics.begin(from) else { return Ok(None) };
    match D::observe(vec![(dynamics, run)], observation, monitor)?.pop() {
        Some(Ok(seen)) => looked_at(dynamics, seen),
        _ => Ok(None),
    }
}

/// How far the motion from a start goes, once it has come to the phase so many times; none where it starts
/// behind a stop or leaves every bound. Cost: that many periods, and 128 in 256 steps.
///
/// # Errors
/// Those of [`Motion::pass`]; the monitor's.
pub(super) fn pass_by<D: Attraction>(
    dynamics: &D,
    from: &D::Start,
    (phase, transient): (f64, u64),
    monitor: &dyn Monitor,
) -> Result<Option<Passing<D::Start>>> {
    let Ok(mut run) = dynamics.begin(from) else { return Ok(None) };
    if wait(&mut run, phase, transient, monitor)? != RunEnd::Reached {
        return Ok(None);
    }
    let start = dynamics.here(&run);
    Ok(range(&mut run, SEEN)?.map(|range| Passing { start, range }))
}

/// What a motion that was observed tends to, as [`settle`].
///
/// # Errors
/// Those of [`Motion::pass`].
pub(super) fn looked_at<D: Attraction>(
    dynamics: &D,
    seen: Observed<D::Start, D::Point>,
) -> Result<Option<OnAttractor<D::Start>>> {
    let Observed { settled: start, cycle, undecided, points, .. } = seen;
    let period = cycle.map(|cycle| cycle.period() as u32);
    let looked = period.unwrap_or(SEEN);
    let Ok(mut run) = dynamics.begin(&start) else { return Ok(None) };
    let Some(range) = range(&mut run, looked)? else { return Ok(None) };
    let portrait = Portrait { period, undecided, impacts: run.impacts(), looked, range };
    Ok(Some(OnAttractor { start, portrait, points }))
}

/// How far a motion goes in so many periods; none where it ends before.
///
/// # Errors
/// Those of [`Motion::pass`].
pub(super) fn range(run: &mut impl Motion, periods: u32) -> Result<Option<Range>> {
    let (begun, mut seen) = (run.time(), Range::NONE);
    for look in 1..=i64::from(periods) * LOOKS {
        let part = TAU * (look % LOOKS) as f64 / LOOKS as f64;
        let until = Time::new(begun.period + look / LOOKS, begun.phase + part);
        if run.pass_seen(until, &mut seen)? != RunEnd::Reached {
            return Ok(None);
        }
    }
    Ok(Some(seen))
}
