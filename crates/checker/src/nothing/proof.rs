//! All conditions over all cells.

use std::ops::Range;

use super::{Fault, Interval, born, text::Certificate};
use crate::{
    rejection::{GoOn, claim},
    touch::{
        flow::Matrix,
        legs::Cell,
        near::{Near, anything},
        wall::Wall,
    },
};

/// Proves everything in some cells; T if the first is among them.
pub(super) fn cells(certificate: &Certificate, which: Range<usize>, go_on: GoOn) -> Result<(), Fault> {
    let harmonics = certificate.harmonics.iter();
    let harmonics =
        harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
    let wall = Wall::new(harmonics.collect(), certificate.window.enclosed(), certificate.pieces, go_on)?;
    let [damping, stiffness, restitution] =
        certificate.ranges.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()));
    let cell = |depth: Interval| {
        let parameters = [damping, stiffness, Interval::ZERO, restitution, depth];
        Cell::new(certificate.mirrored, parameters, Interval::ONE, &wall)
    };
    for index in which {
        let block = certificate.cells[index];
        let least =
            index.checked_sub(1).map_or(Interval::ZERO, |before| certificate.cells[before].depth.enclosed());
        let cell = cell(least.hull(block.depth.enclosed()));
        let turns: Vec<Matrix> = (0..=certificate.longest).map(|n| cell.turned(n)).collect();
        let mut prove = || {
            if index == 0 {
                born::nothing(&cell, &turns, go_on)?;
            }
            let strength = block.strength.enclosed();
            let strengths = (-strength).hull(strength);
            let near = Near { cell: &cell, turns: &turns, strengths, parts: block.parts };
            near.bounded(certificate.longest)?;
            empties(&near, certificate, go_on)
        };
        prove().map_err(|fault| fault.at(format!("cell {} of {}", index + 1, certificate.cells.len())))?;
    }
    Ok(())
}

/// C3 leaves no legs.
fn empties(near: &Near, certificate: &Certificate, go_on: GoOn) -> Result<(), Fault> {
    let mut known = anything(certificate.longest);
    for round in 0..certificate.rounds {
        known = near.narrowed(&known, round == 0, go_on)?;
        if known.iter().all(Option::is_none) {
            return Ok(());
        }
    }
    let left = known.iter().position(Option::is_some).map_or(0, |n| n + 1);
    claim(false, format_args!("there may be a leg of {left} periods (C)"))
}
