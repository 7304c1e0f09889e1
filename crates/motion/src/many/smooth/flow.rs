//! Motions by a list of operations: steps of a Taylor series whose last terms are below rounding.
//!
//! The length of a step is told by norms in coordinates in which the mass is 1, so that displacements and
//! rotations, and the derivatives that are carried along, each have one unit: with C_k the norm of
//! coefficient k for a step h, the last two are at most 10⁻¹⁵ of the largest of C₀ h⁰, …, C₄ h⁴, and for the
//! velocities without the first. Nothing but the motion itself sets the scale. That the forces along the
//! whole step are near their series is bounded as for one coordinate ([`Program::suited`]).

use std::sync::{Arc, OnceLock};

use crate::{
    many::{LinearEquations, RealMatrix, RealVector, State},
    motion::{
        Effect, EffectTally, RunEnd, Time,
        flow::{Gradient, LEAST, Obstacle, Program, Rows, Scalar, TERMS, defect, too_many},
    },
};

/// The order of the series.
pub(crate) const ORDER: usize = 21;

/// What the last terms are at most, relative to the motion.
const TOLERANCE: f64 = 1e-15;

/// No step is longer than a quarter of the forcing period.
const LONGEST: f64 = std::f64::consts::FRAC_PI_2;

/// Directions whose derivatives are carried at once.
const WIDTH: usize = 4;

/// A machine with smooth forces between events.
#[derive(Debug, Clone)]
pub(crate) struct SmoothFlow {
    size: usize,
    program: Program<f64>,
    varied: Program<Gradient<{ WIDTH + 1 }>>,
    /// Lᵀ.
    metric: RealMatrix,
    /// Where steps are counted.
    tally: Arc<OnceLock<Arc<EffectTally>>>,
}

/// A step from `start`: each coordinate is a polynomial in x, 0 ≤ x ≤ 1, time going on by hx.
#[derive(Debug, Clone)]
pub(crate) struct Leap {
    pub start: Time,
    pub h: f64,
    /// Coefficients of each coordinate.
    pub q: Vec<[f64; TERMS]>,
    /// Those of the outputs, two fewer.
    pub outputs: Vec<[f64; TERMS]>,
    /// What a step means that is too short to go on by.
    pub obstacle: Obstacle,
    /// Steps this short end the motion.
    shortest: f64,
}

/// A step in numbers of any kind.
struct Step<S> {
    h: f64,
    rows: Vec<Vec<S>>,
    outputs: Vec<Vec<S>>,
    obstacle: Obstacle,
}

impl SmoothFlow {
    pub fn new(
        program: Program<f64>,
        varied: Program<Gradient<{ WIDTH + 1 }>>,
        equations: &LinearEquations,
        tally: Arc<OnceLock<Arc<EffectTally>>>,
    ) -> SmoothFlow {
        SmoothFlow { size: equations.size(), program, varied, metric: equations.root().transpose(), tally }
    }

    /// Counts that many steps.
    fn stepped(&self, steps: u64) {
        if let Some(tally) = self.tally.get() {
            tally.add(Effect::Smooth, steps);
        }
    }

    /// Steps this short end a motion that needs them.
    pub fn shortest(&self) -> f64 {
        self.program.shortest()
    }

