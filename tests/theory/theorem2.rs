//! Theorem 2: the claim by two routes, the decision, and a brute-force oracle.

use crate::common;

use common::Fraction;
use grazing::existence::{
    Approach, Case, Enclosed, Existence, Interval, Piece, Reason, Signs, by_definition, decide,
    decide_by_enclosure, intervals, tree_intervals,
};
use grazing::local::{Ladder, Point, Polar, Quantity};
use grazing::search::{ProofMethod, prove_theorem2};
use grazing::word::two_impacts;
use num_integer::Integer;
use num_rational::Ratio;
use proptest::prelude::*;

fn plain(x: &Ratio<u64>) -> Fraction {
    (i128::from(*x.numer()), i128::from(*x.denom()))
}

fn signs(case: Case) -> (i32, i32) {
    (case.sign_emu().into(), case.sign_gamma().into())
}

/// Results say what they are, in words and as JSON.
#[test]
fn results_in_words_and_as_json() {
    let interval = intervals(5).unwrap().nth(1).unwrap();
    assert_eq!(interval.to_string(), "n = 5: (1/10, 1/5) in case (+,+)");
    let json = serde_json::to_string(&interval).unwrap();
    let wanted = r#"{"n":5,"m":1,"case":"(+,+)","left":"1/10","right":"1/5","deciding":4}"#;
    assert_eq!(json, wanted);
    let first = serde_json::to_value(intervals(5).unwrap().next().unwrap()).unwrap();
    assert_eq!((&first["left"], &first["deciding"]), (&"0/1".into(), &serde_json::Value::Null));
    let pattern = two_impacts(3, 5).unwrap()[1];
    assert_eq!(pattern.to_string(), "(3,5): (1/6, 1/5) in case (+,+)");

    let (half, s) = (Ratio::new(1.into(), 2.into()), Ratio::new(2.into(), 7.into()));
    let point = Point::Polar(Polar::new(half, s).unwrap());
    let ladder = Ladder::default();
    let found = by_definition(&ladder, &point, 5);
    let Existence::None { positive: 2 | 3, negative: 1 | 4 } = found else { panic!("{found}") };
    let none = Existence::None { positive: 2, negative: 1 };
    assert_eq!(none.to_string(), "no orbit: b_{n,2} > 0 > b_{n,1}");
    assert_eq!(serde_json::to_string(&none).unwrap(), r#"{"none":{"positive":2,"negative":1}}"#);
    let quantity = Quantity::B { n: 5, k: 4 };
    let decision = ladder.sign(&point, quantity);
    assert_eq!(format!("{quantity} {} {}", decision.answer, decision.rung), "b_{5,4} - f64 interval");
    assert_eq!(serde_json::to_string(&decision).unwrap(), r#"{"answer":"-","rung":"f64 interval"}"#);
}

#[test]
fn period_8_as_in_the_paper() {
    let rows: Vec<_> =
        intervals(8).unwrap().map(|i| format!("{} ({}, {})", i.case, i.left, i.right)).collect();
    let paper =
        ["(-,+) (0, 1/16)", "(+,+) (1/16, 1/8)", "(+,-) (1/8, 1/7)", "(+,+) (1/3, 3/8)", "(+,-) (3/8, 2/5)"];
    assert_eq!(rows, paper);
    let deciding: Vec<_> = intervals(8).unwrap().map(|i| i.deciding).collect();
    assert_eq!(deciding, [None, Some(7), Some(1), Some(5), Some(3)]);
}

#[test]
fn periods_1_and_2_follow_the_summary_by_period() {
    // a₂ = 1, |a₁| < 2: period 1 in (+,−) and (−,+); period 2 in (−,+) for a₁ > 0, (+,+) for a₁ < 0.
    let rows = |n| {
        intervals(n).unwrap().map(|i| (signs(i.case), plain(&i.left), plain(&i.right))).collect::<Vec<_>>()
    };
    assert_eq!(rows(1), [((1, -1), (0, 1), (1, 2)), ((-1, 1), (0, 1), (1, 2))]);
    assert_eq!(rows(2), [((-1, 1), (0, 1), (1, 4)), ((1, 1), (1, 4), (1, 2))]);
    for n in [1, 2] {
        assert_eq!(decide(n).unwrap().disagreement, None);
        for (case, left, right) in rows(n) {
            assert!(common::cases(n.into(), common::middle(left, right)).contains(&case));
        }
    }
}

#[test]
fn there_are_phi_plus_one_intervals() {
    for n in 1..=2000u64 {
        let phi = (1..=n).filter(|m| m.gcd(&n) == 1).count();
        assert_eq!(intervals(n).unwrap().count(), phi + 1, "n = {n}");
    }
}

#[test]
fn both_routes_agree() {
    let last = 300;
    let key = |i: &Interval| (i.n, i.left, i.case);
    let mut from_tree: Vec<Interval> = tree_intervals(last).unwrap().collect();
    from_tree.sort_by_key(key);
    let mut by_inverse: Vec<Interval> = (3..=last).flat_map(|n| intervals(n).unwrap()).collect();
    by_inverse.sort_by_key(key);
    assert_eq!(from_tree, by_inverse);
}

#[test]
fn out_of_range_periods_are_errors() {
    for n in [0, u64::MAX] {
        assert!(intervals(n).err().unwrap().is_input());
        assert!(tree_intervals(n).err().unwrap().is_input());
        assert!(decide(n).unwrap_err().is_input());
    }
}

#[test]
fn claim_agrees_with_brute_force() {
    for n in 3..=60 {
        let claimed = intervals(n).unwrap().map(|i| {
            let (emu, gamma) = signs(i.case);
            (plain(&i.left), plain(&i.right), emu, gamma)
        });
        assert_eq!(claimed.collect::<Vec<_>>(), common::theorem(n.into()), "n = {n}");
    }
}

/// The decision, cell by cell: where an orbit exists and why not elsewhere, at every cut and in every cell.
#[test]
fn decision_agrees_with_brute_force() {
    for n in 2..=40u64 {
        let big = i128::from(n);
        let pieces = decide(n).unwrap().pieces;
        let cuts = common::cuts(big);
        for pair in cuts.windows(2) {
            let s = common::middle(pair[0], pair[1]);
            let cases = common::cases(big, s);
            let piece = pieces
                .iter()
                .find(|piece| match piece {
                    Piece::Orbit { left, right, .. } | Piece::Stretch { left, right, .. } => {
                        !common::less(s, plain(left)) && common::less(s, plain(right))
                    }
                    Piece::Point { .. } => false,
                })
                .unwrap_or_else(|| panic!("n = {n}: nothing covers {s:?}"));
            match piece {
                Piece::Orbit { case, .. } => assert_eq!(cases, [signs(*case)], "n = {n}, s = {s:?}"),
                Piece::Stretch { positive, negative, .. } => {
                    assert_eq!(cases, [], "n = {n}, s = {s:?}");
                    assert_eq!(common::sign_b(big, (*positive).into(), s), Some(1));
                    assert_eq!(common::sign_b(big, (*negative).into(), s), Some(-1));
                }
                Piece::Point { .. } => unreachable!(),
            }
        }
        let points: Vec<_> = pieces
            .iter()
            .filter_map(|piece| match piece {
                Piece::Point { at, reason } => Some((plain(at), *reason)),
                _ => None,
            })
            .collect();
        for &s in &cuts[1..cuts.len() - 1] {
            let b: Vec<_> = (1..big).map(|k| common::sign_b(big, k, s)).collect();
            let opposite = b.contains(&Some(1)) && b.contains(&Some(-1));
            match points.iter().find(|(at, _)| *at == s) {
                Some((_, Reason::Singular)) => assert!(common::singular(big, s), "n = {n}, s = {s:?}"),
                Some((_, Reason::Boundary(k))) => {
                    assert!(!common::singular(big, s) && !opposite, "n = {n}, s = {s:?}");
                    assert_eq!(common::sign_b(big, (*k).into(), s), Some(0));
                }
                Some((_, Reason::Excluded { positive, negative })) => {
                    assert!(!common::singular(big, s));
                    assert_eq!(common::sign_b(big, (*positive).into(), s), Some(1));
                    assert_eq!(common::sign_b(big, (*negative).into(), s), Some(-1));
                }
                None => assert!(opposite && !common::singular(big, s), "n = {n}: {s:?} inside a stretch"),
            }
        }
    }
}

#[test]
fn theorem_2_holds_up_to_300() {
    for n in 1..=300 {
        let decision = decide(n).unwrap();
        assert_eq!(decision.disagreement, None, "n = {n}");
        let orbits = decision.pieces.iter().filter(|piece| matches!(piece, Piece::Orbit { .. })).count();
        assert_eq!(orbits, intervals(n).unwrap().count());
    }
}

/// A period and an s = p/q in [0, ½) with q ≤ 2n, as cuts are.
fn period_and_point() -> impl Strategy<Value = (u64, Ratio<u64>)> {
    (2u64..200)
        .prop_flat_map(|n| (Just(n), 1..=2 * n))
        .prop_flat_map(|(n, q)| (Just(n), (0..q.div_ceil(2)).prop_map(move |p| Ratio::new(p, q))))
}

proptest! {
    #![proptest_config(common::config())]

    #[test]
    fn signs_agree_with_brute_force((n, s) in period_and_point()) {
        let (big, (a, c)) = (i128::from(n), plain(&s));
        let at = Signs::new(n, &s, Approach::At);
        let right = Signs::new(n, &s, Approach::JustRight);
        // Nothing changes sign within 1/(4n²) of s: cuts differ by more than that.
        let beside = (a * 16 * big * big + c, c * 16 * big * big);
        let all: Vec<i8> = right.all_b().collect();
        for k in 1..n {
            prop_assert_eq!(i32::from(at.b(k)), common::sign_b(big, k.into(), (a, c)).unwrap_or(0));
            prop_assert_eq!(i32::from(right.b(k)), common::sign_b(big, k.into(), beside).unwrap());
            prop_assert_eq!(right.b(k), all[k.min(n - k) as usize - 1]);
        }
        prop_assert_eq!(at.singular(), common::singular(big, (a, c)));
        if a > 0 {
            prop_assert_eq!(i32::from(right.c()), common::sign_c(big, beside).unwrap());
        }
    }
}

/// Enclosures prove the theorem too, cut (0, ½) their own way, and every witness stands up to the oracle.
#[test]
fn enclosures_agree_with_the_exact_decision() {
    for n in 1..=60 {
        let Enclosed::Decided(decision) = decide_by_enclosure(n).unwrap() else { panic!("n = {n} is open") };
        assert_eq!(decision.disagreement, None, "n = {n}");
        let exact = decide(n).unwrap();
        let kept = |piece: &&Piece| matches!(piece, Piece::Orbit { .. });
        assert!(decision.pieces.iter().filter(kept).eq(exact.pieces.iter().filter(kept)), "n = {n}");
        let mut end = Ratio::new(0, 1);
        for piece in &decision.pieces {
            match piece {
                Piece::Orbit { left, right, .. } if n == 1 => assert!(*left <= end && *right >= end),
                Piece::Orbit { left, .. } | Piece::Stretch { left, .. } => assert_eq!(*left, end, "n = {n}"),
                Piece::Point { at, .. } => assert_eq!(*at, end, "n = {n}"),
            }
            if let Piece::Orbit { right, .. } | Piece::Stretch { right, .. } = piece {
                end = *right;
            }
            if let &Piece::Stretch { ref left, ref right, positive, negative } = piece {
                let middle = common::middle(plain(left), plain(right));
                let signs = [positive, negative].map(|k| common::sign_b(n.into(), k.into(), middle));
                assert_eq!(signs, [Some(1), Some(-1)], "n = {n}, {piece:?}");
            }
        }
        assert_eq!(end, Ratio::new(1, 2), "n = {n}");
    }
    let [exact, interval, both] = [ProofMethod::Exact, ProofMethod::Interval, ProofMethod::Both]
        .map(|method| prove_theorem2(1..=150, method, &()).unwrap());
    for proof in [&interval, &both] {
        assert_eq!(
            (proof.periods, proof.undecided, proof.contradiction, &proof.refuted),
            (150, 0, None, &None)
        );
    }
    // One only counts pieces, the other has them.
    assert_eq!(exact, both);
}
