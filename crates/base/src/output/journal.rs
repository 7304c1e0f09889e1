//! Saved states: what an interrupted run has done, and from which it goes on. Covers, fuzzing and diagrams
//! keep theirs in this one format.
//!
//! One record per line, led by a checksum of it and of all before it, so that a line changed, lost, doubled
//! or moved is noticed. The first line says what the run is: format, program, a description, and a hash of
//! everything that the records depend on. A process killed while it writes leaves at most a torn last
//! line, which is dropped; damage anywhere else is an error. While a state is in use it is locked against
//! other processes. Whether records make sense is for their reader to check.

use std::{
    fmt,
    fs::{self, File, OpenOptions},
    io::{ErrorKind, Read, Write},
    path::{Path, PathBuf},
    time::Duration,
};

use super::{
    file::{resolve, sync_folder, write_file},
    hash::{fnv64, fnv64_after, fnv128},
    lock::Lock,
};
use crate::{
    error::{Error, Result},
    processor::Stopwatch,
};

/// What a saved state is of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SavedRun {
    kind: &'static str,
    words: String,
    identity: u128,
    program: String,
    anew: &'static str,
}

impl SavedRun {
    /// A run of `grazing KIND` by a [`program`](super::program), with a description on one line, and in
    /// `canonical` everything that the records depend on, written so that equal runs give equal texts.
    pub fn new(kind: &'static str, words: impl Into<String>, canonical: &str, program: String) -> SavedRun {
        let words = words.into().replace('\n', " ");
        let anew = "remove it, or name another file, to start anew";
        SavedRun { kind, words, identity: fnv128(canonical.as_bytes()), program, anew }
    }

    /// The same, with what a user can do where a state cannot be gone on from.
    pub fn anew(self, anew: &'static str) -> SavedRun {
        SavedRun { anew, ..self }
    }

    /// Why a state that begins with `found` is not this run's.
    fn differs(&self, found: &str) -> String {
        let (wanted, anew) = (self.to_string(), self.anew);
        let parts = |header: &str| {
            let (head, rest) = header.split_once(": ")?;
            let (kind, program) = head.split_once(" by ")?;
            Some((program.to_string(), format!("{kind}: {rest}")))
        };
        match (parts(found), parts(&wanted)) {
            (Some((program, found)), Some((_, wanted))) if found == wanted => {
                format!("it was written by version {program}, and this is {}; {anew}", self.program)
            }
            _ => format!("it belongs to another run, {found:?}; this one is {wanted:?}; {anew}"),
        }
    }
}

/// The first line of a state.
impl fmt::Display for SavedRun {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let SavedRun { kind, words, identity, program, .. } = self;
        write!(f, "grazing-state 2 {kind} by {program}: {words}; identity {identity:032x}")
    }
}

/// A saved state, open and locked until dropped.
#[derive(Debug)]
pub struct Journal {
    target: PathBuf,
    header: String,
    file: File,
    /// The checksum of the last line.
    chain: u64,
    /// The bytes of the whole lines.
    whole: u64,
    synced: Stopwatch,
    _lock: Lock,
}

/// What was found in a state.
#[derive(Debug)]
pub struct Found {
    /// The records, in order.
    pub records: Vec<String>,
    /// The bytes of a torn last line, which were dropped.
    pub torn: u64,
}

/// What is to be said of a torn last line.
pub fn torn(path: &Path) -> String {
    format!("{}: dropped the last line, which a sudden end had cut off", path.display())
}

/// Records given to the system reach the disk at least this often.
const SYNC: Duration = Duration::from_secs(2);

