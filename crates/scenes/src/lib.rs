//! Impact oscillators and machines as scenes, their tasks run; and every chapter of grazing
//! under its name, for who wants all of it as one library.
//!
//! | module | holds |
//! | --- | --- |
//! | [`scene`] | an oscillator or a machine and what to do with it, as a file |
//! | [`run`] | the tasks of a scene run, each with a typed result |
//! | [`answer`] | of a machine as somebody types it, or of a scene, one page of answer |
//!
//! The other chapters, under their names:
//!
//! | package | modules |
//! | --- | --- |
//! | `grazing` | [`farey`], [`symbol`], [`local`], [`existence`], [`word`], [`tolerance`], [`pattern`]: the theory |
//! | `grazing-check`, `grazing-number` | [`certificate`]: the checker, the trusted code; [`number`] |
//! | `grazing-motion` | [`motion`], [`continuation`], [`attractor`], [`one`], [`many`]: motions, orbits, branches |
//! | `grazing`, `grazing-prove` | [`search`]: what finds certificates and looks for counterexamples |
//!
//! # What is proved
//!
//! Beside what `grazing` proves:
//!
//! - For a linear oscillator with walls: that an exact periodic orbit with a given impact pattern exists, is
//!   the only one in a box, touches no wall else, and is stable or not; and where in a parameter orbits meet,
//!   double their period or graze ([`search::orbit`]); of the motion without impacts that it is alone and
//!   clear of every wall. The same of linear machines with rigid stops ([`search::machine`]).
//! - That every word over an alphabet of return times is an orbit of an oscillator, for a range of µ with 0
//!   at its end: chaos ([`search::chaos`]). That what is born at a touch goes on, word by word, from the
//!   touch to a distance ([`search::range`]).
//!
//! # What is computed
//!
//! - Trajectories of impact oscillators with one degree of freedom, in f64: every impact deeper than a stated
//!   bound ([`one::simulate`]); of machines with any number of degrees of freedom and of rigid and compliant
//!   stops, linear or with forces written as formulas, in real units ([`many::simulate`]).
//! - Of both: sections, attractors, Lyapunov exponents, basins, diagrams ([`attractor`]); periodic orbits
//!   with any impact pattern ([`one::orbit`], [`many::orbit`]), their grazing points with the local theory
//!   there ([`one::grazing`], [`many::grazing`]), branches of them over a parameter with their bifurcations
//!   ([`continuation`]): floating point, without proof.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod answer;
#[doc(hidden)]
pub mod internals;
pub mod run;
pub mod scene;

use grazing_base::{error, monitor, outcome, output, printable, quantity, source, typed};
use grazing_motion::{formula, rounding};

pub use grazing::{
    Error, Monitor, Outcome, Profile, Result, Spent, Spot, certificate, existence, farey, local, num_bigint,
    num_rational, number, pattern, symbol, tolerance, word,
};
pub use grazing_motion::{attractor, continuation, many, motion, one};

/// What finds proofs and writes them down as certificates, of every kind. Untrusted.
pub mod search {
    pub use grazing::search::*;
    pub use grazing_prove::{attractor, chaos, machine, orbit, range, touch};
}

/// The hash of this chapter's sources.
#[doc(hidden)]
pub const SOURCES: &str = env!("GRAZING_SOURCES");
