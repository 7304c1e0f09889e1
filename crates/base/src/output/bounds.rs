//! Exact fractions as decimals that bound them.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, pow};

/// The greatest decimal with `digits` places that is not above x. Cost: one division of `digits` digits.
///
/// −2/3 with 3 places is −0.667 below and −0.666 above.
pub fn decimal_below(x: &BigRational, digits: u32) -> String {
    place_point((x * pow(BigInt::from(10), digits as usize)).floor().to_integer(), digits)
}

/// The least decimal with `digits` places that is not below x.
pub fn decimal_above(x: &BigRational, digits: u32) -> String {
    place_point((x * pow(BigInt::from(10), digits as usize)).ceil().to_integer(), digits)
}

/// The number itself: as a decimal, if it is one of at most 40 places, else as a fraction.
pub fn decimal_or_fraction(x: &BigRational) -> String {
    let is_whole = |places: &u32| (x * pow(BigInt::from(10), *places as usize)).is_integer();
    (0..=40).find(is_whole).map_or_else(|| x.to_string(), |places| decimal_below(x, places))
}

/// The nearest decimal with `digits` places, halves away from zero: a rounded value, not a bound.
pub fn decimal_near(x: &BigRational, digits: u32) -> String {
    place_point((x * pow(BigInt::from(10), digits as usize)).round().to_integer(), digits)
}

/// units·10^−digits, written out.
fn place_point(units: BigInt, digits: u32) -> String {
    let sign = if units.is_negative() { "-" } else { "" };
    let digits = digits as usize;
    let text = format!("{:0>1$}", units.magnitude().to_string(), digits + 1);
    let (whole, rest) = text.split_at(text.len() - digits);
    if digits == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{rest}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_of_two_thirds() {
        let x = BigRational::new((-2).into(), 3.into());
        assert_eq!([decimal_below(&x, 3), decimal_above(&x, 3)], ["-0.667", "-0.666"]);
        let exact = |p: i64, q: i64| decimal_or_fraction(&BigRational::new(p.into(), q.into()));
        assert_eq!([exact(-2, 3), exact(-3, 8), exact(5, 1), exact(0, 1)], ["-2/3", "-0.375", "5", "0"]);
    }
}
