//! Enclosures as text, and back: digits to look at, and exact ends for other programs.
//!
//! | text | written by | read by |
//! | --- | --- | --- |
//! | `[3.1415926 +/- 1e-7]` | `Display` | [`FloatInterval`]'s `FromStr`, [`Ball::read`], Arb: `arb("[3.1415926 +/- 1e-7]")` |
//! | `[25/2^3, 13/2^2]`, exact | `exact_text` | the same two; each end also [`parse_rational`], Coq in `R_scope` |
//! | `arb((25, -3), (1, -60))`, exact | [`Ball::arb_text`], python-flint's `repr` | [`Ball::read`], python-flint: `eval` |
//!
//! The head of the crate has an example of each for python-flint and CoqInterval.

use std::{fmt, str::FromStr};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Num, Zero};

use super::{
    Ball, FloatInterval, ParseError, Precision, Real, ball_digits, certain_digits, parse_rational,
    radius::Radius,
};

/// The digits of an enclosure, off by less than a unit of the last: with that unit, or alone if they are
/// exact.
fn write(
    f: &mut fmt::Formatter<'_>,
    digits: Option<String>,
    ends: Option<(BigRational, BigRational)>,
) -> fmt::Result {
    let Some(digits) = digits else {
        let Some((lo, hi)) = ends else { return f.write_str("[+/- inf]") };
        // A power of 10 from the number of decimals in the greatest magnitude.
        let size = if -&lo > hi { -lo } else { hi };
        let bits = size.numer().bits() as i64 - size.denom().bits() as i64 + 1;
        return write!(f, "[+/- 1e{}]", (bits * 30_103).div_euclid(100_000) + 1);
    };
    let exact =
        ends.is_some_and(|(lo, hi)| lo == hi && parse_rational(&digits).is_ok_and(|value| value == lo));
    if exact {
        return f.write_str(&digits);
    }
    let (plain, exponent) = digits.split_once('e').unwrap_or((&digits, "0"));
    let decimals = plain.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i64);
    let unit = exponent.parse::<i64>().unwrap_or(0) - decimals;
    write!(f, "[{digits} +/- 1e{unit}]")
}

/// Certain digits, 17 at most or as the format's precision says, and a bound of what they are off by; `[+/-
/// 1e5]` if there are none, `[+/- inf]` if nothing is known on one side.
///
/// ```
/// use grazing_number::{FloatInterval, Real, parse_rational};
/// let third = FloatInterval::ratio(&parse_rational("1/3")?, &());
/// assert_eq!(format!("{third:.5}, {third}"), "[0.33333 +/- 1e-5], [0.3333333333333333 +/- 1e-16]");
/// assert_eq!(FloatInterval::from_bounds(0.375, 0.375).to_string(), "0.375");
/// assert_eq!(FloatInterval::from_bounds(-3.0, 2.0).to_string(), "[+/- 1e1]");
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
impl fmt::Display for FloatInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most = f.precision().map_or(17, |most| most as u32);
        let ends = self.exact_bounds();
        write(f, ends.as_ref().and_then(|(lo, hi)| certain_digits(lo, hi, most)), ends)
    }
}

/// As that of a [`FloatInterval`], with as many digits as the ball's bits can show at most.
///
/// ```
/// use grazing_number::{Ball, Elementary, Precision};
/// let pi = Ball::pi(&Precision::new(64));
/// assert_eq!(format!("{pi:.8}, {pi}"), "[3.1415927 +/- 1e-7], [3.141592653589793238 +/- 1e-18]");
/// ```
impl fmt::Display for Ball {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most = f.precision().map_or(self.bits() / 3 + 1, |most| most as u32);
        write(f, ball_digits(self, most), self.exact_bounds())
    }
}

/// A fraction whose denominator is a power of 2, as p or p/2^k.
fn dyadic(x: &BigRational) -> String {
    match x.denom().bits() - 1 {
        0 => x.numer().to_string(),
        k => format!("{}/2^{k}", x.numer()),
    }
}

