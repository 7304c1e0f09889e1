//! Pieces of any flow: the steps of its Taylor series.

use super::{
    grid,
    pieces::{LOWER, Pieces},
};
use crate::motion::{
    Contact, Counter, Effect, RunEnd, State, Time,
    flow::{Expansion, MOST_STEPS, SHORTEST, TERMS, Taylor},
    minimum::{Head, head},
};

#[derive(Debug, Clone)]
pub(super) struct Steps {
    flow: Taylor,
    walls: [Option<Contact>; 2],
    /// What a piece counts: cubic stiffness or another smooth force, and forcing or a moving wall.
    cubic: bool,
    smooth: bool,
    driven: bool,
    /// The longest step on which a wall's motion is a polynomial, too: with 24 terms of a sine it is off by
    /// 2²⁴/24! < 10⁻¹⁶ of the amplitude at 2 radians. The flow knows nothing of the walls and would go
    /// farther.
    longest: f64,
}

/// A step from `start`, of which [`from`, 1] is to be looked at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor {
    start: Time,
    step: Expansion,
    from: f64,
    /// How many there were before it in its period.
    steps: u32,
}

impl Cursor {
    /// After another.
    fn after(self, before: &Cursor) -> Cursor {
        let steps = if self.start.period == before.start.period { before.steps + 1 } else { 0 };
        Cursor { steps, ..self }
    }
}

impl Steps {
    pub fn new(flow: &Taylor, walls: &[Option<Contact>; 2]) -> Self {
        let order = walls.iter().flatten().map(|wall| wall.position.order()).max().unwrap_or(0);
        let equation = flow.equation();
        Steps {
            cubic: equation.cubic != 0.0 && equation.smooth.is_none(),
            smooth: equation.smooth.is_some(),
            driven: order > 0 || equation.is_driven(),
            longest: 2.0 / f64::from(order),
            flow: flow.clone(),
            walls: walls.clone(),
        }
    }

    fn expand<C: Counter>(&self, start: Time, q: f64, u: f64, counter: &mut C) -> Cursor {
        if self.cubic {
            counter.count(Effect::Cubic);
        }
        if self.smooth {
            counter.count(Effect::Smooth);
        }
        if self.driven {
            counter.count(Effect::Drive);
        }
        let mut step = self.flow.expand(State { t: start.phase, q, u }, true, self.longest);
        if !(step.h > 0.0 && step.q.iter().sum::<f64>().is_finite()) {
            // Its terms overflow, or it stands at a pole: as far as it can be told, and no farther.
            step.h = SHORTEST;
            step.q = [0.0; TERMS];
            (step.q[0], step.q[1]) = (q, u * step.h);
        }
        Cursor { start, step, from: 0.0, steps: 0 }
    }
}

impl Pieces for Steps {
    type Cursor = Cursor;
    type Gap = [f64; TERMS];
    type Target = Time;

    fn start<C: Counter>(&self, time: Time, q: f64, u: f64, counter: &mut C) -> Cursor {
        self.expand(time, q, u, counter)
    }

    fn from(&self, cursor: &Cursor) -> f64 {
        cursor.from
    }

    fn pass(&self, cursor: &mut Cursor, x: f64) {
        cursor.from = x;
    }

    fn head<C: Counter, const WALL: usize>(&self, cursor: &Cursor, _: &mut C) -> Head {
        head(&self.gap::<WALL>(cursor))
    }

    fn gap<const WALL: usize>(&self, cursor: &Cursor) -> [f64; TERMS] {
        let mut gap = cursor.step.q;
        if let Some(wall) = &self.walls[WALL] {
            wall.position.add_taylor(-1.0, cursor.start.phase, cursor.step.h, &mut gap);
        }
        if WALL == LOWER { gap } else { gap.map(|c| -c) }
    }

    fn turn<C: Counter>(&self, cursor: &mut Cursor, counter: &mut C) {
        let State { q, u, .. } = self.state(cursor, 1.0);
        *cursor = self.expand(self.time(cursor, 1.0), q, u, counter).after(cursor);
    }

    fn kick<C: Counter>(&self, cursor: &mut Cursor, x: f64, du: f64, counter: &mut C) {
        let State { q, u, .. } = self.state(cursor, x);
        *cursor = self.expand(self.time(cursor, x), q, u + du, counter).after(cursor);
    }

    fn jump<C: Counter>(&self, _: &Cursor, cursor: &mut Cursor, until: Time, counter: &mut C) {
        while self.reach(cursor, until) > 1.0 && self.over(cursor).is_none() {
            self.turn(cursor, counter);
        }
        cursor.from = self.reach(cursor, until).min(1.0);
    }

    fn target(&self, until: Time) -> Time {
        until
    }

    fn reach(&self, cursor: &Cursor, target: Time) -> f64 {
        target.since(cursor.start) / cursor.step.h
    }

    fn time(&self, cursor: &Cursor, x: f64) -> Time {
        cursor.start.after(cursor.step.h * x)
    }

    fn scale(&self, cursor: &Cursor) -> f64 {
        cursor.step.h
    }

    fn state(&self, cursor: &Cursor, x: f64) -> State {
        let [q, slope] =
            cursor.step.q.iter().rev().fold([0.0; 2], |[q, slope], c| [q * x + c, slope * x + q]);
        State { t: self.time(cursor, x).phase, q, u: slope / cursor.step.h }
    }

    fn leave(&self, _: &Cursor) -> Option<grid::Cursor> {
        None
    }

    fn join(&self, _: grid::Cursor) -> Cursor {
        unreachable!("only motions on a grid leave it")
    }

    fn over(&self, cursor: &Cursor) -> Option<RunEnd> {
        if cursor.steps > MOST_STEPS {
            return Some(RunEnd::TooSteep);
        }
        let over = super::unbounded(cursor.step.q[0].abs()) || cursor.step.h <= SHORTEST;
        over.then_some(if cursor.step.h <= SHORTEST { cursor.step.obstacle.into() } else { RunEnd::Escaped })
    }
}
