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
//! it is open. [`Word::in_rectangle`] does the same for all points of a [`Rectangle`] at once, which may meet
//! several regions.
//! [`ClosedWalks`] counts the patterns of a relation by period and encloses its topological entropy.
//! [`Returns`] are the first-return times to a line for eigenvalues of any modulus, which have the same word.
//! [`two_impacts`] lists the Farey intervals on r = 1 where patterns of two impacts exist.
//!
//! ```
//! use grazing::{
//!     local::{Ladder, Point, Polar},
//!     number::parse_rational,
//!     word::{ClosedWalks, Entropy, Relation, Word, two_impacts},
//! };
//! let point = Point::Polar(Polar::new(parse_rational("0.9")?, parse_rational("0.37")?)?);
//! let word = Word::at(&Ladder::default(), &point, true, 100, &())?;
//! assert_eq!((word.letters().as_str(), word.is_whole()), ("DUD", true));
//! // For γ < 0 the periods 1 and 3 may follow themselves: chaos is born.
//! let relation = Relation::new(&word, false, false, 100)?;
//! assert_eq!(relation.loops(), [1, 3]);
//! assert!(relation.is_chaotic());
//! // One pattern has period 1; the number for period n grows like e^(0.528 n).
//! assert_eq!(ClosedWalks::new(&relation).count(1)[0].all, 1u32.into());
//! let (entropy, at_least) = Entropy::of(&word, false, 64)?;
//! let (lower, upper) = entropy.bounds().expect("patterns exist");
//! assert!(parse_rational("0.52804890")? < lower && upper < parse_rational("0.52804891")? && !at_least);
//! // On r = 1 the pattern (3, 5) exists on six intervals of s.
//! assert_eq!(two_impacts(3, 5)?.len(), 6);
//! # Ok::<(), grazing::Error>(())
//! ```
//!
//! Not here: maps of three or more dimensions, where no word decides (`pattern`), and a₂ ≤ 0.

mod count;
mod entropy;
mod path;
mod rectangle;
mod relation;
mod returns;
mod two_impacts;

pub use count::{ClosedWalks, PatternCount};
pub use entropy::Entropy;
use path::alike;
pub(crate) use path::{At, Realm, Signs};
pub use path::{Extent, Letter, MAX_LETTERS, Vertex, Word};
pub use rectangle::Rectangle;
pub use relation::{Edge, MAX_RELATION, Relation};
pub use returns::{ReturnKind, ReturnPiece, Returns, place};
pub use two_impacts::{PatternInterval, two_impacts, two_impacts_of};
