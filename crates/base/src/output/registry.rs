//! Every file that a command reads or writes, known before work begins, so that none is lost: what is written
//! may be named once, and is named by nothing that is read.
//!
//! Files are compared as files and not as names: by device and inode where they are there, and where they are
//! not by the device and inode of the folder and the name. Two that are not there and whose names differ in
//! case only count as one, as they are on some systems. Standard input, output and error are files too,
//! unless they are a terminal or another device; devices can be named any number of times.
//!
//! A file to be written ([`OutputFile`]) comes from here alone, and none is written once a clash was found.

use std::{
    collections::HashMap,
    fmt,
    fs::{self, Metadata},
    path::{Path, PathBuf},
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
};

use super::{
    destination::{Destination, OutputFile},
    file::{probe, resolve},
};
use crate::error::{Error, Result};

/// What a command does with a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileUse {
    /// It is read.
    Read,
    /// It is made, or replaced whole.
    Write,
    /// What it holds is read and gone on from: a saved state, a list.
    Continue,
}

/// A file of a command.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedFile {
    /// What it is to the command: an option as in `--certificate`, `the scene`, `the task NAME`.
    pub role: String,
    /// As it was named. In the name of one of several files `N` stands for its number.
    pub path: PathBuf,
    /// What is done with it.
    pub how: FileUse,
}

impl fmt::Display for NamedFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display().to_string();
        if path.is_empty() { f.write_str(&self.role) } else { write!(f, "{} {path}", self.role) }
    }
}

/// Two names of one file, at least one of which is written.
#[derive(Debug)]
pub struct Clash {
    /// The one that was named first.
    pub first: NamedFile,
    /// The other.
    pub second: NamedFile,
}

impl From<Clash> for Error {
    fn from(Clash { first, second }: Clash) -> Error {
        Error::input(format!("{first} and {second} are the same file"))
    }
}

/// The files of a command.
#[derive(Debug)]
pub struct FileRegistry {
    known: Mutex<Known>,
    refused: Arc<AtomicBool>,
}

#[derive(Debug, Default)]
struct Known {
    files: Vec<NamedFile>,
    /// What of [`files`](Self::files) has a key.
    by: HashMap<Key, usize>,
    /// The folder of a series, and its name there.
    series: HashMap<usize, (PathBuf, String)>,
    /// The numbered files of folders that were looked into.
    listed: HashMap<PathBuf, HashMap<String, Vec<PathBuf>>>,
}

impl Known {
    /// The file, or the series of files, that has a key.
    fn met(&self, key: &Key) -> Option<usize> {
        match key {
            // A member stands in nobody's way but a series', and the other way round.
            Key::Member(place, name) => self.by.get(&Key::Series(place.clone(), name.clone())),
            Key::Series(place, name) => {
                self.by.get(&Key::Member(place.clone(), name.clone())).or_else(|| self.by.get(key))
            }
            other => self.by.get(other),
        }
        .copied()
    }

    fn is_written(&self, keys: &[Key]) -> bool {
        keys.iter().filter_map(|key| self.met(key)).any(|index| self.files[index].how != FileUse::Read)
    }

    /// Gives what is written the keys that it has now.
    fn name_again(&mut self) {
        for (index, file) in self.files.iter().enumerate().filter(|(_, file)| file.how != FileUse::Read) {
            let keys = match self.series.get(&index) {
                Some((folder, name)) => series_key(folder, name).into_iter().collect(),
                None => keys(&file.path, file.how).unwrap_or_default(),
            };
            for key in keys {
                self.by.entry(key).or_insert(index);
            }
        }
    }
}

/// What tells files apart.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Key {
    /// A file that is there.
    There(Place),
    /// One that may be made, by the part of its path that is there and the rest in small letters.
    Name(Place, String),
    /// A file of a series, by the same with `#` for its number.
    Member(Place, String),
    /// A whole series.
    Series(Place, String),
}

/// What is there: device and inode, or where there are none the path without links.
type Place = (u64, u64, PathBuf);

impl Default for FileRegistry {
    fn default() -> Self {
        FileRegistry::new()
    }
}

