//! A parameter swept: at each value the motion goes on from what it had settled on at the last one.
//!
//! So a sweep stays on an attractor as long as there is one, and shows where it is left: a *jump*. Swept up
//! and down, the two differ where two attractors coexist. One value depends on the one before, so a sweep is
//! one job; what is done is kept in a checkpoint, and a resumed sweep is bit for bit the uninterrupted one.

use serde::{Deserialize, Serialize, de::DeserializeOwned};

use super::{
    DiagramPlan,
    along::{Along, Ends, along, arrive},
};
use crate::{
    attractor::{
        checkpoint::{Checkpoint, Keep},
        observe::{Attraction, Observation},
        portrait::{OnAttractor, Passing, pass_by, settle},
    },
    error::Result,
    monitor::Monitor,
};

/// A value of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepStep<S> {
    /// The value.
    pub value: f64,
    /// What the motion settled on; none where it leaves every bound.
    pub settled: Option<OnAttractor<S>>,
    /// Whether it began at the plan's start: at the first value, and after one where it was lost.
    pub anew: bool,
}

impl<S> SweepStep<S> {
    /// What the motion is on, unless that is not decided.
    pub fn decided(&self) -> Option<&OnAttractor<S>> {
        self.settled.as_ref().filter(|settled| !settled.portrait.undecided)
    }
}

/// A place where a sweep leaves an attractor for another.
#[derive(Debug, Clone, PartialEq)]
pub struct Jump<S> {
    /// The last value known at which the motion stays.
    pub stays: f64,
    /// The first value known at which it has left.
    pub left: f64,
    /// How the orbit ends that it was on, if it was one: then it is followed to there, and `stays` and `left`
    /// differ by rounding.
    pub ends: Option<Ends>,
    /// What it was on, as it last settled.
    pub before: OnAttractor<S>,
    /// What it comes to.
    pub after: OnAttractor<S>,
}

impl<S> Jump<S> {
    /// What ends the motion that it was on: the name of what ends the orbit, or "seen".
    pub fn ends_in(&self) -> &'static str {
        self.ends.map_or("seen", Ends::name)
    }
}

/// Two neighbouring values whose attractors differ by less than this, relative to their widths, are no sign
/// of a jump.
const LIKELY: f64 = 0.1;

/// A step of a sweep in which what is not periodic changes by this many times the median change is one.
const UNUSUAL: f64 = 4.0;

/// Halvings of the interval of a jump: a change that goes with the root of the distance falls to a 64th.
const HALVINGS: u32 = 12;

/// An orbit is looked at this part of the way back from its end.
const INSIDE: f64 = 1e-3;

/// How often a motion that seems to stay is followed on, each time for as long as all before.
const DOUBLINGS: u32 = 2;

/// How often a motion that is not periodic is looked at again.
const AGAIN: u32 = 4;

/// What is left of the change, after the halvings, that is a jump.
const LEFT: f64 = 0.5;

/// A change of less than this many times what chance makes of a motion that is not periodic is none.
const CHANCE: f64 = 2.0;

