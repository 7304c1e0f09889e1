//! The keys of the task `rest`.

use num_rational::BigRational;

use super::keys::keys;

keys! {
    /// Finds periodic motions that rest on a stop for a while, chatter included. With one coordinate and no
    /// dry friction all: the cycles of a map of the phases of release, whose multipliers are 0. Else those
    /// that a search finds: Newton's method after releases of motions that begin at rest.
    pub struct RestTask {
        /// takes several values
        parameter: Option<String>,
        /// its values
        values: Vec<BigRational> = "[]",
        /// until the next rest that ends, 1 to 100000; of a search, periods followed
        periods: u32 = "200",
        /// of a search, motions per rigid stop, 1 to 100000
        starts: u32 = "16",
        /// of a search, greatest period, 1 to 100
        longest: u32 = "4",
    }
}
