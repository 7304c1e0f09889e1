//! The number grammar.

use grazing_number::{LIMIT_BITS, parse_integer, parse_rational, parse_rational_within};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

fn ratio(p: i64, q: i64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

#[test]
fn every_form_is_exact() {
    let cases = [
        ("0", ratio(0, 1)),
        ("-7", ratio(-7, 1)),
        ("+7", ratio(7, 1)),
        ("3/8", ratio(3, 8)),
        ("6/16", ratio(3, 8)),
        ("0.375", ratio(3, 8)),
        (".5", ratio(1, 2)),
        ("5.", ratio(5, 1)),
        ("0.1", ratio(1, 10)),
        ("1e-3", ratio(1, 1000)),
        ("1.5E2", ratio(150, 1)),
        ("2^-10", ratio(1, 1024)),
        ("2^+3", ratio(8, 1)),
        ("0.5^2", ratio(1, 4)),
        ("3/2^4", ratio(3, 16)),
        ("1-2^-10", ratio(1023, 1024)),
        (" 3/8 + 2^-3 - 1 ", ratio(-1, 2)),
        ("- 1/3", ratio(-1, 3)),
        ("0e999999999999", ratio(0, 1)),
        ("0^0", ratio(1, 1)),
    ];
    for (text, value) in cases {
        assert_eq!(parse_rational(text).unwrap(), value, "{text}");
    }
    let fine = parse_rational("3/8+2^-200").unwrap();
    assert_eq!(fine - ratio(3, 8), BigRational::new(1.into(), BigInt::from(2).pow(200)));
}

#[test]
fn what_is_no_number_says_what_was_expected() {
    let cases = [
        ("", "expected a digit, found the end"),
        ("x", "expected a digit, found 'x'"),
        ("1 2", "expected `+` or `-`, found '2'"),
        ("1/", "expected a digit, found the end"),
        ("1/-2", "expected a digit, found '-'"),
        ("1..2", "expected `+` or `-`, found '.'"),
        ("2^", "expected the digits of an exponent, found the end"),
        ("1e", "expected the digits of an exponent, found the end"),
        ("1--", "expected a digit, found '-'"),
        ("½", "expected a digit, found '½'"),
        ("1/0", "divides by zero"),
        ("0^-1", "divides by zero"),
        ("1/0^2", "divides by zero"),
        ("1e-999999999", "too large or too fine"),
        ("2^99999999999999999999", "too large or too fine"),
        ("10^1000000", "too large or too fine"),
    ];
    for (text, expected) in cases {
        let error = parse_rational(text).unwrap_err();
        assert!(error.to_string().contains(expected), "{text}: {error}");
    }
    let long = "7".repeat(LIMIT_BITS as usize);
    let error = parse_rational(&long).unwrap_err().to_string();
    assert!(error.len() < 300, "the error abbreviates");
}

/// Refused, or read with one search for common factors at the end; these took seconds to minutes.
#[test]
fn what_would_grow_is_refused_at_once() {
    for text in [
        "1/3^500000",
        "1/3^500000+1/5^340000+1/7^340000",
        "2^32768",
        "3^99999999/3^99999999",
        "1/3^9999+1/5^9999",
        "1e-9865",
        "1e9865",
    ] {
        let error = parse_rational(text).unwrap_err();
        assert!(error.to_string().contains("at most 32768 bits"), "{error}");
    }
    let primes =
        [3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97];
    let long: String = primes.iter().cycle().take(120).map(|p| format!("+1/{p}^999")).collect();
    assert!(parse_rational(&long).is_err());
    // Under a common denominator nothing grows.
    let many = vec!["1/3^9000"; 110].join("+");
    assert_eq!(parse_rational(&many).unwrap(), parse_rational("110/3^9000").unwrap());
    assert_eq!(parse_rational("2^32767").unwrap().numer().bits(), u64::from(LIMIT_BITS));
    assert_eq!(parse_rational("(-1)").ok(), None);
    assert_eq!(parse_rational("1^999999999999").unwrap(), ratio(1, 1));
    assert_eq!(parse_rational("1/10^9000+1e-9000").unwrap(), parse_rational("2e-9000").unwrap());
    assert_eq!(
        parse_rational(&format!("0.{}1", "0".repeat(2000))).unwrap(),
        parse_rational("1e-2001").unwrap()
    );
}

#[test]
fn the_limit_is_the_callers() {
    for (text, least) in [("2^99", 100), ("1/2^99", 100), ("1023", 10), ("1e-3", 10), ("1/3+1/5", 4)] {
        assert!(parse_rational_within(text, least).is_ok(), "{text}");
        let error = parse_rational_within(text, least - 1).unwrap_err().to_string();
        assert!(error.contains(&format!("at most {} bits", least - 1)), "{error}");
    }
}

#[test]
fn whole_numbers_fit_their_type() {
    assert_eq!(parse_integer::<u64>("1e4").unwrap(), 10_000);
    assert_eq!(parse_integer::<u64>("2^64-1").unwrap(), u64::MAX);
    assert!(parse_integer::<u64>("2^64").unwrap_err().to_string().contains("too large"));
    assert!(parse_integer::<u64>("-1").unwrap_err().to_string().contains("negative"));
    assert!(parse_integer::<u64>("1/2").unwrap_err().to_string().contains("not a whole number"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_failure_persistence(FileFailurePersistence::WithSource("regressions")))]

    #[test]
    fn printing_and_reading_back(p in any::<i128>(), q in 1..=i128::MAX) {
        let x = BigRational::new(p.into(), q.into());
        prop_assert_eq!(parse_rational(&x.to_string()).unwrap(), x);
    }

    #[test]
    fn sums_are_sums(a in any::<i64>(), b in 1i64..1000, c in any::<i32>(), k in -60i32..60) {
        let power = BigRational::from_integer(2.into()).pow(k);
        let text = format!("{a}/{b} - {} + 2^{k}", c.unsigned_abs());
        let value = ratio(a, b) - BigRational::from_integer(c.unsigned_abs().into()) + power;
        prop_assert_eq!(parse_rational(&text).unwrap(), value);
    }

    #[test]
    fn decimals_are_powers_of_ten(whole in 0u64..1000, fraction in "[0-9]{0,12}", k in -20i32..20) {
        let value = parse_rational(&format!("{whole}.{fraction}e{k}")).unwrap();
        let digits: BigInt = format!("{whole}{fraction}").parse().unwrap();
        let scale = BigRational::from_integer(10.into()).pow(k - fraction.len() as i32);
        prop_assert_eq!(value, BigRational::from_integer(digits) * scale);
    }

    #[test]
    fn any_text_is_an_answer_and_no_panic(text in "[0-9+./e^ -]{0,12}") {
        let _ = parse_rational(&text).map(|x| assert_eq!(parse_rational(&x.to_string()).unwrap(), x));
    }
}
