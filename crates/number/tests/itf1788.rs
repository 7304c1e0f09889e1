//! Interval operations against the cases of ITF1788 (tests/data/itf1788.csv), and against the tightest
//! intervals of floats around exact fractions.

use std::collections::BTreeMap;

use grazing_number::{Ball, Elementary, FloatInterval, Precision, Transcendental};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

const CASES: &str = include_str!("data/itf1788.csv");

/// Cases of one operation, and how many of them came out as tight as can be.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
struct Tally {
    cases: usize,
    exact: usize,
}

/// An operation, the ends of its arguments, those of the tightest interval around the result.
struct Case {
    operation: &'static str,
    arguments: Vec<(f64, f64)>,
    result: (f64, f64),
}

fn cases() -> Vec<Case> {
    let lines = CASES.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let (operation, ends) = line.split_once(',').unwrap();
            let ends: Vec<f64> = ends.split(',').map(|end| end.parse().unwrap()).collect();
            let mut pairs: Vec<(f64, f64)> = ends.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
            let result = pairs.pop().unwrap();
            Case { operation, arguments: pairs, result }
        })
        .collect()
}

/// The result of an interval operation; `None` for an operation that intervals of floats do not have.
fn in_floats(operation: &str, arguments: &[(f64, f64)]) -> Option<FloatInterval> {
    let interval = |i: usize| FloatInterval::from_bounds(arguments[i].0, arguments[i].1);
    Some(match operation {
        "neg" => -interval(0),
        "add" => interval(0) + &interval(1),
        "sub" => interval(0) - &interval(1),
        "mul" => interval(0) * &interval(1),
        "div" => interval(0) / &interval(1),
        "intersection" => interval(0).intersection(interval(1)).unwrap(),
        "convex_hull" => interval(0).hull(interval(1)),
        "abs" => interval(0).abs(),
        "min" => interval(0).min(interval(1)),
        "max" => interval(0).max(interval(1)),
        "sqrt" => interval(0).sqrt(),
        "sin" => interval(0).sin_cos(&()).0,
        "cos" => interval(0).sin_cos(&()).1,
        "pow" => interval(0).pow(&interval(1), &()),
        _ => (function(operation)?)(&interval(0), &()),
    })
}

/// A function of one number, on any rung.
fn function<T: Transcendental>(name: &str) -> Option<fn(&T, &T::Context) -> T> {
    Some(match name {
        "exp" => T::exp,
        "log" => T::log,
        "tan" => T::tan,
        "atan" => T::atan,
        "sinh" => T::sinh,
        "cosh" => T::cosh,
        _ => return None,
    })
}

/// Every result encloses the tightest one, and how often it is the tightest. Divisors that contain zero, by
/// which this crate's division gives the whole line on purpose, are counted apart.
#[test]
fn intervals_of_floats_keep_itf1788() {
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for Case { operation, arguments, result: (lo, hi) } in cases() {
        let Some(found) = in_floats(operation, &arguments) else { continue };
        assert!(
            found.lo() <= lo && hi <= found.hi(),
            "{operation} {arguments:?}: {found:?} lacks {lo} to {hi}"
        );
        let by_zero = operation == "div" && arguments[1].0 <= 0.0 && arguments[1].1 >= 0.0;
        let name = if by_zero { "div by zero" } else { operation };
        let tally = tallies.entry(name).or_default();
        tally.cases += 1;
        tally.exact += usize::from(found.lo() == lo && found.hi() == hi);
    }
    println!("ITF1788, intervals of floats: {tallies:?}");
    let of = |name: &str| tallies[name];
    let tight = [
        [("neg", 9), ("add", 25), ("sub", 25), ("mul", 106), ("intersection", 2), ("convex_hull", 2)],
        [("abs", 10), ("min", 10), ("max", 10), ("exp", 17), ("log", 17), ("tan", 31)],
    ];
    let waves = [("sin", 50), ("cos", 50), ("atan", 8), ("sinh", 9), ("cosh", 9)];
    for (name, cases) in tight.into_iter().flatten().chain(waves) {
        assert_eq!(of(name), Tally { cases, exact: cases }, "{name}");
    }
    // An unbounded divisor gives the whole line too. Of negative numbers no root is told, and no power, nor
    // of 0 where an exponent may be below it or 0; others are a float wider where the power is exactly a
    // float.
    assert_eq!((of("sqrt"), of("pow")), (Tally { cases: 10, exact: 5 }, Tally { cases: 1154, exact: 729 }));
    let quotients = of("div");
    assert!(quotients.cases > 70 && 2 * quotients.exact >= quotients.cases, "{quotients:?}");
}

