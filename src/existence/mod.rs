//! Where single-impact orbits of period n exist on r = 1: Theorem 2 as a statement, and as something to decide.
//!
//! Two sides are kept apart and compared. The *claim* is the theorem's list of intervals, built by modular inverses
//! ([`intervals`]) and again from the Farey tree ([`tree_intervals`]). The *decision* ([`decide`]) knows only
//! the signs of b_{n,k} and c_n and finds where (52), (53) hold. What happens for r < 1 is not here.

mod boundary;
mod case;
mod decide;
mod intervals;
mod signs;
mod tip;

pub use boundary::{Boundary, Enclosure};
pub use case::Case;
pub use decide::{Decision, Piece, Reason, decide};
pub use intervals::{Interval, MAX_PERIOD, intervals, tree_intervals};
pub use signs::{Side, Signs};
pub use tip::{Lowest, Tip, tip_correction, tip_law};
