//! `grazing boundary`: the lower edges of the areas of Conjecture 1, and how far down they reach.

use std::{ops::RangeInclusive, path::PathBuf, str::FromStr};

use clap::Parser;
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Zero, pow};
use rayon::prelude::*;

use super::{
    Outcome,
    cite::{self, Basis},
    range::Periods,
    reported,
    shards::{Merged, Part, RowSink, ShardRows, ShardSet, part_of, periods_of, task_of},
};
use crate::{
    certificate::cover,
    cli::choice::{Choice, choice},
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::{Boundary, Enclosure, Interval, Lowest, intervals, tip_correction, tip_law},
    local::Rung,
    monitor::{Monitor, timed},
    number::parse_integer,
    output::{
        Column, Destination, FileRegistry, Print, Setting, Shard, ShardedTask, TableCell, TableFormat,
        TableWriter, decimal_above, decimal_below, decimal_near,
    },
};

/// The largest period: beyond it the law of the tips says more than a table.
const MAX_PERIOD: u64 = 100_000;
const MAX_GRID: u64 = 1_000_000;
const MAX_DIGITS: u32 = 1000;

/// Enclose the lower edge r = R(s) of each area of Conjecture 1, or its lowest point.
///
/// Without --grid the table has one row per area: the infimum of r and of a2 = r^2 over the area, regions 3
/// and 4 together, and where it is approached. Areas are open, so they do not attain it. Below it no orbit of
/// period n can appear, whatever s; 0 says that no damping forbids the orbit. Beside it stand (1 - r) n^3 and
/// its limit for large n, G (the law of the tips), alone and with the next term.
///
/// With --grid G the table has R(s) at G evenly spaced s inside each interval of Theorem 2.
///
/// Bounds are certified: the true value is not below *_lower and not above *_upper.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted, or some value could
/// not be certified (its cells are empty).
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing boundary 3..=8
  grazing boundary 5 --m 2 --grid 3 --digits 20")]
