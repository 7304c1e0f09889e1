//! Theorem 1 for impact patterns: the block solver against a dense one, hard cases, invariance, two
//! dimensions against closed forms, and predictions against a smooth map iterated at small µ.

use crate::common;

use grazing::{
    existence::{Existence, Resonance, by_definition, large_eigenvalue_sign},
    local::{Ladder, Plane, Point},
    number::{Ball, FloatInterval, Precision, Real, Sign, parse_rational},
    pattern::{
        Analysis, Coordinates, Entry, Failure, Graph, Map, Numbers, OpenReason, Pattern, PatternExistence,
        Patterns, Report, Value, predicted_orbit, solve,
    },
    word::{ClosedWalks, Entropy, PatternCount},
};
use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;

type Q = BigRational;
type Dense = Vec<Vec<Q>>;

fn q(text: &str) -> Q {
    parse_rational(text).unwrap()
}

fn whole(x: i64) -> Q {
    Q::from_integer(x.into())
}

fn build(a: &Dense, b: &[Q], c: &[Q], e: i64) -> Map {
    let list = |v: &[Q]| v.iter().cloned().map(Entry::from).collect::<Vec<_>>();
    Map::new(a.iter().map(|row| list(row)).collect(), list(b), list(c), whole(e).into(), None).unwrap()
}

fn times(a: &Dense, b: &Dense) -> Dense {
    let entry = |row: &Vec<Q>, j: usize| row.iter().zip(b).map(|(x, other)| x * &other[j]).sum();
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

fn apply(a: &Dense, v: &[Q]) -> Vec<Q> {
    a.iter().map(|row| row.iter().zip(v).map(|(x, y)| x * y).sum()).collect()
}

fn identity(size: usize) -> Dense {
    (0..size).map(|i| (0..size).map(|j| whole(i64::from(i == j))).collect()).collect()
}

fn power(a: &Dense, k: u64) -> Dense {
    (0..k).fold(identity(a.len()), |p, _| times(a, &p))
}

/// Plain Gaussian elimination; `None` if singular.
fn gauss(mut rows: Dense) -> Option<Vec<Q>> {
    let n = rows.len();
    for c in 0..n {
        let p = (c..n).find(|&i| !rows[i][c].is_zero())?;
        rows.swap(c, p);
        let pivot = rows[c].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != c && !row[c].is_zero() {
                let factor = &row[c] / &pivot[c];
                row.iter_mut().zip(&pivot).for_each(|(x, y)| *x -= &factor * y);
            }
        }
    }
    Some((0..n).map(|i| &rows[i][n] / &rows[i][i]).collect())
}

/// The dense m(N+1) system (28), (32) as written: Z = (X₁, Y₁, …), or `None` if det D = 0.
fn dense(a: &Dense, b: &[Q], c: &[Q], periods: &[u64]) -> Option<(Vec<Vec<Q>>, Vec<Q>)> {
    let (size, m) = (a.len(), periods.len());
    let width = m * (size + 1);
    let mut rows = vec![vec![Q::zero(); width + 1]; width];
    for (i, &n) in periods.iter().enumerate() {
        let (own, next) = (i * (size + 1), (i + 1) % m * (size + 1));
        let p = power(a, n);
        for r in 0..size {
            for k in 0..size {
                rows[own + r][own + k] -= &p[r][k];
            }
            rows[own + r][own + size] -= &b[r];
            rows[own + r][next + r] += Q::one();
        }
        for k in 0..size {
            rows[own + size][own + k] = (0..size).map(|r| &c[r] * &p[r][k]).sum();
        }
        rows[own + size][width] = -Q::one();
    }
    let z = gauss(rows)?;
    let blocks = z.chunks(size + 1);
    Some((blocks.clone().map(|z| z[..size].to_vec()).collect(), blocks.map(|z| z[size].clone()).collect()))
}

fn sign(x: &Q) -> i32 {
    if x.is_zero() {
        0
    } else if x.is_positive() {
        1
    } else {
        -1
    }
}

/// Theorem 1 as it is written, from the dense solution: for eµ > 0 and for eµ < 0, `None` where it is silent.
fn theorem(a: &Dense, b: &[Q], c: &[Q], periods: &[u64]) -> [Option<bool>; 2] {
    let Some((x, y)) = dense(a, b, c, periods) else { return [None, None] };
    let mut signs: Vec<i32> = y.iter().map(sign).collect();
    for (x, &n) in x.iter().zip(periods) {
        for k in 1..n {
            let value: Q = apply(&power(a, k), x).iter().zip(c).map(|(x, c)| x * c).sum();
            signs.push(sign(&(value + Q::one())));
        }
    }
    [1, -1].map(|side| match signs.iter().map(|s| s * side).min() {
        Some(1) => Some(true),
        Some(0) => None,
        _ => Some(false),
    })
}

/// Of one impact in two dimensions at a resonance, where the dense system is singular: whether an orbit is
/// born, by the second order's conditions C Aᵏ (I − Aⁿ)⁻¹ B > 0 for 0 < k < n as they are written; `None`
/// elsewhere.
fn born_at_resonance(a: &Dense, b: &[Q], c: &[Q], periods: &[u64]) -> Option<bool> {
    let ([n], 2, None) = (periods, a.len(), dense(a, b, c, periods)) else { return None };
    let det = &a[0][0] * &a[1][1] - &a[0][1] * &a[1][0];
    let p = power(a, *n);
    let rows = (0..2).map(|i| {
        vec![whole(i64::from(i == 0)) - &p[i][0], whole(i64::from(i == 1)) - &p[i][1], b[i].clone()]
    });
    let x = gauss(rows.collect()).filter(|_| det.is_positive() && det < Q::one())?;
    let signs = (1..*n).map(|k| sign(&apply(&power(a, k), &x).iter().zip(c).map(|(x, c)| x * c).sum()));
    Some(signs.min() == Some(1))
}

