//! An oscillator at one parameter value: motion between impacts and impacts themselves, with all their
//! derivatives.
//!
//! Derivatives with respect to the parameter come with those of the system's coefficients: no differences are
//! taken.

use std::{collections::BTreeSet, f64::consts::TAU, sync::Arc};

use super::{super::size, Itinerary, Leg, Touch};
use crate::{
    error::{Error, Result},
    motion::{
        Contact, Effect, EffectTally, Flow, Harmonic, Series, Side, State, System, Wall,
        algebra::{IDENTITY, Matrix2, apply, divide, product},
        flow::{Free, GAUSS, Gradient, Obstacle, Program, Scalar, too_many},
    },
};

/// The equation of motion at one parameter value, and how its coefficients change with the parameter.
#[derive(Debug, Clone)]
pub struct Oscillator {
    system: System<f64>,
    flow: Free,
    walls: Vec<Contact>,
    slope: Option<Slope>,
    /// The highest harmonic, at least 1.
    order: u32,
    /// The fastest rate, if it does not depend on the state.
    rate: Option<f64>,
    tally: Option<Arc<EffectTally>>,
}

/// The derivatives of a system's coefficients in a parameter.
#[derive(Debug, Clone)]
struct Slope {
    damping: f64,
    stiffness: f64,
    cubic: f64,
    forcing: Series,
    /// The equation with its derivatives by q and u at a start and by the parameter, if the terms above are
    /// not all of it: then they are not looked at.
    smooth: Option<Program<Gradient<4>>>,
    /// Of position and restitution; lower, upper.
    walls: [Option<(Series, f64)>; 2],
}

impl Oscillator {
    /// The oscillator of a system, without derivatives in a parameter; `tolerance` is that of [`Free::new`].
    ///
    /// # Errors
    /// Those of [`Free::new`] and [`Contact::of`].
    pub fn new(system: System<f64>, tolerance: f64) -> Result<Oscillator> {
        let (flow, walls) = (Free::new(&system, tolerance)?, Contact::of(&system)?);
        let order = flow.equation().forcing.order();
        let order = walls.iter().fold(order, |order, wall| order.max(wall.position.order()));
        let mut oscillator =
            Oscillator { system, flow, walls, slope: None, order: order.max(1), rate: None, tally: None };
        if oscillator.flow.equation().is_linear() {
            oscillator.rate = Some(oscillator.rate_at(&State { t: 0.0, q: 0.0, u: 0.0 }));
        }
        Ok(oscillator)
    }

    /// The oscillator of a system whose coefficients change at the rates `slope`.
    ///
    /// # Errors
    /// As [`Oscillator::new`]; a rate that is not finite.
    pub fn with_slope(system: System<f64>, slope: &System<f64>, tolerance: f64) -> Result<Oscillator> {
        let wall = |wall: &Option<Wall<f64>>| -> Result<Option<(Series, f64)>> {
            let Some(wall) = wall else { return Ok(None) };
            Ok(Some((Series::new(wall.offset, &wall.harmonics)?, wall.restitution)))
        };
        let program = system.smooth.is_some().then(|| varied(&system, slope)).transpose()?;
        // Of a formula that is recognised the rates are those of the keys that it stands for.
        let plain = program.as_ref().and_then(Program::plain);
        let slope = match plain {
            Some(plain) => {
                let drive = plain.drive.iter().map(|drive| Harmonic {
                    k: drive.k as u32,
                    cos: drive.cos.part(3),
                    sin: drive.sin.part(3),
                });
                let (force, forcing, smooth) = (plain.force.part(3), drive.collect(), None);
                let [damping, stiffness, cubic] =
                    [plain.damping, plain.stiffness, plain.cubic].map(|rate| rate.part(3));
                &System { damping, stiffness, cubic, force, forcing, smooth, ..slope.clone() }
            }
            None => slope,
        };
        let slope = Slope {
            damping: slope.damping,
            stiffness: slope.stiffness,
            cubic: slope.cubic,
            forcing: Series::new(slope.force, &slope.forcing)?,
            smooth: program.filter(|program| program.plain().is_none()),
            walls: [wall(&slope.lower)?, wall(&slope.upper)?],
        };
        Ok(Oscillator { slope: Some(slope), ..Oscillator::new(system, tolerance)? })
    }

