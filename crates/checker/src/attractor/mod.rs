//! Certificates of kind `attractor`: beyond a touch motions are trapped, and what is trapped is chaotic, at
//! every depth up to one; or, of version 2 ([`cells`]), at one depth or between two.
//!
//! The oscillator is that of kind `nothing` ([`super::nothing`]), overdamped: c² > 4k. The theorem with its
//! proof is in `proofs/attractor.md`. No code is shared with what finds the proof.
//!
//! # Form
//!
//! After `kind attractor`, times being in units in which the wall's period is 2π, lengths in units of its
//! amplitude:
//!
//! ```text
//! statement …                what passing proves, word for word: STATEMENT
//! damping LO HI              the ranges of c, k and τ > 0: fractions in lowest terms, LO ≤ HI
//! stiffness LO HI
//! restitution LO HI
//! harmonics J                as of kind chaos, with J lines harmonic
//! harmonic N A A' B B'
//! depth NU                   a fraction: the greatest ν
//! window U V                 where Q = ν − 1 + g(t) ≥ 0, −U ≤ t ≤ V; 0 < U, V
//! bends α α'                 between which −g″ is there; 0 < α
//! concave U V                not where g(t) = cos t: −g″ > 0 for −U ≤ t ≤ V, more than the window
//! pieces J                   nor this: what is shown of g is shown in J pieces, 1 to 1000
//! speed S                    the trap: contacts with −S √ν ≤ V ≤ 0
//! slip Z                     and 0 ≤ aQ + Q′ + V ≤ Zν
//! growth E N                 E > 1, shown for returns after n < N periods one by one; N from 1 to 1000
//! start X                    trapped are motions that start with 0 ≤ aq + q′ ≤ X
//! exponent NU R L            for ν from this fraction on an exponent is at least R > 0; L from 1 to 2000;
//!                            or: exponent none
//! ```
//!
//! Numbers that are no fractions and no counts are decimals; all are as of kind `range`.
//!
//! # Rules
//!
//! For all parameters let a < b be the roots of z² − cz + k, D = b − a, λ = e^−2πa, w = U + V, E₁₂(T) =
//! (e^−aT − e^−bT)/D and E₁₁(T) = e^−aT + a E₁₂(T), which fall as a or b grow; ℓ_n the lesser of E₁₂(2πn ∓
//! w). With ν the depth of its line,
//!
//! - A1: c² > 4k, k > 0 and w < 2π; the wall is as the lines `window` and `bends` say (`stop`);
//! - A2: Z ≥ D/(e^D(2π − w) − 1);
//! - A3: β = α − b² e^bw ν (Z + (1 + τ)v)/D > 0 with v = 1/((1 + τ)ℓ₁), and
//!   S² ≥ 2α″(1 − λ + λτ²ν v²/(2β)) with α″ = α′ + a²ν (1 + Z/D);
//! - A4: γ = α − b² (νZ + (1 + τ)√ν S)/D > 0;
//! - A5: with σ = τ(α − b²νZ/D) + γ and q = 1 − max(S + √ν Z, a√ν)²/(2α), the greater of A_n = σℓ_n/(√ν S)
//!   and B_n = σ(q − E₁₁(2πn − w))/(((1 + τ)S + √ν Z)S) is at least E for n < N, and B_N is;
//! - A6: X ≥ νZ and α > b² (X + (1 + τ)√(2ν(α′ + a²(ν + X/D))))/D;
//! - A7: with NU and R, E₁₁(T) + e^−aT ((1 + τ)S/√NU + Z)/D < 1 for T = 2πL − w, and the greater of A_n and
//!   B_n is at least e^Rn for n ≤ L.
//!
//! All of it is evaluated in intervals of 2⁻⁹⁶, those of the wall of 2⁻⁴⁸.
//!
//! # Example
//!
//! A stop that moves by cos t, with d = 3/2, w = 8 and τ = 4/5, so that c = 3/8 and k = 1/64:
//!
//! ```text
//! harmonic 1 1/1 1/1 0/1 0/1
//! depth 1/100
//! window 0.15 0.15
//! bends 0.98 1.01
//! speed 0.75
//! slip 0.07
//! growth 1.15 14
//! start 2
//! exponent 1/10000 0.005 25
//! ```
//!
//! By hand: a = 0.04775, b = 0.32725, D = 0.2795, λ = 0.7408 and w = 0.3. A1: cos 0.15 = 0.9888 < 1 − ν. A2:
//! 0.2795/(e^1.6724 − 1) = 0.0646. ℓ₁ = E₁₂(2π − w) = 2.184, v = 0.2544; β = 0.98 − 0.3832·1.1032·0.01·0.528
//! = 0.978, α″ = 1.0100 and 2α″·(0.2592 + 0.7408·0.64·0.01·0.0647/1.956) = 0.5239 ≤ 0.5625 (A3). γ = 0.98 −
//! 0.3832·(0.0007 + 1.8·0.1·0.75) = 0.928 (A4). σ = 1.712 and q = 1 − 0.757²/1.96 = 0.7076, so that B₁₄ =
//! 1.712·(0.7076 − E₁₁(87.66))/(1.357·0.75) = 1.16, and A₁₃ = 1.712·0.0714/0.075 = 1.63 (A5). A whole file is
//! `tests/data/attractor.txt`.
//!
//! # Cost
//!
//! 6 N + 6 L exponentials, and 3 J + 2 times the harmonics of the wall. Memory: the certificate.

