//! One case decided by its definition, by the record form and by the claim; and what a sweep found, against the ladder.
//!
//! The definition and the record form take their signs from the ladder, the claim from [`apart`](super::apart): a wrong sign
//! on one side shows as a difference. Where the ladder does not confirm a difference, the error is this program's.

use super::{Case, Tally, apart, sweep::Swept, weighted};
use crate::{
    existence::{
        Claim, Existence, Variant, by_definition, by_records, claimed, claimed_with, definition_and_rung,
    },
    local::{Answer, Ladder, Plane, Point, Quantity, Region, Rung},
};

/// Up to this period a point (a₁, a₂) is decided in reversed time too, and by the record form.
const REVERSED: u64 = 24;
const RECORDED: u64 = 64;

/// How one case compares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comparison {
    Agree(Rung),
    Boundary,
    Undecided,
    Differ,
    /// Two routes of this program to one answer differ.
    Fault(&'static str),
}

pub(super) fn compare(ladder: &Ladder, case: &Case, variant: Variant) -> Comparison {
    let Case { n, point } = case;
    let (found, rung) = definition_and_rung(ladder, point, *n);
    let cases = found.cases(*n);
    let apart = |point: &Point, quantity: Quantity| match quantity {
        Quantity::B { n, k } => match apart::sign(ladder, point, n, k) {
            // An exact zero inside the circle is found by algebra alone.
            Answer::Undecided => ladder.sign(point, quantity).answer,
            answer => answer,
        },
        Quantity::C { .. } => ladder.sign(point, quantity).answer,
    };
    let claim = claimed_with(&apart, point, *n, variant);
    let comparison = against(&found, claim, case, rung);
    if comparison == Comparison::Differ {
        let confirmed = claimed(ladder, point, *n, variant);
        return if confirmed == claim {
            Comparison::Differ
        } else {
            Comparison::Fault("two routes to the sign that decides the claim differ")
        };
    }
    if *n <= RECORDED
        && let Some(records) = by_records(ladder, point, *n)
        && let Some(record) = records.last()
    {
        let decided = *record != Existence::Undecided && found != Existence::Undecided;
        if decided && record.cases(*n) != cases {
            return Comparison::Fault("the definition and the record form differ");
        }
        let by_record = against(record, claim, case, rung);
        if by_record == Comparison::Differ && comparison != Comparison::Undecided {
            return Comparison::Fault("the record form and the claim differ");
        }
    }
    // The same orbits exist in reversed time, where a₁ and a₂ are a₁/a₂ and 1/a₂.
    if let Point::Plane(plane) = point
        && *n <= REVERSED
        && matches!(comparison, Comparison::Agree(_) | Comparison::Undecided)
        && let Ok(reversed) = Plane::new(plane.a1() / plane.a2(), plane.a2().recip())
    {
        let other = by_definition(ladder, &Point::Plane(reversed), *n);
        if other != Existence::Undecided && other.cases(*n) != cases {
            return Comparison::Differ;
        }
    }
    comparison
}

fn against(found: &Existence, claim: Claim, case: &Case, rung: Rung) -> Comparison {
    let claim = match claim {
        Claim::Orbit(orbit) => Existence::Orbit(orbit).cases(case.n),
        Claim::None => Vec::new(),
        Claim::Undecided => return Comparison::Undecided,
        // On a boundary nothing is claimed, but an orbit there would lie in no area. For odd n the line a₁ = −(a₂ + 1), which
        // belongs to no region, has them.
        Claim::Boundary if matches!(found, Existence::Orbit(_)) && !on_line(&case.point) => {
            return Comparison::Differ;
        }
        Claim::Boundary => return Comparison::Boundary,
    };
    match found {
        Existence::Undecided => Comparison::Undecided,
        Existence::Orbit(_) | Existence::None { .. } if found.cases(case.n) == claim => {
            Comparison::Agree(rung)
        }
        _ => Comparison::Differ,
    }
}

