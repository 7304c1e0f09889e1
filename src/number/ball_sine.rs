//! π, and sines and cosines of its exact rational multiples, as balls: fixed-point series on integers.
//!
//! A fixed-point number is an integer X that stands for X·2^−w; errors are counted in its last place.

use num_bigint::{BigInt, BigUint};
use num_integer::Roots;
use num_traits::{One, Zero};

use super::angle::{Angle, Fraction, Octant};
use super::ball::{Ball, Precision};
use super::radius::Radius;
use super::Circular;

/// Bits of π beyond the working precision.
pub(super) const GUARD: u32 = 64;

/// Bits of a single sine beyond the working precision.
const SINE_GUARD: u32 = 32;

/// The error bound of a fixed-point sine or cosine, in its last place.
const ERROR: u64 = 32;

/// π·2^w within 2, by Machin: π = 16 arctan 1/5 − 4 arctan 1/239. Cost: O(w) divisions of w bits by a word.
pub(super) fn pi(w: u32) -> BigInt {
    // 20·(w + 32)/4.6 cut quotients, each off by less than 2, stay below 2³¹ for any w below 2²⁷.
    let arctan = |q: u32| {
        let mut power = (BigUint::one() << (w + 32)) / q;
        let (mut plus, mut minus) = (BigUint::zero(), BigUint::zero());
        let mut odd = 1u32;
        while !power.is_zero() {
            let sum = if odd % 4 == 1 { &mut plus } else { &mut minus };
            *sum += &power / odd;
            power /= q * q;
            odd += 2;
        }
        plus - minus
    };
    BigInt::from((arctan(5) * 16u32 - arctan(239) * 4u32) >> 32)
}

/// Σ (−1)^i y^i first!/(2i + first)!: cos √y for `first` = 0, sin √y / √y for `first` = 1. Within 16.
///
/// Needs 0 ≤ y ≤ 0.617 known within 4. By blocks of m ≈ √N terms (Paterson and Stockmeyer): N multiplications by a word and 2√N full
/// ones for N terms. With d_i = (2i + first − 1)(2i + first), `sum` counts in units of 1/(d₁⋯d_j) for a j that falls
/// whenever the product `scale` = d_{i+1}⋯d_j would outgrow a word.
///
/// Errors: a power is off by at most 9 (y off by 4, one cut, times y ≤ 0.617, summed), and the powers weigh at most
/// 1/2! + 1/4! + … < 0.55; each other cut loses 1 in a unit of 1/(d₁⋯d_i), i ≥ 1, together less than 2·0.55; the last
/// division and the tail lose less than 1 each.
fn series(y: &BigInt, w: u32, first: u64) -> BigInt {
    let d = |i: u64| (2 * i + first - 1) * (2 * i + first);
    // y < 2^−small; y^i/(d₁⋯d_i) < 2^−w ends the alternating sum.
    let small = u64::from(w).saturating_sub(y.bits());
    let mut terms = 1;
    let mut reached = 0;
    while reached <= u64::from(w) {
        reached += small + u64::from(d(terms).ilog2());
        terms += 1;
    }
    let m = terms.sqrt().max(1);
    let mut powers = vec![BigInt::one() << w];
    for j in 0..m as usize {
        powers.push((&powers[j] * y) >> w);
    }
    let mut sum = BigInt::zero();
    let mut term = BigInt::zero();
    let mut scale = 1u64;
    for i in (0..terms).rev() {
        term.clone_from(&powers[(i % m) as usize]);
        term *= scale;
        if i % 2 == 0 {
            sum += &term;
        } else {
            sum -= &term;
        }
        if i > 0 {
            if i % m == 0 {
                sum = (sum * &powers[m as usize]) >> w;
            }
            scale = scale.checked_mul(d(i)).unwrap_or_else(|| {
                sum /= scale;
                d(i)
            });
        }
    }
    sum / scale
}

/// sin or cos of πt, 0 < t ≤ ¼, as value·2^exp ± radius, relative error below 2^(5−w).
fn kernel(cosine: bool, t: &Fraction, precision: &Precision, w: u32) -> (BigInt, i64, Radius) {
    let pi = &precision.pi >> (precision.bits() + GUARD - w);
    // t ≥ 2^(−shift−1), so that πt·2^(w+shift) has at least w bits, whatever the size of t.
    let (x, shift) = match t {
        &Fraction::Small(numerator, denominator) => {
            let shift = numerator.leading_zeros() - denominator.leading_zeros();
            (((pi * numerator) << shift) / denominator, u64::from(shift))
        }
        Fraction::Large(numerator, denominator) => {
            let shift = denominator.bits() - numerator.bits();
            (((pi * BigInt::from(numerator.clone())) << shift) / BigInt::from(denominator.clone()), shift)
        }
    };
    // πt within 2·¼ + 1; its square, at most (π/4)² < 0.617, within 2·0.79·1.5 + 1 < 4.
    let cut = &x >> shift;
    let y = (&cut * &cut) >> w;
    let fixed = i64::from(w);
    if cosine {
        return (series(&y, w, 0), -fixed, Radius::new(ERROR, -fixed));
    }
    // sin πt = πt · sinc: πt within 2/3 + 1 relative to 2^w, the sinc, at least 0.9, within 16.
    let exp = -fixed - shift as i64;
    let radius = Radius::of(&x, exp) * Radius::new(ERROR, -fixed);
    (x * series(&y, w, 1), exp - fixed, radius)
}

