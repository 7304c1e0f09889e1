//! Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.
//!
//! When a parameter µ brings a periodic orbit of an oscillator to touch a stop with zero velocity, the map
//! from period to period is g ∘ f with f smooth and g containing a square root (A. B. Nordmark, Nonlinearity
//! 14 (2001) 1517–1542). For one degree of freedom the linear part of f has trace a₁ and determinant a₂, and
//! orbits of period n with one impact exist according to the signs of the numbers b_{n,k} (59) and c_n (60),
//! by his conditions (52), (53).
//!
//! # What is proved
//!
//! - Theorem 2, for given n: on r = 1 (a₁ = 2 cos 2πs, a₂ = 1) the set of s with an orbit is exactly a list
//!   of intervals between Farey fractions. [`existence::decide`] decides it by integer arithmetic,
//!   [`existence::decide_by_enclosure`] by enclosures; [`search`] writes certificates;
//!   [`certificate::check`], which shares no code with any of them, proves them again. (For all n at once,
//!   Theorem 2 and Conjecture 1 are proved in Coq, under `proofs/`.)
//! - Conjecture 1, for given n and r ≤ r_max < 1: by covers of region 3 with boxes, found by
//!   [`search::cover`] and proved by [`certificate::cover`], and by polynomial identities in regions 2 and 4.
//! - The word theorem: which impact patterns give orbits of the plane map, with covers of words as
//!   certificates ([`word`], [`certificate::word`]), and the most that their number grows on r = 1
//!   ([`search::entropy_certificate`]).
//!
//! # What is computed
//!
//! - The intervals themselves, by modular inverses and by the Farey tree ([`existence`]); Farey fractions of
//!   any size ([`farey`]).
//! - At one point, r < 1 included: which orbits exist, by certain signs only ([`existence::by_definition`],
//!   [`existence::by_records`]); b_{n,k} and c_n to any number of certain digits ([`local`]).
//! - The lower edges of the areas of Conjecture 1, r < 1, and their lowest points, certified to any number of
//!   digits ([`existence::Boundary`]).
//! - For a local map of any dimension, exact or enclosed: which impact patterns give orbits, by Theorem 1
//!   ([`pattern`]).
//! - The formulas as integer polynomials, and statements about them for solvers ([`symbol`]).
//!
//! # When to use it, and when not
//!
//! Use it to attach a checked proof to a statement about these orbits, to ask which orbits a grazing
//! bifurcation gives birth to, or for exact Farey arithmetic. To simulate an oscillator with impacts, follow
//! its orbits, or prove something of them, use `grazing-scenes`, which has all of this, too. Do not use it
//! for maps with more than one square-root direction. Nordmark's Theorem 1, which turns signs into orbits, is
//! proved for maps in `proofs/`, and its conclusion for oscillators, linear or not, from their differential
//! equation: of nonlinear ones, the paper's section 3.1, with a touch of either stop and no other impact.
//!
//! # Map
//!
//! Imports point one way, from the bottom of this table up. Below it: `grazing-number` (as `number`),
//! `grazing-check` (as `certificate`: the trusted code, which depends on nothing), `grazing-base` (errors,
//! output). `DESIGN.md` has the chapters above it.
//!
//! | module | holds |
//! | --- | --- |
//! | [`farey`] | neighbours, tree, sequence, rank |
//! | [`symbol`] | u_n, N_{n,k} as polynomials in (a₁, a₂); sentences for solvers |
//! | [`local`] | u_k, b_{n,k}, c_n at one point on every rung; the ladder of signs |
//! | [`existence`] | Theorem 2 and Conjecture 1: claims, decisions, the edges of the areas |
//! | [`rows`] | the rows of a table of intervals, by all threads |
//! | [`word`] | the word theorem: every impact pattern in two dimensions, their number and entropy |
//! | [`tolerance`] | machines as measured: words and shares on boxes of parameters |
//! | [`pattern`] | Theorem 1 in any dimension: impact patterns, the pattern graph |
//! | [`search`] | what finds certificates and looks for counterexamples |

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod existence;
pub mod farey;
pub mod local;
pub mod pattern;
#[doc(hidden)]
pub mod rows;
pub mod search;
pub mod symbol;
pub mod tolerance;
pub mod word;

use grazing_base::{error, monitor, output, processor, profile, random, source};
pub use grazing_base::{
    error::{Error, Result, Spot},
    monitor::Monitor,
    outcome::Outcome,
    profile::{Profile, Spent},
};
pub use grazing_check as certificate;
pub use grazing_number as number;
/// The package of the integers in this interface.
pub use num_bigint;
/// The package of the exact fractions in this interface.
pub use num_rational;

/// The hash of this chapter's sources and of the checker's.
#[doc(hidden)]
pub const SOURCES: &str = env!("GRAZING_SOURCES");
