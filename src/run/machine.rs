//! Tasks on machines: one motion, its impacts and rests, by stop.
//!
//! Inside, time is the forcing's phase; everything here is reported in the scene's unit of time, and in
//! periods.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{
    Finding, Job, Keeper, Lines, Status, row,
    series::{SampledMotion, follow},
};
use crate::{
    error::Result,
    many::{
        Machine, MachineState, RealVector,
        contact::StopContact,
        section::PlanarMachine,
        simulate::{MachineEvent, MachineRun, MachineSettings, MachineSimulator, PeakForces},
    },
    motion::{RunEnd, Time},
    scene::{MachineSceneFamily, simulate::SimulateTask},
};

row! {
    /// What happened at a stop.
    pub struct StopRow {
        /// Its name.
        pub stop: String,
        /// Impacts there; contacts with a stop that gives way.
        pub impacts: u64,
        /// Minima of its gap within the minimum depth, of which no impact or contact was made.
        pub tangencies: u64,
        /// How often something came to rest on it.
        pub rests: u64,
        /// The largest speed of an impact, or with which a contact began, in the scene's units.
        pub fastest: f64,
        /// The largest impulse of an impact, in the scene's units; absent for a stop that gives way.
        pub strongest: Option<f64>,
        /// The largest force found with which a stop that gives way pushes, in the scene's units; absent for
        /// a rigid one.
        pub peak_force: Option<f64>,
        /// The least gap at points of the series.
        pub least_gap: f64,
        /// The largest gap at points of the series.
        pub largest_gap: f64,
    }
}

row! {
    /// A mode that oscillates.
    pub struct ModeRow {
        /// Its natural frequency, in cycles per unit of time.
        pub frequency: f64,
        /// Its damping ratio.
        pub damping_ratio: f64,
    }
}

/// What happened in one motion of a machine; its series and its events went to the [`Keeper`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineSimulationFindings {
    /// Forcing periods asked for after the transient.
    pub periods: u32,
    /// The period, in the scene's unit of time.
    pub period: f64,
    /// How the motion is computed.
    pub method: &'static str,
    /// The condition number of the modes; absent where they do not exist or forces are formulas.
    pub condition: Option<f64>,
    /// The slowest modes, at most ten; where forces are formulas, of the machine linearised at rest.
    pub modes: Vec<ModeRow>,
    /// How many modes oscillate.
    pub oscillating: usize,
    /// What happened at each stop, after the transient.
    pub stops: Vec<StopRow>,
    /// Instants at which several stops were hit and impacts one by one would have ended otherwise.
    pub order_matters: u64,
    /// Why it ended.
    pub end: RunEnd,
    /// Forcing periods from the beginning to the end.
    pub ended_at: f64,
    /// The displacements at the end.
    pub q: Vec<f64>,
    /// The velocities at the end.
    pub u: Vec<f64>,
    /// The accelerations there.
    #[serde(skip)]
    pub acceleration: Vec<f64>,
    /// What counts as contact without impact.
    pub minimum_depth: f64,
    /// What the harmonics of a measured force leave out, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<MeasuredEffect>,
}

/// How well the harmonics of a measured force stand for it, and what of it the motion feels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeasuredEffect {
    /// The file.
    pub file: String,
    /// The samples used, of so many whole periods; the rest is left out.
    pub samples: usize,
    /// Whole periods in the record.
    pub periods: usize,
    /// The samples left out.
    pub left_out: usize,
    /// How many harmonics stand for it.
    pub harmonics: usize,
    /// The largest difference from a sample.
    pub residual: f64,
    /// The largest difference from the record, taken as straight between samples, is no larger. Of a record
    /// taken once an eighth of its largest second difference: what a smooth force may have been off that
    /// between the samples.
    pub bound: f64,
    /// What stands for it: "harmonics", or "linear", straight lines between the samples of a record taken
    /// once.
    pub interpolation: &'static str,
    /// By how much a force of that size could change the gap at the first impact.
    pub gap_change: Option<f64>,
    /// By how much of a period it could change its time, to first order; absent without an impact.
    pub time_change: Option<f64>,
}

