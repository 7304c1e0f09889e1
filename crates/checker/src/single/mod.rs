//! Certificates of kind `single`: an orbit of one impact, from the touch at which it is born along its curve
//! to a given distance, with where it is stable.
//!
//! The oscillator is that of kind `range` ([`super::range`]). Of an orbit with one impact in n periods the
//! depth ν is an explicit function of the phase t of its impact, for a wall of any harmonics:
//!
//! ```text
//! σν = 1 − g(t) + K g′(t),    K = (1 + τ)E₁₂/S,    S = 1 − E₁₁ + τ(E₂₂ − det E),
//! ```
//!
//! E being that of n periods. So nothing has to contract: what is checked, in cells of the phase, is that ν
//! runs one way, that the impact has a speed, and that the gap is positive (`curve`, `gap`); and where it is
//! said, that the multipliers are inside the unit circle, or that one is outside. No code is shared with what
//! finds the proof.
//!
//! # Form
//!
//! After `kind single`, times being in units in which the wall's period is 2π, lengths in units of its
//! amplitude:
//!
//! ```text
//! statement …                what passing proves, word for word: STATEMENT
//! damping LO HI              the ranges of c, k and τ > 0: fractions in lowest terms, LO ≤ HI
//! stiffness LO HI
//! restitution LO HI
//! side σ                     1 or -1: the wall is at σν − 1 + g(t)
//! harmonics J                as of kind chaos, with J lines harmonic
//! harmonic N A A' B B'
//! periods N                  from one impact to the next, 1 to 1000
//! direction D                1 or -1: phases lie between 0 and D times the last cell's
//! pieces J                   each period between impacts is cut into J pieces, 1 to 1000
//! parts P                    1 to 100, then P lines
//! part NU WORD               ν from that of the line before, at first 0/1, not included, to NU, a larger
//!                            fraction; WORD is stable, unstable, or open, where nothing is said
//! cells M                    1 to 10000, then M lines
//! cell T                     from the phase of the line before, at first 0, to T, a larger decimal, in the
//!                            direction D; at most 3.141
//! ```
//!
//! Decimals and fractions are as of kind `range`. N times J is at most 100,000.
//!
//! # Rules
//!
//! In every cell, for all its phases t and all parameters:
//!
//! - S1: σD(−g′(t) + K g″(t)) > 0: ν increases in the direction D; at a resonance, where K = 0, σ = 1 and S2
//!   will do;
//! - S2: D(−g′(t)) > 0, or, in the first cell, g″(t) < 0; and −D(1 − tr E + det E)/S > 0: the speed of the
//!   impact is positive;
//! - S3: the gap is positive strictly between impacts (`gap`);
//!
//! and at the end of the last cell ν is at least that of the last part. A cell with a ν in a part that is
//! called stable has both multipliers inside the unit circle, one with a ν in a part called unstable has one
//! outside: with Δ = τ² det E and
//!
//! ```text
//! Θ = −τ tr E + (1 + τ)E₁₂ S/(1 − tr E + det E) (g″(t)/g′(t) + c + kK)
//! ```
//!
//! Δ < 1 and |Θ| < 1 + Δ, or |Θ| > 1 + Δ, for all phases of the cell (but t = 0) and all parameters.
//!
//! A *resonance* is E₁₂ = 0, which no enclosure tells. It is decided in whole numbers: c and k are single
//! numbers, and n²(4k − c²) = m² for a whole m > 0; in version 2 = (2m)². Then E₁₂ is 0 in all rules.
//!
//! # Version 2
//!
//! `kind single 2` has the same lines, with another statement, of an oscillator between two walls, the upper
//! one at −w(t − π) if the lower one is at w(t) = σν − 1 + g(t). Periods are half periods, E is (−1)ⁿ E(πn),
//! and S3 is of both gaps; the other rules are the same. Multipliers are those of n half periods, with the
//! mirror after them if n is odd.
//!
//! # Example
//!
//! README's machine before it touches its stop (c = 1/10, k = 3/10, τ = 4/5, σ = −1), its orbit of one
//! period:
//!
//! ```text
//! harmonic 1 1/1 1/1 0/1 0/1
//! periods 1
//! direction -1
//! pieces 32
//! parts 1
//! part 1/100 unstable
//! cells 1
//! cell 0.012
//! ```
//!
//! By hand: E₁₁ = −0.7197, E₁₂ = −0.3771, E₂₂ = −0.6820 and det E = 0.5335, hence S = 1.7197 + 0.8·(−1.2155)
//! = 0.7473 and K = 1.8·(−0.3771)/0.7473 = −0.9083. With D = −1 the phase −θ has ν = 0.9083 sin θ − (1 − cos
//! θ), which is 0.0108 at θ = 0.012 and increases up to tan θ = 0.9083, the fold. 1 − tr E + det E = 2.935 >
//! 0, as S2 wants. There g″/g′ = −cos θ/sin θ = −83.3, c + kK = −0.172, and Θ = 0.8·1.4017 +
//! 1.8·(−0.3771)·0.7473/ 2.935·(−83.5) = 15.6 > 1 + Δ = 1.34: it is unstable.
//!
//! # Cost
//!
//! Counted are exponentials, and what takes as long; at most 50,000,000. With H harmonics, J pieces of a
//! period, N periods and M cells:
//!
//! ```text
//! 2 J + N + 1 + N J                    the free motion
//! for each cell    2 H (J + 2)         the wall
//!                  N J (2 + H)         the gap, and where it may be least
//!                  twice both          between mirrored walls
//! ```
//!
//! Memory: the certificate, and the free motion, N J pieces.

