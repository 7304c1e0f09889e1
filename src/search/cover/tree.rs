//! A strip's bisection trees: grown, written, and walked again.

use super::super::Instance;
use super::{
    chart::{Axis, Cell, Chart},
    claim::{Judge, Verdict},
};
use crate::{
    certificate::cover::Leaf,
    error::{Error, Result},
};

/// Boxes met in one strip before the rest is left open: hundreds of times what any strip of a period up to
/// 128 needs.
const BUDGET: u32 = 1 << 16;

/// The trees of a strip's rows as text: `r` or `s` for a split, then its two parts; leaves as [`Leaf::write`]
/// has them. Boxes still undecided after `max_depth` splits become Open leaves. Where the claim for the strip
/// seems to be false, `refutes` is asked; a point at which it is false ends the search and is returned
/// instead. Cost: O(n) for each box met.
pub(super) fn grow(
    mut judge: Judge,
    max_depth: u32,
    refutes: impl Fn(&Cell) -> Option<Instance>,
) -> std::result::Result<String, Box<Instance>> {
    let (mut text, mut latest, mut met) = (String::new(), None, 0);
    for row in 0..judge.chart.rows() {
        let mut stack = vec![Cell::root(row)];
        while let Some(cell) = stack.pop() {
            met += 1;
            if met > BUDGET {
                Leaf::Open.write(&mut text, &mut latest);
                continue;
            }
            let (verdict, suspect) = judge.judge(&cell, latest);
            if suspect && let Some(case) = refutes(&cell) {
                return Err(Box::new(case));
            }
            match verdict {
                Verdict::Leaf(leaf) if !suspect => leaf.write(&mut text, &mut latest),
                Verdict::Split(axis) if cell.depth() < max_depth => {
                    text.push(if axis == Axis::R { 'r' } else { 's' });
                    let [first, second] = cell.halves(axis);
                    stack.extend([second, first]);
                }
                _ => Leaf::Open.write(&mut text, &mut latest),
            }
        }
    }
    Ok(text)
}

/// Calls `visit` with every leaf of the trees of period `n` on a chart, and its box.
///
/// # Errors
/// An input error if the text is no such trees.
pub(crate) fn walk(text: &str, n: u64, chart: &Chart, mut visit: impl FnMut(Leaf, Cell)) -> Result<()> {
    let malformed = || Error::input("the text is not that of a strip's trees");
    let (mut rest, mut latest) = (text, None);
    for row in 0..chart.rows() {
        let mut stack = vec![Cell::root(row)];
        while let Some(cell) = stack.pop() {
            let axis = match rest.as_bytes().first() {
                Some(b'r') => Axis::R,
                Some(b's') => Axis::S,
                _ => {
                    let (leaf, after) = Leaf::read(rest, n, &mut latest).map_err(|_| malformed())?;
                    visit(leaf, cell);
                    rest = after;
                    continue;
                }
            };
            if cell.depth() >= 120 || cell.r.1.max(cell.s.1) >= 60 {
                return Err(malformed());
            }
            rest = &rest[1..];
            let [first, second] = cell.halves(axis);
            stack.extend([second, first]);
        }
    }
    if rest.is_empty() { Ok(()) } else { Err(malformed()) }
}
