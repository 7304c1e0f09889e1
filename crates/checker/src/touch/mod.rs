//! A linear oscillator with a rigid wall, near the touch: what certificates of kinds `chaos`, `range` and
//! `nothing` are about, in the normal form of `proofs/chaos.md`.
//!
//! The free motion is `flow`, the wall `wall`, impacts and the legs between them `legs`, the graph of letters
//! `graph`, what motions near the touch can do `near` and, before it, `settled`; `text` reads what the kinds
//! write alike. What is proved of all this is said and done by the kinds.

pub(crate) mod about;
pub(crate) mod among;
pub(crate) mod carry;
pub(crate) mod flow;
pub(crate) mod graph;
pub(crate) mod legs;
pub(crate) mod near;
mod settled;
pub(crate) mod text;
pub(crate) mod wall;

/// Numbers in units of 2⁻⁴⁸. The proofs of these kinds need few digits: their boxes are wide.
pub(crate) type Interval = crate::interval::Fixed<48>;
