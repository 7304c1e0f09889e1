//! What soft stops do along a run: their largest forces, and of every contact the impulse and the energy.
//!
//! Between two events the force of a stop in contact, −kz − cz′, is a smooth function of time. Each flight is
//! cut into pieces, and the force is looked at where Gauss's rule with 8 points does in each, and at both
//! ends. Impulse and energy are the integrals, of the force and of the force times the gap's rate, by that
//! rule; about the largest force the maximum is found by golden section and a parabola. What lies between two
//! looks and rises above both more than a parabola does can be missed, and what moves faster than the looks:
//! these are numbers found, not bounds.

use std::{cell::RefCell, sync::Arc};

use super::Stage;
use crate::{
    many::{State, simulate::engine::Run},
    motion::{Time, flow::GAUSS},
};

/// Radians of the fastest motion in a piece: for twice the rate, that of an energy, the rule errs by some
/// 10⁻¹⁰ of what moves so fast.
const PIECE: f64 = 3.0;
/// Pieces of a flight: at least the first, at most the second number.
const PIECES: [f64; 2] = [2.0, 28.0];
/// Pieces of a flight with the force of a formula.
const BENT: f64 = 8.0;
/// Steps of golden section: the parabola through what is left errs by some 10⁻¹² of the force.
const STEPS: usize = 14;

/// Contact with a soft stop, or all of it so far; zeros where there is none.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Contact {
    /// How long it pushed, in radians of the forcing.
    pub duration: f64,
    /// The largest force, in the scene's unit.
    pub peak: f64,
    /// The integral of the force over the time, a radian of the forcing being its unit.
    pub impulse: f64,
    /// The energy that the contact takes from the motion: that of its damper, and what the spring keeps where
    /// it lets go before it is open.
    pub energy: f64,
}

/// What each soft stop did so far.
pub struct Pushes {
    stage: Arc<Stage>,
    from: Time,
    state: State,
    now: Vec<Contact>,
    all: Vec<Contact>,
}

impl Pushes {
    /// Nothing yet, from where the run is.
    pub fn new(run: &Run) -> Pushes {
        let none = vec![Contact::default(); run.simulator().contacts().all().len()];
        Pushes { stage: run.stage(), from: run.time(), state: run.state(), now: none.clone(), all: none }
    }

    /// Of each stop, in all; the duration is that of the longest contact.
    pub fn all(&self) -> &[Contact] {
        &self.all
    }

    /// The contact with a stop that has just ended, or begins; from here on another one.
    pub fn ended(&mut self, stop: usize) -> Contact {
        std::mem::take(&mut self.now[stop])
    }

    /// The run has come to its next event, or to where it was asked to stop. Cost: at most 242 looks, and for
    /// short contacts some 35, where a soft stop is in contact; else none.
    pub fn flown(&mut self, run: &Run) {
        let duration = run.time().since(self.from);
        if duration > 0.0 {
            for stop in self.stage.pushing.clone() {
                let flight = self.flight(run, stop, duration);
                let (now, all) = (&mut self.now[stop], &mut self.all[stop]);
                for one in [&mut *now, &mut *all] {
                    one.peak = one.peak.max(flight.peak);
                    one.impulse += flight.impulse;
                    one.energy += flight.energy;
                }
                now.duration += duration;
                all.duration = all.duration.max(now.duration);
            }
        }
        (self.stage, self.from, self.state) = (run.stage(), run.time(), run.state());
        self.state.t = self.from.phase;
    }

    /// Contact with a stop on the flight of that duration.
    fn flight(&self, run: &Run, stop: usize, duration: f64) -> Contact {
        let contact = &run.simulator().contacts().all()[stop];
        let mut found = Contact { duration, ..Contact::default() };
        // By a law's steps the way from the beginning is long: looks go on from the one before.
        let last = RefCell::new(contact.force.as_ref().map(|_| (0.0, self.state.clone())));
        let look = |after: f64| {
            if contact.force.is_none() {
                let gap = contact.gap(&self.stage.after(self.from, &self.state, after));
                return [contact.push_at(gap), gap[1]];
            }
            let known = last.borrow_mut().take().filter(|(known, _)| *known <= after);
            let (known, state) = known.unwrap_or_else(|| (0.0, self.state.clone()));
            let state = self.stage.after(self.from.after(known), &state, after - known);
            let gap = contact.gap(&state);
            *last.borrow_mut() = Some((after, state));
            [contact.push_at(gap), gap[1]]
        };
        let fastest = self.stage.flow.rates().into_iter().fold(1.0, f64::max);
        let pieces = (fastest * duration / PIECE).clamp(PIECES[0], PIECES[1]).ceil();
        let piece = duration / pieces;
        let mut looks = vec![(0.0, look(0.0)[0])];
        // A formula's force may begin and end as a power that is not whole: s ↦ s²(3 − 2s) makes it smooth.
        let (pieces, bent) = if contact.force.is_some() { (BENT, true) } else { (pieces, false) };
        for i in 0..pieces as u32 {
            for (x, weight) in GAUSS {
                let s = (f64::from(i) + x) / pieces;
                let (after, part) = if bent {
                    (duration * s * s * (3.0 - 2.0 * s), weight * duration / pieces * 6.0 * s * (1.0 - s))
                } else {
                    ((f64::from(i) + x) * piece, weight * piece)
                };
                let [force, rate] = look(after);
                let part = part * force;
                (found.impulse, found.energy) = (found.impulse + part, found.energy - part * rate);
                looks.push((after, force));
            }
        }
        looks.push((duration, look(duration)[0]));
        found.peak = largest(&looks, |after| look(after)[0]);
        found
    }
}

/// The largest value of a smooth function that is known at these places, ascending, about the largest of
/// them.
fn largest(looks: &[(f64, f64)], of: impl Fn(f64) -> f64) -> f64 {
    let best = (0..looks.len()).max_by(|&a, &b| looks[a].1.total_cmp(&looks[b].1)).unwrap_or(0);
    const SHARE: f64 = 0.618_033_988_749_894_8;
    let (mut low, mut high) = (looks[best.saturating_sub(1)], looks[(best + 1).min(looks.len() - 1)]);
    let inner = |low: f64, high: f64| [high - SHARE * (high - low), low + SHARE * (high - low)];
    let at = |x: f64| (x, of(x));
    let mut inside = inner(low.0, high.0).map(at);
    for _ in 0..STEPS {
        if inside[0].1 < inside[1].1 {
            low = inside[0];
            inside = [inside[1], at(inner(low.0, high.0)[1])];
        } else {
            high = inside[1];
            inside = [at(inner(low.0, high.0)[0]), inside[0]];
        }
    }
    let most =
        [looks[best], low, high, inside[0], inside[1]].iter().fold(0.0, |most: f64, one| most.max(one.1));
    // The parabola through three of them, as steep on one side as on the other of its top.
    let [(a, fa), (b, fb), (c, fc)] =
        if inside[0].1 < inside[1].1 { [inside[0], inside[1], high] } else { [low, inside[0], inside[1]] };
    let (left, right) = ((fb - fa) / (b - a), (fc - fb) / (c - b));
    let bend = (right - left) / (c - a);
    let top = b - 0.5 * (left * (c - b) + right * (b - a)) / ((c - a) * bend);
    if bend < 0.0 && (a..=c).contains(&top) { most.max(fb - bend * (top - b) * (top - b)) } else { most }
}
