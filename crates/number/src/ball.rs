//! Balls with a midpoint of any number of bits, on integers alone: no libm, no rounding modes.
//!
//! A ball is m·2^e ± radius. Each operation is exact on midpoints, then cuts the midpoint to its precision
//! and adds what that lost to the radius. A result whose exponent would leave ±2⁶² becomes the whole line, or
//! zero with a radius that bounds it. π, sines and cosines live in `ball_sine`.

use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::OnceLock;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::exponent::{Exponent, Misfit};
use super::radius::Radius;
use super::{Real, Sign, ball_forms, ball_sine};

/// Bounds with more bits than this are not written out.
const WRITTEN: i128 = 1 << 17;

/// A number of bits, and π to that many: what making balls needs.
///
/// Making one costs O(bits²) bit operations for π; make it once and pass it on.
#[derive(Debug, Clone)]
pub struct Precision {
    bits: u32,
    /// π·2^w within 2, w = [`Precision::pi_bits`].
    pub(super) pi: BigInt,
    /// ln 2, likewise, once a logarithm has asked for it.
    ln_2: OnceLock<BigInt>,
}

impl Precision {
    /// A working precision of `bits` bits, at least 16.
    ///
    /// ```
    /// use grazing_number::Precision;
    /// assert_eq!((Precision::new(64).bits(), Precision::new(1).bits()), (64, 16));
    /// ```
    pub fn new(bits: u32) -> Precision {
        let bits = bits.max(16);
        Precision { bits, pi: ball_sine::pi(ball_sine::pi_bits(bits)), ln_2: OnceLock::new() }
    }

    pub(super) fn pi_bits(&self) -> u32 {
        ball_sine::pi_bits(self.bits)
    }

    /// π to `bits` bits, at most 190 more than this precision's.
    pub(super) fn pi_at(&self, bits: u32) -> Ball {
        self.constant(self.pi.clone(), bits)
    }

    /// ln 2, likewise.
    pub(super) fn ln_2_at(&self, bits: u32) -> Ball {
        self.constant(self.ln_2.get_or_init(|| ball_sine::ln_2(self.pi_bits())).clone(), bits)
    }

    fn constant(&self, value: BigInt, bits: u32) -> Ball {
        let w = i128::from(self.pi_bits());
        Ball::new(value, -w, Radius::new(2, -w), bits)
    }

    /// The number of bits of a midpoint; an example is at [`new`](Precision::new).
    pub fn bits(&self) -> u32 {
        self.bits
    }
}

/// The reals within a radius of a midpoint of at most `bits` bits.
///
/// Invariant: `mid` has at most `bits` bits; the radius is infinite if nothing is known.
///
/// ```
/// use grazing_number::{Ball, Elementary, Precision, Real, Sign, ball_digits, parse_rational};
/// let bits = Precision::new(128);
/// let x = Ball::ratio(&parse_rational("1/3")?, &bits);
/// let square = x.exp(&bits) * &x.exp(&bits);
/// assert!((square - &(x.clone() + &x).exp(&bits)).sign().is_none(), "equal, which no ball can tell");
/// assert_eq!(ball_digits(&Ball::pi(&bits), 30).unwrap(), "3.14159265358979323846264338328");
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Ball {
    mid: BigInt,
    exp: Exponent,
    radius: Radius,
    bits: u32,
}

impl Ball {
    /// m·2^e ± `radius`, the midpoint cut to `bits` bits.
    pub(super) fn new(mut mid: BigInt, mut exp: i128, mut radius: Radius, bits: u32) -> Ball {
        let excess = mid.bits() as i128 - i128::from(bits);
        if excess > 0 {
            let exact = mid.trailing_zeros().is_none_or(|zeros| i128::from(zeros) >= excess);
            mid >>= excess;
            exp += excess;
            if !exact {
                radius = radius + Radius::new(1, exp);
            }
            // Rounding −2^b + ε down can reach −2^b, which has a bit more; it is a power of two.
            if mid.bits() > u64::from(bits) {
                mid >>= 1;
                exp += 1;
            }
        }
        if mid.is_zero() {
            return Ball { mid, exp: Exponent::ZERO, radius, bits };
        }
        match Exponent::fit(exp) {
            Ok(exp) => Ball { mid, exp, radius, bits },
            Err(Misfit::Above) => Ball::whole(bits),
            Err(Misfit::Below) => Ball { radius: radius + Radius::of(&mid, exp), ..Ball::zero(bits) },
        }
    }

    /// The whole real line: nothing is known.
    pub(super) fn whole(bits: u32) -> Ball {
        Ball { radius: Radius::INFINITE, ..Ball::zero(bits) }
    }

