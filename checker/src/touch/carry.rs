//! How Z > 0, a gap's being positive, is carried from both ends of a leg over all of it, by what is certain
//! of Z on pieces of time.
//!
//! Z = 0 at both ends, Z′ > 0 at the first and Z′ < 0 at the last. From the first on, Z > 0 is carried
//! forward by pieces that are rising; or convex, if Z′ > 0 where they begin, and so where they end; or open,
//! but then Z′ is no longer known. Likewise it is carried backward from the last, by pieces that are falling,
//! convex or open. Both must meet.

/// What is certain of a gap Z on a piece of time.
#[derive(Clone, Copy)]
pub(crate) struct Piece {
    /// Z > 0.
    pub open: bool,
    /// Z″ > 0.
    pub convex: bool,
    /// Z′ > 0.
    pub rising: bool,
    /// Z′ < 0.
    pub falling: bool,
}

/// Whether Z > 0 between the ends of a leg that is cut into these pieces.
pub(crate) fn is_open(pieces: &[Piece]) -> bool {
    let forward = carried(pieces.iter().map(|piece| (piece.rising, piece.convex, piece.open)));
    let backward = carried(pieces.iter().rev().map(|piece| (piece.falling, piece.convex, piece.open)));
    forward + backward >= pieces.len()
}

/// How many pieces carry Z > 0 away from an impact: those on which Z moves away from the wall; on which it is
/// convex, and is known to do so where they begin; or on which it is open.
pub(crate) fn carried(pieces: impl Iterator<Item = (bool, bool, bool)>) -> usize {
    let mut leaves = true;
    let mut count = 0;
    for (moving, convex, open) in pieces {
        if moving || (leaves && convex) {
            leaves = true;
        } else if open {
            leaves = false;
        } else {
            break;
        }
        count += 1;
    }
    count
}
