//! Tasks of kind `map`: what a motion tends to over two parameters.

use std::{ops::Range, path::Path};

use serde::Serialize;

use super::{
    Finding, Job, Lines, Status,
    basins::NOT_SETTLED,
    diagram::value,
    parts::{foreign, record},
    row,
};
use crate::{
    attractor::diagram::Look,
    error::Result,
    motion::RunEnd,
    one::attractor::map::{MapCell, MapEnd, MapPlan, map_rows},
    output::Journal,
    scene::{branches::MapTask, phase},
};

row! {
    /// One kind of end and how many points of the map have it.
    pub struct MapRow {
        /// "periodic", "not-periodic", "not-settled", "behind-a-stop", "escaped", "impact-limit",
        /// "not-smooth" or "too-steep".
        pub end: &'static str,
        /// The period of a periodic motion, in forcing periods.
        pub period: Option<u32>,
        /// Its impacts in a period.
        pub impacts: Option<u64>,
        /// How many points.
        pub points: usize,
        /// The least Lyapunov exponent of them, times the forcing period; absent where there is none.
        pub least_exponent: Option<f64>,
        /// The largest.
        pub largest_exponent: Option<f64>,
    }
}

/// The kinds of ends that there are, and every point of the map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapFindings {
    /// The parameters, the first along the picture.
    pub varied: [String; 2],
    /// How many values each has.
    pub counts: [u32; 2],
    /// The kinds of ends: periodic ones by period and impacts, then the others.
    pub ends: Vec<MapRow>,
    /// The parameters' values.
    #[serde(skip)]
    pub values: [Vec<f64>; 2],
    /// The points, the first parameter fastest. Not in JSON: they are the task's CSV file.
    #[serde(skip)]
    pub cells: Vec<MapCell>,
}

impl Finding for MapFindings {
    fn status(&self) -> Status {
        if let Some(open) = self.ends.iter().find(|row| row.end == NOT_SETTLED) {
            return Status::undecided(format!(
                "at {} of {} points the motion is not settled: raise `transient`",
                open.points,
                self.cells.len()
            ));
        }
        if self.ends.iter().any(|row| row.end == "periodic" || row.end == "not-periodic") {
            return Status::Done;
        }
        Status::nothing(
            "at no point does the motion lead to an attractor: all are behind a stop or end before",
        )
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("map", format!("{} by {}", self.varied[0], self.varied[1]));
        lines.table("ends", &self.ends);
    }
}

/// The word for an end.
pub fn word(end: MapEnd) -> &'static str {
    match end {
        MapEnd::Periodic(_) => "periodic",
        MapEnd::NotPeriodic => "not-periodic",
        MapEnd::Unsettled => NOT_SETTLED,
        MapEnd::BehindAWall => "behind-a-stop",
        MapEnd::Ended(RunEnd::ImpactLimit) => "impact-limit",
        MapEnd::Ended(RunEnd::NotSmooth) => "not-smooth",
        MapEnd::Ended(RunEnd::TooSteep) => "too-steep",
        MapEnd::Ended(_) => "escaped",
    }
}

/// Follows the motion at every point, resuming from the checkpoint of an interrupted run if there is one.
///
/// # Errors
/// Those of the system at a point and of the simulator; an unusable checkpoint; an interruption.
pub(crate) fn map(task: &MapTask, job: &Job) -> Result<MapFindings> {
    let plan = plan(task, job)?;
    let rows = find(task, job, &plan, 0..plan.rows.len(), job.checkpoint().as_deref())?;
    Ok(findings(task, plan, rows.concat()))
}

/// Some rows of the map, each as a line of JSON, resuming from the checkpoint `file`.
pub(super) fn rows(task: &MapTask, job: &Job, rows: Range<u64>, file: &Path) -> Result<Vec<String>> {
    let rows = rows.start as usize..rows.end as usize;
    find(task, job, &plan(task, job)?, rows, Some(file))?.iter().map(record).collect()
}

/// The findings from all rows, as [`rows`] writes them.
pub(super) fn joined(task: &MapTask, job: &Job, rows: &[String]) -> Result<MapFindings> {
    let plan = plan(task, job)?;
    let mut cells = Vec::new();
    for (number, text) in rows.iter().enumerate() {
        let row: Vec<MapCell> = serde_json::from_str(text).map_err(|error| foreign(number, &error))?;
        if !plan.can_be_row(&row) {
            return Err(foreign(number, &"no run comes to it"));
        }
        cells.extend(row);
    }
    Ok(findings(task, plan, cells))
}

fn plan(task: &MapTask, job: &Job) -> Result<MapPlan> {
    let columns: Vec<f64> = (0..task.count).map(|i| value(&task.range, i, task.count)).collect();
    let upwards = (0..task.second_count).map(|i| value(&task.second_range, i, task.second_count));
    Ok(MapPlan {
        columns,
        rows: upwards.collect(),
        start: job.scene.state(&task.start)?,
        look: Look {
            phase: phase(&task.phase),
            transient: task.transient,
            points: task.points,
            longest: task.longest,
        },
    })
}

fn find(
    task: &MapTask,
    job: &Job,
    plan: &MapPlan,
    rows: Range<usize>,
    file: Option<&Path>,
) -> Result<Vec<Vec<MapCell>>> {
    if let Some(file) = file.filter(|_| !task.resume) {
        Journal::discard(file)?;
    }
    job.monitor.begin(rows.len() as u64, "rows");
    let identity = format!("{} {} {}", job.identity()?, task.parameter, task.second);
    let system = |first, second| {
        job.simulator_of(&job.scene.plain(&[(&task.parameter, first), (&task.second, second)])?)
    };
    map_rows(plan, system, rows, &identity, job.keep(file), job.monitor)
}

fn findings(task: &MapTask, plan: MapPlan, cells: Vec<MapCell>) -> MapFindings {
    MapFindings {
        varied: [task.parameter.clone(), task.second.clone()],
        counts: [task.count, task.second_count],
        ends: gather(&cells),
        values: [plan.columns, plan.rows],
        cells,
    }
}

fn gather(cells: &[MapCell]) -> Vec<MapRow> {
    let mut ends: Vec<MapRow> = Vec::new();
    for cell in cells {
        let (period, impacts) = match cell.end {
            MapEnd::Periodic(period) => (Some(period), Some(cell.impacts)),
            _ => (None, None),
        };
        let end = word(cell.end);
        let same = |row: &&mut MapRow| (row.end, row.period, row.impacts) == (end, period, impacts);
        let (least_exponent, largest_exponent) = (cell.exponent, cell.exponent);
        match ends.iter_mut().find(same) {
            Some(row) => {
                row.points += 1;
                let meet = |one: Option<f64>, pick: fn(f64, f64) -> f64| {
                    one.map_or(cell.exponent, |one| Some(cell.exponent.map_or(one, |other| pick(one, other))))
                };
                row.least_exponent = meet(row.least_exponent, f64::min);
                row.largest_exponent = meet(row.largest_exponent, f64::max);
            }
            None => ends.push(MapRow { end, period, impacts, points: 1, least_exponent, largest_exponent }),
        }
    }
    ends.sort_by_key(|row| (row.period.is_none(), row.period, row.impacts, row.end));
    ends
}
