//! `grazing cover`: prove Conjecture 1 for given periods, r ≤ r_max.

use std::{
    collections::{HashMap, HashSet},
    io::Write,
    ops::{Range, RangeInclusive},
    path::{Path, PathBuf},
    str::FromStr,
    sync::Mutex,
    time::Instant,
};

use clap::Parser;
use num_rational::BigRational;
use rayon::prelude::*;
use serde_json::json;

use super::{
    Outcome, ReportFormat, in_pool,
    range::{Periods, whole},
    reported,
    shards::{Certified, Merged, Part, ShardSet, certificate_line, certify, part_of, periods_of, task_of},
};
use crate::{
    certificate::{self, Rejection},
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    monitor::Monitor,
    number::{parse_integer, parse_rational},
    output::{FileRegistry, Journal, SavedRun, Shard, decimal_above, decimal_below, say, torn},
    program,
    search::cover::{Cover, CoverOptions, CoverTally, Unit, certificate as assemble, cover, units},
};

/// Prove Conjecture 1 for every period in a range, at every point of regions 2, 3 and 4 with r <= r_max, by
/// computation.
///
/// Region 3 is cut into boxes. For each box the claim is that there is no orbit, that there is one, or that
/// the edge of an area runs through it. The search is not trusted: only what the checker of certificates has
/// proved, in integers, is reported as proved. Nothing is claimed for r_max < r < 1.
///
/// Exit code 0: proved; 1: refuted, with a point; 2: wrong usage or a file that cannot be read or written; 3:
/// undecided (boxes left open are listed), or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing cover 3..=16
  grazing cover 3..=16 --certificate covers.txt --resume covers.journal")]
pub struct Args {
    /// The periods: N, or A..=B, from 3 to 256.
    #[arg(value_name = "N|A..=B")]
    periods: Periods,
    /// The largest r covered, at least 1 - 4.9/n^3; by default 1 - 1/n^3 for each n.
    #[arg(long, value_name = "R", value_parser = parse_rational)]
    r_max: Option<BigRational>,
    /// Leave a box open after this many halvings.
    #[arg(long, value_name = "D", default_value_t = 60, value_parser = whole(0..=60))]
    max_depth: u32,
    /// Write a certificate, which `grazing check` proves again without search.
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Cover the I-th of N parts only, and write a shard of the certificate, for `grazing merge`.
    #[arg(long, value_name = "I/N", requires = "certificate", value_parser = Shard::from_str)]
    shard: Option<Shard>,
    /// Keep a journal of finished work in this file, and continue from it if it exists.
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// The number of threads; default: one for each core.
    #[arg(long, value_name = "J", default_value_t = 0, hide_default_value = true, value_parser = parse_integer::<usize>)]
    jobs: usize,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
    /// Write the result to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// One period's result.
struct Row {
    cover: Cover,
    tally: CoverTally,
    /// The checker's answer; none if the cover is not complete or not checked.
    checked: Option<std::result::Result<(), Rejection>>,
    check_seconds: f64,
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    let all = args.periods.within(certificate::cover::MOST, "cover")?;
    let task = task_of(words(&options(args, all.clone())));
    let range = periods_of(&all, 2, args.shard);
    let options = options(args, range.clone());
    let certificate =
        args.certificate.as_deref().map(|path| files.write("--certificate", path)).transpose()?;
    args.resume.as_deref().map(|path| files.go_on("--resume", path)).transpose()?;
    let destination = files.destination(args.output.as_deref())?;
    let (rows, clock) = in_pool(args.jobs, || prove(&options, args.resume.as_deref(), interrupt))?;
    let outcome = outcome(&rows);
    if let (Some(file), Outcome::Done) = (certificate, outcome) {
        let blocks = rows.iter().filter_map(|row| Some((row.cover.n, row.cover.block()?)));
        match args.shard {
            None => {
                let blocks: Vec<String> = blocks.map(|(_, block)| block).collect();
                file.write(|out| Ok(out.write_all(assemble(&range, &blocks).as_bytes())?))?;
            }
            Some(shard) => Part { task, shard, file }.write(|out| {
                for (n, block) in blocks {
                    out.record(n, &json!(block).to_string())?;
                }
                Ok(())
            })?,
        }
    }
    let report = match args.format {
        ReportFormat::Text => text(&range, &rows, args) + &growth(&rows) + &clock,
        ReportFormat::Json => format!("{}\n", json_report(&range, &rows, args)),
    };
    reported(outcome, destination.write(|out| Ok(out.write_all(report.as_bytes())?)))
}

fn options(args: &Args, periods: RangeInclusive<u64>) -> CoverOptions {
    CoverOptions { r_max: args.r_max.clone(), max_depth: args.max_depth, ..CoverOptions::new(periods) }
}

/// What shards are parts of.
fn words(options: &CoverOptions) -> Vec<String> {
    let mut words = vec!["cover".to_string(), format!("{:?}", options.periods)];
    words.extend(options.r_max.iter().flat_map(|r| ["--r-max".to_string(), r.to_string()]));
    words.extend(["--max-depth".to_string(), options.max_depth.to_string()]);
    words
}

/// The certificate from its shards.
pub(super) fn merge(args: &Args, set: &ShardSet, merged: &Merged, interrupt: &Interrupt) -> Result<Outcome> {
    let range = args.periods.within(certificate::cover::MOST, "cover")?;
    set.expect(&task_of(words(&options(args, range.clone()))))?;
    certify(merged, set, *range.start()..*range.end() + 1, &Blocks(&range), interrupt)
}

/// The periods of a campaign.
struct Blocks<'a>(&'a RangeInclusive<u64>);

