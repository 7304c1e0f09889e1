//! The stroboscopic section: a run looked at once a forcing period.

use crate::oscillator::{
    Time,
    simulate::{Run, RunEnd},
};

/// A point of the section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionPoint {
    /// The forcing period in which it lies.
    pub period: i64,
    /// Displacement.
    pub q: f64,
    /// Velocity.
    pub u: f64,
    /// Impacts since the point before, or since the start.
    pub impacts: u64,
}

/// Shows the next `count` points at `phase` ∈ [0, 2π), the first strictly later than the run's time; false
/// from `each` ends it early. Returns [`RunEnd::Reached`] unless the run ended by itself.
pub fn section(run: &mut Run, phase: f64, count: u64, mut each: impl FnMut(SectionPoint) -> bool) -> RunEnd {
    let now = run.time();
    let mut next = Time::new(now.period + i64::from(now.phase >= phase), phase);
    for _ in 0..count {
        let before = run.impacts();
        let end = run.finish(next);
        if end != RunEnd::Reached {
            return end;
        }
        let state = run.state();
        if !each(SectionPoint {
            period: next.period,
            q: state.q,
            u: state.u,
            impacts: run.impacts() - before,
        }) {
            break;
        }
        next.period += 1;
    }
    RunEnd::Reached
}
