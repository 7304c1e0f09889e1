//! The motion of a linear oscillator between impacts, and its walls, over intervals.
//!
//! q(t) = h(t) + F I(τ) + the first entry of exp(τA) (a, b), τ the time since the impact, h the periodic
//! response to the forcing's harmonics, I″ + c I′ + k I = 1 with I = I′ = 0 at τ = 0, and (a, b) the start
//! minus (h, h′).

use super::{
    Interval,
    exponential::{Element, Ring},
    number::Number,
    text::{Coefficient, Harmonic, Side, System, Wall},
};

/// A function of time with its first two derivatives.
pub(crate) type Motion<N> = [N; 3];

/// A sum of harmonics.
type Series<N> = Vec<(N, N, N)>;

/// A wall over intervals: its mean and harmonics, its restitution.
struct Moving<N> {
    offset: N,
    motion: Series<N>,
    restitution: N,
}

/// A system over intervals.
pub(crate) struct Oscillator<N> {
    pub ring: Ring<N>,
    force: N,
    forcing: Series<N>,
    response: Series<N>,
    walls: [Option<Moving<N>>; 2],
    /// Whether c, k and F are exactly 0, whatever a parameter is: the motion under a constant force depends
    /// on it.
    zero: [bool; 3],
}

/// A motion that left a wall at a phase.
#[derive(Clone, Copy)]
pub(crate) struct Flight<N> {
    phase: N,
    start: [N; 2],
}

impl<N: Number> Oscillator<N> {
    /// Encloses the coefficients at a value of the parameter, of which they may make no use.
    ///
    /// # Errors
    /// Says what the method cannot do with them.
    pub fn new<C: Coefficient>(system: &System<C>, parameter: N) -> Result<Self, String> {
        let enclosed = |coefficient: &C| coefficient.enclosed(parameter);
        let integer = |n: u64| N::constant(Interval::integer(n));
        let series = |harmonics: &[Harmonic<C>]| -> Series<N> {
            harmonics.iter().map(|h| (integer(h.k), enclosed(&h.cos), enclosed(&h.sin))).collect()
        };
        let wall = |wall: &Wall<C>| Moving {
            offset: enclosed(&wall.offset),
            motion: series(&wall.harmonics),
            restitution: enclosed(&wall.restitution),
        };
        let ring = Ring { damping: enclosed(&system.damping), stiffness: enclosed(&system.stiffness) };
        let zero = [&system.damping, &system.stiffness, &system.force].map(Coefficient::is_zero);
        let forcing = series(&system.forcing);
        let mut response = Vec::new();
        // α cos νt + β sin νt answers to a cos νt + b sin νt: (k − ν²) α + νc β = a, (k − ν²) β − νc α = b.
        // Divided by ν, with w = k/ν − ν, so that no power above ν² occurs.
        for (harmonic, &(nu, a, b)) in system.forcing.iter().zip(&forcing) {
            let nothing = |why| Err(format!("harmonic {} of the forcing {why}", harmonic.k));
            if harmonic.k == 0 {
                if zero[1] {
                    return nothing("is a constant, to which nothing periodic answers without stiffness");
                }
                response.push((nu, a.over(ring.stiffness), N::ZERO));
                continue;
            }
            let (detuning, damping) = (ring.stiffness.over(nu) - nu, ring.damping);
            let size = detuning.squared() + damping.squared();
            if size.value().magnitude_bits().is_none() {
                return nothing("meets a stiffness or damping too large for this method: squares reach 2^30");
            }
            if !size.value().is_positive() {
                return nothing("is in undamped resonance");
            }
            response.push((
                nu,
                (detuning * a - damping * b).over(size).over(nu),
                (detuning * b + damping * a).over(size).over(nu),
            ));
        }
        let walls = [system.lower.as_ref().map(wall), system.upper.as_ref().map(wall)];
        Ok(Oscillator { ring, force: enclosed(&system.force), forcing, response, walls, zero })
    }

    /// Whether the restitutions are certainly at least 0.
    pub fn restitutions_are_nonnegative(&self) -> bool {
        self.walls.iter().flatten().all(|wall| wall.restitution.value().is_nonnegative())
    }

    /// The sides that have a wall.
    pub fn sides(&self) -> impl Iterator<Item = Side> {
        [Side::Lower, Side::Upper].into_iter().filter(|&side| self.walls[side as usize].is_some())
    }

    fn wall(&self, side: Side) -> &Moving<N> {
        self.walls[side as usize].as_ref().expect("impacts were read with the walls they meet")
    }

    pub fn restitution(&self, side: Side) -> N {
        self.wall(side).restitution
    }