impl Certified for Blocks<'_> {
    fn items(&self, shard: Shard) -> Range<u64> {
        part_of(self.0, 2, shard)
    }

    fn write(&self, items: Range<u64>, set: &ShardSet, out: &mut dyn Write) -> Result<()> {
        let mut blocks = Vec::new();
        set.texts(
            |shard| self.items(shard),
            |block| {
                blocks.push(block.to_string());
                Ok(())
            },
        )?;
        Ok(out.write_all(assemble(&(items.start..=items.end - 1), &blocks).as_bytes())?)
    }
}

/// Searches, then checks; the rows, and how long that took in words.
fn prove(options: &CoverOptions, resume: Option<&Path>, interrupt: &Interrupt) -> Result<(Vec<Row>, String)> {
    let (journal, known) = match resume {
        Some(path) => {
            let (journal, found) = Journal::open(path, &identity(options), MOST)?;
            interrupt.keeps(format!(
                "finished strips are kept in {0}: continue with --resume {0}",
                path.display()
            ));
            if found.torn > 0 {
                say(format_args!("note: {}", torn(path)));
            }
            let known = known(&found.records, &units(options)?).ok_or_else(|| foreign(path))?;
            (Some(Mutex::new(journal)), known)
        }
        None => (None, HashMap::new()),
    };
    let record = |(n, index): Unit, trees: &str| match &journal {
        Some(journal) => {
            journal.lock().expect("no thread fails while it writes").append(&format!("{n} {index} {trees}"))
        }
        None => Ok(()),
    };
    let start = Instant::now();
    let progress = Progress::new(interrupt, (units(options)?.len() - known.len()) as u64, "strips");
    let covers = cover(options, known, &progress, &record)?;
    drop(progress);
    let found = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let progress = Progress::new(interrupt, covers.len() as u64, "periods checked");
    // The long periods first.
    let mut rows: Vec<Row> = covers
        .into_par_iter()
        .rev()
        .with_max_len(1)
        .map(|cover| {
            let row = Row::new(cover, interrupt);
            let _ = progress.advance(1);
            row
        })
        .collect();
    rows.reverse();
    drop(progress);
    let clock = format!("Found in {found:.2} s, checked in {:.2} s.\n", start.elapsed().as_secs_f64());
    Ok((rows, clock))
}

impl Row {
    /// Checks a cover; after an interruption it stays pending.
    fn new(cover: Cover, interrupt: &Interrupt) -> Row {
        let block = cover.block().filter(|_| !interrupt.asked());
        let start = Instant::now();
        let checked = block.map(|block| certificate::cover::check_block(cover.n, block.as_bytes(), 0));
        let check_seconds = start.elapsed().as_secs_f64();
        Row { tally: cover.tally(), checked, check_seconds, cover }
    }