/// ∫ |response of a contact's gap to a force of 1 in a direction| over a time from its start, by the
/// trapezoidal rule.
fn felt(
    simulator: &MachineSimulator,
    direction: &[f64],
    machine: &Machine<f64>,
    stop: usize,
    time: f64,
) -> f64 {
    let flow = simulator.flow();
    let Ok(force) = machine.direction(direction) else { return f64::NAN };
    let n = machine.size;
    let fastest = flow.rates().into_iter().fold(1.0, f64::max);
    let steps = (time * fastest * 16.0).ceil().clamp(64.0, 20_000.0);
    let step = flow.transition(time / steps);
    let mut state = RealVector::zeros(2 * n);
    state.rows_mut(n, n).copy_from(&simulator.equations().accelerate(&force));
    let row = &simulator.contacts().all()[stop].row;
    let (mut sum, mut before) = (0.0, 0.0f64);
    for _ in 0..steps as u64 {
        state = &step * state;
        let gap = row.dot(&state.rows(0, n)).abs();
        sum += (before + gap) / 2.0 * time / steps;
        before = gap;
    }
    sum
}

impl Finding for MachineSimulationFindings {
    fn status(&self) -> Status {
        Status::of_motion(self.end, self.ended_at, [&self.q, &self.u, &self.acceleration])
    }

    fn warnings(&self) -> Vec<String> {
        let mut all = Vec::new();
        if self.order_matters > 0 {
            all.push(format!(
                "{} times several stops were hit at one instant and the outcome depends on the order: Newton's law for all at once was used",
                self.order_matters
            ));
        }
        for stop in &self.stops {
            let extent = stop.largest_gap - stop.least_gap;
            if stop.impacts > 0 && extent < 1e3 * self.minimum_depth {
                all.push(format!(
                    "the gap of stop {} extends over {extent:.3e}, within a thousand times minimum_depth = {:e}: impacts \
                     shallower than that are not told from contact; lower minimum_depth",
                    stop.stop, self.minimum_depth
                ));
            }
        }
        all
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("method", self.method);
        if let Some(condition) = self.condition {
            lines.say("condition", condition);
        }
        lines.table("modes", &self.modes);
        if self.oscillating > self.modes.len() {
            lines.say("more_modes", self.oscillating - self.modes.len());
        }
        lines.say("period", self.period);
        lines.say("periods", self.periods);
        lines.table("stops", &self.stops);
        if self.end != RunEnd::Reached {
            lines.say("ended", self.end.why());
            lines.say("after_periods", self.ended_at);
        }
        if let Some(measured) = &self.measured {
            lines.say("measured_force", measured.file.as_str());
            lines.say("interpolation", measured.interpolation);
            if measured.harmonics > 0 {
                lines.say("harmonics", measured.harmonics);
                lines.say("residual", measured.residual);
            }
            lines.say("bound", measured.bound);
            if let (Some(gap), Some(time)) = (measured.gap_change, measured.time_change) {
                lines.say("gap_change", gap);
                lines.say("time_change", time);
            }
        }
        if self.q.len() <= 10 {
            lines.say("q", self.q.clone());
            lines.say("u", self.u.clone());
        }
    }
}

/// Modes that a report lists.
const LISTED: usize = 10;

/// Gaps within this of their motion's size are contact without impact, unless the scene says otherwise.
const RELATIVE_DEPTH: f64 = 1e-12;

impl Job<'_> {
    /// A simulator of a machine. The minimum depth is the scene's, or 10⁻¹² of the size of the gap to the
    /// nearest stop, or of what starts show at the stops.
    ///
    /// # Errors
    /// Those of [`MachineSimulator::new`].
    pub fn machine_simulator(
        &self,
        machine: &Machine<f64>,
        starts: &[MachineState],
    ) -> Result<MachineSimulator> {
        let given = self.scene.machine_scene()?.minimum_depth;
        let settings = |minimum_depth| MachineSettings { minimum_depth, ..MachineSettings::default() };
        if let Some(depth) = given {
            return Ok(MachineSimulator::new(machine, &settings(depth))?.counting(self.tally.clone()));
        }
        let simulator = MachineSimulator::new(machine, &settings(RELATIVE_DEPTH))?;
        let gap = |state: &MachineState| {
            let one =
                |contact: &StopContact| contact.row.dot(&state.q).abs().max(contact.gap(state)[1].abs());
            simulator.contacts().all().iter().map(one).fold(0.0, f64::max)
        };
        let scale = starts.iter().map(gap).fold(simulator.gap_scale(), f64::max);
        let scale = if scale > 0.0 && scale.is_finite() { scale } else { 1.0 };
        Ok(simulator.with(settings(RELATIVE_DEPTH * scale)).counting(self.tally.clone()))
    }
}

