//! What only a whole scene can tell of its tasks: parameters that exist, ranges, walls that are there, starts
//! on the right side.

mod machine;

use num_rational::BigRational;
use num_traits::Zero;

use machine::check_machine;

use super::{
    branches::{BranchStart, BranchTask, CrisisTask, DiagramTask, MapTask},
    expression::Expression,
    orbits::{EventTask, GrazingTask, OrbitKeys, OrbitTask},
    scene::{Body, Scene},
    sections::{BasinsTask, SectionTask},
    simulate::{SimulateTask, Start},
    task::{Kind, Task},
    validate::ValidateTask,
};
use crate::{
    continuation::{Bifurcation, Options},
    error::{Error, Result},
    many::{Machine, Stop, StopLaw},
    motion::{Contact, Side, System},
};

/// No longer series is written: at some 50 bytes a point, 5 GB.
const MOST_POINTS: u64 = 100_000_000;

/// How many points and periods may be looked at.
const LONGEST: u32 = 10_000;
const POINTS: u32 = 1_000_000;

impl Scene {
    /// A task's scene, with the values it sets and then `changes`, and without the list of tasks, which may
    /// be long; checks all that can be checked before running.
    ///
    /// # Errors
    /// As [`Scene::exact`]; an input error for what the task's kind forbids.
    pub fn for_task(&self, task: &Task, changes: &[(String, BigRational)]) -> Result<Scene> {
        let scene = self.alone(&task.set)?.with(changes)?;
        match scene.body {
            Body::Oscillator(_) => check(&task.kind, &scene, &scene.exact(&[])?.rounded(), &task.path)?,
            Body::Machine(_) => check_machine(&task.kind, &scene, &scene.machine(&[])?, &task.path)?,
        }
        Ok(scene)
    }

    /// What is allowed and likely to be a mistake.
    pub(crate) fn warnings(&self) -> Vec<String> {
        if let Ok(scene) = self.machine_scene() {
            let laws = self.machine(&[]).map(|machine| machine.stops).unwrap_or_default();
            let faster = laws.iter().filter_map(|stop| {
                let StopLaw::Speed(law) = &stop.law else { return None };
                let (name, v) = (&stop.name, law.above_one()?);
                let text = &law.text;
                Some(format!(
                    "the restitution of stop {name}, {text}, is above 1 at the speed v = {v}: impacts there add energy"
                ))
            });
            let gain = |stop: &Stop<Expression>| {
                let value = self.number(&stop.wall.restitution).ok().filter(|value| *value > 1.0)?;
                let name = &stop.name;
                Some(format!(
                    "the restitution of stop {name} is {value}, above 1: every impact there adds energy"
                ))
            };
            let measured = scene.measured.iter().filter(|force| force.left_out > 1).map(|force| {
                let (file, left_out, periods) = (&force.file, force.left_out, force.periods);
                format!(
                    "the last {left_out} samples of {file} are beyond its last whole period and are left out: {periods} \
                     whole periods are used"
                )
            });
            return scene.machine.stops.iter().filter_map(gain).chain(faster).chain(measured).collect();
        }
        let Ok(system) = self.exact(&[]) else { return Vec::new() };
        let one = num_traits::One::one();
        let gains =
            [Side::Lower, Side::Upper].into_iter().filter_map(|side| Some((side, system.wall(side)?)));
        gains
            .filter(|(_, wall)| wall.restitution > one)
            .map(|(side, wall)| {
                let (name, value) = (side.name(), &wall.restitution);
                format!("the {name} wall's restitution is {value}, above 1: every impact there adds energy")
            })
            .collect()
    }

    /// Refuses starts behind a rigid stop.
    fn check_machine_start(&self, start: &Start, machine: &Machine<f64>, path: &str) -> Result<()> {
        let state = self.machine_state(start, machine, path)?;
        for contact in machine.contacts()? {
            let gap = contact.gap(&state)[0];
            let size = contact.position.at(state.t)[0].abs() + contact.row.amax() * state.q.amax();
            // A start on the stop may be behind it by rounding; one that gives way may be pushed in.
            if contact.soft.is_none() && gap < -1e-12 * size {
                let message = format!("starts behind the stop {}: its gap is {gap:e}", contact.name);
                return Err(self.fail(path, &message));
            }
        }
        Ok(())
    }

