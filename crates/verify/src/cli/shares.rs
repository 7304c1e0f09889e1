//! What `word --shares` and `classify` say of a box of parameters: shares of it, from a partition.

use std::{io::Write, path::Path};

use num_bigint::BigInt;
use num_rational::BigRational;
use serde_json::{Value as Json, json};

use super::{
    Outcome,
    place::{self, Bounds},
    pretty,
    progress::{Interrupt, Progress},
    reported,
    word::Format,
};
use crate::{
    certificate,
    error::{Error, Result},
    output::{
        Caption, Column, Destination, Print, Setting, TableCell, TableFormat, TableWriter, decimal_above,
        decimal_below, decimal_or_fraction,
    },
    printable::Printable,
    tolerance::{
        CaseSigns, DEVIATIONS, LAST_PERIOD, Leaf, MOST_CELLS, NormalParameters, ParameterBox, Partition,
        Share, Spread, Subject, SubjectVerdict,
    },
    word::Word,
};

/// How many words of one sign of eµ the text lists.
const WORDS: usize = 12;

/// How long is looked, and up to which period.
pub(super) struct Limits {
    pub cells: u64,
    pub last: u64,
}

impl Limits {
    /// That neither is too large.
    pub fn check(&self) -> Result<()> {
        if !(1..=MOST_CELLS).contains(&self.cells) {
            return Err(Error::input(format!("--cells {}: from 1 to {MOST_CELLS}", self.cells)));
        }
        if !(1..=LAST_PERIOD).contains(&self.last) {
            return Err(Error::input(format!(
                "--max-period {}: from 1 to {LAST_PERIOD} of a box",
                self.last
            )));
        }
        Ok(())
    }
}

/// How the parts of a box count.
#[derive(Clone, Copy)]
pub(super) enum Weight<'a> {
    /// By their size.
    Size,
    /// By a distribution.
    Normal(&'a NormalParameters),
    /// There are but samples.
    Samples(&'a [ParameterBox]),
}

/// What is asked of a box, all of it.
struct Report<'a> {
    of: &'a ParameterBox,
    weight: Weight<'a>,
    bounds: &'a Bounds,
    partition: Partition,
    gamma: Option<bool>,
    /// The certificate that was written, and its text.
    proved: Option<(&'a Path, &'a str)>,
}

impl<'a> Report<'a> {
    fn new(
        (of, weight): (&'a ParameterBox, Weight<'a>),
        bounds: &'a Bounds,
        limits: &Limits,
        interrupt: &Interrupt,
    ) -> Result<Report<'a>> {
        limits.check()?;
        let progress = Progress::new(interrupt, 0, "cells");
        let partition = match weight {
            Weight::Size => Partition::new(of, limits.cells, &progress)?,
            Weight::Normal(normal) => Partition::weighted(of, Some(normal), limits.cells, &progress)?,
            Weight::Samples(all) => Partition::of_samples(all, &progress)?,
        };
        let gamma = match weight {
            Weight::Samples(_) => common_gamma(&partition),
            _ => of.gamma_is_positive(),
        };
        Ok(Report { of, weight, bounds, partition, gamma, proved: None })
    }

    fn chaos(&self, signs: CaseSigns) -> Share {
        self.partition.share(signs.chaos())
    }

    fn gamma_of(&self, signs: CaseSigns) -> Option<bool> {
        signs.gamma.or(self.gamma)
    }

    /// The box in LaTeX.
    fn in_latex(&self) -> String {
        place::in_latex(self.bounds)
    }

    fn heading(&self) -> String {
        let shown = place::shown(self.bounds);
        let all = if matches!(self.weight, Weight::Samples(_)) { "Samples" } else { "All points" };
        if !self.of.has_gamma() {
            return format!("{all} with {shown}");
        }
        let all = if all == "Samples" { "Samples of machines" } else { "All machines" };
        let gamma = match self.gamma {
            Some(true) => "gamma > 0 for all of them",
            Some(false) => "gamma < 0 for all of them",
            None => "gamma has not one sign, or may be 0",
        };
        format!("{all} with {shown}. {gamma}")
    }
}

/// CaseSigns in text.
pub(super) fn spoken(signs: CaseSigns) -> String {
    match signs.case() {
        Some(case) => format!("case {case}"),
        None => format!("e*mu {} 0", if signs.positive { '>' } else { '<' }),
    }
}

/// The same in LaTeX's maths mode.
pub(super) fn in_maths(signs: CaseSigns) -> String {
    match signs.case() {
        Some(case) => case.to_string(),
        None => format!("e\\mu {} 0", if signs.positive { '>' } else { '<' }),
    }
}

pub(super) fn sign(positive: bool) -> i64 {
    if positive { 1 } else { -1 }
}

