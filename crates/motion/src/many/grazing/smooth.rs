//! The motion without impacts where forces are formulas: Newton's method on one period, then harmonics from
//! samples of it.
//!
//! There may be several such motions. Newton's method begins at the motion that was found last, else at that
//! of the machine linearised at rest, at rest, and at what 300 periods make of rest.

use std::{f64::consts::TAU, sync::Arc};

use crate::{
    error::{Error, Result},
    many::{
        Machine, Periodic, RealMatrix, RealVector, Slope, State,
        algebra::stacked,
        simulate::{Settings, Simulator, Stage},
        smooth::Smooth,
    },
    motion::{
        EffectTally, Time,
        flow::{Gradient, Scalar},
    },
};

/// The motion, its derivative in a parameter, and what carries it.
pub(super) struct Found {
    pub motion: Periodic,
    pub drift: Periodic,
    pub stage: Arc<Stage>,
}

/// Newton steps.
const STEPS: u32 = 40;
/// A Newton step so many times the first leads away: what is integrated there takes longer and longer.
const ASTRAY: f64 = 1000.0;
/// Periods after which a motion from rest has settled, if it settles.
const SETTLED: f64 = 300.0;
/// Samples of a period, at first and at most.
const SAMPLES: [usize; 2] = [64, 2048];
/// What harmonics beyond half of those that the samples tell may be, relative to the largest.
const TAIL: f64 = 1e-13;

/// The motion of a machine whose coefficients change at the rates `slope`, nearest to a state at phase 0; its
/// steps are counted in `tally`.
///
/// # Errors
/// No periodic motion found; one that is not smooth, or of more than 1000 harmonics.
pub(super) fn find(
    machine: &Machine<f64>,
    slope: &Machine<f64>,
    near: Option<&State>,
    tally: Option<&Arc<EffectTally>>,
) -> Result<Found> {
    let bare = Machine { stops: Vec::new(), ..machine.clone() };
    let bare_slope = Machine { stops: Vec::new(), ..slope.clone() };
    let simulator = Simulator::new(&bare, &Settings::default())?.counting_too(tally);
    let (stage, n) = (simulator.free(), machine.size);
    let none = || Error::input("no formula among the forces");
    let smooth = stage.smooth.as_ref().ok_or_else(none)?;
    let still = State { t: 0.0, q: RealVector::zeros(n), u: RealVector::zeros(n) };
    let linear = || simulator.flow().equations().response().ok().map(|motion| motion.state(0.0));
    let settled = || Some(smooth.after(Time::new(0, 0.0), &still, SETTLED * TAU));
    // The cheapest first: each is tried only where those before it led nowhere.
    let starts: [&dyn Fn() -> Option<State>; 4] =
        [&|| near.cloned(), &linear, &|| Some(still.clone()), &settled];
    let found = starts.iter().find_map(|start| newton(&stage, start()?));
    let (state, phi) = found.ok_or_else(|| {
        Error::input("without impacts no periodic motion was found, neither from that of the linearised machine nor from rest")
    })?;
    let formulas = Smooth::new(&bare)?.ok_or_else(none)?;
    let own = formulas.slope(&bare, &bare_slope)?;
    let program = formulas.changing(&stage.equations, (&Slope::new(&bare, &bare_slope)?, &own))?;
    let start = stacked(&state.q, &state.u);
    let fixed = start.iter().map(|x| Gradient::constant(*x)).collect();
    let end = smooth.flow.carried(&program, fixed, 0.0, TAU);
    let change = RealVector::from_fn(2 * n, |i, _| end[i].part(1));
    let drift = (RealMatrix::identity(2 * n, 2 * n) - phi).lu().solve(&change).ok_or_else(|| {
        Error::input("the motion without impacts has a multiplier 1: it does not follow the parameter")
    })?;
    let begin = start.iter().zip(drift.iter()).map(|(x, slope)| Gradient([*x, *slope])).collect();
    let path = smooth.flow.path(&program, begin, TAU);
    let path = path.ok_or_else(|| Error::input("the motion without impacts cannot be followed"))?;
    let mut count = SAMPLES[0];
    loop {
        let samples = path.samples(count, TAU);
        // Harmonics that have not died out where the samples end would be told wrongly: twice as many then.
        let [motion, drift] = [0, 1].map(|part| harmonics(&samples, |x| x.part(part)));
        if let (Some(motion), Some(drift)) = (motion, drift) {
            return Ok(Found { motion, drift, stage });
        }
        count *= 2;
        if count > SAMPLES[1] {
            return Err(Error::input("the motion without impacts has too many harmonics to be followed"));
        }
    }
}

