//! `grazing fuzz`: look for a counterexample to Conjecture 1, or with --words to the word theorem.

mod conjecture;
mod words;

use std::{
    fs::{self, OpenOptions},
    io::Write,
    ops::Range,
    path::{Path, PathBuf},
    str::FromStr,
    time::{Duration, Instant},
};

use clap::Parser;
use serde_json::{Value, json};

use super::{
    Outcome, ReportFormat, in_pool,
    range::{Periods, share},
    reported,
    shards::{Merged, Part, ShardSet, task_of},
};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    number::parse_integer,
    output::{Destination, FileRegistry, Journal, SavedRun, Shard, say, say_to, torn},
    program,
    search::fuzz::{Campaign, FuzzOptions, Tally, fuzz, words::WordOptions},
};

/// Fuzz Conjecture 1: decide existence at random points by its definition and by the claim, and compare.
///
/// Most cases come from sweeps: (r, s) uniform, with all n up to N in one pass. The others are drawn near the
/// places where something could fail: r = 1, boundary curves, the ends of intervals, equal eigenvalues,
/// gcd(m, n) > 1, real eigenvalues of every kind. A disagreement is decided again, shrunk, printed with a
/// command that shows it, and appended to a file that the tests replay. The same seed gives the same run,
/// whatever the number of threads.
///
/// With --words it fuzzes the word theorem, which `grazing word` uses. At each point it compares every period
/// up to N, and which may follow which, by the definition and by the word; a case is then a point. It also
/// compares the entropies of random words on r = 1 with their supremum, which `verify --entropy` proves.
///
/// Exit code 0: no disagreement, which proves nothing; 1: a confirmed disagreement, or an error of this
/// program (two of its routes to one answer differ; the point is shown); 2: wrong usage or a file that cannot
/// be read or written; 3: some case is undecided, or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing fuzz --cases 1e5
  grazing fuzz --cases 1e5 --resume fuzz.journal --format json")]
pub struct Args {
    /// Fuzz the word theorem.
    #[arg(long)]
    words: bool,
    /// The periods: N, or A..=B with 3 <= B <= 4096; with --words 1..=B, B <= 1024.
    #[arg(value_name = "N|A..=B", default_value = "1..=64")]
    n: Periods,
    /// As it was written once.
    #[arg(long = "n", hide = true, conflicts_with = "n", value_name = "N|A..=B")]
    long_n: Option<Periods>,
    /// How many cases, rounded up to whole blocks (1e9 is allowed).
    #[arg(long, value_name = "N", default_value = "1e7", value_parser = parse_integer::<u64>)]
    cases: u64,
    /// The seed.
    #[arg(long, value_name = "S", default_value_t = 1, value_parser = parse_integer::<u64>)]
    seed: u64,
    /// The number of threads; default: one for each core.
    #[arg(long, value_name = "J", default_value_t = 0, hide_default_value = true, value_parser = parse_integer::<usize>)]
    jobs: usize,
    /// The share of sweep points at which one period is also decided by the definition, k by k; by default
    /// 0.01. With --words, the share of points at which everything is decided exactly; by default 0.00001.
    #[arg(long, value_name = "F", value_parser = share)]
    definition_share: Option<f64>,
    /// Where disagreements are appended; the tests replay those in tests/data/fuzz_regressions.txt.
    #[arg(long, value_name = "FILE", default_value = "fuzz-regressions.txt")]
    regressions: PathBuf,
    /// Continue from this state file if it exists, and keep it up to date.
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Do the I-th of N parts only, and write a shard of the result to -o, for `grazing merge`.
    #[arg(long, value_name = "I/N", requires = "output", value_parser = Shard::from_str)]
    shard: Option<Shard>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
    /// Write the result to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// How a campaign is told.
trait Told: Campaign {
    /// What is counted.
    const UNIT: &'static str;
    /// The verdict of a disagreement.
    const REFUTED: &'static str;

