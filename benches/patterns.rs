//! Theorem 1 for every impact pattern: the cost against the largest period P.
//!
//! There are about 2^P/P patterns of period P, so the time doubles with each further P. A wrong count fails
//! the bench.

use std::{hint::black_box, time::Instant};

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grazing::local::{Ladder, Plane, Point};
use grazing::pattern::{Analysis, Graph, Map, Numbers, Pattern, Patterns, Report};
use grazing::word::{ClosedWalks, Extent, Relation, Word};
use num_bigint::BigUint;
use num_rational::BigRational;
use rayon::prelude::*;

const PLANE: &str = include_str!("../examples/maps/focus.toml");
const FOUR: &str = include_str!("../examples/maps/four-dimensional.toml");

/// Judges all patterns with Σ n_i ≤ `last`; the number that exist and that are open.
fn all(last: u64, judge: impl Fn(&Pattern) -> Report + Sync) -> (usize, usize, usize) {
    let mut total = (0, 0, 0);
    for period in 1..=last {
        let patterns: Vec<Pattern> = Patterns::of_period(period).collect();
        let count = patterns.par_iter().map(|pattern| {
            let report = judge(pattern);
            (1, usize::from(report.side().is_some()), usize::from(report.is_open()))
        });
        let found = count.reduce(|| (0, 0, 0), |a, b| (a.0 + b.0, a.1 + b.1, a.2 + b.2));
        total = (total.0 + found.0, total.1 + found.1, total.2 + found.2);
    }
    total
}

/// The number of patterns with Σ n_i ≤ 8, 12, 16, 20: necklaces of n beads in two colours but for one, added
/// up.
const PERIODS: [(u64, usize); 4] = [(8, 85), (12, 789), (16, 8_907), (20, 111_301)];

fn plane(criterion: &mut Criterion) {
    let map = Map::from_toml(PLANE, "focus.toml").unwrap();
    let mut group = criterion.benchmark_group("N = 2, exact signs");
    group.sample_size(10);
    for (last, patterns) in PERIODS {
        group.throughput(Throughput::Elements(patterns as u64));
        group.bench_with_input(
            BenchmarkId::new("graph, all patterns to period", last),
            &last,
            |bencher, &last| {
                bencher.iter(|| {
                    let graph = Graph::new(black_box(&map), last, false).unwrap();
                    let found = all(last, |pattern| graph.judge(pattern.periods()));
                    assert_eq!((found.0, found.2), (patterns, 0));
                });
            },
        );
    }
    group.bench_function("general solver, all patterns to period 12", |bencher| {
        bencher.iter(|| {
            let analysis = Analysis::new(black_box(&map), 12, Numbers::Enclosed);
            assert_eq!(all(12, |pattern| analysis.judge(pattern.periods())).0, 789);
        });
    });
    group.finish();
}

fn four(criterion: &mut Criterion) {
    let map = Map::from_toml(FOUR, "four-dimensional.toml").unwrap();
    let mut group = criterion.benchmark_group("N = 4");
    group.sample_size(10);
    for (last, patterns) in PERIODS {
        group.throughput(Throughput::Elements(patterns as u64));
        group.bench_with_input(
            BenchmarkId::new("enclosed, all patterns to period", last),
            &last,
            |bencher, &last| {
                bencher.iter(|| {
                    let analysis = Analysis::new(black_box(&map), last, Numbers::Enclosed);
                    let found = all(last, |pattern| analysis.judge(pattern.periods()));
                    assert_eq!((found.0, found.2), (patterns, 0));
                });
            },
        );
    }
    group.bench_function("exact, all patterns to period 8", |bencher| {
        bencher.iter(|| {
            let analysis = Analysis::new(black_box(&map), 8, Numbers::Exact);
            assert_eq!(all(8, |pattern| analysis.judge(pattern.periods())).0, 85);
        });
    });
    for length in [50, 100, 200, 400] {
        let analysis = Analysis::new(&map, 5, Numbers::Enclosed);
        let pattern: Vec<u64> = (0..length).map(|i: u64| 1 + i * i % 7 % 5).collect();
        group.throughput(Throughput::Elements(length));
        group.bench_with_input(
            BenchmarkId::new("one pattern of length", length),
            &pattern,
            |bencher, pattern| {
                bencher.iter(|| assert!(!analysis.judge(black_box(pattern)).is_open()));
            },
        );
    }
    group.finish();
}

/// The word against listing every pattern, at the ten of 200 points where listing takes longest: medians of
/// the ratio of times.
fn words(_: &mut Criterion) {
    const LAST: u64 = 14;
    let started = |work: &mut dyn FnMut()| {
        let clock = Instant::now();
        work();
        clock.elapsed().as_secs_f64()
    };
    let median = |mut times: [f64; 5]| {
        times.sort_by(f64::total_cmp);
        times[2]
    };
    let ratio = |p: i64, q: i64| BigRational::new(p.into(), q.into());
    let mut rows = Vec::new();
    for seed in 1..=200i64 {
        // In region 3, half of them near r = 1.
        let a2 = ratio(1 + seed * 389 % 999, 1000);
        let a2 = if seed % 2 == 0 { (a2 + ratio(9, 1)) / ratio(10, 1) } else { a2 };
        let a1 = ratio(-1900 + seed * 1597 % 3800, 1000);
        let text = format!(
            "format = \"grazing-map 1\"\nA = [[\"{a1}\", \"1\"], [\"-{a2}\", \"0\"]]\nB = [0, 1]\nC = [1, 0]\ne = 1\n"
        );
        let map = Map::from_toml(&text, "map").unwrap();
        let point = Point::Plane(Plane::new(a1.clone(), a2.clone()).unwrap());
        let (mut listed, mut counted) = ((0, 0), (0, 0));
        let list = started(&mut || {
            let graph = Graph::new(&map, LAST, false).unwrap();
            let found = all(LAST, |pattern| graph.judge(pattern.periods()));
            listed = (found.1, found.2);
        });
        let mut count = || {
            let ladder = Ladder::default();
            let mut sum = (BigUint::ZERO, 0);
            for positive in [true, false] {
                let word = Word::at(&ladder, &point, positive, 200, &()).unwrap();
                let relation = Relation::new(&word, true, false, LAST).unwrap();
                let closed = matches!(word.extent(), Extent::All | Extent::Complete { .. });
                sum.1 += usize::from(relation.is_open() || !closed);
                sum.0 += ClosedWalks::new(&relation).count(LAST).iter().map(|row| &row.all).sum::<BigUint>();
            }
            counted = (usize::try_from(sum.0).unwrap(), sum.1);
        };
        let word = median([(); 5].map(|()| started(&mut count)));
        // Where the word does not end for certain, as on the lines between regions, some pattern must be
        // open.
        assert!(listed == counted || (listed.1 > 0 && counted.1 > 0), "{a1} {a2}: {listed:?} {counted:?}");
        rows.push((list, word, a1, a2));
    }
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    println!(
        "all patterns to period {LAST} of maps with gamma > 0: listing each against one word, the ten slowest of 200 points"
    );
    for (list, word, a1, a2) in rows.iter().take(10) {
        println!(
            "  a1 = {a1}, a2 = {a2}: {:.2} ms against {:.2} ms, {:.0} times",
            list * 1e3,
            word * 1e3,
            list / word
        );
    }
}

criterion_group!(benches, plane, four, words);
criterion_main!(benches);
