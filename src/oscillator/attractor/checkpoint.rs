//! What an interrupted diagram or basin has done, kept as a saved state ([`Journal`]).

use std::path::{Path, PathBuf};

use serde::{Serialize, de::DeserializeOwned};

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    output::{Journal, SavedRun, torn},
};

/// What a user can do about a checkpoint that is not the job's.
const ANEW: &str = "remove it, or set resume = false in the task, to start anew";

/// The checkpoint of one job; without a file nothing is kept.
pub(super) struct Checkpoint {
    state: Option<(Journal, PathBuf)>,
}

impl Checkpoint {
    /// The checkpoint of a job, of at most `most` bytes, and what it holds; `canonical` is a text of all that
    /// the job's result depends on. The monitor is told if a last line was torn.
    ///
    /// # Errors
    /// Those of [`Journal::open`]; an input error for records that are none of the job's.
    pub fn open<T: DeserializeOwned>(
        path: Option<&Path>,
        kind: &'static str,
        canonical: &str,
        most: u64,
        monitor: &dyn Monitor,
    ) -> Result<(Checkpoint, Vec<T>)> {
        let Some(path) = path else { return Ok((Checkpoint { state: None }, Vec::new())) };
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let (state, found) = Journal::open(path, &SavedRun::new(kind, name, canonical).anew(ANEW), most)?;
        if found.torn > 0 {
            monitor.note(&torn(path));
        }
        let checkpoint = Checkpoint { state: Some((state, path.to_path_buf())) };
        let read = |record: &String| {
            serde_json::from_str(record).map_err(|error| checkpoint.bad(&error.to_string()))
        };
        let records = found.records.iter().map(read).collect::<Result<_>>()?;
        Ok((checkpoint, records))
    }

    /// The error for records that no run of the job comes to.
    pub fn bad(&self, what: &str) -> Error {
        let path = self.state.as_ref().map(|(_, path)| path.display().to_string()).unwrap_or_default();
        Error::input(format!("cannot resume from {path}: {what}; {ANEW}"))
    }

    /// Keeps one more part.
    ///
    /// # Errors
    /// An I/O error.
    pub fn append(&mut self, part: &impl Serialize) -> Result<()> {
        match &mut self.state {
            Some((state, _)) => state.append(&text(part)?),
            None => Ok(()),
        }
    }

    /// What ended the job before it was done; an interruption says that the next run goes on.
    pub fn ended(&self, error: Error, done: usize, all: usize, what: &str) -> Error {
        match &self.state {
            Some((_, path)) if error.is_interrupted() => Error::interrupted(format!(
                "interrupted: {done} of {all} {what} are done and kept in {}; running again continues from there",
                path.display()
            )),
            _ => error,
        }
    }
}

fn text(part: &impl Serialize) -> Result<String> {
    Ok(serde_json::to_string(part).map_err(std::io::Error::other)?)
}
