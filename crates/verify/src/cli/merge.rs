//! `grazing merge`: the shards of one task become what a single run would have written.

use std::{io::Read, path::PathBuf};

use super::{
    Commands, Outcome, ReportFormat, boundary, cover, fuzz, intervals,
    reader::Reader,
    shards::{Merged, ShardSet},
    verify,
};
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    output::FileRegistry,
};
use clap::Parser;

/// Put the shards of one task together. The certificate, report, table or picture is the one that a single
/// run would write, byte for byte, except for times.
///
/// Shards are what `verify`, `cover`, `fuzz`, `boundary`, `intervals` and `run` write with --shard I/N. They
/// must be of one task and one version of the program, and all N of them must be there, each once and
/// undamaged; otherwise every fault is named, and the missing ones are listed as for a job array
/// (--array=3,17-19).
///
/// Whoever computed a shard need not be trusted with a certificate: it is checked again as `grazing check`
/// does. If it is not proved, each shard is checked by itself, those that are false are named and listed, and
/// what stood at -o stays. A disagreement in a shard of `fuzz` is decided again; that there was none is taken
/// from the shard, as are the rows of tables and what a task of a scene came to.
///
/// Exit code 0: done, and proved if it is a certificate; 1: refuted; 2: shards are missing, damaged or of
/// another task, wrong usage, a file that cannot be read or written; 3: undecided or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing verify 3..=40 --shard 1/2 --certificate part-1
  grazing verify 3..=40 --shard 2/2 --certificate part-2
  grazing merge part-1 part-2 -o theorem2.txt")]
pub struct Args {
    /// The shards, in any order; - is standard input.
    #[arg(required_unless_present = "files_from", value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Also those whose names are the lines of this file; - is standard input.
    #[arg(long, value_name = "LIST")]
    files_from: Option<PathBuf>,
    /// Write the certificate, report or table to a file, which appears only when complete; of a scene's task,
    /// the folder for its files.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// How the report is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
}

/// The most bytes of a list of names: a million of more than sixty bytes.
const LONGEST_LIST: u64 = 64 << 20;

/// The names of all shards.
fn files(args: &Args, registry: &FileRegistry, interrupt: &Interrupt) -> Result<Vec<PathBuf>> {
    let mut files = args.files.clone();
    if let Some(list) = &args.files_from {
        registry.read("--files-from", list)?;
        let name = list.display();
        let mut text = String::new();
        let read = Reader::open(list, interrupt)
            .and_then(|list| list.take(LONGEST_LIST + 1).read_to_string(&mut text));
        interrupt.check()?;
        read.map_err(|error| Error::io("read", list, error))?;
        if text.len() as u64 > LONGEST_LIST {
            return Err(Error::input(format!("--files-from {name} has more than {LONGEST_LIST} bytes")));
        }
        files.extend(text.lines().filter(|line| !line.is_empty()).map(PathBuf::from));
        if files.is_empty() {
            return Err(Error::input(format!("--files-from {name}: it names no file")));
        }
    }
    Ok(files)
}

pub(super) fn merge<C: Commands>(
    args: &Args,
    registry: &FileRegistry,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let files = files(args, registry, interrupt)?;
    if files.iter().filter(|file| file.as_os_str() == "-").count() > 1 {
        return Err(Error::input("-: standard input is one shard: give it once"));
    }
    // Tried before the shards are read, which may take long. The files of a scene's task go into a folder.
    files.iter().try_for_each(|file| registry.read("the shard", file))?;
    let destination = match args.output.as_deref() {
        Some(output) if output.is_dir() => None,
        output => Some(registry.destination(output)?),
    };
    let set = ShardSet::read(&files, C::program, interrupt, args.format)?;
    let merged = Merged { output: args.output.as_deref(), destination, format: args.format, files: registry };
    let words = set.words();
    let damaged = |error| set.is_no_task(&error);
    match words.first().map(String::as_str) {
        Some("verify") => {
            verify::merge(&verify::Args::try_parse_from(words).map_err(damaged)?, &set, &merged, interrupt)
        }
        Some("cover") => {
            cover::merge(&cover::Args::try_parse_from(words).map_err(damaged)?, &set, &merged, interrupt)
        }
        Some("fuzz") => {
            fuzz::merge(&fuzz::Args::try_parse_from(words).map_err(damaged)?, &set, &merged, interrupt)
        }
        Some("boundary") => boundary::merge(
            &boundary::Args::try_parse_from(words).map_err(damaged)?,
            &set,
            &merged,
            interrupt,
        ),
        Some("intervals") => intervals::merge(
            &intervals::Args::try_parse_from(words).map_err(damaged)?,
            &set,
            &merged,
            interrupt,
        ),
        _ => C::merge(&set, &merged, interrupt)?.ok_or_else(|| {
            Error::input(format!("the shards are of `grazing {}`, which has none", words.join(" ")))
        }),
    }
}
