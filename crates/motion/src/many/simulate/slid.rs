//! How far a machine slides where there is dry friction, and how long it sticks.
//!
//! Between two events a velocity keeps its sign, so that the path is the difference of two places. The energy
//! under a stop's force is an integral over each flight, by Gauss's rule on pieces as short as `pushes` takes
//! them; that by a law of the speed by the same rule on each step of the motion.

use std::sync::Arc;

use super::{Stage, pushes};
use crate::{
    many::{Grip, Rub, State, simulate::engine::Run},
    motion::{RunEnd, Time},
};

/// A motion repeats itself where its states a period apart differ by no more than this of their size.
const SAME: f64 = 1e-9;

/// What was slid so far.
pub struct Slid {
    begin: Time,
    from: Time,
    stage: Arc<Stage>,
    /// Where the energy of anything is an integral.
    state: Option<State>,
    /// Where each row is, and the surface but for its constant velocity.
    places: Vec<f64>,
    stuck: Vec<f64>,
    paths: Vec<f64>,
    energies: Vec<f64>,
}

impl Slid {
    /// Nothing yet, from where the run is.
    pub fn new(run: &Run) -> Slid {
        let (now, places) = (run.time(), places(run));
        let none = vec![0.0; places.len()];
        let (stage, state) = (run.stage(), looked_at(run));
        let (stuck, paths) = (none.clone(), none.clone());
        Slid { begin: now, from: now, stage, state, places, stuck, paths, energies: none }
    }

    /// The run has come to its next event, or to where it was asked to stop.
    pub fn flown(&mut self, run: &Run) {
        if self.places.is_empty() {
            return;
        }
        let (now, places) = (run.time(), places(run));
        let duration = now.since(self.from);
        for (j, (rub, grip)) in run.simulator().contacts().rubs().iter().zip(self.stage.grips()).enumerate() {
            match grip {
                Grip::Open => {}
                Grip::Stuck => self.stuck[j] += duration,
                grip => {
                    let path = grip.sign() * (places[j] - self.places[j] - rub.speed * duration);
                    self.paths[j] += path;
                    self.energies[j] += self.work(run, rub, duration);
                }
            }
        }
        (self.from, self.places, self.stage, self.state) = (now, places, run.stage(), looked_at(run));
    }

    /// ∫ F_k |v| dt on the flight of that duration.
    fn work(&self, run: &Run, rub: &Rub, duration: f64) -> f64 {
        let Some(from) = &self.state else { return 0.0 };
        let contacts = run.simulator().contacts();
        if let (Some(law), Some(smooth)) = (&rub.law, &self.stage.smooth) {
            let power = |state: &State| law.at(rub.rate(state)) * rub.rate(state).abs();
            return smooth.integral(self.from, from, duration, power);
        }
        let Some(stop) = rub.stop else { return 0.0 };
        let look = |after: f64| {
            let state = self.stage.after(self.from, from, after);
            let force = self.stage.pressing(contacts, stop, self.from.after(after), &state);
            force * rub.rate(&state).abs()
        };
        let places = pushes::places(&self.stage, duration, false);
        rub.sliding * places.map(|(after, part)| part * look(after)).sum::<f64>()
    }

    /// For each row with friction the part of the time in which it sticks, how far it slid under a normal
    /// force, and of a stop's force, or by a law, the energy that this took.
    pub fn rows(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        let whole = self.from.since(self.begin);
        let part = move |stuck: &f64| if whole > 0.0 { stuck / whole } else { 0.0 };
        // A velocity of rounding may go the other way.
        let all = self.stuck.iter().zip(&self.paths).zip(&self.energies);
        all.map(move |((stuck, path), energy)| (part(stuck), path.max(0.0), energy.max(0.0)))
    }
}

/// The state, where the energy of anything is an integral.
fn looked_at(run: &Run) -> Option<State> {
    let any = run.simulator().contacts().rubs().iter().any(|rub| rub.stop.is_some() || rub.law.is_some());
    any.then(|| State { t: run.time().phase, ..run.state() })
}

/// Where each row is, less the surface but for its constant velocity.
fn places(run: &Run) -> Vec<f64> {
    let (state, t) = (run.state(), run.time().phase);
    let rubs = run.simulator().contacts().rubs().iter();
    rubs.map(|rub| rub.row.dot(&state.q) - rub.motion.at(t)[0]).collect()
}

/// Whether what sticks now does so for ever: none of it lets go in a period more, and after that the state is
/// the same.
pub fn goes_on(run: &mut Run) -> bool {
    let (now, before, stage) = (run.time(), run.state(), run.stage());
    let contacts = run.simulator().contacts();
    let held: Vec<usize> = stage.holds.stuck().map(|j| contacts.rub_row(j)).collect();
    let mut happened = 0u32;
    let end = run.record(Time::new(now.period + 1, now.phase), |event| {
        happened += u32::from(event.place().is_some_and(|place| held.contains(&place)));
    });
    let after = run.state();
    let off = |a: &f64, b: &f64, size: f64| (a - b).abs() <= SAME * size;
    let size = before.q.amax().max(before.u.amax());
    let pairs = before.q.iter().zip(&after.q).chain(before.u.iter().zip(&after.u));
    end == RunEnd::Reached && happened == 0 && pairs.into_iter().all(|(a, b)| off(a, b, size))
}
