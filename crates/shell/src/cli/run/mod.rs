//! `grazing run`: the tasks of a scene, run by the library ([`run`](crate::run)); here their reports are
//! written and what they found becomes files, each kind of task by the file of its name.

mod answer;
mod axis;
mod bars;
mod basins;
mod branch;
mod chaos;
mod diagram;
mod grazing;
mod map;
mod names;
mod orbits;
mod print;
mod response;
mod section;
mod shard;
mod simulate;
mod units;
mod validate;

use std::{
    io::Write,
    ops::Deref,
    path::{Path, PathBuf},
    str::FromStr,
    sync::{Arc, Mutex, PoisonError},
};

use clap::Parser;
use serde_json::json;

use super::{Outcome, PrintFormat, ReportFormat, in_pool, reported, view::ViewArgs};
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    figure::{FigurePlace, PictureFormat, View},
    number::parse_integer,
    output::{
        Column, Destination, FileRegistry, FileUse, LONGEST_SCENE, NamedFile, Shard, TableCell, TableFormat,
        TableWriter, make_folder, read_text, say, say_to,
    },
    run::{
        CertificateFile, Findings, GrazingFindings, Job as Task, Keeper, RunReport, Status, Surroundings,
        Tabular, TaskReport, parts, run_task,
    },
    scene::{Kind, Scene},
    study,
};
pub(super) use answer::{AnswerArgs, answer, is_answered};
use axis::Axis;
use bars::Bars;
pub(super) use shard::merge;

/// Run the tasks of a scene: simulate an impact oscillator, find its orbits, follow and prove them.
///
/// A scene is a TOML file that names an oscillator's effects, its walls, parameters and tasks. docs/scenes.md
/// has every key, and examples/scenes has scenes to start from. Each task writes its files, named after it,
/// into the folder, and its part of the report to standard output. The whole scene is checked before anything
/// runs. If a task fails, the others still run. In reports and tables phases are fractions of the period, and
/// all else has the scene's units.
///
/// Exit code, the first that applies: 1: something was refuted; 2: wrong usage, a wrong scene, a task that
/// failed or a file that cannot be written; 3: interrupted, undecided or nothing found; 0: all done.
#[derive(Debug, Clone, Parser)]
#[command(after_help = "Examples:
  grazing run examples/scenes/bouncing-ball.toml -o out
  grazing run examples/scenes/bouncing-ball.toml --only bounces --set a=1/2 -o out")]
pub(super) struct Args {
    /// The scene.
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// Run only this task, or the tasks of this group; may be repeated.
    #[arg(long, value_name = "TASK")]
    only: Vec<String>,
    /// Give a parameter this value, in every task; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    set: Vec<(String, String)>,
    /// Do the I-th of N parts of the one task asked for, of kind basins or diagram, and write a shard to the
    /// file -o, for `grazing merge`.
    #[arg(long, value_name = "I/N", requires = "output", value_parser = Shard::from_str)]
    shard: Option<Shard>,
    /// Check the scene and list the files that would be read and written, and do no more.
    #[arg(long)]
    dry_run: bool,
    /// Print the scene in the newest format, its comments and layout as they are, and do no more.
    #[arg(long, conflicts_with_all = ["only", "set", "shard", "dry_run"])]
    upgrade: bool,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
    /// How the report is written; as LaTeX, tables of orbits, of events and of what is proved, each
    /// certificate by its SHA-256.
    #[arg(long, value_enum, default_value_t = PrintFormat::Text)]
    pub(super) format: PrintFormat,
    /// Significant digits of floats in the report as text, where they are no bounds; 17 show all. JSON and
    /// the tables in files have all digits.
    #[arg(long, value_name = "D", default_value_t = DIGITS, value_parser = digits)]
    digits: usize,
    /// What pictures are written as: svg; pdf and png with the feature `print`.
    #[arg(long, value_name = "FORMAT", default_value = "svg", value_parser = picture_format)]
    pictures: PictureFormat,
    #[command(flatten)]
    view: ViewArgs,
    /// Threads; 0 for one per core.
    #[arg(long, value_name = "J", default_value_t = 0, value_parser = parse_integer::<usize>)]
    jobs: usize,
}

