//! Motions, orbits, grazings and branches, of oscillators and of machines: against closed formulas, against
//! engines that share no code with these, against one another.

#[path = "../tasks/paper.rs"]
mod paper;
#[path = "../samples/mod.rs"]
mod samples;

mod branches;
mod codimension_two;
mod detector;
mod grazing;
mod machine_orbits;
mod machines;
mod orbit_runs;
mod orbits;
mod references;
mod rest;
mod searches;
mod simulation;
