//! The rungs' operations: an interval's sum, product and quotient, a ball's at four lengths, sines of
//! multiples of π, exp, and text.
//!
//! Every bench checks its answer and fails if it is wrong.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use grazing_number::{
    Angle, Ball, Circular, Elementary, FloatInterval, Precision, Real, num_rational::BigRational,
    parse_rational,
};

fn number(text: &str) -> BigRational {
    parse_rational(text).unwrap()
}

/// Two numbers that no rung has exactly.
fn pair() -> (BigRational, BigRational) {
    (number("12345/67891"), number("987654321/123456787"))
}

fn intervals(criterion: &mut Criterion) {
    let (x, y) = pair();
    let [a, b] = [&x, &y].map(|x| FloatInterval::ratio(x, &()));
    let mut group = criterion.benchmark_group("f64 interval");
    let mut bench =
        |name: &str, operation: &dyn Fn(FloatInterval, &FloatInterval) -> FloatInterval, exact| {
            assert!(operation(a, &b).contains(&exact), "{name}");
            group.bench_function(name, |bencher| bencher.iter(|| operation(black_box(a), black_box(&b))));
        };
    bench("sum", &|a, b| a + b, &x + &y);
    bench("product", &|a, b| a * b, &x * &y);
    bench("quotient", &|a, b| a / b, &x / &y);
    let angle = Angle::new(&x);
    group.bench_function("sin 12345 pi/67891", |bencher| {
        let sine = || FloatInterval::sin(black_box(&angle), &());
        let (low, high) = Ball::sin(&angle, &Precision::new(256)).exact_bounds().unwrap();
        assert!(sine().contains(&low) && sine().contains(&high));
        bencher.iter(sine);
    });
}

fn balls(criterion: &mut Criterion) {
    let (x, y) = pair();
    for bits in [53, 128, 1024, 4096] {
        let context = Precision::new(bits);
        let [a, b] = [&x, &y].map(|x| Ball::ratio(x, &context));
        let mut group = criterion.benchmark_group(format!("ball of {bits} bits"));
        let mut bench = |name: &str, operation: &dyn Fn(Ball, &Ball) -> Ball, exact: BigRational| {
            assert!(operation(a.clone(), &b).contains(&exact), "{name}");
            group.bench_function(name, |bencher| {
                bencher.iter(|| operation(black_box(&a).clone(), black_box(&b)));
            });
        };
        bench("sum", &|a, b| a + b, &x + &y);
        bench("product", &|a, b| a * b, &x * &y);
        bench("quotient", &|a, b| a / b, &x / &y);
        let angle = Angle::new(&x);
        let precise = |value: Ball| assert!(value.certain_bits().unwrap() >= u64::from(bits) - 4);
        group.bench_function("sin 12345 pi/67891", |bencher| {
            precise(Ball::sin(&angle, &context));
            bencher.iter(|| Ball::sin(black_box(&angle), &context));
        });
        group.bench_function("exp", |bencher| {
            precise(a.exp(&context));
            bencher.iter(|| black_box(&a).exp(&context));
        });
    }
}

fn text(criterion: &mut Criterion) {
    criterion.bench_function("text of a sum", |bencher| {
        let text = "3/8 + 2^-200 - 0.125e-3";
        assert_eq!(number(text) - number("2^-200"), number("2999/8000"));
        bencher.iter(|| parse_rational(black_box(text)));
    });
}

criterion_group!(benches, intervals, balls, text);
criterion_main!(benches);
