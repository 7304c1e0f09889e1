//! Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.

pub mod certificate;
pub mod cli;
mod error;
pub mod existence;
pub mod farey;
pub mod impact;
pub mod local;
mod monitor;
pub mod number;
pub mod output;
pub mod search;

pub use error::{Error, Result};
pub use monitor::Monitor;
