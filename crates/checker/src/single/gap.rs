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
//!
//! Between mirrored walls the pieces are of half periods. In half period i, at u = πi + v, let x_i(v) be
//! (−1)ⁱ x(πi + v). If i is even, the gap to the wall that is met first is the Z above with x_i(v) for x and
//! v for u, and that to the other wall with −x_i(v) and π + v; if i is odd, the other way round. The wall
//! that is met first is met at the end, too, if n is even, the other one if n is odd; a wall that is not met
//! at an end must be open there. And u₀ = πk stands for 2πk, for even k at the one wall and for odd k at the
//! other, with (−1)ᵏ x for x.

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

/// The free motion, the pieces of a period, or half period, and of all of it in order.
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
        let whole = Interval::ZERO.hull(curve.turn);
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

/// With the other sign, or as it is.
fn signed<const N: usize>(x: [Interval; N], other: bool) -> [Interval; N] {
    if other { x.map(|x| -x) } else { x }
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

    /// Whether the gaps are positive strictly between impacts, for all phases.
    pub fn is_clear(&self, free: &Free, at: &Phases, go_on: GoOn) -> Result<bool, Fault> {
        // The wall on each piece of a period, and in its middle: it is the same in every period. Between
        // mirrored walls this is a half period, and the next follows.
        let mut walls = Vec::new();
        for late in if self.mirrored { &[false, true][..] } else { &[false] } {
            for &piece in &free.pieces {
                go_on()?;
                let time = self.since(piece, *late);
                walls.push((
                    piece - piece.middle(),
                    self.wall.at(at.all + time),
                    self.wall.at(at.middle + self.since(piece.middle(), *late)),
                ));
            }
        }
        for wall in 0..if self.mirrored { 2 } else { 1 } {
            if !self.is_clear_of(wall, free, at, &walls, go_on)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A time since the beginning of a half period, or since that of the one before.
    fn since(&self, time: Interval, late: bool) -> Interval {
        if late { time + self.turn } else { time }
    }

    /// Whether a half period is one that begins between windows of a wall: of the wall met first, 0, those
    /// that are odd; then x counts with the other sign. With one wall there are none.
    fn is_late(&self, wall: usize, half: usize) -> bool {
        self.mirrored && (wall + half) % 2 == 1
    }

    /// The same of one wall.
    fn is_clear_of(
        &self,
        wall: usize,
        free: &Free,
        at: &Phases,
        walls: &[(Interval, Shape, Shape)],
        go_on: GoOn,
    ) -> Result<bool, Fault> {
        let (apart, count) = (at.all - at.middle, free.pieces.len());
        let mut pieces = Vec::new();
        // Of each piece the least Z″, and Z′ in the middle.
        let mut bends = Vec::new();
        for (index, stretch) in free.stretches.iter().enumerate() {
            go_on()?;
            let late = self.is_late(wall, index / count);
            let (along, all, centre) = &walls[index % count + if late { count } else { 0 }];
            let [x, v, acceleration] = signed(stretch.all, late);
            let whole = self.gap(&at.shape, all, [x, v]);
            let middle = self.gap(&at.centre, centre, signed(stretch.centre, late));
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
            if self.dips(wall, free, at, first..last + 1, &bends) {
                pieces[first..=last].iter_mut().for_each(|piece| piece.open = true);
            }
        }
        let contacts = if self.mirrored {
            [wall == 0, (wall as u64 + self.periods).is_multiple_of(2)]
        } else {
            [true; 2]
        };
        Ok(carry::is_open(&pieces, contacts))
    }

    /// Whether Z > 0 on a run of convex pieces, by what it is at one time in it; the least Z″ of each piece,
    /// and Z′ in its middle, being given.
    fn dips(
        &self,
        wall: usize,
        free: &Free,
        at: &Phases,
        run: std::ops::Range<usize>,
        bends: &[(Interval, Interval)],
    ) -> bool {
        let own = &bends[run.clone()];
        let least = own[1..].iter().fold(own[0].0, |least, (bend, _)| least.hull(*bend).least());
        let (count, twice) = (free.pieces.len(), least + least);
        let w = self.direction * at.shape.slope;
        let middles = (1..self.periods as usize).filter(|&k| !self.is_late(wall, k));
        for k in middles.filter(|k| run.contains(&(k * count)) || run.end == k * count) {
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
        let late = self.is_late(wall, flat / count);
        let e = self.flow.times(self.turns[flat / count], self.flow.exp(time));
        let [x, v, _] = signed(self.free(e), late);
        let time = self.since(time, late);
        let (all, centre) = (self.wall.at(at.all + time), self.wall.at(at.middle + time));
        let gap = self.gap(&at.centre, &centre, [x, v]);
        let [by_height, by_slope] = self.drift(&at.shape, &all, [x, v]);
        let apart = at.all - at.middle;
        let (height, slope) = (gap.height + by_height * apart, gap.slope + by_slope * apart);
        (height - slope.squared().over(twice)).is_positive()
    }
}