pub struct Args {
    /// The periods: N, or A..=B, from 2 to 100000.
    #[arg(value_name = "N|A..=B")]
    periods: Periods,
    /// Only the areas next to M/N.
    #[arg(long, value_name = "M", value_parser = parse_integer::<u64>)]
    m: Option<u64>,
    /// R(s) at G values of s in each interval, at most 1000000.
    #[arg(long, value_name = "G", value_parser = parse_integer::<u64>)]
    grid: Option<u64>,
    /// The number of decimals, 1 to 1000.
    #[arg(long, value_name = "D", default_value_t = 12, value_parser = parse_integer::<u32>)]
    digits: u32,
    /// How the table is written.
    #[arg(long, value_parser = choice::<TableFormat>(), default_value = "table")]
    pub(super) format: TableFormat,
    /// Cite this certificate, from `grazing cover`, in the caption of the LaTeX table, by its SHA-256; - is
    /// standard input. It is checked first. It proves that nothing but b_{n,k} bounds the areas.
    #[arg(long, value_name = "CERTIFICATE")]
    cite: Option<PathBuf>,
    /// Enclose the I-th of N parts only, and write a shard of the table to -o, for `grazing merge`.
    #[arg(long, value_name = "I/N", requires = "output", value_parser = Shard::from_str, conflicts_with = "cite")]
    shard: Option<Shard>,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

fn check(args: &Args) -> Result<()> {
    args.periods.within(MAX_PERIOD, "boundary")?;
    if *args.periods.0.start() < 2 {
        return Err(Error::input("`grazing boundary` starts at period 2: period 1 has no b to forbid it"));
    }
    if !(1..=MAX_DIGITS).contains(&args.digits) {
        return Err(Error::input(format!("--digits {} is out of bounds: 1 to {MAX_DIGITS}", args.digits)));
    }
    if let Some(grid) = args.grid.filter(|grid| !(1..=MAX_GRID).contains(grid)) {
        return Err(Error::input(format!("--grid {grid} is out of bounds: 1 to {MAX_GRID}")));
    }
    if args.cite.is_some() && !args.format.is_print() {
        return Err(Error::input("--cite does nothing here: only --format latex has a caption"));
    }
    Ok(())
}

/// What shards are parts of.
fn task(args: &Args) -> ShardedTask {
    let mut words = vec!["boundary".to_string(), format!("{:?}", args.periods.0)];
    words.extend(args.m.iter().flat_map(|m| ["--m".to_string(), m.to_string()]));
    words.extend(args.grid.iter().flat_map(|grid| ["--grid".to_string(), grid.to_string()]));
    words.extend(["--digits".to_string(), args.digits.to_string()]);
    words.extend(["--format".to_string(), args.format.word().to_string()]);
    task_of(words)
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    check(args)?;
    if let (Some(shard), Some(output)) = (args.shard, &args.output) {
        let part = Part { task: task(args), shard, file: files.write("-o", output)? };
        let periods = periods_of(&args.periods.0, 2, Some(shard));
        let progress = Progress::new(interrupt, periods.clone().count() as u64, "periods");
        let mut certain = true;
        part.write(|out| {
            let mut rows = Watched { rows: &mut ShardRows::new(out), at: watched(args), certain: true };
            find(args, periods, &mut rows, &progress)?;
            certain = rows.certain;
            Ok(())
        })?;
        return Ok(if certain { Outcome::Done } else { Outcome::Undecided });
    }
    let (name, text) = about(args);
    let about = (name, text, BASES.as_slice());
    let cited = args.cite.as_slice();
    cite::named(cited, files)?;
    let destination = files.destination(args.output.as_deref())?;
    let caption = match cite::caption(cited, about, &args.periods, interrupt)? {
        Ok(caption) => caption,
        Err(outcome) => return Ok(outcome),
    };
    let setting = Setting { caption: Some(&caption), ..Setting::at(&destination) };
    let progress = Progress::new(interrupt, args.periods.count(), "periods");
    written(args, setting, &destination, |rows| find(args, args.periods.0.clone(), rows, &progress))
}

/// The table from its shards.
pub(super) fn merge(args: &Args, set: &ShardSet, merged: &Merged, interrupt: &Interrupt) -> Result<Outcome> {
    check(args)?;
    set.expect(&task(args))?;
    let destination = merged.table()?;
    let (name, text) = about(args);
    let caption = cite::plain(name, text, &args.periods);
    let setting = Setting { caption: Some(&caption), ..Setting::at(&destination) };
    written(args, setting, &destination, |rows| {
        set.rows(
            |shard| part_of(&args.periods.0, 2, shard),
            columns(args).len(),
            |cells| {
                interrupt.check()?;
                rows.row(cells)
            },
        )
    })
}

/// Writes the table whose rows `find` gives; undecided if some value is not certified.
fn written(
    args: &Args,
    setting: Setting<'_>,
    destination: &Destination,
    find: impl FnOnce(&mut dyn RowSink) -> Result<()>,
) -> Result<Outcome> {
    let name = if args.grid.is_some() { "grazing-boundary-grid 1" } else { "grazing-boundary 1" };
    let mut certain = true;
    let written = destination.write(|out| {
        let mut table = TableWriter::set(out, args.format, name, columns(args), setting)?;
        let mut rows = Watched { rows: &mut table, at: watched(args), certain: true };
        let found = find(&mut rows);
        certain = rows.certain;
        table.end(found)
    });
    reported(if certain { Outcome::Done } else { Outcome::Undecided }, written)
}

fn find(
    args: &Args,
    periods: RangeInclusive<u64>,
    rows: &mut dyn RowSink,
    progress: &Progress,
) -> Result<()> {
    match args.grid {
        Some(grid) => edge_rows(args, periods, grid, rows, progress),
        None => lowest_rows(args, periods, rows, progress),
    }
}

/// Notices what was not certified: rows in which a cell is empty.
struct Watched<'a> {
    rows: &'a mut dyn RowSink,
    /// The cell.
    at: usize,
    certain: bool,
}

impl RowSink for Watched<'_> {
    fn row(&mut self, cells: &[TableCell]) -> Result<()> {
        self.certain &= cells[self.at] != TableCell::Empty;
        self.rows.row(cells)
    }

    fn done(&mut self, period: u64) -> Result<()> {
        self.rows.done(period)
    }
}

/// The column that is empty in rows without a certified value: the kind of a lowest point, or r ≥.
fn watched(args: &Args) -> usize {
    area_columns(0, args.format).len() + usize::from(args.grid.is_some())
}

fn columns(args: &Args) -> Vec<Column> {
    let width = args.periods.0.end().to_string().len();
    let mut columns = area_columns(width, args.format);
    if args.grid.is_some() {
        columns.push(Column::new("s", "$s$", 2 * width + 4));
        columns.extend(bound_columns(args.digits));
        return columns;
    }
    columns.push(Column::new("lowest", "lowest", 8).print(Print::Left));
    columns.extend(bound_columns(args.digits));
    let s_width = args.digits as usize / 2 + 2;
    columns.push(Column::new("s_lower", "$s \\ge$", s_width));
    columns.push(Column::new("s_upper", "$s \\le$", s_width));
    columns.push(Column::new("scaled", "$(1 - r)n^3$", 12).print(Print::Omitted));
    columns.push(Column::new("law", "$G$", 12).print(Print::Omitted));
    columns.push(Column::new("law_next", "$G + G_2/n^2$", 12).print(Print::Omitted));
    columns
}

