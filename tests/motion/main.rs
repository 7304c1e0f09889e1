//! Motions, orbits, grazings and branches, of oscillators and of machines: against closed formulas, against
//! engines that share no code with these, against one another.

/// The command that these tests start.
const PROGRAM: &str = env!("CARGO_BIN_EXE_grazing");

#[path = "../samples/mod.rs"]
mod samples;
#[path = "../tasks/mod.rs"]
mod tasks;

mod branches;
mod codimension_two;
mod detector;
mod grazing;
mod machine_branches;
mod machine_orbits;
mod machines;
mod orbit_runs;
mod orbits;
mod references;
mod rest;
mod searches;
mod simulation;
