//! `grazing existence`: Theorem 1 for every impact pattern of a local map.

use std::path::PathBuf;

use clap::Parser;
use num_bigint::BigUint;
use num_traits::ToPrimitive;
use rayon::prelude::*;

use super::{EVERYTHING, OrbitPicture, Outcome, reported};
use crate::{
    cli::choice::choice,
    cli::progress::Interrupt,
    error::{Error, Result},
    number::{FloatInterval, Sign, certain_digits, parse_integer},
    output::{
        Caption, Column, Destination, FileRegistry, FileUse, LONGEST_SCENE, Print, Setting, TableCell,
        TableFormat, TableWriter, latex, make_folder, read_text, say,
    },
    pattern::{
        Analysis, Flights, Graph, MAX_GRAPH_PERIOD, Map, Numbers, Pattern, PatternExistence, Patterns,
        Pruning, Report, Together, Value, Windows,
    },
    word::Entropy,
};

/// Decide for every impact pattern of a local map whether an orbit exists near a grazing bifurcation.
///
/// MAP is a TOML file with A, B, C and e (docs/existence.md). The table has one row per pattern (n_1, ...,
/// n_m), up to rotation, with n_1 + ... + n_m at most P. It says for which sign of e*mu an orbit exists, and
/// has both margins for both signs, the large eigenvalue's leading coefficient and sign, and the solution Y,
/// X of the leading-order equations.
///
/// Exit code 0: every pattern decided; 2: wrong usage or a file that cannot be read or written; 3: some
/// pattern undecided (the reason is given), or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing existence examples/maps/focus.toml --max-period 6
  grazing existence examples/maps/focus.toml --pattern 1,3 --orbit orbit")]
pub struct Args {
    /// The map.
    #[arg(value_name = "MAP.toml")]
    map: PathBuf,
    /// The largest period of a pattern. There are about 2^P/P patterns of period P; at most 10000000 rows are
    /// written.
    #[arg(long, value_name = "P", default_value_t = 6, value_parser = parse_integer::<u64>, conflicts_with = "pattern")]
    max_period: u64,
    /// One pattern only, such as 3,4.
    #[arg(long, value_name = "N1,N2,...", value_parser = pattern, conflicts_with_all = ["existing", "counts"])]
    pattern: Option<Pattern>,
    /// Write that pattern's predicted orbit into a folder, as orbit.csv and orbit.svg.
    #[arg(long, value_name = "DIR", requires = "pattern")]
    orbit: Option<PathBuf>,
    /// Leave out the patterns that exist for neither sign. In two dimensions they are never visited, in more
    /// none with a beginning that no orbit can have is.
    #[arg(long)]
    existing: bool,
    /// Count the patterns of each period instead; in two dimensions, add the growth rate over the periods up
    /// to it.
    #[arg(long, conflicts_with = "existing")]
    counts: bool,
    /// Say whether the flights between impacts contract, letter after letter: then one bound, one distance
    /// from the grazing, serves all patterns of these periods (docs/existence.md).
    #[arg(long, conflicts_with_all = ["pattern", "existing", "counts", "exact", "dot"])]
    uniform: bool,
    /// Give exact fractions in place of certain digits.
    #[arg(long)]
    exact: bool,
    /// Write the pattern graph of a two-dimensional map for Graphviz.
    #[arg(long, value_name = "FILE")]
    dot: Option<PathBuf>,
    /// How the table is written.
    #[arg(long, value_parser = choice::<TableFormat>(), default_value = "table")]
    pub(super) format: TableFormat,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

fn pattern(text: &str) -> Result<Pattern> {
    let periods: Option<Vec<u64>> = text.split(',').map(|n| n.trim().parse().ok()).collect();
    let found = periods
        .and_then(|periods| Pattern::new(&periods))
        .filter(|found| found.periods().iter().all(|&n| n <= LIMIT));
    found.ok_or_else(|| {
        Error::input(format!(
            "{text:?} is not a pattern: periods from 1 to {LIMIT} with commas between, as in 3,4"
        ))
    })
}

const LIMIT: u64 = MAX_GRAPH_PERIOD;

/// The most rows of a list.
const MOST_ROWS: u64 = 10_000_000;

/// Windows until an interruption, which ends the search: between two patterns it may be long.
struct Watched<'a> {
    windows: Windows<'a, FloatInterval>,
    interrupt: &'a Interrupt,
}