    /// The same oscillator, its work added up in `tally`: steps of the integrator, and the pieces of legs
    /// that are looked at for admissibility.
    #[must_use]
    pub fn counting(self, tally: Arc<EffectTally>) -> Oscillator {
        Oscillator { flow: self.flow.counting(tally.clone()), tally: Some(tally), ..self }
    }

    /// Where its work is counted, if it is.
    pub(crate) fn tally(&self) -> Option<&Arc<EffectTally>> {
        self.tally.as_ref()
    }

    /// Counts pieces that were looked at for minima of the gap to a wall, and the searches among them.
    pub(super) fn count(&self, wall: &Contact, pieces: u64, searches: u64) {
        let Some(tally) = &self.tally else { return };
        tally.add(Effect::Piece, pieces);
        tally.add(if wall.side == Side::Lower { Effect::LowerGap } else { Effect::UpperGap }, pieces);
        tally.add(Effect::Search, searches);
        // The integrator's steps count the forcing themselves.
        let equation = self.flow.equation();
        if wall.position.order() > 0 || equation.is_linear() && equation.is_driven() {
            tally.add(Effect::Drive, pieces);
        }
    }

    /// The system.
    pub fn system(&self) -> &System<f64> {
        &self.system
    }

    /// The size of motions that strike the walls of a pattern, for tolerances: of what the forces do in a
    /// radian, of the places and motions of these walls, and of the nearest wall unless it is farther away
    /// than ten times all that moves. Scales with the unit of length; 1 if there is none of this. Cost: that
    /// of 16 evaluations of a force that is a formula.
    pub fn unit(&self, itinerary: &Itinerary) -> f64 {
        let struck = |wall: &Contact| itinerary.strikes().iter().any(|strike| strike.place == wall.side);
        size::unit(self.flow.equation(), self.walls.iter(), struck)
    }

    /// What changes the system by its own size: a force or a wall by the size of the motion, `unit`, or a
    /// coefficient without a unit by 1. 1 if the parameter changes nothing.
    pub fn parameter_unit(&self, unit: f64) -> f64 {
        let Some(slope) = &self.slope else { return 1.0 };
        let states = [[0.0, 0.0], [unit, 0.0], [0.0, unit]];
        let looks = (0..16).flat_map(|look| states.map(|at| (TAU * f64::from(look) / 16.0, at)));
        let forces = looks.map(|(t, [q, u])| slope.acceleration(&State { t, q, u }).abs() / unit);
        let walls = slope.walls.iter().flatten().map(|(place, restitution)| {
            ((place.mean().abs() + place.derivative_bound(0)) / unit).max(restitution.abs())
        });
        let most = forces.chain(walls).filter(|x| x.is_finite()).fold(0.0, f64::max);
        if most > 0.0 { 1.0 / most } else { 1.0 }
    }

    /// (q, u) at t = 0 of the periodic motion without impacts, where the forces are linear and damping or
    /// distance from resonance holds it.
    pub(super) fn response(&self) -> Option<Vec<f64>> {
        let equation = self.flow.equation();
        let (damping, stiffness, mean) = (equation.damping, equation.stiffness, equation.forcing.mean());
        let rest = if mean == 0.0 { 0.0 } else { mean / stiffness };
        let motion = equation.forcing.harmonics().iter().fold([rest, 0.0], |[q, u], harmonic| {
            let k = f64::from(harmonic.k);
            let [re, im] = divide([harmonic.cos, -harmonic.sin], [stiffness - k * k, damping * k]);
            [q + re, u - k * im]
        });
        (equation.is_linear() && motion.iter().all(|x| x.is_finite())).then(|| motion.to_vec())
    }

    /// The system and the rates of its coefficients, where the forces are linear, as keys or as a formula.
    pub fn linear(&self) -> Option<[System<f64>; 2]> {
        let (equation, slope) = (self.flow.equation(), self.slope.as_ref()?);
        if !equation.is_linear() || slope.cubic != 0.0 || slope.smooth.is_some() {
            return None;
        }
        let of = |series: &Series, k: u32| {
            let known = series.harmonics().iter().find(|known| known.k == k);
            known.map_or(Harmonic { k, cos: 0.0, sin: 0.0 }, Clone::clone)
        };
        let both = equation.forcing.harmonics().iter().chain(slope.forcing.harmonics());
        let ks: BTreeSet<u32> = both.map(|known| known.k).collect();
        let keys = |damping: f64, stiffness: f64, forcing: &Series| System {
            damping,
            stiffness,
            cubic: 0.0,
            force: forcing.mean(),
            forcing: ks.iter().map(|&k| of(forcing, k)).collect(),
            smooth: None,
            ..self.system.clone()
        };
        let [lower, upper] = slope.walls.each_ref().map(|wall| {
            let (place, restitution) = wall.as_ref()?;
            Some(Wall {
                offset: place.mean(),
                harmonics: place.harmonics().to_vec(),
                restitution: *restitution,
            })
        });
        let rates = keys(slope.damping, slope.stiffness, &slope.forcing);
        Some([
            keys(equation.damping, equation.stiffness, &equation.forcing),
            System { lower, upper, ..rates },
        ])
    }

