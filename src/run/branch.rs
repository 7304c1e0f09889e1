//! Tasks of kind `branch`: continuation of periodic orbits over a parameter, and of their bifurcations over
//! two.

use serde::Serialize;

use super::{
    Complex, Finding, Job, Judgement, Lines, Status,
    orbit::{admissible, obstacle, phases, speeds, stable},
    row,
};
use crate::{
    error::{Error, Result},
    number::{Plain, Real},
    oscillator::{
        attractor::{attracting, detection::Detection},
        branch::{
            Bifurcation, Branch, BranchOrbit, CurveEnd, Direction, Events, Label, NormalForm, Options,
            Orbits, read_label,
        },
        orbit::{Family, Orbit, Oscillator},
    },
    output::{LONGEST_INPUT, read_text},
    scene::{
        SceneFamily,
        branches::{BranchOrigin, BranchStart, BranchTask, Restart, Way},
    },
};

row! {
    /// A point of a branch.
    pub struct BranchRow {
        /// The branch, counted from 1.
        pub branch: usize,
        /// What happens here, as "flip 1".
        pub label: Option<String>,
        /// The parameter, or both.
        pub parameters: Vec<f64>,
        /// The impact pattern.
        pub pattern: String,
        /// The phases of its impacts, in [0, 2π).
        pub phases: Vec<f64>,
        /// Their incoming relative speeds.
        pub speeds: Vec<f64>,
        /// The larger multiplier.
        pub lambda1: Complex,
        /// The smaller.
        pub lambda2: Complex,
        /// Whether both are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit.
        pub admissible: Judgement,
        /// Why not.
        pub reason: Option<String>,
        /// The normal form's coefficient at a label.
        pub coefficient: Option<f64>,
        /// Its meaning: "supercritical", "subcritical", "above", "below", "transcritical".
        pub criticality: Option<&'static str>,
        /// The least minimum of a gap away from the impacts.
        pub least_gap: Option<f64>,
        /// What is left of the equations.
        pub residual: f64,
        /// Newton steps taken.
        pub newton_steps: usize,
        /// The branch's length from the start, negative on the backward side.
        pub length: f64,
    }
}

row! {
    /// What became of a start, and of each orbit found there.
    pub struct StartRow {
        /// The start, counted from 1.
        pub start: usize,
        /// The orbit's pattern.
        pub pattern: Option<String>,
        /// The branch, counted from 1, that starts there or passes there; none if nothing was found.
        pub branch: Option<usize>,
        /// How the branch ends against its direction.
        pub backward: Option<String>,
        /// How it ends along it.
        pub forward: Option<String>,
        /// Why there is none, or which start it was followed from.
        pub reason: Option<String>,
    }
}

/// Branches, with all that happens along them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BranchFindings {
    /// The parameter, or both.
    pub varied: Vec<String>,
    /// How many points all branches have.
    pub points: usize,
    /// What became of every start.
    pub starts: Vec<StartRow>,
    /// The labelled points.
    pub labels: Vec<BranchRow>,
    /// Every point. Not in JSON: it is the task's CSV file.
    #[serde(skip)]
    pub rows: Vec<BranchRow>,
    /// The branches. Not in JSON: each has a file.
    #[serde(skip)]
    pub branches: Vec<Branch>,
}

impl Finding for BranchFindings {
    fn status(&self) -> Status {
        let empty = self.starts.iter().find(|start| start.branch.is_none());
        if let Some(StartRow { start, reason, .. }) = empty {
            return Status::nothing(format!(
                "start {start}: {}",
                reason.as_deref().unwrap_or("nothing found")
            ));
        }
        let lost = |end: &CurveEnd| matches!(end, CurveEnd::Lost(_) | CurveEnd::Points);
        let broken = self.branches.iter().zip(1..).find_map(|(branch, i)| {
            branch
                .ends
                .iter()
                .find(|end| lost(end))
                .map(|end| format!("branch {i} was not followed to an end: {end}"))
        });
        broken.map_or(Status::Done, Status::undecided)
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("points", self.points);
        lines.table("starts", &self.starts);
        lines.table("labels", &self.labels);
    }
}