    /// The step from a state, no longer than `longest`. `given` is a straight force for each output, a value
    /// and a slope by time.
    pub fn leap(&self, start: Time, state: &State, longest: f64, given: &[[f64; 2]]) -> Leap {
        self.stepped(1);
        let shortest = self.shortest();
        let from: Vec<f64> = state.q.iter().chain(state.u.iter()).copied().collect();
        let step = step(&self.program, &self.metric, &from, start.phase, longest, given);
        let padded = |row: &Vec<f64>| {
            let mut all = [0.0; TERMS];
            all[..row.len()].copy_from_slice(row);
            all
        };
        let finite = step.rows.iter().all(|row| row.iter().sum::<f64>().is_finite());
        if !(step.h > 0.0 && finite) {
            // Its terms overflow, or it stands at a pole: as far as it can be told, and no farther.
            let still = |i: usize| {
                let mut all = [0.0; TERMS];
                (all[0], all[1]) = (state.q[i], state.u[i] * shortest);
                all
            };
            let q = (0..self.size).map(still).collect();
            return Leap {
                start,
                h: shortest,
                q,
                outputs: vec![[0.0; TERMS]; step.outputs.len()],
                obstacle: step.obstacle,
                shortest,
            };
        }
        let q = step.rows.iter().map(padded).collect();
        Leap {
            start,
            h: step.h,
            q,
            outputs: step.outputs.iter().map(padded).collect(),
            obstacle: step.obstacle,
            shortest,
        }
    }

    /// All outputs at a state.
    pub fn all_at(&self, t: f64, q: &RealVector, u: &RealVector) -> Vec<f64> {
        let state: Vec<f64> = q.iter().chain(u.iter()).copied().collect();
        self.program.all_at(&state, t)
    }

    /// ∂q″/∂q and ∂q″/∂q′ at a state; none where they are not finite.
    pub fn jacobian(&self, t: f64, q: &RealVector, u: &RealVector) -> Option<[RealMatrix; 2]> {
        let n = self.size;
        let state: Vec<f64> = q.iter().chain(u.iter()).copied().collect();
        let mut all = RealMatrix::zeros(n, 2 * n);
        for first in (0..2 * n).step_by(WIDTH) {
            let bend = self.varied.all_at(&seeded(&state, first), Gradient::constant(t));
            for j in first..(first + WIDTH).min(2 * n) {
                for i in 0..n {
                    all[(i, j)] = bend[i].part(1 + j - first);
                }
            }
        }
        let finite = all.iter().all(|x| x.is_finite());
        finite.then(|| [all.columns(0, n).into_owned(), all.columns(n, n).into_owned()])
    }

    /// An output's derivatives by q, by q′ and by the time, at a state.
    pub fn output_slopes(&self, output: usize, t: f64, q: &RealVector, u: &RealVector) -> (RealVector, f64) {
        let n = self.size;
        let state: Vec<f64> = q.iter().chain(u.iter()).copied().collect();
        let mut all = RealVector::zeros(2 * n);
        for first in (0..2 * n).step_by(WIDTH) {
            let found = self.varied.all_at(&seeded(&state, first), Gradient::constant(t))[output];
            for j in first..(first + WIDTH).min(2 * n) {
                all[j] = found.part(1 + j - first);
            }
        }
        let constant: Vec<_> = state.iter().map(|x| Gradient::constant(*x)).collect();
        let by_time = self.varied.all_at(&constant, Gradient::variable(t, 1))[output].part(1);
        (all, by_time)
    }

    /// (q, q′) after a duration, and its derivatives by (q, q′) before; NaN where the motion cannot be
    /// followed.
    pub fn flown(&self, state: &State, duration: f64) -> (RealVector, RealMatrix) {
        let n = self.size;
        let from: Vec<f64> = state.q.iter().chain(state.u.iter()).copied().collect();
        let (mut now, mut all) = (RealVector::zeros(2 * n), RealMatrix::zeros(2 * n, 2 * n));
        for first in (0..2 * n).step_by(WIDTH) {
            let end = self.carried(&self.varied, seeded(&from, first), state.t, duration);
            for i in 0..2 * n {
                now[i] = end[i].part(0);
                for j in first..(first + WIDTH).min(2 * n) {
                    all[(i, j)] = end[i].part(1 + j - first);
                }
            }
        }
        (now, all)
    }

