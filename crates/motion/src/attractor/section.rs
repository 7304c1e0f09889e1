//! The stroboscopic section: a run looked at once a forcing period.

use super::dynamics::Motion;
use crate::{
    error::Result,
    motion::{RunEnd, Time},
};

/// A point of the section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionPoint<P = [f64; 2]> {
    /// The forcing period in which it lies.
    pub(crate) period: i64,
    /// The state: (q, u) for an oscillator.
    pub at: P,
    /// Impacts since the point before, or since the start.
    pub(crate) impacts: u64,
}

/// Shows the next `count` points at `phase` ∈ [0, 2π), the first strictly later than the run's time; false
/// from `each` ends it early. Returns [`RunEnd::Reached`] unless the run ended by itself.
///
/// # Errors
/// Those of [`Motion::pass`].
pub fn section<M: Motion>(
    run: &mut M,
    phase: f64,
    count: u64,
    mut each: impl FnMut(SectionPoint<M::Point>) -> bool,
) -> Result<RunEnd> {
    stops(run, phase, count, |run, period, impacts| each(SectionPoint { period, at: run.point(), impacts }))
}

/// The same with the run itself, where its state need not be looked at: the period and the impacts.
pub(super) fn stops<M: Motion>(
    run: &mut M,
    phase: f64,
    count: u64,
    mut each: impl FnMut(&M, i64, u64) -> bool,
) -> Result<RunEnd> {
    let now = run.time();
    // A run that stopped at the phase may be before it by rounding.
    let mut next = Time::new(now.period + i64::from(now.phase >= phase - 1e-12), phase);
    for _ in 0..count {
        let before = run.impacts();
        let end = run.pass(next)?;
        if end != RunEnd::Reached {
            return Ok(end);
        }
        if !each(run, next.period, run.impacts() - before) {
            break;
        }
        next.period += 1;
    }
    Ok(RunEnd::Reached)
}
