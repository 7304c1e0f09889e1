//! Timing, and what numbers say of accuracy: digits, widths, condition numbers.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use num_rational::BigRational;

use grazing::local::condition::log10;

/// The time of one call, as the averages of three batches of about this length, or of one call each.
pub(super) fn batches<R>(length: Duration, mut work: impl FnMut() -> R) -> [Duration; 3] {
    let once = Instant::now();
    black_box(work());
    let calls = (length.as_nanos() / once.elapsed().as_nanos().max(1)).clamp(1, 20_000) as u32;
    [(); 3].map(|()| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(work());
        }
        start.elapsed() / calls
    })
}

/// The median, the lower and the upper quartile.
pub(super) fn quartiles(mut times: Vec<Duration>) -> [Duration; 3] {
    times.sort();
    let at = |share: usize| times.get((times.len().max(1) - 1) * share / 4).copied().unwrap_or_default();
    [at(2), at(1), at(3)]
}

/// The upper median; not a number if there is none.
pub(super) fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The ends of an enclosure, exactly; `None` if it has none.
pub(super) type Bounds = Option<(BigRational, BigRational)>;

/// Decimal digits that an enclosure makes certain: −log₁₀ of radius over |midpoint|, at least 0.
pub(super) fn certain(bounds: &Bounds) -> f64 {
    bounds.as_ref().map_or(0.0, |(lo, hi)| (log10(&(hi + lo)) - log10(&(hi - lo))).max(0.0))
}

/// log₁₀ of its width.
pub(super) fn width(bounds: &Bounds) -> f64 {
    bounds.as_ref().map_or(f64::INFINITY, |(lo, hi)| log10(&(hi - lo)))
}

/// Digits of a float that agree with a value that is not 0: 0 to 17.
pub(super) fn right_digits(found: f64, value: &BigRational) -> f64 {
    BigRational::from_float(found)
        .map_or(0.0, |found| (log10(value) - log10(&(found - value))).clamp(0.0, 17.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_are_quartiles() {
        let of = |times: &[u64]| {
            quartiles(times.iter().map(|&t| Duration::from_nanos(t)).collect()).map(|t| t.as_nanos())
        };
        assert_eq!(of(&[5, 1, 4, 2, 3]), [3, 2, 4]);
        assert_eq!(of(&[7]), [7, 7, 7]);
    }
}
