//! `grazing answer`, or no command at all: a machine in, a page of answer out ([`crate::answer`]); asked for,
//! its pictures, tables and certificates as files, as `grazing run` writes them.

use std::{
    path::{Path, PathBuf},
    sync::{Arc, Mutex, PoisonError},
};

use clap::Parser;

use super::{Bars, DIGITS, Job, last_words, names, setting, write_json, write_text};
use crate::{
    answer::{self, is_machine, scene_of},
    cli::{Outcome, ReportFormat, in_pool, progress::Interrupt, reported},
    error::{Error, Result},
    figure::{self, FigurePlace, MachinePicture, PictureFormat, View},
    output::{Destination, FileRegistry, LONGEST_SCENE, make_folder, read_text},
    run::{Surroundings, TaskReport, run_task},
    scene::Scene,
};

/// What a machine does as its drive is turned up: where it touches its stop, what it does then, and why.
///
/// Each sentence is marked: proved, with a certificate; located, as a root in floats; seen, by following
/// motions. A machine is given by its mass m, stiffness k, damping c (or damping ratio ζ), the frequency f of
/// the drive and the gap to its stop, and if you like the amplitude F of the drive and the restitution e (0.8
/// if not); or by a scene with a task of kind `grazing`. The word `answer` may be left out.
///
/// Exit code: 2: wrong usage, a wrong machine or a file that cannot be written; 3: interrupted, undecided or
/// nothing found; 0: all done.
#[derive(Debug, Clone, Parser)]
#[command(after_help = "Examples:
  grazing 'm = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 10 mm' --save machine.toml
  grazing machine.toml -o out")]
pub(in crate::cli) struct AnswerArgs {
    /// The machine, as `m = 2 kg, k = 800 N/m, …`, or the file of a scene.
    #[arg(value_name = "MACHINE|SCENE.toml")]
    machine: String,
    /// Give a parameter this value; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    set: Vec<(String, String)>,
    /// Write the machine as a scene, for `grazing run`.
    #[arg(long, value_name = "FILE", conflicts_with = "set")]
    save: Option<PathBuf>,
    /// Write the machine's drawing, the picture of its swing, tables and certificates into this folder.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Print all that was found, as `grazing run` does.
    #[arg(long)]
    full: bool,
    /// How it is written; as JSON the reports of both tasks, as `grazing run` writes them.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(in crate::cli) format: ReportFormat,
}

/// What stands in place of a command, where that is a machine or a scene.
pub(in crate::cli) fn is_answered(word: &str) -> bool {
    is_machine(word) || Path::new(word).extension().is_some_and(|ending| ending == "toml")
}

pub(in crate::cli) fn answer(
    args: &AnswerArgs,
    files: &FileRegistry,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let (text, name) = match is_machine(&args.machine) {
        true => (scene_of(&args.machine)?, "machine.toml"),
        false => (read(&args.machine)?, args.machine.as_str()),
    };
    let scene = Scene::from_toml(&text, name)?;
    if !is_machine(&args.machine) {
        names::read(&scene, Path::new(name), files)?;
    }
    let changes = scene.values(&args.set)?;
    let (folder, format) = (args.output.as_deref(), PictureFormat::Svg);
    let save = args.save.as_ref().map(|file| files.write("--save", file)).transpose()?;
    let bars = Bars::new(interrupt);
    let around = Surroundings { changes: &changes, folder, monitor: &bars };
    let done: Arc<Mutex<Vec<TaskReport>>> = Arc::default();
    let answer = answer::answer(&scene, around, |job| {
        interrupt.says_last(last_words(
            &scene.title,
            done.clone(),
            std::iter::once(TaskReport::pending(job)),
        ));
        if let Some(folder) = folder {
            names::task(&scene, job.task, folder, format, files)?;
            make_folder(folder)?;
        }
        let report = in_pool(0, || {
            Ok(match folder {
                Some(folder) => Job { job, folder, named: files, format, view: View::default() }.run(),
                None => run_task(job, &mut ()),
            })
        })?;
        done.lock().unwrap_or_else(PoisonError::into_inner).push(report.clone());
        Ok(report)
    })?;
    bars.clear();
    if let Some(file) = save {
        file.write(|out| Ok(out.write_all(text.as_bytes())?))?;
    }
    if let Some(folder) = folder {
        drawn(&scene.with(&changes)?, &format!("{}-machine", answer.touch.task), folder, files)?;
    }
    let reports: Vec<TaskReport> = answer.reports().cloned().collect();
    let written = Destination::Stdout.write(|out| match (args.format, args.full) {
        (ReportFormat::Json, _) => write_json(&scene.title, &reports, None, out),
        (ReportFormat::Text, true) => reports.iter().try_for_each(|report| write_text(report, DIGITS, out)),
        (ReportFormat::Text, false) => {
            writeln!(out, "{}", scene.title)?;
            match Destination::Stdout.columns() {
                Some(width) => write!(out, "{answer:width$}")?,
                None => write!(out, "{answer}")?,
            }
            Ok(())
        }
    });
    reported(reports.iter().map(|report| report.status.outcome()).collect(), written)
}

/// The text of a scene.
fn read(file: &str) -> Result<String> {
    match Path::new(file).exists() {
        true => Ok(super::shard::plain(&read_text(Path::new(file), LONGEST_SCENE)?)),
        false => Err(Error::input(format!(
            "{file}: there is no such file, and as a machine it is not understood: write m = 2 kg, k = 800 N/m, c = 3 N s/m, f = \
             4 Hz, gap = 10 mm"
        ))),
    }
}

/// The machine's drawing and its data.
fn drawn(scene: &Scene, name: &str, folder: &Path, files: &FileRegistry) -> Result<()> {
    let place = FigurePlace::svg(folder, name);
    for file in [place.picture(), place.data()] {
        files.write("the drawing", &file)?;
    }
    figure::machine(&MachinePicture::of(scene)?, &place)
}
