//! Theorem 1 for impact patterns: the block solver against a dense one, hard cases, invariance, two dimensions against
//! closed forms, and predictions against a smooth map iterated at small µ.

mod common;

use grazing::{
    impact::{
        Analysis, Coordinates, Entry, Existence, Failure, Graph, Growth, Map, Numbers, Pattern, Patterns, Reason, Report, Value,
        Walks, predicted_orbit, solve,
    },
    number::{Ball, FloatInterval, Precision, Real, Sign, parse_rational},
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
    if x.is_zero() { 0 } else if x.is_positive() { 1 } else { -1 }
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

fn sides(report: &Report) -> [Option<bool>; 2] {
    [report.plus, report.minus].map(|side| match side {
        Existence::Orbit => Some(true),
        Existence::NoOrbit => Some(false),
        Existence::Open => None,
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
        let expected = theorem(a, b, c, periods);
        let solution = dense(a, b, c, periods);
        let mut reports = vec![enclosed.judge(periods), exact.judge(periods)];
        reports.extend(graph.as_ref().map(|graph| graph.judge(periods)));
        for report in reports {
            assert_eq!(sides(&report), expected, "{periods:?} {a:?}");
            match &solution {
                None => assert_eq!((report.reason, report.orbit.is_none()), (Some(Reason::Singular), true)),
                Some((x, y)) => {
                    let orbit = report.orbit.unwrap();
                    assert!(orbit.x.iter().flatten().zip(x.iter().flatten()).all(|(v, x)| contains(v, x)), "{periods:?}");
                    assert!(orbit.y.iter().zip(y).all(|(v, y)| contains(v, y)), "{periods:?}");
                    let least = y.iter().min().unwrap();
                    assert!(contains(&orbit.margins(true).1, least) && contains(&-orbit.margins(false).1, y.iter().max().unwrap()));
                    if y.iter().all(|y| !y.is_zero()) {
                        let factor = |(y, &n): (&Q, &u64)| {
                            let response: Q = apply(&power(a, n), b).iter().zip(c).map(|(x, c)| x * c).sum();
                            -response / (y * whole(2))
                        };
                        let leading: Q = y.iter().zip(periods).map(factor).product();
                        assert!(contains(&orbit.leading.unwrap(), &leading));
                        let sign = Sign::of(&leading);
                        assert_eq!(orbit.leading_sign, Some(sign));
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

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..common::config() })]

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

    /// Single impacts of period n: (57)–(60) through u_k, no matrix anywhere.
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
            prop_assert_eq!(report.reason, Some(Reason::Singular));
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
