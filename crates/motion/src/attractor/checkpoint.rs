//! What an interrupted diagram or basin has done, kept as a saved state ([`Journal`]).

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize, de::DeserializeOwned};

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    motion::{Counts, EffectTally},
    output::{self, Journal, SavedRun, torn},
};

/// What a user can do about a checkpoint that is not the job's.
const ANEW: &str = "remove it, or set resume = false in the task, to start anew";

/// Where what is done is kept.
#[derive(Debug, Clone, Copy, Default)]
pub struct Keep<'a> {
    /// The file; without one nothing is kept.
    pub file: Option<&'a Path>,
    /// Where the work of those who do it is counted: kept with what they find, so that the counts of a
    /// resumed job are those of the uninterrupted one.
    pub tally: Option<&'a EffectTally>,
}

/// Some units of a job, all of them done or none, and what was computed for them.
#[derive(Serialize, Deserialize)]
struct Stretch<T> {
    found: Vec<T>,
    effects: Counts,
}

/// The checkpoint of one job; without a file nothing is kept.
pub(crate) struct Checkpoint<'a> {
    state: Option<(Journal, PathBuf)>,
    tally: Option<&'a EffectTally>,
    /// What is counted already.
    counted: Counts,
}

impl<'a> Checkpoint<'a> {
    /// The checkpoint of a job, of at most `most` bytes, and what it holds, its counts added to the tally;
    /// `canonical` is a text of all that the job's result depends on. The monitor is told if a last line was
    /// torn.
    ///
    /// # Errors
    /// Those of [`Journal::open`]; an input error for records that are none of the job's.
    pub fn open<T: DeserializeOwned>(
        Keep { file, tally }: Keep<'a>,
        kind: &'static str,
        canonical: &str,
        most: u64,
        monitor: &dyn Monitor,
    ) -> Result<(Checkpoint<'a>, Vec<T>)> {
        let counted = || tally.map(EffectTally::counts).unwrap_or_default();
        let Some(path) = file else {
            return Ok((Checkpoint { state: None, tally, counted: counted() }, Vec::new()));
        };
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let program = output::program(&[grazing_base::SOURCES, crate::SOURCES]);
        let (state, found) =
            Journal::open(path, &SavedRun::new(kind, name, canonical, program).anew(ANEW), most)?;
        if found.torn > 0 {
            monitor.note(&torn(path));
        }
        let mut checkpoint =
            Checkpoint { state: Some((state, path.to_path_buf())), tally, counted: Counts::default() };
        let mut all = Vec::new();
        for record in &found.records {
            let Stretch { found, effects } =
                serde_json::from_str(record).map_err(|error| checkpoint.bad(&error.to_string()))?;
            all.extend::<Vec<T>>(found);
            if let Some(tally) = tally {
                tally.add_all(&effects);
            }
        }
        checkpoint.counted = counted();
        Ok((checkpoint, all))
    }

    /// The error for records that no run of the job comes to.
    pub fn bad(&self, what: &str) -> Error {
        let path = self.state.as_ref().map(|(_, path)| path.display().to_string()).unwrap_or_default();
        Error::input(format!("cannot resume from {path}: {what}; {ANEW}"))
    }

    /// Keeps some more units, with what was counted since the last ones.
    ///
    /// # Errors
    /// An I/O error.
    pub fn append(&mut self, units: &[impl Serialize]) -> Result<()> {
        let Some((state, _)) = &mut self.state else { return Ok(()) };
        let now = self.tally.map(EffectTally::counts).unwrap_or_default();
        let stretch = Stretch { found: units.iter().collect(), effects: now.since(&self.counted) };
        self.counted = now;
        state.append(&text(&stretch)?)
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