    /// The same over one step, no longer than `longest`, and how far that goes: as far as the derivatives in
    /// all directions allow. Over no time, as between events of one instant, nothing changes.
    pub fn step_transition(&self, state: &State, longest: f64, given: &[[f64; 2]]) -> (RealMatrix, f64) {
        let n = self.size;
        if longest <= 0.0 {
            return (RealMatrix::identity(2 * n, 2 * n), longest);
        }
        let from: Vec<f64> = state.q.iter().chain(state.u.iter()).copied().collect();
        let (mut all, mut h) = (RealMatrix::zeros(2 * n, 2 * n), longest);
        let mut firsts = (0..2 * n).step_by(WIDTH);
        while let Some(first) = firsts.next() {
            self.stepped(1);
            let step = step(&self.varied, &self.metric, &seeded(&from, first), state.t, h, given);
            if step.h < h && first > 0 {
                // Those before went farther.
                firsts = (0..2 * n).step_by(WIDTH);
            }
            h = step.h;
            for i in 0..n {
                let end = step.end(i);
                for j in first..(first + WIDTH).min(2 * n) {
                    all[(i, j)] = end[0].part(1 + j - first);
                    all[(n + i, j)] = end[1].part(1 + j - first);
                }
            }
        }
        (all, h)
    }

    /// A motion whose numbers carry what they carry, by a program of the same machine.
    pub fn carried<S: Scalar>(&self, program: &Program<S>, from: Vec<S>, t: f64, duration: f64) -> Vec<S> {
        let (end, steps) = carry(program, &self.metric, from, (t, duration), |_| {});
        self.stepped(steps);
        end
    }

    /// The same from phase 0 on, at all times between; none where it cannot be followed.
    pub fn path<S: Scalar>(&self, program: &Program<S>, from: Vec<S>, duration: f64) -> Option<Path<S>> {
        let mut steps = Vec::new();
        let (end, count) = carry(program, &self.metric, from, (0.0, duration), |step| steps.push(step));
        self.stepped(count);
        end.iter().all(|x| x.part(0).is_finite()).then_some(Path(steps))
    }
}

/// A motion from phase 0 on, step by step.
pub(crate) struct Path<S>(Vec<Step<S>>);

impl<S: Scalar> Path<S> {
    /// Its displacements at that many evenly spaced times of a duration, the first at its beginning.
    pub fn samples(&self, count: usize, duration: f64) -> Vec<Vec<S>> {
        let (mut begin, mut steps) = (0.0, self.0.iter().peekable());
        let one = |i: usize| {
            let t = duration * i as f64 / count as f64;
            while let Some(passed) = steps.next_if(|step| begin + step.h < t) {
                begin += passed.h;
            }
            let Some(step) = steps.peek() else { return Vec::new() };
            let x = (t - begin) / step.h;
            let at = |row: &Vec<S>| row.iter().rev().fold(S::constant(0.0), |p, c| p.scaled(x) + *c);
            step.rows.iter().map(at).collect()
        };
        (0..count).map(one).collect()
    }
}

/// A state with the derivatives by some of its entries, from `first` on.
fn seeded(state: &[f64], first: usize) -> Vec<Gradient<{ WIDTH + 1 }>> {
    let one = |(i, value): (usize, &f64)| match i.checked_sub(first) {
        Some(place) if place < WIDTH => Gradient::variable(*value, 1 + place),
        _ => Gradient::constant(*value),
    };
    state.iter().enumerate().map(one).collect()
}

