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
    /// [Proves](orbits.md) that exact orbits exist, each the only one in a box, admissible, stable or not;
    /// over a range with `from` or `to`; with `event` that one bifurcates. Linear systems; events and ranges
    /// engine `one`. Without impacts the period is 1, the only event a grazing.
    pub struct ValidateTask {
        /// which; proofs start from approximations
        orbit: OrbitKeys,
        /// a bifurcation to enclose instead
        event: Option<Bifurcation>,
        /// what varies, with `event`, `from` or `to`
        parameter: Option<String>,
        /// least value of the range; the scene's if absent
        from: Option<BigRational>,
        /// greatest; the scene's lies in the range
        to: Option<BigRational>,
        /// how far to look for the event
        reach: Option<f64>,
        /// how the branch is followed to it
        options: Options = "{}",
        /// of the enclosures
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
