//! Certificates of every kind: what is written passes, what is damaged is rejected unless it is still true.

#[path = "../common/mod.rs"]
mod common;
#[path = "../systems/mod.rs"]
mod systems;

mod chaos;
#[cfg(unix)]
mod check;
mod cover;
mod event;
mod free;
mod machine;
mod orbit;
mod overflow;
mod range;
mod range_harmonics;
mod range_motions;
mod range_random;
mod theorem2;
mod validated;
