//! Tasks of kind `basins`: which starts lead to which attractor.

use std::{f64::consts::TAU, ops::Range, path::Path};

use serde::Serialize;

use super::{
    Finding, Job, Lines, Model, Status,
    parts::{foreign, record},
    row,
    section::gap_size,
    small_motion,
};
use crate::{
    attractor::{
        basins::{BasinCell, BasinGrid, Basins, basin_rows},
        detection::Detection,
        dynamics::{Dynamics, SectionState},
        observe::Attraction,
    },
    error::Result,
    motion::{RunEnd, State},
    output::Journal,
    scene::{BasinsTask, StartAxis, phase},
};

row! {
    /// One end and how many starts lead to it.
    pub struct BasinRow {
        /// "periodic", "not-periodic", "not-settled", "behind-a-wall", "escaped", "impact-limit",
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
        Status::nothing("no start of the grid leads to an attractor: all are behind a wall or escape")
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
pub fn basins(task: &BasinsTask, job: &Job) -> Result<BasinsFindings> {
    let file = job.checkpoint();
    over(task, job, Whole { rows: 0..task.u.count as usize, file: file.as_deref() })
}

/// Some rows of the grid, each as a line of JSON, resuming from the checkpoint `file`.
pub(super) fn rows(task: &BasinsTask, job: &Job, rows: Range<u64>, file: &Path) -> Result<Vec<String>> {
    over(task, job, Part { rows: rows.start as usize..rows.end as usize, file: Some(file) })
}

/// The findings from all rows, as [`rows`] writes them.
pub(super) fn joined(task: &BasinsTask, job: &Job, rows: &[String]) -> Result<BasinsFindings> {
    over(task, job, Joined(rows))
}

/// What is looked for, whatever the system is.
struct Search<'a> {
    job: &'a Job<'a>,
    grid: BasinGrid,
    detection: Detection,
    identity: String,
    resume: bool,
}

/// The task for systems of one kind.
struct Setup<'a, D: Attraction> {
    search: Search<'a>,
    dynamics: &'a D,
    /// The start with two numbers in the plane.
    place: &'a (dyn Fn([f64; 2]) -> D::Start + Sync),
    /// If the scene names it.
    plane: Option<[String; 2]>,
    minimum_depth: f64,
    size: f64,
}

/// What to do with a task, whatever it is about.
trait Work {
    type Out;
    fn of<D: Attraction>(self, setup: Setup<D>) -> Result<Self::Out>;
}

struct Whole<'a> {
    rows: Range<usize>,
    file: Option<&'a Path>,
}

struct Part<'a> {
    rows: Range<usize>,
    file: Option<&'a Path>,
}

struct Joined<'a>(&'a [String]);

impl Work for Whole<'_> {
    type Out = BasinsFindings;

    fn of<D: Attraction>(self, setup: Setup<D>) -> Result<BasinsFindings> {
        let rows = setup.find(self.rows, self.file)?;
        Ok(gather(Basins::joined(rows), setup))
    }
}

impl Work for Part<'_> {
    type Out = Vec<String>;

    fn of<D: Attraction>(self, setup: Setup<D>) -> Result<Vec<String>> {
        setup.find(self.rows, self.file)?.iter().map(record).collect()
    }
}

impl Work for Joined<'_> {
    type Out = BasinsFindings;

    fn of<D: Attraction>(self, setup: Setup<D>) -> Result<BasinsFindings> {
        let read = |(number, text): (usize, &String)| {
            let row: Basins<D::Point> =
                serde_json::from_str(text).map_err(|error| foreign(number, &error))?;
            match row.can_be_row(&setup.search.grid, &setup.search.detection) {
                true => Ok(row),
                false => Err(foreign(number, &"no run comes to it")),
            }
        };
        let rows = self.0.iter().enumerate().map(read).collect::<Result<Vec<_>>>()?;
        Ok(gather(Basins::joined(rows), setup))
    }
}

