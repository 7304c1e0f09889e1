//! Motions of an oscillator that rest on a stop.

use crate::{
    attractor::rest::{RestEvent, Resting},
    error::Result,
    motion::{Contact, Event, RunEnd, State, Time},
    one::simulate::Simulator,
};

/// An oscillator with its stops.
pub(super) struct RestingOscillator {
    simulator: Simulator,
    stops: Vec<Contact>,
}

impl RestingOscillator {
    /// With these stops of it, in the scene's order.
    pub fn new(simulator: Simulator, stops: Vec<Contact>) -> RestingOscillator {
        RestingOscillator { simulator, stops }
    }

    /// What rests on a stop.
    fn state(&self, stop: usize, t: f64) -> State {
        let [q, u, _] = self.stops[stop].position.at(t);
        State { t, q, u }
    }
}

impl Resting for RestingOscillator {
    fn stops(&self) -> usize {
        self.stops.len()
    }

    fn bend(&self, stop: usize, phase: f64) -> Result<f64> {
        Ok(self.stops[stop].acceleration(self.simulator.flow(), self.state(stop, phase)))
    }

    fn follow(
        &self,
        stop: usize,
        from: Time,
        until: Time,
        each: &mut dyn FnMut(RestEvent) -> bool,
    ) -> Result<RunEnd> {
        let State { q, u, .. } = self.state(stop, from.phase);
        let mut run = self.simulator.start(from, q, u)?;
        let place = |side| self.stops.iter().position(|stop| stop.side == side).unwrap_or_default();
        loop {
            let event = match run.next(until) {
                Event::Impact(impact) => RestEvent::Impact(impact.time, impact.velocity.abs()),
                Event::Tangency(tangency) => RestEvent::Tangency(tangency.time),
                Event::Stick(stick) => RestEvent::Rest(stick.time, place(stick.place)),
                Event::Release(release) => RestEvent::Release(release.time, place(release.place)),
                Event::Touch(_) | Event::Reversal(_) => continue,
                Event::End(end) => return Ok(end),
            };
            if !each(event) {
                return Ok(RunEnd::Reached);
            }
        }
    }
}
