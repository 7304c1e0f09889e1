//! The one writer of files, and the one reader of small ones.
//!
//! A file is written as a temporary one beside it, brought to the disk and renamed: at every moment the
//! target is whole, the old one or the new. While it is written the temporary is locked. A killed process
//! leaves its temporary behind but not the lock, so the next write of the same target knows it and removes
//! it; one whose owner still writes stays.

use std::{
    fs::{self, File, OpenOptions, TryLockError},
    io::{self, BufWriter, ErrorKind, Read, Write},
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
    thread,
};

use super::early::Early;
use crate::error::{Error, Result};

/// Writes a file whole, or not at all: an error or an interruption leaves neither a new file nor a changed
/// old one. A link is followed, also one to a file that does not exist yet. A device or a pipe is written
/// directly.
///
/// # Errors
/// Whatever `write` returns; an input error if there is no such folder; an I/O error that names `path`.
pub fn write_file(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    write_proved(path, None, write, |_| Ok(Some(()))).map(drop)
}

/// The same, if what was written is worth it: `judge` is given the file that holds it, and where it gives
/// nothing, what stood at `path` stays. `stream` is the pipe or device there, if it is open already.
///
/// # Errors
/// Those of [`write_file`]; whatever `judge` returns.
pub(super) fn write_proved<T>(
    path: &Path,
    stream: Option<File>,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
    judge: impl FnOnce(&Path) -> Result<Option<T>>,
) -> Result<Option<T>> {
    let name = |error: Error| {
        if error.is_io() { error.context(format_args!("cannot write {}", path.display())) } else { error }
    };
    match Target::of(path)? {
        Target::Stream => {
            let out = stream.map_or_else(|| open_stream(path), Ok)?;
            let mut out = BufWriter::new(out);
            let result = write(&mut out).and_then(|()| Ok(out.flush()?));
            // What could not be written is not tried again when the buffer is dropped.
            let _ = out.into_parts();
            result.map_err(name)?;
            judge(path)
        }
        Target::File(target) => {
            let mut temporary = Temporary::beside(&target).map_err(name)?;
            let result = thread::scope(|scope| {
                let mut out = BufWriter::with_capacity(1 << 16, Early::new(scope, &temporary.file));
                let result = write(&mut out).and_then(|()| Ok(out.flush()?));
                let (mut early, _) = out.into_parts();
                result.and_then(|()| Ok(early.wait()?))
            });
            result.map_err(name)?;
            let found = judge(&temporary.path)?;
            if found.is_some() {
                temporary.rename(&target).map_err(name)?;
            }
            Ok(found)
        }
    }
}

/// Opens a pipe or a device to write to; of a pipe it waits for a reader.
fn open_stream(path: &Path) -> Result<File> {
    OpenOptions::new().write(true).open(path).map_err(|error| Error::io("write", path, error))
}

/// Whether a file can be written, tried without touching what is there. A pipe or a device is opened; it is
/// to be written as it is, since the reader of a pipe goes when it is closed.
///
/// # Errors
/// Why not: a missing folder, a folder in the file's place, a file or folder that may not be written.
pub fn probe(path: &Path) -> Result<Option<File>> {
    match Target::of(path)? {
        Target::Stream => open_stream(path).map(Some),
        Target::File(target) => {
            if fs::metadata(&target).is_ok_and(|found| found.permissions().readonly()) {
                return Err(Error::input(format!("cannot write {}: it is read-only", path.display())));
            }
            Temporary::beside(&target)
                .map(|_| None)
                .map_err(|error| error.context(format_args!("cannot write {}", path.display())))
        }
    }
}

/// Makes a folder for files, with those above it, and tries to write there.
///
/// # Errors
/// An I/O error that names the folder.
pub fn make_folder(folder: &Path) -> Result<()> {
    if folder == Path::new("-") {
        return Err(Error::input("-o -: several files need a folder; write ./- for one of that name"));
    }
    if fs::metadata(folder).is_ok_and(|found| !found.is_dir()) {
        let shown = folder.display();
        return Err(Error::input(format!(
            "{shown} is a file, and several files need a folder: give its name"
        )));
    }
    fs::create_dir_all(folder).map_err(|error| Error::io("create", folder, error))?;
    Temporary::beside(&folder.join("probe"))
        .map(drop)
        .map_err(|error| error.context(format_args!("cannot write into {}", folder.display())))
}

/// The text of a file, or of standard input for `-`, of at most `most` bytes; a pipe or a device without end
/// is read no further.
///
/// # Errors
/// An I/O error, or an input error if it is longer or not UTF-8; both name the file.
pub fn read_text(path: &Path, most: u64) -> Result<String> {
    let fail = |error| Error::io("read", path, error);
    let mut bytes = Vec::new();
    let mut stream: Box<dyn Read> = if path == Path::new("-") {
        Box::new(io::stdin())
    } else {
        Box::new(File::open(path).map_err(fail)?)
    };
    stream.by_ref().take(most + 1).read_to_end(&mut bytes).map_err(fail)?;
    if bytes.len() as u64 > most {
        return Err(Error::input(format!("{} has more than {most} bytes", path.display())));
    }
    String::from_utf8(bytes).map_err(|_| Error::input(format!("{} is not UTF-8 text", path.display())))
}

/// The most bytes of a scene or a map.
pub const LONGEST_SCENE: u64 = 4 << 20;

/// The most bytes of a branch's file.
pub const LONGEST_INPUT: u64 = 16 << 20;

/// What a path leads to.
enum Target {
    /// A device or a pipe.
    Stream,
    /// A regular file, there or not: its folder without links, and its name.
    File(PathBuf),
}

