//! sin and cos of πt for the `f64` interval, in 64-bit integers: no libm, no float rounding to trust.
//!
//! A kernel returns a 64-bit mantissa and a proved bound on its error, about 2⁻⁵⁹ of the value; one
//! rounding then yields the two end points, which mostly are neighbouring floats.

use num_traits::ToPrimitive;

use super::angle::{Angle, Fraction};
use super::float_interval::FloatInterval;

/// π/4 · 2⁶⁴, to nearest.
const QUARTER_PI: u64 = 0xc90f_daa2_2168_c235;

/// (π/4)^{2i} / (2i + 1)! · 2⁶⁴, i = 1, …, 9, to nearest. The next one is below 2⁻⁸.
const SIN: [u64; 9] = [
    0x1a51_a662_5307_d323,
    0x00cf_ce5a_015e_2363,
    0x0003_0d51_c8e4_1b6d,
    0x06b1_a017_3cd4,
    0x9_9c0b_5523,
    0x9ba_38d0,
    0x75092,
    0x43f,
    0x2,
];

/// (π/4)^{2i} / (2i)! · 2⁶⁴, i = 1, …, 9, to nearest. The next one is below 2⁻⁴.
const COS: [u64; 9] = [
    0x4ef4_f326_f917_7969,
    0x040f_07c2_06d6_b0ed,
    0x0015_5d3c_7e3c_bffa,
    0x3c3e_a0d1_2375,
    0x69_b47c_a881,
    0x7e74_e28e,
    0x6d_b894,
    0x4832,
    0x25,
];

/// The error bound of both kernels in units of the mantissa. See [`sin_mantissa`] and [`cos_mantissa`].
const ERROR: u64 = 24;

fn high(a: u64, b: u64) -> u64 {
    ((u128::from(a) * u128::from(b)) >> 64) as u64
}

/// Σ (−1)^{i−1} c_i z^{i−1} over the table, in units of 2⁻⁶⁴, within 16.
///
/// Each of 8 steps adds at most 1½ units (a coefficient is off by ½, a product is cut by 1 and scaled by z <
/// 1), the tail less than 1; an error of 5 units in z weighs c₂ + 2c₃ + … < 0.02 and adds less than 1.
fn alternating(table: &[u64; 9], z: u64) -> u64 {
    table.iter().rev().skip(1).fold(table[8], |sum, &c| c - high(z, sum))
}

/// (4t)² in units of 2⁻⁶⁴, within 5 below, from 4t in units of 2⁻⁶⁴, within 2 below.
fn square(w: u64) -> u64 {
    high(w, w)
}

/// sin(πt)/t · m/π·(π/4) for a mantissa m of 4t: in units of 2⁻⁶⁴·m's scale, within [`ERROR`].
///
/// q = m·π/4 is off by at most 3 (½ in the constant, 1 in m, 1 cut). The series gives 1 − sinc within 16 + 1
/// units; multiplied by q < 2⁶⁴ and cut, all stays within 3 + 18 units.
fn sin_mantissa(m: u64, w: u64) -> u64 {
    let z = square(w);
    let q = high(m, QUARTER_PI);
    q - high(q, high(z, alternating(&SIN, z)))
}

/// cos(πt) in units of 2⁻⁶⁴ within [`ERROR`], capped at 1 − 2⁻⁶⁴ (within the bound too).
fn cos_mantissa(w: u64) -> u64 {
    let z = square(w);
    u64::MAX - high(z, alternating(&COS, z))
}

/// The interval m·2^e ± error·2^e, m ≥ error, rounded outwards; m < 2⁶⁴.
pub(super) fn enclose(m: u64, error: u64, e: i64) -> FloatInterval {
    let (lo, (hi, overflow)) = (m - error, m.overflowing_add(error));
    // m + error < 2⁶⁵: beyond 2⁶⁴, halved upwards.
    let hi = if overflow { float((hi >> 1) + (hi & 1) + (1 << 63), e + 1, true) } else { float(hi, e, true) };
    FloatInterval::from_bounds(float(lo, e, false), hi)
}

