//! Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.

pub mod certificate;
mod error;
pub mod cli;
pub mod existence;
pub mod farey;
mod monitor;
pub mod number;
pub mod output;
pub mod search;
pub mod symbol;

pub use error::{Error, Result};
pub use monitor::Monitor;
