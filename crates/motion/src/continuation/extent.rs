//! How far coordinates go along a periodic orbit.

use std::f64::consts::TAU;

use super::FollowedOrbit;
use crate::error::Result;

/// Looks per forcing period.
const LOOKS: f64 = 64.0;
/// So near its ends, as a part of it, a flight is looked at: at an impact a velocity has two values.
const INSIDE: f64 = 1e-9;
/// Halvings to a turning point: the place there moves by the square of what is missing of the time.
const HALVINGS: u32 = 30;

/// The least and the greatest of each coordinate over an orbit; `state` gives each with its velocity at a
/// time ≥ 0 after the first impact. Turning points are known to rounding; of two between looks, 64 per
/// forcing period, neither is seen.
///
/// # Errors
/// Those of `state`.
pub fn extents(
    orbit: &impl FollowedOrbit,
    state: impl Fn(f64) -> Result<Vec<[f64; 2]>>,
) -> Result<Vec<[f64; 2]>> {
    let (pattern, unknowns) = (orbit.pattern(), orbit.unknowns());
    let times: Vec<f64> = (0..unknowns.len()).filter(|i| orbit.is_time(*i)).map(|i| unknowns[i]).collect();
    let whole = |i: usize| {
        TAU * pattern.strikes().iter().take(i).map(|strike| f64::from(strike.periods)).sum::<f64>()
    };
    let mut ends: Vec<f64> = (1..times.len()).map(|i| whole(i) + times[i] - times[0]).collect();
    ends.push(TAU * f64::from(pattern.periods()));
    let mut all = vec![[f64::INFINITY, f64::NEG_INFINITY]; state(0.0)?.len()];
    let mut widen = |i: usize, [q, _]: [f64; 2]| all[i] = [all[i][0].min(q), all[i][1].max(q)];
    let mut from = 0.0;
    for to in ends {
        let looks = ((to - from) / TAU * LOOKS).ceil().max(1.0);
        let time = |look: u32| from + (to - from) * (f64::from(look) / looks).clamp(INSIDE, 1.0 - INSIDE);
        state(to)?.into_iter().enumerate().for_each(|(i, place)| widen(i, place));
        let mut before = state(time(0))?;
        for look in 1..=looks as u32 {
            let here = state(time(look))?;
            for (i, place) in here.iter().enumerate() {
                widen(i, *place);
                let (mut low, mut high) = (time(look - 1), time(look));
                for _ in 0..if before[i][1] * place[1] < 0.0 { HALVINGS } else { 0 } {
                    let middle = 0.5 * (low + high);
                    let turning = state(middle)?[i];
                    *(if turning[1] * place[1] > 0.0 { &mut high } else { &mut low }) = middle;
                    widen(i, turning);
                }
            }
            before = here;
        }
        from = to;
    }
    Ok(all)
}
