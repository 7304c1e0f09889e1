//! Intervals with `f64` end points: the first rung that promises anything.
//!
//! No rounding modes and no libm. Each end point is computed to nearest and then moved outwards by one
//! float, unless an error-free transformation shows that it already lies on the right side. IEEE 754
//! arithmetic without extended precision is assumed, as Rust guarantees on every target but x87.
//!
//! Operations are `#[inline]`: each is a few operations of floats, and a call across packages would cost as
//! much again.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{Angle, Circular, Real, Sign, float_sine};

/// The reals from `lo` to `hi`; −∞ and +∞ say that nothing is known on that side.
///
/// Invariant: `lo ≤ hi`, neither is NaN. Equality is that of the two end points, not of the enclosed numbers.
///
/// ```
/// use grazing_number::{FloatInterval, Real, Sign, parse_rational};
/// let third = FloatInterval::ratio(&parse_rational("1/3")?, &());
/// let sum = third + &third;
/// assert!(sum.contains(&parse_rational("2/3")?) && sum.lo() < sum.hi());
/// let rest = sum + &third - &FloatInterval::integer(1, &());
/// assert_eq!(rest.sign(), None);
/// assert_eq!((rest / &third).sign(), None);
/// assert_eq!((third / &rest), FloatInterval::WHOLE);
/// assert_eq!((sum - &third).sign(), Some(Sign::Positive));
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatInterval {
    lo: f64,
    hi: f64,
}

impl FloatInterval {
    /// The whole real line: nothing is known.
    pub const WHOLE: FloatInterval = FloatInterval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    const ZERO: FloatInterval = FloatInterval { lo: 0.0, hi: 0.0 };

    /// The interval from `lo` to `hi`; the whole line if that is empty or not a number.
    ///
    /// ```
    /// use grazing_number::{FloatInterval, parse_rational};
    /// let x = FloatInterval::from_bounds(0.5, f64::INFINITY);
    /// assert_eq!((x.lo(), x.hi(), x.exact_bounds()), (0.5, f64::INFINITY, None));
    /// assert!(x.contains(&parse_rational("1/2")?) && !x.contains(&parse_rational("1/3")?));
    /// assert_eq!(FloatInterval::from_bounds(2.0, 1.0), FloatInterval::WHOLE);
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    #[inline]
    pub fn from_bounds(lo: f64, hi: f64) -> FloatInterval {
        if lo <= hi { FloatInterval { lo, hi } } else { FloatInterval::WHOLE }
    }

    /// The lower end: no enclosed number is below it. An example of this and what follows is at
    /// [`from_bounds`](FloatInterval::from_bounds).
    #[inline]
    pub fn lo(&self) -> f64 {
        self.lo
    }

    /// The upper end: no enclosed number is above it.
    #[inline]
    pub fn hi(&self) -> f64 {
        self.hi
    }
}

/// a + b rounded down. Knuth's two-sum gives the exact rounding error whenever the sum is finite.
#[inline]
fn add_down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if !sum.is_finite() {
        return if sum == f64::INFINITY && a.is_finite() && b.is_finite() { f64::MAX } else { below(sum) };
    }
    let t = sum - a;
    let error = (a - (sum - t)) + (b - t);
    if error >= 0.0 { sum } else { sum.next_down() }
}

/// An infinite or undefined sum gives no lower bound but −∞.
#[inline]
fn below(x: f64) -> f64 {
    if x == f64::INFINITY { x } else { f64::NEG_INFINITY }
}

