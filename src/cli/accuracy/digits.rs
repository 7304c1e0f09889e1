//! Digits of b_{n,k} against time.

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::{FigurePlace, PictureFormat, accuracy_figure, accuracy_table},
    monitor::Monitor,
    output::{Destination, TableFormat},
    study::{FAMILIES, measure as measured},
};

pub(super) fn measure(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    let progress = Progress::new(interrupt, FAMILIES.len() as u64, "families");
    for family in FAMILIES {
        rows.extend(measured(family));
        progress.advance(1)?;
    }
    Destination::Stdout.write(|out| accuracy_table(&rows, TableFormat::Table, out))?;
    accuracy_figure(
        &rows,
        &FigurePlace { folder: &args.output, name: "accuracy", format: PictureFormat::Svg },
    )
}