/// Bounds of a share, in decimals that lie on the right side of it.
fn ends(share: &Share) -> [String; 2] {
    [decimal_below(&share.lower, 6), decimal_above(&share.upper, 6)]
}

/// The sign of γ that all samples have.
fn common_gamma(partition: &Partition) -> Option<bool> {
    let first = partition.leaves().first()?.gamma?;
    partition.leaves().iter().all(|leaf| leaf.gamma == Some(first)).then_some(first)
}

/// The same in words.
fn said(share: &Share, weight: Weight) -> String {
    let times = |by: u64| [&share.lower, &share.upper].map(|end| end * BigInt::from(by));
    match (share.spread(), weight) {
        (Spread::Everywhere, Weight::Size) => "in all of it".into(),
        (Spread::Nowhere, Weight::Size) => "in none of it".into(),
        (_, Weight::Samples(all)) => {
            let [least, most] = times(all.len() as u64);
            let to = if share.open { format!(" to {most}") } else { String::new() };
            format!("in {least}{to} of them")
        }
        _ => {
            let [lower, upper] = times(100);
            format!("in {} % to {} % of it", decimal_below(&lower, 2), decimal_above(&upper, 2))
        }
    }
}

/// A place, exactly.
fn at(bounds: &Bounds, point: &[BigRational]) -> String {
    let one = |i: usize| format!("{} = {}", place::spoken(bounds[i].0), decimal_or_fraction(&point[i]));
    format!("{}, {}", one(0), one(1))
}

/// `grazing word --shares`, with the certificate that was written.
pub(super) fn run(
    of: (&ParameterBox, Weight),
    (bounds, proved): (&Bounds, Option<(&Path, &str)>),
    limits: Limits,
    format: Format,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let option = if matches!(of.1, Weight::Samples(_)) { "--samples" } else { "--shares" };
    let format = format.of_table(option)?;
    let report = Report { proved, ..Report::new(of, bounds, &limits, interrupt)? };
    let rows = rows(&report, limits.last);
    let open = rows.iter().any(|row| row.word.is_none() && row.share.spread() == Spread::Open);
    let written = destination.write(|out| match format {
        TableFormat::Table => Ok(out.write_all(text(&report, &rows).as_bytes())?),
        TableFormat::Json => write_json(&report, &rows, out),
        table => write_table(&report, &rows, table, out),
    });
    reported(if open { Outcome::Undecided } else { Outcome::Done }, written)
}

/// One statement and its share.
struct Row {
    what: &'static str,
    positive: bool,
    /// Of chaos alone.
    gamma: Option<bool>,
    n: Option<u64>,
    word: Option<Word>,
    name: String,
    share: Share,
}

/// Everything that is said: chaos, periods, words.
fn rows(report: &Report, last: u64) -> Vec<Row> {
    let row = |SubjectVerdict { subject, share }| match subject {
        Subject::Chaos(signs) => Row {
            what: "chaos",
            positive: signs.positive,
            gamma: report.gamma_of(signs),
            n: None,
            word: None,
            name: spoken(signs),
            share,
        },
        Subject::Period { positive, n } => {
            let name = format!("period {n}");
            Row { what: "period", positive, gamma: None, n: Some(n), word: None, name, share }
        }
        Subject::Word { positive, word } => {
            let name = word.letters();
            Row { what: "word", positive, gamma: None, n: None, word: Some(word), name, share }
        }
    };
    report.partition.verdicts(report.of.signs(), last).into_iter().map(row).collect()
}

fn text(report: &Report, rows: &[Row]) -> String {
    let partition = &report.partition;
    let settled = decimal_below(&(partition.settled() * BigInt::from(100)), 2);
    let by = match report.weight {
        Weight::Size => "Shares of this box, every part counting by its size".to_string(),
        Weight::Samples(_) => "Counted, which bounds no share of others".to_string(),
        Weight::Normal(normal) => format!(
            "Shares of the distribution{}; beyond these {DEVIATIONS} deviations all is open",
            place::distributed(report.bounds, normal.parameters())
        ),
    };
    let mut text = format!(
        "{}\n{by}: {} {}, the words certain on {settled} % of it\n",
        report.heading(),
        partition.cells(),
        if matches!(report.weight, Weight::Samples(_)) { "samples" } else { "cells" },
    );
    text += "\nChaos is born\n";
    for row in rows.iter().filter(|row| row.what == "chaos") {
        text += &format!("  {}: {}\n", row.name, said(&row.share, report.weight));
        if let (Spread::Differs, Some(with), Some(without)) =
            (row.share.spread(), &row.share.with, &row.share.without)
        {
            let [with, without] = [with, without].map(|point| at(report.bounds, point));
            text += &format!("    so at {with}, not at {without}\n");
        }
    }
    for positive in [true, false] {
        let of = |what: &'static str| rows.iter().filter(move |r| r.what == what && r.positive == positive);
        text += &format!("\nPeriods between impacts, e*mu {} 0\n", if positive { '>' } else { '<' });
        for row in of("period") {
            text += &format!("  {}: {}\n", row.name, said(&row.share, report.weight));
        }
        let words: Vec<&Row> = of("word").collect();
        text += &format!("Words, e*mu {} 0\n", if positive { '>' } else { '<' });
        for row in words.iter().take(WORDS) {
            let periods = row.word.as_ref().map_or(String::new(), listed);
            text += &format!("  {} ({periods}): {}\n", row.name, said(&row.share, report.weight));
        }
        if words.len() > WORDS {
            text += &format!("  and {} more\n", words.len() - WORDS);
        }
    }
    if let Some(leaf) = partition.open() {
        let part = place::within(&of_cell(report.bounds, leaf));
        text += &format!("\nOpen, in the first place: {}, at {part}\n", why_open(leaf));
    }
    if partition.is_cut() {
        text += "More --cells make the bounds narrower.\n";
    }
    if let Some((path, certificate)) = report.proved {
        text += &format!("Certificate: {}\n", Printable(&path.display().to_string()));
        for (name, value) in certified(certificate) {
            text += &format!("  {name}: {value}\n");
        }
    }
    text
}

