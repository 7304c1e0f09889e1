//! What a task found, said once and written as text or as JSON.

use std::{fmt, io::Write};

use serde::{Serialize, Serializer, ser::SerializeMap};
use serde_json::Value;

use super::Job;
use crate::error::Result;

/// Names and values in the order in which they were found, and the files written.
pub(super) struct Report {
    entries: Vec<(&'static str, Value)>,
    /// Whether something asked for was left undecided.
    pub undecided: bool,
}

impl Report {
    pub fn new(job: &Job) -> Report {
        let parameters: serde_json::Map<String, Value> = job
            .scene
            .parameters
            .iter()
            .map(|(name, value)| (name.clone(), value.to_string().into()))
            .collect();
        let mut report = Report { entries: Vec::new(), undecided: false };
        report.say("task", job.task.name.as_str());
        report.say("kind", job.task.kind.word());
        report.say("parameters", parameters);
        report
    }

    /// Adds a finding.
    pub fn say(&mut self, name: &'static str, value: impl Into<Value>) {
        self.entries.push((name, value.into()));
    }
}

impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.entries.len()))?;
        for (name, value) in &self.entries {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

/// The task's name, then a line a finding.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, value)) in self.entries.iter().enumerate() {
            match index {
                0 => writeln!(f, "{}", text(value))?,
                _ => writeln!(f, "  {name:<16} {}", text(value))?,
            }
        }
        Ok(())
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(all) => all.iter().map(text).collect::<Vec<_>>().join(", "),
        Value::Object(all) => {
            all.iter().map(|(key, value)| format!("{key} = {}", text(value))).collect::<Vec<_>>().join(" ")
        }
        Value::Null => "none".to_string(),
        other => other.to_string(),
    }
}

/// The reports as one object.
pub(super) fn json(scene: &str, tasks: &[Report], out: &mut dyn Write) -> Result<()> {
    #[derive(Serialize)]
    struct All<'a> {
        format: &'static str,
        scene: &'a str,
        tasks: &'a [Report],
    }
    let text = serde_json::to_string_pretty(&All { format: "grazing-run 1", scene, tasks });
    Ok(writeln!(out, "{}", text.map_err(std::io::Error::other)?)?)
}