impl Journal {
    /// Opens the state of a run, or begins one; with what it holds. A state of more than `most` bytes is
    /// refused.
    ///
    /// # Errors
    /// An input error if another process uses it, or if it is no regular file, too large, no state, of
    /// another run, or damaged before its last line; an I/O error.
    pub fn open(path: &Path, run: &SavedRun, most: u64) -> Result<(Journal, Found)> {
        let bad = |reason: String| Error::input(format!("cannot resume from {}: {reason}", path.display()));
        if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            return Err(bad("it is not a regular file".into()));
        }
        let target = resolve(path).map_err(|error| Error::io("open", path, error))?;
        let lock = Lock::take(&target, &format!("grazing {}", run.kind))?;
        let fail = |action, error| Error::io(action, path, error);
        let mut options = OpenOptions::new();
        let mut file = options
            .read(true)
            .append(true)
            .create(true)
            .open(&target)
            .map_err(|error| fail("open", error))?;
        let mut text = Vec::new();
        (&mut file).take(most + 1).read_to_end(&mut text).map_err(|error| fail("read", error))?;
        if text.len() as u64 > most {
            return Err(bad(format!("it has more than {most} bytes, the most that this run can write")));
        }
        let header = run.to_string();
        let Lines { records, whole, chain } = read(&text, run).map_err(bad)?;
        let mut journal =
            Journal { target, header, file, chain, whole, synced: Stopwatch::start(), _lock: lock };
        if whole < text.len() as u64 {
            journal.file.set_len(whole).map_err(|error| fail("write", error))?;
        }
        if whole == 0 {
            let header = journal.header.clone();
            journal.append(&header)?;
            journal.file.sync_all().map_err(|error| fail("write", error))?;
            sync_folder(&journal.target);
        }
        Ok((journal, Found { records, torn: text.len() as u64 - whole }))
    }

    /// Appends a record of one line. It is with the system when this returns, and so survives the end of this
    /// process.
    ///
    /// # Errors
    /// An I/O error; the state then ends with the record before.
    pub fn append(&mut self, record: &str) -> Result<()> {
        debug_assert!(!record.contains('\n'));
        let (line, chain) = line(if self.whole == 0 { START } else { self.chain }, record);
        let mut written = self.file.write_all(line.as_bytes());
        if written.is_err() {
            // A full disk took a part of the line.
            let _ = self.file.set_len(self.whole);
        } else {
            (self.chain, self.whole) = (chain, self.whole + line.len() as u64);
            if self.synced.elapsed() > SYNC {
                written = self.file.sync_data();
                self.synced = Stopwatch::start();
            }
        }
        written.map_err(|error| Error::io("write", &self.target, error))
    }

    /// Makes this the only record: the file is replaced whole, and on the disk when this returns.
    ///
    /// # Errors
    /// An I/O error; the state then is as it was.
    pub fn replace(&mut self, record: &str) -> Result<()> {
        let (first, chain) = line(START, &self.header);
        let (second, chain) = line(chain, record);
        let text = first + &second;
        write_file(&self.target, |out| Ok(out.write_all(text.as_bytes())?))?;
        let file = OpenOptions::new().read(true).append(true).open(&self.target);
        self.file = file.map_err(|error| Error::io("open", &self.target, error))?;
        (self.chain, self.whole) = (chain, text.len() as u64);
        Ok(())
    }

    /// Removes a state, if there is one.
    ///
    /// # Errors
    /// An input error if another process uses it; an I/O error.
    pub fn discard(path: &Path) -> Result<()> {
        let Ok(target) = fs::canonicalize(path) else { return Ok(()) };
        let _lock = Lock::take(&target, "grazing")?;
        match fs::remove_file(&target) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(Error::io("remove", path, error)),
            _ => Ok(()),
        }
    }

    #[cfg_attr(not(test), allow(dead_code, reason = "commands keep it until their output is whole"))]
    /// Removes the state: its run is done, and nothing is left to go on from.
    ///
    /// # Errors
    /// An I/O error.
    pub(crate) fn remove(self) -> Result<()> {
        fs::remove_file(&self.target).map_err(|error| Error::io("remove", &self.target, error))
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        let _ = self.file.sync_data();
    }
}

/// The checksum before the first line.
const START: u64 = 0;

/// A record's line after a line with the checksum `before`, and its own checksum.
fn line(before: u64, record: &str) -> (String, u64) {
    let chain = fnv64_after(fnv64_after(fnv64(b""), &before.to_le_bytes()), record.as_bytes());
    (format!("{chain:016x} {record}\n"), chain)
}

/// What whole lines hold.
struct Lines {
    records: Vec<String>,
    whole: u64,
    chain: u64,
}

/// The records after the header, the bytes up to the last whole one, and its checksum; or what is wrong.
fn read(text: &[u8], run: &SavedRun) -> std::result::Result<Lines, String> {
    let header = run.to_string();
    let mut found = Lines { records: Vec::new(), whole: 0, chain: START };
    let mut end = 0;
    for (index, part) in text.split_inclusive(|&byte| byte == b'\n').enumerate() {
        end += part.len();
        match record(found.chain, part) {
            Some((record, chain)) => {
                if index > 0 {
                    found.records.push(record.to_string());
                } else if record != header {
                    return Err(run.differs(record));
                }
                (found.whole, found.chain) = (end as u64, chain);
            }
            // Begun, and ended at once.
            None if index == 0
                && end == text.len()
                && line(START, &header).0.as_bytes().starts_with(part) => {}
            None if index == 0 => return Err("it is not a saved state".into()),
            None if end == text.len() => {}
            None => return Err(format!("line {} is damaged; {}", index + 1, run.anew)),
        }
    }
    Ok(found)
}

/// The record in a line and its checksum, if the line is whole.
fn record(before: u64, part: &[u8]) -> Option<(&str, u64)> {
    let text = std::str::from_utf8(part).ok()?;
    let found = text.get(17..)?.strip_suffix('\n')?;
    let (whole, chain) = line(before, found);
    (whole == text).then_some((found, chain))
}

#[cfg(test)]
mod tests {
    const PROGRAM: &str = "0.1.0+abc";
    use std::fs;

    use super::*;

    const MOST: u64 = 1 << 16;

