//! One motion of a machine, followed for the task `simulate`.
//!
//! Inside, time is the forcing's phase; everything here is reported in the scene's unit of time, and in
//! periods.

use std::f64::consts::TAU;

use super::{
    super::super::{
        Job, Keeper, MeasuredEffect, ModeRow, SimulationFindings, StopRow,
        series::{SampledMotion, follow},
    },
    Machines,
};
use crate::{
    error::Result,
    many::{
        Machine, RealVector,
        contact::StopContact,
        simulate::{Event, MachineRun, MachineSimulator, PeakForces},
    },
    motion::{RunEnd, Time},
    scene::simulate::SimulateTask,
};

/// Modes that a report lists.
const LISTED: usize = 10;

/// Follows the motion of a task.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub(super) fn simulate(
    task: &SimulateTask,
    engine: &Machines,
    keeper: &mut dyn Keeper,
) -> Result<SimulationFindings> {
    let Machines { job, machine } = *engine;
    let start = job.scene.machine_state(&task.start, machine, "start")?;
    let simulator = job.machine_simulator(machine, std::slice::from_ref(&start))?;
    job.monitor.begin(task.transient + u64::from(task.periods), "periods");
    let run = simulator.start(Time::new(0, start.t), start.q.as_slice(), start.u.as_slice())?;
    let found = before(task, job, machine, &simulator);
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
    (found.moved.end, found.moved.ended_at) = (end, run.time().periods());
    found.moved.q = machine.seen(&state.q).iter().copied().collect();
    found.moved.u = machine.seen(&state.u).iter().map(|u| u * rate).collect();
    let bend = simulator.acceleration(&state)?;
    found.acceleration = machine.seen(&bend).iter().map(|a| a * rate * rate).collect();
    // After a transient it is not the first impact; where forces are formulas the record's effect is none of
    // a linear machine.
    let first = first.filter(|_| task.transient == 0 && !machine.is_smooth());
    found.measured = measured(job, machine, &simulator, start.t, first)?;
    Ok(found)
}

/// What there is to say of the machine before it moves.
fn before(
    task: &SimulateTask,
    job: &Job,
    machine: &Machine<f64>,
    simulator: &MachineSimulator,
) -> SimulationFindings {
    let (flow, smooth) = (simulator.flow(), simulator.is_smooth());
    let (frequencies, cycles) = (flow.frequencies(), 1.0 / machine.period);
    let mode =
        |&(frequency, damping_ratio): &(f64, f64)| ModeRow { frequency: frequency * cycles, damping_ratio };
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
    let depth = simulator.settings().minimum_depth;
    let mut found = SimulationFindings::new(task, job, machine.period, depth);
    found.moved.method = Some(if smooth { "Taylor series" } else { flow.method().name() });
    found.moved.condition = Some(flow.condition()).filter(|condition| condition.is_finite() && !smooth);
    found.moved.oscillating = frequencies.len();
    found.modes = frequencies.iter().take(LISTED).map(mode).collect();
    found.stops = simulator.contacts().all().iter().map(stop).collect();
    found
}

/// An impact: its stop, its time, the gap's rate.
type FirstImpact = (usize, Time, f64);

/// The motion with what was found of it so far.
struct Motion<'a> {
    simulator: &'a MachineSimulator,
    run: MachineRun<'a>,
    found: SimulationFindings,
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
            if let Event::End(end) = event {
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
    fn count(&mut self, event: &Event) {
        let rate = self.simulator.rate();
        self.found.count(event);
        let Some(row) = event.place().map(|stop| &mut self.found.stops[stop]) else { return };
        match event {
            Event::Impact(impact) => {
                self.first.get_or_insert((impact.place, impact.time, impact.velocity));
                row.impacts += 1;
                row.fastest = row.fastest.max(impact.velocity.abs() * rate);
                // Masses per radian² times velocities per radian, over Ω, are masses times velocities.
                let impulse = impact.shock.impulse / rate;
                row.strongest = row.strongest.map(|most| most.max(impulse));
                if impact.shock.order_matters && self.several != Some(impact.time) {
                    self.found.moved.order_matters += 1;
                    self.several = Some(impact.time);
                }
            }
            Event::Touch(touch) => {
                row.impacts += 1;
                row.fastest = row.fastest.max(touch.velocity.abs() * rate);
            }
            Event::Tangency(_) => row.tangencies += 1,
            Event::Stick(_) => row.rests += 1,
            _ => {}
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
