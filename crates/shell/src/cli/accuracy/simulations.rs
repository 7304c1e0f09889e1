//! Errors of simulations against time.

use std::time::Duration;

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::{FigurePlace, flow_accuracy, flow_table, long_runs_table, simulations_table},
    monitor::Monitor,
    output::{Destination, FileRegistry, TableFormat},
    study::{
        flow_accuracy::{long_runs, returning, tolerances},
        simulations::motions,
    },
};

pub(super) fn measure(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    against_another_program(args, files, interrupt)?;
    against_exact_motions(args, files, interrupt)
}

/// The six motions whose ends another program knows.
fn against_another_program(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    let (repeats, batch) =
        if args.quick { (2, Duration::from_micros(200)) } else { (8, Duration::from_millis(5)) };
    let every = if args.quick { 5 } else { 1 };
    let ways: Vec<_> = [None].into_iter().chain(tolerances().into_iter().step_by(every).map(Some)).collect();
    let motions = motions()?;
    let progress = Progress::new(interrupt, (motions.len() * ways.len()) as u64, "measurements");
    let mut prices = Vec::new();
    for motion in motions {
        for &tolerance in &ways {
            if if tolerance.is_some() { motion.is_oscillator() } else { motion.is_linear() } {
                prices.push(motion.measure(tolerance, repeats, batch)?);
            }
            progress.advance(1)?;
        }
    }
    drop(progress);
    Destination::Stdout.write(|out| simulations_table(&prices, TableFormat::Table, out))?;
    files
        .named(&args.output.join("simulations.csv"))?
        .write(|out| simulations_table(&prices, TableFormat::Csv, out))
}

/// Motions that return to their start.
fn against_exact_motions(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    let tolerances: Vec<_> = [None].into_iter().chain(tolerances().into_iter().map(Some)).collect();
    let progress = Progress::new(interrupt, (returning().len() * tolerances.len()) as u64, "measurements");
    for case in returning() {
        for &tolerance in &tolerances {
            rows.push(case.measure(tolerance)?);
            progress.advance(1)?;
        }
    }
    drop(progress);
    Destination::Stdout.write(|out| flow_table(&rows, TableFormat::Table, out))?;
    flow_accuracy(&rows, &FigurePlace::svg(&args.output, "flow-accuracy"))?;
    let rows = long_runs(if args.quick { 3 } else { 6 })?;
    Destination::Stdout.write(|out| long_runs_table(&rows, TableFormat::Table, out))?;
    files
        .named(&args.output.join("long-runs.csv"))?
        .write(|out| long_runs_table(&rows, TableFormat::Csv, out))
}
