//! `grazing check`: prove certificates again.

use std::{
    io::{BufReader, Write},
    path::{Path, PathBuf},
};

use clap::Parser;
use serde::Serialize;
use serde_json::json;

use super::{Outcome, ReportFormat, progress::Interrupt, reader::Reader, reported};
use crate::{
    certificate::{Checked, Hashed, Rejection, check_until},
    error::Result,
    output::{Destination, FileRegistry, say, say_to},
    printable::Printable,
    search::Claimed,
};

/// Prove certificates again, without search, by the trusted checker.
///
/// Every file gets a verdict. The command grazing-check (cargo install --path crates/checker) is this checker
/// alone.
///
/// Exit code 0: every file is proved; 1: some file is malformed or false; else 2: some file cannot be read;
/// else 3: some cover leaves boxes open, or the work was interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing check theorem2.txt covers.txt
  grazing check - <theorem2.txt")]
pub struct Args {
    /// The certificates; - is standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
    /// Write the result to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The checker's answer for a file.
pub(super) type Answer = std::result::Result<Checked, Rejection>;

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    for file in &args.files {
        files.read("the certificate", file)?;
    }
    let destination = files.destination(args.output.as_deref())?;
    let answers: Vec<(&Path, Answer)> =
        args.files.iter().map(|path| (path.as_path(), check(path, interrupt))).collect();
    tell(&answers, args.format, &destination)
}

/// Reports answers.
pub(super) fn tell(
    answers: &[(&Path, Answer)],
    format: ReportFormat,
    destination: &Destination,
) -> Result<Outcome> {
    let written = destination.write(|out| match format {
        ReportFormat::Text => answers.iter().try_for_each(|(path, answer)| text(out, path, answer)),
        ReportFormat::Json => {
            let files: Vec<_> = answers.iter().map(|(path, answer)| FileReport::of(path, answer)).collect();
            Ok(writeln!(out, "{}", json!({ "format": "grazing-check 2", "files": files }))?)
        }
    });
    let outcomes = answers.iter().map(|(path, answer)| match answer {
        Ok(_) => Outcome::Done,
        Err(rejection) => outcome(path, rejection),
    });
    reported(outcomes.collect(), written)
}

/// What a rejection is to the command; a file that cannot be read is said.
pub(super) fn outcome(path: &Path, rejection: &Rejection) -> Outcome {
    match rejection {
        Rejection::Unreadable { line, source } => {
            let action = if *line == 0 { "open" } else { "read" };
            say(format_args!("error: cannot {action} {}: {source}", path.display()));
            Outcome::Failed
        }
        Rejection::Interrupted { .. } => Outcome::Interrupted,
        Rejection::Undecided { .. } => Outcome::Undecided,
        _ => Outcome::Refuted,
    }
}

pub(super) fn check(path: &Path, interrupt: &Interrupt) -> Answer {
    read(path, interrupt, |stream, stop| check_until(stream, stop))
}

/// What a certificate proves, and the SHA-256 of the bytes that were checked: the file's, since the checker
/// reads to its end. A file that changes meanwhile is not cited by the wrong name.
pub(super) fn hashed(
    path: &Path,
    interrupt: &Interrupt,
) -> std::result::Result<(Checked, String), Rejection> {
    read(path, interrupt, |stream, stop| {
        let mut hashed = Hashed::new(stream);
        let checked = check_until(&mut BufReader::with_capacity(1 << 16, &mut hashed), stop)?;
        Ok((checked, hashed.finish()))
    })
}

/// What `check` says of a file, ended early when the user wants it.
fn read<T>(
    path: &Path,
    interrupt: &Interrupt,
    check: impl FnOnce(&mut Reader, &mut dyn FnMut() -> bool) -> std::result::Result<T, Rejection>,
) -> std::result::Result<T, Rejection> {
    let mut stop = || interrupt.check().is_err();
    if stop() {
        return Err(Rejection::Interrupted { line: 1 });
    }
    match Reader::open(path, interrupt) {
        Ok(mut stream) => check(&mut stream, &mut stop),
        Err(_) if stop() => Err(Rejection::Interrupted { line: 1 }),
        Err(source) => Err(Rejection::Unreadable { line: 0, source }),
    }
}

fn text(out: &mut dyn Write, path: &Path, answer: &Answer) -> Result<()> {
    match answer {
        // Each line of it is made printable by itself, and the file's name cannot break one.
        Ok(checked) => format!("{}: {checked}", Printable(&path.display().to_string()))
            .lines()
            .try_for_each(|line| say_to(out, line)),
        Err(rejection) => {
            say_to(out, format_args!("{}: {}: {rejection}", path.display(), rejection.verdict()))
        }
    }
}

/// What `--format json` says of one file.
#[derive(Serialize)]
#[serde(untagged)]
enum FileReport<'a> {
    Proved {
        file: &'a Path,
        verdict: &'static str,
        #[serde(flatten)]
        claim: Claimed<'a>,
        lines: u64,
        statement: &'a str,
    },
    Refused {
        file: &'a Path,
        verdict: &'static str,
        reason: String,
    },
}

impl FileReport<'_> {
    fn of<'a>(file: &'a Path, answer: &'a Answer) -> FileReport<'a> {
        match answer {
            Ok(checked) => FileReport::Proved {
                file,
                verdict: "proved",
                claim: Claimed::of(checked),
                lines: checked.lines,
                statement: checked.statement,
            },
            Err(rejection) => {
                FileReport::Refused { file, verdict: rejection.verdict(), reason: rejection.to_string() }
            }
        }
    }
}