impl Pruning for Watched<'_> {
    fn enter(&mut self, before: Option<u64>, letter: u64) -> bool {
        !self.interrupt.asked() && self.windows.enter(before, letter)
    }

    fn leave(&mut self) {
        self.windows.leave();
    }
}

/// Patterns judged before their rows are written.
const CHUNK: usize = 4096;

/// The engine for a map: the graph in two dimensions, else the general solver.
enum Engine<'m> {
    Graph(Graph),
    General(Box<Analysis<'m>>),
}

impl Engine<'_> {
    fn judge(&self, pattern: &Pattern) -> Report {
        match self {
            Engine::Graph(graph) => graph.judge(pattern.periods()),
            Engine::General(analysis) => analysis.judge(pattern.periods()),
        }
    }

    /// The patterns of a period, if `existing` without those that certainly exist for neither sign as far as
    /// it is seen early.
    fn patterns<'a>(
        &'a self,
        period: u64,
        existing: bool,
        interrupt: &'a Interrupt,
    ) -> Box<dyn Iterator<Item = Pattern> + 'a> {
        match self {
            Engine::Graph(graph) if existing => {
                Box::new(Patterns::walks(period, |from, to| graph.may_follow(from, to)))
            }
            Engine::General(analysis) if existing => match analysis.windows() {
                Some(windows) => Box::new(Patterns::walks(period, Watched { windows, interrupt })),
                None => Box::new(Patterns::of_period(period)),
            },
            _ => Box::new(Patterns::of_period(period)),
        }
    }

    /// Refuses a list of more than [`MOST_ROWS`] patterns.
    fn bounded(&self, args: &Args, interrupt: &Interrupt) -> Result<()> {
        let all: BigUint = (1..=args.max_period).map(Patterns::count).sum();
        if all <= MOST_ROWS.into() {
            return Ok(());
        }
        let rows = match self {
            // They are counted as they will be visited, which takes a part of the time of judging them.
            _ if args.existing => {
                let mut rows = 0u64;
                for (index, _) in
                    (1..=args.max_period).flat_map(|n| self.patterns(n, true, interrupt)).enumerate()
                {
                    rows += 1;
                    if index % CHUNK == 0 {
                        interrupt.check()?;
                    }
                    if rows > MOST_ROWS {
                        break;
                    }
                }
                if rows <= MOST_ROWS { return Ok(()) } else { format!("more than {MOST_ROWS}") }
            }
            _ => match all.to_u64() {
                Some(rows) => rows.to_string(),
                None => format!("about 10^{}", all.to_string().len() - 1),
            },
        };
        Err(Error::input(format!(
            "--max-period {} would write {rows} rows, and at most {MOST_ROWS} are written: give a smaller one",
            args.max_period
        )))
    }
}