/// The name of the table in labels, and what it shows, in LaTeX.
fn about(args: &Args) -> (&'static str, &'static str) {
    if args.grid.is_some() { ("boundary-grid", EDGES) } else { ("boundary", TIPS) }
}

const TIPS: &str = "Bounds of the infimum of $r$ over each area in which there is an orbit with one impact in \
$n$ periods, the case $(e\\mu, \\gamma)$ of the orbit, and bounds of the $s$ at which the infimum is approached.";

const EDGES: &str = "Bounds of $R(s)$, the lower edge of each area in which there is an orbit with one impact in \
$n$ periods, and the case $(e\\mu, \\gamma)$ of the orbit.";

/// What a table of edges can rest on.
const BASES: [Basis; 1] = [Basis {
    kind: cover::KIND,
    proves: "That $b_{n,k} = 0$ alone bounds each area for $r$ up to the certificate's $r_{\\max} < 1$ is proved",
    command: "grazing cover",
}];

/// The areas of one period that the user asked for.
fn areas(args: &Args, n: u64) -> Result<Vec<Boundary>> {
    let wanted = |interval: &Interval| args.m.is_none_or(|m| m == interval.m);
    let areas: Vec<Boundary> = intervals(n)?.filter(wanted).map(Boundary::new).collect();
    match args.m {
        Some(m) if areas.is_empty() => Err(Error::input(format!(
            "period {n} has no area at m = {m}: m is 0, or at most {} and coprime to {n}",
            n / 2
        ))),
        _ => Ok(areas),
    }
}

/// The columns that say which area a row is about.
fn area_columns(digits: usize, format: TableFormat) -> Vec<Column> {
    if format.is_print() {
        return vec![
            Column::new("n", "$n$", 0),
            Column::new("case", "case", 0),
            Column::new("deciding", "decides", 0),
        ];
    }
    vec![
        Column::new("n", "$n$", digits),
        Column::new("m", "$m$", digits),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("deciding", "$k$", 0),
    ]
}

/// Which area a row is about.
struct Area<'a> {
    interval: &'a Interval,
    /// For a page: the case, and what decides.
    printed: Option<(String, String)>,
}

impl<'a> Area<'a> {
    fn new(interval: &'a Interval, format: TableFormat) -> Self {
        let decides = || interval.deciding.map_or(String::new(), |k| format!("b_{{{},{k}}}", interval.n));
        let printed = format.is_print().then(|| (interval.case.to_string(), decides()));
        Area { interval, printed }
    }

    /// The cells of [`area_columns`].
    fn cells(&self) -> Vec<TableCell<'_>> {
        let Area { interval, printed } = self;
        let n = TableCell::Int(interval.n as i64);
        if let Some((case, decides)) = printed {
            let decides = if decides.is_empty() { TableCell::Empty } else { TableCell::Maths(decides) };
            return vec![n, TableCell::Maths(case), decides];
        }
        vec![
            n,
            TableCell::Int(interval.m as i64),
            TableCell::Int(interval.case.sign_emu().into()),
            TableCell::Int(interval.case.sign_gamma().into()),
            interval.deciding.map_or(TableCell::Empty, |k| TableCell::Int(k as i64)),
        ]
    }
}

/// Lower and upper bounds of r and a₂, or nothing.
fn bounds(r: Option<&Enclosure>, digits: u32) -> [String; 4] {
    let Some(r) = r else { return Default::default() };
    if r.upper.is_zero() {
        // Exactly: no zeros that look like rounded ones.
        return ["0"; 4].map(String::from);
    }
    let a2 = r.square();
    [
        decimal_below(&r.lower, digits),
        decimal_above(&r.upper, digits),
        decimal_below(&a2.lower, digits),
        decimal_above(&a2.upper, digits),
    ]
}

fn bound_columns(digits: u32) -> impl Iterator<Item = Column> {
    BOUNDS.into_iter().enumerate().map(move |(i, (name, latex))| {
        let column = Column::new(name, latex, digits as usize + 2);
        // A page has room for r or for a₂ = r².
        if i < 2 { column } else { column.print(Print::Omitted) }
    })
}

const BOUNDS: [(&str, &str); 4] = [
    ("r_lower", "$r \\ge$"),
    ("r_upper", "$r \\le$"),
    ("a2_lower", "$a_2 \\ge$"),
    ("a2_upper", "$a_2 \\le$"),
];

fn text(value: &str) -> TableCell<'_> {
    if value.is_empty() { TableCell::Empty } else { TableCell::Text(value) }
}

