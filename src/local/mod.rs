//! The local map in two dimensions: u_k, b_{n,k}, c_n at one point, on every rung of
//! [`number`](crate::number).
//!
//! A point is given by (r, s), eigenvalues r·e^{±2πis} ([`Polar`], region 3), or by trace and determinant
//! (a₁, a₂) ([`Plane`], every region). Both evaluate the same quantities of a single-impact orbit of
//! period n, equations (59) and (60),
//!
//! ```text
//! b_{n,k} = (u_n − u_k − a₂^k u_{n−k}) / u_n,   c_n = −(1 − v_n + a₂ⁿ) / u_n,
//! ```
//!
//! by forms that do not cancel where they need not. [`Ladder`] decides their signs with as few bits as it
//! can. Where u_n = 0 nothing is defined: that is [`Singular`](Answer::Singular), an answer of its own.
//! Not here: what the signs mean for existence (`existence`).

#[cfg(test)]
mod both_ways;
#[doc(hidden)]
pub mod condition;
mod forward;
mod ladder;
mod plane;
mod point;
mod polar;
mod quick;
mod zero_test;

pub use forward::Forward;
pub use ladder::{Answer, Ladder, Rung, SignDecision, direct_signs, sign_by, sign_on};
pub use plane::{Plane, Region};
pub use point::{Point, Quantity};
pub use polar::Polar;
