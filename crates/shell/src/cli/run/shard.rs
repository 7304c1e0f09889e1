//! A task of a scene in shards, each some rows of basins or of a map or some values of a diagram; and the
//! task from its shards.

use std::{
    ops::Range,
    path::{Path, PathBuf},
};

use num_rational::BigRational;

use super::{Args, Bars, DIGITS, Job, called, list, names, tell};
use crate::{
    cli::{
        Outcome, in_pool,
        progress::Interrupt,
        shards::{Merged, Part, ShardSet},
    },
    error::{Error, Result},
    figure::{PictureFormat, View},
    output::{FileRegistry, FileUse, Journal, Shard, ShardedTask, TaskInput, fingerprint, make_folder},
    program,
    run::{Job as Task, Surroundings, TaskReport, parts},
    scene::Scene,
};

/// What stands for the scene in the words of a task: its shards hold the text.
const SCENE: &str = "SCENE";

/// What shards are parts of. Scenes are told apart by their text and by all that the task's motions depend on
/// besides (matrices, records of forces), not by their name.
fn sharded(args: &Args, changes: &[(String, BigRational)], job: &Task, text: &str) -> Result<ShardedTask> {
    let mut words = ["run", SCENE, "--only", &job.task.name].map(String::from).to_vec();
    for (name, value) in changes {
        words.extend(["--set".to_string(), format!("{name}={value}")]);
    }
    if args.pictures != PictureFormat::Svg {
        words.extend(["--pictures".to_string(), args.pictures.ending().to_string()]);
    }
    let hash = fingerprint(&format!("{} {text}", job.identity()?));
    let input = TaskInput { file: args.scene.display().to_string(), hash, text: text.to_string() };
    Ok(ShardedTask { input: Some(input), ..ShardedTask::new(words, program()) })
}

/// The lines of a scene end alike on all systems.
pub(super) fn plain(text: &str) -> String {
    text.replace("\r\n", "\n")
}

/// Does a part of the one task that is asked for.
pub(super) fn run(
    args: &Args,
    scene: &Scene,
    text: &str,
    shard: Shard,
    files: &FileRegistry,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let (output, name) = (args.output.as_path(), args.scene.display());
    let mut chosen = scene.tasks.iter().filter(|task| {
        let wanted = |only: &String| called(task, only);
        args.only.is_empty() || args.only.iter().any(wanted)
    });
    let (Some(task), None) = (chosen.next(), chosen.next()) else {
        return Err(Error::input(format!("{name}: --shard needs one task: choose it with --only")));
    };
    let Some((count, _)) = parts::units(task) else {
        return Err(Error::input(format!(
            "{name}: the task {} is of kind {}, which has no parts; tasks of kind basins, diagram and map have",
            task.name,
            task.kind.word()
        )));
    };
    if output.is_dir() {
        return Err(Error::input(format!(
            "-o {}: with --shard, -o names the file of the shard, and this is a folder",
            output.display()
        )));
    }
    let (bars, changes) = (Bars::new(interrupt), scene.values(&args.set)?);
    let around = Surroundings { changes: &changes, folder: None, monitor: &bars };
    let job = Task::new(scene, task, around)?;
    let checkpoint = beside(output);
    files.claim("-o", output, FileUse::Write)?;
    files.claim("the checkpoint", &checkpoint, FileUse::Continue)?;
    if args.dry_run {
        return list(args.format.report(), files);
    }
    let part = Part { task: sharded(args, &changes, &job, text)?, shard, file: files.named(output)? };
    let units = units(count, shard);
    let found = in_pool(args.jobs, || parts::part(&job, units.clone(), &checkpoint));
    let written = found.and_then(|records| {
        part.write(|out| {
            units.clone().zip(&records).try_for_each(|(unit, record)| out.record(unit, record))
        })?;
        Journal::discard(&checkpoint)
    });
    bars.clear();
    let file = output.display().to_string();
    let report = match written {
        Ok(()) => TaskReport::part(&job, file),
        Err(error) => TaskReport::failed(&job, &error),
    };
    tell(&scene.title, report, Some(shard), (args.format.report(), args.digits))
}

/// The units of a part, which are taken to cost the same.
fn units(count: u64, shard: Shard) -> Range<u64> {
    shard.part(0..count, 0)
}

/// The checkpoint of a shard.
fn beside(shard: &Path) -> PathBuf {
    let mut name = shard.as_os_str().to_os_string();
    name.push(".checkpoint");
    name.into()
}

/// The task's files and report, from its shards.
pub(in crate::cli) fn merge(
    args: &Args,
    set: &ShardSet,
    merged: &Merged,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let Some(input) = set.input() else {
        return Err(Error::input("the shards are of a scene that they do not hold: they were changed"));
    };
    let [only] = &args.only[..] else {
        return Err(Error::input("the shards are not of one task: they were changed"));
    };
    let folder = merged.output.unwrap_or(Path::new("."));
    let args = Args { scene: PathBuf::from(&input.file), ..args.clone() };
    let scene = Scene::from_toml(&input.text, &input.file)?;
    let task = scene.tasks.iter().find(|task| task.name == *only);
    let found = task.and_then(|task| Some((task, parts::units(task)?)));
    let Some((task, (count, _))) = found else {
        return Err(Error::input(format!("the scene in the shards has no task {only:?} that has parts")));
    };
    let (bars, changes) = (Bars::new(interrupt), scene.values(&args.set)?);
    let around = Surroundings { changes: &changes, folder: Some(folder), monitor: &bars };
    let job = Task::new(&scene, task, around)?;
    set.expect(&sharded(&args, &changes, &job, &input.text)?)?;
    for file in scene.files() {
        merged.files.read("the scene's file", file)?;
    }
    names::task(&scene, task, folder, args.pictures, merged.files)?;
    let mut records = Vec::new();
    set.records(
        |shard| units(count, shard),
        |_, record| {
            records.push(record.to_string());
            interrupt.check()
        },
    )?;
    make_folder(folder)?;
    let view = View::default();
    let job = Job { job: &job, folder, named: merged.files, format: args.pictures, view };
    let report = in_pool(args.jobs, || Ok(job.whole(&records)))?;
    bars.clear();
    tell(&scene.title, report, None, (merged.format, DIGITS))
}
