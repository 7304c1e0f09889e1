//! The rows of a table of intervals: one after the other, or set by all threads and written in order. It is
//! the command line's, and here because millions of rows must be fast.

use std::ops::{Range, RangeInclusive};

use rayon::prelude::*;

use crate::{
    error::Result,
    existence::{Case, Interval, intervals, intervals_between},
    monitor::Monitor,
    output::{Numbers, RowSetter, TableCell, TableWriter, decimal},
};

/// The rows of one period, in order, each given to `row`. One of ten million takes seconds: an interruption
/// is listened for within it too.
///
/// # Errors
/// Those of `row`; an interruption; a period that is too large.
pub fn of_period(
    n: u64,
    style: Style,
    monitor: &dyn Monitor,
    row: &mut dyn FnMut(&[TableCell]) -> Result<()>,
) -> Result<()> {
    for (index, interval) in intervals(n)?.enumerate() {
        with_cells(&interval, style, &mut *row)?;
        if index % 4096 == 4095 {
            monitor.advance(0)?;
        }
    }
    Ok(())
}

/// The rows of all periods: all threads set batches of them, and this one writes a wave of batches while the
/// next is set.
///
/// Cost: O(1) operations per row and digit. Memory: two waves, about 3 MB per thread and 5 MB in JSON.
///
/// # Errors
/// Of what the table is written to; an interruption.
pub fn in_parallel(
    periods: RangeInclusive<u64>,
    style: Style,
    table: &mut TableWriter<'_>,
    monitor: &dyn Monitor,
) -> Result<()> {
    let setter = table.setter();
    let wave = 4 * rayon::current_num_threads();
    // Long decimals make long rows.
    let mut pieces = Pieces { periods, m: 0, length: BATCH / (1 + style.decimals.unwrap_or(0) as u64 / 16) };
    let (mut set, mut next): (Vec<Batch>, Vec<Batch>) = (Vec::new(), Vec::new());
    next.resize_with(wave, Batch::default);
    set.resize_with(wave, Batch::default);
    loop {
        for batch in &mut next {
            pieces.fill(&mut batch.pieces);
        }
        rayon::in_place_scope(|scope| {
            scope.spawn(|_| next.par_iter_mut().for_each(|batch| batch.set(&setter, style)));
            set.iter().try_for_each(|batch| {
                table.rows_set(&batch.rows)?;
                monitor.advance(batch.pieces.iter().filter(|piece| piece.ends_period()).count() as u64)
            })
        })?;
        std::mem::swap(&mut set, &mut next);
        if set.iter().all(|batch| batch.pieces.is_empty()) {
            return Ok(());
        }
    }
}

/// The values of m in a batch: at most two rows each, of 35 bytes or so.
const BATCH: u64 = 4096;

/// The rows of one period with m in a range.
struct Piece {
    n: u64,
    m: Range<u64>,
}

impl Piece {
    fn ends_period(&self) -> bool {
        self.m.end > self.n / 2
    }
}

/// Pieces and, once they are set, their rows.
#[derive(Default)]
struct Batch {
    pieces: Vec<Piece>,
    rows: Vec<u8>,
}

impl Batch {
    fn set(&mut self, setter: &RowSetter, style: Style) {
        self.rows.clear();
        let pieces = self.pieces.iter().flat_map(|Piece { n, m }| intervals_between(*n, m.clone()));
        if setter.is_csv() && style.decimals.is_none() {
            let mut numbers = Numbers::new(&mut self.rows);
            return pieces.for_each(|interval| csv(&interval, &mut numbers));
        }
        pieces.for_each(|interval| with_cells(&interval, style, |cells| setter.set(&mut self.rows, cells)));
    }
}

/// All pieces of a range of periods, in order; those before (start of `periods`, `m`) are done.
struct Pieces {
    periods: RangeInclusive<u64>,
    m: u64,
    length: u64,
}

impl Pieces {
    /// The next ones, with so many values of m together; none at the end.
    fn fill(&mut self, pieces: &mut Vec<Piece>) {
        pieces.clear();
        let mut left = self.length;
        while left > 0 && !self.periods.is_empty() {
            let n = *self.periods.start();
            let end = (n / 2 + 1).min(self.m + left);
            left -= end - self.m;
            pieces.push(Piece { n, m: self.m..end });
            self.m = end;
            if end > n / 2 {
                self.m = 0;
                self.periods.next();
            }
        }
    }
}

/// How rows are written.
#[derive(Debug, Clone, Copy)]
pub struct Style {
    /// The digits of rounded ends, if they are asked for.
    pub decimals: Option<usize>,
    /// As print has it: a block per period, cases and the deciding b in place of numbers.
    pub print: bool,
}

