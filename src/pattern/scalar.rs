//! What the linear algebra asks of a number besides arithmetic, and numbers as they are shown.

use std::fmt;

use num_rational::BigRational;
use num_traits::Zero;

use crate::number::{Ball, FloatInterval, Precision, Real, Sign};

/// A rung of the linear algebra.
pub trait Scalar: Real + Send + Sync {
    /// A number that contains the reals from `lo` to `hi`; `None` if the rung has only exact numbers and `lo`
    /// < `hi`.
    fn between(lo: &BigRational, hi: &BigRational, context: &Self::Context) -> Option<Self>;

    /// How good a pivot it makes, the greater the better; `None` if it may be zero.
    fn pivot(&self) -> Option<i64>;

    /// An `f64` interval that contains it.
    fn enclosure(&self) -> FloatInterval;

    /// It as a [`Value`]: exact if the rung is.
    fn value(&self) -> Value {
        Value::Enclosed(self.enclosure())
    }
}

impl Scalar for FloatInterval {
    fn between(lo: &BigRational, hi: &BigRational, (): &()) -> Option<Self> {
        Some(FloatInterval::from_bounds(Self::ratio(lo, &()).lo(), Self::ratio(hi, &()).hi()))
    }

    fn pivot(&self) -> Option<i64> {
        // The bits of positive floats are ordered as the floats are.
        (self.sign()? != Sign::Zero).then(|| self.lo().abs().min(self.hi().abs()).to_bits() as i64)
    }

    fn enclosure(&self) -> FloatInterval {
        *self
    }
}

impl Scalar for Ball {
    fn between(lo: &BigRational, hi: &BigRational, context: &Precision) -> Option<Self> {
        Some(Ball::between(lo, hi, context))
    }

    fn pivot(&self) -> Option<i64> {
        self.least_exponent()
    }

    fn enclosure(&self) -> FloatInterval {
        match self.exact_bounds() {
            Some((lo, hi)) => {
                let (lo, hi) = (FloatInterval::ratio(&lo, &()), FloatInterval::ratio(&hi, &()));
                FloatInterval::from_bounds(lo.lo(), hi.hi())
            }
            None => FloatInterval::WHOLE,
        }
    }
}

impl Scalar for BigRational {
    fn between(lo: &BigRational, hi: &BigRational, (): &()) -> Option<Self> {
        (lo == hi).then(|| lo.clone())
    }

    /// Short numbers first: they keep the later ones short.
    fn pivot(&self) -> Option<i64> {
        (!self.is_zero()).then(|| -((self.numer().bits() + self.denom().bits()) as i64))
    }

    fn enclosure(&self) -> FloatInterval {
        FloatInterval::ratio(self, &())
    }

    fn value(&self) -> Value {
        Value::Exact(self.clone())
    }
}

/// A number to be shown: an exact fraction, or the interval it certainly lies in.
///
/// Shown as p/q; or with digits that are certain up to one unit of the last; or as an interval if no digit
/// is.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// It is this.
    Exact(BigRational),
    /// It lies here.
    Enclosed(FloatInterval),
}

impl Value {
    /// The middle of its enclosure.
    pub fn middle(&self) -> f64 {
        let interval = self.enclosure();
        interval.lo() + (interval.hi() - interval.lo()) / 2.0
    }

    /// The interval it lies in.
    pub fn enclosure(&self) -> FloatInterval {
        match self {
            Value::Exact(x) => x.enclosure(),
            Value::Enclosed(x) => *x,
        }
    }

    /// An enclosure of the lesser (`greater` false) or the greater of two numbers.
    #[must_use]
    pub(super) fn extreme(self, other: Value, greater: bool) -> Value {
        match (self, other) {
            (Value::Exact(a), Value::Exact(b)) => Value::Exact(if (a < b) == greater { b } else { a }),
            (a, b) => {
                let (a, b) = (a.enclosure(), b.enclosure());
                let pick = if greater { f64::max } else { f64::min };
                Value::Enclosed(FloatInterval::from_bounds(pick(a.lo(), b.lo()), pick(a.hi(), b.hi())))
            }
        }
    }
}

impl Value {
    /// The product.
    #[must_use]
    pub(super) fn times(self, other: Value) -> Value {
        match (self, other) {
            (Value::Exact(a), Value::Exact(b)) => Value::Exact(a * b),
            (a, b) => Value::Enclosed(a.enclosure() * &b.enclosure()),
        }
    }
}

impl std::ops::Neg for Value {
    type Output = Value;

    fn neg(self) -> Value {
        match self {
            Value::Exact(x) => Value::Exact(-x),
            Value::Enclosed(x) => Value::Enclosed(-x),
        }
    }
}

/// The most significant digits shown.
const DIGITS: i32 = 12;

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (lo, hi) = match self {
            Value::Exact(x) => return f.pad(&x.to_string()),
            Value::Enclosed(x) => (x.lo(), x.hi()),
        };
        if lo == 0.0 && hi == 0.0 {
            return f.pad("0");
        }
        let (middle, radius) = (lo + (hi - lo) / 2.0, hi - lo);
        let digits = if radius == 0.0 { DIGITS } else { exponent(middle) - exponent(radius) - 1 };
        if (lo <= 0.0 && hi >= 0.0) || lo.is_infinite() || hi.is_infinite() || digits < 2 {
            // Two decimals rounded to nearest move a number by less than 0.51 %: pushed out by 0.6 % first,
            // it bounds.
            let push = |x: f64, out: f64| if x.is_finite() { x + out * 0.006 * x.abs() } else { x };
            return f.pad(&format!("[{}, {}]", scientific(push(lo, -1.0), 2), scientific(push(hi, 1.0), 2)));
        }
        // The last digit's unit is at least ten radii, and rounding adds half a unit: together below one.
        let digits = digits.min(DIGITS) as usize;
        let e = exponent(middle);
        if (-4..digits as i32).contains(&e) {
            f.pad(&format!("{middle:.*}", (digits as i32 - 1 - e) as usize))
        } else {
            f.pad(&scientific(middle, digits - 1))
        }
    }
}

fn scientific(x: f64, decimals: usize) -> String {
    if x.is_infinite() {
        return if x > 0.0 { "inf".into() } else { "-inf".into() };
    }
    format!("{x:.decimals$e}")
}

/// The decimal exponent of the leading digit of x ≠ 0, exactly: of all it prints, Rust's shortest form keeps
/// that digit.
fn exponent(x: f64) -> i32 {
    let text = format!("{x:e}");
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}
