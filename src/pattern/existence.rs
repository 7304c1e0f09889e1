//! What Theorem 1 says of one impact pattern, and the numbers it rests on.

use std::fmt;

use serde::Serialize;

use super::{Coordinates, Failure, Scalar, Solution, Value, matrix::dot};
use crate::{existence::Resonance, number::Sign};

/// Whether an orbit with a given pattern tends to 0 on one side of the bifurcation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PatternExistence {
    /// Exactly one: (33) and (34) hold strictly.
    Orbit,
    /// None: some quantity in (33), (34) is strictly negative.
    NoOrbit,
    /// Theorem 1 is silent or a sign is not known; the [`OpenReason`] says which.
    Open,
}

/// `orbit`, `no orbit` or `open`.
impl fmt::Display for PatternExistence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            PatternExistence::Orbit => "orbit",
            PatternExistence::NoOrbit => "no orbit",
            PatternExistence::Open => "open",
        })
    }
}

/// A quantity of a pattern: C A^k X_i + 1, or Y_i if k = 0. Both are counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PatternQuantity {
    /// Which impact.
    pub(crate) i: usize,
    /// Which iterate after it.
    pub(crate) k: u64,
}

/// Why a side is left open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum OpenReason {
    /// det D = 0: a singular boundary, where several branches are possible (section 4.1 of the paper).
    Singular,
    /// The first resonance of one impact, nθ = π, with γ > 0: one orbit, its speed like √|µ|, on a side that
    /// the second order decides.
    Resonance,
    /// Of one impact in n periods, with γ > 0, the first resonance may be within the bounds: one orbit, for
    /// eµ < 0 where u_n > 0 and for eµ > 0 where u_n < 0.
    PerhapsResonance,
    /// The enclosure of det D contains 0.
    PerhapsSingular,
    /// A quantity is 0: for k ≥ 1 the orbit is itself grazing, for k = 0 an impact has no velocity.
    Zero(PatternQuantity),
    /// The enclosure of a quantity contains 0.
    PerhapsZero(PatternQuantity),
    /// e = 0 (26).
    Parameter,
    /// e is an interval that contains 0.
    PerhapsParameter,
}

impl fmt::Display for PatternQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.k {
            0 => write!(f, "Y_{}", self.i),
            k => write!(f, "C A^{k} X_{} + 1", self.i),
        }
    }
}

impl fmt::Display for OpenReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OpenReason::Singular => f.write_str("det D = 0: singular, several branches are possible"),
            OpenReason::Resonance => f.write_str(
                "first resonance: an orbit is born, its speed like sqrt|mu|, on the side that the second order decides",
            ),
            OpenReason::PerhapsResonance => f.write_str(
                "the first resonance may be within the bounds: where u_n > 0 one orbit is born for e*mu < 0, where u_n < \
                 0 one for e*mu > 0, where u_n = 0 one on a side that the second order decides",
            ),
            OpenReason::PerhapsSingular => f.write_str("the enclosure of det D contains 0"),
            OpenReason::Zero(place) if place.k == 0 => write!(f, "{place} = 0: an impact without velocity"),
            OpenReason::Zero(place) => write!(f, "{place} = 0: the orbit is itself grazing"),
            OpenReason::PerhapsZero(place) => write!(f, "the enclosure of {place} contains 0"),
            OpenReason::Parameter => f.write_str("e = 0: nothing is claimed for either sign"),
            OpenReason::PerhapsParameter => f.write_str("e may be 0: nothing is claimed for either sign"),
        }
    }
}

/// The solution of (32) and what follows from it; all numbers are exact or enclosed.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct PatternOrbit {
    /// X_1, …, X_m, in the coordinates the map was given in, or those of its section change P.
    pub x: Vec<Vec<Value>>,
    /// Y_1, …, Y_m.
    pub y: Vec<Value>,
    /// The least and the greatest C A^k X_i + 1 of (33); `None` if every n_i = 1.
    pub gaps: Option<[Value; 2]>,
    /// The least and the greatest Y_i of (34).
    pub impacts: [Value; 2],
    /// L = Π −C A^{n_i} B / (2 Y_i): the eigenvalue of largest modulus is L (eµ)^{−m} to leading order (36).
    /// `None` if some Y_i may be 0.
    pub leading: Option<Value>,
    /// The sign of L, if it is certain. For an exact map and a pattern that exists on a side it always is,
    /// unless some C A^{n_i} B = 0.
    pub leading_sign: Option<Sign>,
}

