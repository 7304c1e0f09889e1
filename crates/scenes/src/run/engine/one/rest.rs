//! Motions of an oscillator that rest on a stop.

use crate::{
    attractor::rest::{RestEvent, Resting, tell},
    error::Result,
    motion::{Contact, RunEnd, State, Time},
    one::simulate::Simulator,
};

/// An oscillator with its stops.
pub(super) struct RestingOscillator {
    simulator: Simulator,
    stops: Vec<Contact>,
    order: u32,
}

impl RestingOscillator {
    /// With these stops of it, in the scene's order; the forcing has harmonics up to `order`.
    pub fn new(simulator: Simulator, stops: Vec<Contact>, order: u32) -> RestingOscillator {
        let order = stops.iter().map(|stop| stop.position.order()).fold(order, u32::max);
        RestingOscillator { simulator, stops, order }
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

    fn on(&self, stop: usize, phase: f64) -> [f64; 2] {
        let [q, u, _] = self.stops[stop].position.at(phase);
        [q, u]
    }

    fn order(&self) -> u32 {
        self.order
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
        let place = |side| self.stops.iter().position(|stop| stop.side == side);
        Ok(tell(|| run.next(until), place, each))
    }
}
