//! One process at a time: a file beside a saved state, locked while the state is in use.

use std::{
    fs::{self, File, OpenOptions, TryLockError},
    io::{ErrorKind, Read, Write},
    path::{Path, PathBuf},
    process,
};

use super::file::linked;
use crate::error::{Error, Result};

/// The right to use a state file, until dropped. The system releases it when the process ends, however it
/// ends; the file that a kill leaves is taken over by the next run.
#[derive(Debug)]
pub(super) struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    /// Takes the lock of a file, named without links, for `user` (as in "grazing fuzz").
    ///
    /// # Errors
    /// An input error that says who holds it; an I/O error.
    pub fn take(target: &Path, user: &str) -> Result<Lock> {
        let mut name = std::ffi::OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(".grazing-lock");
        let path = target.with_file_name(name);
        let fail = |error| Error::io("lock", target, error);
        loop {
            let mut file = open(&path).map_err(fail)?;
            match file.try_lock() {
                // Its holder removed it after it was opened here.
                Ok(()) if !linked(&file) => continue,
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    let mut holder = String::new();
                    let _ = file.take(200).read_to_string(&mut holder);
                    let holder = if holder.is_empty() { "another process" } else { holder.trim_end() };
                    return Err(Error::input(format!("{} is in use by {holder}", target.display())));
                }
                // A system without locks.
                Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => {}
                Err(TryLockError::Error(error)) => return Err(fail(error)),
            }
            file.set_len(0)
                .and_then(|()| writeln!(file, "process {} ({user})", process::id()))
                .map_err(fail)?;
            return Ok(Lock { path, _file: file });
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // While it is still locked: nobody else has begun to use it.
        let _ = fs::remove_file(&self.path);
    }
}

/// Opens the lock's file or makes it; never through a link.
fn open(path: &Path) -> std::io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(true);
    match options.clone().create_new(true).open(path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            if !fs::symlink_metadata(path).map_or(true, |found| found.is_file()) {
                return Err(std::io::Error::other(format!("{} is not a file of ours", path.display())));
            }
            // Removed in between by its holder: made anew.
            options.create(true).truncate(false).open(path)
        }
        opened => opened,
    }
}