/// Balls of 256 bits around the arguments: the result reaches both ends of the tightest interval, up to the
/// float beside each; and for points it is, rounded outwards to floats, that interval.
#[test]
fn balls_keep_itf1788() {
    let precision = Precision::new(256);
    let mut tallies: BTreeMap<(&str, bool), Tally> = BTreeMap::new();
    for Case { operation, arguments, result } in cases() {
        let points = arguments.iter().all(|(lo, hi)| lo == hi);
        let fractions = arguments
            .iter()
            .map(|&(lo, hi)| BigRational::from_float(lo).zip(BigRational::from_float(hi)))
            .collect::<Option<Vec<_>>>();
        let Some(fractions) = fractions else { continue };
        let ball = |i: usize| Ball::between(&fractions[i].0, &fractions[i].1, &precision);
        let found = match operation {
            "neg" => -ball(0),
            "add" => ball(0) + &ball(1),
            "sub" => ball(0) - &ball(1),
            "mul" => ball(0) * &ball(1),
            "sqr" => ball(0) * &ball(0),
            "div" => ball(0) / &ball(1),
            "sqrt" => ball(0).sqrt(),
            "abs" => ball(0).abs(),
            "min" => ball(0).min(&ball(1)),
            "max" => ball(0).max(&ball(1)),
            "convex_hull" => ball(0).hull(&ball(1)),
            "intersection" => ball(0).intersection(&ball(1)).unwrap(),
            "pow" => ball(0).pow(&ball(1), &precision),
            "sin" => ball(0).sin_cos(&precision).0,
            "cos" => ball(0).sin_cos(&precision).1,
            name => match function(name) {
                Some(function) => function(&ball(0), &precision),
                None => continue,
            },
        };
        let tally = tallies.entry((operation, points)).or_default();
        tally.cases += 1;
        // Without bounds nothing is known, which is always true.
        let Some((lo, hi)) = found.exact_bounds() else { continue };
        // The true range begins above the float below the tightest interval's lower end.
        let reaches =
            |end: &BigRational, float: f64| BigRational::from_float(float).is_none_or(|float| *end <= float);
        let (least, most) = (result.0.next_up(), result.1.next_down());
        assert!(reaches(&lo, least) && reaches(&-hi.clone(), -most), "{operation} {arguments:?}: {result:?}");
        tally.exact += usize::from(outwards(&lo, &hi) == result);
    }
    println!("ITF1788, balls of 256 bits, (operation, of points): {tallies:?}");
    for name in ["neg", "add", "sub", "mul", "div", "sqr", "sqrt", "exp", "sin", "cos"] {
        let Some(tally) = tallies.get(&(name, true)) else { continue };
        assert_eq!(tally.exact, tally.cases, "{name}");
    }
    let points: usize = tallies.iter().filter(|((_, points), _)| *points).map(|(_, tally)| tally.cases).sum();
    assert!(points >= 20 && tallies.len() >= 15, "{points}");
}

/// The tightest floats around two fractions.
fn outwards(lo: &BigRational, hi: &BigRational) -> (f64, f64) {
    (below(lo), -below(&-hi.clone()))
}

