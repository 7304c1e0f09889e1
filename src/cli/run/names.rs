//! The files that tasks may write, known before they run: no two tasks of a run may name the same.

use crate::{
    error::Result,
    scene::{Kind, Scene, Task},
};

/// What may follow a task's name in the name of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    /// This.
    Fixed(&'static str),
    /// A minus, a number and this.
    Numbered(&'static str),
    /// That of a picture.
    Picture,
    /// A minus, a number and that.
    Pictures,
}

/// The endings of all files that a task of a kind may write.
fn endings(kind: &Kind) -> &'static [Ending] {
    use Ending::{Fixed, Numbered, Picture, Pictures};
    match kind {
        Kind::SimulateTask(_) => &[Pictures, Picture, Fixed(".csv"), Fixed("-events.csv")],
        Kind::SectionTask(_) => &[Picture, Fixed(".csv")],
        Kind::BasinsTask(_) | Kind::MapTask(_) => &[Picture, Fixed(".csv"), Fixed(".checkpoint")],
        Kind::DiagramTask(_) => &[Picture, Fixed(".csv"), Fixed("-windows.csv"), Fixed(".checkpoint")],
        Kind::OrbitTask(_) | Kind::EventTask(_) | Kind::GrazingTask(_) => &[Fixed(".csv")],
        Kind::BranchTask(_) => {
            &[Fixed(".json"), Numbered(".json"), Picture, Fixed(".csv"), Fixed("-points.csv")]
        }
        Kind::CrisisTask(_) => &[Fixed(".csv"), Fixed("-simulated.csv")],
        Kind::ValidateTask(_) => &[Fixed(".csv"), Numbered(".certificate")],
        Kind::ChaosTask(_) => &[Fixed(".csv"), Fixed(".certificate")],
    }
}

/// Whether a task may write a file of this name; names that differ in case only are one on some systems.
pub(super) fn may_write(task: &Task, file: &str) -> bool {
    let (name, file) = (task.name.to_ascii_lowercase(), file.to_ascii_lowercase());
    let Some(rest) = file.strip_prefix(&name) else { return false };
    let numbered = |end: &str| {
        rest.strip_suffix(end)
            .and_then(|rest| rest.strip_prefix('-'))
            .is_some_and(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
    };
    const PICTURES: [&str; 3] = [".svg", ".pdf", ".png"];
    endings(&task.kind).iter().any(|ending| match *ending {
        Ending::Fixed(end) => rest == end,
        Ending::Numbered(end) => numbered(end),
        Ending::Picture => PICTURES.contains(&rest),
        Ending::Pictures => PICTURES.into_iter().any(numbered),
    })
}

/// A file that both tasks may write, one of them under a name without a number: two numbered names agree only
/// where the names of their tasks do, which a scene does not allow.
fn shared(one: &Task, other: &Task) -> Option<String> {
    endings(&one.kind).iter().find_map(|ending| match ending {
        Ending::Fixed(end) => Some(format!("{}{end}", one.name)).filter(|file| may_write(other, file)),
        // The same whatever it is written as.
        Ending::Picture => Some(format!("{}.svg", one.name)).filter(|file| may_write(other, file)),
        Ending::Numbered(_) | Ending::Pictures => None,
    })
}

/// Refuses tasks that would write the same file.
///
/// # Errors
/// An input error at the second task's name.
pub(super) fn distinct(scene: &Scene, tasks: &[&Task]) -> Result<()> {
    for (i, second) in tasks.iter().enumerate() {
        for first in &tasks[..i] {
            if let Some(file) = shared(first, second).or_else(|| shared(second, first)) {
                let message = format!(
                    "this task and the task {} would both write {file}: rename one, or choose one with --only",
                    first.name
                );
                return Err(scene.fail(&format!("{}.name", second.path), &message));
            }
        }
    }
    Ok(())
}
