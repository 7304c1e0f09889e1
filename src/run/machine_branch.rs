//! Tasks of kind `branch` on machines: continuation of periodic orbits over a parameter, and of their
//! bifurcations over two.
//!
//! The continuation is that of oscillators ([`branch`](super::branch)). Phases are fractions of the period,
//! speeds and gaps in the scene's units.

use std::f64::consts::TAU;

use super::{
    Complex, Job, Judgement,
    branch::{BranchList, BranchSource, PointRow, events, follow_over, settled},
    machine_orbit::{admissible_at, multipliers, orbits, phases, speeds, stable},
    row,
};
use crate::{
    attractor::dynamics::Dynamics,
    continuation::{
        BranchPoint, CODIMENSION_TWO, FollowedOrbit, Label, NoForm, NormalForm, RecordForm, read_label_as,
    },
    error::{Error, Result},
    many::{
        Machine, MachineFamily, MachineState,
        branch::{MachinePatterns, MachinePlane},
        normal_form::normal_form,
        orbit::{MachineOrbit, StopPattern, StopStrike, find_from},
        section::PlanarMachine,
        simulate::{MachineEvent, MachineRun},
    },
    motion::{RunEnd, Time},
    one::orbit::natural,
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
    let family = job.machine_family(&task.parameter)?;
    let source = MachineSource::new(&family, machine, job)?;
    let found = match &task.second {
        Some(second) => {
            let at =
                |[first, other]: [f64; 2]| job.scene.machine(&[(&task.parameter, first), (second, other)]);
            let value = MachineSceneFamily::new(&job.scene, second)?.value();
            let place = [family.value(), value];
            let plane =
                MachinePlane::new(&at, place, job.scene.machine_scene()?.minimum_depth, family.tally())?;
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
                let planar = job.planar(&machine, std::slice::from_ref(&from), &[])?;
                vec![attracting(&planar, &from, from.t, job)?]
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

/// The periodic orbit on which a motion settles: its impact pattern is read off the attractor that is found.
fn attracting(planar: &PlanarMachine, from: &MachineState, phase: f64, job: &Job) -> Result<MachineOrbit> {
    let (simulator, detection) = (planar.simulator(), settled(phase));
    let start = from.start(simulator.rate());
    let found = planar.fates(std::slice::from_ref(&start), &detection, &[], job.monitor)?;
    let fate = found.into_iter().next().flatten();
    let fate = fate.ok_or_else(|| Error::input("the attractor's start lies behind a stop"))?;
    let cycle = fate.periodic(&detection)?;
    // At phase 0 the state of an orbit without impacts is asked for.
    let at = planar.state(&cycle.points[0].whole, phase);
    let period = cycle.period() as i64;
    let mut run = simulator.start(Time::new(0, phase), at.q.as_slice(), at.u.as_slice())?;
    // Where the state does not follow from times and speeds.
    let soft =
        simulator.is_smooth() || simulator.contacts().all().iter().any(|contact| contact.soft.is_some());
    let (mut struck, mut impacts) = (None, Vec::<(usize, Time, f64)>::new());
    let mut rests = !run.resting().is_empty();
    let end = loop {
        match run.next(Time::new(period, phase)) {
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
    if rests {
        return Err(Error::input("the motion comes to rest on a stop: orbits with rests are not followed"));
    }
    let turned = |time: &Time| {
        let turns = (time.phase / TAU).floor();
        (time.period + turns as i64, time.phase - turns * TAU)
    };
    let times: Vec<(i64, f64)> = impacts.iter().map(|(_, time, _)| turned(time)).collect();
    let counted = natural(&times, period as u32);
    let strikes =
        impacts.iter().zip(&counted).map(|(hit, &(periods, _))| StopStrike { stop: hit.0, periods });
    let strikes: Vec<StopStrike> = strikes.collect();
    if strikes.is_empty() {
        let pattern = StopPattern::free(period as u32)?;
        let end = run.finish(Time::new(period + 1, 0.0));
        ended(&mut run, end)?;
        return find_from(simulator, &pattern, &[], Some(&run.state()));
    }
    let start: Vec<f64> =
        counted.iter().zip(&impacts).flat_map(|((_, time), (_, _, speed))| [*time, *speed]).collect();
    find_from(simulator, &StopPattern::new(strikes)?, &start, struck.as_ref())
}

fn ended(run: &mut MachineRun, end: RunEnd) -> Result<()> {
    match (run.failure(), end) {
        (Some(error), _) => Err(error),
        (None, RunEnd::Reached) => Ok(()),
        (None, end) => Err(Error::input(format!("the attractor's motion ended, {}", end.why()))),
    }
}
