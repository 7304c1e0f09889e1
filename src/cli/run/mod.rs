//! `grazing run`: the tasks of a scene. Each kind of task is run by the file of its name.

mod basins;
mod branch;
mod crisis;
mod diagram;
mod event;
mod grazing;
mod orbit;
mod report;
mod section;
mod simulate;
mod validate;

use std::{
    fs,
    path::{Path, PathBuf},
};

use clap::Parser;
use num_rational::BigRational;

use super::{Outcome, ReportFormat, in_pool};
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    number::parse_rational,
    oscillator::{
        System,
        simulate::{End, Settings},
    },
    output::Destination,
    scene::{Accuracy, Kind, Scene, Task},
};
use report::Report;

/// Run the tasks of a scene: simulate an impact oscillator.
///
/// A scene is a TOML file that names an oscillator's effects, its walls, parameters and tasks; docs/scenes.md has every
/// key, examples/scenes some scenes to begin with. Each task writes its files, named after it, into the folder, and its
/// part of the report to standard output. All of the scene is checked before anything runs.
///
/// Exit code 0: done; 2: wrong usage, a wrong scene or a file that cannot be written; 3: interrupted or undecided.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// The scene.
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// Run this task only, or the tasks of this group; may be repeated.
    #[arg(long, value_name = "TASK")]
    only: Vec<String>,
    /// Give a parameter this value, in every task; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    set: Vec<(String, BigRational)>,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
    /// How the report is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    format: ReportFormat,
    /// Threads; 0 for one a core.
    #[arg(long, value_name = "J", default_value_t = 0)]
    jobs: usize,
}

fn setting(text: &str) -> Result<(String, BigRational)> {
    let parts = text.split_once('=').ok_or_else(|| Error::input("write NAME=VALUE"))?;
    Ok((parts.0.trim().to_string(), parse_rational(parts.1)?))
}

/// Whether a task is meant by a name: its own or its group's.
fn called(task: &Task, name: &str) -> bool {
    task.name == name || task.group.as_deref() == Some(name)
}

/// A task with all it works on.
struct Job<'a> {
    /// The task.
    task: &'a Task,
    /// The scene, with the parameter values of the task and of the command line.
    scene: Scene,
    /// Its coefficients, rounded from their exact values.
    system: System<f64>,
    /// Where the files go.
    folder: &'a Path,
    /// The user's wish to end.
    interrupt: &'a Interrupt,
}

impl<'a> Job<'a> {
    fn new(
        scene: &Scene,
        task: &'a Task,
        changes: &[(String, BigRational)],
        folder: &'a Path,
        interrupt: &'a Interrupt,
    ) -> Result<Self> {
        let scene = scene.for_task(task, changes)?;
        let system = scene.exact(&[])?.rounded();
        Ok(Job { task, scene, system, folder, interrupt })
    }

    fn run(&self) -> Result<Report> {
        let mut report = Report::new(self);
        match &self.task.kind {
            Kind::Simulate(task) => simulate::run(task, self, &mut report),
            Kind::Section(task) => section::run(task, self, &mut report),
            Kind::Basins(task) => basins::run(task, self, &mut report),
            Kind::OrbitTask(task) => orbit::run(task, self, &mut report),
            Kind::EventTask(task) => event::run(task, self, &mut report),
            Kind::GrazingTask(task) => grazing::run(task, self, &mut report),
            Kind::BranchTask(task) => branch::run(task, self, &mut report),
            Kind::DiagramTask(task) => diagram::run(task, self, &mut report),
            Kind::CrisisTask(task) => crisis::run(task, self, &mut report),
            Kind::ValidateTask(task) => validate::run(task, self, &mut report),
        }?;
        Ok(report)
    }
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    let name = args.scene.display().to_string();
    let text = fs::read_to_string(&args.scene).map_err(|error| Error::io("read", &args.scene, error))?;
    let scene = Scene::from_toml(&text, &name)?;
    for only in &args.only {
        if !scene.tasks.iter().any(|task| called(task, only)) {
            let names: Vec<&str> = scene.tasks.iter().map(|task| task.name.as_str()).collect();
            return Err(Error::input(format!("--only {only}: {name} has the tasks {}", names.join(", "))));
        }
    }
    // All tasks are checked, with the changed parameters, before the first runs.
    let mut jobs = Vec::new();
    for task in scene
        .tasks
        .iter()
        .filter(|task| args.only.is_empty() || args.only.iter().any(|only| called(task, only)))
    {
        jobs.push(Job::new(&scene, task, &args.set, &args.output, interrupt)?);
    }
    if jobs.is_empty() {
        return Err(Error::input(format!("{name} has no [[tasks]]: nothing to do")));
    }
    make(&args.output)?;
    let mut reports = Vec::new();
    for job in &jobs {
        interrupt.check()?;
        let report = in_pool(args.jobs, || job.run())?;
        // As soon as it is known; JSON is one object, at the end.
        if args.format == ReportFormat::Text {
            Destination::Stdout.write(|out| Ok(write!(out, "{report}")?))?;
        }
        reports.push(report);
    }
    if args.format == ReportFormat::Json {
        Destination::Stdout.write(|out| report::json(&scene.title, &reports, out))?;
    }
    let undecided = reports.iter().any(|report| report.undecided);
    Ok(if undecided { Outcome::Undecided } else { Outcome::Done })
}

/// Runs a task of the paper's own scene, without a report.
pub(super) fn paper(task: &str, folder: &Path, interrupt: &Interrupt) -> Result<()> {
    let text = include_str!("../../../examples/scenes/nordmark-2001.toml");
    let scene = Scene::from_toml(text, "nordmark-2001.toml")?;
    let task = scene.tasks.iter().find(|known| known.name == task);
    let task = task.ok_or_else(|| Error::input("the paper's scene has no such task"))?;
    make(folder)?;
    Job::new(&scene, task, &[], folder, interrupt)?.run().map(drop)
}

fn make(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).map_err(|error| Error::io("create", folder, error))
}

/// The simulator's settings for a scene's accuracy.
fn settings(scene: &Scene) -> Settings {
    let Accuracy { tolerance, minimum_depth } = scene.accuracy;
    Settings { tolerance, minimum_depth, ..Settings::default() }
}

/// Why a motion ended.
fn ended(end: End) -> &'static str {
    match end {
        End::Reached => "at the time asked for",
        End::ImpactLimit => "at the limit of impacts",
        End::Escaped => "it left every bound",
    }
}
