//! One motion of a machine, followed for the task `simulate`.
//!
//! Inside, time is the forcing's phase; everything here is reported in the scene's unit of time, and in
//! periods.

use std::f64::consts::TAU;

use super::{
    super::super::{
        Job, Keeper, MeasuredEffect, SeriesOf, SeriesPoint, SeriesStop, SimulationFindings, StopEvent,
        follow::{SampledMotion, follow},
        simulate::{DOWN, UP},
    },
    Machines,
};
use crate::{
    error::{Error, Result},
    many::{
        Grip, Machine, NormalForce, RealVector, State,
        contact::StopContact,
        section,
        simulate::{Contact, Event, Pushes, Run, Simulator, Slid, goes_on},
        threshold,
    },
    motion::{
        RunEnd, SmoothForce, Time,
        event::{Release, Touch},
    },
    scene::{Expression, simulate::SimulateTask},
};

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
    let events = &job.scene.machine_scene()?.events;
    let watched = watching(engine)?;
    let simulator = job.machine_simulator(&watched, std::slice::from_ref(&start))?;
    let span = job.scene.span(task)?;
    let of = series_of(machine, &simulator, [Time::new(task.transient as i64, start.t).periods(), span]);
    keeper.begin(&of)?;
    job.monitor.begin(task.transient + span.ceil() as u64, "periods");
    let run = simulator.start(Time::new(0, start.t), start.q.as_slice(), start.u.as_slice())?;
    let found = before(span, &of, machine, &simulator);
    let along = of.stops.iter().map(|stop| stop.along).collect();
    // What is pushed in the transient is nothing of the series.
    let mut motion = Motion {
        simulator: &simulator,
        machine,
        along,
        run,
        found,
        first: None,
        pushes: None,
        slid: None,
        places: places(&of, &simulator),
        ends: events.iter().map(|known| known.2).collect(),
        keeper,
    };
    let end = follow((task, span), start.t, &mut motion, job.monitor)?;
    let Motion { mut run, mut found, first, pushes, slid, .. } = motion;
    if let Some(error) = run.failure() {
        return Err(error);
    }
    let pushes = pushes.unwrap_or_else(|| Pushes::new(&run));
    let soft = found.stops.iter_mut().zip(pushes.all()).filter(|(row, _)| row.peak_force.is_some());
    for (row, all) in soft {
        (row.peak_force, row.longest) = (Some(all.peak), Some(all.duration / simulator.rate()));
        (row.impulse, row.dissipated) = (all.impulse / simulator.rate(), all.energy);
    }
    let (state, rate) = (run.state(), simulator.rate());
    let list = |of: &RealVector, unit: f64| machine.seen(of).iter().map(|x| x * unit).collect();
    let bend = simulator.acceleration(&state)?;
    let last = [list(&state.q, 1.0), list(&state.u, rate), list(&bend, rate * rate)];
    found.ended((end, run.time()), last);
    let slid = slid.unwrap_or_else(|| Slid::new(&run));
    let grips = run.grips();
    // A force recorded once has no next period.
    let forever = grips.contains(&Grip::Stuck)
        && end == RunEnd::Reached
        && machine.record.is_none()
        && goes_on(&mut run);
    let rubs = machine.friction.iter().zip(grips.into_iter().zip(slid.rows()));
    for (row, (friction, (grip, (share, path, energy)))) in found.friction.iter_mut().zip(rubs) {
        (row.stuck, row.path) = (share, path);
        row.dissipated = match friction.normal {
            NormalForce::Given(normal) if friction.law.is_none() => friction.coefficient * normal * path,
            _ => energy,
        };
        row.at_end = match grip {
            Grip::Open => "open",
            Grip::Stuck if forever => "sticks for ever",
            Grip::Stuck => "sticks",
            Grip::Forward | Grip::Backward => "slides",
        };
    }
    // After a transient it is not the first impact; where forces are formulas the record's effect is none of
    // a linear machine.
    let first = first.filter(|_| task.transient == 0 && !machine.is_smooth());
    found.measured = measured(job, machine, &simulator, start.t, first)?;
    Ok(found)
}

/// The machine, on whose motions the scene's thresholds are told.
fn watching(engine: &Machines) -> Result<Machine<f64>> {
    let Machines { job, machine } = *engine;
    let value = |(name, of, _): &(String, SmoothForce<Expression>, bool)| {
        Ok::<_, Error>((name.clone(), of.try_map(&mut |x| job.scene.number(x))?))
    };
    let all: Vec<_> = job.scene.machine_scene()?.events.iter().map(value).collect::<Result<_>>()?;
    Ok(machine.clone().watching(&all))
}

/// Where crossings are counted from, in radians after a start: what happens at the phase of a section, which
/// is a round number, is not at both ends then.
const APART: f64 = 0.382;

