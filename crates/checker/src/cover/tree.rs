//! Bisection trees: the boxes of a strip, which tile it by construction.

use super::{Fault, expansion::Cell, leaf::Leaf};

/// A box with a side of fewer units is not split.
const LEAST: i64 = 4;

/// Walks the trees of a strip's rows, one after the other in `text`, and hands every leaf with its box to
/// `visit`.
///
/// A split halves the box at its midpoint, rounded down to a unit: the halves share that side, and the
/// leaves' closed boxes cover the row. Memory: a box for each halving above the present one, of which there
/// are at most 60 + 63.
pub(super) fn walk(
    text: &str,
    n: u64,
    strip: [u64; 2],
    rows: &[[i64; 2]],
    mut visit: impl FnMut(Leaf, Cell) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let (mut rest, mut latest) = (text, None);
    let malformed = |rest: &str, reason: String| {
        Err(Fault::Malformed(format!("column {}: {reason}", text.len() - rest.len() + 1)))
    };
    for &row in rows {
        // A stack, not recursion: its depth is bounded by the halvings of the sides, whatever the text says.
        let mut pending = vec![Cell { r: row, s: strip }];
        while let Some(cell) = pending.pop() {
            let (r, s) = (cell.r, cell.s);
            match rest.as_bytes().first() {
                Some(b'r') if r[1] - r[0] >= LEAST => {
                    let middle = r[0] + (r[1] - r[0]) / 2;
                    pending.extend([Cell { r: [middle, r[1]], s }, Cell { r: [r[0], middle], s }]);
                    rest = &rest[1..];
                }
                Some(b's') if s[1] - s[0] >= LEAST as u64 => {
                    let middle = s[0] + (s[1] - s[0]) / 2;
                    pending.extend([Cell { r, s: [middle, s[1]] }, Cell { r, s: [s[0], middle] }]);
                    rest = &rest[1..];
                }
                Some(b'r' | b's') => return malformed(rest, "the box is too small to be split".into()),
                _ => {
                    let (leaf, after) = match Leaf::read(rest, n, &mut latest) {
                        Ok(read) => read,
                        Err(reason) => return malformed(rest, reason),
                    };
                    visit(leaf, cell).map_err(|fault| {
                        let column = text.len() - rest.len() + 1;
                        let token = rest[..rest.len() - after.len()].trim_end_matches(';');
                        fault.at(format!("column {column}, {token} on {}", shown(&cell)))
                    })?;
                    rest = after;
                }
            }
        }
    }
    if rest.is_empty() {
        Ok(())
    } else {
        malformed(rest, "the line goes on after the last row's tree".into())
    }
}

/// A box in decimals, for messages.
pub(super) fn shown(cell: &Cell) -> String {
    let [r, s] = [cell.r.map(|r| r as f64 / 2f64.powi(60)), cell.s.map(|s| s as f64 / 2f64.powi(64))];
    format!("[{}, {}] x [{}, {}]", r[0], r[1], s[0], s[1])
}
