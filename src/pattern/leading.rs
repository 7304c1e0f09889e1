//! The leading-order solution (32) of a pattern in floats, for who looks for its orbit in a true system: for
//! local maps of any dimension, and for those of half a period.

use super::{Report, Value};
use crate::error::{Error, Result};

/// What an impact of a pattern follows from, over η = eµ.
pub(crate) struct LeadingImpact {
    /// X just after the impact before it.
    pub x: Vec<f64>,
    /// The periods since.
    pub periods: u64,
    /// Y at the impact: its speed is √(2a_G) ηY.
    pub y: f64,
}

impl Value {
    /// The middle of its enclosure.
    pub(crate) fn middle(&self) -> f64 {
        let interval = self.enclosure();
        interval.lo() + (interval.hi() - interval.lo()) / 2.0
    }
}

impl Report {
    /// The impacts of the pattern (n₁, …, n_m) that it is about, in their order.
    ///
    /// # Errors
    /// An input error if the report has no solution.
    pub(crate) fn impacts(&self, periods: &[u64]) -> Result<Vec<LeadingImpact>> {
        let solution =
            self.orbit.as_ref().ok_or_else(|| Error::input("the pattern is singular: no start"))?;
        let m = periods.len();
        let impact = |before: usize| LeadingImpact {
            x: solution.x[before].iter().map(Value::middle).collect(),
            periods: periods[before],
            y: solution.y[before].middle(),
        };
        Ok((0..m).map(|i| impact((i + m - 1) % m)).collect())
    }
}

/// An impact of a motion that follows a pattern of the map of half a period and its mirror.
pub(crate) struct HalfImpact {
    /// Which of the pattern's impacts, from 0.
    pub impact: usize,
    /// Whether it comes half a period late, on the mirror of the stop.
    pub late: bool,
    /// Whole periods from its phase to that of the next.
    pub periods: u32,
}

/// The impacts of a pattern of the map of half of `width` periods: the stops alternate with the halves, and a
/// pattern with an odd number of halves is gone round twice.
pub(crate) fn halves(pattern: &[u64], width: u64) -> Vec<HalfImpact> {
    let rounds = if pattern.iter().sum::<u64>() % 2 == 1 { 2 } else { 1 };
    // Whole periods before a half: the other half of one is in the phase.
    let begun = |passed: u64| (passed * width - passed % 2) / 2;
    let mut passed = 0;
    let impacts = (0..rounds).flat_map(|_| pattern.iter().enumerate());
    impacts
        .map(|(impact, n)| {
            let (late, before) = (passed % 2 == 1, begun(passed));
            passed += n;
            HalfImpact { impact, late, periods: (begun(passed) - before) as u32 }
        })
        .collect()
}
