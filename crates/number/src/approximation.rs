//! Floating-point numbers on limbs with a bound of their error: what a single b_{n,k} spends its time in.
//!
//! A ball rounds to its bits after every operation, in integers of any length. Here numbers have a fixed
//! length of L limbs, up to nine of them on the stack, and some bits more than the ball that is wanted in the
//! end. The error is a whole number of units in the last place. Not here: the formulas (`ball_forms`).

use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::ball::Ball;
use super::radius::Radius;
use super::{Sign, fixed};

/// L ≥ 3 limbs, least significant first.
pub(super) trait Limbs: Clone {
    /// 0, of `length` limbs, which an array's own are.
    fn zero(length: usize) -> Self;

    /// The limbs.
    fn limbs(&self) -> &[u64];

    /// The limbs, to be changed.
    fn limbs_mut(&mut self) -> &mut [u64];

    /// As [`fixed::product`]: off by less than 3, downwards.
    fn product(&self, other: &Self) -> Self;
}

impl Limbs for Vec<u64> {
    fn zero(length: usize) -> Self {
        vec![0; length]
    }

    fn limbs(&self) -> &[u64] {
        self
    }

    fn limbs_mut(&mut self) -> &mut [u64] {
        self
    }

    fn product(&self, other: &Self) -> Self {
        fixed::product(self, other)
    }
}

/// Stands for a number within `error`·2^(exp − 64L) of ± limbs·2^(exp − 64L).
///
/// The highest bit is set, unless the number is 0 or the error has [`SHIFTED_ERROR`] bits or more.
#[derive(Clone)]
pub(super) struct Approximation<S> {
    negative: bool,
    limbs: S,
    exp: i64,
    error: u64,
}

/// The error of a number of which nothing is known.
const UNKNOWN: u64 = u64::MAX;

/// The largest error that is counted.
const MOST_ERROR: u64 = 1 << 60;

/// Bits of the largest error to which a shift may bring one. Beyond it zeros above are left standing, so that
/// an error that has grown for good does not outgrow what is counted. They double with every square: after
/// many in a row, nothing is left of a number, however many limbs it has.
const SHIFTED_ERROR: u32 = 24;

/// The largest exponent, up or down: sums of a few of them fit.
const MOST_EXPONENT: i64 = 1 << 58;

impl<S: Limbs> Approximation<S> {
    /// 1, exactly.
    pub fn one(length: usize) -> Self {
        let mut limbs = S::zero(length);
        limbs.limbs_mut()[length - 1] = 1 << 63;
        Approximation { negative: false, limbs, exp: 1, error: 0 }
    }

    /// 0, exactly.
    pub fn nothing(length: usize) -> Self {
        Approximation { negative: false, limbs: S::zero(length), exp: 0, error: 0 }
    }

    /// A fraction, cut to `length` limbs. Cost: a division of `length` limbs, and at most that of reading its
    /// parts' first 64(`length` + 1) bits.
    pub fn ratio(value: &BigRational, length: usize) -> Self {
        if value.is_zero() {
            return Self::nothing(length);
        }
        let w = 64 * length as u64;
        // Either part cut to w + 64 bits: the quotient changes by less than 2^(−w−62) of itself.
        let cut = |x: &BigInt| {
            let excess = x.bits().saturating_sub(w + 64);
            (if excess > 0 { x.magnitude() >> excess } else { x.magnitude().clone() }, excess)
        };
        let ((p, up), (q, down)) = (cut(value.numer()), cut(value.denom()));
        let shift = (w + 1 + q.bits()).saturating_sub(p.bits());
        // At least w + 1 bits, off by less than 1 + 2^−61 of its own last place or, if that is longer, of the
        // one that is kept.
        let quotient = (p << shift) / q;
        let exp = up as i128 - down as i128 - i128::from(shift);
        Self::of(value.is_negative(), &quotient, exp, 2, length)
    }

    /// ± m·2^exp, known to within less than `error` units of the last of the first 64·`length` bits of m.
    fn of(negative: bool, m: &BigUint, exp: i128, error: u64, length: usize) -> Self {
        let w = 64 * length as i128;
        let bits = m.bits() as i128;
        let digits =
            if bits > w { fixed::limbs(&(m >> (bits - w)), length) } else { fixed::limbs(m, length) };
        let mut limbs = S::zero(length);
        limbs.limbs_mut().copy_from_slice(&digits);
        let exp = exp + if bits > w { bits } else { w };
        if bits == 0 && error == 0 {
            return Self::nothing(length);
        }
        // Whatever is cut counts less than 1.
        let error = error + u64::from(bits > w);
        match i64::try_from(exp) {
            Ok(exp) => Approximation { negative, limbs, exp, error }.normal(),
            Err(_) => Approximation { negative, limbs, exp: 0, error: UNKNOWN },
        }
    }