    fn run(words: &str) -> SavedRun {
        SavedRun::new("test", words, words, PROGRAM.into())
    }

    fn open(path: &Path) -> Result<(Journal, Vec<String>)> {
        Journal::open(path, &run("a run"), MOST).map(|(journal, found)| (journal, found.records))
    }

    fn made(path: &Path, records: &[&str]) -> Vec<u8> {
        let (mut journal, none) = open(path).unwrap();
        assert!(none.is_empty());
        records.iter().for_each(|record| journal.append(record).unwrap());
        fs::read(path).unwrap()
    }

    #[test]
    fn every_torn_end_is_dropped_and_other_damage_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal");
        let records = ["one 1", "two", "three 3 3"];
        let text = made(&path, &records);
        for length in 0..=text.len() {
            fs::write(&path, &text[..length]).unwrap();
            let (mut journal, found) = Journal::open(&path, &run("a run"), MOST).unwrap();
            let (found, torn) = (found.records, found.torn as usize);
            assert_eq!(found, records[..found.len()]);
            let lost = text[..length].split(|&byte| byte == b'\n').count().saturating_sub(2);
            assert_eq!(found.len(), lost, "cut at {length}");
            assert_eq!(torn, text[..length].split(|&byte| byte == b'\n').next_back().unwrap().len());
            // What is missing can be appended.
            records[found.len()..].iter().for_each(|record| journal.append(record).unwrap());
            assert_eq!(fs::read(&path).unwrap(), text);
        }
        for at in 0..text.len() {
            for bit in 0..8 {
                let mut damaged = text.clone();
                damaged[at] ^= 1 << bit;
                fs::write(&path, &damaged).unwrap();
                match open(&path) {
                    Err(error) => assert!(error.is_input()),
                    // The last line is taken for torn; without the line feed before it, the last two are one.
                    Ok((_, found)) => {
                        assert!(
                            matches!(found.len(), 1 | 2) && found == records[..found.len()],
                            "changed at {at}"
                        );
                    }
                }
            }
        }
        fs::write(&path, &text).unwrap();
        let error = Journal::open(&path, &run("another"), MOST).unwrap_err().to_string();
        assert!(error.contains("it belongs to another run, \"grazing-state 2 test by "), "{error}");
        assert!(error.contains(": a run; identity ") && error.contains(": another; identity "), "{error}");
        // The same run, by a program from other sources: what to do is said.
        let header = run("a run").to_string().replace(PROGRAM, "0.0.0+0");
        fs::write(&path, line(START, &header).0).unwrap();
        let error = open(&path).unwrap_err().to_string();
        let wanted = format!("it was written by version 0.0.0+0, and this is {PROGRAM}; remove it, or ");
        assert!(error.contains(&wanted), "{error}");
        fs::write(&path, "notes").unwrap();
        assert!(open(&path).unwrap_err().to_string().contains("it is not a saved state"));
        assert_eq!(fs::read(&path).unwrap(), b"notes");
    }

    #[test]
    fn lines_lost_doubled_or_moved_are_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal");
        let text = String::from_utf8(made(&path, &["one", "two", "three", "four"])).unwrap();
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        for i in 1..lines.len() - 1 {
            let mut without = lines.clone();
            without.remove(i);
            let mut doubled = lines.clone();
            doubled.insert(i, lines[i]);
            let mut moved = lines.clone();
            moved.swap(i, i + 1);
            for damaged in [without, doubled, moved] {
                fs::write(&path, damaged.concat()).unwrap();
                match open(&path) {
                    Err(error) => assert!(error.to_string().contains("is damaged"), "{error}"),
                    // Damage that leaves one line after the whole ones cannot be told from a torn one.
                    Ok((_, found)) => assert_eq!(found, ["one", "two", "three"][..found.len()]),
                }
            }
        }
    }

    #[test]
    fn a_replaced_state_holds_its_last_record_and_goes_on() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state");
        let (mut journal, _) = open(&path).unwrap();
        journal.append("one").unwrap();
        journal.replace("two").unwrap();
        journal.replace("three").unwrap();
        journal.append("four").unwrap();
        drop(journal);
        let (journal, found) = open(&path).unwrap();
        assert_eq!(found, ["three", "four"]);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "the state and its lock");
        journal.remove().unwrap();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_state_in_use_says_by_whom_and_one_without_end_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state");
        let (journal, _) = open(&path).unwrap();
        let told = open(&path).unwrap_err().to_string();
        let holder = format!("is in use by process {} (grazing test)", std::process::id());
        assert!(told.ends_with(&holder), "{told}");
        drop(journal);
        fs::write(&path, vec![b'x'; MOST as usize + 1]).unwrap();
        assert!(open(&path).unwrap_err().to_string().contains("more than 65536 bytes"));
        #[cfg(unix)]
        for device in ["/dev/full", "/dev/zero", "/dev/null"] {
            assert!(open(Path::new(device)).unwrap_err().to_string().contains("is not a regular file"));
        }
    }
}
