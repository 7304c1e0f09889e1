//! Tasks of kind `branch` on machines: continuation of periodic orbits over a parameter, and of their
//! bifurcations over two.
//!
//! The continuation is that of oscillators ([`branch`](super::branch)). Phases are fractions of the period,
//! speeds and gaps in the scene's units.

use std::f64::consts::TAU;

use super::{
    Complex, Job, Judgement,
    branch::{BranchList, BranchSource, PointRow, events, follow_over},
    machine_orbit::{admissible_at, multipliers, orbits, phases, speeds, stable},
    row,
};
use crate::{
    error::{Error, Result},
    machine::{
        Machine, MachineFamily, MachineState,
        branch::{MachinePatterns, MachinePlane},
        normal_form::normal_form,
        orbit::{MachineOrbit, StopPattern, StopStrike, find_from},
        simulate::{MachineEvent, MachineRun, MachineSimulator, RunEnd},
    },
    oscillator::{
        Time,
        branch::{
            BranchPoint, CODIMENSION_TWO, FollowedOrbit, Label, NoForm, NormalForm, RecordForm, read_label_as,
        },
        orbit::natural,
    },
    scene::{
        MachineSceneFamily,
        branches::{BranchOrigin, BranchStart, BranchTask},
    },
};

row! {
    /// A point of a branch of a machine.
    pub struct MachineBranchRow {
        /// The branch, counted from 1.
        pub branch: usize,
        /// What happens here, as "flip 1".
        pub label: Option<String>,
        /// The parameter, or both.
        pub parameters: Vec<f64>,
        /// The impact pattern.
        pub pattern: String,
        /// The phases of its impacts, as fractions of the period.
        pub phases: Vec<f64>,
        /// Their incoming speeds, at their stops, in the scene's units.
        pub speeds: Vec<f64>,
        /// The multipliers of largest modulus, at most four.
        pub multipliers: Vec<Complex>,
        /// Whether all are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit: its impacts come in, and there is no other contact.
        pub admissible: Judgement,
        /// Why not.
        pub reason: Option<String>,
        /// The normal form's coefficient at a label.
        pub coefficient: Option<f64>,
        /// Its meaning: "supercritical", "subcritical", "above", "below", "transcritical", "degenerate"; or
        /// why there is none.
        pub criticality: Option<&'static str>,
        /// The stop with the least minimum of its gap away from the impacts.
        pub nearest_stop: Option<String>,
        /// That minimum, in the scene's units.
        pub least_gap: Option<f64>,
        /// What is left of the equations, relative to the size of the motion.
        pub residual: f64,
        /// Newton steps taken.
        pub newton_steps: usize,
        /// The branch's length from the start, negative on the backward side.
        pub length: f64,
    }
}

/// Branches of a machine.
pub type MachineBranchFindings = BranchList<MachineBranchRow, MachineOrbit>;

impl PointRow for MachineBranchRow {
    fn is_labelled(&self) -> bool {
        self.label.is_some()
    }
}

/// The format of a machine's branch in a file.
const FORMAT: &str = "grazing-machine-branch 1";

