//! Theorem 2: the cost of the decision as a function of n, of a range, and of checking its certificate.
//!
//! A decision that disagrees with the theorem, or a certificate that is rejected, fails the bench.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grazing::{
    certificate,
    existence::{decide, intervals, tree_intervals},
    search::{ProofMethod, prove_theorem2, write_theorem2},
};

fn one_period(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("decide one period");
    group.sample_size(20);
    for n in [500u64, 1000, 2000, 4000, 8000] {
        // Per n: about constant, as there are O(n) pieces.
        group.throughput(Throughput::Elements(n));
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |bencher, &n| {
            bencher.iter(|| assert_eq!(decide(black_box(n)).unwrap().disagreement, None));
        });
    }
    group.finish();
}

fn ranges(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("all periods");
    group.sample_size(10);
    for last in [500, 1000] {
        group.bench_function(format!("verify 3..={last}"), |bencher| {
            bencher.iter(|| {
                assert_eq!(prove_theorem2(3..=last, ProofMethod::Exact, &()).unwrap().refuted, None)
            });
        });
    }
    let proof = prove_theorem2(3..=100, ProofMethod::Exact, &()).unwrap();
    let mut text = Vec::new();
    write_theorem2(3..=100, &proof, &mut text, &()).unwrap();
    group.bench_function("check a certificate of 3..=100", |bencher| {
        bencher.iter(|| certificate::check(&mut black_box(&text[..])).unwrap());
    });
    group.finish();
}

fn rows(criterion: &mut Criterion) {
    let last = 2000;
    // Σ (φ(n) + 1) over the range.
    let expected = 1_218_584;
    let mut group = criterion.benchmark_group("Theorem 2's intervals for n = 3..=2000");
    group.throughput(Throughput::Elements(expected)).sample_size(10);
    group.bench_function("by modular inverses", |bencher| {
        bencher.iter(|| {
            let count: usize = (3..=last).map(|n| intervals(n).unwrap().count()).sum();
            assert_eq!(count as u64, expected);
        });
    });
    group.bench_function("by the Farey tree", |bencher| {
        bencher.iter(|| assert_eq!(tree_intervals(last).unwrap().count() as u64, expected));
    });
    group.finish();
}

criterion_group!(benches, one_period, ranges, rows);
criterion_main!(benches);
