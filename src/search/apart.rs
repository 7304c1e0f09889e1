//! The sign of b_{n,k} by (59) as it stands: a second route, which shares no formula, form or decision with
//! the ladder.
//!
//! From (a₁, a₂), u_1, …, u_n by their recurrence, in integers. From (r, s), the powers of λ = r e^{2πis} by
//! complex products of balls, with sin and cos of the enclosed number 2πs rather than of a rational multiple
//! of π. Shared are the arithmetic of balls and the power series that both kinds of sine sum up.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Zero, pow};

use crate::{
    local::{Answer, Ladder, Plane, Point, Polar},
    number::{Ball, Elementary, Precision, Real, Sign},
};

/// The sign of b_{n,k}, 1 ≤ k < n; a zero is found from (a₁, a₂), and on r = 1. Only the precisions are the
/// ladder's.
///
/// Cost: from (a₁, a₂), n products of integers; from (r, s), O(log n) products of balls on each rung that is
/// needed.
pub(super) fn sign(ladder: &Ladder, point: &Point, n: u64, k: u64) -> Answer {
    match point {
        Point::Plane(plane) => from_plane(plane, n, k),
        Point::Polar(polar) => from_polar(ladder, polar, n, k),
    }
}

/// With W_i = D^{i−1} u_i, a₁ = A/D, a₂ = B/D²: D^{n+k−1} N_{n,k} = D^k W_n − Dⁿ W_k − B^k W_{n−k}.
fn from_plane(plane: &Plane, n: u64, k: u64) -> Answer {
    let d = plane.a1().denom().lcm(plane.a2().denom());
    let (a, b) = ((plane.a1() * &d).to_integer(), (plane.a2() * (&d * &d)).to_integer());
    let (mut before, mut w) = (BigInt::ZERO, BigInt::from(1));
    let (mut at_k, mut at_j) = (BigInt::ZERO, BigInt::ZERO);
    for i in 1..=n {
        if i == k {
            at_k.clone_from(&w);
        }
        if i == n - k {
            at_j.clone_from(&w);
        }
        if i < n {
            let next = &a * &w - &b * &before;
            before = std::mem::replace(&mut w, next);
        }
    }
    if w.is_zero() {
        return Answer::Singular;
    }
    let power = |x: &BigInt, e: u64| pow(x.clone(), e as usize);
    let numerator = power(&d, k) * &w - power(&d, n) * at_k - power(&b, k) * at_j;
    Answer::Sign(Sign::from(&numerator) * Sign::from(&w))
}

fn from_polar(ladder: &Ladder, polar: &Polar, n: u64, k: u64) -> Answer {
    let whole = |j: u64| (polar.s() * BigRational::from_integer(j.into())).is_integer();
    if whole(2 * n) {
        return Answer::Singular;
    }
    // (B1): on r = 1 only a zero of sin kπs or sin (n−k)πs is one of b.
    if polar.on_circle() && (whole(k) || whole(n - k)) {
        return Answer::Sign(Sign::Zero);
    }
    for precision in ladder.precisions() {
        let [un, numerator] = parts(polar, n, k, precision);
        if let (Some(u), Some(numerator)) = (un.sign(), numerator.sign()) {
            return Answer::Sign(u * numerator);
        }
    }
    Answer::Undecided
}

/// Im λⁿ and Im λⁿ − Im λ^k − r^{2k} Im λ^{n−k}: u_n and N_{n,k} times r sin 2πs > 0.
fn parts(polar: &Polar, n: u64, k: u64, precision: &Precision) -> [Ball; 2] {
    let ball = |x: &BigRational| Ball::ratio(x, precision);
    let angle = Ball::pi(precision) * &ball(&(polar.s() + polar.s()));
    let (sin, cos) = angle.sin_cos(precision);
    let r = ball(polar.r());
    let lambda = (r.clone() * &cos, r.clone() * &sin);
    let times = |(a, b): &(Ball, Ball), (c, d): &(Ball, Ball)| {
        (a.clone() * c - &(b.clone() * d), a.clone() * d + &(b.clone() * c))
    };
    let imaginary = |j: u64| {
        let one = (Ball::integer(1, precision), Ball::integer(0, precision));
        let (_, y) = (0..64 - j.leading_zeros()).rev().fold(one, |power, bit| {
            let square = times(&power, &power);
            if j >> bit & 1 == 1 { times(&square, &lambda) } else { square }
        });
        y
    };
    let square = r.clone() * &r;
    let weight = (0..64 - k.leading_zeros()).rev().fold(Ball::integer(1, precision), |power, bit| {
        let doubled = power.clone() * &power;
        if k >> bit & 1 == 1 { doubled * &square } else { doubled }
    });
    let un = imaginary(n);
    let numerator = un.clone() - &imaginary(k) - &(weight * &imaginary(n - k));
    [un, numerator]
}
