//! What becomes of a case that a sweep leaves open: it is decided on the ladder, counted, and shrunk if it
//! disagrees.

use super::{
    super::compare::{Comparison, compare, differ},
    FuzzTally, Instance,
    sweep::Swept,
    weighted,
};
use crate::{
    existence::{Claim, Existence, Variant, by_definition, claimed},
    local::{Ladder, Rung},
};

/// What a sweep found of one period and the ladder contradicts: an error of this program, whatever the
/// conjecture says.
pub(super) fn contradiction(ladder: &Ladder, case: &Instance, swept: &Swept) -> Option<&'static str> {
    let Instance { n, point } = case;
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
pub(super) fn one_case(ladder: &Ladder, case: Instance, variant: Variant, tally: &mut FuzzTally) {
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

/// A simple case that differs too: the first of the small ones, or else one near this case, each step taking
/// the first simplification that still differs.
pub(super) fn shrink(ladder: &Ladder, mut case: Instance, variant: Variant) -> Instance {
    if let Some(small) = weighted::small_cases().find(|small| differ(ladder, small, variant)) {
        return small;
    }
    let size = |case: &Instance| case.n as usize + case.to_string().len() * 8;
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
    use crate::{
        existence::Case,
        local::{Answer, Point, Polar, Quantity},
        random::Random,
        search::apart,
    };

    /// Every answer of a sweep that is not the ladder's is noticed, in either half.
    #[test]
    fn a_wrong_sweep_is_an_error_of_ours() {
        let ladder = Ladder::default();
        let ratio = |p: i64, q: i64| BigRational::new(p.into(), q.into());
        let answers = [None, Some(Case::PlusPlus), Some(Case::PlusMinus), Some(Case::MinusPlus)];
        for (n, s) in [(3, ratio(3, 10)), (4, ratio(1, 20)), (5, ratio(2, 11)), (6, ratio(2, 5))] {
            let case = Instance { n, point: Point::Polar(Polar::new(ratio(99, 100), s).unwrap()) };
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

    /// Both routes give one sign on weighted cases of every family.
    #[test]
    fn two_routes_give_one_sign() {
        let (ladder, mut random) = (Ladder::default(), Random::of_unit(3, 0));
        let mut compared = 0;
        for _ in 0..600 {
            let Some(case) = weighted::case(&mut random, &ladder, 2..=40) else { continue };
            for k in [1, case.n / 2, case.n - 1] {
                if (1..case.n).contains(&k) {
                    let other = apart::sign(&ladder, &case.point, case.n, k);
                    let answer = ladder.sign(&case.point, Quantity::B { n: case.n, k }).answer;
                    assert!(
                        other == answer || other == Answer::Undecided,
                        "{case}, k = {k}: {other:?}, {answer:?}"
                    );
                    compared += u64::from(other == answer);
                }
            }
        }
        assert!(compared > 1000, "{compared}");
    }
}
