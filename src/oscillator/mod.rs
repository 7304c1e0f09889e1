//! One-degree-of-freedom impact oscillators: scenes, the effects they call for, flow and impacts, orbits.
//!
//! A [`System`] is the equation of motion in dimensionless form (mass 1, forcing period 2π) with its walls; a [`Scene`]
//! is one with named parameters, read from a file, and what to do with it. From the bottom up: `flow`, `contact` and `simulate`; `section`, `attractor`,
//! `lyapunov`, `basin` on them; `orbit`, and on it `grazing`, `critical`, `branch`, `manifold`; `diagram`; `validate`, which proves and uses none of these. Not here: the local theory at a grazing
//! bifurcation (`impact`, `local`), tables and pictures (`output`).

pub mod attractor;
pub mod basin;
pub mod branch;
mod contact;
mod counter;
pub mod critical;
pub mod diagram;
pub mod flow;
pub mod grazing;
pub mod lyapunov;
pub mod manifold;
pub mod orbit;
mod rise;
pub mod scene;
pub mod section;
mod series;
pub mod simulate;
mod system;
mod time;
mod touching;
pub mod validate;

pub use contact::{Contact, Side};
pub use counter::{Counter, Counts, Effect};
pub use scene::{Expression, Scene};
pub use series::Series;
pub use system::{Harmonic, System, Wall};
pub use time::Time;
pub use touching::touching;
