//! Tasks of kind `simulate`: one motion, its impacts.

use serde::Serialize;

use super::{
    Finding, Job, Keeper, Lines, Status,
    series::{SampledMotion, follow},
    small_motion,
};
use crate::{
    error::Result,
    motion::{Flow, RunEnd, Time},
    one::simulate::{Event, Run, Simulator},
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

/// Follows the motion; each point and each event goes to `keeper` as it comes, so that memory does not grow
/// with the length.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub fn simulate(task: &SimulateTask, job: &Job, keeper: &mut dyn Keeper) -> Result<SimulationFindings> {
    let simulator = job.simulator()?;
    let start = job.scene.state(&task.start)?;
    job.monitor.begin(task.transient + u64::from(task.periods), "periods");
    let run = simulator.start(Time::new(0, start.t), start.q, start.u)?;
    let found = SimulationFindings {
        periods: task.periods,
        impacts: 0,
        tangencies: 0,
        rests: 0,
        end: RunEnd::Reached,
        ended_at: 0.0,
        q: 0.0,
        u: 0.0,
        acceleration: 0.0,
        extent: [f64::INFINITY, f64::NEG_INFINITY],
        minimum_depth: simulator.settings().minimum_depth,
    };
    let mut motion = Motion { simulator: &simulator, run, found, keeper };
    let end = follow(task, start.t, &mut motion, job.monitor)?;
    let Motion { run, mut found, .. } = motion;
    let state = run.state();
    (found.end, found.q, found.u, found.ended_at) = (end, state.q, state.u, run.time().periods());
    found.acceleration = simulator.flow().acceleration(state);
    found.widen(state.q);
    Ok(found)
}

/// The motion with what was found of it so far.
struct Motion<'a> {
    simulator: &'a Simulator,
    run: Run<'a>,
    found: SimulationFindings,
    keeper: &'a mut dyn Keeper,
}

impl SampledMotion for Motion<'_> {
    const CHUNK: u64 = 256;

    fn pass(&mut self, until: Time) -> RunEnd {
        self.run.finish(until)
    }

    fn record(&mut self, until: Time) -> Result<RunEnd> {
        let (found, mut failed) = (&mut self.found, None);
        let end = self.run.record(until, |event| {
            match event {
                Event::Impact(_) => found.impacts += 1,
                Event::Tangency(_) => found.tangencies += 1,
                Event::Stick(_) => found.rests += 1,
                _ => {}
            }
            if let (Some(time), Some(side)) = (event.time(), event.side())
                && let Some(wall) = self.simulator.contact(side)
            {
                found.widen(wall.position.at(time.phase)[0]);
            }
            if failed.is_none() {
                failed = self.keeper.event(&event).err();
            }
        });
        failed.map_or(Ok(end), Err)
    }

    fn sample(&mut self, at: Time) -> Result<()> {
        let state = self.run.state();
        self.found.widen(state.q);
        self.keeper.sample(at, state)
    }
}

impl SimulationFindings {
    fn widen(&mut self, q: f64) {
        let [low, high] = self.extent;
        self.extent = [low.min(q), high.max(q)];
    }
}
