//! A certificate's contents, as written and as read.

use std::fmt;

use super::{
    super::{
        Rejection,
        text::{Decimal, Fraction, Setting, periods, setting},
    },
    STATEMENT,
};
use crate::{
    header::expect_statement,
    lines::{Lines, Words},
    touch::text::{count, line, positive},
};

/// The most cells, and periods of returns.
const CELLS: u64 = 2000;
const RETURNS: u64 = 200;
/// The most of both, multiplied: as many returns the check may look at.
const WORK: u64 = 40_000;
/// The greatest weight.
const WEIGHT: u64 = 1_000_000;

/// Contacts with |V|/√ν from the end of the cell before, or 0, to its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// Its end.
    pub end: Decimal,
    /// What displacements count there.
    pub weight: u64,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Of what, and where; its depth is the greatest.
    pub setting: Setting,
    /// The least ν.
    pub least: Fraction,
    /// X.
    pub start: Decimal,
    /// G.
    pub growth: Decimal,
    /// R.
    pub rate: Decimal,
    /// L.
    pub last: u64,
    /// The cells, from 0 to S.
    pub cells: Vec<Cell>,
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\nkind {} 2\nstatement {STATEMENT}\n", crate::FORMAT, super::super::KIND)?;
        self.setting.write(f, Some(self.least))?;
        writeln!(f, "start {}\ngrowth {} {} {}", self.start, self.growth, self.rate, self.last)?;
        writeln!(f, "cells {}", self.cells.len())?;
        self.cells.iter().try_for_each(|Cell { end, weight }| writeln!(f, "cell {end} {weight}"))
    }
}

fn cell(words: &mut Words) -> Result<Cell, String> {
    let end = positive(words, "a cell's end")?;
    let weight = words.number("a weight", WEIGHT)?;
    if weight > 0 { Ok(Cell { end, weight }) } else { Err("a weight is at least 1".into()) }
}

/// Everything after the kind line, to the end.
pub(super) fn read(lines: &mut Lines) -> Result<Certificate, Rejection> {
    expect_statement(lines, STATEMENT)?;
    let (setting, least) = setting(lines, true)?;
    let start = line(lines, "start", |words| positive(words, "a start"))?;
    let (growth, rate, last) = line(lines, "growth", |words| {
        Ok((positive(words, "a growth")?, positive(words, "an exponent")?, periods(words, RETURNS)?))
    })?;
    lines.form(growth.digits > 10i128.pow(growth.places), "a growth must be above 1")?;
    let number = count(lines, "cells", "the number of cells", CELLS)?;
    let work = number * last;
    let reason =
        format_args!("the check would take up to {work} returns, more than {WORK}: fewer cells or periods");
    lines.form(work <= WORK, reason)?;
    let mut cells: Vec<Cell> = Vec::new();
    for _ in 0..number {
        let next = line(lines, "cell", cell)?;
        let increases = cells.last().is_none_or(|before| before.end.parts() < next.end.parts());
        lines.form(increases, "the ends of cells increase")?;
        cells.push(next);
    }
    let whole = cells.last().is_some_and(|last| last.end.parts() == setting.speed.parts());
    lines.form(whole, "the last cell ends at the speed")?;
    lines.end("the file goes on after its last line")?;
    let least = least.unwrap_or(setting.depth);
    Ok(Certificate { setting, least, start, growth, rate, last, cells })
}
