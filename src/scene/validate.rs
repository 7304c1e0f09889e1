//! The keys of the task `validate`.

use super::{
    keys::keys,
    orbits::{OrbitKeys, check_reach},
    task::Check,
};
use crate::{
    error::Result,
    oscillator::{
        System,
        branch::{Bifurcation, Options},
    },
    scene::Scene,
};

keys! {
    /// Proves that exact orbits exist, each the only one in a box, admissible, and stable or not, with a certificate for each; or, with `event`, encloses the parameter at which one bifurcates. Linear systems, orbits with impacts.
    pub struct ValidateTask {
        /// which; the proof starts from their approximations
        orbit: OrbitKeys,
        /// a bifurcation to enclose, in place of the orbits themselves
        event: Option<Bifurcation>,
        /// the parameter that varies; goes with `event`
        parameter: Option<String>,
        /// how far along its branch to look for the event, in the norm of times, speeds and parameter
        reach: f64 = "0.5",
        /// how the branch is followed to the event
        options: Options = "{}",
        /// bits of the enclosures
        bits: u32 = "128",
    }
}

impl Check for ValidateTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        self.orbit.check(scene, system, &format!("{path}.orbit"))?;
        if system.cubic != 0.0 {
            return Err(scene.fail(path, "only a linear system can be validated: cubic must be 0"));
        }
        if self.orbit.pattern.is_empty() {
            return Err(scene.fail(&format!("{path}.orbit.pattern"), "must have an impact to be validated"));
        }
        if !(64..=4096).contains(&self.bits) {
            return Err(scene.fail(&format!("{path}.bits"), "must be from 64 to 4096"));
        }
        check_reach(scene, self.reach, &self.options, path)?;
        if let Some(event) = self.event
            && !matches!(event, Bifurcation::SaddleNode | Bifurcation::Flip | Bifurcation::Grazing)
        {
            let message = format!("{}: only saddle-node, flip and grazing can be validated", event.name());
            return Err(scene.fail(&format!("{path}.event"), &message));
        }
        match (&self.event, &self.parameter) {
            (None, None) => Ok(()),
            (Some(_), Some(parameter)) => scene.parameter(parameter).map(drop),
            _ => Err(scene.fail(path, "event and parameter belong together: give both or neither")),
        }
    }
}
