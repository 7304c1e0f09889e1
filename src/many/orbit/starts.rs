//! Where a search begins for orbits without impacts of machines whose stops give way, whose forces are
//! formulas, or that have dry friction: the same motions in every form of a question.
//!
//! First the motion that the forces bring about where no stop is in the way (of forces that are formulas, the
//! machine linearised at rest): it is the same from whichever phase time is counted. Then what a deflection
//! makes of it, at a phase that is the forcing's own, in directions that go with the machine and not with its
//! coordinates: what a push at the nearest stop moves, what the springs make of that, and so on, each
//! orthogonal to those before by the masses.

use std::f64::consts::TAU;

use super::{Itinerary, Orbit, between, find, find_from};
use crate::{
    continuation::Starts,
    error::Result,
    many::{RealVector, State, simulate::Simulator},
};

/// Motions to start from.
pub(crate) struct FreeStarts<'s> {
    simulator: &'s Simulator,
    /// The same with its rigid stops passed through.
    soft: Option<Simulator>,
    pattern: &'s Itinerary,
    starts: Starts,
    directions: Vec<RealVector>,
}

/// Most displacements of starts from the motion that the forces bring about, in sizes of the gaps' motion.
const DEFLECTED: f64 = 2.0;

/// Periods after which Newton's method is tried again where it fails from the motion of the forces.
const LATER: [u32; 3] = [8, 16, 32];

/// Less than this part of a direction is left of it by rounding.
const ROUNDING: f64 = 1e-9;

impl<'s> FreeStarts<'s> {
    /// With deflections' speeds up to `greatest`, per radian of the forcing.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub fn new(simulator: &'s Simulator, pattern: &'s Itinerary, greatest: f64) -> Result<Self> {
        let nearest = simulator.nearest_stop();
        let starts = Starts::new(greatest, |t| nearest.map_or(0.0, |stop| simulator.on_stop(stop, t)));
        let directions = directions(simulator, nearest);
        Ok(FreeStarts { simulator, soft: simulator.through()?, pattern, starts, directions })
    }

    /// The orbit that Newton's method finds from the i-th start.
    ///
    /// # Errors
    /// As [`find_from`].
    pub fn find(&self, i: u32) -> Result<Orbit> {
        if i == 0 {
            return self.of_the_forces();
        }
        let (count, greatest) = (2 * self.directions.len() + 1, self.starts.speed());
        let part = |j: usize| 2.0 * Starts::part(i, j, count) - 1.0;
        let t = self.starts.phase(Starts::part(i, 0, count));
        let mut state = self.forced(t);
        for (j, direction) in self.directions.iter().enumerate() {
            let most = DEFLECTED * self.simulator.size();
            state.q.axpy(most * part(2 * j + 1), direction, 1.0);
            state.u.axpy(greatest * part(2 * j + 2), direction, 1.0);
        }
        let state = self.after(&state, TAU - t)?;
        let found = self.from(&state);
        if found.is_ok() || !self.simulator.is_rough() {
            return found;
        }
        // The equations have corners where friction changes otherwise: nearer to the motion it leads to.
        self.from(&self.after(&state, TAU * f64::from(LATER[1]))?)
    }

    /// From the motion of the forces or, where Newton's method finds nothing there, from where that leads.
    fn of_the_forces(&self) -> Result<Orbit> {
        let mut state = self.forced(0.0);
        let mut found = self.from(&state);
        for periods in LATER {
            if found.is_ok() {
                break;
            }
            let Ok(later) = self.after(&state, TAU * f64::from(periods)) else { break };
            state = later;
            found = self.from(&state);
        }
        // Where nothing periodic is brought about, from rest.
        found.or_else(|_| find(self.simulator, self.pattern, &[]))
    }

    /// The motion that the forces alone bring about, at a phase.
    fn forced(&self, t: f64) -> State {
        let (n, flow) = (self.simulator.equations().size(), self.simulator.flow());
        let all = flow.outward(&flow.particular(t));
        State { t, q: all.rows(0, n).into_owned(), u: all.rows(n, n).into_owned() }
    }

    fn after(&self, state: &State, duration: f64) -> Result<State> {
        between(self.simulator, self.soft.as_ref()).after(state, duration)
    }

    fn from(&self, state: &State) -> Result<Orbit> {
        find_from(self.simulator, self.pattern, &[], Some(state))
    }
}

/// Directions that a push at a stop brings about, each with the kinetic energy of the one that moves the gap
/// by 1; of a machine without stops, its coordinates.
fn directions(simulator: &Simulator, stop: Option<usize>) -> Vec<RealVector> {
    let (equations, n) = (simulator.equations(), simulator.equations().size());
    let Some(stop) = stop else {
        return (0..n).map(|i| RealVector::from_fn(n, |j, _| f64::from(u8::from(i == j)))).collect();
    };
    let product = |a: &RealVector, b: &RealVector| a.dot(&(&equations.mass * b));
    let size = simulator.contacts().mobility(stop).sqrt().recip();
    let mut all: Vec<RealVector> = Vec::new();
    let mut next = simulator.contacts().push(stop).clone();
    while all.len() < n {
        let whole = product(&next, &next).sqrt();
        for known in &all {
            let part = product(known, &next) / product(known, known);
            next.axpy(-part, known, 1.0);
        }
        let left = product(&next, &next).sqrt();
        if left <= ROUNDING * whole || left.is_nan() {
            break;
        }
        let direction = &next * (size / left);
        next = equations.accelerate(&(&equations.stiffness * &direction));
        all.push(direction);
    }
    all
}
