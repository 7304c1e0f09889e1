//! What leaves the program, for every part: tables in six formats, files that are whole or absent, journals, rounded decimals.

mod bounds;
mod destination;
mod journal;
mod table;

pub use bounds::{decimal_above, decimal_below, decimal_near};
pub use destination::{Destination, write_file};
pub use journal::Journal;
pub use table::{Cell, Column, TableFormat, TableWriter, decimal};
