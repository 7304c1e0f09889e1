//! The symbolic formulas against recurrences, matrices and their own printed text.

use std::collections::HashMap;

use grazing::symbol::{
    Area, Factored, Format, HalfCellSide, Polynomial, Sentence, chebyshev_roots, period_formulas,
    roots_above, write_formulas,
};
use num_bigint::BigInt;
use num_integer::gcd;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};
use proptest::prelude::*;

use crate::common;
use crate::reader;
use reader::{infix, prefix};

fn rational() -> impl Strategy<Value = BigRational> {
    (-40i64..40, 1i64..25).prop_map(|(p, q)| BigRational::new(p.into(), q.into()))
}

fn period_and_index(most: usize) -> impl Strategy<Value = (usize, usize)> {
    (2..=most).prop_flat_map(|n| (Just(n), 1..n))
}

/// Rows of Aⁿ for A = [[a₁, 1], [−a₂, 0]], by plain multiplication.
fn power(at: &[BigRational; 2], n: usize) -> [[BigRational; 2]; 2] {
    let zero = BigRational::zero;
    let mut rows = [[BigRational::one(), zero()], [zero(), BigRational::one()]];
    for _ in 0..n {
        rows = rows.map(|[x, y]| [&x * &at[0] - &y * &at[1], x]);
    }
    rows
}

fn product(f: &Factored) -> Polynomial {
    let product = f.factors.iter().cloned().product();
    if f.negative { -&product } else { product }
}

proptest! {
    #![proptest_config(common::config())]

    /// b_{n,k} = (1 0) Aᵏ X + 1 with (I − Aⁿ)'s first row killing X, X₁ = −1 (51), (54); det(I − Aⁿ) from the
    /// matrix.
    #[test]
    fn polynomials_agree_with_matrix_powers((n, k) in period_and_index(20), at in [rational(), rational()]) {
        let [u_n, u_k, numerator, determinant] =
            period_formulas(n, k).unwrap().map(|f| f.expanded.evaluate(&at));
        let ([[a, b], [c, d]], one) = (power(&at, n), BigRational::one());
        prop_assert_eq!(&u_n, &b);
        let [x, y] = power(&at, k)[0].clone();
        prop_assert_eq!(u_k, y.clone());
        prop_assert_eq!(determinant, (&one - &a) * (&one - &d) - &b * &c);
        if !b.is_zero() {
            let second = (&a - &one) / b;
            prop_assert_eq!(numerator / u_n, y * second - x + one);
        }
    }

    #[test]
    fn what_is_printed_is_what_was_meant((n, k) in period_and_index(12), at in [rational(), rational()]) {
        let formulas = period_formulas(n, k).unwrap();
        let values: Vec<_> = formulas.iter().map(|f| f.expanded.evaluate(&at)).collect();
        let at = HashMap::from([("a1", at[0].clone()), ("a2", at[1].clone())]);
        let [text, latex, sympy, smtlib, qepcad] =
            [Format::Text, Format::Latex, Format::Sympy, Format::Smtlib, Format::Qepcad]
                .map(|format| write_formulas(&formulas, format));

        let sides = |line: &str| line.split('=').skip(1).map(|side| infix(side, &at)).collect::<Vec<_>>();
        let lines: Vec<_> = text.lines().filter(|line| line.starts_with("  =")).flat_map(sides).collect();
        let twice: Vec<_> = values.iter().flat_map(|v| [v.clone(), v.clone()]).collect();
        prop_assert_eq!(&lines, &twice);
        let latex = reader::maths(&latex);
        let lines: Vec<_> = latex.lines().filter(|line| line.contains('=')).flat_map(sides).collect();
        prop_assert_eq!(&lines, &twice);
        let lines: Vec<_> = qepcad.lines().filter(|line| line.contains('=')).flat_map(|line| {
            let line = line.replace("(A a1)(A a2) [", "").replace(" ].", "").replace("/\\", "");
            format!("={line}").split('=').skip(1).map(|side| infix(side, &at)).collect::<Vec<_>>()
        }).collect();
        prop_assert_eq!(&lines, &twice);
        let named: Vec<_> = sympy.lines().skip(3).map(|line| match line.strip_prefix("assert expand(") {
            None => infix(line.split_once(" = ").unwrap().1, &at),
            Some(rest) => infix(rest.split_once(" - (").unwrap().1.strip_suffix(")) == 0").unwrap(), &at),
        }).collect();
        prop_assert_eq!(&named, &twice);
        prop_assert_eq!(prefix::asserted(&smtlib, &at), [false]);
        prop_assert_eq!(prefix::definitions(&smtlib, &at), values);
    }

}

