//! Attractors over a parameter: what motions from several starts tend to at each of many values; windows and
//! coexistence.
//!
//! Found by following motions, so nothing is proved: a long transient can look like an attractor. Motions
//! start from the same places at every value: none goes on from the attractor of the value before, but in a
//! sweep (`swept`). So values are independent of each other, run in parallel, those of an oscillator many at
//! once, and what is done is kept in a checkpoint; a resumed diagram is bit for bit the uninterrupted one.

mod along;
mod swept;
mod windows;

pub use along::Ends;
pub(crate) use along::arrive;
pub(crate) use swept::jump;
pub use swept::{Jump, SweepStep, jumps, swept};
pub use windows::{Window, coexisting, windows};

use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{
    checkpoint::{Checkpoint, Keep},
    cycle::{Cycle, ordered},
    dynamics::SectionState,
    observe::{Attraction, Observation, Observed},
    portrait::{OnAttractor, looked_at},
};
use crate::{error::Result, monitor::Monitor, motion::State};

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
    /// (q, u) on the section; those of a cycle from the one of least q (then least u) on.
    pub points: Vec<[f64; 2]>,
    /// Its period in forcing periods, if it is periodic.
    pub period: Option<u32>,
    /// Whether it was not decided if it is.
    pub undecided: bool,
    /// Impacts a period; for others in all the points' time.
    pub impacts: u64,
}

/// The attractors found at one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Slice {
    /// The value.
    pub value: f64,
    /// The attractors, in the order of the starts that lead there first; all motions that are not periodic
    /// count as one, all that are not decided as another.
    pub motions: Vec<DiagramMotion>,
    /// Starts whose motion left every bound, or are behind a wall here.
    pub lost: u32,
}

/// Values between two checkpoints, at the least.
const CHUNK: usize = 64;

/// The slices of a plan, in its order. With a file, what is done is kept there as it is done, and what it
/// holds of the same plan is not done again. `identity` is what else the result depends on: a file of another
/// plan or identity is refused. Tells `monitor` of each value. Cost: `transient` + `points` periods for each
/// value and start.
///
/// # Errors
/// Those of the system and the simulator; an unusable checkpoint; an interruption, after a last checkpoint.
pub fn sweep<D: Attraction<Start: Serialize>>(
    plan: &DiagramPlan<D::Start>,
    dynamics: impl Fn(f64) -> Result<D> + Sync,
    identity: &str,
    file: Option<&Path>,
    monitor: &dyn Monitor,
) -> Result<Vec<Slice>> {
    sweep_counting(plan, dynamics, identity, Keep { file, tally: None }, monitor)
}

/// The same, its work counted.
///
/// # Errors
/// Those of [`sweep`].
pub fn sweep_counting<D: Attraction<Start: Serialize>>(
    plan: &DiagramPlan<D::Start>,
    dynamics: impl Fn(f64) -> Result<D> + Sync,
    identity: &str,
    keep: Keep,
    monitor: &dyn Monitor,
) -> Result<Vec<Slice>> {
    let plan_text = serde_json::to_string(plan).map_err(std::io::Error::other)?;
    let (mut checkpoint, mut done): (_, Vec<Slice>) =
        Checkpoint::open(keep, "diagram", &format!("{identity} {plan_text}"), plan.most_bytes(), monitor)?;
    if let Some(wrong) = done.iter().enumerate().find(|(i, slice)| !plan.can_be(*i, slice)) {
        return Err(checkpoint.bad(&format!("its record {} is not of this diagram", wrong.0 + 1)));
    }
    let rest = plan.values.get(done.len()..).unwrap_or_default();
    monitor.advance(done.len() as u64)?;
    // Values whose motions are followed together: two parts for each thread, so that none waits for long.
    let threads = 2 * rayon::current_num_threads();
    let most = (D::TOGETHER / plan.starts.len().max(1)).max(1);
    let together = rest.len().div_ceil(threads).clamp(1, most);
    for chunk in rest.chunks(CHUNK.max(threads * together)) {
        let slices: Vec<Vec<Result<Slice>>> =
            chunk.par_chunks(together).map(|values| slices(plan, values, &dynamics, monitor)).collect();
        match slices.into_iter().flatten().collect::<Result<Vec<_>>>() {
            Ok(found) => {
                checkpoint.append(&found)?;
                done.extend(found);
            }
            Err(error) => return Err(checkpoint.ended(error, done.len(), plan.values.len(), "values")),
        }
    }
    Ok(done)
}

