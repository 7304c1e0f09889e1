//! S3: strictly between impacts the gap to the wall is positive.
//!
//! With x the free motion from K with first velocity H, the motion is g′(t) x(u) a time u after an impact at
//! the phase t, and the gap is
//!
//! ```text
//! Z = g′(t) (x(u) − K) + g(t) − g(t + u)
//! ```
//!
//! with Z = 0 at both ends, Z′ > 0 at the first and Z′ < 0 at the last by S2. The time is cut into pieces,
//! and on each of them, for all phases of a cell, it is seen whether Z is open, convex, rising or falling, as
//! `touch::carry` has these; by the mean-value form in t and u about the middles of both.
//!
//! A run of convex pieces, on which Z″ ≥ μ > 0, is open as well if Z(u₀) − Z′(u₀)²/2μ > 0 for some u₀ in it.
//! Tried are a u₀ where Z is about least, for the middle phase; and, if the run holds it, u₀ = 2πk, where Z =
//! g′(x − K) and Z′ = g′(x′ − 1) are multiples of g′: divided by w = |g′| the condition is
//!
//! ```text
//! D (K − x(2πk)) − w (1 − x′(2πk))²/2μ > 0
//! ```
//!
//! which holds from the touch on, though Z itself vanishes there.

use super::{Fault, Interval, curve::Curve};
use crate::{
    rejection::GoOn,
    touch::{
        carry::{self, Piece},
        flow::Matrix,
        wall::Shape,
    },
};

/// The free motion on a piece: x, x′ and x″, and x and x′ in the middle.
struct Stretch {
    all: [Interval; 3],
    centre: [Interval; 2],
}

/// The free motion, the pieces of a period, and of all of it in order.
pub(super) struct Free {
    pieces: Vec<Interval>,
    stretches: Vec<Stretch>,
}

/// Phases, the middle one, and the wall at both.
pub(super) struct Phases {
    pub all: Interval,
    pub middle: Interval,
    pub shape: Shape,
    pub centre: Shape,
}

/// Z and Z′.
struct Gap {
    height: Interval,
    slope: Interval,
}

impl Free {
    pub fn new(curve: &Curve, pieces: u64, go_on: GoOn) -> Result<Free, Fault> {
        let turn = Interval::PI + Interval::PI;
        let whole = Interval::ZERO.hull(turn);
        let pieces: Vec<Interval> = (0..pieces).map(|i| whole.part(i, pieces)).collect();
        let mut within = Vec::new();
        for &piece in &pieces {
            go_on()?;
            within.push([curve.flow.exp(piece), curve.flow.exp(piece.middle())]);
        }
        let mut stretches = Vec::new();
        for turns in &curve.turns[..curve.periods as usize] {
            go_on()?;
            stretches.extend(within.iter().map(|both| {
                let [all, centre] = both.map(|e| curve.free(curve.flow.times(*turns, e)));
                Stretch { all, centre: [centre[0], centre[1]] }
            }));
        }
        Ok(Free { pieces, stretches })
    }
}

impl Phases {
    pub fn new(curve: &Curve, all: Interval) -> Phases {
        let middle = all.middle();
        Phases { all, middle, shape: curve.wall.at(all), centre: curve.wall.at(middle) }
    }
}

impl Curve {
    /// x, x′ and x″, given E.
    fn free(&self, e: Matrix) -> [Interval; 3] {
        // k first: what is large has room for no more.
        let spring = self.flow.stiffness * e.b;
        let x = e.a * self.place + e.b * self.after;
        let v = self.flow.velocity(e) * self.after - spring * self.place;
        [x, v, -(self.flow.damping * v + self.flow.stiffness * x)]
    }

    /// Z and Z′ at a phase where the wall is `here`, a time after it at which it is `there`.
    fn gap(&self, here: &Shape, there: &Shape, [x, v]: [Interval; 2]) -> Gap {
        Gap {
            height: there.drop - here.drop - here.slope * (x - self.place),
            slope: there.slope - here.slope * v,
        }
    }

    /// The derivatives of Z and Z′ by t.
    fn drift(&self, here: &Shape, there: &Shape, [x, v]: [Interval; 2]) -> [Interval; 2] {
        [there.slope - here.slope - here.bend * (x - self.place), there.bend - here.bend * v]
    }

