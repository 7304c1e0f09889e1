//! Scenes run by the library: each task answered by one function with a typed result, and all tasks reported
//! alike.
//!
//! [`run`] does a scene's tasks one after the other and gives a [`TaskReport`] for each; [`run_task`] does
//! one. A failing task does not end the rest. What is long (a time series) or lasting (figures, tables,
//! certificates) goes to a [`Keeper`]; `()` keeps nothing. Not here: the command line, pictures and tables
//! (the package `grazing-shell`), the keys of a scene (`scene`), mathematics (`one`, `many`).
//!
//! # How a kind of task is run
//!
//! A kind has a file here of its name with
//!
//! 1. `XFindings`, its result: a struct with `Serialize` whose fields are numbers, booleans, words of enums,
//!    lists of rows. A row is declared by `row!`: its fields are the columns of tables and the keys in
//!    JSON, in their order, whichever engine found it. No field is a text that a program would have to parse:
//!    complex numbers are [`Complex`], what rounding may decide is a [`Judgement`], an orbit is [`Analysed`];
//! 2. `impl Finding for XFindings`: its [`Status`] from the data alone, in one place, with a sentence for
//!    every answer that is not "done"; warnings; what is printed, by `Lines`;
//! 3. `pub fn x(task, job) -> Result<XFindings>`: what [`Job`] holds, and no files but those that it reads
//!    and its checkpoint. It asks an `Engine`, chosen by `by_engine!`, and no type of one: what oscillators
//!    and machines answer each in their own way is in `engine`. An error is for what makes the task fail as a
//!    whole; whatever happens to one orbit or one value of many is a row or a count of the findings. It calls
//!    [`Job::monitor`] at least ten times a second;
//! 4. a variant of [`Findings`] and an arm of `answer`.
//!
//! The command line adds `crates/shell/src/cli/run/x.rs`, which writes the findings' files and returns their
//! names.

mod analysed;
mod backbone;
mod bands;
mod basins;
mod birth;
mod born;
mod branch;
mod chaos;
mod crisis;
mod diagram;
mod enclosed;
mod engine;
mod event;
mod families;
mod filed;
mod follow;
mod grazing;
mod grazing_report;
mod highest;
mod hit;
mod influence;
mod lines;
mod local_map;
mod map;
mod monitors;
mod orbit;
pub mod parts;
mod pieces;
mod proved;
mod range;
mod ranged;
mod report;
mod response;
mod rest;
mod restart;
mod section;
mod seen;
mod sentence;
mod series;
mod simulate;
mod status;
mod stretch;
mod swept;
mod table;
mod told;
mod tolerance;
mod units;
mod unstable;
mod validate;

use std::{f64::consts::TAU, path::Path, sync::Arc};

use num_rational::BigRational;
use serde::Serialize;