fn sides(report: &Report) -> [Option<bool>; 2] {
    [report.plus, report.minus].map(|side| match side {
        PatternExistence::Orbit => Some(true),
        PatternExistence::NoOrbit => Some(false),
        PatternExistence::Open => None,
    })
}

fn contains(value: &Value, x: &Q) -> bool {
    match value {
        Value::Exact(y) => x == y,
        Value::Enclosed(y) => y.contains(x),
    }
}

/// Every number and verdict of every engine against the dense solver.
fn compare(a: &Dense, b: &[Q], c: &[Q], patterns: &[Vec<u64>]) {
    let map = build(a, b, c, 1);
    let last = patterns.iter().flatten().copied().max().unwrap();
    let enclosed = Analysis::new(&map, last, Numbers::Enclosed);
    let exact = Analysis::new(&map, last, Numbers::Exact);
    let graph = (a.len() == 2).then(|| Graph::new(&map, last, true).unwrap());
    for periods in patterns {
        let born = born_at_resonance(a, b, c, periods);
        let expected = if born == Some(false) { [Some(false); 2] } else { theorem(a, b, c, periods) };
        let silent = match born {
            Some(false) => None,
            Some(true) => Some(OpenReason::Resonance),
            None => Some(OpenReason::Singular),
        };
        let solution = dense(a, b, c, periods);
        let mut reports = vec![enclosed.judge(periods), exact.judge(periods)];
        reports.extend(graph.as_ref().map(|graph| graph.judge(periods)));
        for report in reports {
            assert_eq!(sides(&report), expected, "{periods:?} {a:?}");
            match &solution {
                None => {
                    assert_eq!((report.reason, report.orbit.is_none()), (silent, true), "{periods:?} {a:?}")
                }
                Some((x, y)) => {
                    let orbit = report.orbit.unwrap();
                    assert!(
                        orbit.x.iter().flatten().zip(x.iter().flatten()).all(|(v, x)| contains(v, x)),
                        "{periods:?}"
                    );
                    assert!(orbit.y.iter().zip(y).all(|(v, y)| contains(v, y)), "{periods:?}");
                    let least = y.iter().min().unwrap();
                    assert!(
                        contains(&orbit.margins(true).1, least)
                            && contains(&-orbit.margins(false).1, y.iter().max().unwrap())
                    );
                    if y.iter().all(|y| !y.is_zero()) {
                        let factor = |(y, &n): (&Q, &u64)| {
                            let response: Q = apply(&power(a, n), b).iter().zip(c).map(|(x, c)| x * c).sum();
                            -response / (y * whole(2))
                        };
                        let leading: Q = y.iter().zip(periods).map(factor).product();
                        assert!(contains(&orbit.leading.unwrap(), &leading));
                        // Where no orbit exists on either side, no engine is asked to climb for this sign; a
                        // zero of it (C A^n B = 0) is seen by exact fractions alone.
                        match orbit.leading_sign {
                            Some(sign) => assert_eq!(sign, Sign::of(&leading), "{periods:?}"),
                            None => {
                                let exists = expected.contains(&Some(true));
                                assert!(!matches!(orbit.y[0], Value::Exact(_)), "{periods:?}");
                                assert!(!exists || leading.is_zero(), "{periods:?}");
                            }
                        }
                    }
                }
            }
        }
    }
}

fn random_map(size: usize, numbers: &[i64]) -> (Dense, Vec<Q>, Vec<Q>) {
    let mut numbers = numbers.iter().cycle();
    let mut next = || Q::new((*numbers.next().unwrap()).into(), 7.into());
    let a: Dense = (0..size).map(|_| (0..size).map(|_| next()).collect()).collect();
    let mut c: Vec<Q> = (0..size).map(|_| next()).collect();
    let mut b: Vec<Q> = (0..size).map(|_| next()).collect();
    if c[0].is_zero() {
        c[0] = Q::one();
    }
    if b[1..].iter().all(Q::is_zero) {
        b[size - 1] = Q::one();
    }
    let rest: Q = b.iter().zip(&c).skip(1).map(|(b, c)| b * c).sum();
    b[0] = -rest / &c[0];
    (a, b, c)
}

fn invertible_difference(a: &Dense) -> bool {
    let size = a.len();
    let mut rows: Dense = identity(size);
    rows.iter_mut().zip(a).for_each(|(row, a)| row.iter_mut().zip(a).for_each(|(x, a)| *x -= a));
    rows.iter_mut().for_each(|row| row.push(Q::zero()));
    gauss(rows).is_some()
}

fn all_patterns(last: u64) -> Vec<Vec<u64>> {
    (1..=last).flat_map(Patterns::of_period).map(|pattern| pattern.periods().to_vec()).collect()
}

