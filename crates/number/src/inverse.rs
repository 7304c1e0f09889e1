//! log and atan of points: power series about a guess that need not be right.
//!
//! With E = e^y for any y, log x = y + 2 artanh((x − E)/(x + E)); with s = sin y and c = cos y, atan x = y +
//! atan((xc − s)/(c + xs)) for |y| and |atan x| ≤ π/4. Both are identities, and every term is a ball: a bad y
//! costs terms of the series, or leaves nothing known, never truth. The y is the midpoint of the same
//! function's value to an eighth of the bits; where few terms are needed anyway, there is none. Cost: that of
//! exp or sin, and O(√b) products more for b bits.
//!
//! # The series
//!
//! artanh z = z·S, S = Σ z^2i/(2i + 1), and atan z = z·S with alternating signs; |z| ≤ 1/4. S is summed in
//! units of 2^−w for z² cut by less than 1 unit. A power P_i ≤ 1/16 is off by e_i, e_1 < 1 and e_(i+1) ≤ 1 +
//! P_i + e_i/16 < 1.2, where P_i weighs z²'s error. So a term is off by less than 1.2/3 + 1 < 2, and n of
//! them by less than 2n. The first power that is cut to 0 is below 2.2 units, and the tail behind it,
//! geometric with 1/16 and divided by 3 or more, below 1. Where z is a ball of radius r, S at its midpoint
//! lies between 0.97 and 1.03 and the slope of artanh and atan over it between 0.93 and 1.07: the product's
//! radius, r·S at least, and r/8 more cover the slope.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use super::{
    Ball, Elementary, Precision, Real, Sign,
    elementary::{GUARD, point_exp, series_sin_cos, shifted},
    radius::Radius,
};

/// The most bits that a series gives for each bit of −log₂ |z|: 32 terms.
const DIRECT: i64 = 64;

/// artanh z, or atan z if `alternating`, for |z| ≤ 1/4, relative error below 2^−`bits` besides z's own;
/// beyond that nothing is known.
fn arc(z: &Ball, bits: u32, alternating: bool) -> Ball {
    if !z.greatest_magnitude().is_within(-2) {
        return Ball::whole(bits);
    }
    let w = i128::from(bits) + 16;
    let square = shifted(z.mid() * z.mid(), 2 * z.unit_exponent() + w);
    let (mut sum, mut power, mut n) = (BigInt::one() << w, square.clone(), 1u32);
    while !power.is_zero() {
        let term = &power / (2 * n + 1);
        if alternating && n % 2 == 1 {
            sum -= term;
        } else {
            sum += term;
        }
        power = (power * &square) >> w;
        n += 1;
    }
    let sum = Ball::new(sum, -w, Radius::new(2 * u64::from(n) + 2, -w), bits + 16);
    (z.clone() * &sum).widened(z.radius() * Radius::new(1, -3))
}

/// log x of a point x > 0, to `bits` bits, at most 96 more than the context has.
pub(super) fn log(x: &Ball, context: &Precision, bits: u32) -> Ball {
    let (w, e) = (bits + GUARD, x.exponent().unwrap_or(0));
    // x = (1 + u)·2^k with −5/16 ≤ u ≤ 3/8, so that no sum with k ln 2 cancels.
    let exact = x.clone().cut(w.max(x.bits() + 2));
    let less = |k: i64| exact.scaled(-i128::from(k)) - &Ball::integer_at(1, w);
    let (k, u) = match less(e) {
        u if (u.clone() + &Ball::new(5.into(), -4, Radius::ZERO, w)).sign() == Some(Sign::Negative) => {
            (e - 1, less(e - 1))
        }
        u => (e, u),
    };
    let part = log1p(&u, bits);
    if k == 0 {
        return part.cut(bits);
    }
    (context.ln_2_at(w) * &Ball::new(k.into(), 0, Radius::ZERO, 64) + &part).cut(bits)
}

/// log(1 + u) of a point, −5/16 ≤ u ≤ 3/8, to somewhat more than `bits` bits.
pub(super) fn log1p(u: &Ball, bits: u32) -> Ball {
    let Some(e) = u.exponent() else { return u.clone() };
    // |u| < 2^−small, and z = u/(2 + u) is below 1/5 and about half of u.
    let small = (-e).max(2);
    let w = bits + GUARD;
    if i64::from(bits) <= DIRECT.saturating_mul(small) {
        let u = u.clone().cut(w);
        return arc(&(u.clone() / &(u + &Ball::integer_at(2, w))), w, false).scaled(1);
    }
    // What the result has less than 1.
    let w = w + small as u32;
    let guess = log1p(&u.clone().cut(bits / 8 + GUARD).centre(), bits / 8).centre();
    let (x, power) = (u.clone().cut(w) + &Ball::integer_at(1, w), point_exp(&guess, w));
    guess.cut(w) + &arc(&((x.clone() - &power) / &(x + &power)), w, false).scaled(1)
}

/// atan x of a point, to the context's bits.
pub(super) fn atan(x: &Ball, context: &Precision) -> Ball {
    let bits = context.bits();
    if x.exponent().is_none_or(|e| e <= 0) {
        return small_atan(x, bits).cut(bits);
    }
    // |x| ≥ 1: ±π/2 − atan 1/x, at least π/4.
    let quarter = context.pi_at(bits + GUARD).scaled(-1);
    let rest = small_atan(&(Ball::integer_at(1, bits + GUARD) / x), bits);
    let right = if x.sign() == Some(Sign::Negative) { -quarter } else { quarter };
    (right - &rest).cut(bits)
}

/// atan x of a point |x| ≤ 1, or a ball as narrow as one that was cut, to somewhat more than `bits` bits.
fn small_atan(x: &Ball, bits: u32) -> Ball {
    let Some(e) = x.exponent() else { return x.clone() };
    let small = (-e).max(3);
    let w = bits + GUARD;
    if i64::from(bits) <= DIRECT.saturating_mul(small) {
        // atan x = 2 atan(x/(1 + √(1 + x²))): 1, 0.414…, 0.198…, 0.0985… < 1/8.
        let (mut x, mut halvings) = (x.clone().cut(w), 0);
        let one = Ball::integer_at(1, w);
        while x.exponent().is_some_and(|e| e > -3) {
            x = x.clone() / &(one.clone() + &(one.clone() + &(x.clone() * &x)).sqrt());
            halvings += 1;
        }
        return arc(&x, w, true).scaled(halvings);
    }
    let w = w + small as u32;
    let guess = small_atan(&x.clone().cut(bits / 8 + GUARD).centre(), bits / 8).centre();
    let (x, (sin, cos)) = (x.clone().cut(w), series_sin_cos(&guess, w));
    let off = (x.clone() * &cos - &sin) / &(cos + &(x * &sin));
    guess.cut(w) + &arc(&off, w, true)
}
