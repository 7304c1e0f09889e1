//! The sign of b_{n,k} by (59) as it stands: a second route, which shares no formula, form or decision with
//! the ladder.
//!
//! From (a₁, a₂), u_1, …, u_n by their recurrence; from (r, s), the powers of λ = r e^{2πis} by complex
//! products, with sin and cos of the number 2πs rather than of a rational multiple of π. First in `i128` with
//! a fixed point, which shares nothing with the ladder, not even its arithmetic. What that leaves open is
//! tried in balls and, from (a₁, a₂), decided in integers; there the arithmetic of balls is shared, and the
//! power series that both kinds of sine sum up.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Zero, pow};

use crate::{
    existence::fixed_point,
    local::{Answer, Ladder, Plane, Point, Polar},
    number::{Ball, Elementary, Precision, Real, Sign},
};

/// The sign of b_{n,k}, 1 ≤ k < n; a zero is found from (a₁, a₂), and on r = 1. Only the precisions are the
/// ladder's.
///
/// Cost: from (a₁, a₂), O(n) products of machine integers, and, if need be, of balls and of integers; from
/// (r, s), O(log n) products, of machine integers and of balls on each rung that is needed.
pub(super) fn sign(ladder: &Ladder, point: &Point, n: u64, k: u64) -> Answer {
    match point {
        Point::Plane(plane) => fixed_point::plane_sign(plane, n, k)
            .map(Answer::Sign)
            .or_else(|| by_balls(ladder, plane, n, k))
            .unwrap_or_else(|| by_integers(plane, n, k)),
        Point::Polar(polar) => from_polar(ladder, polar, n, k),
    }
}

/// N_{n,k} = u_n − u_k − a₂^k u_{n−k} on the second rung of balls: a step of the recurrence costs up to
/// log₂(1 + √2) bits, for |a₁| ≤ 2 and a₂ ≤ 1.
fn by_balls(ladder: &Ladder, plane: &Plane, n: u64, k: u64) -> Option<Answer> {
    let precision = ladder.precisions().nth(1)?;
    let [a1, a2] = [plane.a1(), plane.a2()].map(|x| Ball::ratio(x, precision));
    let integer = |i| Ball::integer(i, precision);
    let (mut before, mut u, mut power) = (integer(0), integer(1), integer(1));
    let (mut at_k, mut at_j) = (None, None);
    for i in 1..=n {
        if i == n - k {
            at_j = Some(u.clone());
        }
        if i <= k {
            power = power * &a2;
        }
        if i == k {
            at_k = Some(u.clone());
        }
        if i < n {
            let next = a1.clone() * &u - &(a2.clone() * &before);
            before = std::mem::replace(&mut u, next);
        }
    }
    let numerator = u.clone() - &at_k? - &(power * &at_j?);
    Some(Answer::Sign(u.sign()? * numerator.sign()?))
}

/// With W_i = D^{i−1} u_i, a₁ = A/D, a₂ = B/D²: D^{n+k−1} N_{n,k} = D^k W_n − Dⁿ W_k − B^k W_{n−k}.
fn by_integers(plane: &Plane, n: u64, k: u64) -> Answer {
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
    let whole = |j: u64| (polar.s().numer() * j % polar.s().denom()).is_zero();
    if whole(2 * n) {
        return Answer::Singular;
    }
    // (B1): on r = 1 only a zero of sin kπs or sin (n−k)πs is one of b.
    if polar.on_circle() && (whole(k) || whole(n - k)) {
        return Answer::Sign(Sign::Zero);
    }
    if let Some(sign) = fixed_point::polar_sign(polar, n, k) {
        return Answer::Sign(sign);
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
    let times = |(a, b): &(Ball, Ball), (c, d): &(Ball, Ball)| {
        (a.clone() * c - &(b.clone() * d), a.clone() * d + &(b.clone() * c))
    };
    let mut square = (r.clone() * &cos, r * &sin);
    // λ^{2^i}, of which every power is a product.
    let squares: Vec<_> = (0..64 - n.leading_zeros())
        .map(|_| {
            let next = times(&square, &square);
            std::mem::replace(&mut square, next)
        })
        .collect();
    let power = |j: u64| {
        let bits = (0..).zip(&squares).filter(|(bit, _)| j >> bit & 1 == 1).map(|(_, square)| square);
        bits.cloned().reduce(|product, square| times(&product, &square)).expect("j is at least 1")
    };
    let (at_k, at_j) = (power(k), power(n - k));
    let (_, un) = times(&at_k, &at_j);
    // r^{2k} = |λ^k|².
    let weight = at_k.0.clone() * &at_k.0 + &(at_k.1.clone() * &at_k.1);
    let numerator = un.clone() - &at_k.1 - &(weight * &at_j.1);
    [un, numerator]
}
