//! Farey fractions: neighbours, the Stern–Brocot tree, the sequences F_N, rank and k-th term.
//!
//! Fractions are [`Ratio`](num_rational::Ratio)s in lowest terms over any machine integer or `BigInt`; where
//! Farey arithmetic itself guarantees lowest terms no gcd is taken. Nothing wraps: a value that does not fit
//! its type is an overflow error, or ruled out by a bound that the function states. What the fractions mean
//! for impact oscillators is not here but in the module `existence`.
//!
//! ```
//! use grazing::farey::{kth, next, path, rank, Turn};
//! use grazing::num_rational::Ratio;
//! let x = Ratio::new(3u64, 8);
//! // The term after 3/8 in F_10, and its place in F_1000000.
//! assert_eq!(next(&x, &10)?, Ratio::new(2, 5));
//! assert_eq!(kth(rank(&x, 1_000_000)?, 1_000_000)?, x);
//! // In the Stern–Brocot tree: left twice, right once, left once.
//! assert_eq!(path(&x)?, [(Turn::Left, 2), (Turn::Right, 1), (Turn::Left, 1)]);
//! # Ok::<(), grazing::Error>(())
//! ```

mod neighbours;
mod rank;
mod sequence;
mod tree;
mod walk;

pub use neighbours::{Neighbours, neighbours};
pub(crate) use rank::floor_sum;
pub use rank::{Ranker, kth, rank};
pub use sequence::{Sequence, bracket, next, previous};
pub use tree::{BreadthFirst, Gap, InOrder, Turn, from_path, path};
pub use walk::Walk;

use num_integer::Integer;
use num_traits::{CheckedAdd, CheckedMul, CheckedSub};

/// What the Farey functions ask of an integer type: the primitive integers and `BigInt`, `BigUint` have it.
pub trait FareyInteger: Integer + Clone + CheckedAdd + CheckedSub + CheckedMul {}

impl<T: Integer + Clone + CheckedAdd + CheckedSub + CheckedMul> FareyInteger for T {}
