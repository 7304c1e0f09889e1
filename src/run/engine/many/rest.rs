//! Motions of a machine with one coordinate that rest on a stop.

use crate::{
    attractor::rest::{RestEvent, Resting, tell},
    error::Result,
    many::{RealVector, State, simulate::Simulator},
    motion::{RunEnd, Time},
};

/// A machine with one coordinate.
pub(super) struct RestingMachine(pub Simulator);

impl RestingMachine {
    /// What rests on a stop.
    fn state(&self, stop: usize, t: f64) -> State {
        let contact = &self.0.contacts().all()[stop];
        let ([place, speed, _], along) = (contact.position.at(t), contact.row[0]);
        let of = |x: f64| RealVector::from_element(1, x / along);
        State { t, q: of(place), u: of(speed) }
    }
}

impl Resting for RestingMachine {
    fn stops(&self) -> usize {
        self.0.contacts().all().len()
    }

    /// Nothing rests on a stop that gives way.
    fn bend(&self, stop: usize, phase: f64) -> Result<f64> {
        let contact = &self.0.contacts().all()[stop];
        if contact.soft.is_some() {
            return Ok(f64::INFINITY);
        }
        let acceleration = self.0.acceleration(&self.state(stop, phase))?;
        Ok(contact.row.dot(&acceleration) - contact.position.at(phase)[2])
    }

    fn order(&self) -> u32 {
        let stops = self.0.contacts().all().iter().map(|stop| stop.position.order());
        stops.fold(self.0.equations().force.order(), u32::max)
    }

    fn follow(
        &self,
        stop: usize,
        from: Time,
        until: Time,
        each: &mut dyn FnMut(RestEvent) -> bool,
    ) -> Result<RunEnd> {
        let State { q, u, .. } = self.state(stop, from.phase);
        let mut run = self.0.start(from, q.as_slice(), u.as_slice())?;
        let rigid = |stop: usize| self.0.contacts().all()[stop].soft.is_none().then_some(stop);
        let end = tell(|| run.next(until), rigid, each);
        run.failure().map_or(Ok(end), Err)
    }
}
