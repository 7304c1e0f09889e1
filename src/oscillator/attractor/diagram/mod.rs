//! Attractors over a parameter: what motions from several starts tend to at each of many values; windows and
//! coexistence.
//!
//! Found by following motions, so nothing is proved: a long transient can look like an attractor. Values are
//! independent of each other, run in parallel, and what is done is kept in a checkpoint; a resumed diagram is
//! bit for bit the uninterrupted one.

mod windows;

pub use windows::{Window, coexisting, windows};

use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{
    checkpoint::Checkpoint,
    detection::{Detection, Fate, wait},
    dynamics::{Dynamics, Motion, SectionState},
    section::section,
};
use crate::{
    Monitor,
    error::Result,
    oscillator::{flow::State, simulate::RunEnd},
};

/// When and for how long to look.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Look {
    /// The phase of the section, 0 ≤ phase < 2π.
    pub phase: f64,
    /// Periods that pass before.
    pub transient: u64,
    /// Points of the section, one per period.
    pub points: u32,
    /// The longest period told from none.
    pub longest: u32,
}

/// What to run at which values.
#[derive(Debug, Clone, Serialize)]
pub struct DiagramPlan<S = State> {
    /// The parameter's values.
    pub values: Vec<f64>,
    /// Where motions start.
    pub starts: Vec<S>,
    /// For how long, and when they are looked at.
    pub look: Look,
    /// Of every this many points of the section only the first is kept.
    pub every: u32,
}

/// An attractor as the diagram keeps it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DiagramMotion {
    /// (q, u) on the section.
    pub points: Vec<[f64; 2]>,
    /// Its period in forcing periods, if it is periodic.
    pub period: Option<u32>,
    /// Impacts a period; for others in all the points' time.
    pub impacts: u64,
}

/// The attractors found at one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Slice {
    /// The value.
    pub value: f64,
    /// The attractors, in the order of the starts that lead there first; all motions that are not periodic
    /// count as one.
    pub motions: Vec<DiagramMotion>,
    /// Starts whose motion left every bound, or are behind a wall here.
    pub lost: u32,
}

/// Values between two checkpoints.
const CHUNK: usize = 64;

/// The slices of a plan, in its order. With a file, what is done is kept there as it is done, and what it
/// holds of the same plan is not done again. `identity` is what else the result depends on: a file of another
/// plan or identity is refused. Tells `monitor` of each value. Cost: `transient` + `points` periods for each
/// value and start.
///
/// # Errors
/// Those of the system and the simulator; an unusable checkpoint; an interruption, after a last checkpoint.
pub fn sweep<D: Dynamics<Start: Serialize>>(
    plan: &DiagramPlan<D::Start>,
    dynamics: impl Fn(f64) -> Result<D> + Sync,
    identity: &str,
    file: Option<&Path>,
    monitor: &dyn Monitor,
) -> Result<Vec<Slice>> {
    let plan_text = serde_json::to_string(plan).map_err(std::io::Error::other)?;
    let (mut checkpoint, mut done): (_, Vec<Slice>) =
        Checkpoint::open(file, "diagram", &format!("{identity} {plan_text}"), plan.most_bytes(), monitor)?;
    if let Some(wrong) = done.iter().enumerate().find(|(i, slice)| !plan.can_be(*i, slice)) {
        return Err(checkpoint.bad(&format!("its record {} is not of this diagram", wrong.0 + 1)));
    }
    let rest = plan.values.get(done.len()..).unwrap_or_default();
    monitor.advance(done.len() as u64)?;
    for chunk in rest.chunks(CHUNK) {
        let slices: Vec<Result<Slice>> = chunk
            .par_iter()
            .map(|&value| {
                let slice = slice(plan, value, &dynamics(value)?, monitor)?;
                monitor.advance(1)?;
                Ok(slice)
            })
            .collect();
        for slice in slices {
            match slice {
                Ok(slice) => {
                    checkpoint.append(&slice)?;
                    done.push(slice);
                }
                Err(error) => return Err(checkpoint.ended(error, done.len(), plan.values.len(), "values")),
            }
        }
    }
    Ok(done)
}

impl<S> DiagramPlan<S> {
    /// More bytes than any state of this plan has: 64 for a point or what else a motion has, 128 for what
    /// else a slice and its line have.
    fn most_bytes(&self) -> u64 {
        let points = u64::from(self.look.points.max(self.look.longest).max(self.every));
        let motion = 64 * (points + 2);
        4096 + self.values.len() as u64 * (128 + self.starts.len() as u64 * motion)
    }

    /// Whether a slice can be that of the value with this index.
    pub fn can_be(&self, index: usize, slice: &Slice) -> bool {
        let Look { points, longest, .. } = self.look;
        let most = points.max(longest).max(self.every) as usize;
        let motion = |motion: &DiagramMotion| {
            motion.points.len() <= most
                && motion.points.iter().flatten().all(|x| x.is_finite())
                && motion.period.is_none_or(|period| (1..=longest).contains(&period))
        };
        self.values.get(index).is_some_and(|value| value.to_bits() == slice.value.to_bits())
            && slice.motions.len() + slice.lost as usize <= self.starts.len()
            && slice.motions.iter().all(motion)
    }
}

fn slice<D: Dynamics>(
    plan: &DiagramPlan<D::Start>,
    value: f64,
    dynamics: &D,
    monitor: &dyn Monitor,
) -> Result<Slice> {
    let (mut found, mut lost) = (Vec::new(), 0u32);
    for start in &plan.starts {
        let Some((motion, fate)) = motion(plan, dynamics, start, monitor)? else {
            lost += 1;
            continue;
        };
        let known = |(_, old): &(DiagramMotion, Fate<D::Point>)| old.is(&fate);
        if !found.iter().any(known) {
            found.push((motion, fate));
        }
    }
    Ok(Slice { value, motions: found.into_iter().map(|(motion, _)| motion).collect(), lost })
}

/// What a start's motion tends to; `None` if it left every bound, or cannot start.
fn motion<D: Dynamics>(
    plan: &DiagramPlan<D::Start>,
    dynamics: &D,
    start: &D::Start,
    monitor: &dyn Monitor,
) -> Result<Option<(DiagramMotion, Fate<D::Point>)>> {
    let Look { phase, transient, points: count, longest } = plan.look;
    let Ok(mut run) = dynamics.begin(start) else { return Ok(None) };
    if wait(&mut run, phase, transient, monitor)? != RunEnd::Reached {
        return Ok(None);
    }
    let detection = Detection { phase, transient: 0, longest: longest as usize, ..Detection::default() };
    let fate = detection.detect(&mut run)?;
    let (period, round, look_at) = match &fate {
        Fate::Ended(_) => return Ok(None),
        Fate::Periodic(cycle) => {
            (Some(cycle.period() as u32), Some(cycle.impacts), (cycle.period() as u32).max(plan.every))
        }
        Fate::Irregular => (None, None, count),
    };
    // The same component at every value: counted from the end of the transient.
    let shown = |at: i64| (at - 1 - transient as i64).rem_euclid(plan.every.into()) == 0;
    let (mut points, before) = (Vec::new(), run.impacts());
    let end = section(&mut run, phase, look_at.into(), |point| {
        if shown(point.period) {
            points.push(point.at.plane());
        }
        true
    })?;
    if end != RunEnd::Reached {
        return Ok(None);
    }
    let impacts = round.unwrap_or_else(|| run.impacts() - before);
    Ok(Some((DiagramMotion { points, period, impacts }, fate)))
}