    /// Bounds of the enclosed numbers as exact fractions, `None` if nothing is known.
    ///
    /// They are the ball's own unless these would take more than 2¹⁷ bits beyond its precision: below 2^−2¹⁷
    /// they are ±2^−2¹⁷ and 0, and for numbers above 2^2¹⁷ there are none. So this is safe for any ball.
    /// Cost: linear in the bits of midpoint and exponent.
    ///
    /// ```
    /// use grazing_number::{Ball, Precision, Real, parse_rational};
    /// let third = parse_rational("1/3")?;
    /// let x = Ball::ratio(&third, &Precision::new(64));
    /// let (low, high) = x.exact_bounds().unwrap();
    /// assert!(low < third && third < high && x.contains(&third) && x.contains(&low));
    /// assert_eq!((x.exponent(), x.least_exponent(), x.certain_bits()), (Some(-1), Some(-1), Some(62)));
    /// assert_eq!(x.centre().certain_bits(), None, "a point is exact");
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn exact_bounds(&self) -> Option<(BigRational, BigRational)> {
        if !self.radius.is_within(WRITTEN) || self.top().is_some_and(|top| top > WRITTEN) {
            return None;
        }
        let (m, e) = self.radius.parts();
        let (low, high, unit) = match self.top() {
            Some(top) if top < -WRITTEN => match self.sign() {
                Some(Sign::Positive) => return Some((BigRational::zero(), dyadic(BigInt::one(), -WRITTEN))),
                Some(Sign::Negative) => return Some((dyadic(-BigInt::one(), -WRITTEN), BigRational::zero())),
                _ => (-BigInt::one(), BigInt::one(), -WRITTEN),
            },
            _ => (self.mid.clone(), self.mid.clone(), self.exp.wide()),
        };
        // A radius of 2⁻¹⁰⁰⁰⁰⁰⁰⁰ would be written out: one far below the last place is rounded up.
        let least = unit.min(0) - WRITTEN;
        let (m, e) = if m > 0 && e < least - 32 { (1, least) } else { (m, e) };
        let common = if m > 0 { unit.min(e) } else { unit };
        let reach = if m > 0 { BigInt::from(m) << (e - common) } else { BigInt::zero() };
        let [low, high] = [low, high].map(|end| end << (unit - common));
        Some((dyadic(low - &reach, common), dyadic(high + reach, common)))
    }

    /// An e with |midpoint| < 2^e, at most twice the midpoint; `None` for the midpoint 0, which has none. An
    /// example of this and what follows is at [`exact_bounds`](Ball::exact_bounds).
    pub fn exponent(&self) -> Option<i64> {
        // A stored exponent and a length in bits are far below 2⁶³ together.
        self.top().map(|top| top as i64)
    }

    fn top(&self) -> Option<i128> {
        (!self.mid.is_zero()).then(|| self.exp.wide() + self.mid.bits() as i128)
    }

    /// Whether the exact number lies between the [`exact_bounds`](Ball::exact_bounds); true if there are
    /// none.
    pub fn contains(&self, value: &BigRational) -> bool {
        self.exact_bounds().is_none_or(|(lo, hi)| !(value - lo).is_negative() && !(hi - value).is_negative())
    }

    /// How many leading bits are certain: log₂ |midpoint| / radius rounded down, at least 0; `None` if exact.
    pub fn certain_bits(&self) -> Option<u64> {
        if self.radius.is_zero() {
            return None;
        }
        let top = self.top().filter(|_| !self.radius.is_infinite());
        let bits = top.map_or(0, |top| top - self.radius.parts().1 - 32 - 1);
        Some(u64::try_from(bits).unwrap_or(0))
    }

    fn common_bits(&self, other: &Ball) -> u32 {
        self.bits.max(other.bits)
    }

    pub(super) fn is_narrower_than(&self, other: &Ball) -> bool {
        self.radius.is_below(other.radius)
    }
}

/// m·2^e. The common factors of numerator and denominator are powers of two: no gcd.
fn dyadic(m: BigInt, e: i128) -> BigRational {
    if e >= 0 {
        return BigRational::from_integer(m << e);
    }
    let Some(zeros) = m.trailing_zeros() else { return BigRational::zero() };
    let common = e.unsigned_abs().min(zeros.into());
    BigRational::new_raw(m >> common, BigInt::one() << (e.unsigned_abs() - common))
}

impl Neg for Ball {
    type Output = Ball;

    fn neg(self) -> Ball {
        Ball { mid: -self.mid, ..self }
    }
}

impl Add<&Ball> for Ball {
    type Output = Ball;

