//! What was measured before: `measured.csv` beside the files says by which program, with which options and on
//! which computer, and a hash of each file, so that a part that is whole is not measured again.

use std::{
    env, fs,
    path::{Path, PathBuf},
    sync::OnceLock,
};

use super::Part;
use crate::{
    error::Result,
    output::{Column, FileRegistry, TableCell, TableFormat, TableWriter, fnv64},
    study::computer::{PROGRAM, load, machine},
};

/// The name of the file.
pub(super) const NAME: &str = "measured.csv";
const COLUMNS: [&str; 8] = ["part", "file", "options", "program", "build", "machine", "load", "hash"];

/// A row for each file, in the order of [`COLUMNS`].
pub(super) struct Kept {
    file: PathBuf,
    rows: Vec<[String; COLUMNS.len()]>,
}

impl Kept {
    /// What a folder says; nothing if it does not, or not in this form.
    pub(super) fn read(folder: &Path) -> Kept {
        let file = folder.join(NAME);
        let mut rows = Vec::new();
        if let Ok(mut reader) = csv::Reader::from_path(&file)
            && reader.headers().is_ok_and(|headers| headers.iter().eq(COLUMNS))
        {
            rows.extend(reader.records().map_while(|row| row.ok()).filter_map(|row| {
                <[String; COLUMNS.len()]>::try_from(row.iter().map(String::from).collect::<Vec<_>>()).ok()
            }));
        }
        Kept { file, rows }
    }

    /// Whether every file of a part is as this program wrote it, with these options.
    pub(super) fn has(&self, part: &Part, options: &str) -> bool {
        part.files.iter().all(|name| {
            let wanted = [part.name, name, options, PROGRAM, build()];
            self.rows.iter().any(|row| {
                row.iter().zip(wanted).all(|(cell, wanted)| cell == wanted)
                    && hash(&self.file.with_file_name(name)).as_deref() == Some(&row[7])
            })
        })
    }

    /// Writes that a part has just been measured.
    ///
    /// # Errors
    /// An I/O error.
    pub(super) fn keep(&mut self, part: &Part, options: &str, files: &FileRegistry) -> Result<()> {
        self.rows.retain(|row| row[0] != part.name);
        let load = load().map_or(String::new(), |load| format!("{load:.2}"));
        for &name in part.files {
            let hash = hash(&self.file.with_file_name(name)).unwrap_or_default();
            let row = [part.name, name, options, PROGRAM, build(), &machine(), &load, &hash];
            self.rows.push(row.map(String::from));
        }
        files.named(&self.file)?.write(|out| {
            let columns = COLUMNS.map(|name| Column::new(name, name, 0)).to_vec();
            let mut table = TableWriter::new(out, TableFormat::Csv, "", columns)?;
            for row in &self.rows {
                table.row(&row.each_ref().map(|cell| TableCell::Text(cell)))?;
            }
            table.finish()
        })
    }
}

/// A hash of a file's bytes, in hexadecimal digits.
fn hash(file: &Path) -> Option<String> {
    Some(format!("{:016x}", fnv64(&fs::read(file).ok()?)))
}

/// That of this program: another build may take another time.
fn build() -> &'static str {
    static BUILD: OnceLock<String> = OnceLock::new();
    BUILD.get_or_init(|| env::current_exe().ok().and_then(|file| hash(&file)).unwrap_or_default())
}