/// The steps of a sweep over the values of a plan, in its order, from its first start. Cost: that of
/// `settle` for each value.
///
/// # Errors
/// Those of the system and the simulator; an unusable checkpoint; an interruption, after a last checkpoint.
pub fn swept<D: Attraction<Start: Serialize + DeserializeOwned>>(
    plan: &DiagramPlan<D::Start>,
    dynamics: impl Fn(f64) -> Result<D>,
    identity: &str,
    keep: Keep,
    monitor: &dyn Monitor,
) -> Result<Vec<SweepStep<D::Start>>> {
    let canonical = serde_json::to_string(plan).map_err(std::io::Error::other)?;
    let (mut checkpoint, mut done): (_, Vec<SweepStep<D::Start>>) =
        Checkpoint::open(keep, "sweep", &format!("{identity} {canonical}"), plan.most_bytes(), monitor)?;
    let foreign = |(i, step): (usize, &SweepStep<D::Start>)| {
        plan.values.get(i).map(|v| v.to_bits()) != Some(step.value.to_bits())
    };
    if let Some(wrong) = done.iter().enumerate().position(foreign) {
        return Err(checkpoint.bad(&format!("its record {} is not of this sweep", wrong + 1)));
    }
    monitor.advance(done.len() as u64)?;
    for &value in plan.values.get(done.len()..).unwrap_or_default() {
        // From where it last settled: one that grows beside a resonance does not come back for long.
        let unbroken = done.iter().rev().map_while(|step| Some((step.value, step.settled.as_ref()?)));
        let last = unbroken.clone().find(|(_, on)| !on.portrait.undecided).or(unbroken.clone().next());
        let observation = plan.observation();
        let settled = match last {
            Some((before, on)) => arrive(on, [before, value], &observation, &dynamics, monitor),
            None => {
                dynamics(value).and_then(|system| settle(&system, &plan.starts[0], &observation, monitor))
            }
        };
        let step = settled.map(|settled| SweepStep { value, settled, anew: last.is_none() });
        match step.and_then(|step| monitor.advance(1).map(|()| step)) {
            Ok(step) => {
                checkpoint.append(std::slice::from_ref(&step))?;
                done.push(step);
            }
            Err(error) => return Err(checkpoint.ended(error, done.len(), plan.values.len(), "values")),
        }
    }
    Ok(done)
}