/// m·2^e rounded down or up to a float, for m > 0.
fn float(m: u64, e: i64, up: bool) -> f64 {
    let zeros = m.leading_zeros();
    let m = m << zeros;
    let top = (m >> 11) + u64::from(up && m & 0x7ff != 0);
    let exponent = e - i64::from(zeros) + 11;
    // top in [2⁵², 2⁵³]: the value is top·2^exponent, and adding the fields lets a carry raise the exponent,
    // from that of the largest floats (2⁵²·2⁹⁷¹ = 2¹⁰²³) to that of infinity.
    match exponent + 1074 {
        biased @ 0..=2045 => f64::from_bits(top + ((biased as u64) << 52)),
        // Below the normal range a float's bits count units of 2⁻¹⁰⁷⁴.
        biased if biased < 0 => {
            let cut = biased.unsigned_abs().min(63);
            f64::from_bits((top >> cut) + u64::from(up && (top >> cut) << cut != top))
        }
        _ if up => f64::INFINITY,
        _ => f64::MAX,
    }
}

/// (m ± error)·2^e: a magnitude before it is rounded. m = 0 is zero itself; else m > 2⁶¹. Of a sine, error ≤
/// [`ERROR`].
#[derive(Clone, Copy)]
struct Magnitude {
    m: u64,
    error: u64,
    e: i64,
}

impl Magnitude {
    const ZERO: Magnitude = Magnitude { m: 0, error: 0, e: 0 };
    const HALF: Magnitude = Magnitude { m: 1 << 63, error: 0, e: -64 };
    const ONE: Magnitude = Magnitude { m: 1 << 63, error: 0, e: -63 };

    /// The enclosure from 4t = m·2^{−64−shift}, m cut down by less than 1.
    fn kernel(cosine: bool, m: u64, shift: i64) -> Magnitude {
        let w = match shift {
            0 => m,
            1..=63 => m >> shift,
            64.. => 0,
            _ => m.saturating_mul(2), // 4t = 1 at the most
        };
        let (m, e) = if cosine { (cos_mantissa(w), -64) } else { (sin_mantissa(m, w), -64 - shift) };
        Magnitude { m, error: ERROR, e }
    }

    /// The same with m ≥ 2⁶³, unless it is zero: the error grows by a factor of 4 at the most.
    fn normal(self) -> Magnitude {
        let zeros = self.m.leading_zeros() & 63;
        Magnitude { m: self.m << zeros, error: self.error << zeros, e: self.e - i64::from(zeros) }
    }
}

/// Whether the sine of the angle is negative, and its magnitude.
#[inline]
fn magnitude(angle: &Angle) -> (bool, Magnitude) {
    let Some((negative, cosine, numerator, denominator)) = angle.small_octant() else { return large(angle) };
    let magnitude = if numerator == 0 {
        if cosine { Magnitude::ONE } else { Magnitude::ZERO }
    } else if denominator >> 32 == 0 && 16 * numerator >= denominator {
        if !cosine && 6 * numerator == denominator {
            Magnitude::HALF
        } else {
            // ¼ ≤ 4t: two short divisions are quicker than a long one, and lose nothing.
            let high = (numerator << 34) / denominator;
            let rest = (numerator << 34) % denominator;
            let m = if high >> 32 == 0 { (high << 32) + (rest << 32) / denominator } else { u64::MAX };
            Magnitude::kernel(cosine, m, 0)
        }
    } else if !cosine && numerator.checked_mul(6) == Some(denominator) {
        Magnitude::HALF
    } else {
        // 4t = m·2^{−shift−64}, 2⁶² < m < 2⁶⁴ cut down.
        let (n, d) = (numerator.leading_zeros(), denominator.leading_zeros());
        let m = (u128::from(numerator << n) << 63) / u128::from(denominator << d);
        Magnitude::kernel(cosine, m as u64, i64::from(n) - i64::from(d) - 3)
    };
    (negative, magnitude)
}

