//! What the formulas ask of a number, so that each is written once and runs on every rung.
//!
//! There are no ordering operators and no conversion from `f64`: a formula starts from exact fractions
//! and branches on decided signs only. Rungs: [`Plain`](super::Plain) (no guarantee),
//! [`FloatInterval`](super::FloatInterval), [`Ball`](super::Ball), and `BigRational` (exact, no sines).

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use super::{Angle, Sign};

/// A number that the field operations apply to; an enclosure's result contains every possible true result.
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
}

/// A rung with sines and cosines of exact rational multiples of π.
pub trait Circular: Real {
    /// Whether a sign that it tells is certain. Where it is not, the form that loses least is to be taken.
    const CERTAIN: bool = true;

    /// sin πx for the angle πx.
    fn sin(angle: &Angle, context: &Self::Context) -> Self;

    /// cos πx for the angle πx.
    fn cos(angle: &Angle, context: &Self::Context) -> Self {
        Self::sin(&angle.complement(), context)
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

    fn ratio(value: &BigRational, (): &()) -> Self {
        value.clone()
    }

    fn integer(value: i32, (): &()) -> Self {
        BigRational::from_integer(value.into())
    }

    fn sign(&self) -> Option<Sign> {
        Some(Sign::of(self))
    }
}
