//! The keys of the task `validate`.

use num_rational::BigRational;

use super::{
    keys::keys,
    orbits::{OrbitKeys, extent},
};
use crate::{
    continuation::{Bifurcation, Options, SearchReach},
    one::orbit::{Orbit, Oscillator},
};

keys! {
    /// Proves that exact orbits exist, each the only one in a box, admissible, and stable or not; with `from`
    /// or `to` at every value of a parameter in a range. With `event` it proves that an orbit bifurcates at a
    /// parameter in an interval. Writes a certificate for each. For linear systems. Of an orbit without
    /// impacts, of period 1, it proves that it is the only one and clear of every stop; of its bifurcations
    /// only a grazing. Bifurcations and ranges are proved where the engine is `one`.
    pub struct ValidateTask {
        /// which orbits; the proof starts from their approximations
        orbit: OrbitKeys,
        /// a bifurcation to enclose, in place of the orbits themselves
        event: Option<Bifurcation>,
        /// the parameter that varies; goes with `event`, or with `from` or `to`
        parameter: Option<String>,
        /// the least value of the range over which the orbits are proved; if absent, the scene's
        from: Option<BigRational>,
        /// the greatest; if absent, the scene's, which lies in the range
        to: Option<BigRational>,
        /// how far along its branch to look for the event, as that of tasks `event` of an
        /// oscillator
        reach: Option<f64>,
        /// how the branch is followed to the event
        options: Options = "{}",
        /// bits of the enclosures
        bits: u32 = "128",
    }
}

impl ValidateTask {
    /// Whether orbits are proved over a range.
    pub(crate) fn has_range(&self) -> bool {
        self.from.is_some() || self.to.is_some()
    }

    /// How far to look for the event along the branch of an orbit.
    pub(crate) fn extent(&self, oscillator: &Oscillator, orbit: &Orbit) -> SearchReach {
        extent(self.reach, oscillator, orbit)
    }
}
