//! Operations of grazing-number, inari and malachite, timed on the same numbers: lines
//!
//!     LIBRARY OPERATION BITS NS LOWER UPPER
//!
//! NS is the fastest of several batches; LOWER and UPPER enclose the result, as floats or to 25 decimals.
//! The operands are enclosures of 12345/67891 and 987654321/123456787, which no binary number is. malachite
//! rounds correctly and has no enclosures: its operation is done twice, rounded down and up, as the ends of
//! positive intervals need it.

use std::{hint::black_box, time::Instant};

use grazing_number::num_rational::BigRational;
use grazing_number::{
    Angle, Ball, Circular, Elementary, FloatInterval, Precision, Real, Transcendental, parse_rational,
};
use inari::{Interval, interval};
use malachite_base::rounding_modes::RoundingMode::{Ceiling, Floor};
use malachite_float::Float;
use malachite_q::Rational;

const BITS: [u32; 5] = [53, 128, 256, 1024, 4096];

/// Nanoseconds of a call: the fastest of nine batches of about 2 ms.
fn time<T>(mut call: impl FnMut() -> T) -> f64 {
    let mut batch = |calls: u32| {
        let start = Instant::now();
        (0..calls).for_each(|_| drop(black_box(call())));
        start.elapsed().as_nanos() as f64 / f64::from(calls)
    };
    // The first call of all makes tables.
    let ns = batch(1).min(batch(100));
    let calls = (2e6 / ns).max(1.0) as u32;
    (0..9).map(|_| batch(calls)).fold(f64::INFINITY, f64::min)
}

fn line(library: &str, operation: &str, bits: u32, ns: f64, ends: [String; 2]) {
    println!("{library} {operation} {bits} {ns:.2} {} {}", ends[0], ends[1]);
}

fn floats() {
    let (x, y) = (parse_rational("12345/67891").unwrap(), parse_rational("987654321/123456787").unwrap());
    let [a, b] = [&x, &y].map(|x| FloatInterval::ratio(x, &()));
    let angle = Angle::new(&x);
    let put = |operation: &str, ns, value: FloatInterval| {
        let ends = [value.lo(), value.hi()].map(|end| format!("{end:e}"));
        line("grazing-number-interval", operation, 53, ns, ends);
    };
    put("sum", time(|| black_box(a) + black_box(&b)), a + &b);
    put("product", time(|| black_box(a) * black_box(&b)), a * &b);
    put("quotient", time(|| black_box(a) / black_box(&b)), a / &b);
    put("sinpi", time(|| FloatInterval::sin(black_box(&angle), &())), FloatInterval::sin(&angle, &()));

    put("exp", time(|| black_box(a).exp(&())), a.exp(&()));
    put("log", time(|| black_box(a).log(&())), a.log(&()));
    put("sin", time(|| black_box(a).sin_cos(&()).0), a.sin_cos(&()).0);
    put("tan", time(|| black_box(a).tan(&())), a.tan(&()));
    put("atan", time(|| black_box(a).atan(&())), a.atan(&()));
    put("sinh", time(|| black_box(a).sinh(&())), a.sinh(&()));
    put("pow", time(|| black_box(b).pow(&a, &())), b.pow(&a, &()));

    let [c, d] = [a, b].map(|x| interval!(x.lo(), x.hi()).unwrap());
    let put = |operation: &str, ns, value: Interval| {
        line("inari", operation, 53, ns, [value.inf(), value.sup()].map(|end| format!("{end:e}")));
    };
    put("sum", time(|| black_box(c) + black_box(d)), c + d);
    put("product", time(|| black_box(c) * black_box(d)), c * d);
    put("quotient", time(|| black_box(c) / black_box(d)), c / d);
}

fn balls() {
    let (x, y) = (parse_rational("12345/67891").unwrap(), parse_rational("987654321/123456787").unwrap());
    let angle = Angle::new(&x);
    for bits in BITS {
        let context = Precision::new(bits);
        let [a, b] = [&x, &y].map(|x| Ball::ratio(x, &context));
        let put = |operation: &str, ns, value: Ball| {
            let (low, high) = value.exact_bounds().unwrap();
            let ends = [digits(&low, false), digits(&high, true)];
            line("grazing-number", operation, bits, ns, ends);
        };
        put("sum", time(|| black_box(&a).clone() + black_box(&b)), a.clone() + &b);
        put("product", time(|| black_box(&a).clone() * black_box(&b)), a.clone() * &b);
        put("quotient", time(|| black_box(&a).clone() / black_box(&b)), a.clone() / &b);
        put("sinpi", time(|| Ball::sin(black_box(&angle), &context)), Ball::sin(&angle, &context));
        put("exp", time(|| black_box(&a).exp(&context)), a.exp(&context));
        put("log", time(|| black_box(&a).log(&context)), a.log(&context));
        put("sin", time(|| black_box(&a).sin_cos(&context).0), a.sin_cos(&context).0);
        put("tan", time(|| black_box(&a).tan(&context)), a.tan(&context));
        put("atan", time(|| black_box(&a).atan(&context)), a.atan(&context));
        put("sinh", time(|| black_box(&a).sinh(&context)), a.sinh(&context));
        put("pow", time(|| black_box(&b).pow(&a, &context)), b.pow(&a, &context));
    }
}

/// The number times 10²⁵, rounded down or up, and e-25 after it.
fn digits(x: &BigRational, up: bool) -> String {
    let scaled = x * parse_rational("1e25").unwrap();
    format!("{}e-25", if up { scaled.ceil() } else { scaled.floor() }.to_integer())
}

fn malachite() {
    let rational = |p: u64, q: u64| Rational::from_unsigneds(p, q);
    let (x, y) = (rational(12345, 67891), rational(987_654_321, 123_456_787));
    for bits in BITS {
        let p = u64::from(bits);
        let both =
            |x: &Rational| [Floor, Ceiling].map(|mode| Float::from_rational_prec_round_ref(x, p, mode).0);
        let ([a, b], [c, d]) = (both(&x), both(&y));
        let exact = |end: &Float| parse_rational(&Rational::try_from(end).unwrap().to_string()).unwrap();
        let put = |operation: &str, ns, [low, high]: [Float; 2]| {
            line(
                "malachite",
                operation,
                bits,
                ns,
                [digits(&exact(&low), false), digits(&exact(&high), true)],
            );
        };
        let sum = || [a.add_prec_round_ref_ref(&c, p, Floor).0, b.add_prec_round_ref_ref(&d, p, Ceiling).0];
        put("sum", time(sum), sum());
        let product =
            || [a.mul_prec_round_ref_ref(&c, p, Floor).0, b.mul_prec_round_ref_ref(&d, p, Ceiling).0];
        put("product", time(product), product());
        let quotient =
            || [a.div_prec_round_ref_ref(&d, p, Floor).0, b.div_prec_round_ref_ref(&c, p, Ceiling).0];
        put("quotient", time(quotient), quotient());
        let exp = || [a.exp_prec_round_ref(p, Floor).0, b.exp_prec_round_ref(p, Ceiling).0];
        put("exp", time(exp), exp());
    }
}

fn main() {
    floats();
    balls();
    malachite();
}
