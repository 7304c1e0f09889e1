//! The numbers of a sweep: `f64`, and pairs of them for what `f64` leaves open.
//!
//! A pair (h, l) stands for h + l with h = fl(h + l), so |l| ≤ u|h|, u = 2⁻⁵³. Sums and products of floats
//! are split into their rounded value and its error without error (Knuth; Dekker and Veltkamp: no fused
//! operation; nothing overflows here, and what underflows is too small to count). What a sweep needs of its
//! numbers is, with U = 2⁻¹⁰⁰ for pairs and 2⁻⁵³ for floats:
//!
//! - a sum is off by at most U(|x| + |y|). The pair: with s + e = h₁ + h₂ and t + f = l₁ + l₂, c = fl(e + t),
//!   v + w = s + c, d = fl(f + w), where |e|, |t| ≤ 1.1u(|x| + |y|) and |f| ≤ 1.1u|t|, |w| ≤ 1.1u(|x| + |y|),
//!   the two roundings are off by at most u(2.2 + 1.2)u(|x| + |y|) in all, below 4u²(|x| + |y|).
//! - a product is off by at most U|xy|. The pair: p + e = h₁h₂; h₁l₂ + l₁h₂ is rounded three times, by at
//!   most 4.1u²|xy|; l₁l₂ ≤ 1.1u²|xy| is left out; adding e rounds by at most 3.4u²|xy|: below 9u²|xy|.
//! - a quotient is off by at most U|x/y|. The pair: q = fl(h₁/h₂) is within 3.1u|x/y|; x − qy as a pair is
//!   off by at most 9u²|x| + 4u²·2.1|x| < 18u²|x|, and divided by h₂ once more, off by 4u of the 3.2u|x| that
//!   it is: below 18u² + 13u² + u² of |x/y|.
//!
//! All are below 2⁻¹⁰¹ = 32u² relatively.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::ToPrimitive;

use crate::number::{Angle, Ball, Circular, FloatInterval, Precision};

/// A number of a sweep: what is promised of its operations is at the head of this file.
pub(crate) trait Rounded:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// U.
    const UNIT: f64;
    /// Below this, products could underflow.
    const SMALLEST: f64;

    /// A float, exactly.
    fn of(x: f64) -> Self;

    /// Its absolute value.
    fn abs(self) -> Self;

    /// cos πx and sin πx for a dyadic angle πx, each within 2U of the true value.
    fn cosine_sine(angle: &Angle) -> (Self, Self);

    /// The larger one.
    fn larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// The smaller one.
    fn smaller(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

/// 2^exponent, for exponents of normal floats.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

impl Rounded for f64 {
    const UNIT: f64 = power_of_two(-53);
    const SMALLEST: f64 = power_of_two(-900);

    fn of(x: f64) -> Self {
        x
    }

    fn abs(self) -> Self {
        f64::abs(self)
    }

    fn cosine_sine(angle: &Angle) -> (Self, Self) {
        let float = |x: FloatInterval| {
            // Neighbouring or equal floats of size ≤ 1, else the bound on the powers fails.
            assert!(x.hi() - x.lo() <= 2.0 * Self::UNIT, "the sine of a dyadic angle is enclosed within 2u");
            x.lo()
        };
        (float(FloatInterval::cos(angle, &())), float(FloatInterval::sin(angle, &())))
    }
}

/// h + l.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Twofold(f64, f64);

/// x + y and its error.
fn sum(x: f64, y: f64) -> Twofold {
    let s = x + y;
    let part = s - x;
    Twofold(s, (x - (s - part)) + (y - part))
}

/// Two halves of at most 26 bits each.
fn split(x: f64) -> (f64, f64) {
    let c = 134_217_729.0 * x;
    let high = c - (c - x);
    (high, x - high)
}

/// xy and its error.
fn product(x: f64, y: f64) -> Twofold {
    let p = x * y;
    let ((a, b), (c, d)) = (split(x), split(y));
    Twofold(p, b * d - (((p - a * c) - b * c) - a * d))
}

impl Rounded for Twofold {
    const UNIT: f64 = power_of_two(-100);
    /// Above it what an underflow loses, less than 2⁻¹⁰⁷⁰, is less than 2⁻²⁷⁰ relatively.
    const SMALLEST: f64 = power_of_two(-800);

    fn of(x: f64) -> Self {
        Twofold(x, 0.0)
    }

    fn abs(self) -> Self {
        if self.0 < 0.0 { -self } else { self }
    }

    fn cosine_sine(angle: &Angle) -> (Self, Self) {
        let pair = |x: Ball| {
            let (low, high) = x.exact_bounds().expect("a sine is bounded");
            let head = low.to_f64().expect("a sine is a float, rounded");
            let exact = num_rational::BigRational::from_float(head).expect("it is finite");
            let tail = (&low - exact).to_f64().expect("the rest is one, too");
            assert!(
                (&high - &low).to_f64().is_some_and(|width| width < power_of_two(-140)),
                "160 bits enclose a sine within 2^-140"
            );
            sum(head, tail)
        };
        let precision = Precision::new(160);
        (pair(Ball::cos(angle, &precision)), pair(Ball::sin(angle, &precision)))
    }
}

impl Add for Twofold {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (Twofold(s, e), Twofold(t, f)) = (sum(self.0, other.0), sum(self.1, other.1));
        let Twofold(v, w) = sum(s, e + t);
        sum(v, f + w)
    }
}