/// C A^n B = 0 for a pattern that exists on neither side: `f64` intervals settle the verdict, not that sign.
#[test]
fn a_vanishing_response_of_a_pattern_without_orbits_is_no_sign() {
    let numbers = [
        -5, 0, -2, -6, 5, 3, 4, 2, -8, -6, 4, -7, 6, 7, 1, -8, -5, 7, 4, -3, 8, -6, -8, -6, 2, 8, 5, -4, -7,
        2, 9, -8,
    ];
    let (a, b, c) = random_map(5, &numbers);
    compare(&a, &b, &c, &all_patterns(5));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: crate::samples::samples(6), ..common::config() })]

    /// Existence impacts against the definition in the (a₁, a₂) plane, which knows nothing of matrices:
    /// verdict, case, and the sign of the large eigenvalue by region (3.6).
    #[test]
    fn single_impacts_against_the_plane(p1 in -50i64..51, p2 in 1i64..21) {
        let (a1, a2) = (Q::new(p1.into(), 20.into()), Q::new(p2.into(), 20.into()));
        prop_assume!(a1 != &a2 + Q::one());
        let plane = Plane::new(a1.clone(), a2.clone()).unwrap();
        let region = plane.region();
        let (ladder, point) = (Ladder::default(), Point::Plane(plane));
        let a = vec![vec![a1, Q::one()], vec![-a2, Q::zero()]];
        for gamma in [1i8, -1] {
            let map = build(&a, &[Q::zero(), whole(gamma.into())], &[Q::one(), Q::zero()], 1);
            let graph = Graph::new(&map, 14, false).unwrap();
            for n in 1..=14 {
                let report = graph.judge(&[n]);
                let single = by_definition(&ladder, &point, n);
                let case = single.cases(n).into_iter().find(|case| case.sign_gamma() == gamma);
                let expected = case.map(|case| case.sign_emu() == 1);
                prop_assert_eq!(report.side(), expected, "n = {}, {:?}", n, single);
                match single {
                    Existence::Orbit(_) | Existence::None { .. } => prop_assert!(!report.is_open()),
                    Existence::Singular => {
                        let silent = match (Resonance::at(&point, n), gamma) {
                            (None, _) => Some(OpenReason::Singular),
                            (Some(Resonance::First), 1) => Some(OpenReason::Resonance),
                            _ => None,
                        };
                        prop_assert_eq!(report.reason, silent);
                    }
                    Existence::Iterate(_) | Existence::SignBoundary => {
                        prop_assert!(matches!(report.reason, None | Some(OpenReason::Zero(_))));
                    }
                    Existence::Undecided => prop_assert!(false),
                }
                if let (Some(case), Some(orbit)) = (case, report.orbit) {
                    let sign = if large_eigenvalue_sign(region, n, case) > 0 { Sign::Positive } else { Sign::Negative };
                    prop_assert_eq!(orbit.eigenvalue_sign(case.sign_emu() == 1), Some(sign));
                }
            }
        }
    }

    #[test]
    fn block_solver_against_dense(size in 2usize..6, numbers in prop::collection::vec(-9i64..10, 7..40)) {
        let (a, b, c) = random_map(size, &numbers);
        prop_assume!(invertible_difference(&a));
        compare(&a, &b, &c, &all_patterns(5));
    }

    /// (12)–(14): verdicts and Y are those of the section chosen; X goes with P.
    #[test]
    fn section_changes_change_nothing(size in 2usize..5, numbers in prop::collection::vec(-9i64..10, 7..40), shear in -5i64..6) {
        let (a, b, c) = random_map(size, &numbers);
        prop_assume!(invertible_difference(&a));
        // P unit lower times unit upper triangular: always invertible, its inverse by elimination.
        let triangle = |lower: bool| -> Dense {
            (0..size).map(|i| (0..size).map(|j| whole(match i.cmp(&j) {
                std::cmp::Ordering::Equal => 1,
                order => if (order == std::cmp::Ordering::Greater) == lower { shear + i as i64 - j as i64 } else { 0 },
            })).collect()).collect()
        };
        let p = times(&triangle(true), &triangle(false));
        let columns: Vec<Vec<Q>> = (0..size).map(|j| {
            gauss(p.iter().enumerate().map(|(i, row)| {
                row.iter().cloned().chain([whole(i64::from(i == j))]).collect()
            }).collect()).unwrap()
        }).collect();
        let inverse: Dense = (0..size).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect();
        let changed = (times(&p, &times(&a, &inverse)), apply(&p, &b), times(&vec![c.clone()], &inverse).remove(0));
        let plain = build(&a, &b, &c, 1);
        let moved = build(&changed.0, &changed.1, &changed.2, 1);
        let list = |v: &[Q]| v.iter().cloned().map(Entry::from).collect::<Vec<_>>();
        let keyed = Map::new(
            a.iter().map(|row| list(row)).collect(), list(&b), list(&c), whole(1).into(),
            Some(p.iter().map(|row| list(row)).collect()),
        ).unwrap();
        let [plain, moved, keyed] = [&plain, &moved, &keyed].map(|map| Analysis::new(map, 5, Numbers::Exact));
        for periods in all_patterns(5) {
            let [r0, r1, r2] = [&plain, &moved, &keyed].map(|analysis| analysis.judge(&periods));
            prop_assert_eq!(sides(&r0), sides(&r1));
            prop_assert_eq!(sides(&r0), sides(&r2));
            prop_assert_eq!((r0.reason, r0.flat), (r1.reason, r1.flat));
            if let (Some(o0), Some(o1), Some(o2)) = (r0.orbit, r1.orbit, r2.orbit) {
                prop_assert_eq!(&o0.y, &o1.y);
                prop_assert_eq!(&o1.x, &o2.x);
                prop_assert_eq!(&o0.leading, &o1.leading);
                prop_assert_eq!(&o0.gaps, &o1.gaps);
                let exact = |x: &Vec<Value>| -> Vec<Q> {
                    x.iter().map(|x| match x { Value::Exact(x) => x.clone(), _ => unreachable!() }).collect()
                };
                for (x0, x1) in o0.x.iter().zip(&o1.x) {
                    prop_assert_eq!(apply(&p, &exact(x0)), exact(x1));
                }
            }
        }
    }

    /// Existence impacts of period n: (57)–(60) through u_k, no matrix anywhere.
    #[test]
    fn two_dimensions_against_closed_forms(p1 in -40i64..41, p2 in 1i64..21, n in 1u64..12) {
        let (a1, a2) = (Q::new(p1.into(), 20.into()), Q::new(p2.into(), 20.into()));
        prop_assume!(a1 != &a2 + Q::one());
        let mut u = vec![Q::zero(), Q::one()];
        let mut powers = vec![Q::one()];
        for k in 1..=n as usize {
            let next = &a1 * &u[k] - &a2 * &u[k - 1];
            u.push(next);
            powers.push(&powers[k - 1] * &a2);
        }
        let m = n as usize;
        let map = build(&vec![vec![a1, Q::one()], vec![-&a2, Q::zero()]], &[Q::zero(), Q::one()], &[Q::one(), Q::zero()], 1);
        let analysis = Analysis::new(&map, n, Numbers::Exact);
        let report = analysis.judge(&[n]);
        if u[m].is_zero() {
            prop_assert!(report.orbit.is_none());
            prop_assert_eq!(report.flat, Some(n));
            return Ok(());
        }
        let orbit = report.orbit.unwrap();
        let v = &u[m + 1] - &a2 * &u[m - 1];
        let c = -(Q::one() - v + &powers[m]) / &u[m];
        prop_assert_eq!(&orbit.x[0], &vec![Value::Exact(-Q::one()), Value::Exact((&u[m + 1] - Q::one()) / &u[m])]);
        // B = (0, 1)ᵀ, so CAB = 1 and c_n = Y.
        prop_assert_eq!(&orbit.y[0], &Value::Exact(c));
        let b: Vec<Q> = (1..m).map(|k| (&u[m] - &u[k] - &powers[k] * &u[m - k]) / &u[m]).collect();
        let ends = b.iter().min().zip(b.iter().max()).map(|(lo, hi)| [Value::Exact(lo.clone()), Value::Exact(hi.clone())]);
        prop_assert_eq!(orbit.gaps, ends);
    }

    #[test]
    fn shown_digits_are_certain(lo in -1e6f64..1e6, width in 0f64..1.0, scale in 0i32..16) {
        let hi = lo + width * 10f64.powi(-scale);
        let text = Value::Enclosed(FloatInterval::from_bounds(lo, hi)).to_string();
        let exact = |x: f64| Q::from_float(x).unwrap();
        if let Some(ends) = text.strip_prefix('[') {
            let (a, b) = ends.trim_end_matches(']').split_once(", ").unwrap();
            prop_assert!(q(a) <= exact(lo) && exact(hi) <= q(b), "{}", text);
        } else {
            let digits = text.split('e').next().unwrap();
            let decimals = digits.split_once('.').map_or(0, |(_, d)| d.len() as i32);
            let e: i32 = text.split_once('e').map_or(0, |(_, e)| e.parse().unwrap());
            let unit = whole(10).pow(e - decimals);
            prop_assert!((q(&text) - exact(lo)).abs() <= unit && (q(&text) - exact(hi)).abs() <= unit, "{}", text);
        }
    }
}

