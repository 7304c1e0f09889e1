//! In which order an orbit slides and sticks, and where what sticks at its beginning is.

use std::f64::consts::TAU;

use super::StopEquations;
use crate::{
    error::Result,
    many::{Grip, RealVector, State, simulate::Simulator},
    motion::{RunEnd, Time},
};

/// A row that is this slow, as a part of what its velocity is added up from, may be one that sticks, of which
/// Newton's method has moved the velocity.
const NEAR: f64 = 1e-3;

/// An impact is not felt along a row whose coupling with the stop is less than this part of what it can be.
const APART: f64 = 1e-13;

/// How a row with friction moves, one after the other, and how long.
pub(super) type Parts = Vec<(Grip, f64)>;

impl StopEquations<'_> {
    /// X, the times and the speeds of unknowns. What sticks where an orbit begins has the surface's velocity;
    /// Newton's method may have moved that, and the machine would slide. So of rows that are slow, what would
    /// slide is begun with the surface's velocity, if it sticks then and where it comes back; and the
    /// equations, which ask for the velocity there to be that of X, bring it to 0.
    pub fn begun(&self, z: &[f64]) -> Result<(State, Vec<f64>, Vec<f64>)> {
        let (state, times, speeds) = self.split(z);
        let Some(simulator) = self.between.rough() else { return Ok((state, times, speeds)) };
        let rates = simulator.rub_rates(&state);
        // The machine as a whole may be at rest.
        let moved = |j: usize| {
            let whole: f64 = simulator.contacts().rubs()[j].row.iter().map(|w| w.abs() * self.scale).sum();
            whole.max(rates[j][1])
        };
        let slow: Vec<usize> = (0..rates.len()).filter(|&j| rates[j][0].abs() <= NEAR * moved(j)).collect();
        let still = simulator.sliding(&state);
        if slow.iter().all(|&j| still[j] == 0.0) {
            return Ok((state, times, speeds));
        }
        let contacts = simulator.contacts();
        let rows: Vec<usize> = slow.iter().map(|&j| contacts.rub_row(j)).collect();
        let Some(inverse) = contacts.among(&rows).try_inverse() else { return Ok((state, times, speeds)) };
        let off = RealVector::from_iterator(slow.len(), slow.iter().map(|&j| -rates[j][0]));
        let mut held = state.clone();
        held.u += contacts.change(&rows, (inverse * off).as_slice());
        if self.comes_back(simulator, &held, &slow) {
            Ok((held, times, speeds))
        } else {
            Ok((state, times, speeds))
        }
    }

    /// Whether these rows stick at a state and, an orbit gone round, where it comes back.
    fn comes_back(&self, simulator: &Simulator, held: &State, rubs: &[usize]) -> bool {
        let begin = Time::new(0, held.t);
        let Ok(mut run) = simulator.start(begin, held.q.as_slice(), held.u.as_slice()) else { return false };
        let sticks = |grips: &[Grip]| rubs.iter().all(|&j| grips[j] == Grip::Stuck);
        if !sticks(&run.grips()) {
            return false;
        }
        match self.pattern.strikes().first() {
            None => {
                let until = begin.after(TAU * f64::from(self.pattern.periods()));
                run.finish(until) == RunEnd::Reached && sticks(&run.grips())
            }
            // It stuck before the impact, too, if that is not felt there.
            Some(strike) => {
                let contacts = simulator.contacts();
                let felt = |&j: &usize| {
                    let row = contacts.rub_row(j);
                    let most = (contacts.mobility(row) * contacts.mobility(strike.place)).sqrt();
                    contacts.coupled(row, strike.place).abs() > APART * most
                };
                !rubs.iter().any(felt)
            }
        }
    }

    /// Where a row sticks all the time, its place comes back whatever it is: in the equation that says so,
    /// the place is asked for.
    pub(super) fn pin(&self, first: &State, (residual, jacobian): (&mut [f64], &mut [Vec<f64>])) {
        let n = self.size();
        let begin = residual.len() - 2 * n;
        for &(j, place) in self.pins {
            let (row, number) = (&self.contacts.rubs()[j].row, self.contacts.rub_row(j));
            let push = self.contacts.push(number) / self.contacts.mobility(number);
            let off = (row.dot(&first.q) - place) / self.scale;
            for k in 0..n {
                residual[begin + k] += push[k] * off;
                (0..n).for_each(|i| jacobian[begin + k][i] += push[k] * row[i]);
            }
        }
    }

    /// How each row with friction moves where the orbit begins.
    pub fn begins(&self, z: &[f64]) -> Result<Vec<Grip>> {
        let Some(simulator) = self.between.rough() else { return Ok(Vec::new()) };
        let (state, ..) = self.begun(z)?;
        let run = simulator.start(Time::new(0, state.t), state.q.as_slice(), state.u.as_slice())?;
        Ok(run.grips())
    }

    /// How each row with friction moves on the orbit, one after the other, and how long; and how many
    /// directions are lost where the most sticks.
    pub fn parts(&self, z: &[f64]) -> Result<(Vec<Parts>, usize)> {
        if self.between.rough().is_none() {
            return Ok((Vec::new(), 0));
        }
        let mut lost = 0;
        let (mut state, times, speeds) = self.begun(z)?;
        let (m, mut all) = (times.len(), Vec::<Parts>::new());
        for leg in 0..m.max(1) {
            let duration = match m {
                0 => TAU * f64::from(self.pattern.periods()),
                _ => self.duration(&times, leg)?,
            };
            let (pieces, end) = self.between.pieces(&state, duration)?;
            for piece in &pieces {
                let Some(stage) = &piece.stage else { continue };
                all.resize(stage.holds.grips.len(), Vec::new());
                lost = lost.max(2 * self.size() - stage.rank());
                for (row, grip) in all.iter_mut().zip(stage.grips()) {
                    row.push((grip, piece.duration));
                }
            }
            if m > 0 {
                let next = (leg + 1) % m;
                state = State { t: super::turned(times[next]), ..end };
                state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            }
        }
        Ok((all, lost))
    }
}

