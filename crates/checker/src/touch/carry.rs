//! How Z > 0, a gap's being positive, is carried from both ends of a leg over all of it, by what is certain
//! of Z on pieces of time.
//!
//! At an end that is a contact Z = 0, with Z′ > 0 at the first and Z′ < 0 at the last. From the first on, Z >
//! 0 is carried forward by pieces that are rising; or convex, if Z′ > 0 where they begin, and so where they
//! end; or open, but then Z′ is no longer known. Likewise it is carried backward from the last, by pieces
//! that are falling, convex or open. Both must meet. At an end that is no contact, as it is for the other of
//! two walls, nothing is known of Z: there an open piece must be the first.

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

/// Whether Z > 0 between the ends of a leg that is cut into these pieces; `contacts` says of both ends
/// whether they are contacts.
pub(crate) fn is_open(pieces: &[Piece], [first, last]: [bool; 2]) -> bool {
    let forward = carried(first, pieces.iter().map(|piece| (piece.rising, piece.convex, piece.open)));
    let backward = carried(last, pieces.iter().rev().map(|piece| (piece.falling, piece.convex, piece.open)));
    forward + backward >= pieces.len()
}

/// How many pieces carry Z > 0 away from an end: those on which Z moves away from the wall; on which it is
/// convex, and is known to do so where they begin; or on which it is open. Where the end is no `contact`, the
/// first must be open.
pub(crate) fn carried(contact: bool, pieces: impl Iterator<Item = (bool, bool, bool)>) -> usize {
    // Whether Z′ > 0 is known where a piece begins; and Z > 0, or Z = 0 < Z′.
    let (mut leaves, mut known) = (contact, contact);
    let mut count = 0;
    for (moving, convex, open) in pieces {
        if known && (moving || (leaves && convex)) {
            leaves = true;
        } else if open {
            (leaves, known) = (false, true);
        } else {
            break;
        }
        count += 1;
    }
    count
}