impl FileRegistry {
    /// One that knows the standard streams of this process.
    pub fn new() -> FileRegistry {
        let registry = FileRegistry { known: Mutex::default(), refused: Arc::default() };
        #[cfg(unix)]
        {
            let mut known = registry.lock();
            for (role, path) in [("standard output", "/dev/fd/1"), ("standard error", "/dev/fd/2")] {
                if let Some(key) = fs::metadata(path).ok().and_then(|found| there(&found, Path::new(path))) {
                    let file = NamedFile { role: role.into(), path: PathBuf::new(), how: FileUse::Write };
                    let index = known.files.len();
                    // Both may be one file.
                    known.by.entry(key).or_insert(index);
                    known.files.push(file);
                }
            }
        }
        registry
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Names a file that is read; `-` is standard input.
    ///
    /// # Errors
    /// An input error if it is written as well.
    pub fn read(&self, role: impl Into<String>, path: &Path) -> Result<()> {
        Ok(self.claim(role, path, FileUse::Read)?)
    }

    /// Names a file that is to be written whole, and tries it.
    ///
    /// # Errors
    /// An input error if it is named already; those of `OutputFile::new`.
    pub fn write(&self, option: &str, path: &Path) -> Result<OutputFile> {
        if path == Path::new("-") {
            return Err(Error::input(format!(
                "{option} -: standard output has the report; write ./- for a file of that name"
            )));
        }
        self.claim(option, path, FileUse::Write)?;
        OutputFile::new(path, self.refused.clone())
    }

    /// Names a file that is read and gone on from, and tries to write it.
    ///
    /// # Errors
    /// An input error if it is named already; an I/O error if it cannot be written.
    pub fn go_on(&self, option: &str, path: &Path) -> Result<()> {
        self.claim(option, path, FileUse::Continue)?;
        match fs::metadata(path) {
            Ok(found) if is_pipe(&found) => {
                Err(Error::input(format!("{option} {}: it is a pipe, and is to be read too", path.display())))
            }
            // A device is for its reader to refuse.
            Ok(found) if !found.is_file() && !found.is_dir() => Ok(()),
            _ => probe(path).map(drop),
        }
    }

    /// What `-o` names: the file, tried; standard output for `-`, its other names, or nothing.
    ///
    /// # Errors
    /// Those of [`write`](Self::write).
    pub fn destination(&self, file: Option<&Path>) -> Result<Destination> {
        let stdout = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].map(Path::new);
        match file {
            Some(path) if !stdout.contains(&path) => Ok(Destination::File(self.write("-o", path)?)),
            _ => Ok(Destination::Stdout),
        }
    }

    /// A file that was named to be written before; it is tried now.
    ///
    /// # Errors
    /// An input error if it was not; those of `OutputFile::new`.
    pub fn named(&self, path: &Path) -> Result<OutputFile> {
        if !self.is_written(path) {
            return Err(Error::input(format!("{} was not named before it was written", path.display())));
        }
        OutputFile::new(path, self.refused.clone())
    }

    /// Whether a file was named to be written, or is a device.
    pub fn is_written(&self, path: &Path) -> bool {
        let Some(keys) = keys(path, FileUse::Write) else { return true };
        let mut known = self.lock();
        if !known.is_written(&keys) {
            // Folders that were not there when files in them were named have been made since.
            known.name_again();
        }
        known.is_written(&keys)
    }

    /// Names a file without trying it.
    ///
    /// # Errors
    /// The clash, if it is named already and one of both is written.
    pub fn claim(
        &self,
        role: impl Into<String>,
        path: &Path,
        how: FileUse,
    ) -> std::result::Result<(), Clash> {
        let file = NamedFile { role: role.into(), path: path.to_path_buf(), how };
        let keys = match path == Path::new("-") {
            true => standard_input(),
            false => keys(path, how).unwrap_or_default(),
        };
        self.settle(&mut self.lock(), file, keys)
    }

