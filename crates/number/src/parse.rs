//! The grammar of numbers: text to an exact rational.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero, pow};

use crate::{BoundedFraction, error::ParseError};

type Result<T> = std::result::Result<T, ParseError>;

/// The most bits of a number's numerator and of its denominator, unless the caller says otherwise.
pub const LIMIT_BITS: u32 = 1 << 15;

/// Reads an exact rational: a sum or difference of terms `12`, `3/8`, `0.375`, `1e-30`, `2^-200`. Cost: that
/// of a product of numbers of the result's bits, at most [`LIMIT_BITS`], for each term.
///
/// ```text
/// number  = [sign] term { sign term }          sign = "+" | "-"
/// term    = power [ "/" power ]
/// power   = decimal [ "^" [sign] digits ]
/// decimal = digits [ "." [digits] ] [ ("e" | "E") [sign] digits ] | "." digits [ … ]
/// ```
///
/// Spaces may stand around signs. Every value is exact: `0.1` is 1/10. At most [`LIMIT_BITS`] bits: see
/// [`parse_rational_within`].
///
/// # Errors
/// A [`ParseError`] that quotes the text and says what was expected where.
///
/// ```
/// use grazing_number::parse_rational;
/// assert_eq!(parse_rational("3/8 - 2^-3")?, parse_rational("0.25")?);
/// assert_eq!(parse_rational("1e-2")?.to_string(), "1/100");
/// assert!(parse_rational("1/0").is_err());
/// assert!(parse_rational("1/3^500000").is_err());
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub fn parse_rational(text: &str) -> Result<BigRational> {
    parse_rational_within(text, LIMIT_BITS)
}

/// [`parse_rational`] with a limit of the caller's: numerator and denominator have at most `bits` bits.
///
/// That holds at every step on the way, where a fraction is not in lowest terms: of the powers in a term, and
/// of partial sums over a common denominator (the larger one where it is a multiple of the other, else the
/// product). What would exceed it is refused before it is computed. Cost: at most one product or quotient of
/// `bits` bits for each term, and one search for common factors, O(bits²), at the end.
///
/// # Errors
/// As [`parse_rational`].
///
/// ```
/// use grazing_number::parse_rational_within;
/// assert!(parse_rational_within("2^99", 100).is_ok() && parse_rational_within("2^100", 100).is_err());
/// ```
pub fn parse_rational_within(text: &str, bits: u32) -> Result<BigRational> {
    read(Reader { text, rest: text.trim(), bits, whole: false })
}

fn read(mut reader: Reader<'_>) -> Result<BigRational> {
    let mut total = reader.signed_term(true)?;
    while !reader.rest.is_empty() {
        let term = reader.signed_term(false)?;
        total = reader.fitting(total + &term)?;
    }
    match total.reduced() {
        Some(value) => Ok(value),
        None => reader.too_large(),
    }
}

/// Reads a whole number in the same grammar, as in `10000`, `1e4` or `2^100`, into any integer type.
///
/// # Errors
/// As [`parse_rational`]; also if the value is not whole or does not fit the type.
///
/// ```
/// use grazing_number::parse_integer;
/// assert_eq!(parse_integer::<u64>("2^64 - 1")?, u64::MAX);
/// assert!(parse_integer::<u64>("1/2").is_err() && parse_integer::<u8>("256").is_err());
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub fn parse_integer<T: TryFrom<BigInt>>(text: &str) -> Result<T> {
    let reader = Reader { text, rest: text.trim(), bits: LIMIT_BITS, whole: true };
    let value = read(reader)?;
    if !value.is_integer() {
        return Err(ParseError::new(format!("{:?} is not a whole number", abbreviate(text))));
    }
    let negative = value < BigRational::zero();
    T::try_from(value.to_integer()).map_err(|_| {
        let why = if negative { "negative: it must be a count" } else { "too large here" };
        ParseError::new(format!("{:?} is {why}", abbreviate(text)))
    })
}

struct Reader<'a> {
    text: &'a str,
    rest: &'a str,
    bits: u32,
    /// Whether a whole number is asked for, so that no error suggests another.
    whole: bool,
}

impl<'a> Reader<'a> {
    fn fail<T>(&self, expected: &str) -> Result<T> {
        let found = match self.rest.chars().next() {
            None => "the end".to_string(),
            Some(c) => format!("{c:?}"),
        };
        let (what, forms) = match self.whole {
            true => ("whole number", "12, 1e6 or 2^20"),
            false => ("number", "3/8, 0.375, 1e-30, 2^-10 or a sum of such terms"),
        };
        Err(ParseError::new(format!(
            "{:?} is not a {what}: expected {expected}, found {found} (write {forms})",
            abbreviate(self.text)
        )))
    }