/// The next step, no longer than `longest`.
fn step<S: Scalar>(
    program: &Program<S>,
    metric: &RealMatrix,
    from: &[S],
    t: f64,
    longest: f64,
    given: &[[f64; 2]],
) -> Step<S> {
    let (n, trial) = (metric.nrows(), 0.25);
    let given: Vec<[f64; 2]> = given.iter().map(|[value, slope]| [*value, slope * trial]).collect();
    let rows = program.solve_all(from, S::constant(t), trial, ORDER + 1, &given);
    let mut factor = longest.min(LONGEST) / trial;
    for part in 0..S::PARTS {
        let norm = |k: usize| {
            let column = RealVector::from_fn(n, |j, _| rows.place(j)[k].part(part));
            (metric * column).amax()
        };
        let last = [norm(ORDER), norm(ORDER - 1)];
        if last == [0.0; 2] {
            continue;
        }
        let mut known: Vec<(usize, f64)> = (0..=4).map(|k| (k, norm(k))).collect();
        if known[1..].iter().all(|term| term.1 == 0.0) {
            known.extend((5..ORDER - 4).map(|k| (k, norm(k))));
        }
        for (size, order) in last.into_iter().zip([ORDER, ORDER - 1]) {
            // C_n x^n ≤ tolerance · weight_k C_k x^k for some k.
            let reach = |weight: &dyn Fn(usize) -> f64| {
                let one = |&(k, own): &(usize, f64)| {
                    (TOLERANCE * weight(k) * own / size).powf(1.0 / (order - k) as f64)
                };
                known.iter().map(one).fold(0.0, f64::max)
            };
            if size > 0.0 {
                factor = factor.min(reach(&|_| 1.0)).min(reach(&|k| k as f64 / order as f64));
            }
        }
    }
    let factor = suited(program, metric, &rows, factor);
    let short = trial * factor <= program.shortest();
    let obstacle = if short { program.obstacle(&rows, factor) } else { Obstacle::Escape };
    let scaled = |row: &[S]| {
        let mut power = 1.0;
        let mut one = |coefficient: &S| {
            let scaled = coefficient.scaled(power);
            power *= factor;
            scaled
        };
        row.iter().map(&mut one).collect::<Vec<S>>()
    };
    Step {
        h: trial * factor,
        rows: (0..n).map(|j| scaled(rows.place(j))).collect(),
        outputs: (0..program.outputs()).map(|k| scaled(rows.output(k))).collect(),
        obstacle,
    }
}

/// The part of the trial step, at most `far`, on which all outputs along the step's polynomials are near
/// their series: for the accelerations the defect of the velocities is small beside the velocities that the
/// first terms make, for the forces of stops it is beside what they are added up from and become.
fn suited<S: Scalar>(program: &Program<S>, metric: &RealMatrix, rows: &Rows<S>, far: f64) -> f64 {
    let (n, trial) = (metric.nrows(), rows.trial());
    let norm = |k: usize| (metric * RealVector::from_fn(n, |j, _| rows.place(j)[k].part(0))).amax();
    let allowed = defect(ORDER, TOLERANCE);
    let mut known: Vec<(usize, f64)> = (1..=4).map(|k| (k, norm(k))).collect();
    if known.iter().all(|term| term.1 == 0.0) {
        known.extend((5..ORDER - 4).map(|k| (k, norm(k))));
    }
    let sizes: Vec<f64> = (n..program.outputs()).map(|k| program.size(rows, k)).collect();
    // What x^{order} of a defect may be, at least what is below all floats.
    let goals =
        known.iter().map(|&(k, own)| (ORDER + 1 - k, allowed * (k as f64 * own).max(f64::MIN_POSITIVE)));
    let goals: Vec<(usize, f64)> = goals.collect();
    let longest = |order: usize, goal: f64, defect: f64, most: f64| {
        let whole = most.powi(order as i32) * defect <= goal;
        if whole { most } else { (goal / defect).powf(1.0 / order as f64).min(most) }
    };
    let fits = |all: &[f64], most: f64| {
        // |Lᵀ K| entry by entry: what is infinite times an entry of 0 takes no part.
        let bent = (0..n).map(|i| {
            let row = (0..n).filter(|&j| metric[(i, j)] != 0.0);
            row.map(|j| metric[(i, j)].abs() * all[j]).sum::<f64>()
        });
        let bent = bent.fold(0.0, f64::max) * trial * trial;
        // x² K x^{n−1} ≤ allowed k C_k x^k for some k.
        let mut best = 0.0f64;
        for &(order, goal) in &goals {
            best = best.max(longest(order, goal, bent, most));
            if best >= most {
                break;
            }
        }
        let forces = all[n..].iter().zip(&sizes).enumerate().map(|(k, (defect, size))| {
            // It may begin at 0, and with all that it is added up from: where nothing moves yet.
            let grown = |last: usize| {
                rows.output(n + k)[..=last].iter().rev().fold(0.0, |sum, c| sum * most + c.part(0).abs())
            };
            let grown = || Some(grown(4)).filter(|&size| size > 0.0).unwrap_or_else(|| grown(ORDER - 4));
            let size = match program.watched(n + k) {
                None => size.max(grown()),
                // The defect of the accelerations holds.
                Some(true) => return most,
                Some(false) => grown(),
            };
            longest(ORDER - 1, allowed * size.max(f64::MIN_POSITIVE), *defect, most)
        });
        forces.fold(best, f64::min)
    };
    program.suited(rows, far, LEAST / trial, fits)
}