    fn check_start(&self, start: &Start, system: &System<f64>, path: &str) -> Result<()> {
        let state = self.state(start)?;
        for contact in Contact::of(system)? {
            let at = contact.position.at(state.t)[0];
            // A start on the wall may be behind it by rounding.
            if contact.gap(state)[0] < -1e-12 * (1.0 + at.abs()) {
                let message = format!(
                    "starts at q = {}, behind the {} wall, which is at {at}{}",
                    state.q,
                    contact.side.name(),
                    self.where_parameters()
                );
                return Err(self.fail(path, &message));
            }
        }
        Ok(())
    }
}

/// The checks of one task, its coefficients being those of the task.
fn check(kind: &Kind, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
    match kind {
        Kind::SimulateTask(task) => task.check(scene, system, path),
        Kind::SectionTask(task) => task.check(scene, system, path),
        Kind::BasinsTask(task) => task.check(scene, system, path),
        Kind::OrbitTask(task) => task.check(scene, system, path),
        Kind::EventTask(task) => task.check(scene, system, path),
        Kind::GrazingTask(task) => task.check(scene, system, path),
        Kind::BranchTask(task) => task.check(scene, system, path),
        Kind::DiagramTask(task) => task.check(scene, system, path),
        Kind::MapTask(task) => task.check(scene, system, path),
        Kind::CrisisTask(task) => task.check(scene, system, path),
        Kind::ValidateTask(task) => task.check(scene, system, path),
        Kind::ChaosTask(task) => task.check(scene, path),
    }
}

/// An oscillator has one displacement and one velocity.
fn check_no_plane(plane: &[String], scene: &Scene, path: &str) -> Result<()> {
    if plane.is_empty() {
        return Ok(());
    }
    let message =
        "names coordinates of a machine, format \"grazing-scene 2\": here they are q and u, leave it out";
    Err(scene.fail(&format!("{path}.plane"), message))
}

/// What a kind of task checks before anything runs.
trait Check {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()>;
}

impl SimulateTask {
    fn check_length(&self, scene: &Scene, path: &str) -> Result<()> {
        let points = u64::from(self.periods) * u64::from(self.samples);
        if points > MOST_POINTS {
            let key = format!("{path}.periods");
            return Err(scene.fail(
                &key,
                &format!(
                    "with samples = {} makes a series of {points} points, more than {MOST_POINTS}: take fewer samples or periods",
                    self.samples
                ),
            ));
        }
        if !(1..=10_000).contains(&self.samples) {
            return Err(scene.fail(&format!("{path}.samples"), "is outside 1 to 10000"));
        }
        Ok(())
    }
}

impl Check for SimulateTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        self.check_length(scene, path)?;
        scene.check_start(&self.start, system, &format!("{path}.start"))
    }
}

impl SectionTask {
    fn check_counts(&self, scene: &Scene, path: &str, dimension: usize) -> Result<()> {
        if self.starts.is_empty() {
            return Err(scene.fail(&format!("{path}.starts"), "is empty; a motion must start somewhere"));
        }
        within(scene, path, "points", self.points, POINTS)?;
        within(scene, path, "longest", self.longest, LONGEST)?;
        within(scene, path, "exponents", self.exponents, u32::try_from(dimension).unwrap_or(u32::MAX))
    }
}

impl Check for SectionTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        self.check_counts(scene, path, 2)?;
        check_no_plane(&self.plane, scene, path)?;
        for (i, start) in (1..).zip(&self.starts) {
            scene.check_start(start, system, &format!("{path}.starts[{i}]"))?;
        }
        let has = |side| match side {
            Side::Lower => system.lower.is_some(),
            Side::Upper => system.upper.is_some(),
        };
        if let Some(side) = self.frame.side().filter(|&side| !has(side)) {
            return Err(scene.fail(&format!("{path}.frame"), &format!("there is no {} wall", side.name())));
        }
        for (i, orbit) in (1..).zip(&self.orbits) {
            check_orbit(orbit, scene, system, &format!("{path}.orbits[{i}]"))?;
        }
        Ok(())
    }
}

impl Check for BasinsTask {
    fn check(&self, scene: &Scene, _: &System<f64>, path: &str) -> Result<()> {
        scene.start_plane(&self.plane, &format!("{path}.plane"))?;
        if let Some(start) = &self.start {
            if self.plane.is_empty() {
                let message = "goes with a plane: here q and u say all, leave it out";
                return Err(scene.fail(&format!("{path}.start"), message));
            }
            scene.state(start)?;
        }
        check_basins(self, scene, path)
    }
}