pub use analysed::Analysed;
pub use backbone::{BackboneEndRow, BackboneRow};
pub use bands::{BandRow, DiagramBandRow};
pub(crate) use basins::basins;
pub use basins::{BasinRow, BasinsFindings};
pub use birth::ChaosRow;
pub use born::BornRow;
pub(crate) use branch::branch;
#[doc(hidden)]
pub use branch::follow;
pub use branch::{BranchFindings, BranchRow, FoundBranches, StartRow};
pub(crate) use chaos::chaos;
pub use chaos::{ChaosFindings, FailureRow, LetterRow};
pub(crate) use crisis::crisis;
pub use crisis::{CrisisFindings, CrisisRow, PersistenceRow};
pub(crate) use diagram::diagram;
pub use diagram::{CoexistingRow, DiagramFindings, WindowRow};
#[doc(hidden)]
pub use engine::{JudgedOrbit, MachineSource, OrbitSource, OscillatorSource, form};
pub(crate) use event::event;
pub use event::{EventFindings, EventRow, WithoutRow};
pub use filed::{CertificateFile, FiledClaim};
pub(crate) use grazing::grazing;
pub use grazing::{GrazingFindings, TouchRow};
pub use grazing_report::GrazingReport;
pub use highest::HighestRow;
pub use hit::HitRow;
pub(crate) use hit::StartNumbers;
pub use influence::InfluenceRow;
pub(crate) use lines::Lines;
pub use local_map::{GrazingMap, MapNumbers};
pub(crate) use map::map;
#[doc(hidden)]
pub use map::word as map_word;
pub use map::{MapFindings, MapRow};
#[doc(hidden)]
pub use monitors::Measures;
pub use monitors::MonitoredRow;
pub(crate) use orbit::orbit;
pub use orbit::{OrbitFindings, OrbitRow};
pub use pieces::{PieceProofs, PieceRow};
pub use proved::{AttractorProofs, ProvedRow};
pub use range::{CellRow, RangeRow, StabilityRow, StableRow};
pub use report::{RunReport, TaskReport};
pub(crate) use response::response;
pub use response::{ContactRow, PeakRow, ResponseFindings, ResponseRow};
pub(crate) use rest::rest;
pub use rest::{ReleaseRow, RestFindings, RestOrbitRow};
pub use restart::FixedRow;
pub(crate) use section::section;
pub use section::{AttractorRow, ExponentRow, SectionFindings, SectionOrbitRow, SectionSet};
pub use seen::SeenRow;
pub use sentence::{Mark, Sentence};
pub use series::{SeriesOf, SeriesPoint, SeriesStop, StopEvent};
pub use simulate::SimulationFindings;
pub(crate) use simulate::{MeasuredEffect, simulate};
pub use status::{Place, Status};
pub use swept::{HysteresisRow, JumpRow, SweepFindings, SweptRow};
pub(crate) use table::row;
pub use table::{Complex, Judgement, Tabular};
pub(crate) use table::{Row, Shown};
pub use tolerance::{ParameterValue, ToleranceReport, ToleranceResonance, ToleranceSide, ToleratedParameter};
pub use units::ColumnUnit;
pub use unstable::UnstableRow;
pub(crate) use validate::validate;
pub use validate::{ProofRow, Proved, UnprovedRow, ValidateFindings};

use crate::{
    attractor::Keep,
    error::{Error, Result},
    many::{Machine, StopLaw},
    monitor::Monitor,
    motion::{Effect, EffectTally, Side, State, System},
    one::{
        orbit::Oscillator,
        simulate::{Settings, Simulator},
    },
    output::Journal,
    scene::{Accuracy, Body, Kind, Scene, SceneFamily, Task},
};

/// What a task found.
pub(crate) trait Finding: Serialize {
    /// How the task ended, by what was found.
    fn status(&self) -> Status;

    /// What a reader should know before trusting the numbers.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }

    /// What a report shows of it.
    fn lines(&self, lines: &mut Lines);

    /// The certificates of what it calls proved.
    fn certificates(&self) -> Vec<&CertificateFile> {
        Vec::new()
    }
}

