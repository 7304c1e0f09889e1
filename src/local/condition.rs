//! Condition numbers, to say how hard a case is.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Plane, Point, Polar, Quantity};
use crate::number::{Ball, Precision, Sign};

/// log₁₀ |x|, to be printed only.
pub fn log10(x: &BigRational) -> f64 {
    if x.is_zero() {
        return f64::NEG_INFINITY;
    }
    let shift = x.numer().bits() as i64 - x.denom().bits() as i64;
    let power = BigInt::one() << shift.unsigned_abs();
    let scaled = if shift >= 0 { x / power } else { x * power };
    scaled.abs().to_f64().unwrap_or(1.0).log10() + shift as f64 * std::f64::consts::LOG10_2
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
