//! π, and sines and cosines of its exact rational multiples, as balls: fixed-point series on integers.
//!
//! A fixed-point number is an integer X that stands for X·2^−w; errors are counted in its last place.

use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Roots;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::angle::{Angle, Fraction, Octant};
use super::ball::{Ball, Precision};
use super::ball_forms;
use super::fixed::{self, Signed};
use super::radius::Radius;
use super::short_sine::{SHORT_ERROR, short_sine};
use super::{Circular, Real};

/// Least bits beyond the working precision in a recurrence.
const GUARD: u32 = 64;

/// Least bits of a single sine beyond the working precision.
pub(super) const SINE_GUARD: u32 = 32;

/// The error bound of a fixed-point sine or cosine, in its last place.
pub(super) const ERROR: u64 = 32;

/// The error bound of [`series`], in its last place.
pub(super) const SERIES_ERROR: u64 = 16;

/// Bits of π beyond what sines to the working precision need, for numerators that lose some.
const PI_SPARE: u32 = 128;

/// The bits of π that sines to `bits` bits need, and some more.
pub(super) fn pi_bits(bits: u32) -> u32 {
    64 * limbs_for(bits + GUARD + PI_SPARE) as u32
}

/// π·2^w within 2, by Machin: π = 16 arctan 1/5 − 4 arctan 1/239. Cost: O(w) divisions of w bits by a word.
pub(super) fn pi(w: u32) -> BigInt {
    // 20·(w + 32)/4.6 cut quotients, each off by less than 2, stay below 2³¹ for any w below 2²⁷.
    let arctan = |q| inverse(q, w + 32, true);
    BigInt::from((arctan(5) * 16u32 - arctan(239) * 4u32) >> 32)
}

/// ln 2·2^w within 2, by 18 artanh 1/26 − 2 artanh 1/4801 + 8 artanh 1/8749: fewer cuts than for π.
pub(super) fn ln_2(w: u32) -> BigInt {
    let artanh = |q| inverse(q, w + 32, false);
    BigInt::from((artanh(26) * 18u32 + artanh(8749) * 8u32 - artanh(4801) * 2u32) >> 32)
}

/// arctan 1/q, or artanh 1/q if not `alternating`, in 2^−w.
fn inverse(q: u32, w: u32, alternating: bool) -> BigUint {
    let mut power = (BigUint::one() << w) / q;
    let (mut plus, mut minus) = (BigUint::zero(), BigUint::zero());
    let mut odd = 1u32;
    while !power.is_zero() {
        let sum = if odd % 4 == 1 || !alternating { &mut plus } else { &mut minus };
        *sum += &power / odd;
        power /= q * q;
        odd += 2;
    }
    plus - minus
}

/// Σ (−1)^i y^i first!/(2i + first)!: cos √y for `first` = 0, sin √y / √y for `first` = 1, in 2^−w, w =
/// 64·`length`. Within [`SERIES_ERROR`].
///
/// Needs 0 ≤ y ≤ 0.617 known within 4. By blocks of m ≈ √N terms (Paterson and Stockmeyer): N multiplications
/// by a word and 2√N full ones for N terms. With d_i = (2i + first − 1)(2i + first), `sum` counts in units of
/// 1/(d₁⋯d_j) for a j that falls whenever the product `scale` = d_{i+1}⋯d_j would outgrow a word. N is odd
/// and m even, so that the sum is positive (its leading term outweighs the rest) wherever it is multiplied or
/// divided; in between it wraps.
///
/// Errors: a power is off by at most 12 (y off by 4, a product by 2, times y ≤ 0.617, summed), and the powers
/// weigh at most 1/2! + 1/4! + … < 0.55; each other cut loses at most 2 in a unit of 1/(d₁⋯d_i), i ≥ 2,
/// together less than 1; the last division and the tail lose less than 1 each.
pub(super) fn series(y: &BigInt, length: usize, first: u64) -> BigInt {
    let w = 64 * length as u64;
    let d = |i: u64| (2 * i + first - 1) * (2 * i + first);
    // y < 2^−small; y^i/(d₁⋯d_i) < 2^−w ends the alternating sum.
    let small = w.saturating_sub(y.bits());
    let (mut terms, mut reached) = (1, 0);
    while reached <= w {
        reached += small + u64::from(d(terms).ilog2());
        terms += 1;
    }
    let terms = terms | 1;
    let m = (terms.sqrt() + 1) & !1;
    let y = fixed::limbs(y.magnitude(), length);
    let mut powers = vec![Vec::new(), y.clone()];
    for j in 1..m as usize {
        powers.push(fixed::product(&powers[j], &y));
    }
    let mut sum = vec![0u64; length + 1];
    let mut scale = 1u64;
    for i in (0..terms).rev() {
        let odd = i % 2 == 1;
        match i % m {
            0 => sum[length] = sum[length].wrapping_add(scale),
            j => fixed::add_scaled(&mut sum, &powers[j as usize], scale, odd),
        }
        if i == 0 {
            break;
        }
        if i % m == 0 {
            sum = fixed::product(&sum, &powers[m as usize]);
        }
        if !odd && scale.checked_mul(d(i)).and_then(|scale| scale.checked_mul(d(i - 1))).is_none() {
            fixed::divide(&mut sum, scale);
            scale = 1;
        }
        scale *= d(i);
    }
    fixed::divide(&mut sum, scale);
    fixed::integer(&sum).into()
}

