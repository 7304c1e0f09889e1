//! Certificates of kind `chaos`: every bi-infinite path of a graph of letters, each of so many periods, is an
//! orbit of a linear impact oscillator with one wall, or with two that are each other's mirror images.
//!
//! The theorem with its proof is in `proofs/chaos.md`; how any linear oscillator with a rigid wall is
//! brought to the form here, in `docs/chaos.md`. What is checked is its conditions H0 to H4, for every
//! box of parameters (`proof`, `work`, `gaps`; `touch` has the wall and the legs), the growth rate, and,
//! if it is claimed, that there are no other orbits near (`only`). The checker works on integers in units
//! of 2⁻⁴⁸ (`interval`); exp, sin, cos and arcsin all are the exponential of one 2×2 matrix
//! (`touch::flow`). No code is shared with what finds the proof.
//!
//! # Form
//!
//! After `kind chaos 3`, times being in units in which the wall's period is 2π, lengths in units of its
//! amplitude:
//!
//! ```text
//! statement …                    what passing proves, word for word: STATEMENT_3
//! damping LO HI                  the ranges of c, k, f, τ > 0 and ν: fractions in lowest terms, LO ≤ HI; f
//!                                is 0/1 0/1 unless c and k are
//! stiffness LO HI                and then ν > 0; for ν the least may be 0/1, which stands for all ν > 0 up
//!                                to the greatest
//! force LO HI
//! restitution LO HI
//! depth LO HI
//! side σ                         1 or -1: the wall is at σν − 1 + g(t)
//! harmonics J                    1 to 100, then J lines, their orders increasing
//! harmonic N A A' B B'           a term a cos Nt + b sin Nt of g, 1 ≤ N ≤ 100: fractions, a from A to A',
//!                                b from B to B'
//! cells C K F T N                into how many parts each range is cut; at most 10000 boxes in all
//! window W                       phases lie within ±W, 0 < W < π/2; there the gap is convex
//! pieces J                       each window, and each time between two, is proved in J pieces, 1 to 1000
//! letters L                      1 to 400, then L lines
//! letter N A A' P P' α β γ S     N periods (1 to 1000); velocities after the first impact from A to A',
//!                                before the last from P to P'; weights; an entry of the growth vector; the
//!                                phases of both impacts are cut into S parts (1 to 64)
//! next V …                       L lines: the numbers, from 1, increasing, of the letters that may follow,
//!                                at least one; and every letter follows some letter
//! contraction K                  0 < K < 1
//! reach B                        q/ν stays below B
//! growth LO HI                   the paths of T periods grow at least like LO^T and at most like HI^T;
//!                                1 ≤ LO < HI
//! complete S M K R               no other orbits with |g′| ≤ νS/2 at all impacts; none of their legs is
//!                                longer than M periods (1 to 1000); proved in R rounds (1 to 100) with
//!                                phases cut into K parts (1 to 64). Or: complete no
//! ```
//!
//! A line after the statement has at most 2000 bytes. All but the ranges and the counts are decimals.
//! Decimals, and both parts of a fraction, have at most 15 digits and lie strictly between −2¹⁵ and 2¹⁵.
//!
//! # Rules
//!
//! With s = 2(a + τp)/(1 + τ) for the velocities p before and a after an impact, s_{mn} of all p in P_m and a
//! in A_n, the map G_n of `touch::legs`, and all paths m → n → k of three letters, in every cell:
//!
//! - 0 < W < π/2, g″ < 0 on ±W, and some a and b of the ranges have Σ a = 1 and Σ j b = 0 exactly; for these
//!   sums all A, all A', all B and all B' each have a common denominator of at most 10³⁰;
//! - H0: −νs/2 lies strictly between −g′ at −W and at W, and E₁₂ ≠ 0 over the leg;
//! - H1: G_n(s_{mn}, s_{nk}) lies in A_n × P_n;
//! - H2: |a_s| (α_n + τβ_m) + |a_{s′}| (α_k + τβ_n) ≤ K (1 + τ)/2 α_n, and the same of p with β_n on the
//!   right;
//! - H3: a > p;
//! - H4: the gap is positive strictly between impacts (`gaps`), and q/ν < B.
//!
//! The growth vector γ satisfies Σ z^{n_w} γ_w ≥ γ_v over the successors w of each v for z = 1/LO, ≤ for z =
//! 1/HI; or both over the predecessors. And either no letter has two successors of the same period, or none
//! two predecessors. Every letter being preceded and followed, each is on a path. What is proved is called
//! chaos if LO > 1, and orbits else: then the growth may be that of one periodic path. For `complete`, σ = 1,
//! f = 0, the letters' periods are different, and C1 to C3 of `only` hold.
//!
//! # Version 4
//!
//! After `kind chaos 4` the same lines, with another statement, are of an oscillator between two walls, the
//! upper one at −w(t − π) if the lower one is at w(t) = σν − 1 + g(t): under q(t) → −q(t − π) the two are
//! exchanged. The force is 0/1 0/1. The periods of letters and of `complete` are half periods, and so are
//! those by which `growth` counts. An odd letter goes from one wall to the other. In G an odd n has −E for E,
//! and T = πn + t′ − t; H4 is of both gaps, |q|/ν < B; the other rules are the same.
//!
//! Versions 1 and 2 had the same lines, and statements that do not say where a path begins: "exactly one
//! motion" is then not true, since its shift by a period is another. They are refused.
//!
//! # Example
//!
//! The paper's oscillator (c = 12/49, k = 100/2401, τ = 1) over {1, 2} for every µ > 0, ν = µ/(1 + µ); the
//! whole file is `tests/data/chaos-12.txt`:
//!
//! ```text
//! depth 0/1 1/1
//! harmonics 1
//! harmonic 1 1/1 1/1 0/1 0/1
//! window 1.2
//! letter 1 0.089 0.244 -0.1582 -0.0612 0.264121084 0.082075454 1 1
//! letter 2 0.615 1.036 -0.367 -0.14 1 0.310435706 1 1
//! next 1 2
//! next 1 2
//! growth 1.61803398874 1.61803398876
//! complete no
//! ```
//!
//! H0 and H3 by hand: s = a + p lies between 0.089 − 0.367 and 1.036 − 0.0612, so ν|s|/2 ≤ 0.4874 < sin 1.2 =
//! 0.932; and every a is positive, every p negative. At ν = 0, where Q = Q′ = 1, letter 1 has E₁₁ = 0.5374,
//! E₁₂ = 2.4267, E₂₁ = −0.1011, E₂₂ = −0.0570 at T = 2π, hence a = (1 − E₁₁)/E₁₂ = 0.1907 and p′ = E₂₁ + E₂₂
//! a = −0.1119: inside its box, as H1 wants. Growth: both letters may follow both, the vector is (1, 1), and
//! z + z² − 1 is 8·10⁻¹² at z = 1/1.61803398874, −9·10⁻¹² at 1/1.61803398876. Cost: 18 for the wall; in the
//! one cell 3, for the letters 4·36 + 4·36 and 8·4, and (46 + 3·16·2 + 1) + (46 + 5·16·2 + 2): 692.
//!
//! # Cost
//!
//! Counted are exponentials, and what takes as long; at most 6,000,000. The wall takes one for each harmonic:
//! H. An impact takes up to 23 H, as its phase is found by Newton's method; a part of its phases, with the
//! middle, 36 H; a leg 4; a piece 1 + H. So with J pieces, N letters of n periods in S parts with p
//! predecessors and f followers, the longest leg L, and a claim `complete S M K R`:
//!
//! ```text
//! (J + 2) H                                                            the wall
//! times C·K·F·T·N cells:   L + 1                                       E over 0 to L periods
//!     for each letter      (p + f) S·36 H + 4 p f S²                   H0 to H3
//!                          46 H + (2n + 1) J (1 + H) + n               H4; 2n + 2 between mirrored walls
//!     for complete         23 H + R M² K·36 H                          the impacts
//!                          (M + (R − 1) M³) K² (5 + M)                 the legs, with M gaps each
//! ```
//!
//! Memory: the certificate and the parts.

