//! Certificates of events.

use grazing::{
    number::{Real, Sign},
    oscillator::validate::Quotient,
    scene::Expression,
};
use num_bigint::BigInt;
use num_rational::BigRational;

/// An expression in p and d = 1/3 as a function of p.
fn quotient(text: &str) -> grazing::Result<Quotient> {
    let names = ["p".to_string(), "d".to_string()];
    let third = BigRational::new(1.into(), 3.into());
    let values = [Quotient::parameter(), Quotient::ratio(&third, &())];
    Expression::parse(text, &names)?.evaluate(&values, &())
}

#[test]
fn expressions_become_quotients_of_polynomials() {
    for (text, above, below) in [
        ("1 + p", vec![1, 1], vec![1]),
        ("2*d/p", vec![2], vec![0, 3]),
        ("1/p^2 - d", vec![3, 0, -1], vec![0, 0, 3]),
        ("d - 1/3", vec![0], vec![1]),
        ("p - p", vec![0], vec![1]),
        ("-1/(1 - p)", vec![1], vec![-1, 1]),
        ("(p + 1)*(p - 1)/2", vec![-1, 0, 1], vec![2]),
        ("0.5*p/p", vec![0, 1], vec![0, 2]),
        ("p^64", [vec![0; 64], vec![1]].concat(), vec![1]),
    ] {
        let value = quotient(text).unwrap();
        let small = |list: &Vec<BigInt>| list.iter().map(|x| x.try_into().unwrap()).collect::<Vec<i64>>();
        assert_eq!(
            value.polynomials().map(|both| both.each_ref().map(small)),
            Some([above, below]),
            "{text}"
        );
    }
    for text in ["p^65", "1/(p+1)^40 + 1/(p+2)^40", "p*1e4000 + 1e-4000"] {
        assert!(quotient(text).is_err() || quotient(text).unwrap().polynomials().is_none(), "{text}");
    }
    assert!(quotient("1/(p - p)").unwrap_err().to_string().contains("divides by zero"));
}

#[test]
fn signs_of_quotients_are_those_of_constants_only() {
    let sign = |text: &str| quotient(text).unwrap().sign();
    assert_eq!(sign("p - p"), Some(Sign::Zero));
    assert_eq!(sign("-d"), Some(Sign::Negative));
    assert_eq!(sign("2"), Some(Sign::Positive));
    assert_eq!(sign("p^2 + 1"), None);
    assert_eq!(sign("1/p"), None);
}
