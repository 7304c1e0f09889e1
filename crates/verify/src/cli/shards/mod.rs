//! Shards for every command that has them: writing one, and reading all of a task: whether they belong
//! together, and what is missing.

mod rows;

use std::{
    collections::BTreeMap,
    io::{Read, Write},
    ops::{Range, RangeInclusive},
    path::{Path, PathBuf},
};

use serde::Serialize;

use super::{Outcome, ReportFormat, check, reader::Reader, reported};
use crate::{
    certificate::check_until,
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    monitor::Monitor,
    output::{
        Destination, FileRegistry, OutputFile, Shard, ShardFile, ShardWriter, ShardedTask, TableCell,
        TaskInput, say,
    },
    printable::Printable,
    program,
};

pub(super) use rows::{PlainRows, RowSink, ShardRows};

/// The task that a command's words name, for its shards.
pub(super) fn task_of(words: impl IntoIterator<Item = impl Into<String>>) -> ShardedTask {
    ShardedTask::new(words.into_iter().map(Into::into).collect(), program())
}

/// The periods of a part of a range, each of which costs about n to the power `exponent` operations.
pub(super) fn part_of(range: &RangeInclusive<u64>, exponent: u32, shard: Shard) -> Range<u64> {
    shard.part(*range.start()..*range.end() + 1, exponent)
}

/// The same as a range with both ends, which may be empty; all periods if there are no parts.
pub(super) fn periods_of(
    range: &RangeInclusive<u64>,
    exponent: u32,
    shard: Option<Shard>,
) -> RangeInclusive<u64> {
    match shard.map(|shard| part_of(range, exponent, shard)) {
        // A period is at least 1.
        Some(part) => part.start..=part.end - 1,
        None => range.clone(),
    }
}

/// What a report says at its end of the certificate that was written, or of the shard of one.
pub(super) fn certificate_line(path: &Path, shard: Option<Shard>) -> String {
    let path = path.display().to_string();
    let path = Printable(&path);
    match shard {
        None => format!("Certificate: {path}; `grazing check {path}` proves it again.\n"),
        Some(shard) => {
            format!("Shard {shard} of a certificate: {path}; `grazing merge` puts the shards together.\n")
        }
    }
}

/// A part of a task and the file that it goes to.
pub struct Part {
    pub task: ShardedTask,
    pub shard: Shard,
    pub file: OutputFile,
}

