//! How far coordinates go along a periodic orbit.

use std::f64::consts::TAU;

use crate::error::Result;

/// Looks per forcing period.
const LOOKS: f64 = 64.0;
/// So near its ends, as a part of it, a flight is looked at: at an impact a velocity has two values.
const INSIDE: f64 = 1e-9;
/// A step so short, as a part of the time between two looks, is the last to a turning point.
const CLOSE: f64 = 1e-9;
/// Most steps to one.
const STEPS: u32 = 60;

/// The least and the greatest of each coordinate over an orbit of so many radians, whose flights begin at
/// `starts`, 0 and ascending; `state` gives each coordinate with its velocity. Turning points are known to
/// rounding; of two within a look neither is seen. Cost: 64 looks per forcing period, some ten for each
/// turning point.
///
/// # Errors
/// Those of `state`.
pub fn extents(
    starts: &[f64],
    period: f64,
    state: impl Fn(f64) -> Result<Vec<[f64; 2]>>,
) -> Result<Vec<[f64; 2]>> {
    let first = state(0.0)?;
    let mut all: Vec<[f64; 2]> = first.iter().map(|[q, _]| [*q; 2]).collect();
    let mut widen = |i: usize, q: f64| all[i] = [all[i][0].min(q), all[i][1].max(q)];
    for (flight, &from) in starts.iter().enumerate() {
        let to = starts.get(flight + 1).copied().unwrap_or(period);
        let looks = ((to - from) / TAU * LOOKS).ceil().max(1.0);
        let time = |look: f64| from + (to - from) * (look / looks).clamp(INSIDE, 1.0 - INSIDE);
        let mut before = (time(0.0), state(time(0.0))?);
        for look in 1..=looks as u32 {
            let here = (time(look.into()), state(time(look.into()))?);
            for i in 0..first.len() {
                widen(i, here.1[i][0]);
                let ends = [(before.0, before.1[i][1]), (here.0, here.1[i][1])];
                if ends[0].1 * ends[1].1 < 0.0 {
                    widen(i, turning_point(i, ends, &state)?);
                }
            }
            before = here;
        }
        state(to)?.iter().enumerate().for_each(|(i, [q, _])| widen(i, *q));
    }
    Ok(all)
}

/// A coordinate where its velocity changes sign between two times: there it moves by the square of what is
/// missing of the time.
fn turning_point(
    i: usize,
    [mut a, mut b]: [(f64, f64); 2],
    state: &impl Fn(f64) -> Result<Vec<[f64; 2]>>,
) -> Result<f64> {
    let (width, mut kept) = (b.0 - a.0, None);
    let mut found = f64::NAN;
    for step in 0..STEPS {
        let secant = b.0 - b.1 * (b.0 - a.0) / (b.1 - a.1);
        let middle = if step % 8 < 7 && secant > a.0 && secant < b.0 { secant } else { 0.5 * (a.0 + b.0) };
        let [q, u] = state(middle)?[i];
        let upper = (u < 0.0) == (b.1 < 0.0);
        let (moved, other) = if upper { (&mut b, &mut a) } else { (&mut a, &mut b) };
        let way = (moved.0 - middle).abs();
        *moved = (middle, u);
        // The end that stays twice counts half.
        if kept == Some(upper) {
            other.1 /= 2.0;
        }
        (kept, found) = (Some(upper), q);
        if u == 0.0 || way <= CLOSE * width {
            break;
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball's hops, of heights 1/2 and 2, and a sine beside it.
    #[test]
    fn turning_points_are_known_to_rounding_and_impacts_are_ends() {
        let state = |t: f64| {
            let (begin, half) = if t <= 2.0 { (0.0, 1.0) } else { (2.0, 2.0) };
            let t0 = t - begin;
            Ok(vec![[t0 * half - 0.5 * t0 * t0 - 3.0, half - t0], [(t - 0.3).sin(), (t - 0.3).cos()]])
        };
        let found = extents(&[0.0, 2.0], 6.0, state).unwrap();
        let wanted = [[-3.0, -1.0], [-1.0, 1.0]];
        for (found, wanted) in found.iter().flatten().zip(wanted.iter().flatten()) {
            assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
        }
    }
}