/// Significant digits where nothing else is asked for, and those that tell every float from others.
const DIGITS: usize = 6;
const ALL_DIGITS: usize = 17;

fn digits(text: &str) -> Result<usize> {
    let digits = parse_integer(text)?;
    if !(1..=ALL_DIGITS).contains(&digits) {
        return Err(Error::input(format!("a whole number from 1 to {ALL_DIGITS}")));
    }
    Ok(digits)
}

/// Writes a report for a reader: as wide as the terminal, if it is one.
fn write_text(report: &TaskReport, digits: usize, out: &mut dyn Write) -> Result<()> {
    Ok(match Destination::Stdout.columns() {
        Some(width) => write!(out, "{report:width$.digits$}"),
        None => write!(out, "{report:.digits$}"),
    }?)
}

fn picture_format(text: &str) -> Result<PictureFormat> {
    let format = PictureFormat::of(Path::new(&format!("picture.{text}")));
    let format = format.ok_or_else(|| Error::input("pictures are svg, pdf or png"))?;
    format.check().map(|()| format)
}

/// NAME=VALUE; the scene reads the value, in its units.
pub(super) fn setting(text: &str) -> Result<(String, String)> {
    let parts = text.split_once('=').ok_or_else(|| Error::input("write NAME=VALUE"))?;
    Ok((parts.0.trim().to_string(), parts.1.trim().to_string()))
}

/// A scene from a file, with other values of some parameters.
pub(super) fn scene_with(path: &Path, given: &[(String, String)], files: &FileRegistry) -> Result<Scene> {
    let scene = Scene::from_toml(&read_text(path, LONGEST_SCENE)?, &path.display().to_string())?;
    names::read(&scene, path, files)?;
    scene.with(&scene.values(given)?)
}

/// Whether a task is meant by a name: its own or its group's.
fn called(task: &crate::scene::Task, name: &str) -> bool {
    task.name == name || task.group.as_deref() == Some(name)
}

/// A task with all it works on, and where its files go.
struct Job<'a> {
    job: &'a Task<'a>,
    folder: &'a Path,
    /// Where they were named.
    named: &'a FileRegistry,
    /// What pictures are written as.
    format: PictureFormat,
    /// What of them they show.
    view: View,
}

impl<'a> Deref for Job<'a> {
    type Target = Task<'a>;

    fn deref(&self) -> &Task<'a> {
        self.job
    }
}

impl Job<'_> {
    fn run(&self) -> TaskReport {
        let report = match &self.task.kind {
            Kind::SimulateTask(_) => simulate::run(self),
            _ => run_task(self.job, &mut Files(self)),
        };
        let report = self.with_units(report);
        let named = |file: &String| self.named.is_written(&self.folder.join(file));
        debug_assert!(report.files.iter().all(named), "{report}");
        report
    }

    /// The report that one run would have given, and its files, from the records of all units.
    fn whole(&self, records: &[String]) -> TaskReport {
        self.with_units(parts::whole(self.job, records, &mut Files(self)))
    }

    /// The same with the table of units among its files.
    fn with_units(&self, mut report: TaskReport) -> TaskReport {
        match units::keep(self, &mut report) {
            Ok(()) => report,
            Err(error) => TaskReport::failed(self.job, &error),
        }
    }

    /// Writes one of the task's files.
    fn write(&self, file: &str, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
        self.named.named(&self.folder.join(file))?.write(write)
    }

    /// Writes certificates, and returns the names of their files.
    fn certificates<'t>(&self, all: impl IntoIterator<Item = &'t CertificateFile>) -> Result<Vec<String>> {
        let write = |CertificateFile { file, accepted }: &CertificateFile| {
            self.write(file, |out| Ok(out.write_all(accepted.text().as_bytes())?))?;
            Ok(file.clone())
        };
        all.into_iter().map(write).collect()
    }

    /// Writes rows as the task's CSV file with this ending, and returns the file's name.
    fn csv<T: Tabular>(&self, rows: &T, end: &str) -> Result<String> {
        let file = format!("{}{end}", self.task.name);
        self.write(&file, |out| {
            let columns = rows.columns().into_iter().map(Column::named).collect();
            let mut table = TableWriter::new(out, TableFormat::Csv, "", columns)?;
            for cells in rows.cells(None) {
                table.row(&cells.iter().map(|cell| TableCell::Text(cell)).collect::<Vec<_>>())?;
            }
            table.finish()
        })?;
        Ok(file)
    }

    /// The axis of a parameter.
    fn axis(&self, parameter: &str) -> Axis<'_> {
        Axis::new(parameter, self.scene.unit(parameter))
    }

    /// Where its picture goes.
    fn place(&self) -> FigurePlace<'_> {
        let Job { folder, format, view, .. } = *self;
        FigurePlace { folder, name: &self.task.name, format, view }
    }

    /// The names of the task's picture and of the data beside it.
    fn figure(&self) -> Vec<String> {
        [self.format.ending(), "csv"].map(|end| format!("{}.{end}", self.task.name)).to_vec()
    }
}

