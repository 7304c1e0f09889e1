//! Numbers: exact fractions, enclosures at every precision, three-valued signs.
//!
//! Everything a user types is an exact rational ([`parse_rational`]). The rungs on which a formula can be
//! evaluated share the trait [`Real`], with sines of rational multiples of π [`Circular`], with functions of
//! enclosed numbers [`Elementary`] and [`Transcendental`]:
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
//! result for point arguments (tests/enclosures.rs). That width is not promised where a result lies outside
//! the range of its rung: an interval of a number below 2⁻¹⁰⁷⁴ ends at 0 and at 2⁻¹⁰⁷⁴, one above 2¹⁰²⁴ at
//! ∞; a ball outside 2^±2⁶² is the whole line, or zero with a radius. It is an enclosure there too. Trusted:
//! Rust, IEEE 754 `f64` addition and multiplication to nearest, num-bigint.
//!
//! Enclosures are also sets, with [`hull`](Ball::hull), [`intersection`](Ball::intersection),
//! [`abs`](Ball::abs), [`min`](Ball::min) and [`max`](Ball::max). Text of them is read by this crate and by
//! others: `Display` and [`exact_text`](Ball::exact_text) write what Arb and Coq read, [`Ball::read`] and
//! `FromStr` read it back, and [`Ball::arb_text`] has an example with python-flint:
//!
//! ```text
//! from flint import arb
//! x = eval("arb((221069929750888, -46), (2147483649, -77))")
//! assert x.contains(arb.pi())
//! ```
//!
//! and `exact_text` one with CoqInterval:
//!
//! ```text
//! From Coq Require Import Reals.
//! From Interval Require Import Tactic.
//! Open Scope R_scope.
//! Goal 884279719003555/2^48 <= PI <= 7074237752028441/2^51.
//! Proof. split; interval with (i_prec 80). Qed.
//! ```
//!
//! There is no order on enclosures and no conversion from `f64`: what branches asks for a [`Sign`], and what
//! an enclosure cannot tell is `None`. Text of others is read in bounded time and memory: a
//! [`BoundedFraction`] stops growing at a limit.
//!
//! A formula is written once, and climbs until its sign is told:
//!
//! ```
//! use grazing_number::{Angle, Ball, Circular, FloatInterval, Precision, Real, Sign, parse_rational};
//! use grazing_number::num_rational::BigRational;
//!
//! /// cos πx − ½.
//! fn formula<T: Circular>(x: &BigRational, context: &T::Context) -> T {
//!     let half = BigRational::new(1.into(), 2.into());
//!     T::cos(&Angle::new(x), context) - &T::ratio(&half, context)
//! }
//!
//! let x = parse_rational("1/3 - 2^-100")?;
//! assert_eq!(formula::<FloatInterval>(&x, &()).sign(), None);
//! assert_eq!(formula::<Ball>(&x, &Precision::new(128)).sign(), Some(Sign::Positive));
//! # Ok::<(), grazing_number::ParseError>(())
//! ```
//!
//! With the feature `serde` a [`Sign`] is serialized as `-`, `0` or `+`.

mod angle;
mod approximation;
mod ball;
mod ball_forms;
mod ball_sine;
mod digits;
#[cfg(test)]
mod edges;
mod elementary;
mod error;
mod exchange;
mod exponent;
mod fixed;
mod float_elementary;
mod float_interval;
mod float_sine;
mod fraction;
mod inverse;
mod operators;
mod parse;
mod plain;
mod radius;
#[cfg(test)]
mod random;
mod real;
mod sets;
mod short_sine;
mod sign;
mod transcendental;

pub use angle::Angle;
pub use ball::{Ball, Precision};
pub use digits::{ball_digits, certain_digits};
pub use elementary::Elementary;
pub use error::ParseError;
pub use float_interval::FloatInterval;
pub use fraction::BoundedFraction;
/// The package of the exact fractions in this interface.
pub use num_rational;
pub use parse::{LIMIT_BITS, parse_integer, parse_rational, parse_rational_within};
pub use plain::Plain;
pub use real::{Circular, Real};
pub use sign::Sign;
pub use transcendental::Transcendental;

/// The example of the README is compiled and run, too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
