//! `grazing farey`: neighbours, rank, k-th term and walks.

use std::{io::Write, path::PathBuf};

use clap::{Parser, Subcommand};
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::ToPrimitive;
use serde_json::json;

use super::{Outcome, ReportFormat};
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    farey::{Ranker, Sequence, Walk, neighbours},
    number::{parse_integer, parse_rational},
    output::{FileRegistry, say},
};

/// Farey fractions: neighbours, rank, k-th term, walks.
///
/// Fractions may have up to 32768 bits in numerator and denominator; those of `rank` up to 64.
///
/// Exit code 0: done; 2: wrong usage; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing farey neighbours 3/8
  grazing farey walk 5
  grazing farey kth 10 100")]
pub struct Args {
    #[command(subcommand)]
    command: Command,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text, global = true)]
    pub(super) format: ReportFormat,
    /// Write the result to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE", global = true)]
    output: Option<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// The neighbours m+/n+ < P/Q < m-/n- of a fraction in F_Q.
    Neighbours {
        /// The fraction.
        #[arg(allow_hyphen_values = true, value_parser = parse_rational, value_name = "P/Q")]
        x: BigRational,
    },
    /// The index in F_N (0/1 has index 0) of the greatest term <= P/Q.
    Rank {
        /// A fraction in [0, 1].
        #[arg(allow_hyphen_values = true, value_parser = parse_rational, value_name = "P/Q")]
        x: BigRational,
        /// The order N, at most 10000000000.
        #[arg(value_parser = parse_integer::<u64>, value_name = "N")]
        order: u64,
    },
    /// The term of F_N with index K (0/1 has index 0).
    Kth {
        /// The index.
        #[arg(value_parser = parse_integer::<u128>, value_name = "K")]
        index: u128,
        /// The order N, at most 10000000000.
        #[arg(value_parser = parse_integer::<u64>, value_name = "N")]
        order: u64,
    },
    /// The terms of F_N in a closed range, one per line.
    Walk {
        /// The order N.
        #[arg(value_parser = parse_integer::<BigInt>, value_name = "N")]
        order: BigInt,
        /// The left end.
        #[arg(long, allow_hyphen_values = true, value_parser = parse_rational, default_value = "0", value_name = "P/Q")]
        from: BigRational,
        /// The right end.
        #[arg(long, allow_hyphen_values = true, value_parser = parse_rational, default_value = "1", value_name = "P/Q")]
        to: BigRational,
    },
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    let json = args.format == ReportFormat::Json;
    let mut outcome = Outcome::Done;
    files.destination(args.output.as_deref())?.list(|out| {
        let line = match &args.command {
            Command::Neighbours { x } => {
                let found = neighbours(x)?;
                let (left, right) = (fraction(&found.left), fraction(&found.right));
                if json {
                    json!({ "format": "grazing-farey 1", "fraction": fraction(x), "left": left, "right": right })
                        .to_string()
                } else {
                    format!("{left} < {} < {right}", fraction(x))
                }
            }
            Command::Rank { x, order } => {
                let index = Ranker::new(*order)?.rank(&small(x)?)?;
                report(json, &fraction(x), *order, index, &index.to_string())
            }
            Command::Kth { index, order } => {
                let x = fraction(&Ranker::new(*order)?.kth(*index)?);
                report(json, &x, *order, *index, &x)
            }
            Command::Walk { order, from, to } => {
                if walk(out, json, order, from, to, interrupt)? == 0 {
                    say(format_args!("F_{order} has no term from {} to {}", fraction(from), fraction(to)));
                    outcome = Outcome::NothingFound;
                }
                return Ok(());
            }
        };
        Ok(writeln!(out, "{line}")?)
    })?;
    Ok(outcome)
}

fn report(json: bool, x: &str, order: u64, index: u128, text: &str) -> String {
    if json {
        // As text: an index can exceed what JSON readers hold exactly.
        json!({ "format": "grazing-farey 1", "fraction": x, "order": order, "index": index.to_string() })
            .to_string()
    } else {
        text.to_string()
    }
}

fn walk(
    out: &mut dyn Write,
    json: bool,
    order: &BigInt,
    from: &BigRational,
    to: &BigRational,
    interrupt: &Interrupt,
) -> Result<u64> {
    if from > to {
        return Err(Error::input(format!("--from {} is above --to {}", fraction(from), fraction(to))));
    }
    let fast = order.to_u64().and_then(|order| Walk::new(order, &small(from).ok()?, &small(to).ok()?).ok());
    match fast {
        Some(terms) => terms_to(out, json, terms, interrupt),
        None => terms_to(out, json, Sequence::new(order.clone(), from, to)?, interrupt),
    }
}

fn terms_to<T: std::fmt::Display>(
    out: &mut dyn Write,
    json: bool,
    terms: impl Iterator<Item = Ratio<T>>,
    interrupt: &Interrupt,
) -> Result<u64> {
    if json {
        writeln!(out, "{{\"format\":\"grazing-farey 1\",\"terms\":[")?;
    }
    let (mut quote, end) = if json { ("\"", "\"") } else { ("", "\n") };
    let mut count = 0;
    for x in terms {
        count += 1;
        write!(out, "{quote}{}/{}{end}", x.numer(), x.denom())?;
        if json {
            quote = ",\n\"";
        }
        if count % 65536 == 0 && interrupt.asked() {
            if json {
                writeln!(out, "\n],\"verdict\":\"interrupted\"}}")?;
            }
            return Err(interrupt.error());
        }
    }
    if json {
        writeln!(out, "\n]}}")?;
    }
    Ok(count)
}

/// p/q, also for integers.
fn fraction<T: std::fmt::Display + Clone + num_integer::Integer>(x: &Ratio<T>) -> String {
    format!("{}/{}", x.numer(), x.denom())
}

fn small(x: &BigRational) -> Result<Ratio<u64>> {
    match (x.numer().to_u64(), x.denom().to_u64()) {
        (Some(p), Some(q)) => Ok(Ratio::new_raw(p, q)),
        _ => Err(Error::input(format!(
            "{x} is not a fraction in [0, 1] with 64-bit numerator and denominator"
        ))),
    }
}
