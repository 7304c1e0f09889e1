//! Tasks of kind `diagram`: what motions tend to over a parameter.

use std::{ops::Range, path::Path};

use num_rational::BigRational;
use serde::Serialize;

use super::{
    AttractorProofs, CertificateFile, DiagramBandRow, Finding, Job, Lines, Status,
    engine::{Engine, by_engine},
    parts::{foreign, record},
    proved::{Proving, StartOf},
    row,
    swept::{Leg, SweepFindings, way},
};
use crate::{
    attractor::{
        diagram::{self, DiagramMotion, DiagramPlan, Look, Slice, SweepStep},
        observe::Attraction,
    },
    error::{Error, Result},
    number::{Plain, Real},
    output::Journal,
    scene::{
        branches::{DiagramTask, SweepWay},
        phase,
    },
};

row! {
    /// Neighbouring values at which an attractor of one period with one number of impacts is found.
    pub struct WindowRow {
        /// The first value.
        pub from: f64,
        /// The last value.
        pub to: f64,
        /// The period, in forcing periods.
        pub period: u32,
        /// Impacts in a period.
        pub impacts: u64,
        /// How many values.
        pub values: usize,
    }
}

row! {
    /// An attractor at a value at which there are several, or at which starts are lost.
    pub struct CoexistingRow {
        /// The parameter's value.
        pub value: f64,
        /// The period, absent if it is not periodic.
        pub period: Option<u32>,
        /// Impacts in a period; for motions that are not periodic, in all points looked at.
        pub impacts: Option<u64>,
        /// Starts at this value whose motion left every bound, or that are behind a stop.
        pub lost: u32,
    }
}

row! {
    /// An attractor at neighbouring values at which there are several, or at which starts are lost.
    pub struct AlsoRow {
        /// The first value.
        pub from: f64,
        /// The last value.
        pub to: f64,
        /// The period, in forcing periods.
        pub period: Option<u32>,
        /// Impacts in a period.
        pub impacts: Option<u64>,
        /// What it is, unless it is periodic.
        pub motion: Option<&'static str>,
        /// How many values.
        pub values: usize,
        /// The most starts that are lost at one of them.
        pub lost: u32,
    }
}

