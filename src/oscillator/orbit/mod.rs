//! Periodic orbits of the true system for any impact pattern, with what proves them orbits or not.
//!
//! [`Itinerary`] is the impact pattern with its walls, [`linearise`] the equations (19) with all derivatives, [`find`]
//! Newton's method on them, its answer an [`Orbit`] with [`Multipliers`] and [`Admissibility`]. [`SingleImpact`] has the exact orbits of
//! a linear oscillator, a second route. Not here: where orbits bifurcate (`grazing`, `critical`).

mod admissible;
mod equations;
mod family;
mod itinerary;
mod leg;
mod multipliers;
mod newton;
mod oscillator;
mod search;
mod single;
mod solution;

pub(super) use admissible::minima;
pub use admissible::{Admissibility, Check, Minimum, check};
pub use equations::{Linearised, duration, linearise};
pub use family::Family;
pub use itinerary::{Itinerary, Strike};
pub use leg::{Leg, Touch};
pub use multipliers::Multipliers;
pub use newton::{Root, newton};
pub use oscillator::Oscillator;
pub use search::search;
pub use single::SingleImpact;
pub use solution::{Impact, Orbit, describe, find, monodromy};
