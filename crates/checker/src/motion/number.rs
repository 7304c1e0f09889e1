//! What the equations are evaluated in: intervals, and intervals with a derivative in one direction.

use std::ops::{Add, Mul, Neg, Sub};

use super::Interval;

/// An enclosed number. Of every operation the result encloses the true one for all enclosed arguments; so do
/// its derivatives, if it has one.
pub(crate) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    const ZERO: Self;
    const ONE: Self;
    const MINUS_ONE: Self;

    /// A number whose derivative is 0.
    fn constant(value: Interval) -> Self;

    /// The number itself.
    fn value(self) -> Interval;

    /// Its derivative.
    fn slope(self) -> Interval;

    /// Divided by 2^k.
    fn shifted_down(self, k: u32) -> Self;

    /// Divided by n ≥ 1.
    fn divided(self, n: i128) -> Self;

    /// The quotients; nothing is known where the divisor may be zero.
    fn over(self, other: Self) -> Self;

    /// The squares.
    fn squared(self) -> Self;

    /// The roots; nothing is known where the number may be negative, nor of the derivative at 0.
    fn root(self) -> Self;

    /// The same number, known to lie between −1 and 1.
    fn within_unit(self) -> Self;

    /// One unit at each end of the number, `more` and a unit at each end of the derivative.
    fn outwards(self, more: Interval) -> Self;
}

impl Number for Interval {
    const ZERO: Self = Interval::ZERO;
    const ONE: Self = Interval::ONE;
    const MINUS_ONE: Self = Interval::MINUS_ONE;

    fn constant(value: Interval) -> Self {
        value
    }

    fn value(self) -> Interval {
        self
    }

    fn slope(self) -> Interval {
        Interval::ZERO
    }

    fn shifted_down(self, k: u32) -> Self {
        self.shifted_down(k)
    }

    fn divided(self, n: i128) -> Self {
        self.divided(n)
    }

    fn over(self, other: Self) -> Self {
        self.over(other)
    }

    fn squared(self) -> Self {
        self.squared()
    }

    fn root(self) -> Self {
        self.roots()
    }

    fn within_unit(self) -> Self {
        self.within_unit()
    }

    fn outwards(self, _: Interval) -> Self {
        self.outwards()
    }
}

/// A number with its derivative in one direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Dual {
    pub value: Interval,
    pub slope: Interval,
}

impl Number for Dual {
    const ZERO: Self = Dual { value: Interval::ZERO, slope: Interval::ZERO };
    const ONE: Self = Dual { value: Interval::ONE, slope: Interval::ZERO };
    const MINUS_ONE: Self = Dual { value: Interval::MINUS_ONE, slope: Interval::ZERO };

    fn constant(value: Interval) -> Self {
        Dual { value, slope: Interval::ZERO }
    }

    fn value(self) -> Interval {
        self.value
    }

    fn slope(self) -> Interval {
        self.slope
    }

    fn shifted_down(self, k: u32) -> Self {
        Dual { value: self.value.shifted_down(k), slope: self.slope.shifted_down(k) }
    }

    fn divided(self, n: i128) -> Self {
        Dual { value: self.value.divided(n), slope: self.slope.divided(n) }
    }

    /// (x/y)′ = (x′ − (x/y) y′)/y.
    fn over(self, other: Self) -> Self {
        let value = self.value.over(other.value);
        Dual { value, slope: (self.slope - value * other.slope).over(other.value) }
    }

    fn squared(self) -> Self {
        let half = self.value * self.slope;
        Dual { value: self.value.squared(), slope: half + half }
    }

    fn root(self) -> Self {
        let root = self.value.roots();
        Dual { value: root, slope: self.slope.over(root + root) }
    }

    fn within_unit(self) -> Self {
        Dual { value: self.value.within_unit(), ..self }
    }

    fn outwards(self, more: Interval) -> Self {
        Dual { value: self.value.outwards(), slope: self.slope.widened(more.outwards()) }
    }
}

impl Neg for Dual {
    type Output = Dual;

    fn neg(self) -> Dual {
        Dual { value: -self.value, slope: -self.slope }
    }
}

impl Add for Dual {
    type Output = Dual;

    fn add(self, other: Dual) -> Dual {
        Dual { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Dual;

    fn sub(self, other: Dual) -> Dual {
        Dual { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Dual {
    type Output = Dual;

    fn mul(self, other: Dual) -> Dual {
        Dual { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}
