//! `grazing merge`: the shards of one task become what a single run would have written.

use std::path::PathBuf;

use clap::Parser;

use super::{
    Outcome, ReportFormat, cover, fuzz,
    shards::{Merged, ShardSet},
    verify,
};
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    output::{Destination, distinct},
};

/// Put the shards of one task together. The certificate or report is the one that a single run would write,
/// byte for byte, except for times.
///
/// Shards are what `verify`, `cover` and `fuzz` write with --shard I/N. They must be of one task and one
/// version of the program, and all N of them must be there, each once and undamaged; otherwise every fault is
/// named, and the missing ones are listed as for a job array (--array=3,17-19).
///
/// Whoever computed a shard need not be trusted with a certificate: it is checked again as `grazing check`
/// does. A disagreement in a shard of `fuzz` is decided again; that there was none is taken from the shard.
///
/// Exit code 0: done, and proved if it is a certificate; 1: refuted; 2: shards are missing, damaged or of
/// another task, wrong usage, a file that cannot be read or written; 3: undecided or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing verify 3..=40 --shard 1/2 --certificate part-1
  grazing verify 3..=40 --shard 2/2 --certificate part-2
  grazing merge part-1 part-2 -o theorem2.txt")]
pub(super) struct Args {
    /// The shards, in any order.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Write the certificate, or for `fuzz` the report, to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// How the report is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    for file in &args.files {
        if let Some(output) = &args.output {
            distinct(&[("a shard", file.as_path()), ("-o", output.as_path())])?;
        }
    }
    // Tried before the shards are read, which may take long.
    Destination::new(args.output.as_deref())?;
    let set = ShardSet::read(&args.files, interrupt)?;
    let merged = Merged { output: args.output.clone(), format: args.format };
    let words = set.words();
    let damaged = |error: clap::Error| {
        let reason = error.to_string();
        let reason = reason.lines().next().unwrap_or_default().trim_start_matches("error: ");
        Error::input(format!("the shards are of `grazing {}`, which is no task: {reason}", words.join(" ")))
    };
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
        _ => Err(Error::input(format!(
            "the shards are of `grazing {}`, which has none: only verify, cover and fuzz have",
            words.join(" ")
        ))),
    }
}
