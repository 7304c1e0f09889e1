//! The local map in any dimension: Theorem 1, impact patterns, stability, and in two dimensions the pattern
//! graph.
//!
//! A [`Map`] is A, B, C and e of a grazing bifurcation, exact or enclosed entry by entry, read from TOML or
//! built in code. A [`Pattern`] (n₁, …, n_m) lists the periods between impacts. [`Analysis`] decides for any
//! pattern what Theorem 1 says: it solves the leading-order equations
//!
//! ```text
//! X_{i+1} = A^{n_i} X_i + B Y_i,   C A^{n_i} X_i = −1     (28), (32)
//! ```
//!
//! and takes the signs of C A^k X_i + 1 (33) and Y_i (34). Every sign is certain: enclosures first, exact
//! fractions where those cannot tell; what stays undecided says why. In two dimensions [`Graph`] does the
//! same faster: each X_i depends on n_i alone, and the existing patterns are the closed walks of a graph
//! (64). In more dimensions [`Windows`] leaves out beginnings of patterns that no orbit can have, and
//! [`Flights`] says whether one bound serves all patterns. Not here: single impacts as functions of (a₁, a₂)
//! (`local`), pictures (the package `grazing-shell`).

mod analysis;
mod coordinates;
mod existence;
mod flights;
mod graph;
mod input;
mod linear;
mod map;
mod matrix;
mod orbit;
mod scalar;
mod sequence;
mod solve;
mod windows;

pub use analysis::{Analysis, Numbers};
pub use coordinates::Coordinates;
pub use existence::{OpenReason, PatternExistence, PatternOrbit, PatternQuantity, Report};
pub use flights::{Flights, Together};
pub use graph::{Graph, MAX_GRAPH_PERIOD, PatternTally};
pub use map::{Entry, Map};
pub use matrix::Matrix;
pub use orbit::{PredictedPoint, predicted_orbit};
pub use scalar::{Scalar, Value};
pub use sequence::{Pattern, Patterns, Pruning};
pub use solve::{Failure, Solution, solve};
pub use windows::Windows;
