//! The price of a sign: the time to decide it by each method, against the distance to where it changes.

use std::{hint::black_box, time::Duration};

use super::{
    ZeroFamily,
    computer::load,
    measure::{batches, quartiles},
    naive::{naive_b, naive_c},
    zeros::NearZero,
};
use crate::{
    error::Result,
    existence::{Existence, definition_and_rung},
    local::{Answer, Ladder, Point, Quantity, Rung, SignDecision, sign_by, sign_on},
    monitor::Monitor,
    number::{Ball, FloatInterval, Plain, Precision, Real},
};

/// How a sign is decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SignMethod {
    /// The paper's formulas in plain `f64`.
    Naive,
    /// One rung alone.
    Rung(Rung),
    /// The ladder: rung after rung until one decides.
    Ladder,
    /// The existence of period n by its definition: the signs of c_n and of b_{n,1}, …, b_{n,n−1}, each by
    /// the ladder.
    Verdict,
}

/// What one method costs at one distance from one kind of place.
#[derive(Debug, Clone)]
pub struct SignPrice {
    /// What is approached.
    pub family: ZeroFamily,
    /// The method.
    pub method: SignMethod,
    /// The relative distance is 10^−`digits`; `None`: 0.
    pub digits: Option<u32>,
    /// The highest rung that decided one of these signs; `None` if none did.
    pub rung: Option<Rung>,
    /// Inputs.
    pub inputs: usize,
    /// Inputs whose answer was found: the sign, u_n = 0, or whether the orbit exists.
    pub decided: usize,
    /// Inputs with a wrong answer.
    pub wrong: usize,
    /// Median, lower and upper quartile of the time of one decision, tries that decide nothing included, over
    /// all inputs and repetitions.
    pub time: [Duration; 3],
    /// Processes that were waiting for a processor or had one, on average over the last minute, where the
    /// system says so: 1 is this one.
    pub load: Option<f64>,
}

/// The relative distances 10^−d of a full study.
pub const DISTANCES: [u32; 11] = [1, 2, 4, 8, 16, 32, 64, 125, 250, 500, 1000];
/// Those of a quick one.
pub const QUICK_DISTANCES: [u32; 5] = [1, 8, 32, 125, 1000];

/// Bits of the balls.
const PRECISIONS: [u32; 6] = [128, 256, 512, 1024, 2048, 4096];
/// The longest periods whose whole verdict is measured.
const VERDICTS: u64 = 1000;

/// Measures every method at `count` places of a family, at each distance and at the places themselves.
///
/// Answers are compared with the ladder's, which is right where it answers at all. Each method is timed
/// three times for about `batch` (at least once) on each input.
///
/// # Errors
/// The monitor's interruption, which it is asked for between methods.
pub fn sign_prices(
    family: ZeroFamily,
    distances: &[u32],
    count: usize,
    batch: Duration,
    monitor: &dyn Monitor,
) -> Result<Vec<SignPrice>> {
    let places = family.places(count, monitor)?;
    let ladder = Ladder::default();
    ladder.precisions().for_each(drop);
    let precisions = PRECISIONS.map(Precision::new);
    let mut prices = Vec::new();
    for digits in distances.iter().copied().map(Some).chain([None]) {
        let inputs: Vec<NearZero> = places.iter().filter_map(|place| place.at(digits)).collect();
        if inputs.is_empty() {
            continue;
        }
        let sign = |input: &NearZero| ladder.sign(&input.point, input.quantity);
        let truth = inputs.iter().map(|input| sign(input).answer).collect();
        let at = Distance { family, digits, truth, inputs, batch };
        let one = |method, rung, sign: &dyn Fn(&NearZero) -> Answer| {
            at.signs(method, |input| SignDecision { answer: sign(input), rung })
        };
        let on = |rung, sign: &dyn Fn(&NearZero) -> Answer| one(SignMethod::Rung(rung), rung, sign);
        prices.push(one(SignMethod::Naive, Rung::Plain, &naive));
        prices.push(on(Rung::Plain, &|input| sign_on::<Plain>(&input.point, input.quantity, &())));
        prices.push(on(Rung::Interval, &|input| sign_on::<FloatInterval>(&input.point, input.quantity, &())));
        monitor.advance(3)?;
        for precision in &precisions {
            let ball = |input: &NearZero| sign_on::<Ball>(&input.point, input.quantity, precision);
            prices.push(on(Rung::Ball(precision.bits()), &ball));
            monitor.advance(1)?;
        }
        prices.push(on(Rung::Exact, &|input| sign_by(&input.point, input.quantity, Rung::Exact)));
        prices.push(at.signs(SignMethod::Ladder, sign));
        monitor.advance(2)?;
        if at.inputs.iter().all(|input| input.quantity.period() <= VERDICTS) {
            prices.push(at.verdicts(&ladder));
            monitor.advance(1)?;
        }
    }
    Ok(prices)
}

