//! The walls of a run: where a start lies, how hard a wall presses on what rests on it, when it lets go.

use std::f64::consts::TAU;

use super::{
    pieces::{LOWER, UPPER},
    rise::first_rise,
};
use crate::{
    error::{Error, Result},
    oscillator::{
        Contact, Series, Side,
        flow::{Equation, State},
    },
};

#[derive(Debug, Clone)]
pub(super) struct Walls {
    pub contacts: [Option<Contact>; 2],
    forces: [Option<Force>; 2],
}

/// z″ of what rests on a wall, as a function of time: `linear` − ±cubic Q³.
#[derive(Debug, Clone)]
struct Force {
    linear: Series,
    /// ±cubic.
    cubic: f64,
    position: Series,
    /// Bounds its modulus.
    strongest: f64,
    /// Bounds its second derivative.
    bend: f64,
}

impl Walls {
    /// # Errors
    /// Walls that come within `2 depth` of each other, or cross.
    pub fn new(equation: &Equation, contacts: [Option<Contact>; 2], depth: f64) -> Result<Self> {
        if let [Some(lower), Some(upper)] = &contacts {
            let gap = Series::combination(&[(1.0, &upper.position), (-1.0, &lower.position)]);
            let overlap = |t: f64| [2.0 * depth - gap.at(t)[0], -gap.at(t)[1]];
            if let Some(t) = first_rise(&overlap, gap.derivative_bound(2), 0.0, TAU) {
                return Err(Error::input(format!(
                    "the walls meet at phase {t:.6}: their distance there is {:e}, it must stay above {:e}",
                    gap.at(t)[0],
                    2.0 * depth
                )));
            }
        }
        let forces =
            contacts.each_ref().map(|contact| contact.as_ref().map(|contact| Force::new(equation, contact)));
        Ok(Walls { contacts, forces })
    }

    fn contact(&self, wall: usize) -> &Contact {
        self.contacts[wall].as_ref().expect("only walls that are there are met")
    }

    fn forces(&self, wall: usize) -> &Force {
        self.forces[wall].as_ref().expect("only walls that are there are met")
    }

    pub fn side(&self, wall: usize) -> Side {
        if wall == LOWER { Side::Lower } else { Side::Upper }
    }

    pub fn restitution(&self, wall: usize) -> f64 {
        self.contact(wall).restitution
    }

    /// The wall a start lies on within `depth`, and z′ there.
    ///
    /// # Errors
    /// A start that is not finite or lies behind a wall by more than `depth`.
    pub fn contact_at(&self, at: State, depth: f64) -> Result<Option<(usize, f64)>> {
        if !(at.q.is_finite() && at.u.is_finite() && at.t.is_finite()) {
            return Err(Error::input(format!(
                "the start q = {}, u = {}, t = {} is not finite",
                at.q, at.u, at.t
            )));
        }
        let mut touched = None;
        for wall in [LOWER, UPPER] {
            let Some(contact) = &self.contacts[wall] else { continue };
            let [z, velocity] = contact.gap(at);
            if z < -depth {
                let (q, place) = (at.q, contact.position.at(at.t)[0]);
                let side = contact.side.name();
                return Err(Error::input(format!(
                    "the start q = {q} lies behind the {side} wall, which is at {place} at phase {}",
                    at.t
                )));
            }
            if z <= depth {
                touched = Some((wall, velocity));
            }
        }
        Ok(touched)
    }

    /// The motion of what rests on a wall.
    pub fn on(&self, wall: usize, t: f64) -> State {
        let [q, u, _] = self.contact(wall).position.at(t);
        State { t, q, u }
    }

    /// z″ of what rests on a wall, and its derivative: the wall presses where it is negative.
    pub fn force(&self, wall: usize, t: f64) -> [f64; 2] {
        self.forces(wall).at(t)
    }

    /// A bound on the modulus of the force.
    pub fn strongest(&self, wall: usize) -> f64 {
        self.forces(wall).strongest
    }

    /// How long after phase `t` the wall lets go, if ever: what rests on it is periodic.
    pub fn release(&self, wall: usize, t: f64) -> Option<f64> {
        let force = self.forces(wall);
        first_rise(&|s| force.at(t + s), force.bend, 0.0, TAU)
    }
}

impl Force {
    fn new(equation: &Equation, contact: &Contact) -> Self {
        let (position, sign) = (&contact.position, contact.side.sign());
        let speed = position.derivative();
        let linear = Series::combination(&[
            (sign, &equation.forcing),
            (-sign * equation.damping, &speed),
            (-sign * equation.stiffness, position),
            (-sign, &speed.derivative()),
        ]);
        let cubic = sign * equation.cubic;
        let most = [position.mean().abs() + position.derivative_bound(0), position.derivative_bound(1)];
        let cube = most[0] * (most[0] * position.derivative_bound(2) + 2.0 * most[1] * most[1]);
        Force {
            strongest: linear.mean().abs() + linear.derivative_bound(0) + cubic.abs() * most[0].powi(3),
            bend: linear.derivative_bound(2) + 3.0 * cubic.abs() * cube,
            position: position.clone(),
            linear,
            cubic,
        }
    }

    fn at(&self, t: f64) -> [f64; 2] {
        let [force, slope, _] = self.linear.at(t);
        if self.cubic == 0.0 {
            return [force, slope];
        }
        let [q, u, _] = self.position.at(t);
        [force - self.cubic * q * q * q, slope - 3.0 * self.cubic * q * q * u]
    }
}
