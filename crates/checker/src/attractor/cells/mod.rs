//! Certificates of kind `attractor 2`: what is trapped is chaotic at one depth, or between two, where
//! displacements need not grow at every impact, but do so by weights.
//!
//! The oscillator, the wall and the trap are those of kind `attractor` ([`super`]). Contacts are cut into
//! cells by their speed, each with a weight; the theorem with its proof is in `proofs/attractor.md`. So gaps
//! between the windows of λ₁ < 2/3 are proved, and depths to which the formulas of version 1 do not reach.
//!
//! # Form
//!
//! After `kind attractor 2`, the statement and the lines from `damping` to `slip` of version 1, but for
//!
//! ```text
//! depths NU NU'              in place of depth: the least and the greatest ν, 0 < NU ≤ NU'
//! ```
//!
//! and then
//!
//! ```text
//! start X                    as of version 1
//! growth G R L               G > 1, R > 0: displacements times their weights grow at least G-fold, and
//!                            e^Rn-fold over n periods; returns take at most L periods, L up to 200
//! cells K                    1 to 2000, K L up to 40000, then K lines
//! cell END WEIGHT            contacts with |V|/√ν from the end before, or 0, to END, a decimal; the last is
//!                            S. WEIGHT is an integer, 1 to 1000000
//! ```
//!
//! # Rules
//!
//! A1 to A4 and A6 of version 1, of the greatest ν. With its letters, and P(T) = e^−aT, F(T) = e^−aT (1 −
//! e^−DT)/D, which is E₁₂, for all parameters, all listed ν and each cell s₀ ≤ s ≤ s₁:
//!
//! - B1: the contacts of the cell lie in the intervals that three rounds of g = s + √ν (z − a y) and y = 1 −
//!   g²/(2α) from 0 ≤ y ≤ 1 on give, where 0 ≤ z ≤ Z and α is any number from α to α′; with t = −√ν g/α, u =
//!   (1 + τ)s + √ν z, h = u/√ν and Σ = (1 + τ)(α + a²νy) − (a + b)(τνz + √ν u), the least α in it. If no y is
//!   left there is no such contact;
//! - B2: for n = 1, 2, …, T = 2πn + t′ − t, the contacts that return after n periods lie in the intervals
//!   that three rounds of y′ = P y + F h, z′ = P e^−DT h, |g′|² = 2α (1 − y′), s′ = g′ + √ν (a y′ − z′) and
//!   t′ = −√ν g′/α give, from 0 ≤ y′ ≤ 1, 0 ≤ z′ ≤ Z and −√ν a ≤ g′ ≤ S + √ν Z on, with 0 ≤ s′ ≤ S; E = Σ
//!   F/(√ν s₁) + τP, by the last round. For n + 1 only those are left that are above the top, with h ≥ (1 −
//!   P y)/F at T = 2πn − t. None are for some n ≤ L;
//! - B3: for each return of B2 E times the least weight of the cells that may hold its s′ is at least G and
//!   e^Rn times the cell's own.
//!
//! All of it is evaluated in intervals of 2⁻⁹⁶, those of the wall of 2⁻⁴⁸.
//!
//! # Example
//!
//! `tests/data/attractor-cells.txt` is of d = 3/2, w = 5 and τ = 4/5, so that λ₁ = 0.62, at ν from 1/127 to
//! 1/126, between the windows of periods 8 and 9. Of its cell from s = 0.65515275 to 0.709748813, of weight
//! 942385, by hand: y is from 0.7477 to 0.7889, t from −0.0635 to −0.0577, h from 13.24 to 14.43 and Σ =
//! 1.7172 (B1). P y + F h is at least 1.049 for n = 7, and more before: none returns within 7 periods. For
//! n = 8 P = 0.0215 and F = 0.0481, so that y′ is from 0.6525 to 0.7114, |g′| = √(2α (1 − y′)) from 0.757
//! to 0.834, s′ from 0.761 to 0.839 and E = 1.7172·0.04808/(0.08909·0.70975) + 0.8·0.0215 = 1.3229. At the
//! top of that pass none is above it: all have returned (B2). The least weight where they do is 871171, and
//! 1.3229·871171 is 1.22293·942385, where G = 1.2229 and e^8R = 1.22287 (B3).
//!
//! # Cost
//!
//! 2 exponentials for each cell, up to 6 for each of its returns, which are some three as a rule and L at
//! most, and 3 L. With 150 cells it is a twentieth of a second, and some 2.5 seconds at most, as K L is
//! bounded. Memory: the certificate.

mod proof;
mod returns;
mod text;

use super::{
    Rejection, proved,
    words::{about, trapped},
};
use crate::{Proved, lines::Lines, touch::text::plain};

pub use text::{Cell, Certificate};

/// What a certificate proves.
pub const STATEMENT: &str = "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu between the listed depths, these included, consider the motions of the oscillator q'' = -c q' - k q \
above the wall Q(t) = nu - 1 + g(t) with restitution tau: q is never below the wall, free where it is above, and \
where it meets the wall it leaves at tau times the speed at which it comes. Let a < b be the roots of z^2 - c z + \
k, which are real and positive, and V = q' - Q' before a contact, which is a graze if V = 0. With the listed \
speed S, slip Z and start X let D be the contacts at which Q >= 0, -S sqrt(nu) <= V <= 0 and 0 <= a Q + Q' + V <= \
Z nu. Then after a contact in D the motion is free for a time, until a next contact, which is in D and comes n \
passages of the wall later, with n from 1 to the listed L. Every motion that begins at a time at which Q <= 0, with \
q >= 0 and 0 <= a q + q' <= X, is in D from its third contact on. The listed cells cut the numbers from 0 to S, and \
a contact in D has the weight of a cell that holds -V / sqrt(nu). Small displacements of q and q' at a fixed time, \
just before a contact in D that is no graze, for which neither that of q nor that of a q + q' is below 0, become, \
but for their sign, such displacements just before the next contact, and that of q times the weight of its contact \
grows at least G-fold and e^(R n)-fold, for the listed G > 1 and R > 0. No periodic motion whose contacts are in D, \
grazing or not, is stable in Lyapunov's sense. Every motion whose contacts are in D and no grazes has a Lyapunov \
exponent of at least R in each period 2 pi. Of the motions that begin as said almost all never graze. It is not \
said that there is one attractor, that a motion comes near all of it, or how long it is where.";

/// Checks everything after the kind line.
pub(crate) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines)?;
    proof::run(&certificate, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    let detail = detail(&certificate);
    Ok(proved(certificate.setting, Some(certificate.least), detail))
}

/// What a certificate speaks of, in words.
fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let Certificate { setting, least, start, growth, rate, last, cells } = certificate;
    let (least, greatest) = (plain(*least), plain(setting.depth));
    let mut all = about(setting, format!("every nu with {least} <= nu <= {greatest}"));
    all.push(trapped(*start));
    let weighs = cells.iter().map(|cell| cell.weight);
    let [light, heavy] = [weighs.clone().min(), weighs.max()].map(Option::unwrap_or_default);
    let cells = cells.len();
    all.push((
        "growth",
        format!(
            "with weights from {light} to {heavy} in {cells} cells of -V/sqrt(nu) {growth} at each contact, which \
             come after {last} periods at most"
        ),
    ));
    all.push(("exponent", format!("at least {rate} in a period 2 pi")));
    all
}
