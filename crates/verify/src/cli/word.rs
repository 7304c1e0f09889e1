//! `grazing word`: every impact pattern at one point, for all periods at once.

use std::{
    fmt::Write as _,
    io::Write,
    path::{Path, PathBuf},
};

use clap::{ArgGroup, Parser, ValueEnum};
use serde_json::{Value as Json, json};

use super::{
    Outcome, cite,
    classify::describe,
    decides,
    place::{self, Asked, Bounds, Place, REVERSED},
    pretty, reported, returns, samples,
    shares::{Limits, Weight},
};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::Resonance,
    local::{Forward, Ladder, Point, Region},
    number::{certain_digits, parse_integer},
    output::{
        Caption, Column, Destination, FileRegistry, OutputFile, Print, Setting, TableCell, TableFormat,
        TableWriter, say,
    },
    printable::Printable,
    search::{Certified, ShareStatement, WordCertificate, WordPlace, certify_share, certify_word},
    tolerance::ParameterBox,
    word::{ClosedWalks, Edge, Entropy, Extent, Letter, Rectangle, Relation, Word},
};

/// The most letters of one word that the command lists: the graph has that many squared edges.
const LETTERS: usize = 2000;
/// The largest --max-period.
const LIMIT: u64 = 400;
/// Bits of the entropy.
const BITS: u32 = 64;

/// Find every impact pattern at one point: which periods occur between impacts, and which may follow which.
///
/// Explained in docs/words.md; tolerances in docs/measured.md. Exit code 3: something is open.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing word --r 0.4633 --s 0.16327
  grazing word --r 1.25 --s 0.37 --returns
  grazing word --frequency 3.7Hz±1% --damping-ratio 0.1±20% --drive 10Hz --shares")]
#[command(group = ArgGroup::new("point").required(true).args(["a1", "r", "frequency", "samples"]))]
#[command(group = ArgGroup::new("of_cells").args(["shares", "decides"]))]
pub struct Args {
    #[command(flatten)]
    place: Place,
    /// Count patterns up to this period, at most 400.
    #[arg(long, value_name = "P", default_value_t = 12, value_parser = parse_integer::<u64>)]
    max_period: u64,
    /// Longest word, at most 2000.
    #[arg(long, value_name = "L", default_value_t = 200, value_parser = parse_integer::<usize>)]
    letters: usize,
    /// Write a certificate.
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// What that of --shares is of: "chaos +", "period + 3", "word + 5 1D 2U 3U".
    #[arg(long, value_name = "WHAT", requires_all = ["shares", "certificate"],
          value_parser = ShareStatement::parse)]
    holds: Option<ShareStatement>,
    /// List first-return times to the grazing line.
    #[arg(long, conflicts_with_all = ["certificate", "max_period"])]
    returns: bool,
    /// Say in which share of a box each verdict holds.
    #[arg(long, conflicts_with = "returns")]
    shares: bool,
    /// X±Y is a normal parameter with deviation Y.
    #[arg(long, requires = "shares", conflicts_with = "certificate")]
    normal: bool,
    /// Count the verdicts of machines in a CSV.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["certificate", "returns", "shares", "decides"])]
    samples: Option<PathBuf>,
    /// Say what change of a parameter changes a verdict.
    #[arg(long, conflicts_with_all = ["certificate", "returns", "shares"])]
    decides: bool,
    /// Cells, at most 1000000.
    #[arg(long, value_name = "C", default_value_t = 2_000, requires = "of_cells",
          value_parser = parse_integer::<u64>)]
    cells: u64,
    /// Rest the certificate on the word theorem: all periods.
    #[arg(long, requires = "certificate", conflicts_with = "shares")]
    by_theorem: bool,
    /// Form of the result.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    /// Write to a file.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Args {
    /// The name of its JSON.
    pub(super) fn json_name(&self) -> &'static str {
        match self {
            Args { returns: true, .. } => "grazing-returns 1",
            Args { shares: true, .. } | Args { samples: Some(_), .. } => "grazing-shares 1",
            Args { decides: true, .. } => "grazing-decides 1",
            _ => "grazing-word 1",
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Json,
    Dot,
    Csv,
    Latex,
    LatexSiunitx,
}