    fn verdict(&self) -> &'static str {
        match (&self.cover.refuted, &self.checked) {
            (Some(_), _) => "refuted",
            (None, None) => "pending",
            (None, Some(Ok(()))) => "proved",
            (None, Some(Err(_))) => "undecided",
        }
    }
}

/// Bytes that no cover's state comes to: periods 3..=256 with r_max = 1 - 1/n^3 take less than a hundredth.
const MOST: u64 = 1 << 30;

/// What a saved state is of: all that its records depend on.
fn identity(options: &CoverOptions) -> SavedRun {
    let r_max = options.r_max.as_ref().map_or_else(|| "default".to_string(), BigRational::to_string);
    let (first, last) = (options.periods.start(), options.periods.end());
    let words = format!("{first}..={last} r-max {r_max} max-depth {}", options.max_depth);
    SavedRun::new("cover", &words, &words, program())
}

/// The trees in the records; none if some record is not of one of these units, or one unit has two.
fn known(records: &[String], units: &[Unit]) -> Option<HashMap<Unit, String>> {
    let mut open: HashSet<Unit> = units.iter().copied().collect();
    let unit = |record: &String| {
        let mut words = record.splitn(3, ' ');
        let unit = (words.next()?.parse().ok()?, words.next()?.parse().ok()?);
        open.remove(&unit).then_some((unit, words.next()?.to_string()))
    };
    records.iter().map(unit).collect()
}

fn foreign(path: &Path) -> Error {
    Error::input(format!("cannot resume from {}: its records are not those of a cover", path.display()))
}

fn outcome(rows: &[Row]) -> Outcome {
    if rows.iter().any(|row| row.cover.refuted.is_some()) {
        Outcome::Refuted
    } else if rows.iter().all(|row| row.verdict() == "proved") {
        Outcome::Done
    } else if rows.iter().any(|row| row.verdict() == "pending") {
        Outcome::Interrupted
    } else {
        Outcome::Undecided
    }
}

fn text(range: &RangeInclusive<u64>, rows: &[Row], args: &Args) -> String {
    let proved = rows.iter().filter(|row| row.verdict() == "proved").count();
    let r_max = args.r_max.as_ref().map_or_else(|| "1 - 1/n^3".to_string(), BigRational::to_string);
    let what = format!("Conjecture 1 for r <= {r_max}");
    let which = if rows.is_empty() {
        "no period: this part is empty".to_string()
    } else if proved == 1 && rows.len() == 1 {
        format!("period n = {}", range.start())
    } else {
        format!("every period n in {range:?}")
    };
    let mut text = match outcome(rows) {
        Outcome::Done => format!("Proved: {what} and {which}.\n"),
        Outcome::Refuted => format!("Refuted: {what} is false.\n"),
        other => {
            let word = if other == Outcome::Interrupted { "Interrupted" } else { "Undecided" };
            format!("{word}: {what} is proved for {proved} of the periods in {range:?}.\n")
        }
    };
    for row in rows {
        match (&row.cover.refuted, &row.checked) {
            (Some(case), _) => {
                text += &format!("  at {case}\n  shown by: grazing classify {}\n", case.arguments())
            }
            (None, None) => text += &format!("  n = {}: pending\n", row.cover.n),
            (None, Some(Err(rejection))) => text += &format!("  n = {}: {rejection}\n", row.cover.n),
            (None, Some(Ok(()))) => {}
        }
        for [r, s] in row.tally.open.iter().take(SHOWN) {
            let [r, s] = [r, s]
                .map(|[low, high]| format!("[{}, {}]", decimal_below(low, 12), decimal_above(high, 12)));
            text += &format!("    open: r in {r}, s in {s}\n");
        }
        if row.tally.open.len() > SHOWN {
            text += &format!("    … {} boxes; --format json lists them all\n", row.tally.open.len());
        }
    }
    text += &table(rows);
    if let (Some(path), Outcome::Done) = (&args.certificate, outcome(rows)) {
        text += &certificate_line(path, args.shard);
    }
    text
}

