//! That at the depth which two cells share both have the same motions.
//!
//! There the motions of the former are the fixed points of its F, in its ranges. A fixed point that lies in
//! sets X lies in what they have in common with F(X), too. Once this lies in the latter's ranges, it is a
//! motion that the latter has, and has once. The sets are cut into as many parts as the former's ranges.

use super::{
    Fault, Interval,
    problem::Problem,
    work::{Numbers, Work},
};
use crate::rejection::{GoOn, claim};

/// Proves it at the depth that is shared, of the numbers of the former and of the latter.
pub(super) fn same(
    problem: &Problem,
    depth: Interval,
    [former, latter]: [&[Numbers]; 2],
    [parts, steps]: [u64; 2],
    go_on: GoOn,
) -> Result<(), Fault> {
    let sets = former.iter().map(|own| own.ends.all()).collect();
    let linked = within(problem, depth, sets, [former, latter], [parts, steps], go_on)?;
    claim(linked, "its motions may not be those of the cell before (link)")
}

/// Whether the fixed points of the former's F in these sets at some depths lie in the latter's ranges.
pub(super) fn within(
    problem: &Problem,
    depths: Interval,
    mut sets: Vec<Interval>,
    [former, latter]: [&[Numbers]; 2],
    [parts, steps]: [u64; 2],
    go_on: GoOn,
) -> Result<bool, Fault> {
    let inside = |sets: &[Interval]| sets.iter().zip(latter).all(|(&set, own)| own.ends.holds(set));
    for _ in 0..steps {
        if inside(&sets) {
            return Ok(true);
        }
        let cells = [problem.cell(depths), problem.cell(depths.middle())];
        let work = Work::new(&problem.graph, cells, &sets, parts, go_on)?;
        let images = work.images(&work.legs(go_on)?, former, go_on)?;
        for (set, image) in sets.iter_mut().zip(images) {
            *set = set.meet(image);
        }
    }
    Ok(inside(&sets))
}
