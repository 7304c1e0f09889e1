//! What finds proofs and writes them down as certificates. Untrusted: the checker in
//! [`certificate`](crate::certificate) shares no code with it.
//!
//! ```
//! use grazing::certificate;
//! use grazing::search::{ProofMethod, prove_theorem2, write_theorem2};
//! let proof = prove_theorem2(3..=8, ProofMethod::Exact, &())?;
//! assert!(proof.refuted.is_none() && proof.pending == 0);
//! let mut text = Vec::new();
//! write_theorem2(3..=8, &proof, &mut text, &())?;
//! assert_eq!(certificate::check(&mut &text[..])?.range, Some(3..=8));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod accepted;
mod apart;
mod compare;
pub mod cover;
mod entropy;
pub mod fuzz;
mod instance;
mod share;
mod theorem2;
mod word;

pub use accepted::{Accepted, Claimed};
pub use entropy::entropy_certificate;
pub use instance::Instance;
pub use share::{ShareStatement, certify_share};
pub use theorem2::{Proof, ProofMethod, assemble_theorem2, prove_theorem2, theorem2_blocks, write_theorem2};
pub use word::{Certified, WordCertificate, WordPlace, certify_word};
