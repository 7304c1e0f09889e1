//! The keys of the task `simulate`, and of the state in which any motion starts.

use std::f64::consts::TAU;

use num_rational::BigRational;

use super::{expression::Expression, keys::keys, matrix::CoordinateList};
use crate::error::{Error, Result};

keys! {
    /// Follows one motion: its time series, its impacts and a picture of both.
    pub struct SimulateTask {
        /// where it starts
        start: Start,
        /// forcing periods that are written
        periods: u32 = "10",
        /// in place of `periods`, in the scene's unit of time
        duration: Option<Expression>,
        /// periods that pass first, unrecorded
        transient: u64 = "0",
        /// points per period, 1 to 10000; at most 100000000 in all
        samples: u32 = "64",
    }
}

keys! {
    /// A state from which a motion starts.
    pub struct Start {
        /// the time, as a fraction of the forcing period
        phase: BigRational = "0",
        /// displacement; one 0 for all
        q: CoordinateList,
        /// velocity
        u: CoordinateList = "0",
    }
}

impl Start {
    /// The state with these floats, its phase in radians.
    ///
    /// # Errors
    /// An input error for what is not finite.
    pub(crate) fn at(t: f64, q: &[f64], u: &[f64]) -> Result<Start> {
        let list = |all: &[f64]| {
            let one = |x: &f64| Expression::parse(&format!("{x:e}"), &[]);
            Ok::<_, Error>(CoordinateList { entries: all.iter().map(one).collect::<Result<_>>()? })
        };
        let phase = BigRational::from_float(t / TAU);
        let phase = phase.ok_or_else(|| Error::input("a phase that is not finite"))?;
        Ok(Start { phase, q: list(q)?, u: list(u)? })
    }
}