/// The form in which branches of a machine with stops of these names are written.
pub(crate) fn form<'n>(names: &'n [&'n str]) -> RecordForm<'n> {
    RecordForm { format: FORMAT, contacts: names }
}

/// Follows branches from all starts.
///
/// # Errors
/// As [`branch`](super::branch()).
pub fn machine_branch(task: &BranchTask, machine: &Machine<f64>, job: &Job) -> Result<MachineBranchFindings> {
    let family = MachineSceneFamily::new(&job.scene, &task.parameter)?;
    let source = MachineSource::new(&family, machine, job)?;
    let found = match &task.second {
        Some(second) => {
            let at =
                |[first, other]: [f64; 2]| job.scene.machine(&[(&task.parameter, first), (second, other)]);
            let value = MachineSceneFamily::new(&job.scene, second)?.value();
            let place = [family.value(), value];
            let plane = MachinePlane::new(&at, place, job.scene.machine_scene()?.minimum_depth)?;
            events(task, &source, &plane, value, job)?
        }
        None => follow_over(task, &source, job)?,
    };
    let mut rows = Vec::new();
    for (branch, i) in found.0.iter().zip(1..) {
        for point in &branch.points {
            let (rate, form) = match (&task.second, point.parameters.as_slice()) {
                (Some(second), &[first, other]) => {
                    let rate = job.scene.machine(&[(&task.parameter, first), (second, other)])?.rate();
                    (rate, point.kind().map(|_| Err(CODIMENSION_TWO)))
                }
                (_, places) => {
                    let (here, slope) = family.at(places[0])?;
                    let form = point.event.map(|event| normal_form(&here, &slope, &point.orbit, event));
                    (here.rate(), form)
                }
            };
            rows.push(MachineBranchRow::of(i, point, &source, rate, form));
        }
    }
    Ok(BranchList::of(task, found, rows))
}

impl MachineBranchRow {
    fn of(
        branch: usize,
        point: &BranchPoint<MachineOrbit>,
        source: &MachineSource,
        rate: f64,
        form: Option<std::result::Result<NormalForm, NoForm>>,
    ) -> MachineBranchRow {
        let orbit = &point.orbit;
        let (admissible, reason) = admissible_at(orbit, point.event);
        MachineBranchRow {
            branch,
            label: point.label.clone(),
            parameters: point.parameters.clone(),
            pattern: source.named(&orbit.pattern),
            phases: phases(orbit),
            speeds: speeds(orbit, rate),
            multipliers: multipliers(&orbit.multipliers),
            stable: stable(orbit, point.event),
            admissible,
            reason,
            coefficient: form.and_then(|form| Some(form.ok()?.coefficient)),
            criticality: form.map(|form| form.map_or_else(|why| why, |form| form.name())),
            nearest_stop: orbit.least.map(|least| source.machine.stops[least.stop].name.clone()),
            least_gap: orbit.least.map(|least| least.gap),
            residual: orbit.residual,
            newton_steps: orbit.steps,
            length: point.length,
        }
    }
}

/// The branches of a scene's machine.
pub(crate) struct MachineSource<'a> {
    family: &'a MachineSceneFamily<'a>,
    pub patterns: MachinePatterns<'a>,
    machine: &'a Machine<f64>,
}

impl<'a> MachineSource<'a> {
    /// # Errors
    /// Those of [`MachinePatterns::new`].
    pub fn new(
        family: &'a MachineSceneFamily<'a>,
        machine: &'a Machine<f64>,
        job: &Job,
    ) -> Result<MachineSource<'a>> {
        let depth = job.scene.machine_scene()?.minimum_depth;
        Ok(MachineSource { family, patterns: MachinePatterns::new(family, family.value(), depth)?, machine })
    }
}

impl<'a> BranchSource for MachineSource<'a> {
    type Family = MachinePatterns<'a>;

    fn family(&self) -> &MachinePatterns<'a> {
        &self.patterns
    }

    fn value(&self) -> f64 {
        self.family.value()
    }

    fn orbits(&self, start: &BranchStart, at: f64, job: &Job) -> Result<Vec<MachineOrbit>> {
        let (machine, _) = self.family.at(at)?;
        let mut found = match start.origin()? {
            BranchOrigin::Attractor(state) => {
                let from = job.scene.machine_state(state, &machine, "attractor")?;
                let simulator = job.machine_simulator(&machine, std::slice::from_ref(&from))?;
                vec![settled(&simulator, &from, job)?]
            }
            BranchOrigin::Orbit(keys) => orbits(keys, &machine, &job.machine_simulator(&machine, &[])?, job)?,
            BranchOrigin::Restart(_) => Vec::new(),
        };
        found.retain(FollowedOrbit::is_orbit);
        Ok(found)
    }

    fn label(&self, text: &str, label: &str) -> Result<Label<StopPattern>> {
        let names: Vec<&str> = self.machine.stops.iter().map(|stop| stop.name.as_str()).collect();
        read_label_as(text, label, form(&names), |strikes, period| {
            if strikes.is_empty() {
                return StopPattern::free(period);
            }
            StopPattern::new(strikes.iter().map(|&(stop, periods)| StopStrike { stop, periods }).collect())
        })
    }

    fn named(&self, pattern: &StopPattern) -> String {
        let names: Vec<&str> = self.machine.stops.iter().map(|stop| stop.name.as_str()).collect();
        pattern.with_names(&names)
    }
}

