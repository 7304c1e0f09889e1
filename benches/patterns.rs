//! Theorem 1 for every impact pattern: the cost against the largest period P.
//!
//! There are about 2^P/P patterns of period P, so the time doubles with each further P. A wrong count fails the bench.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grazing::pattern::{Analysis, Graph, Map, Numbers, Pattern, Patterns, Report};
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

/// The number of patterns with Σ n_i ≤ 8, 12, 16, 20: necklaces of n beads in two colours but for one, added up.
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

criterion_group!(benches, plane, four);
criterion_main!(benches);
