//! The largest forces with which soft stops push along a run.
//!
//! Between two events the force of a stop in contact, −kz − cz′, is a smooth function of time. It is looked
//! at at many instants of each flight; about the largest the maximum is found by golden section. What lies
//! between two looks and rises above both more than a parabola does can be missed: the number is the largest
//! force found, not a bound.

use std::sync::Arc;

use super::Stage;
use crate::{
    many::{State, simulate::engine::Run},
    motion::Time,
};

/// Looks in a flight: at least the first, at most the second number.
const LOOKS: [f64; 2] = [8.0, 256.0];
/// Looks in a radian of the fastest motion.
const DENSITY: f64 = 2.0;
/// Steps of golden section: 0.618³⁰ is 5·10⁻⁷, at a maximum a relative error of some 10⁻¹³.
const STEPS: usize = 30;

/// The largest force of each soft stop so far, in the scene's unit; 0 of those that are not met.
pub(crate) struct PeakForces {
    stage: Arc<Stage>,
    from: Time,
    state: State,
    peaks: Vec<f64>,
}

impl PeakForces {
    /// Nothing yet, from where the run is.
    pub fn new(run: &Run) -> PeakForces {
        let peaks = vec![0.0; run.simulator().contacts().all().len()];
        PeakForces { stage: run.stage(), from: run.time(), state: run.state(), peaks }
    }

    /// Of each stop.
    pub fn peaks(&self) -> &[f64] {
        &self.peaks
    }

    /// The run has come to its next event, or to where it was asked to stop. Cost: at most 300 looks, where a
    /// soft stop is in contact; else none.
    pub fn flown(&mut self, run: &Run) {
        let duration = run.time().since(self.from);
        if duration > 0.0 {
            for stop in self.stage.holds.soft.pushing.clone() {
                let peak = self.peak(run, stop, duration);
                self.peaks[stop] = self.peaks[stop].max(peak);
            }
        }
        (self.stage, self.from, self.state) = (run.stage(), run.time(), run.state());
        self.state.t = self.from.phase;
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