/// The periodic motion near a state at phase 0, and the derivative of the motion over the period.
fn newton(stage: &Stage, mut state: State) -> Option<(State, RealMatrix)> {
    let (smooth, n) = (stage.smooth.as_ref()?, state.q.len());
    let upper = stage.equations.root().transpose();
    let norm = |x: &RealVector| (&upper * x.rows(0, n)).norm().max((&upper * x.rows(n, n)).norm());
    let (mut first, mut last) = (None, f64::INFINITY);
    for _ in 0..STEPS {
        let (end, phi) = smooth.flow.flown(&state, TAU);
        let x = stacked(&state.q, &state.u);
        let off = end - &x;
        if off.iter().chain(phi.iter()).any(|x| !x.is_finite()) {
            return None;
        }
        let change = (RealMatrix::identity(2 * n, 2 * n) - &phi).lu().solve(&off)?;
        let (size, moved) = (norm(&(&x + &change)), norm(&change));
        // Newton's steps square what is left; else rounding has the last word.
        if moved <= 1e-12 * size || moved <= 1e-8 * size && moved >= 0.5 * last {
            return Some((state, phi));
        }
        if moved > ASTRAY * *first.get_or_insert(moved) {
            return None;
        }
        let x = x + change;
        state = State { t: 0.0, q: x.rows(0, n).into_owned(), u: x.rows(n, n).into_owned() };
        last = moved;
    }
    None
}

/// The harmonics of evenly spaced samples; none if there are too few of them.
fn harmonics(samples: &[Vec<Gradient<2>>], part: impl Fn(&Gradient<2>) -> f64) -> Option<Periodic> {
    let (count, n) = (samples.len(), samples[0].len());
    let waves: Vec<(f64, f64)> = (0..count).map(|i| (TAU * i as f64 / count as f64).sin_cos()).collect();
    let amplitude = |k: usize, wave: fn(&(f64, f64)) -> f64| {
        let scale = if k == 0 { 1.0 } else { 2.0 } / count as f64;
        RealVector::from_fn(n, |j, _| {
            let term =
                |(i, sample): (usize, &Vec<Gradient<2>>)| part(&sample[j]) * wave(&waves[i * k % count]);
            samples.iter().enumerate().map(term).sum::<f64>() * scale
        })
    };
    let all: Vec<(RealVector, RealVector)> =
        (0..count / 2).map(|k| (amplitude(k, |wave| wave.1), amplitude(k, |wave| wave.0))).collect();
    // Coordinates may have several units: each for itself.
    let size = |k: usize, j: usize| all[k].0[j].abs().max(all[k].1[j].abs());
    let most: Vec<f64> = (0..n).map(|j| (0..all.len()).map(|k| size(k, j)).fold(0.0, f64::max)).collect();
    let above = |k: usize, part: f64| (0..n).any(|j| size(k, j) > part * most[j]);
    if (count / 4..count / 2).any(|k| above(k, TAIL)) {
        return None;
    }
    let last = (0..count / 4).rev().find(|&k| above(k, 1e-15)).unwrap_or(0);
    let mut motion = Periodic::constant(all[0].0.clone());
    for (k, (cos, sin)) in all.iter().enumerate().take(last + 1).skip(1) {
        motion.add(k as u32, cos, sin);
    }
    Some(motion)
}