    /// Whether the gap is positive strictly between impacts, for all phases.
    pub fn is_clear(&self, free: &Free, at: &Phases, go_on: GoOn) -> Result<bool, Fault> {
        // The wall on each piece of a period, and in its middle: it is the same in every period.
        let mut walls = Vec::new();
        for &piece in &free.pieces {
            go_on()?;
            walls.push((
                piece - piece.middle(),
                self.wall.at(at.all + piece),
                self.wall.at(at.middle + piece.middle()),
            ));
        }
        let apart = at.all - at.middle;
        let mut pieces = Vec::new();
        // Of each piece the least Z″, and Z′ in the middle.
        let mut bends = Vec::new();
        for (stretch, (along, all, centre)) in free.stretches.iter().zip(walls.iter().cycle()) {
            go_on()?;
            let [x, v, acceleration] = stretch.all;
            let whole = self.gap(&at.shape, all, [x, v]);
            let middle = self.gap(&at.centre, centre, stretch.centre);
            let [by_height, by_slope] = self.drift(&at.shape, all, [x, v]);
            let bend = all.bend - at.shape.slope * acceleration;
            let slope = whole.slope.meet(middle.slope + by_slope * apart + bend * *along);
            let height = middle.height + by_height * apart + slope * *along;
            pieces.push(Piece {
                open: whole.height.is_positive() || height.is_positive(),
                convex: bend.is_positive(),
                rising: slope.is_positive(),
                falling: (-slope).is_positive(),
            });
            bends.push((bend.least(), middle.slope));
        }
        let mut from = 0;
        while from < pieces.len() {
            let length = pieces[from..].iter().take_while(|piece| piece.convex).count();
            let run = from..from + length;
            from += length.max(1);
            // What is not open of a run between impacts.
            let closed = |at: &usize| !pieces[*at].open;
            let ends = run.clone().find(closed).zip(run.clone().rev().find(closed));
            let Some((first, last)) = ends.filter(|_| 0 < run.start && run.end < pieces.len()) else {
                continue;
            };
            if self.dips(free, at, first..last + 1, &bends) {
                pieces[first..=last].iter_mut().for_each(|piece| piece.open = true);
            }
        }
        Ok(carry::is_open(&pieces))
    }

    /// Whether Z > 0 on a run of convex pieces, by what it is at one time in it; the least Z″ of each piece,
    /// and Z′ in its middle, being given.
    fn dips(
        &self,
        free: &Free,
        at: &Phases,
        run: std::ops::Range<usize>,
        bends: &[(Interval, Interval)],
    ) -> bool {
        let own = &bends[run.clone()];
        let least = own[1..].iter().fold(own[0].0, |least, (bend, _)| least.hull(*bend).least());
        let (count, twice) = (free.pieces.len(), least + least);
        let w = self.direction * at.shape.slope;
        for k in (1..self.periods as usize).filter(|k| run.contains(&(k * count)) || run.end == k * count) {
            let [x, v, _] = self.free(self.turns[k]);
            let height = self.direction * (self.place - x);
            let steep = (Interval::ONE - v).squared();
            if (height - (w * steep).over(twice)).is_positive() {
                return true;
            }
        }
        // About where Z is least for the middle phase: any time of the run will do.
        let mut flat = run.start;
        for other in run {
            if bends[other].1.magnitude().is_below(bends[flat].1.magnitude()) {
                flat = other;
            }
        }
        let (piece, (bend, slope)) = (free.pieces[flat % count], bends[flat]);
        let time = (piece.middle() - slope.over(bend)).middle();
        let end = if slope.is_positive() { piece.least() } else { piece.greatest() };
        let time = time.common(piece).unwrap_or(end);
        let [x, v, _] = self.free(self.flow.times(self.turns[flat / count], self.flow.exp(time)));
        let (all, centre) = (self.wall.at(at.all + time), self.wall.at(at.middle + time));
        let gap = self.gap(&at.centre, &centre, [x, v]);
        let [by_height, by_slope] = self.drift(&at.shape, &all, [x, v]);
        let apart = at.all - at.middle;
        let (height, slope) = (gap.height + by_height * apart, gap.slope + by_slope * apart);
        (height - slope.squared().over(twice)).is_positive()
    }
}
