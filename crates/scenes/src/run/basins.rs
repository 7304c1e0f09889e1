//! Tasks of kind `basins`: which starts lead to which attractor.

use std::{ops::Range, path::Path};

use serde::Serialize;

use super::{
    Finding, Job, Lines, Status,
    engine::{Engine, StartPlane, by_engine},
    parts::{foreign, record},
    row, small_motion,
};
use crate::{
    attractor::{
        basins::{BasinCell, BasinGrid, Basins, basin_rows},
        detection::Detection,
        observe::Attraction,
    },
    error::Result,
    motion::RunEnd,
    output::Journal,
    scene::{BasinsTask, phase},
};

row! {
    /// One end and how many starts lead to it.
    pub struct BasinRow {
        /// "periodic", "not-periodic", "not-settled", "behind-a-stop", "escaped", "impact-limit",
        /// "not-smooth" or "too-steep".
        pub end: &'static str,
        /// The period of a periodic attractor, in forcing periods.
        pub period: Option<usize>,
        /// Its impacts in a period.
        pub impacts: Option<u64>,
        /// Displacement of its first point on the section; of machines the first number of the plane.
        pub q: Option<f64>,
        /// Velocity there; of machines the second.
        pub u: Option<f64>,
        /// How many starts lead to it.
        pub starts: usize,
    }
}

/// The ends that there are, each with the number of its starts, and the end of each start.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BasinsFindings {
    /// Ends with at least one start; attractors in the order in which starts lead to them.
    pub basins: Vec<BasinRow>,
    /// The grid of starts.
    pub grid: BasinGrid,
    /// What q and u stand for in the grid, and of a machine in rows, if the scene names it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plane: Option<[String; 2]>,
    /// For each start, q fastest, the index of its end in `basins`. Not in JSON: it is the task's CSV file.
    #[serde(skip)]
    pub cells: Vec<usize>,
    /// What counts as contact without impact.
    #[serde(skip)]
    minimum_depth: f64,
    /// How large motions are, as far as the grid or the machine tells; infinite where they do not.
    #[serde(skip)]
    size: f64,
}

/// The word for what was not decided.
pub(super) const NOT_SETTLED: &str = "not-settled";

impl Finding for BasinsFindings {
    fn status(&self) -> Status {
        if let Some(open) = self.basins.iter().find(|basin| basin.end == NOT_SETTLED) {
            let all = self.grid.columns * self.grid.rows;
            return Status::undecided(format!(
                "{} of {all} starts are not settled: it is not decided to what they lead; raise `transient`",
                open.starts
            ));
        }
        if self.basins.iter().any(|basin| basin.end == "periodic" || basin.end == "not-periodic") {
            return Status::Done;
        }
        Status::nothing("no start of the grid leads to an attractor: all are behind a stop or end before")
    }

    fn warnings(&self) -> Vec<String> {
        small_motion(self.size, self.minimum_depth).into_iter().collect()
    }

    fn lines(&self, lines: &mut Lines) {
        if let Some([first, second]) = &self.plane {
            lines.say("plane", format!("{first}, {second}"));
        }
        lines.table("basins", &self.basins);
    }
}

/// Finds the attractor of every start, resuming from the checkpoint of an interrupted run if there is one.
///
/// # Errors
/// Those of the simulator; an unusable checkpoint; an interruption.
pub(crate) fn basins(task: &BasinsTask, job: &Job) -> Result<BasinsFindings> {
    by_engine!(job, engine => {
        let (setup, file) = (Setup::new(task, job, &engine)?, job.checkpoint());
        let rows = setup.find(0..task.u.count as usize, file.as_deref())?;
        Ok(gather(Basins::joined(rows), setup))
    })
}

/// Some rows of the grid, each as a line of JSON, resuming from the checkpoint `file`.
pub(super) fn rows(task: &BasinsTask, job: &Job, rows: Range<u64>, file: &Path) -> Result<Vec<String>> {
    let rows = rows.start as usize..rows.end as usize;
    by_engine!(job, engine => Setup::new(task, job, &engine)?.find(rows, Some(file))?.iter().map(record).collect())
}