    /// The arguments that a saved state belongs to.
    fn arguments(&self) -> String;

    /// What JSON has beside the options and the tally.
    fn more(&self) -> Vec<(&'static str, Value)> {
        Vec::new()
    }

    /// Rates per second of processor time, in words; none where the system does not tell.
    fn rates(&self, tally: &Self::Tally) -> Option<String>;

    /// The counts of a report.
    fn rows(&self, tally: &Self::Tally) -> Vec<(u64, &'static str)>;

    /// What else the tally says, line by line.
    fn remarks(&self, _: &Self::Tally) -> Vec<String> {
        Vec::new()
    }

    /// The commands that show a disagreement.
    fn shown_by(&self, line: &str) -> Result<String>;
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    match options(args)? {
        Options::Conjecture(options) => campaign(args, &options, files, interrupt),
        Options::Words(options) => campaign(args, &options, files, interrupt),
    }
}

/// The report of a campaign from its shards.
pub(super) fn merge(args: &Args, set: &ShardSet, merged: &Merged, interrupt: &Interrupt) -> Result<Outcome> {
    match options(args)? {
        Options::Conjecture(options) => merged_campaign(args, &options, set, merged, interrupt),
        Options::Words(options) => merged_campaign(args, &options, set, merged, interrupt),
    }
}

/// What is fuzzed.
enum Options {
    Conjecture(FuzzOptions),
    Words(WordOptions),
}

fn options(args: &Args) -> Result<Options> {
    let periods = &args.long_n.as_ref().unwrap_or(&args.n).0;
    let (first, last) = (*periods.start(), *periods.end());
    let (cases, seed) = (args.cases, args.seed);
    let definition_share = args.definition_share.unwrap_or(if args.words { 1e-5 } else { 0.01 });
    if cases == 0 {
        return Err(Error::input("--cases 0: give at least 1"));
    }
    if !args.words {
        return Ok(Options::Conjecture(FuzzOptions { first, last, cases, seed, definition_share }));
    }
    if first != 1 {
        return Err(Error::input(format!("--words compares every period up to N: write 1..={last}")));
    }
    Ok(Options::Words(WordOptions { last, cases, seed, definition_share }))
}

/// What shards of a campaign are parts of.
fn words<C: Told>(options: &C) -> Vec<String> {
    let arguments = format!("fuzz {} --cases {}", options.arguments(), options.cases());
    arguments.split(' ').map(str::to_string).collect()
}

/// The units of a part, each of which costs the same.
fn units<C: Campaign>(options: &C, shard: Option<Shard>) -> Range<u64> {
    match shard {
        Some(shard) => shard.part(0..options.units(), 0),
        None => 0..options.units(),
    }
}

/// The one record of a shard, if it has any unit: its number is that of its first unit.
fn record_of(units: &Range<u64>) -> Range<u64> {
    units.start..units.start + units.end.saturating_sub(units.start).min(1)
}

/// Runs a campaign, or a part, from its saved state on, and reports.
fn campaign<C: Told>(
    args: &Args,
    options: &C,
    files: &FileRegistry,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    files.go_on("--regressions", &args.regressions)?;
    args.resume.as_deref().map(|path| files.go_on("--resume", path)).transpose()?;
    options.check_range()?;
    let part = match (args.shard, &args.output) {
        (Some(shard), Some(file)) => {
            Some(Part { task: task_of(words(options)), shard, file: files.write("-o", file)? })
        }
        _ => None,
    };
    let destination = match part {
        Some(_) => Destination::Stdout,
        None => files.destination(args.output.as_deref())?,
    };
    let units = units(options, args.shard);
    let (mut state, start) = match &args.resume {
        Some(path) => {
            let (state, start) = open(path, options, args.shard)?;
            interrupt.keeps(format!(
                "what was counted is kept in {0}: continue with --resume {0}",
                path.display()
            ));
            (Some(state), start)
        }
        None => (None, C::Tally::default()),
    };
    let before = start.decided();
    let clock = Instant::now();
    let left = (units.end - units.start).saturating_sub(start.units());
    let progress = Progress::new(interrupt, left.saturating_mul(options.block()), C::UNIT);
    let mut saved = Instant::now();
    let tally = in_pool(args.jobs, || {
        fuzz(options, units.clone(), start, &progress, |tally| match &mut state {
            Some(state) if saved.elapsed() > PAUSE => {
                saved = Instant::now();
                state.replace(&json!(tally).to_string())
            }
            _ => Ok(()),
        })
    })?;
    drop(progress);
    if let Some(state) = &mut state {
        state.replace(&json!(tally).to_string())?;
    }
    let outcome = outcome(&tally, &units);
    if args.format == ReportFormat::Text {
        // Times differ from run to run, so they do not belong to the result.
        let rate = (tally.decided() - before) as f64 / clock.elapsed().as_secs_f64();
        let rates = options.rates(&tally).map(|rates| format!("; per second of processor time {rates}"));
        say(format_args!("{rate:.3e} {} per second{}", C::UNIT, rates.unwrap_or_default()));
    }
    if let (Some(part), false) = (&part, outcome == Outcome::Interrupted) {
        // A disagreement ends a part early; the shard says so by having it.
        part.write(|out| record_of(&units).try_for_each(|item| out.record(item, &json!(tally).to_string())))?;
    }
    tell(args, options, (&tally, outcome), args.format, &destination)
}

/// The tallies of shards, put together in their order.
fn merged_campaign<C: Told>(
    args: &Args,
    options: &C,
    set: &ShardSet,
    merged: &Merged,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    options.check_range()?;
    merged.files.go_on("--regressions", &args.regressions)?;
    set.expect(&task_of(words(options)))?;
    let mut all = C::Tally::default();
    let part = |shard| units(options, Some(shard));
    set.records(
        |shard| record_of(&part(shard)),
        |shard, record| {
            interrupt.check()?;
            let tally: C::Tally =
                serde_json::from_str(record).map_err(|error| Error::input(format!("no tally: {error}")))?;
            options.check(&tally)?;
            // Only a disagreement, or an error of this program, ends a part early.
            let (done, whole) = (tally.units(), part(shard).end - part(shard).start);
            let early = !tally.disagreements().is_empty() || !tally.faults().is_empty();
            if done > whole || (done < whole && !early) {
                return Err(Error::input(format!("a tally of {done} blocks, where the part has {whole}")));
            }
            all = std::mem::take(&mut all).merge(tally);
            Ok(())
        },
    )?;
    let outcome = outcome(&all, &(0..options.units()));
    tell(args, options, (&all, outcome), merged.format, &merged.report()?)
}

/// What a tally amounts to.
fn outcome<T: Tally>(tally: &T, units: &Range<u64>) -> Outcome {
    if !tally.disagreements().is_empty() || !tally.faults().is_empty() {
        Outcome::Refuted
    } else if tally.units() < units.end - units.start {
        Outcome::Interrupted
    } else if tally.undecided() > 0 {
        Outcome::Undecided
    } else {
        Outcome::Done
    }
}

/// Keeps the disagreements and writes the report.
fn tell<C: Told>(
    args: &Args,
    options: &C,
    (tally, outcome): (&C::Tally, Outcome),
    format: ReportFormat,
    destination: &Destination,
) -> Result<Outcome> {
    let kept = match tally.disagreements() {
        [] => Ok(()),
        found => append(&args.regressions, found),
    };
    let written = destination.write(|out| match format {
        ReportFormat::Text => text(out, args, options, tally, outcome),
        ReportFormat::Json => {
            let mut report = json!({
                "format": "grazing-fuzz 3",
                "verdict": match outcome {
                    Outcome::Done => "no disagreement",
                    other => other.word(),
                },
                "options": options,
                "block": options.block(),
                "tally": tally,
            });
            // They may exceed 2⁵³.
            report["options"]["cases"] = args.cases.to_string().into();
            report["options"]["seed"] = args.seed.to_string().into();
            for (key, value) in options.more() {
                report[key] = value;
            }
            Ok(writeln!(out, "{report}")?)
        }
    });
    reported(outcome, kept.and(written))
}

/// Time between two saved states.
const PAUSE: Duration = Duration::from_millis(250);

/// Bytes that no state comes to: it has one line, and a run ends at the first disagreements.
const MOST: u64 = 16 << 20;

/// The state of this run, and how far it has come.
fn open<C: Told>(path: &Path, options: &C, shard: Option<Shard>) -> Result<(Journal, C::Tally)> {
    // The blocks of a part depend on how many there are in all; a whole run can be made longer.
    let part = shard.map(|shard| format!(" --cases {} --shard {shard}", options.cases()));
    let part = part.unwrap_or_default();
    let canonical = options.canonical() + &part;
    let run = SavedRun::new("fuzz", options.arguments() + &part, &canonical, program());
    let (state, found) = Journal::open(path, &run, MOST)?;
    if found.torn > 0 {
        say(format_args!("note: {}", torn(path)));
    }
    let Some(record) = found.records.last() else { return Ok((state, C::Tally::default())) };
    let tally: Result<C::Tally> =
        serde_json::from_str(record).map_err(|error| Error::input(format!("no tally: {error}")));
    let tally = tally.and_then(|tally| options.check(&tally).map(|()| tally));
    tally
        .map(|tally| (state, tally))
        .map_err(|error| error.context(format_args!("cannot resume from {}", path.display())))
}

/// Appends the lines that are not there yet: a run that goes on from its state may have appended them before.
fn append(path: &Path, lines: &[String]) -> Result<()> {
    let known = if path.is_file() { fs::read_to_string(path).unwrap_or_default() } else { String::new() };
    let lines = lines.iter().filter(|line| !known.lines().any(|old| old == *line));
    let mut file = OpenOptions::new().create(true).append(true).open(path);
    for line in lines {
        file = file.and_then(|mut file| writeln!(file, "{line}").map(|()| file));
    }
    file.map(drop).map_err(|error| Error::io("append to", path, error))
}

fn text<C: Told>(
    out: &mut dyn Write,
    args: &Args,
    options: &C,
    tally: &C::Tally,
    outcome: Outcome,
) -> Result<()> {
    let verdict = match outcome {
        Outcome::Refuted if tally.disagreements().is_empty() => {
            "An error of this program: two of its routes to one answer differ. Please report it.".to_string()
        }
        Outcome::Refuted => format!("Refuted: {}.", C::REFUTED),
        Outcome::Interrupted => format!(
            "Interrupted: no disagreement found in {} of {} {}. This is not a proof.",
            tally.decided(),
            options.cases(),
            C::UNIT
        ),
        _ => "No disagreement found. This is not a proof.".to_string(),
    };
    writeln!(out, "{verdict}")?;
    for (count, what) in options.rows(tally) {
        writeln!(out, "{count:>14}  {what}")?;
    }
    for remark in options.remarks(tally) {
        writeln!(out, "{remark}")?;
    }
    writeln!(
        out,
        "The {} come in blocks of {} and a few more: --cases is rounded up to whole blocks.",
        C::UNIT,
        options.block()
    )?;
    for fault in tally.faults() {
        writeln!(out, "{fault}")?;
    }
    for line in tally.disagreements() {
        writeln!(out, "{line}\n  shown by: {}", options.shown_by(line)?)?;
    }
    if !tally.disagreements().is_empty() {
        say_to(out, format_args!("appended to {}", args.regressions.display()))?;
    }
    Ok(())
}
