//! Certificates of kind `share`: in which share of a box of parameters something holds, at least and at
//! most.
//!
//! The box is one of machines (w, z), natural over drive frequency and damping ratio; of points (r, s); or
//! of points (a₁, a₂). It is cut into halves, these again, and so on: a tree whose leaves are cells. Of a
//! leaf is claimed that the statement holds at all of its points, or at none, or nothing. Halves do not
//! overlap and leave nothing out, so that the areas of the leaves need no proof: one that was cut off by d
//! halvings has 2^−d of the box.
//!
//! What is proved of a leaf is in `cell`: a₁, a₂ and the sign of γ are enclosed on it, and the signs of u_n
//! and N_{n,k} are found on the rectangle of (a₁, a₂) that holds them, as kind [`word`](super::word) does.
//! That chaos is born is two periods found so; that it is not rests on the word theorem, as kind
//! `word-by-theorem` does.
//!
//! # Form
//!
//! ```text
//! statement …                     what passing proves, word for word: STATEMENT
//! box machine LO HI LO HI         the ends of w, 0 < w ≤ 1000, and of z, 0 ≤ z ≤ 1000; or
//! box polar LO HI LO HI           of r, 0 < r ≤ 1, and of s, 0 < s < ½; or
//! box plane LO HI LO HI           of a₁ and of a₂, 0 < a₂ ≤ 1
//! holds period E N                period N occurs, for eµ > 0 (E is +) or eµ < 0 (-), 1 ≤ N ≤ 64; or
//! holds word E N W …              of the periods 1 to N these occur and no others, each W a period and its
//!                                 letter, as in 1D 2U, in order of the periods; or
//! holds chaos E G                 two single-impact orbits coexist for this sign of γ, G; of machines, which
//!                                 have their own, G is left out
//! share P/Q P/Q                   at least and at most this share of the box: the leaves that have it, and
//!                                 all but those that do not
//! 1 or 2 or + or - or ?           the tree, a line for each part, a part before its halves, the lower half
//!                                 before the upper one: cut across the first or the second parameter; a leaf
//!                                 in which the statement holds everywhere, or nowhere; nothing is claimed
//! ```
//!
//! LO, HI are fractions `-?P/Q` in lowest terms of at most 15 digits each, LO ≤ HI. Of a parameter with one
//! value the halves are the same, and each counts as half.
//!
//! # Cost
//!
//! No part is cut off by more than 40 halvings, and no cell asks for more than 64·65/2 signs of N and as
//! many of u before its end; a check that would take more than 10⁷ signs in all is refused before the cell
//! that exceeds it. Memory: 41 parts and 400 numbers.
//!
//! # A certificate by hand
//!
//! ```text
//! box plane -1/1 1/1 1/2 1/2
//! holds period + 2
//! share 1/4 3/4
//! 1
//! 1
//! +
//! ?
//! 1
//! ?
//! -
//! ```
//!
//! The box is a line, a₁ from −1 to 1 at a₂ = ½. u_2 = a₁ and N_{2,1} = a₁ − 1 − a₂ < 0, so that b_{2,1} =
//! N_{2,1}/u_2 is above 0 for a₁ < 0 and below 0 for a₁ > 0; at a₁ = 0 no period 2 occurs. In the first
//! quarter, −1 ≤ a₁ ≤ −½, it occurs, in the last it does not. The two between end where u_2 = 0, and
//! nothing is claimed of them. Damage is found:
//!
//! - `-` in place of the last three lines, and `share 1/4 1/2`: `line 11: false: it does not certainly hold
//!   nowhere in this part`, for there u_2 ≥ 0 has no one sign;
//! - `share 1/4 1/2`: `line 6: false: the parts add up to …`;
//! - `holds period - 2`: `line 9: false: it does not certainly hold everywhere in this part`.

mod cell;
mod text;

use super::{Proved, header, lines::Lines};
use crate::Rejection;
use cell::Cell;

/// The word in the header.
pub const KIND: &str = "share";

/// The most halvings that a part comes from.
pub const DEEPEST: u32 = 40;

/// The largest period that is asked for.
pub const MOST: u64 = 64;

