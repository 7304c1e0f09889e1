//! `grazing accuracy`: what accuracy costs, on this machine.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use super::Outcome;
use crate::{
    cli::progress::Interrupt,
    error::Result,
    figure::{
        FigurePlace, PictureFormat, accuracy_figure, accuracy_table, effects_table, flow_accuracy,
        flow_table, long_runs_table, machine_effects_table,
    },
    output::{Destination, TableFormat, make_folder, write_file},
    study::{
        FAMILIES,
        effects::{effects, machine_effects},
        flow_accuracy::{long_runs, returning, tolerances},
        measure,
    },
};

/// Measure what accuracy costs in time, on this machine.
///
/// Of signs: the time, certain digits and decided signs of b_{n,k}, for each way to compute it and each
/// family of inputs, as accuracy.csv and accuracy.svg. Of simulations: the time and error of the closed form
/// and of the integrator at tolerances 1e-3 to 1e-13, as flow-accuracy.csv and .svg, and the distance from
/// exact motions after 1 to 10^6 periods, as long-runs.csv. Of effects: what each adds to the time per
/// period, with its evaluations counted, as effects.csv, and of machines as machine-effects.csv. The table is
/// also printed. Takes some seconds.
///
/// Exit code 0: done; 2: a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing accuracy --of effects -o figures")]
pub(super) struct Args {
    /// What to measure.
    #[arg(long, value_enum, default_value_t = Subject::Signs)]
    of: Subject,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Subject {
    /// b_{n,k} and its sign.
    Signs,
    /// Motions.
    Simulations,
    /// The effects of an oscillator.
    Effects,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    // Before the measurement rather than after it.
    make_folder(&args.output)?;
    match args.of {
        Subject::Signs => signs(args, interrupt),
        Subject::Simulations => simulations(args, interrupt),
        Subject::Effects => costs(args, interrupt),
    }?;
    Ok(Outcome::Done)
}

fn signs(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    for family in FAMILIES {
        interrupt.check()?;
        rows.extend(measure(family));
    }
    Destination::Stdout.write(|out| accuracy_table(&rows, TableFormat::Table, out))?;
    accuracy_figure(
        &rows,
        &FigurePlace { folder: &args.output, name: "accuracy", format: PictureFormat::Svg },
    )
}

fn simulations(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    for case in returning() {
        for tolerance in [None].into_iter().chain(tolerances().into_iter().map(Some)) {
            interrupt.check()?;
            rows.push(case.measure(tolerance)?);
        }
    }
    Destination::Stdout.write(|out| flow_table(&rows, TableFormat::Table, out))?;
    flow_accuracy(
        &rows,
        &FigurePlace { folder: &args.output, name: "flow-accuracy", format: PictureFormat::Svg },
    )?;
    let rows = long_runs(6)?;
    Destination::Stdout.write(|out| long_runs_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("long-runs.csv"), |out| long_runs_table(&rows, TableFormat::Csv, out))
}

fn costs(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    for effect in effects() {
        interrupt.check()?;
        rows.push(effect.measure()?);
    }
    Destination::Stdout.write(|out| effects_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("effects.csv"), |out| effects_table(&rows, TableFormat::Csv, out))?;
    let mut rows = Vec::new();
    for effect in machine_effects() {
        interrupt.check()?;
        rows.push(effect.measure()?);
    }
    Destination::Stdout.write(|out| machine_effects_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("machine-effects.csv"), |out| {
        machine_effects_table(&rows, TableFormat::Csv, out)
    })
}
