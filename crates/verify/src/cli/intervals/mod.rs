//! `grazing intervals`: Theorem 2's intervals as tables.

mod measure;

use std::{io::Write, ops::RangeInclusive, path::PathBuf, str::FromStr};

use clap::{Parser, ValueEnum};

use super::{
    Outcome,
    cite::{self, Basis},
    range::Periods,
    shards::{Merged, Part, PlainRows, RowSink, ShardRows, ShardSet, part_of, periods_of, task_of},
    two_impacts,
};
use crate::{
    certificate::{cover, theorem2},
    cli::{
        choice::Choice,
        progress::{Interrupt, Progress},
    },
    error::{Error, Result},
    existence::{MAX_PERIOD, intervals},
    monitor::Monitor,
    number::parse_integer,
    output::{
        Caption, Column, FileRegistry, Setting, Shard, ShardedTask, TableCell, TableFormat, TableWriter,
    },
    rows::{self, Style},
    word,
};

/// List Theorem 2's intervals of s: where on r = 1 single-impact orbits of period n exist.
///
/// The columns are n; m, the integer nearest to n s; the signs of e*mu and gamma; both ends as exact
/// fractions; and the k whose b_{n,k} alone decides existence for r < 1. Periods 1 and 2 get their intervals
/// from the summary by period. The format bfile lists the number of intervals of each n instead.
///
/// --pattern I,J lists the intervals of s where on r = 1 an orbit with two impacts exists, I and J periods
/// apart. --two-impacts does so for all patterns of two impacts of a period.
///
/// --measure lists instead how long the intervals of each period are together, L_n, and how many of the
/// periods 3 to n exist at a random s in the mean.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing intervals 3..=8
  grazing intervals 3..=8 --digits 6 --format latex -o intervals.tex
  grazing verify 3..=8 --certificate theorem2.txt
  grazing intervals 3..=8 --format latex --cite theorem2.txt
  grazing intervals --pattern 3,5
  grazing intervals --measure 3..=12")]
pub struct Args {
    /// The periods: N, or A..=B. At most 10000000.
    #[arg(value_name = "N|A..=B", required_unless_present_any = ["pattern", "two_impacts", "measure"])]
    periods: Option<Periods>,
    /// The pattern of two impacts with these periods between them, such as 3,5.
    #[arg(long, value_name = "I,J", value_parser = two_impacts::pattern, conflicts_with_all = ["periods", "two_impacts"])]
    pattern: Option<(u64, u64)>,
    /// All patterns of two impacts of these periods, I + J = N from 3 to 2000.
    #[arg(long, value_name = "N|A..=B", conflicts_with = "periods")]
    two_impacts: Option<Periods>,
    /// The total length of the intervals of these periods, from 3 on: as a fraction up to period 10000, or to
    /// 1000000 of a single one, and in decimals that are certain (15 of them, or D up to 24).
    #[arg(long, value_name = "N|A..=B", conflicts_with_all = ["periods", "two_impacts", "pattern", "cite", "shard"])]
    measure: Option<Periods>,
    /// How the table is written.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(super) format: Format,
    /// Add both ends as decimals, rounded to D digits (at most 1000).
    #[arg(long, alias = "decimals", value_name = "D", value_parser = parse_integer::<usize>)]
    digits: Option<usize>,
    /// Cite this certificate in the caption of the LaTeX table, by its SHA-256; - is standard input. It is
    /// checked first. `grazing verify` writes one that proves the intervals and signs, `grazing cover` one
    /// that proves the deciding k; the option may be given for each.
    #[arg(long, value_name = "CERTIFICATE", conflicts_with_all = ["pattern", "two_impacts"])]
    cite: Vec<PathBuf>,
    /// List the I-th of N parts only, and write a shard of the table to -o, for `grazing merge`.
    #[arg(long, value_name = "I/N", requires = "output", value_parser = Shard::from_str,
          conflicts_with_all = ["pattern", "cite"])]
    shard: Option<Shard>,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// Aligned columns.
    Table,
    /// Comma-separated values.
    Csv,
    /// JSON, its layout in docs/formats.md.
    Json,
    /// A LaTeX longtable with booktabs rules.
    Latex,
    /// The same with the numbers in siunitx's \num.
    LatexSiunitx,
    /// A Markdown table.
    Markdown,
    /// The number of intervals of each n, as an OEIS b-file.
    Bfile,
}

impl Format {
    /// None for a b-file.
    fn of_table(self) -> Option<TableFormat> {
        Some(match self {
            Format::Table => TableFormat::Table,
            Format::Csv => TableFormat::Csv,
            Format::Json => TableFormat::Json,
            Format::Latex => TableFormat::Latex,
            Format::LatexSiunitx => TableFormat::LatexSiunitx,
            Format::Markdown => TableFormat::Markdown,
            Format::Bfile => return None,
        })
    }
}