/// The sign by the paper's formulas in plain `f64`, zero included: they promise nothing.
fn naive(input: &NearZero) -> Answer {
    let value = match (&input.point, input.quantity) {
        (point, Quantity::B { n, k }) => naive_b(point, n, k),
        (Point::Plane(plane), Quantity::C { n }) => naive_c(plane, n),
        (Point::Polar(_), Quantity::C { .. }) => return Answer::Undecided,
    };
    Plain(value).sign().map_or(Answer::Undecided, Answer::Sign)
}

/// The inputs at one distance, and what is true there.
struct Distance {
    family: ZeroFamily,
    digits: Option<u32>,
    truth: Vec<Answer>,
    inputs: Vec<NearZero>,
    batch: Duration,
}

impl SignMethod {
    /// Its name in tables.
    pub fn name(self) -> String {
        match self {
            SignMethod::Naive => "f64, naive".into(),
            SignMethod::Rung(rung) => rung.to_string(),
            SignMethod::Ladder => "ladder".into(),
            SignMethod::Verdict => "verdict".into(),
        }
    }
}

impl Distance {
    /// The price of signs by a method.
    fn signs(&self, method: SignMethod, decide: impl Fn(&NearZero) -> SignDecision) -> SignPrice {
        let (time, load) = self.time(&decide);
        let (mut decided, mut wrong, mut rung) = (0, 0, None);
        for (input, truth) in self.inputs.iter().zip(&self.truth) {
            let found = decide(input);
            if found.answer == Answer::Undecided {
                continue;
            }
            decided += 1;
            wrong += usize::from(*truth != Answer::Undecided && found.answer != *truth);
            rung = rung.max_by_height(found.rung);
        }
        let (family, digits, inputs) = (self.family, self.digits, self.inputs.len());
        SignPrice { family, method, digits, rung, inputs, decided, wrong, time, load }
    }

    /// The price of the whole verdict on each input's period.
    fn verdicts(&self, ladder: &Ladder) -> SignPrice {
        let decide = |input: &NearZero| definition_and_rung(ladder, &input.point, input.quantity.period());
        let (time, load) = self.time(decide);
        let found: Vec<(Existence, Rung)> = self.inputs.iter().map(decide).collect();
        let decided = found.iter().filter(|(existence, _)| *existence != Existence::Undecided);
        SignPrice {
            family: self.family,
            method: SignMethod::Verdict,
            digits: self.digits,
            rung: decided.clone().fold(None, |rung: Option<Rung>, found| rung.max_by_height(found.1)),
            inputs: self.inputs.len(),
            decided: decided.count(),
            wrong: 0,
            time,
            load,
        }
    }

    /// The median and both quartiles of the times of one call, and the system's load before them.
    fn time<R>(&self, decide: impl Fn(&NearZero) -> R) -> ([Duration; 3], Option<f64>) {
        let load = load();
        let one = |input| batches(self.batch, || black_box(decide(black_box(input))));
        (quartiles(self.inputs.iter().flat_map(one).collect()), load)
    }
}

/// The higher of two rungs.
trait Highest {
    fn max_by_height(self, other: Rung) -> Self;
}

impl Highest for Option<Rung> {
    fn max_by_height(self, other: Rung) -> Option<Rung> {
        self.into_iter().chain([other]).max_by_key(|&rung| height(rung))
    }
}

/// Rungs by what they cost.
fn height(rung: Rung) -> u64 {
    match rung {
        Rung::Plain => 0,
        Rung::Interval => 1,
        Rung::Ball(bits) => 2 + u64::from(bits),
        Rung::Exact => u64::MAX,
    }
}

#[cfg(test)]
mod tests {
    use super::{super::ZERO_FAMILIES, *};

    /// Enclosures, integers and the ladder are never wrong; plain floats are, near enough; and what decides
    /// is what must: intervals far away, balls that are long enough, the ladder everywhere.
    #[test]
    fn methods_are_judged_rightly() {
        let short = Duration::from_nanos(1);
        let mut careless = 0;
        for family in ZERO_FAMILIES {
            for price in sign_prices(family, &[1, 200], 2, short, &()).unwrap() {
                match price.method {
                    SignMethod::Naive | SignMethod::Rung(Rung::Plain) => careless += price.wrong,
                    method => assert_eq!(price.wrong, 0, "{method:?}: {price:?}"),
                }
                let all = price.decided == price.inputs;
                match (price.method, price.digits) {
                    (SignMethod::Ladder | SignMethod::Verdict, _) => assert!(all, "{price:?}"),
                    (SignMethod::Rung(Rung::Ball(bits)), Some(digits)) if bits >= 1024 => {
                        assert!(all, "{digits}: {price:?}")
                    }
                    (SignMethod::Rung(Rung::Ball(128)), Some(200)) => {
                        let lost = matches!(family, ZeroFamily::DampedZero | ZeroFamily::ComplexZero);
                        assert!(!(lost && price.decided > 0), "{price:?}");
                    }
                    _ => {}
                }
                assert!(price.time[1] <= price.time[0] && price.time[0] <= price.time[2]);
            }
        }
        assert!(careless > 8, "{careless}");
    }
}
