//! The commands of the theory, and what every command of grazing has: arguments, reports, progress, shards,
//! exit codes. No mathematics lives here; it is in the library `grazing`, which takes longer to compile. An
//! edit here does not compile that again.
//!
//! `grazing-shell` has the same commands, and those of scenes and pictures.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

#[doc(hidden)]
pub mod cli;

// The library's chapters, under the names that they have there.
use grazing::{certificate, existence, farey, local, number, pattern, rows, search, symbol, tolerance, word};
use grazing_base::{error, monitor, outcome, output, printable, processor, profile, quantity, source, typed};

#[doc(hidden)]
pub use cli::{Commands, Theory, main};

/// The hash of this chapter's sources.
pub const SOURCES: &str = env!("GRAZING_SOURCES");

/// This program, as its shards and saved states name it. Shards of the theory's commands are the same by
/// whichever program.
fn program() -> String {
    output::program(&[grazing_base::SOURCES, grazing::SOURCES, SOURCES])
}
