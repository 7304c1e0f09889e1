//! Tasks of kind `branch`: continuation of periodic orbits over a parameter, and of their bifurcations over
//! two.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{
    Analysed, CertificateFile, Finding, Job, Lines, PieceProofs, Status,
    engine::{AnalysedEvent, Branches, Engine, OrbitSource, by_engine},
    monitors::{MonitoredRow, Watch},
    pieces,
    restart::{FixedRow, exact, fixed, no_event, restarted},
    row,
};
use crate::{
    attractor::detection::Detection,
    continuation::{
        Bifurcation, CODIMENSION_TWO, CurveEnd, Direction, EventCurve, FollowedOrbit, Level, Options,
        OrbitBranch, PatternCurve, PatternPlane,
    },
    error::Result,
    many,
    number::{Plain, Real},
    one,
    scene::{
        Scene,
        branches::{BranchOrigin, BranchStart, BranchTask, Way},
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
        with {
            /// The orbit there.
            pub orbit: Analysed
        }
        /// The normal form's coefficient at a label.
        pub coefficient: Option<f64>,
        /// Its meaning: "supercritical", "subcritical", "above", "below", "transcritical", "degenerate"; or
        /// why there is none.
        pub criticality: Option<&'static str>,
        /// The branch's length from the start, negative on the backward side.
        pub length: f64,
        /// The file of the certificate that proves that there is an orbit, and that near this one.
        pub certificate: Option<String>,
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

/// Branches of an engine's orbits.
#[derive(Debug, Clone, PartialEq)]
pub enum FoundBranches {
    /// Of an oscillator.
    One(Vec<OrbitBranch<one::orbit::Orbit>>),
    /// Of a machine.
    Many(Vec<OrbitBranch<many::orbit::Orbit>>),
}

impl FoundBranches {
    /// How each ends, against its direction and along it.
    fn ends(&self) -> Box<dyn Iterator<Item = &[CurveEnd; 2]> + '_> {
        match self {
            FoundBranches::One(all) => Box::new(all.iter().map(|branch| &branch.ends)),
            FoundBranches::Many(all) => Box::new(all.iter().map(|branch| &branch.ends)),
        }
    }
}

impl From<Vec<OrbitBranch<one::orbit::Orbit>>> for FoundBranches {
    fn from(all: Vec<OrbitBranch<one::orbit::Orbit>>) -> Self {
        FoundBranches::One(all)
    }
}

impl From<Vec<OrbitBranch<many::orbit::Orbit>>> for FoundBranches {
    fn from(all: Vec<OrbitBranch<many::orbit::Orbit>>) -> Self {
        FoundBranches::Many(all)
    }
}

/// Branches, with all that happens along them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BranchFindings {
    /// The parameter, or both.
    pub varied: Vec<String>,
    /// Other parameters that have not the scene's values, but those of the point that it starts at.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fixed: Vec<FixedRow>,
    /// How many points all branches have.
    pub points: usize,
    /// What became of every start.
    pub starts: Vec<StartRow>,
    /// The labelled points.
    pub labels: Vec<MonitoredRow>,
    /// What is proved of them; null if that was not asked for.
    pub proofs: Option<PieceProofs>,
    /// Every point. Not in JSON: it is the task's CSV file.
    #[serde(skip)]
    pub rows: Vec<MonitoredRow>,
    /// Monitors without a value somewhere, and why at first. Not in JSON: warnings are.
    #[serde(skip)]
    pub empty: BTreeMap<String, String>,
    /// The branches. Not in JSON: each has a file.
    #[serde(skip)]
    pub branches: FoundBranches,
}

impl BranchFindings {
    /// The scene with the values that other parameters have here.
    ///
    /// # Errors
    /// Those of [`Scene::with`].
    pub fn scene(&self, scene: &Scene) -> Result<Scene> {
        scene.with(&exact(&self.fixed))
    }
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
        let broken = self.branches.ends().zip(1..).find_map(|(ends, i)| {
            ends.iter()
                .find(|end| lost(end))
                .map(|end| format!("branch {i} was not followed to an end: {end}"))
        });
        let proved = || self.proofs.as_ref().map_or(Status::Done, PieceProofs::status);
        broken.map_or_else(proved, Status::undecided)
    }

    fn warnings(&self) -> Vec<String> {
        let told = |(name, why): (&String, &String)| {
            format!(
                "monitor {name} has no value at some points, where its cells are empty: at the first {why}"
            )
        };
        self.empty.iter().map(told).collect()
    }

    fn lines(&self, lines: &mut Lines) {
        if !self.fixed.is_empty() {
            lines.table("fixed", &self.fixed);
        }
        lines.say("points", self.points);
        lines.table("starts", &self.starts);
        lines.table("labels", &self.labels);
        for kind in Bifurcation::ALL {
            let is_one = |row: &MonitoredRow| {
                let name = row.label.as_ref().and_then(|label| label.rsplit_once(' '));
                name.is_some_and(|(name, _)| name == kind.name())
            };
            if let Some(meaning) = kind.meaning().filter(|_| self.labels.iter().any(is_one)) {
                lines.say(kind.name(), meaning);
            }
        }
        if let Some(proofs) = &self.proofs {
            proofs.lines(lines);
        }
    }

    fn certificates(&self) -> Vec<&CertificateFile> {
        self.proofs.iter().flat_map(|proofs| &proofs.certificates).collect()
    }
}

