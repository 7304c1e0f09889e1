//! Shards: one part of a command's work, done apart from the others, in a file that is written once and
//! whole.
//!
//! Lines of text: what the command is, which part this is, one record per item of work, and at the end their
//! number and a checksum of all before it. A shard withstands accidents (cuts, lost lines, exchanged files),
//! not an adversary: what its records claim is for their reader to prove or to decide again.

use std::{
    fmt,
    fs::File,
    io::{BufRead, BufReader, Read, Write},
    ops::Range,
    path::{Path, PathBuf},
    str::FromStr,
    sync::Arc,
};

use serde::{Deserialize, Serialize};
use serde_json::json;

use super::hash::{fnv64, fnv64_after};
use crate::error::{Error, Result};

/// The first words of every shard.
const MAGIC: &str = "grazing-shard 1";

/// The most bytes of a line: the block of a period in a certificate is far shorter.
const LONGEST_LINE: u64 = 256 << 20;

/// The most shards that work is cut into.
const MOST: u64 = 1_000_000;

/// Which part of the work: the `index`-th of `of`, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// From 1 to `of`.
    pub index: u64,
    /// The number of parts.
    pub of: u64,
}

impl FromStr for Shard {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let number = |text: &str| text.parse::<u64>().ok();
        let parts = text.split_once('/').and_then(|(index, of)| Some((number(index)?, number(of)?)));
        let Some((index, of)) = parts else {
            return Err(Error::input(format!("{text:?} is not I/N, as in 3/16")));
        };
        if !(1..=MOST).contains(&of) {
            return Err(Error::input(format!("{of} shards: from 1 to {MOST}")));
        }
        if !(1..=of).contains(&index) {
            return Err(Error::input(format!("shard {index} of {of}: shards are numbered from 1 to {of}")));
        }
        Ok(Shard { index, of })
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

impl Shard {
    /// The items of this part, of those in `all`, each of which costs about as much as its number to the
    /// power `exponent` ≤ 2: parts are contiguous, in order, disjoint, and together all items. With more
    /// parts than items some are empty. Items are below 2³², unless all cost the same. Cost: O(log) of the
    /// number of items.
    pub fn part(self, all: Range<u64>, exponent: u32) -> Range<u64> {
        debug_assert!(exponent == 0 || exponent <= 2 && all.end <= 1 << 32);
        // What the items below n cost, but for a factor: below 2⁹⁶, times `of` below 2¹¹⁶.
        let below = |n: u64| u128::from(n).pow(exponent + 1);
        let of = u128::from(self.of);
        let cut = |index: u64| {
            let goal = below(all.start) * (of - u128::from(index)) + below(all.end) * u128::from(index);
            let (mut low, mut high) = (all.start, all.end);
            while low < high {
                let middle = low + (high - low) / 2;
                if below(middle) * of < goal { low = middle + 1 } else { high = middle }
            }
            low
        };
        cut(self.index - 1)..cut(self.index)
    }
}

/// What a shard is a part of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShardedTask {
    /// The command and its arguments, without those that name files or the shard.
    pub words: Vec<String>,
    /// The program: its version, and hashes of its sources, as in [`program`](super::program).
    pub program: String,
    /// What the command works on besides.
    pub input: Option<TaskInput>,
}

/// A file that a command works on, in the shard so that its parts can be put together without it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TaskInput {
    /// As it was named.
    pub file: String,
    /// A hash of all that the work depends on: the text, and what it names.
    pub hash: String,
    /// Its text.
    pub text: String,
}

impl ShardedTask {
    /// A task of this program.
    pub fn new(words: Vec<String>, program: String) -> Self {
        ShardedTask { words, program, input: None }
    }

    /// What tells tasks apart: what an input is called does not.
    pub fn key(&self) -> (&str, &[String], Option<&str>) {
        (&self.program, &self.words, self.input.as_ref().map(|input| input.hash.as_str()))
    }