/// Keeps findings as files, each kind by its own function.
struct Files<'a>(&'a Job<'a>);

impl Keeper for Files<'_> {
    fn keep(&mut self, _: &Task, findings: &Findings) -> Result<Vec<String>> {
        match (findings, &self.0.task.kind) {
            (Findings::Section(found), Kind::SectionTask(task)) => section::keep(found, task, self.0),
            (Findings::Basins(found), _) => basins::keep(found, self.0),
            (Findings::Map(found), _) => map::keep(found, self.0),
            (Findings::Diagram(found), Kind::DiagramTask(task)) => diagram::keep(found, task, self.0),
            (Findings::Response(found), _) => response::keep(found, self.0),
            (Findings::Branch(found), Kind::BranchTask(task)) => branch::keep(found, task, self.0),
            (Findings::Validate(found), _) => validate::keep(found, self.0),
            (Findings::Chaos(found), _) => chaos::keep(found, self.0),
            (Findings::Orbit(found), _) => Ok(vec![self.0.csv(&found.orbits, ".csv")?]),
            (Findings::Grazing(found), _) => match &**found {
                GrazingFindings::Found(found) => grazing::keep(found, self.0),
                GrazingFindings::Nothing { .. } => Ok(Vec::new()),
            },
            (Findings::Event(found), _) => Ok(vec![self.0.csv(&found.found, ".csv")?]),
            (Findings::Rest(found), _) => {
                Ok(vec![self.0.csv(&found.orbits, ".csv")?, self.0.csv(&found.releases, "-releases.csv")?])
            }
            (Findings::Crisis(found), _) => {
                Ok(vec![self.0.csv(&found.crisis, ".csv")?, self.0.csv(&found.simulated, "-simulated.csv")?])
            }
            _ => Ok(Vec::new()),
        }
    }
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    // Once: it may be a pipe.
    let text = shard::plain(&read_text(&args.scene, LONGEST_SCENE)?);
    let name = args.scene.display().to_string();
    if args.upgrade {
        let upgraded = Scene::upgraded(&text, &name)?;
        Destination::Stdout.write(|out| Ok(out.write_all(upgraded.as_bytes())?))?;
        return Ok(Outcome::Done);
    }
    let scene = Scene::from_toml(&text, &name)?;
    names::read(&scene, &args.scene, files)?;
    for only in &args.only {
        if !scene.tasks.iter().any(|task| called(task, only)) {
            let names: Vec<&str> = scene.tasks.iter().map(|task| task.name.as_str()).collect();
            return Err(Error::input(format!("--only {only}: {name} has the tasks {}", names.join(", "))));
        }
    }
    let changes = scene.values(&args.set)?;
    let view = args.view.view()?;
    if let Some(shard) = args.shard {
        if !args.view.is_whole() {
            return Err(Error::input(
                "--shard draws no picture: leave out --x-limits, --y-limits and --q-modulo-2pi",
            ));
        }
        return shard::run(args, &scene, &text, shard, files, interrupt);
    }
    // All tasks are checked, with the changed parameters, before the first runs.
    let bars = Bars::new(interrupt);
    let around = Surroundings { changes: &changes, folder: Some(&args.output), monitor: &bars };
    let chosen = scene
        .tasks
        .iter()
        .filter(|task| args.only.is_empty() || args.only.iter().any(|only| called(task, only)));
    let jobs = chosen.map(|task| Task::new(&scene, task, around)).collect::<Result<Vec<_>>>()?;
    if jobs.is_empty() {
        return Err(Error::input(format!("{name} has no [[tasks]]: nothing to do")));
    }
    if !args.view.is_whole() {
        shown(&jobs)?;
    }
    for job in &jobs {
        names::task(&scene, job.task, &args.output, args.pictures, files)?;
    }
    if args.dry_run {
        return list(args.format.report(), files);
    }
    make_folder(&args.output)?;
    // What cannot be written ends neither the tasks nor what they refute.
    let mut written = Ok(());
    let done: Arc<Mutex<Vec<TaskReport>>> = Arc::default();
    let parts = || done.lock().unwrap_or_else(PoisonError::into_inner);
    interrupt.says_last(last_words(&scene.title, done.clone(), jobs.iter().map(TaskReport::pending)));
    for job in &jobs {
        let over = parts().last().is_some_and(|last| last.status.is_interrupted());
        let part = if over {
            TaskReport::pending(job)
        } else {
            let job = Job { job, folder: &args.output, named: files, format: args.pictures, view };
            in_pool(args.jobs, || Ok(job.run()))?
        };
        bars.clear();
        if part.status.is_failed() {
            say(format_args!("error: task {}: {}", part.task, part.status));
        }
        // As soon as it is known; JSON is one object, at the end.
        if args.format == PrintFormat::Text {
            let part = Destination::Stdout.write(|out| write_text(&part, args.digits, out));
            written = written.and(part);
        }
        parts().push(part);
    }
    let parts = parts().clone();
    match args.format {
        PrintFormat::Text => {}
        PrintFormat::Json => {
            written = Destination::Stdout.write(|out| write_json(&scene.title, &parts, None, out));
        }
        PrintFormat::Latex => {
            written = Destination::Stdout.write(|out| print::reports(&scene.title, &parts, out));
        }
    }
    let any = |is: fn(&Status) -> bool| parts.iter().any(|part| is(&part.status));
    let outcome: Outcome = parts.iter().map(|part| part.status.outcome()).collect();
    if any(Status::is_failed) {
        let failed = parts.iter().filter(|part| part.status.is_failed()).count();
        say(format_args!("error: {failed} of {} tasks failed", parts.len()));
    }
    reported(outcome, written)
}

