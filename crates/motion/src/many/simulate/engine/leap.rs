//! The event loop where forces are formulas: step by step.

use std::sync::Arc;

use super::{Found, Run};
use crate::{
    error::Result,
    many::{
        State,
        simulate::{Stage, What},
    },
    motion::{
        Effect, RunEnd, Time,
        flow::MOST_STEPS,
        minimum::{NUDGE, clear, head},
    },
};

impl Run<'_> {
    /// Begins a step of the present stage at a state of the machine; false where it has no steps.
    pub(super) fn leap_from(&mut self, time: Time, state: &State) -> bool {
        let stage = self.stage.clone();
        let Some(smooth) = &stage.smooth else { return false };
        let state = State { t: time.phase, ..state.clone() };
        let state = if stage.outward().is_none() { state } else { stage.kept(&state) };
        self.leap = Some(smooth.leap(time, &state));
        let counts = self.period == time.period && !smooth.is_recorded();
        self.leaps = if counts { self.leaps + 1 } else { 0 };
        (self.from, self.period) = (0.0, time.period);
        true
    }

    /// Looks on until something is to be told (false) or `until` is reached or the run ends (true).
    pub(super) fn look_by_steps(&mut self, until: Time) -> Result<bool> {
        let stage = self.stage.clone();
        loop {
            let Some(leap) = &self.leap else { return Ok(true) };
            let reach = until.since(leap.start) / leap.h;
            if reach < self.from {
                return Ok(true);
            }
            if let Some(end) = leap.over().or((self.leaps > MOST_STEPS).then_some(RunEnd::TooSteep)) {
                self.ended = Some(end);
                return Ok(true);
            }
            let end = reach.min(1.0);
            if let Some(found) = self.first_by_step(&stage, end) {
                if (found.hit.place() - self.from) * self.half() > 10.0 * NUDGE {
                    self.changes = 0;
                }
                self.meet(&stage, found)?;
                if !self.events.is_empty() || self.ended.is_some() || !Arc::ptr_eq(&stage, &self.stage) {
                    return Ok(self.ended.is_some());
                }
            } else if reach <= 1.0 {
                self.from = end.max(self.from);
                return Ok(true);
            } else {
                self.changes = 0;
                let (time, state) = (self.time_at(1.0), self.state_at(1.0));
                self.leap_from(time, &state);
            }
        }
    }

    /// The first hit on the step up to `end`.
    fn first_by_step(&mut self, stage: &Stage, mut end: f64) -> Option<Found> {
        let mut first = None;
        let smooth = stage.smooth.as_ref()?;
        let leap = self.leap.take()?;
        if !stage.watched.is_empty() {
            self.count(Effect::Piece);
        }
        for (watch, what) in stage.watched.iter().enumerate() {
            self.count(what.effect());
            let (polynomial, size) = smooth.polynomial(&leap, watch);
            if clear(head(&polynomial), self.simulator.depth(what)) {
                if let What::Gap(stop) = what {
                    self.open[*stop] = true;
                }
                continue;
            }
            self.count(Effect::Search);
            if let Some(found) = self.first_of((watch, what), &polynomial, size, end) {
                end = found.hit.place();
                first = Some(found);
            }
        }
        self.leap = Some(leap);
        first
    }
}
