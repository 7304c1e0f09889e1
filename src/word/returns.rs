//! First-return times to a line, for any complex eigenvalues: one theorem for grazing and border collision.
//!
//! Let A have the eigenvalues r e^{±2πis}, r > 0, 0 < s < ½. Points start on a line ℓ that does not go
//! through 0, and n is a return time where λⁿ takes one of them, for the first time, strictly to the other
//! side of ℓ than 0 is. In the normal form ℓ is x₁ = −1, its points are (−1, p), and the other side is
//! x₁ < −1. With V the periods of the [`Word`] for eµ > 0:
//!
//! - r ≤ 1: the return times are V. The points of an interval never return, if r < 1.
//! - r > 1: they are V, which is that of 1/r, and the next node of the path, after which every point has
//!   returned. (Where the deciding b_{n,k} of that node is zero, one point is left, and returns later.)
//!
//! Along ℓ, from p = −∞ on, come the D's of V in path order, then what is between, then the U's in reverse.
//! The place where the points of n ∈ V end (D) or begin (U) is p_n = (u_{n+1} − 1)/u_n (58).
//!
//! So the areas of Conjecture 1 at r are also the map of these return times at 1/r. They are those of the
//! border-collision normal form with a singular right part and a repelling focus. `proofs/words.md`.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use serde::Serialize;

use super::{Extent, Letter, Vertex, Word, entropy::power};
use crate::{
    error::{Error, Result},
    local::{Point, Region},
    number::{Angle, Ball, Circular, Precision, Real, Sign},
};

/// What makes a return time one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReturnKind {
    /// A period of the word, with this letter.
    Period(Letter),
    /// The node of the path after the word, r > 1.
    Next,
    /// The one point that is left where the next node lies on the boundary of its area, r > 1.
    Left,
    /// These points never return, r ≤ 1.
    Never,
}

/// A piece of the line: its points return first after so many steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReturnPiece {
    /// n; none if they never return.
    pub time: Option<u64>,
    /// m: m/n is its place on the path.
    pub numerator: u64,
    /// Why.
    pub kind: ReturnKind,
    /// The n whose p_n is the left end, none for −∞, and the same of the right end.
    pub ends: [Option<u64>; 2],
}

/// All return times, in the order of their points along the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Returns {
    pieces: Vec<ReturnPiece>,
    whole: bool,
}

impl Returns {
    /// The return times where the eigenvalues have a modulus below, equal to or above 1, from the word for
    /// eµ > 0 at (r, s), above 1 at (1/r, s). Cost: O(L) for L letters.
    ///
    /// # Errors
    /// An input error unless the word is one of complex eigenvalues for eµ > 0 at a point.
    pub fn new(word: &Word, region: Region, modulus: Ordering) -> Result<Returns> {
        if region != Region::Three || !word.is_positive() {
            return Err(Error::input("return times are told for complex eigenvalues, |a1| < 2 sqrt(a2)"));
        }
        let of = |letter: Letter| word.vertices().iter().filter(move |vertex| vertex.letter == letter);
        let (below, above): (Vec<&Vertex>, Vec<&Vertex>) = (of(Letter::D).collect(), of(Letter::U).collect());
        let (lower, upper) = (below.last(), above.last());
        let inner = [lower.map(|v| v.period), upper.map(|v| v.period)];
        let piece = |time: Option<u64>, numerator, kind, ends| ReturnPiece { time, numerator, kind, ends };
        let mut pieces = Vec::new();
        let mut from = None;
        for vertex in &below {
            let n = Some(vertex.period);
            pieces.push(piece(n, vertex.numerator, ReturnKind::Period(Letter::D), [from, n]));
            from = n;
        }
        let next = match word.extent() {
            Extent::Complete { next } => next.map(|n| (n, None)),
            Extent::Boundary { next, deciding } => Some((next, deciding)),
            _ => None,
        };
        let whole = next.is_some() && lower.is_some() && upper.is_some();
        if let (true, Some((next, deciding)), Some(lower), Some(upper)) = (whole, next, lower, upper) {
            let numerator = lower.numerator + upper.numerator;
            debug_assert_eq!(next, lower.period + upper.period);
            if modulus == Ordering::Greater {
                let node = piece(Some(next), numerator, ReturnKind::Next, inner);
                let left = |by: &Vertex| {
                    let end = Some(by.period);
                    let (n, m) = (next + by.period, numerator + by.numerator);
                    piece(Some(n), m, ReturnKind::Left, [end, end])
                };
                match deciding {
                    // p_next = p_upper: that point is left.
                    Some(Letter::D) => pieces.extend([node, left(upper)]),
                    Some(Letter::U) => pieces.extend([left(lower), node]),
                    _ => pieces.push(node),
                }
            } else {
                pieces.push(piece(None, 0, ReturnKind::Never, inner));
            }
        }
        for (index, vertex) in above.iter().enumerate().rev() {
            let (n, to) = (Some(vertex.period), index.checked_sub(1).map(|before| above[before].period));
            pieces.push(piece(n, vertex.numerator, ReturnKind::Period(Letter::U), [n, to]));
        }
        Ok(Returns { pieces, whole })
    }

