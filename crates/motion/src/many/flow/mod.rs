//! The motion of a linear system with periodic force in closed form.
//!
//! (q, q′) = S (y + p(t)) with p a particular solution and y homogeneous. In pairs of coordinates y moves by
//! one exponential each; p is the sum of the pairs' responses, of which those near resonance start from rest
//! in every period, so that they stay moderate: y gains `step` when a period ends. A
//! system that does not fall apart is one block; its p starts from rest in every period, and both move by
//! Taylor series of the exponential on steps in which the matrix is at most 1/2 (`block`). `response` has the
//! pairs' responses but those of real modes, which are oscillators with one degree of freedom.

mod block;
mod response;

use std::f64::consts::TAU;

use block::{Force, exponential, forced, moved, rate_of, responses_from_rest};
use response::{Response, real_pair, responses};

use super::{
    LinearEquations, Periodic, RealMatrix, RealVector, State,
    modes::{Reduction, Shape},
    pair::Pair,
};
use crate::{
    error::{Error, Result},
    motion::{Harmonic, Series, System, flow::Linear},
};

/// Most phases of a period at which the response of one block is kept.
const MOST_STARTS: f64 = 65536.0;

/// How a flow is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlowMethod {
    /// Real modes: damping is classical.
    RealModes,
    /// Complex modes.
    ComplexModes,
    /// The matrix exponential: the eigenvectors are too nearly dependent.
    Exponential,
}

impl FlowMethod {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            FlowMethod::RealModes => "real modes",
            FlowMethod::ComplexModes => "complex modes",
            FlowMethod::Exponential => "matrix exponential",
        }
    }
}

/// The solved equations. Error of a motion over a duration: a few units in the last place of its largest
/// terms, times the condition number, times 1 + the fastest rate · duration.
#[derive(Debug, Clone)]
pub struct LinearFlow {
    equations: LinearEquations,
    motion: Motion,
    condition: f64,
    to: RealMatrix,
    from: RealMatrix,
    /// The force on y.
    force: Periodic,
    step: RealVector,
}

#[derive(Debug, Clone)]
enum Motion {
    Real(Vec<(Pair, Linear)>),
    Complex(Vec<(Pair, [Response; 2])>),
    /// A; p at evenly spaced phases from 0.
    Whole(RealMatrix, Vec<RealVector>),
}

impl LinearFlow {
    /// Solves the equations. Cost: O(n³), and for one block O(n²) per radian of its fastest motion.
    ///
    /// # Errors
    /// Modes that are not found, which finite matrices do not bring about in practice.
    pub fn new(equations: LinearEquations) -> Result<LinearFlow> {
        let Reduction { shape, to, from, condition } = Reduction::new(&equations)?;
        let n = equations.size();
        let force = |v: &RealVector| to.columns(n, n) * equations.accelerate(v);
        let given = &equations.force;
        let harmonics = given.harmonics.iter().map(|(k, a, b)| (*k, force(a), force(b))).collect();
        let force = Periodic { mean: force(&given.mean), harmonics };
        let (motion, step) = match shape {
            Shape::Real(pairs) => {
                let modes =
                    pairs.into_iter().enumerate().map(|(i, pair)| Ok((pair, mode(pair, &force, 2 * i + 1)?)));
                let modes = modes.collect::<Result<Vec<_>>>()?;
                let step = modes.iter().flat_map(|(_, mode)| mode.step()).collect::<Vec<_>>();
                (Motion::Real(modes), RealVector::from_vec(step))
            }
            Shape::Complex(pairs) => {
                let both = |(i, pair)| (pair, responses(pair, &force, 2 * i));
                let all: Vec<_> = pairs.into_iter().enumerate().map(both).collect();
                let mut step = RealVector::zeros(2 * n);
                for (i, (pair, two)) in all.iter().enumerate() {
                    step.rows_mut(2 * i, 2)
                        .copy_from_slice(&real_pair(*pair, two.each_ref().map(Response::step)));
                }
                (Motion::Complex(all), step)
            }
            Shape::Whole(a) => {
                let rate = rate_of(&a).max(f64::from(force.order()));
                if rate.is_nan() || TAU * rate > MOST_STARTS {
                    let most = MOST_STARTS / TAU;
                    return Err(Error::input(format!(
                        "the machine has no modes that tell its motions apart, and its fastest motion has up to {rate:.1e} times the \
                         forcing's frequency; by the matrix exponential at most {most:.0} times can be followed: give `damping_ratio` in \
                         place of `damping`, or leave the stiffest parts out"
                    )));
                }
                let count = (TAU * rate).ceil().clamp(8.0, MOST_STARTS) as usize;
                let mut starts = responses_from_rest(&a, &force, count);
                let step = starts.pop().unwrap_or_else(|| RealVector::zeros(2 * n));
                (Motion::Whole(a, starts), step)
            }
        };
        Ok(LinearFlow { equations, motion, condition, to, from, force, step })
    }