pub(super) fn run(
    args: &Args,
    picture: Option<OrbitPicture>,
    files: &FileRegistry,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    if args.orbit.is_some() && picture.is_none() {
        return Err(Error::input(format!("--orbit draws, which the program `grazing` does: {EVERYTHING}")));
    }
    if !(1..=LIMIT).contains(&args.max_period) {
        return Err(Error::input(format!(
            "--max-period {}: at least 1 and at most {LIMIT}",
            args.max_period
        )));
    }
    let name = args.map.display().to_string();
    files.read("MAP", &args.map)?;
    for picture in
        args.orbit.iter().flat_map(|folder| ["orbit.csv", "orbit.svg"].map(|name| folder.join(name)))
    {
        files.claim("--orbit", &picture, FileUse::Write)?;
    }
    let destination = files.destination(args.output.as_deref())?;
    let dot = args.dot.as_deref().map(|path| files.write("--dot", path)).transpose()?;
    args.orbit.as_deref().map(make_folder).transpose()?;
    let text = read_text(&args.map, LONGEST_SCENE)?;
    let map = Map::from_toml(&text, &name)?;
    for note in map.notes() {
        say(format_args!("note: {name}: {note}"));
    }
    if args.exact && !map.is_exact() {
        return Err(Error::input(format!("--exact needs a map without intervals; {name} has some")));
    }
    if args.uniform {
        return uniform(args, (&map, &name), &destination, interrupt);
    }
    let last = args
        .pattern
        .as_ref()
        .and_then(|pattern| pattern.periods().iter().copied().max())
        .unwrap_or(args.max_period);
    let engine = if map.dimension() == 2 {
        Engine::Graph(Graph::new(&map, last, args.exact)?)
    } else {
        let numbers = if args.exact { Numbers::Exact } else { Numbers::Enclosed };
        Engine::General(Box::new(Analysis::new(&map, last, numbers)))
    };
    if args.pattern.is_none() && !args.counts {
        engine.bounded(args, interrupt)?;
    }
    if let Some(file) = &dot {
        let Engine::Graph(graph) = &engine else {
            return Err(Error::input(format!(
                "--dot needs a map with N = 2; in {name} N = {}",
                map.dimension()
            )));
        };
        file.write(|out| Ok(out.write_all(graph.to_dot().as_bytes())?))?;
    }
    if let (Some(folder), Some(pattern), Some(draw)) = (&args.orbit, &args.pattern, picture) {
        let side = engine.judge(pattern).side();
        draw(&map, pattern, side, folder)?;
    }
    let mut outcome = Outcome::Done;
    let written = destination.write(|out| {
        if args.counts {
            return counts(args, (&engine, &name), out, interrupt, &mut outcome);
        }
        let print = args.format.is_print();
        let caption = caption("existence", LIST, &name);
        let setting = Setting { caption: Some(&caption), ..Setting::at(&destination) };
        let mut table = TableWriter::set(out, args.format, "grazing-existence 1", columns(print), setting)?;
        let mut write = |chunk: &[Pattern]| {
            rows(args, &engine, map.e().sign(), chunk, &mut table, &mut outcome)?;
            interrupt.check()
        };
        let rows = match &args.pattern {
            Some(pattern) => write(std::slice::from_ref(pattern)),
            None => (1..=args.max_period).try_for_each(|period| {
                each_chunk(engine.patterns(period, args.existing, interrupt), &mut write)
            }),
        };
        table.end(rows)
    });
    reported(outcome, written)
}

/// The one row about flights.
fn uniform(
    args: &Args,
    (map, name): (&Map, &str),
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let found = Flights::new(map, args.max_period, interrupt)?;
    let list = |all: &[u64]| all.iter().map(u64::to_string).collect::<Vec<_>>().join(",");
    let [periods, without] = [&found.periods, &found.without].map(|all| list(all));
    let nothing = || Cell::Text(String::new());
    let (verdict, flights, word) = match &found.together {
        Together::Contract(flights) => ("contract", Cell::Whole(*flights as i64), nothing()),
        Together::Grow(word) => ("grow", nothing(), Cell::Text(list(word))),
        _ => ("undecided", nothing(), nothing()),
    };
    let cells = [Cell::Text(periods), Cell::Text(without), Cell::Text(verdict.into()), flights, word];
    let columns = ["periods", "without", "verdict", "flights", "word"];
    let columns = columns.map(|name| Column::new(name, name, 12)).to_vec();
    let outcome = if verdict == "undecided" { Outcome::Undecided } else { Outcome::Done };
    let written = destination.write(|out| {
        let caption = caption("existence-uniform", UNIFORM, name);
        let setting = Setting { caption: Some(&caption), ..Setting::default() };
        let mut table = TableWriter::set(out, args.format, "grazing-existence-uniform 1", columns, setting)?;
        let row = table.row(&cells.each_ref().map(Cell::set));
        table.end(row)
    });
    reported(outcome, written)
}

