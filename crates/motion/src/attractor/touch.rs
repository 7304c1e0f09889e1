//! What is seen at a touch: what attracts just before and just beyond it, whether the motion stays near or
//! jumps, where, swept back, it returns, and from where on a motion that begins at rest hits.
//!
//! What is *born* at a touch exists, and is mostly unstable; what is *seen* attracts. All here is found by
//! following motions: evidence, not proof. Not here: what is born
//! (`pattern`).

pub use super::hitting::Touch;
use super::{
    diagram::{Jump, Look, SweepStep},
    hitting::{Hitting, Known, STAYS, STEP, back, hitting},
    observe::{Attraction, Observation},
    portrait::{OnAttractor, Portrait, range, settle},
};
use crate::{error::Result, monitor::Monitor};

/// How far from the touch to look: there the least gap is this part of the motion's width, of either sign.
const NEAR: f64 = 1e-4;

/// The second look is this many times nearer. What grows with the root of the distance falls to a quarter.
const NEARER: f64 = 16.0;

/// The motion settles until what is left of a small disturbance is this part of it, or for this many periods.
const LEFT_OVER: f64 = 1e-9;
const LONGEST: f64 = 20_000.0;

/// Values before the touch at which a motion is begun at rest, two steps of a way back apart: as far as the
/// least gap is open by half of the width, where the parameter is the drive to none of it.
const RESTS: u32 = 16;

/// How often the last two of them are halved.
const HALVED: u32 = 9;

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
    /// Of a jump, the last value looked at, or the first at which the motion hits no more, and what is seen
    /// there.
    pub back_to: Option<(f64, Option<OnAttractor<S>>)>,
    /// Where motions that begin at rest hit, before the touch; none where that was not asked for or is not
    /// decided at any value.
    pub rest: Option<FromRest<S>>,
    /// How far before the touch a motion that hits was found; none where that was not asked for.
    pub hitting: Option<Hitting>,
}

/// Where motions that begin at rest hit for ever, of the values looked at before a touch.
#[derive(Debug, Clone, PartialEq)]
pub struct FromRest<S> {
    /// The value farthest from the touch at which such a motion hits, or the last one looked at if none does.
    pub parameter: f64,
    /// What it is on there.
    pub settled: OnAttractor<S>,
    /// At how many of the values looked at from there to the touch it hits.
    pub hits: u32,
    /// How many these are.
    pub looked: u32,
    /// At how many of them it is not decided, or leaves every bound, or begins behind a stop.
    pub open: u32,
}

impl<S> Touch<S> {
    /// The periods in which a motion settles near the orbit, where it attracts.
    fn settling(&self) -> u64 {
        let rounds = LEFT_OVER.ln() / self.slowest.ln();
        if rounds > 0.0 { (rounds * f64::from(self.periods)).min(LONGEST) as u64 } else { 0 }
    }

    /// Looked at for longer than `look` says where damping is weak.
    fn looks(&self, look: &Look) -> Look {
        Look { transient: look.transient.max(self.settling()), ..look.clone() }
    }
}

fn observation(look: &Look) -> Observation {
    let Look { phase, transient, points, longest } = *look;
    Observation { phase, transient, longest, points, round: true, every: 1 }
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

/// What is seen at a touch, where the way back ends, and from where on a motion that begins at rest hits.
/// Cost: that of [`beside`], and of a jump up to 80 times `settle` more; from rest and from other starts 40
/// times.
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
    let step = SweepStep { value: beyond.parameter, settled: beyond.settled.clone(), anew: false };
    let rest = from_rest(touch, &observation, &dynamics, monitor)?;
    let mut seen = Seen { look, before, beyond, back: None, back_to: None, rest, hitting: None };
    let jumps = !seen.beyond.near && seen.beyond.settled.is_some();
    let far = jumps.then(|| back(touch, (step, 1), &observation, &dynamics, monitor)).transpose()?;
    if !touch.others.is_empty() {
        let rest = seen.rest.as_ref().map(|rest| (rest.parameter, &rest.settled));
        let known = Known { beyond: far.as_ref(), rest, starts: 1 + RESTS };
        seen.hitting = Some(hitting(touch, &known, &observation, &dynamics, monitor)?);
    }
    if let Some(far) = far {
        (seen.back_to, seen.back) = (far.end(), far.jump);
    }
    Ok(seen)
}

/// Where a motion that begins at rest hits for ever, before the touch.
fn from_rest<D: Attraction>(
    touch: &Touch<D::Start>,
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Option<FromRest<D::Start>>> {
    let Some(start) = &touch.rest else { return Ok(None) };
    // None where it begins behind a stop, is lost, or does not settle.
    let at = |part: f64| -> Result<Option<OnAttractor<D::Start>>> {
        monitor.advance(0)?;
        let settled = settle(&dynamics(touch.at(part))?, start, observation, monitor)?;
        Ok(settled.filter(|settled| !settled.portrait.undecided))
    };
    let hits = |settled: &OnAttractor<D::Start>| settled.portrait.range.speed.is_some();
    let all = (0..RESTS)
        .map(|i| (2.0 * f64::from(i) + 1.0) * STEP)
        .map(|part| Ok((part, at(part)?)))
        .collect::<Result<Vec<_>>>()?;
    let count = |all: &[(f64, Option<OnAttractor<D::Start>>)],
                 what: &dyn Fn(&OnAttractor<D::Start>) -> bool| {
        all.iter().filter(|(_, settled)| settled.as_ref().is_some_and(what)).count() as u32
    };
    let Some(farthest) = all.iter().rposition(|(_, settled)| settled.as_ref().is_some_and(hits)) else {
        let open = RESTS - count(&all, &|_| true);
        let last = all.into_iter().rev().find_map(|(part, settled)| Some((part, settled?)));
        let row =
            |(part, settled)| FromRest { parameter: touch.at(part), settled, hits: 0, looked: RESTS, open };
        return Ok(last.map(row));
    };
    let beyond = all.get(farthest + 1).filter(|free| free.1.is_some()).map(|free| free.0);
    let near = &all[..=farthest];
    let (looked, open) = (near.len() as u32, near.len() as u32 - count(near, &|_| true));
    let number = count(near, &hits);
    let Some((mut part, Some(mut settled))) = all.into_iter().nth(farthest) else { return Ok(None) };
    if let Some(mut free) = beyond {
        for _ in 0..HALVED {
            let middle = part.midpoint(free);
            match at(middle)? {
                Some(found) if hits(&found) => (part, settled) = (middle, found),
                _ => free = middle,
            }
        }
    }
    Ok(Some(FromRest { parameter: touch.at(part), settled, hits: number, looked, open }))
}
