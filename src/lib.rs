//! Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.

mod error;
pub mod number;
pub mod symbol;

pub use error::{Error, Result};