    /// The first lines of a shard.
    fn head(&self, shard: Shard) -> String {
        let words = self.words.join(" ");
        let (hash, line) = match &self.input {
            Some(input) => (format!(" {}", input.hash), format!("input {}\n", json!(input))),
            None => Default::default(),
        };
        let task = fnv64(format!("{} {words}{hash}", self.program).as_bytes());
        let program = &self.program;
        format!("{MAGIC}\ncommand {words}\nprogram {program} task {task:016x}\nshard {shard}\n{line}")
    }
}

/// Writes a shard, record by record.
pub struct ShardWriter<'a> {
    out: &'a mut dyn Write,
    hash: u64,
    records: u64,
}

impl<'a> ShardWriter<'a> {
    /// Begins a shard.
    ///
    /// # Errors
    /// An I/O error from `out`.
    pub fn new(out: &'a mut dyn Write, task: &ShardedTask, shard: Shard) -> Result<Self> {
        let mut writer = ShardWriter { out, hash: fnv64(b""), records: 0 };
        writer.put(&task.head(shard))?;
        Ok(writer)
    }

    fn put(&mut self, text: &str) -> Result<()> {
        self.hash = fnv64_after(self.hash, text.as_bytes());
        Ok(self.out.write_all(text.as_bytes())?)
    }

    /// Writes a record of one line.
    ///
    /// # Errors
    /// An I/O error.
    pub fn record(&mut self, item: u64, record: &str) -> Result<()> {
        debug_assert!(!record.contains('\n'));
        self.records += 1;
        self.put(&format!("item {item} {record}\n"))
    }

    /// Ends the shard.
    ///
    /// # Errors
    /// An I/O error.
    pub fn finish(self) -> Result<()> {
        Ok(writeln!(self.out, "end {} {:016x}", self.records, self.hash)?)
    }
}

/// A whole shard, its checksum right: on disk, or what was read of a stream that cannot be read twice.
#[derive(Debug, Clone)]
pub struct ShardFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its bytes, if it is not on disk.
    bytes: Option<Arc<[u8]>>,
    /// What it is a part of.
    pub task: ShardedTask,
    /// Which part.
    pub shard: Shard,
}

impl ShardFile {
    /// Reads a shard through, without keeping its records. Cost: its length in time, its longest record in
    /// memory.
    ///
    /// # Errors
    /// An input error if it is no shard, cut off, or damaged; an I/O error.
    pub fn open(path: &Path) -> Result<ShardFile> {
        Self::read(path, None)
    }

    /// The same of a shard whose bytes are known, from standard input, say; `path` is what it is called.
    ///
    /// # Errors
    /// As of [`open`](Self::open).
    pub fn of_bytes(path: &Path, bytes: Arc<[u8]>) -> Result<ShardFile> {
        Self::read(path, Some(bytes))
    }

