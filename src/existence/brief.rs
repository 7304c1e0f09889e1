//! Existence for one period with no more signs than the answer takes, for a caller who asks for no
//! particular k.
//!
//! The definition stops where a b_{n,k} > 0 and one < 0 are known, whichever k they have; what intervals left
//! open then stays open. The record form takes every f_k by itself: f_n is a record, or lies between two.

use num_rational::BigRational;
use num_traits::One;

use super::{Case, Existence, single::verdict};
use crate::{
    local::{Answer, Ladder, Point, Quantity, Region, Rung},
    number::{FloatInterval, Sign},
};

/// Existence for one period by the definition.
#[derive(Debug, Clone)]
pub(crate) struct Brief {
    /// As [`by_definition`](super::by_definition) finds it, but with any k.
    pub existence: Existence,
    /// The highest rung it took.
    pub rung: Rung,
    /// The sign of b_{n,k} for k = 1, 2, …; undecided also where it was not needed.
    pub answers: Vec<Answer>,
}

impl Brief {
    /// By the signs of b_{n,k} and, unless two of these are opposite, that of c_n. Cost: O(n) operations of
    /// `f64` intervals, and a sign for each k that is needed and that they leave open.
    ///
    /// # Panics
    /// Unless n ≥ 1.
    pub fn new(ladder: &Ladder, point: &Point, n: u64) -> Brief {
        let singular = match point {
            Point::Polar(polar) => polar.is_singular(n),
            Point::Plane(plane) => plane.is_singular(n),
        };
        if singular {
            return Brief { existence: Existence::Singular, rung: Rung::Exact, answers: Vec::new() };
        }
        let (answers, mut rung) = ladder.signs_until_both(point, n);
        let existence = verdict(answers.iter().copied(), || {
            let c = ladder.sign(point, Quantity::C { n });
            rung = rung.higher(c.rung);
            match c.answer {
                Answer::Sign(sign) => Some(sign),
                Answer::Singular | Answer::Undecided => None,
            }
        });
        Brief { existence, rung, answers }
    }

    /// Existence for the same n by the record form: from enclosures of f_1, …, f_n, which the definition
    /// knows nothing of, and from its signs where two of these overlap. `None` but in regions 2, 3 and 4 with
    /// a₂ ≤ 1. Cost: O(n) interval operations, and where these leave u_n open its sign.
    pub fn record(
        &self,
        ladder: &Ladder,
        point: &Point,
        n: u64,
        first: Option<&[FloatInterval]>,
    ) -> Option<Existence> {
        let known = match point {
            Point::Polar(polar) => Some(polar.u_sign(n)),
            Point::Plane(plane) if plane.a2() > &BigRational::one() => return None,
            Point::Plane(plane) => match plane.region() {
                Region::Two => Some(Sign::Positive),
                Region::Four => Some(Sign::Positive.negated_if(n.is_multiple_of(2))),
                Region::Three => None,
                Region::One | Region::Five | Region::Line => return None,
            },
        };
        if n == 1 {
            // f_1 > 0 there: c_1 < 0.
            return Some(Existence::Orbit(Case::PlusMinus));
        }
        let u = match known.map_or_else(|| ladder.u_sign(point, n).answer, Answer::Sign) {
            Answer::Sign(Sign::Zero) | Answer::Singular => return Some(Existence::Singular),
            Answer::Sign(u) => u,
            Answer::Undecided => return Some(Existence::Undecided),
        };
        if let Some(quotients) = first
            && let Some(found) = place(u, quotients, &[])
        {
            return Some(found);
        }
        let terms = match point {
            Point::Polar(polar) => polar.terms::<FloatInterval>(n, &()),
            Point::Plane(plane) => plane.terms::<FloatInterval>(n, &()),
        };
        // The whole line where 2 − v_k is not certain to be positive.
        let quotients: Vec<FloatInterval> = terms.into_iter().map(|(u, rest)| u / &rest).collect();
        Some(place(u, &quotients, &self.answers).unwrap_or(Existence::Undecided))
    }
}

