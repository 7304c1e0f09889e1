//! The wall σν − 1 + g(t), g a sum of harmonics with its top g(0) = 1, g′(0) = 0: how far it is below its
//! top, its speed and its bend, and the phase at which it has a given speed.
//!
//! g(t) = Σ aⱼ cos jt + bⱼ sin jt with Σ aⱼ = 1 and Σ j bⱼ = 0. The two equations hold exactly, for numbers
//! known by ranges; they are put into the formulas, so that what vanishes at t = 0 is enclosed by what
//! vanishes there:
//!
//! ```text
//! −g′ = Σ j (aⱼ sin jt + bⱼ (1 − cos jt)),    −g″ = Σ j² (aⱼ cos jt + bⱼ sin jt)
//! 1 − g = Σ aⱼ (1 − cos jt) − bⱼ sin jt
//! ```

use super::{Interval, flow::circle};
use crate::rejection::{Fault, GoOn, claim};

/// g by its harmonics, with what is known of it on the window ±W.
pub(crate) struct Wall {
    harmonics: Vec<(u64, [Interval; 2])>,
    /// Whether g(t) = cos t.
    plain: bool,
    /// W.
    pub window: Interval,
    /// The least −g″ on the window, a positive point.
    bend: Interval,
    /// −g′ at −W and at W.
    ends: [Interval; 2],
}

/// The wall at a phase.
pub(crate) struct Shape {
    /// 1 − g.
    pub drop: Interval,
    /// −g′.
    pub slope: Interval,
    /// −g″.
    pub bend: Interval,
}

impl Wall {
    /// With no window: for what is said of it at a phase alone.
    pub fn free(harmonics: Vec<(u64, [Interval; 2])>) -> Wall {
        let plain = matches!(harmonics[..], [(1, [Interval::ONE, Interval::ZERO])]);
        let (window, bend, ends) = (Interval::ZERO, Interval::ONE, [Interval::ZERO; 2]);
        Wall { harmonics, plain, window, bend, ends }
    }

    /// With the window cut into pieces to prove that 0 < W < π/2 and −g″ > 0 there.
    pub fn new(
        harmonics: Vec<(u64, [Interval; 2])>,
        window: Interval,
        pieces: u64,
        go_on: GoOn,
    ) -> Result<Wall, Fault> {
        claim((window + window).is_below(Interval::PI), "the window is not below pi/2")?;
        let mut wall = Wall { window, ..Wall::free(harmonics) };
        let whole = (-window).hull(window);
        for piece in 0..pieces {
            go_on()?;
            let bend = wall.at(whole.part(piece, pieces)).bend.least();
            claim(bend.is_positive(), "the wall may not be convex on the window")?;
            wall.bend = if piece == 0 { bend } else { wall.bend.hull(bend).least() };
        }
        wall.ends = [wall.at(-window).slope, wall.at(window).slope];
        Ok(wall)
    }

    /// Whether it is cos t.
    pub fn plain(&self) -> bool {
        self.plain
    }

    /// At every enclosed phase.
    pub fn at(&self, t: Interval) -> Shape {
        if self.plain {
            let (cosine, sine) = circle(t);
            return Shape { drop: Interval::ONE - cosine, slope: sine, bend: cosine };
        }
        let zero = Interval::ZERO;
        let mut shape = Shape { drop: zero, slope: zero, bend: zero };
        for &(j, [a, b]) in &self.harmonics {
            let j = Interval::ratio(j.into(), 1);
            let (cosine, sine) = circle(j * t);
            let fall = Interval::ONE - cosine;
            shape.drop = shape.drop + a * fall - b * sine;
            shape.slope = shape.slope + j * (a * sine + b * fall);
            shape.bend = shape.bend + j * j * (a * cosine + b * sine);
        }
        shape
    }

    /// The phases in the window where −g′ is among these numbers, if it takes each of them there.
    ///
    /// An approximation t in the window is improved by Newton's method, which need not be right. Then the
    /// phase differs from t by at most |y + g′(t)| / min −g″, by the mean value theorem: the minimum first
    /// over the window, then over what it has been narrowed to.
    pub fn phase(&self, y: Interval) -> Option<Interval> {
        if !(self.ends[0].is_below(y) && y.is_below(self.ends[1])) {
            return None;
        }
        let close = Interval::ratio(1, 1 << 40);
        let edge = self.window.least();
        let inside = |t: Interval| {
            if (-edge).is_up_to(t) && t.is_up_to(edge) {
                t
            } else if t.is_positive() {
                edge
            } else {
                -edge
            }
        };
        let at = |y: Interval| {
            let mut t = Interval::ZERO;
            let mut shape = self.at(t);
            for _ in 0..8 {
                if (y - shape.slope).magnitude().is_below(close) {
                    break;
                }
                t = inside((t + (y - shape.slope).over(shape.bend)).middle());
                shape = self.at(t);
            }
            let within = |bend: Interval| {
                let error = (y - shape.slope).over(bend).magnitude();
                t + (-error).hull(error)
            };
            let coarse = within(self.bend);
            if self.plain { coarse } else { within(self.at(coarse).bend.raised(self.bend)) }
        };
        Some(if y == y.middle() { at(y) } else { at(y.least()).hull(at(y.greatest())) })
    }

    /// −g″ at these phases, and (1 − g)/g′², which is 1/−2g″ at some phase between 0 and them; 1/(1 + cos t)
    /// for g = cos.
    pub fn bends(&self, phase: Interval) -> [Interval; 2] {
        if self.plain {
            let unit = (-Interval::ONE).hull(Interval::ONE);
            let cosine = circle(phase).0.meet(unit);
            return [cosine, Interval::ONE.over(Interval::ONE + cosine)];
        }
        let both = self.at(phase.hull(Interval::ZERO)).bend.raised(self.bend);
        [self.at(phase).bend.raised(self.bend), Interval::ONE.over(both + both)]
    }
}
