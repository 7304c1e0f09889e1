//! Reading a diagram: windows of periodic motion, and where attractors coexist.

use super::Slice;

/// Neighbouring values at which an attractor of one period with one number of impacts is found.
#[derive(Debug, Clone, PartialEq)]
pub struct Window {
    /// The first value.
    pub from: f64,
    /// The last value; the window ends somewhere before the next.
    pub to: f64,
    /// The period, in forcing periods.
    pub period: u32,
    /// Impacts in a period.
    pub impacts: u64,
    /// How many values.
    pub values: usize,
}

/// The windows of a diagram whose values ascend, ordered by where they begin. One narrower than the distance
/// of values can be missed, and two with nothing between them but missed values are taken for one.
pub fn windows(slices: &[Slice]) -> Vec<Window> {
    let mut open: Vec<Window> = Vec::new();
    let mut closed = Vec::new();
    for slice in slices {
        let mut next = Vec::new();
        for motion in &slice.motions {
            let Some(period) = motion.period else { continue };
            let same = |window: &Window| window.period == period && window.impacts == motion.impacts;
            if next.iter().any(same) {
                continue;
            }
            next.push(match open.iter().position(same) {
                Some(i) => {
                    let window = open.swap_remove(i);
                    Window { to: slice.value, values: window.values + 1, ..window }
                }
                None => {
                    let (from, impacts) = (slice.value, motion.impacts);
                    Window { from, to: from, period, impacts, values: 1 }
                }
            });
        }
        closed.append(&mut open);
        open = next;
    }
    closed.append(&mut open);
    closed.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.period.cmp(&b.period)));
    closed
}

/// The slices with more than one attractor, or with starts whose motion is lost; a motion of which it is not
/// decided what it is on is none.
pub fn coexisting(slices: &[Slice]) -> impl Iterator<Item = &Slice> {
    let decided = |slice: &Slice| slice.motions.iter().filter(|motion| !motion.undecided).count();
    slices.iter().filter(move |slice| decided(slice) > 1 || slice.lost > 0)
}
