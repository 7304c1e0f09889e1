//! All conditions over all cells, and from each cell to the next.

use std::ops::Range;

use super::{
    Fault, Interval, Lines, Rejection, gaps, link,
    text::{Cell as Block, Certificate},
    work::{Graph, Numbers, Work, numbers},
};
use crate::{
    rejection::GoOn,
    touch::{legs::Cell, wall::Wall},
};

/// What is the same in all cells.
pub(super) struct Problem<'a> {
    pub graph: Graph,
    wall: &'a Wall,
    /// c, k, τ.
    parameters: [Interval; 3],
    side: Interval,
    pieces: u64,
    contraction: Interval,
}

impl Problem<'_> {
    /// At these depths.
    pub fn cell(&self, depth: Interval) -> Cell<'_> {
        let [damping, stiffness, restitution] = self.parameters;
        let parameters = [damping, stiffness, Interval::ZERO, restitution, depth];
        Cell::new(false, parameters, self.side, self.wall)
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
    cells(certificate, all, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))
}

/// Proves everything in some cells, the first of them being linked to the one before it.
pub(super) fn cells(certificate: &Certificate, which: Range<usize>, go_on: GoOn) -> Result<(), Fault> {
    let harmonics = certificate.harmonics.iter();
    let harmonics =
        harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
    let (window, pieces) = (certificate.window.enclosed(), certificate.pieces);
    let wall = Wall::new(harmonics.collect(), window, pieces, go_on)?;
    let problem = Problem {
        graph: Graph::new(certificate),
        wall: &wall,
        parameters: certificate.ranges.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed())),
        side: if certificate.behind { Interval::ONE } else { -Interval::ONE },
        pieces,
        contraction: certificate.contraction.enclosed(),
    };
    for index in which {
        let block = &certificate.cells[index];
        let latter = numbers(block);
        let mut prove = || {
            let mut least = Interval::ZERO;
            if let Some(before) = index.checked_sub(1).map(|before| &certificate.cells[before]) {
                least = before.depth.enclosed();
                link::same(&problem, least, [&numbers(before), &latter], [before.parts, block.steps], go_on)?;
            }
            problem.holds(least.hull(block.depth.enclosed()), block, &latter, go_on)
        };
        let place = format!("cell {} of {}", index + 1, certificate.cells.len());
        prove().map_err(|fault| fault.at(place))?;
    }
    Ok(())
}