    /// The motion without walls.
    pub fn flow(&self) -> &Free {
        &self.flow
    }

    /// The walls, lower before upper.
    pub fn walls(&self) -> &[Contact] {
        &self.walls
    }

    /// The wall on a side at time t.
    ///
    /// # Errors
    /// An input error if there is no such wall.
    pub(crate) fn touch(&self, side: Side, t: f64) -> Result<Touch<'_>> {
        let wall = self.walls.iter().find(|wall| wall.side == side).ok_or_else(|| {
            Error::input(format!("an impact at the {} wall, but there is no such wall", side.name()))
        })?;
        let slope =
            self.slope.as_ref().and_then(|slope| slope.walls[usize::from(side == Side::Upper)].as_ref());
        let [place, speed, _] = slope.map_or([0.0; 3], |slope| slope.0.at(t));
        Ok(Touch {
            wall,
            motion: wall.position.at(t),
            slope: [place, speed],
            restitution_slope: slope.map_or(0.0, |slope| slope.1),
        })
    }

    /// τ of a wall; 0 if it is not there.
    pub(super) fn restitution(&self, side: Side) -> f64 {
        self.walls.iter().find(|wall| wall.side == side).map_or(0.0, |wall| wall.restitution)
    }

    /// The motion from a state for a time ≥ 0.
    pub fn leg(&self, from: State, duration: f64) -> Leg {
        match self.slope.as_ref().filter(|slope| slope.moves()) {
            None => {
                let (end, matrix) = self.flow.advance_linearised(from, duration);
                Leg { end, matrix, slope: [0.0; 2] }
            }
            Some(Slope { smooth: Some(program), .. }) if let Some(taylor) = self.flow.by_program() => {
                let start = [Gradient::variable(from.q, 1), Gradient::variable(from.u, 2)];
                let [q, u] = taylor.carry(program, start, from.t, duration);
                let end = State { t: from.t + duration, q: q.0[0], u: u.0[0] };
                Leg { end, matrix: [[q.0[1], q.0[2]], [u.0[1], u.0[2]]], slope: [q.0[3], u.0[3]] }
            }
            Some(slope) => self.sensitive_leg(slope, from, duration),
        }
    }

    fn panels(&self, from: &State, duration: f64) -> f64 {
        (duration * self.rate(from)).ceil().max(1.0)
    }

    /// Where and why a leg cannot be followed, if that is before its end.
    pub(crate) fn obstacle(&self, from: State, duration: f64) -> Option<(State, Obstacle)> {
        let moves = self.slope.as_ref().is_some_and(|slope| slope.smooth.is_none() && slope.moves());
        let steep = moves && too_many(self.panels(&from, duration) as u64, duration);
        if steep { Some((from, Obstacle::Steep)) } else { self.flow.obstacle(from, duration) }
    }

    /// Duhamel's integral ∫ Φ(T, s) (0, ∂a/∂p)ᵀ ds by Gauss's rule on panels short against every period in
    /// the system, summed on the way: exact to rounding.
    fn sensitive_leg(&self, slope: &Slope, from: State, duration: f64) -> Leg {
        let panels = self.panels(&from, duration);
        if too_many(panels as u64, duration) {
            let end = State { t: from.t + duration, q: f64::NAN, u: f64::NAN };
            return Leg { end, matrix: IDENTITY, slope: [f64::NAN; 2] };
        }
        let width = duration / panels;
        let (mut here, mut matrix, mut sum, mut at) = (from, IDENTITY, [0.0; 2], 0.0);
        let mut go = |to: f64, weight: f64| {
            let (next, step) = self.flow.advance_linearised(here, to - at);
            (here, at) = (next, to);
            matrix = product(&step, &matrix);
            sum = apply(&step, sum);
            sum[1] += weight * slope.acceleration(&here);
        };
        for panel in 0..panels as u32 {
            for (node, weight) in GAUSS {
                go(width * (f64::from(panel) + node), width * weight);
            }
        }
        go(duration, 0.0);
        Leg { end: here, matrix, slope: sum }
    }

    /// The fastest rate in a motion from a state: of any harmonic, of the damping, of the vibration, whose
    /// stiffness is taken where the oscillator is and as far as its velocity would carry it on the cubic
    /// spring alone. With any other force, of the Taylor series there: a step is about 1.5 over its rate.
    pub(super) fn rate(&self, from: &State) -> f64 {
        self.rate.unwrap_or_else(|| self.rate_at(from))
    }

    fn rate_at(&self, from: &State) -> f64 {
        let equation = self.flow.equation();
        if let Some(taylor) = self.flow.by_program() {
            return 1.5 / taylor.expand(*from, true, f64::INFINITY).h;
        }
        let (cubic, damping) = (equation.cubic.abs(), equation.damping.abs());
        let stiffness =
            equation.stiffness.abs() + 3.0 * (cubic * from.q * from.q + (2.0 * cubic).sqrt() * from.u.abs());
        stiffness.sqrt().max(damping).max(f64::from(self.order))
    }

    /// How an impact of incoming speed V ≠ 0 passes on a displacement before it: the saltation matrix, and
    /// what the parameter adds, both at a fixed time.
    pub(crate) fn saltation(&self, touch: &Touch<'_>, t: f64, speed: f64) -> (Matrix2, [f64; 2]) {
        let matrix = touch.wall.saltation(&self.flow, touch.leaving(t, -speed));
        let ([place, velocity], factor) = (touch.slope, 1.0 + touch.wall.restitution);
        let kick = touch.restitution_slope * touch.wall.side.sign() * speed;
        (matrix, [factor * place, factor * velocity + kick - matrix[1][0] * place])
    }
}

