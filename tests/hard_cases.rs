//! The hard cases of tests/data/hard_cases.toml on every rung: right or undecided, never wrong.
//!
//! The references come from FLINT and from Python's fractions (tests/data/make_hard_cases.py).

use grazing::local::{Answer, Ladder, Plane, Point, Polar, Quantity, Rung, sign_by};
use grazing::number::{Ball, FloatInterval, Precision, Sign, parse_rational};
use grazing::study::condition;
use num_rational::BigRational;
use num_traits::Signed;
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    case: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    name: String,
    r: Option<String>,
    s: Option<String>,
    a1: Option<String>,
    a2: Option<String>,
    n: u64,
    k: Option<u64>,
    expected: String,
    value: Option<String>,
    #[allow(dead_code)]
    source: Option<String>,
}

impl Case {
    fn point(&self) -> Point {
        let number =
            |text: &Option<String>| parse_rational(text.as_ref().expect("r and s, or a1 and a2")).unwrap();
        match self.s {
            Some(_) => Point::Polar(Polar::new(number(&self.r), number(&self.s)).unwrap()),
            None => Point::Plane(Plane::new(number(&self.a1), number(&self.a2)).unwrap()),
        }
    }

    fn quantity(&self) -> Quantity {
        self.k.map_or(Quantity::C { n: self.n }, |k| Quantity::B { n: self.n, k })
    }

    fn expected(&self) -> Answer {
        match self.expected.as_str() {
            "+" => Answer::Sign(Sign::Positive),
            "-" => Answer::Sign(Sign::Negative),
            "0" => Answer::Sign(Sign::Zero),
            "singular" => Answer::Singular,
            other => panic!("expected = {other:?}"),
        }
    }

    /// The reference; `None` if singular or beyond the size of a written-out number.
    fn value(&self) -> Option<BigRational> {
        parse_rational(self.value.as_ref()?).ok()
    }

    fn label(&self) -> String {
        let parameters =
            [&self.r, &self.s, &self.a1, &self.a2].into_iter().flatten().cloned().collect::<Vec<_>>();
        format!("{}: ({}), n = {}, k = {:?}", self.name, parameters.join(", "), self.n, self.k)
    }
}

fn cases() -> Vec<Case> {
    let text = include_str!("data/hard_cases.toml");
    let cases = toml::from_str::<File>(text).unwrap().case;
    assert!(cases.len() >= 60);
    cases
}

/// Whether [lo, hi] meets the reference, which is good to 40 digits.
fn meets((lo, hi): (BigRational, BigRational), value: &BigRational) -> bool {
    let slack = value.abs() * parse_rational("2e-39").unwrap();
    lo <= value + &slack && value - slack <= hi
}

#[test]
fn signs_are_right_or_undecided_on_every_rung() {
    let rungs =
        [Rung::Interval, Rung::Ball(128), Rung::Ball(256), Rung::Ball(1024), Rung::Ball(4096), Rung::Exact];
    for case in cases() {
        let (point, quantity) = (case.point(), case.quantity());
        for rung in rungs {
            let answer = sign_by(&point, quantity, rung);
            assert!(
                answer == case.expected() || answer == Answer::Undecided,
                "{}: {rung:?} says {answer:?}",
                case.label()
            );
        }
    }
}

#[test]
fn the_ladder_decides_every_case() {
    let ladder = Ladder::default();
    for case in cases() {
        let decision = ladder.sign(&case.point(), case.quantity());
        assert_eq!(decision.answer, case.expected(), "{} on {:?}", case.label(), decision.rung);
    }
}

#[test]
fn values_meet_the_references() {
    for case in cases() {
        let (point, quantity) = (case.point(), case.quantity());
        let Some(value) = case.value() else { continue };
        let interval = point.evaluate::<FloatInterval>(quantity, &()).expect("not singular");
        if let Some(bounds) = interval.exact_bounds() {
            assert!(meets(bounds, &value), "{}: {interval:?}", case.label());
        }
        for bits in [128, 256, 1024] {
            let ball = point.evaluate::<Ball>(quantity, &Precision::new(bits)).expect("not singular");
            if let Some(bounds) = ball.exact_bounds() {
                assert!(meets(bounds, &value), "{}: {bits} bits, {ball:?}", case.label());
            }
        }
    }
}

/// The digits lost stay within what the docs of `Polar::b`, `Polar::c`, `Plane::b` and `Plane::c` say.
#[test]
fn digits_lost_stay_within_the_stated_bound() {
    let bits = 1024;
    let precision = Precision::new(bits);
    for case in cases() {
        let Some(ball) = case.point().evaluate::<Ball>(case.quantity(), &precision) else { continue };
        let Some(certain) = ball.certain_bits() else { continue };
        let lost = f64::from(bits) - certain as f64;
        let growth = 2.0 * (case.n as f64).log2() + 10.0;
        let bound = match case.point() {
            Point::Polar(polar) if polar.on_circle() => 6.0,
            Point::Polar(_) if case.k.is_none() => growth,
            point => growth + (1.0 + condition(&point, case.quantity())).log2(),
        };
        assert!(lost <= bound, "{}: {lost} bits lost, the bound is {bound:.1}", case.label());
    }
}

/// What plain `f64` gets wrong even by the stable forms: the reason for the other rungs.
#[test]
fn plain_floats_are_wrong_on_these() {
    let cases = cases();
    let wrong =
        cases.iter().filter(|case| sign_by(&case.point(), case.quantity(), Rung::Plain) != case.expected());
    let count = |name: &str| wrong.clone().filter(|case| case.name == name).count();
    assert_eq!(count("close to a singular boundary"), 6);
    assert_eq!(count("close to an iterate boundary"), 2);
    assert_eq!(wrong.count(), 8);
}
