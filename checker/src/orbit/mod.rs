//! Certificates of kind `orbit`: a periodic orbit of a linear impact oscillator exists, is unique in a box, admissible, and stable or not.
//!
//! The checker works on integers in units of 2⁻⁹⁶ (`fixed`). exp, sin, cos and √ all are the exponential of one 2×2 matrix
//! (`exponential`); the derivatives are formulas (`motion`, `proof`). No code is shared with what finds the proof, and the method differs: that
//! one has balls, closed forms with exp, sin, cos and √, and automatic differentiation.
//!
//! # Format
//!
//! After `kind orbit`; fractions p/q in lowest terms, decimals with a point, times in units in which the forcing's period is 2π:
//!
//! ```text
//! statement …                  what passing proves, word for word
//! digest HEX                   SHA-256 of the system's lines, from damping to the last harmonic
//! damping P/Q                  c, k, F of q″ = −c q′ − k q + F + Σ (a cos νt + b sin νt)
//! stiffness P/Q
//! force P/Q
//! forcing J                    and J lines
//! harmonic NU A B
//! lower OFFSET TAU J           the wall Q₁ = OFFSET + Σ (a cos νt + b sin νt) with restitution TAU, and J harmonics; or: lower none
//! upper …                      the wall Q₂ likewise
//! orbit M CLAIM                the number of impacts; stable, unstable, or open (no claim)
//! impact SIDE N T V            M lines: the wall, the periods to the next impact, the phase and the incoming relative speed, about
//! radius R W                   the orbit is the only one with all T, V within R, and it lies within W
//! row C …                      2M lines of 2M numbers: the preconditioner of Krawczyk's test, about the inverse of the derivative
//! flight J                     for each impact, and J lines
//! until T                      the flight is proved piece by piece: the times since its impact at which the pieces end
//! ```
//!
//! The equations are, for each flight, that at its end the gap to the wall met is 0 and closes at the speed V of that impact; the rows
//! of the derivative in that order, its columns the phases, then the speeds. `tests/orbit_certificate.rs` prints and damages an example.

mod exponential;
mod fixed;
mod motion;
mod proof;
mod sha256;
#[cfg(test)]
mod tests;
mod text;

use super::{
    Checked, FORMAT, Rejection,
    lines::{Lines, Words},
};

pub use text::{Certificate, Claim, Decimal, Fraction, Harmonic, Impact, Side, System, Wall};

/// The word in the header.
pub const KIND: &str = "orbit";

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "The oscillator of this digest has exactly one periodic orbit with the listed impacts (the wall, \
and the periods to the next) whose phases and incoming relative speeds all lie within R of the listed ones: the equations \
of the pattern have exactly one solution there, at it every impact has positive speed, and strictly between impacts every \
gap to a wall is positive. If the claim is stable, both multipliers of that orbit lie strictly inside the unit circle; if \
unstable, one lies strictly outside.";

/// Checks everything after the kind line. Cost for m impacts: O(m³) operations on intervals and three motions for each piece.
pub(super) fn check(lines: &mut Lines) -> Result<Checked, Rejection> {
    let certificate = text::read(lines)?;
    let periods: u64 = certificate.impacts.iter().map(|impact| impact.periods).sum();
    proof::Proof::new(&certificate)
        .and_then(|proof| proof.run())
        .map_err(|reason| lines.false_claim(reason))?;
    let detail = format!(
        "{} impact{}, {}, system {}",
        certificate.impacts.len(),
        if certificate.impacts.len() == 1 { "" } else { "s" },
        if certificate.claim == Claim::Open {
            "stability open".to_string()
        } else {
            certificate.claim.to_string()
        },
        certificate.system.digest()
    );
    Ok(Checked {
        kind: KIND,
        statement: STATEMENT,
        range: periods..=periods,
        lines: lines.number(),
        detail: Some(detail),
    })
}