#[test]
fn hard_cases_against_dense() {
    let row = |texts: &[&str]| texts.iter().map(|text| q(text)).collect::<Vec<Q>>();
    let plane = (row(&["0", "1"]), row(&["1", "0"]));
    let space = (row(&["1", "1", "2"]), row(&["2", "0", "-1"]));
    let two = |rows: [&[&str]; 2]| rows.iter().map(|r| row(r)).collect::<Dense>();
    let three = |rows: [&[&str]; 3]| rows.iter().map(|r| row(r)).collect::<Dense>();
    let flat_cases = [
        // u_3 = a₁² − a₂ = ±10⁻¹², ±10⁻³⁰, 0: D nearly singular, or singular.
        two([&["1/2", "1"], &["-1/4+1e-12", "0"]]),
        two([&["1/2", "1"], &["-1/4-1e-30", "0"]]),
        two([&["1/2", "1"], &["-1/4", "0"]]),
        // An eigenvalue within 10⁻²⁰ of 1; a double eigenvalue; a nilpotent A.
        two([&["3/2-1e-20", "1"], &["-1/2+5e-21", "0"]]),
        two([&["1", "1"], &["-1/4", "0"]]),
        two([&["0", "1"], &["0", "0"]]),
        // Eigenvalues on the unit circle, where quantities are exactly 0.
        two([&["0", "1"], &["-1", "0"]]),
        two([&["-1", "1"], &["-1", "0"]]),
    ];
    for a in &flat_cases {
        compare(a, &plane.0, &plane.1, &all_patterns(6));
    }
    // CAB tiny.
    compare(&flat_cases[3], &row(&["0", "1e-40"]), &plane.1, &all_patterns(4));
    let space_cases = [
        three([&["0", "1", "0"], &["0", "0", "1"], &["0", "0", "0"]]),
        three([&["1/2", "1", "0"], &["0", "1/2", "1"], &["0", "0", "1/2"]]),
        three([&["1-1e-25", "0", "1"], &["0", "-1", "1"], &["1", "0", "1/3"]]),
        three([&["0", "0", "1"], &["1", "0", "0"], &["0", "-1", "0"]]),
    ];
    for a in &space_cases {
        compare(a, &space.0, &space.1, &all_patterns(5));
    }
    // A shift in 5 dimensions, C A^k B = 1 for k = 4 only: the leading term of (36) vanishes elsewhere.
    let shift: Dense = (0..5).map(|i| (0..5).map(|j| whole(i64::from(i + 1 == j))).collect()).collect();
    let unit = |k: usize| (0..5).map(|i| whole(i64::from(i == k))).collect::<Vec<Q>>();
    compare(&shift, &unit(4), &unit(0), &all_patterns(6));
}