/// Declares the findings of every kind that is run here, and passes each question on to the one there is.
macro_rules! findings {
    ($($(#[doc = $doc:literal])+ $kind:ident($type:ty),)+) => {
        /// The findings of a task, by its kind.
        #[derive(Debug, Clone, PartialEq, Serialize)]
        #[serde(untagged)]
        #[non_exhaustive]
        pub enum Findings { $($(#[doc = $doc])+ $kind(Box<$type>),)+ }

        impl Findings {
            fn get(&self) -> &dyn Answer {
                match self { $(Findings::$kind(found) => &**found,)+ }
            }
        }

        $(impl From<$type> for Findings {
            fn from(found: $type) -> Findings {
                Findings::$kind(Box::new(found))
            }
        })+
    };
}

findings! {
    /// One motion.
    Simulation(SimulationFindings),
    /// Attractors on a stroboscopic section.
    Section(SectionFindings),
    /// Which start leads to which attractor.
    Basins(BasinsFindings),
    /// Attractors over a parameter.
    Diagram(DiagramFindings),
    /// Frequency response.
    Response(ResponseFindings),
    /// Attractors over two parameters.
    Map(MapFindings),
    /// Periodic orbits.
    Orbit(OrbitFindings),
    /// The first bifurcations along orbits' branches.
    Event(EventFindings),
    /// A grazing bifurcation.
    Grazing(GrazingFindings),
    /// Branches of orbits.
    Branch(BranchFindings),
    /// The end of an attractor.
    Crisis(CrisisFindings),
    /// Periodic motions that rest.
    Rest(RestFindings),
    /// Proofs.
    Validate(ValidateFindings),
    /// Chaos, proved.
    Chaos(ChaosFindings),
}

/// [`Finding`] without `Serialize`, so that there are objects of it.
trait Answer {
    fn status(&self) -> Status;
    fn warnings(&self) -> Vec<String>;
    fn lines(&self, lines: &mut Lines);
    fn certificates(&self) -> Vec<&CertificateFile>;
}

impl<F: Finding> Answer for F {
    fn status(&self) -> Status {
        Finding::status(self)
    }

    fn warnings(&self) -> Vec<String> {
        Finding::warnings(self)
    }

    fn lines(&self, lines: &mut Lines) {
        Finding::lines(self, lines);
    }

    fn certificates(&self) -> Vec<&CertificateFile> {
        Finding::certificates(self)
    }
}

impl Findings {
    /// How the task ended.
    pub(crate) fn status(&self) -> Status {
        self.get().status()
    }

    /// What a reader should know before trusting the numbers.
    pub(crate) fn warnings(&self) -> Vec<String> {
        self.get().warnings()
    }

    pub(crate) fn lines(&self, lines: &mut Lines) {
        self.get().lines(lines);
    }

    /// The certificates of what it calls proved, each by its file.
    #[must_use]
    pub fn certificates(&self) -> Vec<&CertificateFile> {
        self.get().certificates()
    }
}

/// Takes what a task gives out: the points of a long series as they come, and in the end its findings.
pub trait Keeper {
    /// What the time series is of that comes.
    ///
    /// # Errors
    /// The keeper's own; the task ends with it.
    fn begin(&mut self, _of: &SeriesOf) -> Result<()> {
        Ok(())
    }

    /// A point of it.
    ///
    /// # Errors
    /// The keeper's own; the task ends with it.
    fn sample(&mut self, _sample: &SeriesPoint) -> Result<()> {
        Ok(())
    }

    /// An event of it, no later than the next point.
    ///
    /// # Errors
    /// The keeper's own; the task ends with it.
    fn event(&mut self, _event: &StopEvent) -> Result<()> {
        Ok(())
    }

    /// Keeps the findings; the names of the files in which they are.
    ///
    /// # Errors
    /// The keeper's own; the task counts as failed, and its checkpoint stays.
    fn keep(&mut self, _job: &Job, _findings: &Findings) -> Result<Vec<String>> {
        Ok(Vec::new())
    }
}

/// Keeps nothing.
impl Keeper for () {}

/// What a run has besides the scene.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    /// New values of parameters, in every task.
    pub changes: &'a [(String, BigRational)],
    /// The folder of checkpoints and of the files that a task begins with; without one there are none.
    pub folder: Option<&'a Path>,
    /// Told how far each task is, and asked whether to go on.
    pub monitor: &'a dyn Monitor,
}

impl Default for Surroundings<'_> {
    fn default() -> Self {
        Surroundings { changes: &[], folder: None, monitor: &() }
    }
}

/// A task with all that it works on.
pub struct Job<'a> {
    /// The task.
    pub task: &'a Task,
    /// The scene, with the parameter values of the task and of the run.
    pub scene: Scene,
    /// What it is about, its coefficients rounded from their exact values.
    pub model: Model,
    /// The folder of checkpoints and of the files that a task begins with.
    pub folder: Option<&'a Path>,
    /// Told how far the task is, and asked whether to go on.
    pub monitor: &'a dyn Monitor,
    /// What was computed how often.
    pub tally: Arc<EffectTally>,
}

/// What a task works on, in floats.
#[derive(Debug, Clone, PartialEq)]
pub enum Model {
    /// An oscillator of one degree of freedom.
    Oscillator(System<f64>),
    /// A machine.
    Machine(Machine<f64>),
}

impl Model {
    fn of(scene: &Scene) -> Result<Model> {
        Ok(match scene.body {
            Body::Oscillator(_) => Model::Oscillator(scene.rounded()?),
            Body::Machine(_) => Model::Machine(scene.machine(&[])?),
        })
    }

    /// The period of the forcing, in the scene's unit of time.
    fn period(&self) -> f64 {
        match self {
            Model::Oscillator(system) => TAU / system.shown_rate(),
            Model::Machine(machine) => machine.period,
        }
    }
}

impl<'a> Job<'a> {
    /// A task with its scene, all checked that can be checked before it runs.
    ///
    /// # Errors
    /// Those of [`Scene::for_task`].
    pub fn new(scene: &Scene, task: &'a Task, around: Surroundings<'a>) -> Result<Self> {
        let scene = scene.for_task(task, around.changes)?;
        let model = Model::of(&scene)?;
        let Surroundings { folder, monitor, .. } = around;
        Ok(Job { task, scene, model, folder, monitor, tally: Arc::default() })
    }

    /// The same task of the scene with other values of some parameters; what it computes is counted here.
    ///
    /// # Errors
    /// Those of the scene.
    fn with(&self, values: &[(String, BigRational)]) -> Result<Job<'a>> {
        let scene = self.scene.with(values)?;
        let model = Model::of(&scene)?;
        let Job { task, folder, monitor, .. } = *self;
        Ok(Job { task, scene, model, folder, monitor, tally: self.tally.clone() })
    }

    /// Whether motions of the scene cost little: all forces are linear, and all stops rigid.
    fn is_linear(&self) -> bool {
        match &self.model {
            Model::Oscillator(system) => system.cubic == 0.0 && system.smooth.is_none(),
            Model::Machine(machine) => {
                !machine.is_smooth()
                    && !machine.stops.iter().any(|stop| matches!(stop.law, StopLaw::Soft { .. }))
            }
        }
    }

    /// The oscillator, where the engine is `one`.
    ///
    /// # Errors
    /// For a machine.
    pub(crate) fn system(&self) -> Result<&System<f64>> {
        match &self.model {
            Model::Oscillator(system) => Ok(system),
            Model::Machine(_) => Err(Error::input("the task works on oscillators of one degree of freedom")),
        }
    }

    /// What the stop on a side is called, where the engine is `one`.
    pub(crate) fn stop(&self, side: Side) -> String {
        let known = self.scene.stops.iter().find(|stop| stop.side == Some(side));
        known.map_or_else(|| side.name().into(), |stop| stop.name.clone())
    }

    /// How finely to simulate: the same at every value of a parameter that varies.
    ///
    /// # Errors
    /// For a machine; those of [`Settings::sized`].
    pub(crate) fn settings(&self) -> Result<Settings> {
        let system = self.system()?;
        let settings = Settings { tolerance: self.scene.accuracy.tolerance, ..Settings::default() };
        match self.scene.accuracy.minimum_depth {
            Some(minimum_depth) => Ok(Settings { minimum_depth, ..settings }),
            None => settings.sized(system, &self.starts()?),
        }
    }

    /// Where motions of the task start, as far as that may tell how large they are.
    fn starts(&self) -> Result<Vec<State>> {
        let all = match &self.task.kind {
            Kind::SimulateTask(task) => vec![&task.start],
            Kind::SectionTask(task) => task.starts.iter().collect(),
            Kind::DiagramTask(task) => task.starts.iter().collect(),
            Kind::ResponseTask(task) => vec![&task.start],
            Kind::MapTask(task) => vec![&task.start],
            Kind::CrisisTask(task) => vec![&task.start],
            Kind::BranchTask(task) => {
                task.starts.iter().filter_map(|start| start.attractor.as_ref()).collect()
            }
            Kind::BasinsTask(task) if task.plane.is_empty() => {
                let (q, u) = (self.scene.ends(&task.q)?, self.scene.ends(&task.u)?);
                return Ok([0, 1].map(|i| State { t: 0.0, q: q[i], u: u[i] }).to_vec());
            }
            _ => Vec::new(),
        };
        all.into_iter().map(|start| self.scene.state(start)).collect()
    }

    /// A simulator of the task's system, its work counted.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub(crate) fn simulator(&self) -> Result<Simulator> {
        self.simulator_of(self.system()?)
    }

    /// A simulator of another system of the scene, its work counted.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub(crate) fn simulator_of(&self, system: &System<f64>) -> Result<Simulator> {
        Ok(Simulator::new(system, &self.settings()?)?.counting(self.tally.clone()))
    }

    /// An oscillator for orbits of a system, its work counted.
    ///
    /// # Errors
    /// Those of [`Oscillator::new`].
    pub(crate) fn oscillator(&self, system: System<f64>) -> Result<Oscillator> {
        Ok(Oscillator::new(system, self.scene.accuracy.tolerance)?.counting(self.tally.clone()))
    }

    /// The scene's oscillators over a parameter, their work counted.
    ///
    /// # Errors
    /// Those of [`SceneFamily::new`].
    pub(crate) fn family(&self, parameter: &str) -> Result<SceneFamily<'_>> {
        Ok(SceneFamily::new(&self.scene, parameter)?.counting(self.tally.clone()))
    }

    /// The effects that are counted for what it works on.
    pub(crate) fn effects(&self) -> &'static [Effect] {
        match self.model {
            Model::Oscillator(_) => &Effect::ALL,
            Model::Machine(_) => &Effect::OF_MACHINES,
        }
    }

    /// Asks whether to go on.
    ///
    /// # Errors
    /// The interruption.
    pub(crate) fn check(&self) -> Result<()> {
        self.monitor.advance(0)
    }

    /// A text of all that motions depend on: the oscillator and how finely it is simulated.
    ///
    /// # Errors
    /// None in practice: of the writer.
    pub fn identity(&self) -> Result<String> {
        let Accuracy { tolerance, minimum_depth } = self.scene.accuracy;
        let settings = (tolerance, minimum_depth);
        let settings = serde_json::to_string(&settings).map_err(std::io::Error::other)?;
        Ok(format!("{} {settings}", self.scene.canonical()?))
    }

    /// The task's checkpoint in the folder, if there is a folder.
    pub(crate) fn checkpoint(&self) -> Option<std::path::PathBuf> {
        Some(self.folder?.join(format!("{}.checkpoint", self.task.name)))
    }

    /// A checkpoint, with the counts of the job's work.
    pub(crate) fn keep<'k>(&'k self, file: Option<&'k Path>) -> Keep<'k> {
        Keep { file, tally: Some(&self.tally) }
    }

    /// Where its task stands in the scene's file.
    pub(crate) fn place(&self) -> Place {
        let (file, line) = self.scene.place(self.task);
        Place { file, line }
    }
}

