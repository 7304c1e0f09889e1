//! The project's figures: vector graphics with the data of each in a CSV file of the same name.

mod accuracy;
mod intervals;
mod orbits;

pub use accuracy::{accuracy_figure, accuracy_table};
pub use intervals::intervals;
pub use orbits::{orbit, orbits};
