//! How the displacement of an oscillator and its gaps swing, for the task `response`.

use super::Oscillators;
use crate::{
    attractor::{
        dynamics::Dynamics,
        swing::{self, Swing, Swinging},
    },
    error::Result,
    motion::{Contact, RunEnd, State, Time},
    one::simulate::{Event, Run},
};

/// How displacement and gaps go at a value of a parameter in the motion from a start: for so many periods,
/// with the harmonic k.
///
/// # Errors
/// Those of the system and of the simulator.
pub(super) fn swings(
    engine: &Oscillators,
    change: (&str, f64),
    start: &State,
    [periods, k]: [u32; 2],
) -> Result<Option<Vec<Swing>>> {
    let job = engine.job;
    let simulator = job.simulator_of(&job.scene.plain(&[change])?)?;
    let stops: Vec<Contact> = simulator.contacts().cloned().collect();
    let begin = || Ok(Motion { run: simulator.begin(start)?, stops: &stops });
    let equation = simulator.flow().equation();
    let order = stops.iter().map(|stop| stop.position.order()).fold(equation.forcing.order(), u32::max);
    // The largest modulus of an eigenvalue is at most this.
    let own = equation.damping.abs() + equation.stiffness.abs().sqrt();
    swing::swings(begin, (periods, k, swing::panels(own.max(f64::from(order)), periods)))
}

struct Motion<'a> {
    run: Run<'a>,
    stops: &'a [Contact],
}

impl Swinging for Motion<'_> {
    fn time(&self) -> Time {
        self.run.time()
    }

    fn go(&mut self, until: Time) -> Result<Option<RunEnd>> {
        Ok(match self.run.next(until) {
            Event::End(end) => Some(end),
            _ => None,
        })
    }

    fn places(&self) -> Vec<[f64; 2]> {
        let state = State { t: self.run.time().phase, ..self.run.state() };
        let gaps = self.stops.iter().map(|stop| stop.gap(state));
        std::iter::once([state.q, state.u]).chain(gaps).collect()
    }
}
