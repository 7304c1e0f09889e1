//! Farey fractions: the walk of F_10000 against the plain next-term recurrence, and rank and k-th term.
//!
//! Each walk must count Σ φ(q) + 1 terms and give the same checksum, or the bench fails.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grazing::farey::{Ranker, Sequence, Walk};
use num_rational::Ratio;

const ORDER: u64 = 10_000;
const TERMS: u64 = 30_397_487;

/// Counts the terms and mixes them.
fn count((count, mix): (u64, u64), p: u64, q: u64) -> (u64, u64) {
    (count + 1, mix.wrapping_add(p ^ q))
}

/// The textbook walk: one division per term, of 32-bit integers, nothing else.
fn recurrence() -> (u64, u64) {
    let (mut a, mut b, mut c, mut d) = (0, 1, 1, black_box(ORDER as u32));
    let order = d;
    let mut total = (0, 0);
    while a <= b {
        total = count(total, a.into(), b.into());
        let k = (order + b) / d;
        (a, b, c, d) = (c, d, k * c - a, k * d - b);
    }
    total
}

fn walk() -> Walk {
    Walk::new(black_box(ORDER), &Ratio::new(0, 1), &Ratio::new(1, 1)).unwrap()
}

fn sequence() -> (u64, u64) {
    let terms = Sequence::new(black_box(ORDER), &Ratio::new(0, 1), &Ratio::new(1, 1)).unwrap();
    terms.fold((0, 0), |total, x| count(total, *x.numer(), *x.denom()))
}

fn walks(criterion: &mut Criterion) {
    let expected = recurrence();
    assert_eq!(expected.0, TERMS);
    let mut group = criterion.benchmark_group("walk F_10000");
    group.throughput(Throughput::Elements(TERMS)).sample_size(10);
    type Route = (&'static str, fn() -> (u64, u64));
    let routes: [Route; 4] = [
        ("plain recurrence", recurrence),
        ("Sequence", sequence),
        ("Walk, for loop", || {
            let mut total = (0, 0);
            for x in walk() {
                total = count(total, *x.numer(), *x.denom());
            }
            total
        }),
        ("Walk, fold", || walk().fold((0, 0), |total, x| count(total, *x.numer(), *x.denom()))),
    ];
    for (name, route) in routes {
        group.bench_function(name, |bencher| {
            bencher.iter(|| assert_eq!(route(), expected, "{name} lists other terms"));
        });
    }
    group.finish();
}

fn ranks(criterion: &mut Criterion) {
    let half = Ratio::new(1, 2);
    for order in [10_000, 1_000_000, 100_000_000] {
        let index = Ranker::new(order).unwrap().rank(&half).unwrap();
        criterion.bench_function(&format!("rank of 1/2 in F_{order}, tables included"), |bencher| {
            bencher.iter(|| assert_eq!(Ranker::new(order).unwrap().rank(black_box(&half)).unwrap(), index));
        });
        let ranker = Ranker::new(order).unwrap();
        criterion.bench_function(&format!("term {index} of F_{order}"), |bencher| {
            bencher.iter(|| assert_eq!(ranker.kth(black_box(index)).unwrap(), half));
        });
    }
}

criterion_group!(benches, walks, ranks);
criterion_main!(benches);