    /// Names the files `STEM-N.END` in a folder for every number N, without trying them.
    ///
    /// # Errors
    /// Those of [`claim`](Self::claim).
    pub fn claim_series(
        &self,
        role: impl Into<String>,
        folder: &Path,
        stem: &str,
        end: &str,
    ) -> std::result::Result<(), Clash> {
        let path = folder.join(format!("{stem}-N{end}"));
        let file = NamedFile { role: role.into(), path, how: FileUse::Write };
        let name = format!("{stem}-#{end}").to_lowercase();
        let mut known = self.lock();
        let Some(key) = series_key(folder, &name) else { return Ok(()) };
        let mut keys = vec![key];
        let listed = known.listed.entry(folder.to_path_buf()).or_insert_with(|| numbered_files(folder));
        let listed = listed.get(&name).into_iter().flatten();
        keys.extend(listed.filter_map(|path| there(&fs::metadata(path).ok()?, path)));
        let index = known.files.len();
        known.series.insert(index, (folder.to_path_buf(), name));
        self.settle(&mut known, file, keys)
    }

    /// Keeps a file with its keys, unless one of those that it meets is a clash.
    fn settle(&self, known: &mut Known, file: NamedFile, keys: Vec<Key>) -> std::result::Result<(), Clash> {
        let clash = |&index: &usize| {
            let other = &known.files[index];
            (other.how != FileUse::Read || file.how != FileUse::Read) && !made_before(other, &file)
        };
        if let Some(first) = keys.iter().filter_map(|key| known.met(key)).find(clash) {
            self.refused.store(true, Ordering::Relaxed);
            return Err(Clash { first: known.files[first].clone(), second: file });
        }
        let index = known.files.len();
        for key in keys {
            known.by.entry(key).or_insert(index);
        }
        known.files.push(file);
        Ok(())
    }

    /// Lets nothing be written from here on.
    pub fn stop(&self) {
        self.refused.store(true, Ordering::Relaxed);
    }

    /// Whether nothing is written: some file was named twice, or the files are only listed.
    pub fn refused(&self) -> bool {
        self.refused.load(Ordering::Relaxed)
    }

    /// All that was named, in that order, without the standard streams.
    pub fn files(&self) -> Vec<NamedFile> {
        let known = self.lock();
        known.files.iter().filter(|file| !file.path.as_os_str().is_empty()).cloned().collect()
    }
}

/// What a task reads that an earlier task of the run makes.
pub const MADE: &str = "the restart of ";

/// Whether a task may read what an earlier one writes: that is its way to go on from there.
fn made_before(first: &NamedFile, second: &NamedFile) -> bool {
    second.how == FileUse::Read
        && second.role.starts_with(MADE)
        && first.how == FileUse::Write
        && first.role.starts_with("the task ")
}

/// The keys of a file; none of a device, which any number may name, and of what cannot be reached. What is
/// read, and there, has no name: another file may have one that differs in case.
fn keys(path: &Path, how: FileUse) -> Option<Vec<Key>> {
    let found = fs::metadata(path).ok();
    let there = found.as_ref().map(|found| there(found, path)).map_or(Some(None), |key| key.map(Some))?;
    if how == FileUse::Read && there.is_some() {
        return Some(there.into_iter().collect());
    }
    let path = resolve(path).unwrap_or_else(|_| path.to_path_buf());
    let name = path.file_name()?.to_str()?.to_lowercase();
    let (place, rest) = place(path.parent()?)?;
    let series = series(&name).map(|series| Key::Member(place.clone(), format!("{rest}/{series}")));
    Some([there, series].into_iter().flatten().chain([Key::Name(place, format!("{rest}/{name}"))]).collect())
}

/// Standard input, if it is a file.
fn standard_input() -> Vec<Key> {
    let path = Path::new("/dev/fd/0");
    fs::metadata(path).ok().and_then(|found| there(&found, path)).into_iter().collect()
}

/// Whether it is a pipe with a name.
fn is_pipe(_found: &Metadata) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        _found.file_type().is_fifo()
    }
    #[cfg(not(unix))]
    {
        false
    }
}