/// R(s) on a grid.
fn edge_rows(
    args: &Args,
    periods: RangeInclusive<u64>,
    grid: u64,
    table: &mut dyn RowSink,
    progress: &Progress,
) -> Result<()> {
    for n in periods {
        for area in areas(args, n)? {
            // In portions, so that Ctrl-C is heard and memory stays bounded.
            let places: Vec<u64> = (1..=grid).collect();
            for portion in places.chunks(256) {
                let values: Result<Vec<_>> = portion
                    .par_iter()
                    .map(|&i| {
                        let s = grid_point(area.interval(), i, grid);
                        let at = BigRational::new((*s.numer()).into(), (*s.denom()).into());
                        let rung = Rung::Ball(area.bits(args.digits));
                        Ok((s, timed(progress, rung, || area.at(&at, args.digits))?))
                    })
                    .collect();
                for (s, r) in values? {
                    let bounds = bounds(r.as_ref(), args.digits);
                    let about = Area::new(area.interval(), args.format);
                    let mut cells = about.cells();
                    cells.push(TableCell::Fraction(&s));
                    cells.extend(bounds.iter().map(|bound| text(bound)));
                    table.row(&cells)?;
                }
                progress.advance(0)?;
            }
        }
        table.done(n)?;
        progress.advance(1)?;
    }
    Ok(())
}

/// left + i(right − left)/(grid + 1). Terms below 2·10⁵·10⁵·10⁶ < 2⁶⁴.
fn grid_point(interval: &Interval, i: u64, grid: u64) -> Ratio<u64> {
    let (p, q) = (interval.left.numer(), interval.left.denom());
    let (p2, q2) = (interval.right.numer(), interval.right.denom());
    Ratio::new(p * q2 * (grid + 1 - i) + p2 * q * i, q * q2 * (grid + 1))
}

/// The lowest points.
fn lowest_rows(
    args: &Args,
    periods: RangeInclusive<u64>,
    table: &mut dyn RowSink,
    progress: &Progress,
) -> Result<()> {
    let width = args.periods.0.end().to_string().len();
    for n in periods {
        for portion in areas(args, n)?.chunks(64) {
            // (1 − r) n³ is to have its six decimals, however few of r are printed.
            let digits = args.digits.max(8 + 3 * width as u32);
            let lowest =
                |area: &Boundary| timed(progress, Rung::Ball(area.bits(digits)), || area.lowest(digits));
            let found: Vec<Option<Lowest>> = portion.par_iter().map(lowest).collect();
            for (area, lowest) in portion.iter().zip(&found) {
                let row = Row::new(area.interval(), lowest.as_ref(), args.digits);
                let about = Area::new(area.interval(), args.format);
                let mut cells = about.cells();
                cells.push(text(row.kind));
                cells.extend(row.numbers.iter().map(|number| text(number)));
                table.row(&cells)?;
            }
            progress.advance(0)?;
        }
        table.done(n)?;
        progress.advance(1)?;
    }
    Ok(())
}

/// What is said of a lowest point.
struct Row {
    kind: &'static str,
    numbers: Vec<String>,
}

impl Row {
    fn new(interval: &Interval, lowest: Option<&Lowest>, digits: u32) -> Row {
        let zero = Enclosure::zero();
        let (kind, r, s) = match lowest {
            None => ("", None, None),
            Some(Lowest::Zero { left, right }) => {
                ("interval", Some(&zero), Some(Enclosure { lower: left.clone(), upper: right.clone() }))
            }
            Some(Lowest::Region4) => ("region4", Some(&zero), None),
            Some(Lowest::Tip(tip)) => ("tip", Some(&tip.r), Some(tip.s.clone())),
        };
        let mut numbers = bounds(r, digits).to_vec();
        // The place of a minimum is known to half the digits of its value.
        let half = digits.div_ceil(2);
        numbers.extend(match s {
            Some(s) => [decimal_below(&s.lower, half), decimal_above(&s.upper, half)],
            None => Default::default(),
        });
        let (Some(Lowest::Tip(tip)), Some(k)) = (lowest, interval.deciding) else {
            numbers.extend(["", "", ""].map(String::from));
            return Row { kind, numbers };
        };
        let cube = BigRational::from_integer(pow(BigInt::from(interval.n), 3));
        let (n, t) = (interval.n as f64, k as f64 / interval.n as f64);
        let (_, law) = tip_law(t);
        numbers.push(decimal_near(&((BigRational::one() - tip.r.middle()) * cube), 6));
        numbers.push(format!("{law:.6}"));
        numbers.push(format!("{:.6}", law + tip_correction(t) / (n * n)));
        Row { kind, numbers }
    }
}
