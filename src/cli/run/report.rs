//! What a task found, said once and written as text or as JSON.

use std::{fmt, io::Write};

use serde::{
    Serialize, Serializer,
    ser::{SerializeMap, SerializeSeq},
};
use serde_json::Value;

use super::Job;
use crate::{
    error::Result,
    output::{Cell, Column, TableFormat, TableWriter, write_file},
};

/// A value or a table.
enum Finding {
    Value(Value),
    Rows(Rows),
}

/// A small table: what a task found several of.
pub(super) struct Rows {
    columns: Vec<&'static str>,
    rows: Vec<Vec<Value>>,
}

impl Rows {
    pub fn new(columns: &[&'static str]) -> Rows {
        Rows { columns: columns.to_vec(), rows: Vec::new() }
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Adds a row, one value for each column.
    pub fn push<const N: usize>(&mut self, row: [Value; N]) {
        debug_assert_eq!(N, self.columns.len());
        self.rows.push(row.to_vec());
    }

    /// Writes the table as the task's CSV file with this ending.
    pub fn save(&self, job: &Job, end: &str) -> Result<()> {
        let file = job.folder.join(format!("{}{end}", job.task.name));
        write_file(&file, |out| self.write(out, TableFormat::Csv))
    }

    fn write(&self, out: &mut dyn Write, format: TableFormat) -> Result<()> {
        let columns = self.columns.iter().enumerate().map(|(i, name)| {
            let width = self.rows.iter().map(|row| text(&row[i]).chars().count()).max();
            Column::new(name, name, width.unwrap_or(0))
        });
        let mut table = TableWriter::new(out, format, "grazing-run-rows 1", columns.collect())?;
        for row in &self.rows {
            let row: Vec<String> = row.iter().map(text).collect();
            table.row(&row.iter().map(|cell| Cell::Text(cell)).collect::<Vec<_>>())?;
        }
        table.finish()
    }
}

/// The rows as objects, keys in the order of the columns.
impl Serialize for Rows {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        struct Row<'a>(&'a [&'static str], &'a [Value]);
        impl Serialize for Row<'_> {
            fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
                let mut map = serializer.serialize_map(Some(self.0.len()))?;
                for (name, value) in self.0.iter().zip(self.1) {
                    map.serialize_entry(name, value)?;
                }
                map.end()
            }
        }
        let mut rows = serializer.serialize_seq(Some(self.rows.len()))?;
        for row in &self.rows {
            rows.serialize_element(&Row(&self.columns, row))?;
        }
        rows.end()
    }
}

/// A number, or "none" if it is not finite.
pub(super) fn number(x: f64) -> Value {
    x.into()
}

/// A list of numbers.
pub(super) fn numbers(all: impl Iterator<Item = f64>) -> Value {
    all.map(number).collect::<Vec<_>>().into()
}

/// Names and values in the order in which they were found, and the files written.
#[derive(Default)]
pub(super) struct Report {
    entries: Vec<(&'static str, Finding)>,
    /// The names of the files written.
    pub files: Vec<String>,
    /// Whether something asked for was left undecided.
    pub undecided: bool,
    /// Whether something asked for was refuted.
    pub refuted: bool,
}

impl Report {
    /// Adds a finding.
    pub fn say(&mut self, name: &'static str, value: impl Into<Value>) {
        match (name, value.into()) {
            ("files", Value::Array(files)) => {
                self.files.extend(files.iter().filter_map(Value::as_str).map(String::from));
            }
            (_, value) => self.entries.push((name, Finding::Value(value))),
        }
    }

    /// Adds a table, and writes it as the task's CSV file.
    pub fn rows(&mut self, name: &'static str, rows: Rows, job: &Job) -> Result<()> {
        rows.save(job, ".csv")?;
        self.table(name, rows);
        Ok(())
    }

    /// Adds a table.
    pub fn table(&mut self, name: &'static str, rows: Rows) {
        self.entries.push((name, Finding::Rows(rows)));
    }
}

impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.entries.len()))?;
        for (name, value) in &self.entries {
            match value {
                Finding::Value(value) => map.serialize_entry(name, value)?,
                Finding::Rows(rows) => map.serialize_entry(name, rows)?,
            }
        }
        map.end()
    }
}

/// A line a finding.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, value) in &self.entries {
            match value {
                Finding::Value(value) => writeln!(f, "  {name:<16} {}", text(value))?,
                Finding::Rows(rows) => {
                    let mut table = Vec::new();
                    rows.write(&mut table, TableFormat::Table).map_err(|_| fmt::Error)?;
                    writeln!(f, "  {name}")?;
                    for line in String::from_utf8_lossy(&table).lines() {
                        writeln!(f, "    {line}")?;
                    }
                }
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
