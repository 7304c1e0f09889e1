//! What is seen at a touch: what attracts just before and just beyond it, whether the motion stays near or
//! jumps, and where, swept back, it returns.
//!
//! What is *born* at a touch exists, and is mostly unstable; what is *seen* attracts. All here is found by
//! following motions: evidence, not proof. Not here: what is born
//! (`pattern`).

use super::{
    diagram::{Jump, Look, SweepStep, jump},
    observe::{Attraction, Observation},
    portrait::{Portrait, apart, range, settle},
};
use crate::{Monitor, error::Result};

/// How far from the touch to look: there the least gap is this part of the motion's width, of either sign.
const NEAR: f64 = 1e-4;

/// The second look is this many times nearer. What grows with the root of the distance falls to a quarter.
const NEARER: f64 = 16.0;

/// A motion whose extent differs by less than this part of its width has stayed.
const STAYS: f64 = 0.1;

/// Steps back: in each the least gap opens by 1/64 of the motion's width.
const STEPS: u32 = 128;
const STEP: f64 = 1.0 / 64.0;

/// A touch, as what moves there is followed.
#[derive(Debug, Clone)]
pub struct Touch<S> {
    /// The parameter's value.
    pub parameter: f64,
    /// How fast the least gap opens with the parameter: positive if the touch is reached from above.
    pub e: f64,
    /// A state of the orbit that touches, at a phase at which it is not near a stop.
    pub start: S,
    /// Its period, in forcing periods.
    pub periods: u32,
    /// The width of that orbit, in the unit of gaps.
    pub width: f64,
}

/// What is seen on one side.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// The parameter's value.
    pub parameter: f64,
    /// What the orbit's state leads to there; none where that leaves every bound.
    pub portrait: Option<Portrait>,
    /// Whether it stays near the orbit that touches: what differs is small, or shrinks with the distance.
    pub near: bool,
}

/// What is seen at a touch.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// The orbit that touches, as it is just before.
    pub before: Beside,
    /// Just beyond.
    pub beyond: Beside,
    /// Of a jump, where the motion that it leads to is left as the parameter goes back; none if it is not, so
    /// far as looked.
    pub back: Option<Jump>,
    /// Of a jump, the last value looked at, and what is seen there.
    pub back_to: Option<(f64, Option<Portrait>)>,
}

/// What is seen at a touch. Cost: up to four times [`settle`], and of a jump up to 140 times more.
///
/// # Errors
/// Those of the system and of [`settle`].
pub fn seen<D: Attraction>(
    touch: &Touch<D::Start>,
    look: &Look,
    dynamics: impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Seen> {
    let Look { phase, transient, points, longest } = *look;
    let observation = Observation { phase, transient, longest, points, round: Some(1), every: 1 };
    // A change of the parameter that opens the gap by this part of the width.
    let away = |part: f64| part * touch.width / touch.e;
    let at = |parameter: f64| settle(&dynamics(parameter)?, &touch.start, &observation, monitor);
    // The orbit itself, whether it attracts or not.
    let nearest = dynamics(touch.parameter + away(NEAR / NEARER))?;
    let orbit = range(&mut nearest.begin(&touch.start)?, touch.periods)?;
    let differs = |one: &Portrait| orbit.map(|orbit| apart(one.extent, orbit.extent));
    let beside = |sign: f64| -> Result<(Beside, SweepStep<D::Start>)> {
        let parameter = touch.parameter + away(sign * NEAR);
        let settled = at(parameter)?;
        let near = match settled.as_ref().and_then(|settled| differs(&settled.portrait)) {
            Some(first) if first < STAYS => true,
            Some(first) => {
                let nearer = at(touch.parameter + away(sign * NEAR / NEARER))?;
                nearer.and_then(|nearer| differs(&nearer.portrait)).is_some_and(|second| second < first / 2.0)
            }
            None => false,
        };
        let portrait = settled.as_ref().map(|settled| settled.portrait.clone());
        Ok((Beside { parameter, portrait, near }, SweepStep { value: parameter, settled, anew: true }))
    };
    let (before, _) = beside(1.0)?;
    let (beyond, step) = beside(-1.0)?;
    let mut seen = Seen { before, beyond, back: None, back_to: None };
    if seen.beyond.near || seen.beyond.portrait.is_none() {
        return Ok(seen);
    }
    let mut last = step;
    for i in 1..=STEPS {
        monitor.advance(0)?;
        let value = touch.parameter + away(f64::from(i) * STEP);
        let Some(from) = last.settled.as_ref().map(|settled| &settled.start) else { break };
        let settled = settle(&dynamics(value)?, from, &observation, monitor)?;
        let next = SweepStep { value, settled, anew: false };
        let here = next.settled.as_ref().map(|settled| settled.portrait.clone());
        seen.back_to = Some((value, here));
        let pair = [last, next];
        let changed = match (&pair[0].settled, &pair[1].settled) {
            (Some(a), Some(b)) => a.portrait.apart(&b.portrait) > STAYS,
            _ => true,
        };
        if changed && let Some(found) = jump(&pair, &observation, &dynamics, monitor)? {
            seen.back = Some(found);
            break;
        }
        let [_, next] = pair;
        last = next;
    }
    Ok(seen)
}
