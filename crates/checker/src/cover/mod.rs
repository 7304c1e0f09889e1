//! Certificates of kind `cover`: Conjecture 1 for single periods n, in regions 2 and 4 and in region 3 up to
//! r = r_max < 1.
//!
//! # What is proved, and how
//!
//! In region 3 the eigenvalues are r e^{±iθ}, θ = 2πs. With N_{n,k} = u_n − u_k − a₂^k u_{n−k}, (59) and (60)
//! read b_{n,k} = N_{n,k}/u_n and c_n = −|1 − rⁿe^{inθ}|²/u_n, and by (62) N_{n,k} = r^{k−1} T_k/sin θ with
//!
//! ```text
//! T_k(r, θ) = r^{n−k} sin nθ − rⁿ sin (n−k)θ − sin kθ.
//! ```
//!
//! T_k/sin θ is a polynomial in r and cos θ, so that s = 0 and s = ½ are no exception. Where u_n ≠ 0, (52)
//! and (53) hold for some signs exactly if all T_k have one strict sign t (for r > 0; a box that touches r =
//! 0 says nothing of that line), and then for sign γ = −t and sign eµ = t sign u_n.
//!
//! - *Strips.* [0, ½] is cut at all multiples of 1/(2n), where u_n = 0, and at the ends of Theorem 2's
//!   intervals. The checker computes these cuts and sees that each interval is exactly one strip, so that u_n
//!   has one sign in it, and (52), (53) one case. The singular lines u_n = 0 are sides of boxes, never
//!   inside: the N of a leaf at such a line keep their signs on both its sides, and the case changes across
//!   it with the sign of u_n.
//! - *Leaves.* Every strip is covered by boxes, of each of which a claim is proved (`leaf`): no orbit (None);
//!   all T_k of one sign (Orbit); or one T_d decides and grows with r (Edge). Taylor's formula of second
//!   order, with a bound of the rest, proves them (`expansion`), in integer arithmetic (`fixed`).
//! - *Areas.* In a strip that is no interval only None leaves may stand. In one that is, the Orbit and Edge
//!   leaves must have its t and d; they form one area that reaches up to r_max (`areas`). All leaves of the
//!   strip (0, 1/(2n)) must be Orbit leaves. Two intervals touch only where u_n = 0; the other ends of an
//!   interval are in the closed boxes of a neighbour whose leaves are all None. So no two of the areas are
//!   joined.
//! - *Regions 2 and 4* take no boxes: there, polynomial identities decide (`regions`). On s = ½ both charts
//!   speak of the same orbits; for odd n the row at the top of the last strip ends there in an Orbit leaf, or
//!   the area would not be one interval, so that the areas of regions 3 and 4 are joined.
//!
//! Nothing is taken from the proof of Conjecture 1, and nothing is claimed for r_max < r < 1. The least r of
//! every area of Theorem 2's intervals is below 1 − 4.9/n³ as far as is known; were r_max below it, the area
//! would be missing at r_max and the certificate rejected.
//!
//! # Boxes
//!
//! The rows of a strip are 0 ≤ r ≤ 1/2, 1/2 ≤ r ≤ 3/4, 3/4 ≤ r ≤ 7/8, …, the last one up to r_max. Strip ×
//! row is the root of a tree of halvings. The checker rounds: it takes r in units of 2⁻⁶⁰ and s in units of
//! 2⁻⁶⁴, the ends of a strip and r_max outwards, midpoints down. So it covers a little more than the strip,
//! by boxes that have their sides in common.
//!
//! # Form
//!
//! ```text
//! range A B                            after the kind line: the periods, 3 ≤ A ≤ B ≤ 256
//! lines L                              the number of lines after the header
//! statement …                          what passing proves, word for word: STATEMENT
//!
//! n N RMAX COUNT                       for each period in turn, with r_max, a fraction 0 < p/q < 1, q ≤
//!                                      2^40, and the number of leaves
//! identity region2                     N_{n,k} < 0 for all k in region 2
//! identity region4                     none in region 4 for even n; for odd n, b_{n,n-2} > 0 decides
//! strip P/Q P/Q                        the next strip of s, from 0/1 to 1/2
//! TREES                                the trees of its rows, r = 0 to 1/2, 1/2 to 3/4, … up to r_max, in
//!                                      preorder: one line of at most 2^24 bytes
//!
//! r                                    the box is halved in r; the lower half's tree, then the upper one's
//! s                                    the box is halved in s; the left half's tree, then the right one's
//! NK,K';                               N_{n,K} > 0 > N_{n,K'} on the closed box: no orbit
//! n                                    the same again: NK,K'; with the K and K' of the last one before it in
//!                                      TREES; malformed if there is none
//! P;  M;                               all N_{n,k} > 0 (P) or < 0 (M)
//! pK; pKl; pKr;  mK; mKl; mKr;         N_{n,K} > 0 (p) or < 0 (m) decides, the more so for larger r; for
//!                                      smaller (l) or larger (r) s
//! O;                                   open: nothing is claimed, and the statement is not proved
//! ```
//!
//! # Rules
//!
//! - *Strips*: between neighbours among the multiples of 1/(2n) in [0, ½] and the ends of Theorem 2's
//!   intervals ([`theorem2`](super::theorem2) lists them).
//! - *Rows*: [1 − 2^−j, 1 − 2^−(j+1)], j = 0, 1, …, while the upper end is below r_max, then one up to r_max.
//!   A box of fewer than 4 units (2⁻⁶⁰ of r, 2⁻⁶⁴ of s) is not halved.
//! - *Form of the sines*: in the first strip and the last one, whose closed boxes may touch s = 0 and s = ½,
//!   the claims are proved of T_k/(n sin θ), in all others of T_k (`expansion`).
//! - *Leaves allowed*: in a strip that is no interval of Theorem 2, None and Open. In one that is, t = −1
//!   (`M`, `m`) where GAMMA = + and t = 1 (`P`, `p`) where GAMMA = −; the deciding index of an Edge leaf is n
//!   − n₊ in the interval (m₊/n₊, m/n), n₊ in the interval (m/n, (m − m₊)/(n − n₊)), where m n₊ ≡ 1 modulo n,
//!   1 ≤ n₊ ≤ n; in (0, 1/(2n)) only Orbit and Open leaves.
//! - *Top row*: of the leaves that end at r_max in a strip that is an interval, the Orbit and Edge leaves are
//!   neighbours and read from left to right: Edge leaves with `r`, at least one Orbit leaf, Edge leaves with
//!   `l`. For odd n the last strip's end with an Orbit leaf, at s = ½.
//! - With Open leaves and nothing false the answer is neither proved nor rejected but undecided.
//!
//! # Cost
//!
//! O(n³) small operations per period, O(n) products per leaf that is no None leaf and per side of a box.
//! Memory: a line of trees, the sides of up to 2048 boxes (O(n) numbers each), and the boxes above the
//! present one.
//!
//! # One block by hand
//!
//! Period 3 up to r = 2/3 (the lowest point of the area of (1/3, 1/2) has r = 1/2):
//!
//! ```text
//! n 3 2/3 22
//! identity region2
//! identity region4
//! strip 0/1 1/6
//! sM;M;sM;M;
//! strip 1/6 1/3
//! ssM;m2;sm2;rN2,1;snnsM;m2l;
//! strip 1/3 1/2
//! sN2,1;snrnp1;ssnp1r;sp1r;sp1r;rp1;P;
//! ```
//!
//! T_1 = r² sin 3θ − r³ sin 2θ − sin θ and T_2 = r sin 3θ − r³ sin θ − sin 2θ. There are two rows, [0, 1/2]
//! and [1/2, 2/3]. In the first strip both rows are halved in s, and both T are < 0 on all four boxes: (−,+).
//! In the second strip, the interval (1/6, 1/3) with t = −1 and d = 2, the first row is quartered in s: on
//! [1/6, 5/24] both T are < 0; on [5/24, 1/4] and [1/4, 7/24], the latter halved once more, T_2 decides: at r
//! = 0, T_2 = −sin 2θ changes sign at s = 1/4. Near s = 1/3 there is no orbit: N2,1 and, for the same again,
//! n. At the top, M and m2l: an orbit up to s = 1/4, and from there to 1/3 an end of it, for −T_2 falls with
//! s. In the third strip, t = 1 and d = 1, the top reads None, three Edge leaves where T_1 grows with s, and
//! at s = 1/2 an Orbit leaf above an Edge leaf.
//!
//! Damage is found:
//!
//! - 22 leaves changed to 21: `line 6: malformed: the block has 22 leaves, not 21`;
//! - the first strip `sM;M;sM;M;` to `M;M;`:
//!   `line 10: false: column 1, M on [0, 0.5] x [0, 0.16666666666666666]: the sign of N_{3,1} is not shown`,
//!   for the box is too large for a parabola;
//! - `sM;m2l;` to `sM;m2;`: `line 12: false: the leaves of (1/6, 1/3) are not one area: at the top, the leaf
//!   on [0.5, 0.6666666666666666] x [0.25, 0.3333333333333333] is out of order`;
//! - `rN2,1;snn` to `rnsnn`, the first None leaf of the strip:
//!   `line 12: malformed: column 13: n without an N before it`;
//! - the last leaf `P;` to `M;`: `line 14: false: column 35, M on [0.5833333333333334, 0.6666666666666666] x
//!   [0.4791666666666667, 0.5]: the sign or the deciding index is not that of the strip's interval`.