/// That every picture of the tasks is one of which a part can be shown.
fn shown(jobs: &[Task]) -> Result<()> {
    let is_one = |job: &&Task| {
        matches!(job.task.kind, Kind::SectionTask(_) | Kind::DiagramTask(_) | Kind::BranchTask(_))
    };
    let is_other = |job: &&Task| {
        matches!(
            job.task.kind,
            Kind::SimulateTask(_) | Kind::BasinsTask(_) | Kind::MapTask(_) | Kind::ResponseTask(_)
        )
    };
    let other = jobs.iter().find(is_other).or(jobs.first().filter(|_| !jobs.iter().any(|job| is_one(&job))));
    other.map_or(Ok(()), |job| {
        Err(Error::input(format!(
            "--x-limits, --y-limits and --q-modulo-2pi are for pictures of sections, diagrams and branches, and \
             task {} is of kind {}: choose tasks with --only",
            job.task.name,
            job.task.kind.word()
        )))
    })
}

/// Lists the files of this command.
fn list(format: ReportFormat, files: &FileRegistry) -> Result<Outcome> {
    files.stop();
    let files = files.files();
    let with = |wanted: fn(FileUse) -> bool| files.iter().filter(move |file| wanted(file.how));
    let (reads, writes) = (with(|how| how != FileUse::Write), with(|how| how != FileUse::Read));
    Destination::Stdout.write(|out| match format {
        ReportFormat::Text => {
            reads.map(|file| ("reads", file)).chain(writes.map(|file| ("writes", file))).try_for_each(
                |(how, file)| say_to(out, format_args!("{how:6} {} ({})", file.path.display(), file.role)),
            )
        }
        ReportFormat::Json => {
            let shown =
                |file: &NamedFile| json!({ "file": file.path.display().to_string(), "as": file.role });
            let (reads, writes): (Vec<_>, Vec<_>) = (reads.map(shown).collect(), writes.map(shown).collect());
            let report = json!({ "format": "grazing-files 1", "reads": reads, "writes": writes });
            Ok(writeln!(out, "{report}")?)
        }
    })?;
    Ok(Outcome::Done)
}

