//! Certificates of kind `range`: the motions that are born where a linear impact oscillator touches its wall,
//! one for every bi-infinite path of a graph, from the touch to a given distance.
//!
//! The theorem with its proof is in `proofs/ranges.md`. Version 2 says besides that there are no other
//! motions near; for σ = −1 of bounded ones. The oscillator is that of kind `chaos`
//! ([`super::chaos`]; `touch` has what both need), but a path is given by the strengths s of its impacts
//! alone, of which every edge of the graph has a range, and the depth ν runs from 0, the touch, through cells
//! that each have their own ranges. What is checked in a cell is E1 to E3 (`map`) and H4 (`gaps`), and
//! between two cells that the motions are the same (`link`); `work` has the legs. No code is shared with what
//! finds the proof.
//!
//! # Form
//!
//! After `kind range`, times being in units in which the wall's period is 2π, lengths in units of its
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
//! window W                   phases lie within ±W, 0 < W < π/2
//! pieces J                   each window, and each time between two, is proved in J pieces, 1 to 1000
//! letters L                  1 to 400, then L lines
//! letter N γ                 N periods (1 to 1000), and an entry of the growth vector
//! next V …                   L lines: the numbers, from 1, increasing, of the letters that may follow, at
//!                            least one; and every letter follows some letter
//! growth LO HI               the paths of T periods grow at least like LO^T and at most like HI^T;
//!                            1 ≤ LO < HI
//! contraction K              0 < K < 1
//! longest N                  of versions 2 and 4: 1 to 1000
//! rounds Q                   of versions 2 and 4: 1 to 100
//! cells M                    1 to 10000, then M blocks
//! cell NU S R                ν from that of the block before, at first 0/1, to NU, a larger fraction; each
//!                            edge's range is cut into S parts (1 to 64); that the motions are those of the
//!                            block before takes up to R steps (0 to 1000; of the first block 0)
//! others S K D               of both: no others with |g′| ≤ νS/2 at all impacts; strengths are cut into
//!                            K parts, the cell's depths into D, K² D ≤ 1000. Or: others no
//! edge A B m w               one line for each edge of the graph, in the order of its first letter and then
//!                            of its second: s lies from A to B, A < B; a factor; a weight > 0
//! ```
//!
//! A line after the statement has at most 2000 bytes. All but ranges, depths and counts are decimals.
//! Decimals, and both parts of a fraction, have at most 15 digits and lie strictly between −2¹⁵ and 2¹⁵.
//! There are at most 100,000 lines edge, and in a cell at most 100,000 legs: pairs of edges, times S².
//!
//! # Rules
//!
//! An edge u → v is the impact between a leg of letter u and one of letter v. For s before and s′ after a leg
//! of letter v let a_v(s, s′) and p_v(s, s′) be its first and its last velocity, and for all paths t → u → v
//! → x of four letters, with s⁻, s and s⁺ in the ranges of t → u, u → v and v → x,
//!
//! ```text
//! f = 2 (a_v(s, s⁺) + τ p_u(s⁻, s))/(1 + τ),    F = s − m (s − f)
//! ```
//!
//! In every cell, for all its ν and all parameters:
//!
//! - 0 < W < π/2, g″ < 0 on ±W, and the harmonics are as kind `chaos` wants them;
//! - H0: −νs/2 lies strictly between −g′ at −W and at W, and E₁₂ ≠ 0 over each leg;
//! - E1: F lies in the range of u → v;
//! - E2: |1 − m + m f_s| w + |m f_{s⁻}| w⁻ + |m f_{s⁺}| w⁺ ≤ K w;
//! - E3: in each part of the range of u → v one of these holds throughout: a_v > s/2; p_u < s/2; a_v > p_u;
//! - H4: the gap is positive strictly between impacts (`gaps`).
//!
//! At the depth that two cells share let X be all ranges of the former; up to R times replace each by what it
//! has in common with F of them all. Once each lies in the latter's range the cells are linked. The growth
//! vector and the periods are as kind `chaos` wants them.
//!
//! For a line others the letters' periods are different, and S is above |s| in the edges' ranges. In each of
//! D parts of the cell C1 and C2 of `touch::near` hold with S and N, for σ = −1 what is in `touch::settled`
//! for C2; after at most Q rounds of C3 only impacts of edges are left, with strengths in some ranges X; and
//! X, up to Q times replaced by what it has in common with F of it, comes to lie in the edges' ranges.
//!
//! # Versions 3 and 4
//!
//! `kind range 3` has the lines of version 1 and `kind range 4` those of version 2, with other statements: of
//! an oscillator between two walls, the upper one at −w(t − π) if the lower one is at w(t) = σν − 1 + g(t).
//! Under q(t) → −q(t − π) the two are exchanged. Periods of letters, and N, are half periods, and so are
//! those by which `growth` counts; an odd letter goes from one wall to the other. In a and p an odd n has −E
//! for E, and T = πn + t′ − t; H4 is of both gaps; the other rules are the same.
//!
//! # Example
//!
//! README's machine before it touches its stop (c = 1/10, k = 3/10, τ = 4/5, σ = −1), its orbit of one
//! period:
//!
//! ```text
//! harmonic 1 1/1 1/1 0/1 0/1
//! pieces 32
//! letters 1
//! letter 1 1
//! next 1
//! cells 1
//! cell 1/100 1 0
//! edge 2 2.5 1 1
//! ```
//!
//! H0 by hand: ν|s|/2 ≤ 0.0125 < sin 1.2 with the window 1.2. At ν = 0, where Q = Q′ = −1, E₁₁ = −0.7197, E₁₂
//! = −0.3771, E₂₁ = 0.1131 and E₂₂ = −0.6820 at T = 2π, hence a = −(1 − E₁₁)/E₁₂ = 4.560 and p = −E₂₁ + E₂₂ a
//! = −3.223, so that F = f = 2 (a + 4/5 p)/(9/5) = 2.202: inside its range, as E1 wants, and a > s/2, as E3
//! does. Cost: 34 for the wall; in the one cell 2, 36, 5, 1, 23 and 3·32·4 + 1: 486. Whole files are
//! `tests/data/range-1.txt`, the same up to ν = 1/10 in six cells, `range-12.txt` and `range-13.txt`.
//!
//! # Cost
//!
//! Counted are exponentials, and what takes as long; at most 50,000,000, and as many that are counted while
//! C3 and F are done. The wall takes one for each
//! harmonic: H. With E edges, J pieces, the longest letter L, and for each letter of n periods p predecessors
//! and f followers, in S parts and R steps:
//!
//! ```text
//! (J + 2) H                                        the wall
//! for each cell        L + 1                       E over 0 to L periods
//!     for each edge    36 H S                      its impacts in parts
//!     for each letter  5 p f S²                    legs
//!     for each edge    p f S³                      F: p of its first letter, f of its second
//!     and              23 H E                      impacts as wholes
//!     for each letter  p f ((2n + 1) J (2 + 2 H) + n)    gaps; 2n + 2 between mirrored walls
//!     for each step    the first four again, with the parts S of the cell before
//!     others S K D     D (2 N + 3 + 23 H)
//! ```
//!
//! Counted while it is done: each part of an impact, each leg, E over a number of periods and each sum of
//! velocities in F counts 36 H, or N + 5 if that is more.
//!
//! Memory: the certificate, and the parts and legs of a cell.

