//! exp, sin, cos and √ of enclosed numbers. On balls by integers alone: argument reduction, then power
//! series.
//!
//! A wide argument is right too: the result's radius bounds how far the function moves over the whole ball.
//! Sines of exact multiples of π, which are tighter and faster, live in `ball_sine`.

use num_bigint::BigInt;
use num_integer::{Integer, Roots};
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{
    Ball, Plain, Precision, Real, Sign,
    ball_sine::{SERIES_ERROR, limbs_for, pi, series},
    radius::Radius,
};

/// A rung with the elementary functions of its own numbers.
///
/// ```
/// use grazing_number::{Ball, Elementary, FloatInterval, Precision, Real};
/// let bits = Precision::new(128);
/// let two = Ball::integer(2, &bits);
/// let (sin, cos) = two.sin_cos(&bits);
/// assert_eq!(format!("{sin:.9}, {cos:.9}"), "[0.909297427 +/- 1e-9], [-0.416146837 +/- 1e-9]");
/// assert_eq!(format!("{:.20}", two.exp(&bits)), "[7.3890560989306502272 +/- 1e-19]");
/// assert_eq!(format!("{:.20}", two.sqrt()), "[1.4142135623730950488 +/- 1e-19]");
/// let root = FloatInterval::integer(2, &()).sqrt();
/// assert_eq!((root.lo(), root.hi()), (1.414213562373095, 1.4142135623730951));
/// assert_eq!(FloatInterval::pi(&()).exact_text(), "[884279719003555/2^48, 7074237752028441/2^51]");
/// ```
pub trait Elementary: Real {
    /// π.
    fn pi(context: &Self::Context) -> Self;

    /// e^x for every enclosed x.
    #[must_use]
    fn exp(&self, context: &Self::Context) -> Self;

    /// sin x and cos x for every enclosed x.
    fn sin_cos(&self, context: &Self::Context) -> (Self, Self);

    /// √x for every enclosed x; nothing is known of the result if an enclosed x may be negative.
    #[must_use]
    fn sqrt(&self) -> Self;
}

/// No guarantee: the platform's own functions.
impl Elementary for Plain {
    fn pi((): &()) -> Plain {
        Plain(std::f64::consts::PI)
    }

    fn exp(&self, (): &()) -> Plain {
        Plain(self.0.exp())
    }

    fn sin_cos(&self, (): &()) -> (Plain, Plain) {
        let (sin, cos) = self.0.sin_cos();
        (Plain(sin), Plain(cos))
    }

    fn sqrt(&self) -> Plain {
        Plain(self.0.sqrt())
    }
}

/// Bits beyond the working precision in a series.
pub(super) const GUARD: u32 = 32;

/// Sines and cosines of arguments beyond 2^4096 are answered by ±1: π to as many bits would be needed.
const FAR: i64 = 4096;

/// For b bits: width at most 3 times that of the correctly rounded enclosure for a point, and for wide
/// arguments at most 1 + 2⁻⁸ times the width of the true range more. Cost: O(√b) products of b bits for exp,
/// sin and cos.
impl Elementary for Ball {
    fn pi(context: &Precision) -> Ball {
        context.pi_at(context.bits())
    }

    /// Positive for every x > −2⁶¹; from 2⁶² on nothing is known.
    fn exp(&self, context: &Precision) -> Ball {
        exp(self, context.bits())
    }

    fn sin_cos(&self, context: &Precision) -> (Ball, Ball) {
        let (bits, radius) = (context.bits(), self.radius());
        let anything = Ball::zero(bits).widened(Radius::one());
        if self.exponent().is_some_and(|e| e > FAR) || !radius.is_within(2) {
            return (anything.clone(), anything);
        }
        let (sin, cos) = point_sin_cos(&self.centre(), context);
        let (sin, cos) = (sin.cut(bits), cos.cut(bits));
        // |sin(m+δ) − sin m| ≤ r and ≤ |cos m| r + r²/2; from 1 on, [−1, 1] says more.
        let widen = |value: &Ball, slope: &Ball| {
            let curved = radius * slope.greatest_magnitude() + radius * radius * Radius::new(1, -1);
            let change = if curved.is_below(radius) { curved } else { radius };
            if change.is_below(Radius::one()) { value.clone().widened(change) } else { anything.clone() }
        };
        (widen(&sin, &cos), widen(&cos, &sin))
    }

