//! The event loop of a machine.

use std::sync::Arc;

use super::{
    MachineEvent, MachineSimulator, StopImpact, StopRelease, StopStick, StopTangency,
    stage::{Stage, What},
};
use crate::{
    error::{Error, Result},
    machine::{MachineState, RealVector},
    oscillator::{
        Counter, Effect, Time,
        simulate::{
            RunEnd, Share,
            search::{Gap, Hit, ROUNDING, clear},
        },
    },
};

/// What rounding may move a place by.
const NUDGE: f64 = 1e-12;

/// More changes of what is rested on than this at one place would be a loop.
const MOST_CHANGES: u32 = 1000;

/// A motion of a machine under way.
pub struct MachineRun<'a> {
    simulator: &'a MachineSimulator,
    stage: Arc<Stage>,
    period: i64,
    /// The cell of the finest level.
    cell: usize,
    /// The homogeneous motion at the cell's beginning.
    y: Vec<f64>,
    /// The place in the cell from which on it is to be looked at, in [−1, 1].
    from: f64,
    /// The level to look at first.
    level: usize,
    /// Whether the gap was above the minimum depth since the last contact, for each stop.
    open: Vec<bool>,
    /// What is to be told.
    events: Vec<MachineEvent>,
    impacts: u64,
    ended: Option<RunEnd>,
    /// Changes of the stage without progress.
    changes: u32,
    failure: Option<Error>,
    counts: Option<Share>,
}

/// A hit on a cell: what was watched, z, z′ and z″ by x, and the rounding error of z.
struct Found {
    watch: usize,
    hit: Hit,
    z: [f64; 3],
    rounding: f64,
}