#[cold]
fn large(angle: &Angle) -> (bool, Magnitude) {
    let octant = angle.octant();
    let magnitude = match (octant.halves(), &octant.t) {
        (Some(0), _) => Magnitude::ZERO,
        (Some(1), _) => Magnitude::HALF,
        (Some(_), _) => Magnitude::ONE,
        (None, Fraction::Large(numerator, denominator)) => {
            let shift = denominator.bits() - numerator.bits() + 63;
            let m = ((numerator << shift) / denominator).to_u64().unwrap_or(u64::MAX);
            Magnitude::kernel(octant.cosine, m, shift as i64 - 66)
        }
        (None, Fraction::Small(..)) => unreachable!("machine integers take the other path"),
    };
    (octant.negative, magnitude)
}

/// sin of the angle: width at most 2 ulp, and 0 where the sine is rational. Cost: a division and about 12
/// products of 64 bits for angles in machine integers.
#[inline]
pub(super) fn sin(angle: &Angle) -> FloatInterval {
    let (negative, Magnitude { m, error, e }) = magnitude(angle);
    if m == 0 {
        return point(0.0);
    }
    let wide = enclose(m, error, e);
    // No sine exceeds 1.
    let magnitude = FloatInterval::from_bounds(wide.lo(), wide.hi().min(1.0));
    if negative { -magnitude } else { magnitude }
}

/// ab/c for magnitudes that are not zero.
///
/// With A, B, C ≥ 2⁶³, off by α, β, γ ≤ 4·[`ERROR`], AB/2⁶⁴ is off by δ = α + β + 2: (αB + βA + αβ)/2⁶⁴ is
/// below α + β + 1, and the cut below 1. Then 2⁶³P/C is off by 2⁶³(δ + γP/C)/(C − γ) ≤ (δ + 2γ)(1 + 2⁻⁵⁰) < δ
/// + 2γ + 1, and 1 for the cut. P lies between 2⁶² and 2⁶⁴, so the quotient does between 2⁶¹ and 2⁶⁴.
fn product_over(a: Magnitude, b: Magnitude, c: Magnitude) -> Magnitude {
    let [a, b, c] = [a, b, c].map(Magnitude::normal);
    let product = u128::from(a.m) * u128::from(b.m);
    let (dividend, divisor) = (product >> 64 << 63, u128::from(c.m));
    let errors = a.error + b.error + 2 * c.error;
    let exact = errors == 0 && product as u64 == 0 && dividend % divisor == 0;
    let error = if exact { 0 } else { errors + 4 };
    Magnitude { m: (dividend / divisor) as u64, error, e: a.e + b.e - c.e + 1 }
}

/// −2 sin α sin β / cos(α + β) for two angles and their sum, rounded once: the whole line where the cosine is
/// 0. Width: mostly one ulp, three at the most. Cost: three sines, a product and a division.
pub(super) fn sines_over_cosine([first, second]: [&Angle; 2], sum: &Angle) -> FloatInterval {
    let [(minus_a, a), (minus_b, b), (minus_c, c)] =
        [magnitude(first), magnitude(second), magnitude(&sum.complement())];
    if c.m == 0 {
        return FloatInterval::WHOLE;
    }
    if a.m == 0 || b.m == 0 {
        return point(0.0);
    }
    let Magnitude { m, error, e } = product_over(a, b, c);
    let quotient = enclose(m, error, e + 1);
    if minus_a ^ minus_b ^ minus_c { quotient } else { -quotient }
}

