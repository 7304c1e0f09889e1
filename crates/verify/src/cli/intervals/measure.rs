//! `grazing intervals --measure`: how much of r = 1 each period takes.

use super::{Format, Periods};
use crate::{
    cli::{
        cite,
        progress::{Interrupt, Progress},
    },
    error::{Error, Result},
    existence::{MAX_DECIMALS, MAX_EXACT, MAX_PERIOD, PeriodMeasure, measure, measures},
    monitor::Monitor,
    output::{Column, Destination, Print, Setting, TableCell, TableWriter},
};

/// The largest period with a fraction, where there are several.
const EXACT: u64 = 10_000;
/// The largest one whose fraction is printed on a page.
const PRINTED: u64 = 40;
/// Decimals unless others are asked for.
const DECIMALS: usize = 15;

/// What the table shows, in LaTeX.
const CAPTION: &str = "The total length $L_n$ of the intervals of $s$ in $(0, \\frac12)$ on $r = 1$ where there is an \
orbit with one impact in $n$ periods, and the mean number of the periods $3, \\dots, n$ that exist at one $s$. Decimals \
are rounded; every digit is certain.";

/// Writes a row for each period.
pub(super) fn run(
    periods: &Periods,
    format: Format,
    decimals: Option<usize>,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<()> {
    let (first, last) = periods.within(MAX_PERIOD, "intervals --measure")?.into_inner();
    if first < 3 {
        return Err(Error::input(format!(
            "--measure {first}: the measure is that of a period from 3 on; period 1 exists for every s, and 2 \
             for every s but 1/4"
        )));
    }
    let decimals = decimals.unwrap_or(DECIMALS);
    if !(1..=MAX_DECIMALS as usize).contains(&decimals) {
        return Err(Error::input(format!("--digits {decimals}: from 1 to {MAX_DECIMALS} with --measure")));
    }
    let Some(format) = format.of_table() else {
        return Err(Error::input(
            "--format bfile has whole numbers; `grazing sequence` lists L_n as two of them",
        ));
    };
    let exact = if first == last { MAX_EXACT } else { EXACT };
    let wide = if last <= PRINTED { Print::Right } else { Print::Omitted };
    let columns = vec![
        Column::new("n", "$n$", last.to_string().len()),
        Column::new("length_decimal", "$L_n$", decimals + 2),
        Column::new("mean", "$2(L_3+\\dots+L_n)$", decimals + 4),
        Column::new("length", "$L_n$, exactly", 0).print(wide),
    ];
    let progress = Progress::new(interrupt, last - first + 1, "periods");
    destination.list(|out| {
        let caption = cite::plain("measure", CAPTION, periods);
        let setting = Setting { caption: Some(&caption), ..Setting::default() };
        let mut table = TableWriter::set(out, format, "grazing-measure 1", columns, setting)?;
        let rows = measures(last, &progress, |PeriodMeasure { n, length, mean, .. }| {
            if n < first {
                return Ok(());
            }
            let digits = decimals as u32;
            let fraction = if n <= exact { Some(measure(n)?) } else { None };
            let fraction = fraction.map(|x| format!("{}/{}", x.numer(), x.denom()));
            let cell = if format.is_print() { TableCell::Maths } else { TableCell::Text };
            table.row(&[
                TableCell::Int(n as i64),
                TableCell::Text(&length.decimals(digits)),
                TableCell::Text(&mean.decimals(digits)),
                fraction.as_deref().map_or(TableCell::Empty, cell),
            ])?;
            progress.advance(1)
        });
        table.end(rows)
    })
}
