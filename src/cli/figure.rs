//! `grazing figure`: the project's figures, each with its data beside it.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use super::Outcome;
use crate::{error::Result, output::figure};

/// Draw a figure as SVG, with its data as CSV beside it.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// Which figure.
    #[arg(value_enum)]
    figure: Figure,
    /// The largest period shown, 3 to 40.
    #[arg(long, value_name = "N", default_value_t = 15)]
    n: u64,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Figure {
    /// Theorem 2's intervals for n = 3 to N.
    Intervals,
    /// Single-impact orbits of period 15 in regions 1, 2 and 5.
    #[value(name = "3")]
    Orbits,
}

pub(super) fn run(args: &Args) -> Result<Outcome> {
    match args.figure {
        Figure::Intervals => figure::intervals(args.n, &args.output)?,
        Figure::Orbits => figure::orbits(&args.output)?,
    }
    Ok(Outcome::Done)
}