/// How often the motion from a start passes each threshold in a period, up and down: the mean over so many,
/// or over what the motion lasts.
///
/// # Errors
/// Those of the simulator; a motion that ends at once; an interruption.
pub(super) fn crossings(
    engine: &Machines,
    start: &section::Start,
    periods: u32,
) -> Result<Vec<(String, [f64; 2])>> {
    let job = engine.job;
    if job.scene.machine_scene()?.events.is_empty() {
        return Ok(Vec::new());
    }
    let watched = watching(engine)?;
    let u: Vec<f64> = start.u.iter().map(|u| u / watched.rate()).collect();
    let state = State {
        t: start.t,
        q: RealVector::from_column_slice(&start.q),
        u: RealVector::from_column_slice(&u),
    };
    let simulator = job.machine_simulator(&watched, std::slice::from_ref(&state))?;
    let texts: Vec<Option<&str>> =
        simulator.kinks().map(|k| threshold(&simulator.switches()[k].text)).collect();
    let before = simulator.contacts().all().len() + watched.friction.len();
    let mut counts = vec![[0.0; 2]; texts.len()];
    let mut run = simulator.start(Time::new(0, start.t), &start.q, &u)?;
    let first = Time::new(0, start.t).after(APART);
    let last = Time { period: first.period + i64::from(periods), ..first };
    let mut passed = f64::from(periods);
    for until in [first, last] {
        loop {
            job.check()?;
            let event = run.next(until);
            if let Some(error) = run.failure() {
                return Err(error);
            }
            match event {
                Event::End(RunEnd::Reached) => break,
                Event::End(end) => {
                    passed = run.time().since(first) / TAU;
                    if passed > 0.0 {
                        break;
                    }
                    let why = end.why();
                    return Err(Error::input(format!("no threshold is counted, as the motion ended, {why}")));
                }
                Event::Kink(kink) if until == last => {
                    let kink = kink.place - before;
                    counts[kink][usize::from(run.is_below(kink))] += 1.0;
                }
                _ => {}
            }
        }
    }
    let named =
        |(text, count): (Option<&str>, [f64; 2])| Some((text?.to_string(), count.map(|x| x / passed)));
    Ok(texts.into_iter().zip(counts).filter_map(named).collect())
}

fn series_of(machine: &Machine<f64>, simulator: &Simulator, [begin, span]: [f64; 2]) -> SeriesOf {
    let points = machine.points();
    // Of one coordinate that is seen at one point, the factor between the two.
    let alone =
        (points == 1 && machine.size == 1).then(|| machine.seen(&RealVector::from_element(1, 1.0))[0]);
    let stop = |contact: &StopContact| SeriesStop {
        name: contact.name.clone(),
        along: alone.map(|factor| contact.row[0] / factor),
    };
    let stops = simulator.contacts().all().iter().map(stop).collect();
    let friction = machine.friction.iter().map(|friction| friction.name.clone()).collect();
    let texts = || simulator.kinks().map(|k| simulator.switches()[k].text.as_str());
    let kinks = texts().filter(|text| threshold(text).is_none()).map(str::to_string).collect();
    let events = texts().filter_map(threshold).map(str::to_string).collect();
    SeriesOf { points, stops, friction, kinks, events, period: machine.period, begin, span }
}

/// Of each kink, as events number them, its place among all kinks of forces and then all events.
fn places(of: &SeriesOf, simulator: &Simulator) -> Vec<usize> {
    let (mut kinks, mut events) = (0.., of.kinks.len()..);
    let texts = simulator.kinks().map(|k| threshold(&simulator.switches()[k].text));
    texts.filter_map(|event| if event.is_some() { events.next() } else { kinks.next() }).collect()
}

/// What there is to say of the machine before it moves.
fn before(span: f64, of: &SeriesOf, machine: &Machine<f64>, simulator: &Simulator) -> SimulationFindings {
    let (flow, smooth) = (simulator.flow(), simulator.is_smooth());
    let compliant: Vec<bool> = simulator.contacts().all().iter().map(|stop| stop.soft.is_some()).collect();
    let method = if smooth { "Taylor series" } else { flow.method().name() };
    let depth = simulator.settings().minimum_depth;
    let mut found = SimulationFindings::new(span, (of, &compliant), method, depth);
    found.moved.condition = Some(flow.condition()).filter(|condition| condition.is_finite() && !smooth);
    let cycles = 1.0 / machine.period;
    let modes: Vec<_> =
        flow.frequencies().into_iter().map(|(rate, damping)| (rate * cycles, damping)).collect();
    found.oscillating(&modes);
    found
}

/// An impact: its stop, its time, the gap's rate.
type FirstImpact = (usize, Time, f64);

