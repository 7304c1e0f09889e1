//! The event loop of a machine: the search for the next hit, cell by cell, coarse before fine. What a hit
//! makes of the motion is in `contact`.

mod contact;
mod grips;
mod leap;

use std::sync::Arc;

use super::{
    Event, Simulator,
    holds::{Holds, SoftStops, What},
    stage::Stage,
};
use crate::{
    error::{Error, Result},
    many::{Grip, LinearFlow, State, smooth::Leap},
    motion::{
        Counter, Effect, RunEnd, Share, Time,
        event::Impact,
        minimum::{Gap, Hit, ROUNDING, clear},
    },
};

/// More changes of what is rested on than this at one place would be a loop.
const MOST_CHANGES: u32 = 1000;

/// A motion of a machine under way.
pub struct Run<'a> {
    simulator: &'a Simulator,
    stage: Arc<Stage>,
    period: i64,
    /// The cell of the finest level.
    cell: usize,
    /// The homogeneous motion at the cell's beginning.
    y: Vec<f64>,
    /// Where forces are formulas, the step in place of the cell.
    leap: Option<Leap>,
    /// Steps in the present period.
    leaps: u32,
    /// The place in the cell from which on it is to be looked at, in [−1, 1]; in the step, in [0, 1].
    from: f64,
    /// The level to look at first.
    level: usize,
    /// Whether the gap was above the minimum depth since the last contact, for each stop.
    open: Vec<bool>,
    /// What is to be told.
    events: Vec<Event>,
    impacts: u64,
    ended: Option<RunEnd>,
    /// Changes of the stage without progress.
    changes: u32,
    failure: Option<Error>,
    /// What of friction was met last, or which switch.
    rubbed: Option<What>,
    /// The friction known to have no velocity at the instant of the last hit, whatever rounding says.
    still: Vec<usize>,
    /// When friction began to slide last, and which: it has no velocity then.
    begun: (Time, Vec<usize>),
    /// The period, and how many zeros of switches it had so far.
    pub(super) kinks: (i64, u32),
    counts: Option<Share>,
}

/// A hit on a cell: what was watched, z, z′ and z″ by x, and the rounding error of z.
struct Found {
    watch: usize,
    hit: Hit,
    z: [f64; 3],
    rounding: f64,
}

impl<'a> Run<'a> {
    pub(super) fn new(simulator: &'a Simulator, time: Time, state: State) -> Result<Run<'a>> {
        let soft = SoftStops::of(&simulator.contacts, &state);
        // What has no velocity is decided below.
        let grips = (simulator.sliding(&state).into_iter().zip(simulator.contacts.rubs()))
            .map(|(rate, rub)| match rub.stop {
                Some(stop) if !soft.pushing.contains(&stop) => Grip::Open,
                _ => Grip::of(rate),
            })
            .collect();
        let holds = Holds { soft, grips, ..Holds::default() };
        let stage = simulator.stage(&simulator.decided(holds, None, time, &state)?)?;
        let depth = simulator.settings.minimum_depth;
        let open = simulator.contacts.all().iter().map(|stop| stop.gap(&state)[0] > depth).collect();
        let mut run = Run {
            simulator,
            stage: stage.clone(),
            period: time.period,
            cell: 0,
            y: Vec::new(),
            leap: None,
            leaps: 0,
            from: -1.0,
            level: 0,
            open,
            events: Vec::new(),
            impacts: 0,
            ended: None,
            changes: 0,
            failure: None,
            rubbed: None,
            still: Vec::new(),
            begun: (time, Vec::new()),
            kinks: (time.period, 0),
            counts: simulator.tally.as_ref().map(Share::of),
        };
        run.enter(stage, time, &state);
        let touched = simulator.touched(&state);
        let rates: Vec<f64> = touched.iter().map(|&j| simulator.contacts.all()[j].gap(&state)[1]).collect();
        let arrives = |(&j, rate): (&usize, &f64)| *rate < 0.0 && !run.is_slow(j, time, &state);
        if touched.iter().zip(&rates).any(arrives) {
            run.strike(time, state, &touched, &rates, 0.0)?;
        } else if touched.is_empty() || !run.settle(time, state.clone(), &touched, &[])? {
            run.regrip(time, &state, &[])?;
        }
        // How it begins is nothing that happens.
        let friction = run.simulator.contacts.all().len();
        run.events.retain(|event| event.place().is_none_or(|place| place < friction));
        Ok(run)
    }

    /// On to the next event, no further than `until`. An impact at the initial time comes first of all.
    ///
    /// A stage that cannot be built (dependent stops rested on, motions too fast) ends the run as
    /// [`RunEnd::Escaped`] would; it is reported by [`failure`](Self::failure).
    pub fn next(&mut self, until: Time) -> Event {
        if let Some(event) = self.due(until) {
            return event;
        }
        if let Some(end) = self.ended {
            return Event::End(end);
        }
        if self.impacts >= self.simulator.settings.impact_limit {
            self.ended = Some(RunEnd::ImpactLimit);
            return Event::End(RunEnd::ImpactLimit);
        }
        loop {
            match self.look(until) {
                Ok(true) => return Event::End(self.ended.unwrap_or(RunEnd::Reached)),
                Ok(false) => {}
                Err(error) => {
                    self.failure = Some(error);
                    self.ended = Some(RunEnd::Escaped);
                    return Event::End(RunEnd::Escaped);
                }
            }
            if let Some(event) = self.due(until) {
                return event;
            }
        }
    }

    /// What of friction was met last, or which switch, taken once.
    pub(crate) fn rubbed(&mut self) -> Option<What> {
        self.rubbed.take()
    }

    /// Why the run could not go on, if it ended for that; taken once.
    pub fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }

