//! Every impact pattern in two dimensions, for all periods at once: the word theorem.
//!
//! Condition (64) says which period may follow which between impacts. With
//!
//! ```text
//! p_n = (u_{n+1} − 1)/u_n,   q_n = (a₂ⁿ + a₂ u_{n−1})/u_n,   σ = sign(eµ) sign(γ)
//! ```
//!
//! period j may follow period i iff σ(p_j − q_i) > 0; a pattern exists iff it is a closed walk of that
//! relation over the periods n whose b_{n,k} all have the sign of eµ. Those periods are, for eµ > 0 in region
//! 3, an initial piece of the Stern–Brocot path to s, each period the denominator of a fraction above s
//! (letter U, c_n > 0) or below it (letter D, c_n < 0). The whole relation, for both signs of γ, follows from
//! that [`Word`] alone: see [`Word::edge`]. `proofs/words.md` has the proof.
//!
//! [`Word::at`] walks the path and decides one sign per step on the ladder; an answer is certain or says that
//! it is open. [`Word::in_rectangle`] does the same for all points of a [`Rectangle`] at once.
//! [`ClosedWalks`] counts the patterns of a relation by period and encloses its topological entropy.
//! [`two_impacts`] lists the Farey intervals on r = 1 where patterns of two impacts exist.
//!
//! Not here: maps of three or more dimensions, where no word decides (`pattern`), and a₂ ≤ 0.

mod count;
mod entropy;
mod path;
mod rectangle;
mod relation;
mod two_impacts;

pub use count::{ClosedWalks, PatternCount};
pub use entropy::Entropy;
pub(crate) use path::{At, Signs};
pub use path::{Extent, Letter, MAX_LETTERS, Vertex, Word};
pub use rectangle::Rectangle;
pub use relation::{Edge, MAX_RELATION, Relation};
pub use two_impacts::{PatternInterval, two_impacts, two_impacts_of};
