//! Tasks of kind `branch`: continuation of periodic orbits over a parameter, and of their bifurcations over
//! two.

use serde::Serialize;

use super::{
    Complex, Finding, Job, Judgement, Lines, Row, Status,
    orbit::{admissible, obstacle, phases, speeds, stable},
    row,
};
use crate::{
    attractor::detection::Detection,
    continuation::{
        Bifurcation, CODIMENSION_TWO, CurveEnd, Direction, EventCurve, FollowedOrbit, Label, NoForm,
        NormalForm, Options, OrbitBranch, PatternCurve, PatternFamily, PatternOf, PatternPlane,
    },
    error::{Error, Result},
    number::{Plain, Real},
    one::{
        attractor::attracting,
        branch::{BranchOrbit, OscillatorPatterns, OscillatorPlane, read_label},
        orbit::{Family, Itinerary, Orbit},
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
        /// The times of its impacts, as its pattern counts them, the first in [0, 2π).
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
        /// Its meaning: "supercritical", "subcritical", "above", "below", "transcritical", "degenerate"; or
        /// why there is none.
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

/// A row of a table of points of branches.
pub trait PointRow: Row + Serialize + Clone {
    /// Whether the point has a label.
    fn is_labelled(&self) -> bool;
}

impl PointRow for BranchRow {
    fn is_labelled(&self) -> bool {
        self.label.is_some()
    }
}

/// Branches, with all that happens along them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BranchList<R, O: FollowedOrbit> {
    /// The parameter, or both.
    pub varied: Vec<String>,
    /// How many points all branches have.
    pub points: usize,
    /// What became of every start.
    pub starts: Vec<StartRow>,
    /// The labelled points.
    pub labels: Vec<R>,
    /// Every point. Not in JSON: it is the task's CSV file.
    #[serde(skip)]
    pub rows: Vec<R>,
    /// The branches. Not in JSON: each has a file.
    #[serde(skip)]
    pub branches: Vec<OrbitBranch<O>>,
}

/// Branches of an oscillator.
pub type BranchFindings = BranchList<BranchRow, Orbit>;

impl<R: PointRow, O: FollowedOrbit> Finding for BranchList<R, O> {
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

impl<R: PointRow, O: FollowedOrbit> BranchList<R, O> {
    /// The findings of a task whose branches have these points.
    pub(super) fn of(
        task: &BranchTask,
        (branches, starts): (Vec<OrbitBranch<O>>, Vec<StartRow>),
        rows: Vec<R>,
    ) -> BranchList<R, O> {
        BranchList {
            varied: [&task.parameter].into_iter().chain(&task.second).cloned().collect(),
            points: rows.len(),
            starts,
            labels: rows.iter().filter(|row| row.is_labelled()).cloned().collect(),
            rows,
            branches,
        }
    }
}

/// Follows branches from all starts.
///
/// # Errors
/// A start outside the range, a file that cannot be read or has no such label; an interruption.
pub fn branch(task: &BranchTask, job: &Job) -> Result<BranchFindings> {
    let family = job.family(&task.parameter)?;
    let source = OscillatorSource::new(&family)?;
    let (branches, starts) = match &task.second {
        Some(second) => {
            let plane = |[first, other]: [f64; 2]| {
                let system = job.scene.plain(&[(&task.parameter, first), (second, other)])?;
                job.oscillator(system)
            };
            let value = SceneFamily::new(&job.scene, second)?.value();
            let plane = OscillatorPlane::new(&plane, [family.value(), value])?;
            events(task, &source, &plane, value, job)?
        }
        None => follow_over(task, &source, job)?,
    };
    let mut rows = Vec::new();
    for (branch, i) in branches.iter().zip(1..) {
        for point in &branch.points {
            let form = match (point.event, point.parameters.as_slice()) {
                (Some(event), &[parameter]) => {
                    Some(NormalForm::at(&family.at(parameter)?, &point.orbit, event))
                }
                _ => point.kind().map(|_| Err(CODIMENSION_TWO)),
            };
            rows.push(BranchRow::of(i, point, form));
        }
    }
    Ok(BranchFindings::of(task, (branches, starts), rows))
}

/// The branches of a task over one parameter.
pub(super) fn follow_over<S: BranchSource>(
    task: &BranchTask,
    source: &S,
    job: &Job,
) -> Result<Branches<<S::Family as PatternFamily>::Orbit>> {
    let range = (task.range[0], task.range[1]);
    follow(&task.starts, source, range, direction(task.direction), &task.options, job)
}

fn direction(way: Way) -> Direction {
    match way {
        Way::Both => Direction::Both,
        Way::Up => Direction::Forward,
        Way::Down => Direction::Backward,
    }
}

impl BranchRow {
    fn of(
        branch: usize,
        point: &BranchOrbit,
        form: Option<std::result::Result<NormalForm, NoForm>>,
    ) -> BranchRow {
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
            reason: obstacle(orbit, point.event),
            coefficient: form.and_then(|form| Some(form.ok()?.coefficient)),
            criticality: form.map(|form| form.map_or_else(|why| why, |form| form.name())),
            least_gap: orbit.least.map(|least| least.gap),
            residual: orbit.residual,
            newton_steps: orbit.steps,
            length: point.length,
        }
    }
}

/// What the branches of a scene are followed in.
pub(crate) trait BranchSource {
    /// The orbits over the parameter.
    type Family: PatternFamily + ?Sized;

    /// The orbits over the parameter.
    fn family(&self) -> &Self::Family;

    /// The scene's own value of the parameter.
    fn value(&self) -> f64;

    /// The admissible orbits that a start means, at a value of the parameter.
    ///
    /// # Errors
    /// Why there are none, or an interruption.
    fn orbits(
        &self,
        start: &BranchStart,
        at: f64,
        job: &Job,
    ) -> Result<Vec<<Self::Family as PatternFamily>::Orbit>>;

    /// A label of a branch's file.
    ///
    /// # Errors
    /// Those of [`read_label`].
    fn label(
        &self,
        text: &str,
        label: &str,
    ) -> Result<Label<PatternOf<<Self::Family as PatternFamily>::Orbit>>>;

    /// How a pattern is written.
    fn named(&self, pattern: &PatternOf<<Self::Family as PatternFamily>::Orbit>) -> String;
}

/// The branches of a scene's oscillator.
pub(crate) struct OscillatorSource<'a> {
    family: &'a SceneFamily<'a>,
    patterns: OscillatorPatterns<'a>,
}

