//! What accuracy costs: the price of a sign and digits against time on families of inputs, errors of
//! simulations against time, the cost of each effect; of proofs, bits, time and size. And machines beside
//! their touch.
//!
//! Also the formulas as the paper prints them, in plain `f64`, to show what they lose. Nothing here is used
//! elsewhere.

pub mod computer;
mod digits;
pub mod effects;
mod families;
pub mod flow_accuracy;
mod measure;
mod naive;
mod proofs;
mod sign_price;
pub mod simulations;
mod touches;
mod zeros;

pub use digits::{DigitsPrice, INPUTS, METHODS, digits_prices};
pub use families::{FAMILIES, InputFamily};
pub use measure::condition;
pub use proofs::{CHAOS, PAPER, ProofCost, ProofSizes, proof_costs};
pub use sign_price::{DISTANCES, QUICK_DISTANCES, SignMethod, SignPrice, sign_prices};
pub use touches::{RESTITUTION, TouchSample, touch_samples};
pub use zeros::{ZERO_FAMILIES, ZeroFamily};
