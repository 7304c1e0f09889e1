//! What soft stops do along a run: their largest forces, and of every contact the impulse and the energy.
//!
//! Between two events the force of a stop in contact, −kz − cz′, is a smooth function of time. It is looked
//! at at many instants of each flight; about the largest the maximum is found by golden section. What lies
//! between two looks and rises above both more than a parabola does can be missed: the number is the largest
//! force found, not a bound. Impulse and energy are integrals of the force, and of the force times the gap's
//! rate, by Gauss's rule with 8 points on pieces of at most half a radian of the fastest motion.

use std::sync::Arc;

use super::Stage;
use crate::{
    many::{State, simulate::engine::Run},
    motion::{Time, flow::GAUSS},
};

/// Looks in a flight: at least the first, at most the second number.
const LOOKS: [f64; 2] = [8.0, 256.0];
/// Looks in a radian of the fastest motion.
const DENSITY: f64 = 2.0;
/// Steps of golden section: 0.618³⁰ is 5·10⁻⁷, at a maximum a relative error of some 10⁻¹³.
const STEPS: usize = 30;

/// Contact with a soft stop, or all of it so far; zeros where there is none.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Contact {
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
pub(crate) struct Pushes {
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

    /// The run has come to its next event, or to where it was asked to stop. Cost: at most 300 looks, and 16
    /// for each radian of the fastest motion, where a soft stop is in contact; else none.
    pub fn flown(&mut self, run: &Run) {
        let duration = run.time().since(self.from);
        if duration > 0.0 {
            for stop in self.stage.holds.soft.pushing.clone() {
                let peak = self.peak(run, stop, duration);
                let [impulse, energy] = self.taken(run, stop, duration);
                let (now, all) = (&mut self.now[stop], &mut self.all[stop]);
                for one in [&mut *now, &mut *all] {
                    one.peak = one.peak.max(peak);
                    one.impulse += impulse;
                    one.energy += energy;
                }
                now.duration += duration;
                all.duration = all.duration.max(now.duration);
            }
        }
        (self.stage, self.from, self.state) = (run.stage(), run.time(), run.state());
        self.state.t = self.from.phase;
    }

    /// ∫ F dt and −∫ F z′ dt of a stop on the flight of that duration.
    fn taken(&self, run: &Run, stop: usize, duration: f64) -> [f64; 2] {
        let contact = &run.simulator().contacts().all()[stop];
        let Some(soft) = contact.soft else { return [0.0; 2] };
        let fastest = self.stage.flow.rates().into_iter().fold(1.0, f64::max);
        let pieces = (2.0 * fastest * duration).clamp(1.0, LOOKS[1]).ceil();
        let piece = duration / pieces;
        let mut sums = [0.0; 2];
        for i in 0..pieces as u32 {
            for (x, weight) in GAUSS {
                let gap = contact.gap(&self.stage.after(self.from, &self.state, (f64::from(i) + x) * piece));
                let part = weight * piece * soft.force(gap);
                (sums[0], sums[1]) = (sums[0] + part, sums[1] - part * gap[1]);
            }
        }
        sums
    }

    /// The largest force of a stop on the flight of that duration.
    fn peak(&self, run: &Run, stop: usize, duration: f64) -> f64 {
        let contact = &run.simulator().contacts().all()[stop];
        let Some(soft) = contact.soft else { return 0.0 };
        let force = |after: f64| soft.force(contact.gap(&self.stage.after(self.from, &self.state, after)));
        let fastest = self.stage.flow.rates().into_iter().fold(1.0, f64::max);
        let looks = (DENSITY * fastest * duration).clamp(LOOKS[0], LOOKS[1]).ceil();
        let at = |i: f64| duration * (i / looks).clamp(0.0, 1.0);
        let all = (0..=looks as u32).map(|i| (f64::from(i), force(at(f64::from(i)))));
        let (place, mut best) =
            all.fold((0.0, f64::NEG_INFINITY), |best, look| if look.1 > best.1 { look } else { best });
        // Between the neighbours of the largest.
        const SHARE: f64 = 0.618_033_988_749_894_8;
        let (mut low, mut high) = (at(place - 1.0), at(place + 1.0));
        let inner = |low: f64, high: f64| [high - SHARE * (high - low), low + SHARE * (high - low)];
        let mut places = inner(low, high);
        let mut values = places.map(force);
        for _ in 0..STEPS {
            if values[0] < values[1] {
                low = places[0];
                places = [places[1], inner(low, high)[1]];
                values = [values[1], force(places[1])];
            } else {
                high = places[1];
                places = [inner(low, high)[0], places[0]];
                values = [force(places[0]), values[0]];
            }
            best = best.max(values[0]).max(values[1]);
        }
        best
    }
}
