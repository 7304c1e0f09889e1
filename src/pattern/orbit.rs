//! The points of a predicted orbit, for tables and pictures.

use super::{Coordinates, Failure, Map, Scalar, Value, matrix::dot, solve};
use crate::{
    error::{Error, Result},
    number::{Ball, Precision},
};

/// A point of a predicted orbit to leading order: x = x̃ + |eµ| times `x`.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct PredictedPoint {
    /// The impact that it follows, from 1.
    pub i: usize,
    /// The iterates of f since that impact: 0 is just after it, n_i just before the next.
    pub k: u64,
    /// sign(eµ) A^k X_i, in the coordinates of the map or of its section change P.
    pub x: Vec<Value>,
    /// sign(eµ)(C A^k X_i + 1): h / |eµ|. Positive between impacts; for k = n_i and at k = 0 it is not a
    /// condition.
    pub gap: Value,
}

const BITS: u32 = 512;

/// The orbit of a pattern for a sign of eµ, m + Σ n_i points. It solves (32); whether it exists is for
/// [`Analysis`](super::Analysis) to say. Cost: O(P N³ + m N³ + n N²) products of balls of 512 bits, P the
/// greatest of the m periods and n = Σ n_i; memory: O(P N² + n N) of them.
///
/// # Errors
/// An input error if det D = 0, or if it cannot be told from 0 with 512 bits.
///
/// ```
/// use grazing::pattern::{Analysis, Map, Numbers, predicted_orbit};
/// let text = r#"
///     format = "grazing-map 1"
///     A = [[0.1, 1], ["-1/3", 0]]
///     B = [0, 1]
///     C = [1, 0]
///     e = 1
/// "#;
/// let map = Map::from_toml(text, "map.toml")?;
/// // Theorem 1 for the pattern (1, 2), and the points of its orbit if it exists.
/// let report = Analysis::new(&map, 2, Numbers::Enclosed).judge(&[1, 2]);
/// assert!(!report.is_open());
/// if let Some(positive) = report.side() {
///     assert_eq!(predicted_orbit(&map, &[1, 2], positive)?.len(), 5);
/// }
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn predicted_orbit(map: &Map, periods: &[u64], positive: bool) -> Result<Vec<PredictedPoint>> {
    let last = periods.iter().copied().max().unwrap_or(1);
    let coordinates = Coordinates::<Ball>::new(map, last, Precision::new(BITS));
    let solved = coordinates.as_ref().ok_or(Failure::Unknown).and_then(|map| Ok((map, solve(map, periods)?)));
    let (map, solution) = solved.map_err(|failure| {
        let how = if failure == Failure::Singular { "det D = 0" } else { "det D may be 0" };
        Error::input(format!("the pattern has no orbit to show: {how}"))
    })?;
    let signed = |x: &Ball| if positive { x.value() } else { -x.value() };
    let zero = crate::number::Real::integer(0, map.context());
    let one = crate::number::Real::integer(1, map.context());
    let mut points = Vec::new();
    for (i, (&n, x)) in periods.iter().zip(&solution.x).enumerate() {
        for k in 0..=n {
            let here = map.power(k).apply(x, map.context());
            let gap = dot(map.power(k).row(0), x, &zero) + &one;
            points.push(PredictedPoint {
                i: i + 1,
                k,
                x: map.original(&here).iter().map(signed).collect(),
                gap: signed(&gap),
            });
        }
    }
    Ok(points)
}
