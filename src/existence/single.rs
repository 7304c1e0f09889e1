//! Does a single-impact orbit of period n exist at one point, and in which case? The definition, and the
//! record form.
//!
//! Existence has one definition, the signs in (52) and (53); [`by_definition`] takes it at its word, one k
//! after the other. [`by_records`] uses an identity: with f_j = u_j/(2 − v_j),
//!
//! ```text
//! 2 N_{n,k} = u_n (2 − v_k) − u_k (2 − v_n),    N_{n,k} = u_n b_{n,k},
//! ```
//!
//! and 2 − v_j > 0 in regions 2, 3 and 4, so b_{n,k} u_n has the sign of f_n − f_k and c_n the sign of −f_n:
//! an orbit exists iff f_n ≠ 0 is a strict record of f_1, …, f_n. One pass with the latest maximum and
//! minimum decides every n ≤ N. Two f are compared by their enclosures, or else by the sign of b_{n,k}.

use std::{fmt, time::Duration};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use serde::Serialize;

use super::Case;
use crate::{
    error::Result,
    local::{Answer, Ladder, Plane, Point, Quantity, Region, Rung},
    number::{FloatInterval, Real, Sign},
    processor::Stopwatch,
};

/// What is known of the single-impact orbits of one period at one point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Existence {
    /// (52) and (53) hold in this case and, for n = 1, in the one with both signs reversed: exactly one orbit
    /// in each.
    Orbit(Case),
    /// b_{n,positive} > 0 > b_{n,negative}: no orbit.
    None {
        /// A k with b_{n,k} > 0.
        positive: u64,
        /// A k with b_{n,k} < 0.
        negative: u64,
    },
    /// u_n = 0, a singular boundary: Theorem 1 is silent; [`Resonance`](super::Resonance) says what is born.
    Singular,
    /// b_{n,k} = 0 for this k, an iterate boundary, and no two b have opposite signs: Theorem 1 is silent. Of
    /// a linear oscillator there is none, at any µ ([`in_words`](Existence::in_words)).
    Iterate(u64),
    /// c_n = 0, a sign boundary, and every b has the same sign: Theorem 1 is silent.
    SignBoundary,
    /// The ladder's precision was not enough.
    Undecided,
}

/// In words, as `orbit in case (+,-)` or `no orbit: b_{n,2} > 0 > b_{n,1}`.
impl fmt::Display for Existence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Existence::Orbit(case) => write!(f, "orbit in case {case}"),
            Existence::None { positive, negative } => {
                write!(f, "no orbit: b_{{n,{positive}}} > 0 > b_{{n,{negative}}}")
            }
            Existence::Singular => f.write_str("singular boundary: u_n = 0"),
            Existence::Iterate(k) => write!(f, "iterate boundary: b_{{n,{k}}} = 0"),
            Existence::SignBoundary => f.write_str("sign boundary: c_n = 0"),
            Existence::Undecided => f.write_str("undecided"),
        }
    }
}

impl Existence {
    /// The cases in which an orbit of period `n` exists.
    pub fn cases(self, n: u64) -> Vec<Case> {
        match self {
            Existence::Orbit(case) if n == 1 => vec![case, case.reversed()],
            Existence::Orbit(case) => vec![case],
            _ => Vec::new(),
        }
    }

    /// The word that tables have for it: `orbit`, `none`, `singular boundary`, `iterate boundary`, `sign
    /// boundary` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Existence::Orbit(_) => "orbit",
            Existence::None { .. } => "none",
            Existence::Singular => "singular boundary",
            Existence::Iterate(_) => "iterate boundary",
            Existence::SignBoundary => "sign boundary",
            Existence::Undecided => "undecided",
        }
    }

    /// What it says of linear oscillators at every µ, where Theorem 1 is silent about small µ: at an iterate
    /// boundary with c_n ≠ 0 (`Every_mu_statement` of `StatementOneImpact.v`). That is everywhere but on the
    /// lines of `region`.
    pub fn in_words(self, region: Region) -> Option<&'static str> {
        (matches!(self, Existence::Iterate(_)) && region != Region::Line).then_some(
            "of a linear oscillator no motion repeats with one impact in n periods, at any mu; of maps Theorem 1 is \
             silent",
        )
    }

    /// The k that it names with b_{n,k} > 0, with b_{n,k} < 0 and with b_{n,k} = 0.
    pub fn indices(self) -> [Option<u64>; 3] {
        match self {
            Existence::None { positive, negative } => [Some(positive), Some(negative), None],
            Existence::Iterate(k) => [None, None, Some(k)],
            _ => [None; 3],
        }
    }
}

/// Existence for period `n` at `point`, by the signs of c_n and of every b_{n,k}. Cost: n signs.
///
/// # Panics
/// Unless n ≥ 1.
pub fn by_definition(ladder: &Ladder, point: &Point, n: u64) -> Existence {
    definition_and_rung(ladder, point, n).0
}

