//! An oscillator at one parameter value: motion between impacts and impacts themselves, with all their derivatives.
//!
//! Derivatives with respect to the parameter come with those of the system's coefficients: no differences are taken.

use super::{
    super::{Flow, Side, State, System, Wall, flow},
    algebra::{Matrix2, apply, product},
};
use crate::error::{Error, Result};

/// The equation of motion at one parameter value, its flow, and how its coefficients change with the parameter.
pub struct Oscillator {
    system: System<f64>,
    slope: Option<System<f64>>,
    flow: Box<dyn Flow>,
}

/// Oscillators that differ in one parameter.
pub trait Family: Sync {
    /// The oscillator at a parameter value; with a slope if derivatives in the parameter will be asked for.
    ///
    /// # Errors
    /// An input error where the system is not defined.
    fn at(&self, parameter: f64) -> Result<Oscillator>;
}

impl<F: Fn(f64) -> Result<Oscillator> + Sync> Family for F {
    fn at(&self, parameter: f64) -> Result<Oscillator> {
        self(parameter)
    }
}

/// Where a motion without impacts leads, with derivatives at fixed times.
#[derive(Debug, Clone, Copy)]
pub struct Leg {
    /// The state at its end.
    pub end: State,
    /// ∂(q, u)/∂(q₀, u₀).
    pub matrix: Matrix2,
    /// ∂(q, u)/∂p.
    pub slope: [f64; 2],
}

/// A wall at one time, its velocity and acceleration, and what the parameter does to it.
#[derive(Debug, Clone, Copy)]
pub struct Contact {
    /// 1 for the lower wall, −1 for the upper.
    pub sign: f64,
    /// Q, Q′, Q″.
    pub motion: [f64; 3],
    /// ∂(Q, Q′)/∂p.
    pub slope: [f64; 2],
    /// τ.
    pub restitution: f64,
    /// ∂τ/∂p.
    pub restitution_slope: f64,
}

impl Contact {
    /// The state at the wall with relative velocity `speed` away from it: V before an impact is −V here, and τV after it.
    pub fn leaving(&self, t: f64, speed: f64) -> State {
        State { t, q: self.motion[0], u: self.motion[1] + self.sign * speed }
    }
}

impl Oscillator {
    /// The oscillator of a system, without derivatives in a parameter.
    ///
    /// # Errors
    /// An input error if the system has no flow.
    pub fn new(system: System<f64>) -> Result<Oscillator> {
        Ok(Oscillator { flow: flow(&system)?, system, slope: None })
    }

    /// The oscillator of a system whose coefficients change at the rates `slope`.
    ///
    /// # Errors
    /// As [`Oscillator::new`].
    pub fn with_slope(system: System<f64>, slope: System<f64>) -> Result<Oscillator> {
        Ok(Oscillator { slope: Some(slope), ..Oscillator::new(system)? })
    }

    /// The system.
    pub fn system(&self) -> &System<f64> {
        &self.system
    }

    /// The flow.
    pub fn flow(&self) -> &dyn Flow {
        &*self.flow
    }

    /// The wall on a side at time t.
    ///
    /// # Errors
    /// An input error if there is no such wall.
    pub fn contact(&self, side: Side, t: f64) -> Result<Contact> {
        let missing = || Error::input(format!("an impact at the {side} wall, but there is no such wall"));
        let wall = side.wall(&self.system).ok_or_else(missing)?;
        let slope = self.slope.as_ref().and_then(|slope| side.wall(slope));
        let rates = slope.map_or([0.0; 3], |slope| slope.motion(t));
        Ok(Contact {
            sign: side.sign(),
            motion: wall.motion(t),
            slope: [rates[0], rates[1]],
            restitution: wall.restitution,
            restitution_slope: slope.map_or(0.0, |slope| slope.restitution),
        })
    }

    /// The motion from a state for a time ≥ 0.
    pub fn leg(&self, from: State, duration: f64) -> Leg {
        match self.slope.as_ref().filter(|slope| moves(slope)) {
            None => {
                let (end, matrix) = self.flow.advance_linearised(from, duration);
                Leg { end, matrix, slope: [0.0; 2] }
            }
            Some(slope) => self.sensitive_leg(slope, from, duration),
        }
    }

