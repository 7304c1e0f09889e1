//! What only a whole scene can tell of the tasks on a machine: stops that are there, planes, starts, orbits.

use num_traits::Zero;

use super::{check_basins, check_grazing, check_range, check_reach, check_values};
use crate::{
    error::{Error, Result},
    many::{Machine, RealVector, Stop, StopLaw, section::PlaneAxis},
    scene::{
        branches::BranchStart,
        orbits::OrbitKeys,
        scene::Scene,
        sections::{BasinsTask, Frame, SectionTask},
        task::Kind,
        validate::ValidateTask,
    },
};

/// The checks of one task on a machine; most kinds do not work on machines.
pub(super) fn check_machine(kind: &Kind, scene: &Scene, machine: &Machine<f64>, path: &str) -> Result<()> {
    if let Some((record, _)) = &machine.record {
        check_once(kind, scene, record.length() / machine.period, path)?;
    }
    match kind {
        Kind::SimulateTask(task) => {
            task.check_length(scene, path)?;
            scene.check_machine_start(&task.start, machine, &format!("{path}.start"))
        }
        Kind::OrbitTask(task) => {
            check_machine_orbit(&task.orbit, scene, machine, &format!("{path}.orbit"))?;
            check_values(task, scene, path)
        }
        Kind::GrazingTask(task) => {
            scene.check_parameter(&task.parameter, &format!("{path}.parameter"))?;
            check_grazing(task, scene, path)?;
            let key = |key: &str| format!("{path}.{key}");
            check_stops(scene, machine, path)?;
            if !task.orbit.pattern.is_empty() || task.orbit.period != 1 {
                let message = "of a machine, the motion without impacts is followed: leave `orbit` out";
                return Err(scene.fail(&key("orbit"), message));
            }
            Ok(())
        }
        Kind::SectionTask(task) => check_machine_section(task, scene, machine, path),
        Kind::BasinsTask(task) => check_machine_basins(task, scene, machine, path),
        Kind::DiagramTask(task) => {
            check_range(scene, path, ("parameter", &task.parameter), ("range", &task.range))?;
            task.check_counts(scene, path)?;
            let key = |key: &str| format!("{path}.{key}");
            scene.plane(&task.plane, machine, &key("plane"))?;
            for (i, start) in (1..).zip(&task.starts) {
                scene.machine_state(start, machine, &key(&format!("starts[{i}]")))?;
            }
            check_frame(task.frame, scene, path)?;
            check_machine_branches(&task.branches, scene, machine, &key("branches"))?;
            let wrong = |error: Error| scene.fail(&key("options"), &error.to_string());
            task.options.checked().map(drop).map_err(wrong)
        }
        Kind::EventTask(task) => {
            scene.check_parameter(&task.parameter, &format!("{path}.parameter"))?;
            check_reach(scene, task.reach, &task.options, path)?;
            check_stops(scene, machine, path)?;
            check_machine_orbit(&task.orbit, scene, machine, &format!("{path}.orbit"))
        }
        Kind::BranchTask(task) => {
            check_stops(scene, machine, path)?;
            if task.frame != Frame::Fixed {
                let message = "is a wall of format 1: of a machine, the picture shows the gap to a stop";
                return Err(scene.fail(&format!("{path}.frame"), message));
            }
            check_machine_branches(&task.starts, scene, machine, &format!("{path}.starts"))?;
            task.check_ranges(scene, path)
        }
        Kind::ValidateTask(task) => check_machine_proof(task, scene, machine, path),
        _ => {
            let message = "does not work on machines, format \"grazing-scene 2\": there are simulate, section, basins, \
                           diagram, orbit, event, grazing, branch and validate";
            Err(scene.fail(&format!("{path}.kind"), message))
        }
    }
}

