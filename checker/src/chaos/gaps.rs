//! The condition H4: strictly between impacts the gap to the wall is positive.
//!
//! The gap is Z = q − w, and with q = ν q̂ it is Z = 1 − g(t) + ν (q̂ − σ), Z″ = −g″(t) + ν q̂″. A window is
//! 2πk − W ≤ t ≤ 2πk + W. Where Z″ > 0 on the first window from the first impact on, Z = 0 < Z′ at that
//! impact keeps Z > 0; likewise backwards from the last. Where Z″ ≥ m > 0 on a window between, Z ≥ Z(2πk) −
//! Z′(2πk)²/2m on it, which is ν times q̂ − σ − ν q̂′²/2m. Between windows Z > 0 is shown outright.

use super::{
    Fault,
    fixed::Interval,
    legs::turn,
    work::{GoOn, Work},
};

/// Proves it for every letter of a cell, and that q̂ stays below the reach.
pub(super) fn open(work: &Work, pieces: u64, go_on: GoOn) -> Result<(), Fault> {
    (0..work.numbers.letters.len()).try_for_each(|n| {
        flight(work, n, pieces, go_on).map_err(|fault| fault.at(format!("letter {}", n + 1)))
    })
}

/// Of all legs of a letter, at a time since the middle of their first window.
struct Motion {
    place: Interval,
    velocity: Interval,
    acceleration: Interval,
}

fn flight(work: &Work, n: usize, pieces: u64, go_on: GoOn) -> Result<(), Fault> {
    let wrong = |reason: String| Err(Fault::False(format!("{reason} (H4)")));
    let (cell, letter) = (&work.cell, &work.numbers.letters[n]);
    let all = |mut strengths: Vec<Interval>| {
        let first = strengths.pop()?;
        cell.impact(strengths.into_iter().fold(first, Interval::hull))
    };
    let first = all(letter.previous.iter().map(|&m| work.strength(m, n)).collect());
    let last = all(letter.next.iter().map(|&k| work.strength(n, k)).collect());
    // A letter that nothing precedes is on no path.
    let (Some(first), Some(last)) = (first, last) else {
        return if letter.previous.is_empty() {
            Ok(())
        } else {
            wrong("an impact may be outside the window".into())
        };
    };
    let motion = |k: u64, t: Interval| {
        // E(2πk + t − t₁), the first factor known.
        let e = cell.flow.times(work.turns(k), cell.flow.exp(t - first.phase));
        let (fallen, speed) = cell.fall(turn(k) + t - first.phase);
        let (place, velocity) = cell.flow.apply(e, first.place, letter.after.all);
        let (place, velocity) = (place + fallen, velocity + speed);
        Motion { place, velocity, acceleration: cell.acceleration(place, velocity) }
    };
    let bounded = |motion: &Motion| motion.place.is_below(work.numbers.reach);
    let mut least = Vec::new();
    for k in 0..=letter.periods {
        let from = if k == 0 { first.phase } else { -cell.wall.window };
        let to = if k == letter.periods { last.phase } else { cell.wall.window };
        let window = from.until(to);
        let mut curvature: Option<Interval> = None;
        for piece in 0..pieces {
            go_on()?;
            let t = window.part(piece, pieces);
            let motion = motion(k, t);
            let here = (cell.wall.at(t).bend + cell.depth * motion.acceleration).least();
            if !here.is_positive() {
                return wrong(format!("the gap may not be convex in window {k}"));
            }
            if !bounded(&motion) {
                return wrong(format!("the motion may go beyond its reach in window {k}"));
            }
            curvature = Some(curvature.map_or(here, |least| least.hull(here).least()));
        }
        least.push(curvature.unwrap_or(Interval::WHOLE));
    }
    let between = cell.wall.window.until(turn(1) - cell.wall.window);
    for k in 0..letter.periods {
        for piece in 0..pieces {
            go_on()?;
            let t = between.part(piece, pieces);
            let motion = motion(k, t);
            let gap = cell.wall.at(t).drop + cell.depth * (motion.place - cell.side);
            if !gap.is_positive() {
                return wrong(format!("the gap may not be positive after window {k}"));
            }
            if !bounded(&motion) {
                return wrong(format!("the motion may go beyond its reach after window {k}"));
            }
        }
    }
    for k in 1..letter.periods {
        let motion = motion(k, Interval::ZERO);
        let bound = least[k as usize];
        let dip = (cell.depth * motion.velocity.squared()).over(bound + bound);
        if !(motion.place - cell.side - dip).is_positive() {
            return wrong(format!("the wall may be met in window {k}"));
        }
    }
    Ok(())
}