/// Existence for period n from the sign of u_n ≠ 0, enclosures of f_1, …, f_n and, where these overlap, the
/// signs of b_{n,k}, if they are known.
fn place(u: Sign, quotients: &[FloatInterval], answers: &[Answer]) -> Option<Existence> {
    let (here, others) = quotients.split_last()?;
    let (mut above, mut below, mut equal, mut open) = (None, None, None, false);
    for (k, there) in (1..).zip(others) {
        // The sign of f_n − f_k is that of u_n b_{n,k}.
        let known = || match answers.get(k as usize - 1) {
            Some(Answer::Sign(b)) => Some(*b * u),
            _ => None,
        };
        match apart(here, there).or_else(known) {
            Some(Sign::Positive) => above = above.or(Some(k)),
            Some(Sign::Negative) => below = below.or(Some(k)),
            Some(Sign::Zero) => equal = equal.or(Some(k)),
            None => open = true,
        }
    }
    let positive_f = u == Sign::Positive;
    Some(match (above, below, equal) {
        (Some(above), Some(below), _) if positive_f => Existence::None { positive: above, negative: below },
        (Some(above), Some(below), _) => Existence::None { positive: below, negative: above },
        _ if open => return None,
        (_, _, Some(k)) => Existence::Iterate(k),
        // A record high: b has the sign of u_n, c that of −f_n.
        (Some(_), ..) => Existence::Orbit(Case::from_signs(positive_f, !positive_f)),
        _ => Existence::Orbit(Case::from_signs(!positive_f, !positive_f)),
    })
}

/// The sign of the difference of two enclosed numbers, where the enclosures have no number in common.
fn apart(one: &FloatInterval, other: &FloatInterval) -> Option<Sign> {
    if one.lo() > other.hi() {
        Some(Sign::Positive)
    } else if one.hi() < other.lo() {
        Some(Sign::Negative)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::*;
    use crate::{
        existence::{by_definition, by_records},
        local::{Plane, Polar},
        random::Random,
    };

    /// Near fractions and near r = 1, where many signs are open, and in every region: the same orbits as by
    /// every sign, and the same by the record form, whatever enclosures it begins with.
    #[test]
    fn no_sign_less_is_no_other_answer() {
        let (ladder, mut random) = (Ladder::default(), Random::of_unit(10, 0));
        let (mut orbits, mut none, mut boundary) = (0, 0, 0);
        for case in 0..400 {
            let n = random.within(1, 24);
            let mut tiny = || BigRational::new(1.into(), BigInt::one() << random.within(3, 90));
            let (first, second) = (tiny(), tiny());
            let fraction = BigRational::new(random.within(0, n).into(), (2 * n).into());
            let r = if case % 5 == 0 { BigRational::one() } else { BigRational::one() - first };
            let s = if case % 3 == 0 { fraction } else { fraction + &second };
            let point = if case % 4 == 0 {
                let a1 = &r + &r - &second * BigInt::from(random.within(0, 2));
                Plane::new(if random.coin() { -a1 } else { a1 }, &r * &r).map(Point::Plane)
            } else {
                Polar::new(r, s).map(Point::Polar)
            };
            let Ok(point) = point else { continue };
            let (brief, full) = (Brief::new(&ladder, &point, n), by_definition(&ladder, &point, n));
            let kind = std::mem::discriminant::<Existence>;
            assert_eq!(kind(&brief.existence), kind(&full), "{point:?}, n = {n}");
            assert_eq!(brief.existence.cases(n), full.cases(n), "{point:?}, n = {n}");
            match full {
                Existence::Orbit(_) => orbits += 1,
                Existence::None { .. } => none += 1,
                _ => boundary += 1,
            }
            let records = by_records(&ladder, &point, n);
            let record = brief.record(&ladder, &point, n, None);
            assert_eq!(records.is_some(), record.is_some());
            if let (Some(records), Some(record)) = (records, record) {
                assert_eq!(record.cases(n), records[n as usize - 1].cases(n), "{point:?}, n = {n}");
                let whole = vec![FloatInterval::WHOLE; n as usize];
                let from_whole = brief.record(&ladder, &point, n, Some(&whole)).unwrap();
                assert_eq!(from_whole, record);
            }
        }
        assert!(orbits > 50 && none > 50 && boundary > 10, "{orbits} {none} {boundary}");
    }
}