mod cost;
mod gaps;
mod legs;
mod link;
mod map;
mod others;
mod problem;
mod proof;
#[cfg(test)]
mod tests;
mod text;
mod words;
mod work;

use self::others::Room;
use super::{
    Proved, Rejection,
    lines::Lines,
    rejection::{Fault, unless},
    touch::{
        Interval,
        about::About,
        graph::{Vertex, grows},
    },
};

pub use super::touch::among::Among;
pub use text::{Alone, Cell, Certificate, Decimal, Edge, Fraction, Harmonic, Letter, Others, Range};

/// The word in the header.
pub const KIND: &str = "range";

/// The most cells.
const CELLS: u64 = 10_000;
/// The most that a check may cost, in exponentials.
const COST: u64 = 50_000_000;

/// What certificates of versions 1 and 2 prove.
macro_rules! one_wall {
    () => {
        "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the last cell's, the oscillator q'' = -c q' - k q above the wall sigma nu - 1 + g(t), \
sigma the listed side, with restitution tau: for every bi-infinite path of the listed graph of letters \
and every integer m there is exactly one motion whose impacts, one between two letters, have times \
within W of multiples of 2 pi, as many periods 2 pi apart as the letters say, the impact before letter 0 \
within W of 2 pi m, each at a phase where g' = nu s/2 with s in the range that the cell of nu has for \
the edge between its letters. It has no other impacts, all are at positive speed, and between them the \
gap is positive. Where nu is in two cells both have the same motion, and with c, k, tau, g, the path and \
m held fixed the times and velocities of its impacts depend continuously on nu, from where it is born at \
nu = 0. With the same m, paths whose periods differ somewhere have different motions; on the set of the \
states (q, q') at t = pi of all these motions, for all m, the map to t = 3 pi has a topological entropy \
between the logarithms of the growth rates."
    };
}

