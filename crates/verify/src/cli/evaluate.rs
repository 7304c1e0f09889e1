//! `grazing evaluate`: b_{n,k} and c_n at one point.

use std::{io::Write, path::PathBuf};

use clap::{ArgGroup, Parser};
use num_rational::BigRational;
use num_traits::One;
use serde_json::json;

use super::{Outcome, PrintFormat, place::coordinates, range::whole, reported};
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    local::{Answer, Ladder, Plane, Point, Polar, Quantity, SignDecision},
    number::{Precision, Sign, ball_digits, parse_integer, parse_rational},
    output::{
        Caption, Column, FileRegistry, Print, Setting, TableCell, TableFormat, TableWriter, latex_numbers,
    },
};

/// The largest period for which all b_{n,k} are listed; with K any period will do.
const LIST: u64 = 100_000;

/// Evaluate b_{n,k} and c_n at one point: sign, what decided it, and certain digits.
///
/// A printed number is off by less than one unit of its last digit, and near u_n = 0 and near zeros it has as
/// many digits as elsewhere: longer balls are taken there, up to 16384 bits more. The sign comes from the
/// first method that can tell: f64 intervals, balls of 128 to 16384 bits, or exact arithmetic. Where u_n = 0
/// both b_{n,k} and c_n are "singular", that is, not defined. Numbers may have up to 32768 bits in numerator
/// and denominator.
///
/// Exit code 0: done; 2: wrong usage; 3: a sign is undecided, or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing evaluate 5 --s 1/7 --r 0.9
  grazing evaluate 1000000 7 --s 3/8+2^-200 --bits 512")]
#[command(group = ArgGroup::new("point").required(true).args(["s", "a1"]))]
pub struct Args {
    /// The period.
    #[arg(value_name = "N", required_unless_present = "long_n", value_parser = parse_integer::<u64>)]
    n: Option<u64>,
    /// The index, 1 <= K < N; without it all b_{n,k} are listed.
    #[arg(value_name = "K", value_parser = parse_integer::<u64>)]
    k: Option<u64>,
    /// As it was written once.
    #[arg(long = "n", hide = true, conflicts_with = "n", value_name = "N", value_parser = parse_integer::<u64>)]
    long_n: Option<u64>,
    /// As it was written once.
    #[arg(long = "k", hide = true, conflicts_with = "k", value_name = "K", value_parser = parse_integer::<u64>)]
    long_k: Option<u64>,
    /// The angle of complex eigenvalues over 2 pi, 0 < S < 1/2.
    #[arg(long, value_parser = parse_rational, allow_hyphen_values = true)]
    s: Option<BigRational>,
    /// Their modulus, 0 < R <= 1.
    #[arg(long, value_parser = parse_rational, allow_hyphen_values = true, requires = "s", default_value = "1")]
    r: BigRational,
    /// The trace.
    #[arg(long, value_parser = parse_rational, allow_hyphen_values = true, requires = "a2", value_name = "X")]
    a1: Option<BigRational>,
    /// The determinant, positive.
    #[arg(long, value_parser = parse_rational, allow_hyphen_values = true, requires = "a1", value_name = "Y")]
    a2: Option<BigRational>,
    /// The precision of the printed digits, 16 to 65536 bits.
    #[arg(long, default_value_t = 128, value_parser = whole(16..=65536))]
    bits: u32,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = PrintFormat::Text)]
    pub(super) format: PrintFormat,
    /// Write the result to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    let point = args.point()?;
    let destination = files.destination(args.output.as_deref())?;
    let n = args.n();
    if n == 0 {
        return Err(Error::input("N = 0: a period is at least 1"));
    }
    let range = match args.k.or(args.long_k) {
        Some(k) if k == 0 || k >= n => {
            return Err(Error::input(format!("K = {k} is outside 1 <= K < N = {n}")));
        }
        Some(k) => k..k + 1,
        None if n > LIST => {
            return Err(Error::input(format!(
                "N = {n}: all b_{{n,k}} are listed up to N = {LIST}; name one, as in {n} 1"
            )));
        }
        None => 1..n,
    };
    let (ladder, precision) = (Ladder::default(), Precision::new(args.bits));
    let quantities = range.map(|k| Quantity::B { n, k }).chain([Quantity::C { n }]);
    let mut outcome = Outcome::Done;
    let mut rows = Vec::new();
    for quantity in quantities {
        let decision = ladder.sign_watched(&point, quantity, interrupt)?;
        interrupt.check()?;
        if decision.answer == Answer::Undecided {
            outcome = Outcome::Undecided;
        }
        rows.push(Row { quantity, decision, digits: digits(&point, quantity, decision, &precision) });
    }
    let written = destination.write(|out| match args.format {
        PrintFormat::Text => rows.iter().try_for_each(|row| Ok(writeln!(out, "{}", row.text())?)),
        PrintFormat::Json => {
            let values: Vec<_> = rows.iter().map(Row::json).collect();
            Ok(writeln!(
                out,
                "{}",
                json!({ "format": "grazing-evaluate 2", "n": n.to_string(), "values": values })
            )?)
        }
        PrintFormat::Latex => print(&rows, args, out),
    });
    reported(outcome, written)
}

