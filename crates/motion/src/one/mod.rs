//! The engine for one degree of freedom: its motions with impacts, many at once where that pays, its periodic
//! orbits, where they graze, its branches and attractors.
//!
//! From the bottom up: [`simulate`], the motion with impacts; [`orbit`], periodic orbits of any impact
//! pattern; [`grazing`], where they graze, with the local map there; [`branch`], what `continuation` asks of
//! them; [`attractor`], what the chapter of that name asks, and what is asked of these alone. Not here:
//! what any engine shares (`motion`, `continuation`, `attractor`); machines of several coordinates (`many`,
//! which imports nothing from here, nor this from there); proofs (`search`).

pub mod attractor;
pub mod branch;
pub mod grazing;
pub mod orbit;
pub mod simulate;
mod size;
