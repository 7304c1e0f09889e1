//! The event loop, composed at compile time of the effects present.

use super::{
    Event, Settings, grid,
    pieces::{LOWER, Pieces, UPPER},
    wall::Walls,
};
use crate::{
    error::Result,
    motion::{
        Counter, Effect, RunEnd, State, Time,
        event::{Impact, Release, Stick, Tangency},
        minimum::{Gap, Hit, NUDGE, ROUNDING, clear, norm},
    },
};

/// A run with its kind of flow and of walls forgotten.
pub(super) trait Engine: Send {
    fn next(&mut self, until: Time) -> Event;
    fn time(&self) -> Time;
    fn state(&self) -> State;
    fn impacts(&self) -> u64;
    /// The motion, if it is on a grid, in flight, and nothing is left to be told.
    fn aloft(&self) -> Option<Aloft>;
}

/// A motion in flight on a grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aloft {
    pub cursor: grid::Cursor,
    /// As [`Loop::open`].
    pub open: [bool; 2],
    pub impacts: u64,
}

/// A run through the pieces `P`, with a lower and an upper wall or not, told of to a counter or not.
pub(super) struct Loop<'a, P: Pieces, C, const HAS_LOWER: bool, const HAS_UPPER: bool> {
    pieces: &'a P,
    walls: &'a Walls,
    settings: &'a Settings,
    /// Where the last free flight began, if there is no wall.
    origin: Option<P::Cursor>,
    cursor: P::Cursor,
    /// Whether the gap was above the minimum depth since the last contact, per wall.
    open: [bool; 2],
    rest: Option<Rest>,
    /// An impact at the initial time, not yet told.
    first: Option<Event>,
    /// A stick, not yet told.
    pending: Option<Event>,
    impacts: u64,
    ended: Option<RunEnd>,
    counter: C,
}

/// On a wall.
#[derive(Debug, Clone, Copy)]
struct Rest {
    wall: usize,
    now: Time,
    release: Option<Time>,
}

/// A wall within reach on a piece: which, the hit, z, z′ and z″ there, and the rounding error of z.
struct Contacted {
    wall: usize,
    hit: Hit,
    z: f64,
    slope: f64,
    bend: f64,
    rounding: f64,
}