    /// The earliest event not yet told, if it is due.
    fn due(&mut self, until: Time) -> Option<Event> {
        let time = |event: &Event| event.time().unwrap_or(until);
        let first = (0..self.events.len()).min_by(|&a, &b| {
            time(&self.events[a]).partial_cmp(&time(&self.events[b])).unwrap_or(std::cmp::Ordering::Equal)
        })?;
        (time(&self.events[first]) <= until).then(|| self.events.remove(first))
    }

    /// The other impacts at the instant of one that was told, which are not told any more.
    pub(super) fn others_at(&mut self, time: Time) -> Vec<Impact<usize>> {
        let mut others = Vec::new();
        self.events.retain(|event| match event {
            Event::Impact(impact) if impact.time == time => {
                others.push(*impact);
                false
            }
            _ => true,
        });
        others
    }

    /// What is run.
    pub(in crate::many::simulate) fn simulator(&self) -> &'a Simulator {
        self.simulator
    }

    /// The machine as it rests now.
    pub(crate) fn stage(&self) -> Arc<Stage> {
        self.stage.clone()
    }

    /// Where the run is in time.
    pub fn time(&self) -> Time {
        self.time_at(self.from)
    }

    /// The motion now, after the impact if there is one.
    pub fn state(&self) -> State {
        self.state_at(self.from)
    }

    /// How many impacts there were; of several at one instant each counts.
    pub fn impacts(&self) -> u64 {
        self.impacts
    }

    /// The stops rested on, ascending.
    pub(crate) fn resting(&self) -> &[usize] {
        &self.stage.holds.resting
    }

    /// How it moves at each row with friction.
    pub fn grips(&self) -> Vec<Grip> {
        self.stage.grips()
    }

    /// The flow of the machine as it is in contact now.
    pub(crate) fn flow(&self) -> LinearFlow {
        self.stage.flow.clone()
    }

    /// The soft stops that push, ascending.
    pub fn pushing(&self) -> &[usize] {
        &self.stage.pushing
    }

    /// On to `until`, events unseen.
    pub fn finish(&mut self, until: Time) -> RunEnd {
        self.record(until, |_| {})
    }

    /// On to `until`, each event shown.
    pub fn record(&mut self, until: Time, mut each: impl FnMut(Event)) -> RunEnd {
        loop {
            match self.next(until) {
                Event::End(end) => return end,
                event => each(event),
            }
        }
    }

    /// To be told.
    pub(super) fn push_event(&mut self, event: Event) {
        self.events.push(event);
    }

    #[inline]
    fn count(&mut self, effect: Effect) {
        if let Some(counts) = &mut self.counts {
            counts.count(effect);
        }
    }

    /// Whether what is watched is surely clear of 0 on a cell of a level.
    #[inline]
    fn clear(&mut self, stage: &Stage, level: usize, watch: usize, cell: usize) -> bool {
        let what = stage.watched[watch];
        self.count(what.effect());
        clear(stage.head(level, watch, cell, &self.y), self.simulator.depth(&what))
    }

    /// Radians in a unit of x.
    fn half(&self) -> f64 {
        self.leap.as_ref().map_or_else(|| self.stage.finest().half, |leap| leap.h)
    }

    /// Where the cell begins.
    fn begin(&self) -> f64 {
        (2 * self.cell) as f64 * self.half()
    }

    fn time_at(&self, x: f64) -> Time {
        if let Some(leap) = &self.leap {
            return leap.time(x);
        }
        Time::new(self.period, (2 * self.cell + 1) as f64 * self.half() + x * self.half())
    }

    pub(super) fn state_at(&self, x: f64) -> State {
        if let Some(leap) = &self.leap {
            return leap.state(x);
        }
        let mut y = self.stage.vector(&self.y);
        let after = (1.0 + x) * self.half();
        self.stage.flow.advance(&mut y, after);
        self.stage.join(self.begin() + after, &y)
    }

    /// Sets the cursor at a state of the machine.
    fn enter(&mut self, stage: Arc<Stage>, time: Time, state: &State) {
        self.stage = stage;
        if self.leap_from(time, state) {
            return;
        }
        let cell = ((time.phase / (2.0 * self.half())) as usize).min(self.stage.cells() - 1);
        (self.period, self.cell) = (time.period, cell);
        let after = (time.phase - self.begin()).max(0.0);
        let mut y = self.stage.split(&State { t: time.phase, ..state.clone() });
        self.stage.flow.advance(&mut y, -after);
        self.y = self.stage.padded(&y);
        self.from = (after / self.half() - 1.0).clamp(-1.0, 1.0);
        self.level = self.stage.levels.len() - 1;
    }

    fn escaped(&self) -> bool {
        let size: f64 = self.y.iter().map(|y| y.abs()).sum();
        size.is_nan() || size > 1e100
    }

    /// Looks on until something is to be told (false) or `until` is reached or the run ends (true).
    fn look(&mut self, until: Time) -> Result<bool> {
        let stage = self.stage.clone();
        if stage.smooth.is_some() {
            return self.look_by_steps(until);
        }
        if stage.watched.is_empty() {
            self.fly(until);
            return Ok(true);
        }
        let width = 2.0 * self.half();
        let last = ((until.phase / width) as usize).min(stage.cells() - 1);
        let place = (until.phase - (2 * last + 1) as f64 * self.half()) / self.half();
        let finest = stage.levels.len() - 1;
        loop {
            if (self.period, self.cell) > (until.period, last) {
                return Ok(true);
            }
            // Stretches of many cells begin where a cell does.
            if self.from == -1.0 && self.level < finest && self.skip(&stage, (until.period, last)) {
                if self.ended.is_some() {
                    return Ok(true);
                }
                continue;
            }
            let here = (self.period, self.cell) == (until.period, last);
            let end = if here { place.min(1.0) } else { 1.0 };
            if end < self.from {
                return Ok(true);
            }
            if let Some(found) = self.first(&stage, end) {
                self.meet(&stage, found)?;
                if !self.events.is_empty() || self.ended.is_some() || !Arc::ptr_eq(&stage, &self.stage) {
                    return Ok(self.ended.is_some());
                }
            } else if here {
                self.from = end.max(self.from);
                return Ok(true);
            } else {
                // A cell without an event: what happened at one place is over, and larger stretches may be
                // clear again.
                self.changes = 0;
                self.level = finest.saturating_sub(1);
                self.turn(&stage, finest, 1);
                if self.ended.is_some() {
                    return Ok(true);
                }
            }
        }
    }

    /// Passes over the largest stretch of cells from here on that is surely clear of everything; false if
    /// there is none before `goal`.
    fn skip(&mut self, stage: &Stage, goal: (i64, usize)) -> bool {
        let finest = stage.levels.len() - 1;
        // A coarser one where this begins it.
        if self.level > 0 && self.cell.is_multiple_of(1 << (finest - self.level + 1)) {
            self.level -= 1;
        }
        while self.level < finest {
            let cells = 1usize << (finest - self.level);
            let aligned = self.cell.is_multiple_of(cells);
            let before = self.period < goal.0 || self.cell + cells <= goal.1;
            if aligned && before {
                let at = self.cell / cells;
                let level = self.level;
                self.count(Effect::Piece);
                if (0..stage.watched.len()).all(|watch| self.clear(stage, level, watch, at)) {
                    self.opened(stage);
                    self.changes = 0;
                    self.turn(stage, self.level, cells);
                    return true;
                }
            }
            self.level += 1;
        }
        false
    }

    fn opened(&mut self, stage: &Stage) {
        for what in &stage.watched {
            if let What::Gap(stop) = what {
                self.open[*stop] = true;
            }
        }
    }

    fn turn(&mut self, stage: &Stage, level: usize, cells: usize) {
        stage.turn(level, &mut self.y);
        self.from = -1.0;
        self.cell += cells;
        if self.cell == stage.cells() {
            (self.cell, self.period) = (0, self.period + 1);
            for (y, step) in self.y.iter_mut().zip(stage.flow.step()) {
                *y += step;
            }
        }
        if self.escaped() {
            self.ended = Some(RunEnd::Escaped);
        }
    }

    /// Straight to `until`, as nothing is in the way.
    fn fly(&mut self, until: Time) {
        if until < self.time() {
            return;
        }
        let (time, stage) = (self.time(), self.stage.clone());
        let mut y = stage.vector(&self.y);
        let start = (1.0 + self.from) * self.half();
        let step = stage.flow.step();
        if step.iter().all(|x| *x == 0.0) {
            stage.flow.advance(&mut y, start + until.since(time));
        } else {
            let mut left = start;
            let mut now = Time { period: time.period, phase: time.phase };
            while now.period < until.period && y.amax() <= 1e100 {
                stage.flow.advance(&mut y, left + std::f64::consts::TAU - now.phase);
                y += step;
                (now, left) = (Time { period: now.period + 1, phase: 0.0 }, 0.0);
            }
            stage.flow.advance(&mut y, left + until.since(now));
        }
        (self.period, self.cell) =
            (until.period, ((until.phase / (2.0 * self.half())) as usize).min(stage.cells() - 1));
        let after = (until.phase - self.begin()).max(0.0);
        stage.flow.advance(&mut y, -after);
        self.y = stage.padded(&y);
        self.from = (after / self.half() - 1.0).clamp(-1.0, 1.0);
        if self.escaped() {
            self.ended = Some(RunEnd::Escaped);
        }
    }

    /// The first hit on the cell up to `end`.
    fn first(&mut self, stage: &Stage, mut end: f64) -> Option<Found> {
        let mut first = None;
        let finest = stage.levels.len() - 1;
        self.count(Effect::Piece);
        for (watch, what) in stage.watched.iter().enumerate() {
            if self.clear(stage, finest, watch, self.cell) {
                if let What::Gap(stop) = what {
                    self.open[*stop] = true;
                }
                continue;
            }
            self.count(Effect::Search);
            let (polynomial, size) = stage.polynomial(watch, self.cell, &self.y);
            if let Some(found) = self.first_of((watch, what), &polynomial, size, end) {
                end = found.hit.place();
                first = Some(found);
            }
        }
        first
    }

    /// The first hit up to `end` of what is watched, given as a polynomial of a size.
    fn first_of(
        &mut self,
        (watch, what): (usize, &What),
        polynomial: &[f64],
        size: f64,
        end: f64,
    ) -> Option<Found> {
        let rounding = ROUNDING * size;
        let open = match what {
            What::Gap(stop) => self.open[*stop],
            _ => false,
        };
        let depth = self.simulator.depth(what);
        let mut gap = Gap::new(polynomial, depth.max(rounding), open);
        let hit = gap.first(self.from, end);
        if let What::Gap(stop) = what {
            self.open[*stop] = gap.open;
        }
        hit.map(|hit| Found { watch, hit, z: gap.at(hit.place()), rounding })
    }
}