proptest! {
    #![proptest_config(ProptestConfig { cases: crate::samples::samples(16), ..common::config() })]

    /// A sentence says the same in every format, its hypotheses describe its half-cell, and it is true where
    /// it is tried.
    #[test]
    fn sentences_are_true_and_agree_between_formats(
        n in 3usize..12, m in 1usize..6, plus in any::<bool>(), c in -510i64..510, r in 1i64..=32,
    ) {
        prop_assume!(2 * m < n && gcd(m, n) == 1);
        let area = Area::HalfCell { m, side: if plus { HalfCellSide::Plus } else { HalfCellSide::Minus } };
        let sentence = Sentence::new(n, area).unwrap();
        let s = (c as f64 / 511.).acos() / (2. * std::f64::consts::PI);
        let at = HashMap::from([
            ("c", BigRational::new(c.into(), 511.into())),
            ("r", BigRational::new(r.into(), 32.into())),
        ]);
        let inside = if plus { (m as f64 - 0.5, m as f64) } else { (m as f64, m as f64 + 0.5) };
        let place = s * n as f64;
        prop_assume!((2. * place - (2. * place).round()).abs() > 1e-6);
        prop_assert_eq!(agree_and_hold(&sentence, &at), inside.0 < place && place < inside.1);
    }

    #[test]
    fn region4_sentences_are_true_and_agree_between_formats(n in 3usize..14, at in [rational(), rational()]) {
        let at = [-at[0].abs() / BigInt::from(20), at[1].abs() / BigInt::from(40)];
        let inside = at[1].is_positive() && at[1] < BigRational::one() && &at[0] + &at[1] > -BigRational::one()
            && &at[0] * &at[0] >= &at[1] * BigInt::from(4) && at[0].is_negative();
        let at = HashMap::from([("a1", at[0].clone()), ("a2", at[1].clone())]);
        prop_assert_eq!(agree_and_hold(&Sentence::new(n, Area::Region4).unwrap(), &at), inside);
    }
}

/// Checks the sentence at one point, and that each format compares the same values; true if its hypotheses
/// hold.
fn agree_and_hold(sentence: &Sentence, at: &HashMap<&str, BigRational>) -> bool {
    let script = sentence.write(Format::Smtlib);
    let asserted = prefix::asserted(&script, at);
    assert_eq!(asserted.len(), 2, "hypotheses and the negated claim");
    assert!(!(asserted[0] && asserted[1]), "{script} is false at {at:?}");
    let expected = prefix::comparisons(&script, at);
    for format in [Format::Text, Format::Latex, Format::Sympy, Format::Qepcad] {
        let text = sentence.write(format);
        let text = if format == Format::Latex { reader::maths(&text) } else { text };
        assert_eq!(reader::comparisons(&text, format, at), expected, "{format:?}: {text}");
    }
    asserted[0]
}

