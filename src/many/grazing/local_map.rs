//! The local map at a grazing.

use std::f64::consts::{PI, TAU};

use num_rational::BigRational;

use super::free::{FreeMotion, LeastGap};
use crate::{
    error::{Error, Result},
    many::{
        LinearFlow, RealMatrix, RealVector, State,
        algebra::{eigenvalues, stacked},
        pair::Pair,
    },
    pattern::{Entry, Map, Report},
};

/// The local map of the stroboscopic section at the phase of grazing, in coordinates x = (q, q′) less those
/// of the motion, velocities per radian of the forcing.
#[derive(Debug, Clone)]
pub struct LocalMap {
    /// A: ∂(q, q′) after a period by (q, q′) before.
    pub(crate) a: RealMatrix,
    /// B.
    pub(crate) b: RealVector,
    /// C.
    pub(crate) c: RealVector,
    /// e: how fast the least gap opens with the parameter (26).
    pub e: f64,
    /// a_G: the second derivative of the gap there.
    pub acceleration: f64,
    /// How fast the rate of the gap at the phase of grazing changes with the parameter.
    pub rate_drift: f64,
    /// Its derivative in the parameter, at that phase.
    pub drift: State,
    /// det A, without cancellation.
    pub determinant: f64,
    /// The eigenvalues of A, by modulus, the largest first.
    pub(crate) eigenvalues: Vec<(f64, f64)>,
    /// What A is the flow over, 2π, or the mirror of the flow over, π.
    span: f64,
    /// None where forces are formulas.
    flow: Option<LinearFlow>,
    /// Of B, C on the flow's own coordinates.
    own: [RealVector; 2],
}

/// How far entries may be off that were computed in floats.
const ERROR: f64 = 1e-12;

impl LocalMap {
    /// The map at a minimum of a gap that is zero. An a_G that is not positive is for
    /// [`to_map`](Self::to_map) to refuse.
    ///
    /// # Errors
    /// Those of [`LinearFlow::new`]; eigenvalues of A that are not found.
    pub(crate) fn new(motion: &FreeMotion, at: &LeastGap) -> Result<LocalMap> {
        Self::over(motion, at, TAU)
    }

    /// The same over half a period, after which all is mirrored.
    pub(super) fn half(motion: &FreeMotion, at: &LeastGap) -> Result<LocalMap> {
        Self::over(motion, at, PI)
    }

    fn over(motion: &FreeMotion, at: &LeastGap, span: f64) -> Result<LocalMap> {
        let (contact, push) = (&motion.contacts().all()[at.stop], motion.contacts().push(at.stop));
        let n = motion.equations.size();
        let [gap, slope] = &motion.gaps[at.stop];
        let (acceleration, [e, rate_drift, _]) = (gap.at(at.phase)[2], slope.at(at.phase));
        let state = motion.motion().state(at.phase);
        let smooth = motion.stage.as_ref().and_then(|stage| stage.smooth.as_ref());
        // 2n is even: the mirror does not change the determinant.
        let (a, determinant, flow) = match smooth {
            None => {
                let flow = LinearFlow::new(motion.equations.clone())?;
                (flow.transition(span) * mirrors(span), motion.equations.determinant(span), Some(flow))
            }
            Some(smooth) => {
                let a = smooth.transition(&state, span) * mirrors(span);
                (a, smooth.determinant(&state, span), None)
            }
        };
        // A stop that gives way does not turn velocities at once: its map has no square root.
        let factor = if contact.soft.is_some() { 0.0 } else { 1.0 + contact.restitution };
        let kick = (2.0 * acceleration.max(0.0)).sqrt() * factor;
        let change = push * (kick / motion.contacts().mobility(at.stop));
        let zero = RealVector::zeros(n);
        let (b, c) = (stacked(&zero, &change), stacked(&contact.row, &zero));
        Ok(LocalMap {
            own: match &flow {
                Some(flow) => [flow.kick(&change), flow.seen(&contact.row, &zero)],
                None => [b.clone(), c.clone()],
            },
            b,
            c,
            e,
            acceleration,
            rate_drift,
            drift: motion.drift.state(at.phase),
            determinant,
            eigenvalues: eigenvalues(&a, determinant)?,
            a,
            span,
            flow,
        })
    }

    /// A, row by row.
    pub fn a(&self) -> Vec<Vec<f64>> {
        self.a.row_iter().map(|row| row.iter().copied().collect()).collect()
    }

    /// B.
    pub fn b(&self) -> &[f64] {
        self.b.as_slice()
    }