/// What there is at a value: a kind of motion, period and impacts, and which of those of one kind.
type Kind = (Option<&'static str>, Option<(u32, u64)>, usize);

impl AlsoRow {
    /// What coexists, each attractor once for values that follow each other. Motions that are not periodic
    /// are one at each value: they are not told apart.
    fn all(slices: &[Slice]) -> Vec<AlsoRow> {
        let mut rows: Vec<AlsoRow> = Vec::new();
        let mut open: Vec<(Kind, usize)> = Vec::new();
        let several: Vec<f64> = diagram::coexisting(slices).map(|slice| slice.value).collect();
        for slice in slices {
            if !several.contains(&slice.value) {
                open.clear();
                continue;
            }
            let now = kinds(slice).into_iter().map(|kind| {
                let known = open.iter().find(|(before, _)| *before == kind);
                let row = known.map_or(rows.len(), |&(_, row)| row);
                if known.is_none() {
                    let (motion, periodic, _) = kind;
                    let [from, to] = [slice.value; 2];
                    let (period, impacts) = periodic.unzip();
                    rows.push(AlsoRow { from, to, period, impacts, motion, values: 0, lost: 0 });
                }
                let last = &mut rows[row];
                (last.to, last.values, last.lost) = (slice.value, last.values + 1, last.lost.max(slice.lost));
                (kind, row)
            });
            open = now.collect();
        }
        rows
    }
}

/// What there is at a value, each once; nothing but what is lost counts as something.
fn kinds(slice: &Slice) -> Vec<Kind> {
    let mut all: Vec<Kind> = Vec::new();
    for motion in slice.motions.iter().filter(|motion| !motion.undecided) {
        let periodic = motion.period.map(|period| (period, motion.impacts));
        let what = periodic.is_none().then_some("not periodic");
        let before = all.iter().filter(|kind| (kind.0, kind.1) == (what, periodic)).count();
        if periodic.is_some() || before == 0 {
            all.push((what, periodic, before));
        }
    }
    if slice.motions.is_empty() {
        all.push((Some("all lost"), None, 0));
    }
    all
}

/// Attractors at each value, and what they amount to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiagramFindings {
    /// The parameter.
    pub parameter: String,
    /// Of a machine, what the two numbers of a point are, as in the scene; the first is drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plane: Option<[String; 2]>,
    /// How many values were looked at.
    pub values: usize,
    /// Windows of periodic motion, by where they begin.
    pub windows: Vec<WindowRow>,
    /// Values with several attractors or with lost starts, a row for each attractor, at least one for each
    /// value.
    pub coexisting: Vec<CoexistingRow>,
    /// Where none, some or all motions that are seen hit for ever: of several starts, or of the two ways of a
    /// sweep; absent of one motion at each value, which does not tell what else there is.
    pub bands: Option<Vec<DiagramBandRow>>,
    /// Values at which it is not decided whether a motion tends to a periodic orbit.
    pub not_settled: Vec<f64>,
    /// What a sweep comes to, in place of `windows` and `coexisting`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sweep: Option<SweepFindings>,
    /// What is proved of the attractors, if that was asked for.
    pub proofs: Option<AttractorProofs>,
    /// All points, value by value. Not in JSON: they are the task's CSV file.
    #[serde(skip)]
    pub slices: Vec<Slice>,
    /// How many of the slices are of the way up of a sweep; the others are of the way down.
    #[serde(skip)]
    pub upwards: usize,
}

