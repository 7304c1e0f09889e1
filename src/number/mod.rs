//! Numbers: exact fractions, enclosures at every precision, three-valued signs.
//!
//! Everything a user types is an exact rational ([`parse_rational`]). The rungs on which a formula can be
//! evaluated share the trait [`Real`], with sines of rational multiples of π [`Circular`], with functions of
//! enclosed numbers [`Elementary`]:
//!
//! | rung | type | promises |
//! | --- | --- | --- |
//! | plain | [`Plain`] | nothing; there to be compared with |
//! | interval | [`FloatInterval`] | the true value lies between two `f64` |
//! | ball | [`Ball`] | the true value lies in a ball of any number of bits |
//! | exact | `BigRational` | the true value, without sines |
//!
//! Of the interval and the ball: every operation's result contains the true result for every choice of
//! enclosed arguments, and its width is at most 8 times that of the correctly rounded enclosure of the exact
//! result for point arguments (tests/theory/enclosures.rs). That width is not promised where a result lies
//! outside the range of its rung: an interval of a number below 2⁻¹⁰²² may end at 0 and at 2⁻¹⁰²², one above
//! 2¹⁰²⁴ at ∞; a ball outside 2^±2⁶² is the whole line, or zero with a radius. It is an enclosure there too.
//! Trusted: Rust, IEEE 754 `f64` addition and multiplication to nearest, num-bigint. Not here: the formulas
//! (`local`).
//!
//! ```
//! use grazing::number::{Ball, FloatInterval, Precision, Real, Sign, parse_rational};
//! // No float tells 3/8 + 2^-200 from 3/8; a ball of 256 bits does.
//! let (x, y) = (parse_rational("3/8+2^-200")?, parse_rational("0.375")?);
//! let close = FloatInterval::ratio(&x, &()) - &FloatInterval::ratio(&y, &());
//! assert!(close.contains(&(&x - &y)));
//! assert_eq!(close.sign(), None);
//! let bits = Precision::new(256);
//! let apart = Ball::ratio(&x, &bits) - &Ball::ratio(&y, &bits);
//! assert_eq!(apart.sign(), Some(Sign::Positive));
//! # Ok::<(), grazing::Error>(())
//! ```

mod angle;
mod approximation;
mod ball;
mod ball_forms;
mod ball_sine;
mod digits;
mod dual;
#[cfg(test)]
mod edges;
mod elementary;
mod exponent;
mod fixed;
mod float_interval;
mod float_sine;
mod formula;
mod fraction;
mod parse;
mod plain;
mod radius;
mod real;
mod short_sine;
mod sign;
mod text;

pub use angle::Angle;
pub use ball::{Ball, Precision};
pub use digits::{ball_digits, certain_digits};
pub use dual::Dual;
pub use elementary::Elementary;
pub use float_interval::FloatInterval;
pub use formula::Function;
pub(crate) use formula::{Formula, Operation};
pub(crate) use fraction::Fraction;
pub use parse::{LIMIT_BITS, parse_integer, parse_rational, parse_rational_within};
pub use plain::Plain;
pub use real::{Circular, Real};
pub use sign::Sign;
pub(crate) use text::serialize_fraction;
