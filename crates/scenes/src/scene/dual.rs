//! Plain `f64` arithmetic that carries a derivative along (dual numbers): no guarantee, no differences.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use crate::number::{Plain, Real, Sign};

/// A value and its derivative in one variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual {
    /// The value.
    pub value: f64,
    /// The derivative.
    pub slope: f64,
}

impl Dual {
    /// A constant.
    pub fn constant(value: f64) -> Dual {
        Dual { value, slope: 0.0 }
    }
}

impl Neg for Dual {
    type Output = Dual;

    fn neg(self) -> Dual {
        Dual { value: -self.value, slope: -self.slope }
    }
}

macro_rules! operation {
    ($trait:ident, $method:ident, $slope:expr) => {
        impl $trait<&Dual> for Dual {
            type Output = Dual;

            fn $method(self, other: &Dual) -> Dual {
                let slope: fn(Dual, Dual) -> f64 = $slope;
                Dual { value: self.value.$method(other.value), slope: slope(self, *other) }
            }
        }
    };
}

operation!(Add, add, |a, b| a.slope + b.slope);
operation!(Sub, sub, |a, b| a.slope - b.slope);
operation!(Mul, mul, |a, b| a.slope * b.value + a.value * b.slope);
operation!(Div, div, |a, b| (a.slope - a.value / b.value * b.slope) / b.value);

impl Real for Dual {
    type Context = ();

    fn ratio(value: &BigRational, (): &()) -> Dual {
        Dual::constant(Plain::ratio(value, &()).0)
    }

    fn integer(value: i32, (): &()) -> Dual {
        Dual::constant(value.into())
    }

    /// The value's own sign, as for [`Plain`].
    fn sign(&self) -> Option<Sign> {
        Plain(self.value).sign()
    }
}
