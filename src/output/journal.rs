//! An append-only file of finished work, from which an interrupted run goes on.
//!
//! One record a line, led by a checksum; the first line says what the run is. A process killed while it writes leaves at most a
//! torn last line, which is detected and dropped. Damage anywhere else is an error, never skipped.

use std::{
    fs::{File, OpenOptions},
    io::{ErrorKind, Read, Write},
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use crate::error::{Error, Result};

/// A journal open for appending.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    synced: Instant,
}

/// Records given to the system reach the disk at least this often.
const SYNC: Duration = Duration::from_secs(2);

impl Journal {
    /// Opens the journal of a run that `header` describes, or begins one; with the records it holds, in order.
    ///
    /// # Errors
    /// An input error if the file is no journal, is of another run, or is damaged before its last line; an I/O error.
    pub fn open(path: &Path, header: &str) -> Result<(Journal, Vec<String>)> {
        let fail = |action, error| Error::io(action, path, error);
        let mut options = OpenOptions::new();
        let mut file =
            options.read(true).append(true).create(true).open(path).map_err(|error| fail("open", error))?;
        let mut text = Vec::new();
        file.read_to_end(&mut text).map_err(|error| fail("read", error))?;
        let (records, whole) = read(&text, header)
            .map_err(|reason| Error::input(format!("cannot resume from {}: {reason}", path.display())))?;
        file.set_len(whole as u64).map_err(|error| fail("write", error))?;
        let mut journal = Journal { path: path.to_path_buf(), file, synced: Instant::now() };
        if whole == 0 {
            journal.append(header)?;
        }
        Ok((journal, records))
    }

    /// Appends a record of one line. It is with the system when this returns, and so survives the end of this process.
    ///
    /// # Errors
    /// An I/O error.
    pub fn append(&mut self, record: &str) -> Result<()> {
        let mut written = self.file.write_all(line(record).as_bytes());
        if self.synced.elapsed() > SYNC {
            written = written.and_then(|()| self.file.sync_data());
            self.synced = Instant::now();
        }
        // A pipe or a device has nothing to bring to a disk.
        written
            .or_else(|error| if error.kind() == ErrorKind::InvalidInput { Ok(()) } else { Err(error) })
            .map_err(|error| Error::io("write", &self.path, error))
    }
}

fn line(record: &str) -> String {
    format!("{:016x} {record}\n", checksum(record))
}

/// FNV-1a: it is to tell torn lines, not to withstand an adversary; whatever is read from a journal is checked again.
fn checksum(record: &str) -> u64 {
    record
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// The records after the header, and the number of bytes up to the last whole one; or what is wrong.
fn read(text: &[u8], header: &str) -> std::result::Result<(Vec<String>, usize), String> {
    let mut records = Vec::new();
    let mut whole = 0;
    for (index, part) in text.split_inclusive(|&byte| byte == b'\n').enumerate() {
        let end = whole + part.len();
        match record(part) {
            Some(found) if index > 0 => records.push(found.to_string()),
            Some(found) if found == header => {}
            Some(found) => return Err(format!("it is of another run, {found:?}; this one is {header:?}")),
            // Begun, and ended at once.
            None if index == 0 && end == text.len() && line(header).as_bytes().starts_with(part) => break,
            None if index == 0 => return Err("it is not a journal".into()),
            None if end == text.len() => break,
            None => return Err(format!("line {} is damaged", index + 1)),
        }
        whole = end;
    }
    Ok((records, whole))
}

/// The record in a line, if the line is whole.
fn record(part: &[u8]) -> Option<&str> {
    let text = std::str::from_utf8(part).ok()?;
    let found = text.get(17..)?.strip_suffix('\n')?;
    (line(found) == text).then_some(found)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn every_torn_end_is_dropped_and_other_damage_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal");
        let records = ["one 1", "two", "three 3 3"];
        let (mut journal, none) = Journal::open(&path, "a run").unwrap();
        assert!(none.is_empty());
        records.iter().for_each(|record| journal.append(record).unwrap());
        let text = fs::read(&path).unwrap();
        for length in 0..=text.len() {
            fs::write(&path, &text[..length]).unwrap();
            let (mut journal, found) = Journal::open(&path, "a run").unwrap();
            assert_eq!(found, records[..found.len()]);
            let lost = text[..length].split(|&byte| byte == b'\n').count().saturating_sub(2);
            assert_eq!(found.len(), lost, "cut at {length}");
            // What is missing can be appended.
            records[found.len()..].iter().for_each(|record| journal.append(record).unwrap());
            assert_eq!(fs::read(&path).unwrap(), text);
        }
        for at in 0..text.len() {
            let mut damaged = text.clone();
            damaged[at] ^= 1;
            fs::write(&path, &damaged).unwrap();
            match Journal::open(&path, "a run") {
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
        fs::write(&path, &text).unwrap();
        let error = Journal::open(&path, "another").unwrap_err().to_string();
        assert!(error.contains("it is of another run, \"a run\"; this one is \"another\""), "{error}");
        fs::write(&path, "notes").unwrap();
        assert!(Journal::open(&path, "a run").unwrap_err().to_string().contains("it is not a journal"));
        assert_eq!(fs::read(&path).unwrap(), b"notes");
    }
}