impl<D: Attraction> Setup<'_, D> {
    fn find(&self, rows: Range<usize>, file: Option<&Path>) -> Result<Vec<Basins<D::Point>>> {
        let Search { job, grid, detection, identity, resume } = &self.search;
        if let Some(file) = file.filter(|_| !resume) {
            Journal::discard(file)?;
        }
        job.monitor.begin(rows.len() as u64, "rows");
        let keep = job.keep(file);
        basin_rows((self.dynamics, self.place), grid, detection, rows, identity, keep, job.monitor)
    }
}

fn over<W: Work>(task: &BasinsTask, job: &Job, work: W) -> Result<W::Out> {
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
    let mut search = Search { job, grid, detection, identity: job.identity()?, resume: task.resume };
    match &job.model {
        Model::Oscillator(_) => {
            let dynamics = &job.simulator()?;
            let minimum_depth = dynamics.settings().minimum_depth;
            let axes = job.scene.start_plane(&task.plane, "plane")?;
            let at = State { t: search.detection.phase, q: 0.0, u: 0.0 };
            let base = match &task.start {
                Some(start) => State { t: at.t, ..job.scene.state(start)? },
                None => at,
            };
            let place = &move |numbers: [f64; 2]| {
                let mut start = base;
                for (axis, x) in axes.into_iter().zip(numbers) {
                    match axis {
                        StartAxis::Place => start.q = x,
                        StartAxis::Speed => start.u = x,
                        StartAxis::Phase => start.t = TAU * (x - x.floor()),
                    }
                }
                start
            };
            // How large the motions are, as far as the grid tells.
            let extent =
                |(axis, [low, high]): (StartAxis, [f64; 2])| (axis == StartAxis::Place).then_some(high - low);
            let size = axes
                .into_iter()
                .zip([search.grid.q, search.grid.u])
                .find_map(extent)
                .unwrap_or(f64::INFINITY);
            let plane = match &task.plane[..] {
                [first, second] => Some([first.clone(), second.clone()]),
                _ => None,
            };
            if let Some(names) = &plane {
                let own = serde_json::to_string(&(names, base)).map_err(std::io::Error::other)?;
                search.identity = format!("{} {own}", search.identity);
            }
            work.of(Setup { search, dynamics, place, plane, minimum_depth, size })
        }
        Model::Machine(machine) => {
            let rest = job.scene.rest(&task.start, machine)?;
            let axes = job.scene.plane(&task.plane, machine, "plane")?;
            let planar = job.planar(machine, &[], &task.plane)?;
            let dynamics = &planar.starting(machine, &axes, [&rest[0], &rest[1]])?;
            let names = job.scene.plane_names(&task.plane);
            let own = serde_json::to_string(&(&names, &rest, dynamics.simulator().settings()));
            search.identity = format!("{} {}", search.identity, own.map_err(std::io::Error::other)?);
            let minimum_depth = dynamics.simulator().settings().minimum_depth;
            let (plane, size) = (Some(names), gap_size(dynamics.simulator()));
            let start = search.detection.phase;
            let place = &|at| dynamics.in_plane(at, start);
            work.of(Setup { search, dynamics, place, plane, minimum_depth, size })
        }
    }
}

fn gather<D: Attraction>(
    Basins { attractors, cells }: Basins<D::Point>,
    Setup { search, plane, minimum_depth, size, .. }: Setup<D>,
) -> BasinsFindings {
    let none = BasinRow { end: "", period: None, impacts: None, q: None, u: None, starts: 0 };
    let word = |end| BasinRow { end, ..none.clone() };
    let mut all = vec![
        word("behind-a-wall"),
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
        q: Some(cycle.points[0].plane()[0]),
        u: Some(cycle.points[0].plane()[1]),
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
    BasinsFindings { basins, grid: search.grid, plane, cells, minimum_depth, size }
}
