//! What the formulas ask of a number, so that each is written once and runs on every rung.
//!
//! There are no ordering operators and no conversion from `f64`: a formula starts from exact fractions
//! and branches on decided signs only. Rungs: [`Plain`](super::Plain) (no guarantee),
//! [`FloatInterval`](super::FloatInterval), [`Ball`](super::Ball), and `BigRational` (exact, no sines).

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use super::{Angle, Sign};

/// A number that the field operations apply to; an enclosure's result contains every possible true result.
///
/// ```
/// use grazing_number::{FloatInterval, Real, Sign, parse_rational};
/// let x = FloatInterval::ratio(&parse_rational("1/3")?, &()) - &FloatInterval::integer(1, &());
/// assert_eq!(x.sign(), Some(Sign::Negative));
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub trait Real:
    Clone
    + Neg<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
{
    /// What must be known to make a number: its precision, or nothing.
    type Context;

    /// The number equal to (or the narrowest handy enclosure of) an exact fraction.
    fn ratio(value: &BigRational, context: &Self::Context) -> Self;

    /// The integer `value`, exactly.
    fn integer(value: i32, context: &Self::Context) -> Self;

    /// The sign if it is certain.
    fn sign(&self) -> Option<Sign>;

    /// 1 − (u_k + a₂^k u_{n−k})/u_n for (a₁, a₁²/4 − a₂, a₂) and (n, k), where this rung has a short way to
    /// it that keeps all its digits.
    #[must_use]
    fn plane_quotient(_point: [&BigRational; 3], _at: [u64; 2], _context: &Self::Context) -> Option<Self> {
        None
    }

    /// The sign of [`plane_quotient`](Real::plane_quotient), as far as it is certain, where this rung has a
    /// short way to it, which then tells no less than any other.
    #[must_use]
    fn plane_sign(
        _point: [&BigRational; 3],
        _at: [u64; 2],
        _context: &Self::Context,
    ) -> Option<Option<Sign>> {
        None
    }
}

/// A rung with sines and cosines of exact rational multiples of π.
///
/// ```
/// use grazing_number::{Angle, Ball, Circular, Precision, Real, parse_rational};
/// let (angle, bits) = (Angle::new(&parse_rational("1/5")?), Precision::new(64));
/// assert_eq!(format!("{:.9}", Ball::sin(&angle, &bits)), "[0.587785252 +/- 1e-9]");
/// assert_eq!(format!("{:.9}", Ball::cos(&angle, &bits)), "[0.809016994 +/- 1e-9]");
/// assert_eq!(format!("{:.9}", Ball::sines(&angle, 3, &bits)[3]), "[0.951056516 +/- 1e-9]");
/// assert_eq!(format!("{:.9}", Ball::cosines(&angle, 3, &bits)[3]), "[-0.309016994 +/- 1e-9]");
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub trait Circular: Real {
    /// Whether a sign that it tells is certain. Where it is not, the form that loses least is to be taken.
    const CERTAIN: bool = true;

    /// sin πx for the angle πx.
    fn sin(angle: &Angle, context: &Self::Context) -> Self;

    /// cos πx for the angle πx.
    fn cos(angle: &Angle, context: &Self::Context) -> Self {
        Self::sin(&angle.complement(), context)
    }

    /// −2 sin α sin β / cos(α + β) for two angles and their sum.
    fn sines_over_cosine([first, second]: [&Angle; 2], sum: &Angle, context: &Self::Context) -> Self {
        let product = Self::sin(first, context) * &Self::sin(second, context);
        -(product.clone() + &product) / &Self::cos(sum, context)
    }

    /// 1 − (sin 2πks + rⁿ sin 2π(n − k)s)/(r^(n−k) sin 2πns) for (r, s) with r < 1 and (n, k), where this
    /// rung has a short way to it that keeps all its digits.
    #[must_use]
    fn polar_quotient(
        _point: (&BigRational, &BigRational),
        _at: [u64; 2],
        _context: &Self::Context,
    ) -> Option<Self> {
        None
    }

    /// The sign of r^(n−k) sin 2πns − sin 2πks − rⁿ sin 2π(n − k)s, as far as it is certain, where this rung
    /// has a short way to it, which tells no less than any other unless r is near 1.
    #[must_use]
    fn polar_sign(
        _point: (&BigRational, &BigRational),
        _at: [u64; 2],
        _context: &Self::Context,
    ) -> Option<Option<Sign>> {
        None
    }

    /// sin(kπx) for k = 0, 1, …, n.
    fn sines(angle: &Angle, n: u64, context: &Self::Context) -> Vec<Self> {
        (0..=n).map(|k| Self::sin(&angle.times(k), context)).collect()
    }

    /// cos(kπx) for k = 0, 1, …, n.
    fn cosines(angle: &Angle, n: u64, context: &Self::Context) -> Vec<Self> {
        (0..=n).map(|k| Self::cos(&angle.times(k), context)).collect()
    }

    /// The narrower of two enclosures of one number. Without enclosures: `self`.
    ///
    /// # Panics
    /// If the two are disjoint: one of them would be wrong.
    #[must_use]
    fn tighter(self, other: Self) -> Self;
}

impl Real for BigRational {
    type Context = ();

    #[inline]
    fn ratio(value: &BigRational, (): &()) -> Self {
        value.clone()
    }

    fn integer(value: i32, (): &()) -> Self {
        BigRational::from_integer(value.into())
    }

    #[inline]
    fn sign(&self) -> Option<Sign> {
        Some(Sign::of(self))
    }
}
