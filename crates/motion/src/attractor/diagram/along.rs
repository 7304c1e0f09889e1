//! A periodic orbit followed over a parameter by Newton's method, as long as it attracts, and where it ends.
//!
//! A motion that is started at the next value from where it was at the last one is off by as much as the
//! orbit moved between them: near the orbit's end it is thrown off it, the earlier the longer the step. The
//! orbit itself has no such error, so what follows it comes to one place whatever values are looked at.

use crate::{
    attractor::{
        confirm::{Size, fixed_point},
        dynamics::{Dynamics, Motion, SectionState},
        observe::{Attraction, Observation},
        portrait::{OnAttractor, settle},
    },
    error::Result,
    monitor::Monitor,
    motion::{RunEnd, Time},
    rounding::CIRCLE,
};

/// How the attraction of an orbit ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// A multiplier comes to 1.
    Fold,
    /// A multiplier comes to −1.
    Flip,
    /// A pair comes to the unit circle.
    Torus,
    /// It meets a stop, or no longer, or another time.
    Grazing,
    /// It is none of these as far as is seen.
    Unknown,
}

impl Ends {
    /// As in reports.
    pub fn name(self) -> &'static str {
        match self {
            Ends::Fold => "saddle-node",
            Ends::Flip => "flip",
            Ends::Torus => "neimark-sacker",
            Ends::Grazing => "grazing",
            Ends::Unknown => "unknown",
        }
    }
}

/// An orbit as far as it attracts.
pub(super) struct Along<S> {
    /// The last value at which it is known to attract.
    pub stays: f64,
    /// A state on it there.
    pub start: S,
    /// The first value at which there is none that attracts near it, and how it ended, if it did.
    pub left: Option<(f64, Ends)>,
}

/// In one step an orbit moves by no more than this part of its extent where that was largest: relative to
/// what it is now, one that shrinks to nothing would never come there.
const MOVES: f64 = 0.02;
/// A motion that comes back this near, relative to its largest coordinate, is on an orbit.
const CLOSED: f64 = 1e-10;
/// Steps are halved to this part of the way, or until two values are neighbours.
const LEAST: f64 = 1e-13;
/// A multiplier this near to the unit circle, and as many times nearer than where the way began, is at it.
const AT_THE_CIRCLE: f64 = 1e-2;
/// How often a motion that an orbit no longer holds is followed on between two values.
const LEGS: u32 = 6;
/// Where the motion is looked at beyond the end of an orbit: this part of what is left of the way.
const BEYOND: f64 = 1.0 / 64.0;

/// A fixed point with the multiplier nearest to the unit circle, and how far that is from it.
struct Place {
    x: Vec<f64>,
    multiplier: (f64, f64),
    distance: f64,
    impacts: u64,
}

fn place<D: Dynamics>(dynamics: &D, from: &[f64], phase: f64, period: u32) -> Result<Option<Place>> {
    let Some(found) = fixed_point(dynamics, from, phase, period.into())? else { return Ok(None) };
    let Some(all) = D::multipliers(&found.slope, None) else { return Ok(None) };
    let distance = |(re, im): &(f64, f64)| (re.hypot(*im) - 1.0).abs();
    let radius = all.iter().map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
    let Some(&multiplier) = all.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))) else {
        return Ok(None);
    };
    if radius > 1.0 + CIRCLE {
        return Ok(None);
    }
    let (impacts, end) = round(dynamics, &found.x, phase, period)?;
    // Newton's method stops, too, where its steps come to nothing beside a touch.
    let open = CLOSED * Size::of(dynamics, &found.x, phase)?.magnitude;
    let closed = end.is_some_and(|end| end.iter().zip(&found.x).all(|(a, b)| (a - b).abs() <= open));
    Ok(closed.then(|| Place { distance: distance(&multiplier), x: found.x, multiplier, impacts }))
}

/// Impacts in a period from there, and where it ends, if it does not before.
fn round<D: Dynamics>(dynamics: &D, x: &[f64], phase: f64, period: u32) -> Result<(u64, Option<Vec<f64>>)> {
    let Ok(mut run) = dynamics.begin(&dynamics.at(x, phase)) else { return Ok((0, None)) };
    let begun = run.time();
    let end = run.pass(Time { period: begun.period + i64::from(period), ..begun })?;
    let here = (end == RunEnd::Reached).then(|| run.point().coordinates().to_vec());
    Ok((run.impacts(), here))
}