impl Part {
    /// Writes the shard.
    ///
    /// # Errors
    /// An I/O error; whatever `write` returns.
    pub fn write(&self, write: impl FnOnce(&mut ShardWriter<'_>) -> Result<()>) -> Result<()> {
        self.file.write(|out| {
            let mut shard = ShardWriter::new(out, &self.task, self.shard)?;
            write(&mut shard)?;
            shard.finish()
        })
    }
}

/// The format of a report of faults.
const FAULTS: &str = "grazing-merge 1";

/// What keeps shards from being put together.
#[derive(Debug, Default, Serialize)]
struct Faults {
    format: &'static str,
    /// The task that most of them are of: the command's words. None if no file is a whole shard.
    task: Option<String>,
    /// Into how many parts it is divided.
    of: Option<u64>,
    /// The numbers of those that are not there, or are not what they should be.
    missing: Vec<u64>,
    /// The same as a job array is given them.
    array: String,
    /// What is wrong with other files, one text for each.
    faults: Vec<String>,
}

impl Faults {
    /// Reports them, if that is to be JSON; in words they are said as they are found.
    fn tell(&self, format: ReportFormat) -> Result<()> {
        if format != ReportFormat::Json {
            return Ok(());
        }
        let text = serde_json::to_string_pretty(self).map_err(std::io::Error::other)?;
        Destination::Stdout.write(|out| Ok(writeln!(out, "{text}")?))
    }
}

/// The shards of a task in `of` parts, each once, by their numbers; what is wrong with any other goes to
/// `faults`.
fn one_of_each(
    found: Vec<ShardFile>,
    task: &ShardedTask,
    of: u64,
    faults: &mut Vec<String>,
) -> BTreeMap<u64, ShardFile> {
    let mut shards: BTreeMap<u64, ShardFile> = BTreeMap::new();
    for shard in found {
        let path = shard.path.display();
        if (&shard.task.words, shard.shard.of) != (&task.words, of) {
            faults.push(format!(
                "{path}: it is shard {} of `grazing {}`, the others are of {of} of `grazing {}`",
                shard.shard,
                shard.task.words.join(" "),
                task.words.join(" ")
            ));
        } else if shard.task.program != task.program {
            faults.push(format!(
                "{path}: it is by version {}, the others are by {}",
                shard.task.program, task.program
            ));
        } else if shard.task.key() != task.key() {
            let name = |task: &ShardedTask| task.input.as_ref().map(|i| format!("{} {}", i.file, i.hash));
            faults.push(format!(
                "{path}: it is of another content of {}, the others are of {}",
                name(&shard.task).unwrap_or_default(),
                name(task).unwrap_or_default()
            ));
        } else if let Some(other) = shards.get(&shard.shard.index) {
            faults.push(format!(
                "{path}: it is shard {} again, after {}: leave one out",
                shard.shard,
                other.path.display()
            ));
        } else {
            shards.insert(shard.shard.index, shard);
        }
    }
    shards
}

/// The shards of one task, each once, none missing.
pub struct ShardSet {
    task: ShardedTask,
    /// In order.
    shards: Vec<ShardFile>,
}

impl ShardSet {
    /// Reads shards through, which must be by the program that `program` says of their words. What is wrong
    /// with the set, if anything is, is reported before the error.
    ///
    /// # Errors
    /// An input error once every fault was said: a shard that is damaged, of another task or there twice, and
    /// those missing; an interruption.
    pub fn read(
        files: &[PathBuf],
        program: fn(&[String]) -> String,
        interrupt: &Interrupt,
        format: ReportFormat,
    ) -> Result<ShardSet> {
        let progress = Progress::new(interrupt, files.len() as u64, "shards read");
        let mut faults = Vec::new();
        let mut found = Vec::new();
        for file in files {
            match open(file, interrupt) {
                Ok(mut shard) => {
                    share(&mut shard, found.last());
                    found.push(shard);
                }
                Err(error) => faults.push(error.to_string()),
            }
            progress.advance(1)?;
        }
        drop(progress);
        // The task of most files is the one that is meant.
        let mut votes = BTreeMap::new();
        for (index, shard) in found.iter().enumerate() {
            votes.entry((shard.task.key(), shard.shard.of)).or_insert((0, index)).0 += 1;
        }
        let first = votes.into_values().max_by_key(|(count, _)| *count).map(|(_, index)| index);
        let meant = first.map(|index| (found[index].task.clone(), found[index].shard.of));
        let Some((task, of)) = meant else {
            faults.iter().for_each(|fault| say(format_args!("error: {fault}")));
            Faults { format: FAULTS, faults, ..Faults::default() }.tell(format)?;
            return Err(Error::input(
                "none of the files is a whole shard: give those that --shard I/N wrote",
            ));
        };
        let shards = one_of_each(found, &task, of, &mut faults);
        faults.iter().for_each(|fault| say(format_args!("error: {fault}")));
        let missing: Vec<u64> = (1..=of).filter(|index| !shards.contains_key(index)).collect();
        let (lack, array) = (missing.len(), listed(&missing));
        let (wrong, words) = (!faults.is_empty(), Some(task.words.join(" ")));
        if wrong || lack > 0 {
            let array = array.clone();
            Faults { format: FAULTS, task: words, of: Some(of), missing, array, faults }.tell(format)?;
        }
        if lack > 0 {
            return Err(Error::input(format!("{lack} of {of} shards are missing: --array={array}")));
        }
        if wrong {
            return Err(Error::input(
                "all shards are there; leave out the files named above, which are not among them",
            ));
        }
        let own = program(&task.words);
        if task.program != own {
            return Err(Error::input(format!(
                "the shards are by version {}, this is {own}: merge with the version that wrote them",
                task.program
            )));
        }
        Ok(ShardSet { task, shards: shards.into_values().collect() })
    }

    /// What the command works on besides.
    pub fn input(&self) -> Option<&TaskInput> {
        self.task.input.as_ref()
    }

    /// The command and its arguments.
    pub fn words(&self) -> &[String] {
        &self.task.words
    }

    /// What is wrong with shards whose words are no command's.
    pub fn is_no_task(&self, error: &clap::Error) -> Error {
        let (reason, words) = (error.to_string(), self.words().join(" "));
        let reason = reason.lines().next().unwrap_or_default().trim_start_matches("error: ");
        Error::input(format!("the shards are of `grazing {words}`, which is no task: {reason}"))
    }

