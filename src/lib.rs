//! Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.

mod error;
pub mod local;
pub mod number;

pub use error::{Error, Result};
