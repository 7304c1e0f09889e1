//! What effects cost.

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::{effects_table, machine_effects_table},
    monitor::Monitor,
    output::{Destination, FileRegistry, TableFormat},
    study::effects::{PERIODS, effects, machine_effects},
};

pub(super) fn measure(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    let (periods, runs) = if args.quick { (50, 2) } else { (PERIODS, 20) };
    let all = effects().len() + machine_effects().len();
    let progress = Progress::new(interrupt, all as u64, "effects");
    let mut rows = Vec::new();
    for effect in effects() {
        rows.push(effect.measure(periods, runs)?);
        progress.advance(1)?;
    }
    Destination::Stdout.write(|out| effects_table(&rows, TableFormat::Table, out))?;
    files
        .named(&args.output.join("effects.csv"))?
        .write(|out| effects_table(&rows, TableFormat::Csv, out))?;
    let mut rows = Vec::new();
    for effect in machine_effects() {
        rows.push(effect.measure(periods, runs)?);
        progress.advance(1)?;
    }
    drop(progress);
    Destination::Stdout.write(|out| machine_effects_table(&rows, TableFormat::Table, out))?;
    files
        .named(&args.output.join("machine-effects.csv"))?
        .write(|out| machine_effects_table(&rows, TableFormat::Csv, out))
}
