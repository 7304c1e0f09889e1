//! Certificates of kind `nothing`: beyond a touch nothing is born, and no motion stays near it, from the
//! touch to a given distance.
//!
//! The oscillator is that of kind `range` ([`super::range`]) with σ = 1: its place of rest is behind the
//! wall. The theorem with its proof is in `proofs/ranges.md`; C1 to C3, which it rests on, are in
//! `proofs/chaos.md`. No code is shared with what finds the proof.
//!
//! # Form
//!
//! After `kind nothing`, times being in units in which the wall's period is 2π, lengths in units of its
//! amplitude:
//!
//! ```text
//! statement …                what passing proves, word for word: STATEMENT
//! damping LO HI              the ranges of c, k and τ > 0: fractions in lowest terms, LO ≤ HI
//! stiffness LO HI
//! restitution LO HI
//! harmonics J                as of kind chaos, with J lines harmonic
//! harmonic N A A' B B'
//! window W                   phases lie within ±W, 0 < W < π/2
//! pieces J                   the window is proved convex in J pieces, 1 to 1000
//! longest N                  1 to 100
//! rounds R                   1 to 100
//! cells M                    1 to 10000, then M lines
//! cell NU S K                ν from that of the line before, at first 0/1, to NU, a larger fraction; S > 0;
//!                            the strengths from −S to S are cut into K parts (1 to 64)
//! ```
//!
//! Decimals and fractions are as of kind `range`.
//!
//! # Rules
//!
//! In every cell, for all its ν and all parameters, C1 and C2 of `touch::near` hold with its S and N, 0 < W <
//! π/2 and g″ < 0 on ±W; and after R rounds of C3 no legs are left. At ν = 0:
//!
//! - T: for legs of n ≤ N periods from q̂ = 1 to q̂ = 1 let aₙ and pₙ be the first and the last velocity. The
//!   graph of those that are not below 1 at whole periods between, in which m may be followed by n if aₙ ≥
//!   pₘ, has no cycle.
//!
//! # Version 2
//!
//! `kind nothing 2` has the same lines, with another statement, of an oscillator between two walls, the upper
//! one at −w(t − π) if the lower one is at w(t) = σν − 1 + g(t). Periods are half periods, and an odd number
//! of them has −E for E; the other rules are the same.
//!
//! # Example
//!
//! README's machine beyond its touch (c = 1/10, k = 3/10, τ = 4/5):
//!
//! ```text
//! harmonic 1 1/1 1/1 0/1 0/1
//! pieces 16
//! longest 2
//! rounds 3
//! cells 1
//! cell 1/100 8 1
//! ```
//!
//! T by hand: over n = 1, 2 periods E₁₁ = −0.7197, 0.4753 and E₁₂ = −0.3771, 0.5286, so that a₁ = (1 −
//! E₁₁)/E₁₂ = −4.560, p₁ = 3.223, and a₂ = 0.9926, p₂ = −0.8345. No leg of one period follows one of one or
//! two: −4.560 is below 3.223 and −0.8345. A leg of two, half-way at E₁₁ + E₁₂ a₂ = −1.094 < 1, is none. A
//! whole file is `tests/data/nothing.txt`.
//!
//! # Cost
//!
//! Counted are exponentials, and what takes as long; at most 6,000,000. With H harmonics and J pieces:
//!
//! ```text
//! (J + 2) H + N + 1 + N²                           the wall; T
//! for each cell    N + 1 + 23 H                    E over 0 to N periods; the strengths as a whole
//!     a round      N² K 36 H                       impacts in parts
//!     the first    N K² (N + 5)                    legs
//!     each other   N³ K² (N + 5)
//! ```
//!
//! Memory: the certificate, and the impacts of a cell, N² K.

mod born;
mod proof;
mod text;

use super::{
    Proved, Rejection,
    lines::Lines,
    rejection::{Fault, unless},
    touch::{
        Interval,
        about::About,
        text::{plain, wall_in_words},
    },
};

pub use text::{Cell, Certificate, Decimal, Fraction, Harmonic, Range};

/// The word in the header.
pub const KIND: &str = "nothing";

/// What a certificate proves.
pub const STATEMENT: &str = "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the last cell's, consider the motions of the oscillator q'' = -c q' - k q above the wall \
nu - 1 + g(t) with restitution tau: q is never below the wall, free where it is above, and where it meets the \
wall it leaves at tau times the speed at which it comes, or rests on the wall while that does not pull. With \
the listed longest N and rounds R, and S that of a cell of nu, every motion, in whatever state it begins, meets the wall \
within (2 R + 2)(N + 1) periods 2 pi, and so again and again, at a phase that is not within W of a multiple \
of 2 pi or at which |g'| > nu S/2. And for nu -> 0 nothing is born, whatever S: let a_n and p_n be the first \
and the last velocity of q'' = -c q' - k q from q = 1 to q = 1 in n periods, for those n up to N for which q \
is at least 1 after each whole period between; there is no infinite sequence of such n in which a_n >= p_m \
whenever n follows m. Every n is up to N.";