/// det D within 10⁻³⁰ of 0 in three dimensions: x is moved to where two large solutions of opposite sign
/// meet.
#[test]
fn nearly_singular_in_three_dimensions() {
    let (b, c) = (vec![whole(0), whole(1), whole(1)], vec![whole(1), whole(0), whole(0)]);
    let family = |t: &Q| {
        vec![
            vec![q("1/3"), t.clone(), q("1")],
            vec![q("1/2"), q("-1/5"), q("2")],
            vec![q("-1"), q("1/7"), q("1/4")],
        ]
    };
    // Y of the pattern (2) is a ratio of polynomials in t; bisect a change of its sign through a pole.
    let y = |t: &Q| dense(&family(t), &b, &c, &[2]).unwrap().1[0].clone();
    let grid: Vec<Q> = (-40..40).map(|k| Q::new((2 * k + 1).into(), 17.into())).collect();
    let mut poles = 0;
    for pair in grid.windows(2) {
        let (mut lo, mut hi) = (pair[0].clone(), pair[1].clone());
        if sign(&y(&lo)) == sign(&y(&hi)) {
            continue;
        }
        for _ in 0..105 {
            let middle = (&lo + &hi) / whole(2);
            if sign(&y(&middle)) == sign(&y(&lo)) { lo = middle } else { hi = middle }
        }
        if y(&lo).abs() > q("1e20") {
            poles += 1;
            for t in [lo, hi] {
                compare(&family(&t), &b, &c, &[vec![2], vec![2, 2], vec![1, 2]]);
            }
        }
    }
    assert!(poles > 0, "the family has a singular boundary");
}

#[test]
fn twenty_dimensions() {
    let entry = |i: usize, j: usize| match (i + 3 * j) % 5 {
        _ if i == j => Q::new(1.into(), (i as i64 + 2).into()),
        0 => Q::new(((i * j) as i64 % 7 - 3).into(), 11.into()),
        _ => Q::zero(),
    };
    let a: Dense = (0..20).map(|i| (0..20).map(|j| entry(i, j)).collect()).collect();
    let mut b = vec![Q::zero(); 20];
    (b[3], b[7], b[19]) = (whole(1), whole(-2), whole(1));
    let mut c = vec![Q::zero(); 20];
    (c[0], c[3], c[7]) = (whole(1), whole(2), whole(1));
    let map = build(&a, &b, &c, 1);
    let analysis = Analysis::new(&map, 3, Numbers::Enclosed);
    for periods in [vec![1], vec![3], vec![1, 2]] {
        let report = analysis.judge(&periods);
        assert_eq!(sides(&report), theorem(&a, &b, &c, &periods));
        let (x, _) = dense(&a, &b, &c, &periods).unwrap();
        assert!(
            report.orbit.unwrap().x.iter().flatten().zip(x.iter().flatten()).all(|(v, x)| contains(v, x))
        );
    }
}

/// Patterns of length 200: repeated ones have the solution of their part, rotated ones the same verdict.
#[test]
fn long_patterns() {
    let a = vec![
        vec![q("0.9"), q("1"), q("0")],
        vec![q("-0.6"), q("0"), q("0.1")],
        vec![q("0.05"), q("0"), q("0.4")],
    ];
    let (b, c) = (vec![q("0"), q("1"), q("0.25")], vec![q("1"), q("0"), q("0")]);
    let map = build(&a, &b, &c, -1);
    let analysis = Analysis::new(&map, 5, Numbers::Enclosed);
    for part in [vec![1, 2], vec![4, 1, 2, 5, 3]] {
        let long: Vec<u64> = part.iter().copied().cycle().take(200).collect();
        let report = analysis.judge(&long);
        assert_eq!(sides(&report), theorem(&a, &b, &c, &part));
        let (_, y) = dense(&a, &b, &c, &part).unwrap();
        assert!(report.orbit.unwrap().y.iter().zip(y.iter().cycle()).all(|(v, y)| contains(v, y)));
    }
    let mut long: Vec<u64> = (0..200u64).map(|i| 1 + i * i % 7 % 5).collect();
    let verdict = sides(&analysis.judge(&long));
    assert!(verdict.iter().all(Option::is_some));
    long.rotate_left(77);
    assert_eq!(sides(&analysis.judge(&long)), verdict);
    // In two dimensions the graph knows.
    let (a, b, c) =
        (vec![vec![q("0.9"), q("1")], vec![q("-0.6"), q("0")]], [q("0"), q("1")], [q("1"), q("0")]);
    let map = build(&a, &b, &c, 1);
    let (analysis, graph) = (Analysis::new(&map, 5, Numbers::Enclosed), Graph::new(&map, 5, false).unwrap());
    for long in [long, vec![4; 200], vec![2; 200]] {
        assert_eq!(sides(&analysis.judge(&long)), sides(&graph.judge(&long)));
    }
}

