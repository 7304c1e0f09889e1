//! One rung on one family: time per b_{n,k}, certain digits, signs decided and signs wrong.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Input, InputFamily, naive::naive_b};
use crate::{
    local::{Answer, Ladder, Plane, Point, Polar, Quantity, Rung, sign_by, sign_on},
    number::{Ball, Circular, FloatInterval, Plain, Precision, Real, Sign},
};

/// How b_{n,k} is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Evaluation {
    /// The paper's formulas in plain `f64`.
    Naive,
    /// This crate's forms on a rung.
    Rung(Rung),
}

/// What one method does on one family.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The family.
    pub family: InputFamily,
    /// The method.
    pub method: Evaluation,
    /// Time for one b_{n,k}: value for rungs with values, sign for the exact one. Median over the inputs.
    pub time: Duration,
    /// Median of certain decimal digits (−log₁₀ of radius over |midpoint|, at least 0); for plain `f64`,
    /// which is certain of nothing, digits that happen to be right; for the exact rung, nothing.
    pub digits: Option<f64>,
    /// Median width of the enclosure, as log₁₀; −∞ is not shown.
    pub width: Option<f64>,
    /// Bits of precision lost on the worst input, for balls.
    pub lost: Option<u64>,
    /// Inputs whose sign was decided.
    pub decided: usize,
    /// Inputs whose sign was decided wrongly.
    pub wrong: usize,
    /// Inputs.
    pub inputs: usize,
    /// log₁₀ of the median condition number of b_{n,k} in its two parameters.
    pub condition: f64,
}

const INPUTS: usize = 24;
const PRECISIONS: [u32; 5] = [128, 256, 1024, 4096, 16384];

/// Measures every method on a family: naive and stable plain `f64`, intervals, balls of 128 to 16384 bits,
/// exact.
///
/// Signs are compared with the ladder's, plain digits with balls of 1024 bits. Takes up to a few seconds.
pub fn measure(family: InputFamily) -> Vec<Measured> {
    let inputs = family.inputs(INPUTS);
    let ladder = Ladder::default();
    let quantity = |input: &Input| Quantity::B { n: input.n, k: input.k };
    let truth: Vec<Answer> =
        inputs.iter().map(|input| ladder.sign(&input.point, quantity(input)).answer).collect();
    let reference = Precision::new(1024);
    let condition = median(inputs.iter().map(|input| condition(&input.point, quantity(input)).log10()));
    let row = |method, times: Vec<Duration>, signs: Vec<Answer>| {
        let decided = signs.iter().filter(|&&sign| sign != Answer::Undecided).count();
        let wrong = signs
            .iter()
            .zip(&truth)
            .filter(|&(sign, truth)| *sign != Answer::Undecided && sign != truth)
            .count();
        let time = Duration::from_secs_f64(median(times.iter().map(Duration::as_secs_f64)));
        Measured {
            family,
            method,
            time,
            digits: None,
            width: None,
            lost: None,
            decided,
            wrong,
            inputs: INPUTS,
            condition,
        }
    };
    let plain_digits = |values: &[f64]| {
        median(inputs.iter().zip(values).map(|(input, &value)| {
            let exact = input
                .point
                .evaluate::<Ball>(quantity(input), &reference)
                .and_then(|ball| ball.exact_bounds());
            right_digits(value, exact)
        }))
    };
    let mut rows = Vec::new();

    let values: Vec<f64> = inputs.iter().map(naive).collect();
    let signs =
        values.iter().map(|&value| Plain(value).sign().map_or(Answer::Undecided, Answer::Sign)).collect();
    let times = inputs.iter().map(|input| time(|| naive(black_box(input)))).collect();
    rows.push(Measured { digits: Some(plain_digits(&values)), ..row(Evaluation::Naive, times, signs) });

    let values: Vec<f64> = inputs
        .iter()
        .filter_map(|input| input.point.evaluate::<Plain>(quantity(input), &()))
        .map(|x| x.0)
        .collect();
    let (times, signs) = run::<Plain>(&inputs, &());
    rows.push(Measured {
        digits: Some(plain_digits(&values)),
        ..row(Evaluation::Rung(Rung::Plain), times, signs)
    });

    let (times, signs) = run::<FloatInterval>(&inputs, &());
    let bounds: Vec<_> = inputs
        .iter()
        .map(|input| {
            input.point.evaluate::<FloatInterval>(quantity(input), &()).and_then(|x| x.exact_bounds())
        })
        .collect();
    rows.push(Measured {
        digits: Some(median(bounds.iter().map(certain))),
        width: Some(median(bounds.iter().map(width))),
        ..row(Evaluation::Rung(Rung::Interval), times, signs)
    });

    for bits in PRECISIONS {
        let precision = Precision::new(bits);
        let (times, signs) = run::<Ball>(&inputs, &precision);
        let balls: Vec<Ball> =
            inputs.iter().filter_map(|input| input.point.evaluate(quantity(input), &precision)).collect();
        let bounds: Vec<_> = balls.iter().map(Ball::exact_bounds).collect();
        let lost =
            balls.iter().filter_map(|ball| Some(u64::from(bits).saturating_sub(ball.certain_bits()?))).max();
        rows.push(Measured {
            digits: Some(median(bounds.iter().map(certain))),
            width: Some(median(bounds.iter().map(width))),
            lost,
            ..row(Evaluation::Rung(Rung::Ball(bits)), times, signs)
        });
    }

    let signs: Vec<Answer> =
        inputs.iter().map(|input| sign_by(&input.point, quantity(input), Rung::Exact)).collect();
    // Where it cannot decide, its time says nothing.
    if signs.iter().any(|&sign| sign != Answer::Undecided) {
        let times = inputs
            .iter()
            .map(|input| time(|| sign_by(black_box(&input.point), quantity(input), Rung::Exact)))
            .collect();
        rows.push(row(Evaluation::Rung(Rung::Exact), times, signs));
    }
    rows
}

