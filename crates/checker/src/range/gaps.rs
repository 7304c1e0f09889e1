//! The condition H4: strictly between impacts the gap to the wall is positive.
//!
//! The gap is Z = 1 − g(t) + ν (q̂ − σ), with Z = 0 at both ends of a leg, Z′ > 0 at the first and Z′ < 0 at
//! the last by E3. The leg is cut into pieces of time, on which Z is, certainly,
//!
//! - open: Z > 0;
//! - convex: Z″ > 0;
//! - rising: Z′ > 0, or falling: Z′ < 0.
//!
//! `touch::carry` says how these carry Z > 0 from both impacts. In a window between, 2πk − W ≤ t ≤ 2πk + W,
//! all pieces are open, too, if Z″ ≥ μ > 0 there and Z(2πk) − Z′(2πk)²/2μ > 0, which is ν times q̂ − σ − ν
//! q̂′²/2μ.
//!
//! Between mirrored walls window k is πk − W ≤ t ≤ πk + W, for even k that of the wall where the leg begins,
//! for odd k of the other; and as of kind `chaos` the gap to its wall at the time πk + t is that above with
//! (−1)ᵏ q̂(πk + t) for q̂. Each wall has its own pieces, from the leg's beginning to its end: windows k, k +
//! 2, … and the times between. The leg's first impact is a contact with the one, its last with the wall that
//! window n belongs to.
//!
//! An impact's phase is known by an interval. So the first pieces may be before it or hold it: what is said
//! of Z there is said of the motion that is free for all times, and open they are not if they hold it.

use super::{Fault, Interval, map::Legs, work::Work};
use crate::{
    rejection::{GoOn, claim},
    touch::{
        carry::{self, Piece},
        legs::Impact,
    },
};

/// Proves it for every leg of a cell, of these strengths.
pub(super) fn open(
    work: &Work,
    legs: &Legs,
    strengths: &[Interval],
    pieces: u64,
    go_on: GoOn,
) -> Result<(), Fault> {
    let mut impacts = Vec::new();
    for (edge, &s) in strengths.iter().enumerate() {
        let Some(impact) = work.cell.impact(s) else { return Err(work.graph.outside(edge)) };
        impacts.push(impact);
    }
    for (index, &[from, letter, to]) in work.graph.legs.iter().enumerate() {
        let flight = Flight {
            work,
            periods: work.graph.periods[letter],
            ends: [&impacts[from], &impacts[to]],
            after: Work::after(legs, index),
            pieces,
        };
        let holds = flight.is_open(go_on)?;
        claim(
            holds,
            format_args!(
                "letter {} between {} and {}: the gap may not be positive (H4)",
                letter + 1,
                work.graph.edges[from][0] + 1,
                work.graph.edges[to][1] + 1
            ),
        )?;
    }
    Ok(())
}

/// All legs between two edges.
struct Flight<'a> {
    work: &'a Work<'a>,
    periods: u64,
    ends: [&'a Impact; 2],
    after: Interval,
    pieces: u64,
}

/// The gap, its slope and its bend.
struct Gap {
    height: Interval,
    slope: Interval,
    bend: Interval,
}

impl Flight<'_> {
    /// q̂ and q̂′ at a time t since the middle of window k.
    fn motion(&self, k: u64, t: Interval) -> [Interval; 2] {
        let cell = &self.work.cell;
        let e = cell.flow.times(self.work.turns(k), cell.flow.exp(t - self.ends[0].phase));
        let (place, velocity) = cell.flow.apply(e, self.ends[0].place, self.after);
        [place, velocity]
    }

    fn gap(&self, k: u64, t: Interval) -> Gap {
        let cell = &self.work.cell;
        let ([place, velocity], shape) = (self.motion(k, t), cell.wall.at(t));
        Gap {
            height: shape.drop + cell.depth * (place - cell.side),
            slope: shape.slope + cell.depth * velocity,
            bend: shape.bend + cell.depth * cell.acceleration(place, velocity),
        }
    }

    /// A piece, by what Z, Z′ and Z″ are on it and Z and Z′ in its middle; and the least Z″.
    fn piece(&self, k: u64, t: Interval) -> (Piece, Interval) {
        let (all, middle) = (self.gap(k, t), self.gap(k, t.middle()));
        let apart = t - t.middle();
        let slope = middle.slope + all.bend * apart;
        let (rising, falling) = (all.slope.is_positive() || slope.is_positive(), {
            (-all.slope).is_positive() || (-slope).is_positive()
        });
        let height = middle.height + all.slope.meet(slope) * apart;
        let open = all.height.is_positive() || height.is_positive();
        (Piece { open, convex: all.bend.is_positive(), rising, falling }, all.bend.least())
    }

    /// All pieces in order, of the wall whose first window is window 0 or, between mirrored walls, 1.
    fn pieces(&self, start: u64, go_on: GoOn) -> Result<Vec<Piece>, Fault> {
        let cell = &self.work.cell;
        let (window, n) = (cell.wall.window, self.periods);
        let [first, last] = self.ends;
        let (pi, step) = (Interval::PI, if cell.mirrored { 2 } else { 1 });
        let mut all = Vec::new();
        if start == 1 {
            all.extend(self.between(1, (first.phase - pi).hull(-window), go_on)?);
        }
        for k in (start..=n).step_by(step) {
            let from = if k == 0 { first.phase } else { -window };
            let to = if k == n { last.phase } else { window };
            let begin = all.len();
            let mut least: Option<Interval> = None;
            for part in 0..self.pieces {
                go_on()?;
                let (piece, bend) = self.piece(k, from.hull(to).part(part, self.pieces));
                all.push(piece);
                least = Some(least.map_or(bend, |least| least.hull(bend).least()));
            }
            if let Some(least) = least.filter(|_| 0 < k && k < n) {
                let [place, velocity] = self.motion(k, Interval::ZERO);
                let dip = (cell.depth * velocity.squared()).over(least + least);
                if least.is_positive() && (place - cell.side - dip).is_positive() {
                    all[begin..].iter_mut().for_each(|piece| piece.open = true);
                }
            }
            if k < n {
                // To the wall's next window, or to the end of the leg, which is at the other wall.
                let to = if k + step as u64 <= n { pi + pi - window } else { pi + last.phase };
                all.extend(self.between(k, window.hull(to), go_on)?);
            }
        }
        Ok(all)
    }

    /// The pieces of a time since the middle of window k that is no window.
    fn between(&self, k: u64, time: Interval, go_on: GoOn) -> Result<Vec<Piece>, Fault> {
        let piece = |part| go_on().map(|()| self.piece(k, time.part(part, self.pieces)).0);
        (0..self.pieces).map(piece).collect()
    }

    fn is_open(&self, go_on: GoOn) -> Result<bool, Fault> {
        if !self.work.cell.mirrored {
            return Ok(carry::is_open(&self.pieces(0, go_on)?, [true, true]));
        }
        let even = self.periods.is_multiple_of(2);
        Ok(carry::is_open(&self.pieces(0, go_on)?, [true, even])
            && carry::is_open(&self.pieces(1, go_on)?, [false, !even]))
    }
}
