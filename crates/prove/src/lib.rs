//! What finds certificates of motions and writes them down: of orbits and events of oscillators, of machines,
//! of chaos, of ranges that begin at a touch, of what attracts beyond it. Untrusted: the checker,
//! `grazing-check`, shares no code with it. And [`touch`], where the theory meets a grazing that an engine
//! has found. `grazing-scenes` has these modules as `search`.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod attractor;
mod between;
pub mod chaos;
pub mod machine;
pub mod orbit;
pub mod range;
pub mod touch;

use grazing::{search::Accepted, tolerance, word};
use grazing_base::{error, monitor};
use grazing_check as certificate;
use grazing_motion::{many, motion};
use grazing_number as number;

/// The hash of this chapter's sources.
#[doc(hidden)]
pub const SOURCES: &str = env!("GRAZING_SOURCES");