impl Neg for Twofold {
    type Output = Self;

    fn neg(self) -> Self {
        Twofold(-self.0, -self.1)
    }
}

impl Sub for Twofold {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let Twofold(p, e) = product(self.0, other.0);
        sum(p, e + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Twofold {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let q = Self::of(self.0 / other.0);
        let rest = self - q * other;
        sum(q.0, rest.0 / other.0)
    }
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use num_traits::Signed;

    use super::*;
    use crate::random::Random;

    fn exact(x: Twofold) -> BigRational {
        BigRational::from_float(x.0).unwrap() + BigRational::from_float(x.1).unwrap()
    }

    /// A pair of random bits and exponents; now and then with a gap, a power of two, or no low part.
    fn drawn(random: &mut Random, near: Option<Twofold>) -> Twofold {
        let float = |random: &mut Random, exponent: i64| {
            let mantissa = match random.within(0, 3) {
                0 => 1.0,
                1 => 2.0 - f64::EPSILON,
                _ => 1.0 + (random.bits() >> 12) as f64 * f64::EPSILON,
            };
            let x = mantissa * power_of_two(exponent);
            if random.coin() { -x } else { x }
        };
        if let Some(near) = near {
            // Nearly its negative, or nearly itself.
            let exponent = -60 - random.within(0, 60) as i64;
            let shift = float(random, exponent);
            let other = near + Twofold::of(near.0 * shift);
            return if random.coin() { -other } else { other };
        }
        let exponents = [random.within(0, 120) as i64 - 60, -54 - random.within(0, 70) as i64];
        let [high, ratio] = exponents.map(|exponent| float(random, exponent));
        let low = if random.within(0, 2) == 0 { 0.0 } else { high * ratio };
        sum(high, low)
    }

    /// The promises hold, over operands that cancel, that differ widely in size, and at ends of binades.
    #[test]
    fn operations_are_as_close_as_promised() {
        let mut random = Random::of_unit(9, 0);
        let unit = BigRational::from_float(Twofold::UNIT).unwrap();
        let mut worst = [0.0f64; 3];
        for round in 0..6000 {
            let x = drawn(&mut random, None);
            let y = drawn(&mut random, (round % 3 == 0).then_some(x));
            let (a, b) = (exact(x), exact(y));
            let results = [
                (exact(x + y), &a + &b, a.abs() + b.abs()),
                (exact(x * y), &a * &b, (&a * &b).abs()),
                (exact(x / y), &a / &b, (&a / &b).abs()),
            ];
            for (worst, (found, wanted, scale)) in worst.iter_mut().zip(results) {
                let off = (found - wanted).abs();
                assert!(off <= &unit * &scale, "{x:?} {y:?}");
                *worst = worst.max((off / (scale * &unit)).to_f64().unwrap());
            }
            let order = exact(x).cmp(&exact(y));
            assert_eq!(x.partial_cmp(&y), Some(order));
        }
        // The operations are worth their name: none loses 2⁻⁸⁰.
        assert!(worst.iter().all(|&worst| worst > 1e-9 && worst < 1.0), "{worst:?}");
    }

    #[test]
    fn sines_are_within_two_units() {
        let mut random = Random::of_unit(10, 0);
        let precision = Precision::new(300);
        for _ in 0..200 {
            let s = random.bits() >> 11 | 1;
            let angle = Angle::new(&BigRational::new(s.into(), (1u64 << 53).into()));
            let (cosine, sine) = Twofold::cosine_sine(&angle);
            for (found, ball) in
                [(cosine, Ball::cos(&angle, &precision)), (sine, Ball::sin(&angle, &precision))]
            {
                let (low, _) = ball.exact_bounds().unwrap();
                assert!((exact(found) - low).abs().to_f64().unwrap() < Twofold::UNIT);
            }
        }
    }
}
