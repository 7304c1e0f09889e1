//! The program `grazing`: the commands of the theory, which are `grazing-verify`'s, and those of scenes and
//! pictures, with the data of each beside it. No mathematics lives here.
//!
//! `cli` reads arguments and writes reports, `figure` draws. `cli` uses `figure`, never the reverse.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod cli;
mod figure;

// The library's chapters, under the names that they have there.
use grazing_base::{error, monitor, output, printable, profile, random};
use grazing_scenes::{
    answer, certificate, continuation, existence, farey, local, many, motion, number, one, pattern, run,
    scene, search, tolerance, word,
};
use grazing_study as study;

pub use cli::main;
#[doc(hidden)]
pub use figure::text_width;

/// This program, as its shards of scenes' tasks name it: every chapter decides their rows.
fn program() -> String {
    output::program(&[
        grazing_base::SOURCES,
        grazing::SOURCES,
        grazing_motion::SOURCES,
        grazing_prove::SOURCES,
        grazing_scenes::SOURCES,
        grazing_verify::SOURCES,
        env!("GRAZING_SOURCES"),
    ])
}
