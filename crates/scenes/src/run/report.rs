//! What a run says of one task.

use std::fmt;

use serde::{Serialize, Serializer, ser::SerializeMap};

use super::{CertificateFile, ColumnUnit, FiledClaim, Findings, Job, Lines, Place, Status, units};
use crate::{
    error::{Error, Result},
    scene::Engine,
};

/// A task's name, its status, what it found, what that cost, and where it is kept.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TaskReport {
    /// Its name.
    pub task: String,
    /// Its kind, as in the scene.
    pub kind: &'static str,
    /// How it ended.
    #[serde(flatten)]
    pub status: Status,
    /// What computed its motions, and why that.
    pub engine: Engine,
    /// Where it stands in the scene.
    pub place: Place,
    /// The exact values of the parameters.
    #[serde(serialize_with = "as_map")]
    pub parameters: Vec<(String, String)>,
    /// These as a reader is told them.
    #[serde(skip)]
    pub told: Vec<String>,
    /// What its numbers are in, by their columns, as far as the scene has units.
    #[serde(serialize_with = "as_units")]
    pub units: Vec<ColumnUnit>,
    /// What it found, unless it failed.
    #[serde(flatten, serialize_with = "with_claims")]
    pub findings: Option<Findings>,
    /// What a reader should know before trusting the numbers.
    pub warnings: Vec<String>,
    /// What was computed, and how often: see docs/formats.md.
    #[serde(serialize_with = "as_map")]
    pub effects: Vec<(&'static str, u64)>,
    /// The files in which the findings are kept.
    pub files: Vec<String>,
}

fn as_map<K: Serialize, V: Serialize, S: Serializer>(
    all: &[(K, V)],
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(all.len()))?;
    for (key, value) in all {
        map.serialize_entry(key, value)?;
    }
    map.end()
}

/// What was found, and in `certificates` what the checker says of each.
fn with_claims<S: Serializer>(
    findings: &Option<Findings>,
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Found<'a> {
        #[serde(flatten)]
        findings: &'a Findings,
        certificates: Vec<FiledClaim<'a>>,
    }
    let found = findings.as_ref().map(|findings| {
        let certificates = findings.certificates().into_iter().map(CertificateFile::claim).collect();
        Found { findings, certificates }
    });
    found.serialize(serializer)
}

/// The scene's own units.
fn as_units<S: Serializer>(all: &[ColumnUnit], serializer: S) -> std::result::Result<S::Ok, S::Error> {
    let own = all.iter().map(|unit| (unit.column, &unit.own)).filter(|(_, own)| !own.is_empty());
    as_map(&own.collect::<Vec<_>>(), serializer)
}

impl TaskReport {
    fn new(job: &Job, status: Status) -> TaskReport {
        let parameters = job.scene.parameters.iter();
        let counted = job.effects().iter().map(|&effect| (effect.name(), job.tally.of(effect)));
        TaskReport {
            task: job.task.name.clone(),
            kind: job.task.kind.word(),
            status,
            engine: job.scene.engine.clone(),
            place: job.place(),
            parameters: parameters.map(|(name, value)| (name.clone(), value.to_string())).collect(),
            told: job.scene.parameters.iter().map(|(name, value)| job.scene.told(name, value)).collect(),
            units: units::columns(&job.scene, &job.task.kind),
            findings: None,
            warnings: job.scene.warnings(),
            effects: counted.filter(|&(_, count)| count > 0).collect(),
            files: Vec::new(),
        }
    }

    pub(super) fn of(job: &Job, findings: Findings, files: Vec<String>) -> TaskReport {
        let mut report = TaskReport::new(job, findings.status());
        report.warnings.extend(findings.warnings());
        TaskReport { findings: Some(findings), files, ..report }
    }

    /// Of a task that failed as a whole.
    pub fn failed(job: &Job, error: &Error) -> TaskReport {
        TaskReport::new(job, Status::of_error(error, job.place()))
    }

    /// Of a part, which is in a file for all parts to be put together.
    pub fn part(job: &Job, file: String) -> TaskReport {
        TaskReport { files: vec![file], ..TaskReport::new(job, Status::Done) }
    }

    /// Of a task that was not reached.
    pub fn pending(job: &Job) -> TaskReport {
        TaskReport::new(job, Status::Pending)
    }
}

/// The reports of a run as one JSON object: what `grazing run --format json` prints (docs/formats.md).
#[derive(Debug, Clone, Serialize)]
pub struct RunReport<'a> {
    format: &'static str,
    scene: &'a str,
    shard: Option<String>,
    tasks: &'a [TaskReport],
}

impl<'a> RunReport<'a> {
    /// The reports of tasks of the scene with this title; of a part of one task, which part, as in "1/4".
    pub fn new(scene: &'a str, shard: Option<String>, tasks: &'a [TaskReport]) -> RunReport<'a> {
        RunReport { format: "grazing-run 4", scene, shard, tasks }
    }

    /// The text of the object, indented.
    ///
    /// # Errors
    /// None in practice: of the writer.
    pub fn to_json(&self) -> Result<String> {
        Ok(serde_json::to_string_pretty(self).map_err(std::io::Error::other)?)
    }
}

/// The names of files, many numbered certificates by the first and the last.
fn told(files: &[String]) -> Vec<String> {
    let stem = |file: &&String| file.strip_suffix(".certificate").map(str::to_string);
    let is_one = |file: &&String| stem(file).is_some_and(|stem| stem.ends_with(|c: char| c.is_ascii_digit()));
    let certificates: Vec<&String> = files.iter().filter(is_one).collect();
    match certificates[..] {
        [first, _, _, .., last] => {
            let others = files.iter().filter(|file| !is_one(file)).cloned();
            others.chain([format!("{first} to {last}")]).collect()
        }
        _ => files.to_vec(),
    }
}

/// The task's name, then a line for each thing. A precision, as in `{:.6}`, is how many significant digits
/// floats have, where they are no bounds; a width, as in `{:80}`, how wide lines may be.
impl fmt::Display for TaskReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Lines::new(f.precision(), f.width()).in_units(&self.units);
        lines.say("kind", self.kind);
        lines.say("status", self.status.to_string());
        lines.say("engine", format!("{}: {}", self.engine.name.word(), self.engine.reason));
        if !self.parameters.is_empty() {
            lines.say("parameters", self.told.join(if self.units.is_empty() { " " } else { ", " }));
        }
        if let Some(findings) = &self.findings {
            findings.lines(&mut lines);
        }
        for warning in &self.warnings {
            lines.say("warning", warning.as_str());
        }
        if !self.files.is_empty() {
            lines.say("files", told(&self.files));
        }
        let effects: Vec<String> =
            self.effects.iter().map(|(name, count)| format!("{name} {count}")).collect();
        lines.say("effects", if effects.is_empty() { vec!["none".to_string()] } else { effects });
        write!(f, "{}\n{}", self.task, lines.text())
    }
}
