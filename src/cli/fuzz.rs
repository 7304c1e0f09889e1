//! `grazing fuzz`: look for a counterexample to Conjecture 1.

use std::{
    fs::{self, OpenOptions},
    io::Write,
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use clap::Parser;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::{Outcome, ReportFormat, in_pool, range::Periods};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    number::parse_integer,
    output::{Destination, write_file},
    search::fuzz::{Case, Options, Tally, fuzz},
};

/// Fuzz Conjecture 1: decide existence at random points by its definition and by the claim, and compare.
///
/// Most cases come from sweeps: (r, s) uniform, all n up to N in one pass. The others are drawn near the places where
/// something could fail: r = 1, boundary curves, the ends of intervals, equal eigenvalues, gcd(m, n) > 1, real
/// eigenvalues of every kind. A disagreement is decided again, shrunk, printed with a command that shows it, and
/// appended to a file that the tests replay. The same seed gives the same run whatever the number of threads.
///
/// Exit code 0: no disagreement, which is no proof; 1: a confirmed disagreement; 2: wrong usage or a file that cannot be
/// read or written; 3: some case is undecided.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// The periods: N, or A..=B with 3 <= B <= 4096.
    #[arg(long, value_name = "N|A..=B", default_value = "1..=64")]
    n: Periods,
    /// End after this many cases (1e9 is allowed).
    #[arg(long, value_name = "N", default_value = "1e7", value_parser = parse_integer::<u64>)]
    cases: u64,
    /// The seed.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// The number of threads; default: one for each core.
    #[arg(long, value_name = "J", default_value_t = 0, hide_default_value = true)]
    jobs: usize,
    /// The share of sweep points at which one period is decided by the definition, k by k, as well.
    #[arg(long, value_name = "F", default_value_t = 0.01)]
    definition_share: f64,
    /// Where disagreements are appended; the tests replay those in tests/data/fuzz_regressions.txt.
    #[arg(long, value_name = "FILE", default_value = "fuzz-regressions.txt")]
    regressions: PathBuf,
    /// Go on from this state file if it exists, and keep it up to date.
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    format: ReportFormat,
}

/// The state file.
#[derive(Serialize, Deserialize)]
struct State {
    format: String,
    options: Options,
    tally: Tally,
}

const STATE: &str = "grazing-fuzz-state 1";

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    if !(0.0..=1.0).contains(&args.definition_share) {
        return Err(Error::input(format!(
            "--definition-share {}: a number from 0 to 1",
            args.definition_share
        )));
    }
    let options = Options {
        first: *args.n.0.start(),
        last: *args.n.0.end(),
        cases: args.cases,
        seed: args.seed,
        definition_share: args.definition_share,
    };
    let start = match &args.resume {
        Some(path) if path.exists() => read_state(path, &options)?,
        _ => Tally::default(),
    };
    let before = start.decided();
    let clock = Instant::now();
    let progress = Progress::new(interrupt, options.cases.saturating_sub(before), "cases");
    let mut saved = Instant::now();
    let tally = in_pool(args.jobs, || {
        fuzz(&options, start, &progress, |tally| match &args.resume {
            Some(path) if saved.elapsed() > Duration::from_secs(2) => {
                saved = Instant::now();
                save_state(path, &options, tally)
            }
            _ => Ok(()),
        })
    })?;
    drop(progress);
    if let Some(path) = &args.resume {
        save_state(path, &options, &tally)?;
    }
    if !tally.disagreements.is_empty() {
        append(&args.regressions, &tally.disagreements)?;
    }
    let rate = (tally.decided() - before) as f64 / clock.elapsed().as_secs_f64();
    Destination::Stdout.write(|out| match args.format {
        ReportFormat::Text => text(out, args, &tally, rate),
        ReportFormat::Json => {
            let report = json!({ "format": "grazing-fuzz 1", "options": options, "tally": tally });
            Ok(writeln!(out, "{report}")?)
        }
    })?;
    Ok(match (&tally.disagreements[..], tally.undecided) {
        ([], 0) => Outcome::Done,
        ([], _) => Outcome::Undecided,
        _ => Outcome::Refuted,
    })
}

fn read_state(path: &Path, options: &Options) -> Result<Tally> {
    let text = fs::read_to_string(path).map_err(|error| Error::io("read", path, error))?;
    let state: State = serde_json::from_str(&text).map_err(|error| {
        Error::input(format!("{} is not a state of `grazing fuzz`: {error}", path.display()))
    })?;
    if state.format != STATE {
        return Err(Error::input(format!("{}: expected the format {STATE:?}", path.display())));
    }
    let same = Options { cases: options.cases, ..state.options.clone() };
    if same != *options {
        return Err(Error::input(format!(
            "{} is of another run: its options are --n {}..={} --seed {} --definition-share {}",
            path.display(),
            state.options.first,
            state.options.last,
            state.options.seed,
            state.options.definition_share
        )));
    }
    Ok(state.tally)
}

fn save_state(path: &Path, options: &Options, tally: &Tally) -> Result<()> {
    let state = State { format: STATE.into(), options: options.clone(), tally: tally.clone() };
    write_file(path, |out| Ok(writeln!(out, "{}", json!(state))?))
}

fn append(path: &Path, lines: &[String]) -> Result<()> {
    let mut file = OpenOptions::new().create(true).append(true).open(path);
    for line in lines {
        file = file.and_then(|mut file| writeln!(file, "{line}").map(|()| file));
    }
    file.map(drop).map_err(|error| Error::io("append to", path, error))
}

fn text(out: &mut dyn Write, args: &Args, tally: &Tally, rate: f64) -> Result<()> {
    let verdict = if tally.disagreements.is_empty() {
        "No disagreement found. This is no proof."
    } else {
        "Refuted: the definition and the claim disagree."
    };
    writeln!(out, "{verdict}")?;
    let rows = [
        (tally.decided(), "cases (n, point) decided both ways, of which"),
        (tally.swept, "by f64 with proved bounds, in sweeps over all n"),
        (tally.interval, "by f64 intervals"),
        (tally.ball, "by multi-precision balls"),
        (tally.exact, "by integers alone"),
        (tally.boundary, "on a boundary, where nothing is claimed"),
        (tally.undecided, "undecided, and not counted above"),
        (tally.weighted, "weighted cases, near the places where something could fail"),
        (tally.repeated, "sweep results decided again by the definition, k by k"),
    ];
    for (count, what) in rows {
        writeln!(out, "{count:>14}  {what}")?;
    }
    // Times differ from run to run, so they do not belong to the result.
    let sweeps = (tally.decided() - tally.weighted.min(tally.decided())) as f64 / tally.sweep_seconds;
    let weighted = tally.weighted as f64 / tally.weighted_seconds;
    eprintln!("{rate:.3e} cases a second; on one core {sweeps:.3e} in sweeps, {weighted:.3e} weighted");
    for line in &tally.disagreements {
        let case: Case = line.parse()?;
        writeln!(out, "{line}\n  shown by: grazing classify {}", case.arguments())?;
    }
    if !tally.disagreements.is_empty() {
        writeln!(out, "appended to {}", args.regressions.display())?;
    }
    Ok(())
}