    /// Whether the shards are of a task as this program writes it: arguments that it would not give a shard
    /// are nobody's.
    ///
    /// # Errors
    /// An input error if not.
    pub fn expect(&self, task: &ShardedTask) -> Result<()> {
        if self.task.key() == task.key() {
            return Ok(());
        }
        let [found, wanted] = [&self.task, task].map(|task| task.words.join(" "));
        Err(Error::input(format!(
            "the shards name the task `grazing {found}`, which --shard writes as `grazing {wanted}`: they were changed"
        )))
    }

    /// Hands on the records of all shards in order, `items` saying which each must have.
    ///
    /// # Errors
    /// An input error if a shard has others; an I/O error; whatever `each` returns.
    pub fn records(
        &self,
        items: impl Fn(Shard) -> Range<u64>,
        mut each: impl FnMut(Shard, &str) -> Result<()>,
    ) -> Result<()> {
        self.shards.iter().try_for_each(|file| {
            let done = file.records(items(file.shard), |_, record| each(file.shard, record));
            done.map_err(|error| {
                if !error.is_input() {
                    return error;
                }
                say(format_args!("error: {error}"));
                Error::input(are_false(1, self.shards.len(), &file.shard.index.to_string()))
            })
        })
    }

    /// The shards whose own certificate is not proved. Cost: that of checking all.
    fn untrue(&self, form: &impl Certified, interrupt: &Interrupt) -> Result<Faults> {
        let (mut missing, mut faults) = (Vec::new(), Vec::new());
        for file in &self.shards {
            let items = form.items(file.shard);
            if items.is_empty() {
                continue;
            }
            let alone = ShardSet { task: self.task.clone(), shards: vec![file.clone()] };
            let mut text = Vec::new();
            form.write(items, &alone, &mut text)?;
            let mut stop = || interrupt.check().is_err();
            if let Err(rejection) = check_until(&mut text.as_slice(), &mut stop) {
                interrupt.check()?;
                faults.push(format!("{}: {}: {rejection}", file.path.display(), rejection.verdict()));
                missing.push(file.shard.index);
            }
        }
        let (task, of) = (Some(self.task.words.join(" ")), Some(self.shards.len() as u64));
        Ok(Faults { format: FAULTS, task, of, array: listed(&missing), missing, faults })
    }

    /// The same for the rows of tables, each with so many cells, where each period is an item.
    ///
    /// # Errors
    /// Those of [`records`](Self::records); an input error for what is no row.
    pub fn rows(
        &self,
        items: impl Fn(Shard) -> Range<u64>,
        columns: usize,
        mut each: impl FnMut(&[TableCell]) -> Result<()>,
    ) -> Result<()> {
        self.records(items, |_, record| rows::rows(record, columns, &mut each))
    }

    /// The same for records that are texts of several lines.
    ///
    /// # Errors
    /// Those of [`records`](Self::records).
    pub fn texts(
        &self,
        items: impl Fn(Shard) -> Range<u64>,
        mut each: impl FnMut(&str) -> Result<()>,
    ) -> Result<()> {
        self.records(items, |_, record| {
            let text: String = serde_json::from_str(record)
                .map_err(|error| Error::input(format!("an item is no text: {error}")))?;
            each(&text)
        })
    }
}

/// Opens a shard; `-` is standard input, which is kept in memory.
fn open(file: &Path, interrupt: &Interrupt) -> Result<ShardFile> {
    if file != Path::new("-") {
        return ShardFile::open(file);
    }
    let mut bytes = Vec::new();
    let read = Reader::open(file, interrupt).and_then(|mut stream| stream.read_to_end(&mut bytes));
    interrupt.check()?;
    read.map_err(|error| Error::io("read", file, error))?;
    ShardFile::of_bytes(file, bytes.into())
}

/// Drops a shard's text of its input if the one before has the same: thousands may hold it, and the first of
/// a task is enough.
fn share(shard: &mut ShardFile, before: Option<&ShardFile>) {
    let known = before.and_then(|before| before.task.input.as_ref()).map(|input| &input.hash);
    if let Some(input) = shard.task.input.as_mut().filter(|input| Some(&input.hash) == known) {
        input.text = String::new();
    }
}

/// "3,17-19".
fn listed(numbers: &[u64]) -> String {
    let mut text = String::new();
    let mut rest = numbers;
    while let Some(&first) = rest.first() {
        let run = rest.iter().zip(first..).take_while(|(number, wanted)| *number == wanted).count();
        let last = rest[run - 1];
        let comma = if text.is_empty() { "" } else { "," };
        text += &if last == first { format!("{comma}{first}") } else { format!("{comma}{first}-{last}") };
        rest = &rest[run..];
    }
    text
}

/// Where what is merged goes, and how it is told.
pub struct Merged<'a> {
    /// As `-o` has it.
    pub output: Option<&'a Path>,
    /// What that is, if it is no folder.
    pub destination: Option<Destination>,
    /// How the report is written.
    pub format: ReportFormat,
    /// The files of the command.
    pub files: &'a FileRegistry,
}

