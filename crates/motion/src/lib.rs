//! Motions of impact oscillators and of machines, in f64 and without proof: simulation, periodic orbits,
//! branches, grazings, attractors. No theory of what is born at a grazing; `grazing-scenes` puts the two
//! together, and is what to use.
//!
//! | module | holds |
//! | --- | --- |
//! | [`formula`] | formulas as trees |
//! | [`motion`] | what moves: forces, series, the equation of one coordinate, its free motion, the minimum test |
//! | [`continuation`] | curves of orbits, events on them, switching, multipliers, Newton's method, normal forms |
//! | [`attractor`] | where motions end: sections, recurrence, basins, diagrams, exponents |
//! | [`one`] | the engine for one degree of freedom: motions, orbits, grazing |
//! | [`many`] | the engine for machines: any number of coordinates and of stops, in real units |

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod attractor;
pub mod continuation;
#[doc(hidden)]
pub mod formula;
pub mod many;
pub mod motion;
pub mod one;
#[doc(hidden)]
pub mod rounding;

use grazing_base::{error, monitor, output, random};

/// The hash of this chapter's sources.
#[doc(hidden)]
pub const SOURCES: &str = env!("GRAZING_SOURCES");