mod areas;
pub mod expansion;
pub mod fixed;
mod leaf;
mod regions;
mod strips;
mod tree;

use std::{
    collections::{HashMap, hash_map::Entry},
    hash::{BuildHasherDefault, Hash, Hasher},
    ops::RangeInclusive,
};

pub use leaf::Leaf;

use super::{
    Proved, Rejection,
    arithmetic::{Fraction, Multiple, inverse},
    header::{self, Header},
    lines::{Lines, Words, number},
    rejection::Fault,
    theorem2::Theorem,
};
use crate::rejection::ensure;
use areas::Top;
use expansion::{Cell, Form, Patch, Powers, Waves};
use strips::Strip;

/// The word in the header.
pub const KIND: &str = "cover";

/// The largest period a certificate of this kind may speak of.
pub const MOST: u64 = 256;

/// The largest denominator of r_max.
pub const FINEST: u64 = 1 << 40;

/// The longest line of trees, in bytes.
const LONGEST: usize = 1 << 24;

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "For every period n in the range, with the r_max of its block, let an orbit exist at a point if u_n is not 0 \
there and (52) and (53) hold for some signs of e*mu and gamma. In region 2 (a2 < 1) an orbit exists everywhere, in the case (-,+). In region 4 (a2 < 1) \
none exists for even n; for odd n one exists exactly where b_{n,n-2} > 0, in the case (+,-), and that set is connected. In region 3 with 0 < r <= r_max \
orbits exist only for s in Theorem 2's intervals; in each interval they have its case and form one area: a connected set, which contains with every point \
all higher ones up to r_max, meets r = r_max in one interval, and is bounded inside the strip of its interval by b_{n,d} = 0 alone, d being \
the index that Conjecture 1 names, and no other b_{n,k} is 0 there; for (0, 1/(2n)) it is the whole strip. On s = 1/2, the common edge of regions 3 and \
4, both agree, and for odd n the last area goes on there from one into the other. Nothing is claimed for r_max < r < 1.";

