//! The flow by Taylor series of any order with a tolerance: for cubic stiffness, for any smooth force, and to
//! compare with the closed form.
//!
//! The equation is polynomial in q, q′ and sines of t, so that its Taylor coefficients follow from one
//! another by sums of products; those of any other smooth force do so by a [`Program`]. A step's polynomial
//! *is* the dense output, as good inside the step as at its end, and a polynomial is what the search for
//! impacts can bound from below on whole intervals; the interpolants of Runge–Kutta codes are of lower order
//! than their steps and have no such bound. Hence no integrator crate here.

use std::{f64::consts::TAU, sync::Arc};

use super::{
    Equation, Gradient, Scalar,
    program::{harmonic, linear, radii, suited},
};
use crate::{
    error::{Error, Result},
    motion::{
        Effect, EffectTally, Flow, Harmonic, State, System,
        algebra::{Matrix2, product},
        flow::program::{Obstacle, Program},
    },
};

/// Room for the coefficients of a piece.
pub(crate) const TERMS: usize = 24;

/// Steps this short end a motion that needs them: towards a pole or beyond all bounds.
pub(crate) const SHORTEST: f64 = 1e-9 * TAU;

/// A force that takes more steps to go on through a forcing period is too steep: a stiffness of 10⁹ times the
/// square of the forcing's frequency does.
pub(crate) const MOST_STEPS: u32 = 100_000;

/// Whether so many steps are too many to have gone on by this.
pub(crate) fn too_many(steps: u64, gone: f64) -> bool {
    steps as f64 > f64::from(MOST_STEPS) * (1.0 + gone.abs() / TAU)
}

/// No step is longer than a quarter of the forcing period.
const LONGEST: f64 = std::f64::consts::FRAC_PI_2;

/// Gauss–Legendre with 8 points on [0, 1]: (node, weight).
pub(crate) const GAUSS: [(f64, f64); 8] = {
    let half = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_27),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
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

/// Steps shorter than this are given as 0.
pub(crate) const LEAST: f64 = 1e-12;

/// The part of a tolerance that may bound the defect of a step times its length, by an estimate that is far
/// from sharp.
pub(crate) fn defect(order: usize, tolerance: f64) -> f64 {
    order as f64 * tolerance.powf(0.75)
}

/// Adaptive Taylor series: order N from the tolerance, step such that the last two terms of q and of q′ stay
/// under it, and such that the force along the whole step is near its series.
#[derive(Debug, Clone)]
pub struct Taylor {
    recurrence: Recurrence,
    tolerance: f64,
    order: usize,
    /// How much larger than the tolerance the bound of the defect may be.
    looser: f64,
    tally: Option<Arc<EffectTally>>,
}

/// A step: q(t + hx) and its derivatives by initial q and u, x ∈ [0, 1].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Expansion {
    pub h: f64,
    pub q: [f64; TERMS],
    /// What a step means that is too short to go on by.
    pub obstacle: Obstacle,
}

impl Taylor {
    /// `tolerance`, from 1e-3 to 1e-15, bounds the last terms kept of each step's series, relative to |q| +
    /// |u| or, if it is larger, to one of the terms before; the estimated local error is a seventh of it. No
    /// unit of length enters. A step costs O(N²) for a cubic term, else O(N) per harmonic, N ≈ 3 −
    /// ln(tolerance)/2.
    ///
    /// # Errors
    /// A tolerance outside its range, a coefficient that is not finite.
    pub(crate) fn new(system: &System<f64>, tolerance: f64) -> Result<Self> {
        Taylor::of(Equation::new(system)?, tolerance)
    }

    /// The flow of an equation.
    pub(crate) fn of(equation: Equation, tolerance: f64) -> Result<Self> {
        if !(1e-15..=1e-3).contains(&tolerance) {
            return Err(Error::input(format!("tolerance = {tolerance} is not between 1e-15 and 1e-3")));
        }
        let order = (3.0 - tolerance.ln() / 2.0).ceil() as usize;
        let recurrence = Recurrence(equation);
        let order = order.min(TERMS - 1);
        Ok(Taylor { recurrence, tolerance, order, looser: defect(order, tolerance) / tolerance, tally: None })
    }

