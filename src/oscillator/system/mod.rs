//! What an oscillator is: the equation of motion, forcing and moving walls, the impact law, states and times.
//!
//! [`System`] has coefficients of any kind; [`Contact`] is one of its walls in f64, [`Side`] says which. Not
//! here: how the motion goes on between impacts (`flow`), when impacts happen (`simulate`).

mod contact;
mod equation;
mod force;
mod motion;
mod series;
mod time;

pub use contact::{Contact, Side};
pub use equation::{Harmonic, System, Wall};
pub use force::SmoothForce;
pub(crate) use force::{Q, TIME, U};
pub use motion::{Flow, State};
pub use series::Series;
pub(super) use series::finite;
pub use time::Time;