fn on_line(point: &Point) -> bool {
    matches!(point, Point::Plane(plane) if plane.region() == Region::Line)
}

pub(in crate::search) fn differ(ladder: &Ladder, case: &Case, variant: Variant) -> bool {
    compare(ladder, case, variant) == Comparison::Differ
}

/// What a sweep found of one period and the ladder contradicts: an error of this program, whatever the conjecture says.
pub(super) fn contradiction(ladder: &Ladder, case: &Case, swept: &Swept) -> Option<&'static str> {
    let Case { n, point } = case;
    let cases = |found: Option<_>| found.into_iter().collect::<Vec<_>>();
    if let Some(found) = swept.defined {
        let existence = by_definition(ladder, point, *n);
        if existence != Existence::Undecided && existence.cases(*n) != cases(found) {
            return Some("a sweep's record form and the definition differ");
        }
    }
    if let Some(found) = swept.claimed {
        let claim = match claimed(ladder, point, *n, Variant::True) {
            Claim::Orbit(case) => Some(vec![case]),
            Claim::None => Some(Vec::new()),
            // The sweep has decided a sign that is zero.
            Claim::Boundary => None,
            Claim::Undecided => return None,
        };
        if claim != Some(cases(found)) {
            return Some("a sweep's claim and the ladder's differ");
        }
    }
    None
}

/// Decides and counts one case on the ladder; time reversal must not change what exists.
pub(super) fn one_case(ladder: &Ladder, case: Case, variant: Variant, tally: &mut Tally) {
    match compare(ladder, &case, variant) {
        Comparison::Agree(Rung::Ball(_)) => tally.ball += 1,
        Comparison::Agree(Rung::Exact) => tally.exact += 1,
        Comparison::Agree(_) => tally.interval += 1,
        Comparison::Boundary => tally.boundary += 1,
        Comparison::Undecided => tally.undecided += 1,
        Comparison::Differ => tally.disagreements.push(shrink(ladder, case, variant).to_string()),
        Comparison::Fault(what) => tally.faults.push(format!("{what}: {case}")),
    }
}

/// A simple case that differs too: the first of the small ones, or else one near this case, each step taking the first
/// simplification that still differs.
pub(super) fn shrink(ladder: &Ladder, mut case: Case, variant: Variant) -> Case {
    if let Some(small) = weighted::small_cases().find(|small| differ(ladder, small, variant)) {
        return small;
    }
    let size = |case: &Case| case.n as usize + case.to_string().len() * 8;
    while let Some(better) = weighted::simpler(&case)
        .into_iter()
        .find(|simpler| size(simpler) < size(&case) && differ(ladder, simpler, variant))
    {
        case = better;
    }
    case
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;

    use super::*;
    use crate::{existence::Case as Signs, local::Polar};

    /// Every answer of a sweep that is not the ladder's is noticed, in either half.
    #[test]
    fn a_wrong_sweep_is_an_error_of_ours() {
        let ladder = Ladder::default();
        let ratio = |p: i64, q: i64| BigRational::new(p.into(), q.into());
        let answers = [None, Some(Signs::PlusPlus), Some(Signs::PlusMinus), Some(Signs::MinusPlus)];
        for (n, s) in [(3, ratio(3, 10)), (4, ratio(1, 20)), (5, ratio(2, 11)), (6, ratio(2, 5))] {
            let case = Case { n, point: Point::Polar(Polar::new(ratio(99, 100), s).unwrap()) };
            let truth = by_definition(&ladder, &case.point, n).cases(n).first().copied();
            for answer in answers {
                for swept in [
                    Swept { defined: Some(answer), claimed: None },
                    Swept { defined: None, claimed: Some(answer) },
                    Swept { defined: Some(truth), claimed: Some(answer) },
                ] {
                    let noticed = contradiction(&ladder, &case, &swept).is_some();
                    assert_eq!(noticed, answer != truth, "{case}: {answer:?}");
                }
            }
            assert_eq!(contradiction(&ladder, &case, &Swept { defined: None, claimed: None }), None);
        }
    }
}
