//! The commands of scenes and pictures, and the program that has every command.

mod accuracy;
mod export;
mod figure;
mod run;
mod shell;
mod view;

use std::{path::Path, process::ExitCode};

use clap::{Parser, Subcommand};
use grazing_verify::{
    Commands, Theory,
    cli::{self, OrbitPicture, Question, Short},
};
// What every command has, under the names that it has there.
use grazing_verify::cli::{
    Outcome, PrintFormat, ReportFormat, cite, in_pool, place, progress, progress::Interrupt, range, reported,
    shards,
};

use crate::{
    error::Result,
    figure::{FigurePlace, orbit},
    output::FileRegistry,
};

#[derive(Debug, Subcommand)]
enum Command {
    Answer(run::AnswerArgs),
    Run(Box<run::Args>),
    #[command(flatten)]
    Theory(Box<Theory>),
    Figure(Box<figure::Args>),
    Export(export::Args),
    Accuracy(accuracy::Args),
    Completions(shell::CompletionsArgs),
    Man(shell::ManArgs),
}

/// Parses the process's arguments, runs the command, and says how it ended.
pub fn main() -> ExitCode {
    cli::main::<Command>()
}

impl Commands for Command {
    const NAME: &'static str = "grazing";
    const ORBIT: Option<OrbitPicture> = Some(|map, pattern, side, folder: &Path| {
        orbit(map, pattern, side, &FigurePlace::svg(folder, "orbit"))
    });

    const SHORT: Option<Short> = Some(("answer", run::is_answered));
    const QUESTIONS: &'static [Question] = &[
        (
            "What does my machine do?",
            &[
                ("answer", "as its drive is turned up: where it touches, what it does then, and why"),
                ("run", "the tasks of a scene: motions, orbits, branches, attractors, and proofs of them"),
                ("decay", "its frequency and damping, with their deviations, from a free decay"),
            ],
        ),
        (
            "What is born at a touch?",
            &[
                ("classify", "orbits with one impact, period by period, at a point or in a box"),
                ("word", "every pattern of impacts, and whether chaos is born"),
                ("existence", "the patterns of a local map of any dimension"),
                ("boundary", "how much damping an orbit survives"),
                ("intervals", "where orbits exist without damping"),
                ("evaluate", "b_{n,k} and c_n, in certain digits"),
            ],
        ),
        (
            "Is it true?",
            &[
                ("check", "certificates, proved again without search"),
                ("verify", "Theorem 2, for every period in a range"),
                ("cover", "Conjecture 1, for every period in a range, by computation"),
                ("fuzz", "Conjecture 1, at random points"),
                ("formula", "polynomials, and sentences for other tools"),
            ],
        ),
        (
            "Pictures, numbers, files",
            &[
                ("figure", "a figure as SVG, with its data as CSV"),
                ("export", "a table of `run` for MATLAB, NumPy or AUTO"),
                ("merge", "the shards of one task, put together"),
                ("farey", "Farey fractions: neighbours, ranks, walks"),
                ("sequence", "a sequence of whole numbers, as a b-file"),
                ("accuracy", "what accuracy costs in time, on this computer"),
                ("completions", "those of a shell"),
                ("man", "the manual, a page per command"),
                ("help", "this, or the help of a command"),
            ],
        ),
    ];

    fn run(self, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
        match self {
            Command::Theory(command) => command.run_in::<Command>(files, interrupt),
            Command::Figure(args) => figure::run(&args, files, interrupt),
            Command::Accuracy(args) => accuracy::run(&args, files, interrupt),
            Command::Run(args) => run::run(&args, files, interrupt),
            Command::Answer(args) => run::answer(&args, files, interrupt),
            Command::Export(args) => export::run(&args, files),
            Command::Completions(args) => shell::completions(&args, files, cli::command::<Command>()),
            Command::Man(args) => shell::man(&args, files, cli::command::<Command>()),
        }
    }

    fn has_profile(&self) -> bool {
        match self {
            Command::Theory(command) => command.has_profile(),
            command => matches!(command, Command::Run(_) | Command::Answer(_)),
        }
    }

    fn json(&self) -> Option<&'static str> {
        match self {
            Command::Theory(command) => command.json(),
            Command::Run(args) if args.format.report() == ReportFormat::Json => Some("grazing-run 4"),
            Command::Answer(args) if args.format == ReportFormat::Json => Some("grazing-run 4"),
            _ => None,
        }
    }

    fn program(words: &[String]) -> String {
        if words.first().is_some_and(|word| word == "run") {
            crate::program()
        } else {
            Theory::program(words)
        }
    }

    fn merge(
        set: &shards::ShardSet,
        merged: &shards::Merged,
        interrupt: &Interrupt,
    ) -> Result<Option<Outcome>> {
        if set.words().first().is_none_or(|word| word != "run") {
            return Ok(None);
        }
        let args = run::Args::try_parse_from(set.words()).map_err(|error| set.is_no_task(&error))?;
        run::merge(&args, set, merged, interrupt).map(Some)
    }
}