/// Open boxes listed for one period.
const SHOWN: usize = 8;

fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{:>5} {:>6} {:>9} {:>9} {:>8} {:>8} {:>6} {:>6} {:>9} {:>9}\n",
        "n", "areas", "leaves", "none", "orbit", "edge", "open", "depth", "find s", "check s"
    );
    let mut line = |n: &str, tally: &CoverTally, open: usize, find: f64, check: f64| {
        let CoverTally { areas, none, orbit, edge, depth, .. } = tally;
        let leaves = none + orbit + edge + open as u64;
        text += &format!(
            "{n:>5} {areas:>6} {leaves:>9} {none:>9} {orbit:>8} {edge:>8} {open:>6} {depth:>6} {find:>9.3} {check:>9.3}\n"
        );
    };
    let mut all = (CoverTally::default(), 0, 0.0, 0.0);
    for Row { cover, tally, check_seconds, .. } in rows {
        line(&cover.n.to_string(), tally, tally.open.len(), cover.seconds, *check_seconds);
        let CoverTally { none, orbit, edge, open, areas, depth } = tally;
        all.0.none += none;
        all.0.orbit += orbit;
        all.0.edge += edge;
        all.0.areas += areas;
        all.0.depth = all.0.depth.max(*depth);
        all.1 += open.len();
        all.2 += cover.seconds;
        all.3 += check_seconds;
    }
    if rows.len() > 1 {
        line("all", &all.0, all.1, all.2, all.3);
    }
    text
}

/// How leaves and times grow over the periods of a range, if all are proved and enough to say.
fn growth(rows: &[Row]) -> String {
    if rows.len() < 8 || rows.iter().any(|row| row.verdict() != "proved") {
        return String::new();
    }
    let exponent =
        |of: fn(&Row) -> f64| slope(rows.iter().map(|row| ((row.cover.n as f64).ln(), of(row).ln())));
    format!(
        "Least squares: leaves grow like n^{:.2}, time to find like n^{:.2}, to check like n^{:.2}.\n",
        exponent(|row| row.tally.leaves() as f64),
        exponent(|row| row.cover.seconds.max(1e-9)),
        exponent(|row| row.check_seconds.max(1e-9)),
    )
}

/// The slope of the line of least squares.
fn slope(points: impl Iterator<Item = (f64, f64)> + Clone) -> f64 {
    let count = points.clone().count() as f64;
    let (x, y) = points.clone().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    let [above, below] =
        points.fold([0.0, 0.0], |[a, b], (u, v)| [a + (u - x) * (v - y), b + (u - x) * (u - x)]);
    above / below
}

fn json_report(range: &RangeInclusive<u64>, rows: &[Row], args: &Args) -> serde_json::Value {
    let ends = |[low, high]: &[BigRational; 2]| [low.to_string(), high.to_string()];
    let period = |row: &Row| {
        let Row { cover, tally, checked, check_seconds } = row;
        json!({
            "n": cover.n,
            "verdict": row.verdict(),
            "r_max": cover.r_max.to_string(),
            "areas": tally.areas,
            "leaves": tally.leaves(),
            "none": tally.none,
            "orbit": tally.orbit,
            "edge": tally.edge,
            "depth": tally.depth,
            "open": tally.open.iter().map(|[r, s]| json!({ "r": ends(r), "s": ends(s) })).collect::<Vec<_>>(),
            "open_area": tally.open_area(),
            "witness": cover.refuted.as_ref().map(ToString::to_string),
            "rejection": checked.as_ref().and_then(|answer| answer.as_ref().err()).map(ToString::to_string),
            "find_seconds": cover.seconds,
            "check_seconds": check_seconds,
        })
    };
    json!({
        "format": "grazing-cover 1",
        "verdict": match outcome(rows) {
            Outcome::Done => "proved",
            other => other.word(),
        },
        "range": [range.start(), range.end()],
        "periods": rows.iter().map(period).collect::<Vec<_>>(),
        "shard": args.shard.map(|shard| shard.to_string()),
        "certificate": args.certificate.as_ref().filter(|_| outcome(rows) == Outcome::Done),
    })
}