/// Follows branches from all starts.
///
/// # Errors
/// A start outside the range, a file that cannot be read or has no such label; an interruption.
pub fn branch(task: &BranchTask, job: &Job) -> Result<BranchFindings> {
    let direction = match task.direction {
        Way::Both => Direction::Both,
        Way::Up => Direction::Forward,
        Way::Down => Direction::Backward,
    };
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let range = (task.range[0], task.range[1]);
    let (branches, starts) = match &task.second {
        Some(second) => events(task, second, direction, job)?,
        None => follow(&task.starts, &family, range, direction, &task.options, job)?,
    };
    let mut rows = Vec::new();
    for (branch, i) in branches.iter().zip(1..) {
        for point in &branch.points {
            let form = match (point.event, point.parameters.as_slice()) {
                (Some(event), &[parameter]) => NormalForm::at(&family.at(parameter)?, &point.orbit, event),
                _ => None,
            };
            rows.push(BranchRow::of(i, point, form));
        }
    }
    Ok(BranchFindings {
        varied: [&task.parameter].into_iter().chain(&task.second).cloned().collect(),
        points: rows.len(),
        starts,
        labels: rows.iter().filter(|row| row.label.is_some()).cloned().collect(),
        rows,
        branches,
    })
}

impl BranchRow {
    fn of(branch: usize, point: &BranchOrbit, form: Option<NormalForm>) -> BranchRow {
        let orbit = &point.orbit;
        let [lambda1, lambda2] = orbit.multipliers.values().map(Complex::from);
        BranchRow {
            branch,
            label: point.label.clone(),
            parameters: point.parameters.clone(),
            pattern: orbit.itinerary.to_string(),
            phases: phases(orbit),
            speeds: speeds(orbit),
            lambda1,
            lambda2,
            stable: stable(orbit, point.event),
            admissible: admissible(orbit, point.event),
            reason: obstacle(orbit),
            coefficient: form.map(|form| form.coefficient),
            criticality: form.map(|form| form.name()),
            least_gap: orbit.least.map(|least| least.gap),
            residual: orbit.residual,
            newton_steps: orbit.steps,
            length: point.length,
        }
    }
}

/// The branches of some starts, and what became of each; an orbit that lies on a branch already followed
/// starts none.
pub(crate) fn follow(
    starts: &[BranchStart],
    family: &SceneFamily,
    range: (f64, f64),
    direction: Direction,
    options: &Options,
    job: &Job,
) -> Result<(Vec<Branch>, Vec<StartRow>)> {
    let options = options.checked()?;
    let (mut found, mut rows) = (Vec::<Branch>::new(), Vec::new());
    job.monitor.begin(starts.len() as u64, "starts");
    for (start, number) in starts.iter().zip(1..) {
        if let BranchOrigin::Restart(restart) = start.origin()? {
            let label = label(restart, job)?;
            let orbits = Orbits::over(family, label.itinerary.clone(), range);
            let place = orbits.restart(&label, &options)?;
            let branch = if restart.switch {
                let (born, place) = orbits.switch(label.event, &place)?;
                // Against the tangent are the same orbits, a period later.
                let direction = if label.event == Bifurcation::Flip { Direction::Forward } else { direction };
                Branch::follow(&born, &place, direction, &options)?
            } else {
                Branch::follow(&orbits, &place, direction, &options)?
            };
            rows.push(StartRow::of(number, found.len() + 1, &branch));
            found.push(branch);
        } else {
            let at = start.at.as_ref().map_or(family.value(), |value| Plain::ratio(value, &()).0);
            let nothing = |reason: String| StartRow {
                start: number,
                pattern: None,
                branch: None,
                backward: None,
                forward: None,
                reason: Some(reason),
            };
            match orbits_at(start, &family.at(at)?, job) {
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => rows.push(nothing(error.to_string())),
                Ok(orbits) if orbits.is_empty() => {
                    rows.push(nothing(format!("no admissible orbit of the pattern found at {at}")));
                }
                Ok(orbits) => {
                    for orbit in orbits {
                        if let Some(index) = found.iter().position(|branch| branch.passes(&orbit, at)) {
                            rows.push(StartRow {
                                pattern: Some(orbit.itinerary.to_string()),
                                branch: Some(index + 1),
                                ..nothing("lies on a branch already followed".into())
                            });
                            continue;
                        }
                        let orbits = Orbits::over(family, orbit.itinerary.clone(), range);
                        let place = orbits.start(orbit.z, at, &options)?;
                        let branch = Branch::follow(&orbits, &place, direction, &options)?;
                        rows.push(StartRow::of(number, found.len() + 1, &branch));
                        found.push(branch);
                        job.check()?;
                    }
                }
            }
        }
        job.monitor.advance(1)?;
    }
    Ok((found, rows))
}

