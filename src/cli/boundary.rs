//! `grazing boundary`: the lower edges of the areas of Conjecture 1, and how far down they reach.

use std::{io::Write, path::PathBuf};

use clap::Parser;
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, pow};
use rayon::prelude::*;

use super::{
    Outcome,
    cite::{self, Basis},
    range::Periods,
    reported,
};
use crate::{
    certificate::cover,
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::{Boundary, Enclosure, Interval, Lowest, intervals, tip_correction, tip_law},
    monitor::Monitor,
    number::parse_integer,
    output::{
        Column, Destination, Print, Setting, TableCell, TableFormat, TableWriter, decimal_above,
        decimal_below, decimal_near,
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
pub(super) struct Args {
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
    #[arg(long, value_enum, default_value_t = TableFormat::Table)]
    pub(super) format: TableFormat,
    /// Cite this certificate, from `grazing cover`, in the caption of the LaTeX table, by its SHA-256; - is
    /// standard input. It is checked first. It proves that nothing but b_{n,k} bounds the areas.
    #[arg(long, value_name = "CERTIFICATE")]
    cite: Option<PathBuf>,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
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
    if args.cite.is_some() && args.format != TableFormat::Latex {
        return Err(Error::input("--cite does nothing here: only --format latex has a caption"));
    }
    let destination = Destination::new(args.output.as_deref())?;
    let (name, about) = match args.grid {
        Some(_) => ("boundary-grid", EDGES),
        None => ("boundary", TIPS),
    };
    let about = (name, about, BASES.as_slice());
    let files = args.cite.as_slice();
    let caption = match cite::caption(files, about, &args.periods, args.output.as_deref(), interrupt)? {
        Ok(caption) => caption,
        Err(outcome) => return Ok(outcome),
    };
    let setting = Setting { caption: caption.as_ref(), ..Setting::at(&destination) };
    let progress = Progress::new(interrupt, args.periods.count(), "periods");
    let mut certain = true;
    let written = destination.write(|out| {
        certain = match args.grid {
            Some(grid) => edges(args, grid, setting, out, &progress)?,
            None => lowest(args, setting, out, &progress)?,
        };
        Ok(())
    });
    reported(if certain { Outcome::Done } else { Outcome::Undecided }, written)
}

const TIPS: &str = "Bounds of the infimum of $r$ over each area in which there is an orbit with one impact in \
$n$ periods, and of the $s$ at which it is approached.";

const EDGES: &str = "Bounds of $R(s)$, the lower edge of each area in which there is an orbit with one impact in \
$n$ periods.";

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
fn area_columns(digits: usize) -> Vec<Column> {
    vec![
        Column::new("n", "$n$", digits),
        Column::new("m", "$m$", digits),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("deciding", "$k$", 0),
    ]
}

fn area_cells(interval: &Interval) -> [TableCell<'static>; 5] {
    [
        TableCell::Int(interval.n as i64),
        TableCell::Int(interval.m as i64),
        TableCell::Int(interval.case.sign_emu().into()),
        TableCell::Int(interval.case.sign_gamma().into()),
        interval.deciding.map_or(TableCell::Empty, |k| TableCell::Int(k as i64)),
    ]
}

/// Lower and upper bounds of r and a₂, or nothing.
fn bounds(r: Option<&Enclosure>, digits: u32) -> [String; 4] {
    let Some(r) = r else { return Default::default() };
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

/// R(s) on a grid; whether everything was certified.
fn edges(
    args: &Args,
    grid: u64,
    setting: Setting<'_>,
    out: &mut dyn Write,
    progress: &Progress,
) -> Result<bool> {
    let width = args.periods.0.end().to_string().len();
    let mut columns = area_columns(width);
    columns.push(Column::new("s", "$s$", 2 * width + 4));
    columns.extend(bound_columns(args.digits));
    let mut table = TableWriter::set(out, args.format, "grazing-boundary-grid 1", columns, setting)?;
    let mut certain = true;
    let rows = edge_rows(args, grid, &mut table, progress, &mut certain);
    table.end(rows)?;
    Ok(certain)
}

fn edge_rows(
    args: &Args,
    grid: u64,
    table: &mut TableWriter,
    progress: &Progress,
    certain: &mut bool,
) -> Result<()> {
    for n in args.periods.0.clone() {
        for area in areas(args, n)? {
            // In portions, so that Ctrl-C is heard and memory stays bounded.
            let places: Vec<u64> = (1..=grid).collect();
            for portion in places.chunks(256) {
                let values: Result<Vec<_>> = portion
                    .par_iter()
                    .map(|&i| {
                        let s = grid_point(area.interval(), i, grid);
                        Ok((
                            s,
                            area.at(
                                &BigRational::new((*s.numer()).into(), (*s.denom()).into()),
                                args.digits,
                            )?,
                        ))
                    })
                    .collect();
                for (s, r) in values? {
                    *certain &= r.is_some();
                    let bounds = bounds(r.as_ref(), args.digits);
                    let mut cells = area_cells(area.interval()).to_vec();
                    cells.push(TableCell::Fraction(&s));
                    cells.extend(bounds.iter().map(|bound| text(bound)));
                    table.row(&cells)?;
                }
                progress.advance(0)?;
            }
        }
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

/// The lowest points; whether all were certified.
fn lowest(args: &Args, setting: Setting<'_>, out: &mut dyn Write, progress: &Progress) -> Result<bool> {
    let width = args.periods.0.end().to_string().len();
    let mut columns = area_columns(width);
    columns.push(Column::new("lowest", "lowest", 8).print(Print::Left));
    columns.extend(bound_columns(args.digits));
    let s_width = args.digits as usize / 2 + 2;
    columns.push(Column::new("s_lower", "$s \\ge$", s_width));
    columns.push(Column::new("s_upper", "$s \\le$", s_width));
    columns.push(Column::new("scaled", "$(1 - r)n^3$", 12).print(Print::Omitted));
    columns.push(Column::new("law", "$G$", 12).print(Print::Omitted));
    columns.push(Column::new("law_next", "$G + G_2/n^2$", 12).print(Print::Omitted));
    let mut table = TableWriter::set(out, args.format, "grazing-boundary 1", columns, setting)?;
    let mut certain = true;
    let rows = lowest_rows(args, width, &mut table, progress, &mut certain);
    table.end(rows)?;
    Ok(certain)
}

fn lowest_rows(
    args: &Args,
    width: usize,
    table: &mut TableWriter,
    progress: &Progress,
    certain: &mut bool,
) -> Result<()> {
    for n in args.periods.0.clone() {
        for portion in areas(args, n)?.chunks(64) {
            // (1 − r) n³ is to have its six decimals, however few of r are printed.
            let digits = args.digits.max(8 + 3 * width as u32);
            let found: Vec<Option<Lowest>> = portion.par_iter().map(|area| area.lowest(digits)).collect();
            for (area, lowest) in portion.iter().zip(&found) {
                *certain &= lowest.is_some();
                let row = Row::new(area.interval(), lowest.as_ref(), args.digits);
                let mut cells = area_cells(area.interval()).to_vec();
                cells.push(text(row.kind));
                cells.extend(row.numbers.iter().map(|number| text(number)));
                table.row(&cells)?;
            }
            progress.advance(0)?;
        }
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
