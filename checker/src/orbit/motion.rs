//! The motion of a linear oscillator between impacts, and its walls, over intervals.
//!
//! q(t) = h(t) + F I(τ) + the first entry of exp(τA) (a, b), τ the time since the impact, h the periodic response to the forcing's
//! harmonics, I″ + c I′ + k I = 1 with I = I′ = 0 at τ = 0, and (a, b) the start minus (h, h′).

use super::{
    Side,
    exponential::{CIRCLE, Element, Ring},
    fixed::Interval,
    text::{Fraction, Harmonic, System, Wall},
};

/// A function of time with its first two derivatives.
pub(super) type Motion = [Interval; 3];

/// A sum of harmonics.
type Series = Vec<(Interval, Interval, Interval)>;

/// A wall over intervals: its mean and harmonics, its restitution.
struct Moving {
    offset: Interval,
    motion: Series,
    restitution: Interval,
}

/// A system over intervals.
pub(super) struct Oscillator {
    pub ring: Ring,
    force: Interval,
    forcing: Series,
    response: Series,
    walls: [Option<Moving>; 2],
    /// Whether c and k are exactly 0: the motion under a constant force depends on it.
    zero: [bool; 2],
}

/// A motion that left a wall at a phase.
#[derive(Clone, Copy)]
pub(super) struct Flight {
    phase: Interval,
    start: [Interval; 2],
}

fn enclosed(value: Fraction) -> Interval {
    Interval::ratio(value.p, value.q)
}

impl Oscillator {
    /// Encloses the coefficients.
    ///
    /// # Errors
    /// Says what the method cannot do with them.
    pub fn new(system: &System) -> Result<Self, String> {
        let series = |harmonics: &[Harmonic]| -> Series {
            harmonics.iter().map(|h| (Interval::integer(h.k), enclosed(h.cos), enclosed(h.sin))).collect()
        };
        let wall = |wall: &Wall| Moving {
            offset: enclosed(wall.offset),
            motion: series(&wall.harmonics),
            restitution: enclosed(wall.restitution),
        };
        let ring = Ring { damping: enclosed(system.damping), stiffness: enclosed(system.stiffness) };
        let forcing = series(&system.forcing);
        let mut response = Series::new();
        // α cos νt + β sin νt answers to a cos νt + b sin νt: (k − ν²) α + νc β = a, (k − ν²) β − νc α = b. Divided by ν, with w = k/ν − ν,
        // so that no power above ν² occurs.
        for (harmonic, &(nu, a, b)) in system.forcing.iter().zip(&forcing) {
            let nothing = |why| Err(format!("harmonic {} of the forcing {why}", harmonic.k));
            if harmonic.k == 0 {
                if system.stiffness.p == 0 {
                    return nothing("is a constant, to which nothing periodic answers without stiffness");
                }
                response.push((nu, a.over(ring.stiffness), Interval::ZERO));
                continue;
            }
            let (detuning, damping) = (ring.stiffness.over(nu) - nu, ring.damping);
            let size = detuning.squared() + damping.squared();
            if size.magnitude_bits().is_none() {
                return nothing("meets a stiffness or damping too large for this method: squares reach 2^30");
            }
            if !size.is_positive() {
                return nothing("is in undamped resonance");
            }
            response.push((
                nu,
                (detuning * a - damping * b).over(size).over(nu),
                (detuning * b + damping * a).over(size).over(nu),
            ));
        }
        let zero = [system.damping.p == 0, system.stiffness.p == 0];
        let walls = [system.lower.as_ref().map(wall), system.upper.as_ref().map(wall)];
        Ok(Oscillator { ring, force: enclosed(system.force), forcing, response, walls, zero })
    }

    /// The sides that have a wall.
    pub fn sides(&self) -> impl Iterator<Item = Side> {
        [Side::Lower, Side::Upper].into_iter().filter(|&side| self.walls[side as usize].is_some())
    }

    fn wall(&self, side: Side) -> &Moving {
        self.walls[side as usize].as_ref().expect("impacts were read with the walls they meet")
    }

    pub fn restitution(&self, side: Side) -> Interval {
        self.wall(side).restitution
    }

    /// Q, Q′, Q″.
    pub fn wall_motion(&self, side: Side, t: Interval) -> Motion {
        let wall = self.wall(side);
        let [value, slope, curvature] = sum(&wall.motion, t);
        [value + wall.offset, slope, curvature]
    }

    /// q″ at displacement q, velocity u, time t.
    pub fn acceleration(&self, q: Interval, u: Interval, t: Interval) -> Interval {
        sum(&self.forcing, t)[0] + self.force - self.ring.damping * u - self.ring.stiffness * q
    }

    /// The motion after an impact at the incoming relative speed `velocity`.
    pub fn depart(&self, side: Side, phase: Interval, velocity: Interval) -> Flight {
        let [position, speed, _] = self.wall_motion(side, phase);
        let [response, slope, _] = sum(&self.response, phase);
        let rebound = side.inward(self.restitution(side) * velocity);
        Flight { phase, start: [position - response, speed + rebound - slope] }
    }

    /// The gap ±(q − Q) to a wall with its derivatives, a time τ after the start.
    pub fn gap(&self, flight: Flight, side: Side, tau: Interval) -> Motion {
        self.gap_at(flight, side, tau, flight.phase + tau)
    }

    /// The same, the phase at that time being known as `t`.
    pub fn gap_at(&self, flight: Flight, side: Side, tau: Interval, t: Interval) -> Motion {
        let e = self.ring.exp(tau);
        let [free, drift] = self.ring.apply(e, flight.start);
        let [response, slope, _] = sum(&self.response, t);
        let q = response + free + self.force * self.ramp(tau, e);
        let u = slope + drift + self.force * e.b;
        let [position, speed, curvature] = self.wall_motion(side, t);
        [q - position, u - speed, self.acceleration(q, u, t) - curvature].map(|x| side.inward(x))
    }

    /// I(τ): I′ is the entry b of exp(τA), which is integrated by its equation.
    fn ramp(&self, tau: Interval, e: Element) -> Interval {
        match self.zero {
            [_, false] => (Interval::ONE - e.a).over(self.ring.stiffness),
            [false, true] => (tau - e.b).over(self.ring.damping),
            [true, true] => tau.squared().shifted_down(1),
        }
    }
}

/// Σ (a cos kt + b sin kt) with its derivatives.
fn sum(series: &Series, t: Interval) -> Motion {
    series.iter().fold([Interval::ZERO; 3], |[value, slope, curvature], &(k, a, b)| {
        // Where k t is a wide interval the series says less than this.
        let Element { a: cos, b: sin } = CIRCLE.exp(k * t);
        let (cos, sin) = (cos.within_unit(), sin.within_unit());
        let here = a * cos + b * sin;
        [value + here, slope + k * (b * cos - a * sin), curvature - k * k * here]
    })
}