fn check_machine_basins(task: &BasinsTask, scene: &Scene, machine: &Machine<f64>, path: &str) -> Result<()> {
    check_basins(task, scene, path)?;
    let axes = scene.plane(&task.plane, machine, &format!("{path}.plane"))?;
    if axes.iter().any(|axis| matches!(axis, PlaneAxis::Gap(_) | PlaneAxis::Rate(_))) {
        let message = "has a gap; starts are given by displacements and velocities, as in [\"q1\", \"u2\"]";
        return Err(scene.fail(&format!("{path}.plane"), message));
    }
    let rest = scene.rest(&task.start, machine)?;
    let ones = RealVector::from_element(machine.points(), 1.0);
    let wrong = |error: Error| scene.fail(&format!("{path}.plane"), &error.to_string());
    machine.coordinates(&ones).map_err(wrong)?;
    machine.coordinates(&RealVector::from_vec(rest[0].clone())).map(drop).map_err(wrong)
}

fn check_machine_proof(task: &ValidateTask, scene: &Scene, machine: &Machine<f64>, path: &str) -> Result<()> {
    check_machine_orbit(&task.orbit, scene, machine, &format!("{path}.orbit"))?;
    let fail = |key: &str, message: &str| Err(scene.fail(&format!("{path}.{key}"), message));
    if task.event.is_some() || task.parameter.is_some() {
        let key = if task.event.is_some() { "event" } else { "parameter" };
        return fail(key, "of a machine, orbits are proved and no bifurcations: leave it out");
    }
    if machine.is_smooth() {
        return fail(
            "kind",
            "proves orbits of linear machines; a `force` of this one is a formula in its motion",
        );
    }
    if task.orbit.pattern.is_empty() {
        return fail("orbit.pattern", "must have an impact to be validated");
    }
    if let Some(stop) = machine.stops.iter().find(|stop| !stop.law.is_newton()) {
        let message = format!(
            "proves orbits between rigid stops of constant restitution; stop {} is another",
            stop.name
        );
        return fail("kind", &message);
    }
    Ok(())
}

/// A force that is recorded once: one run, from where it begins, no longer than it is.
fn check_once(kind: &Kind, scene: &Scene, periods: f64, path: &str) -> Result<()> {
    let fail = |key: &str, message: &str| Err(scene.fail(&format!("{path}.{key}"), message));
    let Kind::SimulateTask(task) = kind else {
        let message = "needs a periodic force; `measured` with once = true is a record of one run, for `simulate` alone: fit \
                       `harmonics` to it instead";
        return fail("kind", message);
    };
    if task.transient > 0 {
        return fail("transient", "passes a part of a force that is recorded once: leave it out");
    }
    if !task.start.phase.is_zero() {
        return fail("start.phase", "is not 0, where the record of the force begins: leave it out");
    }
    if f64::from(task.periods) > periods * (1.0 + 1e-9) {
        let message =
            format!("asks for {} periods; the record of the force ends after {periods:.6}", task.periods);
        return fail("periods", &message);
    }
    Ok(())
}

fn check_machine_section(
    task: &SectionTask,
    scene: &Scene,
    machine: &Machine<f64>,
    path: &str,
) -> Result<()> {
    let key = |key: &str| format!("{path}.{key}");
    task.check_counts(scene, path, 2 * machine.size)?;
    for (i, start) in (1..).zip(&task.starts) {
        scene.check_machine_start(start, machine, &key(&format!("starts[{i}]")))?;
    }
    scene.plane(&task.plane, machine, &key("plane"))?;
    check_frame(task.frame, scene, path)?;
    for (i, orbit) in (1..).zip(&task.orbits) {
        check_machine_orbit(orbit, scene, machine, &key(&format!("orbits[{i}]")))?;
    }
    if task.manifolds {
        let message = "are drawn for oscillators of one degree of freedom only, format \"grazing-scene 1\": \
                       with more they are no curves in a plane";
        return Err(scene.fail(&key("manifolds"), message));
    }
    if task.grazing_curve {
        let message = "is drawn for oscillators of one degree of freedom only, format \"grazing-scene 1\": \
                       with more it is no curve in a plane";
        return Err(scene.fail(&key("grazing_curve"), message));
    }
    Ok(())
}