/// sin or cos of πt, 0 < t ≤ ¼, as value·2^exp ± radius, relative error below 2^(13−w), w = 64·`length`.
fn kernel(cosine: bool, t: &Fraction, precision: &Precision, length: usize) -> (BigInt, i128, Radius) {
    match short_limbs(cosine, t, length) {
        // At least sin π/512 > 2^−7.4.
        Some(limbs) => {
            let exp = -64 * limbs.len() as i128;
            (fixed::integer(&limbs).into(), exp, Radius::new(SHORT_ERROR, exp))
        }
        None => series_kernel(cosine, t, precision, length),
    }
}

/// The short series where it serves, by `length` limbs or more.
fn short_limbs(cosine: bool, t: &Fraction, length: usize) -> Option<Vec<u64>> {
    match t {
        &Fraction::Small(p, q) => short_sine(cosine, p, q, length),
        Fraction::Large(..) => None,
    }
}

/// As [`kernel`] by the long series, relative error below 2^(5−w).
pub(super) fn series_kernel(
    cosine: bool,
    t: &Fraction,
    precision: &Precision,
    length: usize,
) -> (BigInt, i128, Radius) {
    let w = 64 * length as u32;
    let pi = &precision.pi >> (precision.pi_bits() - w);
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
    let fixed = i128::from(w);
    if cosine {
        return (series(&y, length, 0), -fixed, Radius::new(ERROR, -fixed));
    }
    // sin πt = πt · sinc: πt within 2/3 + 1 relative to 2^w, the sinc, at least 0.9, within 16.
    let exp = -fixed - i128::from(shift);
    let radius = Radius::of(&x, exp) * Radius::new(ERROR, -fixed);
    (x * series(&y, length, 1), exp - fixed, radius)
}

/// sin or cos of πt within [`ERROR`] of the last of L limbs, for 1/512 ≤ t ≤ ¼ on L + 1 limbs, of which the
/// lowest may be off by 2⁵⁰.
///
/// πt is off by 2·¼ of π, 1 of a cut and 2^−12 of t, its square, at most 0.617, by less than 2·0.79·1.51 + 1
/// < 4. sin πt = πt · sinc: by 1.51 of the first, 0.79·16 of the series and a cut.
pub(super) fn limbs_sine(cosine: bool, t: &[u64], precision: &Precision) -> Vec<u64> {
    let length = t.len() - 1;
    let w = 64 * length as u32;
    let pi: BigInt = &precision.pi >> (precision.pi_bits() - w);
    let x = (pi * BigInt::from(fixed::integer(t))) >> (w + 64);
    let y = (&x * &x) >> w;
    let value = if cosine { series(&y, length, 0) } else { (x * series(&y, length, 1)) >> w };
    fixed::limbs(value.magnitude(), length)
}

/// The sine of an exact angle as value·2^exp ± radius, relative error below 2^(13−w), for w = 64·`length` or
/// as many bits as π has.
pub(super) fn exact_sine(angle: &Angle, precision: &Precision, length: usize) -> (BigInt, i128, Radius) {
    let octant = angle.octant();
    let length = length.min(precision.pi_bits() as usize / 64);
    let (value, exp, radius) = match octant.halves() {
        Some(halves) => (halves.into(), -1, Radius::ZERO),
        None => kernel(octant.cosine, &octant.t, precision, length),
    };
    (if octant.negative { -value } else { value }, exp, radius)
}

