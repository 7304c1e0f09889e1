//! How far a machine slides where there is dry friction, and how long it sticks.
//!
//! Between two events a velocity keeps its sign, so that the path is the difference of two places.

use crate::{
    many::{Grip, simulate::engine::Run},
    motion::{RunEnd, Time},
};

/// A motion repeats itself where its states a period apart differ by no more than this of their size.
const SAME: f64 = 1e-9;

/// What was slid so far.
pub(crate) struct Slid {
    begin: Time,
    from: Time,
    grips: Vec<Grip>,
    /// Where each row is, and the surface but for its constant velocity.
    places: Vec<f64>,
    stuck: Vec<f64>,
    paths: Vec<f64>,
}

impl Slid {
    /// Nothing yet, from where the run is.
    pub fn new(run: &Run) -> Slid {
        let (now, places) = (run.time(), places(run));
        let none = vec![0.0; places.len()];
        Slid { begin: now, from: now, grips: run.grips().to_vec(), places, stuck: none.clone(), paths: none }
    }

    /// The run has come to its next event, or to where it was asked to stop.
    pub fn flown(&mut self, run: &Run) {
        if self.places.is_empty() {
            return;
        }
        let (now, places) = (run.time(), places(run));
        let duration = now.since(self.from);
        for (j, rub) in run.simulator().contacts().rubs().iter().enumerate() {
            match self.grips[j] {
                Grip::Stuck => self.stuck[j] += duration,
                grip => self.paths[j] += grip.sign() * (places[j] - self.places[j] - rub.speed * duration),
            }
        }
        (self.from, self.places, self.grips) = (now, places, run.grips().to_vec());
    }

    /// For each row with friction the part of the time in which it sticks, and how far it slid.
    pub fn rows(&self) -> impl Iterator<Item = (f64, f64)> {
        let whole = self.from.since(self.begin);
        let part = move |stuck: &f64| if whole > 0.0 { stuck / whole } else { 0.0 };
        // A velocity of rounding may go the other way.
        self.stuck.iter().zip(&self.paths).map(move |(stuck, path)| (part(stuck), path.max(0.0)))
    }
}

/// Where each row is, less the surface but for its constant velocity.
fn places(run: &Run) -> Vec<f64> {
    let (state, t) = (run.state(), run.time().phase);
    let rubs = run.simulator().contacts().rubs().iter();
    rubs.map(|rub| rub.row.dot(&state.q) - rub.motion.at(t)[0]).collect()
}

/// Whether what sticks now does so for ever: none of it lets go in a period more, and after that the state is
/// the same.
pub(crate) fn goes_on(run: &mut Run) -> bool {
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
