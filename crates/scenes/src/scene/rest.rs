//! The keys of the task `rest`.

use num_rational::BigRational;

use super::keys::keys;

keys! {
    /// Finds periodic motions that rest on a stop for a while. Chatter that ends in a rest is part of them.
    /// Of a machine with one coordinate and without dry friction all: where a stop lets go of what rests on
    /// it nothing is left of how it came there, so that they are the cycles of a map of the phases of
    /// release, and their multipliers are 0. Else those that a search finds: motions begin at rest on each
    /// rigid stop, and after some of their releases Newton's method looks for an orbit, stable or not.
    pub struct RestTask {
        /// a parameter that takes several values
        parameter: Option<String>,
        /// its values
        values: Vec<BigRational> = "[]",
        /// within how many periods of its release a motion is to come to the next rest that ends, from 1 to
        /// 100000; of a search for how many periods each motion is followed
        periods: u32 = "200",
        /// of a search, how many motions begin at rest on each rigid stop, from 1 to 100000
        starts: u32 = "16",
        /// of a search, the greatest period looked for, in periods of the forcing, from 1 to 100
        longest: u32 = "4",
    }
}