impl Format {
    /// As the format of a table; `option` is what prints no graphs.
    pub fn of_table(self, option: &str) -> Result<TableFormat> {
        match self {
            Format::Text => Ok(TableFormat::Table),
            Format::Json => Ok(TableFormat::Json),
            Format::Csv => Ok(TableFormat::Csv),
            Format::Latex => Ok(TableFormat::Latex),
            Format::LatexSiunitx => Ok(TableFormat::LatexSiunitx),
            Format::Dot => {
                Err(Error::input(format!("--format dot draws pattern graphs: leave out {option}")))
            }
        }
    }
}

/// One sign of γ of a word.
struct Case {
    relation: Relation,
    counts: Vec<(String, String)>,
    entropy: Entropy,
    at_least: bool,
}

/// One sign of eµ.
struct Side {
    word: Word,
    cases: Vec<Case>,
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    if !(1..=LIMIT).contains(&args.max_period) {
        return Err(Error::input(format!("--max-period {}: from 1 to {LIMIT}", args.max_period)));
    }
    if !(1..=LETTERS).contains(&args.letters) {
        return Err(Error::input(format!("--letters {}: from 1 to {LETTERS}", args.letters)));
    }
    let destination = files.destination(args.output.as_deref())?;
    if args.returns {
        return return_times(args, &destination, interrupt);
    }
    let limits = Limits { cells: args.cells, last: args.max_period };
    if let Some(file) = &args.samples {
        let (all, bounds) = samples::read(file, files)?;
        let of = (&all[0], Weight::Samples(&all));
        return super::shares::run(of, (&bounds, None), limits, args.format, &destination, interrupt);
    }
    if args.shares {
        return shares(args, limits, files, &destination, interrupt);
    }
    if args.decides {
        return decides::run(args.place.given()?, &limits, args.format, &destination, interrupt);
    }
    let file = args.certificate.as_deref().map(|path| files.write("--certificate", path)).transpose()?;
    let given = Given::new(args)?;
    if given.reversed && file.is_some() {
        return Err(Error::input(
            "--certificate: for a2 > 1 certify the time-reversed system, at a1/a2 and 1/a2 (or 1/r and s); its patterns are read backwards",
        ));
    }
    let ladder = Ladder::default();
    let progress = Progress::new(interrupt, 0, "letters");
    let sides = [true, false]
        .into_iter()
        .map(|positive| {
            let word = match &given.place {
                At::Point(point) => Word::at(&ladder, point, positive, args.letters, &progress)?,
                At::Rectangle(rectangle) => Word::in_rectangle(rectangle, positive, args.letters, &progress)?,
                At::Box(of) => of.word(positive, args.letters, &progress)?,
            };
            let cases = [true, false]
                .into_iter()
                .map(|gamma| case(&word, gamma, given.reversed, args.max_period))
                .collect::<Result<_>>()?;
            Ok(Side { word, cases })
        })
        .collect::<Result<Vec<Side>>>()?;
    drop(progress);
    let certified = file.as_ref().map(|_| certify(args, &given, &sides, interrupt)).transpose()?;
    let kept = keep(file.as_ref(), certified.as_ref());
    let written_to = match &certified {
        Some(Certified::Text(_)) if kept.is_ok() => args.certificate.as_deref(),
        _ => None,
    };
    let heading = &given.heading;
    let text_of = match &certified {
        Some(Certified::Text(text)) => text,
        _ => "",
    };
    let silent = given.silent(args.max_period, &sides);
    let caption = caption(&given, written_to.map(|path| cite::written(path, text_of)));
    let written = destination.write(|out| match args.format {
        Format::Text => {
            let silent = in_words(&given, &silent);
            Ok(out.write_all(text((heading, &silent), &sides, written_to).as_bytes())?)
        }
        Format::Json => json_report((&given, &silent), &sides, written_to, out),
        Format::Dot => Ok(out.write_all(dot(&sides).as_bytes())?),
        Format::Csv => table(&sides, TableFormat::Csv, &caption, out),
        Format::Latex => table(&sides, TableFormat::Latex, &caption, out),
        Format::LatexSiunitx => table(&sides, TableFormat::LatexSiunitx, &caption, out),
    });
    let open = sides.iter().any(|side| {
        !matches!(side.word.extent(), Extent::All | Extent::Complete { .. })
            || side.cases.iter().any(|case| case.relation.is_open())
    });
    let open = open || !silent.is_empty() || matches!(certified, Some(Certified::Undecided(_)));
    reported(if open { Outcome::Undecided } else { Outcome::Done }, kept.and(written))
}

