//! What an interrupted diagram has done, kept in a file that is replaced whole.

use std::{fs, io::ErrorKind, path::Path};

use serde::{Deserialize, Serialize};

use super::Slice;
use crate::error::{Error, Result};

const FORMAT: &str = "grazing-diagram 1";

#[derive(Serialize, Deserialize)]
struct File {
    format: String,
    identity: String,
    slices: Vec<Slice>,
}

/// The slices in a checkpoint; none if there is no such file.
pub(super) fn read(path: &Path, identity: &str) -> Result<Vec<Slice>> {
    let text = match fs::read_to_string(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        text => text.map_err(|error| Error::io("read", path, error))?,
    };
    let bad = |what: &str| Error::input(format!("{}: {what}; remove it to start anew", path.display()));
    let file: File = serde_json::from_str(&text).map_err(|error| bad(&format!("no checkpoint: {error}")))?;
    if file.format != FORMAT {
        return Err(bad(&format!("its format is {:?}, not {FORMAT:?}", file.format)));
    }
    if file.identity != identity {
        return Err(bad("a checkpoint of another diagram"));
    }
    Ok(file.slices)
}

/// Replaces the checkpoint: at every moment the file is whole.
pub(super) fn write(path: &Path, identity: &str, slices: &[Slice]) -> Result<()> {
    let file = File { format: FORMAT.into(), identity: identity.into(), slices: slices.to_vec() };
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
    write().map_err(|error| Error::io("write", path, error))
}
