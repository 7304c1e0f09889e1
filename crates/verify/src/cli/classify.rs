//! `grazing classify`: which single-impact orbits exist at one point.

use std::{io::Write, path::PathBuf};

use clap::Parser;

use super::{
    Outcome,
    place::{Asked, Place},
    reported,
    shares::{self, Limits},
};
use crate::{
    cli::choice::choice,
    cli::progress::Interrupt,
    error::{Error, Result},
    existence::{Existence, Resonance, large_eigenvalue_sign, up_to},
    local::{Forward, Ladder, Point, Region},
    monitor::Monitor,
    number::parse_integer,
    output::{
        Caption, Column, Destination, FileRegistry, Print, Setting, TableCell, TableFormat, TableWriter,
    },
    word::{Extent, Word},
};

/// The largest --max-period.
const LIMIT: u64 = 100_000;
/// How many cells of a box are looked at.
const CELLS: u64 = 2_000;

/// Say which single-impact orbits exist at one point, period by period.
///
/// Give the point by the trace and determinant of the linear part, --a1 and --a2, or by the modulus r and the
/// angle theta = 2 pi s of its complex eigenvalues, --r and --s. The table has, for each period, the cases
/// (sign e*mu, sign gamma) with an orbit and the sign of its large eigenvalue; or two k with b_{n,k} of
/// opposite sign, which forbid an orbit; or the boundary on which the point lies, where Theorem 1 is silent.
/// Where that is singular, n theta = m pi, its resonance says what is born: first is m = 1, higher m >= 2.
/// Where some b_{n,k} = 0 no motion of a linear oscillator has one impact in n periods, at any mu. For a2 > 1
/// the time-reversed system is classified, which has the same orbits.
///
/// With intervals, as in --r 0.97±1% --s 0.2..=0.21 or --frequency 12.3Hz±1% --damping-ratio 0.02±20% --drive
/// 10Hz, the table has for each period and case whether the orbit exists everywhere in the box, nowhere, or
/// in a part of it (differs), and bounds of the share of the box in which it does.
///
/// Exit code 0: every period is decided; 2: wrong usage; 3: of some period the theory is silent, or has the
/// second order decide, or it is undecided.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing classify --r 0.99 --s 21/100
  grazing classify --a1 -3/2 --a2 0.9 --max-period 6
  grazing classify --frequency 12.3Hz±1% --damping-ratio 0.02±20% --drive 10Hz
  grazing classify --summary")]
