//! Where output goes: standard output, or a file that appears only when it is complete.

use std::{
    fs,
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
};

use crate::error::{Error, Result};

/// Standard output, or a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Destination {
    /// Standard output.
    Stdout,
    /// A file, written as [`write_file`] does.
    File(PathBuf),
}

impl Destination {
    /// The file, if one is named, else standard output.
    pub fn new(file: Option<PathBuf>) -> Self {
        file.map_or(Destination::Stdout, Destination::File)
    }

    /// Runs `write` on the destination, buffered.
    ///
    /// # Errors
    /// Whatever `write` returns; an I/O error that names the destination.
    pub fn write(&self, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
        match self {
            Destination::File(path) => write_file(path, write),
            Destination::Stdout => {
                let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
                let result = write(&mut out).and_then(|()| Ok(out.flush()?));
                // What could not be written is not tried again when the buffer is dropped.
                let _ = out.into_parts();
                result.map_err(|error| if error.is_io() { error.context("standard output") } else { error })
            }
        }
    }
}

/// Writes a file by way of a temporary one beside it, renamed when all is written: an error or an interruption
/// leaves neither a new file nor a changed old one. A device or pipe is written directly.
///
/// # Errors
/// Whatever `write` returns; an I/O error that names `path`.
pub fn write_file(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let name = |error: Error| {
        if error.is_io() { error.context(format_args!("cannot write {}", path.display())) } else { error }
    };
    // Through a symbolic link, the file it points to is replaced and not the link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    if fs::metadata(&target).is_ok_and(|found| !found.is_file()) {
        return write_directly(&target, write).map_err(name);
    }
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        return Err(Error::input(format!(
            "cannot write {}: there is no folder {}",
            path.display(),
            folder.display()
        )));
    }
    replace(&target, folder, write).map_err(name)
}

fn write_directly(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let mut out = BufWriter::new(fs::File::create(path)?);
    let result = write(&mut out).and_then(|()| Ok(out.flush()?));
    let _ = out.into_parts();
    result
}

fn replace(target: &Path, folder: &Path, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".grazing-");
    #[cfg(unix)]
    {
        // As for any new file, the user's mask applies.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut out = BufWriter::with_capacity(1 << 16, builder.tempfile_in(folder)?);
    write(&mut out)?;
    out.flush()?;
    let file = out.into_inner().map_err(|error| Error::from(error.into_error()))?;
    file.as_file().sync_all()?;
    file.persist(target).map_err(|error| Error::from(error.error))?;
    Ok(())
}
