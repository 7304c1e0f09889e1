//! The commands of the theory: what they write, print and refuse; and certificates of covers, by the command.

/// The command that these tests start.
const PROGRAM: &str = env!("CARGO_BIN_EXE_grazing-verify");

#[path = "../common/mod.rs"]
mod common;
#[path = "../process/mod.rs"]
mod process;
#[path = "../samples/mod.rs"]
mod samples;

mod boundary;
mod cover;
mod cover_certificates;
mod elsewhere;
mod entropy;
mod fuzz;
mod measure;
mod measured;
mod sequences;
mod share;
mod words;
