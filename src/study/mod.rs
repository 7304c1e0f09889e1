//! What accuracy costs: families of inputs, and each rung's time, certain digits and decided signs on them;
//! of simulations, time against error and the cost of each effect; of proofs, bits, time and size.
//!
//! Also the formulas as the paper prints them, in plain `f64`, to show what they lose. Nothing here is used
//! elsewhere.

pub mod computer;
pub mod effects;
mod families;
pub mod flow_accuracy;
mod measure;
mod naive;
mod proofs;
mod sign_price;
mod zeros;

pub use families::{FAMILIES, Input, InputFamily};
pub use measure::{Evaluation, Measured, condition, measure};
pub use proofs::{ProofCost, ProofSizes, proof_costs};
pub use sign_price::{DISTANCES, QUICK_DISTANCES, SignMethod, SignPrice, sign_prices};
pub use zeros::{ZERO_FAMILIES, ZeroFamily};