/// What the word leaves out, in words.
fn in_words(given: &Given, silent: &[(u64, Option<Resonance>)]) -> String {
    let [(n, first), ..] = silent else { return String::new() };
    let of = if first.is_some() { " of several impacts" } else { "" };
    let lines =
        if given.point().is_some() { Resonance::in_words(silent) } else { vec![Resonance::across(*n)] };
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    format!("{text}Theorem 1 is silent about patterns{of} with such a period: they are not counted below.\n")
}

/// `--returns`.
fn return_times(args: &Args, destination: &Destination, interrupt: &Interrupt) -> Result<Outcome> {
    let format = args.format.of_table("--returns")?;
    let (forward, at) = match args.place.asked()? {
        Asked::Point(point) => (point.forward()?, point.coordinates()),
        Asked::Box(..) => {
            return Err(Error::input("--returns is asked at one point: give its coordinates as numbers"));
        }
    };
    returns::run(&forward, &at, args.letters, format, destination, interrupt)
}

/// `--shares`.
fn shares(
    args: &Args,
    limits: Limits,
    files: &FileRegistry,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let Asked::Box(asked) = args.place.asked()? else {
        return Err(Error::input("--shares are those of a box: give at least one coordinate as an interval"));
    };
    if args.place.drive_varies() {
        return Err(Error::input(
            "--shares: give --drive as one number, for every part of a box counts by its size",
        ));
    }
    let (of, bounds) = *asked;
    if args.normal {
        let (normal, of, bounds) = args.place.normal(&of, &bounds)?;
        let of = (&of, Weight::Normal(&normal));
        return super::shares::run(of, (&bounds, None), limits, args.format, destination, interrupt);
    }
    limits.check()?;
    let file = args.certificate.as_deref().map(|path| files.write("--certificate", path)).transpose()?;
    let certified = match (&args.holds, &file) {
        (Some(holds), _) => {
            let progress = Progress::new(interrupt, 0, "cells of the certificate");
            let mut stop = || interrupt.check().is_err();
            Some(certify_share(&of, holds, limits.cells, &progress, &mut stop)?)
        }
        (None, None) => None,
        (None, Some(_)) => {
            return Err(Error::input(
                "--certificate with --shares is of one statement: add --holds \"chaos +\", \"period + 3\" or \"word + 5 1D 2U 3U\"",
            ));
        }
    };
    let kept = keep(file.as_ref(), certified.as_ref());
    let proved = match (&certified, &args.certificate) {
        (Some(Certified::Text(text)), Some(path)) if kept.is_ok() => Some((path.as_path(), text.as_str())),
        _ => None,
    };
    let of = (&of, Weight::Size);
    let outcome = super::shares::run(of, (&bounds, proved), limits, args.format, destination, interrupt)?;
    let open = matches!(certified, Some(Certified::Undecided(_))) && outcome == Outcome::Done;
    reported(if open { Outcome::Undecided } else { outcome }, kept)
}

