//! A task in parts: rows of basins and of a map, and values of a diagram, are done apart, in processes of
//! their own, and put together.
//!
//! A record is what one of these units came to, a line of JSON. The findings come from the records of all
//! units in order by the same steps as in one run, so they are equal to the bit. Records are read with care
//! but believed: who computed them is trusted.

use std::{collections::BTreeMap, fmt, ops::Range, path::Path};

use serde::{Deserialize, Serialize};

use super::{Findings, Job, Keeper, TaskReport, basins, diagram, kept, map};
use crate::{
    error::{Error, Result},
    motion::Effect,
    scene::{Kind, Task},
};

/// How many units a task has that can be done apart, and what they are; none if its kind has no such units.
pub fn units(task: &Task) -> Option<(u64, &'static str)> {
    match &task.kind {
        Kind::BasinsTask(task) => Some((task.u.count.into(), "rows")),
        // A value of a sweep depends on the one before.
        Kind::DiagramTask(task) if task.sweep.is_none() => Some((task.count.into(), "values")),
        Kind::MapTask(task) => Some((task.second_count.into(), "rows")),
        _ => None,
    }
}

/// What a unit came to, and with the first of a part what all of the part took.
#[derive(Serialize, Deserialize)]
struct Unit {
    /// Records are kept as they were written.
    found: String,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    effects: BTreeMap<String, u64>,
}

/// Does some units, and gives a record for each. What is done is kept in the checkpoint `file`, and what it
/// holds of these units is not done again. Cost: that of these units.
///
/// # Errors
/// Those of the task; an unusable checkpoint; an interruption; an input error if the task has no units.
pub fn part(job: &Job, units: Range<u64>, file: &Path) -> Result<Vec<String>> {
    job.check()?;
    let records = match &job.task.kind {
        Kind::BasinsTask(task) => basins::rows(task, job, units, file),
        Kind::DiagramTask(task) if task.sweep.is_none() => diagram::values(task, job, units, file),
        Kind::MapTask(task) => map::rows(task, job, units, file),
        kind => Err(no_parts(kind.word())),
    }?;
    let mut effects: BTreeMap<String, u64> =
        counted(job).map(|effect| (effect.name().to_string(), job.tally.of(effect))).collect();
    effects.retain(|_, count| *count > 0);
    let unit = |found| record(&Unit { found, effects: std::mem::take(&mut effects) });
    records.into_iter().map(unit).collect()
}

/// What one run would have said and kept, from the records of all units in order. Never fails as a function,
/// as [`run_task`](super::run_task).
pub fn whole(job: &Job, records: &[String], keeper: &mut dyn Keeper) -> TaskReport {
    match job.check().and_then(|()| joined(job, records)).and_then(|findings| kept(job, findings, keeper)) {
        Ok((findings, files)) => TaskReport::of(job, findings, files),
        Err(error) => TaskReport::failed(job, &error),
    }
}

fn joined(job: &Job, records: &[String]) -> Result<Findings> {
    let mut found = Vec::with_capacity(records.len());
    for (number, text) in records.iter().enumerate() {
        let unit: Unit = serde_json::from_str(text).map_err(|error| foreign(number, &error))?;
        for (name, count) in unit.effects {
            let effect = counted(job).find(|effect| effect.name() == name);
            job.tally.add(effect.ok_or_else(|| foreign(number, &format!("no effect {name:?}")))?, count);
        }
        found.push(unit.found);
    }
    Ok(match &job.task.kind {
        Kind::BasinsTask(task) => basins::joined(task, job, &found)?.into(),
        Kind::DiagramTask(task) if task.sweep.is_none() => diagram::joined(task, job, &found)?.into(),
        Kind::MapTask(task) => map::joined(task, job, &found)?.into(),
        kind => return Err(no_parts(kind.word())),
    })
}

fn counted(job: &Job) -> impl Iterator<Item = Effect> {
    job.effects().iter().copied()
}

fn no_parts(kind: &str) -> Error {
    Error::input(format!(
        "a task of kind {kind} cannot be done in parts; those of kind basins, map and, unless it sweeps, diagram can"
    ))
}

/// A line of JSON.
pub(super) fn record(unit: &impl Serialize) -> Result<String> {
    Ok(serde_json::to_string(unit).map_err(std::io::Error::other)?)
}

/// The error for a record that is none of the task's, the first having the number 0.
pub(super) fn foreign(number: usize, why: &dyn fmt::Display) -> Error {
    Error::input(format!("unit {number} of the task has a record that is not one: {why}"))
}