    fn read(path: &Path, bytes: Option<Arc<[u8]>>) -> Result<ShardFile> {
        let mut hash = fnv64(b"");
        let mut head = Vec::new();
        let (mut records, mut end) = (0, None);
        lines(path, bytes.as_deref(), |line| {
            if head.is_empty() && line != format!("{MAGIC}\n") {
                return Err(match line.strip_suffix("\r\n") {
                    Some(MAGIC) => {
                        "its lines end with CR LF: it was changed on its way here; copy it as it is"
                    }
                    _ => "it is not a shard: `--shard I/N` writes them",
                }
                .into());
            }
            if end.is_some() {
                return Err("it is damaged: lines follow its end".into());
            }
            if let Some(last) = line.strip_prefix("end ") {
                end = Some(last == format!("{records} {hash:016x}\n"));
                return Ok(());
            }
            hash = fnv64_after(hash, line.as_bytes());
            if head.len() < 4 || head.len() == 4 && records == 0 && line.starts_with("input ") {
                head.push(line.trim_end_matches('\n').to_string());
            } else {
                records += 1;
            }
            Ok(())
        })?;
        let bad = |reason: &str| Error::input(format!("{}: {reason}", path.display()));
        match end {
            None if head.is_empty() => return Err(bad("it is empty")),
            None => return Err(bad("it is cut off")),
            Some(false) => return Err(bad("it is damaged: its checksum does not match")),
            Some(true) => {}
        }
        let field = |index: usize, name: &str| {
            head.get(index)?.strip_prefix(name).map(|text: &str| text.trim().to_string())
        };
        let read = || {
            let words = field(1, "command ")?.split(' ').map(str::to_string).collect();
            let program = field(2, "program ")?.split_once(" task ")?.0.to_string();
            let input = head.get(4).map(|_| field(4, "input ")).map(|text| serde_json::from_str(&text?).ok());
            let input = match input {
                Some(input) => Some(input?),
                None => None,
            };
            let task = ShardedTask { words, program, input };
            let shard = field(3, "shard ")?.parse().ok()?;
            (task.head(shard) == head.iter().map(|line| format!("{line}\n")).collect::<String>())
                .then_some((task, shard))
        };
        let (task, shard) = read().ok_or_else(|| bad("its first lines are not those of a shard"))?;
        Ok(ShardFile { path: path.to_path_buf(), bytes, task, shard })
    }

    /// Hands on its records in order, of which there must be one for each of `items`.
    ///
    /// # Errors
    /// An input error if its items are others; an I/O error; whatever `each` returns.
    pub fn records(&self, items: Range<u64>, mut each: impl FnMut(u64, &str) -> Result<()>) -> Result<()> {
        let mut wanted = items.clone();
        let mut failed = None;
        let found = lines(&self.path, self.bytes.as_deref(), |line| {
            let Some((item, record)) = line.strip_prefix("item ").and_then(|line| line.split_once(' '))
            else {
                return Ok(());
            };
            match wanted.next() {
                Some(next) if item == next.to_string() => {
                    each(next, record.trim_end_matches('\n')).map_err(|error| {
                        failed = Some(error);
                        String::new()
                    })
                }
                _ => Err(format!("it is damaged: item {item} is out of order or not of this part")),
            }
        });
        match failed {
            Some(error) => Err(error.context(self.path.display())),
            None => found,
        }?;
        match wanted.next() {
            Some(missing) => Err(Error::input(format!("{}: it lacks item {missing}", self.path.display()))),
            None => Ok(()),
        }
    }
}

/// A regular file, to be read.
fn opened(path: &Path) -> Result<impl BufRead> {
    let file = File::open(path).map_err(|error| Error::io("open", path, error))?;
    if !file.metadata().map_err(|error| Error::io("read", path, error))?.is_file() {
        return Err(Error::input(format!("{}: it is not a regular file", path.display())));
    }
    Ok(BufReader::with_capacity(1 << 16, file))
}

