//! b_{n,k} by rung at one rational s on r = 1, all k at once, and all signs at random (r, s).
//!
//! Every bench checks its answer and fails if it is wrong. The point is that of benches/peers/arb.c.

use std::{f64::consts::PI, hint::black_box};

use criterion::{Criterion, criterion_group, criterion_main};
use grazing::local::{Answer, Ladder, Point, Polar, Rung, direct_signs};
use grazing::number::{Ball, FloatInterval, Plain, Precision, Real, Sign, parse_rational};
use num_rational::BigRational;

const N: u64 = 100;
const K: u64 = 37;

fn point() -> Polar {
    Polar::new(parse_rational("1").unwrap(), parse_rational("12345/67891").unwrap()).unwrap()
}

/// b_{100,37} and the sum of all b_{100,k}, from balls of 512 bits, which the tests compare with FLINT.
fn expected() -> (BigRational, BigRational) {
    let precision = Precision::new(512);
    let middle = |ball: &Ball| ball.exact_bounds().unwrap().0;
    let all = point().b_all::<Ball>(N, &precision).unwrap();
    (middle(&all[K as usize - 1]), all.iter().map(middle).sum())
}

fn near(value: f64, expected: &BigRational) -> bool {
    let error = BigRational::from_float(value).unwrap() / expected - BigRational::from_integer(1.into());
    num_traits::Signed::abs(&error) < parse_rational("1e-11").unwrap()
}

fn single(criterion: &mut Criterion) {
    let point = point();
    let (single, _) = expected();
    let mut group = criterion.benchmark_group("single b");
    group.bench_function("plain f64, as printed", |bencher| {
        let (n, k, s) = (N as f64, K as f64, 12345.0 / 67891.0);
        let b = || {
            -2.0 * (k * PI * black_box(s)).sin() * ((n - k) * PI * black_box(s)).sin()
                / (n * PI * black_box(s)).cos()
        };
        assert!(near(b(), &single));
        bencher.iter(b);
    });
    group.bench_function("plain f64, exact arguments", |bencher| {
        let b = || black_box(&point).b::<Plain>(N, K, &()).unwrap();
        assert!(near(b().0, &single));
        bencher.iter(b);
    });
    group.bench_function("f64 interval", |bencher| {
        let b = || black_box(&point).b::<FloatInterval>(N, K, &()).unwrap();
        assert!(b().contains(&single) && b().hi() - b().lo() < 1e-14);
        bencher.iter(b);
    });
    for bits in [128, 256, 1024, 4096] {
        let precision = Precision::new(bits);
        group.bench_function(format!("{bits} bits"), |bencher| {
            let b = || black_box(&point).b::<Ball>(N, K, &precision).unwrap();
            assert!(b().certain_bits().unwrap() > u64::from(bits) - 8);
            let (lo, hi) = b().exact_bounds().unwrap();
            let slack = parse_rational("2^-500").unwrap();
            assert!(lo - &slack <= single && single <= hi + slack);
            bencher.iter(b);
        });
    }
}

fn all(criterion: &mut Criterion) {
    let point = point();
    let (_, sum) = expected();
    let mut group = criterion.benchmark_group("all b, n = 100");
    for bits in [128, 256, 1024, 4096] {
        let precision = Precision::new(bits);
        group.bench_function(format!("{bits} bits"), |bencher| {
            let all = || black_box(&point).b_all::<Ball>(N, &precision).unwrap();
            let total = all().iter().fold(Ball::integer(0, &precision), |total, b| total + b);
            let (lo, hi) = total.exact_bounds().unwrap();
            let slack = parse_rational("2^-120").unwrap();
            assert!(all().len() == 99 && lo - &slack <= sum && sum <= hi + slack);
            bencher.iter(all);
        });
    }
}

/// 1000 points (r, s) with r, s of six digits and n ≤ 100.
fn random_points() -> Vec<(Point, Polar, u64)> {
    let mut state = 1u64;
    let mut next = |bound: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) % bound
    };
    let ratio = |p: u64, q: u64| BigRational::new(p.into(), q.into());
    let points = std::iter::repeat_with(|| {
        (ratio(1 + next(999_982), 999_983), ratio(1 + next(500_000), 1_000_003), 3 + next(98))
    });
    let polar =
        points.map(|(r, s, n)| (Polar::new(r, s).unwrap(), n)).filter(|(polar, n)| !polar.is_singular(*n));
    polar.map(|(polar, n)| (Point::Polar(polar.clone()), polar, n)).take(1000).collect()
}

fn signs(criterion: &mut Criterion) {
    let points = random_points();
    let ladder = Ladder::default();
    let (mut total, mut higher, mut at) = (0, 0, 0);
    for (point, _, n) in &points {
        let decisions = ladder.signs(point, *n);
        assert!(decisions.iter().all(|d| matches!(d.answer, Answer::Sign(Sign::Positive | Sign::Negative))));
        let climbed = decisions.iter().filter(|d| d.rung != Rung::Interval).count();
        (total, higher, at) = (total + decisions.len(), higher + climbed, at + usize::from(climbed > 0));
    }
    println!(
        "signs: {total} at 1000 random points; {higher} of them, at {at} points, needed more than f64 intervals"
    );
    let mut group = criterion.benchmark_group("all signs at random (n, r, s)");
    group.bench_function("f64 intervals alone", |bencher| {
        let mut next = points.iter().cycle();
        bencher.iter(|| next.next().map(|(_, polar, n)| direct_signs::<FloatInterval>(polar, *n, &())));
    });
    group.bench_function("the ladder", |bencher| {
        let mut next = points.iter().cycle();
        bencher.iter(|| next.next().map(|(point, _, n)| ladder.signs(point, *n)));
    });
}

criterion_group!(benches, single, all, signs);
criterion_main!(benches);