impl Slope {
    /// Whether the parameter changes the motion between impacts.
    fn moves(&self) -> bool {
        if self.smooth.is_some() {
            return true;
        }
        [self.damping, self.stiffness, self.cubic, self.forcing.mean()].iter().any(|x| *x != 0.0)
            || !self.forcing.harmonics().is_empty()
    }

    /// ∂a/∂p at fixed (t, q, u).
    fn acceleration(&self, &State { t, q, u }: &State) -> f64 {
        if let Some(program) = &self.smooth {
            let [t, q, u] = [t, q, u].map(Gradient::constant);
            return program.at(q, u, t).0[3];
        }
        self.forcing.at(t)[0] - self.damping * u - (self.stiffness + self.cubic * q * q) * q
    }
}

/// A system's equation with the derivatives of its coefficients in the last place.
fn varied(system: &System<f64>, slope: &System<f64>) -> Result<Program<Gradient<4>>> {
    let mut slopes = Vec::new();
    slope.try_map(|x| {
        slopes.push(*x);
        Ok::<(), Error>(())
    })?;
    let mut next = slopes.into_iter();
    let both = system.try_map(|x| {
        let mut all = Gradient::constant(*x);
        all.0[3] = next.next().unwrap_or(0.0);
        Ok::<_, Error>(all)
    })?;
    Program::new(&both)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Harmonic;

    /// A linear system's rate is kept, the others' is that of the state.
    #[test]
    fn a_rate_that_is_kept_is_that_of_every_state() {
        let forcing = vec![Harmonic { k: 3, cos: 0.5, sin: 0.1 }];
        for (damping, stiffness, cubic) in
            [(0.2, 0.04, 0.0), (0.0, 40.0, 0.0), (-7.5, -1e-3, 0.0), (0.1, 1.0, 0.7), (0.0, 0.0, -0.2)]
        {
            let forcing = forcing.clone();
            let (force, smooth, lower, upper) = (0.3, None, None, None);
            let system =
                System { damping, stiffness, cubic, force, forcing, smooth, lower, upper, rate: None };
            let oscillator = Oscillator::new(system, 1e-12).unwrap();
            assert_eq!(oscillator.rate.is_some(), cubic == 0.0);
            for (q, u) in [(0.0, 0.0), (1.0, -2.0), (-1e3, 1e6), (1e-9, 0.5)] {
                let at = State { t: 1.0, q, u };
                assert_eq!(oscillator.rate(&at).to_bits(), oscillator.rate_at(&at).to_bits());
            }
        }
    }
}
