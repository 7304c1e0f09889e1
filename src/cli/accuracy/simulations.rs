//! Errors of simulations against time.

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::{FigurePlace, PictureFormat, flow_accuracy, flow_table, long_runs_table},
    monitor::Monitor,
    output::{Destination, TableFormat, write_file},
    study::flow_accuracy::{long_runs, returning, tolerances},
};

pub(super) fn measure(args: &Args, interrupt: &Interrupt) -> Result<()> {
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
    flow_accuracy(
        &rows,
        &FigurePlace { folder: &args.output, name: "flow-accuracy", format: PictureFormat::Svg },
    )?;
    let rows = long_runs(if args.quick { 3 } else { 6 })?;
    Destination::Stdout.write(|out| long_runs_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("long-runs.csv"), |out| long_runs_table(&rows, TableFormat::Csv, out))
}