/// Where a sweep jumps. An orbit is followed to where it ends. Of a motion that is not periodic, a change
/// between neighbours is a jump if it stays as the interval between them is halved, the motion going on from
/// the nearer one: what grows by and by, as by the root of the distance from a grazing, does not; nor does
/// what chance makes of it. Cost: for each unusual change that of `settle` twice, and up to 36 times
/// the periods of the transient and 128 more, some of them twice over.
///
/// # Errors
/// Those of `settle`.
pub fn jumps<D: Attraction>(
    steps: &[SweepStep<D::Start>],
    observation: &Observation,
    dynamics: impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Vec<Jump<D::Start>>> {
    let change = |pair: &[SweepStep<D::Start>]| {
        let [a, b] = pair else { return None };
        Some(a.decided()?.portrait.apart(&b.decided()?.portrait))
    };
    let mut changes: Vec<f64> = steps.windows(2).filter_map(change).collect();
    changes.sort_by(f64::total_cmp);
    let usual = changes.get(changes.len() / 2).copied().unwrap_or_default();
    let mut found = Vec::new();
    for pair in steps.windows(2) {
        // An orbit is followed whatever is usual: of few values most may be jumps.
        let is_orbit = pair[0].decided().is_some_and(|on| on.portrait.period.is_some());
        let least = if is_orbit { LIKELY } else { LIKELY.max(UNUSUAL * usual) };
        if change(pair).is_some_and(|change| change > least) {
            found.extend(jump(pair, observation, &dynamics, monitor)?);
        }
    }
    Ok(found)
}

/// The jump between two steps, if it is one.
pub(crate) fn jump<D: Attraction>(
    pair: &[SweepStep<D::Start>],
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Option<Jump<D::Start>>> {
    let [SweepStep { value, settled: Some(first), .. }, SweepStep { value: end, settled: Some(last), .. }] =
        pair
    else {
        return Ok(None);
    };
    let whole = first.portrait.apart(&last.portrait);
    let at = |value: f64, from: &OnAttractor<D::Start>, transient: u64| {
        settle(&dynamics(value)?, &from.start, &Observation { transient, ..observation.clone() }, monitor)
    };
    let waits = observation.transient;
    let follow = |to: f64| along(first, [*value, to], observation.phase, dynamics, monitor);
    let found = match follow(*end)? {
        Some(Along { left: None, .. }) => return Ok(None),
        Some(Along { stays, left: Some((left, ends)), .. }) => {
            // A simulator tells a touch from none up to a distance, and where damping is light a motion that
            // begins beside the orbit meets the stop: it is looked at a little before, on the orbit itself.
            let inside = stays + INSIDE * (value - stays);
            let Some(Along { start, .. }) = follow(inside)? else { return Ok(None) };
            let on = OnAttractor { start, ..first.clone() };
            let kind = |on: &OnAttractor<D::Start>| (on.portrait.period, on.portrait.impacts);
            let before = at(inside, &on, waits)?.filter(|before| kind(before) == kind(first));
            let before = before.unwrap_or_else(|| first.clone());
            // What is beyond is what the sweep came to: near the end a motion may creep for long.
            at(left, last, waits)?.map(|after| Jump { stays, left, ends: Some(ends), before, after })
        }
        None => leaves([(*value, first), (*end, last)], observation, dynamics, monitor)?,
    };
    let Some(found) = found else { return Ok(None) };
    let change = found.before.portrait.apart(&found.after.portrait);
    if change <= LIKELY || change <= LEFT * whole {
        return Ok(None);
    }
    // Not at the ends found: near the end of an attractor a motion that stays for long leaves when it is
    // looked at again.
    for (value, on) in [(*value, first), (*end, last)] {
        if change <= CHANCE * by_chance(&dynamics(value)?, on, observation, monitor)? {
            return Ok(None);
        }
    }
    Ok(Some(found))
}

/// Where a motion that is not periodic leaves what it is on for the other, where it seems to stay followed
/// for four times as long; none where it is lost. On the way only how far it goes is looked at; what it is on
/// is asked at the two ends.
fn leaves<D: Attraction>(
    [(value, first), (end, last)]: [(f64, &OnAttractor<D::Start>); 2],
    observation: &Observation,
    dynamics: &impl Fn(f64) -> Result<D>,
    monitor: &dyn Monitor,
) -> Result<Option<Jump<D::Start>>> {
    let (mut stays, mut left) = (value, end);
    let (mut before, mut after) = (Passing::from(first), Passing::from(last));
    let stayed = |here: &Passing<D::Start>, before: &Passing<D::Start>, after: &Passing<D::Start>| {
        here.range.apart(&before.range) < here.range.apart(&after.range)
    };
    let at = |value: f64, from: &D::Start, transient: u64| {
        pass_by(&dynamics(value)?, from, (observation.phase, transient), monitor)
    };
    for _ in 0..HALVINGS {
        let middle = stays + (left - stays) / 2.0;
        if middle == stays || middle == left {
            break;
        }
        // It leaves in the end, or is taken to stay.
        let mut waits = observation.transient;
        let mut here = at(middle, &before.start, waits)?;
        for _ in 0..DOUBLINGS {
            let Some(on) = here.as_ref().filter(|here| stayed(here, &before, &after)) else { break };
            here = at(middle, &on.start, waits)?;
            waits *= 2;
        }
        match here {
            Some(here) if stayed(&here, &before, &after) => (stays, before) = (middle, here),
            Some(here) => (left, after) = (middle, here),
            None => return Ok(None),
        }
    }
    let here = Observation { transient: 0, ..observation.clone() };
    let on = |value: f64, from: &D::Start| settle(&dynamics(value)?, from, &here, monitor);
    let (before, after) = (on(stays, &before.start)?, on(left, &after.start)?);
    Ok(before.zip(after).map(|(before, after)| Jump { stays, left, ends: None, before, after }))
}

/// How differently a motion that is not periodic goes when it is looked at again, later.
fn by_chance<D: Attraction>(
    dynamics: &D,
    on: &OnAttractor<D::Start>,
    observation: &Observation,
    monitor: &dyn Monitor,
) -> Result<f64> {
    if on.portrait.period.is_some() {
        return Ok(0.0);
    }
    let (mut start, mut most) = (on.start.clone(), 0.0f64);
    for _ in 0..AGAIN {
        let when = (observation.phase, observation.transient);
        let Some(again) = pass_by(dynamics, &start, when, monitor)? else { break };
        most = most.max(again.range.apart(&on.portrait.range));
        start = again.start;
    }
    Ok(most)
}
