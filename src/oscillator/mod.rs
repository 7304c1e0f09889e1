//! One-degree-of-freedom impact oscillators: scenes, the effects they call for, flow and impacts, orbits.
//!
//! A [`System`] is the equation of motion in dimensionless form (mass 1, forcing period 2π) with its walls. Not
//! here: the local theory at a grazing bifurcation (`impact`, `local`), tables and pictures (`output`).

pub mod attractor;
pub mod basin;
mod contact;
mod counter;
pub mod flow;
pub mod lyapunov;
mod rise;
pub mod section;
mod series;
pub mod simulate;
mod system;
mod time;

pub use contact::{Contact, Side};
pub use counter::{Counter, Counts, Effect};
pub use series::Series;
pub use system::{Harmonic, System, Wall};
pub use time::Time;