    /// The same flow, the steps of its motions added up in `tally`; but not those of `expand`, which are for
    /// its caller to count.
    #[must_use]
    pub(crate) fn counting(self, tally: Arc<EffectTally>) -> Self {
        Taylor { tally: Some(tally), ..self }
    }

    /// What entered that many steps.
    fn count(&self, steps: u64) {
        let Some(tally) = &self.tally else { return };
        let equation = self.equation();
        let force = if equation.smooth.is_some() { Effect::Smooth } else { Effect::Cubic };
        if !equation.is_linear() {
            tally.add(force, steps);
        }
        if equation.is_driven() {
            tally.add(Effect::Drive, steps);
        }
    }

    pub(crate) fn equation(&self) -> &Equation {
        &self.recurrence.0
    }

    /// The next step, no longer than `longest` > 0, backwards if `forward` is false.
    pub(crate) fn expand(&self, from: State, forward: bool, longest: f64) -> Expansion {
        if let Some(smooth) = &self.equation().smooth {
            let step = self.step(&smooth.program, [from.q, from.u], from.t, forward, longest);
            let mut q = [0.0; TERMS];
            q[..=self.order].copy_from_slice(&step.q);
            return Expansion { h: step.h, q, obstacle: step.obstacle };
        }
        let trial = if forward { 0.25 } else { -0.25 };
        let mut q = [0.0; TERMS];
        let n = self.order;
        let squares = self.recurrence.expand(from, trial, &mut q[..=n]);
        debug_assert!(squares.len() == TERMS);
        let size = Size::of(|i| q[i], trial.abs(), n);
        let far = size.reach(self.tolerance, longest.min(LONGEST) / trial.abs());
        let factor = self.suited(&q[..=n], trial.abs(), far, self.tolerance * size.at(far));
        let mut power = 1.0;
        for coefficient in &mut q[..=n] {
            *coefficient *= power;
            power *= factor;
        }
        Expansion { h: trial * factor, q, obstacle: Obstacle::Escape }
    }

    /// The part of the trial step, at most `far`, on which the cubic force along a polynomial is near its
    /// series.
    fn suited(&self, q: &[f64], trial: f64, far: f64, goal: f64) -> f64 {
        let Equation { damping, stiffness, cubic, ref forcing, .. } = *self.equation();
        let n = self.order;
        let far = far.min(n as f64 / (2.0 * trial * f64::from(forcing.order())));
        let [place, rate] = linear([q[n - 1], q[n]], far, trial, n);
        let driven = |h: &Harmonic<f64>| harmonic(h.cos.hypot(h.sin), f64::from(h.k) * trial, n);
        let known = stiffness.abs() * place
            + damping.abs() * rate
            + forcing.harmonics().iter().map(driven).sum::<f64>();
        let bounds = |radius: f64, all: &mut [f64]| {
            let ([r, _], a) = (radii(q.iter().copied(), radius), q[0].abs());
            all[0] = cubic.abs() * r * (3.0 * a * (a + r) + r * r);
        };
        let fits = |all: &[f64], most: f64| self.fits(goal, trial * all[0], most);
        suited(n, [far, LEAST / trial], (&[known], &mut [0.0]), bounds, fits)
    }

    /// The longest step x of at most `most` with x^n `defect` ≤ n tolerance^{3/4} times the motion's size,
    /// `goal` being the same but for n and the power of the tolerance.
    fn fits(&self, goal: f64, defect: f64, most: f64) -> f64 {
        let goal = self.looser * goal;
        if most.powi(self.order as i32) * defect <= goal {
            return most;
        }
        (goal / defect).powf(1.0 / self.order as f64).min(most)
    }

