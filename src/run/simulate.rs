//! Tasks of kind `simulate`: one motion, its impacts.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{Finding, Job, Keeper, Lines, Status, small_motion};
use crate::{
    error::Result,
    motion::{Flow, RunEnd, Time},
    one::simulate::Event,
    scene::simulate::SimulateTask,
};

/// What happened in one motion; its series and its events went to the [`Keeper`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SimulationFindings {
    /// Forcing periods asked for after the transient.
    pub periods: u32,
    /// Impacts, after the transient.
    pub impacts: u64,
    /// Minima of a gap within the minimum depth, of which no impact was made.
    pub tangencies: u64,
    /// How often it came to rest on a wall.
    pub rests: u64,
    /// Why it ended.
    pub end: RunEnd,
    /// Forcing periods from the beginning to the end.
    pub ended_at: f64,
    /// The displacement at the end.
    pub q: f64,
    /// The velocity at the end.
    pub u: f64,
    /// The acceleration there, without any wall.
    #[serde(skip)]
    pub acceleration: f64,
    /// The least and the greatest displacement at points of the series and at impacts.
    pub extent: [f64; 2],
    /// What counts as contact without impact.
    pub minimum_depth: f64,
}

impl Finding for SimulationFindings {
    fn status(&self) -> Status {
        Status::of_motion(self.end, self.ended_at, [&[self.q], &[self.u], &[self.acceleration]])
    }

    fn warnings(&self) -> Vec<String> {
        small_motion(self.extent[1] - self.extent[0], self.minimum_depth).into_iter().collect()
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("periods", self.periods);
        lines.say("impacts", self.impacts);
        lines.say("tangencies", self.tangencies);
        lines.say("rests", self.rests);
        if self.end != RunEnd::Reached {
            lines.say("ended", self.end.why());
            lines.say("after_periods", self.ended_at);
        }
        lines.say("q", self.q);
        lines.say("u", self.u);
    }
}

/// Periods between two looks at whether to go on.
const CHUNK: u64 = 256;

/// Follows the motion; each point and each event goes to `keeper` as it comes, so that memory does not grow
/// with the length.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub fn simulate(task: &SimulateTask, job: &Job, keeper: &mut dyn Keeper) -> Result<SimulationFindings> {
    let simulator = job.simulator()?;
    let start = job.scene.state(&task.start)?;
    job.monitor.begin(task.transient + u64::from(task.periods), "periods");
    let mut run = simulator.start(Time::new(0, start.t), start.q, start.u)?;
    let mut end = RunEnd::Reached;
    let mut passed = 0;
    while passed < task.transient && end == RunEnd::Reached {
        let next = (passed + CHUNK).min(task.transient);
        end = run.finish(Time::new(next as i64, start.t));
        job.monitor.advance(next - passed)?;
        passed = next;
    }
    let mut found = SimulationFindings {
        periods: task.periods,
        impacts: 0,
        tangencies: 0,
        rests: 0,
        end,
        ended_at: 0.0,
        q: 0.0,
        u: 0.0,
        acceleration: 0.0,
        extent: [f64::INFINITY, f64::NEG_INFINITY],
        minimum_depth: simulator.settings().minimum_depth,
    };
    let widen = |[low, high]: [f64; 2], q: f64| [low.min(q), high.max(q)];
    let samples = u64::from(task.samples);
    for sample in 0..=u64::from(task.periods) * samples {
        if found.end != RunEnd::Reached {
            break;
        }
        let (period, part) = (sample / samples, sample % samples);
        if part == 0 && period > 0 && period.is_multiple_of(CHUNK) {
            job.monitor.advance(CHUNK)?;
        }
        let phase = start.t + TAU * part as f64 / f64::from(task.samples);
        let until = Time::new((task.transient + period) as i64, phase);
        let mut failed = None;
        found.end = run.record(until, |event| {
            match event {
                Event::Impact(_) => found.impacts += 1,
                Event::Tangency(_) => found.tangencies += 1,
                Event::Stick(_) => found.rests += 1,
                _ => {}
            }
            if let (Some(time), Some(side)) = (event.time(), event.side()) {
                let wall = simulator.contact(side).map(|wall| wall.position.at(time.phase)[0]);
                found.extent = wall.map_or(found.extent, |q| widen(found.extent, q));
            }
            if failed.is_none() {
                failed = keeper.event(&event).err();
            }
        });
        if let Some(error) = failed {
            return Err(error);
        }
        if found.end == RunEnd::Reached {
            let state = run.state();
            found.extent = widen(found.extent, state.q);
            keeper.sample(until, state)?;
        }
    }
    let state = run.state();
    (found.q, found.u, found.ended_at) = (state.q, state.u, run.time().periods());
    found.acceleration = simulator.flow().acceleration(state);
    found.extent = widen(found.extent, state.q);
    Ok(found)
}
