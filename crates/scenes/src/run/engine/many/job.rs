//! What a job on a machine has: simulators, the machine over a parameter, its sections.

use super::super::super::Job;
use crate::{
    error::Result,
    many::{Machine, State, section::PlanarMachine, simulate::Simulator},
    scene::MachineSceneFamily,
};

impl Job<'_> {
    /// A simulator of a machine. The minimum depth is the scene's, or 10⁻¹² of the size of the gap to the
    /// nearest stop, or of what starts show at the stops.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub(crate) fn machine_simulator(&self, machine: &Machine<f64>, starts: &[State]) -> Result<Simulator> {
        let given = self.scene.machine_scene()?.minimum_depth;
        Ok(Simulator::suited(machine, given, starts)?.counting(self.tally.clone()))
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