    /// The same by a program, in numbers of any kind; a step suits all their parts.
    fn step<S: Scalar>(
        &self,
        program: &Program<S>,
        from: [S; 2],
        t: f64,
        forward: bool,
        longest: f64,
    ) -> Step<S> {
        let trial = if forward { 0.25 } else { -0.25 };
        let n = self.order;
        let rows = program.solve(from, S::constant(t), trial, n + 1);
        let mut factor = longest.min(LONGEST) / trial.abs();
        let size = |part: usize| Size::of(|i| rows.q()[i].part(part), trial.abs(), n);
        for part in 0..S::PARTS {
            factor = size(part).reach(self.tolerance, factor);
        }
        let goal = self.tolerance * size(0).at(factor);
        let fits = |defect: &[f64], most: f64| self.fits(goal, trial.abs() * defect[0], most);
        let factor = program.suited(&rows, factor, LEAST / trial.abs(), fits);
        let short = trial.abs() * factor <= SHORTEST;
        let obstacle = if short { program.obstacle(&rows, factor) } else { Obstacle::Escape };
        let (mut q, mut power) = (rows.into_q(), 1.0);
        for coefficient in &mut q {
            *coefficient = coefficient.scaled(power);
            power *= factor;
        }
        Step { h: trial * factor, q, obstacle }
    }

    /// A step by a formula's program, no longer than `longest`, with its derivative and its length.
    pub(crate) fn step_linearised(&self, from: State, longest: f64) -> Option<(State, Matrix2, f64)> {
        let smooth = self.equation().smooth.as_ref()?;
        let start = [Gradient::variable(from.q, 1), Gradient::variable(from.u, 2)];
        let step = self.step(&smooth.varied, start, from.t, true, longest);
        let (end, matrix) = linearised(step.end(), from.t + step.h);
        Some((end, matrix, step.h))
    }

    /// A motion by a program, the numbers carrying what they carry; NaN where it cannot be followed.
    pub(crate) fn carry<S: Scalar>(
        &self,
        program: &Program<S>,
        [mut q, mut u]: [S; 2],
        from: f64,
        duration: f64,
    ) -> [S; 2] {
        let (mut left, mut t, mut steps) = (duration, from, 0);
        while left != 0.0 {
            steps += 1;
            let step = self.step(program, [q, u], t, left > 0.0, left.abs());
            if is_stuck(step.h, left) || too_many(steps, duration - left) {
                return [S::constant(f64::NAN); 2];
            }
            [q, u] = step.end();
            left = if step.h.abs() < left.abs() { left - step.h } else { 0.0 };
            t = from + duration - left;
        }
        self.count(steps);
        [q, u]
    }

    /// ∫ ∂q″/∂q′ dt along a motion, by Gauss's rule on each step; NaN where it cannot be followed.
    pub(crate) fn divergence(&self, from: State, duration: f64) -> f64 {
        let mut sum = 0.0;
        let end = self.steps(from, duration, |from, step| {
            for (x, weight) in GAUSS {
                let [q, slope] = value(&step.q, x);
                let at = State { t: from.t + step.h * x, q, u: slope / step.h };
                sum += step.h * weight * self.equation().divergence(at);
            }
        });
        sum + 0.0 * end.q
    }

    /// Where a motion cannot be followed any farther, and why, if that is before its end.
    pub(crate) fn obstacle(&self, mut from: State, duration: f64) -> Option<(State, Obstacle)> {
        let (mut left, mut steps) = (duration, 0);
        while left > 0.0 {
            steps += 1;
            if too_many(steps, duration - left) {
                return Some((from, Obstacle::Steep));
            }
            let step = self.expand(from, true, left);
            if is_stuck(step.h, left) {
                return Some((from, step.obstacle));
            }
            let [q, slope] = value(&step.q, 1.0);
            left = if step.h < left { left - step.h } else { 0.0 };
            from = State { t: from.t + step.h, q, u: slope / step.h };
        }
        None
    }

