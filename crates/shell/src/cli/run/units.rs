//! Which unit each column of a task's tables is in: a table beside them, where the scene has units. Columns
//! keep their names, by which programs find them.

use std::{
    fs::File,
    io::{BufRead, BufReader},
};

use super::Job;
use crate::{
    error::Result,
    run::{ColumnUnit, TaskReport},
    scene::{EngineKey, Kind},
};

/// What its file's name ends with.
pub(super) const ENDING: &str = "-units.csv";

/// Writes it for the tables that a report names.
pub(super) fn keep(job: &Job, report: &mut TaskReport) -> Result<()> {
    let mut rows = String::new();
    for file in report.files.iter().filter(|file| file.ends_with(".csv")) {
        let mut head = String::new();
        BufReader::new(File::open(job.folder.join(file))?).read_line(&mut head)?;
        for column in head.trim_end().split(',') {
            if let Some(unit) = unit(job, &report.units, file, column) {
                rows += &format!("{file},{column},{unit}\n");
            }
        }
    }
    if !rows.is_empty() {
        let file = format!("{}{ENDING}", job.task.name);
        job.write(&file, |out| Ok(write!(out, "file,column,unit\n{rows}")?))?;
        report.files.push(file);
    }
    Ok(())
}

fn unit(job: &Job, units: &[ColumnUnit], file: &str, column: &str) -> Option<String> {
    let named = |name: &str| units.iter().find(|unit| unit.column == name).map(|unit| unit.own.clone());
    let ends = |end: &str| file.strip_prefix(&*job.task.name) == Some(end);
    let kind = &job.task.kind;
    match (kind, column) {
        // The picture's parameters are in the units in which they are written.
        (Kind::BranchTask(_) | Kind::DiagramTask(_), _) if ends(".csv") => {
            let name = match column {
                "parameter" => kind.parameter(),
                "q" if kind.second().is_some() => kind.second(),
                "q" if job.scene.engine.name == EngineKey::One => return named("extent"),
                _ => None,
            };
            name.and_then(|name| job.scene.unit(name)).map(|unit| unit.text.clone())
        }
        // There it counts periods.
        (Kind::SimulateTask(_), "period") if ends("-events.csv") => None,
        // Of several coordinates or stops the columns have numbers.
        (Kind::SimulateTask(_), _) => named(column.trim_end_matches(|c: char| c.is_ascii_digit())),
        _ => named(column),
    }
}
