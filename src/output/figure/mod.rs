//! The project's figures: vector graphics with the data of each in a CSV file of the same name.

mod intervals;

pub use intervals::intervals;