    fn sqrt(&self) -> Ball {
        let (mid, exp, radius) = (self.mid(), self.unit_exponent(), self.radius());
        let bits = self.bits();
        let least = match self.sign() {
            Some(Sign::Zero) => return self.clone(),
            Some(Sign::Positive) => self.least_magnitude(),
            _ => None,
        };
        let Some((least, least_exp)) = least else {
            // From 0 on, √x is too.
            let high = self.ends().filter(|_| self.is_from_zero_on());
            return high.map_or(Ball::whole(bits), |[_, high]| Ball::zero(bits).hull(&high.cut(bits).sqrt()));
        };
        // √(m·2^e), e made even, to at least bits + 1 bits: the integer root is cut by less than 1.
        let shift = (2 * i128::from(bits) + 2 - mid.bits() as i128).max(0);
        let shift = shift + (exp - shift).rem_euclid(2);
        let shifted = mid << shift;
        let root = shifted.sqrt();
        let root_exp = (exp - shift) / 2;
        let mut error = if &root * &root == shifted { Radius::ZERO } else { Radius::new(1, root_exp) };
        if !radius.is_zero() {
            // |√(m+δ) − √m| ≤ r/(2√(m−r)), and 2³¹ ≤ least < 2³² makes the integer root of least·2³¹ or 2³²
            // fit.
            let even = 31 + (least_exp - 31).rem_euclid(2);
            error = error + radius.over((least << even).sqrt(), (least_exp - even) / 2 + 1);
        }
        Ball::new(root, root_exp, error, bits)
    }
}

/// e^x to `bits` bits for every enclosed x.
pub(super) fn exp(x: &Ball, bits: u32) -> Ball {
    let radius = x.radius();
    if radius.is_zero() {
        return point_exp(x, bits);
    }
    if !radius.is_within(-10) {
        // Too wide for one slope; e^x rises, so that the end points bound it.
        let ends = x.ends().map(|ends| ends.map(|end| point_exp(&end, bits)));
        return ends.map_or(Ball::whole(bits), |[low, high]| low.hull(&high));
    }
    // |e^(m+δ) − e^m| ≤ e^m (e^r − 1) ≤ e^m r (1 + r) for r < 1.
    let value = point_exp(&x.centre(), bits);
    let change = value.greatest_magnitude() * radius * (Radius::one() + radius);
    value.widened(change).without_negatives()
}

/// e^x of a point: e^|x| = (e^(|x|/2^k))^(2^k), |x|/2^k ≤ 2^−j for a j ≈ ∛bits, j ≥ 2.
pub(super) fn point_exp(x: &Ball, bits: u32) -> Ball {
    let Some(exponent) = x.exponent() else { return Ball::integer_at(1, bits) };
    let negative = x.sign() == Some(Sign::Negative);
    if exponent > 62 {
        // Below the least number of all, or beyond all.
        let tiny = || Ball::zero(bits).widened(Radius::new(1, i128::MIN / 2)).without_negatives();
        return if negative { tiny() } else { Ball::whole(bits) };
    }
    let j = bits.cbrt();
    let k = (exponent + i64::from(j)).max(0) as u32;
    // Each squaring doubles the relative error.
    let w = bits + GUARD + k;
    let t = shifted(x.mid().magnitude().clone().into(), x.unit_exponent() - i128::from(k) + i128::from(w));
    let mut value = Ball::new(exp_series(&t, w), -i128::from(w), Radius::new(EXP_ERROR, -i128::from(w)), w);
    if negative {
        value = Ball::integer_at(1, w) / &value;
    }
    for _ in 0..k {
        value = value.clone() * &value;
    }
    // Below the least number of all a power is 0 with a radius.
    let value = value.cut(bits);
    if value.exponent().is_none() { value.without_negatives() } else { value }
}

/// The error bound of [`exp_series`], in its last place.
const EXP_ERROR: u64 = 16;