    /// What was solved.
    pub(crate) fn equations(&self) -> &LinearEquations {
        &self.equations
    }

    /// How.
    pub fn method(&self) -> FlowMethod {
        match self.motion {
            Motion::Real(_) => FlowMethod::RealModes,
            Motion::Complex(_) => FlowMethod::ComplexModes,
            Motion::Whole(..) => FlowMethod::Exponential,
        }
    }

    /// The condition number of the eigenvectors in coordinates in which those of an undamped system are
    /// orthonormal; 1 for real modes, infinite for a defective system.
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// 2n: the number of coordinates of y.
    pub(crate) fn dimension(&self) -> usize {
        self.to.nrows()
    }

    /// The largest modulus of an eigenvalue of a pair, for one block a bound of its matrix.
    pub fn rates(&self) -> Vec<f64> {
        match &self.motion {
            Motion::Real(all) => all.iter().map(|(_, mode)| mode.rate()).collect(),
            Motion::Complex(all) => all.iter().map(|(pair, _)| pair.rate()).collect(),
            Motion::Whole(a, _) => vec![rate_of(a)],
        }
    }

    /// The pairs that move for themselves; none for one block.
    pub(super) fn pairs(&self) -> Option<Vec<Pair>> {
        match &self.motion {
            Motion::Real(all) => Some(all.iter().map(|known| known.0).collect()),
            Motion::Complex(all) => Some(all.iter().map(|known| known.0).collect()),
            Motion::Whole(..) => None,
        }
    }

    /// Natural frequencies and damping ratios of the modes that oscillate, in multiples of the forcing's
    /// frequency, ascending; none for one block.
    pub fn frequencies(&self) -> Vec<(f64, f64)> {
        let one = |pair: Pair| match pair {
            Pair::Mode { damping, stiffness } if stiffness > 0.0 => {
                Some((stiffness.sqrt(), damping / (2.0 * stiffness.sqrt())))
            }
            // 0 without a sign where nothing damps.
            Pair::Spiral { rate, turn } => Some((rate.hypot(turn), 0.0 - rate / rate.hypot(turn))),
            _ => None,
        };
        let mut all: Vec<(f64, f64)> = self.pairs().unwrap_or_default().into_iter().filter_map(one).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all
    }

    /// A p, 2n entries, at t in [0, 2π].
    pub fn particular(&self, t: f64) -> RealVector {
        match &self.motion {
            Motion::Real(all) => {
                let parts = all.iter().flat_map(|(_, mode)| mode.particular(t));
                RealVector::from_iterator(2 * all.len(), parts)
            }
            Motion::Complex(all) => {
                let parts =
                    all.iter().flat_map(|(pair, two)| real_pair(*pair, two.each_ref().map(|r| r.at(t))));
                RealVector::from_iterator(2 * all.len(), parts)
            }
            Motion::Whole(a, starts) => {
                let width = TAU / starts.len() as f64;
                let i = ((t / width) as usize).min(starts.len() - 1);
                let begin = i as f64 * width;
                forced(a, &self.force, begin, t - begin, &starts[i])
            }
        }
    }

    /// g·p for a functional g on y, in two parts: a series, of the pairs whose p is periodic; and g on the
    /// other pairs alone.
    ///
    /// # Errors
    /// Responses that are not finite.
    pub(super) fn drive(&self, g: &RealVector) -> Result<(Series, RealVector)> {
        let mut rest = g.clone();
        let mut parts: Vec<(f64, Series)> = Vec::new();
        match &self.motion {
            Motion::Real(all) => {
                for (i, (_, mode)) in all.iter().enumerate() {
                    let Some(place) = mode.periodic() else { continue };
                    parts.push((g[2 * i + 1], place.derivative()));
                    parts.push((g[2 * i], place));
                    rest.rows_mut(2 * i, 2).fill(0.0);
                }
            }
            Motion::Complex(all) => {
                for (i, (pair, two)) in all.iter().enumerate() {
                    if !two.iter().all(Response::is_periodic) {
                        continue;
                    }
                    let [first, second] = match pair {
                        Pair::Two(_) => [two[0].series(false)?, two[1].series(false)?],
                        _ => [two[0].series(false)?, two[0].series(true)?],
                    };
                    parts.push((g[2 * i], first));
                    parts.push((g[2 * i + 1], second));
                    rest.rows_mut(2 * i, 2).fill(0.0);
                }
            }
            Motion::Whole(..) => {}
        }
        let parts: Vec<(f64, &Series)> = parts.iter().map(|(factor, series)| (*factor, series)).collect();
        Ok((Series::combination(&parts), rest))
    }

