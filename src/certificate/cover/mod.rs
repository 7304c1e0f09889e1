//! Certificates of kind `cover`: Conjecture 1 for single periods, r ≤ r_max.

mod areas;
pub mod expansion;
pub mod fixed;
mod leaf;
mod regions;
mod strips;
mod tree;

use std::{io::BufRead, ops::RangeInclusive};

pub use leaf::Leaf;

use super::{
    Checked, Rejection,
    arithmetic::{Fraction, inverse},
    header::{self, Header},
    lines::{Lines, Words, number},
    theorem2::Theorem,
};
use areas::Top;
use expansion::Form;
use strips::Strip;
use tree::Fault;

/// The word in the header.
pub const KIND: &str = "cover";

/// The largest period a certificate of this kind may speak of.
pub const MOST: u64 = 256;

/// The largest denominator of r_max.
pub const FINEST: u64 = 1 << 40;

/// The longest line of trees.
const LONGEST: u64 = 1 << 26;

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "For every period n in the range, with the r_max of its block: let an orbit exist at a point if u_n is not 0 there and (52) \
and (53) hold for some signs of e*mu and gamma. In region 2 an orbit exists everywhere, in the case (-,+). In region 4 (a2 < 1) none exists for \
even n; for odd n one exists exactly where b_{n,n-2} > 0, in the case (+,-), and that set is connected. The points of region 3 with r <= r_max \
at which an orbit exists lie in the areas of Theorem 2's intervals: each interval of s holds exactly one, which is connected, meets r = r_max in one \
interval, has the case of the interval throughout, and inside the strip of its interval is bounded by b_{n,d} = 0 alone, where no other b_{n,k} is 0, \
d being the index that Conjecture 1 names; the area of (0, 1/(2n)) is that whole strip. On s = 1/2, the common edge of regions 3 and 4, \
the two agree and, for odd n, meet. Nothing is claimed for r_max < r < 1.";

/// The header's lines for a range of periods with `lines` lines after it.
pub fn header(range: &RangeInclusive<u64>, lines: u64) -> String {
    header::text(KIND, STATEMENT, range, lines)
}

/// What is left open in the blocks of a certificate.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Open {
    leaves: u64,
    /// Their area in r and s, in units of 2⁻⁶⁰.
    area: u128,
    /// The line of the first.
    line: u64,
}

/// Checks everything after the kind line.
pub(super) fn check<R: BufRead>(lines: &mut Lines<R>) -> Result<Checked, Rejection> {
    let header = Header::read(lines, 3..=MOST, STATEMENT)?;
    let mut open = Open::default();
    for n in header.range() {
        block(lines, n, &mut open)?;
    }
    let checked = header.finish(lines, KIND, STATEMENT)?;
    open.rejection().map_or(Ok(checked), Err)
}

/// Checks the block of one period, `text` being its lines from `n N …` on, which `before` lines come before.
///
/// Blocks are independent: a certificate is proved if its header and all its blocks are. Cost: O(n³) small operations for the
/// regions 2 and 4, O(log n) products for a None leaf, O(n) for every other.
///
/// # Errors
/// As [`check`](super::check).
pub fn check_block(n: u64, text: &[u8], before: u64) -> Result<(), Rejection> {
    let mut lines = Lines::after(before, text);
    if !(3..=MOST).contains(&n) {
        return Err(lines.malformed(format!("n = {n} is not from 3 to {MOST}")));
    }
    let mut open = Open::default();
    block(&mut lines, n, &mut open)?;
    if lines.next()?.is_some() {
        return Err(lines.malformed(format!("the block of n = {n} has ended")));
    }
    open.rejection().map_or(Ok(()), Err)
}

impl Open {
    fn rejection(&self) -> Option<Rejection> {
        let area = self.area as f64 / 2f64.powi(60);
        (self.leaves > 0).then(|| Rejection::Undecided {
            line: self.line,
            reason: format!(
                "all else being proved, {} leaves are open, area {area:e} in (r, s)",
                self.leaves
            ),
        })
    }
}

fn block<R: BufRead>(lines: &mut Lines<R>, n: u64, open: &mut Open) -> Result<(), Rejection> {
    let line = lines.expect("the block of a period")?;
    let (r_max, leaves) = block_header(&line, n).map_err(|reason| lines.malformed(reason))?;
    let header_at = lines.number();
    for (name, holds) in
        [("region2", regions::region2 as fn(u64) -> bool), ("region4", regions::region4 as fn(u64) -> bool)]
    {
        if lines.expect("an identity")? != format!("identity {name}") {
            return Err(lines.malformed(format!("expected \"identity {name}\"")));
        }
        if !holds(n) {
            return Err(lines.false_claim(format!("the identity of {name} does not hold")));
        }
    }
    let rows = strips::rows(r_max);
    let mut found = 0;
    for strip in strips::strips(n).map_err(|reason| lines.false_claim(reason))? {
        if lines.expect("a strip")? != format!("strip {} {}", strip.left, strip.right) {
            return Err(lines.malformed(format!("expected \"strip {} {}\"", strip.left, strip.right)));
        }
        let text = lines.expect_within(LONGEST, "the trees of a strip")?;
        found += check_strip(n, &strip, &rows, &text, open, lines.number()).map_err(|fault| match fault {
            Fault::Malformed(reason) => lines.malformed(reason),
            Fault::False(reason) => lines.false_claim(reason),
        })?;
    }
    if found != leaves {
        let reason = format!("the block has {found} leaves, not {leaves}");
        return Err(Rejection::Malformed { line: header_at, reason });
    }
    Ok(())
}

/// r_max and the number of leaves.
fn block_header(line: &str, n: u64) -> Result<(Fraction, u64), String> {
    let mut words = Words::new(line);
    if words.word("n")? != "n" || words.number("the period", MOST)? != n {
        return Err(format!("expected the block of n = {n}"));
    }
    let r_max = words.fraction(FINEST)?;
    let (p, q) = r_max.parts();
    if p == 0 || p == q {
        return Err("expected 0 < r_max < 1".into());
    }
    let leaves = words.number("the number of leaves", u64::MAX)?;
    words.end()?;
    Ok((r_max, leaves))
}

/// Checks all leaves of a strip and, if none is open, the strip's part of the conclusion; the number of leaves.
fn check_strip(
    n: u64,
    strip: &Strip,
    rows: &[[i64; 2]],
    text: &str,
    open: &mut Open,
    line: u64,
) -> Result<u64, Fault> {
    let form = if strip.outermost { Form::Quotient } else { Form::Sine };
    let mut top = Top::new(rows.last().expect("there is a row")[1]);
    let (mut leaves, mut complete) = (0, true);
    tree::walk(text, n, strip.units, rows, |leaf, cell| {
        leaves += 1;
        strip.allows(&leaf)?;
        leaf.prove(n, &cell, form)?;
        if leaf == Leaf::Open {
            complete = false;
            if open.leaves == 0 {
                open.line = line;
            }
            open.leaves += 1;
            open.area += ((cell.r[1] - cell.r[0]) as u128 * u128::from(cell.s[1] - cell.s[0])) >> 64;
        }
        top.add(leaf, cell);
        Ok(())
    })?;
    if let (true, Some(_)) = (complete, &strip.interval) {
        top.is_one_interval().map_err(|reason| {
            Fault::False(format!(
                "the leaves of ({}, {}) are not one area: {reason}",
                strip.left, strip.right
            ))
        })?;
    }
    Ok(leaves)
}