/// Runs all tasks of a scene, in their order; all are checked before the first begins. After an interruption
/// the rest are reported as not reached.
///
/// ```
/// use grazing_scenes::{run::{Status, Surroundings, run}, scene::Scene};
///
/// let text = r#"
///     format = "grazing-scene 3"
///     title = "a ball"
///     [system]
///     force = -1
///     [[stops]]
///     side = "lower"
///     offset = 0
///     restitution = "1/2"
///     [[tasks]]
///     name = "drop"
///     kind = "simulate"
///     start = { q = 0.5 }
///     periods = 1
/// "#;
/// let scene = Scene::from_toml(text, "ball.toml")?;
/// for report in run(&scene, Surroundings::default(), &mut ())? {
///     assert_eq!(report.status, Status::Done);
///     println!("{report}");
/// }
/// # Ok::<(), grazing_scenes::Error>(())
/// ```
///
/// # Errors
/// Those of [`Job::new`]: what happens later is in the reports.
pub fn run(scene: &Scene, around: Surroundings, keeper: &mut dyn Keeper) -> Result<Vec<TaskReport>> {
    let jobs = scene.tasks.iter().map(|task| Job::new(scene, task, around)).collect::<Result<Vec<_>>>()?;
    let mut reports: Vec<TaskReport> = Vec::new();
    for job in &jobs {
        let over = reports.last().is_some_and(|last| last.status.is_interrupted());
        reports.push(if over { TaskReport::pending(job) } else { run_task(job, keeper) });
    }
    Ok(reports)
}

