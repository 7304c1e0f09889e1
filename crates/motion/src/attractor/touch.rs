//! What is seen at a touch: what attracts just before and just beyond it, whether the motion stays near or
//! jumps, and where, swept back, it returns.
//!
//! What is *born* at a touch exists, and is mostly unstable; what is *seen* attracts. All here is found by
//! following motions: evidence, not proof. Not here: what is born
//! (`pattern`).

use super::{
    diagram::{Jump, Look, SweepStep, arrive, jump},
    observe::{Attraction, Observation},
    portrait::{OnAttractor, Portrait, range, settle},
};
use crate::{error::Result, monitor::Monitor};

/// How far from the touch to look: there the least gap is this part of the motion's width, of either sign.
const NEAR: f64 = 1e-4;

/// The second look is this many times nearer. What grows with the root of the distance falls to a quarter.
const NEARER: f64 = 16.0;

/// A motion whose extent and impacts differ by less than this part of the size of motions has stayed.
const STAYS: f64 = 0.1;

/// The motion settles until what is left of a small disturbance is this part of it, or for this many periods.
const LEFT_OVER: f64 = 1e-9;
const LONGEST: f64 = 20_000.0;

/// Steps back: in each the least gap opens by 1/64 of the motion's width.
const STEPS: u32 = 63;
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
    /// The largest modulus of its multipliers.
    pub slowest: f64,
    /// The width of that orbit, in the unit of gaps.
    pub width: f64,
}

/// What is seen on one side.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside<S> {
    /// The parameter's value.
    pub parameter: f64,
    /// What the orbit's state leads to there; none where that leaves every bound.
    pub settled: Option<OnAttractor<S>>,
    /// Whether it stays near the orbit that touches: what differs is small, or shrinks with the distance.
    pub near: bool,
}

/// What is seen at a touch.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen<S> {
    /// How it was looked at.
    pub look: Look,
    /// The orbit that touches, as it is just before.
    pub before: Beside<S>,
    /// Just beyond.
    pub beyond: Beside<S>,
    /// Of a jump, where the motion that it leads to is left as the parameter goes back; none if it is not, so
    /// far as looked.
    pub back: Option<Jump<S>>,
    /// Of a jump, the last value looked at, and what is seen there.
    pub back_to: Option<(f64, Option<OnAttractor<S>>)>,
}

impl<S> Touch<S> {
    /// The periods in which a motion settles near the orbit, where it attracts.
    fn settling(&self) -> u64 {
        let rounds = LEFT_OVER.ln() / self.slowest.ln();
        if rounds > 0.0 { (rounds * f64::from(self.periods)).min(LONGEST) as u64 } else { 0 }
    }

    /// The parameter at which the least gap is this part of the motion's width.
    fn at(&self, part: f64) -> f64 {
        self.parameter + part * self.width / self.e
    }

    /// Looked at for longer than `look` says where damping is weak.
    fn looks(&self, look: &Look) -> Look {
        Look { transient: look.transient.max(self.settling()), ..look.clone() }
    }
}

fn observation(look: &Look) -> Observation {
    let Look { phase, transient, points, longest } = *look;
    Observation { phase, transient, longest, points, round: Some(1), every: 1 }
}

/// What is seen just before a touch and just beyond it. Cost: up to four times `settle`, each for longer
/// than `look` says where damping is weak.
///
/// # Errors
/// Those of the system and of `settle`.
pub fn beside<D: Attraction>(
    touch: &Touch<D::Start>,
    look: &Look,
    dynamics: impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<[Beside<D::Start>; 2]> {
    let observation = observation(&touch.looks(look));
    let at = |parameter: f64| settle(&dynamics(parameter)?, &touch.start, &observation, monitor);
    // The orbit itself, whether it attracts or not.
    let nearest = dynamics(touch.at(NEAR / NEARER))?;
    let orbit = range(&mut nearest.begin(&touch.start)?, touch.periods)?;
    // In the unit of gaps, for a machine at rest before a stop that moves has no width of its own.
    let differs = |one: &Portrait| orbit.map(|orbit| one.range.moved(&orbit) / touch.width);
    let side = |sign: f64| -> Result<Beside<D::Start>> {
        let parameter = touch.at(sign * NEAR);
        let settled = at(parameter)?;
        let near = match settled.as_ref().and_then(|settled| differs(&settled.portrait)) {
            Some(first) if first < STAYS => true,
            Some(first) => {
                let nearer = at(touch.at(sign * NEAR / NEARER))?;
                nearer.and_then(|nearer| differs(&nearer.portrait)).is_some_and(|second| second < first / 2.0)
            }
            None => false,
        };
        Ok(Beside { parameter, settled, near })
    };
    Ok([side(1.0)?, side(-1.0)?])
}

/// What is seen at a touch, and where the way back ends. Cost: that of [`beside`], and of a jump up to 80
/// times `settle` more.
///
/// # Errors
/// As [`beside`].
pub fn seen<D: Attraction>(
    touch: &Touch<D::Start>,
    look: &Look,
    dynamics: impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Seen<D::Start>> {
    let [before, beyond] = beside(touch, look, &dynamics, monitor)?;
    let look = touch.looks(look);
    let observation = observation(&look);
    let step = SweepStep { value: beyond.parameter, settled: beyond.settled.clone(), anew: true };
    let mut seen = Seen { look, before, beyond, back: None, back_to: None };
    if seen.beyond.near || seen.beyond.settled.is_none() {
        return Ok(seen);
    }
    let mut last = step;
    for i in 1..=STEPS {
        monitor.advance(0)?;
        let value = touch.at(f64::from(i) * STEP);
        let Some(from) = last.settled.as_ref() else { break };
        let settled = arrive(from, [last.value, value], &observation, &dynamics, monitor)?;
        let next = SweepStep { value, settled, anew: false };
        seen.back_to = Some((value, next.settled.clone()));
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