    /// ± m·2^exp ± `radius`.
    pub fn enclosed(m: &BigInt, exp: i128, radius: Radius, length: usize) -> Self {
        if radius.is_infinite() {
            return Approximation { error: UNKNOWN, ..Self::one(length) };
        }
        // The last place of the first w bits of m, or that of m with zeros below.
        let place = exp + (m.bits() as i128 - 64 * length as i128).max(0);
        let (units, e) = radius.parts();
        let error = match e - place {
            _ if units == 0 => 0,
            28.. => return Approximation { error: UNKNOWN, ..Self::one(length) },
            above @ 0.. => units << above,
            below @ -40..0 => (units >> -below) + 1,
            _ => 1,
        };
        Self::of(m.is_negative(), m.magnitude(), exp, error, length)
    }

    /// ± a fraction on limbs, within `error` of its last place.
    pub fn fraction(negative: bool, limbs: S, error: u64) -> Self {
        Approximation { negative, limbs, exp: 0, error }.normal()
    }

    /// Whether it is 0, exactly.
    fn is_nothing(&self) -> bool {
        self.error == 0 && self.length() == 0
    }

    /// Bits of the limbs as an integer.
    #[inline(always)]
    fn length(&self) -> u64 {
        let limbs = self.limbs.limbs();
        match limbs.iter().rposition(|&limb| limb != 0) {
            Some(top) => 64 * (top as u64 + 1) - u64::from(limbs[top].leading_zeros()),
            None => 0,
        }
    }

    /// Shifted up as far as the zeros above and the size of an error allow.
    #[inline(always)]
    fn normal(mut self) -> Self {
        let limbs = self.limbs.limbs_mut();
        let last = limbs.len() - 1;
        let mut zeros = limbs[last].leading_zeros();
        if self.error > 0 {
            zeros = zeros.min(SHIFTED_ERROR.saturating_sub(64 - self.error.leading_zeros()));
        } else if zeros == 64
            && let Some(top) = limbs.iter().rposition(|&limb| limb != 0)
        {
            let whole = last - top;
            limbs.copy_within(..=top, whole);
            limbs[..whole].fill(0);
            self.exp -= 64 * whole as i64;
            zeros = limbs[last].leading_zeros();
        }
        if 0 < zeros && zeros < 64 {
            for i in (1..=last).rev() {
                limbs[i] = limbs[i] << zeros | limbs[i - 1] >> (64 - zeros);
            }
            limbs[0] <<= zeros;
            self.exp -= i64::from(zeros);
            self.error <<= zeros;
        }
        if self.exp.unsigned_abs() > MOST_EXPONENT.unsigned_abs() {
            (self.exp, self.error) = (0, UNKNOWN);
        }
        self
    }

    /// At least the limbs as a fraction, in units of 2^−32; at most 2³².
    #[inline(always)]
    fn top(&self) -> u128 {
        let limbs = self.limbs.limbs();
        u128::from(limbs[limbs.len() - 1] >> 32) + 1
    }

    /// The product. With x, y < 1 the limbs as fractions and e, f ≤ 2⁶⁰ the errors, these change it by at
    /// most ey + fx + ef·2^(−64L), of which the last is below 1; a sum rounded down loses 1, the product 3.
    #[inline]
    pub fn times(&self, other: &Self) -> Self {
        if self.is_nothing() || other.is_nothing() {
            return Self::nothing(self.limbs.limbs().len());
        }
        let (e, f) = (self.error, other.error);
        let error = if e.max(f) > MOST_ERROR {
            UNKNOWN
        } else {
            ((u128::from(e) * other.top() + u128::from(f) * self.top()) >> 32) as u64 + 5
        };
        let limbs = self.limbs.product(&other.limbs);
        let negative = self.negative != other.negative;
        Approximation { negative, limbs, exp: self.exp + other.exp, error }.normal()
    }

    /// Twice the number.
    pub fn doubled(mut self) -> Self {
        self.exp += 1;
        self
    }

    /// Half the number.
    pub fn halved(mut self) -> Self {
        self.exp -= 1;
        self
    }

    /// With its sign changed.
    pub fn negated(mut self) -> Self {
        self.negative = !self.negative;
        self
    }