impl FloatInterval {
    /// Both ends exactly, `[p/2^j, q/2^k]`; −∞ and ∞ are `-inf` and `inf`. [`FromStr`] reads it back.
    ///
    /// ```
    /// use grazing_number::FloatInterval;
    /// let x = FloatInterval::from_bounds(-0.1, f64::INFINITY);
    /// assert_eq!(x.exact_text(), "[-3602879701896397/2^55, inf]");
    /// assert_eq!(x.exact_text().parse::<FloatInterval>()?, x);
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn exact_text(self) -> String {
        let end = |x: f64| BigRational::from_float(x).map_or_else(|| x.to_string(), |x| dyadic(&x));
        format!("[{}, {}]", end(self.lo()), end(self.hi()))
    }
}

impl Ball {
    /// Both ends exactly, `[p/2^j, q/2^k]`, as far as [`exact_bounds`](Ball::exact_bounds) tells them; `None`
    /// where that has none. [`Ball::read`] reads it back.
    ///
    /// ```
    /// use grazing_number::{Ball, Precision, parse_rational};
    /// let bits = Precision::new(64);
    /// let x = Ball::between(&parse_rational("25/8")?, &parse_rational("13/4")?, &bits);
    /// assert_eq!(x.exact_text().unwrap(), "[25/2^3, 13/2^2]");
    /// assert_eq!(Ball::read("[25/2^3, 13/2^2]", &bits)?.exact_bounds(), x.exact_bounds());
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn exact_text(&self) -> Option<String> {
        let (lo, hi) = self.exact_bounds()?;
        Some(format!("[{}, {}]", dyadic(&lo), dyadic(&hi)))
    }

    /// Midpoint and radius exactly, `arb((m, e), (r, f))` for m·2^e ± r·2^f, as python-flint's constructor
    /// takes them, which rounds a radius of more than 30 bits up; `None` if nothing is known. [`Ball::read`]
    /// reads it back, and python-flint's own `repr`.
    ///
    /// ```
    /// use grazing_number::{Ball, Elementary, Precision};
    /// let bits = Precision::new(48);
    /// let text = Ball::pi(&bits).arb_text().unwrap();
    /// assert_eq!(text, "arb((221069929750888, -46), (2147483649, -77))");
    /// assert_eq!(Ball::read(&text, &bits)?.arb_text().unwrap(), text);
    /// assert_eq!(Ball::read("arb((0x5, -0x3), (0x0, 0x0))", &bits)?.to_string(), "0.625");
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn arb_text(&self) -> Option<String> {
        let (r, f) = self.radius().parts();
        let known = !self.radius().is_infinite();
        known.then(|| format!("arb(({}, {}), ({r}, {f}))", self.mid(), self.unit_exponent()))
    }

    /// Reads an enclosure: a number as of [`parse_rational`], `[MIDDLE +/- RADIUS]`, `[LOW, HIGH]`, or
    /// `arb((m, e), (r, f))`; examples are at [`exact_text`](Ball::exact_text) and
    /// [`arb_text`](Ball::arb_text). What has more bits than the context is enclosed. Of the first three,
    /// numbers have at most [`LIMIT_BITS`](super::LIMIT_BITS) bits, and `inf` as an end or radius is the
    /// whole line.
    ///
    /// # Errors
    /// A [`ParseError`] that quotes what is not a number, or ends that are in the wrong order.
    pub fn read(text: &str, context: &Precision) -> Result<Ball, ParseError> {
        if let Some(parts) = text.trim().strip_prefix("arb(") {
            return read_arb(text, parts, context);
        }
        Ok(match ends(text)? {
            [Some(lo), Some(hi)] => Ball::between(&lo, &hi, context),
            _ => Ball::whole(context.bits()),
        })
    }
}