/// The greatest float that is not above x.
fn below(x: &BigRational) -> f64 {
    // To nearest, or beside it where the conversion is off by more: corrected by exact comparison.
    let mut near = x.to_f64().unwrap_or(f64::NAN);
    let above = |float: f64| match BigRational::from_float(float) {
        Some(float) => float > *x,
        None => float > 0.0,
    };
    while above(near) {
        near = near.next_down();
    }
    while !above(near.next_up()) {
        near = near.next_up();
    }
    near
}

/// Ends at which operations of floats go wrong where they do: zero, the smallest and largest floats, both
/// sides of 1, of a power of 2 and of the range in which products are exact, and some that are no
/// fraction of a power of 2 nearby.
fn ends() -> Vec<f64> {
    let positive =
        [5e-324, f64::MIN_POSITIVE, 1e-250, 0.1, 1.0f64.next_down(), 3.0, 134_217_729.0, 1e250, f64::MAX];
    positive.iter().flat_map(|&x| [x, -x]).chain([0.0]).collect()
}

/// Our own cases: all pairs of points from [`ends`], and of some intervals between neighbours of them,
/// against the tightest floats around the exact range.
#[test]
fn intervals_of_floats_are_as_tight_as_exact_fractions_allow() {
    let mut ends = ends();
    ends.sort_by(f64::total_cmp);
    let points = ends.iter().map(|&x| (x, x));
    let arguments: Vec<(f64, f64)> =
        points.chain(ends.windows(2).step_by(3).map(|pair| (pair[0], pair[1]))).collect();
    let exact = |x: f64| BigRational::from_float(x).unwrap();
    let mut tallies: BTreeMap<&str, (Tally, Tally)> = BTreeMap::new();
    let least = BigRational::new(BigInt::one(), BigInt::one() << 880);
    let largest = least.recip();
    for &a in &arguments {
        for &b in &arguments {
            for operation in ["add", "sub", "mul", "div"] {
                if operation == "div" && b.0 <= 0.0 && b.1 >= 0.0 {
                    continue;
                }
                let mut corners = vec![(a.0, b.0), (a.0, b.1), (a.1, b.0), (a.1, b.1)];
                corners.dedup();
                let corner = |&(x, y): &(f64, f64)| match (operation, exact(x), exact(y)) {
                    ("add", x, y) => x + y,
                    ("sub", x, y) => x - y,
                    ("mul", x, y) => x * y,
                    (_, x, y) => x / y,
                };
                let corners: Vec<BigRational> = corners.iter().map(corner).collect();
                let (lo, hi) = (corners.iter().min().unwrap(), corners.iter().max().unwrap());
                let tightest = outwards(lo, hi);
                let found = in_floats(operation, &[a, b]).unwrap();
                assert!(
                    found.lo() <= tightest.0 && tightest.1 <= found.hi(),
                    "{operation} {a:?} {b:?}: {found:?} lacks {tightest:?}"
                );
                // Where a number is below 2⁻⁹⁰⁰ or above 2⁹⁰⁰, products and quotients may be a float wider.
                let inside = |x: &BigRational| x.is_zero() || (x.abs() >= least && x.abs() < largest);
                let inside = [a.0, a.1, b.0, b.1].map(exact).iter().all(inside) && inside(lo) && inside(hi);
                let (inner, outer) = tallies.entry(operation).or_default();
                let tally = if inside { inner } else { outer };
                tally.cases += 1;
                tally.exact += usize::from((found.lo(), found.hi()) == tightest);
                let near = |x: f64, y: f64| x == y || x.next_up() == y || x.next_down() == y;
                assert!(
                    near(found.lo(), tightest.0) && near(found.hi(), tightest.1),
                    "{operation} {a:?} {b:?}: {found:?} is wider than {tightest:?} by more than a float"
                );
            }
        }
    }
    println!("own cases, (between 2^-880 and 2^880, outside): {tallies:?}");
    for (operation, (inner, outer)) in tallies {
        assert!(inner.exact == inner.cases && inner.cases > 80, "{operation}: {inner:?}");
        let sum = ["add", "sub"].contains(&operation);
        assert!(outer.cases > 200 && (!sum || outer.exact == outer.cases), "{operation}: {outer:?}");
    }
}