    /// What y gains where a period ends: p(2π) − p(0).
    pub(crate) fn step(&self) -> &RealVector {
        &self.step
    }

    /// y of a state; t in [0, 2π].
    pub fn split(&self, state: &State) -> RealVector {
        let n = self.equations.size();
        self.to.columns(0, n) * &state.q + self.to.columns(n, n) * &state.u - self.particular(state.t)
    }

    /// The state of y at t in [0, 2π].
    pub fn join(&self, t: f64, y: &RealVector) -> State {
        let n = self.equations.size();
        let x = &self.from * (y + self.particular(t));
        State { t, q: x.rows(0, n).into_owned(), u: x.rows(n, n).into_owned() }
    }

    /// The real parts of the eigenvalues with the other sign, ascending: how fast motions decay. For one
    /// block a bound of its matrix in place of each.
    pub(super) fn decays(&self) -> Vec<f64> {
        let of = |pair: Pair| match pair {
            Pair::Mode { damping, stiffness } => {
                let root = (damping * damping / 4.0 - stiffness).max(0.0).sqrt();
                [damping / 2.0 - root, damping / 2.0 + root]
            }
            Pair::Spiral { rate, .. } => [-rate; 2],
            Pair::Two(rates) => rates.map(|rate| -rate),
        };
        let mut all: Vec<f64> = match &self.motion {
            Motion::Whole(a, _) => vec![rate_of(a); a.nrows()],
            _ => self.pairs().unwrap_or_default().into_iter().flat_map(of).collect(),
        };
        all.sort_by(f64::total_cmp);
        all
    }

    /// The change of y of a change of state.
    pub(super) fn inward(&self, q: &RealVector, u: &RealVector) -> RealVector {
        let n = self.equations.size();
        self.to.columns(0, n) * q + self.to.columns(n, n) * u
    }

    /// The change of state (q, q′) of a change of y.
    pub(super) fn outward(&self, y: &RealVector) -> RealVector {
        &self.from * y
    }

    /// (q, q′) by y.
    pub(super) fn from(&self) -> &RealMatrix {
        &self.from
    }

    /// y of a change of velocity.
    pub(crate) fn kick(&self, du: &RealVector) -> RealVector {
        let n = self.equations.size();
        self.to.columns(n, n) * du
    }

    /// The functional a·q + b·q′ on y.
    pub fn seen(&self, a: &RealVector, b: &RealVector) -> RealVector {
        let n = self.equations.size();
        self.from.rows(0, n).tr_mul(a) + self.from.rows(n, n).tr_mul(b)
    }

    /// y after `duration`, which may be negative, within a period.
    pub fn advance(&self, y: &mut RealVector, duration: f64) {
        self.advance_all(std::slice::from_mut(y), duration);
    }

    /// The same of several: the flow of a pair of coordinates is found once.
    pub(crate) fn advance_all(&self, all: &mut [RealVector], duration: f64) {
        let mut pair = |i: usize, matrix: &[[f64; 2]; 2]| all.iter_mut().for_each(|y| apply(matrix, y, i));
        match &self.motion {
            Motion::Real(modes) => {
                for (i, (_, mode)) in modes.iter().enumerate() {
                    pair(i, &mode.matrix(duration));
                }
            }
            Motion::Complex(pairs) => {
                for (i, (at, _)) in pairs.iter().enumerate() {
                    pair(i, &at.matrix(duration));
                }
            }
            Motion::Whole(a, _) => {
                all.iter_mut().for_each(|y| *y = moved(a, duration, y, |a, v| a * v));
            }
        }
    }

