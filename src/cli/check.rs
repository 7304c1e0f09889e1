//! `grazing check`: prove certificates again.

use std::{
    fs::File,
    io::{self, BufReader, Read, Write},
    path::{Path, PathBuf},
};

use clap::Parser;
use serde_json::json;

use super::{Outcome, ReportFormat};
use crate::{
    certificate::{self, Checked, Rejection},
    error::{Error, Result},
    output::Destination,
};

/// Prove certificates again, without search, by the trusted checker.
///
/// Exit code 0: every file is proved; 1: some file is malformed or false; 2: some file cannot be read; 3: none of this, but some cover
/// leaves boxes open.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// The certificates; - is standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    format: ReportFormat,
}

pub(super) fn run(args: &Args) -> Result<Outcome> {
    let mut results = Vec::new();
    for path in &args.files {
        results.push((path, check(path)?));
    }
    Destination::Stdout.write(|out| match args.format {
        ReportFormat::Text => results.iter().try_for_each(|(path, result)| text(out, path, result)),
        ReportFormat::Json => {
            let files: Vec<_> = results.iter().map(|(path, result)| json_report(path, result)).collect();
            Ok(writeln!(out, "{}", json!({ "format": "grazing-check 1", "files": files }))?)
        }
    })?;
    let outcomes: Vec<Outcome> = results.iter().map(|(_, result)| outcome(result)).collect();
    let worst = [Outcome::Refuted, Outcome::Undecided].into_iter().find(|one| outcomes.contains(one));
    Ok(worst.unwrap_or(Outcome::Done))
}

fn outcome(result: &std::result::Result<Checked, Rejection>) -> Outcome {
    match result {
        Ok(_) => Outcome::Done,
        Err(Rejection::Undecided { .. }) => Outcome::Undecided,
        Err(_) => Outcome::Refuted,
    }
}

/// The checker's answer; an error if the file cannot be read.
fn check(path: &Path) -> Result<std::result::Result<Checked, Rejection>> {
    let input: Box<dyn Read> = if path == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(path).map_err(|error| Error::io("open", path, error))?)
    };
    match certificate::check(&mut BufReader::with_capacity(1 << 16, input)) {
        Err(Rejection::Unreadable { source, .. }) => Err(Error::io("read", path, source)),
        answer => Ok(answer),
    }
}

fn text(out: &mut dyn Write, path: &Path, result: &std::result::Result<Checked, Rejection>) -> Result<()> {
    match result {
        Ok(checked) => {
            let (first, last) = (checked.range.start(), checked.range.end());
            let detail = checked.detail.iter().map(|detail| format!(": {detail}")).collect::<String>();
            writeln!(out, "{}: proved, {} for n = {first}..={last}{detail}", path.display(), checked.kind)?;
        }
        Err(rejection) if outcome(result) == Outcome::Undecided => {
            writeln!(out, "{}: {rejection}", path.display())?;
        }
        Err(rejection) => writeln!(out, "{}: rejected: {rejection}", path.display())?,
    }
    Ok(())
}

fn json_report(path: &Path, result: &std::result::Result<Checked, Rejection>) -> serde_json::Value {
    match result {
        Ok(checked) => json!({
            "file": path,
            "verdict": "proved",
            "kind": checked.kind,
            "range": [checked.range.start(), checked.range.end()],
            "detail": checked.detail,
            "lines": checked.lines,
            "statement": checked.statement,
        }),
        Err(rejection) => json!({
            "file": path,
            "verdict": if outcome(result) == Outcome::Undecided { "undecided" } else { "rejected" },
            "reason": rejection.to_string(),
        }),
    }
}
