//! What certificates about linear impact oscillators share. The kinds are elsewhere: `orbit`, `event`;
//! `machine` takes numbers, lines and patterns from here.
//!
//! The checker works on integers in units of 2⁻⁹⁶ (`interval`, which `chaos` uses with 2⁻⁴⁸), alone or with a
//! derivative (`number`). exp, sin, cos and √ all are the exponential of one 2×2 matrix (`exponential`). From
//! it come the motion between impacts (`oscillator`), the equations of an impact pattern, what makes their
//! solution an orbit, and its multipliers (`cycle`), and the test that there is one (`krawczyk`). `pattern`
//! has what holds of impacts and flights whatever the state is. `text` reads and writes the lines that the
//! kinds have in common, `range` coefficients that are intervals, `words` says them in words. No code is
//! shared with what finds the proof, and the method differs: that one has balls, and closed forms with exp,
//! sin, cos and √.

pub(crate) mod cycle;
pub(crate) mod exponential;
pub(crate) mod krawczyk;
pub(crate) mod number;
pub(crate) mod oscillator;
pub(crate) mod pattern;
pub(crate) mod range;
#[cfg(test)]
mod tests;
pub(crate) mod text;
pub(crate) mod words;

/// Numbers in units of 2⁻⁹⁶.
pub(crate) type Interval = super::interval::Fixed<96>;

use super::{
    Rejection, header,
    lines::{Lines, Words},
    rejection::Fault,
};