/// The most signs that a check may ask for.
const WORK: u64 = 10_000_000;

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "The listed box is one of parameters (w, z), (r, s) or (a1, a2). To (w, z), for \
machine, belong the trace a1 and the determinant a2 of exp(2 pi w A), A the matrix with the rows (0, 1) and (-1, -2 z), \
and the sign of gamma, that of the entry of exp(2 pi w A) on the upper right; to (r, s), for polar, a1 = 2 r cos 2 pi s \
and a2 = r^2. Let u_0 = 0, u_1 = 1, u_{k+1} = a1 u_k - a2 u_{k-1}, b_{n,k} = (u_n - u_k - a2^k u_{n-k})/u_n, \
p_n = (u_{n+1} - 1)/u_n and q_n = (a2^n + a2 u_{n-1})/u_n. A period n occurs, for a sign of e mu, if u_n is not 0 and \
every b_{n,k} with 0 < k < n has strictly that sign; then its letter is U if p_n > q_n and D if p_n < q_n. In at least \
the first and at most the second listed share of the box, by its area, or by length or number where it has none, what is \
listed holds. period: it occurs for the listed sign of e mu. word: of the periods from 1 to the first number those \
listed occur, with these letters, and no others. chaos: two periods occur with the letter U if the listed sign of e mu \
is that of gamma, the listed sign or for machine its own, and with D if not. Of chaos the second share holds if the \
word theorem does, as stated and proved in the folder proofs of the project and not here.";

/// A part of the box: its place among 2^`halvings` parts along each parameter.
#[derive(Debug, Clone, Copy, Default)]
struct Part {
    index: [u64; 2],
    halvings: [u32; 2],
}

impl Part {
    /// How many halvings it comes from.
    fn depth(&self) -> u32 {
        self.halvings[0] + self.halvings[1]
    }

    /// The lower and the upper half across a parameter.
    fn halves(self, axis: usize) -> [Part; 2] {
        [0, 1].map(|upper| {
            let mut half = self;
            half.index[axis] = 2 * half.index[axis] + upper;
            half.halvings[axis] += 1;
            half
        })
    }
}

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    header::expect_statement(lines, STATEMENT)?;
    let area = lines.line("box", text::Area::read)?;
    let claim = lines.line("holds", |words| text::Claim::read(words, &area))?;
    let whole = 1 << DEEPEST;
    let [lower, upper] = lines.line("share", |words| Ok([words.fraction(whole)?, words.fraction(whole)?]))?;
    let shares_at = lines.number();
    let mut left = WORK;
    // In units of 2^−DEEPEST of the box: where it holds, and where it does not.
    let [mut with, mut without] = [0, 0];
    let mut parts = vec![Part::default()];
    while let Some(part) = parts.pop() {
        let line = lines.expect("a part of the box")?;
        match line.as_str() {
            "1" | "2" => {
                let fits = part.depth() < DEEPEST;
                lines.form(fits, format_args!("a part comes from at most {DEEPEST} halvings"))?;
                let [first, second] = part.halves(usize::from(line == "2"));
                parts.extend([second, first]);
            }
            "+" | "-" => {
                let found = match Cell::of(&area, &part) {
                    Some(mut cell) => cell.holds(&claim, &mut left).map_err(|why| lines.malformed(why))?,
                    None => None,
                };
                let (wanted, where_to) = match line.as_str() {
                    "+" => (true, "everywhere"),
                    _ => (false, "nowhere"),
                };
                let holds = found == Some(wanted);
                lines.claim(holds, format_args!("it does not certainly hold {where_to} in this part"))?;
                *(if wanted { &mut with } else { &mut without }) += whole >> part.depth();
            }
            "?" => {}
            _ => return Err(lines.malformed("expected 1, 2, +, - or ?")),
        }
    }
    lines.end("the file goes on after the last part of the box")?;
    let is = |share: crate::Fraction, area: u64| {
        let (p, q) = share.parts();
        u128::from(p) * u128::from(whole) == u128::from(area) * u128::from(q)
    };
    if !(is(lower, with) && is(upper, whole - without)) {
        let reason = format!("the parts add up to {with} and {} of {whole}", whole - without);
        return Err(Rejection::False { line: shares_at, reason });
    }
    let percent = |hundredths: u128| format!("{}.{:02} %", hundredths / 100, hundredths % 100);
    let of_whole = |area: u64| u128::from(area) * 10_000;
    let least = percent(of_whole(with) >> DEEPEST);
    let most = percent(of_whole(whole - without).div_ceil(u128::from(whole)));
    let detail = vec![
        ("share", format!("{least} to {most} of the box, {lower} to {upper}{}", claim.condition())),
        ("holds there", claim.to_string()),
        ("box", area.to_string()),
    ];
    Ok(Proved::plain(None, detail))
}