impl Args {
    /// Whether lengths are asked for, not intervals.
    pub(super) fn is_measure(&self) -> bool {
        self.measure.is_some()
    }
}

/// What is listed, how it is written.
struct List<'a> {
    periods: RangeInclusive<u64>,
    two_impacts: bool,
    /// None for a b-file.
    format: Option<TableFormat>,
    decimals: Option<usize>,
    caption: Option<&'a Caption>,
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    if let Some(periods) = &args.measure {
        let destination = files.destination(args.output.as_deref())?;
        measure::run(periods, args.format, args.digits, &destination, interrupt)?;
        return Ok(Outcome::Done);
    }
    if let Some((i, j)) = args.pattern {
        let (format, decimals) = (checked(args)?, args.digits);
        let destination = files.destination(args.output.as_deref())?;
        let pattern = || Ok(word::two_impacts(i, j)?.into_iter());
        two_impacts::run((i, j), pattern, format, decimals, &destination, interrupt)?;
        return Ok(Outcome::Done);
    }
    let mut list = list(args)?;
    if let (Some(shard), Some(output)) = (args.shard, &args.output) {
        let part = Part { task: list.task(), shard, file: files.write("-o", output)? };
        let periods = periods_of(&list.periods, list.exponent(), Some(shard));
        let progress = Progress::new(interrupt, periods.clone().count() as u64, "periods");
        part.write(|out| list.rows(periods, &mut ShardRows::new(out), &progress))?;
        return Ok(Outcome::Done);
    }
    cite::named(&args.cite, files)?;
    let destination = files.destination(args.output.as_deref())?;
    if !args.cite.is_empty() && !list.is_print() {
        return Err(Error::input("--cite does nothing here: only --format latex has a caption"));
    }
    let (name, text) = list.about();
    let periods = Periods(list.periods.clone());
    let caption = match cite::caption(&args.cite, (name, text, BASES.as_slice()), &periods, interrupt)? {
        Ok(caption) => caption,
        Err(outcome) => return Ok(outcome),
    };
    list.caption = Some(&caption);
    let progress = Progress::new(interrupt, periods.count(), "periods");
    destination.list(|out| list.whole(out, &progress))?;
    Ok(Outcome::Done)
}

/// The table from its shards.
pub(super) fn merge(args: &Args, set: &ShardSet, merged: &Merged, interrupt: &Interrupt) -> Result<Outcome> {
    let mut list = list(args)?;
    set.expect(&list.task())?;
    let (name, text) = list.about();
    let caption = cite::plain(name, text, &Periods(list.periods.clone()));
    list.caption = Some(&caption);
    let items = |shard| part_of(&list.periods, list.exponent(), shard);
    merged.table()?.list(|out| {
        list.write(out, |rows| {
            set.rows(items, list.columns().len(), |cells| {
                interrupt.check()?;
                rows.row(cells)
            })
        })
    })?;
    Ok(Outcome::Done)
}

/// The format of a table, none for a b-file; what else is asked of it can be done.
fn checked(args: &Args) -> Result<Option<TableFormat>> {
    if let Some(digits) = args.digits.filter(|&digits| digits > 1000) {
        return Err(Error::input(format!("--digits {digits} is too many: at most 1000")));
    }
    let format = args.format.of_table();
    if args.digits.is_some() && format.is_none() {
        return Err(Error::input("--digits does nothing with --format bfile, which has no ends"));
    }
    Ok(format)
}

/// What is listed, but for a single pattern.
fn list(args: &Args) -> Result<List<'static>> {
    let (format, decimals) = (checked(args)?, args.digits);
    let (periods, two_impacts) = match (&args.two_impacts, &args.periods) {
        (Some(periods), _) => (two_impacts::periods(periods)?, true),
        (None, Some(periods)) => (periods.within(MAX_PERIOD, "intervals")?, false),
        (None, None) => return Err(Error::input("give the periods: N, or A..=B")),
    };
    Ok(List { periods, two_impacts, format, decimals, caption: None })
}