mod curve;
mod gap;
mod proof;
#[cfg(test)]
mod tests;
mod text;
mod words;

use super::{
    Proved, Rejection,
    lines::Lines,
    rejection::{Fault, unless},
    touch::{Interval, about::About},
};

pub use proof::Found;
pub use text::{Certificate, Decimal, Fraction, Harmonic, Part, Range, Word};

/// The word in the header.
pub const KIND: &str = "single";

/// What a certificate proves.
pub const STATEMENT: &str = "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the last part's, the oscillator q'' = -c q' - k q above the wall sigma nu - 1 + g(t), \
sigma the listed side, with restitution tau, has exactly one motion that repeats itself after the listed n \
periods 2 pi and has one impact in them, at a time t, and so at all t + 2 pi n m, for which D t lies between \
0 and the last cell's T, D being the listed direction. The impact is at positive speed, and the gap between \
impacts is positive. With c, k, tau and g held fixed t is a continuous function of nu, from where the motion \
is born with t = 0 at nu = 0, and D t increases with nu. For nu in a part that is called stable the motion is \
asymptotically stable, both multipliers being inside the unit circle; in one called unstable it is unstable, \
one of them being outside.";

/// What a certificate of version 2 proves: the same between two walls, one the mirror image of the other.
pub const STATEMENT_2: &str = "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the last part's, the oscillator q'' = -c q' - k q between the lower wall w(t) = sigma nu \
- 1 + g(t), sigma the listed side, and the upper wall -w(t - pi), both with restitution tau, has exactly one \
motion that the listed n half periods pi later is itself, q(t + pi n) = q(t), if n is even, or its mirror \
image, q(t + pi n) = -q(t), if n is odd, and that has one impact in such a time, counting both walls: with the \
lower wall at a time t, and so at all t + pi n m, with the upper one where n m is odd, for which D t lies \
between 0 and the last cell's T, D being the listed direction. The impact is at positive speed, and between \
impacts the gaps to both walls are positive, as at impacts is that to the other wall. With c, k, tau and g \
held fixed t is a continuous function of nu, from where the motion is born with t = 0 at nu = 0, and D t \
increases with nu. For nu in a part that is called stable the motion is asymptotically stable, both \
multipliers of n half periods being inside the unit circle; in one called unstable it is unstable, one of \
them being outside.";

/// What is found of one cell, from 0, if S1 to S3 hold in it: for a search, which finds cell after cell. What
/// is proved is what [`check`](crate::check) accepts as a whole. The parts play no role. `stop` is asked
/// after every microsecond or few of work whether to end.
///
/// # Errors
/// The condition that fails, or that it was stopped.
pub fn cell_holds(
    certificate: &Certificate,
    cell: usize,
    stop: &mut dyn FnMut() -> bool,
) -> Result<Found, String> {
    let all = proof::cells(certificate, cell..cell + 1, &mut || unless(stop())).map_err(Fault::reason)?;
    all.into_iter().next().ok_or_else(|| "there is no such cell".into())
}

/// Checks everything after the kind line.
pub(super) fn check<const MIRRORED: bool>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines, MIRRORED)?;
    proof::run(&certificate, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    let detail = words::detail(&certificate);
    let Certificate { mirrored, ranges, harmonics, .. } = certificate;
    let depth = certificate.parts.last().map_or(Fraction::ZERO, |last| last.depth);
    let about = Some(About { mirrored, ranges, behind: certificate.behind, harmonics, depth, least: None });
    Ok(Proved { title: Some("orbit of one impact"), about, ..Proved::plain(None, detail) })
}