impl<'a> OscillatorSource<'a> {
    /// # Errors
    /// Those of [`OscillatorPatterns::new`].
    pub fn new(family: &'a SceneFamily<'a>) -> Result<OscillatorSource<'a>> {
        Ok(OscillatorSource { family, patterns: OscillatorPatterns::new(family, family.value())? })
    }
}

impl<'a> BranchSource for OscillatorSource<'a> {
    type Family = OscillatorPatterns<'a>;

    fn family(&self) -> &OscillatorPatterns<'a> {
        &self.patterns
    }

    fn value(&self) -> f64 {
        self.family.value()
    }

    fn orbits(&self, start: &BranchStart, at: f64, job: &Job) -> Result<Vec<Orbit>> {
        let oscillator = self.family.at(at)?;
        match start.origin()? {
            BranchOrigin::Attractor(state) => {
                let from = job.scene.state(state)?;
                Ok(vec![attracting(&oscillator, from, &settled(from.t), &job.settings()?)?])
            }
            BranchOrigin::Orbit(keys) => {
                let mut orbits = keys.orbits(&oscillator)?;
                orbits.retain(|orbit| orbit.admissibility.is_admissible());
                Ok(orbits)
            }
            BranchOrigin::Restart(_) => Ok(Vec::new()),
        }
    }

    fn label(&self, text: &str, label: &str) -> Result<Label<Itinerary>> {
        read_label(text, label)
    }

    fn named(&self, pattern: &Itinerary) -> String {
        pattern.to_string()
    }
}

/// How the attractor is looked for on which a branch starts.
pub(super) fn settled(phase: f64) -> Detection {
    Detection { phase, transient: 10_000, longest: 200, ..Detection::default() }
}

/// Branches, and what became of every start.
type Branches<O> = (Vec<OrbitBranch<O>>, Vec<StartRow>);

/// The branches of some starts, and what became of each; an orbit that lies on a branch already followed
/// starts none.
pub(crate) fn follow<S: BranchSource>(
    starts: &[BranchStart],
    source: &S,
    range: (f64, f64),
    direction: Direction,
    options: &Options,
    job: &Job,
) -> Result<Branches<<S::Family as PatternFamily>::Orbit>> {
    let options = options.checked()?;
    let (mut found, mut rows) = (Vec::<OrbitBranch<_>>::new(), Vec::new());
    job.monitor.begin(starts.len() as u64, "starts");
    for (start, number) in starts.iter().zip(1..) {
        if let BranchOrigin::Restart(restart) = start.origin()? {
            let label = label(restart, source, job)?;
            let orbits = PatternCurve::over(source.family(), label.itinerary.clone(), range);
            let place = orbits.restart(&label, &options)?;
            let branch = if restart.switch {
                let (born, place) = orbits.switch(label.event, &place)?;
                // Against the tangent are the same orbits, a period later.
                let direction = if label.event == Bifurcation::Flip { Direction::Forward } else { direction };
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
            match source.orbits(start, at, job) {
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
                        let orbits = PatternCurve::over(source.family(), orbit.pattern().clone(), range);
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

fn label<S: BranchSource>(
    restart: &Restart,
    source: &S,
    job: &Job,
) -> Result<Label<PatternOf<<S::Family as PatternFamily>::Orbit>>> {
    let folder = job.folder.ok_or_else(|| Error::input("a restart needs the folder of its branch's file"))?;
    let file = folder.join(&restart.file);
    let text = read_text(&file, LONGEST_INPUT)?;
    source.label(&text, &restart.label).map_err(|error| error.context(file.display()))
}

/// The labels of the restarts, followed in two parameters, `value` being the scene's own of the second.
pub(super) fn events<S, P>(
    task: &BranchTask,
    source: &S,
    plane: &P,
    value: f64,
    job: &Job,
) -> Result<Branches<P::Orbit>>
where
    S: BranchSource,
    P: PatternPlane<Orbit = <S::Family as PatternFamily>::Orbit> + ?Sized,
{
    let options = task.options.checked()?;
    let (mut found, mut rows) = (Vec::new(), Vec::new());
    for (start, number) in task.starts.iter().zip(1..) {
        job.check()?;
        let BranchOrigin::Restart(restart) = start.origin()? else { continue };
        let label = label(restart, source, job)?;
        let ranges = [(task.range[0], task.range[1]), (task.second_range[0], task.second_range[1])];
        let parameters = [label.parameters[0], *label.parameters.get(1).unwrap_or(&value)];
        let events = EventCurve { plane, itinerary: label.itinerary.clone(), event: label.event, ranges };
        let place = events.start(&label.z, parameters, &options)?;
        let branch = OrbitBranch::follow(&events, &place, direction(task.direction), &options)?;
        rows.push(StartRow::of(number, found.len() + 1, &branch, source.named(&branch.itinerary)));
        found.push(branch);
    }
    Ok((found, rows))
}