/// Follows branches from all starts.
///
/// # Errors
/// A start outside the range, a file that cannot be read or has no such label; an interruption.
pub(crate) fn branch(task: &BranchTask, job: &Job) -> Result<BranchFindings> {
    let fixed = by_engine!(job, engine => fixed(task, job, &engine))?;
    if fixed.is_empty() {
        return by_engine!(job, engine => of(task, job, &engine));
    }
    let there = job.with(&exact(&fixed))?;
    let found = by_engine!(&there, engine => of(task, &there, &engine))?;
    Ok(BranchFindings { fixed, ..found })
}

fn of<E: Engine>(task: &BranchTask, job: &Job, engine: &E) -> Result<BranchFindings>
where
    FoundBranches: From<Vec<OrbitBranch<E::Orbit>>>,
{
    let family = engine.family(&task.parameter)?;
    let source = engine.source(&family)?;
    let watch = Watch::new(task, &source, &job.scene)?;
    let levels = watch.levels(task.levels.0.iter());
    let (branches, starts) = match &task.second {
        Some(second) => source.loci(task, second)?,
        None => {
            let (range, way) = ((task.range[0], task.range[1]), direction(task.direction));
            let along = (task.parameter.as_str(), range);
            follow(&task.starts, (&source, &levels), along, way, &task.options, job)?
        }
    };
    let (proofs, marks) = match task.prove {
        true => pieces::prove(&branches, &task.parameter, engine, job)
            .map(|(proofs, marks)| (Some(proofs), marks))?,
        false => (None, Vec::new()),
    };
    let varied: Vec<String> = [&task.parameter].into_iter().chain(&task.second).cloned().collect();
    let (mut rows, mut empty) = (Vec::new(), BTreeMap::new());
    for (branch, number) in branches.iter().zip(1..) {
        for (point, place) in branch.points.iter().zip(0..) {
            let names = varied.iter().map(String::as_str);
            let at: Vec<(&str, f64)> = names.zip(point.parameters.iter().copied()).collect();
            let AnalysedEvent { orbit, form, .. } = source.analysed(&point.orbit, &at, point.event)?;
            // Along a curve of bifurcations every other one is of codimension two.
            let double = branch.subject.is_some() && point.level.is_none();
            let form = form.or_else(|| point.kind().filter(|_| double).map(|_| Err(CODIMENSION_TWO)));
            let (coefficient, criticality) = AnalysedEvent::form(form);
            let monitors = watch.row(&point.orbit, &point.parameters, &mut empty);
            let row = BranchRow {
                orbit,
                branch: number,
                label: point.label.clone(),
                parameters: point.parameters.clone(),
                coefficient,
                criticality,
                length: point.length,
                certificate: marks.get(number - 1).and_then(|marks| marks[place].clone()),
            };
            rows.push(MonitoredRow { row, monitors });
        }
    }
    Ok(BranchFindings {
        varied,
        fixed: Vec::new(),
        points: rows.len(),
        starts,
        labels: rows.iter().filter(|row| row.label.is_some()).cloned().collect(),
        proofs,
        rows,
        empty,
        branches: branches.into(),
    })
}

fn direction(way: Way) -> Direction {
    match way {
        Way::Both => Direction::Both,
        Way::Up => Direction::Forward,
        Way::Down => Direction::Backward,
    }
}

/// How the attractor is looked for on which a branch starts.
pub(super) fn settled(phase: f64) -> Detection {
    Detection { phase, transient: 10_000, longest: 200, ..Detection::default() }
}

