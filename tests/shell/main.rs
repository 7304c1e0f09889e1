//! The command as a shell, a reader of its tables and a cluster meet it.

/// The command that these tests start.
const PROGRAM: &str = env!("CARGO_BIN_EXE_grazing");

#[path = "../process/mod.rs"]
mod process;
#[path = "../samples/mod.rs"]
mod samples;

mod answer;
mod arguments;
mod cli;
mod decay;
mod drawn_machines;
mod export;
mod figures;
mod parsers;
#[cfg(target_os = "linux")]
mod reliability;
mod reports;
mod schemas;
mod shards;
#[cfg(target_os = "linux")]
mod shell;
mod surface;
