//! Where the theory meets a grazing that an engine has found: its local map as `pattern` takes it, and what
//! the theory says is born there as a start for Newton's method.

use num_rational::BigRational;

use crate::error::{Error, Result};
use grazing::{
    local::Region,
    pattern::{Entry, Map, Report, Value},
};
use grazing_motion::continuation::{Known, LeadingImpact, LocalMap, Near};

/// What the theory makes of a local map.
pub trait InTheory {
    /// The map, every computed entry widened by far more than its error where Newton's method has converged,
    /// but without proof.
    ///
    /// # Errors
    /// An input error if a_G is not positive, and those of [`Map::new`].
    fn to_map(&self) -> Result<Map>;

    /// The region of (a₁, a₂), taken as they are computed; after reversing time if a₂ > 1. `None` for a₂ ≤ 0
    /// and for more degrees of freedom.
    fn region(&self) -> Option<Region>;
}

impl InTheory for LocalMap {
    fn to_map(&self) -> Result<Map> {
        if self.acceleration.is_nan() || self.acceleration <= 0.0 {
            let message = format!("a_G = {} at the grazing point; it must be positive", self.acceleration);
            return Err(Error::input(message));
        }
        let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("A is not finite"));
        let entry = |&(x, radius): &Near| match radius {
            0.0 => Ok(Entry::from(exact(x)?)),
            _ => Entry::between(exact(x - radius)?, exact(x + radius)?),
        };
        let Known { a, b, c, e, .. } = &self.known;
        let all = |row: &Vec<Near>| row.iter().map(entry).collect::<Result<Vec<Entry>>>();
        Map::new(a.iter().map(all).collect::<Result<_>>()?, all(b)?, all(c)?, entry(e)?, None)
    }

    fn region(&self) -> Option<Region> {
        self.plane().and_then(|_| Region::at(self.trace(), self.determinant))
    }
}

/// The impacts of the pattern (n₁, …, n_m) that a report is about, in their order: the leading-order solution
/// (32) in floats.
///
/// # Errors
/// An input error if the report has no solution.
pub fn leading_impacts(report: &Report, periods: &[u64]) -> Result<Vec<LeadingImpact>> {
    let solution = report.orbit.as_ref().ok_or_else(|| Error::input("the pattern is singular: no start"))?;
    let m = periods.len();
    let impact = |before: usize| LeadingImpact {
        x: solution.x[before].iter().map(Value::middle).collect(),
        periods: periods[before],
        y: solution.y[before].middle(),
    };
    Ok((0..m).map(|i| impact((i + m - 1) % m)).collect())
}