impl Finding for DiagramFindings {
    fn status(&self) -> Status {
        if let Some(first) = self.not_settled.first() {
            return Status::undecided(format!(
                "at {} of {} values a motion is not settled, the first {first}: raise `transient`",
                self.not_settled.len(),
                self.values
            ));
        }
        match self.slices.iter().any(|slice| !slice.motions.is_empty()) {
            true => self.proofs.as_ref().map_or(Status::Done, AttractorProofs::status),
            false => Status::nothing("at no value does a start lead to an attractor: all are lost"),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        if let Some([first, _]) = &self.plane {
            lines.say("drawn", first.as_str());
        }
        lines.say("values", self.values);
        if let Some(rows) = &self.bands {
            DiagramBandRow::say(rows, &self.parameter, lines);
            lines.table("bands", rows);
        }
        match &self.sweep {
            Some(sweep) => sweep.lines(lines),
            None => {
                lines.table("windows", &self.windows);
                lines.table("coexisting", &AlsoRow::all(&self.slices));
            }
        }
        if !self.not_settled.is_empty() {
            lines.say("not_settled", self.not_settled.len());
        }
        if let Some(proofs) = &self.proofs {
            proofs.lines(lines);
        }
    }

    fn certificates(&self) -> Vec<&CertificateFile> {
        self.proofs.iter().flat_map(|proofs| &proofs.certificates).collect()
    }
}

/// The i-th of `count` evenly spaced values.
fn exact(range: &[BigRational], i: u32, count: u32) -> BigRational {
    let part = BigRational::new(i.into(), (count - 1).into());
    &range[0] + (&range[1] - &range[0]) * part
}

/// The same as a float, from exact ends: 0.84 is the float nearest to 0.84.
pub(super) fn value(range: &[BigRational], i: u32, count: u32) -> f64 {
    Plain::ratio(&exact(range, i, count), &()).0
}

/// The values of the task with these numbers, from what starts, and how they are looked at.
fn plan<S>(task: &DiagramTask, starts: Vec<S>, values: Range<u64>) -> DiagramPlan<S> {
    DiagramPlan {
        values: values.map(|i| value(&task.range, i as u32, task.count)).collect(),
        starts,
        look: Look {
            phase: phase(&task.phase),
            transient: task.transient,
            points: task.points,
            longest: task.longest,
        },
        every: task.every,
    }
}

/// Follows the motions of systems of one kind.
fn follow<D: Attraction<Start: Serialize>>(
    task: &DiagramTask,
    job: &Job,
    plan: &DiagramPlan<D::Start>,
    file: Option<&Path>,
    plane: &str,
    dynamics: impl Fn(f64) -> Result<D> + Sync,
) -> Result<Vec<Slice>> {
    if let Some(file) = file.filter(|_| !task.resume) {
        Journal::discard(file)?;
    }
    job.monitor.begin(plan.values.len() as u64, "values");
    let identity = format!("{} {}{plane}", job.identity()?, task.parameter);
    diagram::sweep_counting(plan, dynamics, &identity, job.keep(file), job.monitor)
}

/// Follows motions at every value, resuming from the checkpoint of an interrupted run if there is one.
///
/// # Errors
/// Those of the system at a value and of the simulator; an unusable checkpoint; an interruption.
pub(crate) fn diagram(task: &DiagramTask, job: &Job) -> Result<DiagramFindings> {
    if let Some(sweep) = task.sweep {
        return swept(task, sweep, job);
    }
    let slices = slices(task, job, 0..task.count.into(), job.checkpoint().as_deref())?;
    with_proofs(task, job, gather(task, job, slices))
}

/// The findings with what is proved of the attractors, if that is asked for.
fn with_proofs(task: &DiagramTask, job: &Job, found: DiagramFindings) -> Result<DiagramFindings> {
    if !task.prove {
        return Ok(found);
    }
    let proofs = by_engine!(job, engine => prove_slices(task, job, &engine, &found.slices))?;
    Ok(DiagramFindings { proofs: Some(proofs), ..found })
}

/// Proves the attractors at each value: motions are followed again, to have a state on each.
fn prove_slices<E: Engine>(
    task: &DiagramTask,
    job: &Job,
    engine: &E,
    slices: &[Slice],
) -> Result<AttractorProofs> {
    let states = engine.states(&task.starts)?;
    let plan = plan(task, engine.begun(&states), 0..0);
    let mut found = Vec::new();
    job.monitor.begin(slices.len() as u64, "values");
    for (slice, i) in slices.iter().zip(0..) {
        let dynamics = engine.dynamics(&states, Some((&task.parameter, slice.value)), &task.plane)?;
        let seen = diagram::attractors(&plan, &dynamics, slice.motions.len(), job.monitor)?;
        if seen.len() != slice.motions.len() {
            let [before, now] = [slice.motions.len(), seen.len()];
            let what = format!("{before} attractors were seen at {}, and {now} seen again", slice.value);
            return Err(Error::input(format!("{what}: proofs need the machine on which they were seen")));
        }
        let named =
            |(start, on): (usize, _)| (format!("start {}", start + 1), exact(&task.range, i, task.count), on);
        found.extend(seen.into_iter().map(named));
        job.monitor.advance(1)?;
    }
    let proving = Proving { engine, task: &job.task.name, parameter: &task.parameter, look: &plan.look };
    let all = found.iter().map(|(seen, value, on)| (seen.as_str(), value.clone(), on));
    proving.all(&all.collect::<Vec<_>>(), job)
}

/// The numbers of the values of a sweep in its order, with whether it goes up there.
pub(super) fn ways(count: u32, sweep: SweepWay) -> Vec<(bool, u32)> {
    let up = (0..count).map(|i| (true, i));
    let down = (0..count).rev().map(|i| (false, i));
    match sweep {
        SweepWay::Up => up.collect(),
        SweepWay::Down => down.collect(),
        SweepWay::Both => up.chain(down).collect(),
    }
}

/// Sweeps the parameter.
fn swept(task: &DiagramTask, sweep: SweepWay, job: &Job) -> Result<DiagramFindings> {
    by_engine!(job, engine => sweep_over(task, job, &engine, &ways(task.count, sweep)))
}

fn sweep_over<E: Engine>(
    task: &DiagramTask,
    job: &Job,
    engine: &E,
    ways: &[(bool, u32)],
) -> Result<DiagramFindings> {
    let (steps, found, look) = sweep_steps(task, job, engine, ways)?;
    let slices = steps.iter().map(slice).collect();
    let proofs = task.prove.then(|| prove(task, job, engine, &look, ways, &steps)).transpose()?;
    let mut findings = gather(task, job, slices);
    (findings.windows, findings.coexisting) = (Vec::new(), Vec::new());
    let upwards = ways.iter().filter(|(up, _)| *up).count();
    let (up, down) = findings.slices.split_at(upwards);
    // One way tells of one motion at each value.
    findings.bands = (!up.is_empty() && !down.is_empty()).then(|| {
        let both = up.iter().zip(down.iter().rev());
        DiagramBandRow::all(
            both.map(|(up, down)| (up.value, hit(up).zip(hit(down)).map(|both| [both.0, both.1].concat()))),
        )
    });
    Ok(DiagramFindings { sweep: Some(found), proofs, upwards, ..findings })
}

/// What a sweep settles on, value by value, and what that amounts to.
type Swept<E> = (Vec<SweepStep<StartOf<E>>>, SweepFindings, Look);

/// Follows a sweep of values with these numbers, resuming from the checkpoint of an interrupted run if there
/// is one.
pub(super) fn sweep_steps<E: Engine>(
    task: &DiagramTask,
    job: &Job,
    engine: &E,
    ways: &[(bool, u32)],
) -> Result<Swept<E>> {
    let states = engine.states(&task.starts)?;
    let plane = engine.plane(&task.plane);
    let drawn = plane.as_ref().map_or("q", |[first, _]| first);
    let dynamics = |value| engine.dynamics(&states, Some((&task.parameter, value)), &task.plane);
    let values = ways.iter().map(|&(_, i)| value(&task.range, i, task.count)).collect();
    let plan = DiagramPlan { values, ..plan(task, engine.begun(&states), 0..0) };
    let file = job.checkpoint();
    if let Some(file) = file.as_deref().filter(|_| !task.resume) {
        Journal::discard(file)?;
    }
    job.monitor.begin(plan.values.len() as u64, "values");
    let names = plane.as_ref().map_or(String::new(), |names| names.join(", "));
    let identity = format!("{} {}{names}", job.identity()?, task.parameter);
    let steps = diagram::swept(&plan, dynamics, &identity, job.keep(file.as_deref()), job.monitor)?;
    let upwards = ways.iter().filter(|(up, _)| *up).count();
    let mut legs = Vec::new();
    for (up, steps) in [(true, &steps[..upwards]), (false, &steps[upwards..])] {
        if !steps.is_empty() {
            let jumps = diagram::jumps(steps, &plan.observation(), dynamics, job.monitor)?;
            legs.push(Leg { up, steps, jumps });
        }
    }
    let found = SweepFindings::of(&legs, drawn);
    drop(legs);
    Ok((steps, found, plan.look))
}

/// Proves the attractors of a sweep.
fn prove<E: Engine>(
    task: &DiagramTask,
    job: &Job,
    engine: &E,
    look: &Look,
    ways: &[(bool, u32)],
    steps: &[SweepStep<StartOf<E>>],
) -> Result<AttractorProofs> {
    let seen = ways.iter().zip(steps).filter_map(|(&(up, i), step)| {
        Some((way(up), exact(&task.range, i, task.count), step.settled.as_ref()?))
    });
    let proving = Proving { engine, task: &job.task.name, parameter: &task.parameter, look };
    proving.all(&seen.collect::<Vec<_>>(), job)
}

/// A step as a slice of the diagram.
fn slice<S>(step: &SweepStep<S>) -> Slice {
    let motion = step.settled.as_ref().map(|settled| DiagramMotion {
        points: settled.points.clone(),
        period: settled.portrait.period,
        undecided: settled.portrait.undecided,
        impacts: settled.portrait.impacts,
    });
    Slice { value: step.value, lost: u32::from(motion.is_none()), motions: motion.into_iter().collect() }
}

/// The slices at some values, each as a line of JSON, resuming from the checkpoint `file`.
pub(super) fn values(task: &DiagramTask, job: &Job, values: Range<u64>, file: &Path) -> Result<Vec<String>> {
    slices(task, job, values, Some(file))?.iter().map(record).collect()
}

/// The findings from the slices at all values, as [`values`] writes them.
pub(super) fn joined(task: &DiagramTask, job: &Job, slices: &[String]) -> Result<DiagramFindings> {
    // What the starts are does not matter, only how many.
    let plan = plan(task, vec![(); task.starts.len()], 0..task.count.into());
    let read = |(number, text): (usize, &String)| {
        let slice: Slice = serde_json::from_str(text).map_err(|error| foreign(number, &error))?;
        match plan.can_be(number, &slice) {
            true => Ok(slice),
            false => Err(foreign(number, &"no run comes to it")),
        }
    };
    with_proofs(task, job, gather(task, job, slices.iter().enumerate().map(read).collect::<Result<_>>()?))
}

fn slices(task: &DiagramTask, job: &Job, values: Range<u64>, file: Option<&Path>) -> Result<Vec<Slice>> {
    by_engine!(job, engine => {
        let states = engine.states(&task.starts)?;
        let names = engine.plane(&task.plane).map_or(String::new(), |names| names.join(", "));
        let at = |value| engine.dynamics(&states, Some((&task.parameter, value)), &task.plane);
        let plan = plan(task, engine.begun(&states), values);
        follow(task, job, &plan, file, &names, at)
    })
}

/// Which of the motions at a value hit; none where one is lost or not settled.
fn hit(slice: &Slice) -> Option<Vec<bool>> {
    let known = slice.lost == 0 && slice.motions.iter().all(|motion| !motion.undecided);
    known.then(|| slice.motions.iter().map(|motion| motion.impacts > 0).collect())
}

fn gather(task: &DiagramTask, job: &Job, slices: Vec<Slice>) -> DiagramFindings {
    let windows = diagram::windows(&slices).into_iter().map(|window| WindowRow {
        from: window.from,
        to: window.to,
        period: window.period,
        impacts: window.impacts,
        values: window.values,
    });
    let mut coexisting = Vec::new();
    for &Slice { value, ref motions, lost } in diagram::coexisting(&slices) {
        if motions.is_empty() {
            coexisting.push(CoexistingRow { value, period: None, impacts: None, lost });
        }
        coexisting.extend(motions.iter().filter(|motion| !motion.undecided).map(|motion| CoexistingRow {
            value,
            period: motion.period,
            impacts: Some(motion.impacts),
            lost,
        }));
    }
    let open = |slice: &&Slice| slice.motions.iter().any(|motion| motion.undecided);
    let not_settled = slices.iter().filter(open).map(|slice| slice.value).collect();
    let plane = by_engine!(job, engine => engine.plane(&task.plane));
    let several = task.starts.len() > 1 && task.sweep.is_none();
    let bands = several.then(|| DiagramBandRow::all(slices.iter().map(|slice| (slice.value, hit(slice)))));
    DiagramFindings {
        plane,
        parameter: task.parameter.clone(),
        values: slices.len(),
        windows: windows.collect(),
        coexisting,
        bands,
        not_settled,
        sweep: None,
        proofs: None,
        slices,
        upwards: 0,
    }
}