fn check_basins(task: &BasinsTask, scene: &Scene, path: &str) -> Result<()> {
    if task.start.as_ref().is_some_and(|start| !start.phase.is_zero()) {
        let message = "is given by the task's own phase, when all motions start: leave it out here";
        return Err(scene.fail(&format!("{path}.start.phase"), message));
    }
    for (range, name) in [(&task.q, "q"), (&task.u, "u")] {
        if !(2..=4000).contains(&range.count) {
            return Err(scene.fail(&format!("{path}.{name}.count"), "is outside 2 to 4000"));
        }
        scene.number(&range.from)?;
        scene.number(&range.to)?;
    }
    within(scene, path, "longest", task.longest, LONGEST)
}

impl Check for OrbitTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        check_orbit(&self.orbit, scene, system, &format!("{path}.orbit"))?;
        check_values(self, scene, path)
    }
}

fn check_values(task: &OrbitTask, scene: &Scene, path: &str) -> Result<()> {
    if let Some(parameter) = &task.parameter {
        scene.check_parameter(parameter, &format!("{path}.parameter"))?;
    }
    if task.parameter.is_some() == task.values.is_empty() {
        return Err(scene.fail(path, "parameter and values belong together: give both or neither"));
    }
    Ok(())
}

impl Check for EventTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        scene.check_parameter(&self.parameter, &format!("{path}.parameter"))?;
        check_reach(scene, self.reach, &self.options, path)?;
        check_orbit(&self.orbit, scene, system, &format!("{path}.orbit"))
    }
}

impl Check for GrazingTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        scene.check_parameter(&self.parameter, &format!("{path}.parameter"))?;
        check_grazing(self, scene, path)?;
        check_orbit(&self.orbit, scene, system, &format!("{path}.orbit"))
    }
}

fn check_grazing(task: &GrazingTask, scene: &Scene, path: &str) -> Result<()> {
    check_reach(scene, task.reach, &task.options, path)?;
    if !(1..=12).contains(&task.max_period) {
        return Err(scene.fail(&format!("{path}.max_period"), "is outside 1 to 12"));
    }
    Ok(())
}

impl Check for BranchTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        check_starts(scene, system, &self.starts, &format!("{path}.starts"))?;
        self.check_ranges(scene, path)
    }
}

impl BranchTask {
    fn check_ranges(&self, scene: &Scene, path: &str) -> Result<()> {
        check_range(scene, path, ("parameter", &self.parameter), ("range", &self.range))?;
        if let Some(second) = &self.second {
            check_range(scene, path, ("second", second), ("second_range", &self.second_range))?;
            if second == &self.parameter || self.starts.iter().any(|start| start.restart.is_none()) {
                return Err(scene.fail(
                    &format!("{path}.second"),
                    "must be another parameter, and every start a restart at the label of what is followed",
                ));
            }
        }
        let wrong = |error: Error| scene.fail(&format!("{path}.options"), &error.to_string());
        self.options.checked().map(drop).map_err(wrong)
    }
}

impl Check for DiagramTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        check_range(scene, path, ("parameter", &self.parameter), ("range", &self.range))?;
        check_starts(scene, system, &self.branches, &format!("{path}.branches"))?;
        check_no_plane(&self.plane, scene, path)?;
        self.check_counts(scene, path)?;
        let wrong = |error: Error| scene.fail(&format!("{path}.options"), &error.to_string());
        self.options.checked().map(drop).map_err(wrong)
    }
}

impl DiagramTask {
    fn check_counts(&self, scene: &Scene, path: &str) -> Result<()> {
        let values = [
            (self.count, "count", 2, 1_000_000),
            (self.points, "points", 2, 1_000_000),
            (self.longest, "longest", 1, 10_000),
            (self.every, "every", 1, self.points),
        ];
        for (value, key, least, most) in values {
            if !(least..=most).contains(&value) {
                return Err(scene.fail(&format!("{path}.{key}"), &format!("is outside {least} to {most}")));
            }
        }
        if self.starts.is_empty() {
            return Err(scene.fail(&format!("{path}.starts"), "is empty; a motion must start somewhere"));
        }
        Ok(())
    }
}

impl Check for MapTask {
    fn check(&self, scene: &Scene, _: &System<f64>, path: &str) -> Result<()> {
        check_range(scene, path, ("parameter", &self.parameter), ("range", &self.range))?;
        check_range(scene, path, ("second", &self.second), ("second_range", &self.second_range))?;
        if self.second == self.parameter {
            return Err(scene.fail(&format!("{path}.second"), "must be another parameter"));
        }
        let values = [
            (self.count, "count", 2, 4000),
            (self.second_count, "second_count", 2, 4000),
            (self.longest, "longest", 1, LONGEST),
            (self.points, "points", 3 * self.longest.min(LONGEST), POINTS),
        ];
        for (value, key, least, most) in values {
            if !(least..=most).contains(&value) {
                return Err(scene.fail(&format!("{path}.{key}"), &format!("is outside {least} to {most}")));
            }
        }
        Ok(())
    }
}