    /// The pieces from p = −∞ to p = ∞. If the word was cut, what lies between is missing.
    pub fn pieces(&self) -> &[ReturnPiece] {
        &self.pieces
    }

    /// Whether nothing is missing.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// The return times, in increasing order.
    pub fn times(&self) -> Vec<u64> {
        let mut all: Vec<u64> = self.pieces.iter().filter_map(|piece| piece.time).collect();
        all.sort_unstable();
        all
    }
}

/// The largest n for which [`place`] is found by the recurrence of u.
const LONGEST: u64 = 4096;

/// p_n = (u_{n+1} − 1)/u_n, where u_n ≠ 0, at the point with a₂ ≤ 1 or, `reversed`, at the one with
/// eigenvalues 1/λ. An enclosure; `None` if that is too much work: from a₁, a₂, for n above 4096.
///
/// Cost: by r and s three sines and O(log n) products; by a₁ and a₂ O(n) products of numbers of O(n) bits.
pub fn place(point: &Point, reversed: bool, n: u64) -> Option<Ball> {
    match point {
        Point::Polar(polar) => {
            // r (cos θ + sin θ (cos nθ − r⁻ⁿ)/sin nθ).
            let precision = Precision::new(256);
            let exact = |x: &BigRational| Ball::ratio(x, &precision);
            let angle = Angle::new(&(polar.s() * BigInt::from(2)));
            let (one, many) = (angle.clone(), angle.times(n));
            if many.sin_sign() == Sign::Zero {
                return None;
            }
            let small = power(&exact(polar.r()), n, &precision);
            let (r, inverse) = if reversed {
                (exact(&polar.r().recip()), small)
            } else {
                (exact(polar.r()), Ball::integer(1, &precision) / &small)
            };
            let sine = |angle: &Angle| <Ball as Circular>::sin(angle, &precision);
            let cosine = |angle: &Angle| <Ball as Circular>::cos(angle, &precision);
            let swing = sine(&one) * &(cosine(&many) - &inverse) / &sine(&many);
            Some(r * &(cosine(&one) + &swing))
        }
        Point::Plane(plane) => {
            if n > LONGEST || plane.is_singular(n) {
                return None;
            }
            let (a1, a2) = if reversed {
                (plane.a1() / plane.a2(), plane.a2().recip())
            } else {
                (plane.a1().clone(), plane.a2().clone())
            };
            // Each step loses less than log₂(|a₁| + a₂ + 1) bits, as |a₁| < 2√a₂.
            let growth = (BigRational::one() + &a2 * BigInt::from(3)).ceil().to_integer().bits() + 1;
            let precision = Precision::new(192 + (n * growth) as u32);
            let [a1, a2] = [a1, a2].map(|x| Ball::ratio(&x, &precision));
            let (mut before, mut at) = (Ball::integer(0, &precision), Ball::integer(1, &precision));
            for _ in 0..n {
                let next = a1.clone() * &at - &(a2.clone() * &before);
                before = std::mem::replace(&mut at, next);
            }
            Some((at - &Ball::integer(1, &precision)) / &before)
        }
    }
}
