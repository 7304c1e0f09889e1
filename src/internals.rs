//! What the project's own programs use besides: its command line, tests and benches, the Python package. No
//! part of the interface: it changes without notice.

pub use crate::{monitor::timed, processor::threads};

pub mod rows;

/// What leaves the program.
pub mod output {
    pub use crate::output::*;
}
/// The machine's linear algebra, with matrices of a package of others.
pub mod many {
    pub use crate::many::{
        contact::{Contacts, StopContact},
        equations::{LinearEquations, Periodic},
        flow::LinearFlow,
        slope::Slope,
    };
}
/// Text of others on its way out.
pub mod printable {
    pub use crate::printable::{Printable, csv_field, is_printable};
}
/// Time, threads, memory.
pub mod processor {
    pub use crate::processor::{most_memory, process_seconds, threads};
}
/// The same choices on every machine.
pub mod random {
    pub use crate::random::Random;
}
/// What accuracy costs.
pub mod study {
    pub use crate::study::*;
}