impl<'a, P: Pieces, C: Counter, const HAS_LOWER: bool, const HAS_UPPER: bool>
    Loop<'a, P, C, HAS_LOWER, HAS_UPPER>
{
    /// # Errors
    /// A start behind a wall by more than the minimum depth.
    pub fn new(
        pieces: &'a P,
        walls: &'a Walls,
        settings: &'a Settings,
        time: Time,
        [q, u]: [f64; 2],
        mut counter: C,
    ) -> Result<Self> {
        let contact = walls.contact_at(State { t: time.phase, q, u }, settings.minimum_depth)?;
        let cursor = pieces.start(time, q, u, &mut counter);
        let origin = (!HAS_LOWER && !HAS_UPPER).then(|| cursor.clone());
        let mut run = Loop {
            pieces,
            walls,
            settings,
            origin,
            cursor,
            open: [contact.is_none(); 2],
            rest: None,
            first: None,
            pending: None,
            impacts: 0,
            ended: None,
            counter,
        };
        if let Some((wall, velocity)) = contact {
            let x = run.pieces.from(&run.cursor);
            run.settle(wall, x, velocity.abs());
            if velocity < 0.0 && run.rest.is_none() {
                run.first = Some(run.strike(wall, x, velocity, 0.0));
            }
        }
        Ok(run)
    }

    /// The run of a motion that was in flight.
    pub fn resume(
        pieces: &'a P,
        walls: &'a Walls,
        settings: &'a Settings,
        Aloft { cursor, open, impacts }: Aloft,
        counter: C,
    ) -> Self {
        let cursor = pieces.join(cursor);
        let (origin, rest, first, pending, ended) = (None, None, None, None, None);
        Loop { pieces, walls, settings, origin, cursor, open, rest, first, pending, impacts, ended, counter }
    }

    /// Looks at the piece as far as `end`: the first hit, and on which wall.
    #[inline]
    fn look(&mut self, end: f64) -> Option<Contacted> {
        let mut first = None;
        let mut end = end;
        if HAS_LOWER {
            self.counter.count(Effect::LowerGap);
            first = self.look_at::<LOWER>(end);
            if let Some(contacted) = &first {
                end = contacted.hit.place();
            }
        }
        if HAS_UPPER {
            self.counter.count(Effect::UpperGap);
            first = self.look_at::<UPPER>(end).or(first);
        }
        first
    }

    /// The first hit on one wall.
    #[inline]
    fn look_at<const WALL: usize>(&mut self, end: f64) -> Option<Contacted> {
        self.counter.count(Effect::Piece);
        let head = self.pieces.head::<C, WALL>(&self.cursor, &mut self.counter);
        if clear(head, self.settings.minimum_depth) {
            self.open[WALL] = true;
            return None;
        }
        self.counter.count(Effect::Search);
        let gap = self.pieces.gap::<WALL>(&self.cursor);
        let mut search = Gap::new(gap.as_ref(), self.settings.minimum_depth, self.open[WALL]);
        let hit = search.first(self.pieces.from(&self.cursor), end);
        self.open[WALL] = search.open;
        hit.map(|hit| {
            let [z, slope, bend] = search.at(hit.place());
            Contacted { wall: WALL, hit, z, slope, bend, rounding: ROUNDING * norm(gap.as_ref()) }
        })
    }

    /// Makes an event of a hit; a wall that only touches is none.
    fn meet(&mut self, Contacted { wall, hit, z, slope, bend, rounding }: Contacted) -> Option<Event> {
        let (scale, x) = (self.pieces.scale(&self.cursor), hit.place());
        self.pieces.pass(&mut self.cursor, x);
        match hit {
            Hit::Tangency(_) => {
                let (time, side) = (self.pieces.time(&self.cursor, x), self.walls.side(wall));
                Some(Event::Tangency(Tangency { time, place: side, gap: z }))
            }
            Hit::Press(_) => {
                self.settle(wall, x, 0.0);
                if self.rest.is_none() {
                    // The wall presses by no more than rounding: on, and surely not to the same place.
                    self.pieces.pass(&mut self.cursor, x + NUDGE);
                }
                self.pending.take()
            }
            Hit::Impact(_) => {
                // On the wrong side of rounding an impact may seem to leave: it arrives with velocity 0.
                let velocity = (slope / scale).min(0.0);
                let radius = (2.0 * (z.abs() + rounding) / slope.abs())
                    .min((2.0 * (z.abs() + rounding) / bend.abs()).sqrt());
                Some(self.strike(wall, x, velocity, radius * scale))
            }
        }
    }

    /// An impact at x of the current piece.
    fn strike(&mut self, wall: usize, x: f64, velocity: f64, radius: f64) -> Event {
        let time = self.pieces.time(&self.cursor, x);
        let (side, restitution) = (self.walls.side(wall), self.walls.restitution(wall));
        self.impacts += 1;
        self.open[wall] = false;
        self.pieces.kick(
            &mut self.cursor,
            x,
            -side.sign() * (1.0 + restitution) * velocity,
            &mut self.counter,
        );
        self.settle(wall, self.pieces.from(&self.cursor), -restitution * velocity);
        // The phase is a double below 2π.
        Event::Impact(Impact { time, radius: radius + 1e-15, place: side, velocity, shock: () })
    }

    /// Comes to rest on a wall that presses if the bounce to come, z′ being `velocity` ≥ 0, is lower than the
    /// minimum depth.
    #[inline]
    fn settle(&mut self, wall: usize, x: f64, velocity: f64) {
        let bound = self.settings.minimum_depth * self.walls.strongest(wall);
        if velocity * velocity >= 2.0 * bound {
            return;
        }
        let now = self.pieces.time(&self.cursor, x);
        let force = self.walls.force(wall, now.phase)[0];
        if force >= 0.0 || velocity * velocity >= -2.0 * force * self.settings.minimum_depth {
            return;
        }
        let restitution = self.walls.restitution(wall);
        let rest = if restitution < 1.0 { 2.0 * velocity / (-force * (1.0 - restitution)) } else { 0.0 };
        let time = now.after(rest);
        let later = self.walls.force(wall, time.phase)[0];
        if (later / force - 1.0).abs() > 0.5 {
            // The wall changes its mind before the bounces end: one by one, then.
            return;
        }
        self.counter.count(Effect::Release);
        let release = self.walls.release(wall, time.phase).map(|duration| time.after(duration));
        self.rest = Some(Rest { wall, now, release });
        self.pending = Some(Event::Stick(Stick { time, place: self.walls.side(wall), rest }));
    }

    fn end(&mut self, end: RunEnd) -> Event {
        self.ended = Some(end);
        Event::End(end)
    }
}