    fn add(self, other: &Ball) -> Ball {
        let bits = self.common_bits(other);
        let radius = self.radius + other.radius;
        if other.mid.is_zero() {
            return Ball { radius, bits, ..self };
        }
        if self.mid.is_zero() {
            return Ball { radius, bits, ..other.clone() };
        }
        let (high, low) = if self.exp >= other.exp { (&self, other) } else { (other, &self) };
        // A term far below the other's last bit counts as an error only, or 2⁻¹⁰⁰⁰⁰⁰⁰⁰ would be written out.
        let reach = i128::from(bits) + 64;
        let (big, small) = if self.top() >= other.top() { (&self, other) } else { (other, &self) };
        if let (Some(above), Some(below)) = (big.top(), small.top())
            && above - below > reach
        {
            // The lowest bit of `big` is at most `bits` below its top.
            let radius = radius + Radius::of(&small.mid, small.exp.wide());
            return Ball::new(big.mid.clone(), big.exp.wide(), radius, bits);
        }
        // At most reach + bits.
        let distance = high.exp.wide() - low.exp.wide();
        let mid = (&high.mid << distance) + &low.mid;
        Ball::new(mid, low.exp.wide(), radius, bits)
    }
}

impl Sub<&Ball> for Ball {
    type Output = Ball;

    fn sub(self, other: &Ball) -> Ball {
        -(-self + other)
    }
}

impl Mul<&Ball> for Ball {
    type Output = Ball;

    fn mul(self, other: &Ball) -> Ball {
        let bits = self.common_bits(other);
        if self.radius.is_infinite() || other.radius.is_infinite() {
            return Ball::whole(bits);
        }
        let mut radius = Radius::ZERO;
        if !self.radius.is_zero() {
            radius = self.radius * (Radius::of(&other.mid, other.exp.wide()) + other.radius);
        }
        if !other.radius.is_zero() {
            radius = radius + Radius::of(&self.mid, self.exp.wide()) * other.radius;
        }
        Ball::new(&self.mid * &other.mid, self.exp.wide() + other.exp.wide(), radius, bits)
    }
}

impl Div<&Ball> for Ball {
    type Output = Ball;

    /// The quotients; the whole line if the divisor contains zero.
    fn div(self, other: &Ball) -> Ball {
        let bits = self.common_bits(other);
        let Some((m, e)) = other.least_magnitude() else { return Ball::whole(bits) };
        if self.radius.is_infinite() {
            return self;
        }
        let length = |x: &BigInt| x.bits() as i128;
        let shift = (i128::from(bits) + 1 + length(&other.mid) - length(&self.mid)).max(0);
        let numerator = &self.mid << shift;
        let (quotient, rest) = numerator.div_rem(&other.mid);
        let exp = self.exp.wide() - other.exp.wide() - shift;
        // |x/y − x₀/y₀| ≤ (rx + |x₀/y₀| ry) / |y|, and the integer quotient is cut by less than 1.
        let mut radius = Radius::ZERO;
        if !self.radius.is_zero() || !other.radius.is_zero() {
            let cut = if rest.is_zero() { Radius::ZERO } else { Radius::new(1, exp) };
            let cut = Radius::of(&quotient, exp) + cut;
            radius = (self.radius + cut * other.radius).over(m, e);
        }
        if !rest.is_zero() {
            radius = radius + Radius::new(1, exp);
        }
        Ball::new(quotient, exp, radius, bits)
    }
}

impl Ball {
    /// A lower bound m·2^e of every enclosed magnitude, m ≥ 2³¹; `None` if zero is enclosed.
    pub(super) fn least_magnitude(&self) -> Option<(u64, i128)> {
        if self.mid.is_zero() || self.radius.is_infinite() {
            return None;
        }
        // |mid| to 62 bits, down; the radius on the same scale, up.
        let cut = self.mid.bits() as i128 - 62;
        let mid = if cut >= 0 { self.mid.magnitude() >> cut } else { self.mid.magnitude() << -cut };
        let mid = mid.iter_u64_digits().next().unwrap_or(0);
        let exp = self.exp.wide() + cut;
        let (m, e) = self.radius.parts();
        let distance = e - exp;
        let radius = match distance {
            _ if m == 0 => 0,
            31.. => return None,
            0.. => m << distance,
            -63..0 => (m >> -distance) + 1,
            _ => 1,
        };
        let least = mid.checked_sub(radius).filter(|&least| least > 0)?;
        let zeros = i128::from(least.leading_zeros());
        Some((least << zeros >> 32, exp - zeros + 32))
    }
}

impl Real for Ball {
    type Context = Precision;

    fn ratio(value: &BigRational, context: &Precision) -> Ball {
        let (numerator, denominator) = (value.numer(), value.denom());
        if denominator.is_one() {
            return Ball::new(numerator.clone(), 0, Radius::ZERO, context.bits);
        }
        let shift =
            (i128::from(context.bits) + 1 + denominator.bits() as i128 - numerator.bits() as i128).max(0);
        let (quotient, rest) = (numerator << shift).div_rem(denominator);
        let radius = if rest.is_zero() { Radius::ZERO } else { Radius::new(1, -shift) };
        Ball::new(quotient, -shift, radius, context.bits)
    }