/// Writes a certificate, or says why there is none.
fn keep(file: Option<&OutputFile>, certified: Option<&Certified>) -> Result<()> {
    match (file, certified) {
        (Some(file), Some(Certified::Text(text))) => file.write(|out| Ok(out.write_all(text.as_bytes())?)),
        (_, Some(Certified::Undecided(reason))) => {
            say(format_args!("no certificate: {reason}"));
            Ok(())
        }
        _ => Ok(()),
    }
}

/// What the table of the words shows; `certificate` is the one that proves it.
fn caption(given: &Given, certificate: Option<String>) -> Caption {
    let cited = certificate.map_or(String::new(), |name| format!(" Proved by the certificate {name}."));
    Caption {
        text: format!(
            "The periods $n$ that can occur between impacts at {}, in the order of the Stern--Brocot path: the \
             fraction $m/n$ of each, its letter, and the periods that may follow it.{cited}",
            given.at
        ),
        label: "tab:word".into(),
    }
}

/// A row for each period of each word: its letter, and what may follow it for either sign of γ.
fn table(sides: &[Side], format: TableFormat, caption: &Caption, out: &mut dyn Write) -> Result<()> {
    let columns = vec![
        Column::new("sign_emu", "for", 0),
        Column::new("n", "$n$", 0),
        Column::new("place", "$m/n$", 0),
        Column::new("letter", "letter", 0).print(Print::Left),
        Column::new("after_plus", "may follow, $\\gamma > 0$", 0).print(Print::Lines(28)),
        Column::new("after_minus", "may follow, $\\gamma < 0$", 0).print(Print::Lines(28)),
    ];
    let setting = Setting { caption: Some(caption), ..Setting::default() };
    let mut table = TableWriter::set(out, format, "grazing-word 1", columns, setting)?;
    for side in sides {
        for vertex in side.word.vertices() {
            let after = |case: &Case| {
                let relation = &case.relation;
                let follows = |to: &&u64| relation.edge(vertex.period, **to) == Edge::Yes;
                let all = relation.periods().iter().filter(follows).map(u64::to_string);
                all.collect::<Vec<_>>().join(", ")
            };
            let after: Vec<String> = side.cases.iter().map(after).collect();
            let place = vertex.fraction();
            let sign = match (format.is_print(), side.word.is_positive()) {
                (true, true) => TableCell::Maths("e\\mu > 0"),
                (true, false) => TableCell::Maths("e\\mu < 0"),
                (false, positive) => TableCell::Int(if positive { 1 } else { -1 }),
            };
            table.row(&[
                sign,
                TableCell::Int(vertex.period as i64),
                TableCell::Fraction(&place),
                TableCell::Text(&vertex.letter.to_string()),
                TableCell::Text(&after[0]),
                TableCell::Text(&after[1]),
            ])?;
        }
    }
    table.finish()
}

/// Where the words are asked for.
enum At {
    Point(Box<Point>),
    Rectangle(Box<Rectangle>),
    Box(Box<ParameterBox>),
}

struct Given {
    place: At,
    /// Whether time was reversed to get there.
    reversed: bool,
    heading: String,
    /// The place in LaTeX.
    at: String,
    /// The names and bounds of a box, and of a machine's whether γ > 0.
    bounds: Option<(Bounds, Option<Option<bool>>)>,
}

impl Given {
    /// The point, if it is one.
    fn point(&self) -> Option<&Point> {
        match &self.place {
            At::Point(point) => Some(point),
            At::Rectangle(_) | At::Box(_) => None,
        }
    }

    /// The periods up to the last that is counted with u_n = 0, of which the word is not, and their
    /// resonance, which is none for a₂ = 1; of a box the first resonance that it may meet.
    fn silent(&self, last: u64, sides: &[Side]) -> Vec<(u64, Option<Resonance>)> {
        match self.point() {
            Some(point) => Resonance::up_to(point, last),
            None => {
                let met = sides.iter().filter_map(|side| side.word.straddled_resonance());
                met.map(|n| (n, Some(Resonance::First))).collect()
            }
        }
    }

