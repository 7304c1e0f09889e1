//! `grazing intervals`: Theorem 2's intervals as tables.

use std::{io::Write, path::PathBuf};

use clap::{Parser, ValueEnum};

use super::{
    Outcome,
    cite::{self, Basis},
    range::Periods,
    two_impacts,
};
use crate::{
    certificate::{cover, theorem2},
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::{MAX_PERIOD, intervals},
    monitor::Monitor,
    number::parse_integer,
    output::{Caption, Column, Destination, Setting, TableCell, TableFormat, TableWriter, decimal},
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
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing intervals 3..=8
  grazing intervals 3..=8 --decimals 6 --format latex -o intervals.tex
  grazing verify 3..=8 --certificate theorem2.txt
  grazing intervals 3..=8 --format latex --cite theorem2.txt
  grazing intervals --pattern 3,5")]
pub(super) struct Args {
    /// The periods: N, or A..=B. At most 10000000.
    #[arg(value_name = "N|A..=B", required_unless_present_any = ["pattern", "two_impacts"])]
    periods: Option<Periods>,
    /// The pattern of two impacts with these periods between them, such as 3,5.
    #[arg(long, value_name = "I,J", value_parser = two_impacts::pattern, conflicts_with_all = ["periods", "two_impacts"])]
    pattern: Option<(u64, u64)>,
    /// All patterns of two impacts of these periods, I + J = N from 3 to 2000.
    #[arg(long, value_name = "N|A..=B", conflicts_with = "periods")]
    two_impacts: Option<Periods>,
    /// How the table is written.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(super) format: Format,
    /// Add both ends as decimals, rounded to D digits (at most 1000).
    #[arg(long, value_name = "D", value_parser = parse_integer::<usize>)]
    decimals: Option<usize>,
    /// Cite this certificate in the caption of the LaTeX table, by its SHA-256; - is standard input. It is
    /// checked first. `grazing verify` writes one that proves the intervals and signs, `grazing cover` one
    /// that proves the deciding k; the option may be given for each.
    #[arg(long, value_name = "CERTIFICATE", conflicts_with_all = ["pattern", "two_impacts"])]
    cite: Vec<PathBuf>,
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
    /// A Markdown table.
    Markdown,
    /// The number of intervals of each n, as an OEIS b-file.
    Bfile,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    if let Some(digits) = args.decimals.filter(|&digits| digits > 1000) {
        return Err(Error::input(format!("--decimals {digits} is too many: at most 1000")));
    }
    let destination = Destination::new(args.output.as_deref())?;
    let format = match args.format {
        Format::Table => Some(TableFormat::Table),
        Format::Csv => Some(TableFormat::Csv),
        Format::Json => Some(TableFormat::Json),
        Format::Latex => Some(TableFormat::Latex),
        Format::Markdown => Some(TableFormat::Markdown),
        Format::Bfile => None,
    };
    if args.decimals.is_some() && format.is_none() {
        return Err(Error::input("--decimals does nothing with --format bfile, which has no ends"));
    }
    if let Some((i, j)) = args.pattern {
        let pattern = || Ok(word::two_impacts(i, j)?.into_iter());
        two_impacts::run(&[i + j], |_| pattern(), format, args.decimals, &destination, interrupt)?;
        return Ok(Outcome::Done);
    }
    if let Some(periods) = &args.two_impacts {
        let all = two_impacts::periods(periods)?;
        two_impacts::run(&all, word::two_impacts_of, format, args.decimals, &destination, interrupt)?;
        return Ok(Outcome::Done);
    }
    let Some(periods) = &args.periods else { return Err(Error::input("give the periods: N, or A..=B")) };
    periods.within(MAX_PERIOD, "intervals")?;
    if !args.cite.is_empty() && format != Some(TableFormat::Latex) {
        return Err(Error::input("--cite does nothing here: only --format latex has a caption"));
    }
    let about = ("intervals", CAPTION, BASES.as_slice());
    let caption = match cite::caption(&args.cite, about, periods, args.output.as_deref(), interrupt)? {
        Ok(caption) => caption,
        Err(outcome) => return Ok(outcome),
    };
    let progress = Progress::new(interrupt, periods.count(), "periods");
    match format {
        None => destination.list(|out| bfile(periods, out, &progress))?,
        Some(format) => {
            let caption = caption.as_ref();
            destination.list(|out| table(periods, args.decimals, (format, caption), out, &progress))?;
        }
    }
    Ok(Outcome::Done)
}

const CAPTION: &str = "The open intervals of $s$ on $r = 1$ where there is an orbit with one impact in $n$ \
periods, and the signs of $e\\mu$ and $\\gamma$ for which it exists.";

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

fn bfile(periods: &Periods, out: &mut dyn Write, progress: &Progress) -> Result<()> {
    for n in periods.0.clone() {
        writeln!(out, "{n} {}", intervals(n)?.count())?;
        progress.advance(1)?;
    }
    Ok(())
}

fn table(
    periods: &Periods,
    decimals: Option<usize>,
    (format, caption): (TableFormat, Option<&Caption>),
    out: &mut dyn Write,
    progress: &Progress,
) -> Result<()> {
    let digits = periods.0.end().to_string().len();
    let mut columns = vec![
        Column::new("n", "$n$", digits),
        Column::new("m", "$m$", digits),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("left", "left end", 2 * digits + 2),
        Column::new("right", "right end", 2 * digits + 2),
        Column::new("deciding", "deciding $k$", 0),
    ];
    if let Some(decimals) = decimals {
        columns.push(Column::new("left_rounded", "left (rounded)", decimals + 2));
        columns.push(Column::new("right_rounded", "right (rounded)", decimals + 2));
    }
    let mut table = TableWriter::set(
        out,
        format,
        "grazing-intervals 1",
        columns,
        Setting { caption, ..Setting::default() },
    )?;
    let rows = rows(periods, decimals, &mut table, progress);
    table.end(rows)
}

fn rows(
    periods: &Periods,
    decimals: Option<usize>,
    table: &mut TableWriter,
    progress: &Progress,
) -> Result<()> {
    for n in periods.0.clone() {
        // One period of ten million takes seconds: listen for Ctrl-C within it too.
        for (index, interval) in intervals(n)?.enumerate() {
            let rounded = decimals.map(|d| (decimal(&interval.left, d), decimal(&interval.right, d)));
            let mut cells = [TableCell::Empty; 9];
            cells[..7].copy_from_slice(&[
                TableCell::Int(n as i64),
                TableCell::Int(interval.m as i64),
                TableCell::Int(interval.case.sign_emu().into()),
                TableCell::Int(interval.case.sign_gamma().into()),
                TableCell::Fraction(&interval.left),
                TableCell::Fraction(&interval.right),
                interval.deciding.map_or(TableCell::Empty, |k| TableCell::Int(k as i64)),
            ]);
            let width = match &rounded {
                Some((left, right)) => {
                    cells[7..].copy_from_slice(&[TableCell::Text(left), TableCell::Text(right)]);
                    9
                }
                None => 7,
            };
            table.row(&cells[..width])?;
            if index % 4096 == 4095 {
                progress.advance(0)?;
            }
        }
        progress.advance(1)?;
    }
    Ok(())
}
