//! The hard cases of tests/data/hard_cases.toml on every rung: right or undecided, never wrong.
//!
//! The references come from FLINT and from Python's fractions (tests/data/make_hard_cases.py).

use grazing::local::condition::condition;
use grazing::local::{Answer, Ladder, Plane, Point, Polar, Quantity, Rung, sign_by};
use grazing::number::{Ball, FloatInterval, Precision, Sign, parse_rational};
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
    let text = include_str!("../data/hard_cases.toml");
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

/// Numbers in the last binade of the floats.
#[test]
fn the_largest_floats_give_no_wrong_sign() {
    let number = |text| parse_rational(text).unwrap();
    let point = Point::Plane(Plane::new(number("12e153"), number("1e308")).unwrap());
    // b_{3,1} = (a₁ + 1)(a₁ − a₂ − 1)/(a₁² − a₂).
    let expected = Answer::Sign(Sign::Negative);
    for (rung, needed) in [(Rung::Interval, false), (Rung::Ball(128), true), (Rung::Exact, true)] {
        let answer = sign_by(&point, Quantity::B { n: 3, k: 1 }, rung);
        assert!(answer == expected || !needed && answer == Answer::Undecided, "{rung:?} says {answer:?}");
    }
}

/// Powers r^n whose exponents exceed 64 bits: the term is negligible, so that b u_n has the sign of −sin
/// 2πks.
#[test]
fn exponents_beyond_the_range_give_no_wrong_sign() {
    let number = |text| parse_rational(text).unwrap();
    let ladder = Ladder::default();
    for (n, k, r, s) in [
        (93_000_000_000_000_004, 7, "2^-100", "1/7+2^-1100"),
        (93_000_000_000_000_004, 8, "2^-100", "1/7+2^-1100"),
        (9_000_000_000_000_000_000, 1, "1e-30", "1/7"),
        (u64::MAX, 2, "1e-300", "2/7"),
        (u64::MAX, u64::MAX - 2, "1e-30", "1/7"),
        (1 << 62, 1, "1/2", "1/5"),
        (1 << 63, 1, "1/2", "1/5"),
    ] {
        let polar = Polar::new(number(r), number(s)).unwrap();
        let sine = |index: u64| {
            let turns = number(s) * BigRational::from_integer(index.into());
            let rest = &turns - turns.floor();
            if rest < number("1/2") { Sign::Positive } else { Sign::Negative }
        };
        // M = r^{n−k} sin 2πns − sin 2πks − rⁿ sin 2π(n−k)s.
        let expected = Answer::Sign(-(sine(k) * sine(n)));
        let (point, quantity) = (Point::Polar(polar), Quantity::B { n, k });
        for rung in [Rung::Interval, Rung::Ball(128), Rung::Ball(4096)] {
            let answer = sign_by(&point, quantity, rung);
            assert!(answer == expected || answer == Answer::Undecided, "{n}, {k}: {rung:?} says {answer:?}");
        }
        assert_eq!(ladder.sign(&point, quantity).answer, expected, "{n}, {k}, {r}, {s}");
        // b itself is large beyond every exponent, but for k = n − 2: no digit may be wrong.
        let value = point.evaluate::<Ball>(quantity, &Precision::new(128)).expect("not singular");
        if let Some((low, high)) = value.exact_bounds() {
            let beyond = number("2^1000");
            assert!(k == n - 2 || low < -beyond.clone() || high > beyond, "{n}, {k}: {value:?}");
        }
    }
    // Growing powers, u_n beyond every exponent.
    let point = Point::Plane(Plane::new(number("2^60"), number("1/3")).unwrap());
    for k in [1, 2, (1 << 60) - 1] {
        // u_n − u_k − a₂^k u_{n−k} > 0 in region 1.
        let answer = ladder.sign(&point, Quantity::B { n: 1 << 60, k }).answer;
        assert!(matches!(answer, Answer::Undecided | Answer::Sign(Sign::Positive)), "{answer:?}");
    }
}

/// An exact zero, b_{3,1} = (a₁ + 1)(a₁ − a₂ − 1)/(a₁² − a₂) at a₁ = −1, whose integers exceed the first
/// exact try.
#[test]
fn the_last_exact_try_goes_beyond_the_first() {
    let a2 = parse_rational("1/3+2^-20000").unwrap();
    let point = Point::Plane(Plane::new(-parse_rational("1").unwrap(), a2).unwrap());
    let decision = Ladder::new(256).sign(&point, Quantity::B { n: 3, k: 1 });
    assert_eq!((decision.answer, decision.rung), (Answer::Sign(Sign::Zero), Rung::Exact));
}

/// A monitor ends a sign on the way, however long its integers are.
#[test]
fn an_interruption_ends_a_sign() {
    struct After(std::sync::atomic::AtomicU32);
    impl grazing::Monitor for After {
        fn advance(&self, _: u64) -> grazing::Result<()> {
            let left = self.0.fetch_update(SeqCst, SeqCst, |left| left.checked_sub(1));
            left.map(drop).map_err(|_| grazing::Error::interrupted("enough"))
        }
    }
    use std::sync::atomic::Ordering::SeqCst;
    let a2 = parse_rational("1/3+2^-20000").unwrap();
    let point = Point::Plane(Plane::new(-parse_rational("1").unwrap(), a2).unwrap());
    let quantity = Quantity::B { n: 3, k: 1 };
    let ladder = Ladder::new(256);
    let ended = |calls: u32| ladder.sign_watched(&point, quantity, &After(calls.into()));
    assert!((0..8).all(|calls| ended(calls).unwrap_err().is_interrupted()));
    assert_eq!(ended(1000).unwrap().answer, Answer::Sign(Sign::Zero));
}
