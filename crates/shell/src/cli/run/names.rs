//! The files that tasks read and may write, known before they run: none is named twice.

use std::path::Path;

use super::units;
use crate::{
    error::{Error, Result},
    figure::PictureFormat,
    output::{Clash, FileRegistry, FileUse, MADE},
    scene::{
        Kind, Scene, Task,
        branches::{BranchOrigin, BranchTask},
        orbits::RangeKey,
    },
};

/// What may follow a task's name in the name of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    /// This.
    Fixed(&'static str),
    /// The first, a minus, a number and the second.
    Numbered(&'static str, &'static str),
    /// That of a picture.
    Picture,
    /// This, and that of a picture.
    Beside(&'static str),
    /// A minus, a number and that.
    Pictures,
    /// This, for a file from which an interrupted task goes on.
    State(&'static str),
}

/// The endings of files that only some branches have.
fn endings_of_branch(task: &BranchTask) -> impl Iterator<Item = &'static Ending> {
    use Ending::{Beside, Fixed, Numbered};
    let proofs: &[Ending] = &[Fixed("-proofs.csv"), Numbered("", ".certificate")];
    let orbits: &[Ending] = &[Beside("-orbits"), Fixed("-orbits.csv")];
    let asked = [(task.prove, proofs), (task.drawn > 0, orbits)];
    asked.into_iter().filter(|(asked, _)| *asked).flat_map(|(_, all)| all)
}

/// The endings of all files that a task of a kind may write, but for [`endings_of_branch`].
fn endings(kind: &Kind) -> &'static [Ending] {
    use Ending::{Fixed, Numbered, Picture, Pictures, State};
    match kind {
        Kind::SimulateTask(_) => &[Pictures, Picture, Fixed(".csv"), Fixed("-events.csv")],
        Kind::SectionTask(_) => &[Picture, Fixed(".csv")],
        Kind::BasinsTask(_) | Kind::MapTask(_) => &[Picture, Fixed(".csv"), State(".checkpoint")],
        Kind::DiagramTask(task) if task.prove => &[
            Picture,
            Fixed(".csv"),
            Fixed("-windows.csv"),
            Fixed("-bands.csv"),
            Fixed("-jumps.csv"),
            Fixed("-proofs.csv"),
            Numbered("", ".certificate"),
            State(".checkpoint"),
        ],
        Kind::DiagramTask(task) if task.sweep.is_some() => &[
            Picture,
            Fixed(".csv"),
            Fixed("-windows.csv"),
            Fixed("-bands.csv"),
            Fixed("-jumps.csv"),
            State(".checkpoint"),
        ],
        Kind::DiagramTask(_) => {
            &[Picture, Fixed(".csv"), Fixed("-windows.csv"), Fixed("-bands.csv"), State(".checkpoint")]
        }
        Kind::ResponseTask(_) => &[
            Picture,
            Fixed(".csv"),
            Fixed("-peaks.csv"),
            Fixed("-backbone.csv"),
            Fixed("-jumps.csv"),
            State(".checkpoint"),
        ],
        Kind::OrbitTask(_) | Kind::EventTask(_) => &[Fixed(".csv")],
        Kind::GrazingTask(task) if task.prove || task.attractor || task.range != RangeKey::None => &[
            Fixed(".csv"),
            Fixed("-touches.csv"),
            Fixed("-seen.csv"),
            Fixed("-bands.csv"),
            Fixed("-hits.csv"),
            Fixed("-influence.csv"),
            Fixed("-proofs.csv"),
            Fixed("-before.certificate"),
            Fixed("-before-part.certificate"),
            Numbered("-before", ".certificate"),
            Numbered("-before-cell", ".certificate"),
            Fixed("-beyond.certificate"),
            Fixed("-beyond-part.certificate"),
            Fixed("-beyond-attractor.certificate"),
            Fixed("-beyond-attractor-at.certificate"),
            Numbered("-beyond", ".certificate"),
            Numbered("-beyond-cell", ".certificate"),
            Numbered("", ".certificate"),
        ],
        Kind::GrazingTask(_) => &[
            Fixed(".csv"),
            Fixed("-touches.csv"),
            Fixed("-seen.csv"),
            Fixed("-bands.csv"),
            Fixed("-hits.csv"),
            Fixed("-influence.csv"),
        ],
        Kind::BranchTask(_) => {
            &[Fixed(".json"), Numbered("", ".json"), Picture, Fixed(".csv"), Fixed("-points.csv")]
        }
        Kind::CrisisTask(_) => &[Fixed(".csv"), Fixed("-simulated.csv")],
        Kind::RestTask(_) => &[Fixed(".csv"), Fixed("-releases.csv")],
        Kind::ValidateTask(_) => &[Fixed(".csv"), Numbered("", ".certificate")],
        Kind::ChaosTask(_) => &[Fixed(".csv"), Fixed(".certificate")],
    }
}

