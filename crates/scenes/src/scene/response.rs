//! The keys of the task `response`.

use num_rational::BigRational;

use super::{branches::SweepWay, keys::keys, simulate::Start};

keys! {
    /// Frequency response: how far each coordinate and each gap swings, and how it lags behind the drive,
    /// over a parameter, as a rule the drive's frequency. Of the linear machine (without contact and
    /// friction, formulas linearised at rest) in closed form, with its peaks, their half-power points and
    /// damping ratios; where that is not what the machine does, also what is seen as the parameter goes up
    /// and down. An interrupted task resumes from its checkpoint.
    pub struct ResponseTask {
        /// the parameter that varies
        parameter: String,
        /// its bounds
        range: Vec<BigRational>,
        /// how many values, evenly spaced, both bounds among them
        count: u32 = "200",
        /// which harmonic of the forcing amplitudes and lags are of
        harmonic: u32 = "1",
        /// whether motions are followed, up and down; without it where a stop is reached by the linear
        /// response, and where there is friction or a force is not linear
        seen: Option<bool>,
        /// which way the parameter goes there
        sweep: SweepWay = "\"both\"",
        /// whether to add the backbone curve, of one coordinate with smooth forces of the displacement and
        /// stops that stand still: how far it swings in a free vibration at `harmonic` times the drive's
        /// frequency, without damping, friction and losses at impacts, whatever the drive, and without one
        backbone: bool = "false",
        /// where the motion starts, at the first value
        start: Start = "{ q = 0 }",
        /// how many periods pass first, at each value
        transient: u64 = "200",
        /// how many periods are looked at of a motion that is not periodic
        points: u32 = "100",
        /// the longest period that counts as periodic, in forcing periods
        longest: u32 = "16",
        /// whether to continue from the checkpoint that an interrupted run left in the folder
        resume: bool = "true",
    }
}