/// The header's lines for a range of periods with `lines` lines after it.
pub fn header(range: &RangeInclusive<u64>, lines: u64) -> String {
    header::text(KIND, STATEMENT, range, lines)
}

/// What is left open in the blocks of a certificate.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Open {
    leaves: u64,
    /// Their area in r and s, as an integer and the rest in units of 2⁻¹²⁴. Up to 254 periods leave open up
    /// to about ½ each.
    area: (u32, u128),
    /// The line of the first.
    line: u64,
}

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let header = Header::read(lines, 3..=MOST, STATEMENT)?;
    let mut open = Open::default();
    let mut r_max = Vec::new();
    for n in header.range() {
        r_max.push((n, block(lines, n, &mut open)?));
    }
    let proved = header.finish(lines)?;
    match open.rejection() {
        Some(rejection) => Err(rejection),
        None => Ok(Proved { detail: vec![("r_max", in_words(&r_max))], ..proved }),
    }
}

/// The r_max of every period.
fn in_words(all: &[(u64, Fraction)]) -> String {
    let before = |a: Fraction, b: Fraction| {
        let ((p, q), (u, v)) = (a.parts(), b.parts());
        u128::from(p) * u128::from(v) < u128::from(u) * u128::from(q)
    };
    let (mut least, mut most) = (all[0], all[0]);
    for &one in all {
        least = if before(one.1, least.1) { one } else { least };
        most = if before(most.1, one.1) { one } else { most };
    }
    if least == most {
        return least.1.to_string();
    }
    let rule = all.iter().all(|&(n, r_max)| r_max.parts() == (n.pow(3) - 1, n.pow(3)));
    let rule = if rule { "1 - 1/n^3, " } else { "" };
    format!("{rule}from {} (n = {}) to {} (n = {})", least.1, least.0, most.1, most.0)
}