mod cost;
mod gaps;
mod only;
mod proof;
#[cfg(test)]
mod tests;
mod text;
mod words;
mod work;

use super::{
    Proved, Rejection,
    lines::{Lines, Words},
    rejection::Fault,
    touch::{
        Interval,
        graph::{Vertex, grows},
    },
};

pub use text::{Certificate, Complete, Decimal, Fraction, Harmonic, Letter, Range};

/// The word in the header.
pub const KIND: &str = "chaos";

/// The most boxes of parameters.
const CELLS: u64 = 10_000;
/// The most that a check may cost, in exponentials.
const COST: u64 = 6_000_000;

/// Why versions 1 and 2 are refused.
pub(super) const WITHDRAWN: &str = "its statement leaves out which impact is the first, so that it is not true as it stands; \
`grazing run SCENE -o FOLDER`, with the scene that it came from, writes it anew, as version 3 or, between mirrored walls, 4";

/// What a certificate of version 3 proves.
pub const STATEMENT_3: &str = "For all c, k, f, tau and nu > 0 in the listed ranges, and for g(t) \
the sum of the listed harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j \
b together 0, the oscillator q'' = -c q' - k q + f above the wall sigma nu - 1 + g(t), sigma the listed \
side, with restitution tau: for every bi-infinite path of the listed graph of letters and every integer m \
there is exactly one motion whose impacts, one between two letters, have times within W of multiples of \
2 pi, as many periods 2 pi apart as the letters say, the impact before letter 0 within W of 2 pi m, and \
velocities, divided by nu, after the first and before the last impact of each letter in its ranges. It \
has no other impacts, all are at positive speed, between them the gap is positive, and q/nu stays below \
the reach. With the same m, paths whose periods differ somewhere have different motions; on the set of \
the states (q, q') at t = pi of all these motions, for all m, the map to t = 3 pi has a topological \
entropy between the logarithms of the growth rates. If the line complete has a strength S, every motion that \
meets the wall at arbitrarily early and arbitrarily late times, and only within W of multiples of 2 pi \
where |g'| <= nu S/2, is one of these; if c and k are positive, so is every bounded motion for all time \
that meets it only there.";