impl Merged<'_> {
    /// Where a table goes, which is in the format that its shards name.
    ///
    /// # Errors
    /// Those of [`report`](Self::report); an input error if another format was asked for.
    pub fn table(&self) -> Result<Destination> {
        if self.format != ReportFormat::Text {
            return Err(Error::input(
                "--format is for reports: a merged table is in the format with which its shards were made",
            ));
        }
        self.report()
    }

    /// Where a report goes.
    ///
    /// # Errors
    /// An input error if that is a folder.
    pub fn report(&self) -> Result<Destination> {
        match &self.destination {
            Some(destination) => Ok(destination.clone()),
            None => self.files.destination(self.output),
        }
    }
}

/// How the blocks of some shards become a certificate.
pub(super) trait Certified {
    /// The items of a shard.
    fn items(&self, shard: Shard) -> Range<u64>;

    /// Writes the certificate of the items in a range, whose blocks `set` has.
    ///
    /// # Errors
    /// An input error if the shards are not as they should be; an I/O error.
    fn write(&self, items: Range<u64>, set: &ShardSet, out: &mut dyn Write) -> Result<()>;
}

/// Writes a merged certificate if it is proved, as `grazing check` does; the report. If it is not, what stood
/// there stays, and the shards that are not proved by themselves are named.
pub(super) fn certify(
    merged: &Merged,
    set: &ShardSet,
    all: Range<u64>,
    form: &impl Certified,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let (Some(Destination::File(file)), Some(path)) = (&merged.destination, merged.output) else {
        return Err(Error::input("these are shards of a certificate: name its file with -o"));
    };
    let mut answer = None;
    let mut judge = |written: &Path| {
        let found = check::check(written, interrupt);
        let kept = found.is_ok().then_some(());
        answer = Some(found);
        Ok(kept)
    };
    if file.is_stream() {
        // What is given to a pipe cannot be taken back: it is proved in a file of its own.
        let mut own = tempfile::NamedTempFile::new()?;
        form.write(all, set, &mut own)?;
        if judge(own.path())?.is_some() {
            let mut own = own.reopen()?;
            file.write(|out| Ok(std::io::copy(&mut own, out).map(drop)?))?;
        }
    } else {
        file.write_proved(|out| form.write(all, set, out), judge)?;
    }
    let Some(answer) = answer else { return Err(Error::input("the certificate was not checked")) };
    let Err(rejection) = &answer else {
        return check::tell(&[(path, answer)], merged.format, &Destination::Stdout);
    };
    let outcome = check::outcome(path, rejection);
    if matches!(outcome, Outcome::Refuted | Outcome::Undecided) {
        let faults = set.untrue(form, interrupt)?;
        faults.faults.iter().for_each(|fault| say(format_args!("error: {fault}")));
        if !faults.missing.is_empty() {
            say(format_args!("error: {}", are_false(faults.missing.len(), set.shards.len(), &faults.array)));
        }
        say(format_args!("note: {} is as it was: what is not proved is not kept", path.display()));
        if merged.format == ReportFormat::Json && !faults.missing.is_empty() {
            return reported(outcome, faults.tell(merged.format));
        }
    }
    check::tell(&[(path, answer)], merged.format, &Destination::Stdout)
}

/// What a script of a cluster looks for.
fn are_false(false_ones: usize, of: usize, array: &str) -> String {
    format!("{false_ones} of {of} shards are false: --array={array}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_shards_read_as_a_job_array() {
        assert_eq!(listed(&[]), "");
        assert_eq!(listed(&[3]), "3");
        assert_eq!(listed(&[3, 17, 18, 19]), "3,17-19");
        assert_eq!(listed(&[1, 2, 4, 6, 7]), "1-2,4,6-7");
    }
}
