//! A parameter swept: at each value the motion goes on from what it had settled on at the last one.
//!
//! So a sweep stays on an attractor as long as there is one, and shows where it is left: a *jump*. Swept up
//! and down, the two differ where two attractors coexist. One value depends on the one before, so a sweep is
//! one job; what is done is kept in a checkpoint, and a resumed sweep is bit for bit the uninterrupted one.

use serde::{Deserialize, Serialize, de::DeserializeOwned};

use super::DiagramPlan;
use crate::{
    attractor::{
        checkpoint::{Checkpoint, Keep},
        observe::{Attraction, Observation},
        portrait::{OnAttractor, settle},
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

/// A place where a sweep leaves an attractor for another.
#[derive(Debug, Clone, PartialEq)]
pub struct Jump<S> {
    /// The last value known at which the motion stays.
    pub stays: f64,
    /// The first value known at which it has left.
    pub left: f64,
    /// What it was on, as it last settled.
    pub before: OnAttractor<S>,
    /// What it comes to.
    pub after: OnAttractor<S>,
}

/// Two neighbouring values whose attractors differ by less than this, relative to their widths, are no sign
/// of a jump.
const LIKELY: f64 = 0.1;

/// A step of a sweep in which the attractor changes by this many times the median change is one.
const UNUSUAL: f64 = 4.0;

/// Halvings of the interval of a jump: a change that goes with the root of the distance falls to a 64th.
const HALVINGS: u32 = 12;

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
        let last = done.last().and_then(|step| step.settled.as_ref()).map(|settled| &settled.start);
        let step = dynamics(value).and_then(|system| {
            let from = last.unwrap_or(&plan.starts[0]);
            Ok(SweepStep {
                value,
                settled: settle(&system, from, &plan.observation(), monitor)?,
                anew: last.is_none(),
            })
        });
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

/// Where a sweep jumps. A change between neighbours is one if it stays as the interval between them is
/// halved, the motion going on from the nearer one: what grows by and by, as by the root of the distance from
/// a flip or a grazing, does not; nor does what chance makes of a motion that is not periodic. Cost: up to
/// fourteen times `settle` for each unusual change.
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
        let [SweepStep { settled: Some(a), .. }, SweepStep { settled: Some(b), .. }] = pair else {
            return None;
        };
        Some(a.portrait.apart(&b.portrait))
    };
    let mut changes: Vec<f64> = steps.windows(2).filter_map(change).collect();
    changes.sort_by(f64::total_cmp);
    let usual = changes.get(changes.len() / 2).copied().unwrap_or_default();
    let mut found = Vec::new();
    for pair in steps.windows(2) {
        if change(pair).is_some_and(|change| change > LIKELY.max(UNUSUAL * usual)) {
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
    let (whole, mut stays, mut left) = (first.portrait.apart(&last.portrait), *value, *end);
    let (mut before, mut after) = (first.clone(), last.clone());
    // Close to where an attractor ends, motions do not settle: it looks as it did where they last did.
    let mut settled = first.clone();
    for _ in 0..HALVINGS {
        let middle = stays + (left - stays) / 2.0;
        if middle == stays || middle == left {
            break;
        }
        match settle(&dynamics(middle)?, &before.start, observation, monitor)? {
            Some(here) if here.portrait.apart(&before.portrait) < here.portrait.apart(&after.portrait) => {
                (stays, before) = (middle, here);
                if before.portrait.period.is_some() || settled.portrait.period.is_none() {
                    settled = before.clone();
                }
            }
            Some(here) => (left, after) = (middle, here),
            None => return Ok(None),
        }
    }
    let change = before.portrait.apart(&after.portrait);
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
    Ok(Some(Jump { stays, left, before: settled, after }))
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
    let again = settle(dynamics, &on.start, observation, monitor)?;
    Ok(again.map_or(0.0, |again| again.portrait.apart(&on.portrait)))
}
