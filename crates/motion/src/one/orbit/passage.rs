//! Once round an orbit, passage by passage: touch a wall, leave it, fly, touch the next, and what that impact
//! does to a displacement.

use std::f64::consts::TAU;

use super::{Itinerary, Leg, OrbitImpact, Oscillator, Touch};
use crate::{
    error::{Error, Result},
    motion::{
        Flow, State,
        algebra::{Matrix2, apply},
    },
};

/// The unknowns z = (t₁, V₁, …, t_m, V_m) of a pattern with impacts; (q, u) at t = 0 without.
#[derive(Debug, Clone, Copy)]
pub struct Unknowns<'a> {
    itinerary: &'a Itinerary,
    z: &'a [f64],
}

/// From one impact of an orbit to the next.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passage<'o> {
    /// The impact that it leaves from, counted from 0.
    pub index: usize,
    /// The impact that it arrives at.
    pub next: usize,
    /// The wall that it leaves.
    pub here: Touch<'o>,
    /// The state just after the impact.
    pub from: State,
    /// V of the impact that it leaves from.
    pub speed: f64,
    /// How long it lasts.
    pub duration: f64,
    /// The wall that it arrives at.
    pub there: Touch<'o>,
    /// The impact that it arrives at, its phase as among the unknowns.
    pub arrival: OrbitImpact,
    oscillator: &'o Oscillator,
}

/// The two equations of a passage: that it arrives at the wall, and with the next impact's speed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arrival {
    /// σ (q − Q(t′)) and σ (u − Q′(t′)) + V′.
    pub residual: [f64; 2],
    /// Their derivatives by (t, V) of the impact that it leaves from, by rows.
    pub departure: Matrix2,
    /// Their derivatives by (t′, V′) of the impact that it arrives at, by rows.
    pub arrival: Matrix2,
    /// Their derivatives by the parameter.
    pub slope: [f64; 2],
}

impl<'a> Unknowns<'a> {
    /// The unknowns of a pattern.
    ///
    /// # Errors
    /// An input error if there are too many or too few.
    pub fn new(itinerary: &'a Itinerary, z: &'a [f64]) -> Result<Unknowns<'a>> {
        if z.len() != Self::count(itinerary) {
            return Err(Error::input(format!("{} unknowns for the pattern {itinerary}", z.len())));
        }
        Ok(Unknowns { itinerary, z })
    }

    /// How many unknowns a pattern has.
    pub(crate) fn count(itinerary: &Itinerary) -> usize {
        (2 * itinerary.strikes().len()).max(2)
    }

    /// Whether an unknown is an impact time.
    pub(crate) fn is_time(itinerary: &Itinerary, unknown: usize) -> bool {
        unknown.is_multiple_of(2) && !itinerary.strikes().is_empty()
    }

    /// What an unknown of 1 is where lengths and speeds are measured by `unit`: times are in radians.
    pub(crate) fn unit(itinerary: &Itinerary, unknown: usize, unit: f64) -> f64 {
        if Unknowns::is_time(itinerary, unknown) { 1.0 } else { unit }
    }

    /// t_{i+1}, i from 0.
    pub fn phase(&self, i: usize) -> f64 {
        self.z[2 * i]
    }

    /// V_{i+1}, i from 0: positive if the impact comes in.
    pub fn speed(&self, i: usize) -> f64 {
        self.z[2 * i + 1]
    }

    /// All speeds; none without impacts.
    pub(crate) fn speeds(&self) -> impl Iterator<Item = f64> + use<'a> {
        self.z.iter().skip(1).step_by(2).take(self.itinerary.strikes().len()).copied()
    }

    /// How long the motion from impact i to the next lasts.
    pub fn duration(&self, i: usize) -> f64 {
        let next = (i + 1) % self.itinerary.strikes().len();
        TAU * f64::from(self.itinerary.strikes()[i].periods) + self.phase(next) - self.phase(i)
    }

    /// The passages in order, from the first impact to itself; none without impacts. Each is an input error
    /// if a wall is missing.
    pub(crate) fn passages<'o>(
        &self,
        oscillator: &'o Oscillator,
    ) -> impl Iterator<Item = Result<Passage<'o>>> + use<'a, 'o> {
        let (unknowns, m) = (*self, self.itinerary.strikes().len());
        (0..m).map(move |index| {
            let next = (index + 1) % m;
            let [strike, target] = [index, next].map(|i| unknowns.itinerary.strikes()[i]);
            let (t, speed) = (unknowns.phase(index), unknowns.speed(index));
            let here = oscillator.touch(strike.place, t)?;
            // A single impact follows itself.
            let there =
                if next == index { here } else { oscillator.touch(target.place, unknowns.phase(next))? };
            let from = here.leaving(t, here.wall.restitution * speed);
            let arrival =
                OrbitImpact { side: target.place, phase: unknowns.phase(next), speed: unknowns.speed(next) };
            let duration = unknowns.duration(index);
            Ok(Passage { index, next, here, from, speed, duration, there, arrival, oscillator })
        })
    }
}

impl Passage<'_> {
    /// The flight with its derivatives in the state it starts from and in the parameter.
    pub fn fly(&self) -> Leg {
        self.oscillator.leg(self.from, self.duration)
    }

    /// The flight's derivatives in the state it starts from only.
    pub fn matrix(&self) -> Matrix2 {
        self.oscillator.flow().advance_linearised(self.from, self.duration).1
    }

    /// Its two equations with their derivatives.
    pub fn equations(&self) -> Arrival {
        let (here, there) = (&self.here, &self.there);
        let Leg { end, matrix, slope } = self.fly();
        let (left, sign) = (here.wall.side.sign(), there.wall.side.sign());
        let (acceleration, tau) = (|at| self.oscillator.flow().acceleration(at), here.wall.restitution);
        // Starting later is starting displaced: by what the wall and the orbit move in between, reversed.
        let delayed = [here.motion[1] - self.from.u, here.motion[2] - acceleration(self.from)];
        let kicked = [0.0, left * tau];
        let changed = [here.slope[0], here.slope[1] + left * here.restitution_slope * self.speed];
        let [delayed, kicked, changed] = [delayed, kicked, changed].map(|x| apply(&matrix, x));
        let late = [end.u - there.motion[1], acceleration(end) - there.motion[2]];
        let gap = [end.q - there.motion[0], late[0]];
        Arrival {
            residual: [sign * gap[0], sign * gap[1] + self.arrival.speed],
            departure: [0, 1].map(|row| [sign * delayed[row], sign * kicked[row]]),
            arrival: [[sign * late[0], 0.0], [sign * late[1], 1.0]],
            slope: [0, 1].map(|row| sign * (changed[row] + slope[row] - there.slope[row])),
        }
    }

    /// What the impact at its end does to a displacement, and what the parameter adds; its speed must not
    /// be 0.
    pub fn saltation(&self) -> (Matrix2, [f64; 2]) {
        self.oscillator.saltation(&self.there, self.arrival.phase, self.arrival.speed)
    }
}
