//! Signs on all of a box, from a partition into cells that is refined where a sign is not certain.

use std::cell::RefCell;

use super::{
    cell::{Cell, LONGEST, decision},
    parameters::ParameterBox,
};
use crate::{
    local::{Polar, Rung, SignDecision},
    number::Sign,
    word::{Extent, Realm, Signs},
};

/// The most cells of a partition.
const CELLS: usize = 4096;

/// The image of a box. Cells are kept from one sign to the next.
pub(super) struct Tube {
    cells: RefCell<Vec<(ParameterBox, Cell)>>,
    realm: Realm,
}

impl Tube {
    pub fn new(of: &ParameterBox) -> Tube {
        let cell = Cell::new(of);
        let realm = cell.realm();
        Tube { cells: RefCell::new(vec![(of.clone(), cell)]), realm }
    }

    pub fn realm(&self) -> Realm {
        self.realm
    }

    /// Whether γ > 0, where that is the same on all cells.
    pub fn gamma(&self) -> Option<bool> {
        let sign = |positive| if positive { Sign::Positive } else { Sign::Negative };
        self.common(0, |cell| cell.gamma.map(sign)).map(|found| found == Sign::Positive)
    }

    /// What a sign is on every cell. Cells where it is not certain are halved, all of them at a time; that
    /// ends at two different signs, or where there are too many.
    fn common(&self, n: u64, sign: impl Fn(&Cell) -> Option<Sign>) -> Option<Sign> {
        if n > LONGEST {
            return None;
        }
        let mut cells = self.cells.borrow_mut();
        let mut found = None;
        let mut from = 0;
        loop {
            let mut halved = Vec::new();
            let mut kept = Vec::with_capacity(cells.len() - from);
            for (of, cell) in cells.drain(from..) {
                match sign(&cell) {
                    Some(sign) => {
                        if found.is_some_and(|known| known != sign) {
                            found = Some(Sign::Zero);
                        }
                        found = found.or(Some(sign));
                        kept.push((of, cell));
                    }
                    None => halved.push((of, cell)),
                }
            }
            cells.extend(kept);
            let stop = found == Some(Sign::Zero)
                || cells.len() + 2 * halved.len() > CELLS
                || halved.iter().any(|(of, _)| of.is_point());
            if stop || halved.is_empty() {
                let certain = halved.is_empty() && found != Some(Sign::Zero);
                cells.extend(halved);
                return found.filter(|_| certain);
            }
            from = cells.len();
            for (of, cell) in halved {
                cells.extend(of.halves(of.wide_axis(cell.axis())).map(|half| {
                    let cell = Cell::new(&half);
                    (half, cell)
                }));
            }
        }
    }
}

impl Signs for Tube {
    fn side(&self, n: u64) -> Result<Sign, Rung> {
        self.common(n, |cell| cell.u(n)).ok_or(Rung::Exact)
    }

    fn deciding(&self, n: u64, k: u64) -> SignDecision {
        decision(self.common(n, |cell| cell.b(n, k)))
    }

    fn absent(&self, n: u64, lower: u64, upper: u64) -> bool {
        let sign = |occurs| if occurs { Sign::Positive } else { Sign::Negative };
        self.common(n, |cell| cell.occurs(n, lower, upper).map(sign)) == Some(Sign::Negative)
    }

    fn open(&self, next: u64, _: Rung) -> Extent {
        Extent::Straddled { next }
    }

    fn on_circle(&self) -> bool {
        false
    }

    fn polar(&self) -> Option<&Polar> {
        None
    }
}