    /// The sum. What is shifted out of the smaller number counts less than 1, and so does what is cut from
    /// its error, and the last bit of a sum that carries.
    #[inline]
    pub fn plus(&self, other: &Self) -> Self {
        if self.is_nothing() || other.is_nothing() {
            return if self.is_nothing() { other } else { self }.clone();
        }
        let (high, low) = if self.exp >= other.exp { (self, other) } else { (other, self) };
        if high.error.max(low.error) > MOST_ERROR {
            return Approximation { error: UNKNOWN, ..high.clone() };
        }
        let gap = (high.exp - low.exp).unsigned_abs();
        let mut small = low.limbs.clone();
        shift_down(small.limbs_mut(), gap);
        let passed = if gap == 0 { low.error } else { (low.error >> gap.min(63)) + 2 };
        let mut error = high.error + passed;
        let mut large = high.limbs.clone();
        let (mut exp, mut negative) = (high.exp, high.negative);
        if high.negative == low.negative {
            let mut carry = false;
            for (limb, &x) in large.limbs_mut().iter_mut().zip(small.limbs()) {
                let (sum, first) = limb.overflowing_add(x);
                let (sum, second) = sum.overflowing_add(carry.into());
                (*limb, carry) = (sum, first || second);
            }
            if carry {
                let limbs = large.limbs_mut();
                shift_down(limbs, 1);
                limbs[limbs.len() - 1] |= 1 << 63;
                exp += 1;
                error = (error >> 1) + 2;
            }
        } else {
            if large.limbs().iter().rev().lt(small.limbs().iter().rev()) {
                std::mem::swap(&mut large, &mut small);
                negative = !negative;
            }
            let mut borrow = false;
            for (limb, &x) in large.limbs_mut().iter_mut().zip(small.limbs()) {
                let (rest, first) = limb.overflowing_sub(x);
                let (rest, second) = rest.overflowing_sub(borrow.into());
                (*limb, borrow) = (rest, first || second);
            }
        }
        Approximation { negative, limbs: large, exp, error }.normal()
    }

    /// The difference.
    #[inline]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.clone().negated())
    }

    /// The j-th power, j ≥ 1. Cost: at most 2 log₂ j products.
    pub fn power(&self, j: u64) -> Self {
        let mut power = self.clone();
        for bit in (0..63 - j.leading_zeros()).rev() {
            power = power.times(&power);
            if j >> bit & 1 == 1 {
                power = power.times(self);
            }
        }
        power
    }

    /// The sign, if certain.
    pub fn sign(&self) -> Option<Sign> {
        if self.is_nothing() {
            return Some(Sign::Zero);
        }
        let (first, rest) = self.limbs.limbs().split_first()?;
        let outweighs = *first > self.error || rest.iter().any(|&limb| limb != 0);
        (outweighs && self.error <= MOST_ERROR).then_some(Sign::Positive.negated_if(self.negative))
    }

    /// How many leading bits the error leaves alone; 0 for the number 0.
    pub fn certain_bits(&self) -> u64 {
        if self.error > MOST_ERROR {
            return 0;
        }
        self.length().saturating_sub(u64::from(64 - self.error.leading_zeros()))
    }

    /// As a ball of `bits` bits.
    pub fn ball(&self, bits: u32) -> Ball {
        if self.error > MOST_ERROR {
            return Ball::whole(bits);
        }
        let limbs = self.limbs.limbs();
        let m = BigInt::from_biguint(
            if self.negative { num_bigint::Sign::Minus } else { num_bigint::Sign::Plus },
            fixed::integer(limbs),
        );
        let exp = i128::from(self.exp) - 64 * limbs.len() as i128;
        Ball::new(m, exp, Radius::new(self.error, exp), bits)
    }
}

/// ⌊limbs / 2^by⌋.
#[inline(always)]
fn shift_down(limbs: &mut [u64], by: u64) {
    let length = limbs.len();
    let (whole, bits) = ((by / 64).min(length as u64) as usize, by % 64);
    if whole > 0 {
        limbs.copy_within(whole.., 0);
        limbs[length - whole..].fill(0);
    }
    if bits > 0 {
        for i in 0..length - 1 {
            limbs[i] = limbs[i] >> bits | limbs[i + 1] << (64 - bits);
        }
        limbs[length - 1] >>= bits;
    }
}

#[cfg(test)]
mod tests {
    use num_traits::One;

    use super::*;
    use crate::random::Random;

    fn dyadic(m: BigInt, e: i64) -> BigRational {
        let power = BigInt::one() << e.unsigned_abs();
        if e < 0 { BigRational::new(m, power) } else { BigRational::from_integer(m * power) }
    }