/// The rows of some patterns, judged by all threads.
fn rows(
    args: &Args,
    engine: &Engine,
    e: Option<Sign>,
    chunk: &[Pattern],
    table: &mut TableWriter,
    outcome: &mut Outcome,
) -> Result<()> {
    let judged: Vec<(Report, Vec<Cell>)> = chunk
        .par_iter()
        .map(|pattern| {
            let report = engine.judge(pattern);
            let print = args.format.is_print();
            let cells = if keep(args, &report) { cells(pattern, &report, e, print) } else { Vec::new() };
            (report, cells)
        })
        .collect();
    for (report, cells) in judged.iter().filter(|(_, cells)| !cells.is_empty()) {
        if report.is_open() {
            *outcome = Outcome::Undecided;
        }
        table.row(&cells.iter().map(Cell::set).collect::<Vec<_>>())?;
    }
    Ok(())
}

fn each_chunk(
    patterns: impl Iterator<Item = Pattern>,
    mut write: impl FnMut(&[Pattern]) -> Result<()>,
) -> Result<()> {
    let mut chunk = Vec::with_capacity(CHUNK);
    for pattern in patterns {
        chunk.push(pattern);
        if chunk.len() == CHUNK {
            write(&chunk)?;
            chunk.clear();
        }
    }
    write(&chunk)
}

fn keep(args: &Args, report: &Report) -> bool {
    !args.existing || report.side().is_some() || report.is_open()
}

/// What the list shows, in LaTeX.
const LIST: &str = "The orbits by their patterns, the periods between impacts: for which sign of $e\\mu$ there is one, \
the sign of $\\mu$ then, $L$ of the largest eigenvalue $\\Lambda_1 \\sim L (e\\mu)^{-m}$, and its sign";

/// What the counts show.
const COUNTS: &str = "How many patterns there are of each period, for how many there is an orbit, and the growth rate of \
their number, if it is known";

/// What the row about flights shows.
const UNIFORM: &str = "Whether the flights of these periods contract, letter after letter: after how many every vector of \
the plane $Cx = 0$ is halved, or a word that grows";

/// The caption of a table about a map.
fn caption(name: &str, about: &str, map: &str) -> Caption {
    Caption { text: format!("{about}. The map: \\texttt{{{}}}.", latex(map)), label: format!("tab:{name}") }
}

fn columns(print: bool) -> Vec<Column> {
    // On a page the verdict has the sign of eµ.
    let sign_emu = if print { Print::Omitted } else { Print::Right };
    vec![
        Column::new("pattern", "pattern", 12).print(Print::Left),
        Column::new("period", "$n$", 0),
        Column::new("impacts", "$m$", 0),
        Column::new("primitive", "primitive", 0).print(Print::Omitted),
        Column::new("verdict", "verdict", 0).print(Print::Left),
        Column::new("sign_emu", "", 0).print(sign_emu),
        Column::new("sign_mu", "$\\operatorname{sign}\\mu$", 0),
        Column::new("h_plus", "$h_+$", 15).print(Print::Omitted),
        Column::new("y_plus", "$y_+$", 15).print(Print::Omitted),
        Column::new("h_minus", "$h_-$", 15).print(Print::Omitted),
        Column::new("y_minus", "$y_-$", 15).print(Print::Omitted),
        Column::new("leading", "$L$", 15),
        Column::new("sign_eigenvalue", "$\\operatorname{sign}\\Lambda_1$", 0),
        Column::new("reason", "reason", 0).print(Print::Lines(16)),
        Column::new("Y", "$Y$", 0).print(Print::Omitted),
        Column::new("X", "$X$", 0).print(Print::Omitted),
    ]
}

/// A cell that outlives the row it was computed in.
enum Cell {
    Whole(i64),
    Maths(&'static str),
    /// Nothing, if it is empty.
    Text(String),
}

impl Cell {
    fn sign(positive: Option<bool>, print: bool) -> Cell {
        match (positive, print) {
            (None, _) => Cell::Text(String::new()),
            (Some(positive), true) => Cell::Maths(if positive { "+" } else { "-" }),
            (Some(positive), false) => Cell::Whole(if positive { 1 } else { -1 }),
        }
    }

