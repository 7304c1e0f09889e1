//! Covers: what finding and checking cost as n grows.
//!
//! A cover with an Open leaf, or one that the checker rejects, fails the bench. Find and check of one n stand
//! side by side.

use std::{collections::HashMap, hint::black_box};

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use grazing::{
    certificate::cover::check_block,
    search::cover::{Cover, CoverOptions, cover},
};

fn find(n: u64) -> Cover {
    cover(&CoverOptions::new(n..=n), HashMap::new(), &(), &|_, _| Ok(())).unwrap().remove(0)
}

fn find_and_check(criterion: &mut Criterion) {
    // One thread, so that times are costs.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut group = criterion.benchmark_group("covers");
    group.sample_size(10);
    for n in [8u64, 16, 32, 64, 127, 128] {
        let cover = pool.install(|| find(n));
        assert!(cover.tally().open.is_empty());
        let block = cover.block().unwrap();
        // Time per leaf: constant if only their number grows.
        group.throughput(Throughput::Elements(cover.tally().leaves()));
        group.bench_with_input(BenchmarkId::new("find", n), &n, |bencher, &n| {
            bencher.iter(|| pool.install(|| find(black_box(n))));
        });
        group.bench_with_input(BenchmarkId::new("check", n), &n, |bencher, &n| {
            bencher.iter(|| check_block(n, black_box(block.as_bytes()), 0).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, find_and_check);
criterion_main!(benches);