/// Over a time this short, in radians, a motion is of the second order: what is left out is the cube of it.
const BRIEF: f64 = 1e-11;

/// The end of a motion, and in how many steps, each of which is shown.
fn carry<S: Scalar>(
    program: &Program<S>,
    metric: &RealMatrix,
    mut from: Vec<S>,
    (begin, duration): (f64, f64),
    mut shown: impl FnMut(Step<S>),
) -> (Vec<S>, u64) {
    let (n, mut left, mut t, mut steps) = (metric.nrows(), duration, begin, 0);
    while left > 0.0 {
        steps += 1;
        let step = step(program, metric, &from, t, left, &[]);
        let stuck = step.h.is_nan() || step.h < left.min(BRIEF).min(program.shortest());
        if stuck && left > BRIEF || too_many(steps, duration - left) {
            // With all that it carries.
            return (from.iter().map(|x| x.scaled(f64::NAN)).collect(), steps);
        }
        if stuck {
            // What is left ends at a pole of a derivative, such as that of d^1.5 at d = 0.
            let bend = program.all_at(&from, S::constant(t));
            for j in 0..n {
                from[j] = from[j] + from[n + j].scaled(left);
                from[n + j] = from[n + j] + bend[j].scaled(left);
            }
            return (from, steps);
        }
        for j in 0..n {
            [from[j], from[n + j]] = step.end(j);
        }
        left = if step.h < left { left - step.h } else { 0.0 };
        t = begin + duration - left;
        shown(step);
    }
    (from, steps)
}

impl<S: Scalar> Step<S> {
    /// A coordinate and its velocity at the end.
    fn end(&self, coordinate: usize) -> [S; 2] {
        let (zero, row) = (S::constant(0.0), &self.rows[coordinate]);
        let [q, slope] = row.iter().rev().fold([zero; 2], |[p, slope], c| [p + *c, slope + p]);
        [q, slope.scaled(1.0 / self.h)]
    }
}

impl Leap {
    /// The state at a place; t is the phase.
    pub fn state(&self, x: f64) -> State {
        let n = self.q.len();
        let at =
            |row: &[f64; TERMS]| row.iter().rev().fold([0.0; 2], |[p, slope], c| [p * x + c, slope * x + p]);
        let all: Vec<[f64; 2]> = self.q.iter().map(at).collect();
        State {
            t: self.time(x).phase,
            q: RealVector::from_fn(n, |i, _| all[i][0]),
            u: RealVector::from_fn(n, |i, _| all[i][1] / self.h),
        }
    }

    /// The time of a place.
    pub fn time(&self, x: f64) -> Time {
        self.start.after(self.h * x)
    }

    /// Why the motion cannot go on from here, if it cannot.
    pub fn over(&self) -> Option<RunEnd> {
        let size: f64 = self.q.iter().map(|row| row[0].abs()).sum();
        let short = self.h <= self.shortest;
        let over = size.is_nan() || size > 1e100 || short;
        over.then_some(if short { self.obstacle.into() } else { RunEnd::Escaped })
    }
}
