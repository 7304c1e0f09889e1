//! The walls of a run: where a start lies, how hard a wall presses on what rests on it, when it lets go.

use std::{f64::consts::TAU, sync::Arc};

use super::{
    pieces::{LOWER, UPPER},
    rise::first_rise,
};
use crate::{
    error::{Error, Result},
    motion::{
        Contact, Series, Side, State,
        flow::{Equation, Program, Range, Scalar, Smooth},
    },
};

#[derive(Debug, Clone)]
pub(super) struct Walls {
    pub contacts: [Option<Contact>; 2],
    forces: [Option<Force>; 2],
}

/// z″ of what rests on a wall, as a function of time: `linear` − ±cubic Q³, or ±(a − Q″) with any smooth
/// force.
#[derive(Debug, Clone)]
struct Force {
    linear: Series,
    /// ±cubic.
    cubic: f64,
    position: Series,
    smooth: Option<(f64, Arc<Smooth>)>,
    /// Bounds its modulus.
    strongest: f64,
    /// Bounds its second derivative.
    bend: f64,
}

impl Walls {
    /// # Errors
    /// Walls that come within `2 depth` of each other, or cross; a force that is not smooth on a wall.
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
        let force =
            |wall: usize| contacts[wall].as_ref().map(|contact| Force::new(equation, contact)).transpose();
        let forces = [force(LOWER)?, force(UPPER)?];
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
    fn new(equation: &Equation, contact: &Contact) -> Result<Self> {
        if let Some(smooth) = &equation.smooth {
            return Force::smooth(smooth, contact);
        }
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
        Ok(Force {
            strongest: linear.mean().abs() + linear.derivative_bound(0) + cubic.abs() * most[0].powi(3),
            bend: linear.derivative_bound(2) + 3.0 * cubic.abs() * cube,
            position: position.clone(),
            smooth: None,
            linear,
            cubic,
        })
    }

    /// Bounds on cells of the period; they are 0 where nothing moves.
    ///
    /// # Errors
    /// A force that is not smooth on the wall.
    fn smooth(smooth: &Arc<Smooth>, contact: &Contact) -> Result<Self> {
        let program: Program<Range> = smooth.program_in()?;
        let position = &contact.position;
        let still = position.order() == 0 && !smooth.program.is_driven();
        let bounds = |cells: u32| {
            let width = TAU / f64::from(cells);
            let (mut strongest, mut bend) = (0.0f64, 0.0f64);
            for cell in 0..cells {
                let t = (f64::from(cell) + 0.5) * width;
                let radius = if still { 0.0 } else { width / 2.0 };
                let ([q, u, second], third) = (position.at(t), position.derivative().at(t)[2]);
                // The derivative of order n − 1, within the radius.
                let near = |value: f64, n: i32| {
                    let change = radius * position.derivative_bound(n);
                    Range::new(value - change, value + change)
                };
                let (q, u, second, third) = (near(q, 1), near(u, 2), near(second, 3), near(third, 4));
                let path = [q, u, second.scaled(0.5)];
                let speed = [u, second, third.scaled(0.5)];
                let time = Range::new(t - radius, t + radius);
                let all = program.along(&path, &speed, time, 1.0);
                let (here, bent) = ((all[0] - second).size(), 2.0 * all[2].size());
                if !(here.is_finite() && bent.is_finite()) {
                    return Err(t);
                }
                (strongest, bend) = (strongest.max(here), bend.max(bent + position.derivative_bound(4)));
            }
            Ok((strongest, bend))
        };
        let cells = if still { 1 } else { 64 };
        let (strongest, bend) = bounds(cells).or_else(|_| bounds(64 * cells)).map_err(|t| {
            let side = contact.side.name();
            Error::input(format!(
                "the force is not smooth on the {side} wall near q = {}, t = {t:.3}: a pole, or a root or \
                 logarithm of a number that is not positive; move the wall or change the force",
                position.at(t)[0]
            ))
        })?;
        Ok(Force {
            linear: Series::ZERO,
            cubic: 0.0,
            position: position.clone(),
            smooth: Some((contact.side.sign(), smooth.clone())),
            // Rounding within the ranges.
            strongest: strongest * (1.0 + 1e-9),
            bend: bend * (1.0 + 1e-9),
        })
    }

    fn at(&self, t: f64) -> [f64; 2] {
        if let Some((sign, smooth)) = &self.smooth {
            let ([q, u, second], third) = (self.position.at(t), self.position.derivative().at(t)[2]);
            let all = smooth.program.along(&[q, u], &[u, second], t, 1.0);
            return [sign * (all[0] - second), sign * (all[1] - third)];
        }
        let [force, slope, _] = self.linear.at(t);
        if self.cubic == 0.0 {
            return [force, slope];
        }
        let [q, u, _] = self.position.at(t);
        [force - self.cubic * q * q * q, slope - 3.0 * self.cubic * q * q * u]
    }
}
