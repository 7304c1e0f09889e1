//! What accuracy costs: the price of a sign and digits against time on families of inputs, errors of
//! simulations against time, the cost of each effect; of proofs, bits, time and size. And machines beside
//! their touch.
//!
//! Also the formulas as the paper prints them, in plain `f64`, to show what they lose. Nothing here is used
//! elsewhere.

// They panic once nobody reads; `output` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod computer;
mod digits;
pub mod effects;
mod families;
pub mod flow_accuracy;
mod gaps;
mod measure;
mod naive;
mod proofs;
mod sign_price;
pub mod simulations;
mod touches;
mod zeros;

pub use digits::{DigitsPrice, INPUTS, METHODS, digits_prices};
pub use families::{FAMILIES, InputFamily};
pub use gaps::{Hit, Proved, Stretch, eigenvalue, gaps};
pub use proofs::{CHAOS, PAPER, ProofCost, ProofSizes, proof_costs};
pub use sign_price::{DISTANCES, QUICK_DISTANCES, SignMethod, SignPrice, sign_prices};
pub use touches::{RESTITUTION, Sight, TouchSample, touch_samples};
pub use zeros::{ZERO_FAMILIES, ZeroFamily};

use grazing::{existence, local, word};
use grazing_base::{error, monitor, random};
use grazing_check as certificate;
use grazing_motion::{many, motion, one};
use grazing_number as number;
use grazing_scenes::{run, scene, search};

/// The hash of this chapter's sources.
pub const SOURCES: &str = env!("GRAZING_SOURCES");