    fn set(&self) -> TableCell<'_> {
        match self {
            Cell::Whole(number) => TableCell::Int(*number),
            Cell::Maths(formula) => TableCell::Maths(formula),
            Cell::Text(text) if text.is_empty() => TableCell::Empty,
            Cell::Text(text) => TableCell::Text(text),
        }
    }
}

fn cells(pattern: &Pattern, report: &Report, e: Option<Sign>, print: bool) -> Vec<Cell> {
    let side = report.side();
    let verdict = match (report.plus, report.minus) {
        (PatternExistence::Orbit, _) => "emu>0",
        (_, PatternExistence::Orbit) => "emu<0",
        (PatternExistence::NoOrbit, PatternExistence::NoOrbit) => "neither",
        _ => "undecided",
    };
    let orbit = report.orbit.as_ref();
    let mut reason: Vec<String> = report.reason.iter().map(ToString::to_string).collect();
    if let Some(n) = report.flat {
        reason.push(format!("C A^{n} B = 0: no leading eigenvalue"));
    }
    if side.is_some() && report.flat.is_none() && orbit.is_some_and(|orbit| orbit.leading_sign.is_none()) {
        reason.push("the enclosure of some C A^n B contains 0: the eigenvalue's sign is open".into());
    }
    match (report.plus, report.minus) {
        (PatternExistence::Open, PatternExistence::NoOrbit) => reason.push("none for emu < 0".into()),
        (PatternExistence::NoOrbit, PatternExistence::Open) => reason.push("none for emu > 0".into()),
        _ => {}
    }
    let show = |value: Option<Value>| Cell::Text(value.map_or(String::new(), |value| value.to_string()));
    let margin = |positive| {
        orbit.map_or((None, None), |orbit| {
            let (gap, impact) = orbit.margins(positive);
            (gap, Some(impact))
        })
    };
    let (plus, minus) = (margin(true), margin(false));
    let eigenvalue = side.and_then(|side| orbit?.eigenvalue_sign(side)).map(|sign| sign == Sign::Positive);
    let join = |values: &[Value]| values.iter().map(Value::to_string).collect::<Vec<_>>().join(" ");
    let flat = report.flat.is_some();
    let pattern_cell = Cell::Text(if print { format!("({pattern})") } else { pattern.to_string() });
    let rows = |x: &[Vec<Value>]| x.iter().map(|x| join(x)).collect::<Vec<_>>().join("; ");
    vec![
        pattern_cell,
        Cell::Whole(pattern.period() as i64),
        Cell::Whole(pattern.periods().len() as i64),
        Cell::Text(if pattern.is_primitive() { "yes" } else { "no" }.into()),
        match verdict {
            "emu>0" if print => Cell::Maths("e\\mu > 0"),
            "emu<0" if print => Cell::Maths("e\\mu < 0"),
            _ => Cell::Text(verdict.into()),
        },
        Cell::sign(side, print),
        Cell::sign(side.filter(|_| e.is_some()).map(|side| side == (e == Some(Sign::Positive))), print),
        show(plus.0),
        show(plus.1),
        show(minus.0),
        show(minus.1),
        show(orbit.and_then(|orbit| orbit.leading.clone())),
        Cell::sign(eigenvalue.filter(|_| !flat), print),
        Cell::Text(reason.join("; ")),
        Cell::Text(orbit.map_or(String::new(), |orbit| join(&orbit.y))),
        Cell::Text(orbit.map_or(String::new(), |orbit| rows(&orbit.x))),
    ]
}