/// Checks the block of one period, `text` being its lines from `n N …` on, which `before` lines come before.
///
/// Blocks are independent: a certificate is proved if its header and all its blocks are. Cost: O(n³) small
/// operations for the regions 2 and 4, O(n) products for every interval of r and, at s = 0 and s = ½, of s;
/// O(1) for a None leaf, O(n) for an Orbit or Edge leaf.
///
/// # Errors
/// As [`check`](super::check).
#[inline(never)]
pub fn check_block(n: u64, text: &[u8], before: u64) -> Result<(), Rejection> {
    let (mut text, mut never) = (text, || false);
    let mut lines = Lines::after(before, &mut text, &mut never);
    lines.form((3..=MOST).contains(&n), format_args!("n = {n} is not from 3 to {MOST}"))?;
    let mut open = Open::default();
    block(&mut lines, n, &mut open)?;
    lines.end(format_args!("the block of n = {n} has ended"))?;
    open.rejection().map_or(Ok(()), Err)
}

impl Open {
    /// Takes note of an open box in the strip of trees at a line.
    fn add(&mut self, cell: Cell, line: u64) {
        if self.leaves == 0 {
            self.line = line;
        }
        self.leaves += 1;
        // At most 2⁶⁰·2⁶³, so that the carry is at most 1.
        let area = (cell.r[1] - cell.r[0]) as u128 * u128::from(cell.s[1] - cell.s[0]) + self.area.1;
        self.area = (self.area.0 + (area >> 124) as u32, area & ((1 << 124) - 1));
    }

    fn rejection(&self) -> Option<Rejection> {
        let area = f64::from(self.area.0) + self.area.1 as f64 / 2f64.powi(124);
        (self.leaves > 0).then(|| Rejection::Undecided {
            line: self.line,
            reason: format!(
                "all else being proved, {} leaves are open, area {area:e} in (r, s)",
                self.leaves
            ),
        })
    }
}

/// Checks a block; its r_max.
fn block(lines: &mut Lines, n: u64, open: &mut Open) -> Result<Fraction, Rejection> {
    let line = lines.expect("the block of a period")?;
    let (r_max, leaves) = block_header(&line, n).map_err(|reason| lines.malformed(reason))?;
    let header_at = lines.number();
    for (name, holds) in
        [("region2", regions::region2 as fn(u64) -> bool), ("region4", regions::region4 as fn(u64) -> bool)]
    {
        let line = lines.expect("an identity")?;
        lines.form(line == format!("identity {name}"), format_args!("expected \"identity {name}\""))?;
        lines.claim(holds(n), format_args!("the identity of {name} does not hold"))?;
    }
    let rows = strips::rows(r_max);
    let mut powers = Known(HashMap::default());
    let mut found = 0;
    for strip in strips::strips(n).map_err(|reason| lines.false_claim(reason))? {
        let line = lines.expect("a strip")?;
        let holds = line == format!("strip {} {}", strip.left, strip.right);
        lines.form(holds, format_args!("expected \"strip {} {}\"", strip.left, strip.right))?;
        let text = lines.expect_within(LONGEST, "the trees of a strip")?;
        found += check_strip(n, &mut powers, &strip, &rows, &text, open, lines)
            .map_err(|fault| lines.rejection(fault))?;
    }
    if found != leaves {
        let reason = format!("the block has {found} leaves, not {leaves}");
        return Err(Rejection::Malformed { line: header_at, reason });
    }
    Ok(r_max)
}

