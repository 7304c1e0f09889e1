//! What accuracy costs: families of inputs, and each rung's time, certain digits and decided signs on them;
//! of simulations, time against error and the cost of each effect.
//!
//! Also the formulas as the paper prints them, in plain `f64`, to show what they lose. Nothing here is used
//! elsewhere.

pub mod effects;
mod families;
pub mod flow_accuracy;
mod measure;
mod naive;

pub use families::{FAMILIES, Input, InputFamily};
pub use measure::{Evaluation, Measured, condition, measure};
pub use naive::naive_b;
