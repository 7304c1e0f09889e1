//! A linear oscillator in closed form: the motion between impacts, the walls, and the gaps to them.
//!
//! Between impacts q(t) = h(t) + F I(τ) + E₁₁(τ) a + E₁₂(τ) b with τ the time since the impact, h the
//! response to the forcing's harmonics, E(τ) = exp(τ [[0, 1], [−k, −c]]), I′ = E₁₂ the response to a constant
//! force, and (a, b) the start minus (h, h′).

use num_bigint::BigInt;
use num_rational::BigRational;

use super::{Jet, coefficient::exact};
use crate::{
    error::{Error, Result},
    machine::Bounds,
    motion::{Harmonic, Side, System, Wall},
    number::{Ball, Elementary, Precision, Real, Sign},
};

/// The free motion's kind, by the sign of ω² = k − c²/4.
enum Free {
    /// cos ωτ and sin ωτ.
    Oscillating(Jet),
    /// cosh ωτ and sinh ωτ, ω² = c²/4 − k.
    Overdamped(Jet),
    /// 1 and τ.
    Critical,
}

/// A linear system with enclosed coefficients.
pub(super) struct Linear<'a> {
    system: System<Jet>,
    free: Free,
    /// h: the periodic response to the forcing.
    response: Vec<Harmonic<Jet>>,
    pub precision: &'a Precision,
}

/// A motion that left a wall: when, and (a, b).
pub(super) struct Flight {
    phase: Jet,
    start: [Jet; 2],
}

/// A function of time with its first two derivatives.
pub(super) type Motion = [Jet; 3];

impl<'a> Linear<'a> {
    /// A system whose coefficients are exact, or each any between two numbers.
    pub fn of(system: &System<Bounds>, precision: &'a Precision) -> Result<Self> {
        let Some(system) = exact(system) else {
            let between = |[lo, hi]: &Bounds| Ok::<_, Error>(Jet::constant(Ball::between(lo, hi, precision)));
            return Linear::enclosed(system.try_map(between)?, precision);
        };
        Linear::exact(&system, precision)
    }

    /// A system with exact coefficients.
    fn exact(system: &System<BigRational>, precision: &'a Precision) -> Result<Self> {
        let discriminant = &system.stiffness - &system.damping * &system.damping / BigInt::from(4);
        let enclosed = system.try_map(|value| Ok::<_, Error>(Jet::ratio(value, precision)))?;
        Linear::new(enclosed, Jet::ratio(&discriminant, precision), precision)
    }

    /// A system whose coefficients may depend on an unknown.
    pub fn enclosed(system: System<Jet>, precision: &'a Precision) -> Result<Self> {
        let quarter = Jet::ratio(&BigRational::new(1.into(), 4.into()), precision);
        let square = system.damping.clone() * &system.damping * &quarter;
        let discriminant = system.stiffness.clone() - &square;
        Linear::new(system, discriminant, precision)
    }

    fn new(system: System<Jet>, discriminant: Jet, precision: &'a Precision) -> Result<Self> {
        if !is_zero(&system.cubic) {
            return Err(Error::input("only linear systems can be validated: `cubic` must be 0"));
        }
        if system.smooth.is_some() {
            return Err(Error::input(
                "only linear systems can be validated: `force` must not depend on q, u or t",
            ));
        }
        let walls = [&system.lower, &system.upper].into_iter().flatten();
        if walls.map(|wall| wall.restitution.sign()).any(|sign| matches!(sign, None | Some(Sign::Negative))) {
            return Err(Error::input("a restitution must be at least 0"));
        }
        let free = match discriminant.sign() {
            Some(Sign::Positive) => Free::Oscillating(discriminant.sqrt()),
            Some(Sign::Negative) => Free::Overdamped((-discriminant).sqrt()),
            _ if is_zero(&discriminant) => Free::Critical,
            _ => return Err(Error::input("damping^2 cannot be told from 4 stiffness here")),
        };
        let mut response = Vec::new();
        for force in &system.forcing {
            response.push(respond(&system, force, precision)?);
        }
        Ok(Linear { system, free, response, precision })
    }