/// The exact error ab − p of p = fl(ab), if neither overflow nor underflow can spoil it.
///
/// Dekker's product on Veltkamp halves: exact while 2⁻⁹⁰⁰ < |p| < 2⁹⁰⁰ and both factors are below 2⁹⁰⁰.
#[inline]
fn product_error(a: f64, b: f64, p: f64) -> Option<f64> {
    const BIG: f64 = f64::from_bits((1023 + 900) << 52);
    const SMALL: f64 = f64::from_bits((1023 - 900) << 52);
    if !(p.abs() > SMALL && p.abs() < BIG && a.abs() < BIG && b.abs() < BIG) {
        return None;
    }
    let split = |x: f64| {
        let c = 134_217_729.0 * x; // 2²⁷ + 1
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    Some(((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0)
}

/// The largest float known to be ≤ ab and the least known to be ≥ ab. 0·∞ counts as 0, as it must for end
/// points.
#[inline]
fn product(a: f64, b: f64) -> (f64, f64) {
    if a == 0.0 || b == 0.0 {
        return (0.0, 0.0);
    }
    let p = a * b;
    if p.is_infinite() && (a.is_infinite() || b.is_infinite()) {
        return (p, p);
    }
    match product_error(a, b, p) {
        Some(error) => directed(p, error),
        None => (p.next_down(), p.next_up()),
    }
}

/// The floats next to `x` + `error` below and above, for an `error` within half a unit of x's last place, x
/// normal.
#[inline]
fn directed(x: f64, error: f64) -> (f64, f64) {
    // The neighbour away from zero is one up in bits, whatever the sign.
    let away = (error > 0.0) == (x > 0.0);
    let bits = x.to_bits();
    let other = f64::from_bits(if away { bits + 1 } else { bits - 1 });
    match error {
        e if e < 0.0 => (other, x),
        e if e > 0.0 => (x, other),
        _ => (x, x),
    }
}

/// Bounds of a/b for finite b ≠ 0.
#[inline]
fn quotient(a: f64, b: f64) -> (f64, f64) {
    let q = a / b;
    if a == 0.0 || a.is_infinite() {
        return (q, q);
    }
    // a − qb is a float (Sterbenz), computed exactly through p = fl(qb).
    let p = q * b;
    match product_error(q, b, p) {
        Some(error) if a.abs().min(q.abs()) > 1e-270 && a.abs() < 1e270 => {
            let rest = (a - p) - error;
            directed(q, if b > 0.0 { rest } else { -rest })
        }
        _ => (q.next_down(), q.next_up()),
    }
}

impl Neg for FloatInterval {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        FloatInterval { lo: -self.hi, hi: -self.lo }
    }
}

impl Add<&FloatInterval> for FloatInterval {
    type Output = Self;

    #[inline]
    fn add(self, other: &Self) -> Self {
        FloatInterval { lo: add_down(self.lo, other.lo), hi: -add_down(-self.hi, -other.hi) }
    }
}

impl Sub<&FloatInterval> for FloatInterval {
    type Output = Self;

    #[inline]
    fn sub(self, other: &Self) -> Self {
        self + &-*other
    }
}

impl Mul<&FloatInterval> for FloatInterval {
    type Output = Self;

    #[inline]
    fn mul(self, other: &Self) -> Self {
        let (a, b) = (self, *other);
        let span = |lo: (f64, f64), hi: (f64, f64)| FloatInterval { lo: lo.0, hi: hi.1 };
        // Which end points meet is settled by the signs; only two straddling factors need all four products.
        if b.lo >= 0.0 {
            let low = if a.lo >= 0.0 { b.lo } else { b.hi };
            let high = if a.hi >= 0.0 { b.hi } else { b.lo };
            span(product(a.lo, low), product(a.hi, high))
        } else if b.hi <= 0.0 {
            -(a * &-b)
        } else if a.lo >= 0.0 || a.hi <= 0.0 {
            b * &a
        } else {
            let (down, up) = (product(a.lo, b.hi), product(a.hi, b.hi));
            let (down2, up2) = (product(a.hi, b.lo), product(a.lo, b.lo));
            FloatInterval { lo: down.0.min(down2.0), hi: up.1.max(up2.1) }
        }
    }
}

impl Div<&FloatInterval> for FloatInterval {
    type Output = Self;

    /// The quotients; the whole line if the divisor contains zero or is unbounded.
    #[inline]
    fn div(self, other: &Self) -> Self {
        let (a, b) = (self, *other);
        if !(b.lo.is_finite() && b.hi.is_finite()) || (b.lo <= 0.0 && b.hi >= 0.0) {
            return FloatInterval::WHOLE;
        }
        if b.hi < 0.0 {
            return -(a / &-b);
        }
        let low = if a.lo >= 0.0 { b.hi } else { b.lo };
        let high = if a.hi >= 0.0 { b.lo } else { b.hi };
        FloatInterval { lo: quotient(a.lo, low).0, hi: quotient(a.hi, high).1 }
    }
}

impl Real for FloatInterval {
    type Context = ();

    fn ratio(value: &BigRational, (): &()) -> Self {
        if value.is_zero() {
            return FloatInterval::ZERO;
        }
        let (numerator, denominator) = (value.numer().magnitude(), value.denom().magnitude());
        // 64 or 65 bits of the quotient, cut to 64: all that two end points can show.
        let shift = denominator.bits() as i64 - numerator.bits() as i64 + 64;
        let (quotient, exact) = {
            let (n, d) = if shift >= 0 {
                (numerator << shift, denominator.clone())
            } else {
                (numerator.clone(), denominator << -shift)
            };
            let quotient = &n / &d;
            let exact = &quotient * d == n;
            (quotient, exact)
        };
        let excess = quotient.bits() - 64;
        let exact = exact && quotient.trailing_zeros().is_none_or(|zeros| zeros >= excess);
        let mantissa = (quotient >> excess).to_u64().unwrap_or(u64::MAX);
        let exponent = excess as i64 - shift;
        let magnitude = float_sine::enclose(mantissa, u64::from(!exact), exponent);
        if value.is_negative() { -magnitude } else { magnitude }
    }

    #[inline]
    fn integer(value: i32, (): &()) -> Self {
        FloatInterval { lo: value.into(), hi: value.into() }
    }

    #[inline]
    fn sign(&self) -> Option<Sign> {
        if self.lo > 0.0 {
            Some(Sign::Positive)
        } else if self.hi < 0.0 {
            Some(Sign::Negative)
        } else if self.lo == 0.0 && self.hi == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}

impl Circular for FloatInterval {
    fn sin(angle: &Angle, (): &()) -> Self {
        float_sine::sin(angle)
    }

    fn sines_over_cosine(angles: [&Angle; 2], sum: &Angle, (): &()) -> Self {
        float_sine::sines_over_cosine(angles, sum)
    }

    #[inline]
    fn tighter(self, other: Self) -> Self {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        assert!(lo <= hi, "two enclosures of one number are disjoint");
        FloatInterval { lo, hi }
    }
}

impl FloatInterval {
    /// The end points as exact fractions, `None` if one is infinite.
    pub fn exact_bounds(&self) -> Option<(BigRational, BigRational)> {
        Some((BigRational::from_float(self.lo)?, BigRational::from_float(self.hi)?))
    }

    /// Whether the exact number lies in the interval.
    pub fn contains(&self, value: &BigRational) -> bool {
        let at_least =
            |x: f64| BigRational::from_float(x).map_or(x < 0.0, |x| (value - x).numer() >= &BigInt::zero());
        let at_most =
            |x: f64| BigRational::from_float(x).map_or(x > 0.0, |x| (x - value).numer() >= &BigInt::zero());
        at_least(self.lo) && at_most(self.hi)
    }
}
