//! The record form at one point by floats alone: what arrays of points are classified by first.
//!
//! With f_j = u_j/(2 − v_j), period n has an orbit iff f_n is a strict record of f_1, …, f_n
//! ([`by_records`](super::by_records)). Here u_j and v_j come from one enclosure each of a₁ and a₂; where a
//! sign or a comparison is not certain nothing is said, and the exact point decides.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Case, Existence};
use crate::number::{FloatInterval, Sign};

/// A real number within `off` of `at`. Both are floats; each operation rounds to nearest, within 2⁻⁵³ of its
/// result or, below the normal numbers, within 2⁻¹⁰⁷⁵. What is computed for `off` takes at most eight such
/// operations on numbers that are not negative, so that [`SLACK`] covers their rounding, and [`TINY`] what
/// underflows. An overflow makes `off` infinite or no number, and then [`sign`](Near::sign) tells nothing.
#[derive(Clone, Copy)]
struct Near {
    at: f64,
    off: f64,
}

const HALF_UNIT: f64 = f64::EPSILON / 2.0;
/// 1 + 2⁻⁴⁹.
const SLACK: f64 = 1.0 + 8.0 * f64::EPSILON;
/// 2⁻¹⁰⁰⁰.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

impl Near {
    fn exact(at: f64) -> Near {
        Near { at, off: 0.0 }
    }

    fn of(x: &FloatInterval) -> Near {
        let at = x.lo() + (x.hi() - x.lo()) / 2.0;
        Near { at, off: (x.hi() - at).max(at - x.lo()) * SLACK + TINY }
    }

    /// The sign, if it is certain and not 0.
    fn sign(self) -> Option<Sign> {
        if self.at > self.off {
            Some(Sign::Positive)
        } else if self.at < -self.off {
            Some(Sign::Negative)
        } else {
            None
        }
    }

    /// The quotient by a number whose sign is certain: |x/y − at/at′| ≤ (off + |at/at′| off′)/(|at′| − off′).
    fn over(self, other: Near) -> Near {
        let (at, least) = (self.at / other.at, (other.at.abs() - other.off) * (2.0 - SLACK));
        let off = (self.off + at.abs() * other.off) / least + at.abs() * HALF_UNIT;
        Near { at, off: off * SLACK + TINY }
    }
}

impl Neg for Near {
    type Output = Near;

    fn neg(self) -> Near {
        Near { at: -self.at, off: self.off }
    }
}

impl Add for Near {
    type Output = Near;

    fn add(self, other: Near) -> Near {
        let at = self.at + other.at;
        Near { at, off: (self.off + other.off + at.abs() * HALF_UNIT) * SLACK + TINY }
    }
}

impl Sub for Near {
    type Output = Near;

    fn sub(self, other: Near) -> Near {
        self + -other
    }
}

impl Mul for Near {
    type Output = Near;

    fn mul(self, other: Near) -> Near {
        let at = self.at * other.at;
        let off = self.at.abs() * other.off + self.off * (other.at.abs() + other.off);
        Near { at, off: (off + at.abs() * HALF_UNIT) * SLACK + TINY }
    }
}

/// Existence for every period 1, …, `last` at every point with a₁ and a₂ in these intervals, as
/// [`up_to`](super::up_to) says it; `None` unless all of it is certain, 0 < a₂ ≤ 1 and |a₁| < a₂ + 1. Cost:
/// some twelve operations on floats with bounds a period.
///
/// ```
/// use grazing::existence::{Existence, by_enclosures};
/// use grazing::number::FloatInterval;
/// let [a1, a2] = [0.5, 0.9].map(|x| FloatInterval::from_bounds(x, x));
/// let found = by_enclosures(&a1, &a2, 5).expect("no boundary is near");
/// assert_eq!(found[4].to_string(), "no orbit: b_{n,4} > 0 > b_{n,1}");
/// // u_2 = a₁ = 0.
/// assert_eq!(by_enclosures(&FloatInterval::from_bounds(0.0, 0.0), &a2, 5), None);
/// ```
pub fn by_enclosures(a1: &FloatInterval, a2: &FloatInterval, last: u64) -> Option<Vec<Existence>> {
    let is_inside = a2.lo() > 0.0 && a2.hi() <= 1.0;
    let (a1, a2) = (Near::of(a1), Near::of(a2));
    let one = Near::exact(1.0);
    let is_positive = |x: Near| x.sign() == Some(Sign::Positive);
    if !is_inside {
        return None;
    }
    // Regions 1 and 5: every b_{n,k} > 0, and c_n has the sign of a₁ (`Region1` and `Region5` of appendix A).
    for (beyond, case) in [(a1, Case::PlusPlus), (-a1, Case::PlusMinus)] {
        if is_positive(beyond - (a2 + one)) {
            return Some(vec![Existence::Orbit(case); last as usize]);
        }
    }
    if !(is_positive(a2 + one - a1) && is_positive(a2 + one + a1)) {
        return None;
    }
    // u_n, v_n and a₂ⁿ, each from those of half its index, so that errors do not double at every step.
    let mut all: Vec<[Near; 3]> = Vec::with_capacity(last as usize + 1);
    all.extend([[Near::exact(0.0), Near::exact(2.0), one], [one, a1, a2]]);
    let mut found = Vec::with_capacity(last as usize);
    // f_1 > 0: c_1 < 0.
    found.push(Existence::Orbit(Case::PlusMinus));
    let first = one.over(Near::exact(2.0) - a1);
    let (mut highest, mut lowest) = ((1, first), (1, first));
    for n in 2..=last {
        let half = n as usize / 2;
        let [u, v, power] = all[half];
        let [u, v, power] = if n % 2 == 0 {
            [u * v, v * v - power - power, power * power]
        } else {
            let [next_u, next_v, _] = all[half + 1];
            [next_u * v - power, v * next_v - a1 * power, power * power * a2]
        };
        all.push([u, v, power]);
        let rest = Near::exact(2.0) - v;
        let is_positive_f = u.sign()? == Sign::Positive;
        if rest.sign()? != Sign::Positive {
            return None;
        }
        let f = u.over(rest);
        found.push(match ((f - highest.1).sign()?, (f - lowest.1).sign()?) {
            (Sign::Positive, _) => {
                highest = (n, f);
                Existence::Orbit(Case::from_signs(is_positive_f, !is_positive_f))
            }
            (_, Sign::Negative) => {
                lowest = (n, f);
                Existence::Orbit(Case::from_signs(!is_positive_f, !is_positive_f))
            }
            _ if is_positive_f => Existence::None { positive: lowest.0, negative: highest.0 },
            _ => Existence::None { positive: highest.0, negative: lowest.0 },
        });
    }
    Some(found)
}
