//! Attractors over two parameters: what one start leads to at each point of a grid of systems, with the
//! largest Lyapunov exponent.
//!
//! Found by following motions, many at once, so nothing is proved: a long transient can look like an
//! attractor. Systems that are not linear are followed one by one.

use std::{f64::consts::TAU, ops::Range, path::Path};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{
    attractor::{
        Keep,
        checkpoint::Checkpoint,
        detection::{Detection, Fate, Recurrence},
        diagram::Look,
        dynamics::Dynamics,
    },
    error::Result,
    monitor::Monitor,
    motion::{Flow, RunEnd, State, algebra::apply, flow::Free},
    one::simulate::{Event, Simulator, batch::Batch},
};

/// What becomes of the start at one point of the map.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MapCell {
    /// How it ends.
    pub end: MapEnd,
    /// Impacts in a round of a periodic motion; of others in all periods looked at.
    pub impacts: u64,
    /// The largest Lyapunov exponent times the forcing period: of a periodic motion ln |λ| over its period,
    /// of others over the periods looked at; none where it is −∞, because the motion comes to rest on a wall,
    /// or where the motion ends.
    pub exponent: Option<f64>,
}

/// How a start ends at one point of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MapEnd {
    /// On a periodic motion, of this period in forcing periods.
    Periodic(u32),
    /// No recurrence seen.
    NotPeriodic,
    /// Not decided: a transient is not over, or points recur and no orbit is found.
    Unsettled,
    /// It cannot start: it is behind a wall.
    BehindAWall,
    /// The run ended.
    Ended(RunEnd),
}

/// A grid of systems, the first parameter fastest.
#[derive(Debug, Clone, Serialize)]
pub struct MapPlan {
    /// Values of the first parameter.
    pub columns: Vec<f64>,
    /// Values of the second.
    pub rows: Vec<f64>,
    /// Where the motion starts.
    pub start: State,
    /// For how long, and when it is looked at.
    pub look: Look,
}

/// Motions of different systems that are followed together: their tables fit a core's cache.
const TOGETHER: usize = 256;

/// Rows that run in parallel before they are kept.
const CHUNK: usize = 8;

/// Periods between two looks at whether to go on.
const PAUSE: u64 = 16;

/// The cells of a map, row by row. With a file, rows that are done are kept there, and those that it
/// holds of the same plan are not done again; `identity` is what else the result depends on. Cost:
/// `transient` + `points` periods for each cell.
///
/// # Errors
/// Those of a system; an unusable checkpoint; an interruption, after what was done is kept.
pub fn map(
    plan: &MapPlan,
    system: impl Fn(f64, f64) -> Result<Simulator> + Sync,
    identity: &str,
    file: Option<&Path>,
    monitor: &dyn Monitor,
) -> Result<Vec<MapCell>> {
    let keep = Keep { file, tally: None };
    Ok(map_rows(plan, system, 0..plan.rows.len(), identity, keep, monitor)?.concat())
}