pub mod cells;
mod proof;
mod rates;
mod stop;
mod text;
mod words;

use super::{
    Proved, Rejection,
    lines::Lines,
    motion::Interval,
    rejection::{Fault, GoOn, claim},
    touch::about::About,
};

pub use text::{Certificate, Decimal, Exponent, Fraction, Harmonic, Range, Setting, Shown};

/// The word in the header.
pub const KIND: &str = "attractor";

/// What a certificate proves; `proofs/coq/Headline.v` quotes it from the trap on.
pub const STATEMENT: &str = "For all c, k, tau in the listed ranges, for g(t) the sum of the listed \
harmonics a cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, and for \
every nu > 0 up to the listed depth, consider the motions of the oscillator q'' = -c q' - k q above the wall \
Q(t) = nu - 1 + g(t) with restitution tau: q is never below the wall, free where it is above, and where it \
meets the wall it leaves at tau times the speed at which it comes. Let a < b be the roots of z^2 - c z + k, \
which are real and positive, and V = q' - Q' before a contact, which is a graze if V = 0. With the listed \
speed S, slip Z, growth E and start X let D be the contacts at which Q >= 0, -S sqrt(nu) <= V <= 0 and 0 <= a \
Q + Q' + V <= Z nu. Then after a contact in D the motion is free for a time, until a next contact, which is in \
D. Every motion that begins at a time at which Q <= 0, with q >= 0 and 0 <= a q + q' <= X, is in D from its \
third contact on. Small displacements of q and q' at a fixed time, just before a contact in D that is no graze, \
for which neither that of q nor that of a q + q' is below 0, become, but for their sign, such displacements \
just before the next contact, and that of q grows E-fold at least. No periodic motion whose contacts are in D, \
grazing or not, is stable in Lyapunov's sense. Every motion whose contacts are in D and no grazes has a \
positive Lyapunov exponent; where an exponent R is listed with a nu, from that nu on it is at least R in each \
period 2 pi. Of the motions that begin as said almost all never graze. It is not said that there is one \
attractor, that a motion comes near all of it, or how long it is where.";

/// The largest growth that A5 leaves room for, whatever is listed, in units of 2⁻⁴⁸; the wall is not looked
/// at. For a search: what is proved is what [`check`](crate::check) accepts.
///
/// # Errors
/// The rule that fails before it.
pub fn growth(certificate: &Certificate) -> Result<i128, String> {
    proof::growth(certificate).map_err(Fault::reason)
}

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines)?;
    proof::run(&certificate, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    let detail = words::detail(&certificate);
    Ok(proved(certificate.setting, None, detail))
}

/// What is proved of a setting, for depths from `least` on if there is such a number.
fn proved(setting: Setting, least: Option<Fraction>, detail: Vec<(&'static str, String)>) -> Proved {
    let Setting { ranges, harmonics, depth, .. } = setting;
    let about = Some(About { mirrored: false, ranges, behind: true, harmonics, depth, least });
    Proved { title: Some("chaos that attracts"), about, ..Proved::plain(None, detail) }
}