/// What a certificate of version 4 proves: the same between two walls, one the mirror image of the other.
pub const STATEMENT_4: &str = "For all c, k, tau and nu > 0 in the listed ranges, and for g(t) the sum of \
the listed harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, \
the oscillator q'' = -c q' - k q between the lower wall w(t) = sigma nu - 1 + g(t), sigma the listed side, \
and the upper wall -w(t - pi), both with restitution tau: for every bi-infinite path of the listed graph of \
letters and every integer m there is exactly one motion whose impacts, one between two letters, have times \
within W of multiples of pi, at the lower wall of even and at the upper wall of odd multiples, as many half \
periods pi apart as the letters say, the impact before letter 0 within W of m pi, and velocities, divided by \
nu, with the other sign at the upper wall, after the first and before the last impact of each letter in its \
ranges. It has no other impacts, all are at positive speed, between them the gaps to both walls are positive, \
as at impacts is that to the other wall, and |q|/nu stays below the reach. With the same m, paths \
whose half periods differ somewhere have different motions; on the set of the states (q, q') at t = pi/2 of all \
these motions, for all m, the map F to (-q, -q') at t = 3 pi/2 has a topological entropy between the \
logarithms of the growth rates, and the map to t = 5 pi/2 is F applied twice, of twice that entropy. If the line complete has a strength S, \
every motion that meets the walls at arbitrarily early and arbitrarily late times, and only where the above \
do and |w'|, or at the upper wall |w'| half a period before, is at most nu S/2, is one of these; if c and k \
are positive, so is every bounded motion for all time that meets them only there.";

/// Checks everything after the kind line.
pub(super) fn check<const MIRRORED: bool>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines, MIRRORED)?;
    let letters = certificate.letters.iter();
    let letters =
        letters.map(|letter| Vertex { periods: letter.periods, growth: letter.growth, next: &letter.next });
    grows(&letters.collect::<Vec<_>>(), certificate.growth).map_err(|reason| lines.false_claim(reason))?;
    proof::run(&certificate, lines)?;
    let title = if certificate.is_chaos() { KIND } else { "orbits" };
    Ok(Proved { title: Some(title), ..Proved::plain(None, words::detail(&certificate)) })
}