/// Writes the report of one task, or of a part of it.
fn tell(
    scene: &str,
    report: TaskReport,
    shard: Option<Shard>,
    (format, digits): (ReportFormat, usize),
) -> Result<Outcome> {
    let outcome = report.status.outcome();
    if report.status.is_failed() {
        say(format_args!("error: task {}: {}", report.task, report.status));
    }
    let written = Destination::Stdout.write(|out| match format {
        ReportFormat::Text => {
            write_text(&report, digits, out)?;
            match (shard, report.status.is_done()) {
                (Some(shard), true) => {
                    Ok(writeln!(out, "Shard {shard} of the task; `grazing merge` puts the shards together.")?)
                }
                _ => Ok(()),
            }
        }
        ReportFormat::Json => write_json(scene, std::slice::from_ref(&report), shard, out),
    });
    reported(outcome, written)
}

/// What is said, as JSON, if the process ends while a task is under way that does not end itself: the reports
/// of all tasks.
fn last_words(
    scene: &str,
    done: Arc<Mutex<Vec<TaskReport>>>,
    pending: impl Iterator<Item = TaskReport>,
) -> impl Fn() -> (String, Outcome) + Send + 'static {
    let (scene, pending): (_, Vec<TaskReport>) = (scene.to_string(), pending.collect());
    move || {
        let mut parts = done.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let reason = "the process ended while this was under way".to_string();
        let mut status = Status::Interrupted { reason };
        for report in &pending[parts.len()..] {
            let status = std::mem::replace(&mut status, Status::Pending);
            parts.push(TaskReport { status, ..report.clone() });
        }
        let mut text = Vec::new();
        let written = write_json(&scene, &parts, None, &mut text);
        let outcome = parts.iter().map(|part| part.status.outcome()).collect::<Outcome>();
        let text = written.ok().and_then(|()| String::from_utf8(text).ok()).unwrap_or_default();
        (text, outcome.and(Outcome::Interrupted))
    }
}

/// The reports as one object.
fn write_json(scene: &str, tasks: &[TaskReport], shard: Option<Shard>, out: &mut dyn Write) -> Result<()> {
    let report = RunReport::new(scene, shard.map(|shard| shard.to_string()), tasks);
    Ok(writeln!(out, "{}", report.to_json()?)?)
}

/// Runs a task of the paper's own scene, without a report; the files that it wrote.
pub(super) fn paper(
    task: &str,
    &FigurePlace { folder, format, view, .. }: &FigurePlace,
    files: &FileRegistry,
    interrupt: &Interrupt,
) -> Result<Vec<PathBuf>> {
    let scene = Scene::from_toml(study::PAPER, "nordmark-2001.toml")?;
    let task = scene.tasks.iter().find(|known| known.name == task);
    let task = task.ok_or_else(|| Error::input("the paper's scene has no such task"))?;
    make_folder(folder)?;
    let bars = Bars::new(interrupt);
    let around = Surroundings { changes: &[], folder: Some(folder), monitor: &bars };
    names::task(&scene, task, folder, format, files)?;
    let report = Job { job: &Task::new(&scene, task, around)?, folder, named: files, format, view }.run();
    match report.status {
        Status::Failed { reason, .. } => Err(Error::input(reason)),
        Status::Interrupted { reason } => Err(Error::interrupted(reason)),
        _ => Ok(report.files.iter().map(|file| folder.join(file)).collect()),
    }
}
