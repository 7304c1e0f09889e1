//! Any pattern of any map: enclosures first, more bits where they cannot tell, exact fractions last.

use std::sync::OnceLock;

use num_rational::BigRational;

use super::{
    Coordinates, Failure, Map, OpenReason, Report, Scalar, Windows,
    existence::{examine, flat},
    solve,
};
use crate::number::{Ball, FloatInterval, Precision, Sign};

/// How the numbers of a report are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// As intervals that contain them: the fastest that decides.
    Enclosed,
    /// As exact fractions. Exact maps only.
    Exact,
}

/// The bits of the rungs between `f64` intervals and exact fractions.
const BITS: [u32; 3] = [128, 512, 2048];

/// Theorem 1 for any pattern of one map: each sign decided by `f64` intervals, balls of 128, 512 and 2048
/// bits, and for exact maps by fractions. A map with intervals stops at 128 bits: its own width is what it
/// cannot see through.
///
/// Shared freely between threads.
#[derive(Debug)]
pub struct Analysis<'m> {
    map: &'m Map,
    last: u64,
    numbers: Numbers,
    float: Option<Coordinates<FloatInterval>>,
    balls: [OnceLock<Option<Coordinates<Ball>>>; 3],
    exact: OnceLock<Option<Coordinates<BigRational>>>,
}

/// A report, and whether more bits could not change it.
type Attempt = (Report, bool);

impl<'m> Analysis<'m> {
    /// Prepares A, …, A^`last`; patterns may use periods up to that. With [`Numbers::Exact`] a map that is
    /// not exact is treated as with [`Numbers::Enclosed`]. Cost: O(P N³) products of `f64` intervals, P =
    /// `last`; later, once on each rung that a pattern needs, as many of its numbers. Memory: P N² numbers
    /// per rung.
    pub fn new(map: &'m Map, last: u64, numbers: Numbers) -> Self {
        let float = Coordinates::new(map, last, ());
        Analysis { map, last, numbers, float, balls: Default::default(), exact: OnceLock::new() }
    }

    /// What leaves out the patterns with a beginning that no orbit can have, for either sign of eµ, for
    /// [`Patterns::walks`](super::Patterns::walks): no pattern that exists; of an exact map none that is open
    /// with det D ≠ 0. Of a map with intervals a window may be decided where a pattern is not.
    /// `None` where nothing can be left out: in two dimensions, which have the [`Graph`](super::Graph), and
    /// where e may be 0.
    pub fn windows(&self) -> Option<Windows<'_, FloatInterval>> {
        let known = self.map.e().sign().is_some_and(|sign| sign != Sign::Zero);
        self.float.as_ref().filter(|map| known && map.dimension() > 2).map(Windows::new)
    }

    /// Theorem 1 for the pattern `periods`, each from 1 to the greatest prepared, and for one impact at a
    /// [resonance](crate::existence::Resonance) what is known there. Cost: O(m N³ + n N)
    /// operations on each rung climbed, n = Σ n_i; on the exact rung with numbers of O(n) times the bits of
    /// the map's.
    pub fn judge(&self, periods: &[u64]) -> Report {
        let report = self.by_theorem(periods);
        let one = periods.first().copied().filter(|_| periods.len() == 1);
        match report.reason {
            Some(OpenReason::Singular) => one.and_then(|n| self.map.at_resonance(n)).unwrap_or(report),
            Some(OpenReason::PerhapsSingular) => {
                one.and_then(|n| self.map.near_resonance(n)).unwrap_or(report)
            }
            _ => report,
        }
    }

    fn by_theorem(&self, periods: &[u64]) -> Report {
        let mut found = None;
        if self.numbers == Numbers::Enclosed || !self.map.is_exact() {
            if let Some(map) = &self.float {
                let attempt = self.attempt(map, periods);
                if attempt.1 {
                    return attempt.0;
                }
                found = Some(attempt);
            }
            let rungs = if self.map.is_exact() { BITS.len() } else { 1 };
            for (&bits, map) in BITS.iter().zip(&self.balls).take(rungs) {
                let map = map.get_or_init(|| Coordinates::new(self.map, self.last, Precision::new(bits)));
                if let Some(map) = map {
                    let attempt = self.attempt(map, periods);
                    if attempt.1 {
                        return attempt.0;
                    }
                    found = Some(attempt);
                }
            }
        }
        if let Some(map) = self.exact.get_or_init(|| Coordinates::new(self.map, self.last, ())) {
            return self.attempt(map, periods).0;
        }
        found.map_or_else(
            || Report::unsolved(Failure::Unknown, None, self.map.e().sign()),
            |attempt| attempt.0,
        )
    }

    fn attempt<T: Scalar>(&self, map: &Coordinates<T>, periods: &[u64]) -> Attempt {
        let (e, flat) = (self.map.e().sign(), flat(map, periods));
        match solve(map, periods) {
            Err(failure) => (Report::unsolved(failure, flat, e), failure == Failure::Singular),
            Ok(solution) => {
                let (tally, orbit) = examine(map, periods, &solution);
                let report = tally.report(e, flat, orbit);
                let known = report
                    .orbit
                    .as_ref()
                    .is_some_and(|orbit| orbit.leading_sign.is_some_and(|s| s != Sign::Zero));
                let settled = tally.is_settled() && (report.side().is_none() || known || flat.is_some());
                (report, settled)
            }
        }
    }
}