/// Σ t^i/i! in units of 2^−w, for 0 ≤ t ≤ 1/4, cut by less than 1; all cuts go down. Within [`EXP_ERROR`].
///
/// By blocks of m ≈ √N of the N terms, as `ball_sine::series`: `sum` counts in units of 1/(1·2⋯j) for a j
/// that falls whenever the product `scale` = (i + 1)⋯j would outgrow a word.
///
/// Errors: a power is off by e ≤ 1 + e/4 + 1/4, below 1.7, t itself by 1, and the powers weigh at most 1/1! +
/// 1/2! + … < 1.72: below 3. A product by t^m loses 1 and, the sum being below 2 in its unit, less than 4 for
/// the power; its unit is 1/i!, i = m, 2m, …, m ≥ 2: together below 5(1/2! + 1/4! + …) < 3. The last division
/// loses 1, others 1 in a unit below 1/20!, and the tail, whose first term is below 1, less than 2.
fn exp_series(t: &BigInt, w: u32) -> BigInt {
    // t < 2^−small; t^i/i! < 2^−w ends the sum.
    let small = u64::from(w).saturating_sub(t.bits());
    let (mut terms, mut reached) = (1u64, 0);
    while reached <= u64::from(w) {
        reached += small + u64::from(terms.ilog2());
        terms += 1;
    }
    let m = terms.sqrt().max(2) as usize;
    let mut powers = vec![BigInt::one() << w, t.clone()];
    for j in 1..m {
        powers.push((&powers[j] * t) >> w);
    }
    let (mut sum, mut scale) = (BigInt::zero(), 1u64);
    for i in (0..terms).rev() {
        let place = (i % m as u64) as usize;
        sum += &powers[place] * scale;
        if i == 0 {
            break;
        }
        if place == 0 {
            sum = (sum * &powers[m]) >> w;
        }
        if scale.checked_mul(i).is_none() {
            sum /= scale;
            scale = 1;
        }
        scale *= i;
    }
    sum / scale
}

/// sin x and cos x of a point, to `GUARD` bits more than the context has.
pub(super) fn point_sin_cos(x: &Ball, context: &Precision) -> (Ball, Ball) {
    let bits = context.bits();
    if x.sign() == Some(Sign::Zero) {
        return (Ball::zero(bits), Ball::integer_at(1, bits));
    }
    let v = 64 * limbs_for(bits + GUARD) as u32;
    let (quadrant, t) = reduced(x, v, context);
    let (sin, cos) = series_sin_cos(&t, bits);
    match quadrant {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// sin t and cos t to `bits` + [`GUARD`] bits for a |t| ≤ π/4 + 2⁻²⁰ known within 2^(−v−4).
pub(super) fn series_sin_cos(t: &Ball, bits: u32) -> (Ball, Ball) {
    let length = limbs_for(bits + GUARD);
    let v = 64 * length as u32;
    // |t| cut to v bits, within 1.01; its square within 2·0.79·1.01 + 1 < 4 and below 0.617.
    let cut = shifted(t.mid().abs(), t.unit_exponent() + i128::from(v));
    let y = (&cut * &cut) >> v;
    let fixed = |first| {
        Ball::new(
            series(&y, length, first),
            -i128::from(v),
            Radius::new(SERIES_ERROR, -i128::from(v)),
            bits + GUARD,
        )
    };
    (fixed(1) * t, fixed(0))
}

/// n mod 4 and t = x − nπ/2 with |t| ≤ π/4 + 2^−v, within 2^(−v−4) and relative error below 2^−(bits + 32),
/// for x ≠ 0.
fn reduced(x: &Ball, v: u32, context: &Precision) -> (u8, Ball) {
    let Some(exponent @ 0..) = x.exponent() else { return (0, x.clone()) };
    let good = context.bits() + GUARD;
    // In units of 2^−w: x is cut by less than 1, π known within 3, n < 2^(exponent + 1).
    let lost = exponent as u32 + 4;
    let mut w = v + 8 + lost;
    loop {
        let pi = if w <= context.pi_bits() { &context.pi >> (context.pi_bits() - w) } else { pi(w) };
        let x = shifted(x.mid().clone(), x.unit_exponent() + i128::from(w));
        let n: BigInt = (&x * 4i32 + &pi).div_floor(&(&pi * 2i32));
        let twice: BigInt = x * 2i32 - &n * pi;
        let deficit = i64::from(good + lost) - twice.bits() as i64;
        if deficit <= 0 {
            let quadrant = n.mod_floor(&4.into()).to_u8().unwrap_or(0);
            let scale = -i128::from(w) - 1;
            return (quadrant, Ball::new(twice, scale, Radius::new(1, scale + i128::from(lost)), w + lost));
        }
        // x is near a multiple of π/2, but no rational other than 0 is one.
        w += deficit as u32;
    }
}

/// ⌊x·2^e⌋.
pub(super) fn shifted(x: BigInt, e: i128) -> BigInt {
    if e >= 0 { x << e } else { x >> -e }
}