impl Job<'_> {
    /// The scene's machines over a parameter, their work counted.
    ///
    /// # Errors
    /// Those of [`MachineSceneFamily::new`].
    pub fn machine_family(&self, parameter: &str) -> Result<MachineSceneFamily<'_>> {
        Ok(MachineSceneFamily::new(&self.scene, parameter)?.counting(self.tally.clone()))
    }

    /// A machine with the plane in which its sections are seen.
    ///
    /// # Errors
    /// Those of [`machine_simulator`](Self::machine_simulator); a plane that names what the machine does not
    /// have.
    pub(crate) fn planar(
        &self,
        machine: &Machine<f64>,
        starts: &[MachineState],
        plane: &[String],
    ) -> Result<PlanarMachine> {
        let axes = self.scene.plane(plane, machine, "plane")?;
        PlanarMachine::new(machine, self.machine_simulator(machine, starts)?, &axes)
    }
}

/// Follows the motion; each point and each event goes to `keeper` as it comes, so that memory does not grow
/// with the length.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub fn simulate_machine(
    task: &SimulateTask,
    machine: &Machine<f64>,
    job: &Job,
    keeper: &mut dyn Keeper,
) -> Result<MachineSimulationFindings> {
    let start = job.scene.machine_state(&task.start, machine, "start")?;
    let simulator = job.machine_simulator(machine, std::slice::from_ref(&start))?;
    job.monitor.begin(task.transient + u64::from(task.periods), "periods");
    let run = simulator.start(Time::new(0, start.t), start.q.as_slice(), start.u.as_slice())?;
    let found = MachineSimulationFindings::before(task, machine, &simulator);
    // What is pushed in the transient is no peak of the series.
    let mut motion =
        Motion { simulator: &simulator, run, found, first: None, peaks: None, several: None, keeper };
    let end = follow(task, start.t, &mut motion, job.monitor)?;
    let Motion { mut run, mut found, first, peaks, .. } = motion;
    if let Some(error) = run.failure() {
        return Err(error);
    }
    let peaks = peaks.unwrap_or_else(|| PeakForces::new(&run));
    for (row, peak) in found.stops.iter_mut().zip(peaks.peaks()) {
        row.peak_force = row.peak_force.map(|_| *peak);
    }
    let (state, rate) = (run.state(), simulator.rate());
    found.end = end;
    found.q = machine.seen(&state.q).iter().copied().collect();
    found.u = machine.seen(&state.u).iter().map(|u| u * rate).collect();
    let bend = simulator.acceleration(&state)?;
    found.acceleration = machine.seen(&bend).iter().map(|a| a * rate * rate).collect();
    found.ended_at = run.time().periods();
    // After a transient it is not the first impact; where forces are formulas the record's effect is none of
    // a linear machine.
    let first = first.filter(|_| task.transient == 0 && !machine.is_smooth());
    found.measured = measured(job, machine, &simulator, start.t, first)?;
    Ok(found)
}

/// An impact: its stop, its time, the gap's rate.
type FirstImpact = (usize, Time, f64);

/// The motion with what was found of it so far.
struct Motion<'a> {
    simulator: &'a MachineSimulator,
    run: MachineRun<'a>,
    found: MachineSimulationFindings,
    first: Option<FirstImpact>,
    peaks: Option<PeakForces>,
    /// The last instant at which the order of several impacts mattered: it counts once.
    several: Option<Time>,
    keeper: &'a mut dyn Keeper,
}

impl SampledMotion for Motion<'_> {
    const CHUNK: u64 = 16;

    fn pass(&mut self, until: Time) -> RunEnd {
        self.run.finish(until)
    }

    fn record(&mut self, until: Time) -> Result<RunEnd> {
        let mut failed = None;
        loop {
            let peaks = self.peaks.get_or_insert_with(|| PeakForces::new(&self.run));
            let event = self.run.next(until);
            peaks.flown(&self.run);
            if let MachineEvent::End(end) = event {
                return failed.map_or(Ok(end), Err);
            }
            self.count(&event);
            if failed.is_none() {
                failed = self.keeper.machine_event(&event).err();
            }
        }
    }

    fn sample(&mut self, at: Time) -> Result<()> {
        let state = self.run.state();
        for (row, contact) in self.found.stops.iter_mut().zip(self.simulator.contacts().all()) {
            let [gap, _] = contact.gap(&state);
            (row.least_gap, row.largest_gap) = (row.least_gap.min(gap), row.largest_gap.max(gap));
        }
        self.keeper.machine_sample(at, &state)
    }
}

