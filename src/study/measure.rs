//! Timing, and what numbers say of accuracy: digits, widths, condition numbers.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::{
    local::{Plane, Point, Polar, Quantity},
    number::{Ball, Precision, Sign},
};

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

/// log₁₀ |x|, to be printed only.
fn log10(x: &BigRational) -> f64 {
    if x.is_zero() {
        return f64::NEG_INFINITY;
    }
    let shift = x.numer().bits() as i64 - x.denom().bits() as i64;
    let power = BigInt::one() << shift.unsigned_abs();
    let scaled = if shift >= 0 { x / power } else { x * power };
    scaled.abs().to_f64().unwrap_or(1.0).log10() + shift as f64 * std::f64::consts::LOG10_2
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

/// The condition number of b_{n,k} or c_n: its relative change per relative change of each parameter, both
/// added.
///
/// From a step of 2⁻³⁰⁰ in balls of 1024 bits: good to a few digits below 2²⁰⁰. Infinite at a zero.
pub fn condition(at: &Point, quantity: Quantity) -> f64 {
    let precision = Precision::new(1024);
    let middle = |point: &Point| {
        let (lo, hi) = point.evaluate::<Ball>(quantity, &precision)?.exact_bounds()?;
        Some((lo + hi) / BigInt::from(2))
    };
    let step = BigRational::new(1.into(), BigInt::one() << 300);
    let scale = BigRational::one() - &step;
    let moved = match at {
        Point::Polar(polar) => {
            let polar_at = |r, s| Polar::new(r, s).ok().map(Point::Polar);
            [polar_at(polar.r() * &scale, polar.s().clone()), polar_at(polar.r().clone(), polar.s() * &scale)]
        }
        Point::Plane(plane) => {
            let plane_at = |a1, a2| Plane::new(a1, a2).ok().map(Point::Plane);
            [
                plane_at(plane.a1() * &scale, plane.a2().clone()),
                plane_at(plane.a1().clone(), plane.a2() * &scale),
            ]
        }
    };
    let Some(value) = middle(at).filter(|value| Sign::of(value) != Sign::Zero) else {
        return f64::INFINITY;
    };
    let change = |point: Option<Point>| {
        point.and_then(|point| middle(&point)).map_or(f64::INFINITY, |other| {
            10f64.powf(log10(&((other / &value - BigRational::one()) / &step)))
        })
    };
    moved.into_iter().map(change).sum()
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