    fn too_large<T>(&self) -> Result<T> {
        Err(ParseError::new(format!(
            "{:?} is too large or too fine: at most {} bits are allowed in numerator and denominator",
            abbreviate(self.text),
            self.bits
        )))
    }

    /// Takes `c` if it comes next.
    fn take(&mut self, c: char) -> bool {
        match self.rest.strip_prefix(c) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Takes a sign if one comes next: true for minus.
    fn sign(&mut self) -> Option<bool> {
        if self.take('-') {
            Some(true)
        } else if self.take('+') {
            Some(false)
        } else {
            None
        }
    }

    fn fitting(&self, value: BoundedFraction) -> Result<BoundedFraction> {
        if value.is_too_large() { self.too_large() } else { Ok(value) }
    }

    fn divides_by_zero<T>(&self) -> Result<T> {
        Err(ParseError::new(format!("{:?} divides by zero", abbreviate(self.text))))
    }

    fn signed_term(&mut self, first: bool) -> Result<BoundedFraction> {
        self.rest = self.rest.trim_start();
        let negative = match self.sign() {
            Some(negative) => negative,
            None if first => false,
            None => return self.fail("`+` or `-`"),
        };
        self.rest = self.rest.trim_start();
        let term = self.term()?;
        self.rest = self.rest.trim_start();
        Ok(if negative { -term } else { term })
    }

    fn term(&mut self) -> Result<BoundedFraction> {
        let numerator = self.power()?;
        if !self.take('/') {
            return Ok(numerator);
        }
        let denominator = self.power()?;
        if denominator.is_zero() {
            return self.divides_by_zero();
        }
        self.fitting(numerator / &denominator)
    }

    fn power(&mut self) -> Result<BoundedFraction> {
        let base = self.decimal()?;
        if !self.take('^') {
            return Ok(base);
        }
        let exponent = self.exponent()?;
        if base.is_zero() && exponent < 0 {
            return self.divides_by_zero();
        }
        let raised = self.fitting(base.power(exponent.unsigned_abs()))?;
        Ok(if exponent < 0 { raised.reciprocal() } else { raised })
    }

    /// A signed exponent; one beyond `i64` is beyond the size limit too, whatever the base but 0 and ±1.
    fn exponent(&mut self) -> Result<i64> {
        let negative = self.sign().unwrap_or(false);
        let digits = self.digits();
        if digits.is_empty() {
            return self.fail("the digits of an exponent");
        }
        match digits.parse::<i64>() {
            Ok(value) => Ok(if negative { -value } else { value }),
            Err(_) => self.too_large(),
        }
    }

    fn digits(&mut self) -> &'a str {
        let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        self.rest = rest;
        digits
    }

    fn decimal(&mut self) -> Result<BoundedFraction> {
        let whole = self.digits();
        let fraction = if self.take('.') { self.digits() } else { "" };
        if whole.is_empty() && fraction.is_empty() {
            return self.fail("a digit");
        }
        let exponent = if self.take('e') || self.take('E') { self.exponent()? } else { 0 };
        // Each digit but leading zeros takes more than 3.32 bits, each of the fraction in the denominator.
        let limit = u64::from(self.bits);
        let all = format!("{whole}{fraction}");
        let all = all.trim_start_matches('0');
        if all.is_empty() {
            return Ok(BoundedFraction::new(BigInt::ZERO, BigInt::one(), limit));
        }
        let too_many = |digits: u64| digits.saturating_mul(33) / 10 > limit + 4;
        let exponent = exponent.saturating_sub(fraction.len() as i64);
        if too_many(all.len() as u64) || too_many(exponent.unsigned_abs()) {
            return self.too_large();
        }
        let value: BigInt = match all.parse() {
            Ok(value) => value,
            Err(_) => return self.fail("a digit"),
        };
        let scale = pow(BigInt::from(10), exponent.unsigned_abs() as usize);
        let (numerator, denominator) =
            if exponent < 0 { (value, scale) } else { (value * scale, BigInt::one()) };
        self.fitting(BoundedFraction::new(numerator, denominator, limit))
    }
}

/// A text short enough for an error line.
pub(super) fn abbreviate(text: &str) -> String {
    let text = text.trim();
    if text.chars().count() <= 60 {
        return text.to_string();
    }
    let head: String = text.chars().take(57).collect();
    format!("{head}…")
}
