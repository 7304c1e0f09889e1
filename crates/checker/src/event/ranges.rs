//! Coefficients that depend on the parameter and are known to lie within intervals: quotients of polynomials
//! whose coefficients are ranges.

use std::fmt;

use super::{
    super::{
        lines::Words,
        motion::{
            number::Number,
            range::Range,
            text::Coefficient,
            words::{Spoken, polynomial, quotient},
        },
    },
    quotient::{DEGREE, value},
};
use crate::rejection::ensure;

/// (P₀ + P₁ p + …)/(Q₀ + Q₁ p + …), each P and Q any number in its range.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RangeQuotient {
    /// P₀, P₁, …
    pub numerator: Vec<Range>,
    /// Q₀, Q₁, …
    pub denominator: Vec<Range>,
}

impl Coefficient for RangeQuotient {
    const VARIES: bool = true;

    fn is_zero(&self) -> bool {
        self.numerator.iter().all(Coefficient::is_zero)
    }

    fn is_negative(&self) -> bool {
        let alone = self.denominator.len() == 1 && self.numerator.len() == 1;
        alone
            && Coefficient::is_negative(&self.numerator[0])
            && !Coefficient::is_negative(&self.denominator[0])
    }

    fn enclosed<N: Number>(&self, parameter: N) -> N {
        let of = |list: &[Range]| value(&list.iter().map(Range::interval).collect::<Vec<_>>(), parameter);
        of(&self.numerator).over(of(&self.denominator))
    }

    fn read(words: &mut Words) -> Result<Self, String> {
        let polynomial = |text: &str| -> Result<Vec<Range>, String> {
            let list: Vec<Range> = text.split(',').map(Range::parse).collect::<Result<_, _>>()?;
            let holds = list.len() <= DEGREE + 1;
            ensure(holds, format_args!("a polynomial has at most {} coefficients", DEGREE + 1))?;
            Ok(list)
        };
        let word = words.word("a quotient P0,P1,.../Q0,Q1,... of ranges")?;
        let (numerator, denominator) =
            word.split_once('/').ok_or("expected a quotient P0,P1,.../Q0,Q1,... of ranges LOWER..UPPER")?;
        Ok(RangeQuotient { numerator: polynomial(numerator)?, denominator: polynomial(denominator)? })
    }
}

impl fmt::Display for RangeQuotient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |list: &[Range]| list.iter().map(Range::to_string).collect::<Vec<_>>().join(",");
        write!(f, "{}/{}", list(&self.numerator), list(&self.denominator))
    }
}

impl Spoken for RangeQuotient {
    fn is_negative(&self) -> bool {
        matches!(&self.numerator[..], [only] if Spoken::is_negative(only))
    }

    fn magnitude(&self, parameter: &str) -> String {
        let above = match &self.numerator[..] {
            [only] => only.magnitude(parameter),
            list => polynomial(list, parameter),
        };
        quotient(above, &self.denominator, parameter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_of_ranges_read_as_one_writes_them() {
        for (word, sign, text) in [
            ("-3..-3/1..1", true, "3"),
            ("-3..-2/1..1", false, "[-3, -2]"),
            ("1..1,2..3/2..2", false, "(1 + [2, 3] p)/2"),
            ("1..1/0..0,2..2", false, "1/(2 p)"),
            ("0..0/1..2", false, "0"),
            ("-1..-1/1..1,0..0,-1..-1", true, "1/(1 - p^2)"),
        ] {
            let read = RangeQuotient::read(&mut Words::new(word)).unwrap_or_else(|why| panic!("{why}"));
            assert_eq!((Spoken::is_negative(&read), read.magnitude("p").as_str()), (sign, text), "{word}");
        }
    }
}