impl Check for CrisisTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        check_range(scene, path, ("parameter", &self.parameter), ("bracket", &self.bracket))?;
        check_orbit(&self.orbit, scene, system, &format!("{path}.orbit"))
    }
}

impl Check for ValidateTask {
    fn check(&self, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
        check_orbit(&self.orbit, scene, system, &format!("{path}.orbit"))?;
        if system.cubic != 0.0 {
            return Err(scene.fail(path, "only a linear system can be validated: cubic must be 0"));
        }
        if system.smooth.is_some() {
            let message = "depends on q, u or t: kind \"validate\" proves linear systems only; if the force is linear, \
                           write it as damping, stiffness and forcing";
            return Err(scene.fail("system.force", message));
        }
        if self.orbit.pattern.is_empty()
            && (self.event != Some(Bifurcation::Grazing) || self.orbit.period != 1)
        {
            let message = "must have an impact to be validated; without one, only a grazing is, of period 1";
            return Err(scene.fail(&format!("{path}.orbit.pattern"), message));
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
            (Some(_), Some(parameter)) => scene.check_parameter(parameter, &format!("{path}.parameter")),
            _ => Err(scene.fail(path, "event and parameter belong together: give both or neither")),
        }
    }
}

/// The keys of an orbit against the walls that there are.
fn check_orbit(orbit: &OrbitKeys, scene: &Scene, system: &System<f64>, path: &str) -> Result<()> {
    let fail = |key: &str, message: &str| Err(scene.fail(&format!("{path}.{key}"), message));
    if let Err(error) = orbit.itinerary(system) {
        return fail("pattern", &error.to_string());
    }
    if !orbit.stops.is_empty() {
        return fail("stops", "names stops of a machine, format \"grazing-scene 2\": give `walls`");
    }
    let m = orbit.pattern.len();
    if !orbit.walls.is_empty() && orbit.walls.len() != m {
        return fail("walls", &format!("must name {m} walls, one for each impact"));
    }
    if m > 0 && orbit.walls.is_empty() && system.lower.is_some() && system.upper.is_some() {
        return fail("pattern", "the scene has two walls: name the wall of each impact in walls");
    }
    let missing = |side| [system.lower.is_none(), system.upper.is_none()][usize::from(side == Side::Upper)];
    if orbit.walls.iter().any(|&side| missing(side))
        || (m > 0 && missing(Side::Lower) && missing(Side::Upper))
    {
        return fail("pattern", "has an impact at a wall that the scene does not have");
    }
    if !orbit.start.is_empty() && orbit.start.len() != (2 * m).max(2) {
        return fail("start", &format!("must hold {} numbers", (2 * m).max(2)));
    }
    Ok(())
}

/// What reach and options must be.
fn check_reach(scene: &Scene, reach: Option<f64>, options: &Options, path: &str) -> Result<()> {
    if reach.is_some_and(|reach| reach.is_nan() || reach <= 0.0) {
        return Err(scene.fail(&format!("{path}.reach"), "must be positive"));
    }
    let wrong = |error: Error| scene.fail(&format!("{path}.options"), &error.to_string());
    options.checked().map(drop).map_err(wrong)
}

/// The parameter that `over` names, and its range; each a key of the task, with its value.
fn check_range<T: PartialOrd>(
    scene: &Scene,
    path: &str,
    (over, parameter): (&str, &str),
    (key, range): (&str, &[T]),
) -> Result<()> {
    scene.check_parameter(parameter, &format!("{path}.{over}"))?;
    match range {
        [low, high] if low < high => Ok(()),
        _ => Err(scene.fail(&format!("{path}.{key}"), "must hold two numbers, the smaller first")),
    }
}

fn check_starts(scene: &Scene, system: &System<f64>, starts: &[BranchStart], path: &str) -> Result<()> {
    for (i, start) in (1..).zip(starts) {
        let path = format!("{path}[{i}]");
        start.origin().map_err(|error| scene.fail(&path, &error.to_string()))?;
        if let Some(orbit) = &start.orbit {
            check_orbit(orbit, scene, system, &format!("{path}.orbit"))?;
        }
    }
    Ok(())
}

fn within(scene: &Scene, path: &str, key: &str, value: u32, most: u32) -> Result<()> {
    if (1..=most).contains(&value) {
        return Ok(());
    }
    Err(scene.fail(&format!("{path}.{key}"), &format!("is outside 1 to {most}")))
}