impl Octant {
    /// The value where it is rational: 0, ½ or 1 (Niven), in halves.
    pub(super) fn halves(&self) -> Option<u32> {
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

/// The sine of an angle in fixed point, within [`ERROR`], with a whole limb.
fn fixed_sine(angle: &Angle, precision: &Precision, length: usize) -> Signed {
    let octant = angle.octant();
    let w = 64 * length as i128;
    let magnitude = match octant.halves() {
        Some(halves) => BigUint::from(halves) << (w - 1),
        None => {
            if let Some(limbs) = short_limbs(octant.cosine, &octant.t, length) {
                let mut limbs = limbs[limbs.len() - length..].to_vec();
                limbs.push(0);
                return Signed { negative: octant.negative, limbs };
            }
            let (value, exp, _) = series_kernel(octant.cosine, &octant.t, precision, length);
            value.magnitude() >> -(exp + w)
        }
    };
    Signed { negative: octant.negative, limbs: fixed::limbs(&magnitude, length + 1) }
}

/// f(0), f(1), …, f(n) for f(k) = sin or cos of k times the angle, from f(0), f(1) by f(k+1) = 2c·f(k) −
/// f(k−1).
///
/// Let c be the cosine, e_k the error of f(k) in the last place. A step adds at most 2·[`ERROR`]·1.1 + 9 < 80
/// (c's own error and a product's), and an error ε made at step i reaches step k as ε·sin((k−i)x)/sin x ≤ ε(k
/// − i). Hence e_k ≤ 32k + 80·k²/2 ≤ 72k². Where that leaves fewer than `bits` good bits, the value is
/// computed by itself.
fn multiples(
    angle: &Angle,
    n: u64,
    precision: &Precision,
    first: [&Angle; 2],
    single: impl Fn(&Angle) -> Ball,
) -> Vec<Ball> {
    let bits = precision.bits();
    let length = limbs_for(bits + GUARD);
    let exp = -64 * length as i128;
    // 2c = 4·(c/2): half a cosine is a fraction.
    let cosine = fixed_sine(&angle.complement(), precision, length);
    let half = fixed::limbs(&(fixed::integer(&cosine.limbs) >> 1), length);
    let [mut previous, mut current] = first.map(|angle| fixed_sine(angle, precision, length));
    let mut values = Vec::with_capacity(n as usize + 1);
    for k in 0..=n {
        let error = 72 * u128::from(k) * u128::from(k) + u128::from(ERROR);
        let error_bits = u64::from(128 - error.leading_zeros());
        let magnitude = fixed::integer(&previous.limbs);
        values.push(if magnitude.bits() < error_bits + u64::from(bits) || error_bits > 60 {
            single(&angle.times(k))
        } else {
            let sign = if previous.negative { Sign::Minus } else { Sign::Plus };
            Ball::new(BigInt::from_biguint(sign, magnitude), exp, Radius::new(error as u64, exp), bits)
        });
        let next = current.step(&half, cosine.negative, &previous);
        previous = current;
        current = next;
    }
    values
}

/// Limbs for a number of bits, at least 2.
pub(super) fn limbs_for(bits: u32) -> usize {
    bits.div_ceil(64).max(2) as usize
}

impl Circular for Ball {
    /// Width at most 3 times that of the correctly rounded enclosure. Cost for b bits: O(√b) products of b
    /// bits.
    fn sin(angle: &Angle, precision: &Precision) -> Ball {
        let octant = angle.octant();
        let bits = precision.bits();
        let magnitude = match octant.halves() {
            Some(halves) => Ball::new(halves.into(), -1, Radius::ZERO, bits),
            None => {
                let (value, exp, radius) =
                    kernel(octant.cosine, &octant.t, precision, limbs_for(bits + SINE_GUARD));
                Ball::new(value, exp, radius, bits)
            }
        };
        if octant.negative { -magnitude } else { magnitude }
    }

    /// By 1 − cos(α − β)/cos(α + β) where this loses no more bits than are to spare: two cosines in place of
    /// three sines.
    fn sines_over_cosine([first, second]: [&Angle; 2], sum: &Angle, precision: &Precision) -> Ball {
        let bits = precision.bits();
        let length = limbs_for(bits + SINE_GUARD);
        let exp = -64 * length as i128;
        let [above, below] = [first.minus(second), sum.clone()].map(|angle| angle.complement());
        if [&above, &below].iter().all(|angle| angle.octant().halves().is_none()) {
            let [above, below] = [above, below].map(|angle| fixed_sine(&angle, precision, length).integer());
            let difference = &below - above;
            // The errors, of at most 2·ERROR = 64, then are below a quarter of the last bit that is kept.
            let enough = |x: &BigInt| x.bits() >= u64::from(bits) + 9;
            if enough(&difference) && enough(&below) {
                return Ball::new(difference, exp, Radius::new(2 * ERROR, exp), bits)
                    / &Ball::new(below, exp, Radius::new(ERROR, exp), bits);
            }
        }
        let product = Ball::sin(first, precision) * &Ball::sin(second, precision);
        -(product.clone() + &product) / &Ball::cos(sum, precision)
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

    fn polar_quotient(
        point: (&BigRational, &BigRational),
        at: [u64; 2],
        precision: &Precision,
    ) -> Option<Ball> {
        let [numerator, denominator] = ball_forms::polar_parts(point, at, precision)?;
        Some((numerator / &denominator).cut(precision.bits()))
    }

    fn polar_sign(
        point: (&BigRational, &BigRational),
        at: [u64; 2],
        precision: &Precision,
    ) -> Option<Option<super::Sign>> {
        ball_forms::polar_sign(point, at, precision)
    }

    fn tighter(self, other: Ball) -> Ball {
        let difference = (self.clone() - &other).sign();
        assert!(
            matches!(difference, None | Some(super::Sign::Zero)),
            "two enclosures of one number are disjoint"
        );
        if other.is_narrower_than(&self) { other } else { self }
    }
}

#[cfg(test)]
mod tests {
    use num_traits::{Signed, ToPrimitive};

    use super::*;

    /// The bounds from the terms that the comments name: no sampled value comes near them.
    #[test]
    fn the_error_bounds_cover_their_terms() {
        // y = (π/4)² at the most, off by 4; a power adds a product's 2 and y's 4 to what the last one passes
        // on.
        let y = (std::f64::consts::PI / 4.0).powi(2);
        let power = (2..60).fold(4.0f64, |error, j: i32| (error * y + 4.0 * y.powi(j - 1) + 2.0).max(error));
        for first in [0u64, 1] {
            let d = |i: u64| ((2 * i + first - 1) * (2 * i + first)) as f64;
            let weight = |i: u64| (1..=i).map(d).product::<f64>().recip();
            let powers: f64 = (1..20).map(|i| power * weight(i)).sum();
            let cuts: f64 = (2..20).map(|i| 2.0 * weight(i)).sum();
            // The last division and the tail.
            let series = powers + cuts + 2.0;
            assert!(series > 2.0 && series <= SERIES_ERROR as f64, "{series}");
        }
        // Of the sine: πt within 2/3 + 1, the sinc, at least 0.9, within its series' error.
        let sine = SERIES_ERROR as f64 / 0.9 + 5.0 / 3.0;
        assert!(sine * 1.01 <= ERROR as f64 && SERIES_ERROR <= ERROR);
    }

    /// Values to 128 bits against values to 400, before a rounding could hide an error.
    #[test]
    fn kernels_stay_within_their_error() {
        let precision = Precision::new(400);
        let mut worst = 0.0f64;
        for i in 1..2000u64 {
            let t = BigRational::new((i * 7919).into(), (4 * 2000 * 7919u64 + 1).into());
            let angle = Angle::new(&t);
            for (cosine, true_value) in
                [(false, Ball::sin(&angle, &precision)), (true, Ball::cos(&angle, &precision))]
            {
                let octant = angle.octant();
                let (value, exp, radius) = series_kernel(cosine, &octant.t, &precision, 2);
                let error = Ball::new(value, exp, Radius::ZERO, 400) - &true_value;
                let (low, high) = error.exact_bounds().unwrap();
                let (bound, _) = Ball::zero(64).widened(radius).exact_bounds().unwrap();
                let error = low.abs().max(high.abs());
                assert!(error <= -bound.clone(), "{i}, cosine: {cosine}");
                worst = worst.max((error / -bound).to_f64().unwrap());
            }
        }
        // More than one last place, so that the bound is no formality.
        assert!(worst * ERROR as f64 > 1.0, "{worst}");
    }
}
