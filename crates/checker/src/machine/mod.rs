//! Certificates of kind `machine-orbit`: a periodic orbit of a linear machine with rigid stops exists, is
//! unique in a box, admissible, and stable or not.
//!
//! A machine is M q″ + C q′ + K q = f₀ + Σ f_k(t) with n coordinates, a force of period T, and stops
//! w·q ≥ Q(t) in any number, each with a restitution τ: an impact turns the gap's rate −V into τV and changes
//! the velocities by (1 + τ) V M⁻¹wᵀ/(w M⁻¹wᵀ). It is a kind of its own, not a version of `orbit`, as no part
//! of the mathematics is that of one coordinate: the flow is the exponential of a matrix of any size
//! (`linear`, `motion`), the unknowns are whole states (`cycle`), stability is asked of powers of a matrix
//! (`proof`). Numbers, the lines of the proof and what holds of every pattern are those of `motion`. No
//! code is shared with what finds the proof.
//!
//! # Form
//!
//! After `kind machine-orbit`. Every coefficient is an interval `LOWER..UPPER`, written R here: two decimals,
//! in order, equal for a number that is known exactly. M, C, K, forces and T are in consistent units of the
//! machine's own; phases T, pieces, velocities U and V are not: their unit of time is T/2π, in which the
//! forcing's period is 2π.
//!
//! ```text
//! statement …                  what passing proves, word for word: STATEMENT
//! digest HEX                   SHA-256, in lower case, of the machine's lines, from coordinates to the last
//!                              stop's, each ended by a line feed
//! coordinates N                1 to 8
//! period R                     T > 0
//! unit E                       M, C, K and forces are 10^E times what is listed, -99 to 99; no motion
//!                              depends on it
//! mass R …                     N lines, of 1, 2, …, N numbers: the lower triangle of M, which is symmetric
//! damping R …                  N lines of N numbers
//! stiffness R …                N lines of N numbers
//! force R …                    f₀, N numbers
//! forcing J                    and J lines, J ≤ 1000:
//! harmonic K A … B …           A cos 2πKt/T + B sin 2πKt/T, N numbers each, 1 ≤ K ≤ 1000, in any order,
//!                              repeated or not
//! stops S                      0 to 16, and for each:
//! stop OFFSET TAU J            Q = OFFSET + Σ (a cos + b sin), restitution TAU ≥ 0, J harmonics; three
//!                              intervals and a number
//! direction R …                w, N numbers
//! harmonic K A B               J lines
//! orbit M CLAIM                the number of impacts, (2N + 1) M ≤ 84; stable, unstable, or open (no claim)
//! scales S …                   2N decimals above 0: the units of the displacements, then of the velocities,
//!                              in which the radii are meant
//! impact STOP N T Q … U …      M lines: the stop from 1, the periods to the next impact (0 to 10000, not all
//!                              0); about the phase, and N displacements and N velocities just before the
//!                              impact
//! radius R W                   the orbit is the only one with all phases within R, and displacements and
//!                              velocities within R times their scales; its own are within W; 0 < W ≤ R
//! row C …                      (2N + 1) M lines of as many numbers: the preconditioner of Krawczyk's test
//! flight J                     for each impact, J ≥ 1, and J lines
//! until T                      the times since its impact at which pieces end; they grow, and the last is
//!                              not before the flight's end
//! ```
//!
//! T, Q, U, S, C are decimals (see the crate's head), and all numbers lie strictly between −2³⁰ and 2³⁰.
//! Lines with a number for every coordinate or unknown have at most 4000 bytes.
//!
//! The unknowns are, impact by impact, T, Q …, U …; the equations, impact by impact, that the gap to the stop
//! that is hit is 0 (one), and that the flight ends in the state before the next impact (2N). As for an
//! orbit, it must be shown not to repeat itself: for every divisor d of M for which d of M parts of the
//! periods are whole, some impact i and i + d differ in stop, state, or the time between them.
//!
//! # An example worked by hand
//!
//! A ball of mass 1 that a table throws up: q″ = −1, stop q ≥ 0 at rest, restitution 1, T = 2π. Thrown with V
//! it comes back 2V later, so that V = π for the pattern 1. But it does so from any phase: no certificate is
//! accepted, as the equations' derivative is singular. Let the table move, Q = a sin t, with restitution
//! τ < 1. Each impact must give back what is lost: relative to the table the ball comes at −V and leaves at
//! τV; it leaves with q′ = τV + a cos t and comes back a period later with q′ = −V + a cos t, and in between
//! loses 2π by gravity, so that (1 + τ) V = 2π. Over the flight q changes by 2π(τV + a cos t) − 2π² = 0: a
//! cos t = π − τV = π(1 − τ)/(1 + τ). With τ = 1/2 and a = 2: V = 4π/3, cos t = π/6, t = ±1.0197…; just
//! before the impact q = 2 sin t, q′ = π/3 − 4π/3 = −π. So
//! `impact 1 1 1.0197267436954502 1.7039299541846926 -3.141592653589793` is near one orbit, and with a minus
//! before phase and displacement near the other. `crates/checker/tests/machine.rs` checks both.
//!
//! # Version 2: without impacts
//!
//! The motion that meets no stop, the response to the forcing. After `kind machine-orbit 2` the machine is as
//! in version 1, and then there are only
//!
//! ```text
//! orbit 0 CLAIM                no impact; stable, unstable, or open
//! scales S …                   2N decimals above 0: the units in which powers of the flow shrink
//! flight J                     J ≥ 1, and J lines: the period from phase 0 on
//! until T                      the times at which the pieces end; the last is not before 2π
//! ```
//!
//! K must certainly be regular, no harmonic of the force may be in undamped resonance, and 1 must certainly
//! be no multiplier of the flow over a period, so that no other motion without impacts has that period. On
//! every piece, m its middle and r half its length, z(m) + z′(m)[−r, r] + z″[0, r²/2] > 0 for the gap z to
//! every stop. Stability is asked of the powers of the flow over a period.
//!
//! # Cost
//!
//! In version 2 M counts as 1. In exponentials of 2 × 2 matrices, with J harmonics in all, P pieces and M
//! impacts: e (8P + 20M) + (1 + 2J)(4P + 12M) may be at most 1,000,000, e = (2N + 1)³/4 rounded up. Memory:
//! the certificate.