    /// C.
    pub fn c(&self) -> &[f64] {
        self.c.as_slice()
    }

    /// √(2a_G): an impact of size y has the speed V = √(2a_G) y.
    pub(crate) fn speed_scale(&self) -> f64 {
        (2.0 * self.acceleration).sqrt()
    }

    /// γ = A₁₂ (44), of one degree of freedom.
    pub fn gamma(&self) -> Option<f64> {
        (self.b.len() == 2).then(|| self.a[(0, 1)])
    }

    /// The map for the local theory, in the coordinates in which the flow falls apart, so that A is made of
    /// blocks of two and intervals stay narrow in any dimension. Every computed entry is widened by 10⁻¹² of
    /// the largest of its block, more for fast modes and for nearly dependent ones: far more than its error,
    /// but no proof. What is zero by structure stays exactly zero.
    ///
    /// # Errors
    /// An input error if a_G is not positive, and those of [`Map::new`].
    pub fn to_map(&self) -> Result<Map> {
        if self.acceleration.is_nan() || self.acceleration <= 0.0 {
            let message = format!("a_G = {} at the grazing point; it must be positive", self.acceleration);
            return Err(Error::input(message));
        }
        let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("A is not finite"));
        let wide = |x: f64, radius: f64| Entry::between(exact(x - radius)?, exact(x + radius)?);
        let zero = || Entry::from(BigRational::from_integer(0.into()));
        let size = self.b.len();
        let (own, condition, pairs, rates) = match &self.flow {
            Some(flow) => {
                let condition = if flow.condition().is_finite() { flow.condition() } else { 10.0 };
                (flow.matrix(self.span) * mirrors(self.span), condition, flow.pairs(), flow.rates())
            }
            None => (self.a.clone(), 10.0, None, Vec::new()),
        };
        let entry = |i: usize, j: usize| match &pairs {
            Some(_) if i / 2 != j / 2 => Ok(zero()),
            Some(all) if i != j && matches!(all[i / 2], Pair::Two(_)) => Ok(zero()),
            Some(_) => {
                let first = i / 2 * 2;
                let largest = own.view((first, first), (2, 2)).amax();
                // The phase of a fast mode after a period is off by some ε times its rate.
                wide(own[(i, j)], ERROR.max(64.0 * f64::EPSILON * rates[i / 2]) * condition * largest)
            }
            None => wide(own[(i, j)], ERROR * condition * own.amax().max(1.0)),
        };
        let a = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect::<Result<_>>()?;
        let vector = |v: &RealVector| {
            let one = |&x: &f64| if x == 0.0 { Ok(zero()) } else { wide(x, ERROR * condition * x.abs()) };
            v.iter().map(one).collect::<Result<Vec<Entry>>>()
        };
        let [b, c] = &self.own;
        Map::new(a, vector(b)?, vector(c)?, wide(self.e, ERROR * self.e.abs())?, None)
    }

    /// Times t_i and incoming speeds V_i of the impacts of the pattern (n₁, …, n_m) of `report`, which is of
    /// [`to_map`](Self::to_map), at the distance `away` of the parameter from the grazing at phase `phase`:
    /// the leading-order solution (32). Impact i follows n_{i−1} periods after the one before, with speed
    /// √(2a_G) η Y_{i−1}, η = e · `away`, where the rate of the gap is −V on the parabola of curvature a_G
    /// that the gap follows there.
    ///
    /// # Errors
    /// An input error if the report has no solution.
    pub fn start(&self, phase: f64, periods: &[u64], report: &Report, away: f64) -> Result<Vec<f64>> {
        let (n, eta) = (self.b.len() / 2, self.e * away);
        let row = self.c.rows(0, n);
        let mut z = Vec::with_capacity(2 * periods.len());
        for before in report.impacts(periods)? {
            let x = RealVector::from_vec(before.x);
            let mut arriving = self.flow.as_ref().map_or_else(|| x.clone(), |flow| flow.outward(&x));
            for _ in 0..before.periods {
                arriving = &self.a * arriving;
            }
            let speed = self.speed_scale() * eta * before.y;
            let rate = eta * row.dot(&arriving.rows(n, n)) + self.rate_drift * away;
            z.extend([phase - (rate + speed) / self.acceleration, speed]);
        }
        Ok(z)
    }
}

/// 1 for a whole period, −1 for half of one, after which all is mirrored.
fn mirrors(span: f64) -> f64 {
    if span < TAU { -1.0 } else { 1.0 }
}
