//! What the project's own programs use besides: tests and benches, the Python package. No part of the
//! interface: it changes without notice.

pub use grazing::rows;
pub use grazing_base::{
    monitor::timed,
    output, printable,
    processor::{self, threads},
    random,
};

/// The machine's linear algebra, with matrices of a package of others.
pub mod many {
    pub use grazing_motion::many::{
        contact::{Contacts, StopContact},
        equations::{LinearEquations, Periodic},
        flow::LinearFlow,
        slope::Slope,
    };
}
