//! The word theorem against the definition: which periods occur by every b_{n,k}, and which follow which by
//! (64), in exact fractions written out here.

mod certificate;
use crate::common;
mod exhaustive;
mod forms;
mod returns;

use common::{Fraction, config, middle, sign_b, sign_sin, singular};
use grazing::existence::{Boundary, Case, intervals};
use grazing::local::{Ladder, Plane, Point, Polar};
use grazing::word::{Edge, Extent, Letter, Relation, Word, two_impacts, two_impacts_of};
use num_rational::BigRational;
use num_traits::{One, Pow, Signed, Zero};
use proptest::prelude::*;

type Q = BigRational;

fn q(p: i64, d: i64) -> Q {
    Q::new(p.into(), d.into())
}

/// u_0, …, u_last at (a₁, a₂).
fn u(a1: &Q, a2: &Q, last: usize) -> Vec<Q> {
    let mut u = vec![Q::zero(), Q::one()];
    for k in 1..last {
        let next = a1 * &u[k] - a2 * &u[k - 1];
        u.push(next);
    }
    u
}

/// The periods up to `last` with u_n ≠ 0 and every b_{n,k} of the sign of eµ, by (59).
fn occurring(a2: &Q, u: &[Q], positive: bool, last: usize) -> Vec<u64> {
    let sign = |x: &Q| if positive { x.is_positive() } else { x.is_negative() };
    let b = |n: usize, k: usize| (&u[n] - &u[k] - Pow::pow(a2, k) * &u[n - k]) / &u[n];
    (1..=last).filter(|&n| !u[n].is_zero() && (1..n).all(|k| sign(&b(n, k)))).map(|n| n as u64).collect()
}

/// σ(p_j − q_i) as (64) has it.
fn follows(a2: &Q, u: &[Q], i: u64, j: u64, sigma: bool) -> Edge {
    let (i, j) = (i as usize, j as usize);
    let p = (&u[j + 1] - Q::one()) / &u[j];
    let q = (Pow::pow(a2, i) + a2 * &u[i - 1]) / &u[i];
    let difference = if sigma { p - q } else { q - p };
    if difference.is_zero() {
        Edge::Open
    } else if difference.is_positive() {
        Edge::Yes
    } else {
        Edge::No
    }
}

const LAST: u64 = 20;

