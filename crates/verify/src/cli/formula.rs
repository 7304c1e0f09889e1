//! `grazing formula`: the formulas as symbols.

use std::path::PathBuf;

use clap::Parser;

use super::Outcome;
use super::choice::choice;
use crate::{
    error::{Error, Result},
    number::parse_integer,
    output::FileRegistry,
    symbol::{Area, Format, Sentence, period_formulas, write_formulas},
};

/// Write the formulas of one period as polynomials, or Conjecture 1 for it as a sentence for other tools.
///
/// With N and K: u_n, u_k, N_{n,k} = u_n - u_k - a2^k u_{n-k} and 1 - v_n + a2^n as integer polynomials in
/// (a1, a2), both multiplied out and with every known factor taken out. For a tool, a script that makes it
/// compare the two.
///
/// With N and --sentence: a closed sentence, free of division. z3 and cvc5 answer `unsat` (of its negation),
/// QEPCAD `TRUE`.
///
/// Exit code 0: done; 2: wrong usage.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing formula 5 2
  grazing formula 5 --sentence --area 2+ --format smtlib -o area.smt2")]
pub struct Args {
    /// The period: up to 200, or up to 50 for a sentence.
    #[arg(value_parser = parse_integer::<usize>)]
    n: usize,
    /// The index k, from 1 to N - 1.
    #[arg(required_unless_present = "sentence", conflicts_with = "sentence", value_parser = parse_integer::<usize>)]
    k: Option<usize>,
    /// Write a sentence.
    #[arg(long)]
    sentence: bool,
    /// Where the sentence speaks: region4 (the default), or M+ or M- for the half-cell on one side of s =
    /// M/N, r <= 1.
    #[arg(long, value_name = "M+|M-|region4", conflicts_with = "k")]
    area: Option<Area>,
    /// Who reads it.
    #[arg(long, value_parser = choice::<Format>(), default_value = "text")]
    format: Format,
    /// Write the result to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: &Args, files: &FileRegistry) -> Result<Outcome> {
    let text = match args.k {
        Some(k) => write_formulas(&period_formulas(args.n, k)?, args.format),
        None if args.sentence => {
            Sentence::new(args.n, args.area.unwrap_or(Area::Region4))?.write(args.format)
        }
        None => return Err(Error::input("give K, or --sentence")),
    };
    files.destination(args.output.as_deref())?.write(|out| Ok(out.write_all(text.as_bytes())?))?;
    Ok(Outcome::Done)
}