/// Cyclic words by brute force: all compositions, rotated to the least.
#[test]
fn patterns_are_all_necklaces_once() {
    for n in 1..=12u64 {
        let mut expected: Vec<Vec<u64>> = (0..1u64 << (n - 1))
            .map(|cuts| {
                let mut word = vec![1];
                (0..n - 1).for_each(|i| {
                    if cuts >> i & 1 == 1 { word.push(1) } else { *word.last_mut().unwrap() += 1 }
                });
                (0..word.len()).map(|i| [&word[i..], &word[..i]].concat()).min().unwrap()
            })
            .collect();
        expected.sort();
        expected.dedup();
        let found: Vec<Pattern> = Patterns::of_period(n).collect();
        assert_eq!(found.iter().map(|p| p.periods().to_vec()).collect::<Vec<_>>(), expected);
        for pattern in found {
            let mut rotated = pattern.periods().to_vec();
            rotated.rotate_left(1);
            assert_eq!(Pattern::new(&rotated), Some(pattern.clone()));
            let m = rotated.len();
            let primitive = (1..m).all(|d| m % d != 0 || (0..m).any(|i| rotated[i] != rotated[(i + d) % m]));
            assert_eq!(pattern.is_primitive(), primitive);
        }
    }
    assert_eq!((Pattern::new(&[]), Pattern::new(&[1, 0])), (None, None));
}

/// Enumeration with and without pruning, and the count by closed walks, agree.
#[test]
fn the_graph_counts_what_exists() {
    for (a1, a2) in
        [("0.9", "0.6"), ("2", "0.75"), ("-2", "0.75"), ("-0.3", "0.8"), ("0.2", "0.95"), ("1.3", "0.5")]
    {
        let a = vec![vec![q(a1), q("1")], vec![-q(a2), q("0")]];
        for gamma in [1, -1] {
            let map = build(&a, &[q("0"), whole(gamma)], &[q("1"), q("0")], 1);
            let graph = Graph::new(&map, 11, false).unwrap();
            let analysis = Analysis::new(&map, 11, Numbers::Enclosed);
            for side in [true, false] {
                let walks = graph.walks(side, 11);
                for PatternCount { period: n, all, primitive } in walks.count(11) {
                    let exist = |pattern: &Pattern| graph.judge(pattern.periods()).side() == Some(side);
                    let found: Vec<Pattern> = Patterns::of_period(n).filter(exist).collect();
                    let pruned: Vec<Pattern> =
                        Patterns::walks(n, |i, j| graph.may_follow(i, j)).filter(exist).collect();
                    assert_eq!(found, pruned);
                    assert_eq!(all, BigUint::from(found.len()), "n = {n} at {a1}, {a2}, {gamma}, {side}");
                    assert_eq!(primitive, BigUint::from(found.iter().filter(|p| p.is_primitive()).count()));
                }
            }
            for periods in all_patterns(9) {
                assert_eq!(sides(&graph.judge(&periods)), sides(&analysis.judge(&periods)), "{periods:?}");
            }
        }
    }
}