/// What the checker says of a certificate.
fn certified(text: &str) -> Vec<(&'static str, String)> {
    certificate::check(&mut text.as_bytes()).map_or(Vec::new(), |checked| checked.detail)
}

/// The bounds of a cell.
fn of_cell(bounds: &Bounds, leaf: &Leaf) -> Bounds {
    let [first, second] = leaf.cell.bounds().clone();
    [(bounds[0].0, first), (bounds[1].0, second)]
}

/// What is not certain on a cell.
fn why_open(leaf: &Leaf) -> String {
    leaf.why_open(|positive| if positive { "e*mu > 0" } else { "e*mu < 0" }).unwrap_or_default()
}

fn listed(word: &Word) -> String {
    if word.is_endless() {
        return "every period".into();
    }
    word.vertices().iter().map(|vertex| vertex.period.to_string()).collect::<Vec<_>>().join(", ")
}

fn write_json(report: &Report, rows: &[Row], out: &mut dyn Write) -> Result<()> {
    let point = |point: &Option<Vec<BigRational>>| {
        point.as_ref().map(|point| point.iter().map(ToString::to_string).collect::<Vec<_>>())
    };
    let of = |what: &str, keys: &dyn Fn(&Row) -> Json| -> Vec<Json> {
        rows.iter()
            .filter(|row| row.what == what)
            .map(|row| {
                let mut all = keys(row);
                all["sign_emu"] = json!(sign(row.positive));
                all["verdict"] = json!(row.share.spread().word());
                all["share"] = json!(ends(&row.share));
                all["with"] = json!(point(&row.share.with));
                all["without"] = json!(point(&row.share.without));
                all
            })
            .collect()
    };
    let gamma = report.of.has_gamma().then_some(report.gamma);
    let all = json!({
        "format": "grazing-shares 1",
        "region": report.heading(),
        "box": place::json(report.bounds, gamma),
        "normal": match report.weight {
            Weight::Normal(normal) => place::json_normal(report.bounds, normal.parameters()),
            _ => Json::Null,
        },
        "samples": match report.weight {
            Weight::Samples(all) => json!(all.len()),
            _ => Json::Null,
        },
        "cells": report.partition.cells(),
        "cut": report.partition.is_cut(),
        "settled": decimal_below(&report.partition.settled(), 6),
        "open": report.partition.open().map(|leaf| json!({
            "cell": place::json(&of_cell(report.bounds, leaf), None),
            "why": why_open(leaf),
        })),
        "certificate": report.proved.map(|(path, _)| path.display().to_string()),
        "chaos": of("chaos", &|row| json!({ "sign_gamma": row.gamma.map(sign) })),
        "periods": of("period", &|row| json!({ "n": row.n })),
        "words": of("word", &|row| {
            let word = row.word.as_ref();
            let periods = word.map(|w| w.vertices().iter().map(|v| v.period).collect::<Vec<_>>());
            json!({ "letters": row.name, "periods": periods, "endless": word.map(Word::is_endless) })
        }),
    });
    pretty(&all, out)
}

