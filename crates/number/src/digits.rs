//! Decimal digits of an enclosed number: only those that are certain.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero, pow};

use super::Ball;

/// Numbers beyond 2^±this are not written out before they become digits.
const WRITTEN: u64 = 100_000;

/// log₁₀ 2 · 2⁶⁴, to nearest.
const LOG10_2: i128 = 5_553_023_288_523_357_132;

/// The number between `lo` and `hi`, in either order, in decimal: the printed text is off by less than one
/// unit of its last digit.
///
/// At most `most` significant digits, and of an exact number no trailing zeros; `None` if not even one is
/// certain. Cost: a few products of integers of the size of `lo` and `hi`.
///
/// ```
/// use grazing_number::{certain_digits, parse_rational};
/// let x = parse_rational("1/7")?;
/// let error = parse_rational("1e-9")?;
/// assert_eq!(certain_digits(&(&x - &error), &(&x + &error), 40).unwrap(), "0.14285714");
/// assert_eq!(certain_digits(&x, &x, 5).unwrap(), "0.14286");
/// assert_eq!(certain_digits(&(&x + &error), &(&x - &error), 40).unwrap(), "0.14285714");
/// assert_eq!(certain_digits(&-&error, &error, 40), None);
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub fn certain_digits(lo: &BigRational, hi: &BigRational, most: u32) -> Option<String> {
    digits_times(lo, hi, 0, most)
}

/// The number that a ball encloses in decimal, as [`certain_digits`] writes it, for a ball of any exponent:
/// m·10^e beyond 2^±100000. `None` if not even one digit is certain.
///
/// Cost: for b bits a few products of integers of b bits, and for numbers m·2^e beyond 2^±100000 O(log |e|)
/// products more.
///
/// ```
/// use grazing_number::{Ball, Precision, Real, ball_digits, parse_rational};
/// let context = Precision::new(64);
/// let mut x = Ball::ratio(&parse_rational("2^-16384")?, &context);
/// for _ in 0..11 {
///     x = x.clone() * &x;
/// }
/// assert_eq!(ball_digits(&x, 12).unwrap(), "3.02365786578e-10100891");
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub fn ball_digits(ball: &Ball, most: u32) -> Option<String> {
    let exponent = ball.exponent().filter(|exponent| exponent.unsigned_abs() > WRITTEN);
    let Some(exponent) = exponent else {
        let (lo, hi) = ball.exact_bounds()?;
        return certain_digits(&lo, &hi, most);
    };
    // Right within one: |exponent| < 2⁶³ times an error of half a unit.
    let tens = (i128::from(exponent) * LOG10_2) >> 64;
    let tens = i64::try_from(tens).ok()?;
    // Each of at most 63 squarings doubles the relative error: 96 bits more than the ball's are enough.
    let power = ball.ten_to(tens.unsigned_abs(), 96);
    let scaled = if tens < 0 { ball.clone() * &power } else { ball.clone() / &power };
    let (lo, hi) = scaled.exact_bounds()?;
    digits_times(&lo, &hi, tens, most)
}

/// [`certain_digits`] of a number times 10^tens.
fn digits_times(lo: &BigRational, hi: &BigRational, tens: i64, most: u32) -> Option<String> {
    let half = BigRational::new(1.into(), 2.into());
    let (middle, radius) = ((lo + hi) * &half, (hi - lo).abs() * &half);
    if middle.is_zero() {
        return radius.is_zero().then(|| "0".to_string());
    }
    let magnitude = middle.abs();
    let exponent = decimal_exponent(&magnitude);
    // Half a unit for the radius and half for rounding.
    let mut places = i64::from(most.max(1)) - 1 - exponent;
    if !radius.is_zero() {
        places = places.min(-decimal_exponent(&(&radius * BigInt::from(2))) - 1);
    }
    if places < -exponent {
        return None;
    }
    let scaled = (&magnitude * ten_to(places) + &half).floor().to_integer();
    let (mut digits, mut exponent) = (scaled.to_string(), exponent);
    // 9.99… may round up to one digit more.
    if digits.len() as i64 > exponent + places + 1 {
        exponent += 1;
        digits.pop();
    }
    if radius.is_zero() {
        digits.truncate(digits.trim_end_matches('0').len().max(1));
    }
    let sign = if middle.is_negative() { "-" } else { "" };
    Some(format!("{sign}{}", layout(&digits, exponent + tens)))
}

/// d.ddd·10^exponent as plain text where that is short, else with an exponent.
fn layout(digits: &str, exponent: i64) -> String {
    let length = digits.len() as i64;
    match exponent {
        -5..0 => format!("0.{}{digits}", "0".repeat((-exponent - 1) as usize)),
        0.. if exponent < length - 1 => {
            let (whole, fraction) = digits.split_at(exponent as usize + 1);
            format!("{whole}.{fraction}")
        }
        _ if exponent == length - 1 => digits.to_string(),
        _ if length == 1 => format!("{digits}e{exponent}"),
        _ => format!("{}.{}e{exponent}", &digits[..1], &digits[1..]),
    }
}

/// ⌊log₁₀ x⌋ for x > 0.
fn decimal_exponent(x: &BigRational) -> i64 {
    // Right within one from the lengths in bits, then corrected exactly.
    let bits = x.numer().bits() as i64 - x.denom().bits() as i64;
    let mut exponent = (bits as i128 * 30103 / 100_000).to_i64().unwrap_or(0) - 1;
    while ten_to(exponent + 1) <= *x {
        exponent += 1;
    }
    while ten_to(exponent) > *x {
        exponent -= 1;
    }
    exponent
}

fn ten_to(exponent: i64) -> BigRational {
    let power = pow(BigInt::from(10), exponent.unsigned_abs() as usize);
    if exponent >= 0 { BigRational::from_integer(power) } else { BigRational::new(BigInt::one(), power) }
}