fn point(value: f64) -> FloatInterval {
    FloatInterval::from_bounds(value, value)
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use num_traits::{One, Signed, ToPrimitive, pow};

    use super::*;
    use crate::{Ball, Circular, Elementary, Precision};

    fn exact(x: u64) -> BigRational {
        BigRational::from_integer(x.into())
    }

    fn two_to(e: usize) -> BigRational {
        BigRational::from_integer(BigInt::one() << e)
    }

    /// (π/4)^{2i}/(2i + first)!·2⁶⁴ to 60 places.
    fn coefficient(i: usize, first: usize) -> BigRational {
        let pi = Ball::pi(&Precision::new(256)).exact_bounds().unwrap().0;
        let factorial: BigInt = (1..=2 * i + first).map(BigInt::from).product();
        pow(pi / exact(4), 2 * i) * two_to(64) / BigRational::from_integer(factorial)
    }

    /// The tables, and the bounds from the terms that the comments name: no sampled value comes near them.
    #[test]
    fn the_error_bound_covers_its_terms() {
        let float = |x: BigRational| x.to_f64().unwrap();
        for (table, first) in [(&SIN, 1), (&COS, 0)] {
            let off = |i: usize| float((exact(table[i - 1]) - coefficient(i, first)).abs());
            assert!((1..=9).all(|i| off(i) <= 0.5), "first = {first}");
            let tail = float(coefficient(10, first));
            // Each of 8 steps: a coefficient, a product's cut, and what came before times z < 1.
            let sum = (1..=8).fold(off(9) + tail, |error, i| error + off(i) + 1.0);
            // z is off by 5 units and multiplies c₂ + 2c₃ + ….
            let slope: f64 =
                (2..=9).map(|i| (i - 1) as f64 * float(coefficient(i, first) / two_to(64))).sum();
            let alternating = sum + 5.0 * slope;
            assert!(alternating <= 16.0, "{alternating}");
            // Times z, whose 5 units weigh c₁, and cut.
            let series = alternating + 5.0 * float(coefficient(1, first) / two_to(64)) + 1.0;
            // The sine: times q, off by 3, and cut. The cosine: capped at 1 − 2⁻⁶⁴.
            let total = if first == 1 { series + 3.0 + 1.0 } else { series + 1.0 };
            assert!(total <= ERROR as f64, "first = {first}: {total}");
        }
    }

    /// Mantissas against balls, before the rounding to 53 bits could hide an error.
    #[test]
    fn kernels_stay_within_their_error() {
        let precision = Precision::new(200);
        let mut worst = BigRational::from_integer(0.into());
        for i in 1..4000u64 {
            // 4t = m·2⁻⁶⁴, m ≥ 2⁶², off by nothing.
            let m = (1 << 62) + i * ((3u128 << 62) / 4000) as u64;
            let angle = crate::Angle::new(&(exact(m) / two_to(66)));
            for (value, ball) in [
                (sin_mantissa(m, m), Ball::sin(&angle, &precision)),
                (cos_mantissa(m), Ball::cos(&angle, &precision)),
            ] {
                let (low, high) = ball.exact_bounds().unwrap();
                let (low, high) = (low * two_to(64) - exact(value), high * two_to(64) - exact(value));
                let error = low.abs().max(high.abs());
                assert!(error <= exact(ERROR), "m = {m:#x}: {error}");
                worst = worst.max(error);
            }
        }
        assert!(worst > exact(1), "the bound is no formality: {}", worst.to_f64().unwrap());
    }

    /// Products over magnitudes, off by as much as they may be: within the error, which is no formality.
    #[test]
    fn products_over_stay_within_their_error() {
        let ends = |Magnitude { m, error, e }: Magnitude| {
            let scaled = |m: BigRational| m * two_to((e + 200) as usize) / two_to(200);
            [scaled(exact(m) - exact(error)), scaled(exact(m) + exact(error))]
        };
        let mut random = crate::random::Random(5);
        let mut mantissas = vec![1 << 63, (1 << 63) + 1, u64::MAX, u64::MAX - 1, (1 << 61) + 1, 3 << 61];
        mantissas.extend((0..12).map(|_| random.next() >> random.below(3) | 1 << 61));
        let (mut worst, mut exactly) = (BigRational::from_integer(0.into()), 0);
        for (&a, &b, &c) in mantissas.iter().flat_map(|a| {
            let pairs = mantissas.iter().flat_map(|b| mantissas.iter().map(move |c| (b, c)));
            pairs.map(move |(b, c)| (a, b, c))
        }) {
            for error in [0, 1, ERROR] {
                let of = |m: u64| Magnitude { m, error, e: -64 };
                let [a, b, c] = [of(a), of(b), of(c)];
                let found = product_over(a, b, c);
                assert!(found.m > 1 << 60 && found.error <= 16 * ERROR + 4);
                let ([low, high], [a, b, c]) = (ends(found), [a, b, c].map(ends));
                let (least, most) = (&a[0] * &b[0] / &c[1], &a[1] * &b[1] / &c[0]);
                assert!(low <= least && most <= high, "{a:?} {b:?} {c:?}");
                if found.error == 0 {
                    exactly += 1;
                } else if error > 0 {
                    worst = worst.max((most - least) / (high - low));
                }
            }
        }
        assert!(exactly > 0 && worst > exact(1) / exact(2), "{exactly} {worst}");
    }

    /// Quotients of sines against balls, from poles and zeros at 10⁻³⁰⁰ to the middle, and rational ones.
    #[test]
    fn quotients_of_sines_are_enclosed_within_three_ulp() {
        let precision = Precision::new(256);
        let ratio = |p: u64, q: u64| BigRational::new(p.into(), q.into());
        let tiny = |e: u32| BigRational::new(1.into(), BigInt::from(10).pow(e));
        let mut points: Vec<BigRational> = (1..200).map(|i| ratio(i * 7919, 2 * 199 * 7907)).collect();
        for (base, e) in [(0, 300), (0, 20), (3, 18), (3, 150), (4, 9), (4, 60), (6, 12), (6, 200), (1, 30)] {
            points.extend([ratio(base, 12) + tiny(e), ratio(base, 12) - tiny(e)]);
        }
        let mut exact = 0;
        for s in points.into_iter().chain((1..24).map(|i| ratio(i, 24))) {
            let angle = Angle::new(&s);
            for (j, k) in [(1, 1), (1, 2), (2, 1), (2, 3), (5, 7), (37, 63)] {
                let sum = angle.times(j + k);
                let pair = [&angle.times(j), &angle.times(k)];
                let found = sines_over_cosine(pair, &sum);
                if sum.complement().sin_sign() == crate::Sign::Zero {
                    assert_eq!(found, FloatInterval::WHOLE);
                    continue;
                }
                let ball = Ball::sines_over_cosine(pair, &sum, &precision);
                let (low, high) = ball.exact_bounds().unwrap();
                let (lo, hi) = found.exact_bounds().unwrap();
                assert!(lo <= high && low <= hi, "s = {s}, {j}, {k}: {found:?}, {ball:?}");
                if lo == hi {
                    exact += 1;
                } else {
                    assert!(lo <= low && high <= hi, "s = {s}, {j}, {k}: {found:?}, {ball:?}");
                    // Below the floats an end is 0.
                    let ulp = found.hi().abs().next_up() - found.hi().abs();
                    let near = found.hi() - found.lo() <= 3.0 * ulp;
                    assert!(near || high.abs() < two_to(1) / two_to(1023), "s = {s}, {j}, {k}: {found:?}");
                }
            }
        }
        assert!(exact > 10, "rational quotients are points: {exact}");
    }

    /// m ± error across 2⁶⁴, where the upper end is halved, and across 2¹⁰²⁴, where it is infinite.
    #[test]
    fn enclosures_carry_outwards() {
        for (m, error) in
            [(u64::MAX, 2), (u64::MAX, 1), (u64::MAX - 1, 3), (u64::MAX, 4096), (u64::MAX, 1 << 20)]
        {
            for e in [-200, 0, 900, 958, 959, 960, 961] {
                let scaled =
                    |x: BigInt| BigRational::from_integer(x) * two_to((e + 200) as usize) / two_to(200);
                let found = enclose(m, error, e);
                let ends = [BigInt::from(m) - error, BigInt::from(m) + error].map(scaled);
                assert!(ends.iter().all(|end| found.contains(end)), "{m:#x} ± {error}, 2^{e}: {found:?}");
            }
        }
    }
}