    /// Q, Q′, Q″.
    pub fn wall_motion(&self, side: Side, t: N) -> Motion<N> {
        let wall = self.wall(side);
        let [value, slope, curvature] = sum(&wall.motion, t);
        [value + wall.offset, slope, curvature]
    }

    /// q″ at displacement q, velocity u, time t.
    pub fn acceleration(&self, q: N, u: N, t: N) -> N {
        sum(&self.forcing, t)[0] + self.force - self.ring.damping * u - self.ring.stiffness * q
    }

    /// The motion after an impact at the incoming relative speed `velocity`.
    pub fn depart(&self, side: Side, phase: N, velocity: N) -> Flight<N> {
        let [position, speed, _] = self.wall_motion(side, phase);
        let [response, slope, _] = sum(&self.response, phase);
        let rebound = side.inward(self.restitution(side) * velocity);
        Flight { phase, start: [position - response, speed + rebound - slope] }
    }

    /// The periodic response itself, from a phase on. Nothing is known of it where the stiffness may be 0.
    pub fn steady(&self, phase: N) -> Flight<N> {
        let rest = if self.zero[2] { N::ZERO } else { self.force.over(self.ring.stiffness) };
        Flight { phase, start: [rest, N::ZERO] }
    }

    /// The gap of the periodic response, a sum of harmonics itself, with its derivatives. Nothing is known of
    /// it where the stiffness may be 0 and the force is not.
    pub fn free_gap(&self, side: Side, t: N) -> Motion<N> {
        let Flight { start: [rest, _], .. } = self.steady(t);
        let [response, slope, curvature] = sum(&self.response, t);
        let [position, speed, bend] = self.wall_motion(side, t);
        [rest + response - position, slope - speed, curvature - bend].map(|x| side.inward(x))
    }

    /// The same gap as a sum of harmonics: its mean, then the coefficients of cos and sin, first of the
    /// forcing's orders, then of the wall's; constants among these are no part of the mean.
    pub fn free_series(&self, side: Side) -> (N, Vec<[N; 2]>) {
        let (wall, rest) = (self.wall(side), self.steady(N::ZERO).start[0]);
        let answers = self.response.iter().map(|&(_, a, b)| [a, b]);
        let moves = wall.motion.iter().map(|&(_, a, b)| [-a, -b]);
        let terms = answers.chain(moves).map(|both| both.map(|x| side.inward(x)));
        (side.inward(rest - wall.offset), terms.collect())
    }

    /// Whether no other motion without impacts comes back after 2π: 1 is no multiplier of it.
    pub fn is_alone(&self) -> bool {
        let turn = self.ring.exp(N::constant(Interval::PI + Interval::PI));
        // Of exp(tA) = a + bA the trace is 2a − cb.
        let trace = turn.a + turn.a - self.ring.damping * turn.b;
        let determinant = self.ring.determinant(turn);
        let value = (N::ONE - trace + determinant).value();
        value.is_positive() || (-value).is_positive()
    }

    /// The gap ±(q − Q) to a wall with its derivatives, a time τ after the start.
    pub fn gap(&self, flight: Flight<N>, side: Side, tau: N) -> Motion<N> {
        self.gap_at(flight, side, tau, flight.phase + tau)
    }

    /// The same, the phase at that time being known as `t`.
    pub fn gap_at(&self, flight: Flight<N>, side: Side, tau: N, t: N) -> Motion<N> {
        let e = self.ring.exp(tau);
        let [free, drift] = self.ring.apply(e, flight.start);
        let [response, slope, _] = sum(&self.response, t);
        let q = response + free + self.force * self.ramp(tau, e);
        let u = slope + drift + self.force * e.b;
        let [position, speed, curvature] = self.wall_motion(side, t);
        [q - position, u - speed, self.acceleration(q, u, t) - curvature].map(|x| side.inward(x))
    }

    /// I(τ): I′ is the entry b of exp(τA), which is integrated by its equation.
    fn ramp(&self, tau: N, e: Element<N>) -> N {
        match self.zero {
            [_, false, _] => (N::ONE - e.a).over(self.ring.stiffness),
            [false, true, _] => (tau - e.b).over(self.ring.damping),
            [true, true, _] => tau.squared().shifted_down(1),
        }
    }
}

/// Σ (a cos kt + b sin kt) with its derivatives.
fn sum<N: Number>(series: &Series<N>, t: N) -> Motion<N> {
    series.iter().fold([N::ZERO; 3], |[value, slope, curvature], &(k, a, b)| {
        // Where k t is a wide interval the series says less than this.
        let Element { a: cos, b: sin } = Ring::CIRCLE.exp(k * t);
        let (cos, sin) = (cos.within_unit(), sin.within_unit());
        let here = a * cos + b * sin;
        [value + here, slope + k * (b * cos - a * sin), curvature - k * k * here]
    })
}