    fn steps(&self, mut from: State, duration: f64, mut each: impl FnMut(State, &Expansion)) -> State {
        let end = from.t + duration;
        let (mut left, mut steps) = (duration, 0);
        while left != 0.0 {
            steps += 1;
            let step = self.expand(from, left > 0.0, left.abs());
            if is_stuck(step.h, left) || too_many(steps, duration - left) {
                return State { t: end, q: f64::NAN, u: f64::NAN };
            }
            each(from, &step);
            let [q, slope] = value(&step.q, 1.0);
            left = if step.h.abs() < left.abs() { left - step.h } else { 0.0 };
            from = State { t: end - left, q, u: slope / step.h };
        }
        self.count(steps);
        from
    }
}

impl Flow for Taylor {
    fn acceleration(&self, at: State) -> f64 {
        self.equation().acceleration(at)
    }

    fn advance(&self, from: State, duration: f64) -> State {
        self.steps(from, duration, |_, _| {})
    }

    fn advance_linearised(&self, from: State, duration: f64) -> (State, Matrix2) {
        if let Some(smooth) = &self.equation().smooth {
            let start = [Gradient::variable(from.q, 1), Gradient::variable(from.u, 2)];
            return linearised(self.carry(&smooth.varied, start, from.t, duration), from.t + duration);
        }
        let mut total = [[1.0, 0.0], [0.0, 1.0]];
        let n = self.order;
        let end = self.steps(from, duration, |_, step| {
            let column = |q, u| {
                let [dq, slope] = value(&self.recurrence.vary(&step.q[..=n], step.h, q, u), 1.0);
                [dq, slope / step.h]
            };
            let (first, second) = (column(1.0, 0.0), column(0.0, 1.0));
            total = product(&[[first[0], second[0]], [first[1], second[1]]], &total);
        });
        (end, total)
    }
}

/// How large a motion is on a step: |q| + |u| where it begins, or the largest of the terms of its series that
/// follow, at the place x of the trial step. A motion that begins at rest in 0 has those alone.
pub(crate) struct Size {
    start: f64,
    /// |c_k| and k.
    terms: [(f64, i32); 3],
    /// What the last two terms are in q or, i / |h| times as large, in q′, with i.
    last: [(f64, i32); 2],
}

impl Size {
    /// Of a series to order n about the beginning of a trial step.
    pub fn of(coefficient: impl Fn(usize) -> f64, trial: f64, n: usize) -> Size {
        let size = |i: usize| coefficient(i).abs();
        let start = size(0) + size(1) / trial;
        let first = if start == 0.0 { (2..n - 3).find(|k| size(*k) > 0.0).unwrap_or(2) } else { 2 };
        let last = |i: usize| (size(i) * (i as f64 / trial).max(1.0), i as i32);
        // At a pole there are none to compare with.
        let term = |k: usize| (if size(k).is_finite() { size(k) } else { 0.0 }, k as i32);
        let terms = [0, 1, 2].map(|more| term(first + more));
        Size { start, terms, last: [last(n), last(n - 1)] }
    }

    /// At a place of the step.
    fn at(&self, x: f64) -> f64 {
        self.terms.iter().fold(self.start, |most, &(size, k)| most.max(size * x.powi(k)))
    }

    /// The farthest place, but at most `most`, at which the last terms are at most this part of the size. Of
    /// a motion without any size that is seen, the end of the trial step.
    pub fn reach(&self, tolerance: f64, most: f64) -> f64 {
        let nothing = self.start == 0.0 && self.terms.iter().all(|term| term.0 == 0.0);
        if nothing {
            let moves = self.last.iter().any(|last| last.0 > 0.0);
            return if moves { most.min(1.0) } else { most };
        }
        let farthest = |&(size, i): &(f64, i32)| {
            if size == 0.0 {
                return f64::INFINITY;
            }
            let mut x = (tolerance * self.start / size).powf(1.0 / f64::from(i));
            for &(part, k) in &self.terms {
                // Where a term is larger than what x was made from, it allows more.
                if size * x.powi(i) < tolerance * part * x.powi(k) || x == 0.0 {
                    x = x.max((tolerance * part / size).powf(1.0 / f64::from(i - k)));
                }
            }
            x
        };
        self.last.iter().map(farthest).fold(most, f64::min)
    }
}