impl Motion<'_> {
    /// Adds an event to the row of its stop.
    fn count(&mut self, event: &MachineEvent) {
        let rate = self.simulator.rate();
        let Some(row) = event.stop().map(|stop| &mut self.found.stops[stop]) else { return };
        match event {
            MachineEvent::Impact(impact) => {
                self.first.get_or_insert((impact.stop, impact.time, impact.velocity));
                row.impacts += 1;
                row.fastest = row.fastest.max(impact.velocity.abs() * rate);
                // Masses per radian² times velocities per radian, over Ω, are masses times velocities.
                let impulse = impact.impulse / rate;
                row.strongest = row.strongest.map(|most| most.max(impulse));
                if impact.order_matters && self.several != Some(impact.time) {
                    self.found.order_matters += 1;
                    self.several = Some(impact.time);
                }
            }
            MachineEvent::Touch(touch) => {
                row.impacts += 1;
                row.fastest = row.fastest.max(touch.velocity.abs() * rate);
            }
            MachineEvent::Tangency(_) => row.tangencies += 1,
            MachineEvent::Stick(_) => row.rests += 1,
            _ => {}
        }
    }
}

impl MachineSimulationFindings {
    /// What there is to say of the machine before it moves.
    fn before(task: &SimulateTask, machine: &Machine<f64>, simulator: &MachineSimulator) -> Self {
        let (flow, smooth) = (simulator.flow(), simulator.is_smooth());
        let (frequencies, cycles) = (flow.frequencies(), 1.0 / machine.period);
        let mode = |&(frequency, damping_ratio): &(f64, f64)| ModeRow {
            frequency: frequency * cycles,
            damping_ratio,
        };
        let stop = |contact: &StopContact| StopRow {
            stop: contact.name.clone(),
            impacts: 0,
            tangencies: 0,
            rests: 0,
            fastest: 0.0,
            strongest: contact.soft.is_none().then_some(0.0),
            peak_force: contact.soft.map(|_| 0.0),
            least_gap: f64::INFINITY,
            largest_gap: f64::NEG_INFINITY,
        };
        MachineSimulationFindings {
            periods: task.periods,
            period: machine.period,
            method: if smooth { "Taylor series" } else { flow.method().name() },
            condition: Some(flow.condition()).filter(|condition| condition.is_finite() && !smooth),
            modes: frequencies.iter().take(LISTED).map(mode).collect(),
            oscillating: frequencies.len(),
            stops: simulator.contacts().all().iter().map(stop).collect(),
            order_matters: 0,
            end: RunEnd::Reached,
            ended_at: 0.0,
            q: Vec::new(),
            u: Vec::new(),
            acceleration: Vec::new(),
            minimum_depth: simulator.settings().minimum_depth,
            measured: None,
        }
    }
}

/// What is known of the measured force of a scene that has one, and of how far it may move the first impact
/// of a motion that begins at `phase`.
fn measured(
    job: &Job,
    machine: &Machine<f64>,
    simulator: &MachineSimulator,
    phase: f64,
    first: Option<FirstImpact>,
) -> Result<Option<MeasuredEffect>> {
    let Some(force) = &job.scene.machine_scene()?.measured else { return Ok(None) };
    let direction: Vec<f64> =
        force.direction.iter().map(|one| job.scene.number(one)).collect::<Result<_>>()?;
    let change = first.map(|(stop, time, velocity)| {
        let since = time.since(Time::new(0, phase));
        (force.bound * felt(simulator, &direction, machine, stop, since), velocity.abs())
    });
    Ok(Some(MeasuredEffect {
        file: force.file.clone(),
        samples: force.samples,
        periods: force.periods,
        left_out: force.left_out,
        harmonics: force.harmonics.len(),
        residual: force.residual,
        bound: force.bound,
        interpolation: if force.once.is_some() { "linear" } else { "harmonics" },
        gap_change: change.map(|(gap, _)| gap),
        time_change: change.map(|(gap, speed)| gap / speed / TAU),
    }))
}
