//! `grazing intervals --pattern` and `--two-impacts`: where on r = 1 patterns of two impacts exist.

use std::ops::RangeInclusive;

use num_rational::Ratio;

use super::{range::Periods, shards::RowSink};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::MAX_PERIOD,
    monitor::Monitor,
    output::{Caption, Column, Destination, Setting, TableCell, TableFormat, TableWriter, decimal},
    rows::Style,
    word::PatternInterval,
};

/// What a table of them shows, in LaTeX.
pub(super) const CAPTION: &str = "The open intervals of $s$ on $r = 1$ where there is an orbit with two impacts, $i$ \
and $j$ periods apart, and the case $(e\\mu, \\gamma)$ in which it exists.";

/// The largest period of --two-impacts: there are about n²/7 intervals of period n.
const LIMIT: u64 = 2000;

/// Reads I,J.
pub(super) fn pattern(text: &str) -> Result<(u64, u64)> {
    let part = |part: &str| part.trim().parse::<u64>().ok();
    let pair = text.split_once(',').and_then(|(i, j)| Some((part(i)?, part(j)?)));
    let ordered = pair.map(|(i, j)| (i.min(j), i.max(j)));
    ordered.filter(|&(i, j)| i >= 1 && i < j && j <= MAX_PERIOD && i + j <= MAX_PERIOD).ok_or_else(|| {
        Error::input(format!(
            "{text:?} is not a pattern of two impacts: two different periods with a comma between, as in 3,5, \
             together at most {MAX_PERIOD}"
        ))
    })
}

/// The periods of --two-impacts.
pub(super) fn periods(range: &Periods) -> Result<RangeInclusive<u64>> {
    let (first, last) = (*range.0.start(), *range.0.end());
    if first < 3 || last > LIMIT {
        return Err(Error::input(format!(
            "--two-impacts {first}..={last}: give sums of two different periods, from 3 to {LIMIT}"
        )));
    }
    Ok(range.0.clone())
}

/// Writes the intervals of the pattern (i, j) as a table, or their number as a b-file where there is no
/// table format.
pub(super) fn run<I: Iterator<Item = PatternInterval>>(
    (i, j): (u64, u64),
    intervals: impl Fn() -> Result<I>,
    format: Option<TableFormat>,
    decimals: Option<usize>,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<()> {
    let progress = Progress::new(interrupt, 1, "periods");
    let Some(format) = format else {
        return destination.list(|out| Ok(writeln!(out, "{} {}", i + j, intervals()?.count())?));
    };
    destination.list(|out| {
        let style = Style { decimals, print: format.is_print() };
        let mut columns = columns((i + j).to_string().len(), style.print);
        if let Some(decimals) = decimals {
            columns.push(Column::new("left_rounded", "left (rounded)", decimals + 2));
            columns.push(Column::new("right_rounded", "right (rounded)", decimals + 2));
        }
        let caption = Caption { text: CAPTION.into(), label: format!("tab:pattern-{i}-{j}") };
        let setting = Setting { caption: Some(&caption), ..Setting::default() };
        let mut table = TableWriter::set(out, format, "grazing-pattern-intervals 1", columns, setting)?;
        let rows = intervals().and_then(|intervals| rows(intervals, style, &mut table, &progress));
        table.end(rows)
    })
}

/// The columns, but for rounded ends.
pub(super) fn columns(digits: usize, print: bool) -> Vec<Column> {
    if print {
        return vec![
            Column::new("i", "$i$", 0),
            Column::new("j", "$j$", 0),
            Column::new("case", "case", 0),
            Column::new("left", "from", 0),
            Column::new("right", "to", 0),
        ];
    }
    vec![
        Column::new("i", "$i$", digits),
        Column::new("j", "$j$", digits),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("left", "left end", 2 * digits + 2),
        Column::new("right", "right end", 2 * digits + 2),
    ]
}

/// A row for each interval.
pub(super) fn rows(
    intervals: impl Iterator<Item = PatternInterval>,
    style: Style,
    rows: &mut dyn RowSink,
    progress: &Progress,
) -> Result<()> {
    for (index, interval) in intervals.enumerate() {
        row(&interval, style, rows)?;
        if index % 4096 == 4095 {
            progress.advance(0)?;
        }
    }
    Ok(())
}

fn row(interval: &PatternInterval, style: Style, table: &mut dyn RowSink) -> Result<()> {
    let (left, right): (&Ratio<u64>, &Ratio<u64>) = (&interval.left, &interval.right);
    let rounded = style.decimals.map(|d| (decimal(left, d), decimal(right, d)));
    let case = interval.case.to_string();
    let mut cells = vec![TableCell::Int(interval.i as i64), TableCell::Int(interval.j as i64)];
    if style.print {
        cells.push(TableCell::Maths(&case));
    } else {
        let signs = [interval.case.sign_emu(), interval.case.sign_gamma()];
        cells.extend(signs.map(|sign| TableCell::Int(sign.into())));
    }
    cells.extend([TableCell::Fraction(left), TableCell::Fraction(right)]);
    if let Some((left, right)) = &rounded {
        cells.extend([TableCell::Text(left), TableCell::Text(right)]);
    }
    table.row(&cells)
}
