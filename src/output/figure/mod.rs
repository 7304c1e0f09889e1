//! The project's figures: vector graphics with the data of each in a CSV file of the same name.

mod intervals;
mod orbits;

pub use intervals::intervals;
pub use orbits::{orbit, orbits};
