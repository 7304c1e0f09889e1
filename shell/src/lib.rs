//! The command `grazing`: arguments, what each command runs, tables, pictures with the data of each beside
//! them, exit codes. No mathematics lives here; it is in the library `grazing`, which takes longer to
//! compile. An edit here does not compile that again.
//!
//! `cli` reads arguments and writes reports, `figure` draws. `cli` uses `figure`, never the reverse.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod cli;
mod figure;

// The library's chapters, under the names that they have there.
use grazing::{
    certificate, continuation, existence, farey,
    internals::{output, printable, processor, random, rows, study},
    local, many, motion, number, one, pattern, run, scene, search, symbol, tolerance, word,
};

mod error {
    pub(crate) use grazing::{Error, Result};
}
mod monitor {
    pub(crate) use grazing::{Monitor, internals::timed};
}
mod outcome {
    pub(crate) use grazing::Outcome;
}
mod profile {
    pub(crate) use grazing::Profile;
}

pub use cli::main;
#[doc(hidden)]
pub use figure::text_width;

/// This program, as its shards and saved states name it: the library's name for itself, and a hash of the
/// sources of this package, which decide how rows are written.
fn program() -> String {
    format!("{}.{}", output::PROGRAM, env!("GRAZING_SHELL_SOURCES"))
}
