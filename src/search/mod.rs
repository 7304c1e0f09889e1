//! What finds proofs and writes them down as certificates. Untrusted: the checker in
//! [`certificate`](crate::certificate) shares no code with it.

mod apart;
mod compare;
pub mod cover;
pub mod fuzz;
mod instance;
mod theorem2;
mod word;

pub use instance::Instance;
pub use theorem2::{Proof, ProofMethod, assemble_theorem2, prove_theorem2, theorem2_blocks, write_theorem2};
pub use word::{Certified, WordCertificate, WordPlace, certify_word};
