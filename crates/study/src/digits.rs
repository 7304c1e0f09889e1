//! Digits against time: b_{n,k} by each method on the same few inputs, whose values another program computed
//! to 1240 digits.
//!
//! `digits_reference.csv` has the inputs, exactly, and the values, by python-flint at 16384 bits, which is
//! four times the longest precision here: `benches/peers/digits_reference.py` wrote them. Digits of floats,
//! which promise none, are those that agree; of an enclosure, those that it makes certain, and whether it
//! holds the value is counted.

use std::{hint::black_box, time::Duration};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Pow, Signed};

use super::{
    InputFamily,
    computer::load,
    families::Input,
    measure::{Bounds, batches, certain, median, quartiles, right_digits, width},
    naive::naive_b,
};
use crate::{
    error::{Error, Result},
    local::condition::condition,
    local::{Plane, Point, Polar, Quantity, Rung},
    monitor::Monitor,
    number::{Ball, FloatInterval, Plain, Precision, Real, Sign, parse_rational, parse_rational_within},
};

/// How b_{n,k} is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum DigitsMethod {
    /// The paper's formulas in plain `f64`.
    Naive,
    /// This crate's forms on a rung.
    Rung(Rung),
    /// Intervals, then balls of 128, 256, … bits, until this many digits are certain.
    Ladder(u32),
    /// The recurrence of u_k in integers, from (a₁, a₂): the value itself, as a fraction.
    Fraction,
}

/// What one method does on one family.
#[derive(Debug, Clone)]
pub struct DigitsPrice {
    /// The family.
    pub family: InputFamily,
    /// The method.
    pub method: DigitsMethod,
    /// Median, lower and upper quartile of the time of one value, over all inputs and repetitions.
    pub time: [Duration; 3],
    /// Median and least of the decimal digits; for `DigitsMethod::Fraction` infinite.
    pub digits: [f64; 2],
    /// Median width of the enclosure, as log₁₀.
    pub width: Option<f64>,
    /// Bits of precision lost on the worst input, for balls.
    pub lost: Option<u64>,
    /// Inputs whose sign the value shows.
    pub decided: usize,
    /// Inputs whose sign it shows wrongly.
    pub wrong: usize,
    /// Inputs whose value is not in the enclosure.
    pub outside: usize,
    /// Inputs.
    pub inputs: usize,
    /// log₁₀ of the median condition number of b_{n,k} in its two parameters.
    pub condition: f64,
    /// The load of the machine.
    pub load: Option<f64>,
}

/// Bits of the balls.
pub const PRECISIONS: [u32; 6] = [128, 256, 512, 1024, 2048, 4096];
/// Digits asked of the ladder.
pub const TARGETS: [u32; 5] = [10, 30, 100, 300, 1000];
/// Inputs of each family.
pub const INPUTS: usize = 8;

const REFERENCE: &str = include_str!("digits_reference.csv");
/// 1240 digits, and their power of ten.
const REFERENCE_BITS: u32 = 1 << 15;

/// An input and its value, right to 1240 digits.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The input.
    pub(crate) input: Input,
    /// b_{n,k}.
    pub(crate) value: BigRational,
}

/// The inputs of a family, from `digits_reference.csv`.
///
/// # Errors
/// None: the file is part of the program, and a test reads it.
pub fn solved(family: InputFamily) -> Result<Vec<Solved>> {
    let rows = REFERENCE.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    rows.filter(|row| row.first() == Some(&family.name()))
        .map(|row| {
            let [_, n, k, coordinates, x, y, value] = row[..] else {
                return Err(Error::input("digits_reference.csv: a line without seven columns"));
            };
            let (x, y) = (parse_rational(x)?, parse_rational(y)?);
            let point = match coordinates {
                "rs" => Point::Polar(Polar::new(x, y)?),
                _ => Point::Plane(Plane::new(x, y)?),
            };
            let whole = |text: &str| text.parse().map_err(|_| Error::input(format!("{text} is no period")));
            let input = Input { point, n: whole(n)?, k: whole(k)? };
            Ok(Solved { input, value: parse_rational_within(value, REFERENCE_BITS)? })
        })
        .collect()
}

