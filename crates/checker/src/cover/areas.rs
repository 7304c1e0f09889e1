//! From leaves to areas: the part of the conclusion that is about one strip which is an interval of
//! Theorem 2.
//!
//! Let E be the set of the points of the strip, 0 < r ≤ r_max, with t N_{n,k} > 0 for all k: the points with
//! an orbit. It avoids the boxes of None leaves, contains those of Orbit leaves, and is {t T_d > 0} in those
//! of Edge leaves. (There, t T_d > 0 makes every other t T_k > 0; where t T_d ≤ 0, some other t T_k is > 0,
//! so that the signs are neither all t nor all −t.)
//!
//! **One interval of r.** From a point of E go up, s being fixed. In an Orbit leaf's box the path stays in E;
//! in an Edge leaf's, too, as t T_d grows with r. Where it enters the box of another leaf it is in E at a
//! point of that closed box, which therefore is an Orbit or Edge leaf's. So the path stays in E up to r =
//! r_max: at every s of the strip, the r with an orbit form an interval (R(s), r_max], or are none.
//!
//! **One interval at the top.** If the Orbit and Edge leaves at the top are neighbours in a row which reads,
//! from left to right, Edge leaves where t T_d grows with s, at least one Orbit leaf, Edge leaves where it
//! falls, then E at r = r_max is one interval: a point of E in a left Edge leaf has everything right of it up
//! to the Orbit leaves in E, and likewise on the other side.
//!
//! **At s = ½**, for odd n, the row of the last strip must end in an Orbit leaf. Its box holds a piece of the
//! line s = ½ below r_max, on which all t T_k/sin θ > 0: there the area of region 3 goes on into that of
//! region 4.
//!
//! So E is connected, and not empty. A limit of points of E inside the strip that is not in E lies in an Edge
//! leaf and has N_{n,d} = 0: the curve b_{n,d} = 0 bounds the area, and there every other N_{n,k} has the
//! strict sign t.

use super::{expansion::Cell, leaf::Leaf, tree::shown};
use crate::rejection::ensure;

/// The Orbit and Edge leaves at the top of a strip, read in the order of a walk: from left to right. Memory:
/// O(1).
pub(super) struct Top {
    r: i64,
    /// How far the interval has been read.
    stage: Stage,
    /// Where the latest of these leaves ended.
    right: Option<u64>,
    /// The latest of these leaves.
    latest: Option<Leaf>,
    fault: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    Growing,
    Whole,
    Falling,
}

impl Top {
    /// No leaves yet, for rows that end at `r`.
    pub fn new(r: i64) -> Top {
        Top { r, stage: Stage::Growing, right: None, latest: None, fault: None }
    }

    /// Reads a leaf, if it is one of these.
    pub fn add(&mut self, leaf: Leaf, cell: Cell) {
        let next = match leaf {
            _ if cell.r[1] != self.r || self.fault.is_some() => return,
            Leaf::None { .. } | Leaf::Open => return,
            Leaf::Orbit { .. } => Stage::Whole,
            Leaf::Edge { across, .. } => {
                if across > 0 {
                    Stage::Growing
                } else {
                    Stage::Falling
                }
            }
        };
        let follows = match (self.stage, next) {
            (Stage::Growing, Stage::Growing | Stage::Whole) | (Stage::Whole, Stage::Whole) => true,
            (Stage::Whole | Stage::Falling, Stage::Falling) => !matches!(leaf, Leaf::Edge { across: 0, .. }),
            _ => false,
        };
        if self.right.is_some_and(|right| right != cell.s[0]) {
            self.fault = Some(format!("a gap comes before the leaf on {}", shown(&cell)));
        } else if !follows {
            self.fault = Some(format!("the leaf on {} is out of order", shown(&cell)));
        }
        (self.stage, self.right, self.latest) = (next, Some(cell.s[1]), Some(leaf));
    }

    /// Checks that they read as one interval does and, if it must `reach` a certain end on the right, that an
    /// Orbit leaf ends there.
    pub fn is_one_interval(&self, reach: Option<u64>) -> Result<(), String> {
        if let Some(fault) = &self.fault {
            return Err(format!("at the top, {fault}"));
        }
        ensure(self.stage != Stage::Growing, "at the top, there is no orbit leaf")?;
        let reaches = |end| self.right == Some(end) && matches!(self.latest, Some(Leaf::Orbit { .. }));
        ensure(reach.is_none_or(reaches), "at the top, no orbit leaf ends at s = 1/2")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(row: &str) -> Top {
        let mut top = Top::new(1);
        for (i, kind) in (0..).zip(row.chars()) {
            let across = match kind {
                'r' => 1,
                'l' => -1,
                _ => 0,
            };
            let leaf = match kind {
                'N' => Leaf::None { positive: 1, negative: 2 },
                'P' => Leaf::Orbit { positive: true },
                _ => Leaf::Edge { positive: true, deciding: 1, across },
            };
            top.add(leaf, Cell { r: [0, 1], s: [i, i + 1] });
            top.add(Leaf::Orbit { positive: true }, Cell { r: [-1, 0], s: [i, i + 1] });
        }
        top
    }

    /// No true claims read otherwise than one interval does, so that no certificate can show the refusals.
    #[test]
    fn what_is_not_one_interval_is_refused() {
        let reads = |row: &&str| read(row).is_one_interval(None).is_ok();
        assert!(["P", "NrrPPllN", "rP", "Pl"].iter().all(reads));
        let wrong =
            ["", "N", "rl", "PNP", "rNP", "lP", "Pr", "rPlP", "PlNl", "r", "l", "eP", "Pe", "rPle", "rePl"];
        assert!(!wrong.iter().any(reads));
    }

    /// The area must go on into region 4.
    #[test]
    fn an_interval_that_must_reach_the_end_does() {
        let reaches = |row: &&str| read(row).is_one_interval(Some(row.len() as u64)).is_ok();
        assert!(["P", "NrrPP", "rP"].iter().all(reaches));
        assert!(!["Pl", "PN", "rPN"].iter().any(reaches));
    }
}