/// A step in numbers of any kind.
struct Step<S> {
    h: f64,
    q: Vec<S>,
    obstacle: Obstacle,
}

impl<S: Scalar> Step<S> {
    /// q and u at its end.
    fn end(&self) -> [S; 2] {
        let zero = S::constant(0.0);
        let [q, slope] = self.q.iter().rev().fold([zero; 2], |[p, slope], c| [p + *c, slope + p]);
        [q, slope.scaled(1.0 / self.h)]
    }
}

/// A state and its derivative by the state that it came from.
fn linearised([q, u]: [Gradient<3>; 2], t: f64) -> (State, Matrix2) {
    (State { t, q: q.0[0], u: u.0[0] }, [[q.0[1], q.0[2]], [u.0[1], u.0[2]]])
}

/// Whether a step is too short to reach the end, and not the last one.
fn is_stuck(h: f64, left: f64) -> bool {
    h.is_nan() || h.abs() < left.abs().min(1e-11)
}

/// The Taylor coefficients of the equation's solutions.
#[derive(Debug, Clone)]
pub(crate) struct Recurrence(pub(crate) Equation);

impl Recurrence {
    /// Fills `q` with the coefficients of x ↦ q(t + hx) and returns those of its square (zeros without a
    /// cubic term).
    pub fn expand(&self, from: State, h: f64, q: &mut [f64]) -> [f64; TERMS] {
        let Equation { damping, stiffness, cubic, ref forcing, .. } = self.0;
        let mut force = [0.0; TERMS];
        forcing.add_taylor(1.0, from.t, h, &mut force[..q.len() - 2]);
        let mut squares = [0.0; TERMS];
        (q[0], q[1]) = (from.q, h * from.u);
        for i in 0..q.len() - 2 {
            let mut here = force[i] - stiffness * q[i];
            if cubic != 0.0 {
                squares[i] = convolve(q, q, i);
                here -= cubic * convolve(&squares, q, i);
            }
            q[i + 2] = next(here, damping, h, i, q[i + 1]);
        }
        squares
    }

    /// The coefficients of the variation of the solution `q` that starts as (δq, δu).
    pub fn vary(&self, q: &[f64], h: f64, dq: f64, du: f64) -> [f64; TERMS] {
        let Equation { damping, stiffness, cubic, .. } = self.0;
        let (mut variation, mut squares) = ([0.0; TERMS], [0.0; TERMS]);
        (variation[0], variation[1]) = (dq, h * du);
        for i in 0..q.len() - 2 {
            let mut here = -stiffness * variation[i];
            if cubic != 0.0 {
                squares[i] = convolve(q, q, i);
                here -= 3.0 * cubic * convolve(&squares, &variation, i);
            }
            variation[i + 2] = next(here, damping, h, i, variation[i + 1]);
        }
        variation
    }
}

/// Coefficient i + 2 of a solution of q″ = here − damping q′ in x = t/h.
fn next(here: f64, damping: f64, h: f64, i: usize, slope: f64) -> f64 {
    let (i1, i2) = ((i + 1) as f64, (i + 2) as f64);
    h * (h * here - damping * i1 * slope) / (i1 * i2)
}

/// Coefficient i of a product.
fn convolve(a: &[f64], b: &[f64], i: usize) -> f64 {
    a[..=i].iter().zip(b[..=i].iter().rev()).map(|(x, y)| x * y).sum()
}

/// A polynomial and its derivative at x.
fn value(coefficients: &[f64], x: f64) -> [f64; 2] {
    coefficients.iter().rev().fold([0.0; 2], |[p, slope], c| [p * x + c, slope * x + p])
}