mod cycle;
mod free;
mod linear;
mod motion;
mod proof;
mod text;
mod words;

use super::{FORMAT, Proved, Rejection, lines::Lines, rejection::Fault};
use crate::rejection::GoOn;

pub use super::motion::{
    range::Range,
    text::{Decimal, Harmonic},
};
pub use super::orbit::Claim;
pub use free::FreeCertificate;
pub(super) use free::check as check_free;
pub use text::{Certificate, Impact, Load, Machine, Stop};

/// The word in the header.
pub const KIND: &str = "machine-orbit";

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "For every choice of one number in each interval, the machine of this digest, M q'' + C q' + K q = f(t) \
with rigid stops, has a positive definite M and exactly one periodic orbit with the listed impacts (the stop, and the periods to \
the next) whose phases, displacements and velocities just before each impact all lie within R, in the listed scales, of the \
listed ones: the equations of the pattern have exactly one solution there, at it every impact has positive speed and meets no \
other stop, strictly between impacts every gap to a stop is positive, and no smaller number of periods than that of all listed \
impacts is a period of the orbit. If the claim is stable, all multipliers of that orbit lie strictly inside the unit circle; if \
unstable, one lies strictly outside.";

/// What a certificate of version 2 proves.
pub const STATEMENT_2: &str = "For every choice of one number in each interval, the machine of this digest, M q'' + C q' + K q = f(t) \
with rigid stops, has a positive definite M and exactly one motion without impacts that comes back after one period of the \
forcing: its equation of motion has exactly one solution of that period, and at all times every gap of that solution to a stop is \
positive. If the claim is stable, all multipliers of that motion lie strictly inside the unit circle; if unstable, one lies \
strictly outside.";

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines)?;
    let periods: u64 = certificate.impacts.iter().map(|impact| impact.periods).sum();
    let go_on: GoOn = &mut || lines.go_on();
    proof::Proof::new(&certificate, go_on)
        .and_then(|proof| proof.run(go_on))
        .map_err(|fault| lines.rejection(fault))?;
    Ok(Proved::plain(Some(periods..=periods), words::detail(&certificate)))
}