/// Follows the orbit that `on` is on at `from` towards `to`; none where it is not periodic, or where between
/// the two there is no system. Cost: some five rounds with vectors for each step, of which there are about a
/// hundred where the orbit ends.
///
/// # Errors
/// Those of the system and of its motions; the monitor's.
pub(super) fn along<D: Dynamics>(
    on: &OnAttractor<D::Start>,
    [from, to]: [f64; 2],
    phase: f64,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Option<Along<D::Start>>> {
    let Some(period) = on.portrait.period else { return Ok(None) };
    let mut system = dynamics(from)?;
    let Ok(run) = system.begin(&on.start) else { return Ok(None) };
    let Some(mut here) = place(&system, run.point().coordinates(), phase, period)? else { return Ok(None) };
    drop(run);
    let first = here.distance;
    // Not every parameter is one of a system between two that are.
    let system_at = |value: f64| match dynamics(value) {
        Err(error) if error.is_input() => Ok(None),
        system => system.map(Some),
    };
    let (mut at, mut step, mut left, mut scale) = (from, to - from, None, 0.0f64);
    while at != to {
        monitor.advance(0)?;
        let next = if (to - at).abs() <= step.abs() { to } else { at + step };
        let is_least = step.abs() <= LEAST * (to - from).abs().max(at.abs()) || next == at;
        if is_least && let Some(left) = left {
            // A simulator tells a touch from none up to a distance.
            let Some(beyond) = system_at(at + BEYOND * (to - at))? else { return Ok(None) };
            let (impacts, _) = round(&beyond, &here.x, phase, period)?;
            let left = Some((left, kind(&here, first, impacts)));
            return Ok(Some(Along { stays: at, start: system.at(&here.x, phase), left }));
        }
        let Some(there) = system_at(next)? else { return Ok(None) };
        let size = Size::of(&system, &here.x, phase)?;
        scale = scale.max(size.extent);
        // From rest all is far.
        let moved = if scale <= size.part(0.0) { f64::INFINITY } else { MOVES * scale };
        let found = place(&there, &here.x, phase, period)?;
        let near = |found: &Place| found.x.iter().zip(&here.x).all(|(a, b)| (a - b).abs() <= moved);
        match found.filter(near) {
            Some(found) => (at, system, here, step) = (next, there, found, 2.0 * step),
            None => {
                left = Some(next);
                step /= 2.0;
            }
        }
    }
    Ok(Some(Along { stays: at, start: system.at(&here.x, phase), left: None }))
}

/// What ended an orbit: of the last place known of it, with the distance from the unit circle where the way
/// began, and the impacts from there just beyond.
fn kind(last: &Place, first: f64, impacts: u64) -> Ends {
    let (re, im) = last.multiplier;
    if last.distance < AT_THE_CIRCLE && last.distance <= AT_THE_CIRCLE * first {
        return match im.abs() > AT_THE_CIRCLE {
            true => Ends::Torus,
            false if re > 0.0 => Ends::Fold,
            false => Ends::Flip,
        };
    }
    if impacts == last.impacts { Ends::Unknown } else { Ends::Grazing }
}

/// What the motion comes to at `to` that had settled at `from`, the parameter moved so slowly that it stays
/// on an orbit as long as that attracts: see `settle`.
///
/// # Errors
/// Those of [`along`] and `settle`.
pub(crate) fn arrive<D: Attraction>(
    on: &OnAttractor<D::Start>,
    [from, to]: [f64; 2],
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Option<OnAttractor<D::Start>>> {
    let phase = observation.phase;
    let (mut at, mut on) = (from, on.clone());
    for _ in 0..LEGS {
        let Some(Along { start, left, .. }) = along(&on, [at, to], phase, dynamics, monitor)? else {
            break;
        };
        on.start = start;
        let Some((left, _)) = left else { break };
        let next = left + BEYOND * (to - left);
        match settle(&dynamics(next)?, &on.start, observation, monitor)? {
            Some(there) if there.portrait.period.is_some() => (at, on) = (next, there),
            _ => break,
        }
    }
    settle(&dynamics(to)?, &on.start, observation, monitor)
}
