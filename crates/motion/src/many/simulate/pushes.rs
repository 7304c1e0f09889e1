//! What soft stops do along a run: their largest forces, the impulses, and the energy that they take.
//!
//! A stop at depth d = −z pushes with F(d, v), v = −z′ being how fast d grows. At rest there it would push
//! with F(d, 0), and what that does on the way, ∫ F(s, 0) ds from 0 to d, is stored: it is given back. The
//! rest is lost, at the rate (F(d, v) − F(d, 0)) v as long as d > 0: c v² of a damper, 0 without one. Where a
//! stop was let go of before it is open F is 0, and its spring gives what it has stored to its damper. So the
//! losses of the parts of a run add up to that of the whole, wherever it is cut, and they never fall.
//!
//! Between two events all of this is smooth in time. Each flight is cut into pieces, and looked at where
//! Gauss's rule with 8 points does in each, and at both ends. Impulse and loss are integrals by that rule;
//! about the largest force the maximum is found by golden section and a parabola. What lies between two looks
//! and rises above both more than a parabola does can be missed, and what moves faster than the looks: these
//! are numbers found, not bounds.

use std::{cell::RefCell, sync::Arc};

use super::Stage;
use crate::{
    many::{State, contact::StopContact, simulate::engine::Run},
    motion::{Time, flow::GAUSS, minimum::ROUNDING},
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
    /// The energy that is lost: what does not stay stored in the stop. Of a contact, with what the spring
    /// keeps where it lets go before it is open, and without what it had kept where the contact begins so.
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
    pub fn ended(&mut self, stop: usize, contact: &StopContact) -> Contact {
        let kept = kept(contact, &self.state);
        let next = Contact { energy: -kept, ..Contact::default() };
        let ended = std::mem::replace(&mut self.now[stop], next);
        Contact { energy: ended.energy + kept, ..ended }
    }

    /// The run has come to its next event, or to where it was asked to stop. Cost: at most 242 looks, and for
    /// short contacts some 35, where a soft stop is in contact; else none.
    pub fn flown(&mut self, run: &Run) {
        let (duration, state) = (run.time().since(self.from), State { t: run.time().phase, ..run.state() });
        for (stop, contact) in soft(run) {
            let flight = match self.stage.pushing.contains(&stop) {
                true if duration > 0.0 => self.flight(contact, duration),
                true => continue,
                false => Contact {
                    energy: kept(contact, &self.state) - kept(contact, &state),
                    ..Contact::default()
                },
            };
            let (now, all) = (&mut self.now[stop], &mut self.all[stop]);
            for one in [&mut *now, &mut *all] {
                one.peak = one.peak.max(flight.peak);
                one.impulse += flight.impulse;
                one.energy += flight.energy;
            }
            now.duration += flight.duration;
            all.duration = all.duration.max(now.duration);
        }
        (self.stage, self.from, self.state) = (run.stage(), run.time(), state);
    }

    /// Contact with a stop on the flight of that duration.
    fn flight(&self, contact: &StopContact, duration: f64) -> Contact {
        let mut found = Contact { duration, ..Contact::default() };
        // By a law's steps the way from the beginning is long: looks go on from the one before.
        let last = RefCell::new(contact.force.as_ref().map(|_| (0.0, self.state.clone())));
        // The force, and the rate of the loss.
        let seen = |gap: [f64; 2]| {
            let [force, at_rest] = [gap, [gap[0], 0.0]].map(|gap| contact.push_at(gap));
            [force, (at_rest.max(0.0) - force) * gap[1]]
        };
        let look = |after: f64| {
            if contact.force.is_none() {
                return seen(contact.gap(&self.stage.after(self.from, &self.state, after)));
            }
            let known = last.borrow_mut().take().filter(|(known, _)| *known <= after);
            let (known, state) = known.unwrap_or_else(|| (0.0, self.state.clone()));
            let state = self.stage.after(self.from.after(known), &state, after - known);
            let gap = contact.gap(&state);
            *last.borrow_mut() = Some((after, state));
            seen(gap)
        };
        let mut looks = vec![(0.0, look(0.0)[0])];
        for (after, part) in places(&self.stage, duration, contact.force.is_some()) {
            let [force, loss] = look(after);
            (found.impulse, found.energy) = (found.impulse + part * force, found.energy + part * loss);
            looks.push((after, force));
        }
        looks.push((duration, look(duration)[0]));
        found.peak = largest(&looks, |after| look(after)[0]);
        found
    }
}

/// What the spring of a stop has stored; nothing at a depth that is rounding's, as where it opens.
fn kept(contact: &StopContact, state: &State) -> f64 {
    let gap = contact.gap(state)[0];
    let terms: f64 = contact.row.iter().zip(state.q.iter()).map(|(w, q)| (w * q).abs()).sum();
    let rounding = ROUNDING * (terms + contact.position.at(state.t)[0].abs());
    if -gap <= rounding { 0.0 } else { contact.kept(gap) }
}

/// Where Gauss's rule looks on a flight in a stage, and the weights. A formula's force may begin and end as a
/// power that is not whole, and is bent: s ↦ s²(3 − 2s) makes it smooth.
pub(super) fn places(stage: &Stage, duration: f64, bent: bool) -> impl Iterator<Item = (f64, f64)> {
    let fastest = stage.flow.rates().into_iter().fold(1.0, f64::max);
    let pieces = (fastest * duration / PIECE).clamp(PIECES[0], PIECES[1]).ceil();
    let pieces = if bent { BENT } else { pieces };
    let places = (0..pieces as u32).flat_map(move |i| {
        GAUSS.map(|(x, weight)| ((f64::from(i) + x) / pieces, weight * duration / pieces))
    });
    places.map(move |(s, part)| match bent {
        true => (duration * s * s * (3.0 - 2.0 * s), part * 6.0 * s * (1.0 - s)),
        false => (duration * s, part),
    })
}

/// The soft stops with their places.
fn soft<'a>(run: &Run<'a>) -> impl Iterator<Item = (usize, &'a StopContact)> {
    let all = run.simulator().contacts().all().iter().enumerate();
    all.filter(|(_, contact)| contact.soft.is_some())
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
