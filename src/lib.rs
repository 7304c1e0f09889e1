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
//! - For a linear oscillator with walls: that an exact periodic orbit with a given impact pattern exists, is
//!   the only one in a box, touches no wall else, and is stable or not; and where in a parameter orbits meet,
//!   double their period or graze ([`search::orbit`]); of the motion without impacts that it is alone and
//!   clear of every wall. The same of linear machines with rigid stops ([`search::machine`]). All have
//!   certificates ([`certificate::orbit`], [`certificate::event`], [`certificate::machine`]).
//! - That every word over an alphabet of return times is an orbit of an oscillator, for a range of µ with 0
//!   at its end: chaos ([`search::chaos`], [`certificate::chaos`]). That what is born at a touch goes on,
//!   word by word, from the touch to a distance ([`search::range`], [`certificate::range`]).
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
//! - Trajectories of impact oscillators with one degree of freedom, in f64: every impact deeper than a stated
//!   bound ([`one::simulate`]); of machines with any number of degrees of freedom and of rigid and compliant
//!   stops, linear or with forces written as formulas, in real units ([`many::simulate`]).
//! - Of both: sections, attractors, Lyapunov exponents, basins, diagrams ([`attractor`]); periodic orbits
//!   with any impact pattern ([`one::orbit`], [`many::orbit`]), their grazing points with the local theory
//!   there ([`one::grazing`], [`many::grazing`]), branches of them over a parameter with their bifurcations
//!   ([`continuation`]): floating point, without proof.
//! - The formulas as integer polynomials, and statements about them for solvers ([`symbol`]).
//!
//! # When to use it, and when not
//!
//! Use it to attach a checked proof to a statement about these orbits, to ask which orbits a grazing
//! bifurcation gives birth to, to simulate an oscillator with impacts, or for exact Farey arithmetic. Do not
//! use it for maps with more than one square-root direction. Nordmark's Theorem 1, which turns signs into
//! orbits, is proved for maps in `proofs/`, and its conclusion for linear oscillators from their differential
//! equation. That a nonlinear oscillator near grazing has such a map is the paper's section 3.1, not proved.
//!
//! # Map
//!
//! Dependencies point one way, from the bottom of this table up; `certificate` is the package
//! `grazing-check`, which depends on nothing, and `number` is `grazing-number`.
//!
//! | module | holds |
//! | --- | --- |
//! | [`certificate`] | the certificate format and its checker: the trusted code |
//! | [`number`] | exact numbers and their text form; enclosures at every precision; certain signs |
//! | [`farey`] | neighbours, tree, sequence, rank |
//! | [`symbol`] | u_n, N_{n,k} as polynomials in (a₁, a₂); sentences for solvers |
//! | [`local`] | u_k, b_{n,k}, c_n at one point on every rung; the ladder of signs |
//! | [`existence`] | Theorem 2 and Conjecture 1: claims, decisions, the edges of the areas |
//! | [`word`] | the word theorem: every impact pattern in two dimensions, their number and entropy |
//! | [`tolerance`] | machines as measured: words and shares on boxes of parameters |
//! | [`pattern`] | Theorem 1 in any dimension: impact patterns, the pattern graph |
//! | [`motion`] | what moves: forces, series, the equation of one coordinate, its free motion, the minimum test |
//! | [`continuation`] | curves of orbits, events on them, switching, multipliers, Newton's method, normal forms |
//! | [`attractor`] | where motions end: sections, recurrence, basins, diagrams, exponents |
//! | [`one`] | the engine for one degree of freedom: motions, orbits, grazing |
//! | [`many`] | the engine for machines: any number of coordinates and of stops, in real units |
//! | [`search`] | what finds certificates and looks for counterexamples |
//! | [`scene`] | an oscillator or a machine and what to do with it, as a file |
//! | [`run`] | the tasks of a scene run, each with a typed result |
//! | [`Error`], [`Outcome`], [`Monitor`], [`Profile`] | what goes wrong; how work ends; how a long job reports and is ended; where its time goes |
//!
//! Not public, and below the table, for every part: `formula` (as trees), `printable` (text of others on its
//! way out), `processor` (its time, its threads), `random` (the same choices on every machine),
//! `output` (files that are whole or absent, saved states, tables), `source` (errors that name file, line and
//! key). Above it: `study` (what accuracy costs). The command line and its pictures are a package of their
//! own, `grazing-shell`, which uses this one. `tests/structure.rs` holds the sources to this order.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod attractor;
pub mod continuation;
mod error;
pub mod existence;
pub mod farey;
mod formula;
#[doc(hidden)]
pub mod internals;
pub mod local;
pub mod many;
mod monitor;
pub mod motion;
pub mod one;
mod outcome;
mod output;
pub mod pattern;
mod printable;
mod processor;
mod profile;
mod random;
pub mod run;
pub mod scene;
pub mod search;
mod source;
mod study;
pub mod symbol;
pub mod tolerance;
pub mod word;

pub use error::{Error, Result, Spot};
pub use grazing_check as certificate;
pub use grazing_number as number;
pub use monitor::Monitor;
/// The package of the integers in this interface.
pub use num_bigint;
/// The package of the exact fractions in this interface.
pub use num_rational;
pub use outcome::Outcome;
pub use profile::{Profile, Spent};
