//! How far before a touch a motion that hits is found: what is seen beyond it and what several starts lead
//! to, each swept back until it hits no more.
//!
//! All is found by following motions: that none was found is evidence, not proof. Not here: whether one that
//! begins at rest hits (`touch`).

use super::{
    diagram::{Jump, SweepStep, arrive, jump},
    observe::{Attraction, Observation},
    portrait::{OnAttractor, Portrait, settle},
};
use crate::{error::Result, monitor::Monitor};

/// A motion whose extent and impacts differ by less than this part of the size of motions has stayed.
pub(super) const STAYS: f64 = 0.1;

/// Steps back: in each the least gap opens by 1/64 of the motion's width.
const STEPS: u32 = 63;
pub(super) const STEP: f64 = 1.0 / 64.0;

/// Where the other starts are tried, in steps: beside the touch, and where the gap is open by an eighth of
/// the width.
const TRIED: [f64; 2] = [0.25, 8.0];

/// Halvings of a step in which a motion ceases to hit, and is not seen to jump.
const HALVINGS: u32 = 4;

/// A touch, as what moves there is followed.
#[derive(Debug, Clone)]
pub struct Touch<S> {
    /// The parameter's value.
    pub parameter: f64,
    /// How fast the least gap opens with the parameter: positive if the touch is reached from above.
    pub e: f64,
    /// A state of the orbit that touches, at a phase at which it is not near a stop.
    pub start: S,
    /// A start at rest; none where it is not asked for.
    pub rest: Option<S>,
    /// Starts of other motions that may hit before the touch; none where it is not asked how far before it
    /// motions hit.
    pub others: Vec<S>,
    /// Its period, in forcing periods.
    pub periods: u32,
    /// The largest modulus of its multipliers.
    pub slowest: f64,
    /// The width of that orbit, in the unit of gaps.
    pub width: f64,
}

impl<S> Touch<S> {
    /// The parameter at which the least gap is this part of the motion's width.
    pub(super) fn at(&self, part: f64) -> f64 {
        self.parameter + part * self.width / self.e
    }
}

/// What was found of motions that hit before a touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hitting {
    /// The first value, farthest from the touch, at which the last of them has left; none if none was found.
    pub left: Option<f64>,
    /// Whether it still hits at the last value looked at, which is `left` then.
    pub stays: bool,
    /// How many motions were begun: from beyond, at rest and from the other starts.
    pub starts: u32,
    /// How many of the starts it was not decided of what they lead to.
    pub open: u32,
}

/// What is known before other starts are tried.
pub(super) struct Known<'k, S> {
    /// The motion beyond, swept back.
    pub beyond: Option<&'k Back<S>>,
    /// A value at which a motion from rest settled, and on what.
    pub rest: Option<(f64, &'k OnAttractor<S>)>,
    /// How many motions these are of.
    pub starts: u32,
}

/// A motion swept back from a touch.
pub(super) struct Back<S> {
    /// What it is on at each step, from the first on.
    steps: Vec<SweepStep<S>>,
    /// Where it first leaves what it was on.
    pub jump: Option<Jump<S>>,
    /// The first value at which it hits no more.
    left: Option<f64>,
    /// Whether it hits at all.
    hits: bool,
}

impl<S> Back<S> {
    /// The last value looked at, or the first at which it hits no more, and what is seen there.
    pub fn end(&self) -> Option<(f64, Option<OnAttractor<S>>)>
    where
        S: Clone,
    {
        self.steps
            .last()
            .filter(|_| self.steps.len() > 1)
            .map(|step| (self.left.unwrap_or(step.value), step.settled.clone()))
    }
}

fn hits<S>(on: &OnAttractor<S>) -> bool {
    on.portrait.range.speed.is_some()
}

/// Whether two motions at one value are taken for one: two that are not periodic are.
fn alike(one: &Portrait, other: &Portrait) -> bool {
    one.period.is_none() && other.period.is_none() || one.apart(other) <= STAYS
}

