//! `grazing figure`: the project's figures, each with its data beside it.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use num_rational::BigRational;

use super::{Outcome, run::paper};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    figure,
    number::parse_rational,
    output::make_folder,
};

/// Draw a figure as SVG, with its data as CSV beside it.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// Which figure.
    #[arg(value_enum)]
    figure: Figure,
    /// The largest period shown, for 5 the only one; by default 15, for tips 200, for 5 8.
    #[arg(long, value_name = "N")]
    n: Option<u64>,
    /// For records: the modulus of the eigenvalues, 0 < R <= 1; by default 0.993.
    #[arg(long, value_name = "R", value_parser = parse_rational)]
    r: Option<BigRational>,
    /// For records: their angle in turns, 0 < S < 1/2; by default 0.205.
    #[arg(long, value_name = "S", value_parser = parse_rational)]
    s: Option<BigRational>,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Figure {
    /// The five regions of the (a1, a2) plane.
    #[value(name = "2")]
    Regions,
    /// Single-impact orbits of period 15 in regions 1, 2 and 5.
    #[value(name = "3")]
    Orbits,
    /// The iterate boundaries b_{n,k} = 0 that bound areas, n = 3 to N.
    #[value(name = "4")]
    Iterate,
    /// Branches of the non-impacting and the single-impact orbits of section 4.2 over mu.
    #[value(name = "6")]
    Branches,
    /// The attractor of section 4.2 between mu_gr4 and mu_cr, with the branch of period 4.
    #[value(name = "7")]
    Diagram,
    /// The areas where orbits of period N exist, from a proved cover.
    #[value(name = "5")]
    Areas,
    /// Attractors before the grazing bifurcation of section 4.2, mu = -0.05.
    #[value(name = "8")]
    Before,
    /// Attractors near it, mu = -0.024.
    #[value(name = "9")]
    Near,
    /// The attractor after it, mu = 0.003.
    #[value(name = "10")]
    After,
    /// Theorem 2's intervals for n = 3 to N.
    Intervals,
    /// The powers of an eigenvalue seen from 1: their records are the periods that exist.
    Records,
    /// The words of the (a1, a2) plane and their entropy, areas of period up to N: where chaos is born.
    Words,
    /// The lowest points of all areas beside their law for large n, n = 4 to N.
    Tips,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    if args.figure != Figure::Records && (args.r.is_some() || args.s.is_some()) {
        return Err(Error::input("--r and --s belong to `grazing figure records`"));
    }
    make_folder(&args.output)?;
    let number =
        |given: &Option<BigRational>, default| given.clone().map_or_else(|| parse_rational(default), Ok);
    let n = args.n.unwrap_or(match args.figure {
        Figure::Areas => 8,
        Figure::Tips => 200,
        _ => 15,
    });
    match args.figure {
        Figure::Regions => figure::regions(&args.output)?,
        Figure::Iterate => figure::iterate_boundaries(n, &args.output)?,
        Figure::Areas => figure::areas(n, &args.output, &Progress::new(interrupt, n + 1, "strips"))?,
        Figure::Intervals => figure::intervals(n, &args.output)?,
        Figure::Records => {
            figure::records(&number(&args.r, "0.993")?, &number(&args.s, "0.205")?, n, &args.output)?
        }
        Figure::Words => {
            figure::words(n, &args.output, &Progress::new(interrupt, n.saturating_sub(2), "periods"))?
        }
        Figure::Tips => {
            figure::tips(n, &args.output, &Progress::new(interrupt, n.saturating_sub(3), "periods"))?
        }
        Figure::Branches => paper("figure6", &args.output, interrupt)?,
        Figure::Diagram => paper("figure7", &args.output, interrupt)?,
        Figure::Before => paper("figure8", &args.output, interrupt)?,
        Figure::Near => paper("figure9", &args.output, interrupt)?,
        Figure::After => paper("figure10", &args.output, interrupt)?,
        Figure::Orbits => figure::orbits(&args.output)?,
    }
    Ok(Outcome::Done)
}