impl<P: Pieces, C: Counter, const HAS_LOWER: bool, const HAS_UPPER: bool> Engine
    for Loop<'_, P, C, HAS_LOWER, HAS_UPPER>
{
    fn next(&mut self, until: Time) -> Event {
        if let Some(event) = self.first.take() {
            return event;
        }
        if self.pending.and_then(|event| event.time()).is_some_and(|time| time <= until) {
            return self.pending.take().expect("looked at");
        }
        if let Some(end) = self.ended {
            return Event::End(end);
        }
        if self.impacts >= self.settings.impact_limit {
            return self.end(RunEnd::ImpactLimit);
        }
        if let Some(Rest { wall, now, release }) = &mut self.rest {
            let wall = *wall;
            let Some(time) = release.filter(|time| *time <= until) else {
                *now = if *now < until { until } else { *now };
                return Event::End(RunEnd::Reached);
            };
            let State { q, u, .. } = self.walls.on(wall, time.phase);
            self.cursor = self.pieces.start(time, q, u, &mut self.counter);
            self.rest = None;
            return Event::Release(Release { time, place: self.walls.side(wall) });
        }
        // Nothing can be met from here on, so there is nothing to look at on the way.
        if let Some(origin) = &self.origin {
            self.pieces.jump(origin, &mut self.cursor, until, &mut self.counter);
            let over = self.pieces.over(&self.cursor);
            return over.map_or(Event::End(RunEnd::Reached), |end| self.end(end));
        }
        if let Some(end) = self.pieces.over(&self.cursor) {
            return self.end(end);
        }
        let target = self.pieces.target(until);
        loop {
            let reach = self.pieces.reach(&self.cursor, target);
            if let Some(hit) = self.look(reach.min(1.0)) {
                if let Some(event) = self.meet(hit) {
                    return event;
                }
            } else if reach <= 1.0 {
                let from = self.pieces.from(&self.cursor);
                self.pieces.pass(&mut self.cursor, reach.max(from));
                return Event::End(RunEnd::Reached);
            } else {
                self.pieces.turn(&mut self.cursor, &mut self.counter);
                if let Some(end) = self.pieces.over(&self.cursor) {
                    return self.end(end);
                }
            }
        }
    }

    fn time(&self) -> Time {
        match self.rest {
            Some(rest) => rest.now,
            None => self.pieces.time(&self.cursor, self.pieces.from(&self.cursor)),
        }
    }

    fn state(&self) -> State {
        match self.rest {
            Some(rest) => self.walls.on(rest.wall, rest.now.phase),
            None => self.pieces.state(&self.cursor, self.pieces.from(&self.cursor)),
        }
    }

    fn impacts(&self) -> u64 {
        self.impacts
    }

    fn aloft(&self) -> Option<Aloft> {
        let told = self.rest.is_none() && self.first.is_none() && self.pending.is_none();
        let cursor = (told && self.ended.is_none()).then(|| self.pieces.leave(&self.cursor)).flatten()?;
        Some(Aloft { cursor, open: self.open, impacts: self.impacts })
    }
}