    fn integer(&self, value: i32) -> Jet {
        Jet::integer(value, self.precision)
    }

    /// The wall on this side.
    ///
    /// # Errors
    /// An input error if there is none.
    pub fn wall(&self, side: Side) -> Result<&Wall<Jet>> {
        let wall = match side {
            Side::Lower => &self.system.lower,
            Side::Upper => &self.system.upper,
        };
        wall.as_ref().ok_or_else(|| Error::input(format!("there is no {} wall", side.name())))
    }

    /// The sides that have a wall.
    pub fn sides(&self) -> impl Iterator<Item = Side> {
        [Side::Lower, Side::Upper].into_iter().filter(|&side| self.wall(side).is_ok())
    }

    /// x or −x: the direction away from the wall.
    pub fn inward(&self, side: Side, x: Jet) -> Jet {
        if side == Side::Lower { x } else { -x }
    }

    /// Q, Q′, Q″ at time t.
    pub fn wall_motion(&self, side: Side, t: &Jet) -> Result<Motion> {
        let wall = self.wall(side)?;
        let [value, slope, curvature] = self.series(&wall.harmonics, t);
        Ok([value + &wall.offset, slope, curvature])
    }

    /// A sum of harmonics with its derivatives at time t. Cost: one sine and cosine each.
    fn series(&self, harmonics: &[Harmonic<Jet>], t: &Jet) -> Motion {
        let zero = || self.integer(0);
        harmonics.iter().fold([zero(), zero(), zero()], |[value, slope, curvature], harmonic| {
            let k = Jet::ratio(&BigInt::from(harmonic.k).into(), self.precision);
            let (sin, cos) = (k.clone() * t).sin_cos(self.precision);
            let here = harmonic.cos.clone() * &cos + &(harmonic.sin.clone() * &sin);
            let along = (harmonic.sin.clone() * &cos - &(harmonic.cos.clone() * &sin)) * &k;
            [value + &here, slope + &along, curvature - &(k.clone() * &k * &here)]
        })
    }

    /// E(τ).
    pub fn propagator(&self, tau: &Jet) -> [[Jet; 2]; 2] {
        let half = Jet::ratio(&BigRational::new(1.into(), 2.into()), self.precision);
        let rate = self.system.damping.clone() * &half;
        let decay = (-rate.clone() * tau).exp(self.precision);
        // C and S with C′ = ∓ω² S, S′ = C: E = e^(−cτ/2) (C + S (A + c/2)).
        let (c, s) = match &self.free {
            Free::Oscillating(omega) => {
                let (sin, cos) = (omega.clone() * tau).sin_cos(self.precision);
                (cos, sin / omega)
            }
            Free::Overdamped(omega) => {
                let up = (omega.clone() * tau).exp(self.precision);
                let down = self.integer(1) / &up;
                ((up.clone() + &down) * &half, (up - &down) * &half / omega)
            }
            Free::Critical => (self.integer(1), tau.clone()),
        };
        let (c, s) = (c * &decay, s * &decay);
        let shift = s.clone() * &rate;
        [[c.clone() + &shift, s.clone()], [-s * &self.system.stiffness, c - &shift]]
    }

    /// I(τ) = ∫₀^τ E₁₂, for the E(τ) given.
    fn ramp(&self, tau: &Jet, propagator: &[[Jet; 2]; 2]) -> Jet {
        let system = &self.system;
        if !is_zero(&system.stiffness) {
            return (self.integer(1) - &propagator[0][0]) / &system.stiffness;
        }
        if !is_zero(&system.damping) {
            return (tau.clone() - &propagator[0][1]) / &system.damping;
        }
        tau.clone() * tau * &Jet::ratio(&BigRational::new(1.into(), 2.into()), self.precision)
    }

    /// The motion that leaves a wall at `phase` after an impact at the incoming relative speed `velocity`.
    pub fn depart(&self, side: Side, phase: &Jet, velocity: &Jet) -> Result<Flight> {
        let [position, speed, _] = self.wall_motion(side, phase)?;
        let [response, slope, _] = self.series(&self.response, phase);
        let rebound = self.inward(side, self.wall(side)?.restitution.clone() * velocity);
        Ok(Flight { phase: phase.clone(), start: [position - &response, speed + &rebound - &slope] })
    }

