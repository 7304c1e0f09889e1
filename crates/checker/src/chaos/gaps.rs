//! The condition H4: strictly between impacts the gap to the wall is positive; with two walls, to both.
//!
//! The gap is Z = q − w, and with q = ν q̂ it is Z = 1 − g(t) + ν (q̂ − σ), Z″ = −g″(t) + ν q̂″. A window is
//! 2πk − W ≤ t ≤ 2πk + W. Where Z″ > 0 on the first window from the first impact on, Z = 0 < Z′ at that
//! impact keeps Z > 0; likewise backwards from the last. Where Z″ ≥ m > 0 on a window between, Z ≥ Z(2πk) −
//! Z′(2πk)²/2m on it, which is ν times q̂ − σ − ν q̂′²/2m. Between windows Z > 0 is shown outright.
//!
//! Between mirrored walls the windows are πk − W ≤ t ≤ πk + W, for even k those of the wall where the leg
//! begins, for odd k of the other. The gap to the latter at the time πk + t is that of the former with
//! (−1)ᵏ q̂(πk + t) for q̂, at the phase t: so each window is proved as with one wall. Between its windows k
//! and k + 2 each wall's gap is shown to be positive outright, from the leg's beginning (which is in window
//! 0) for the wall with k = −1, and to its end for the wall whose last window is that before the last.

use std::fmt;

use super::{Fault, Interval, work::Work};
use crate::{
    rejection::{GoOn, claim},
    touch::legs::Impact,
};

/// Proves it for every letter of a cell, and that q̂ stays below the reach; with two walls, |q̂|.
pub(super) fn open(work: &Work, pieces: u64, go_on: GoOn) -> Result<(), Fault> {
    (0..work.numbers.letters.len()).try_for_each(|n| {
        flight(work, n, pieces, go_on).map_err(|fault| fault.at(format!("letter {}", n + 1)))
    })
}

/// Of all legs of a letter, at a time since the middle of a window, as seen from that window's wall.
struct Motion {
    place: Interval,
    velocity: Interval,
    acceleration: Interval,
}

/// All legs of a letter, from their first impacts.
struct Legs<'a> {
    work: &'a Work<'a>,
    first: Impact,
    after: Interval,
}

impl Legs<'_> {
    /// At a time t since the middle of window k.
    fn motion(&self, k: u64, t: Interval) -> Motion {
        let cell = &self.work.cell;
        let since = t - self.first.phase;
        // E of the time since the impact, its first factor known.
        let e = cell.flow.times(self.work.turns(k), cell.flow.exp(since));
        let (fallen, speed) = cell.fall(cell.time(k) + since);
        let (place, velocity) = cell.flow.apply(e, self.first.place, self.after);
        let (place, velocity) = (place + fallen, velocity + speed);
        Motion { place, velocity, acceleration: cell.acceleration(place, velocity) }
    }

    /// The place at a time t since the middle of the window before window 0, of the other wall.
    fn before(&self, t: Interval) -> Interval {
        -self.motion(0, t - self.work.cell.time(1)).place
    }

    fn is_within_reach(&self, place: Interval) -> bool {
        let reach = self.work.numbers.reach;
        place.is_below(reach) && (!self.work.cell.mirrored || (-place).is_below(reach))
    }
}

/// A false claim for this reason, unless it `holds`.
fn shown(holds: bool, reason: impl fmt::Display) -> Result<(), Fault> {
    claim(holds, format_args!("{reason} (H4)"))
}

fn flight(work: &Work, n: usize, pieces: u64, go_on: GoOn) -> Result<(), Fault> {
    let (cell, letter) = (&work.cell, &work.numbers.letters[n]);
    let all = |mut strengths: Vec<Interval>| {
        let first = strengths.pop()?;
        cell.impact(strengths.into_iter().fold(first, Interval::hull))
    };
    let first = all(letter.previous.iter().map(|&m| work.strength(m, n)).collect());
    let last = all(letter.next.iter().map(|&k| work.strength(n, k)).collect());
    let (Some(first), Some(last)) = (first, last) else {
        return shown(false, "an impact may be outside the window");
    };
    let legs = Legs { work, first, after: letter.after.all };
    for k in 0..=letter.periods {
        let from = if k == 0 { first.phase } else { -cell.wall.window };
        let to = if k == letter.periods { last.phase } else { cell.wall.window };
        let least = window(&legs, k, from.hull(to), pieces, go_on)?;
        if 0 < k && k < letter.periods {
            let motion = legs.motion(k, Interval::ZERO);
            let dip = (cell.depth * motion.velocity.squared()).over(least + least);
            let holds = (motion.place - cell.side - dip).is_positive();
            shown(holds, format_args!("the wall may be met in window {k}"))?;
        }
    }
    // One of both walls has the windows k and k + 1, or k and k + 2.
    let pi = Interval::PI;
    let next = pi + pi - cell.wall.window;
    for k in 0..letter.periods {
        let end = if cell.mirrored && k + 1 == letter.periods { pi + last.phase } else { next };
        let time = cell.wall.window.hull(end);
        between(&legs, time, pieces, go_on, &format!("after window {k}"), |t| legs.motion(k, t).place)?;
    }
    if cell.mirrored {
        let time = (pi + first.phase).hull(next);
        between(&legs, time, pieces, go_on, "before window 1", |t| legs.before(t))?;
    }
    Ok(())
}

/// That the gap is convex in window k, in this part of it; the least of its second derivatives.
fn window(legs: &Legs, k: u64, window: Interval, pieces: u64, go_on: GoOn) -> Result<Interval, Fault> {
    let cell = &legs.work.cell;
    let mut curvature: Option<Interval> = None;
    for piece in 0..pieces {
        go_on()?;
        let t = window.part(piece, pieces);
        let motion = legs.motion(k, t);
        let here = (cell.wall.at(t).bend + cell.depth * motion.acceleration).least();
        shown(here.is_positive(), format_args!("the gap may not be convex in window {k}"))?;
        let holds = legs.is_within_reach(motion.place);
        shown(holds, format_args!("the motion may go beyond its reach in window {k}"))?;
        curvature = Some(curvature.map_or(here, |least| least.hull(here).least()));
    }
    Ok(curvature.unwrap_or(Interval::WHOLE))
}

/// That a wall's gap is positive at all these times since the middle of one of its windows.
fn between(
    legs: &Legs,
    time: Interval,
    pieces: u64,
    go_on: GoOn,
    when: &str,
    place: impl Fn(Interval) -> Interval,
) -> Result<(), Fault> {
    let cell = &legs.work.cell;
    for piece in 0..pieces {
        go_on()?;
        let t = time.part(piece, pieces);
        let place = place(t);
        let gap = cell.wall.at(t).drop + cell.depth * (place - cell.side);
        shown(gap.is_positive(), format_args!("the gap may not be positive {when}"))?;
        shown(legs.is_within_reach(place), format_args!("the motion may go beyond its reach {when}"))?;
    }
    Ok(())
}
