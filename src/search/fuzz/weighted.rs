//! Points where the conjecture could fail, or its evaluation: near boundaries, ends, equal eigenvalues, r
//! = 1.

use std::ops::RangeInclusive;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{
    Instance,
    random::{fraction, tiny},
};
use crate::{
    existence::intervals,
    local::{Answer, Ladder, Plane, Point, Polar, Quantity},
    number::{Angle, Circular, FloatInterval, Real, Sign},
    random::Random,
};

fn ratio(p: u64, q: u64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

/// A case of a family chosen at random, mostly with a period in range; `None` if the choice fell outside the
/// region meant.
pub(super) fn case(random: &mut Random, ladder: &Ladder, periods: RangeInclusive<u64>) -> Option<Instance> {
    let last = *periods.end();
    let n = random.within(*periods.start(), last);
    match random.within(0, 9) {
        0 => polar(n, near_one(random), fraction(random) / BigInt::from(2)),
        1 => {
            let s = near_multiple(random, n, n)?;
            polar(n, modulus(random), s)
        }
        2 => {
            // The ends 1/(2n), (m ± ½)/n of the half-cells.
            let s = near_multiple(random, n, 2 * n)?;
            polar(n, modulus(random), s)
        }
        3 => {
            let s = near_end(random, n)?;
            polar(n, modulus(random), s)
        }
        4 => near_boundary(random, ladder, n.max(3)),
        5 => {
            // gcd(m, n) > 1.
            let g = random.within(2, 6);
            let n = g * random.within(2, (last / g).max(2));
            let s = near_multiple(random, n / g, n / g)?;
            polar(n, modulus(random), s)
        }
        6 => {
            // Near equal eigenvalues: λ², 2λ ± tiny.
            let size = if random.coin() { near_one(random) } else { fraction(random) };
            let lambda = signed(random, size);
            let shift = if random.within(0, 3) == 0 { BigRational::zero() } else { tiny(random, 1, 100) };
            let a1 = &lambda * BigInt::from(2);
            plane(n, if random.coin() { a1 + shift } else { a1 - shift }, &lambda * &lambda)
        }
        7 => {
            // Near the lines |a₁| = a₂ + 1, inside and outside.
            let a2 = modulus(random);
            let shift = signed_tiny(random);
            let a1 = &a2 + BigRational::one() + shift;
            plane(n, signed(random, a1), a2)
        }
        8 => {
            // Anywhere in the plane, regions 1 and 5 included.
            let a2 = modulus(random);
            let a1 = fraction(random) * BigInt::from(4);
            plane(n, signed(random, a1), a2)
        }
        _ => {
            // Regions 2 and 4: real eigenvalues of one sign.
            let (x, y) = (modulus(random), modulus(random));
            let a1 = &x + &y;
            plane(n, signed(random, a1), x * y)
        }
    }
}

fn polar(n: u64, r: BigRational, s: BigRational) -> Option<Instance> {
    Some(Instance { n, point: Point::Polar(Polar::new(r, s).ok()?) })
}

fn plane(n: u64, a1: BigRational, a2: BigRational) -> Option<Instance> {
    // Beyond a₂ = 1 there is time reversal, tested apart.
    if a2 > BigRational::one() {
        return None;
    }
    Some(Instance { n, point: Point::Plane(Plane::new(a1, a2).ok()?) })
}

fn signed(random: &mut Random, x: BigRational) -> BigRational {
    if random.coin() { -x } else { x }
}

fn signed_tiny(random: &mut Random) -> BigRational {
    let tiny = tiny(random, 1, 100);
    signed(random, tiny)
}

fn near_one(random: &mut Random) -> BigRational {
    BigRational::one() - tiny(random, 3, 120)
}

/// r in (0, 1]: anything, near 1, near 0, or 1.
fn modulus(random: &mut Random) -> BigRational {
    match random.within(0, 7) {
        0 => BigRational::one(),
        1 => tiny(random, 5, 60),
        2..=4 => near_one(random),
        _ => fraction(random),
    }
}

/// A multiple of 1/q in (0, ½), moved by a tiny amount or not.
fn near_multiple(random: &mut Random, n: u64, q: u64) -> Option<BigRational> {
    if q < 3 {
        return None;
    }
    let s = ratio(random.within(1, q.div_ceil(2) - 1), q);
    Some(if n.is_multiple_of(7) { s } else { s + signed_tiny(random) })
}

/// Near an end of one of Theorem 2's intervals.
fn near_end(random: &mut Random, n: u64) -> Option<BigRational> {
    let all: Vec<_> = intervals(n).ok()?.collect();
    let interval = &all[random.within(0, all.len() as u64 - 1) as usize];
    let end = if random.coin() { interval.left } else { interval.right };
    Some(ratio(*end.numer(), *end.denom()) + signed_tiny(random))
}

/// Near the curve that bounds an area: r bisected towards the sign change of the deciding b_{n,k}, then
/// stopped early.
fn near_boundary(random: &mut Random, ladder: &Ladder, n: u64) -> Option<Instance> {
    let all: Vec<_> = intervals(n).ok()?.filter(|interval| interval.deciding.is_some()).collect();
    let interval = &all[random.within(0, all.len() as u64 - 1) as usize];
    let (left, right) = (
        ratio(*interval.left.numer(), *interval.left.denom()),
        ratio(*interval.right.numer(), *interval.right.denom()),
    );
    let place = ratio(random.within(1, 999), 1000);
    let s = &left + (right - &left) * place;
    let k = interval.deciding?;
    let curve = Curve::new(&s, n, k);
    // r is between low/2^bits and high/2^bits.
    let (mut low, mut high, mut bits) = (0u64, 1u64, 0u32);
    let dyadic = |numerator: u64, bits: u32| BigRational::new(numerator.into(), (1u64 << bits).into());
    for _ in 0..random.within(1, 40) {
        (low, high, bits) = (2 * low, 2 * high, bits + 1);
        let middle = low + 1;
        let sign = curve.sign(middle as f64 / (1u64 << bits) as f64).map_or_else(
            || {
                let point = Point::Polar(Polar::new(dyadic(middle, bits), s.clone()).ok()?);
                Some(ladder.sign(&point, Quantity::B { n, k }).answer)
            },
            |sign| Some(Answer::Sign(sign)),
        );
        match sign? {
            Answer::Sign(Sign::Positive) => high = middle,
            Answer::Sign(Sign::Negative) => low = middle,
            _ => break,
        }
    }
    let r = dyadic(if random.coin() { high } else { low }, bits);
    if r.is_positive() { polar(n, r, s) } else { None }
}

/// The sign of b_{n,k} as a function of r, for one s.
struct Curve {
    n: u64,
    k: u64,
    u: Sign,
    /// sin 2πjs for j = n, n − k, k.
    sines: [FloatInterval; 3],
}

impl Curve {
    fn new(s: &BigRational, n: u64, k: u64) -> Curve {
        let angle = Angle::new(&(s + s));
        let sine = |j| FloatInterval::sin(&angle.times(j), &());
        Curve { n, k, u: angle.times(n).sin_sign(), sines: [n, n - k, k].map(sine) }
    }

    /// The sign at 0 < r < 1, if intervals tell it and it is not zero.
    fn sign(&self, r: f64) -> Option<Sign> {
        let r = FloatInterval::from_bounds(r, r);
        let one = FloatInterval::from_bounds(1.0, 1.0);
        let power = |base: FloatInterval, e: u64| {
            (0..64 - e.leading_zeros()).rev().fold(one, |power, bit| {
                let square = power * &power;
                if e >> bit & 1 == 1 { square * &base } else { square }
            })
        };
        let at_j = power(r, self.n - self.k);
        let at_n = at_j * &power(r, self.k);
        let numerator = at_j * &self.sines[0] - &self.sines[2] - &(at_n * &self.sines[1]);
        let sign = numerator.sign()? * self.u;
        (sign != Sign::Zero).then_some(sign)
    }
}

/// A catalogue of small cases, the simplest first: n ≤ 8, s with a denominator up to 24, a few r.
pub(super) fn small_cases() -> impl Iterator<Item = Instance> {
    let moduli = [(1, 1), (1, 2), (3, 4), (9, 10), (99, 100)];
    (2..=8).flat_map(move |n| {
        (3..=24).flat_map(move |q| {
            let coprime = (1..q.div_ceil(&2)).filter(move |p| q.gcd(p) == 1);
            coprime.flat_map(move |p| {
                moduli.into_iter().filter_map(move |(a, b)| polar(n, ratio(a, b), ratio(p, q)))
            })
        })
    })
}

/// Simpler cases than this one: fewer digits, smaller n; the simplest first.
pub(super) fn simpler(case: &Instance) -> Vec<Instance> {
    let mut all = Vec::new();
    let point = |a: BigRational, b: BigRational| match &case.point {
        Point::Polar(_) => Polar::new(a, b).ok().map(Point::Polar),
        Point::Plane(_) => Plane::new(a, b).ok().map(Point::Plane),
    };
    let (a, b) = match &case.point {
        Point::Polar(polar) => (polar.r(), polar.s()),
        Point::Plane(plane) => (plane.a1(), plane.a2()),
    };
    all.extend((2..case.n).map(|n| Instance { n, point: case.point.clone() }));
    for x in convergents(a) {
        all.extend(point(x, b.clone()).map(|point| Instance { n: case.n, point }));
    }
    for x in convergents(b) {
        all.extend(point(a.clone(), x).map(|point| Instance { n: case.n, point }));
    }
    all
}

/// The fractions on the way to x down the Stern–Brocot tree, the last step of each run and its middle.
fn convergents(x: &BigRational) -> Vec<BigRational> {
    let mut found = Vec::new();
    let (mut a, mut b) = (x.numer().clone(), x.denom().clone());
    let (mut p0, mut q0, mut p, mut q) = (BigInt::zero(), BigInt::one(), BigInt::one(), BigInt::zero());
    while !b.is_zero() {
        let (quotient, rest) = a.div_mod_floor(&b);
        let small = quotient.to_u64().unwrap_or(u64::MAX);
        for run in [1, small / 2, small.saturating_sub(1), small] {
            let (p1, q1) = (&p * run + &p0, &q * run + &q0);
            if !q1.is_zero() && run > 0 {
                found.push(BigRational::new(p1, q1));
            }
        }
        (p0, p) = (p.clone(), &quotient * p + p0);
        (q0, q) = (q.clone(), &quotient * q + q0);
        (a, b) = (b, rest);
    }
    found.retain(|y| y != x);
    found.sort_by_key(|y| y.denom().bits() + y.numer().bits());
    found.dedup();
    found
}