    /// The periodic response itself, from a phase on.
    ///
    /// # Errors
    /// An input error without stiffness.
    pub fn steady(&self, phase: &Jet) -> Result<Flight> {
        let (force, stiffness) = (&self.system.force, &self.system.stiffness);
        if stiffness.sign().is_none_or(|sign| sign == Sign::Zero) {
            return Err(Error::input("a motion without impacts is proved only with stiffness"));
        }
        let rest = if is_zero(force) { self.integer(0) } else { force.clone() / stiffness };
        Ok(Flight { phase: phase.clone(), start: [rest, self.integer(0)] })
    }

    /// q, q′, q″ of a flight a time τ after its start, at time `t` (the start's phase and τ, modulo 2π).
    pub fn motion(&self, flight: &Flight, tau: &Jet, t: &Jet) -> Motion {
        let e = self.propagator(tau);
        let [a, b] = &flight.start;
        let [response, slope, _] = self.series(&self.response, t);
        let force = &self.system.force;
        let mut q = response + &(e[0][0].clone() * a) + &(e[0][1].clone() * b);
        let mut u = slope + &(e[1][0].clone() * a) + &(e[1][1].clone() * b);
        if !is_zero(force) {
            q = q + &(force.clone() * &self.ramp(tau, &e));
            u = u + &(force.clone() * &e[0][1]);
        }
        let acceleration = self.acceleration(&q, &u, t);
        [q, u, acceleration]
    }

    /// q″ at displacement q, velocity u and time t.
    pub fn acceleration(&self, q: &Jet, u: &Jet, t: &Jet) -> Jet {
        let system = &self.system;
        let [forcing, ..] = self.series(&system.forcing, t);
        forcing + &system.force - &(system.damping.clone() * u) - &(system.stiffness.clone() * q)
    }

    /// The gap ±(q − Q) to the wall on a side with its derivatives, a time τ after the flight's start.
    pub fn gap(&self, flight: &Flight, side: Side, tau: &Jet) -> Result<Motion> {
        let t = flight.phase.clone() + tau;
        self.gap_at(flight, side, tau, &t)
    }

    /// As [`gap`](Linear::gap), with the time known.
    pub fn gap_at(&self, flight: &Flight, side: Side, tau: &Jet, t: &Jet) -> Result<Motion> {
        let [q, u, a] = self.motion(flight, tau, t);
        let [position, speed, curvature] = self.wall_motion(side, t)?;
        Ok([q - &position, u - &speed, a - &curvature].map(|x| self.inward(side, x)))
    }
}

/// Whether a number is zero whatever the unknowns.
fn is_zero(x: &Jet) -> bool {
    let constant = x.slopes.iter().all(|slope| slope.sign() == Some(Sign::Zero));
    constant && x.sign() == Some(Sign::Zero)
}

/// The periodic response α cos kt + β sin kt to one harmonic a cos kt + b sin kt of the forcing:
/// (K − k²) α + k c β = a, (K − k²) β − k c α = b.
fn respond(system: &System<Jet>, force: &Harmonic<Jet>, precision: &Precision) -> Result<Harmonic<Jet>> {
    let k = Jet::ratio(&BigInt::from(force.k).into(), precision);
    let detuning = system.stiffness.clone() - &(k.clone() * &k);
    let damping = system.damping.clone() * &k;
    let determinant = detuning.clone() * &detuning + &(damping.clone() * &damping);
    if determinant.sign() != Some(Sign::Positive) {
        return Err(Error::input(format!("harmonic {} of the forcing is in undamped resonance", force.k)));
    }
    let cos = (detuning.clone() * &force.cos - &(damping.clone() * &force.sin)) / &determinant;
    let sin = (detuning * &force.sin + &(damping * &force.cos)) / &determinant;
    Ok(Harmonic { k: force.k, cos, sin })
}
