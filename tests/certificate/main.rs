//! Certificates of every kind: what is written passes, what is damaged is rejected unless it is still true.

/// The command that these tests start.
const PROGRAM: &str = env!("CARGO_BIN_EXE_grazing");

#[path = "../common/mod.rs"]
mod common;
#[path = "../samples/mod.rs"]
mod samples;
#[path = "../systems/mod.rs"]
mod systems;

mod chaos;
#[cfg(unix)]
mod check;
mod claims;
mod event;
mod free;
mod machine;
mod orbit;
mod range;
mod range_harmonics;
mod range_motions;
mod range_random;
mod validated;