/// Sweeps a motion back from `first`, the next step being number `next`, until it hits no more. Cost: up
/// to 80 times `settle`.
pub(super) fn back<D: Attraction>(
    touch: &Touch<D::Start>,
    (first, next): (SweepStep<D::Start>, u32),
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Back<D::Start>> {
    let is_hitting = first.settled.as_ref().is_some_and(hits);
    let mut found = Back { steps: vec![first], jump: None, left: None, hits: is_hitting };
    for i in next..=STEPS {
        monitor.advance(0)?;
        let value = touch.at(f64::from(i) * STEP);
        let Some((last, from)) =
            found.steps.last().and_then(|step| Some((step.value, step.settled.as_ref()?)))
        else {
            break;
        };
        let settled = arrive(from, [last, value], observation, dynamics, monitor)?;
        found.steps.push(SweepStep { value, settled, anew: false });
        let pair = &found.steps[found.steps.len() - 2..];
        let changed = match (&pair[0].settled, &pair[1].settled) {
            (Some(a), Some(b)) => a.portrait.apart(&b.portrait) > STAYS,
            _ => true,
        };
        let jumped = if changed { jump(pair, observation, dynamics, monitor)? } else { None };
        match (pair[1].settled.as_ref().is_some_and(hits), &jumped, &pair[0].settled) {
            (true, ..) => {}
            (false, None, Some(on)) => {
                found.left = Some(fades((last, on), value, observation, dynamics, monitor)?);
            }
            (false, jumped, _) => found.left = Some(jumped.as_ref().map_or(value, |jump| jump.left)),
        }
        found.jump = found.jump.take().or(jumped);
        // Of an orbit with impacts it is asked where it is left, not where nothing hits.
        if found.left.is_some() || touch.rest.is_none() && found.jump.is_some() {
            break;
        }
    }
    Ok(found)
}

/// The first value at which a motion hits no more, between one at which it does and one at which it does not.
fn fades<D: Attraction>(
    (mut hit, on): (f64, &OnAttractor<D::Start>),
    mut free: f64,
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<f64> {
    let mut on = on.clone();
    for _ in 0..HALVINGS {
        let middle = hit.midpoint(free);
        match arrive(&on, [hit, middle], observation, dynamics, monitor)?.filter(hits) {
            Some(here) => (hit, on) = (middle, here),
            None => free = middle,
        }
    }
    Ok(free)
}

/// How far before a touch a motion that hits is found: the one that was swept back from beyond it, the one
/// from rest, and those to which the touch's other starts lead. Cost: `settle` for each start and value, and
/// that of `back` for each motion that is another.
pub(super) fn hitting<D: Attraction>(
    touch: &Touch<D::Start>,
    known: &Known<D::Start>,
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Hitting> {
    let mut others: Vec<Back<D::Start>> = Vec::new();
    let &Known { beyond, rest, mut starts } = known;
    let mut open = 0;
    // A step is known by its number, and a value between two by the one before.
    let step = |value: f64| ((value - touch.parameter) * touch.e / touch.width / STEP).max(0.0);
    let is_known = |others: &[Back<D::Start>], at: f64, on: &OnAttractor<D::Start>| {
        let like = |one: &SweepStep<D::Start>| {
            let near = (step(one.value) - step(at)).abs() < 1.0;
            near && one
                .settled
                .as_ref()
                .is_some_and(|known| hits(known) && alike(&known.portrait, &on.portrait))
        };
        beyond.into_iter().chain(others).any(|back| back.steps.iter().any(like))
    };
    let further = |others: &mut Vec<Back<D::Start>>, value: f64, on: OnAttractor<D::Start>| -> Result<()> {
        if hits(&on) && !is_known(others, value, &on) {
            let first = SweepStep { value, settled: Some(on), anew: false };
            let next = step(value).floor() as u32 + 1;
            others.push(back(touch, (first, next), observation, dynamics, monitor)?);
        }
        Ok(())
    };
    for i in TRIED {
        let value = touch.at(i * STEP);
        let system = dynamics(value)?;
        for start in &touch.others {
            monitor.advance(0)?;
            starts += 1;
            match settle(&system, start, observation, monitor)? {
                Some(on) if !on.portrait.undecided => further(&mut others, value, on)?,
                _ => open += 1,
            }
        }
    }
    if let Some((value, on)) = rest {
        further(&mut others, value, on.clone())?;
    }
    let all: Vec<&Back<D::Start>> = beyond.into_iter().chain(&others).filter(|back| back.hits).collect();
    let end = |back: &&&Back<D::Start>| {
        back.left.or(back.steps.last().map(|step| step.value)).unwrap_or(touch.parameter)
    };
    let farthest = all.iter().max_by(|a, b| step(end(a)).total_cmp(&step(end(b))));
    Ok(Hitting {
        left: farthest.as_ref().map(end),
        stays: farthest.is_some_and(|back| back.left.is_none()),
        starts,
        open,
    })
}
