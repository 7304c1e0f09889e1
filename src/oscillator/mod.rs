//! One-degree-of-freedom impact oscillators: scenes, the effects they call for, flow and impacts, orbits.
//!
//! A [`System`] is the equation of motion in dimensionless form (mass 1, forcing period 2π) with its walls. Not
//! here: the local theory at a grazing bifurcation (`impact`, `local`), tables and pictures (`output`).

mod side;
mod system;
pub mod validate;

pub use side::Side;
pub use system::{Harmonic, System, Wall};
