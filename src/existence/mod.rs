//! Where single-impact orbits of period n exist on r = 1: Theorem 2 as a statement, and as something to
//! decide.
//!
//! Two sides are kept apart and compared. The *claim* is the theorem's list of intervals, built by modular
//! inverses ([`intervals`]) and again from the Farey tree ([`tree_intervals`]). The *decision* ([`decide`])
//! knows only the signs of b_{n,k} and c_n and finds where (52), (53) hold. A second proof
//! ([`decide_by_enclosure`]) takes the claim as a guess and proves it by enclosures over whole stretches.
//! For r < 1: one point at a time ([`by_definition`], [`by_records`], [`claimed`]), and the edge of an area
//! of Conjecture 1 with its lowest point ([`Boundary`]). How long the intervals of a period are together,
//! and how many periods coexist at a random s: [`measure`], [`measures`], [`Coexistence`].
//!
//! Not here: which impact patterns have orbits, which the command `existence` asks ([`crate::pattern`]).
//!
//! ```
//! use grazing::existence::{Existence, by_definition, decide, intervals};
//! use grazing::local::{Ladder, Point, Polar};
//! use grazing::number::parse_rational;
//! // Period 5 on r = 1: φ(5) + 1 intervals, and the decision finds the same.
//! assert_eq!(intervals(5)?.count(), 5);
//! assert!(decide(5)?.disagreement.is_none());
//! // One of them is (1/3, 2/5). At s = 3/8 the orbit survives damping r = 0.95, but not r = 0.7.
//! let at = |r: &str| -> grazing::Result<Existence> {
//!     let polar = Polar::new(parse_rational(r)?, parse_rational("3/8")?)?;
//!     Ok(by_definition(&Ladder::default(), &Point::Polar(polar), 5))
//! };
//! assert!(matches!(at("0.95")?, Existence::Orbit(_)));
//! assert!(matches!(at("0.7")?, Existence::None { .. }));
//! # Ok::<(), grazing::Error>(())
//! ```

mod boundary;
mod brief;
mod by_enclosure;
mod case;
mod claim;
mod coexistence;
mod decide;
mod eigenvalue;
pub(crate) mod fixed_point;
mod intervals;
mod measure;
mod quick;
mod resonance;
mod signs;
mod single;
mod tip;
mod units;

pub use boundary::{Boundary, Enclosure};
pub(crate) use brief::Brief;
pub use by_enclosure::{Enclosed, decide_by_enclosure};
pub use case::Case;
pub(crate) use claim::claimed_with;
pub use claim::{Claim, Variant, claimed};
pub use coexistence::{Coexistence, Coexisting, MAX_COEXISTENCE, coexisting, landau, landau_scaled};
pub(crate) use decide::each_piece;
pub use decide::{Decision, Piece, Reason, decide};
pub use eigenvalue::large_eigenvalue_sign;
pub(crate) use intervals::intervals_between;
pub use intervals::{Interval, MAX_PERIOD, intervals, tree_intervals};
pub use measure::{MAX_DECIMALS, MAX_EXACT, NarrowBounds, PeriodMeasure, measure, measures};
pub use quick::by_enclosures;
pub use resonance::Resonance;
pub use signs::{Approach, Signs};
pub use single::definition_and_rung;
pub use single::{Existence, by_definition, by_records, up_to};
pub use tip::{Lowest, Tip, tip_correction, tip_law};