impl PatternOrbit {
    /// The two margins for a sign of eµ: the least sign(eµ)(C A^k X_i + 1), `None` if every n_i = 1, and the
    /// least sign(eµ) Y_i.
    pub fn margins(&self, positive: bool) -> (Option<Value>, Value) {
        let pick = |ends: &[Value; 2]| if positive { ends[0].clone() } else { -ends[1].clone() };
        (self.gaps.as_ref().map(pick), pick(&self.impacts))
    }

    /// The sign of the large eigenvalue for small eµ of a sign: that of L (eµ)^{−m} (36).
    pub fn eigenvalue_sign(&self, positive: bool) -> Option<Sign> {
        self.leading_sign.map(|sign| sign.negated_if(!positive && self.y.len() % 2 == 1))
    }
}

/// Theorem 1 for one pattern.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Report {
    /// For small eµ > 0.
    pub plus: PatternExistence,
    /// For small eµ < 0.
    pub minus: PatternExistence,
    /// Why a side is open, if one is.
    pub reason: Option<OpenReason>,
    /// An n_i with C A^{n_i} B = 0: (36) then has no leading term.
    pub flat: Option<u64>,
    /// The solution of (32), unless D is or may be singular.
    pub orbit: Option<PatternOrbit>,
}

impl Report {
    /// The report on a pattern for which (32) was not solved.
    pub(super) fn unsolved(failure: Failure, flat: Option<u64>, e: Option<Sign>) -> Report {
        let reason = match failure {
            Failure::Singular => OpenReason::Singular,
            Failure::Unknown => OpenReason::PerhapsSingular,
        };
        Report {
            plus: PatternExistence::Open,
            minus: PatternExistence::Open,
            reason: Some(parameter(e).unwrap_or(reason)),
            flat,
            orbit: None,
        }
    }

    /// The report on one impact at a resonance of a map of two dimensions with a₂ < 1, whose f, h and b are
    /// C².
    pub(super) fn at_resonance(resonance: Resonance, gamma: Sign, n: u64, e: Option<Sign>) -> Report {
        let found = Self::near_resonance(resonance, gamma, e);
        let exact =
            |reason| if reason == OpenReason::PerhapsResonance { OpenReason::Resonance } else { reason };
        Report { reason: found.reason.map(exact), flat: Some(n), ..found }
    }

    /// The same where it may only be near.
    pub(super) fn near_resonance(resonance: Resonance, gamma: Sign, e: Option<Sign>) -> Report {
        let is_born = resonance == Resonance::First && gamma == Sign::Positive;
        let reason = parameter(e).or(is_born.then_some(OpenReason::PerhapsResonance));
        let side = if reason.is_some() { PatternExistence::Open } else { PatternExistence::NoOrbit };
        Report { plus: side, minus: side, reason, flat: None, orbit: None }
    }

    /// The sign of eµ for which the orbit exists: `true` for eµ > 0, `None` if for neither or if that is not
    /// known.
    pub fn side(&self) -> Option<bool> {
        match (self.plus, self.minus) {
            (PatternExistence::Orbit, _) => Some(true),
            (_, PatternExistence::Orbit) => Some(false),
            _ => None,
        }
    }

    /// Whether a side is open.
    pub fn is_open(&self) -> bool {
        self.plus == PatternExistence::Open || self.minus == PatternExistence::Open
    }
}

fn parameter(e: Option<Sign>) -> Option<OpenReason> {
    match e {
        Some(Sign::Zero) => Some(OpenReason::Parameter),
        None => Some(OpenReason::PerhapsParameter),
        Some(_) => None,
    }
}

/// What is known of the signs of some of a pattern's quantities.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tally {
    positive: bool,
    negative: bool,
    zero: Option<PatternQuantity>,
    unknown: Option<PatternQuantity>,
}

impl Tally {
    /// Counts a sign; a zero or an unknown one is remembered by its place, the first of each.
    pub(crate) fn add(&mut self, sign: Option<Sign>, place: PatternQuantity) {
        match sign {
            Some(Sign::Positive) => self.positive = true,
            Some(Sign::Negative) => self.negative = true,
            Some(Sign::Zero) => self.zero = self.zero.or(Some(place)),
            None => self.unknown = self.unknown.or(Some(place)),
        }
    }

