//! Attractors over a parameter: what motions from several starts tend to at each of many values; windows and coexistence.
//!
//! Found by following motions, so nothing is proved: a long transient can look like an attractor. Values are independent of each other, run in parallel, and what
//! is done is kept in a checkpoint; a resumed diagram is bit for bit the uninterrupted one.

mod checkpoint;
mod windows;

pub use windows::{Window, coexisting, windows};

use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::section::{Point, section};
use crate::{
    Monitor,
    error::Result,
    oscillator::{
        System, Time,
        flow::State,
        simulate::{End, Settings, Simulator},
    },
};

/// When and for how long to look.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// The phase of the section, 0 ≤ phase < 2π.
    pub phase: f64,
    /// Periods that pass before.
    pub transient: u64,
    /// Points of the section, one a period.
    pub points: u32,
    /// The longest period told from none; one is found only if it goes round twice within the points.
    pub longest: u32,
}

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
    let (mut found, mut lost): (Vec<(Motion, Vec<Point>)>, u32) = (Vec::new(), 0);
    for &start in &plan.starts {
        let Some((motion, points)) = motion(plan, &simulator, start) else {
            lost += 1;
            continue;
        };
        let known = |(old, seen): &(Motion, Vec<Point>)| {
            old.period == motion.period
                && (old.period.is_none()
                    || old.impacts == motion.impacts && seen.iter().any(|p| same(p, &points[0], 1e-4)))
        };
        if !found.iter().any(known) {
            found.push((motion, points));
        }
    }
    Ok(Slice { value, motions: found.into_iter().map(|(motion, _)| motion).collect(), lost })
}

/// What a start's motion tends to, with all points of the section, for a periodic one once round; `None` if it left every bound, or cannot start.
fn motion(plan: &Plan, simulator: &Simulator, start: State) -> Option<(Motion, Vec<Point>)> {
    let Look { phase, transient, points: count, longest } = plan.look;
    let mut run = simulator.start(Time::new(0, start.t), start.q, start.u).ok()?;
    let mut points = Vec::new();
    let ends = [
        section(&mut run, phase, transient, |_| true),
        section(&mut run, phase, count.into(), |point| {
            points.push(point);
            true
        }),
    ];
    if ends != [End::Reached; 2] {
        return None;
    }
    let period = repeats(&points, longest as usize);
    if let Some(period) = period {
        points.drain(..points.len() - period);
    }
    let motion = Motion {
        points: points.iter().step_by(plan.every as usize).map(|point| [point.q, point.u]).collect(),
        period: period.map(|period| period as u32),
        impacts: points.iter().map(|point| point.impacts).sum(),
    };
    Some((motion, points))
}

fn same(a: &Point, b: &Point, near: f64) -> bool {
    (a.q - b.q).abs() + (a.u - b.u).abs() < near * (1.0 + a.q.abs() + a.u.abs())
}

/// The shortest shift, up to `longest`, by which the later half of the points, or more, repeats.
fn repeats(points: &[Point], longest: usize) -> Option<usize> {
    let n = points.len();
    (1..=longest.min(n / 2)).find(|&p| {
        let from = (n / 2).min(n - 2 * p);
        (from..n - p).all(|i| same(&points[i], &points[i + p], 1e-7))
    })
}
