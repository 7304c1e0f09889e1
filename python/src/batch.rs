//! Many motions at once, from arrays into arrays.

use std::f64::consts::TAU;

use grazing_scenes::{
    Error, Monitor, Result,
    attractor::dynamics::Dynamics,
    motion::{RunEnd, State},
    one::simulate::{Settings, Simulator, batch::Batch},
    scene::{Accuracy, Body, Scene},
};
use rayon::prelude::*;

use crate::{machines, watch::Watch};

/// Motions that are followed together: their tables fit a core's cache.
const TOGETHER: usize = 256;

/// What to follow. A start is the displacements of all coordinates, then their velocities, (q, u) of an
/// oscillator; and each motion has a value of each varied parameter.
pub struct Plan<'a> {
    pub scene: &'a Scene,
    /// How many coordinates the scene has.
    pub coordinates: usize,
    pub starts: &'a [f64],
    pub varied: &'a [String],
    pub values: &'a [f64],
    /// Of the forcing, as a fraction of its period: where motions start and are looked at.
    pub phase: f64,
    pub transient: u64,
    /// Periods from one record to the next.
    pub every: u64,
    pub records: usize,
}

impl Plan<'_> {
    /// The values of the parameters that a motion has of its own.
    pub fn changes(&self, motion: usize) -> Vec<(&str, f64)> {
        let width = self.varied.len();
        let values = &self.values[motion * width..][..width];
        self.varied.iter().map(String::as_str).zip(values.iter().copied()).collect()
    }

    /// Where a motion starts.
    ///
    /// # Errors
    /// An input error for numbers that are not finite.
    pub fn start(&self, motion: usize) -> Result<&[f64]> {
        let width = 2 * self.coordinates;
        let start = &self.starts[motion * width..][..width];
        if start.iter().all(|x| x.is_finite()) {
            return Ok(start);
        }
        let all: Vec<String> = start.iter().map(ToString::to_string).collect();
        Err(Error::input(format!("motion {motion}: the start ({}) is not finite", all.join(", "))))
    }
}

/// How many coordinates a scene has.
pub fn coordinates(scene: &Scene) -> usize {
    match &scene.body {
        Body::Machine(scene) => scene.machine.points(),
        _ => 1,
    }
}

/// How a motion ended, as `grazing.End`.
const REACHED: u8 = 0;
const IMPACT_LIMIT: u8 = 1;
const ESCAPED: u8 = 2;
const NOT_SMOOTH: u8 = 3;
pub const BEHIND_A_WALL: u8 = 4;
const TOO_STEEP: u8 = 5;

pub fn code(end: RunEnd) -> u8 {
    match end {
        RunEnd::Reached => REACHED,
        RunEnd::ImpactLimit => IMPACT_LIMIT,
        RunEnd::NotSmooth => NOT_SMOOTH,
        RunEnd::TooSteep => TOO_STEEP,
        _ => ESCAPED,
    }
}

/// Follows all motions, on all cores: the first record is after the transient, the others `every` periods
/// apart. What a motion does not reach is NaN; its impacts are those after the transient.
pub fn follow(
    plan: &Plan,
    points: &mut [f64],
    impacts: &mut [u64],
    ends: &mut [u8],
    watch: &Watch,
) -> Result<()> {
    for name in plan.varied {
        plan.scene.parameter(name)?;
    }
    if let Body::Machine(_) = plan.scene.body {
        return machines::follow(plan, points, impacts, ends, watch);
    }
    let Accuracy { tolerance, minimum_depth } = plan.scene.accuracy;
    let (system, settings) = (plan.scene.rounded()?, Settings { tolerance, ..Settings::default() });
    let settings = match minimum_depth {
        Some(minimum_depth) => Settings { minimum_depth, ..settings },
        None => {
            let starts = plan.starts.chunks(2).map(|start| State { t: 0.0, q: start[0], u: start[1] });
            settings.sized(&system, &starts.collect::<Vec<_>>())?
        }
    };
    let shared = match plan.varied {
        [] => Some(Simulator::new(&system, &settings)?),
        _ => None,
    };
    watch.begin(ends.len() as u64, "motions");
    if ends.is_empty() || plan.records == 0 {
        return Ok(());
    }
    let width = plan.records * 2;
    let lots = points.par_chunks_mut(TOGETHER * width);
    let lots = lots.zip(impacts.par_chunks_mut(TOGETHER)).zip(ends.par_chunks_mut(TOGETHER)).enumerate();
    lots.try_for_each(|(lot, ((points, impacts), ends))| {
        let first = lot * TOGETHER;
        let own = match shared {
            Some(_) => Vec::new(),
            None => (first..first + ends.len())
                .map(|motion| simulator(plan, motion, &settings))
                .collect::<Result<Vec<_>>>()?,
        };
        let at = |index: usize| shared.as_ref().unwrap_or_else(|| &own[index]);
        lot_of(plan, first, &at, points, impacts, ends, watch)?;
        watch.advance(ends.len() as u64)
    })
}

/// The simulator of a motion with parameters of its own.
fn simulator(plan: &Plan, motion: usize, settings: &Settings) -> Result<Simulator> {
    let system = plan.scene.plain(&plan.changes(motion));
    system
        .and_then(|system| Simulator::new(&system, settings))
        .map_err(|error| error.context(format!("motion {motion}")))
}

fn lot_of<'a>(
    plan: &Plan,
    first: usize,
    simulator: &impl Fn(usize) -> &'a Simulator,
    points: &mut [f64],
    impacts: &mut [u64],
    ends: &mut [u8],
    watch: &Watch,
) -> Result<()> {
    let width = plan.records * 2;
    let phase = TAU * (plan.phase - plan.phase.floor());
    points.fill(f64::NAN);
    impacts.fill(0);
    let (mut runs, mut places) = (Vec::new(), Vec::new());
    for (index, end) in ends.iter_mut().enumerate() {
        let start = plan.start(first + index)?;
        // A start that is finite is refused for one reason alone.
        match simulator(index).begin(&State { t: phase, q: start[0], u: start[1] }) {
            Ok(run) => {
                runs.push((simulator(index), run));
                places.push(index);
                *end = REACHED;
            }
            Err(_) => *end = BEHIND_A_WALL,
        }
    }
    let mut batch = Batch::new(phase, runs);
    for _ in 0..plan.transient {
        batch.pass();
        watch.advance(0)?;
    }
    let before: Vec<u64> = (0..places.len()).map(|motion| batch.impacts(motion)).collect();
    for record in 0..plan.records {
        if record > 0 {
            for _ in 0..plan.every {
                batch.pass();
                watch.advance(0)?;
            }
        }
        for (motion, &index) in places.iter().enumerate() {
            if batch.end(motion) == RunEnd::Reached {
                let [q, u] = simulator(index).drawn(&batch.point(motion));
                points[index * width + 2 * record] = q;
                points[index * width + 2 * record + 1] = u;
            }
        }
    }
    for (motion, &index) in places.iter().enumerate() {
        impacts[index] = batch.impacts(motion) - before[motion];
        ends[index] = code(batch.end(motion));
    }
    Ok(())
}
