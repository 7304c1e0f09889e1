//! Numbers: exact fractions and their text form.
//!
//! Everything a user types is an exact rational; nothing here rounds.

mod parse;

pub use parse::{LIMIT_BITS, parse_integer, parse_rational};
