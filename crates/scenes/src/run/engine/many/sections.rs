//! What a section of a machine has besides attractors: chosen orbits.

use super::{
    super::super::{Judgement, SectionFindings, SectionOrbitRow, SectionSet},
    JudgedOrbit, Machines, admissible, machine_orbits, named,
};
use crate::{
    attractor::{
        cycle::Cycle,
        dynamics::{Dynamics, SectionState},
        section::section as follow,
    },
    error::Result,
    many::section::{PlanarMachine, Point},
    motion::RunEnd,
    scene::{SectionTask, phase},
};

/// Adds the orbits of the task that are no attractors found.
///
/// # Errors
/// Those of the orbits' search; an interruption.
pub(super) fn further(
    task: &SectionTask,
    engine: &Machines,
    planar: &PlanarMachine,
    cycles: &[(usize, Cycle<Point>)],
    found: &mut SectionFindings,
) -> Result<()> {
    let Machines { job, machine } = *engine;
    let simulator = planar.simulator();
    for keys in &task.orbits {
        job.check()?;
        for orbit in machine_orbits(keys, machine, simulator, job)?.found {
            if admissible(&orbit, None).0 == Judgement::No {
                continue;
            }
            let start = orbit.state.start(machine.rate());
            let mut run = planar.begin(&start)?;
            let (mut points, mut first) = (Vec::new(), None);
            let end = follow(&mut run, phase(&task.phase), orbit.itinerary.periods().into(), |point| {
                points.push(point.at.plane());
                first.get_or_insert(point.at);
                true
            })?;
            let stable = orbit.stable(None) == Judgement::Yes;
            let shown = |point| cycles.iter().any(|(_, cycle)| cycle.passes(point));
            if end != RunEnd::Reached || first.as_ref().is_some_and(shown) {
                continue;
            }
            found.points.push((SectionSet::Orbit(found.further_orbits.len()), points));
            let pattern = named(&orbit.itinerary, machine);
            found.further_orbits.push(SectionOrbitRow { pattern, stable });
        }
    }
    Ok(())
}
