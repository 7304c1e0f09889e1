//! How the coordinates of a machine and its gaps swing, for the task `response`.

use super::Machines;
use crate::{
    attractor::swing::{self, Swing, Swinging},
    error::Result,
    many::{
        Machine, State,
        section::Start,
        simulate::{Event, Run, Simulator},
    },
    motion::{RunEnd, Time},
};

/// How coordinates and gaps go at a value of a parameter in the motion from a start: for so many periods,
/// with the harmonic k.
///
/// # Errors
/// Those of the machine and of the simulator.
pub(super) fn swings(
    engine: &Machines,
    states: &[State],
    change: (&str, f64),
    start: &Start,
    [periods, k]: [u32; 2],
) -> Result<Option<Vec<Swing>>> {
    let job = engine.job;
    let machine = job.scene.machine(&[change])?;
    let simulator = job.machine_simulator(&machine, states)?;
    let u: Vec<f64> = start.u.iter().map(|u| u / simulator.rate()).collect();
    let begin = || {
        let run = simulator.start(Time::new(0, start.t), &start.q, &u)?;
        Ok(Motion { run, machine: &machine, simulator: &simulator })
    };
    swing::swings(begin, (periods, k, swing::panels(fastest(&simulator), periods)))
}

/// No linear motion of the machine is faster, in contact with compliant stops or not.
fn fastest(simulator: &Simulator) -> f64 {
    let contacts = simulator.contacts();
    let pushed = contacts.all().iter().enumerate().filter_map(|(i, stop)| {
        let soft = stop.soft?;
        Some((soft.stiffness * contacts.mobility(i)).sqrt() + soft.damping * contacts.mobility(i))
    });
    let own = simulator.flow().rates().into_iter().fold(0.0, f64::max);
    let places = contacts.all().iter().map(|stop| stop.position.order());
    let order = places.fold(simulator.equations().force.order(), u32::max);
    (own + pushed.sum::<f64>()).max(f64::from(order))
}

struct Motion<'a> {
    run: Run<'a>,
    machine: &'a Machine<f64>,
    simulator: &'a Simulator,
}

impl Swinging for Motion<'_> {
    fn time(&self) -> Time {
        self.run.time()
    }

    fn go(&mut self, until: Time) -> Result<Option<RunEnd>> {
        match self.run.next(until) {
            Event::End(end) => self.run.failure().map_or(Ok(Some(end)), Err),
            _ => Ok(None),
        }
    }

    fn places(&self) -> Vec<[f64; 2]> {
        let state = State { t: self.run.time().phase, ..self.run.state() };
        let (q, u) = (self.machine.seen(&state.q), self.machine.seen(&state.u));
        let coordinates = q.iter().zip(u.iter()).map(|(q, u)| [*q, *u]);
        let gaps = self.simulator.contacts().all().iter().map(|stop| stop.gap(&state));
        coordinates.chain(gaps).collect()
    }
}
