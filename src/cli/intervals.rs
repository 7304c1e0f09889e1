//! `grazing intervals`: Theorem 2's intervals as tables.

use std::{io::Write, path::PathBuf};

use clap::{Parser, ValueEnum};

use super::{Outcome, range::Periods};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::{MAX_PERIOD, intervals},
    monitor::Monitor,
    output::{Cell, Column, Destination, TableFormat, TableWriter, decimal},
};

/// List Theorem 2's intervals of s: where on r = 1 single-impact orbits of period n exist.
///
/// Columns: n; m, the integer nearest to n s; the signs of e*mu and gamma; both ends as exact fractions; the k whose
/// b_{n,k} alone decides existence for r < 1. Periods 1 and 2 get their intervals from the summary by period. The
/// format bfile lists the number of intervals of each n instead.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// The periods: N, or A..=B. At most 10000000.
    #[arg(value_name = "N|A..=B")]
    periods: Periods,
    /// How the table is written.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(super) format: Format,
    /// Add both ends as decimals, rounded to D digits (at most 1000).
    #[arg(long, value_name = "D")]
    decimals: Option<usize>,
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
    args.periods.within(MAX_PERIOD, "intervals")?;
    if let Some(digits) = args.decimals.filter(|&digits| digits > 1000) {
        return Err(Error::input(format!("--decimals {digits} is too many: at most 1000")));
    }
    let destination = Destination::new(args.output.as_deref())?;
    let progress = Progress::new(interrupt, args.periods.count(), "periods");
    let format = match args.format {
        Format::Table => TableFormat::Table,
        Format::Csv => TableFormat::Csv,
        Format::Json => TableFormat::Json,
        Format::Latex => TableFormat::Latex,
        Format::Markdown => TableFormat::Markdown,
        Format::Bfile => {
            destination.list(|out| bfile(args, out, &progress))?;
            return Ok(Outcome::Done);
        }
    };
    destination.list(|out| table(args, format, out, &progress))?;
    Ok(Outcome::Done)
}

fn bfile(args: &Args, out: &mut dyn Write, progress: &Progress) -> Result<()> {
    for n in args.periods.0.clone() {
        writeln!(out, "{n} {}", intervals(n)?.count())?;
        progress.advance(1)?;
    }
    Ok(())
}

fn table(args: &Args, format: TableFormat, out: &mut dyn Write, progress: &Progress) -> Result<()> {
    let digits = args.periods.0.end().to_string().len();
    let mut columns = vec![
        Column::new("n", "$n$", digits),
        Column::new("m", "$m$", digits),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("left", "left end", 2 * digits + 2),
        Column::new("right", "right end", 2 * digits + 2),
        Column::new("deciding", "deciding $k$", 0),
    ];
    if let Some(decimals) = args.decimals {
        columns.push(Column::new("left_rounded", "left (rounded)", decimals + 2));
        columns.push(Column::new("right_rounded", "right (rounded)", decimals + 2));
    }
    let mut table = TableWriter::new(out, format, "grazing-intervals 1", columns)?;
    let rows = rows(args, &mut table, progress);
    table.end(rows)
}

fn rows(args: &Args, table: &mut TableWriter, progress: &Progress) -> Result<()> {
    for n in args.periods.0.clone() {
        // One period of ten million takes seconds: listen for Ctrl-C within it too.
        for (index, interval) in intervals(n)?.enumerate() {
            let rounded = args.decimals.map(|d| (decimal(&interval.left, d), decimal(&interval.right, d)));
            let mut cells = [Cell::Empty; 9];
            cells[..7].copy_from_slice(&[
                Cell::Int(n as i64),
                Cell::Int(interval.m as i64),
                Cell::Int(interval.case.sign_emu().into()),
                Cell::Int(interval.case.sign_gamma().into()),
                Cell::Fraction(&interval.left),
                Cell::Fraction(&interval.right),
                interval.deciding.map_or(Cell::Empty, |k| Cell::Int(k as i64)),
            ]);
            let width = match &rounded {
                Some((left, right)) => {
                    cells[7..].copy_from_slice(&[Cell::Text(left), Cell::Text(right)]);
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