impl StartRow {
    fn of(start: usize, number: usize, branch: &Branch) -> StartRow {
        let [backward, forward] = branch.ends.each_ref().map(|end| Some(end.to_string()));
        let pattern = Some(branch.itinerary.to_string());
        StartRow { start, pattern, branch: Some(number), backward, forward, reason: None }
    }
}

/// The admissible orbits that a start means.
fn orbits_at(start: &BranchStart, oscillator: &Oscillator, job: &Job) -> Result<Vec<Orbit>> {
    match start.origin()? {
        BranchOrigin::Attractor(state) => {
            let from = job.scene.state(state)?;
            let detection =
                Detection { phase: from.t, transient: 10_000, longest: 200, ..Detection::default() };
            Ok(vec![attracting(oscillator, from, &detection, &job.settings())?])
        }
        BranchOrigin::Orbit(keys) => {
            let mut orbits = keys.orbits(oscillator)?;
            orbits.retain(|orbit| orbit.admissibility.is_admissible());
            Ok(orbits)
        }
        BranchOrigin::Restart(_) => Ok(Vec::new()),
    }
}

fn label(restart: &Restart, job: &Job) -> Result<Label> {
    let folder = job.folder.ok_or_else(|| Error::input("a restart needs the folder of its branch's file"))?;
    let file = folder.join(&restart.file);
    let text = read_text(&file, LONGEST_INPUT)?;
    read_label(&text, &restart.label).map_err(|error| error.context(file.display()))
}

/// The labels of the restarts, followed in two parameters.
fn events(
    task: &BranchTask,
    second: &str,
    direction: Direction,
    job: &Job,
) -> Result<(Vec<Branch>, Vec<StartRow>)> {
    let options = task.options.checked()?;
    let plane = |[first, other]: [f64; 2]| {
        let system = job.scene.plain(&[(&task.parameter, first), (second, other)])?;
        Oscillator::new(system, job.scene.accuracy.tolerance)
    };
    let value = SceneFamily::new(&job.scene, second)?.value();
    let (mut found, mut rows) = (Vec::new(), Vec::new());
    for (start, number) in task.starts.iter().zip(1..) {
        job.check()?;
        let BranchOrigin::Restart(restart) = start.origin()? else { continue };
        let label = label(restart, job)?;
        let ranges = [(task.range[0], task.range[1]), (task.second_range[0], task.second_range[1])];
        let events = Events { plane: &plane, itinerary: label.itinerary.clone(), event: label.event, ranges };
        let parameters = [label.parameters[0], *label.parameters.get(1).unwrap_or(&value)];
        let place = events.start(&label.z, parameters, &options)?;
        let branch = Branch::follow(&events, &place, direction, &options)?;
        rows.push(StartRow::of(number, found.len() + 1, &branch));
        found.push(branch);
    }
    Ok((found, rows))
}
