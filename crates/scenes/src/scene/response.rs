//! The keys of the task `response`.

use num_rational::BigRational;

use super::{branches::SweepWay, keys::keys, simulate::Start};

keys! {
    /// [Frequency response](#frequency-response): swing, amplitude and lag of each coordinate and gap over a
    /// parameter, linear in closed form, and as seen.
    pub struct ResponseTask {
        /// what varies
        parameter: String,
        /// its bounds
        range: Vec<BigRational>,
        /// values, both bounds among them
        count: u32 = "200",
        /// of the forcing, for amplitudes and lags
        harmonic: u32 = "1",
        /// follow motions, up and down; without it where a stop is reached, with friction and formulas
        seen: Option<bool>,
        /// which way the parameter goes there
        sweep: SweepWay = "\"both\"",
        /// follow on, as they are unstable, the orbits that a sweep leaves
        unstable: bool = "true",
        /// add the backbone curves of the free machine
        backbone: bool = "false",
        /// at the first value
        start: Start = "{ q = 0 }",
        /// periods that pass first, at each value
        transient: u64 = "200",
        /// periods looked at of a motion that is not periodic
        points: u32 = "100",
        /// longest period that counts as periodic
        longest: u32 = "16",
        /// whether to continue from an interrupted run's checkpoint
        resume: bool = "true",
    }
}
