//! What every chapter of grazing stands on, but for numbers: errors, how work ends and reports, what leaves
//! the program, sources of files, random choices, time and threads. No mathematics, and no interface for
//! others: it changes without notice.
//!
//! | module | holds |
//! | --- | --- |
//! | [`printable`] | text of others on its way out |
//! | [`error`], [`outcome`] | what goes wrong; how work ends |
//! | [`processor`], [`profile`], [`monitor`] | time and threads; where time goes; how a long job reports and is ended |
//! | [`random`] | the same choices on every machine |
//! | [`quantity`] | units and what they are units of |
//! | [`typed`] | what hands type where numbers are wanted |
//! | [`output`] | files that are whole or absent, saved states, shards, tables |
//! | [`source`] | errors that name file, line and key |

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod error;
pub mod monitor;
pub mod outcome;
pub mod output;
pub mod printable;
pub mod processor;
pub mod profile;
pub mod quantity;
pub mod random;
pub mod source;
pub mod typed;

use grazing_number as number;

/// The hash of this chapter's sources, of those of the numbers, and of the versions of all packages.
pub const SOURCES: &str = env!("GRAZING_SOURCES");