/// What certificates of versions 3 and 4 prove: the same between two walls, each the mirror image of the
/// other.
macro_rules! mirrored {
    () => {
        "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the last cell's, the oscillator q'' = -c q' - k q between the lower wall w(t) = sigma nu \
- 1 + g(t), sigma the listed side, and the upper wall -w(t - pi), both with restitution tau: for every \
bi-infinite path of the listed graph of letters and every integer m there is exactly one motion whose \
impacts, one between two letters, have times within W of multiples of pi, at the lower wall of even and at \
the upper wall of odd multiples, as many half periods pi apart as the letters say, the impact before letter \
0 within W of m pi, each at a phase where w', at the upper wall w' half a period before, is nu s/2 with s in \
the range that the cell of nu has for the edge between its letters. It has no other impacts, all are at \
positive speed, between them the gaps to both walls are positive, as at impacts is that to the other wall. \
Where nu is in two cells both have the same motion, and with c, k, tau, g, the path and m held fixed the \
times and velocities of its impacts depend continuously on nu, from where it is born at nu = 0. With the \
same m, paths whose half periods differ somewhere have different motions; on the set of the states (q, q') \
at t = pi/2 of all these motions, for all m, the map F to (-q, -q') at t = 3 pi/2 has a topological entropy \
between the logarithms of the growth rates, and the map to t = 5 pi/2 is F applied twice, of twice that \
entropy."
    };
}

/// What a certificate proves.
pub const STATEMENT: &str = one_wall!();

/// What a certificate of version 2 proves.
pub const STATEMENT_2: &str = concat!(
    one_wall!(),
    " If a cell has a line others with a strength S, then for its \
nu every motion that meets the wall at arbitrarily early and late times, only within W of multiples of \
2 pi where |g'| <= nu S/2, and is bounded if sigma is -1, is one of these. If c and k are positive, every \
bounded motion that meets the wall, and only there, is one of these or, if sigma is -1, has a last impact. \
S is above |s| in the ranges of all its edges."
);

/// What a certificate of version 3 proves.
pub const STATEMENT_3: &str = mirrored!();

/// What a certificate of version 4 proves.
pub const STATEMENT_4: &str = concat!(
    mirrored!(),
    " If a cell has a line others with a strength S, then for its \
nu every motion that meets the walls at arbitrarily early and late times, only where the above do and |w'|, \
or at the upper wall |w'| half a period before, is at most nu S/2, and is bounded if sigma is -1, is one of \
these. If c and k are positive, every bounded motion that meets a wall, and only there, is one of these or, \
if sigma is -1, has a last impact. S is above |s| in the ranges of all its edges."
);

/// The statement of a version, from 1 to 4.
fn statement(version: u8) -> &'static str {
    [STATEMENT, STATEMENT_2, STATEMENT_3, STATEMENT_4][usize::from(version - 1)]
}

/// Whether the conditions hold in one cell, from 0, and it is linked to the one before: for a search, which
/// finds cell after cell. What is proved is what [`check`](crate::check) accepts as a whole. `stop` is asked
/// after every microsecond or few of work whether to end.
///
/// # Errors
/// The condition that fails, or that it was stopped.
pub fn cell_holds(
    certificate: &Certificate,
    cell: usize,
    stop: &mut dyn FnMut() -> bool,
) -> Result<(), String> {
    proof::cells(certificate, cell..cell + 1, &mut Room::new(), &mut || unless(stop())).map_err(Fault::reason)
}

/// Whether one cell's claim that there are no others holds, from 0: for a search, as
/// [`cell_holds`].
///
/// # Errors
/// The condition that fails, or that it was stopped.
pub fn others_hold(
    certificate: &Certificate,
    cell: usize,
    stop: &mut dyn FnMut() -> bool,
) -> Result<(), String> {
    proof::alone(certificate, cell, &mut || unless(stop())).map_err(Fault::reason)
}

/// Checks everything after the kind line, of version 1 to 4.
pub(super) fn check<const VERSION: u8>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines, VERSION)?;
    let letters = certificate.letters.iter();
    let letters =
        letters.map(|letter| Vertex { periods: letter.periods, growth: letter.growth, next: &letter.next });
    grows(&letters.collect::<Vec<_>>(), certificate.growth).map_err(|reason| lines.false_claim(reason))?;
    proof::run(&certificate, lines)?;
    let title = if certificate.is_chaos() { "range of chaos" } else { "range of orbits" };
    let detail = words::detail(&certificate);
    let Certificate { mirrored, ranges, harmonics, .. } = certificate;
    let depth = certificate.cells.last().map_or(Fraction::ZERO, |last| last.depth);
    let about = Some(About { mirrored, ranges, behind: certificate.behind, harmonics, depth, least: None });
    Ok(Proved { title: Some(title), about, ..Proved::plain(None, detail) })
}