impl<S> DiagramPlan<S> {
    /// How many periods are looked at, and what for.
    pub fn observation(&self) -> Observation {
        let Look { phase, transient, points, longest } = self.look;
        Observation { phase, transient, longest, points, round: true, every: self.every }
    }

    /// What motions that go on amount to at a value.
    fn slice<P: SectionState>(&self, value: f64, all: Vec<Observed<S, P>>) -> Slice {
        let (mut known, mut motions) = (Known::default(), Vec::new());
        let lost = (self.starts.len() - all.len()) as u32;
        for seen in all {
            if known.is_new(&seen) {
                let Observed { cycle, undecided, points, impacts, .. } = seen;
                let period = cycle.map(|cycle| cycle.period() as u32);
                // When the cycle was told goes with rounding, and the point that came then.
                let points = if period.is_some() { ordered(points, |&point| point) } else { points };
                motions.push(DiagramMotion { points, period, undecided, impacts });
            }
        }
        Slice { value, motions, lost }
    }

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
                && motion.period.is_none_or(|period| (1..=longest).contains(&period) && !motion.undecided)
        };
        self.values.get(index).is_some_and(|value| value.to_bits() == slice.value.to_bits())
            && slice.motions.len() + slice.lost as usize <= self.starts.len()
            && slice.motions.iter().all(motion)
    }
}

/// Attractors at a value that have been seen: all that are not periodic count as one, all that are not
/// decided as another.
struct Known<P>(Vec<(Option<Cycle<P>>, bool)>);

impl<P> Default for Known<P> {
    fn default() -> Known<P> {
        Known(Vec::new())
    }
}

impl<P: SectionState> Known<P> {
    /// Whether it is none of them; then it is one from now on.
    fn is_new<S>(&mut self, seen: &Observed<S, P>) -> bool {
        let same = |(old, undecided): &(Option<Cycle<P>>, bool)| match (old, &seen.cycle) {
            (Some(old), Some(cycle)) => old.is(cycle),
            (old, cycle) => old.is_none() && cycle.is_none() && *undecided == seen.undecided,
        };
        let is_new = !self.0.iter().any(same);
        if is_new {
            self.0.push((seen.cycle.clone(), seen.undecided));
        }
        is_new
    }
}

/// The attractors at one value, in the order of a [`Slice`], each with the index of the start that leads
/// there first and with a state on it. Cost: that of the slice again, up to the last start that leads to
/// another one of these `most` attractors.
///
/// # Errors
/// Those of the simulator; an interruption.
pub fn attractors<D: Attraction>(
    plan: &DiagramPlan<D::Start>,
    dynamics: &D,
    most: usize,
    monitor: &dyn Monitor,
) -> Result<Vec<(usize, OnAttractor<D::Start>)>> {
    let (mut known, mut found) = (Known::default(), Vec::new());
    for (index, start) in plan.starts.iter().enumerate() {
        if found.len() == most {
            break;
        }
        let Ok(run) = dynamics.begin(start) else { continue };
        if let Some(Ok(seen)) = D::observe(vec![(dynamics, run)], &plan.observation(), monitor)?.pop()
            && known.is_new(&seen)
        {
            found.extend(looked_at(dynamics, seen)?.map(|on| (index, on)));
        }
    }
    Ok(found)
}

/// The slices at some values: the motions of all of them are followed together.
fn slices<D: Attraction>(
    plan: &DiagramPlan<D::Start>,
    values: &[f64],
    dynamics: &(impl Fn(f64) -> Result<D> + Sync),
    monitor: &dyn Monitor,
) -> Vec<Result<Slice>> {
    let systems: Vec<Result<D>> = values.iter().map(|&value| dynamics(value)).collect();
    // Which value each motion has.
    let (mut places, mut motions) = (Vec::new(), Vec::new());
    for (place, system) in systems.iter().enumerate() {
        let Ok(system) = system else { continue };
        for run in plan.starts.iter().filter_map(|start| system.begin(start).ok()) {
            places.push(place);
            motions.push((system, run));
        }
    }
    let outcomes = match D::observe(motions, &plan.observation(), monitor) {
        Ok(outcomes) => outcomes,
        Err(error) => return vec![Err(error)],
    };
    let mut found: Vec<Vec<Observed<D::Start, D::Point>>> = systems.iter().map(|_| Vec::new()).collect();
    for (place, observed) in places.into_iter().zip(outcomes) {
        found[place].extend(observed);
    }
    let slice = |(system, (&value, found)): (Result<D>, (&f64, Vec<_>))| {
        system?;
        monitor.advance(1)?;
        Ok(plan.slice(value, found))
    };
    systems.into_iter().zip(values.iter().zip(found)).map(slice).collect()
}