impl Args {
    /// The period, of which clap sees to it that it is given.
    fn n(&self) -> u64 {
        self.n.or(self.long_n).unwrap_or_default()
    }

    fn point(&self) -> Result<Point> {
        Ok(match (&self.s, &self.a1, &self.a2) {
            (Some(s), _, _) => Point::Polar(Polar::new(self.r.clone(), s.clone())?),
            (None, Some(a1), Some(a2)) if self.r.is_one() => {
                Point::Plane(Plane::new(a1.clone(), a2.clone())?)
            }
            _ => return Err(Error::input("give a point by --s (and --r), or by --a1 and --a2")),
        })
    }
}

/// A LaTeX table with a row for each quantity.
fn print(rows: &[Row], args: &Args, out: &mut dyn Write) -> Result<()> {
    let columns = vec![
        Column::new("quantity", "quantity", 0).print(Print::Left),
        Column::new("sign", "sign", 0),
        Column::new("decided_by", "decided by", 0).print(Print::Left),
        Column::new("value", "value", 0).print(Print::Lines(45)),
    ];
    let at = coordinates(args.a1.as_ref().zip(args.a2.as_ref()), args.s.as_ref().map(|s| (&args.r, s)));
    let text = format!(
        "$b_{{n,k}}$ and $c_n$ for $n = {}$ at {at}. Each value is off by less than one unit of its last digit.",
        args.n()
    );
    let caption = Caption { text, label: format!("tab:evaluate-{}", args.n()) };
    let setting = Setting { caption: Some(&caption), width: None };
    let mut table = TableWriter::set(out, TableFormat::Latex, "grazing-evaluate 2", columns, setting)?;
    for row in rows {
        let SignDecision { answer, rung, .. } = row.decision;
        let (name, sign, rung) = (row.quantity.to_string(), answer.to_string(), rung.to_string());
        let digits = latex_numbers(row.digits.as_deref().unwrap_or_default());
        let known = matches!(answer, Answer::Sign(_));
        table.row(&[
            TableCell::Maths(&name),
            if known { TableCell::Maths(&sign) } else { TableCell::Text(&sign) },
            TableCell::Text(&rung),
            match digits.trim_matches('$') {
                "" => TableCell::Empty,
                digits => TableCell::Maths(digits),
            },
        ])?;
    }
    table.finish()
}

struct Row {
    quantity: Quantity,
    decision: SignDecision,
    digits: Option<String>,
}

impl Row {
    fn text(&self) -> String {
        let SignDecision { answer, rung, .. } = self.decision;
        let digits = self.digits.as_deref().unwrap_or_default();
        let name = self.quantity.to_string();
        format!("{name:<12} {answer:<9} {rung:<12} {digits}").trim_end().to_string()
    }

    fn json(&self) -> serde_json::Value {
        let SignDecision { answer, rung, .. } = self.decision;
        json!({ "name": self.quantity, "sign": answer, "decided_by": rung, "value": self.digits })
    }
}

/// The certain digits at the precision asked for.
fn digits(
    point: &Point,
    quantity: Quantity,
    decision: SignDecision,
    precision: &Precision,
) -> Option<String> {
    if decision.answer == Answer::Sign(Sign::Zero) {
        return Some("0".into());
    }
    ball_digits(&point.evaluate_closely(quantity, precision)?, precision.bits() * 3 / 10)
}