/// Existence for every period 1, …, `last`: by the record form where it serves, or else by the definition,
/// one period after the other. Cost: as [`by_records`], or `last`² signs.
///
/// # Errors
/// That of `check`, which is asked before every period that takes the definition.
pub fn up_to(
    ladder: &Ladder,
    point: &Point,
    last: u64,
    mut check: impl FnMut() -> Result<()>,
) -> Result<Vec<Existence>> {
    match by_records(ladder, point, last) {
        Some(found) => Ok(found),
        None => (1..=last).map(|n| check().map(|()| by_definition(ladder, point, n))).collect(),
    }
}

/// [`by_definition`], and the highest rung it took: intervals, then balls by their bits, then integers.
pub fn definition_and_rung(ladder: &Ladder, point: &Point, n: u64) -> (Existence, Rung) {
    let c = ladder.sign(point, Quantity::C { n });
    let mut rung = c.rung;
    let c = match c.answer {
        Answer::Singular => return (Existence::Singular, rung),
        Answer::Sign(sign) => Some(sign),
        Answer::Undecided => None,
    };
    let decisions = ladder.signs(point, n);
    rung = decisions.iter().fold(rung, |rung, decision| rung.higher(decision.rung));
    (verdict(decisions.iter().map(|decision| decision.answer), || c), rung)
}

/// What the signs of b_{n,1}, b_{n,2}, … and, unless two of them are opposite, that of c_n say; `None` for a
/// c_n that is undecided. Needs u_n ≠ 0.
pub(super) fn verdict(answers: impl Iterator<Item = Answer>, c: impl FnOnce() -> Option<Sign>) -> Existence {
    let (mut positive, mut negative, mut zero, mut undecided) = (None, None, None, false);
    for (k, answer) in (1..).zip(answers) {
        let place = match answer {
            Answer::Sign(Sign::Positive) => &mut positive,
            Answer::Sign(Sign::Negative) => &mut negative,
            Answer::Sign(Sign::Zero) => &mut zero,
            Answer::Singular | Answer::Undecided => {
                undecided = true;
                continue;
            }
        };
        place.get_or_insert(k);
    }
    match (positive, negative, zero) {
        (Some(positive), Some(negative), _) => Existence::None { positive, negative },
        _ if undecided => Existence::Undecided,
        (_, _, Some(k)) => Existence::Iterate(k),
        _ => match c() {
            None => Existence::Undecided,
            Some(Sign::Zero) => Existence::SignBoundary,
            // For n = 1 there is no b: of the two cases, the one with eµ > 0 stands for both.
            Some(c) => Existence::Orbit(Case::from_signs(negative.is_none(), c == Sign::Positive)),
        },
    }
}

/// Existence for every period 1, …, `last` at a point of region 2, 3 or 4 with a₂ ≤ 1, by the record form;
/// `None` elsewhere.
///
/// Cost: O(1) interval operations for each n; where these leave a comparison open, the sign of a b, and where
/// they leave that of a u open, for a point (a₁, a₂) of region 3 the integers u_1, …, u_last.
///
/// ```
/// use grazing::existence::{Existence, by_definition, by_records};
/// use grazing::{local::{Ladder, Point, Polar}, number::parse_rational};
/// let point = Point::Polar(Polar::new(parse_rational("0.99")?, parse_rational("0.21")?)?);
/// let ladder = Ladder::default();
/// let found = by_records(&ladder, &point, 6).expect("region 3");
/// assert_eq!(found[4], by_definition(&ladder, &point, 5));
/// assert_eq!(found[4].to_string(), "orbit in case (+,-)");
/// assert!(matches!(found[5], Existence::None { .. }));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn by_records(ladder: &Ladder, point: &Point, last: u64) -> Option<Vec<Existence>> {
    let start = ladder.profile().map(|_| Stopwatch::start());
    let (signs, quotients) = (u_signs(point, last)?, quotients(point, last));
    let spent = start.map_or(Duration::ZERO, |start| start.elapsed());
    let mut records = Records {
        ladder,
        point,
        signs: &signs,
        quotients: &quotients,
        highest: 1,
        lowest: 1,
        lost: false,
        compared: 0,
    };
    let found = (1..=last).map(|n| records.next(n)).collect();
    if let (Some(profile), 1..) = (ladder.profile(), records.compared) {
        profile.add(Rung::Interval, records.compared, spent);
    }
    Some(found)
}