    fn new(args: &Args) -> Result<Given> {
        let (of, bounds) = match args.place.asked()? {
            Asked::Point(asked) => {
                let Forward { point, region, reversed } = asked.forward()?;
                let time = if reversed { REVERSED } else { "" };
                let heading = format!("{}{time}", describe(region));
                let place = At::Point(Box::new(point));
                return Ok(Given { place, reversed, heading, at: asked.coordinates(), bounds: None });
            }
            Asked::Box(of) => *of,
        };
        let at = format!("all points with {}", place::in_latex(&bounds));
        let shown = place::shown(&bounds);
        let (place, heading, gamma) = if bounds[0].0 == "a1" {
            let rectangle = Rectangle::new(bounds[0].1.clone(), bounds[1].1.clone())?;
            let region = rectangle.region().map_or("The box meets a line between regions".into(), describe);
            (At::Rectangle(Box::new(rectangle)), format!("All points with {shown}. {region}"), None)
        } else if of.has_gamma() {
            let gamma = of.gamma_is_positive();
            let sign = match gamma {
                Some(true) => "gamma > 0 for all of them",
                Some(false) => "gamma < 0 for all of them",
                None => "gamma has not one sign, or may be 0",
            };
            (At::Box(Box::new(of)), format!("All machines with {shown}. {sign}"), Some(gamma))
        } else {
            (At::Box(Box::new(of)), format!("All points with {shown}. {}", describe(Region::Three)), None)
        };
        Ok(Given { place, reversed: false, heading, at, bounds: Some((bounds, gamma)) })
    }
}

fn certify(args: &Args, given: &Given, sides: &[Side], interrupt: &Interrupt) -> Result<Certified> {
    let place = match &given.place {
        At::Point(point) => WordPlace::Point(point),
        At::Rectangle(rectangle) => WordPlace::Rectangle(rectangle),
        At::Box(_) => {
            return Err(Error::input(
                "--certificate: for a point, or for intervals of --a1 and --a2; of other boxes there is one of a share, with --shares and --holds",
            ));
        }
    };
    let words: Vec<&Word> = sides.iter().map(|side| &side.word).collect();
    let last = args.max_period;
    let kind = if args.by_theorem { WordCertificate::ByTheorem } else { WordCertificate::BySigns { last } };
    certify_word(place, &words, kind, &mut || interrupt.check().is_err())
}

fn case(word: &Word, gamma: bool, reversed: bool, last: u64) -> Result<Case> {
    let counted = ClosedWalks::new(&Relation::new(word, gamma, reversed, last)?).count(last);
    let (entropy, at_least) = Entropy::of(word, gamma, BITS)?;
    // Over all periods the relation is shown on those counted.
    let shown = if word.is_endless() { last } else { u64::MAX };
    Ok(Case {
        relation: Relation::new(word, gamma, reversed, shown)?,
        counts: counted.iter().map(|row| (row.all.to_string(), row.primitive.to_string())).collect(),
        entropy,
        at_least,
    })
}

fn sign(positive: bool) -> &'static str {
    if positive { ">" } else { "<" }
}

fn digits(entropy: &Entropy) -> Option<String> {
    let (lo, hi) = entropy.bounds()?;
    Some(certain_digits(&lo, &hi, 15).unwrap_or_else(|| "0".into()))
}