/// What a certificate of version 2 proves: the same between two walls, one the mirror image of the other.
pub const STATEMENT_2: &str = "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the last cell's, consider the motions of the oscillator q'' = -c q' - k q between the \
lower wall w(t) = nu - 1 + g(t) and the upper wall -w(t - pi), both with restitution tau: q is never below \
the lower nor above the upper wall, free where it is between, and where it meets a wall it leaves at tau \
times the speed at which it comes, or rests on the wall while that does not pull. With the listed longest N \
and rounds R, and S that of a cell of nu, every motion, in whatever state it begins, within (2 R + 2)(N + 1) \
half periods pi, and so again and again, meets the lower wall at a phase that is not within W of a multiple \
of 2 pi or at which |w'| > nu S/2, or the upper wall where half a period before there is such a phase. And \
for nu -> 0 nothing is born, whatever S: let a_n be the first velocity of q'' = -c q' - k q from q = 1 to q = \
(-1)^n in n half periods, and p_n the last, times (-1)^n, for those n up to N for which (-1)^k q is at least \
1 after k half periods, for each whole k between; there is no infinite sequence of such n in which a_n >= p_m \
whenever n follows m. Every n is up to N.";

/// Whether the conditions hold in one cell, from 0: for a search, which finds cell after cell. What is proved
/// is what [`check`](crate::check) accepts as a whole. `stop` is asked after every microsecond or few of work
/// whether to end.
///
/// # Errors
/// The condition that fails, or that it was stopped.
pub fn cell_holds(
    certificate: &Certificate,
    cell: usize,
    stop: &mut dyn FnMut() -> bool,
) -> Result<(), String> {
    proof::cells(certificate, cell..cell + 1, &mut || unless(stop())).map_err(Fault::reason)
}

/// Checks everything after the kind line.
pub(super) fn check<const MIRRORED: bool>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines, MIRRORED)?;
    let all = 0..certificate.cells.len();
    proof::cells(&certificate, all, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    let detail = detail(&certificate);
    let Certificate { mirrored, ranges, harmonics, .. } = certificate;
    let depth = certificate.cells.last().map_or(Fraction::ZERO, |last| last.depth);
    let about = Some(About { mirrored, ranges, behind: true, harmonics, depth, least: None });
    Ok(Proved { title: Some("nothing born"), about, ..Proved::plain(None, detail) })
}

/// All that the statement leaves to the lines, in words.
fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let wall = wall_in_words(&certificate.harmonics);
    let (motion, [half, walls]) = match certificate.mirrored {
        false => {
            (format!("q'' = -c q' - k q above the wall nu - 1 + {wall}, restitution tau"), ["", "the wall"])
        }
        true => (
            format!(
                "q'' = -c q' - k q between the lower wall nu - 1 + {wall} and its mirror image half a period later, \
                 restitution tau"
            ),
            ["half ", "a wall"],
        ),
    };
    let mut all = vec![("motion", motion)];
    for (name, [lo, hi]) in text::RANGES.iter().zip(certificate.ranges) {
        let value = if lo == hi { plain(lo) } else { format!("from {} to {}", plain(lo), plain(hi)) };
        all.push((name, value));
    }
    let last = certificate.cells.last().map_or(Fraction::ZERO, |cell| cell.depth);
    all.push(("depth", format!("every nu with 0 < nu <= {}", plain(last))));
    let Certificate { longest, rounds, window, .. } = certificate;
    let strengths: Vec<String> = certificate
        .cells
        .iter()
        .map(|cell| format!("{} up to nu = {}", cell.strength, plain(cell.depth)))
        .collect();
    let strengths = match &strengths[..] {
        [first, .., last] if strengths.len() > 4 => {
            format!("{first}, …, {last}: in each of {} cells what it lists", strengths.len())
        }
        all => all.join(", "),
    };
    let near = match certificate.mirrored {
        false => format!("within {window} of a multiple of 2 pi and at |g'| <= nu S/2"),
        true => format!("within {window} of its top and where it moves at nu S/2 at most"),
    };
    let periods = certificate.periods();
    all.push(("leaves", format!("within {periods} {half}periods (N = {longest}, R = {rounds}) every motion meets {walls} elsewhere than {near}")));
    all.push(("S", strengths));
    all
}