/// Runs one task and lets the keeper keep what it found. Never fails as a function: the report's status says
/// how the task ended.
pub fn run_task(job: &Job, keeper: &mut dyn Keeper) -> TaskReport {
    let found = job.check().and_then(|()| answer(job, keeper));
    let found = found.and_then(|findings| kept(job, findings, keeper)).and_then(|found| {
        // What is finished and kept needs none, and the next run may have other settings.
        job.checkpoint().map_or(Ok(()), |file| Journal::discard(&file))?;
        Ok(found)
    });
    match found {
        Ok((findings, files)) => TaskReport::of(job, findings, files),
        Err(error) => TaskReport::failed(job, &error),
    }
}

/// The findings and the files in which they are kept.
fn kept(job: &Job, findings: Findings, keeper: &mut dyn Keeper) -> Result<(Findings, Vec<String>)> {
    let files = keeper.keep(job, &findings)?;
    Ok((findings, files))
}

fn answer(job: &Job, keeper: &mut dyn Keeper) -> Result<Findings> {
    Ok(match &job.task.kind {
        Kind::SimulateTask(task) => simulate(task, job, keeper)?.into(),
        Kind::SectionTask(task) => section(task, job)?.into(),
        Kind::BasinsTask(task) => further(|| basins(task, job))?.into(),
        Kind::DiagramTask(task) => diagram(task, job)?.into(),
        Kind::ResponseTask(task) => further(|| response(task, job))?.into(),
        Kind::OrbitTask(task) => orbit(task, job)?.into(),
        Kind::EventTask(task) => event(task, job)?.into(),
        Kind::GrazingTask(task) => grazing(task, job)?.into(),
        Kind::BranchTask(task) => branch(task, job)?.into(),
        Kind::MapTask(task) => further(|| map(task, job))?.into(),
        Kind::CrisisTask(task) => further(|| crisis(task, job))?.into(),
        Kind::RestTask(task) => rest(task, job)?.into(),
        Kind::ValidateTask(task) => validate(task, job)?.into(),
        Kind::ChaosTask(task) => chaos(task, job)?.into(),
    })
}

/// A task whose answer is a grid or a picture, which a program without the feature leaves out.
fn further<T>(run: impl FnOnce() -> Result<T>) -> Result<T> {
    match cfg!(feature = "grids") {
        true => run(),
        false => Err(Error::input(
            "this program was built without basins, crises, maps and responses: `grazing run` has them",
        )),
    }
}

/// A warning if a motion is so small that contact without impact, within `minimum_depth`, is a large part of
/// it.
fn small_motion(extent: f64, minimum_depth: f64) -> Option<String> {
    (extent < 1e3 * minimum_depth).then(|| {
        format!(
            "the motion extends over {extent:.3e}, within a thousand times minimum_depth = {minimum_depth:e}: impacts shallower \
             than that are not told from contact; lower minimum_depth, or measure lengths in a smaller unit"
        )
    })
}