/// Some rows of a map, each by itself. With a file, rows that are done are kept there, and those that it
/// holds of the same plan and rows are not done again; `identity` is what else the result depends on. Tells
/// `monitor` of each row. Cost: `transient` + `points` periods for each cell.
///
/// # Errors
/// Those of a system; an unusable checkpoint; an interruption, after what was done is kept.
pub fn map_rows(
    plan: &MapPlan,
    system: impl Fn(f64, f64) -> Result<Simulator> + Sync,
    rows: Range<usize>,
    identity: &str,
    keep: Keep,
    monitor: &dyn Monitor,
) -> Result<Vec<Vec<MapCell>>> {
    let text = serde_json::to_string(&(plan, &rows)).map_err(std::io::Error::other)?;
    let columns = plan.columns.len();
    // 128 bytes for each cell.
    let most = 4096 + 128 * (columns as u64 + 1) * (rows.len() as u64 + 1);
    let (mut checkpoint, mut done): (_, Vec<Vec<MapCell>>) =
        Checkpoint::open(keep, "map", &format!("{identity} {text}"), most, monitor)?;
    if done.len() > rows.len() || done.iter().any(|row| !plan.can_be_row(row)) {
        return Err(checkpoint.bad("a record is not of this map"));
    }
    monitor.advance(done.len() as u64)?;
    for chunk in rows.clone().skip(done.len()).collect::<Vec<_>>().chunks(CHUNK) {
        let parts: Vec<(usize, usize)> = chunk
            .iter()
            .flat_map(|&row| (0..columns).step_by(TOGETHER).map(move |column| (row, column)))
            .collect();
        let part = |&(row, column): &(usize, usize)| {
            let values = &plan.columns[column..columns.min(column + TOGETHER)];
            let systems = values.iter().map(|&first| system(first, plan.rows[row]));
            let found = cells_of(&systems.collect::<Result<Vec<_>>>()?, plan, monitor)?;
            monitor.advance(u64::from(column + TOGETHER >= columns))?;
            Ok(found)
        };
        let found: Result<Vec<Vec<MapCell>>> = parts.par_iter().map(part).collect();
        let found = match found {
            Ok(found) => found.concat(),
            Err(error) => return Err(checkpoint.ended(error, done.len(), rows.len(), "rows")),
        };
        let found: Vec<Vec<MapCell>> = found.chunks(columns).map(<[MapCell]>::to_vec).collect();
        checkpoint.append(&found)?;
        done.extend(found);
    }
    Ok(done)
}

impl MapPlan {
    /// Whether these can be the cells of a row.
    pub fn can_be_row(&self, row: &[MapCell]) -> bool {
        let cell = |cell: &MapCell| match cell.end {
            MapEnd::Periodic(period) => (1..=self.look.longest).contains(&period),
            _ => true,
        };
        row.len() == self.columns.len() && row.iter().all(cell)
    }
}

/// What the start leads to in each of these systems.
fn cells_of(simulators: &[Simulator], plan: &MapPlan, monitor: &dyn Monitor) -> Result<Vec<MapCell>> {
    let Look { phase, transient, points, longest } = plan.look;
    let nothing = MapCell { end: MapEnd::BehindAWall, impacts: 0, exponent: None };
    let mut cells = vec![nothing; simulators.len()];
    let (mut names, mut motions) = (Vec::new(), Vec::new());
    for (name, simulator) in simulators.iter().enumerate() {
        if let Ok(run) = simulator.begin(&plan.start) {
            names.push(name);
            motions.push((simulator, run));
        }
    }
    let mut batch = Batch::new(phase, motions);
    for passed in 0..=transient {
        batch.pass();
        if passed % PAUSE == 0 {
            monitor.advance(0)?;
        }
    }
    let detection = Detection { phase, transient: 0, longest: longest as usize, ..Detection::default() };
    let mut seen: Vec<Seen> = (0..names.len())
        .map(|motion| {
            let (at, impacts) = (batch.point(motion), batch.impacts(motion));
            let growth = Growth::new(&simulators[names[motion]], State { t: phase, q: at[0], u: at[1] });
            let recurrence = Recurrence::new(&detection, &simulators[names[motion]], at, monitor)?;
            Ok(Seen { recurrence, more: true, first: impacts, last: impacts, growth })
        })
        .collect::<Result<_>>()?;
    for passed in 0..u64::from(points) {
        batch.record(|motion, event| seen[motion].growth.see(event));
        if passed % PAUSE == 0 {
            monitor.advance(0)?;
        }
        for (motion, seen) in seen.iter_mut().enumerate() {
            if batch.end(motion) != RunEnd::Reached {
                seen.more = false;
                continue;
            }
            let at = batch.point(motion);
            seen.growth.reach(State { t: phase, q: at[0], u: at[1] });
            if seen.more {
                let impacts = batch.impacts(motion);
                seen.more = seen.recurrence.see(at, impacts - seen.last)?;
                seen.last = impacts;
            }
        }
    }
    for (motion, seen) in seen.iter_mut().enumerate() {
        let cell = &mut cells[names[motion]];
        let end = batch.end(motion);
        if end != RunEnd::Reached {
            *cell = MapCell { end: MapEnd::Ended(end), ..nothing };
            continue;
        }
        cell.exponent = Some(seen.growth.whole() / f64::from(points)).filter(|exponent| exponent.is_finite());
        let passed = batch.impacts(motion) - seen.first;
        (cell.end, cell.impacts) = match seen.recurrence.fate()? {
            Fate::Periodic(cycle) => {
                // Of a periodic motion the exponent is that of its multipliers.
                if let Some(first) = cycle.exponents().first() {
                    cell.exponent = Some(*first).filter(|exponent| exponent.is_finite());
                }
                (MapEnd::Periodic(cycle.period() as u32), cycle.impacts)
            }
            Fate::Unsettled => (MapEnd::Unsettled, passed),
            _ => (MapEnd::NotPeriodic, passed),
        };
    }
    Ok(cells)
}

