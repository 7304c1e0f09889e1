//! Motions of a machine to start a search from, the same in every form of a question.
//!
//! First the motion that the forces bring about where no stop is in the way (of forces that are formulas, the
//! machine linearised at rest): it is the same from whichever phase time is counted. Then deflections of it,
//! at a phase that is the forcing's own, in directions that go with the machine and not with its coordinates:
//! what a push at the nearest stop moves, what the springs make of that, and so on, each orthogonal to those
//! before by the masses.

use crate::{
    continuation::Starts,
    many::{RealVector, State, simulate::Simulator},
    rounding::DIRECTION,
};

/// Deflections of the motion that the forces bring about.
pub(crate) struct Deflections<'s> {
    simulator: &'s Simulator,
    starts: Starts,
    directions: Vec<RealVector>,
}

/// Most displacements of starts from the motion that the forces bring about, in sizes of the gaps' motion.
const DEFLECTED: f64 = 2.0;

impl<'s> Deflections<'s> {
    /// With speeds up to `greatest`, per radian of the forcing.
    pub fn new(simulator: &'s Simulator, greatest: f64) -> Deflections<'s> {
        let nearest = simulator.nearest_stop();
        let starts = Starts::new(greatest, |t| nearest.map_or(0.0, |stop| simulator.on_stop(stop, t)));
        Deflections { simulator, starts, directions: directions(simulator, nearest) }
    }

    /// The motion that the forces alone bring about, at a phase.
    pub fn forced(&self, t: f64) -> State {
        let (n, flow) = (self.simulator.equations().size(), self.simulator.flow());
        let all = flow.outward(&flow.particular(t));
        State { t, q: all.rows(0, n).into_owned(), u: all.rows(n, n).into_owned() }
    }

    /// The i-th deflection of it, from 1 on.
    pub fn deflected(&self, i: u32) -> State {
        let (count, greatest) = (2 * self.directions.len() + 1, self.starts.speed());
        let part = |j: usize| 2.0 * Starts::part(i, j, count) - 1.0;
        let mut state = self.forced(self.starts.phase(Starts::part(i, 0, count)));
        for (j, direction) in self.directions.iter().enumerate() {
            let most = DEFLECTED * self.simulator.size();
            state.q.axpy(most * part(2 * j + 1), direction, 1.0);
            state.u.axpy(greatest * part(2 * j + 2), direction, 1.0);
        }
        state
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
        if left <= DIRECTION * whole || left.is_nan() {
            break;
        }
        let direction = &next * (size / left);
        next = equations.accelerate(&(&equations.stiffness * &direction));
        all.push(direction);
    }
    all
}
