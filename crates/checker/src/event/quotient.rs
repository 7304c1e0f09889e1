//! Coefficients that depend on the parameter: quotients of polynomials.

use std::fmt;

use super::super::{
    decimal::{gcd, integer},
    lines::Words,
    motion::{
        Interval,
        number::Number,
        text::{Coefficient, DIGITS},
        words::{Spoken, polynomial, quotient},
    },
};

/// The highest power of the parameter.
pub(super) const DEGREE: usize = 16;

/// (P₀ + P₁ p + P₂ p² + …)/(Q₀ + Q₁ p + …) in integers, the coefficients by rising powers. It may have common
/// factors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quotient {
    /// P₀, P₁, …: the last is not 0, unless it is the only one.
    pub numerator: Vec<i128>,
    /// Q₀, Q₁, …: the last is above 0.
    pub denominator: Vec<i128>,
}

impl Quotient {
    /// Whether it has the one form in which it may be written, but for its size: no highest power is 0, no
    /// integer above 1 divides all coefficients, the denominator's last is positive.
    fn is_canonical(&self) -> bool {
        let (numerator, denominator) = (&self.numerator, &self.denominator);
        let divisor = numerator.iter().chain(denominator).fold(0, |all, x| gcd(all, x.unsigned_abs()));
        let ends = numerator.len() == 1 || numerator.last() != Some(&0);
        ends && denominator.last().is_some_and(|&last| last > 0) && divisor == 1
    }

    /// All coefficients divided by the greatest of the denominator's, so that they are of moderate size.
    fn scaled(&self) -> [Vec<Interval>; 2] {
        let scale = self.denominator.iter().map(|x| x.abs()).max().unwrap_or(1);
        [&self.numerator, &self.denominator]
            .map(|list| list.iter().map(|&x| Interval::ratio(x, scale)).collect())
    }
}

impl Coefficient for Quotient {
    const VARIES: bool = true;

    fn is_zero(&self) -> bool {
        self.numerator == [0]
    }

    fn is_negative(&self) -> bool {
        self.denominator.len() == 1 && self.numerator.len() == 1 && self.numerator[0] < 0
    }

    fn enclosed<N: Number>(&self, parameter: N) -> N {
        let [numerator, denominator] = self.scaled();
        value(&numerator, parameter).over(value(&denominator, parameter))
    }

    fn read(words: &mut Words) -> Result<Self, String> {
        let polynomial = |text: &str| -> Option<Vec<i128>> {
            let list: Vec<i128> = text.split(',').map(|word| integer(word, DIGITS)).collect::<Option<_>>()?;
            (list.len() <= DEGREE + 1).then_some(list)
        };
        let read = |word: &str| {
            let (numerator, denominator) = word.split_once('/')?;
            Some(Quotient { numerator: polynomial(numerator)?, denominator: polynomial(denominator)? })
        };
        let holds = |x: &Quotient| x.is_canonical() && x.scaled().iter().flatten().all(|x| x.is_known());
        read(words.word("a quotient of polynomials")?).filter(holds).ok_or_else(|| {
            format!(
                "expected a quotient P0,P1,.../Q0,Q1,... in lowest terms, up to power {DEGREE}, in integers of at most {DIGITS} digits"
            )
        })
    }
}

impl fmt::Display for Quotient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |list: &[i128]| list.iter().map(i128::to_string).collect::<Vec<_>>().join(",");
        write!(f, "{}/{}", list(&self.numerator), list(&self.denominator))
    }
}

impl Spoken for Quotient {
    fn is_negative(&self) -> bool {
        terms(&self.numerator) == 1 && self.numerator.last().is_some_and(|&x| x < 0)
    }

    fn magnitude(&self, parameter: &str) -> String {
        let minus = Spoken::is_negative(self);
        let numerator: Vec<i128> = self.numerator.iter().map(|&x| if minus { -x } else { x }).collect();
        quotient(polynomial(&numerator, parameter), &self.denominator, parameter)
    }
}

/// A polynomial's value, by Horner's rule.
pub(super) fn value<N: Number>(list: &[Interval], parameter: N) -> N {
    list.iter().rev().fold(N::ZERO, |sum, &x| sum * parameter + N::constant(x))
}

/// The number of terms that are not 0.
fn terms(list: &[i128]) -> usize {
    list.iter().filter(|&&x| x != 0).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::number::Dual;

    fn read(word: &str) -> Option<Quotient> {
        Quotient::read(&mut Words::new(word)).ok()
    }

    #[test]
    fn every_quotient_has_one_form_but_for_common_factors() {
        let most = "0,".repeat(16) + "1/1";
        for good in ["0/1", "1/1", "-1/3", "1,1/1", "1/0,0,1", "0,-3/7,2", "0,1/0,1", &most] {
            assert_eq!(read(good).map(|x| x.to_string()).as_deref(), Some(good));
        }
        let long = "0,".repeat(17) + "1/1";
        for bad in [
            "0/2",
            "0,0/1",
            "1,0/1",
            "2,2/2",
            "1/-1",
            "1/0",
            "1/0,0",
            "1/",
            "/1",
            "1",
            "1,/1",
            "1,,1/1",
            "1,1/1/1",
            "+1/1",
            "-0/1",
            "01/1",
            "1.5/1",
            "1073741824/1",
            "1,-1/1,-1",
            &long,
        ] {
            assert_eq!(read(bad), None, "{bad}");
        }
    }

    #[test]
    fn values_and_slopes_are_enclosed() {
        // (1 + 2 p)/(3 p²) at p = 1/4: 8; its derivative −(2 + 2p)/(3 p³) = −160/3.
        let x = read("1,2/0,0,3").unwrap();
        let p = Dual { value: Interval::ratio(1, 4), slope: Interval::ONE };
        let at = x.enclosed(p);
        let error = Interval::ratio(1, 1 << 60);
        assert!(at.value.is_within(error, Interval::integer(8)));
        assert!(at.slope.is_within(error, Interval::ratio(-160, 3)));
        // Nothing is known about a pole.
        let pole = Dual { value: Interval::ratio(-1, 9).until(Interval::ONE), slope: Interval::ONE };
        assert!(!x.enclosed(pole).value.is_known());
    }

    #[test]
    fn quotients_read_as_one_writes_them() {
        for (word, text) in [
            ("1,1/1", "(1 + mu)"),
            ("-12/49", "12/49"),
            ("1/0,0,1", "1/(mu^2)"),
            ("0,-2/5", "2 mu/5"),
            ("-1,0,3/1,-1,4", "(-1 + 3 mu^2)/(1 - mu + 4 mu^2)"),
            ("0/1", "0"),
        ] {
            assert_eq!(read(word).unwrap().magnitude("mu"), text);
        }
    }
}