/// A motion as it is looked at.
struct Seen<'a> {
    recurrence: Recurrence<'a, Simulator>,
    /// Whether it may still recur.
    more: bool,
    /// Its impacts when the looking began, and at the last point.
    first: u64,
    last: u64,
    growth: Growth<'a>,
}

/// A vector that the derivative of a motion carries along, told of the motion by its events.
struct Growth<'a> {
    simulator: &'a Simulator,
    vector: [f64; 2],
    /// Where the vector is in time: a state, as far as a flow needs it.
    state: State,
    /// How much time has passed since `state`, where nothing else counts (a linear flow).
    later: f64,
    /// Whether it has not been anywhere since the section.
    fresh: bool,
    /// The logarithm of its growth.
    sum: f64,
}

impl<'a> Growth<'a> {
    fn new(simulator: &'a Simulator, state: State) -> Self {
        Growth { simulator, vector: [0.6, 0.8], state, later: 0.0, fresh: true, sum: 0.0 }
    }

    /// On by a duration without impact.
    fn fly(&mut self, duration: f64) {
        let matrix = match self.simulator.flow() {
            Free::Linear(flow) => flow.matrix(std::mem::take(&mut self.later) + duration),
            flow => flow.advance_linearised(self.state, duration).1,
        };
        self.vector = apply(&matrix, self.vector);
    }

    fn see(&mut self, event: Event) {
        match event {
            Event::Impact(impact) => {
                let t = impact.time.phase;
                self.fly((t - self.state.t).rem_euclid(TAU));
                let contact = self.simulator.contact(impact.place).expect("a wall that was met");
                let [q, speed, _] = contact.position.at(t);
                let u = speed + contact.side.sign() * impact.velocity;
                let arrival = State { t, q, u };
                self.vector = apply(&contact.saltation(self.simulator.flow(), arrival), self.vector);
                (self.state, self.fresh) = (contact.bounce(arrival), false);
                self.measure();
            }
            Event::Stick(_) | Event::Release(_) => self.vector = [0.0; 2],
            _ => {}
        }
    }

    /// At the section, a period after it was there last.
    fn reach(&mut self, state: State) {
        let duration = if self.fresh { TAU } else { (state.t - self.state.t).rem_euclid(TAU) };
        let waits = matches!(self.simulator.flow(), Free::Linear(_)) && self.later < 4.0 * TAU;
        if waits {
            self.later += duration;
        } else {
            self.fly(duration);
            self.measure();
        }
        (self.state, self.fresh) = (state, true);
    }

    /// The logarithm of all its growth.
    fn whole(&mut self) -> f64 {
        if self.later > 0.0 {
            self.fly(0.0);
        }
        self.measure();
        self.sum
    }

    /// A unit vector again, the logarithm of its length taken.
    fn measure(&mut self) {
        let size = self.vector[0].hypot(self.vector[1]);
        self.sum += size.ln();
        if size > 0.0 {
            self.vector = self.vector.map(|x| x / size);
        }
    }
}
