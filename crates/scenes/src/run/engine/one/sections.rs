//! What a section of an oscillator has besides attractors: chosen orbits, manifolds, the grazing curve.

use std::f64::consts::TAU;

use super::{
    super::super::{Job, SectionFindings, SectionOrbitRow, SectionSet},
    Oscillators,
};
use crate::{
    attractor::{cycle::Cycle, dynamics::Dynamics},
    error::{Error, Result},
    motion::Contact,
    one::{
        attractor::{
            manifold::{ManifoldPlan, reversed, reversed_phase, unstable_manifold},
            touching,
        },
        simulate::Simulator,
    },
    scene::{SectionTask, phase},
};

/// Adds the orbits of the task that are no attractors found, with the manifolds of unstable ones, and the
/// curve on which the next period grazes a wall.
///
/// # Errors
/// Those of the orbits' search; an interruption.
pub(super) fn further(
    task: &SectionTask,
    engine: &Oscillators,
    simulator: &Simulator,
    cycles: &[(usize, Cycle)],
    found: &mut SectionFindings,
) -> Result<()> {
    let (job, phase) = (engine.job, phase(&task.phase));
    let oscillator = job.oscillator(engine.system.clone())?;
    for keys in &task.orbits {
        job.check()?;
        let known = keys.orbits(&oscillator, || job.check())?.found;
        for orbit in known.iter().filter(|orbit| orbit.admissibility.is_admissible()) {
            let point = |i: u32| {
                let state = orbit.state(&oscillator, phase + TAU * f64::from(i))?;
                Ok([state.q, state.u])
            };
            let points = (0..orbit.itinerary.periods()).map(point).collect::<Result<Vec<_>>>()?;
            if cycles.iter().any(|(_, cycle)| cycle.passes(&points[0])) {
                continue;
            }
            if task.manifolds && !orbit.multipliers.is_stable() {
                let plan = ManifoldPlan::default().sized(orbit.unit);
                manifolds(job, simulator, (phase, &plan), &points, found)?;
            }
            let drawn = points.iter().map(|point| simulator.drawn(point)).collect();
            found.points.push((SectionSet::Orbit(found.further_orbits.len()), drawn));
            found.further_orbits.push(SectionOrbitRow {
                pattern: orbit.itinerary.to_string(),
                stable: orbit.multipliers.is_stable(),
            });
        }
    }
    let walls: Vec<Contact> = simulator.contacts().cloned().collect();
    for wall in walls.iter().filter(|_| task.grazing_curve) {
        for piece in touching(simulator.flow(), &walls, wall, phase) {
            let piece = piece.iter().map(|state| simulator.drawn(&[state.q, state.u])).collect();
            found.grazing_curve.push((wall.clone(), piece));
        }
    }
    Ok(())
}

/// Adds the manifolds of an unstable orbit with these points, or why there are none.
fn manifolds(
    job: &Job,
    simulator: &Simulator,
    (phase, plan): (f64, &ManifoldPlan),
    points: &[[f64; 2]],
    found: &mut SectionFindings,
) -> Result<()> {
    let back = reversed(job.system()?).and_then(|system| job.simulator_of(&system));
    let periods = points.len() as u32;
    for &[q, u] in points {
        let unstable = unstable_manifold(simulator, phase, periods, [q, u], plan, job.monitor);
        let stable = match &back {
            Ok(back) => {
                let phase = reversed_phase(phase);
                unstable_manifold(back, phase, periods, [q, -u], plan, job.monitor)
            }
            Err(error) => Err(Error::input(error.to_string())),
        };
        for (is_stable, pieces) in [(false, unstable), (true, stable)] {
            match pieces {
                Ok(pieces) => {
                    let turned = |piece: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
                        let turned = |[q, u]: [f64; 2]| simulator.drawn(&[q, if is_stable { -u } else { u }]);
                        piece.into_iter().map(turned).collect()
                    };
                    found.manifolds.extend(pieces.into_iter().map(|piece| (is_stable, turned(piece))));
                }
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => {
                    let which = if is_stable { "stable" } else { "unstable" };
                    let note = format!("no {which} manifold is drawn: {error}");
                    if !found.notes.contains(&note) {
                        found.notes.push(note);
                    }
                }
            }
        }
    }
    Ok(())
}
