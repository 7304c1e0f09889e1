//! Certificates of kind `orbit`: a periodic orbit of a linear impact oscillator exists, is unique in a box,
//! admissible, and stable or not.
//! Version 2 says it of all oscillators whose coefficients lie in given intervals.
//!
//! The arithmetic, the motion and the equations are those of `motion`; the equations' derivatives are
//! formulas (`proof`). No code is shared with what finds the proof, and the method differs: that one has
//! balls, closed forms with exp, sin, cos and √, and automatic differentiation.
//!
//! # Form
//!
//! After `kind orbit`, times being in units in which the forcing's period is 2π:
//!
//! ```text
//! statement …                  what passing proves, word for word: STATEMENT
//! digest HEX                   SHA-256, in lower case, of the system's lines, units included, to the last
//!                              harmonic, each ended by a line feed
//! units L 0                    lengths, speeds, forces and walls are 10^L times what is listed, -99 to 99
//!                              but not 0; without this line they are as listed. An oscillator moves alike in
//!                              all units of length, so that nothing is computed with it
//! damping P/Q                  c, k, F of q″ = −c q′ − k q + F + Σ (a cos νt + b sin νt)
//! stiffness P/Q
//! force P/Q
//! forcing J                    and J lines, J ≤ 1000:
//! harmonic NU A B              0 ≤ ν ≤ 1000, in any order, repeated or not
//! lower OFFSET TAU J           the wall Q₁ = OFFSET + Σ (a cos νt + b sin νt) with restitution TAU ≥ 0, and
//!                              J harmonics; or: lower none
//! upper …                      the wall Q₂ likewise; Q₁ < q < Q₂
//! orbit M CLAIM                the number of impacts, 1 to 24; stable, unstable, or open (no claim)
//! impact SIDE N T V            M lines: lower or upper, the periods to the next impact (0 to 10000, not all
//!                              0), the phase and the incoming relative speed, about
//! radius R W                   the orbit is the only one with all T, V within R, and it lies within W; 0 < W
//!                              ≤ R
//! row C …                      2M lines of 2M numbers: the preconditioner of Krawczyk's test, about the
//!                              inverse of the derivative
//! flight J                     for each impact, J ≥ 1, and J lines
//! until T                      the flight is proved piece by piece: the times since its impact at which the
//!                              pieces end; they grow, and the last is not before the flight's end
//! ```
//!
//! T, V, R, W and C are decimals (see the crate's head); A, B, OFFSET, TAU, P/Q are fractions in lowest terms
//! of at most 34 digits each, Q > 0, P with a minus or none. All lie strictly between −2³⁰ and 2³⁰; beyond
//! that the checker's intervals end.
//!
//! Version 2 begins with `kind orbit 2` and differs in its statement and in that each coefficient, here a
//! fraction P/Q, A, B, OFFSET or TAU, is an interval `LOWER..UPPER`: two decimals, in order, equal for a
//! number that is known exactly. `damping 0.31415926535897932..0.31415926535897933` is for c = π/10. All is
//! evaluated over the intervals, so that it holds for every choice of one number in each; where one number
//! stands in several places, each counts by itself. A coefficient is zero, as the motion without stiffness or
//! damping needs it, only as `0..0`.
//!
//! The equations are, for each flight, that at its end the gap to the wall met is 0 and closes at the speed V
//! of that impact; the rows of the derivative in that order, its columns the phases, then the speeds. An
//! impact turns the relative velocity w into −TAU w. Impact i + 1 comes 2πN_i + T_{i+1} − T_i after impact i,
//! and impact 1 after the last. `tests/certificate/orbit.rs` prints and damages an example.
//!
//! The listed orbit must be shown not to repeat itself: for every divisor d of M for which d N/M is whole, N
//! being the sum of all N_i, some impact i differs from impact i + d in its wall, in its speed, or in that
//! the time between them is not 2π d N/M. So an orbit listed twice is no orbit of twice the period.
//!
//! # Version 3: without impacts
//!
//! The motion that meets no wall, the response to the forcing. After `kind orbit 3` the system is as in
//! version 2, and then there are only
//!
//! ```text
//! orbit 0 CLAIM                no impact; stable, unstable, or open
//! flight J                     J ≥ 1, and J lines: the period from phase 0 on
//! until T                      the times at which the pieces end; the last is not before 2π
//! ```
//!
//! The response is F/k + Σ (α cos νt + β sin νt) with (k − ν²) α + νcβ = a and (k − ν²) β − νcα = b, so that
//! k must certainly differ from 0, and no ν may be in undamped resonance. c must certainly differ from 0, or
//! k from every ν², so that 1 is no multiplier and no other motion without impacts has that period. On every
//! piece, m its middle and r half its length, z(m) + z′(m)[−r, r] + z″[0, r²/2] > 0 for the gap z to every
//! wall. It is stable if c > 0 and k > 0, and unstable if c < 0 or k < 0. The restitutions decide nothing.
//!
//! # Cost
//!
//! In version 3 M counts as 0. With J harmonics in all, P pieces and M impacts, (1 + 2J)(4P + 24M) may be at
//! most 1,000,000, which bounds the exponentials taken. Memory: the certificate.