/// One impact at every resonance θ = mπ/q with rational a₁, a₂, for either sign of γ: born for m = 1 alone,
/// and for γ > 0; patterns of several impacts, and maps with a₂ ≥ 1, stay open.
#[test]
fn at_a_resonance_the_second_order_says_whether_one_impact_is_born() {
    let mut seen = [0; 2];
    for (a1, a2, q0) in [
        ("0", "1/4", 2),
        ("1/2", "1/4", 3),
        ("-1/2", "1/4", 3),
        ("1", "1/2", 4),
        ("-1", "1/2", 4),
        ("1/2", "1/12", 6),
        ("-1/2", "1/12", 6),
        ("0", "1/1000000", 2),
        ("1", "1", 3),
    ] {
        let a = vec![vec![q(a1), q("1")], vec![-q(a2), q("0")]];
        for gamma in [1, -1] {
            let (b, c) = ([q("0"), whole(gamma)], [q("1"), q("0")]);
            let patterns: Vec<Vec<u64>> =
                (1..=4).map(|k| vec![k * q0]).chain([vec![1, q0], vec![q0, q0]]).collect();
            compare(&a, &b, &c, &patterns);
            let map = build(&a, &b, &c, 1);
            let graph = Graph::new(&map, 4 * q0, false).unwrap();
            for periods in &patterns {
                let report = graph.judge(periods);
                let first = periods == &[q0] && !a1.starts_with('-') && gamma == 1 && a2 != "1";
                let open = first || periods.len() == 2 || a2 == "1";
                assert_eq!(report.is_open(), open, "{a1} {a2} {gamma} {periods:?}");
                assert_eq!(report.reason == Some(OpenReason::Resonance), first);
                seen[usize::from(first)] += 1;
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 4), "{seen:?}");
}

/// Bounds about those resonances: what is said of one impact in n periods holds of every map within, on
/// either side of u_n = 0 and there; between the first and a higher resonance, and with wider bounds, nothing
/// more is said than is so.
#[test]
fn bounds_that_hold_a_resonance_say_what_holds_of_every_map_within() {
    let mut seen = [0; 3];
    for (a1, a2, n) in [
        ("0", "1/4", 2),
        ("1/2", "1/4", 3),
        ("-1/2", "1/4", 3),
        ("1", "1/2", 4),
        ("-1", "1/2", 4),
        ("1/2", "1/12", 6),
        ("1/2", "1/4", 6),
        ("1", "1", 3),
    ] {
        for (gamma, width) in [1, -1].into_iter().flat_map(|g| ["1/10000", "1/100", "1/3"].map(|w| (g, w))) {
            let [a1, a2, width] = [a1, a2, width].map(q);
            let about = |x: &Q| Entry::between(x - &width, x + &width).unwrap();
            let [zero, one] = [0, 1].map(|x| Entry::from(whole(x)));
            let rows = vec![vec![about(&a1), one.clone()], vec![about(&-&a2), zero.clone()]];
            let (b, c) = (vec![zero.clone(), whole(gamma).into()], vec![one.clone(), zero.clone()]);
            let Ok(map) = Map::new(rows, b, c, one.clone(), None) else { continue };
            let report = Graph::new(&map, n, false).unwrap().judge(&[n]);
            assert_eq!(sides(&report), sides(&Analysis::new(&map, n, Numbers::Enclosed).judge(&[n])));
            for (i, j) in (-2..=2).flat_map(|i| (-2..=2).map(move |j| (i, j))) {
                let [a1, a2] =
                    [&a1 + &width * Q::new(i.into(), 2.into()), &a2 - &width * Q::new(j.into(), 2.into())];
                let a = vec![vec![a1, whole(1)], vec![-a2, whole(0)]];
                let exact = build(&a, &[whole(0), whole(gamma)], &[whole(1), whole(0)], 1);
                let within = Graph::new(&exact, n, false).unwrap().judge(&[n]);
                let place = format!("{a:?}, n = {n}, gamma {gamma}, {width}: {report:?} {within:?}");
                if !report.is_open() {
                    assert_eq!(sides(&report), sides(&within), "{place}");
                    seen[0] += 1;
                } else if report.reason == Some(OpenReason::PerhapsResonance) {
                    let u = |n: u64| {
                        (1..n)
                            .fold([whole(0), whole(1)], |[x, y], _| [y.clone(), &a[0][0] * y + &a[1][0] * x])
                    };
                    let wanted = match Sign::of(&u(n)[1]) {
                        Sign::Zero => (PatternExistence::Open, PatternExistence::Open),
                        Sign::Positive => (PatternExistence::NoOrbit, PatternExistence::Orbit),
                        Sign::Negative => (PatternExistence::Orbit, PatternExistence::NoOrbit),
                    };
                    assert_eq!((within.plus, within.minus), wanted, "{place}");
                    seen[1] += 1;
                } else {
                    seen[2] += 1;
                }
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

/// The counts without listing, against judging every pattern: maps with singular periods and open edges among
/// them.
#[test]
fn tallies_agree_with_judging_every_pattern() {
    for (a1, a2) in [
        ("0.9", "0.6"),
        ("-1", "1/2"),
        ("1", "1"),
        ("0", "1/4"),
        ("-3/2", "1/2"),
        ("1/2", "1"),
        ("2", "0.75"),
    ] {
        let a = vec![vec![q(a1), q("1")], vec![-q(a2), q("0")]];
        let map = build(&a, &[q("0"), whole(-1)], &[q("1"), q("0")], 1);
        let graph = Graph::new(&map, 10, false).unwrap();
        for tally in graph.tallies() {
            let mut found = [0u32; 4];
            for pattern in Patterns::of_period(tally.period) {
                let report = graph.judge(pattern.periods());
                found[match report.side() {
                    Some(true) => 0,
                    Some(false) => 1,
                    None => 2 + usize::from(report.is_open()),
                }] += 1;
            }
            let counts = [tally.plus, tally.minus, tally.neither, tally.undecided];
            assert_eq!(counts, found.map(BigUint::from), "{a1} {a2} period {}", tally.period);
            assert_eq!(tally.patterns, BigUint::from(found.iter().sum::<u32>()));
        }
    }
}

#[test]
fn growth_rates_known_in_closed_form() {
    let rate = |follows: &[&[u8]]| {
        let rows: Vec<Vec<bool>> = follows.iter().map(|row| row.iter().map(|&x| x == 1).collect()).collect();
        let periods: Vec<u64> = (1..=rows.len() as u64).collect();
        ClosedWalks::from_edges(&periods, &rows).entropy(44)
    };
    assert!(matches!(rate(&[&[0, 0], &[1, 0]]), Entropy::Empty));
    assert!(matches!(rate(&[&[1, 1], &[0, 1]]), Entropy::Zero));
    assert!(matches!(rate(&[&[0, 1], &[1, 0]]), Entropy::Zero));
    let near = |x: &Q| x.to_f64().unwrap();
    let holds = |entropy: Entropy, root: f64| {
        let (lo, hi) = entropy.bounds().unwrap();
        let Entropy::Positive { z, .. } = entropy else { panic!("{entropy:?}") };
        assert!(near(&z.0) < root && root < near(&z.1) && near(&(&z.1 - &z.0)) < 1e-11, "{z:?} {root}");
        let log = -root.ln();
        assert!(near(&lo) < log && log < near(&hi) && near(&(&hi - &lo)) < 1e-11, "{lo} {hi} {log}");
    };
    // 1 = z + z²: the golden mean. 1 = z + z² + z³. z + z³ = 1 with 2 left out. Follow 1 by 2 only, 2 by
    // both: z² + z³ = 1.
    holds(rate(&[&[1, 1], &[1, 1]]), (5f64.sqrt() - 1.0) / 2.0);
    holds(rate(&[&[1, 1, 1], &[1, 1, 1], &[1, 1, 1]]), 0.543_689_012_692_076_4);
    holds(rate(&[&[1, 0, 1], &[0, 0, 0], &[1, 0, 1]]), 0.682_327_803_828_019_3);
    holds(rate(&[&[0, 1], &[1, 1]]), 0.754_877_666_246_692_8);
    // A component reached from another with a smaller root: the least one counts.
    holds(rate(&[&[0, 1, 0], &[1, 1, 1], &[0, 0, 1]]), 0.754_877_666_246_692_8);
}

#[test]
fn nothing_is_claimed_when_e_may_be_zero() {
    let list = |v: [i64; 2]| v.iter().map(|&x| whole(x).into()).collect::<Vec<Entry>>();
    let a = || vec![vec![q("0.9").into(), whole(1).into()], vec![q("-0.6").into(), whole(0).into()]];
    for (e, reason) in [
        (Entry::from(Q::zero()), OpenReason::Parameter),
        (Entry::between(q("-1"), q("2")).unwrap(), OpenReason::PerhapsParameter),
    ] {
        let map = Map::new(a(), list([0, 1]), list([1, 0]), e, None).unwrap();
        assert_eq!(map.notes().len(), 1);
        let report = Analysis::new(&map, 2, Numbers::Enclosed).judge(&[2]);
        assert_eq!((sides(&report), report.reason), ([None, None], Some(reason)));
        let report = Graph::new(&map, 2, false).unwrap().judge(&[2]);
        assert_eq!((sides(&report), report.reason), ([None, None], Some(reason)));
    }
}

/// Intervals around an exact map: what they decide is what the exact map says, and its numbers lie inside.
#[test]
fn intervals_contain_the_exact_map() {
    let a = [["0.9", "1", "0"], ["-0.6", "0", "0.1"], ["0.05", "0", "0.4"]];
    let (b, c) = ([q("0"), q("1"), q("0.25")], [q("1"), q("0"), q("0")]);
    let exact: Dense = a.iter().map(|row| row.iter().map(|x| q(x)).collect()).collect();
    let mut undecided = 0;
    for width in ["1e-9", "1e-3", "0.05"] {
        let around = |x: &Q| Entry::between(x - q(width), x + q(width) / whole(3)).unwrap();
        let entries = exact.iter().map(|row| row.iter().map(around).collect()).collect();
        let plain = |v: &[Q]| v.iter().cloned().map(Entry::from).collect::<Vec<_>>();
        let map = Map::new(entries, plain(&b), plain(&c), whole(1).into(), None).unwrap();
        assert!(!map.is_exact());
        let analysis = Analysis::new(&map, 5, Numbers::Exact);
        for periods in all_patterns(5) {
            let (report, expected) = (analysis.judge(&periods), theorem(&exact, &b, &c, &periods));
            for (side, expected) in sides(&report).iter().zip(expected) {
                assert!(side.is_none() || *side == expected);
            }
            undecided += usize::from(report.is_open());
            if let (Some(orbit), Some((x, y))) = (report.orbit, dense(&exact, &b, &c, &periods)) {
                assert!(orbit.x.iter().flatten().zip(x.iter().flatten()).all(|(v, x)| contains(v, x)));
                assert!(orbit.y.iter().zip(&y).all(|(v, y)| contains(v, y)));
            }
        }
    }
    assert!(undecided > 0, "the widest intervals leave something open");
}

#[test]
fn the_rungs_solve_alike_and_orbits_close() {
    let a = vec![
        vec![q("1/3"), q("1"), q("1")],
        vec![q("1/2"), q("-1/5"), q("2")],
        vec![q("-1"), q("1/7"), q("1/4")],
    ];
    let (b, c) = (vec![q("0"), q("1"), q("1")], vec![q("1"), q("0"), q("0")]);
    let map = build(&a, &b, &c, 1);
    let exact = solve(&Coordinates::<Q>::new(&map, 4, ()).unwrap(), &[3, 1, 4]).unwrap();
    let float = solve(&Coordinates::<FloatInterval>::new(&map, 4, ()).unwrap(), &[3, 1, 4]).unwrap();
    let bits = Precision::new(100);
    let ball = solve(&Coordinates::<Ball>::new(&map, 4, bits).unwrap(), &[3, 1, 4]).unwrap();
    for i in 0..3 {
        assert!(float.y[i].contains(&exact.y[i]) && ball.y[i].contains(&exact.y[i]));
        assert!(exact.x[i].iter().zip(&ball.x[i]).all(|(x, ball)| ball.contains(x)));
    }
    assert_eq!(Coordinates::<Q>::new(&map, 1, ()).unwrap().power(0)[(0, 0)].sign(), Some(Sign::Positive));
    // Between impacts a point is the image of the one before; across one, h = 0 on both sides.
    let points = predicted_orbit(&map, &[3, 1, 4], false).unwrap();
    assert_eq!(points.len(), 3 + 8);
    for pair in points.windows(2).filter(|pair| pair[1].k > 0) {
        let middle = |v: &Value| v.enclosure().lo();
        for (row, x) in a.iter().zip(&pair[1].x) {
            let image: f64 = row.iter().zip(&pair[0].x).map(|(a, x)| a.to_f64().unwrap() * middle(x)).sum();
            assert!((image - middle(x)).abs() < 1e-9 * (1.0 + image.abs()));
        }
    }
    let singular = build(
        &vec![vec![q("1/2"), q("1")], vec![q("-1/4"), q("0")]],
        &[q("0"), q("1")],
        &[q("1"), q("0")],
        1,
    );
    assert!(predicted_orbit(&singular, &[3], true).unwrap_err().to_string().contains("det D = 0"));
    let found = solve(&Coordinates::<Q>::new(&singular, 3, ()).unwrap(), &[3]);
    assert_eq!(found.unwrap_err(), Failure::Singular);
}
