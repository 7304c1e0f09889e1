//! What a job on a machine has: simulators, the machine over a parameter, its sections.

use super::super::super::Job;
use crate::{
    error::Result,
    many::{
        Machine, State,
        contact::StopContact,
        section::PlanarMachine,
        simulate::{Settings, Simulator},
    },
    scene::MachineSceneFamily,
};

/// Gaps within this of their motion's size are contact without impact, unless the scene says otherwise.
const RELATIVE_DEPTH: f64 = 1e-12;

impl Job<'_> {
    /// A simulator of a machine. The minimum depth is the scene's, or 10⁻¹² of the size of the gap to the
    /// nearest stop, or of what starts show at the stops.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub(crate) fn machine_simulator(&self, machine: &Machine<f64>, starts: &[State]) -> Result<Simulator> {
        let given = self.scene.machine_scene()?.minimum_depth;
        let settings = |minimum_depth| Settings { minimum_depth, ..Settings::default() };
        if let Some(depth) = given {
            return Ok(Simulator::new(machine, &settings(depth))?.counting(self.tally.clone()));
        }
        let simulator = Simulator::new(machine, &settings(RELATIVE_DEPTH))?;
        let gap = |state: &State| {
            let one =
                |contact: &StopContact| contact.row.dot(&state.q).abs().max(contact.gap(state)[1].abs());
            simulator.contacts().all().iter().map(one).fold(0.0, f64::max)
        };
        let scale = starts.iter().map(gap).fold(simulator.gap_scale(), f64::max);
        let scale = if scale > 0.0 && scale.is_finite() { scale } else { 1.0 };
        Ok(simulator.with(settings(RELATIVE_DEPTH * scale)).counting(self.tally.clone()))
    }

    /// The scene's machines over a parameter, their work counted.
    ///
    /// # Errors
    /// Those of [`MachineSceneFamily::new`].
    pub(crate) fn machine_family(&self, parameter: &str) -> Result<MachineSceneFamily<'_>> {
        Ok(MachineSceneFamily::new(&self.scene, parameter)?.counting(self.tally.clone()))
    }

    /// A machine with the plane in which its sections are seen.
    ///
    /// # Errors
    /// Those of `machine_simulator`; a plane that names what the machine does not
    /// have.
    pub fn planar(
        &self,
        machine: &Machine<f64>,
        starts: &[State],
        plane: &[String],
    ) -> Result<PlanarMachine> {
        let axes = self.scene.plane(plane, machine, "plane")?;
        PlanarMachine::new(machine, self.machine_simulator(machine, starts)?, &axes)
    }
}
