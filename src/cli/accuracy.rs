//! `grazing accuracy`: what accuracy costs, on this machine.

use std::{fs, path::PathBuf};

use clap::Parser;

use super::Outcome;
use crate::{
    error::{Error, Result},
    output::{Destination, Interrupt, TableFormat, accuracy_figure, accuracy_table},
    study::{FAMILIES, measure},
};

/// Measure time, certain digits and decided signs of b_{n,k}, for each rung and each family of inputs.
///
/// Prints the table and writes it as accuracy.csv, with the figure accuracy.svg beside it. Takes some seconds.
///
/// Exit code 0: done; 2: a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
pub(super) struct Args {
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    // Before the measurement rather than after it.
    fs::create_dir_all(&args.output).map_err(|error| Error::io("create", &args.output, error))?;
    let mut rows = Vec::new();
    for family in FAMILIES {
        interrupt.check()?;
        rows.extend(measure(family));
    }
    Destination::Stdout.write(|out| accuracy_table(&rows, TableFormat::Table, out))?;
    accuracy_figure(&rows, &args.output)?;
    Ok(Outcome::Done)
}