    /// Counts what another tally did, for impact i.
    pub(crate) fn merge(&mut self, other: &Tally, i: usize) {
        let at = |place: Option<PatternQuantity>| place.map(|place| PatternQuantity { i, ..place });
        self.positive |= other.positive;
        self.negative |= other.negative;
        self.zero = self.zero.or(at(other.zero));
        self.unknown = self.unknown.or(at(other.unknown));
    }

    /// Whether more bits could not change the answer.
    pub(crate) fn is_settled(&self) -> bool {
        self.unknown.is_none() || (self.positive && self.negative)
    }

    /// What Theorem 1 says for eµ > 0 or eµ < 0.
    pub(crate) fn side(&self, positive: bool) -> PatternExistence {
        if if positive { self.negative } else { self.positive } {
            PatternExistence::NoOrbit
        } else if self.zero.is_some() || self.unknown.is_some() {
            PatternExistence::Open
        } else {
            PatternExistence::Orbit
        }
    }

    /// The report that these signs amount to.
    pub(crate) fn report(&self, e: Option<Sign>, flat: Option<u64>, orbit: PatternOrbit) -> Report {
        let silent = parameter(e);
        let side = |positive| if silent.is_some() { PatternExistence::Open } else { self.side(positive) };
        let (plus, minus) = (side(true), side(false));
        let open = plus == PatternExistence::Open || minus == PatternExistence::Open;
        let reason = silent.or(self.zero.map(OpenReason::Zero)).or(self.unknown.map(OpenReason::PerhapsZero));
        Report { plus, minus, reason: reason.filter(|_| open), flat, orbit: Some(orbit) }
    }
}

/// The least and the greatest of some values.
pub(super) fn range(values: impl Iterator<Item = Value>) -> Option<[Value; 2]> {
    values.fold(None, |range, value| {
        Some(match range {
            None => [value.clone(), value],
            Some([least, greatest]) => [least.extreme(value.clone(), false), greatest.extreme(value, true)],
        })
    })
}

/// −C A^n B / (2 y), unless y may be 0.
pub(super) fn factor<T: Scalar>(map: &Coordinates<T>, n: u64, y: &T) -> Option<T> {
    y.pivot()?;
    Some(-map.response(n).clone() / &(y.clone() + y))
}

/// An n_i with C A^{n_i} B = 0 exactly.
pub(super) fn flat<T: Scalar>(map: &Coordinates<T>, periods: &[u64]) -> Option<u64> {
    periods.iter().copied().find(|&n| map.response(n).sign() == Some(Sign::Zero))
}

/// The signs of a solution, and the numbers to show. Cost: O(n N) multiplications, n the pattern's period.
pub(super) fn examine<T: Scalar>(
    map: &Coordinates<T>,
    periods: &[u64],
    solution: &Solution<T>,
) -> (Tally, PatternOrbit) {
    let mut tally = Tally::default();
    let zero = T::integer(0, map.context());
    let one = T::integer(1, map.context());
    let mut gaps = Vec::new();
    for (i, (&n, x)) in periods.iter().zip(&solution.x).enumerate() {
        for k in 1..n {
            let gap = dot(map.power(k).row(0), x, &zero) + &one;
            tally.add(gap.sign(), PatternQuantity { i: i + 1, k });
            gaps.push(gap.value());
        }
        tally.add(solution.y[i].sign(), PatternQuantity { i: i + 1, k: 0 });
    }
    let factors: Option<Vec<T>> = periods.iter().zip(&solution.y).map(|(&n, y)| factor(map, n, y)).collect();
    let leading_sign = factors.as_ref().and_then(|factors| {
        factors.iter().try_fold(Sign::Positive, |product, factor| Some(product * factor.sign()?))
    });
    let leading = factors.and_then(|factors| factors.into_iter().reduce(|product, factor| product * &factor));
    let orbit = PatternOrbit {
        x: solution.x.iter().map(|x| map.original(x).iter().map(T::value).collect()).collect(),
        y: solution.y.iter().map(T::value).collect(),
        gaps: range(gaps.into_iter()),
        impacts: range(solution.y.iter().map(T::value)).unwrap_or_else(|| [zero.value(), zero.value()]),
        leading: leading.map(|x| x.value()),
        leading_sign,
    };
    (tally, orbit)
}