    /// Whether the number that is stood for is known by its error; all are, where none is counted.
    fn holds<S: Limbs>(x: &Approximation<S>, value: &BigRational) -> bool {
        if x.error > MOST_ERROR {
            return true;
        }
        let limbs = x.limbs.limbs();
        let unit = x.exp - 64 * limbs.len() as i64;
        let m = BigInt::from(fixed::integer(limbs));
        let mid = dyadic(if x.negative { -m } else { m }, unit);
        (value - mid).abs() <= dyadic(x.error.into(), unit)
    }

    /// Fractions at both ends of the range that is written out, short ones, long ones, 0, and neighbours.
    fn fraction(random: &mut Random) -> BigRational {
        let mut word = || BigInt::from(random.next() >> (random.next() % 60));
        let (p, q) = (word(), word() + 1u32);
        let long = word() << 700;
        let value = match word().bits() % 7 {
            0 => BigRational::zero(),
            1 => BigRational::new(p + &long, long + q),
            2 => dyadic(p, -900),
            3 => dyadic(p, 900),
            4 => BigRational::one() + dyadic(p, -400),
            5 => BigRational::from_integer(p),
            _ => BigRational::new(p, q),
        };
        if random.coin() { -value } else { value }
    }

    /// Chains of sums and products against exact fractions, with every cancellation on the way.
    fn chains<S: Limbs>(length: usize) {
        let mut random = Random(length as u64);
        let (mut certain, mut cancelled) = (0, 0);
        for _ in 0..100 {
            let mut exact = fraction(&mut random);
            let mut x = Approximation::<S>::ratio(&exact, length);
            for _ in 0..6 {
                assert!(holds(&x, &exact), "{exact}");
                let other = match random.next() % 5 {
                    0 => exact.clone(),
                    1 => -exact.clone(),
                    2 => -&exact + dyadic(1.into(), -300),
                    _ => fraction(&mut random),
                };
                let mut y = Approximation::<S>::ratio(&other, length);
                let mut other = other;
                if random.coin() {
                    // At the edge of what is known.
                    let (m, units) = (BigInt::from(random.next()) << 40, 1 + random.below(1 << 20));
                    let e = random.below(80) as i64 - 120;
                    y = Approximation::enclosed(&m, e.into(), Radius::new(units, e.into()), length);
                    other = dyadic(if random.coin() { m + units } else { m - units }, e);
                }
                (x, exact) = match random.next() % 3 {
                    0 => (x.times(&y), exact * other),
                    1 => (x.plus(&y), exact + other),
                    _ => (x.minus(&y), exact - other),
                };
                assert!(x.sign().is_none_or(|sign| sign == Sign::of(&exact)), "{exact}");
                let short = x.certain_bits() + 40 < 64 * length as u64;
                certain += usize::from(!short);
                cancelled += usize::from(short);
                let ball = x.ball(90);
                assert!(ball.contains(&exact), "{exact}");
            }
        }
        // Errors are small unless something cancels or was not known, and then they are seen.
        assert!(certain > 40 && cancelled > 20, "{certain} {cancelled}");
    }

    #[test]
    fn every_operation_holds_its_result() {
        chains::<[u64; 3]>(3);
        chains::<[u64; 5]>(5);
        chains::<[u64; 9]>(9);
        chains::<Vec<u64>>(3);
        chains::<Vec<u64>>(12);
    }

    /// Powers too large or too small to be counted are unknown, not wrong; so is what follows from them.
    #[test]
    fn ends_of_the_range_are_unknown() {
        let three = Approximation::<[u64; 3]>::ratio(&BigRational::from_integer(3.into()), 3);
        let power = three.power(1 << 40);
        assert!(power.certain_bits() > 64 && power.sign() == Some(Sign::Positive));
        let third = Approximation::<[u64; 3]>::ratio(&BigRational::new(1.into(), 3.into()), 3);
        for beyond in [three.power(1 << 62), third.power(u64::MAX)] {
            assert!(beyond.sign().is_none() && beyond.certain_bits() == 0);
            let after = beyond.plus(&three).times(&third).doubled();
            assert!(after.sign().is_none() && after.minus(&after).sign().is_none());
            assert!(after.ball(128).exact_bounds().is_none());
        }
        let nothing = Approximation::<[u64; 3]>::nothing(3);
        assert_eq!(nothing.times(&three).plus(&nothing).sign(), Some(Sign::Zero));
        assert_eq!(nothing.power(u64::MAX).sign(), Some(Sign::Zero));
        // A remainder that is nothing but error has no sign.
        assert_eq!(third.minus(&third).sign(), None);
        let error = third.minus(&third).power(1 << 63);
        assert_eq!(error.sign(), None);
    }
}