#[command(group(clap::ArgGroup::new("point").required(true).args(["a1", "r", "frequency", "summary"])))]
pub struct Args {
    #[command(flatten)]
    place: Place,
    /// The periods are 1 to P, at most 100000.
    #[arg(long, alias = "max-n", value_name = "P", default_value_t = 15, value_parser = parse_integer::<u64>,
          conflicts_with = "summary")]
    max_period: u64,
    /// Print what holds in each region for every period, instead of one point.
    #[arg(long)]
    summary: bool,
    /// How the table is written.
    #[arg(long, value_parser = choice::<TableFormat>(), default_value = "table")]
    pub(super) format: TableFormat,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Args {
    /// The name of its JSON.
    pub(super) fn json_name(&self) -> &'static str {
        if self.place.is_box() { "grazing-classify-box 1" } else { "grazing-classify 1" }
    }
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    let destination = files.destination(args.output.as_deref())?;
    if args.summary {
        return summary(args, &destination);
    }
    if !(1..=LIMIT).contains(&args.max_period) {
        let last = args.max_period;
        return Err(Error::input(format!("--max-period {last}: a whole number from 1 to {LIMIT}")));
    }
    let asked = match args.place.asked()? {
        Asked::Point(asked) => asked,
        Asked::Box(asked) if !args.place.drive_varies() => {
            let limits = Limits { cells: CELLS, last: args.max_period };
            return shares::classify(&asked.0, &asked.1, limits, args.format, &destination, interrupt);
        }
        Asked::Box(..) => {
            let why = "every part of a box counts by its size";
            return Err(Error::input(format!("--drive: give it as one number here, for {why}")));
        }
    };
    let (place, at) = (asked.forward()?, asked.coordinates());
    let ladder = Ladder::default().with_profile(interrupt.profile());
    let found = up_to(&ladder, &place.point, args.max_period, || interrupt.check())?;
    interrupt.check()?;
    let written = destination.write(|out| {
        if args.format == TableFormat::Table && destination.is_stdout() {
            let time = if place.reversed { ", after reversing time (a2 > 1)" } else { "" };
            writeln!(out, "{}{time}", describe(place.region))?;
            words(&place.point, out)?;
            let resonances = Resonance::up_to(&place.point, args.max_period).into_iter();
            let resonances: Vec<_> = resonances.filter(|(_, kind)| kind.is_some()).collect();
            for line in Resonance::in_words(&resonances) {
                writeln!(out, "{line}")?;
            }
            let mut zeros =
                (1u64..).zip(&found).filter_map(|(n, one)| Some((n, one.in_words(place.region)?)));
            if let Some((n, line)) = zeros.next() {
                let more = if zeros.next().is_some() { ", ..." } else { "" };
                writeln!(out, "n = {n}{more}, some b_{{n,k}} = 0: {line}")?;
            }
        }
        write(args.format, (&place, &at), &found, out)
    });
    let open = |(n, existence): (u64, &Existence)| match existence {
        Existence::Orbit(_) | Existence::None { .. } => false,
        Existence::Singular => Resonance::at(&place.point, n) != Some(Resonance::Higher),
        _ => true,
    };
    let open = (1..).zip(&found).any(open);
    reported(if open { Outcome::Undecided } else { Outcome::Done }, written)
}

/// The words for both signs of eµ, as far as they are soon found.
fn words(point: &Point, out: &mut dyn Write) -> Result<()> {
    const SHOWN: usize = 12;
    for positive in [true, false] {
        let word = Word::at(&Ladder::new(1024), point, positive, SHOWN, &())?;
        let periods: Vec<String> = word.vertices().iter().map(|vertex| vertex.period.to_string()).collect();
        let sign = if positive { '>' } else { '<' };
        match word.extent() {
            Extent::Line => {}
            Extent::All => writeln!(out, "e*mu {sign} 0: every period can occur between impacts")?,
            Extent::Odd => {
                writeln!(out, "e*mu {sign} 0: every odd period can occur between impacts, and 2")?;
            }
            _ => {
                let more = if word.is_whole() { "" } else { ", ..." };
                let (letters, periods) = (word.letters(), periods.join(", "));
                writeln!(
                    out,
                    "e*mu {sign} 0: word {letters}{more}, periods between impacts {periods}{more}"
                )?;
            }
        }
    }
    Ok(())
}

pub(super) fn describe(region: Region) -> String {
    let words = region.words();
    match region {
        Region::Line => words.replacen("on", "On", 1),
        _ => format!("Region {words}"),
    }
}

fn write(
    format: TableFormat,
    (place, at): (&Forward, &str),
    found: &[Existence],
    out: &mut dyn Write,
) -> Result<()> {
    if format.is_print() {
        return print(format, (place, at), found, out);
    }
    let columns = [
        Column::new("n", "$n$", 6),
        Column::new("existence", "existence", 17).print(Print::Left),
        Column::new("sign_emu", "$\\operatorname{sign} e\\mu$", 0),
        Column::new("sign_gamma", "$\\operatorname{sign}\\gamma$", 0),
        Column::new("large_eigenvalue", "$\\operatorname{sign}\\Lambda$", 0),
        Column::new("positive_k", "$b_{n,k} > 0$", 0),
        Column::new("negative_k", "$b_{n,k} < 0$", 0),
        Column::new("zero_k", "$b_{n,k} = 0$", 0),
        Column::new("resonance", "resonance", 0).print(Print::Left),
    ];
    let mut table = TableWriter::new(out, format, "grazing-classify 1", columns.to_vec())?;
    for (n, &existence) in (1u64..).zip(found) {
        let mut cells = [TableCell::Empty; 9];
        cells[0] = TableCell::Int(n as i64);
        cells[1] = TableCell::Text(existence.name());
        if let Some(resonance) = Resonance::at(&place.point, n) {
            cells[8] = TableCell::Text(resonance.name());
        }
        for (cell, k) in cells[5..8].iter_mut().zip(existence.indices()) {
            *cell = k.map_or(TableCell::Empty, |k| TableCell::Int(place.index(n, k) as i64));
        }
        let cases = existence.cases(n);
        for case in &cases {
            cells[2] = TableCell::Int(case.sign_emu().into());
            cells[3] = TableCell::Int(case.sign_gamma().into());
            cells[4] = TableCell::Int(large_eigenvalue_sign(place.region, n, *case).into());
            table.row(&cells)?;
        }
        if cases.is_empty() {
            table.row(&cells)?;
        }
    }
    table.finish()
}