/// The key of what is there; none of a device.
fn there(found: &Metadata, path: &Path) -> Option<Key> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if found.file_type().is_char_device() || found.file_type().is_socket() {
            return None;
        }
    }
    Some(Key::There(identity(found, path)?))
}

#[cfg(unix)]
fn identity(found: &Metadata, _: &Path) -> Option<Place> {
    use std::os::unix::fs::MetadataExt;
    Some((found.dev(), found.ino(), PathBuf::new()))
}

#[cfg(not(unix))]
fn identity(_: &Metadata, path: &Path) -> Option<Place> {
    Some((0, 0, fs::canonicalize(path).ok()?))
}

/// The longest part of a path that is there, and the rest in small letters.
fn place(path: &Path) -> Option<(Place, String)> {
    let mut rest: Vec<String> = Vec::new();
    let mut at = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    loop {
        if let Ok(found) = fs::metadata(at) {
            return Some((identity(&found, at)?, rest.into_iter().rev().collect::<Vec<_>>().join("/")));
        }
        rest.push(at.file_name()?.to_string_lossy().to_lowercase());
        at = at.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    }
}

/// The key of a series in a folder.
fn series_key(folder: &Path, name: &str) -> Option<Key> {
    let (place, rest) = place(folder)?;
    Some(Key::Series(place, format!("{rest}/{name}")))
}

/// The series `stem-#.end` that a file named `STEM-12.END` is of.
fn series(name: &str) -> Option<String> {
    let (stem, end) = name.rsplit_once('.')?;
    let (stem, number) = stem.rsplit_once('-')?;
    let digits = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| format!("{stem}-#.{end}").to_lowercase())
}

/// The files in a folder whose names have a number at the end, by their series.
fn numbered_files(folder: &Path) -> HashMap<String, Vec<PathBuf>> {
    let mut all: HashMap<String, Vec<PathBuf>> = HashMap::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if let Some(name) = entry.file_name().to_str().and_then(series) {
            all.entry(name).or_default().push(entry.path());
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_named_once() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("old"), "old").unwrap();
        fs::write(at("m-7.json"), "old").unwrap();
        fs::hard_link(at("old"), at("hard")).unwrap();
        let clash = |first: (&str, FileUse), second: (&str, FileUse)| {
            let files = FileRegistry::new();
            files.claim("a", &at(first.0), first.1).unwrap();
            let said = files.claim("b", &at(second.0), second.1).err();
            assert_eq!(files.refused(), said.is_some());
            said.is_some()
        };
        use FileUse::{Continue, Read, Write};
        for (first, second) in [("old", "hard"), ("new", "./new"), ("new", "NEW"), ("no/new", "no/./New")] {
            assert!(clash((first, Write), (second, Write)), "{first} {second}");
            assert!(clash((first, Read), (second, Write)), "{first} {second}");
            assert!(clash((first, Continue), (second, Read)), "{first} {second}");
            assert!(!clash((first, Read), (second, Read)), "{first} {second}");
        }
        for (first, second) in
            [("old", "older"), ("new", "newer"), ("no/new", "new"), ("x-1.json", "x-2.json")]
        {
            assert!(!clash((first, Write), (second, Write)), "{first} {second}");
        }
        // A series against its members, those that are there by other names too.
        fs::hard_link(at("m-7.json"), at("seven")).unwrap();
        for name in ["m-7.json", "M-12.json", "seven"] {
            for series_first in [true, false] {
                let files = FileRegistry::new();
                let one = || files.claim("a", &at(name), Read).is_err();
                let all = || files.claim_series("the task m", folder.path(), "m", ".json").is_err();
                let met = if series_first { [all(), one()] } else { [one(), all()] };
                assert_eq!(met, [false, true], "{name}");
            }
        }
        let files = FileRegistry::new();
        files.claim_series("the task m", folder.path(), "m", ".json").unwrap();
        for other in ["m.json", "m-.json", "m-1.csv", "n-1.json"] {
            files.claim("a", &at(other), Write).unwrap();
        }
        assert!(files.named(&at("n-1.json")).is_ok() && files.named(&at("p.json")).is_err());
    }
}