/// Measures every method on a family's first `count` inputs, balls of up to `bits` bits, each timed three
/// times for about `batch` (at least once) on each input.
///
/// # Errors
/// The monitor's interruption, which it is asked for between methods.
pub fn digits_prices(
    family: InputFamily,
    count: usize,
    bits: u32,
    batch: Duration,
    monitor: &dyn Monitor,
) -> Result<Vec<DigitsPrice>> {
    let inputs: Vec<Solved> = solved(family)?.into_iter().take(count).collect();
    let condition = median(inputs.iter().map(|one| condition(&one.input.point, one.quantity()).log10()));
    let study = Study { family, inputs, condition, batch };
    let mut prices = vec![
        study.plain(DigitsMethod::Naive, |one| Some(naive_b(&one.input.point, one.input.n, one.input.k))),
        study.plain(DigitsMethod::Rung(Rung::Plain), |one| one.on::<Plain>(&()).map(|x| x.0)),
        study.enclosed(DigitsMethod::Rung(Rung::Interval), |one| {
            Enclosure::Interval(one.on::<FloatInterval>(&()))
        }),
    ];
    monitor.advance(3)?;
    let precisions: Vec<Precision> =
        PRECISIONS.into_iter().filter(|&one| one <= bits).map(Precision::new).collect();
    for precision in &precisions {
        let method = DigitsMethod::Rung(Rung::Ball(precision.bits()));
        prices.push(study.enclosed(method, |one| Enclosure::Ball(one.on::<Ball>(precision))));
        monitor.advance(1)?;
    }
    // A ball of so many bits has at most so many digits.
    let within = |digits: &u32| f64::from(*digits) < 0.29 * f64::from(bits);
    for digits in TARGETS.into_iter().filter(within) {
        prices.push(study.enclosed(DigitsMethod::Ladder(digits), |one| one.climb(digits, &precisions)));
        monitor.advance(1)?;
    }
    prices.extend(study.fraction());
    monitor.advance(1)?;
    Ok(prices)
}

/// How many methods [`digits_prices`] measures at most, in the units of its monitor.
pub const METHODS: u64 = 4 + PRECISIONS.len() as u64 + TARGETS.len() as u64;

impl DigitsMethod {
    /// Its name in tables.
    pub fn name(self) -> String {
        match self {
            DigitsMethod::Naive => "f64, naive".into(),
            DigitsMethod::Rung(Rung::Plain) => "f64".into(),
            DigitsMethod::Rung(rung) => rung.to_string(),
            DigitsMethod::Ladder(digits) => format!("ladder to {digits} digits"),
            DigitsMethod::Fraction => "fraction".into(),
        }
    }
}

/// What encloses a value.
enum Enclosure {
    Interval(Option<FloatInterval>),
    Ball(Option<Ball>),
}

impl Enclosure {
    fn bounds(&self) -> Bounds {
        match self {
            Enclosure::Interval(x) => x.as_ref().and_then(FloatInterval::exact_bounds),
            Enclosure::Ball(x) => x.as_ref().and_then(Ball::exact_bounds),
        }
    }
}

impl Solved {
    fn quantity(&self) -> Quantity {
        Quantity::B { n: self.input.n, k: self.input.k }
    }

    fn on<T: crate::number::Circular>(&self, context: &T::Context) -> Option<T> {
        self.input.point.evaluate(self.quantity(), context)
    }

    /// The first rung with this many certain digits, or the last one.
    fn climb(&self, digits: u32, precisions: &[Precision]) -> Enclosure {
        let bits = f64::from(digits) * std::f64::consts::LOG2_10;
        let first = self.on::<FloatInterval>(&());
        // |midpoint| over radius, which rounding changes by a few parts in 10¹⁶.
        let enough = |x: &FloatInterval| (x.hi() + x.lo()).abs() >= bits.exp2() * (x.hi() - x.lo());
        if digits <= 15 && first.as_ref().is_some_and(enough) {
            return Enclosure::Interval(first);
        }
        let mut last = None;
        for precision in precisions.iter().filter(|one| f64::from(one.bits()) >= bits) {
            last = self.on::<Ball>(precision);
            let certain = last.as_ref().and_then(Ball::certain_bits);
            if certain.is_some_and(|certain| certain as f64 >= bits) {
                break;
            }
        }
        Enclosure::Ball(last)
    }
}

