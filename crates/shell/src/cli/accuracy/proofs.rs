//! What proofs cost.

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::{FigurePlace, proof_figure, proof_table},
    output::{Destination, FileRegistry, TableFormat},
    study::{ProofSizes, proof_costs},
};

pub(super) fn measure(args: &Args, _: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    let sizes = if args.quick { ProofSizes::QUICK } else { ProofSizes::FULL };
    let progress = Progress::new(interrupt, sizes.steps(), "proofs");
    let costs = proof_costs(&sizes, &progress)?;
    drop(progress);
    Destination::Stdout.write(|out| proof_table(&costs, TableFormat::Table, out))?;
    proof_figure(&costs, &FigurePlace::svg(&args.output, "proofs"))
}
