//! What an interrupted job has done, kept in a file that is replaced whole.

use std::{
    fs,
    io::ErrorKind,
    path::Path,
    time::{Duration, Instant},
};

use serde::{Deserialize, Serialize, de::DeserializeOwned};

use crate::error::{Error, Result};

/// Less than this apart no two checkpoints are written, but for the last.
const PAUSE: Duration = Duration::from_secs(5);

#[derive(Serialize, Deserialize)]
struct File<T> {
    format: String,
    identity: String,
    done: T,
}

/// The checkpoint of one job.
pub(super) struct Checkpoint<'a> {
    path: Option<&'a Path>,
    format: &'static str,
    identity: String,
    last: Instant,
}

impl<'a> Checkpoint<'a> {
    /// That of a job in a file, or none; `identity` is all that its result depends on.
    pub fn new(path: Option<&'a Path>, format: &'static str, identity: String) -> Self {
        Checkpoint { path, format, identity, last: Instant::now() }
    }

    /// What is done already; `None` if there is no such file. Refuses a file of another job.
    pub fn read<T: DeserializeOwned>(&self) -> Result<Option<T>> {
        let Some(path) = self.path else { return Ok(None) };
        let text = match fs::read_to_string(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            text => text.map_err(|error| Error::io("read", path, error))?,
        };
        let bad = |what: &str| Error::input(format!("{}: {what}; remove it to start anew", path.display()));
        // Its name first: another format may have other fields.
        let json: serde_json::Value =
            serde_json::from_str(&text).map_err(|error| bad(&format!("no checkpoint: {error}")))?;
        if json["format"] != self.format {
            return Err(bad(&format!("its format is {}, not {:?}", json["format"], self.format)));
        }
        let file: File<T> =
            serde_json::from_value(json).map_err(|error| bad(&format!("no checkpoint: {error}")))?;
        if file.identity != self.identity {
            return Err(bad("a checkpoint of another job: of other settings or another scene"));
        }
        Ok(Some(file.done))
    }

    /// Replaces the file, unless that was done a moment ago: at every moment it is whole.
    pub fn write(&mut self, done: &impl Serialize) -> Result<()> {
        if self.last.elapsed() >= PAUSE { self.write_now(done) } else { Ok(()) }
    }

    /// Replaces the file.
    pub fn write_now(&mut self, done: &impl Serialize) -> Result<()> {
        let Some(path) = self.path else { return Ok(()) };
        let file = File { format: self.format.into(), identity: self.identity.clone(), done };
        let text = serde_json::to_string(&file).map_err(std::io::Error::other)?;
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let write = || -> std::io::Result<()> {
            let mut new = tempfile::NamedTempFile::new_in(folder)?;
            std::io::Write::write_all(&mut new, text.as_bytes())?;
            new.persist(path)?;
            Ok(())
        };
        write().map_err(|error| Error::io("write", path, error))?;
        self.last = Instant::now();
        Ok(())
    }
}