impl<'a> MachineRun<'a> {
    pub(super) fn new(
        simulator: &'a MachineSimulator,
        time: Time,
        state: MachineState,
    ) -> Result<MachineRun<'a>> {
        let stage = simulator.free.clone();
        let gaps: Vec<[f64; 2]> =
            simulator.contacts.all().iter().map(|contact| contact.gap(&state)).collect();
        let depth = simulator.settings.minimum_depth;
        let mut run = MachineRun {
            simulator,
            stage,
            period: time.period,
            cell: 0,
            y: Vec::new(),
            from: -1.0,
            level: 0,
            open: gaps.iter().map(|[gap, _]| *gap > depth).collect(),
            events: Vec::new(),
            impacts: 0,
            ended: None,
            changes: 0,
            failure: None,
            counts: simulator.tally.as_ref().map(Share::of),
        };
        run.enter(simulator.free.clone(), time, &state);
        let touched: Vec<usize> = (0..gaps.len()).filter(|&j| gaps[j][0] <= depth).collect();
        if touched.iter().any(|&j| gaps[j][1] < 0.0) {
            let rates: Vec<f64> = touched.iter().map(|&j| gaps[j][1]).collect();
            run.strike(time, state, &touched, &rates, 0.0)?;
        } else if !touched.is_empty() {
            run.settle(time, state, &touched, &[])?;
        }
        Ok(run)
    }

    /// On to the next event, no further than `until`. An impact at the initial time comes first of all.
    ///
    /// A stage that cannot be built (dependent stops rested on, motions too fast) ends the run as
    /// [`RunEnd::Escaped`] would; it is reported by [`failure`](Self::failure).
    pub fn next(&mut self, until: Time) -> MachineEvent {
        if let Some(event) = self.due(until) {
            return event;
        }
        if let Some(end) = self.ended {
            return MachineEvent::End(end);
        }
        if self.impacts >= self.simulator.settings.impact_limit {
            self.ended = Some(RunEnd::ImpactLimit);
            return MachineEvent::End(RunEnd::ImpactLimit);
        }
        loop {
            match self.look(until) {
                Ok(true) => return MachineEvent::End(self.ended.unwrap_or(RunEnd::Reached)),
                Ok(false) => {}
                Err(error) => {
                    self.failure = Some(error);
                    self.ended = Some(RunEnd::Escaped);
                    return MachineEvent::End(RunEnd::Escaped);
                }
            }
            if let Some(event) = self.due(until) {
                return event;
            }
        }
    }

    /// Why the run could not go on, if it ended for that; taken once.
    pub fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }

    /// The earliest event not yet told, if it is due.
    fn due(&mut self, until: Time) -> Option<MachineEvent> {
        let time = |event: &MachineEvent| event.time().unwrap_or(until);
        let first = (0..self.events.len()).min_by(|&a, &b| {
            time(&self.events[a]).partial_cmp(&time(&self.events[b])).unwrap_or(std::cmp::Ordering::Equal)
        })?;
        (time(&self.events[first]) <= until).then(|| self.events.remove(first))
    }

    /// The other impacts at the instant of one that was told, which are not told any more.
    pub(super) fn others_at(&mut self, time: Time) -> Vec<StopImpact> {
        let mut others = Vec::new();
        self.events.retain(|event| match event {
            MachineEvent::Impact(impact) if impact.time == time => {
                others.push(*impact);
                false
            }
            _ => true,
        });
        others
    }

    /// What is run.
    pub(super) fn simulator(&self) -> &'a MachineSimulator {
        self.simulator
    }

    /// The machine as it rests now.
    pub(super) fn stage(&self) -> Arc<Stage> {
        self.stage.clone()
    }

    /// Where the run is in time.
    pub fn time(&self) -> Time {
        self.time_at(self.from)
    }

    /// The motion now, after the impact if there is one.
    pub fn state(&self) -> MachineState {
        self.state_at(self.from)
    }

    /// How many impacts there were; of several at one instant each counts.
    pub fn impacts(&self) -> u64 {
        self.impacts
    }

    /// The stops rested on, ascending.
    pub fn resting(&self) -> &[usize] {
        &self.stage.resting
    }

    /// On to `until`, events unseen.
    pub fn finish(&mut self, until: Time) -> RunEnd {
        self.record(until, |_| {})
    }

    /// On to `until`, each event shown.
    pub fn record(&mut self, until: Time, mut each: impl FnMut(MachineEvent)) -> RunEnd {
        loop {
            match self.next(until) {
                MachineEvent::End(end) => return end,
                event => each(event),
            }
        }
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
        self.count(if matches!(what, What::Gap(_)) { Effect::Gap } else { Effect::Force });
        clear(stage.head(level, watch, cell, &self.y), self.simulator.settings.minimum_depth)
    }

    fn half(&self) -> f64 {
        self.stage.finest().half
    }

    /// Where the cell begins.
    fn begin(&self) -> f64 {
        (2 * self.cell) as f64 * self.half()
    }

    fn time_at(&self, x: f64) -> Time {
        Time::new(self.period, (2 * self.cell + 1) as f64 * self.half() + x * self.half())
    }

    fn state_at(&self, x: f64) -> MachineState {
        let mut y = self.stage.vector(&self.y);
        let after = (1.0 + x) * self.half();
        self.stage.flow.advance(&mut y, after);
        self.stage.join(self.begin() + after, &y)
    }

    /// Sets the cursor at a state of the machine.
    fn enter(&mut self, stage: Arc<Stage>, time: Time, state: &MachineState) {
        self.stage = stage;
        let cell = ((time.phase / (2.0 * self.half())) as usize).min(self.stage.cells() - 1);
        (self.period, self.cell) = (time.period, cell);
        let after = (time.phase - self.begin()).max(0.0);
        let mut y = self.stage.split(&MachineState { t: time.phase, ..state.clone() });
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
        let (depth, finest) = (self.simulator.settings.minimum_depth, stage.levels.len() - 1);
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
            let rounding = ROUNDING * size;
            let open = match what {
                What::Gap(stop) => self.open[*stop],
                What::Force(_) => false,
            };
            let mut gap = Gap::new(&polynomial, depth.max(rounding), open);
            let hit = gap.first(self.from, end);
            if let What::Gap(stop) = what {
                self.open[*stop] = gap.open;
            }
            if let Some(hit) = hit {
                end = hit.place();
                first = Some(Found { watch, hit, z: gap.at(end), rounding });
            }
        }
        first
    }

    /// Makes events of a hit.
    fn meet(&mut self, stage: &Stage, Found { watch, hit, z, rounding }: Found) -> Result<()> {
        let (x, half) = (hit.place(), self.half());
        let time = self.time_at(x);
        self.from = x;
        match (stage.watched[watch], hit) {
            (What::Gap(stop), Hit::Tangency(_)) => {
                self.events.push(MachineEvent::Tangency(StopTangency { time, stop, gap: z[0] }));
            }
            (What::Gap(stop), Hit::Press(_)) => {
                let state = self.state_at(x);
                let resting = stage.resting.clone();
                if !self.settle(time, state, &[stop], &resting)? {
                    // The stop presses by no more than rounding: on, and surely not to the same place.
                    self.from = x + NUDGE;
                }
            }
            (What::Gap(stop), Hit::Impact(_)) => {
                // On the wrong side of rounding an impact may seem to leave: it arrives with velocity 0.
                let velocity = (z[1] / half).min(0.0);
                let off = 2.0 * (z[0].abs() + rounding);
                let radius = (off / z[1].abs()).min((off / z[2].abs()).sqrt()) * half;
                self.hit(stage, (x, watch), stop, velocity, z[2] / (half * half), radius)?;
            }
            (What::Force(_), Hit::Tangency(_)) => {}
            (What::Force(stop), Hit::Impact(_) | Hit::Press(_)) => {
                let state = self.state_at(x);
                let resting: Vec<usize> =
                    stage.resting.iter().copied().filter(|&other| other != stop).collect();
                self.events.push(MachineEvent::Release(StopRelease { time, stop }));
                self.rest(time, &state, &resting)?;
            }
        }
        Ok(())
    }

    /// An impact on a stop at x, the gap's rate being `velocity` and its second derivative before it `bend`.
    fn hit(
        &mut self,
        stage: &Stage,
        (x, watch): (f64, usize),
        stop: usize,
        velocity: f64,
        bend: f64,
        radius: f64,
    ) -> Result<()> {
        let (time, simulator) = (self.time_at(x), self.simulator);
        let (depth, mut touched) = (simulator.settings.minimum_depth, vec![stop]);
        let after = (1.0 + x) * self.half();
        let mut y = stage.vector(&self.y);
        let alone = stage.resting.is_empty() && simulator.contacts.all().len() == 1;
        let mut known = None;
        if !alone {
            stage.flow.advance(&mut y, after);
            let state = stage.join(self.begin() + after, &y);
            for (other, contact) in simulator.contacts.all().iter().enumerate() {
                if other != stop && !stage.resting.contains(&other) && contact.gap(&state)[0] <= depth {
                    touched.push(other);
                }
            }
            known = Some(state);
        }
        if touched.len() > 1 || !stage.resting.is_empty() {
            let state = known.unwrap_or_else(|| self.state_at(x));
            let rate =
                |&j: &usize| if j == stop { velocity } else { simulator.contacts.all()[j].gap(&state)[1] };
            let rates: Vec<f64> = touched.iter().map(rate).collect();
            return self.strike(time, state, &touched, &rates, radius);
        }
        // One stop alone: the motion is kicked where it is.
        let law = simulator.contacts.impact(&[stop], &[velocity])?;
        let mut kick = stage.flow.kick(&law.change);
        stage.flow.advance(&mut kick, -after);
        let kick = stage.padded(&kick);
        // The gap's rate is to change by −(1 + τ) w as the tables see it: what they are off by would add up
        // over many impacts.
        let wanted = -(1.0 + simulator.contacts.all()[stop].restitution) * velocity;
        let seen = stage.slope(watch, x, &kick) / self.half();
        let factor = if (seen / wanted - 1.0).abs() < 1e-6 { wanted / seen } else { 1.0 };
        for (y, kick) in self.y.iter_mut().zip(kick) {
            *y += factor * kick;
        }
        self.told(time, stop, velocity, law.impulses[0], radius, 1, false);
        let bounce = -simulator.contacts.all()[stop].restitution * velocity;
        let pushed = bend - simulator.drags[stop] * law.impulses[0];
        if pushed < 0.0 && bounce * bounce < -2.0 * pushed * depth {
            let state = self.state_at(x);
            self.settle(time, state, &[stop], &[])?;
        }
        Ok(())
    }

    #[allow(clippy::too_many_arguments)]
    fn told(
        &mut self,
        time: Time,
        stop: usize,
        velocity: f64,
        impulse: f64,
        radius: f64,
        together: usize,
        order_matters: bool,
    ) {
        self.impacts += 1;
        self.open[stop] = false;
        // The phase is a double below 2π.
        let radius = radius + 1e-15;
        self.events.push(MachineEvent::Impact(StopImpact {
            time,
            radius,
            stop,
            velocity,
            impulse,
            together,
            order_matters,
        }));
    }

    /// Impacts at one instant on the stops touched, together with those rested on.
    fn strike(
        &mut self,
        time: Time,
        mut state: MachineState,
        touched: &[usize],
        rates: &[f64],
        radius: f64,
    ) -> Result<()> {
        let (simulator, resting) = (self.simulator, self.stage.resting.clone());
        let all: Vec<usize> = touched.iter().chain(&resting).copied().collect();
        if all.len() > 1 {
            self.count(Effect::Together);
        }
        let rates: Vec<f64> = rates.iter().copied().chain(resting.iter().map(|_| 0.0)).collect();
        let law = simulator.contacts.impact(&all, &rates)?;
        state.u += &law.change;
        for (i, &stop) in touched.iter().enumerate() {
            // A stop that is touched and neither hit nor pushed is only touched.
            if rates[i] < 0.0 || law.impulses[i] > 0.0 {
                self.told(time, stop, rates[i], law.impulses[i], radius, all.len(), law.order_matters);
            }
        }
        if !self.settle(time, state.clone(), touched, &resting)? {
            // Thrown off what it rested on, unless some of it still presses.
            self.rest_among(time, &state, &resting)?;
        }
        Ok(())
    }

    /// Comes to rest on those of the stops touched whose bounce to come, z′ ≥ 0 in `state`, is lower than the
    /// minimum depth, beside those of `resting` that still press. False if nothing is added: then nothing is
    /// changed.
    fn settle(
        &mut self,
        time: Time,
        mut state: MachineState,
        touched: &[usize],
        resting: &[usize],
    ) -> Result<bool> {
        let (simulator, depth) = (self.simulator, self.simulator.settings.minimum_depth);
        let contacts = simulator.contacts.all();
        let bounce = |j: usize, state: &MachineState| contacts[j].gap(state)[1].max(0.0);
        let held: Vec<usize> = self.held(&state, resting)?;
        // z″ of a stop with the forces of those that are held.
        let free = |j: usize, state: &MachineState| contacts[j].acceleration(&simulator.equations, state);
        let accelerations: Vec<f64> = held.iter().map(|&j| free(j, &state)).collect();
        let forces = simulator.contacts.pressing(&held, &accelerations)?;
        let helped = simulator.contacts.change(&held, &forces);
        let pressed = |j: usize| free(j, &state) + contacts[j].row.dot(&helped);
        let mut added: Vec<(usize, f64)> = Vec::new();
        for &j in touched {
            let (v, a) = (bounce(j, &state), pressed(j));
            if a < 0.0 && v * v < -2.0 * a * depth {
                let tau = contacts[j].restitution;
                let rest = if tau < 1.0 { 2.0 * v / (-a * (1.0 - tau)) } else { 0.0 };
                added.push((j, rest));
            }
        }
        if added.is_empty() {
            return Ok(false);
        }
        let all: Vec<usize> = held.iter().copied().chain(added.iter().map(|known| known.0)).collect();
        // What still moves away is brought to rest, all at once.
        let rates = RealVector::from_iterator(all.len(), all.iter().map(|&j| -contacts[j].gap(&state)[1]));
        if let Some(stopped) = simulator.contacts.among(&all).lu().solve(&rates) {
            state.u += simulator.contacts.change(&all, stopped.as_slice());
        }
        let accelerations: Vec<f64> = all.iter().map(|&j| free(j, &state)).collect();
        let forces = simulator.contacts.pressing(&all, &accelerations)?;
        let mut pressing: Vec<usize> = (0..all.len()).filter(|&i| forces[i] > 0.0).map(|i| all[i]).collect();
        pressing.sort_unstable();
        if !added.iter().any(|(j, _)| pressing.contains(j)) {
            return Ok(false);
        }
        let stage = simulator.stage(&pressing)?;
        let longest = added.iter().map(|known| known.1).fold(0.0, f64::max);
        if longest > 0.0 && !steady(&stage, &state, longest) {
            // The stop changes its mind before the bounces end: one by one, then.
            return Ok(false);
        }
        for &j in resting.iter().filter(|j| !pressing.contains(j)) {
            self.events.push(MachineEvent::Release(StopRelease { time, stop: j }));
        }
        for (stop, rest) in added {
            if pressing.contains(&stop) {
                self.open[stop] = false;
                self.events.push(MachineEvent::Stick(StopStick { time: time.after(rest), stop, rest }));
            }
        }
        self.change(stage, time, &state);
        Ok(true)
    }

    /// Those of the stops rested on that are not left by the velocities of `state`.
    fn held(&self, state: &MachineState, resting: &[usize]) -> Result<Vec<usize>> {
        let simulator = self.simulator;
        let depth = simulator.settings.minimum_depth;
        let stays = |&&j: &&usize| {
            let contact = &simulator.contacts.all()[j];
            let (v, a) = (contact.gap(state)[1], contact.acceleration(&simulator.equations, state));
            v <= 0.0 || v * v < 2.0 * a.abs() * depth
        };
        Ok(resting.iter().filter(stays).copied().collect())
    }

    /// Goes on resting on those of the stops that still press, after others were hit.
    fn rest_among(&mut self, time: Time, state: &MachineState, resting: &[usize]) -> Result<()> {
        let held = self.held(state, resting)?;
        for &stop in resting.iter().filter(|j| !held.contains(j)) {
            self.events.push(MachineEvent::Release(StopRelease { time, stop }));
        }
        self.rest(time, state, &held)
    }

    /// Rests on those of the stops, none of which is left by velocity, that press; the others let go.
    fn rest(&mut self, time: Time, state: &MachineState, stops: &[usize]) -> Result<()> {
        let simulator = self.simulator;
        let contacts = simulator.contacts.all();
        let accelerations: Vec<f64> =
            stops.iter().map(|&j| contacts[j].acceleration(&simulator.equations, state)).collect();
        let forces = simulator.contacts.pressing(stops, &accelerations)?;
        let mut pressing = Vec::new();
        for (&stop, force) in stops.iter().zip(forces) {
            if force > 0.0 {
                pressing.push(stop);
            } else {
                self.events.push(MachineEvent::Release(StopRelease { time, stop }));
            }
        }
        pressing.sort_unstable();
        let stage = simulator.stage(&pressing)?;
        self.change(stage, time, state);
        Ok(())
    }

    fn change(&mut self, stage: Arc<Stage>, time: Time, state: &MachineState) {
        for &stop in stage.resting.iter().chain(&self.stage.resting) {
            self.open[stop] = false;
        }
        self.changes += 1;
        self.enter(stage, time, state);
        if self.changes > MOST_CHANGES {
            // On, by what rounding may move a place.
            self.from = (self.from + NUDGE).min(1.0);
        }
    }
}

/// Whether the forces of what is rested on are within a factor of their values at `state` for `duration`.
fn steady(stage: &Stage, state: &MachineState, duration: f64) -> bool {
    let forces = |t: f64, y: &RealVector| -> Vec<f64> {
        let period = (t / std::f64::consts::TAU).floor() * std::f64::consts::TAU;
        stage.forces(t - period, y)
    };
    let mut y = stage.split(state);
    let now = forces(state.t, &y);
    stage.flow.advance(&mut y, duration);
    let later = forces(state.t + duration, &y);
    now.iter().zip(later).all(|(now, later)| (later / now - 1.0).abs() <= 0.5)
}