    /// Duhamel's integral ∫ Φ(T, s) (0, ∂a/∂p)ᵀ ds by Gauss's rule on panels short against every period in the system,
    /// summed on the way: exact to rounding.
    fn sensitive_leg(&self, slope: &System<f64>, from: State, duration: f64) -> Leg {
        let panels = (duration * self.rate()).ceil().max(1.0);
        let width = duration / panels;
        let (mut here, mut matrix, mut sum, mut at) = (from, super::algebra::IDENTITY, [0.0; 2], 0.0);
        let mut go = |to: f64, weight: f64| {
            let (next, step) = self.flow.advance_linearised(here, to - at);
            (here, at) = (next, to);
            matrix = product(&step, &matrix);
            sum = apply(&step, sum);
            sum[1] += weight * acceleration(slope, &here);
        };
        for panel in 0..panels as u32 {
            for (node, weight) in GAUSS {
                go(width * (f64::from(panel) + node), width * weight);
            }
        }
        go(duration, 0.0);
        Leg { end: here, matrix, slope: sum }
    }

    /// The fastest rate in the system: of the vibration, of the damping, of any harmonic.
    pub(super) fn rate(&self) -> f64 {
        let system = &self.system;
        let walls = Side::BOTH.into_iter().filter_map(|side| side.wall(system)).flat_map(|wall| &wall.harmonics);
        let fastest = system.forcing.iter().chain(walls).map(|h| h.k).max().unwrap_or(1).max(1);
        (system.stiffness.abs() + 3.0 * system.cubic.abs()).sqrt().max(system.damping.abs()).max(f64::from(fastest))
    }

    /// How an impact of incoming speed V ≠ 0 passes on a displacement before it: the saltation matrix, and what the
    /// parameter adds.
    pub fn saltation(&self, contact: &Contact, t: f64, speed: f64) -> (Matrix2, [f64; 2]) {
        let (sign, tau) = (contact.sign, contact.restitution);
        let before = self.flow.acceleration(contact.leaving(t, -speed));
        let after = self.flow.acceleration(contact.leaving(t, tau * speed));
        let jump = -tau * before + (1.0 + tau) * contact.motion[2] - after;
        let [wall, wall_velocity] = contact.slope;
        let slope = [
            (1.0 + tau) * wall,
            (1.0 + tau) * wall_velocity + contact.restitution_slope * sign * speed - jump * sign * wall / speed,
        ];
        ([[-tau, 0.0], [jump * sign / speed, -tau]], slope)
    }
}

/// Whether a slope changes the motion between impacts.
fn moves(slope: &System<f64>) -> bool {
    let still = [slope.damping, slope.stiffness, slope.cubic, slope.force].iter().all(|x| *x == 0.0)
        && slope.forcing.iter().all(|h| h.cos == 0.0 && h.sin == 0.0);
    !still
}

/// The right side of the equation of motion, at its word.
fn acceleration(system: &System<f64>, State { t, q, u }: &State) -> f64 {
    let forcing: f64 = system
        .forcing
        .iter()
        .map(|h| {
            let (sin, cos) = (f64::from(h.k) * t).sin_cos();
            h.cos * cos + h.sin * sin
        })
        .sum();
    -system.damping * u - system.stiffness * q - system.cubic * q * q * q + system.force + forcing
}

/// Gauss–Legendre with 8 points on [0, 1]: (node, weight).
const GAUSS: [(f64, f64); 8] = {
    let half = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_361_98),
        (0.525_532_409_916_329, 0.313_706_645_877_887_29),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
        (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
    ];
    let mut rule = [(0.0, 0.0); 8];
    let mut i = 0;
    while i < 4 {
        let (node, weight) = half[i];
        rule[4 + i] = (0.5 + node / 2.0, weight / 2.0);
        rule[3 - i] = (0.5 - node / 2.0, weight / 2.0);
        i += 1;
    }
    rule
};