/// The sign of u_n for n = 1, …, last, exact; `None` unless the point is in region 2, 3 or 4.
fn u_signs(point: &Point, last: u64) -> Option<Vec<Sign>> {
    let plane = match point {
        Point::Polar(polar) => return Some((1..=last).map(|n| polar.u_sign(n)).collect()),
        Point::Plane(plane) => plane,
    };
    match plane.region() {
        _ if plane.a2() > &BigRational::one() => None,
        Region::Two => Some(vec![Sign::Positive; last as usize]),
        Region::Four => Some((1..=last).map(|n| Sign::Positive.negated_if(n % 2 == 0)).collect()),
        Region::Three => {
            let certain = (1..).zip(plane.terms::<FloatInterval>(last, &())).map(|(n, (u, _))| {
                // u is zero nowhere else.
                if plane.is_singular(n) { Some(Sign::Zero) } else { u.sign() }
            });
            Some(certain.collect::<Option<_>>().unwrap_or_else(|| u_signs_exactly(plane, last)))
        }
        Region::One | Region::Five | Region::Line => None,
    }
}

/// Enclosures of f_1, …, f_last, all times the same positive number; none on r = 1, where integers tell more.
fn quotients(point: &Point, last: u64) -> Vec<FloatInterval> {
    let terms = match point {
        Point::Polar(polar) if polar.on_circle() => Vec::new(),
        Point::Polar(polar) => polar.terms::<FloatInterval>(last, &()),
        Point::Plane(plane) => plane.terms::<FloatInterval>(last, &()),
    };
    // The whole line where 2 − v_j is not certain to be positive.
    terms.into_iter().map(|(u, rest)| u / &rest).collect()
}

/// W_k = D^{k−1} u_k by its recurrence in integers, a₁ = A/D, a₂ = B/D².
fn u_signs_exactly(plane: &Plane, last: u64) -> Vec<Sign> {
    let d = num_integer::lcm(plane.a1().denom().clone(), plane.a2().denom().clone());
    let a = (plane.a1() * &d).to_integer();
    let b = (plane.a2() * (&d * &d)).to_integer();
    let (mut before, mut w) = (BigInt::ZERO, BigInt::from(1));
    let mut signs = Vec::new();
    for _ in 0..last {
        signs.push(Sign::from(&w));
        let next = &a * &w - &b * &before;
        before = std::mem::replace(&mut w, next);
    }
    signs
}

/// The running records of f_1, f_2, ….
struct Records<'a> {
    ladder: &'a Ladder,
    point: &'a Point,
    signs: &'a [Sign],
    /// Enclosures of f_1, f_2, …, if there are any.
    quotients: &'a [FloatInterval],
    /// The first index with the greatest f so far, and with the least.
    highest: u64,
    lowest: u64,
    /// A comparison could not be decided, so that the two indices above mean nothing any more.
    lost: bool,
    /// The number of comparisons that enclosures decided.
    compared: u64,
}

impl Records<'_> {
    /// The sign of f_n − f_k, k < n: that of u_n b_{n,k}; where u_n = 0 and so f_n = 0, the sign of −f_k.
    fn compare(&mut self, n: u64, k: u64) -> Option<Sign> {
        let u = self.signs[n as usize - 1];
        if u == Sign::Zero {
            return Some(-self.signs[k as usize - 1]);
        }
        let at = |j: u64| self.quotients.get(j as usize - 1).copied();
        if let Some(sign) = at(n).zip(at(k)).and_then(|(here, there)| (here - &there).sign()) {
            self.compared += 1;
            return Some(sign);
        }
        match self.ladder.sign(self.point, Quantity::B { n, k }).answer {
            Answer::Sign(b) => Some(b * u),
            Answer::Singular | Answer::Undecided => None,
        }
    }

    /// Existence for period n; periods must be asked for in order.
    fn next(&mut self, n: u64) -> Existence {
        let u = self.signs[n as usize - 1];
        let positive_f = u == Sign::Positive;
        if n == 1 {
            // f_1 > 0 there: c_1 < 0.
            return Existence::Orbit(Case::PlusMinus);
        }
        let (highest, lowest) = (self.highest, self.lowest);
        let compared =
            if self.lost { (None, None) } else { (self.compare(n, highest), self.compare(n, lowest)) };
        let (Some(above), Some(below)) = compared else {
            // Where a record cannot be told, the definition may still find two opposite signs.
            self.lost = true;
            return by_definition(self.ladder, self.point, n);
        };
        if above == Sign::Positive {
            self.highest = n;
        }
        if below == Sign::Negative {
            self.lowest = n;
        }
        match (u, above, below) {
            (Sign::Zero, ..) => Existence::Singular,
            // A record high: b has the sign of u_n, c that of −f_n.
            (_, Sign::Positive, _) => Existence::Orbit(Case::from_signs(positive_f, !positive_f)),
            (_, _, Sign::Negative) => Existence::Orbit(Case::from_signs(!positive_f, !positive_f)),
            (_, Sign::Zero, _) => Existence::Iterate(highest),
            (_, _, Sign::Zero) => Existence::Iterate(lowest),
            // Strictly between: b_{n,highest} has the sign of −u_n, b_{n,lowest} that of u_n.
            _ if positive_f => Existence::None { positive: lowest, negative: highest },
            _ => Existence::None { positive: highest, negative: lowest },
        }
    }
}