fn text((heading, silent): (&str, &str), sides: &[Side], certificate: Option<&Path>) -> String {
    let mut text = format!("{heading}\n{silent}");
    let mut chaotic = Vec::new();
    for side in sides {
        let positive = side.word.is_positive();
        let _ = writeln!(text, "\ne*mu {} 0: word {}", sign(positive), side.word.letters());
        for vertex in side.word.vertices() {
            let (n, place) = (vertex.period, vertex.fraction());
            let _ = write!(text, "  {} period {n} at {}/{}", vertex.letter, place.numer(), place.denom());
            if vertex.letter == Letter::Either {
                let _ = write!(text, ": c_{n} is 0, or has not one sign");
            }
            text += "\n";
        }
        let _ = writeln!(text, "  {}", side.word.extent().in_words());
        for case in &side.cases {
            let _ = writeln!(text, "  case {}:", case.relation.case());
            if side.word.extent() == Extent::All {
                let all = !case.relation.loops().is_empty();
                let _ = writeln!(
                    text,
                    "    {}",
                    if all { "every period may follow every period" } else { "no period may follow any" }
                );
            } else {
                edges(&case.relation, &mut text);
            }
            let counts: Vec<&str> = case.counts.iter().map(|(all, _)| all.as_str()).collect();
            let _ = writeln!(text, "    patterns of period 1, 2, ...: {}", counts.join(" "));
            let at_least = if case.at_least { "at least " } else { "" };
            let _ = match (&case.entropy, digits(&case.entropy)) {
                (Entropy::Positive { .. }, Some(rate)) => {
                    chaotic.push(format!(
                        "{} with entropy {at_least}{rate} per forcing period",
                        case.relation.case()
                    ));
                    writeln!(text, "    entropy {at_least}{rate}")
                }
                (_, Some(_)) => writeln!(text, "    entropy {at_least}0"),
                (_, None) => writeln!(
                    text,
                    "    {}",
                    if case.at_least { "no pattern is certain" } else { "no pattern exists" }
                ),
            };
        }
    }
    let open = |case: &&Case| case.at_least && !matches!(case.entropy, Entropy::Positive { .. });
    let open: Vec<String> = sides
        .iter()
        .flat_map(|side| &side.cases)
        .filter(open)
        .map(|case| case.relation.case().to_string())
        .collect();
    let sentence = match (&chaotic[..], &open[..]) {
        ([], []) => {
            let by = if silent.is_empty() { "" } else { " by patterns without such a period" };
            format!("Chaos is born in none of the four cases (sign e*mu, sign gamma){by}.")
        }
        ([], _) => {
            "Whether chaos is born is not decided: it is certain in none of the four cases (sign e*mu, sign gamma)."
                .into()
        }
        _ => {
            let born = chaotic.join("\n  ");
            let left = if open.is_empty() { String::new() } else { format!("\nNot decided: {}", open.join(", ")) };
            format!("Chaos is born in these cases (sign e*mu, sign gamma):\n  {born}{left}")
        }
    };
    let _ = writeln!(text, "\n{sentence}");
    if let Some(path) = certificate {
        let _ = writeln!(text, "Certificate: {}", Printable(&path.display().to_string()));
    }
    text
}

fn edges(relation: &Relation, text: &mut String) {
    for (i, row) in relation.edges().iter().enumerate() {
        let list = |wanted: Edge| {
            let periods = row.iter().zip(relation.periods()).filter(|(edge, _)| **edge == wanted);
            periods.map(|(_, n)| n.to_string()).collect::<Vec<_>>().join(", ")
        };
        let (yes, open) = (list(Edge::Yes), list(Edge::Open));
        let open = if open.is_empty() { open } else { format!("; open: {open}") };
        let yes = if yes.is_empty() { "nothing".into() } else { yes };
        let _ = writeln!(text, "    after {}: {yes}{open}", relation.periods()[i]);
    }
}