fn check_stops(scene: &Scene, machine: &Machine<f64>, path: &str) -> Result<()> {
    if machine.stops.is_empty() {
        let message = "needs a stop that could be grazed: there is no [[walls]]";
        return Err(scene.fail(&format!("{path}.kind"), message));
    }
    Ok(())
}

/// Machines have gaps in place of frames.
fn check_frame(frame: Frame, scene: &Scene, path: &str) -> Result<()> {
    if frame == Frame::Fixed {
        return Ok(());
    }
    let message =
        "is a wall of format 1: of a machine write plane = [\"gap NAME\", \"rate NAME\"] with a stop's name";
    Err(scene.fail(&format!("{path}.frame"), message))
}

/// What an orbit's keys must be, whose impacts are on stops with names.
fn check_machine_orbit(orbit: &OrbitKeys, scene: &Scene, machine: &Machine<f64>, path: &str) -> Result<()> {
    let fail = |key: &str, message: &str| Err(scene.fail(&format!("{path}.{key}"), message));
    let m = orbit.pattern.len();
    if !orbit.walls.is_empty() {
        return fail(
            "walls",
            "names walls of an oscillator of format 1: give `stops`, the names of a machine's stops",
        );
    }
    if m == 0 && orbit.period == 0 {
        return fail("period", "must be at least 1");
    }
    match orbit.pattern.iter().try_fold(0u32, |sum, &n| sum.checked_add(n)) {
        Some(0) if m > 0 => return fail("pattern", "must have a period of at least 1"),
        None => return fail("pattern", "sums to more than 4294967295"),
        Some(_) => {}
    }
    let names: Vec<&str> = machine.stops.iter().map(|stop| stop.name.as_str()).collect();
    if m > 0 && names.is_empty() {
        return fail("pattern", "has impacts, but the machine has no stop");
    }
    if orbit.stops.is_empty() && m > 0 && names.len() > 1 {
        let message = format!(
            "the machine has several stops: name that of each impact in `stops`, of {}",
            names.join(", ")
        );
        return fail("pattern", &message);
    }
    if !orbit.stops.is_empty() && orbit.stops.len() != m {
        return fail("stops", &format!("must name {m} stops, one for each impact"));
    }
    if let Some(unknown) = orbit.stops.iter().find(|name| !names.contains(&name.as_str())) {
        return fail(
            "stops",
            &format!("{unknown:?} is not a stop of the machine; there are {}", names.join(", ")),
        );
    }
    let rigid = |stop: &Stop<f64>| !matches!(stop.law, StopLaw::Soft { .. });
    let hit = |stop: &&Stop<f64>| m > 0 && (orbit.stops.is_empty() || orbit.stops.contains(&stop.name));
    if let Some(soft) = machine.stops.iter().filter(hit).find(|stop| !rigid(stop)) {
        let message = format!(
            "stop {} gives way: contact with it is no impact of a pattern, and orbits have it without being told; \
             leave it out",
            soft.name
        );
        return fail(if orbit.stops.is_empty() { "pattern" } else { "stops" }, &message);
    }
    let free = m == 0 && (machine.is_smooth() || !machine.stops.iter().all(rigid));
    let needed = if free { 2 * machine.points() } else { 2 * m };
    if !orbit.start.is_empty() && orbit.start.len() != needed {
        return fail("start", &format!("must hold {needed} numbers"));
    }
    Ok(())
}

fn check_machine_branches(
    starts: &[BranchStart],
    scene: &Scene,
    machine: &Machine<f64>,
    path: &str,
) -> Result<()> {
    for (i, start) in (1..).zip(starts) {
        let path = format!("{path}[{i}]");
        start.origin().map_err(|error| scene.fail(&path, &error.to_string()))?;
        if let Some(orbit) = &start.orbit {
            check_machine_orbit(orbit, scene, machine, &format!("{path}.orbit"))?;
        }
        if let Some(start) = &start.attractor {
            scene.check_machine_start(start, machine, &format!("{path}.attractor"))?;
        }
    }
    Ok(())
}
