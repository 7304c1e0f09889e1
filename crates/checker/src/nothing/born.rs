//! T: that nothing is born, from E(2πn) alone.

use super::{Fault, Interval};
use crate::{
    rejection::{GoOn, claim},
    touch::{flow::Matrix, legs::Cell},
};

/// The first and the last velocity of a leg from q̂ = 1 to q̂ = 1 in n periods, or none if it is certainly
/// below 1 at a whole period between.
fn velocities(cell: &Cell, turns: &[Matrix], n: usize) -> Option<[Interval; 2]> {
    let one = Interval::ONE;
    let after = (one - turns[n].a).over(turns[n].b);
    let between = |k: usize| cell.flow.apply(turns[k], one, after).0;
    let below = (1..n).any(|k| between(k).is_below(one));
    (!below).then(|| [after, cell.flow.apply(turns[n], one, after).1])
}

/// That the graph has no cycle: what has no successor in it is taken away, until nothing is left.
pub(super) fn nothing(cell: &Cell, turns: &[Matrix], go_on: GoOn) -> Result<(), Fault> {
    let mut left: Vec<[Interval; 2]> = (1..turns.len()).filter_map(|n| velocities(cell, turns, n)).collect();
    loop {
        go_on()?;
        let followed = |&[_, before]: &[Interval; 2]| left.iter().any(|[after, _]| !after.is_below(before));
        let next: Vec<[Interval; 2]> = left.iter().copied().filter(followed).collect();
        if next.len() == left.len() {
            return claim(left.is_empty(), "something may be born (T)");
        }
        left = next;
    }
}
