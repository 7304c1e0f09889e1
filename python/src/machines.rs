//! Many motions of a machine at once: as `batch` has it of oscillators, each motion by itself.

use std::f64::consts::TAU;

use grazing_scenes::{
    Error, Monitor, Result,
    many::{Machine, State, simulate::Simulator},
    motion::{RunEnd, Time},
};
use rayon::prelude::*;

use crate::{
    batch::{BEHIND_A_WALL, Plan, code},
    watch::Watch,
};

/// Periods of a transient between two looks at Ctrl-C, as of a task.
const CHUNK: u64 = 16;

/// A machine ready to run.
struct Solved {
    machine: Machine<f64>,
    simulator: Simulator,
}

impl Solved {
    /// The scene's machine, with values of its own of some parameters.
    fn new(plan: &Plan, changes: &[(&str, f64)]) -> Result<Solved> {
        let machine = plan.scene.machine(changes)?;
        let given = plan.scene.machine_scene()?.minimum_depth;
        let simulator = Simulator::suited(&machine, given, &[])?;
        Ok(Solved { machine, simulator })
    }

    /// The simulator of motions from a state, if it is not the machine's own: where the scene gives no
    /// minimum depth, that of a motion follows from its start, as of a task.
    fn of(&self, plan: &Plan, start: &State) -> Result<Option<Simulator>> {
        if plan.scene.machine_scene()?.minimum_depth.is_some() {
            return Ok(None);
        }
        let depth = self.simulator.depth_for(std::slice::from_ref(start));
        Ok((depth != self.simulator.minimum_depth()).then(|| self.simulator.sharing(depth)))
    }
}

/// Follows all motions, on all cores. A record is the displacements of all coordinates, then their
/// velocities.
pub fn follow(
    plan: &Plan,
    points: &mut [f64],
    impacts: &mut [u64],
    ends: &mut [u8],
    watch: &Watch,
) -> Result<()> {
    let shared = match plan.varied {
        [] => Some(Solved::new(plan, &[])?),
        _ => None,
    };
    watch.begin(ends.len() as u64, "motions");
    if ends.is_empty() || plan.records == 0 {
        return Ok(());
    }
    let all = points.par_chunks_mut(plan.records * 2 * plan.coordinates);
    let all = all.zip(impacts.par_iter_mut()).zip(ends.par_iter_mut()).enumerate();
    all.try_for_each(|(motion, ((points, impacts), end))| {
        let own = match shared {
            Some(_) => None,
            None => Some(Solved::new(plan, &plan.changes(motion)).map_err(|error| named(motion, error))?),
        };
        // One of the two there is.
        if let Some(solved) = shared.as_ref().or(own.as_ref()) {
            (*impacts, *end) = one(plan, solved, motion, points, watch)?;
        }
        watch.advance(1)
    })
}

fn named(motion: usize, error: Error) -> Error {
    error.context(format!("motion {motion}"))
}

/// Follows a motion: its impacts after the transient, and how it ended.
fn one(plan: &Plan, solved: &Solved, motion: usize, points: &mut [f64], watch: &Watch) -> Result<(u64, u8)> {
    points.fill(f64::NAN);
    let (n, phase) = (plan.coordinates, TAU * (plan.phase - plan.phase.floor()));
    let (q, u) = plan.start(motion)?.split_at(n);
    let start = solved.machine.state(phase, q, u).map_err(|error| named(motion, error))?;
    let own = solved.of(plan, &start)?;
    let simulator = own.as_ref().unwrap_or(&solved.simulator);
    if simulator.is_behind(&start) {
        return Ok((0, BEHIND_A_WALL));
    }
    let run = simulator.start(Time::new(0, phase), start.q(), start.u());
    let mut run = run.map_err(|error| named(motion, error))?;
    let (mut end, mut passed) = (RunEnd::Reached, 0);
    let mut go_on = |until: u64| {
        let end = run.finish(Time::new(until as i64, phase));
        if let Some(error) = run.failure() {
            return Err(named(motion, error));
        }
        watch.advance(0)?;
        Ok((end, run.impacts(), run.state()))
    };
    let mut before = 0;
    while passed < plan.transient && end == RunEnd::Reached {
        passed = (passed + CHUNK).min(plan.transient);
        (end, before, _) = go_on(passed)?;
    }
    let mut impacts = before;
    let rate = solved.machine.rate();
    for period in 0..=(plan.records as u64 - 1) * plan.every {
        if end != RunEnd::Reached {
            break;
        }
        let state;
        (end, impacts, state) = go_on(plan.transient + period)?;
        if end == RunEnd::Reached && period.is_multiple_of(plan.every) {
            let record = &mut points[(period / plan.every) as usize * 2 * n..][..2 * n];
            record[..n].copy_from_slice(&solved.machine.displaced(state.q()));
            let velocities = solved.machine.displaced(state.u());
            record[n..].iter_mut().zip(velocities).for_each(|(to, u)| *to = u * rate);
        }
    }
    Ok((impacts - before, code(end)))
}