fn json_report(
    (given, silent): (&Given, &[(u64, Option<Resonance>)]),
    sides: &[Side],
    certificate: Option<&Path>,
    out: &mut dyn Write,
) -> Result<()> {
    let sides: Vec<Json> = sides
        .iter()
        .map(|side| {
            let vertices = side.word.vertices();
            let (kind, next) = match side.word.extent() {
                Extent::All => ("all", None),
                Extent::Complete { next } => ("complete", next),
                Extent::Boundary { next, deciding: Some(_) } => ("boundary", Some(next)),
                Extent::Boundary { next, deciding: None } => ("singular", Some(next)),
                Extent::Undecided { next, .. } => ("undecided", Some(next)),
                Extent::Straddled { next } => ("straddled", Some(next)),
                Extent::Cut => ("cut", None),
                Extent::Odd => ("odd", None),
                Extent::Line => ("line", None),
            };
            json!({
                "sign_emu": if side.word.is_positive() { 1 } else { -1 },
                "letters": side.word.letters(),
                "periods": vertices.iter().map(|vertex| vertex.period).collect::<Vec<_>>(),
                "fractions": vertices
                    .iter()
                    .map(|vertex| format!("{}/{}", vertex.numerator, vertex.period))
                    .collect::<Vec<_>>(),
                "end": { "kind": kind, "next": next, "detail": side.word.extent().in_words() },
                "cases": side.cases.iter().map(json_case).collect::<Vec<_>>(),
            })
        })
        .collect();
    let bounds = given.bounds.as_ref().map(|(bounds, gamma)| place::json(bounds, *gamma));
    let row = |(n, kind): &(u64, Option<Resonance>)| json!({ "period": n, "resonance": kind });
    let resonances: Vec<Json> = silent.iter().map(row).collect();
    let report = json!({
        "format": "grazing-word 1",
        "region": given.heading,
        "box": bounds,
        "reversed": given.reversed,
        "words": sides,
        "resonances": resonances,
        "certificate": certificate.map(|path| path.display().to_string()),
    });
    pretty(&report, out)
}

fn json_case(case: &Case) -> Json {
    let pairs = |wanted: Edge| {
        let rows = case.relation.edges().iter().zip(case.relation.periods());
        rows.flat_map(|(row, from)| {
            let follows = row.iter().zip(case.relation.periods()).filter(|(edge, _)| **edge == wanted);
            follows.map(|(_, to)| [*from, *to]).collect::<Vec<_>>()
        })
        .collect::<Vec<_>>()
    };
    let (kind, z) = match &case.entropy {
        Entropy::Empty => ("none", None),
        Entropy::Zero => ("zero", None),
        Entropy::Positive { z: (lo, hi), .. } => ("positive", certain_digits(lo, hi, 15)),
    };
    json!({
        "sign_gamma": case.relation.case().sign_gamma(),
        "edges": pairs(Edge::Yes),
        "open": pairs(Edge::Open),
        "loops": case.relation.loops(),
        "patterns": case
            .counts
            .iter()
            .enumerate()
            .map(|(index, (all, primitive))| json!({ "period": index + 1, "all": all, "primitive": primitive }))
            .collect::<Vec<_>>(),
        "entropy": { "kind": kind, "rate": digits(&case.entropy), "z": z, "lower_bound": case.at_least },
        "chaotic": matches!(case.entropy, Entropy::Positive { .. }),
    })
}

fn dot(sides: &[Side]) -> String {
    let mut text = String::from(
        "// Which period may follow which, one graph per case (sign e*mu, sign gamma): its closed walks are the impact patterns.\n\
         // dashed: a quantity is zero or not known\ndigraph patterns {\n  node [shape=circle];\n",
    );
    for case in sides.iter().flat_map(|side| &side.cases) {
        let relation = &case.relation;
        let name: String = relation
            .case()
            .to_string()
            .chars()
            .map(|c| {
                if c == '+' {
                    'p'
                } else if c == '-' {
                    'm'
                } else {
                    '_'
                }
            })
            .collect();
        let _ = writeln!(text, "  subgraph cluster{name} {{\n    label=\"{}\";", relation.case());
        for n in relation.periods() {
            let _ = writeln!(text, "    \"{name}{n}\" [label=\"{n}\"];");
        }
        for (row, from) in relation.edges().iter().zip(relation.periods()) {
            for (edge, to) in row.iter().zip(relation.periods()) {
                let style = match edge {
                    Edge::Yes => "",
                    Edge::Open => " [style=dashed]",
                    Edge::No => continue,
                };
                let _ = writeln!(text, "    \"{name}{from}\" -> \"{name}{to}\"{style};");
            }
        }
        text += "  }\n";
    }
    text + "}\n"
}
