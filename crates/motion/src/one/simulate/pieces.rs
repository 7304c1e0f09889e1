//! A flow cut into pieces on each of which the gap to every wall is a polynomial, and no wall's effect unless
//! it is asked for.

use super::grid;
use crate::motion::{Counter, RunEnd, State, Time, minimum::Head};

/// The lower wall's place in arrays of two; the upper's is 1.
pub(super) const LOWER: usize = 0;
pub(super) const UPPER: usize = 1;

/// The flow as the search for impacts sees it. A place on a piece is x ∈ [−1, 1], proportional to time.
pub(super) trait Pieces: Send + Sync {
    /// A piece and the motion on it.
    type Cursor: Clone + Send;
    /// Coefficients of a polynomial in x.
    type Gap: AsRef<[f64]>;
    /// A time, as far as it can be prepared for comparisons.
    type Target: Copy;

    /// The piece that begins at (or holds) `time` with this motion.
    fn start<C: Counter>(&self, time: Time, q: f64, u: f64, counter: &mut C) -> Self::Cursor;

    /// The place from which on the piece is to be looked at.
    fn from(&self, cursor: &Self::Cursor) -> f64;

    /// Everything before x has been looked at.
    fn pass(&self, cursor: &mut Self::Cursor, x: f64);

    /// The gap to wall `WALL` on the piece, as far as it can be had cheaply.
    fn head<C: Counter, const WALL: usize>(&self, cursor: &Self::Cursor, counter: &mut C) -> Head;

    /// The gap to wall `WALL` on the piece.
    fn gap<const WALL: usize>(&self, cursor: &Self::Cursor) -> Self::Gap;

    /// On to the next piece.
    fn turn<C: Counter>(&self, cursor: &mut Self::Cursor, counter: &mut C);

    /// Adds `du` to the velocity at x, from where the piece is to be looked at again.
    fn kick<C: Counter>(&self, cursor: &mut Self::Cursor, x: f64, du: f64, counter: &mut C);

    /// Straight to `until`, as no wall is in the way; `origin` is where the flight began.
    fn jump<C: Counter>(
        &self,
        origin: &Self::Cursor,
        cursor: &mut Self::Cursor,
        until: Time,
        counter: &mut C,
    );

    /// A time made ready for [`reach`](Self::reach).
    fn target(&self, until: Time) -> Self::Target;

    /// The place of a time on this piece, more than 1 if it is on a later one.
    fn reach(&self, cursor: &Self::Cursor, target: Self::Target) -> f64;

    /// The time of a place.
    fn time(&self, cursor: &Self::Cursor, x: f64) -> Time;

    /// dt/dx.
    fn scale(&self, cursor: &Self::Cursor) -> f64;

    /// The motion at a place; t is the phase.
    fn state(&self, cursor: &Self::Cursor, x: f64) -> State;

    /// The motion on a grid, if this is one.
    fn leave(&self, cursor: &Self::Cursor) -> Option<grid::Cursor>;

    /// The motion that was on this grid, back.
    fn join(&self, cursor: grid::Cursor) -> Self::Cursor;

    /// Why the motion cannot go on from the piece, if it cannot.
    fn over(&self, cursor: &Self::Cursor) -> Option<RunEnd>;
}
