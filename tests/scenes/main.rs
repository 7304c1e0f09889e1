//! Scenes: what is read, what runs of them report, and every form of a question.

/// The command that these tests start.
const PROGRAM: &str = env!("CARGO_BIN_EXE_grazing");

#[path = "../common/mod.rs"]
mod common;
#[path = "../samples/mod.rs"]
mod samples;
#[path = "../tasks/mod.rs"]
mod tasks;

mod bifurcations;
mod formats;
mod forms;
mod friction_branches;
mod input;
mod machine_branches;
mod measured;
mod monitors;
mod proved_branches;
mod proved_clocks;
mod proved_ranges;
mod proved_units;
mod quantities;
mod restarts;
mod scales;
mod scene_runs;
mod section4;
mod task_reports;