impl List<'_> {
    /// What shards are parts of.
    fn task(&self) -> ShardedTask {
        let mut words = vec!["intervals".to_string()];
        words.extend(self.two_impacts.then(|| "--two-impacts".to_string()));
        words.push(format!("{:?}", self.periods));
        let format = self.format.map_or("bfile", Choice::word);
        words.extend(["--format".to_string(), format.to_string()]);
        words.extend(self.decimals.iter().flat_map(|d| ["--decimals".to_string(), d.to_string()]));
        task_of(words)
    }

    /// A period n costs about n to this power.
    fn exponent(&self) -> u32 {
        if self.two_impacts { 2 } else { 1 }
    }

    /// The name of the table in labels, and what it shows, in LaTeX.
    fn about(&self) -> (&'static str, &'static str) {
        if self.two_impacts { ("two-impacts", two_impacts::CAPTION) } else { ("intervals", CAPTION) }
    }

    /// Whether it goes onto a page.
    fn is_print(&self) -> bool {
        self.format.is_some_and(TableFormat::is_print)
    }

    fn style(&self) -> Style {
        Style { decimals: self.decimals, print: self.is_print() }
    }

    fn columns(&self) -> Vec<Column> {
        if self.format.is_none() {
            return vec![Column::new("n", "$n$", 0), Column::new("intervals", "intervals", 0)];
        }
        let digits = self.periods.end().to_string().len();
        let mut columns = if self.two_impacts {
            two_impacts::columns(digits, self.is_print())
        } else {
            columns(digits, self.is_print())
        };
        if let Some(decimals) = self.decimals {
            columns.push(Column::new("left_rounded", "left (rounded)", decimals + 2));
            columns.push(Column::new("right_rounded", "right (rounded)", decimals + 2));
        }
        columns
    }

    /// Writes the list; `rows` gives its rows.
    fn write(&self, out: &mut dyn Write, rows: impl FnOnce(&mut dyn RowSink) -> Result<()>) -> Result<()> {
        let Some(format) = self.format else { return rows(&mut PlainRows(out)) };
        let mut table = self.table(out, format)?;
        let rows = rows(&mut table);
        table.end(rows)
    }

    fn table<'a>(&self, out: &'a mut dyn Write, format: TableFormat) -> Result<TableWriter<'a>> {
        let setting = Setting { caption: self.caption, ..Setting::default() };
        let name = if self.two_impacts { "grazing-pattern-intervals 1" } else { "grazing-intervals 1" };
        TableWriter::set(out, format, name, self.columns(), setting)
    }

    /// Writes the list with all its rows.
    fn whole(&self, out: &mut dyn Write, progress: &Progress) -> Result<()> {
        let periods = self.periods.clone();
        match self.format {
            Some(format) if !self.two_impacts => {
                let mut table = self.table(out, format)?;
                let rows = rows::in_parallel(periods, self.style(), &mut table, progress);
                table.end(rows)
            }
            _ => self.write(out, |rows| self.rows(periods, rows, progress)),
        }
    }

    fn rows(&self, periods: RangeInclusive<u64>, rows: &mut dyn RowSink, progress: &Progress) -> Result<()> {
        for n in periods {
            match (self.format, self.two_impacts) {
                (None, false) => count(n, intervals(n)?.count(), rows)?,
                (None, true) => count(n, word::two_impacts_of(n)?.count(), rows)?,
                (Some(_), false) => rows::of_period(n, self.style(), progress, &mut |cells| rows.row(cells))?,
                (Some(_), true) => {
                    two_impacts::rows(word::two_impacts_of(n)?, self.style(), rows, progress)?;
                }
            }
            rows.done(n)?;
            progress.advance(1)?;
        }
        Ok(())
    }
}

/// How many there are, for a b-file.
fn count(n: u64, count: usize, rows: &mut dyn RowSink) -> Result<()> {
    rows.row(&[TableCell::Int(n as i64), TableCell::Int(count as i64)])
}

const CAPTION: &str = "The open intervals of $s$ on $r = 1$ where there is an orbit with one impact in $n$ \
periods, the case $(e\\mu, \\gamma)$ in which it exists, and the $b_{n,k}$ that alone decides about it for $r < 1$.";

/// What a table of intervals can rest on.
const BASES: [Basis; 2] = [
    Basis { kind: theorem2::KIND, proves: "The intervals and signs are proved", command: "grazing verify" },
    Basis {
        kind: cover::KIND,
        proves: "That $b_{n,k}$ with the deciding $k$ alone bounds each area of orbits for $r$ up to the certificate's \
$r_{\\max} < 1$ is proved",
        command: "grazing cover",
    },
];

fn columns(digits: usize, print: bool) -> Vec<Column> {
    if print {
        return vec![
            Column::new("n", "$n$", 0),
            Column::new("case", "case", 0),
            Column::new("left", "from", 0),
            Column::new("right", "to", 0),
            Column::new("deciding", "decides", 0),
        ];
    }
    vec![
        Column::new("n", "$n$", digits),
        Column::new("m", "$m$", digits),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("left", "left end", 2 * digits + 2),
        Column::new("right", "right end", 2 * digits + 2),
        Column::new("deciding", "deciding $k$", 0),
    ]
}
