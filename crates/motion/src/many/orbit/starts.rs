//! The search for orbits without impacts of machines whose stops give way, whose forces are formulas, or that
//! have dry friction: from the motion that the forces bring about, and from deflections of it.

use std::f64::consts::TAU;

use super::{Itinerary, Orbit, between, find_beside};
use crate::{
    error::Result,
    many::{State, deflected::Deflections, simulate::Simulator},
};

/// Motions to start from.
pub struct FreeStarts<'s> {
    simulator: &'s Simulator,
    /// The same with its rigid stops passed through.
    soft: Option<Simulator>,
    pattern: &'s Itinerary,
    deflections: Deflections<'s>,
}

/// Periods after which Newton's method is tried again where it fails from the motion of the forces.
const LATER: [u32; 3] = [8, 16, 32];

impl<'s> FreeStarts<'s> {
    /// With deflections' speeds up to `greatest`, per radian of the forcing.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub fn new(simulator: &'s Simulator, pattern: &'s Itinerary, greatest: f64) -> Result<Self> {
        let deflections = Deflections::new(simulator, greatest);
        Ok(FreeStarts { simulator, soft: simulator.through()?, pattern, deflections })
    }

    /// The orbit that Newton's method finds from the i-th start, those that are known taken out.
    ///
    /// # Errors
    /// As [`find_beside`].
    pub fn find(&self, i: u32, known: &[Orbit]) -> Result<Orbit> {
        if i == 0 {
            return self.of_the_forces(known);
        }
        let state = self.deflections.deflected(i);
        let state = self.after(&state, TAU - state.t)?;
        let found = self.from(&state, known);
        if found.is_ok() || !self.simulator.is_rough() {
            return found;
        }
        // The equations have corners where friction changes otherwise: nearer to the motion it leads to.
        self.from(&self.after(&state, TAU * f64::from(LATER[1]))?, known)
    }

    /// From the motion of the forces or, where Newton's method finds nothing there, from where that leads.
    fn of_the_forces(&self, known: &[Orbit]) -> Result<Orbit> {
        let mut state = self.deflections.forced(0.0);
        let mut found = self.from(&state, known);
        for periods in LATER {
            if found.is_ok() {
                break;
            }
            let Ok(later) = self.after(&state, TAU * f64::from(periods)) else { break };
            state = later;
            found = self.from(&state, known);
        }
        // Where nothing periodic is brought about, from rest.
        found.or_else(|_| find_beside(self.simulator, self.pattern, &[], None, known))
    }

    /// Whether a period takes too long to follow from the motion of the forces.
    pub fn is_hopeless(&self) -> bool {
        self.after(&self.deflections.forced(0.0), TAU).is_err_and(|error| error.is_limit())
    }

    /// The states of an orbit a period later, two, … until it begins anew; those that can be followed.
    pub fn later(&self, orbit: &Orbit) -> Vec<State> {
        let unmoved = |state| between(self.simulator, self.soft.as_ref()).unmoved(state);
        let next = |state: &State| self.after(state, TAU).ok().map(unmoved);
        let count = orbit.itinerary.periods() as usize - 1;
        std::iter::successors(next(&orbit.state).filter(|_| count > 0), next).take(count).collect()
    }

    fn after(&self, state: &State, duration: f64) -> Result<State> {
        between(self.simulator, self.soft.as_ref()).after(state, duration)
    }

    fn from(&self, state: &State, known: &[Orbit]) -> Result<Orbit> {
        find_beside(self.simulator, self.pattern, &[], Some(state), known)
    }
}