fn naive(input: &Input) -> f64 {
    naive_b(&input.point, input.n, input.k)
}

fn run<T: Circular>(inputs: &[Input], context: &T::Context) -> (Vec<Duration>, Vec<Answer>) {
    let quantity = |input: &Input| Quantity::B { n: input.n, k: input.k };
    let times = inputs
        .iter()
        .map(|input| time(|| black_box(&input.point).evaluate::<T>(quantity(input), context)))
        .collect();
    let signs = inputs.iter().map(|input| sign_on::<T>(&input.point, quantity(input), context)).collect();
    (times, signs)
}

/// Time of one call: the least average of three batches of about a millisecond.
fn time<R>(work: impl FnMut() -> R) -> Duration {
    batches(Duration::from_millis(1), work).into_iter().min().unwrap_or_default()
}

/// The time of one call, as the averages of three batches of about this length, or of one call each.
pub(super) fn batches<R>(length: Duration, mut work: impl FnMut() -> R) -> [Duration; 3] {
    let once = Instant::now();
    black_box(work());
    let calls = (length.as_nanos() / once.elapsed().as_nanos().max(1)).clamp(1, 20_000) as u32;
    [(); 3].map(|()| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(work());
        }
        start.elapsed() / calls
    })
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// log₁₀ |x|, to be printed only.
fn log10(x: &BigRational) -> f64 {
    if x.is_zero() {
        return f64::NEG_INFINITY;
    }
    let shift = x.numer().bits() as i64 - x.denom().bits() as i64;
    let power = BigInt::one() << shift.unsigned_abs();
    let scaled = if shift >= 0 { x / power } else { x * power };
    scaled.abs().to_f64().unwrap_or(1.0).log10() + shift as f64 * std::f64::consts::LOG10_2
}

type Bounds = Option<(BigRational, BigRational)>;

fn certain(bounds: &Bounds) -> f64 {
    bounds.as_ref().map_or(0.0, |(lo, hi)| (log10(&(hi + lo)) - log10(&(hi - lo))).max(0.0))
}

fn width(bounds: &Bounds) -> f64 {
    bounds.as_ref().map_or(f64::INFINITY, |(lo, hi)| log10(&(hi - lo)))
}

fn right_digits(value: f64, exact: Bounds) -> f64 {
    match (BigRational::from_float(value), exact) {
        (Some(value), Some((exact, _))) => (log10(&exact) - log10(&(value - &exact))).clamp(0.0, 17.0),
        _ => 0.0,
    }
}

/// The condition number of b_{n,k} or c_n: its relative change per relative change of each parameter, both
/// added.
///
/// From a step of 2⁻³⁰⁰ in balls of 1024 bits: good to a few digits below 2²⁰⁰. Infinite at a zero.
pub fn condition(at: &Point, quantity: Quantity) -> f64 {
    let precision = Precision::new(1024);
    let middle = |point: &Point| {
        let (lo, hi) = point.evaluate::<Ball>(quantity, &precision)?.exact_bounds()?;
        Some((lo + hi) / BigInt::from(2))
    };
    let step = BigRational::new(1.into(), BigInt::one() << 300);
    let scale = BigRational::one() - &step;
    let moved = match at {
        Point::Polar(polar) => {
            let polar_at = |r, s| Polar::new(r, s).ok().map(Point::Polar);
            [polar_at(polar.r() * &scale, polar.s().clone()), polar_at(polar.r().clone(), polar.s() * &scale)]
        }
        Point::Plane(plane) => {
            let plane_at = |a1, a2| Plane::new(a1, a2).ok().map(Point::Plane);
            [
                plane_at(plane.a1() * &scale, plane.a2().clone()),
                plane_at(plane.a1().clone(), plane.a2() * &scale),
            ]
        }
    };
    let Some(value) = middle(at).filter(|value| Sign::of(value) != Sign::Zero) else {
        return f64::INFINITY;
    };
    let change = |point: Option<Point>| {
        point.and_then(|point| middle(&point)).map_or(f64::INFINITY, |other| {
            10f64.powf(log10(&((other / &value - BigRational::one()) / &step)))
        })
    };
    moved.into_iter().map(change).sum()
}
