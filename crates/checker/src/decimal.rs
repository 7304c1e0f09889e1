//! Numbers of certificates about motions: fractions and decimals, each of which is written in one way only.

use std::fmt;

use super::{interval::Fixed, lines::Words};

/// The most digits of a numerator, a denominator or a decimal, of whatever kind: below 2¹¹³.
pub(crate) const DIGITS: usize = 34;

/// A fraction p/q in lowest terms, q > 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    /// The numerator.
    pub p: i128,
    /// The denominator.
    pub q: i128,
}

/// `digits` / 10^`places`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decimal {
    /// All digits, as an integer.
    pub digits: i128,
    /// How many of them stand after the point.
    pub places: u32,
}

impl Fraction {
    pub(crate) const ZERO: Fraction = Fraction { p: 0, q: 1 };

    pub(crate) fn enclosed<const POINT: u32>(self) -> Fixed<POINT> {
        Fixed::ratio(self.p, self.q)
    }

    /// Reads a fraction of at most `most` digits above and below, which the intervals can hold.
    pub(crate) fn read<const POINT: u32>(words: &mut Words, most: usize) -> Result<Fraction, String> {
        let read = |word: &str| {
            let (p, q) = word.split_once('/')?;
            let (p, q) = (integer(p, most)?, integer(q, most)?);
            (q > 0 && gcd(p.unsigned_abs(), q.unsigned_abs()) == 1).then_some(Fraction { p, q })
        };
        read(words.word("a fraction p/q")?).filter(|x| x.enclosed::<POINT>().is_known()).ok_or_else(|| {
            let room = Fixed::<POINT>::ROOM;
            format!(
                "expected a fraction p/q in lowest terms, of at most {most} digits each, between -2^{room} and 2^{room}"
            )
        })
    }
}

impl Decimal {
    pub(crate) fn enclosed<const POINT: u32>(self) -> Fixed<POINT> {
        Fixed::ratio(self.digits, 10i128.pow(self.places))
    }

    /// The whole part and the rest in units of 10⁻³⁴, both of the number's sign: they are in order as the
    /// numbers are.
    pub(crate) fn parts(self) -> (i128, i128) {
        let scale = 10i128.pow(self.places);
        (self.digits / scale, self.digits % scale * 10i128.pow(DIGITS as u32 - self.places))
    }

    /// `-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?` but not `-0`, of at most `most` digits.
    pub(crate) fn canonical(word: &str, most: usize) -> Option<Decimal> {
        let are_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let magnitude = word.strip_prefix('-').unwrap_or(word);
        let (whole, places) = match magnitude.split_once('.') {
            None => (magnitude, ""),
            Some((_, places)) if !are_digits(places) || places.ends_with('0') => return None,
            Some(parts) => parts,
        };
        let canonical = are_digits(whole) && (whole == "0" || !whole.starts_with('0')) && word != "-0";
        if !canonical || whole.len() + places.len() > most {
            return None;
        }
        let digits: i128 = format!("{whole}{places}").parse().ok()?;
        let digits = if word.starts_with('-') { -digits } else { digits };
        Some(Decimal { digits, places: places.len() as u32 })
    }

    /// Reads a decimal of at most `most` digits, which the intervals can hold.
    pub(crate) fn read<const POINT: u32>(words: &mut Words, most: usize) -> Result<Decimal, String> {
        let canonical = Decimal::canonical(words.word("a decimal")?, most);
        canonical.filter(|x| x.enclosed::<POINT>().is_known()).ok_or_else(|| {
            let room = Fixed::<POINT>::ROOM;
            format!(
                "expected a decimal of at most {most} digits between -2^{room} and 2^{room}, without +, -0 or needless zeros"
            )
        })
    }
}

/// A decimal without a point, of at most `most` digits.
pub(crate) fn integer(word: &str, most: usize) -> Option<i128> {
    Decimal::canonical(word, most).filter(|number| number.places == 0).map(|number| number.digits)
}

/// The greatest common divisor; that of 0 and b is b.
pub(crate) fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.p, self.q)
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.digits < 0 { "-" } else { "" };
        let scale = 10u128.pow(self.places);
        let magnitude = self.digits.unsigned_abs();
        write!(f, "{sign}{}", magnitude / scale)?;
        if self.places > 0 { write!(f, ".{:01$}", magnitude % scale, self.places as usize) } else { Ok(()) }
    }
}
