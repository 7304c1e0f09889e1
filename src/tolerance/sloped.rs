//! Numbers that depend on the two parameters of a cell: where they and their slopes are, in intervals.
//!
//! By the rules of differentiation, each step in outward rounding. Where a divisor may be 0 nothing is known
//! of the quotient, and so of none of its slopes.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use crate::number::{FloatInterval, Real, Sign};

type F = FloatInterval;

/// A function of two parameters on a cell: all its values there lie in an interval, and all its derivatives
/// by either parameter.
#[derive(Debug, Clone, Copy)]
pub struct Sloped {
    pub(super) value: F,
    pub(super) slope: [F; 2],
}

impl Sloped {
    /// The parameter itself, the first (0) or the second (1), with values in an interval.
    pub fn parameter(axis: usize, value: F) -> Sloped {
        let slope = [0, 1].map(|i| F::integer(i32::from(i == axis), &()));
        Sloped { value, slope }
    }

    /// What depends on neither.
    pub fn constant(value: F) -> Sloped {
        Sloped { value, slope: [F::integer(0, &()); 2] }
    }

    /// Where its values are.
    pub fn value(&self) -> FloatInterval {
        self.value
    }

    /// Where its slopes in both parameters are.
    pub fn slope(&self) -> [FloatInterval; 2] {
        self.slope
    }

    fn with(self, other: &Sloped, value: F, slope: impl Fn(F, F) -> F) -> Sloped {
        Sloped { value, slope: [0, 1].map(|i| slope(self.slope[i], other.slope[i])) }
    }
}

/// (f g)′ = f′ g + f g′.
fn of_product([f, g]: [F; 2], by_f: F, by_g: F) -> F {
    by_f * &g + &(f * &by_g)
}

/// (f/g)′ = (f′ − (f/g) g′)/g.
fn of_quotient(quotient: F, g: F, by_f: F, by_g: F) -> F {
    (by_f - &(quotient * &by_g)) / &g
}

impl Neg for Sloped {
    type Output = Self;

    fn neg(self) -> Self {
        Sloped { value: -self.value, slope: self.slope.map(|x| -x) }
    }
}

impl Add<&Sloped> for Sloped {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        self.with(other, self.value + &other.value, |a, b| a + &b)
    }
}

impl Sub<&Sloped> for Sloped {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self.with(other, self.value - &other.value, |a, b| a - &b)
    }
}

impl Mul<&Sloped> for Sloped {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let of = [self.value, other.value];
        self.with(other, self.value * &other.value, |a, b| of_product(of, a, b))
    }
}

impl Div<&Sloped> for Sloped {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        let quotient = self.value / &other.value;
        self.with(other, quotient, |a, b| of_quotient(quotient, other.value, a, b))
    }
}

impl Real for Sloped {
    type Context = ();

    fn ratio(value: &BigRational, (): &()) -> Self {
        Sloped::constant(F::ratio(value, &()))
    }

    fn integer(value: i32, (): &()) -> Self {
        Sloped::constant(F::integer(value, &()))
    }

    fn sign(&self) -> Option<Sign> {
        self.value.sign()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::expansion::{float, hull};

    fn q(p: i64, d: i64) -> BigRational {
        BigRational::new(p.into(), d.into())
    }

    /// f = (x² − 3y)/(y + x y) and its derivatives in exact numbers, at points of a cell.
    #[test]
    fn values_and_slopes_at_points_are_in_those_of_the_cell() {
        fn f<T: Real<Context = ()>>(x: &T, y: &T) -> T {
            let over = x.clone() * x - &(T::integer(3, &()) * y);
            over / &(y.clone() + &(x.clone() * y))
        }
        let (wide, far) = ([q(1, 3), q(2, 5)], [q(7, 4), q(2, 1)]);
        let side = |[lo, hi]: &[BigRational; 2]| hull(float(lo), float(hi));
        let found = f(&Sloped::parameter(0, side(&wide)), &Sloped::parameter(1, side(&far)));
        assert!(found.value.hi() - found.value.lo() < 1.5 && found.sign() == Some(Sign::Negative));
        for (i, j) in (0..5).flat_map(|i| (0..5).map(move |j| (i, j))) {
            let at = |[lo, hi]: &[BigRational; 2], i: i64| lo + (hi - lo) * q(i, 4);
            let (x, y) = (at(&wide, i), at(&far, j));
            let one = q(1, 1);
            let value = (&x * &x - q(3, 1) * &y) / (&y + &x * &y);
            assert!(found.value.contains(&value));
            // f = (x²/y − 3)/(1 + x).
            let by_x = (q(2, 1) * &x / &y - &value) / (&one + &x);
            let by_y = -(&x * &x / (&y * &y)) / (&one + &x);
            assert!(found.slope[0].contains(&by_x) && found.slope[1].contains(&by_y), "{i} {j}");
        }
    }

    #[test]
    fn nothing_is_known_of_a_quotient_by_what_may_be_zero() {
        let x = Sloped::parameter(0, F::from_bounds(-1.0, 2.0));
        let found = Sloped::integer(1, &()) / &x;
        assert_eq!((found.value, found.slope[0], found.sign()), (F::WHOLE, F::WHOLE, None));
    }
}