/// Compares word and relation with the definition at one point.
fn compare(a1: &Q, a2: &Q) {
    let point = Point::Plane(Plane::new(a1.clone(), a2.clone()).unwrap());
    let ladder = Ladder::default();
    let u = u(a1, a2, LAST as usize + 2);
    for positive in [true, false] {
        let word = Word::at(&ladder, &point, positive, 100, &()).unwrap();
        if matches!(word.extent(), Extent::Line | Extent::Odd) {
            assert_eq!(a1.abs(), a2 + Q::one());
        }
        assert!(!matches!(word.extent(), Extent::Undecided { .. }), "{a1} {a2}: {:?}", word.extent());
        let mut found: Vec<u64> = word.up_to(LAST).iter().map(|vertex| vertex.period).collect();
        found.sort_unstable();
        assert_eq!(found, occurring(a2, &u, positive, LAST as usize), "{a1} {a2} eµ > 0: {positive}");
        for gamma in [true, false] {
            let relation = Relation::new(&word, gamma, false, LAST).unwrap();
            for &i in &found {
                for &j in &found {
                    let expected = follows(a2, &u, i, j, positive == gamma);
                    assert_eq!(relation.edge(i, j), expected, "{a1} {a2} {i} -> {j}, {positive} {gamma}");
                }
            }
            // W6: a cycle through two periods, one of them with a loop, needs two loops, the second perhaps
            // beyond LAST.
            let chaotic = Relation::new(&word, gamma, false, 1000).unwrap().is_chaotic();
            let cycles = found.iter().any(|&i| {
                let edge = |i, j| relation.edge(i, j) == Edge::Yes;
                found.iter().any(|&j| i != j && edge(i, j) && edge(j, i) && (edge(i, i) || edge(j, j)))
            });
            assert!(!cycles || chaotic || !word.is_whole(), "{a1} {a2} {positive} {gamma}");
        }
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn words_agree_with_the_definition(a1 in -2400i64..2400, a2 in 1i64..=1000) {
        compare(&q(a1, 1000), &q(a2, 1000));
    }

    #[test]
    fn words_agree_near_the_circle(a1 in -19_999i64..20_000, exponent in 4u32..9) {
        compare(&q(a1, 10_000), &(Q::one() - q(1, 10i64.pow(exponent))));
    }

    #[test]
    fn words_agree_for_large_and_small_numbers(
        a1 in -4i64..=4, d1 in 1i64..60, a2 in 1i64..60, d2 in 1i64..60, shift in -30i32..30,
    ) {
        prop_assume!(a2 <= d2);
        let a1 = q(a1, d1) * Pow::pow(&q(2, 1), shift);
        compare(&a1, &q(a2, d2));
    }
}

/// Points where something vanishes: u_n = 0 by Niven's theorem, a₂ = 1 with rational s, equal eigenvalues,
/// lines.
#[test]
fn words_agree_where_quantities_vanish() {
    for a2 in [q(1, 1), q(1, 4), q(1, 9), q(9, 16), q(1, 2), q(1, 3), q(2, 3), q(1, 1000)] {
        for a1 in [
            q(0, 1),
            q(1, 1),
            q(-1, 1),
            q(1, 2),
            q(-1, 2),
            q(2, 3),
            q(-2, 3),
            q(2, 1),
            q(-2, 1),
            q(3, 2),
            q(-3, 2),
        ] {
            compare(&a1, &a2);
        }
        // |a₁| = a₂ + 1, and next to it.
        for sign in [1, -1] {
            let line = (&a2 + Q::one()) * q(sign, 1);
            compare(&line, &a2);
            compare(&(&line + q(1, 1_000_000)), &a2);
            compare(&(&line - q(1, 1_000_000)), &a2);
        }
    }
}

/// The deciding b is zero: b_{3,1} = 0 at (−(1 + a₂)²… ), found by solving N_{3,1} = a₁² − a₂ − 1 − a₂a₁ =
/// (a₁ + 1)(a₁ − a₂ − 1).
#[test]
fn a_vanishing_deciding_b_leaves_one_edge_open() {
    // N_{3,1} = 0 at a₁ = −1, in region 3 for a₂ > 1/4, with s > 1/4: 3 has letter D iff u_3 = a₁² − a₂ = 1 −
    // a₂ > 0.
    let a2 = q(1, 2);
    compare(&q(-1, 1), &a2);
    let point = Point::Plane(Plane::new(q(-1, 1), a2).unwrap());
    let word = Word::at(&Ladder::default(), &point, true, 10, &()).unwrap();
    assert!(matches!(word.extent(), Extent::Boundary { next: 3, deciding: Some(_) }), "{:?}", word.extent());
    assert!(Relation::new(&word, true, false, 10).unwrap().is_open());
}

/// On r = 1 at rational s, where u_n = 0 at the end of the path and everything is an integer sign.
#[test]
fn words_on_the_circle() {
    let ladder = Ladder::default();
    for den in 3i128..30 {
        for num in (1..den).filter(|&p| 2 * p < den) {
            let s: Fraction = (num, den);
            let point = Point::Polar(Polar::new(Q::one(), q(num as i64, den as i64)).unwrap());
            for positive in [true, false] {
                let word = Word::at(&ladder, &point, positive, 1000, &()).unwrap();
                let mut found: Vec<u64> = word.up_to(30).iter().map(|vertex| vertex.period).collect();
                found.sort_unstable();
                let wanted = if positive { 1 } else { -1 };
                let occurs = |n: i128| !singular(n, s) && (1..n).all(|k| sign_b(n, k, s) == Some(wanted));
                let expected: Vec<u64> = (1..=30).filter(|&n| occurs(n)).map(|n| n as u64).collect();
                assert_eq!(found, expected, "s = {num}/{den}, {positive}");
                let relation = Relation::new(&word, true, false, 30).unwrap();
                for &i in &found {
                    for &j in &found {
                        assert_eq!(relation.edge(i, j), on_circle(i, j, s, positive), "{i} {j} {num}/{den}");
                    }
                }
            }
        }
    }
}

/// Whether j may follow i on r = 1, γ > 0: p_j − q_i = N_{i+j,i}/(u_i u_j), N_{n,k} ~ −sin nπs sin kπs sin
/// (n−k)πs.
fn on_circle(i: u64, j: u64, (p, q): Fraction, positive: bool) -> Edge {
    let (i, j) = (i128::from(i), i128::from(j));
    let numerator = -sign_sin((i + j) * p, q) * sign_sin(i * p, q) * sign_sin(j * p, q);
    let sign = numerator * sign_sin(2 * i * p, q) * sign_sin(2 * j * p, q) * if positive { 1 } else { -1 };
    match sign {
        0 => Edge::Open,
        1 => Edge::Yes,
        _ => Edge::No,
    }
}

/// The Farey intervals of two-impact patterns, against the signs between all break points.
#[test]
fn two_impact_intervals_agree_with_the_signs() {
    for j in 2u64..11 {
        for i in 1..j {
            let claimed = two_impacts(i, j).unwrap();
            let mut cuts: Vec<Fraction> =
                (1..=i128::from(2 * (i + j))).flat_map(|d| (0..=d / 2).map(move |p| (p, d))).collect();
            cuts.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
            cuts.dedup_by(|a, b| a.0 * b.1 == b.0 * a.1);
            for pair in cuts.windows(2) {
                let s = middle(pair[0], pair[1]);
                for (positive, gamma) in [(true, true), (true, false), (false, true), (false, false)] {
                    let wanted = if positive { 1 } else { -1 };
                    let occurs = |n: u64| (1..i128::from(n)).all(|k| sign_b(n.into(), k, s) == Some(wanted));
                    let edge = |i, j| {
                        let edge = on_circle(i, j, s, positive);
                        edge == if gamma { Edge::Yes } else { Edge::No }
                    };
                    let exists = occurs(i) && occurs(j) && edge(i, j) && edge(j, i);
                    let at = |x: &num_rational::Ratio<u64>| (i128::from(*x.numer()), i128::from(*x.denom()));
                    let inside = claimed.iter().any(|interval| {
                        let (left, right) = (at(&interval.left), at(&interval.right));
                        let case = interval.case == case(positive, gamma);
                        case && left.0 * s.1 < s.0 * left.1 && s.0 * right.1 < right.0 * s.1
                    });
                    assert_eq!(inside, exists, "({i}, {j}) at {s:?}, {positive} {gamma}");
                }
            }
        }
    }
}

fn case(positive: bool, gamma: bool) -> Case {
    match (positive, gamma) {
        (true, true) => Case::PlusPlus,
        (true, false) => Case::PlusMinus,
        (false, true) => Case::MinusPlus,
        (false, false) => Case::MinusMinus,
    }
}

/// Ends that touch are break points of the pattern, so that no two intervals of one case are one.
#[test]
fn numbers_of_intervals_by_period() {
    let found: Vec<usize> = (3..=26).map(|n| two_impacts_of(n).unwrap().count()).collect();
    // Counted by a program of another kind, from the signs between break points.
    let expected =
        [3, 4, 8, 8, 12, 15, 18, 20, 24, 28, 32, 41, 34, 41, 50, 54, 58, 69, 59, 77, 72, 82, 80, 108];
    assert_eq!(found, expected);
}

/// The word of an area, as the figure draws it, is that of a point inside it just above its lower edge.
#[test]
fn words_of_areas_are_words_of_points_in_them() {
    let ladder = Ladder::default();
    for n in 3u64..=11 {
        for interval in intervals(n).unwrap().filter(|interval| interval.deciding.is_some()) {
            let (left, right) = (&interval.left, &interval.right);
            let s = q(
                (left.numer() * right.denom() + right.numer() * left.denom()) as i64,
                (2 * left.denom() * right.denom()) as i64,
            );
            let Some(edge) = Boundary::new(interval.clone()).at(&s, 12).unwrap() else {
                panic!("{interval:?}")
            };
            let r = &edge.upper + q(1, 1_000_000_000);
            let at = Word::at(&ladder, &Point::Polar(Polar::new(r, s).unwrap()), true, 100, &()).unwrap();
            let letter = if interval.case == Case::PlusPlus { Letter::U } else { Letter::D };
            let of = Word::of_area(n, interval.m, letter, at.vertices()[1].period).unwrap();
            assert_eq!((at.vertices(), at.extent()), (of.vertices(), of.extent()), "{interval:?}");
            for (i, j) in (0..at.vertices().len()).flat_map(|i| (0..at.vertices().len()).map(move |j| (i, j)))
            {
                assert_eq!(at.edge(i, j, true), of.edge(i, j, true));
            }
        }
    }
    assert_eq!(Word::of_area(6, 2, Letter::U, 3), None);
    assert_eq!(Word::of_area(5, 3, Letter::U, 2), None);
}

/// s far from everything small: the path is walked without listing what is skipped.
#[test]
fn ends_of_the_range() {
    let ladder = Ladder::default();
    let tiny =
        Point::Polar(Polar::new(q(1, 2), Q::new(1.into(), num_bigint::BigInt::from(10).pow(15u32))).unwrap());
    let word = Word::at(&ladder, &tiny, true, 10, &()).unwrap();
    assert_eq!(word.vertices()[1].period, 500_000_000_000_001);
    let below = Word::at(&ladder, &tiny, false, 10, &()).unwrap();
    assert_eq!((below.vertices().len(), below.extent()), (10, Extent::Cut));
    // 1/(2s) does not fit: said, not wrapped.
    let beyond =
        Point::Polar(Polar::new(q(1, 2), Q::new(1.into(), num_bigint::BigInt::from(10).pow(40u32))).unwrap());
    assert_eq!(Word::at(&ladder, &beyond, true, 10, &()).unwrap().extent(), Extent::Cut);
    for limit in [0, grazing::word::MAX_LETTERS + 1] {
        assert!(Word::at(&ladder, &tiny, true, limit, &()).unwrap_err().is_input());
    }
    // Over all periods the graph is never whole, and is not built without end.
    let two = Point::Plane(Plane::new(q(14, 10), q(42, 100)).unwrap());
    let all = Word::at(&ladder, &two, false, 10, &()).unwrap();
    assert_eq!(all.extent(), Extent::All);
    assert!(Relation::new(&all, true, false, u64::MAX).unwrap_err().is_input());
    let outside = Point::Plane(Plane::new(q(1, 1), q(3, 2)).unwrap());
    assert!(Word::at(&ladder, &outside, true, 10, &()).unwrap_err().is_input());
}