/// The motion with what was found of it so far.
struct Motion<'a> {
    simulator: &'a Simulator,
    machine: &'a Machine<f64>,
    /// Of one coordinate, by how much the gap of each stop opens with it.
    along: Vec<Option<f64>>,
    run: Run<'a>,
    found: SimulationFindings,
    first: Option<FirstImpact>,
    pushes: Option<Pushes>,
    slid: Option<Slid>,
    /// Of each kink, as events number them, its place in reports.
    places: Vec<usize>,
    /// Which events end the motion.
    ends: Vec<bool>,
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
            let pushes = self.pushes.get_or_insert_with(|| Pushes::new(&self.run));
            let slid = self.slid.get_or_insert_with(|| Slid::new(&self.run));
            let event = self.run.next(until);
            pushes.flown(&self.run);
            let contact = match &event {
                Event::Touch(Touch { place, .. }) | Event::Release(Release { place, .. }) => {
                    self.simulator.contacts().all().get(*place).map(|stop| pushes.ended(*place, stop))
                }
                _ => None,
            };
            slid.flown(&self.run);
            if let Event::End(end) = event {
                return failed.map_or(Ok(end), Err);
            }
            if let Event::Impact(impact) = event {
                self.first.get_or_insert((impact.place, impact.time, impact.velocity));
            }
            let Some(event) = self.told(&event, contact) else { continue };
            if self.found.happened(&event) && failed.is_none() {
                failed = self.keeper.event(&event).err();
            }
            let before = self.found.stops.len() + self.found.friction.len() + self.found.kinks.len();
            let ends = event.stop.checked_sub(before).is_some_and(|event| self.ends[event]);
            if ends && failed.is_none() {
                return Ok(RunEnd::Event);
            }
        }
    }

    fn sample(&mut self, time: Time) -> Result<()> {
        let (state, rate) = (self.run.state(), self.machine.rate());
        let here = State { t: time.phase, ..state.clone() };
        let gap = |stop: &StopContact| {
            let [gap, speed] = stop.gap(&here);
            [gap, speed * rate]
        };
        let gaps: Vec<[f64; 2]> = self.simulator.contacts().all().iter().map(gap).collect();
        let (q, u) = (self.machine.seen(&state.q), self.machine.seen(&state.u) * rate);
        let sample = SeriesPoint { time, q: q.as_slice(), u: u.as_slice(), gaps: &gaps };
        self.found.passed(&sample);
        self.keeper.sample(&sample)
    }
}

impl Motion<'_> {
    /// An event, as it is kept, with the contact that it ends.
    fn told(&self, event: &Event, ended: Option<Contact>) -> Option<StopEvent> {
        let ((time, stop), rate) = (event.at()?, self.machine.rate());
        let Some(contact) = self.simulator.contacts().all().get(stop) else {
            let before = self.found.stops.len() + self.found.friction.len();
            let Some(kink) = stop.checked_sub(before) else {
                return Some(StopEvent::new(event.word(), time, stop));
            };
            let place = self.places[kink];
            let word = match (place < self.found.kinks.len(), self.run.is_below(kink)) {
                (true, _) => event.word(),
                (false, true) => DOWN,
                (false, false) => UP,
            };
            return Some(StopEvent::new(word, time, before + place));
        };
        // The gap is 0 there: position = along · q.
        let [position, speed, _] = contact.position.at(time.phase);
        let place = self.along[stop].map(|along| [position / along, speed * rate / along]);
        let known = StopEvent { place, ..StopEvent::new(event.word(), time, stop) };
        Some(match event {
            Event::Impact(impact) => StopEvent {
                velocity: Some(impact.velocity * rate),
                leaving: (impact.shock.together == 1)
                    .then(|| -contact.restitution_at(-impact.velocity) * impact.velocity * rate),
                // Masses per radian² times velocities per radian, over Ω, are masses times velocities.
                impulse: Some(impact.shock.impulse / rate),
                energy: Some(impact.shock.energy),
                radius: Some(impact.radius / rate),
                together: Some(impact.shock.together),
                order_matters: Some(impact.shock.order_matters),
                ..known
            },
            Event::Touch(touch) => StopEvent {
                velocity: Some(touch.velocity * rate),
                radius: Some(touch.radius / rate),
                ..known
            },
            Event::Tangency(tangency) => StopEvent { gap: Some(tangency.gap), ..known },
            Event::Stick(stick) => StopEvent { rest: Some(stick.rest / rate), ..known },
            Event::Release(_) if contact.soft.is_some() => {
                let Contact { duration, peak, impulse, energy } = ended.unwrap_or_default();
                StopEvent {
                    duration: Some(duration / rate),
                    force: Some(peak),
                    impulse: Some(impulse / rate),
                    energy: Some(energy),
                    ..known
                }
            }
            Event::Release(_) | Event::Reversal(_) | Event::Kink(_) => known,
            Event::End(_) => return None,
        })
    }
}

/// What is known of the measured force of a scene that has one, and of how far it may move the first impact
/// of a motion that begins at `phase`.
fn measured(
    job: &Job,
    machine: &Machine<f64>,
    simulator: &Simulator,
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
fn felt(simulator: &Simulator, direction: &[f64], machine: &Machine<f64>, stop: usize, time: f64) -> f64 {
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
