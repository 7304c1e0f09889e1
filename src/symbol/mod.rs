//! The formulas as symbols: exact integer polynomials, their known factors, and the statements as closed
//! sentences, printed for a reader or for a tool that we did not write.
//!
//! - [`Polynomial`]: integer polynomials in two variables, nothing more than these formulas need.
//! - [`period_formulas`]: u_n, u_k, N_{n,k} and 1 − v_n + a₂ⁿ in (a₁, a₂) with every factor that is proved to
//!   divide them.
//! - [`chebyshev_roots`]: rationals that provably separate the roots cos(πj/n) of u_n.
//! - [`Sentence`]: what holds in region 4 and on one half-cell of region 3, for one n, free of division.
//!
//! No numbers are decided here (that is `local`) and no solver is run: a sentence is text.
//!
//! ```
//! use grazing::symbol::{Area, Format, Sentence, period_formulas, write_formulas};
//! let text = write_formulas(&period_formulas(5, 2)?, Format::Text);
//! assert!(text.contains("N_{5,2} = u_5 - u_2 - a2^2*u_3"));
//! let sentence = Sentence::new(5, Area::Region4)?.write(Format::Smtlib);
//! assert!(sentence.ends_with("(check-sat)\n"));
//! # Ok::<(), grazing::Error>(())
//! ```

mod formula;
mod polynomial;
mod print;
mod roots;
mod sentence;

pub use formula::{Factored, MAX_PERIOD, period_formulas, write_formulas};
pub use polynomial::Polynomial;
pub use print::Format;
pub use roots::{chebyshev_roots, roots_above};
pub use sentence::{Area, HalfCellSide, MAX_SENTENCE_PERIOD, Sentence};
