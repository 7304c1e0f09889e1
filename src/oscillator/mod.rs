//! One-degree-of-freedom impact oscillators: the system, its motion, its orbits and where they bifurcate, its
//! attractors.
//!
//! A [`System`] is the equation of motion in dimensionless form (mass 1, forcing period 2π) with its walls.
//! Eleven chapters, from the bottom up: `algebra`, plain linear algebra; `counter`, what was computed and how
//! often; `system`, what an oscillator is;
//! [`flow`], the motion between impacts; [`simulate`], the motion with them; [`orbit`], periodic orbits of
//! any impact pattern; [`grazing`], where they graze, with the local map there; [`branch`], how they continue
//! and bifurcate; [`attractor`], where motions end; [`validate`], which proves orbits and uses no search of
//! these; [`chaos`], which proves that all words over an alphabet are orbits. Not here: what is to be done,
//! as a file (`scene`); the local theory at a grazing bifurcation (`pattern`, `local`); tables and pictures
//! (`output`, `figure`).

mod algebra;
pub mod attractor;
pub mod branch;
pub mod chaos;
mod counter;
pub mod flow;
pub mod grazing;
pub mod orbit;
pub mod simulate;
mod size;
mod system;
pub mod validate;

pub(crate) use counter::Share;
pub use counter::{Counter, Counts, Effect, EffectTally};
pub use system::{Contact, Harmonic, Series, Side, SmoothForce, System, Time, Wall};
pub(crate) use system::{Q, TIME, U};