/// One family's inputs.
struct Study {
    family: InputFamily,
    inputs: Vec<Solved>,
    condition: f64,
    batch: Duration,
}

impl Study {
    /// A row without digits: the time of `work` on the inputs for which `has` holds.
    fn row<R>(&self, method: DigitsMethod, work: impl Fn(&Solved) -> R) -> DigitsPrice {
        let load = load();
        let one = |input| batches(self.batch, || black_box(work(black_box(input))));
        DigitsPrice {
            family: self.family,
            method,
            time: quartiles(self.inputs.iter().flat_map(one).collect()),
            digits: [f64::INFINITY; 2],
            width: None,
            lost: None,
            decided: 0,
            wrong: 0,
            outside: 0,
            inputs: self.inputs.len(),
            condition: self.condition,
            load,
        }
    }

    fn plain(&self, method: DigitsMethod, value: impl Fn(&Solved) -> Option<f64>) -> DigitsPrice {
        let values: Vec<f64> = self.inputs.iter().map(|one| value(one).unwrap_or(f64::NAN)).collect();
        let pairs = || self.inputs.iter().zip(&values);
        let digits: Vec<f64> = pairs().map(|(one, &value)| right_digits(value, &one.value)).collect();
        let signs = pairs().filter_map(|(one, &value)| Some((Plain(value).sign()?, Sign::of(&one.value))));
        DigitsPrice {
            digits: both(&digits),
            decided: signs.clone().count(),
            wrong: signs.filter(|(sign, truth)| sign != truth).count(),
            ..self.row(method, value)
        }
    }

    fn enclosed(&self, method: DigitsMethod, value: impl Fn(&Solved) -> Enclosure) -> DigitsPrice {
        let found: Vec<Enclosure> = self.inputs.iter().map(&value).collect();
        let bounds: Vec<Bounds> = found.iter().map(Enclosure::bounds).collect();
        let digits: Vec<f64> = bounds.iter().map(certain).collect();
        let pairs = || self.inputs.iter().zip(&bounds);
        let sign = |bounds: &Bounds| {
            let (lo, hi) = bounds.as_ref()?;
            (Sign::of(lo) == Sign::of(hi)).then(|| Sign::of(lo))
        };
        let holds = |one: &Solved, bounds: &Bounds| {
            bounds.as_ref().is_none_or(|(lo, hi)| touches(lo, hi, &one.value))
        };
        let lost = |one: &Enclosure| match (one, method) {
            (Enclosure::Ball(Some(ball)), DigitsMethod::Rung(Rung::Ball(bits))) => {
                Some(u64::from(bits).saturating_sub(ball.certain_bits()?))
            }
            _ => None,
        };
        DigitsPrice {
            digits: both(&digits),
            width: Some(median(bounds.iter().map(width))),
            lost: found.iter().filter_map(lost).max(),
            decided: bounds.iter().filter_map(sign).count(),
            wrong: pairs()
                .filter(|(one, bounds)| sign(bounds).is_some_and(|sign| sign != Sign::of(&one.value)))
                .count(),
            outside: pairs().filter(|(one, bounds)| !holds(one, bounds)).count(),
            ..self.row(method, value)
        }
    }

    /// The exact value, where it is a fraction.
    fn fraction(&self) -> Option<DigitsPrice> {
        let plane = |one: &Solved| match &one.input.point {
            Point::Plane(plane) => Some(plane.clone()),
            Point::Polar(_) => None,
        };
        let planes: Option<Vec<Plane>> = self.inputs.iter().map(plane).collect();
        let mut right = 0;
        for (plane, one) in planes?.iter().zip(&self.inputs) {
            let (numerator, denominator) = fraction(plane, one.input.n, one.input.k);
            let value = BigRational::new(numerator, denominator);
            right += usize::from(touches(&value, &value, &one.value));
        }
        let inputs = self.inputs.len();
        let row = self.row(DigitsMethod::Fraction, |one| match &one.input.point {
            Point::Plane(plane) => Some(fraction(plane, one.input.n, one.input.k)),
            Point::Polar(_) => None,
        });
        Some(DigitsPrice { decided: inputs, outside: inputs - right, ..row })
    }
}

