//! One wall in f64: the gap to it, how fast it closes, and the impact law (67) with its derivative.

use super::{Flow, Series, State, System, Wall, series::finite};
use crate::{
    error::{Error, Result},
    motion::algebra::Matrix2,
};

/// Which wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// Q₁, below.
    Lower,
    /// Q₂, above.
    Upper,
}

impl Side {
    /// +1 for the lower wall, −1 for the upper: the gap is `sign` (q − Q).
    pub fn sign(self) -> f64 {
        match self {
            Side::Lower => 1.0,
            Side::Upper => -1.0,
        }
    }

    /// "lower" or "upper", as scenes name it.
    pub fn name(self) -> &'static str {
        match self {
            Side::Lower => "lower",
            Side::Upper => "upper",
        }
    }
}

/// A wall seen from the oscillator: the gap z = ±(q − Q(t)) is positive away from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Below or above.
    pub side: Side,
    /// Q(t).
    pub position: Series,
    /// τ ≥ 0.
    pub restitution: f64,
}

impl Contact {
    /// The wall in normal form.
    ///
    /// # Errors
    /// A coefficient that is not finite, a negative restitution, a harmonic with k = 0.
    pub(crate) fn new(side: Side, wall: &Wall<f64>) -> Result<Self> {
        finite("restitution", wall.restitution)?;
        if wall.restitution < 0.0 {
            return Err(Error::input(format!("restitution = {} is negative", wall.restitution)));
        }
        let position = Series::new(wall.offset, &wall.harmonics)?;
        Ok(Contact { side, position, restitution: wall.restitution + 0.0 })
    }

    /// The walls of a system, lower before upper.
    ///
    /// # Errors
    /// Those of `Contact::new`, led by the side.
    pub fn of(system: &System<f64>) -> Result<Vec<Contact>> {
        [(Side::Lower, &system.lower), (Side::Upper, &system.upper)]
            .into_iter()
            .filter_map(|(side, wall)| Some((side, wall.as_ref()?)))
            .map(|(side, wall)| {
                Contact::new(side, wall).map_err(|e| e.context(format!("{} wall", side.name())))
            })
            .collect()
    }

    /// z = ±(q − Q) and z′ = ±(u − Q′).
    pub fn gap(&self, at: State) -> [f64; 2] {
        let ([place, speed, _], sign) = (self.position.at(at.t), self.side.sign());
        [sign * (at.q - place), sign * (at.u - speed)]
    }

    /// z″: the wall presses where it is negative. At a grazing contact it is a_G.
    pub fn acceleration(&self, flow: &impl Flow, at: State) -> f64 {
        self.side.sign() * (flow.acceleration(at) - self.position.at(at.t)[2])
    }

    /// z, z′ and z″, as [`gap`](Self::gap) and [`acceleration`](Self::acceleration) give them.
    pub(crate) fn motion(&self, flow: &impl Flow, at: State) -> [f64; 3] {
        let ([place, speed, bend], sign) = (self.position.at(at.t), self.side.sign());
        [sign * (at.q - place), sign * (at.u - speed), sign * (flow.acceleration(at) - bend)]
    }

    /// The state after an impact (67): q kept, z′ turned into −τ z′.
    pub fn bounce(&self, at: State) -> State {
        let speed = self.position.at(at.t)[1];
        State { u: speed - self.restitution * (at.u - speed), ..at }
    }

    /// The saltation matrix of an impact that arrives as `at`: ∂(q, u) after, at a fixed time, by (q, u)
    /// before, [[−τ, 0], [(a⁺ + τ a⁻ − (1+τ) Q″) / w, −τ]] with w = u − Q′ ≠ 0 the incoming relative
    /// velocity; determinant τ².
    pub(crate) fn saltation(&self, flow: &impl Flow, at: State) -> Matrix2 {
        let (tau, [_, speed, bend]) = (self.restitution, self.position.at(at.t));
        let (before, after) = (flow.acceleration(at), flow.acceleration(self.bounce(at)));
        [[-tau, 0.0], [(after + tau * before - (1.0 + tau) * bend) / (at.u - speed), -tau]]
    }
}