/// An interval's row in CSV: the bytes that are set of its cells, in a third of the time.
fn csv(interval: &Interval, numbers: &mut Numbers) {
    let Interval { n, m, case, left, right, deciding } = interval;
    numbers.number(*n, b',');
    numbers.number(*m, b',');
    let signs = match case {
        Case::MinusMinus => b"-1,-1,\0\0",
        Case::MinusPlus => b"-1,1,\0\0\0",
        Case::PlusMinus => b"1,-1,\0\0\0",
        Case::PlusPlus => b"1,1,\0\0\0\0",
    };
    let length = 4 + usize::from(case.sign_emu() < 0) + usize::from(case.sign_gamma() < 0);
    numbers.word(u64::from_le_bytes(*signs), length);
    for end in [left, right] {
        numbers.number(*end.numer(), b'/');
        numbers.number(*end.denom(), b',');
    }
    match deciding {
        Some(k) => numbers.number(*k, b'\n'),
        None => numbers.word(b'\n'.into(), 1),
    }
}

/// Gives the cells of an interval's row to `use_cells`.
fn with_cells<T>(interval: &Interval, style: Style, use_cells: impl FnOnce(&[TableCell]) -> T) -> T {
    let Interval { n, case, left, right, .. } = interval;
    let (name, decides);
    let (mut cells, mut count) = ([TableCell::Empty; 9], 0);
    let mut push = |cell| {
        cells[count] = cell;
        count += 1;
    };
    if style.print {
        // The first one of a period is at 0; of period 1 both are.
        let begins = interval.m == 0 && (*n > 1 || case.sign_emu() > 0);
        push(if begins { TableCell::Int(*n as i64) } else { TableCell::Empty });
        name = case.to_string();
        push(TableCell::Maths(&name));
    } else {
        push(TableCell::Int(*n as i64));
        push(TableCell::Int(interval.m as i64));
        push(TableCell::Int(case.sign_emu().into()));
        push(TableCell::Int(case.sign_gamma().into()));
    }
    push(TableCell::Fraction(left));
    push(TableCell::Fraction(right));
    match interval.deciding {
        Some(k) if style.print => {
            decides = format!("b_{{{n},{k}}}");
            push(TableCell::Maths(&decides));
        }
        Some(k) => push(TableCell::Int(k as i64)),
        None => push(TableCell::Empty),
    }
    let rounded;
    if let Some(digits) = style.decimals {
        rounded = [left, right].map(|end| decimal(end, digits));
        push(TableCell::Text(&rounded[0]));
        push(TableCell::Text(&rounded[1]));
    }
    use_cells(&cells[..count])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::{Column, TableFormat};

    /// Numbers of one to eight digits, all cases, and intervals that no b decides.
    #[test]
    fn csv_is_what_is_set_of_cells() {
        let columns = ["n", "m", "emu", "gamma", "left", "right", "k"].map(|name| Column::new(name, "", 0));
        let mut out = Vec::new();
        let table = TableWriter::new(&mut out, TableFormat::Csv, "", columns.into()).unwrap();
        let (setter, style) = (table.setter(), Style { decimals: None, print: false });
        let short = (1..=120).map(|n| Piece { n, m: 0..n / 2 + 1 });
        let long = [9_999, 10_000, 10_001, 99_991, 1_234_567, 9_999_991, 10_000_000]
            .map(|n| [0..40, n / 3..n / 3 + 40, n / 2 - 30..n / 2 + 1].map(|m| Piece { n, m }));
        let pieces: Vec<Piece> = short.chain(long.into_iter().flatten()).collect();
        let mut wanted = Vec::new();
        for interval in pieces.iter().flat_map(|piece| intervals_between(piece.n, piece.m.clone())) {
            with_cells(&interval, style, |cells| setter.set(&mut wanted, cells));
        }
        let mut batch = Batch { pieces, rows: Vec::new() };
        batch.set(&setter, style);
        assert_eq!(String::from_utf8(batch.rows).unwrap(), String::from_utf8(wanted).unwrap());
    }

    /// Batches of every length have each m of each period once, in order.
    #[test]
    fn pieces_are_all_rows_in_order() {
        let wanted: Vec<(u64, u64)> = (1..=40).flat_map(|n| (0..=n / 2).map(move |m| (n, m))).collect();
        for length in [1, 2, 3, 7, 20, 64, 4096] {
            let mut pieces = Pieces { periods: 1..=40, m: 0, length };
            let (mut found, mut batch, mut ended) = (Vec::new(), Vec::new(), 0);
            loop {
                pieces.fill(&mut batch);
                if batch.is_empty() {
                    break;
                }
                assert!(batch.iter().map(|piece| piece.m.end - piece.m.start).sum::<u64>() <= length);
                ended += batch.iter().filter(|piece| piece.ends_period()).count();
                found.extend(batch.iter().flat_map(|piece| piece.m.clone().map(|m| (piece.n, m))));
            }
            assert_eq!((&found, ended), (&wanted, 40), "{length}");
        }
    }
}
