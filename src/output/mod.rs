//! What leaves the program: tables in six formats, files that are whole or absent, journals, figures, progress.

mod bounds;
mod destination;
pub mod figure;
mod journal;
mod progress;
mod table;

pub use bounds::{decimal_above, decimal_below, decimal_near};
pub use destination::{Destination, write_file};
pub use figure::{accuracy_figure, accuracy_table};
pub use journal::Journal;
pub use progress::{Interrupt, Progress};
pub use table::{Cell, Column, TableFormat, TableWriter, decimal};
