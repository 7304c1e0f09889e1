//! The number theory and Theorem 1: every claim against other routes, exact fractions and brute force.

#[path = "../common/mod.rs"]
mod common;
#[path = "../reader/mod.rs"]
mod reader;
#[path = "../samples/mod.rs"]
mod samples;

mod appendix_b;
mod boundary;
mod classify;
mod cover;
mod decay;
mod enclosures;
mod entropy;
mod farey;
mod flights;
mod fuzz;
mod hard_cases;
mod map_input;
mod measure;
mod overflow;
mod patterns;
mod pieces;
mod share;
mod smooth_map;
mod solvers;
mod symbols;
mod theorem2;
mod theorem2_certificates;
mod tolerance;
mod windows;
mod words;
