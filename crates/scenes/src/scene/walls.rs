//! Whether two walls stay apart all the period long: a bound, not a sample.

use std::f64::consts::PI;

use crate::{
    error::Result,
    motion::{Contact, Harmonic, Series},
};

/// Walls nearer than this, in units of their size, count as touching.
const CLOSE: f64 = 1e-9;

/// `None` if the walls stay apart by more than 10⁻⁹ times their size; else a time at which they do not, and
/// the gap there.
///
/// On a stretch of half-width h around m the gap g is at least g(m) − |g′(m)| h − M h²/2, M a bound of |g″|;
/// stretches are halved until that is positive or the gap at the middle is not. Rounding is far below the
/// margin. Cost: at worst about sqrt(M/g) stretches for the least gap g, some 10⁵.
pub(super) fn meet(lower: &Contact, upper: &Contact) -> Result<Option<(f64, f64)>> {
    let (low, high) = (&lower.position, &upper.position);
    let opposite = |h: &Harmonic<f64>| Harmonic { k: h.k, cos: -h.cos, sin: -h.sin };
    let harmonics: Vec<_> =
        high.harmonics().iter().cloned().chain(low.harmonics().iter().map(opposite)).collect();
    let gap = Series::new(high.mean() - low.mean(), &harmonics)?;
    let size = |series: &Series| series.mean().abs() + series.derivative_bound(0);
    let (margin, curvature) = (CLOSE * (size(low) + size(high)), gap.derivative_bound(2));
    let mut stretches = vec![(PI, PI)];
    while let Some((middle, half)) = stretches.pop() {
        let [value, slope, _] = gap.at(middle);
        if value <= margin {
            return Ok(Some((middle, value)));
        }
        if value - slope.abs() * half - curvature * half * half / 2.0 <= 0.0 {
            let half = half / 2.0;
            stretches.extend([(middle + half, half), (middle - half, half)]);
        }
    }
    Ok(None)
}