/// The findings from all rows, as [`rows`] writes them.
pub(super) fn joined(task: &BasinsTask, job: &Job, rows: &[String]) -> Result<BasinsFindings> {
    by_engine!(job, engine => {
        let setup = Setup::new(task, job, &engine)?;
        let rows = rows.iter().enumerate().map(|row| setup.read(row)).collect::<Result<Vec<_>>>()?;
        Ok(gather(Basins::joined(rows), setup))
    })
}

/// The task for systems of one engine.
struct Setup<'a, D: Attraction> {
    job: &'a Job<'a>,
    grid: BasinGrid,
    detection: Detection,
    starts: StartPlane<D>,
    resume: bool,
}

impl<'a, D: Attraction> Setup<'a, D> {
    fn new(task: &BasinsTask, job: &'a Job, engine: &impl Engine<Dynamics = D>) -> Result<Self> {
        let grid = BasinGrid {
            q: job.scene.ends(&task.q)?,
            u: job.scene.ends(&task.u)?,
            columns: task.q.count as usize,
            rows: task.u.count as usize,
        };
        let detection = Detection {
            phase: phase(&task.phase),
            transient: task.transient,
            longest: task.longest as usize,
            ..Detection::default()
        };
        let starts = engine.start_plane(task, &grid, detection.phase)?;
        Ok(Setup { job, grid, detection, starts, resume: task.resume })
    }

    fn find(&self, rows: Range<usize>, file: Option<&Path>) -> Result<Vec<Basins<D::Point>>> {
        let Setup { job, grid, detection, starts, resume } = self;
        if let Some(file) = file.filter(|_| !resume) {
            Journal::discard(file)?;
        }
        job.monitor.begin(rows.len() as u64, "rows");
        let place = |at| (starts.place)(&starts.dynamics, at);
        let (own, keep) = (&starts.identity, job.keep(file));
        let identity = format!("{}{}{own}", job.identity()?, if own.is_empty() { "" } else { " " });
        basin_rows((&starts.dynamics, &place), grid, detection, rows, &identity, keep, job.monitor)
    }

    fn read(&self, (number, text): (usize, &String)) -> Result<Basins<D::Point>> {
        let row: Basins<D::Point> = serde_json::from_str(text).map_err(|error| foreign(number, &error))?;
        match row.can_be_row(&self.grid, &self.detection) {
            true => Ok(row),
            false => Err(foreign(number, &"no run comes to it")),
        }
    }
}

fn gather<D: Attraction>(
    Basins { attractors, cells }: Basins<D::Point>,
    Setup { grid, starts, .. }: Setup<D>,
) -> BasinsFindings {
    let none = BasinRow { end: "", period: None, impacts: None, q: None, u: None, starts: 0 };
    let word = |end| BasinRow { end, ..none.clone() };
    let mut all = vec![
        word("behind-a-stop"),
        word("escaped"),
        word("impact-limit"),
        word("not-periodic"),
        word(NOT_SETTLED),
        word("not-smooth"),
        word("too-steep"),
    ];
    let others = all.len();
    all.extend(attractors.iter().map(|cycle| BasinRow {
        end: "periodic",
        period: Some(cycle.period()),
        impacts: Some(cycle.impacts),
        q: Some(starts.dynamics.drawn(&cycle.points[0])[0]),
        u: Some(starts.dynamics.drawn(&cycle.points[0])[1]),
        starts: 0,
    }));
    let class = |cell: &BasinCell| match cell {
        BasinCell::Behind => 0,
        BasinCell::Ended(RunEnd::ImpactLimit) => 2,
        BasinCell::Ended(RunEnd::NotSmooth) => 5,
        BasinCell::Ended(RunEnd::TooSteep) => 6,
        BasinCell::Ended(_) => 1,
        BasinCell::Irregular => 3,
        BasinCell::Unsettled => 4,
        BasinCell::Attractor(index) => others + index,
    };
    let classes: Vec<usize> = cells.iter().map(class).collect();
    classes.iter().for_each(|&class| all[class].starts += 1);
    // Only the ends that there are, in the same order.
    let mut index = vec![0; all.len()];
    let mut basins = Vec::new();
    for (class, basin) in all.into_iter().enumerate().filter(|(_, basin)| basin.starts > 0) {
        index[class] = basins.len();
        basins.push(basin);
    }
    let cells = classes.into_iter().map(|class| index[class]).collect();
    let StartPlane { plane, minimum_depth, size, .. } = starts;
    BasinsFindings { basins, grid, plane, cells, minimum_depth, size }
}
