//! From leaves to areas: the part of the conclusion that is about one strip which is an interval of Theorem 2.
//!
//! Let E be the set of the points of the strip, 0 < r ≤ r_max, with t N_{n,k} > 0 for all k: the points with an orbit. It avoids
//! the boxes of None leaves, contains those of Orbit leaves, and is {t T_d > 0} in those of Edge leaves. (There, t T_d > 0 makes every other
//! t T_k > 0; where t T_d ≤ 0, some other t T_k is > 0, so that the signs are neither all t nor all −t.)
//!
//! **One interval of r.** From a point of E go up, s being fixed. In an Orbit leaf's box the path stays in E; in an Edge leaf's, too, as t T_d grows with r. Where it
//! enters the box of another leaf it is in E at a point of that closed box, which therefore is an Orbit or Edge leaf's. So the path stays in E up to
//! r = r_max: at every s of the strip, the r with an orbit form an interval (R(s), r_max], or are none.
//!
//! **One interval at the top.** If the Orbit and Edge leaves at the top are neighbours in a row which reads, from left to right, Edge leaves where t T_d
//! grows with s, at least one Orbit leaf, Edge leaves where it falls, then E at r = r_max is one
//! interval: a point of E in a left Edge leaf has everything right of it up to the Orbit leaves in E, and likewise on the other side.
//!
//! So E is connected, and not empty. A limit of points of E inside the strip that is not in E lies in an Edge leaf and has N_{n,d} = 0: the curve b_{n,d} = 0 bounds the
//! area, and there every other N_{n,k} has the strict sign t.

use super::{expansion::Cell, leaf::Leaf, tree::shown};

/// The Orbit and Edge leaves at the top of a strip, in the order of a walk: from left to right.
pub(super) struct Top {
    r: i64,
    leaves: Vec<(Leaf, Cell)>,
}

impl Top {
    /// No leaves yet, for rows that end at `r`.
    pub fn new(r: i64) -> Top {
        Top { r, leaves: Vec::new() }
    }

    /// Takes note of a leaf, if it is one of these.
    pub fn add(&mut self, leaf: Leaf, cell: Cell) {
        if cell.r[1] == self.r && matches!(leaf, Leaf::Orbit { .. } | Leaf::Edge { .. }) {
            self.leaves.push((leaf, cell));
        }
    }

    /// Checks that they read as one interval does.
    pub fn is_one_interval(&self) -> Result<(), String> {
        if let Some(pair) = self.leaves.windows(2).find(|pair| pair[0].1.s[1] != pair[1].1.s[0]) {
            return Err(format!("at the top, a gap follows the leaf on {}", shown(&pair[0].1)));
        }
        let growing = |leaf: &Leaf| matches!(leaf, Leaf::Edge { across: 1, .. });
        let falling = |leaf: &Leaf| matches!(leaf, Leaf::Edge { across: -1, .. });
        let rest = self.leaves.iter().skip_while(|(leaf, _)| growing(leaf));
        let mut rest = rest.skip_while(|(leaf, _)| matches!(leaf, Leaf::Orbit { .. }));
        if !self.leaves.iter().any(|(leaf, _)| matches!(leaf, Leaf::Orbit { .. })) {
            return Err("at the top, there is no orbit leaf".into());
        }
        match rest.find(|(leaf, _)| !falling(leaf)) {
            Some((_, cell)) => Err(format!("at the top, the leaf on {} is out of order", shown(cell))),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No true claims read otherwise than one interval does, so that no certificate can show the refusals.
    #[test]
    fn what_is_not_one_interval_is_refused() {
        let reads = |row: &str| {
            let mut top = Top::new(1);
            for (i, kind) in (0..).zip(row.chars()) {
                let across = if kind == 'r' { 1 } else { -1 };
                let leaf = match kind {
                    'N' => Leaf::None { positive: 1, negative: 2 },
                    'P' => Leaf::Orbit { positive: true },
                    _ => Leaf::Edge { positive: true, deciding: 1, across },
                };
                top.add(leaf, Cell { r: [0, 1], s: [i, i + 1] });
                top.add(Leaf::Orbit { positive: true }, Cell { r: [-1, 0], s: [i, i + 1] });
            }
            top.is_one_interval().is_ok()
        };
        assert!(["P", "NrrPPllN", "rP", "Pl"].into_iter().all(reads));
        assert!(!["", "N", "rl", "PNP", "rNP", "lP", "Pr", "rPlP", "PlNl"].into_iter().any(reads));
    }
}