/// The same for a page: cases, and which b_{n,k} tell.
fn print(
    format: TableFormat,
    (place, at): (&Forward, &str),
    found: &[Existence],
    out: &mut dyn Write,
) -> Result<()> {
    let columns = vec![
        Column::new("n", "$n$", 0),
        Column::new("existence", "existence", 0).print(Print::Left),
        Column::new("case", "case", 0),
        Column::new("large_eigenvalue", "$\\operatorname{sign}\\Lambda$", 0),
        Column::new("positive_k", "$> 0$", 0),
        Column::new("negative_k", "$< 0$", 0),
        Column::new("zero_k", "$= 0$", 0),
    ];
    let caption = Caption {
        text: format!(
            "Orbits with one impact in $n$ periods at {at}, {}: whether they exist, in which case \
             $(e\\mu, \\gamma)$, the sign of the large eigenvalue, and $b_{{n,k}}$ that decide.",
            describe(place.region).split(':').next().unwrap_or_default().to_lowercase()
        ),
        label: "tab:classify".into(),
    };
    let setting = Setting { caption: Some(&caption), ..Setting::default() };
    let mut table = TableWriter::set(out, format, "grazing-classify 1", columns, setting)?;
    for (n, &existence) in (1u64..).zip(found) {
        let decides = existence.indices().map(|k| k.map(|k| format!("b_{{{n},{}}}", place.index(n, k))));
        let [above, below, zero] = [0, 1, 2].map(|i| match &decides[i] {
            Some(text) => TableCell::Maths(text),
            None => TableCell::Empty,
        });
        let named = match Resonance::at(&place.point, n) {
            Some(resonance) => format!("{}, {} resonance", existence.name(), resonance.name()),
            None => existence.name().to_string(),
        };
        let mut row = |case: TableCell, sign: TableCell| {
            table.row(&[TableCell::Int(n as i64), TableCell::Text(&named), case, sign, above, below, zero])
        };
        let cases = existence.cases(n);
        for case in &cases {
            let sign = large_eigenvalue_sign(place.region, n, *case);
            row(TableCell::Maths(&case.to_string()), TableCell::Maths(if sign > 0 { "+" } else { "-" }))?;
        }
        if cases.is_empty() {
            row(TableCell::Empty, TableCell::Empty)?;
        }
    }
    table.finish()
}

/// Sections 3.6 and 3.7 of the paper, by region.
const REGIONS: [[&str; 6]; 5] = [
    ["1", "a1 > a2+1", "(+,+) (-,-)", "(+,+)", "(+,+)", "-sign(e mu)"],
    ["2", "2 sqrt(a2) <= a1 < a2+1", "(+,-) (-,+)", "(-,+)", "(-,+)", "sign(e mu)"],
    [
        "3",
        "|a1| < 2 sqrt(a2)",
        "(+,-) (-,+)",
        "(-,+) a1 > 0; (+,+) a1 < 0",
        "(-,+) 0 < s < 1/(2n); one area per interval",
        "sign(e mu)",
    ],
    [
        "4",
        "-(a2+1) < a1 <= -2 sqrt(a2)",
        "(+,-) (-,+)",
        "(+,+)",
        "n even: none; n odd: (+,-) where b_{n,n-2} > 0",
        "sign(e mu)",
    ],
    ["5", "a1 < -(a2+1)", "(+,-) (-,+)", "(+,-)", "(+,-)", "(-1)^(n+1) sign(e mu)"],
];

