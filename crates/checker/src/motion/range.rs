//! Coefficients that are known to lie between two decimals: what is proved holds for every value there.

use std::fmt;

use super::{
    super::decimal::gcd,
    Interval, Words,
    number::Number,
    text::{Coefficient, DIGITS, Decimal, Fraction},
    words::Spoken,
};

/// All numbers from `lower` to `upper`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range {
    /// The least.
    pub lower: Decimal,
    /// The greatest.
    pub upper: Decimal,
}

impl Range {
    /// `LOWER..UPPER`, in order.
    pub(crate) fn parse(word: &str) -> Result<Self, String> {
        let read = || {
            let (lower, upper) = word.split_once("..")?;
            let (lower, upper) = (Decimal::canonical(lower, DIGITS)?, Decimal::canonical(upper, DIGITS)?);
            let fits = [lower, upper].iter().all(|x| x.enclosed::<96>().is_known());
            (fits && lower.parts() <= upper.parts()).then_some(Range { lower, upper })
        };
        read().ok_or_else(|| {
            format!("expected LOWER..UPPER, decimals of at most {DIGITS} digits between -2^30 and 2^30, the lower first")
        })
    }

    /// The ends, in lowest terms.
    pub(crate) fn bounds(&self) -> [Fraction; 2] {
        [self.lower, self.upper].map(|Decimal { digits: p, places }| {
            let q = 10i128.pow(places);
            let common = gcd(p.unsigned_abs(), q.unsigned_abs()) as i128;
            Fraction { p: p / common, q: q / common }
        })
    }

    pub(crate) fn interval(&self) -> Interval {
        self.lower.enclosed().until(self.upper.enclosed())
    }
}

impl Coefficient for Range {
    const VARIES: bool = false;

    fn is_zero(&self) -> bool {
        self.lower.digits == 0 && self.upper.digits == 0
    }

    fn is_negative(&self) -> bool {
        self.lower.digits < 0
    }

    fn enclosed<N: Number>(&self, _: N) -> N {
        N::constant(self.interval())
    }

    fn read(words: &mut Words) -> Result<Self, String> {
        Range::parse(words.word("LOWER..UPPER")?)
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.lower, self.upper)
    }
}

impl Spoken for Range {
    fn is_negative(&self) -> bool {
        self.lower == self.upper && self.lower.digits < 0
    }

    /// A number, or [lower, upper].
    fn magnitude(&self, _: &str) -> String {
        if self.lower == self.upper {
            return Decimal { digits: self.lower.digits.abs(), ..self.lower }.to_string();
        }
        format!("[{}, {}]", self.lower, self.upper)
    }
}