    fn integer(value: i32, context: &Precision) -> Ball {
        Ball::new(value.into(), 0, Radius::ZERO, context.bits)
    }

    fn plane_quotient(parts: [&BigRational; 3], at: [u64; 2], context: &Precision) -> Option<Ball> {
        let [numerator, denominator] = ball_forms::plane_parts(parts, at, context)?;
        Some((numerator / &denominator).cut(context.bits))
    }

    fn plane_sign(parts: [&BigRational; 3], at: [u64; 2], context: &Precision) -> Option<Option<Sign>> {
        ball_forms::plane_sign(parts, at, context)
    }

    fn sign(&self) -> Option<Sign> {
        if self.radius.is_zero() || self.least_magnitude().is_some() {
            Some((&self.mid).into())
        } else {
            None
        }
    }
}

impl Ball {
    /// A ball that contains the reals between `lo` and `hi`, in either order. Without numbers below 0 if both
    /// are at least 0, and without numbers above it if both are at most 0.
    ///
    /// ```
    /// use grazing_number::{Ball, Elementary, Precision, parse_rational};
    /// let (zero, one, bits) = (parse_rational("0")?, parse_rational("1")?, Precision::new(64));
    /// let root = Ball::between(&zero, &one, &bits).sqrt();
    /// assert_eq!(root.exact_bounds(), Some((zero, one)));
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn between(lo: &BigRational, hi: &BigRational, context: &Precision) -> Ball {
        let two = BigInt::from(2);
        let centre = Ball::ratio(&((lo + hi) / &two), context);
        let reach = Ball::ratio(&((hi - lo) / two), context);
        let radius = centre.radius + Radius::of(&reach.mid, reach.exp.wide()) + reach.radius;
        let ball = Ball { radius, ..centre };
        match (lo.is_negative() || hi.is_negative(), lo.is_positive() || hi.is_positive()) {
            (false, _) => ball.without_negatives(),
            (true, false) => -(-ball).without_negatives(),
            _ => ball,
        }
    }

    /// An e with 2^(e−1) ≤ |x| for every enclosed x, the greatest that the bounds show; `None` if zero is
    /// enclosed.
    pub fn least_exponent(&self) -> Option<i64> {
        self.least_magnitude().map(|(m, e)| (e + 64 - i128::from(m.leading_zeros())) as i64)
    }
}

/// What the elementary functions take apart and put together.
impl Ball {
    /// The midpoint alone, exactly.
    #[must_use]
    pub fn centre(&self) -> Ball {
        Ball { radius: Radius::ZERO, ..self.clone() }
    }

    pub(super) fn zero(bits: u32) -> Ball {
        Ball { mid: BigInt::zero(), exp: Exponent::ZERO, radius: Radius::ZERO, bits }
    }

    pub(super) fn integer_at(value: i32, bits: u32) -> Ball {
        Ball::new(value.into(), 0, Radius::ZERO, bits)
    }

    /// 10^e to `more` bits than this ball has, less one for every squaring.
    pub(super) fn ten_to(&self, e: u64, more: u32) -> Ball {
        let ten = Ball::integer_at(10, self.bits.saturating_add(more));
        let mut power = Ball::integer_at(1, ten.bits);
        for bit in (0..64 - e.leading_zeros()).rev() {
            power = power.clone() * &power;
            if e >> bit & 1 == 1 {
                power = power * &ten;
            }
        }
        power
    }

    /// The midpoint's mantissa, in units of 2^[`unit_exponent`](Ball::unit_exponent).
    pub(super) fn mid(&self) -> &BigInt {
        &self.mid
    }

    pub(super) fn unit_exponent(&self) -> i128 {
        self.exp.wide()
    }

    pub(super) fn radius(&self) -> Radius {
        self.radius
    }

    pub(super) fn bits(&self) -> u32 {
        self.bits
    }

    /// At least |x| for every enclosed x.
    pub(super) fn greatest_magnitude(&self) -> Radius {
        Radius::of(&self.mid, self.exp.wide()) + self.radius
    }

    /// 2^k times the ball.
    pub(super) fn scaled(&self, k: i128) -> Ball {
        let (m, e) = self.radius.parts();
        let radius = if self.radius.is_infinite() { self.radius } else { Radius::new(m, e + k) };
        Ball::new(self.mid.clone(), self.exp.wide() + k, radius, self.bits)
    }

    /// The same ball with its radius enlarged.
    pub(super) fn widened(self, by: Radius) -> Ball {
        Ball { radius: self.radius + by, ..self }
    }

    /// The same ball with at most `bits` bits in its midpoint.
    pub(super) fn cut(self, bits: u32) -> Ball {
        Ball::new(self.mid, self.exp.wide(), self.radius, bits)
    }
}
