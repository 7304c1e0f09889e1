//! The commands of the theory.

use clap::Subcommand;

use super::{
    Commands, Outcome, ReportFormat, boundary, check, classify, cover, decay, evaluate, existence, farey,
    formula, fuzz, intervals, merge, sequence, verify, word,
};
use crate::{
    cli::progress::Interrupt,
    error::Result,
    output::{FileRegistry, TableFormat},
};

/// A command of the theory.
#[derive(Debug, Subcommand)]
pub enum Theory {
    Verify(verify::Args),
    Check(check::Args),
    Merge(merge::Args),
    Cover(cover::Args),
    Intervals(intervals::Args),
    Classify(classify::Args),
    Word(word::Args),
    Decay(decay::Args),
    Existence(existence::Args),
    Fuzz(fuzz::Args),
    Farey(farey::Args),
    Boundary(boundary::Args),
    Sequence(sequence::Args),
    Formula(formula::Args),
    Evaluate(evaluate::Args),
}

impl Commands for Theory {
    const NAME: &'static str = "grazing-verify";
    const ELSEWHERE: &'static [&'static str] = &["figure", "accuracy", "run", "export", "completions", "man"];

    fn run(self, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
        self.run_in::<Theory>(files, interrupt)
    }

    fn has_profile(&self) -> bool {
        use Theory::{Boundary, Classify, Cover, Fuzz, Verify};
        matches!(self, Verify(_) | Cover(_) | Classify(_) | Fuzz(_) | Boundary(_))
    }

    fn json(&self) -> Option<&'static str> {
        let report = |format: ReportFormat, name| (format == ReportFormat::Json).then_some(name);
        let table = |format: TableFormat, name| (format == TableFormat::Json).then_some(name);
        match self {
            Theory::Verify(args) => report(args.format, "grazing-verify 1"),
            Theory::Check(args) => report(args.format, "grazing-check 2"),
            // Of a certificate, `check`'s; what the shards are of is not known yet.
            Theory::Merge(args) => report(args.format, "grazing-check 2"),
            Theory::Cover(args) => report(args.format, "grazing-cover 1"),
            Theory::Intervals(args) => {
                let name = if args.is_measure() { "grazing-measure 1" } else { "grazing-intervals 1" };
                (args.format == intervals::Format::Json).then_some(name)
            }
            Theory::Classify(args) => table(args.format, args.json_name()),
            Theory::Word(args) => (args.format == word::Format::Json).then_some(args.json_name()),
            Theory::Decay(args) => report(args.format, "grazing-decay 1"),
            Theory::Existence(args) => table(args.format, "grazing-existence 1"),
            Theory::Fuzz(args) => report(args.format, "grazing-fuzz 3"),
            Theory::Farey(args) => report(args.format, "grazing-farey 1"),
            Theory::Boundary(args) => table(args.format, "grazing-boundary 1"),
            Theory::Evaluate(args) => report(args.format.report(), "grazing-evaluate 2"),
            Theory::Sequence(_) | Theory::Formula(_) => None,
        }
    }
}

impl Theory {
    /// The same as a command of a larger program.
    ///
    /// # Errors
    /// Those of the command.
    pub fn run_in<C: Commands>(self, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
        match self {
            Theory::Verify(args) => verify::run(&args, files, interrupt),
            Theory::Check(args) => check::run(&args, files, interrupt),
            Theory::Merge(args) => merge::merge::<C>(&args, files, interrupt),
            Theory::Cover(args) => cover::run(&args, files, interrupt),
            Theory::Intervals(args) => intervals::run(&args, files, interrupt),
            Theory::Classify(args) => classify::run(&args, files, interrupt),
            Theory::Word(args) => word::run(&args, files, interrupt),
            Theory::Decay(args) => decay::run(&args, files),
            Theory::Existence(args) => existence::run(&args, C::ORBIT, files, interrupt),
            Theory::Fuzz(args) => fuzz::run(&args, files, interrupt),
            Theory::Farey(args) => farey::run(&args, files, interrupt),
            Theory::Boundary(args) => boundary::run(&args, files, interrupt),
            Theory::Sequence(args) => sequence::run(&args, files, interrupt),
            Theory::Formula(args) => formula::run(&args, files),
            Theory::Evaluate(args) => evaluate::run(&args, files, interrupt),
        }
    }
}