/// Periods that pass before a motion is taken to have settled.
const TRANSIENT: u32 = 5_000;
/// Periods between two looks at whether to go on.
const CHUNK: u32 = 16;
/// The longest period that is told from none.
const LONGEST: u32 = 200;
/// States this close, relative to the size of the motion, are the same: Newton's method does the rest.
const SAME: f64 = 1e-6;

/// The periodic orbit on which a motion settles.
fn settled(simulator: &MachineSimulator, from: &MachineState, job: &Job) -> Result<MachineOrbit> {
    let mut run = simulator.start(Time::new(0, from.t), from.q.as_slice(), from.u.as_slice())?;
    let at = |period: u32| Time::new(period.into(), from.t);
    for period in (0..TRANSIENT).step_by(CHUNK as usize) {
        let end = run.finish(at((period + CHUNK).min(TRANSIENT)));
        ended(&mut run, end)?;
        job.check()?;
    }
    // Where the state does not follow from times and speeds.
    let soft =
        simulator.is_smooth() || simulator.contacts().all().iter().any(|contact| contact.soft.is_some());
    let first = run.state();
    let mut struck = None;
    let size = simulator.scale().max(first.q.amax()).max(first.u.amax());
    let mut impacts: Vec<(usize, Time, f64)> = Vec::new();
    for period in 1..=LONGEST {
        let mut rests = false;
        let end = loop {
            match run.next(at(TRANSIENT + period)) {
                MachineEvent::Impact(hit) => {
                    impacts.push((hit.stop, hit.time, -hit.velocity));
                    if soft && struck.is_none() {
                        struck = Some(run.state());
                    }
                }
                MachineEvent::Stick(_) => rests = true,
                MachineEvent::End(end) => break end,
                _ => {}
            }
        };
        ended(&mut run, end)?;
        job.check()?;
        if rests || !run.resting().is_empty() {
            return Err(Error::input(
                "the motion comes to rest on a stop: orbits with rests are not followed",
            ));
        }
        let now = run.state();
        if (&now.q - &first.q).amax().max((&now.u - &first.u).amax()) > SAME * size {
            continue;
        }
        let turned = |time: &Time| {
            let turns = (time.phase / TAU).floor();
            (time.period + turns as i64, time.phase - turns * TAU)
        };
        let times: Vec<(i64, f64)> = impacts.iter().map(|(_, time, _)| turned(time)).collect();
        let counted = natural(&times, period);
        let strikes =
            impacts.iter().zip(&counted).map(|(hit, &(periods, _))| StopStrike { stop: hit.0, periods });
        let strikes: Vec<StopStrike> = strikes.collect();
        if soft && strikes.is_empty() {
            let end = run.finish(Time::new(i64::from(TRANSIENT + period) + 1, 0.0));
            ended(&mut run, end)?;
            return find_from(simulator, &StopPattern::free(period)?, &[], Some(&run.state()));
        }
        let pattern = if strikes.is_empty() { StopPattern::free(1)? } else { StopPattern::new(strikes)? };
        let start: Vec<f64> =
            counted.iter().zip(&impacts).flat_map(|((_, time), (_, _, speed))| [*time, *speed]).collect();
        return find_from(simulator, &pattern, &start, struck.as_ref());
    }
    Err(Error::input(format!(
        "the motion has no period of at most {LONGEST} after {TRANSIENT} periods: its attractor is not periodic, or it settles slowly"
    )))
}

fn ended(run: &mut MachineRun, end: RunEnd) -> Result<()> {
    match (run.failure(), end) {
        (Some(error), _) => Err(error),
        (None, RunEnd::Reached) => Ok(()),
        (None, end) => Err(Error::input(format!("the motion ended before it settled, {}", end.why()))),
    }
}