/// Reads a number, `[MIDDLE +/- RADIUS]` or `[LOW, HIGH]`, rounded outwards. As [`Ball::read`].
impl FromStr for FloatInterval {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<FloatInterval, ParseError> {
        let [lo, hi] = ends(text)?.map(|end| end.map(|end| FloatInterval::ratio(&end, &())));
        let (lo, hi) = (lo.map_or(f64::NEG_INFINITY, |lo| lo.lo()), hi.map_or(f64::INFINITY, |hi| hi.hi()));
        Ok(FloatInterval::from_bounds(lo, hi))
    }
}

/// The ends of what the text encloses; `None` for an infinite one.
fn ends(text: &str) -> Result<[Option<BigRational>; 2], ParseError> {
    let finite = |text: &str, infinite: &[&str]| match text.trim() {
        text if infinite.contains(&text) => Ok(None),
        text => parse_rational(text).map(Some),
    };
    let Some(inside) = text.trim().strip_prefix('[').and_then(|text| text.strip_suffix(']')) else {
        let value = finite(text, &[])?;
        return Ok([value.clone(), value]);
    };
    if let Some((middle, radius)) = inside.split_once("+/-") {
        let middle = if middle.trim().is_empty() { BigRational::zero() } else { parse_rational(middle)? };
        let Some(radius) = finite(radius, &["inf"])? else { return Ok([None, None]) };
        return ordered(text, [Some(&middle - &radius), Some(middle + radius)]);
    }
    let (low, high) =
        inside.split_once(',').ok_or_else(|| wrong(text, "has neither `,` nor `+/-` in its brackets"))?;
    ordered(text, [finite(low, &["-inf"])?, finite(high, &["inf", "+inf"])?])
}

fn ordered(text: &str, ends: [Option<BigRational>; 2]) -> Result<[Option<BigRational>; 2], ParseError> {
    match &ends {
        [Some(lo), Some(hi)] if lo > hi => Err(wrong(text, "ends below where it begins")),
        _ => Ok(ends),
    }
}

fn wrong(text: &str, what: &str) -> ParseError {
    ParseError::new(format!("{:?} {what}", super::parse::abbreviate(text)))
}

/// `(m, e), (r, f))`, whole numbers, in base 16 after `0x`. Without the second pair the radius is 0;
/// python-flint writes the midpoint 0 as `0.0`, and an infinite radius as `'+inf'`.
fn read_arb(text: &str, parts: &str, context: &Precision) -> Result<Ball, ParseError> {
    let number = |word: &str| {
        let word = word.trim().trim_matches(['(', ')']);
        let (sign, digits) = word.strip_prefix('-').map_or((1, word), |rest| (-1, rest));
        let (base, digits) = digits.strip_prefix("0x").map_or((10, digits), |rest| (16, rest));
        let plain = digits.chars().all(|c| c.is_digit(base));
        plain.then(|| BigInt::from_str_radix(digits, base).ok())?.map(|value| value * sign)
    };
    let exponent = |e: &BigInt| i64::try_from(e).ok().map(i128::from);
    let read = || {
        let parts = parts.trim().strip_suffix(')')?.replace("0.0", "0, 0");
        if parts.ends_with("'+inf'") {
            return Some(Ball::whole(context.bits()));
        }
        let numbers = parts.split(',').map(number).collect::<Option<Vec<BigInt>>>()?;
        let (m, e, radius) = match &numbers[..] {
            [m, e] => (m, e, Radius::ZERO),
            [m, e, r, f] if r.sign() != num_bigint::Sign::Minus => (m, e, Radius::of(r, exponent(f)?)),
            _ => return None,
        };
        Some(Ball::new(m.clone(), exponent(e)?, radius, context.bits()))
    };
    read().ok_or_else(|| wrong(text, "is not `arb((m, e), (r, f))` of whole numbers, e and f below 2^63"))
}
