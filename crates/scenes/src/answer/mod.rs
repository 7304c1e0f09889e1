//! One question, one page of answer: what does this machine do as its drive is turned up? In sentences, each
//! with its mark, and one picture, how far it swings over the drive. The command line, Python and the page in
//! a browser give this answer.
//!
//! It is what two tasks of a scene find: its first `grazing`, with what moves the touch, and a `response`
//! over the same parameter about the touch. Both could stand in the scene. Not here: how they are run
//! (`run`), the picture (the package `grazing-shell`).

mod machine;

use std::fmt;

use num_rational::BigRational;

pub use machine::{is_machine, scene_of};

use crate::{
    error::Result,
    run::{Findings, GrazingFindings, GrazingReport, Job, Lines, Sentence, Status, Surroundings, TaskReport},
    scene::{Kind, Scene, Task, branches::SweepWay, response::ResponseTask, simulate::Start},
};

/// How many values of the drive the picture has, each way.
const VALUES: u32 = 61;
/// How far it goes beyond the touch, and below what else is told, as parts of the value.
const BEYOND: f64 = 1.4;
const BELOW: f64 = 0.7;

/// What the two tasks came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Of the touch.
    pub touch: TaskReport,
    /// How far it swings about the touch; absent where no touch at a value other than 0 was found.
    pub swing: Option<TaskReport>,
}

impl Answer {
    /// What it says, each with its mark; what a reader asks for further stands in the report of the touch.
    pub fn sentences(&self) -> Vec<&Sentence> {
        let found = found(&self.touch);
        found.map_or_else(Vec::new, |found| found.sentences.iter().filter(|said| !said.detail).collect())
    }

    /// The reports of its tasks, as of a run of the scene.
    pub fn reports(&self) -> impl Iterator<Item = &TaskReport> {
        std::iter::once(&self.touch).chain(&self.swing)
    }

    /// What should be known before its numbers are trusted.
    fn warnings(&self) -> Vec<&str> {
        let mut warnings: Vec<&str> = Vec::new();
        for text in self.reports().flat_map(|report| &report.warnings) {
            if !warnings.contains(&text.as_str()) {
                warnings.push(text);
            }
        }
        warnings
    }
}

/// Asks both: `run` runs a task ([`run_task`](crate::run::run_task)) and keeps what it likes of it.
///
/// # Errors
/// An input error of a scene without a task of kind `grazing`; those of [`Job::new`] and of `run`. What
/// happens later is in the reports.
pub fn answer(
    scene: &Scene,
    around: Surroundings,
    mut run: impl FnMut(&Job) -> Result<TaskReport>,
) -> Result<Answer> {
    let task = touch_task(scene)?;
    let touch = run(&Job::new(scene, &task, around)?)?;
    let swing = swing_task(&task, &touch).filter(|_| !touch.status.is_interrupted());
    let swing = swing.map(|task| run(&Job::new(scene, &task, around)?));
    Ok(Answer { touch, swing: swing.transpose()? })
}

/// The scene's first task of kind `grazing`, with what moves the touch.
fn touch_task(scene: &Scene) -> Result<Task> {
    let own = scene.tasks.iter().find(|task| matches!(task.kind, Kind::GrazingTask(_)));
    let mut task = own.cloned().ok_or_else(|| {
        let names: Vec<&str> = scene.parameters.iter().map(|(name, _)| name.as_str()).collect();
        scene.fail(
            "tasks",
            &format!(
                "has no task of kind grazing, of which the answer is. Add\n\n    [[tasks]]\n    name = \"first-touch\"\n    kind = \"grazing\"\n    \
                 parameter = \"…\"    # what is turned up, of {}\n\nor run the tasks that it has: grazing run",
                names.join(", ")
            ),
        )
    })?;
    if let Kind::GrazingTask(keys) = &mut task.kind {
        keys.sensitivity = true;
    }
    Ok(task)
}

/// How far the machine swings about the touch that was found, up and down, over the parameter of that task;
/// none where no touch was found, or at 0.
fn swing_task(touch: &Task, report: &TaskReport) -> Option<Task> {
    let (Kind::GrazingTask(keys), found) = (&touch.kind, found(report)?) else { return None };
    let range = about(found)?;
    let keys = ResponseTask {
        parameter: keys.parameter.clone(),
        range: range.map(BigRational::from_float).into_iter().collect::<Option<_>>()?,
        count: VALUES,
        harmonic: 1,
        // Where motions were not followed beside the touch, that takes long.
        seen: Some(found.seen.is_some()),
        sweep: SweepWay::Both,
        unstable: true,
        backbone: false,
        start: Start::at(0.0, &[0.0], &[0.0]).ok()?,
        transient: 200,
        points: 100,
        longest: 16,
        resume: false,
    };
    Some(Task {
        name: format!("{}-swing", touch.name),
        kind: Kind::ResponseTask(Box::new(keys)),
        ..touch.clone()
    })
}

fn found(report: &TaskReport) -> Option<&GrazingReport> {
    match report.findings.as_ref()? {
        Findings::Grazing(found) => match &**found {
            GrazingFindings::Found(found) => Some(found),
            GrazingFindings::Nothing { .. } => None,
        },
        _ => None,
    }
}

/// The values about a touch within which the answer has something to show; none where it is at 0.
fn about(found: &GrazingReport) -> Option<[f64; 2]> {
    let touch = found.at.parameter;
    let rows = found.seen.iter().flatten().filter(|row| matches!(&*row.place, "back" | "rest"));
    let (mut least, mut most) = (touch, touch);
    for row in rows {
        (least, most) = (least.min(row.value), most.max(row.value));
    }
    let ends = if touch > 0.0 { [BELOW * least, BEYOND * most] } else { [BEYOND * least, BELOW * most] };
    // A range past 0 is of another sign of the drive.
    (touch != 0.0 && least * most > 0.0 && ends[0] < ends[1]).then_some(ends)
}

/// The machine's numbers, a line for each sentence under its mark, and what else a reader should know. A
/// width, as in `{:80}`, is how wide lines may be.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Lines::new(None, f.width());
        if !self.touch.told.is_empty() {
            lines.say("parameters", self.touch.told.join(", "));
        }
        for Sentence { mark, text, .. } in self.sentences() {
            lines.say(&mark.to_string(), text.as_str());
        }
        for report in self.reports() {
            if report.status != Status::Done {
                lines.say(&report.task, report.status.to_string());
            }
        }
        for warning in self.warnings() {
            lines.say("warning", warning);
        }
        f.write_str(lines.text())
    }
}