    /// g ↦ g E(duration) for a functional g on y.
    pub(super) fn pull(&self, g: &mut RealVector, duration: f64) {
        match &self.motion {
            Motion::Real(all) => {
                for (i, (_, mode)) in all.iter().enumerate() {
                    apply(&transposed(mode.matrix(duration)), g, i);
                }
            }
            Motion::Complex(all) => {
                for (i, (pair, _)) in all.iter().enumerate() {
                    apply(&transposed(pair.matrix(duration)), g, i);
                }
            }
            Motion::Whole(a, _) => *g = moved(a, duration, g, |a, v| a.tr_mul(v)),
        }
    }

    /// E(duration), 2n × 2n.
    pub(crate) fn matrix(&self, duration: f64) -> RealMatrix {
        if let Motion::Whole(a, _) = &self.motion {
            return exponential(a, duration);
        }
        let n = self.dimension();
        let mut all = RealMatrix::identity(n, n);
        for j in 0..n {
            let mut column = all.column(j).into_owned();
            self.advance(&mut column, duration);
            all.set_column(j, &column);
        }
        all
    }

    /// ∂(q, q′) after by (q, q′) before.
    pub fn transition(&self, duration: f64) -> RealMatrix {
        &self.from * self.matrix(duration) * &self.to
    }

    /// A linear map of (q, q′) as one of y.
    pub(super) fn reduced(&self, map: &RealMatrix) -> RealMatrix {
        &self.to * map * &self.from
    }

    /// The state after `duration` > 0, over as many periods as that takes. The phase is brought back to [0,
    /// 2π).
    pub fn after(&self, state: &State, duration: f64) -> State {
        let mut y = self.split(state);
        let (mut t, mut left) = (state.t, duration);
        let plain = self.step.iter().all(|x| *x == 0.0);
        if plain {
            self.advance(&mut y, left);
            let end = t + left;
            return self.join(end - (end / TAU).floor() * TAU, &y);
        }
        while t + left >= TAU {
            self.advance(&mut y, TAU - t);
            y += &self.step;
            (left, t) = (left - (TAU - t), 0.0);
        }
        self.advance(&mut y, left);
        self.join(t + left, &y)
    }

    /// G v with y′ = G y.
    pub(super) fn generate(&self, v: &RealVector) -> RealVector {
        match &self.motion {
            Motion::Real(all) => generated(all.iter().map(|known| known.0.generator()), v),
            Motion::Complex(all) => generated(all.iter().map(|known| known.0.generator()), v),
            Motion::Whole(a, _) => a * v,
        }
    }

    /// g G for a functional g on y.
    pub(super) fn generate_row(&self, g: &RealVector) -> RealVector {
        match &self.motion {
            Motion::Real(all) => generated(all.iter().map(|known| transposed(known.0.generator())), g),
            Motion::Complex(all) => generated(all.iter().map(|known| transposed(known.0.generator())), g),
            Motion::Whole(a, _) => a.tr_mul(g),
        }
    }

    /// The Taylor coefficients of x ↦ p(t + hx).
    pub(super) fn expand(&self, t: f64, h: f64, terms: usize) -> Vec<RealVector> {
        let mut all = vec![self.particular(t)];
        let mut force = Force::new(&self.force, t, h);
        for i in 1..terms {
            let next = (self.generate(&all[i - 1]) + force.next()) * (h / i as f64);
            all.push(next);
        }
        all
    }
}

/// The one-degree oscillator of a mode, the force on which is at this place of y.
fn mode(pair: Pair, force: &Periodic, at: usize) -> Result<Linear> {
    let Pair::Mode { damping, stiffness } = pair else { unreachable!("real modes only") };
    let forcing =
        force.harmonics.iter().map(|(k, a, b)| Harmonic { k: *k, cos: a[at], sin: b[at] }).collect();
    Linear::new(&System { damping, stiffness, force: force.mean[at], forcing, ..System::default() })
}

fn apply(m: &[[f64; 2]; 2], y: &mut RealVector, i: usize) {
    let (a, b) = (y[2 * i], y[2 * i + 1]);
    y[2 * i] = m[0][0] * a + m[0][1] * b;
    y[2 * i + 1] = m[1][0] * a + m[1][1] * b;
}

fn transposed(m: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [[m[0][0], m[1][0]], [m[0][1], m[1][1]]]
}

fn generated(blocks: impl Iterator<Item = [[f64; 2]; 2]>, v: &RealVector) -> RealVector {
    let mut all = v.clone();
    for (i, block) in blocks.enumerate() {
        apply(&block, &mut all, i);
    }
    all
}
