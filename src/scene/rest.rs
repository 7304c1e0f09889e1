//! The keys of the task `rest`.

use num_rational::BigRational;

use super::keys::keys;

keys! {
    /// Finds all periodic motions that rest on a stop for a while, of a machine with one coordinate: where a
    /// stop lets go of what rests on it nothing is left of how it came there, so that they are the cycles of
    /// a map of the phases of release. Chatter that ends in a rest is part of them. All their multipliers are
    /// 0.
    pub struct RestTask {
        /// a parameter that takes several values
        parameter: Option<String>,
        /// its values
        values: Vec<BigRational> = "[]",
        /// within how many periods of its release a motion is to come to the next rest that ends, from 1 to
        /// 100000
        periods: u32 = "200",
    }
}
