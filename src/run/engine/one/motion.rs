//! One motion of an oscillator, followed for the task `simulate`.

use std::f64::consts::TAU;

use super::{
    super::super::{
        Keeper, SimulationFindings,
        series::{SampledMotion, follow},
    },
    Oscillators,
};
use crate::{
    error::Result,
    motion::{Flow, RunEnd, Time},
    one::simulate::{Run, Simulator},
    scene::simulate::SimulateTask,
};

/// The motion with what was found of it so far.
struct Motion<'a> {
    simulator: &'a Simulator,
    run: Run<'a>,
    found: SimulationFindings,
    extent: [f64; 2],
    keeper: &'a mut dyn Keeper,
}

/// Follows the motion of a task.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub(super) fn simulate(
    task: &SimulateTask,
    engine: &Oscillators,
    keeper: &mut dyn Keeper,
) -> Result<SimulationFindings> {
    let (job, simulator) = (engine.job, engine.job.simulator()?);
    let start = job.scene.state(&task.start)?;
    job.monitor.begin(task.transient + u64::from(task.periods), "periods");
    let run = simulator.start(Time::new(0, start.t), start.q, start.u)?;
    let found = SimulationFindings::new(task, job, TAU, simulator.settings().minimum_depth);
    let extent = [f64::INFINITY, f64::NEG_INFINITY];
    let mut motion = Motion { simulator: &simulator, run, found, extent, keeper };
    let end = follow(task, start.t, &mut motion, job.monitor)?;
    let state = motion.run.state();
    motion.widen(state.q);
    let Motion { run, mut found, extent, .. } = motion;
    (found.moved.end, found.moved.ended_at) = (end, run.time().periods());
    (found.moved.q, found.moved.u) = (vec![state.q], vec![state.u]);
    found.moved.extent = Some(extent);
    found.acceleration = vec![simulator.flow().acceleration(state)];
    Ok(found)
}

impl SampledMotion for Motion<'_> {
    const CHUNK: u64 = 256;

    fn pass(&mut self, until: Time) -> RunEnd {
        self.run.finish(until)
    }

    fn record(&mut self, until: Time) -> Result<RunEnd> {
        let (mut failed, [mut low, mut high]) = (None, self.extent);
        let end = self.run.record(until, |event| {
            self.found.count(&event);
            if let Some((time, side)) = event.at()
                && let Some(wall) = self.simulator.contact(side)
            {
                let at = wall.position.at(time.phase)[0];
                (low, high) = (low.min(at), high.max(at));
            }
            if failed.is_none() {
                failed = self.keeper.event(&event).err();
            }
        });
        self.extent = [low, high];
        failed.map_or(Ok(end), Err)
    }

    fn sample(&mut self, at: Time) -> Result<()> {
        let state = self.run.state();
        self.widen(state.q);
        self.keeper.sample(at, state)
    }
}

impl Motion<'_> {
    fn widen(&mut self, q: f64) {
        let [low, high] = self.extent;
        self.extent = [low.min(q), high.max(q)];
    }
}