/// One row per period: patterns, those that exist for each sign, undecided ones; and for N = 2 the growth
/// rates.
fn counts(
    args: &Args,
    (engine, map): (&Engine, &str),
    out: &mut dyn std::io::Write,
    interrupt: &Interrupt,
    outcome: &mut Outcome,
) -> Result<()> {
    let mut columns: Vec<Column> = [
        ("period", "period"),
        ("patterns", "patterns"),
        ("plus", "$e\\mu > 0$"),
        ("minus", "$e\\mu < 0$"),
        ("neither", "neither"),
        ("undecided", "undecided"),
    ]
    .map(|(name, latex)| Column::new(name, latex, 9))
    .to_vec();
    if matches!(engine, Engine::Graph(_)) {
        let growth = [("growth_plus", "growth, $e\\mu > 0$"), ("growth_minus", "growth, $e\\mu < 0$")];
        columns.extend(growth.map(|(name, latex)| Column::new(name, latex, 15)));
    }
    let caption = caption("existence-counts", COUNTS, map);
    let setting = Setting { caption: Some(&caption), ..Setting::default() };
    let mut table = TableWriter::set(out, args.format, "grazing-existence-counts 1", columns, setting)?;
    let rows = match engine {
        Engine::Graph(graph) => counted(graph, interrupt, outcome, &mut table),
        Engine::General(_) => (1..=args.max_period)
            .try_for_each(|period| listed(engine, period, interrupt, outcome, &mut table)),
    };
    table.end(rows)
}

/// The rows of a two-dimensional map, from its graph without listing a pattern. Numbers beyond 64 bits are
/// text.
fn counted(
    graph: &Graph,
    interrupt: &Interrupt,
    outcome: &mut Outcome,
    table: &mut TableWriter,
) -> Result<()> {
    for row in graph.tallies() {
        interrupt.check()?;
        if row.undecided != BigUint::ZERO {
            *outcome = Outcome::Undecided;
        }
        let counts = [row.patterns, row.plus, row.minus, row.neither, row.undecided];
        let texts = counts.each_ref().map(ToString::to_string);
        let growth =
            [true, false].map(|side| show_growth(&graph.walks(side, row.period).entropy(GROWTH_BITS)));
        let mut cells = vec![TableCell::Int(row.period as i64)];
        cells.extend(whole_cells(&counts, &texts));
        cells.extend(growth.iter().map(|text| TableCell::Text(text)));
        table.row(&cells)?;
    }
    Ok(())
}

/// Whole numbers of any size, those beyond 64 bits as text.
fn whole_cells<'t>(numbers: &[BigUint], texts: &'t [String]) -> impl Iterator<Item = TableCell<'t>> {
    let cell = |(number, text): (&BigUint, &'t String)| {
        number.to_i64().map_or(TableCell::Text(text), TableCell::Int)
    };
    numbers.iter().zip(texts).map(cell)
}

/// Bits of a growth rate.
const GROWTH_BITS: u32 = 44;

/// The row of one period, pattern by pattern.
fn listed(
    engine: &Engine,
    period: u64,
    interrupt: &Interrupt,
    outcome: &mut Outcome,
    table: &mut TableWriter,
) -> Result<()> {
    let mut found = [0u64; 4];
    each_chunk(engine.patterns(period, true, interrupt), |chunk| {
        let kinds: Vec<usize> = chunk
            .par_iter()
            .map(|pattern| {
                let report = engine.judge(pattern);
                match report.side() {
                    Some(true) => 0,
                    Some(false) => 1,
                    None => 2 + usize::from(report.is_open()),
                }
            })
            .collect();
        kinds.into_iter().for_each(|kind| found[kind] += 1);
        interrupt.check()
    })?;
    if found[3] > 0 {
        *outcome = Outcome::Undecided;
    }
    // What was not visited exists for neither sign.
    let all = Patterns::count(period);
    let neither = &all - (found[0] + found[1] + found[3]);
    let [plus, minus, _, undecided] = found.map(BigUint::from);
    let counts = [all, plus, minus, neither, undecided];
    let texts = counts.each_ref().map(ToString::to_string);
    let mut cells = vec![TableCell::Int(period as i64)];
    cells.extend(whole_cells(&counts, &texts));
    table.row(&cells)
}

fn show_growth(growth: &Entropy) -> String {
    match (growth, growth.bounds()) {
        (Entropy::Positive { .. }, Some((lo, hi))) => {
            certain_digits(&lo, &hi, 12).unwrap_or_else(|| "?".into())
        }
        (Entropy::Zero, _) => "0".into(),
        _ => "none".into(),
    }
}