mod free;
mod proof;
mod text;
mod words;

use super::{
    FORMAT, Proved, Rejection,
    lines::Lines,
    motion::{text::Coefficient, words::Spoken},
    rejection::Fault,
};

pub use super::motion::{
    range::Range,
    text::{Decimal, Fraction, Harmonic, Impact, Side, System, Units, Wall},
};
pub use free::FreeCertificate;
pub(super) use free::check as check_free;
pub use text::{Certificate, Claim};

/// The word in the header.
pub const KIND: &str = "orbit";

/// What a certificate of version 1 proves.
pub const STATEMENT: &str = "The oscillator of this digest has exactly one periodic orbit with the listed impacts (the wall, \
and the periods to the next) whose phases and incoming relative speeds all lie within R of the listed ones: the equations \
of the pattern have exactly one solution there, at it every impact has positive speed, strictly between impacts every \
gap to a wall is positive, and no smaller number of periods than that of all listed impacts is a period of the orbit. If \
the claim is stable, both multipliers of that orbit lie strictly inside the unit circle; if unstable, one lies strictly \
outside.";

/// What a certificate of version 2 proves.
pub const STATEMENT_2: &str = "Each coefficient of the system of this digest is an interval. Every oscillator whose coefficients lie in \
these intervals has exactly one periodic orbit with the listed impacts (the wall, \
and the periods to the next) whose phases and incoming relative speeds all lie within R of the listed ones: the equations \
of the pattern have exactly one solution there, at it every impact has positive speed, strictly between impacts every \
gap to a wall is positive, and no smaller number of periods than that of all listed impacts is a period of the orbit. If \
the claim is stable, both multipliers of that orbit lie strictly inside the unit circle; if unstable, one lies strictly \
outside.";

/// What a certificate of version 3 proves.
pub const STATEMENT_3: &str = "Each coefficient of the system of this digest is an interval. Every oscillator whose coefficients lie in \
these intervals has exactly one motion without impacts that comes back after one period of the forcing: its equation of motion \
has exactly one solution of period 2 pi, and at all times every gap of that solution to a wall is positive. \
If the claim is stable, both multipliers of that motion lie strictly inside the unit circle; if unstable, one lies strictly \
outside.";

/// What a coefficient is, which is what the versions differ in.
#[expect(private_bounds, reason = "certificates are made of the versions that there are")]
pub trait Version: Coefficient + Spoken {
    /// The line of the kind.
    const HEAD: &str;
    /// What passing proves.
    const STATEMENT: &str;
}

impl Version for Fraction {
    const HEAD: &str = "kind orbit";
    const STATEMENT: &str = STATEMENT;
}

impl Version for Range {
    const HEAD: &str = "kind orbit 2";
    const STATEMENT: &str = STATEMENT_2;
}

/// Checks everything after the kind line.
pub(super) fn check<C: Version>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate: Certificate<C> = text::read(lines)?;
    let periods: u64 = certificate.impacts.iter().map(|impact| impact.periods).sum();
    let proof = proof::Proof::new(&certificate).map_err(|reason| lines.false_claim(reason))?;
    proof.run(&mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    Ok(Proved::plain(Some(periods..=periods), words::detail(&certificate)))
}