/// The same in print, with σ for the sign of eµ.
const FORMULAS: [[&str; 6]; 5] = [
    [
        "1",
        "a_1 > a_2 + 1",
        "\\begin{array}[t]{@{}l@{}}(+,+)\\\\ (-,-)\\end{array}",
        "(+,+)",
        "(+,+)",
        "-\\sigma",
    ],
    [
        "2",
        "\\begin{array}[t]{@{}l@{}}2\\sqrt{a_2} \\le a_1\\\\ a_1 < a_2 + 1\\end{array}",
        "\\begin{array}[t]{@{}l@{}}(+,-)\\\\ (-,+)\\end{array}",
        "(-,+)",
        "(-,+)",
        "\\sigma",
    ],
    [
        "3",
        "|a_1| < 2\\sqrt{a_2}",
        "\\begin{array}[t]{@{}l@{}}(+,-)\\\\ (-,+)\\end{array}",
        "\\begin{array}[t]{@{}l@{}}(-,+)\\text{ if } a_1 > 0\\\\ (+,+)\\text{ if } a_1 < 0\\end{array}",
        "\\begin{array}[t]{@{}l@{}}(-,+)\\text{ if } 2ns < 1\\\\ \\text{areas over intervals}\\end{array}",
        "\\sigma",
    ],
    [
        "4",
        "\\begin{array}[t]{@{}l@{}}-(a_2 + 1) < a_1\\\\ a_1 \\le -2\\sqrt{a_2}\\end{array}",
        "\\begin{array}[t]{@{}l@{}}(+,-)\\\\ (-,+)\\end{array}",
        "(+,+)",
        "\\begin{array}[t]{@{}l@{}}n \\text{ even: none}\\\\ n \\text{ odd: } (+,-)\\\\ \\text{if } b_{n,n-2} > 0\\end{array}",
        "\\sigma",
    ],
    [
        "5",
        "a_1 < -(a_2 + 1)",
        "\\begin{array}[t]{@{}l@{}}(+,-)\\\\ (-,+)\\end{array}",
        "(+,-)",
        "(+,-)",
        "(-1)^{n+1}\\sigma",
    ],
];

/// Sections 3.6 and 3.7 of the paper, by region, for 0 < a₂ ≤ 1.
fn summary(args: &Args, destination: &Destination) -> Result<Outcome> {
    let columns = [
        Column::new("region", "", 0),
        Column::new("where", "where", 30).print(Print::Lines(17)),
        Column::new("period_1", "period 1", 12).print(Print::Lines(12)),
        Column::new("period_2", "period 2", 28).print(Print::Lines(17)),
        Column::new("period_n", "period $n \\geq 3$", 52).print(Print::Lines(19)),
        Column::new("large_eigenvalue", "$\\operatorname{sign}\\Lambda$", 0).print(Print::Lines(13)),
    ];
    let caption = Caption {
        text: "The orbits with one impact by region of the plane of $a_1$ and $a_2$, $0 < a_2 \\le 1$: the cases \
               $(e\\mu, \\gamma)$ in which each period exists, and the sign of the large eigenvalue $\\Lambda$, \
               $\\sigma = \\operatorname{sign} e\\mu$."
            .into(),
        label: "tab:regions".into(),
    };
    destination.write(|out| {
        let print = args.format.is_print();
        let columns = columns.map(|column| if print { column.print(Print::Left) } else { column });
        let setting = Setting { caption: Some(&caption), ..Setting::default() };
        let name = "grazing-classify-summary 1";
        let mut table = TableWriter::set(out, args.format, name, columns.to_vec(), setting)?;
        for (row, formulas) in REGIONS.iter().zip(&FORMULAS) {
            let cells = if print { formulas.map(TableCell::Maths) } else { row.map(TableCell::Text) };
            table.row(&cells)?;
        }
        table.finish()
    })?;
    Ok(Outcome::Done)
}