impl Target {
    fn of(path: &Path) -> Result<Target> {
        let bad = |what: String| Err(Error::input(format!("cannot write {}: {what}", path.display())));
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => return bad("it is a folder".into()),
            Ok(found) if !found.is_file() => return Ok(Target::Stream),
            _ => {}
        }
        match resolve(path) {
            Ok(target) => Ok(Target::File(target)),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                bad(format!("there is no folder {}", folder(&follow(path)).display()))
            }
            Err(error) => Err(Error::io("write", path, error)),
        }
    }
}

/// The file that a path leads to, in a folder named without links. The file need not exist.
///
/// # Errors
/// Of the system: no such folder, a loop of links.
pub(super) fn resolve(path: &Path) -> io::Result<PathBuf> {
    if let Ok(target) = fs::canonicalize(path) {
        return Ok(target);
    }
    let path = follow(path);
    match (path.is_symlink(), path.file_name()) {
        (true, _) => Err(io::Error::other("too many links")),
        (_, None) => Err(io::Error::other("it is a folder")),
        (_, Some(name)) => {
            let folder = fs::canonicalize(folder(&path))?;
            if folder.is_dir() { Ok(folder.join(name)) } else { Err(ErrorKind::NotADirectory.into()) }
        }
    }
}

/// A path with the links at its end followed, as far as a system would.
fn follow(path: &Path) -> PathBuf {
    let mut path = path.to_path_buf();
    for _ in 0..40 {
        match fs::read_link(&path) {
            Ok(next) => path = folder(&path).join(next),
            Err(_) => break,
        }
    }
    path
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// At most so many processes write one target at a time.
const SLOTS: u32 = 8;

/// A locked file beside a target, removed when dropped.
struct Temporary {
    path: PathBuf,
    file: File,
    renamed: bool,
}

/// The temporaries of this process, for an end that runs no destructors. The one piece of the file system
/// that is ours is one per process.
static OPEN: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes the temporary files of all writes that are under way, before the process ends without waiting for
/// them.
pub fn remove_temporaries() {
    for path in OPEN.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
        let _ = fs::remove_file(path);
    }
}

impl Temporary {
    fn beside(target: &Path) -> Result<Temporary> {
        // By a hash: the name of any target fits, whatever its length and letters.
        let name = target.file_name().unwrap_or_default();
        let tag = super::hash::fnv64(name.as_encoded_bytes());
        let path = |slot: u32| target.with_file_name(format!(".grazing-{tag:016x}-{slot}"));
        for slot in 0..SLOTS {
            let place = path(slot);
            // Twice, for one that a kill has left.
            for _ in 0..2 {
                match OpenOptions::new().write(true).create_new(true).open(&place) {
                    Ok(file) => {
                        // Where there are no locks, nothing that was left is recognised, and all else works.
                        let taken = matches!(file.try_lock(), Err(TryLockError::WouldBlock));
                        if taken || !linked(&file) {
                            // Another process took it for left, between the last two steps, and removes it
                            // itself: by now the name may be that of a third one's file.
                            continue;
                        }
                        OPEN.lock().unwrap_or_else(PoisonError::into_inner).push(place.clone());
                        let temporary = Temporary { path: place, file, renamed: false };
                        for slot in slot + 1..SLOTS {
                            remove_left(&path(slot));
                        }
                        return Ok(temporary);
                    }
                    Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                        if !remove_left(&place) {
                            break;
                        }
                    }
                    Err(error) => return Err(error.into()),
                }
            }
        }
        Err(Error::input(format!(
            "{SLOTS} others write it now, or were killed where files cannot be locked: remove {}",
            path(0).display()
        )))
    }

    fn rename(&mut self, target: &Path) -> Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.path, target)?;
        self.renamed = true;
        sync_folder(target);
        Ok(())
    }
}

/// Brings a file's name to the disk, where the system can.
pub(super) fn sync_folder(target: &Path) {
    if let Ok(folder) = File::open(folder(target)) {
        let _ = folder.sync_all();
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.renamed {
            let _ = fs::remove_file(&self.path);
        }
        OPEN.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.path);
    }
}

/// Removes a temporary file that nobody holds; whether it did.
fn remove_left(path: &Path) -> bool {
    // Only who holds the lock of a file that still has this name may remove it. Its owner may have renamed
    // it between the first two steps, and another have come by the name.
    path.is_file()
        && OpenOptions::new()
            .write(true)
            .open(path)
            .is_ok_and(|file| file.try_lock().is_ok() && named(&file, path) && fs::remove_file(path).is_ok())
}

/// Whether an open file has this name, which is no link.
fn named(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let known = |found: &fs::Metadata| (found.dev(), found.ino());
        matches!((file.metadata(), fs::symlink_metadata(path)), (Ok(a), Ok(b)) if known(&a) == known(&b))
    }
    #[cfg(not(unix))]
    {
        file.metadata().is_ok() && path.is_file()
    }
}

/// Whether an open file still has a name.
pub(super) fn linked(file: &File) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        file.metadata().is_ok_and(|found| found.nlink() > 0)
    }
    #[cfg(not(unix))]
    {
        file.metadata().is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_write_one_file_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("part");
        std::thread::scope(|scope| {
            for writer in 0..SLOTS / 2 {
                let target = &target;
                scope.spawn(move || {
                    for _ in 0..200 {
                        write_file(target, |out| Ok(writeln!(out, "{writer}")?)).unwrap();
                    }
                });
            }
        });
        assert_eq!(fs::read(&target).unwrap().len(), 2);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary is left");
    }
}
