//! Where what is born beyond a touch is proved: that there is nothing else near, cell by cell.
//!
//! Near reaches as far as the strengths of what is born, and farther where the checker can be shown that; the
//! claims are added to the cells that have them from the touch on.

use super::{close::Budget, map::Oscillator, nothing::longest, write};
use crate::{
    certificate::range::{Alone, Certificate, Others, others_hold},
    error::Result,
    monitor::Monitor,
    search::chaos::write::decimal,
};

/// S, in the greatest |s| of the cell, from the widest; what is cut into how many parts, from the coarsest.
const WIDER: [f64; 4] = [1.5, 1.3, 1.1, 1.02];
const PARTS: [[u64; 2]; 4] = [[2, 1], [4, 1], [4, 4], [8, 4]];
/// Rounds of C3, and of F.
const ROUNDS: u64 = 8;

/// The certificate with claims that there are no others, in as many cells from the touch on as have one; none
/// if the first has none. Strengths and parts that did for a cell are tried first for the next.
pub(super) fn alone(
    certificate: &Certificate,
    oscillator: &Oscillator,
    budget: &mut Budget,
    monitor: &dyn Monitor,
) -> Result<Option<Certificate>> {
    let periods: Vec<u64> = certificate.letters.iter().map(|letter| letter.periods).collect();
    let distinct = (1..periods.len()).all(|n| !periods[..n].contains(&periods[n]));
    let Some(longest) = longest(oscillator).filter(|_| certificate.behind && distinct) else {
        return Ok(None);
    };
    let mut found = Certificate { alone: Some(Alone { longest, rounds: ROUNDS }), ..certificate.clone() };
    let mut first = [0, 0];
    for cell in 0..found.cells.len() {
        let ways =
            (first[1]..PARTS.len()).flat_map(|cut| (first[0]..WIDER.len()).map(move |wide| [wide, cut]));
        let mut held = None;
        for [wide, cut] in ways {
            monitor.advance(0)?;
            let strength = decimal((greatest(&found, cell) * WIDER[wide] * 1000.0).ceil() / 1000.0, 3)?;
            let [parts, slices] = PARTS[cut];
            found.cells[cell].others = Some(Others { strength, parts, slices });
            if others_hold(&found, cell, &mut || budget.stops()).is_ok() {
                held = Some([wide, cut]);
            }
            if held.is_some() || budget.is_spent() {
                break;
            }
        }
        let Some(way) = held else {
            found.cells[cell].others = None;
            break;
        };
        first = way;
    }
    Ok(found.cells[0].others.is_some().then_some(found))
}

/// The greatest |s| of a cell's edges.
fn greatest(certificate: &Certificate, cell: usize) -> f64 {
    let ends = certificate.cells[cell].edges.iter().flat_map(|edge| edge.strengths);
    ends.map(|end| write::float(end).abs()).fold(0.0, f64::max)
}