impl Octant {
    /// The value where it is rational: 0, ½ or 1 (Niven), in halves.
    fn halves(&self) -> Option<u32> {
        let (zero, sixth) = match &self.t {
            &Fraction::Small(p, q) => (p == 0, p.checked_mul(6) == Some(q)),
            Fraction::Large(p, q) => (p.is_zero(), p * 6u32 == *q),
        };
        match (zero, self.cosine) {
            (true, cosine) => Some(if cosine { 2 } else { 0 }),
            (false, false) if sixth => Some(1),
            _ => None,
        }
    }
}

/// The sine of an angle in fixed point at w bits, within [`ERROR`].
fn fixed_sine(angle: &Angle, precision: &Precision, w: u32) -> BigInt {
    let octant = angle.octant();
    let magnitude = match octant.halves() {
        Some(halves) => BigInt::from(halves) << (w - 1),
        None => {
            let (value, exp, _) = kernel(octant.cosine, &octant.t, precision, w);
            value >> -(exp + i64::from(w))
        }
    };
    if octant.negative { -magnitude } else { magnitude }
}

/// f(0), f(1), …, f(n) for f(k) = sin or cos of k times the angle, from f(0), f(1) by f(k+1) = 2c·f(k) − f(k−1).
///
/// Let c be the cosine, e_k the error of f(k) in the last place, w = bits + [`GUARD`]. A step adds at most 2·[`ERROR`]·1.1 + 1 < 80
/// (c's own error and a cut), and an error ε made at step i reaches step k as ε·sin((k−i)x)/sin x ≤ ε(k − i). Hence
/// e_k ≤ 32k + 80·k²/2 ≤ 72k². Where that leaves fewer than `bits` good bits, the value is computed by itself.
fn multiples(angle: &Angle, n: u64, precision: &Precision, first: [&Angle; 2], single: impl Fn(&Angle) -> Ball) -> Vec<Ball> {
    let (bits, w) = (precision.bits(), precision.bits() + GUARD);
    let double_cosine: BigInt = fixed_sine(&angle.complement(), precision, w) << 1;
    let [mut previous, mut current] = first.map(|angle| fixed_sine(angle, precision, w));
    let mut values = Vec::with_capacity(n as usize + 1);
    for k in 0..=n {
        let error = 72 * u128::from(k) * u128::from(k) + u128::from(ERROR);
        let error_bits = u64::from(128 - error.leading_zeros());
        values.push(if previous.bits() < error_bits + u64::from(bits) || error_bits > 60 {
            single(&angle.times(k))
        } else {
            Ball::new(previous.clone(), -i64::from(w), Radius::new(error as u64, -i64::from(w)), bits)
        });
        let next = ((&double_cosine * &current) >> w) - &previous;
        previous = current;
        current = next;
    }
    values
}

impl Circular for Ball {
    /// Width at most 3 times that of the correctly rounded enclosure. Cost for b bits: O(√b) products of b bits.
    fn sin(angle: &Angle, precision: &Precision) -> Ball {
        let octant = angle.octant();
        let bits = precision.bits();
        let magnitude = match octant.halves() {
            Some(halves) => Ball::new(halves.into(), -1, Radius::ZERO, bits),
            None => {
                let (value, exp, radius) = kernel(octant.cosine, &octant.t, precision, bits + SINE_GUARD);
                Ball::new(value, exp, radius, bits)
            }
        };
        if octant.negative { -magnitude } else { magnitude }
    }

    /// Cost for b bits: n products of b bits, by the recurrence in k.
    fn sines(angle: &Angle, n: u64, precision: &Precision) -> Vec<Ball> {
        multiples(angle, n, precision, [&angle.times(0), angle], |angle| Ball::sin(angle, precision))
    }

    /// As [`sines`](Circular::sines).
    fn cosines(angle: &Angle, n: u64, precision: &Precision) -> Vec<Ball> {
        let first = [&angle.times(0).complement(), &angle.complement()];
        multiples(angle, n, precision, first, |angle| Ball::cos(angle, precision))
    }

    fn tighter(self, other: Ball) -> Ball {
        if other.is_narrower_than(&self) { other } else { self }
    }
}
