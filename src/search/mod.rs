//! What finds proofs and writes them down as certificates. Untrusted: the checker in
//! [`certificate`](crate::certificate) shares no code with it.

pub mod cover;
pub mod fuzz;
mod theorem2;

pub use theorem2::{Method, Proof, prove_theorem2, write_theorem2};
