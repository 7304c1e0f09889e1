//! The keys of the task `simulate`, and of the state in which any motion starts.

use num_rational::BigRational;

use super::{expression::Expression, keys::keys, matrix::CoordinateList};

keys! {
    /// Follows one motion: its time series, its impacts and a picture of both.
    pub struct SimulateTask {
        /// where it starts
        start: Start,
        /// how many forcing periods are written
        periods: u32 = "10",
        /// in place of `periods`, how long is written, in the scene's unit of time: seconds, say
        duration: Option<Expression>,
        /// how many periods pass first, unrecorded
        transient: u64 = "0",
        /// points of the time series per period, from 1 to 10000; at most 100000000 in all
        samples: u32 = "64",
    }
}

keys! {
    /// A state from which a motion starts.
    pub struct Start {
        /// the time, as a fraction of the forcing period: t = 2π `phase`
        phase: BigRational = "0",
        /// the displacement; of several coordinates a list, or one 0 for all
        q: CoordinateList,
        /// the velocity, in the same way
        u: CoordinateList = "0",
    }
}
