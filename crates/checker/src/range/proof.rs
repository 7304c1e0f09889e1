//! All conditions over all cells, and from each cell to the next.

use std::ops::Range;

use super::{
    Fault, Interval, Lines, Rejection, gaps, link,
    others::{self, Room},
    problem::Problem,
    text::{Cell as Block, Certificate},
    work::{Numbers, Work, numbers},
};
use crate::{rejection::GoOn, touch::wall::Wall};

impl Problem<'_> {
    /// That there are no others at these depths, if that is claimed.
    fn alone(
        &self,
        certificate: &Certificate,
        depths: Interval,
        block: &Block,
        numbers: &[Numbers],
        room: &mut Room,
        go_on: GoOn,
    ) -> Result<(), Fault> {
        match (&certificate.alone, &block.others) {
            (Some(alone), Some(claim)) => (0..claim.slices).try_for_each(|slice| {
                others::none(self, depths.part(slice, claim.slices), numbers, (alone, claim), room, go_on)
            }),
            _ => Ok(()),
        }
    }

    /// All conditions in a cell of these depths.
    fn holds(&self, depths: Interval, block: &Block, numbers: &[Numbers], go_on: GoOn) -> Result<(), Fault> {
        let cells = [self.cell(depths), self.cell(depths.middle())];
        let strengths: Vec<Interval> = numbers.iter().map(|own| own.ends.all()).collect();
        let work = Work::new(&self.graph, cells, &strengths, block.parts, go_on)?;
        let legs = work.legs(go_on)?;
        work.contracts(&legs, numbers, self.contraction, go_on)?;
        gaps::open(&work, &legs, &strengths, self.pieces, go_on)
    }
}

/// Proves everything in every cell.
pub(super) fn run(certificate: &Certificate, lines: &mut Lines) -> Result<(), Rejection> {
    let all = 0..certificate.cells.len();
    cells(certificate, all, &mut Room::new(), &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))
}

/// Proves everything in some cells, the first of them being linked to the one before it.
/// `room` is for that there are no others.
pub(super) fn cells(
    certificate: &Certificate,
    which: Range<usize>,
    room: &mut Room,
    go_on: GoOn,
) -> Result<(), Fault> {
    let wall = wall(certificate, go_on)?;
    let problem = Problem::new(certificate, &wall);
    for index in which {
        let block = &certificate.cells[index];
        let latter = numbers(block);
        let mut prove = || {
            let mut least = Interval::ZERO;
            if let Some(before) = index.checked_sub(1).map(|before| &certificate.cells[before]) {
                least = before.depth.enclosed();
                link::same(&problem, least, [&numbers(before), &latter], [before.parts, block.steps], go_on)?;
            }
            let depths = least.hull(block.depth.enclosed());
            problem.holds(depths, block, &latter, go_on)?;
            problem.alone(certificate, depths, block, &latter, room, go_on)
        };
        let place = format!("cell {} of {}", index + 1, certificate.cells.len());
        prove().map_err(|fault| fault.at(place))?;
    }
    Ok(())
}

/// Proves of one cell that there are no others, if that is claimed.
pub(super) fn alone(certificate: &Certificate, index: usize, go_on: GoOn) -> Result<(), Fault> {
    let wall = wall(certificate, go_on)?;
    let block = &certificate.cells[index];
    let before = index.checked_sub(1).map(|before| certificate.cells[before].depth.enclosed());
    let depths = before.unwrap_or(Interval::ZERO).hull(block.depth.enclosed());
    let (problem, room) = (Problem::new(certificate, &wall), &mut Room::new());
    problem.alone(certificate, depths, block, &numbers(block), room, go_on)
}

fn wall(certificate: &Certificate, go_on: GoOn) -> Result<Wall, Fault> {
    let harmonics = certificate.harmonics.iter();
    let harmonics =
        harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
    Wall::new(harmonics.collect(), certificate.window.enclosed(), certificate.pieces, go_on)
}
