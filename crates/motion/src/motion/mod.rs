//! What moves, whatever engine follows it: times and series of harmonics, forces, the equation of one
//! coordinate with its walls, its free motion, the minimum test for gaps, what was computed and how often.
//!
//! A [`System`] is the equation of motion of an oscillator in dimensionless form (mass 1, forcing period 2π)
//! with its walls, coefficients of any kind; [`Contact`] is one of its walls in f64, [`Side`] says which;
//! [`flow`] is the motion between impacts, of an oscillator or of one mode of a machine, and the Taylor
//! programs of smooth forces of any number of coordinates. `minimum` finds where a gap has an impact or a
//! tangency on one piece, `cell` where it is least. Not here: when impacts happen (`one`, `many`).

pub(crate) mod algebra;
pub(crate) mod backbone;
mod cell;
mod contact;
mod counter;
mod end;
mod equation;
pub mod event;
pub mod flow;
mod force;
pub(crate) mod minimum;
mod series;
mod state;
mod time;
mod vibrations;

pub(crate) use algebra::Matrix2;

pub(crate) use cell::minimum_within;
pub use contact::{Contact, Side};
pub(crate) use counter::Share;
pub use counter::{Counter, Counts, Effect, EffectTally};
pub use end::RunEnd;
pub use equation::{Harmonic, System, Wall};
pub use event::Event;
pub use force::SmoothForce;
pub use force::{Q, TIME, U};
pub use series::Series;
pub(crate) use series::finite;
pub use state::{Flow, State};
pub use time::Time;
pub use vibrations::{AmplitudeEnd, Vibrations};
