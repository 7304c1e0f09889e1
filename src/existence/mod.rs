//! Where single-impact orbits of period n exist on r = 1: Theorem 2 as a statement, and as something to
//! decide.
//!
//! Two sides are kept apart and compared. The *claim* is the theorem's list of intervals, built by modular
//! inverses ([`intervals`]) and again from the Farey tree ([`tree_intervals`]). The *decision* ([`decide`])
//! knows only the signs of b_{n,k} and c_n and finds where (52), (53) hold. A second proof
//! ([`decide_by_enclosure`]) takes the claim as a guess and proves it by enclosures over whole stretches. For
//! r < 1: one point at a time ([`by_definition`], [`by_records`], [`claimed`]), and the edge of an area of
//! Conjecture 1 with its lowest point ([`Boundary`]).

mod boundary;
mod by_enclosure;
mod case;
mod claim;
mod decide;
mod eigenvalue;
mod intervals;
mod signs;
mod single;
mod tip;

pub use boundary::{Boundary, Enclosure};
pub use by_enclosure::{Enclosed, decide_by_enclosure};
pub use case::Case;
pub(crate) use claim::claimed_with;
pub use claim::{Claim, Variant, claimed};
pub use decide::{Decision, Piece, Reason, decide};
pub use eigenvalue::large_eigenvalue_sign;
pub use intervals::{Interval, MAX_PERIOD, intervals, tree_intervals};
pub use signs::{Approach, Signs};
pub(crate) use single::definition_and_rung;
pub use single::{Existence, by_definition, by_records};
pub use tip::{Lowest, Tip, tip_correction, tip_law};