fn write_table(report: &Report, rows: &[Row], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let print = format.is_print();
    let mut columns = vec![Column::new("what", "", 0).print(Print::Left)];
    columns.extend(signs_columns(print));
    columns.extend([
        Column::new("n", "$n$", 0),
        Column::new("word", "word", 0).print(Print::Left),
        Column::new("verdict", "holds", 0).print(Print::Left),
        Column::new("lower", "at least", 0),
        Column::new("upper", "at most", 0),
    ]);
    let caption = Caption {
        text: format!(
            "Where in the box {} chaos is born, a period can occur between impacts, and a word is that of the \
             point: bounds of the share of {}.",
            report.in_latex(),
            match report.weight {
                Weight::Size => "the box",
                Weight::Normal(_) => "a normal distribution around its middle",
                Weight::Samples(_) => "the samples, which bounds no other",
            }
        ),
        label: "tab:shares".into(),
    };
    let setting = Setting { caption: Some(&caption), ..Setting::default() };
    let mut table = TableWriter::set(out, format, "grazing-shares 1", columns, setting)?;
    for row in rows {
        let [lower, upper] = ends(&row.share);
        let mut cells = vec![TableCell::Text(row.what)];
        let case = in_maths(CaseSigns { positive: row.positive, gamma: row.gamma });
        cells.extend(signs_cells(print, Some((row.positive, row.gamma)), &case));
        cells.extend([
            row.n.map_or(TableCell::Empty, |n| TableCell::Int(n as i64)),
            if row.word.is_some() { TableCell::Text(&row.name) } else { TableCell::Empty },
            TableCell::Text(row.share.spread().word()),
            TableCell::Text(&lower),
            TableCell::Text(&upper),
        ]);
        table.row(&cells)?;
    }
    table.finish()
}

/// The signs of a row: two columns for machines, one in print.
pub(super) fn signs_columns(print: bool) -> Vec<Column> {
    if print {
        return vec![Column::new("case", "case", 0)];
    }
    vec![Column::new("sign_emu", "", 0), Column::new("sign_gamma", "", 0)]
}

pub(super) fn signs_cells(
    print: bool,
    signs: Option<(bool, Option<bool>)>,
    case: &str,
) -> Vec<TableCell<'_>> {
    if print {
        return vec![signs.map_or(TableCell::Empty, |_| TableCell::Maths(case))];
    }
    let cell = |positive: Option<bool>| positive.map_or(TableCell::Empty, |p| TableCell::Int(sign(p)));
    vec![cell(signs.map(|signs| signs.0)), cell(signs.and_then(|signs| signs.1))]
}

/// `grazing classify` on a box: for each period the cases in which it has an orbit somewhere, and where.
pub(super) fn classify(
    of: &ParameterBox,
    bounds: &Bounds,
    limits: Limits,
    format: TableFormat,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let report = Report::new((of, Weight::Size), bounds, &limits, interrupt)?;
    let mut rows: Vec<(u64, Option<CaseSigns>, Share)> = Vec::new();
    for n in 1..=limits.last {
        let share = |signs: CaseSigns| report.partition.share(signs.orbit(n));
        let all = report.of.signs().into_iter().map(|signs| (n, Some(signs), share(signs)));
        let (none, some): (Vec<_>, Vec<_>) = all.partition(|row| row.2.spread() == Spread::Nowhere);
        if some.is_empty() {
            rows.extend(none.into_iter().take(1).map(|(n, _, share)| (n, None, share)));
        }
        rows.extend(some);
    }
    let open = rows.iter().any(|row| row.2.spread() == Spread::Open);
    let written = destination.write(|out| {
        if format == TableFormat::Table && destination.is_stdout() {
            writeln!(out, "{}", report.heading())?;
            for signs in report.of.signs() {
                writeln!(out, "{}: chaos is born {}", spoken(signs), said(&report.chaos(signs), report.weight))?;
            }
        }
        let print = format.is_print();
        let mut columns = vec![
            Column::new("n", "$n$", 6),
            Column::new("existence", "orbit", 10).print(Print::Left),
        ];
        columns.extend(signs_columns(print));
        columns.extend([Column::new("lower", "at least", 0), Column::new("upper", "at most", 0)]);
        let caption = Caption {
            text: format!(
                "Orbits with one impact in $n$ periods in the box {}: in which case they exist everywhere, or \
                 in a part of it, and bounds of its share.",
                report.in_latex()
            ),
            label: "tab:classify-box".into(),
        };
        let setting = Setting { caption: Some(&caption), ..Setting::default() };
        let mut table = TableWriter::set(out, format, "grazing-classify-box 1", columns, setting)?;
        for (n, signs, share) in &rows {
            let [lower, upper] = ends(share);
            let signs = signs.map(|signs| (signs.positive, report.gamma_of(signs)));
            let case = signs.map_or(String::new(), |(positive, gamma)| in_maths(CaseSigns { positive, gamma }));
            let mut cells = vec![TableCell::Int(*n as i64), TableCell::Text(share.spread().word())];
            cells.extend(signs_cells(print, signs, &case));
            cells.extend([TableCell::Text(&lower), TableCell::Text(&upper)]);
            table.row(&cells)?;
        }
        table.finish()
    });
    reported(if open { Outcome::Undecided } else { Outcome::Done }, written)
}