/// What is computed once for many boxes, by their bounds of r or of s: they have most of them in common.
struct Known<K, V>(HashMap<K, V, BuildHasherDefault<Mixed>>);

/// A quick hash of a pair of bounds. Where it is poor, only time is lost.
#[derive(Default)]
struct Mixed(u64);

impl Hasher for Mixed {
    fn write(&mut self, bytes: &[u8]) {
        for word in bytes.chunks_exact(8) {
            let word = u64::from_le_bytes(word.try_into().expect("8 bytes"));
            self.0 = (self.0.rotate_left(29) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        }
    }

    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 32)
    }
}

/// How much of it is held at most.
const HELD: usize = 1 << 10;

impl<K: Copy + Eq + Hash, V> Known<K, V> {
    fn get(&mut self, bounds: K, make: impl FnOnce(K) -> Result<V, String>) -> Result<&V, String> {
        if self.0.len() == HELD {
            self.0.clear();
        }
        Ok(match self.0.entry(bounds) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(place) => place.insert(make(bounds)?),
        })
    }
}

/// r_max and the number of leaves.
fn block_header(line: &str, n: u64) -> Result<(Fraction, u64), String> {
    let mut words = Words::new(line);
    let holds = words.word("n")? == "n" && words.number("the period", MOST)? == n;
    ensure(holds, format_args!("expected the block of n = {n}"))?;
    let r_max = words.fraction(FINEST)?;
    let (p, q) = r_max.parts();
    ensure(p > 0 && p < q, "expected 0 < r_max < 1")?;
    let leaves = words.number("the number of leaves", u64::MAX)?;
    words.end()?;
    Ok((r_max, leaves))
}

/// Checks all leaves of a strip and, if none is open, the strip's part of the conclusion; the number of
/// leaves.
fn check_strip(
    n: u64,
    powers: &mut Known<[i64; 2], Powers>,
    strip: &Strip,
    rows: &[[i64; 2]],
    text: &str,
    open: &mut Open,
    lines: &mut Lines,
) -> Result<u64, Fault> {
    let form = if strip.outermost { Form::Quotient } else { Form::Sine };
    let mut top = Top::new(rows.last().expect("there is a row")[1]);
    let mut waves = Known(HashMap::default());
    let (mut leaves, mut complete) = (0, true);
    tree::walk(text, n, strip.units, rows, |leaf, cell| {
        lines.go_on()?;
        leaves += 1;
        strip.allows(&leaf).map_err(Fault::False)?;
        let powers = powers.get(cell.r, |r| Powers::new(n, r)).map_err(Fault::False)?;
        let waves = waves.get(cell.s, |s| Waves::new(n, s, form)).map_err(Fault::False)?;
        leaf.prove(&Patch::new(powers, waves)).map_err(Fault::False)?;
        if leaf == Leaf::Open {
            complete = false;
            open.add(cell, lines.number());
        }
        top.add(leaf, cell);
        Ok(())
    })?;
    if complete && strip.interval.is_some() {
        // Where the area must go on beyond s = ½.
        let reach = (n % 2 == 1 && strip.right == Fraction::HALF).then_some(strip.units[1]);
        top.is_one_interval(reach).map_err(|reason| {
            Fault::False(format!(
                "the leaves of ({}, {}) are not one area: {reason}",
                strip.left, strip.right
            ))
        })?;
    }
    Ok(leaves)
}