/// Whether an enclosure holds the value of which this is the reference, right to a relative 10⁻¹²³⁰.
fn touches(lo: &BigRational, hi: &BigRational, value: &BigRational) -> bool {
    let slack = value.abs() / Pow::pow(BigInt::from(10), 1230u32);
    lo <= &(value + &slack) && &(value - slack) <= hi
}

/// The median and the least.
fn both(values: &[f64]) -> [f64; 2] {
    [median(values.iter().copied()), values.iter().copied().fold(f64::INFINITY, f64::min)]
}

/// b_{n,k} as a quotient of integers, not in lowest terms.
///
/// With a₁ = A/D and a₂ = B/D, the integers U_m = D^{m−1} u_m obey U_{m+1} = A U_m − B D U_{m−1}, and b_{n,k}
/// = (U_n − D^{n−k} U_k − B^k U_{n−k}) / U_n. Cost: O(n) products of an integer of n times the bits of the
/// point by one of its bits.
fn fraction(plane: &Plane, n: u64, k: u64) -> (BigInt, BigInt) {
    let d = plane.a1().denom().lcm(plane.a2().denom());
    let a = plane.a1().numer() * (&d / plane.a1().denom());
    let b = plane.a2().numer() * (&d / plane.a2().denom());
    let product = &b * &d;
    let (mut before, mut u) = (BigInt::from(0), BigInt::from(1));
    let (mut at_k, mut at_rest) = (BigInt::from(0), BigInt::from(0));
    for m in 1..=n {
        if m == k {
            at_k.clone_from(&u);
        }
        if m == n - k {
            at_rest.clone_from(&u);
        }
        if m < n {
            let next = &a * &u - &product * before;
            before = std::mem::replace(&mut u, next);
        }
    }
    let numerator = &u - Pow::pow(&d, n - k) * at_k - Pow::pow(&b, k) * at_rest;
    (numerator, u)
}

#[cfg(test)]
mod tests {
    use super::{super::FAMILIES, *};

    /// The file has the families' own inputs, and each method's values are those of the other program.
    #[test]
    fn values_agree_with_another_programs() {
        for family in FAMILIES {
            let count = if family == InputFamily::NearComplexPole { 1 } else { INPUTS };
            let known = solved(family).unwrap();
            assert_eq!(known.len(), INPUTS);
            for (one, input) in known.iter().zip(family.inputs(count)) {
                assert_eq!((one.input.n, one.input.k), (input.n, input.k));
                let same = match (&one.input.point, &input.point) {
                    (Point::Polar(a), Point::Polar(b)) => a.r() == b.r() && a.s() == b.s(),
                    (Point::Plane(a), Point::Plane(b)) => a.a1() == b.a1() && a.a2() == b.a2(),
                    _ => false,
                };
                assert!(same, "{input:?}");
            }
            let mut careless = f64::INFINITY;
            for price in digits_prices(family, 2, 1024, Duration::ZERO, &()).unwrap() {
                let enclosed = !matches!(price.method, DigitsMethod::Naive | DigitsMethod::Rung(Rung::Plain));
                if enclosed {
                    assert_eq!((price.wrong, price.outside), (0, 0), "{price:?}");
                } else {
                    careless = careless.min(price.digits[0]);
                }
                let wanted = match price.method {
                    DigitsMethod::Rung(Rung::Ball(bits)) => 0.3 * (f64::from(bits) - 75.0),
                    DigitsMethod::Ladder(digits) => f64::from(digits) - 0.01,
                    DigitsMethod::Fraction => f64::INFINITY,
                    _ => 0.0,
                };
                assert!(price.digits[1] >= wanted, "{price:?}");
                assert!(price.digits[1] <= price.digits[0] && price.time[1] <= price.time[2]);
            }
            if matches!(family, InputFamily::NearPole | InputFamily::NearComplexPole) {
                assert!(careless < 3.0, "{family:?}: {careless}");
            }
        }
    }
}
