//! Attractors over a parameter: what motions from several starts tend to at each of many values; windows and coexistence.
//!
//! Found by following motions, so nothing is proved: see [`Attractor`]. Values are independent of each other, run in parallel, and what
//! is done is kept in a checkpoint; a resumed diagram is bit for bit the uninterrupted one.

mod checkpoint;
mod windows;

pub use windows::{Window, coexisting, windows};

use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{
    Attractor, Look, System,
    flow::State,
    simulate::{End, Settings, Simulator},
};
use crate::{Monitor, error::Result};

/// What to run at which values.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The parameter's values.
    pub values: Vec<f64>,
    /// Where motions start.
    pub starts: Vec<State>,
    /// For how long, and when they are looked at.
    pub look: Look,
    /// Only the first of every so many points of the section is kept.
    pub every: u32,
    /// How finely to simulate.
    pub settings: Settings,
}

/// An attractor as the diagram keeps it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Motion {
    /// (q, u) on the section.
    pub points: Vec<[f64; 2]>,
    /// Its period in forcing periods, if it is periodic.
    pub period: Option<u32>,
    /// Impacts a period; for others in all the points' time.
    pub impacts: u64,
    /// The largest Lyapunov exponent, per forcing period; `None` if it is −∞.
    pub lyapunov: Option<f64>,
}

/// The attractors found at one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Slice {
    /// The value.
    pub value: f64,
    /// The attractors, in the order of the starts that lead there first; all motions that are not periodic count as one.
    pub motions: Vec<Motion>,
    /// Starts whose motion left every bound, or are behind a wall here.
    pub lost: u32,
}

/// Values between two checkpoints.
const CHUNK: usize = 64;

/// The slices of a plan, in its order. With a file, what is done is kept there as it is done, and what it holds of the
/// same plan is not done again. `identity` is what else the result depends on: a file of another plan or identity is refused. Tells `monitor` of each
/// value. Cost: `transient` + `points` periods for each value and start.
///
/// # Errors
/// Those of the system and the simulator; an unusable checkpoint; an interruption, after a last checkpoint.
pub fn sweep(
    plan: &Plan,
    system: impl Fn(f64) -> Result<System<f64>> + Sync,
    identity: &str,
    file: Option<&Path>,
    monitor: &impl Monitor,
) -> Result<Vec<Slice>> {
    let identity = format!("{identity} {plan:?}");
    let mut done = match file {
        Some(file) => checkpoint::read(file, &identity)?,
        None => Vec::new(),
    };
    let rest = plan.values.get(done.len()..).unwrap_or_default();
    monitor.advance(done.len() as u64)?;
    for chunk in rest.chunks(CHUNK) {
        let slices: Vec<Result<Slice>> = chunk
            .par_iter()
            .map(|&value| {
                let slice = slice(plan, value, &system(value)?)?;
                monitor.advance(1)?;
                Ok(slice)
            })
            .collect();
        for slice in slices {
            done.push(slice?);
        }
        if let Some(file) = file {
            checkpoint::write(file, &identity, &done)?;
        }
    }
    Ok(done)
}

fn slice(plan: &Plan, value: f64, system: &System<f64>) -> Result<Slice> {
    let simulator = Simulator::new(system, &plan.settings)?;
    let (mut found, mut lost): (Vec<Attractor>, u32) = (Vec::new(), 0);
    for &start in &plan.starts {
        match Attractor::of(&simulator, start, &plan.look, || Ok(())) {
            Ok(attractor) if attractor.end == End::Reached => {
                let known = |old: &Attractor| {
                    old.is(&attractor) || old.period.is_none() && attractor.period.is_none()
                };
                if !found.iter().any(known) {
                    found.push(attractor);
                }
            }
            _ => lost += 1,
        }
    }
    let motion = |attractor: Attractor| {
        let points = attractor.points.iter().step_by(plan.every as usize);
        Motion {
            points: points.map(|state| [state.q, state.u]).collect(),
            period: attractor.period,
            impacts: attractor.impacts,
            lyapunov: Some(attractor.lyapunov).filter(|exponent| exponent.is_finite()),
        }
    };
    Ok(Slice { value, motions: found.into_iter().map(motion).collect(), lost })
}
