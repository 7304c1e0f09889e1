//! exp, sin, cos and √ of balls against FLINT (tests/data/elementary.csv), identities, and plain floats.

use grazing_number::{Ball, Elementary, Plain, Precision, Real, Sign, parse_rational};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

fn dyadic(p: &BigInt, e: i32) -> BigRational {
    let power = BigInt::one() << e.unsigned_abs();
    if e < 0 { BigRational::new(p.clone(), power) } else { BigRational::from_integer(p * power) }
}

fn width(x: &Ball) -> BigRational {
    let (lo, hi) = x.exact_bounds().unwrap();
    hi - lo
}

/// The functions by name, one ball in and one out.
fn apply(name: &str, x: &Ball, precision: &Precision) -> Ball {
    match name {
        "exp" => x.exp(precision),
        "sin" => x.sin_cos(precision).0,
        "cos" => x.sin_cos(precision).1,
        _ => x.sqrt(),
    }
}

#[test]
fn values_agree_with_flint() {
    let text = include_str!("data/elementary.csv");
    assert!(text.lines().count() > 400);
    let precisions = [24, 53, 128, 300, 1024, 4000].map(Precision::new);
    for line in text.lines() {
        let words: Vec<&str> = line.split(',').collect();
        let (p, e): (BigInt, i32) = (words[1].parse().unwrap(), words[2].parse().unwrap());
        let x = dyadic(&p, e);
        let value = parse_rational(words[3]).unwrap();
        let digits: u32 = if words[3].len() > 1000 { 1298 } else { 59 };
        let slack = value.abs() / pow(BigInt::from(10), digits as usize - 1);
        for precision in &precisions {
            let bits = i64::from(precision.bits());
            let argument = Ball::ratio(&x, precision);
            let answer = apply(words[0], &argument, precision);
            let (lo, hi) = answer.exact_bounds().unwrap();
            assert!(lo <= &value + &slack && &value - &slack <= hi, "{line:.80} at {bits} bits");
            if width(&argument).is_zero() {
                let unit = dyadic(&BigInt::one(), (answer.exponent().unwrap_or(0) - bits) as i32);
                assert!(hi - lo <= unit * BigInt::from(6), "{line:.80} at {bits} bits is too wide");
            }
        }
    }
}

#[test]
fn arguments_without_an_answer_say_so() {
    let precision = Precision::new(64);
    let exact = |text: &str| Ball::ratio(&parse_rational(text).unwrap(), &precision);
    assert!(exact("-1").sqrt().exact_bounds().is_none());
    let straddling = Ball::between(&BigRational::from_integer((-1).into()), &BigRational::one(), &precision);
    assert!(straddling.sqrt().exact_bounds().is_none());
    assert!(exact("0").sqrt().contains(&BigRational::zero()) && width(&exact("0").sqrt()).is_zero());
    assert!(exact("2^70").exp(&precision).exact_bounds().is_none());
    let tiny = exact("-2^70").exp(&precision);
    assert!(tiny.contains(&BigRational::zero()) && width(&tiny) <= parse_rational("2").unwrap());
    let whole = exact("1") / &straddling;
    assert!(whole.exp(&precision).exact_bounds().is_none() && whole.sqrt().exact_bounds().is_none());
    let (sin, cos) = whole.sin_cos(&precision);
    for value in [sin, cos, exact("2^5000").sin_cos(&precision).0] {
        assert_eq!(value.exact_bounds(), Some((-BigRational::one(), BigRational::one())));
    }
    assert_eq!(Real::sign(&exact("0").sin_cos(&precision).0), Some(Sign::Zero));
}

proptest! {
    #![proptest_config(ProptestConfig::with_failure_persistence(FileFailurePersistence::WithSource("regressions")))]

    /// A wide ball's image contains the images of the points in it, and is not much wider than needed.
    #[test]
    fn wide_arguments_are_right(
        p in -10_000i64..10_000, e in -12i32..1, spread in 0u64..1 << 20, down in 0i32..44, part in -1000i64..=1000,
        bits in prop_oneof![Just(53u32), Just(128)],
    ) {
        let precision = Precision::new(bits);
        let (mid, radius) = (dyadic(&p.into(), e), dyadic(&spread.into(), -down));
        let x = Ball::between(&(&mid - &radius), &(&mid + &radius), &precision);
        let point = &mid + &radius * BigRational::new(part.into(), 1000.into());
        let inner = Ball::ratio(&point, &precision);
        for name in ["exp", "sin", "cos", "sqrt"] {
            let (wide, narrow) = (apply(name, &x, &precision), apply(name, &inner, &precision));
            // A root is not known where the argument may be negative; above 2^2¹⁷, e^90852, numbers are not
            // written out.
            let (Some((lo, hi)), Some((low, high))) = (wide.exact_bounds(), narrow.exact_bounds()) else {
                let unknown = match name {
                    "sqrt" => mid <= radius,
                    "exp" => &mid + &radius > BigRational::from_integer(90_850.into()),
                    _ => false,
                };
                prop_assert!(unknown, "nothing is known of {} of {}", name, point);
                continue;
            };
            // Both hold the true value.
            prop_assert!(low <= hi && lo <= high, "{} of {} is not in the image", name, point);
            let limit = match name {
                "exp" => &hi * &radius.clone().max(BigRational::one()) * &radius.clone().min(BigRational::one()),
                "sqrt" => continue,
                _ => radius.clone().min(BigRational::one()),
            } * BigInt::from(2);
            let rounding = dyadic(&BigInt::one(), 6 - bits as i32) * (BigRational::one() + hi.abs());
            prop_assert!(&hi - &lo <= limit * BigRational::new(101.into(), 100.into()) + rounding, "{} is too wide", name);
        }
    }

    /// sin² + cos² = 1, e^x e^−x = 1, (√x)² = x, and the addition theorems; plain floats are near.
    #[test]
    fn identities_hold(p in any::<i64>(), e in -70i32..-50, q in -1000i64..1000) {
        let precision = Precision::new(200);
        let x = Ball::ratio(&dyadic(&p.into(), e), &precision);
        let y = Ball::ratio(&dyadic(&q.into(), -7), &precision);
        let one = BigRational::one();
        let tight = dyadic(&BigInt::one(), -150);
        let is = |value: Ball, exact: &BigRational| value.contains(exact) && width(&value) < tight;
        let ((s, c), (s2, c2)) = (x.sin_cos(&precision), y.sin_cos(&precision));
        prop_assert!(is(s.clone() * &s + &(c.clone() * &c), &one));
        let (sum, _) = (x.clone() + &y).sin_cos(&precision);
        prop_assert!(is(s.clone() * &c2 + &(c.clone() * &s2) - &sum, &BigRational::zero()));
        let product = y.exp(&precision) * &(-y.clone()).exp(&precision);
        prop_assert!(is(product, &one));
        let square = x.clone() * &x;
        let root = square.sqrt();
        prop_assert!(is(root.clone() * &root - &square, &BigRational::zero()));
        let plain = Plain(p as f64 * 2f64.powi(e)).sin_cos(&());
        let near = |ball: &Ball, float: f64| {
            (ball.clone() - &Ball::ratio(&BigRational::from_float(float).unwrap(), &precision)).exponent().is_none_or(|e| e < -30)
        };
        prop_assert!(near(&s, plain.0.0) && near(&c, plain.1.0));
        prop_assert!(near(&y.exp(&precision).centre(), Plain(q as f64 / 128.0).exp(&()).0));
    }
}