/// Names the files that a scene is read from.
///
/// # Errors
/// An input error if one is written.
pub(super) fn read(scene: &Scene, path: &Path, files: &FileRegistry) -> Result<()> {
    files.read("the scene", path)?;
    scene.files().iter().try_for_each(|file| files.read("the scene's file", file))
}

/// Names the files that a task may write into a folder, and those there that it begins with. They are tried
/// when they are written.
///
/// # Errors
/// An input error at the task's name if one of them is another file of this command.
pub(super) fn task(
    scene: &Scene,
    task: &Task,
    folder: &Path,
    format: PictureFormat,
    files: &FileRegistry,
) -> Result<()> {
    let clashes = |clash| told(scene, task, clash);
    let origins = match &task.kind {
        Kind::BranchTask(branch) => branch.starts.as_slice(),
        Kind::DiagramTask(diagram) => diagram.branches.as_slice(),
        _ => &[],
    };
    for origin in origins {
        if let Ok(BranchOrigin::Restart(restart)) = origin.origin() {
            let role = format!("{MADE}{}", task.name);
            files.claim(role, &folder.join(&restart.file), FileUse::Read).map_err(clashes)?;
        }
    }
    let role = format!("the task {}", task.name);
    let picture = format!(".{}", format.ending());
    let one = |end: &str, how| files.claim(&role, &folder.join(format!("{}{end}", task.name)), how);
    if scene.units.is_some() {
        one(units::ENDING, FileUse::Write).map_err(clashes)?;
    }
    let branch = match &task.kind {
        Kind::BranchTask(branch) => Some(endings_of_branch(branch)),
        _ => None,
    };
    for ending in endings(&task.kind).iter().chain(branch.into_iter().flatten()) {
        match *ending {
            Ending::Fixed(end) => one(end, FileUse::Write),
            Ending::State(end) => one(end, FileUse::Continue),
            Ending::Picture => one(&picture, FileUse::Write),
            Ending::Beside(first) => one(&format!("{first}{picture}"), FileUse::Write),
            Ending::Numbered(first, end) => {
                files.claim_series(&role, folder, &format!("{}{first}", task.name), end)
            }
            Ending::Pictures => files.claim_series(&role, folder, &task.name, &picture),
        }
        .map_err(clashes)?;
    }
    Ok(())
}

/// What is said at a task whose file is another's too.
fn told(scene: &Scene, task: &Task, Clash { first, second }: Clash) -> Error {
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    // Of a series and one of its files, the file.
    let series = second.path.to_string_lossy().contains("-N.") && first.how != FileUse::Read;
    let file = name(if series { &first.path } else { &second.path });
    let message = match (first.role.starts_with("the task "), second.how) {
        (true, FileUse::Write | FileUse::Continue) => format!(
            "this task and {} would both write {file}: rename one, or choose one with --only",
            first.role
        ),
        (_, FileUse::Read) => format!("this task begins with {file}, which {} writes", first.role),
        _ => format!(
            "this task would write {file}, which is {first}: rename the task, or write elsewhere with -o"
        ),
    };
    scene.fail(&format!("{}.name", task.path), &message)
}