/// The branches of some starts, and what became of each; an orbit that lies on a branch already followed
/// starts none.
pub fn follow<S: OrbitSource>(
    starts: &[BranchStart],
    (source, levels): (&S, &[Level<S::Orbit>]),
    (parameter, range): (&str, (f64, f64)),
    direction: Direction,
    options: &Options,
    job: &Job,
) -> Result<Branches<S::Orbit>> {
    let options = options.checked()?;
    let (mut found, mut rows) = (Vec::<OrbitBranch<_>>::new(), Vec::new());
    job.monitor.begin(starts.len() as u64, "starts");
    for (start, number) in starts.iter().zip(1..) {
        if let BranchOrigin::Restart(restart) = start.origin()? {
            let label = restarted(restart, &[parameter], source, job)?;
            let orbits = PatternCurve::over(source.family(), label.itinerary.clone(), range).telling(levels);
            let place = orbits.restart(&label, &options)?;
            let branch = if restart.switch {
                let event = label.event.ok_or_else(|| no_event(restart))?;
                let (born, place) = orbits.switch(event, &place)?;
                // Against the tangent are the same orbits, a period later.
                let direction = if event == Bifurcation::Flip { Direction::Forward } else { direction };
                OrbitBranch::follow(&born, &place, direction, &options)?
            } else {
                OrbitBranch::follow(&orbits, &place, direction, &options)?
            };
            rows.push(StartRow::of(number, found.len() + 1, &branch, source.named(&branch.itinerary)));
            found.push(branch);
        } else {
            let at = start.at.as_ref().map_or(source.value(), |value| Plain::ratio(value, &()).0);
            let nothing = |reason: String| StartRow {
                start: number,
                pattern: None,
                branch: None,
                backward: None,
                forward: None,
                reason: Some(reason),
            };
            match source.orbits(start, at) {
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => rows.push(nothing(error.to_string())),
                Ok(orbits) if orbits.is_empty() => {
                    rows.push(nothing(format!("no admissible orbit of the pattern found at {at}")));
                }
                Ok(orbits) => {
                    for orbit in orbits {
                        let pattern = source.named(orbit.pattern());
                        if let Some(index) = found.iter().position(|branch| branch.passes(&orbit, at)) {
                            rows.push(StartRow {
                                pattern: Some(pattern),
                                branch: Some(index + 1),
                                ..nothing("lies on a branch already followed".into())
                            });
                            continue;
                        }
                        let pattern_of = orbit.pattern().clone();
                        let orbits = PatternCurve::over(source.family(), pattern_of, range).telling(levels);
                        let place = orbits.start_at(&orbit, at, &options)?;
                        let branch = OrbitBranch::follow(&orbits, &place, direction, &options)?;
                        rows.push(StartRow::of(number, found.len() + 1, &branch, pattern));
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
    fn of<O: FollowedOrbit>(
        start: usize,
        number: usize,
        branch: &OrbitBranch<O>,
        pattern: String,
    ) -> StartRow {
        let [backward, forward] = branch.ends.each_ref().map(|end| Some(end.to_string()));
        StartRow { start, pattern: Some(pattern), branch: Some(number), backward, forward, reason: None }
    }
}

/// The labels of the restarts, followed in two parameters.
pub(super) fn events<S, P>(
    task: &BranchTask,
    second: &str,
    (source, plane): (&S, &P),
    job: &Job,
) -> Result<Branches<P::Orbit>>
where
    S: OrbitSource,
    P: PatternPlane<Orbit = S::Orbit> + ?Sized,
{
    let options = task.options.checked()?;
    let watch = Watch::new(task, source, &job.scene)?;
    let levels = watch.levels(task.hold.0.iter().chain(&task.levels.0));
    let (mut found, mut rows) = (Vec::new(), Vec::new());
    for (start, number) in task.starts.iter().zip(1..) {
        job.check()?;
        let BranchOrigin::Restart(restart) = start.origin()? else { continue };
        let label = restarted(restart, &[&task.parameter, second], source, job)?;
        let ranges = [(task.range[0], task.range[1]), (task.second_range[0], task.second_range[1])];
        let parameters = [label.parameters[0], label.parameters[1]];
        let event = match &task.hold.0[..] {
            [] => Some(label.event.ok_or_else(|| no_event(restart))?),
            _ => None,
        };
        let (itinerary, levels) = (label.itinerary.clone(), &levels[..]);
        let events = EventCurve { plane, itinerary, event, ranges, levels };
        let place = events.start(&label.z, parameters, &options)?;
        let branch = OrbitBranch::follow(&events, &place, direction(task.direction), &options)?;
        rows.push(StartRow::of(number, found.len() + 1, &branch, source.named(&branch.itinerary)));
        found.push(branch);
    }
    Ok((found, rows))
}
