//! One motion of an oscillator, followed for the task `simulate`.

use std::f64::consts::TAU;

use super::{
    super::super::{
        Keeper, SeriesOf, SeriesPoint, SeriesStop, SimulationFindings, StopEvent,
        follow::{SampledMotion, follow},
    },
    Oscillators,
};
use crate::{
    attractor::dynamics::Dynamics,
    error::Result,
    motion::{Contact, Event, Flow, RunEnd, Time},
    one::simulate::{self, Run},
    scene::simulate::SimulateTask,
};

/// The motion with what was found of it so far.
struct Motion<'a> {
    run: Run<'a>,
    /// In the scene's order.
    stops: Vec<Contact>,
    mass: f64,
    /// Radians in the scene's unit of time.
    rate: f64,
    found: SimulationFindings,
    keeper: &'a mut dyn Keeper,
}

/// Follows the motion of a task.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub(super) fn simulate(
    task: &SimulateTask,
    engine: &Oscillators,
    keeper: &mut dyn Keeper,
) -> Result<SimulationFindings> {
    let (job, simulator) = (engine.job, engine.job.simulator()?);
    let (start, rate) = (job.scene.state(&task.start)?, simulator.rate());
    let sides = job.scene.stops.iter().filter_map(|stop| Some((stop, stop.side?)));
    let known = |side| simulator.contact(side).cloned();
    let (named, stops): (Vec<SeriesStop>, Vec<Contact>) = sides
        .filter_map(|(stop, side)| {
            Some((SeriesStop { name: stop.name.clone(), along: Some(side.sign()) }, known(side)?))
        })
        .unzip();
    let span = job.scene.span(task)?;
    let begin = Time::new(task.transient as i64, start.t).periods();
    let of = SeriesOf {
        points: 1,
        stops: named,
        friction: vec![],
        kinks: vec![],
        events: vec![],
        period: TAU / rate,
        begin,
        span,
    };
    keeper.begin(&of)?;
    job.monitor.begin(task.transient + span.ceil() as u64, "periods");
    let run = simulator.begin(&start)?;
    let depth = simulator.settings().minimum_depth;
    let method = if job.is_linear() { "closed form" } else { "Taylor series" };
    let found = SimulationFindings::new(span, (&of, &vec![false; of.stops.len()]), method, depth);
    let mut motion = Motion { run, stops, mass: job.scene.mass()?, rate, found, keeper };
    let end = follow((task, span), start.t, &mut motion, job.monitor)?;
    let Motion { run, mut found, .. } = motion;
    let state = run.state();
    let bend = simulator.flow().acceleration(state);
    found.ended((end, run.time()), [vec![state.q], vec![state.u * rate], vec![bend * rate * rate]]);
    Ok(found)
}

impl SampledMotion for Motion<'_> {
    const CHUNK: u64 = 256;

    fn pass(&mut self, until: Time) -> RunEnd {
        self.run.finish(until)
    }

    fn record(&mut self, until: Time) -> Result<RunEnd> {
        let Motion { run, stops, mass, rate, found, keeper } = self;
        let mut failed = None;
        let end = run.record(until, |event| {
            let Some(event) = told(&event, stops, *mass, *rate) else { return };
            if found.happened(&event) && failed.is_none() {
                failed = keeper.event(&event).err();
            }
        });
        failed.map_or(Ok(end), Err)
    }

    fn sample(&mut self, time: Time) -> Result<()> {
        let state = self.run.state();
        let mut gaps = [[0.0; 2]; 2];
        for (gap, stop) in gaps.iter_mut().zip(&self.stops) {
            let ([place, speed, _], sign) = (stop.position.at(time.phase), stop.side.sign());
            *gap = [sign * (state.q - place), sign * (state.u - speed) * self.rate];
        }
        let sample =
            SeriesPoint { time, q: &[state.q], u: &[state.u * self.rate], gaps: &gaps[..self.stops.len()] };
        self.found.passed(&sample);
        self.keeper.sample(&sample)
    }
}

/// An event, as it is kept.
fn told(event: &simulate::Event, stops: &[Contact], mass: f64, rate: f64) -> Option<StopEvent> {
    let (time, side) = event.at()?;
    let place = stops.iter().position(|stop| stop.side == side)?;
    let [at, speed, _] = stops[place].position.at(time.phase);
    let known = StopEvent { place: Some([at, speed * rate]), ..StopEvent::new(event.word(), time, place) };
    Some(match event {
        Event::Impact(impact) => {
            let velocity = impact.velocity * rate;
            let leaving = -stops[place].restitution * velocity;
            StopEvent {
                velocity: Some(velocity),
                leaving: Some(leaving),
                impulse: Some(mass * (leaving - velocity)),
                energy: Some(0.5 * mass * (leaving - velocity) * -(leaving + velocity)),
                radius: Some(impact.radius / rate),
                together: Some(1),
                order_matters: Some(false),
                ..known
            }
        }
        Event::Tangency(tangency) => StopEvent { gap: Some(tangency.gap), ..known },
        Event::Stick(stick) => StopEvent { rest: Some(stick.rest / rate), ..known },
        Event::Release(_) | Event::Touch(_) | Event::Reversal(_) | Event::Kink(_) | Event::End(_) => known,
    })
}