/// Hands on the lines of a file, or of its bytes if they are known, each with its line feed if it has one.
fn lines(
    path: &Path,
    bytes: Option<&[u8]>,
    mut each: impl FnMut(&str) -> std::result::Result<(), String>,
) -> Result<()> {
    let fail = |error| Error::io("read", path, error);
    let mut reader: Box<dyn BufRead + '_> = match bytes {
        Some(bytes) => Box::new(bytes),
        None => Box::new(opened(path)?),
    };
    let mut line = Vec::new();
    loop {
        line.clear();
        if (&mut reader).take(LONGEST_LINE + 1).read_until(b'\n', &mut line).map_err(fail)? == 0 {
            return Ok(());
        }
        if line.len() as u64 > LONGEST_LINE {
            let path = path.display();
            return Err(Error::input(format!("{path}: it has a line of more than {LONGEST_LINE} bytes")));
        }
        let text = std::str::from_utf8(&line).map_err(|_| "it is damaged: it is not text".to_string());
        text.and_then(&mut each).map_err(|reason| Error::input(format!("{}: {reason}", path.display())))?;
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn task() -> ShardedTask {
        ShardedTask::new(["verify", "3..=9"].map(String::from).to_vec(), "0.1.0+abc".into())
    }

    fn written(records: &[(u64, &str)]) -> Vec<u8> {
        let mut text = Vec::new();
        let mut writer = ShardWriter::new(&mut text, &task(), Shard { index: 2, of: 3 }).unwrap();
        records.iter().for_each(|(item, record)| writer.record(*item, record).unwrap());
        writer.finish().unwrap();
        text
    }

    /// Parts are all items, in order and once, whatever the weights and however many parts.
    #[test]
    fn parts_are_a_partition() {
        for all in [0..0, 0..1, 3..501, 5..6, 1_000_000..1_000_007, 0..u64::MAX] {
            for of in [1, 2, 3, 16, 1000] {
                for exponent in 0..if all.end > 1 << 32 { 1 } else { 3 } {
                    let mut next = all.start;
                    for index in 1..=of {
                        let part = Shard { index, of }.part(all.clone(), exponent);
                        assert_eq!(part.start, next, "{all:?} {index}/{of}");
                        assert!(part.end >= part.start);
                        next = part.end;
                    }
                    assert_eq!(next, all.end);
                }
            }
        }
        // Weighted parts cost alike.
        let cost = |part: Range<u64>| part.map(|n| (n * n) as f64).sum::<f64>();
        let costs: Vec<f64> = (1..=8).map(|index| cost(Shard { index, of: 8 }.part(3..501, 2))).collect();
        let (least, most) = costs.iter().fold((f64::MAX, 0.0f64), |(a, b), &x| (a.min(x), b.max(x)));
        assert!(most < 1.1 * least, "{costs:?}");
    }

    #[test]
    fn every_cut_and_every_changed_byte_is_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("shard");
        let text = written(&[(5, "one"), (6, "two words"), (7, "")]);
        fs::write(&path, &text).unwrap();
        let shard = ShardFile::open(&path).unwrap();
        assert_eq!((&shard.task, shard.shard), (&task(), Shard { index: 2, of: 3 }));
        let mut seen = Vec::new();
        let keep = |item, record: &str| {
            seen.push(format!("{item}:{record}"));
            Ok(())
        };
        shard.records(5..8, keep).unwrap();
        assert_eq!(seen, ["5:one", "6:two words", "7:"]);
        for items in [5..7, 5..9, 4..7, 6..8] {
            assert!(shard.records(items.clone(), |_, _| Ok(())).unwrap_err().is_input(), "{items:?}");
        }
        for length in 0..text.len() {
            fs::write(&path, &text[..length]).unwrap();
            assert!(ShardFile::open(&path).unwrap_err().is_input(), "cut at {length}");
        }
        for at in 0..text.len() {
            for bit in 0..8 {
                let mut damaged = text.clone();
                damaged[at] ^= 1 << bit;
                fs::write(&path, &damaged).unwrap();
                assert!(ShardFile::open(&path).unwrap_err().is_input(), "byte {at}");
            }
        }
        fs::write(&path, [text.clone(), b"item 8 more\n".to_vec()].concat()).unwrap();
        assert!(ShardFile::open(&path).unwrap_err().to_string().contains("lines follow its end"));
        assert!(ShardFile::open(folder.path()).unwrap_err().to_string().contains("not a regular file"));
    }

    #[test]
    fn shards_are_numbered_from_one() {
        assert_eq!("3/16".parse::<Shard>().unwrap(), Shard { index: 3, of: 16 });
        for wrong in ["", "3", "0/4", "5/4", "1/0", "-1/4", "1/2/3", "1/1000001", " 1/2"] {
            assert!(wrong.parse::<Shard>().unwrap_err().is_input(), "{wrong}");
        }
    }
}
