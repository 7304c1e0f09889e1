//! Grazing bifurcations of the true system: where they are, the local map there, and the orbits born at them.
//!
//! A periodic orbit, with impacts or without, grazes where a further minimum of a gap is zero: [`locate`].
//! Its [`LocalMap`] has A, B, C, e, γ and a_G of sections 2 and 3.1 of the paper, and [`Grazing::start`]
//! turns the leading-order solution of a pattern into a start for Newton's method on the true system. Not
//! here: which patterns exist (`pattern`), following a branch further.

mod half;
mod local_map;
mod locate;
mod start;

pub use half::is_mirrored;
pub use local_map::LocalMap;
pub use locate::{Grazing, locate};