/// What is this short, in radians, may be rounding's: where a row lets go with F_s = F_k its velocity begins
/// with the square of the time, and is caught again while it is within the minimum depth.
const BRIEF: f64 = 1e-4;

/// Slid in less than this, in radians, is rounding's.
const MOMENT: f64 = 1e-3;

/// What is as short as times are rounded takes no time: it may be decided twice at one instant.
const INSTANT: f64 = 1e-13;

/// The rows that stick all the time, or all but so short a time that Newton's method cannot tell: at the ends
/// of the stretch of places at which they can, what is slid is the fourth power of that time.
pub(super) fn held(parts: &[Parts]) -> Vec<usize> {
    let slides = |row: &Parts| -> f64 {
        row.iter().filter(|part| part.0 != Grip::Stuck).map(|part| part.1).sum::<f64>()
    };
    (0..parts.len()).filter(|&j| slides(&parts[j]) < MOMENT).collect()
}

/// The order of parts, with how long each takes, on a circle: parts that are the same are one, and where one
/// changes to another back and forth at one instant, it changes once.
pub(super) fn told(mut parts: Parts) -> Vec<Grip> {
    if parts.iter().any(|part| part.1 > INSTANT) {
        parts.retain(|part| part.1 > INSTANT);
    }
    loop {
        let n = parts.len();
        let next = |i: usize| (i + 1) % n;
        if let Some(i) = (0..n).find(|&i| n > 1 && parts[i].0 == parts[next(i)].0) {
            let (gone, j) = (parts[i].1, next(i));
            parts[j].1 += gone;
            parts.remove(i);
            continue;
        }
        let brief = |i: usize| parts[i % n].1 < BRIEF;
        let same = |i: usize, j: usize| parts[i % n].0 == parts[j % n].0;
        let twice = |i: usize| brief(i + 1) && brief(i + 2) && same(i, i + 2) && same(i + 1, i + 3);
        let Some(i) = (0..n).find(|&i| n > 3 && twice(i)) else {
            return parts.into_iter().map(|part| part.0).collect();
        };
        let gone = [(i + 1) % n, (i + 2) % n];
        let mut at = 0;
        parts.retain(|_| {
            at += 1;
            !gone.contains(&(at - 1))
        });
    }
}