#[test]
fn factors_multiply_back_and_include_the_proved_ones() {
    let divisors = |n: usize| (1..=n).filter(|d| n.is_multiple_of(*d)).count();
    let linear = |a2: i32, one: i32| {
        &(&Polynomial::variable(0) + &(&Polynomial::from(a2) * &Polynomial::variable(1)))
            + &Polynomial::from(one)
    };
    for n in 2..=24 {
        for k in 1..n {
            let formulas = period_formulas(n, k).unwrap();
            for f in &formulas {
                assert_eq!(product(f), f.expanded, "n = {n}, k = {k}");
            }
            let [u_n, u_k, numerator, determinant] = &formulas;
            let g = gcd(n, k);
            assert_eq!(u_n.factors.len(), divisors(n) - 1);
            assert_eq!(u_k.factors.len(), divisors(k) - 1);
            assert_eq!(determinant.factors.len(), divisors(n));
            assert!(numerator.factors.contains(&linear(-1, -1)), "a1 - a2 - 1, n = {n}, k = {k}");
            assert_eq!(numerator.factors.contains(&linear(1, 1)), g % 2 == 0, "n = {n}, k = {k}");
            let known = 2 * divisors(g) - 1;
            assert!([known, known + 1].contains(&numerator.factors.len()), "n = {n}, k = {k}");
        }
    }
}

/// 2 N_{n,k} = u_n (2 − v_k) − u_k (2 − v_n), as polynomials.
#[test]
fn record_identity() {
    let (two, a2) = (Polynomial::from(2), Polynomial::variable(1));
    // v_j = u_{j+1} − a₂ u_{j−1}, built from the binomial form of u and not by the recurrence.
    let v = |j: usize| &binomial_u(j + 1) - &(&a2 * &binomial_u(j - 1));
    for n in 2..=20 {
        for k in 1..n {
            let [u_n, u_k, numerator, _] = period_formulas(n, k).unwrap().map(|f| f.expanded);
            assert_eq!(u_n, binomial_u(n));
            let right = &(&u_n * &(&two - &v(k))) - &(&u_k * &(&two - &v(n)));
            assert_eq!(&two * &numerator, right, "n = {n}, k = {k}");
        }
    }
}

/// u_n = Σ (−1)^j C(n−1−j, j) a₁^{n−1−2j} a₂^j.
fn binomial_u(n: usize) -> Polynomial {
    let term = |j: usize| {
        let sign = if j.is_multiple_of(2) { 1 } else { -1 };
        let binomial = num_integer::binomial(BigInt::from(n - 1 - j), BigInt::from(j)) * sign;
        Polynomial::monomial(binomial, [(n - 1 - 2 * j) as u32, j as u32])
    };
    (0..n.div_ceil(2)).filter(|j| 2 * j < n).map(term).fold(Polynomial::default(), |sum, t| &sum + &t)
}

/// The brackets are disjoint and U_{n−1}, of degree n − 1, changes sign on each: so each holds exactly one
/// root, with no appeal to Sturm; and it is the right one by its place.
#[test]
fn every_bracket_holds_one_root() {
    // q^{n−1} U_{n−1}(p/q)
    let value = |n: usize, x: &BigRational| {
        let u = binomial_u(n);
        u.evaluate(&[x * BigInt::from(2), BigRational::one()])
    };
    for n in 3..=50 {
        let mut above = BigRational::one();
        for j in 1..n {
            let [low, high] = chebyshev_roots(n, j);
            assert!(low < high && high == above, "n = {n}, j = {j}");
            assert!((value(n, &low) * value(n, &high)).is_negative(), "n = {n}, j = {j}");
            above = low;
        }
        assert_eq!(above, -BigRational::one());
        assert_eq!(roots_above(n, &pow(BigRational::new(1.into(), 2.into()), 400)).0, (n - 1) / 2);
    }
}

#[test]
fn what_does_not_exist_is_an_input_error() {
    for (n, k) in [(1, 1), (3, 0), (3, 3), (201, 1)] {
        assert!(period_formulas(n, k).unwrap_err().is_input());
    }
    assert!(Sentence::new(2, Area::Region4).is_err());
    for (n, area) in [(6, "2+"), (5, "3-"), (5, "0+"), (8, "4+")] {
        assert!(Sentence::new(n, area.parse().unwrap()).unwrap_err().is_input(), "{area} of {n}");
    }
    for wrong in ["", "+", "x+", "3", "region5", "-1+"] {
        assert!(wrong.parse::<Area>().unwrap_err().is_input(), "{wrong:?}");
    }
}
