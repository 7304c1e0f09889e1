//! The command line: arguments, what each command runs, exit codes. No mathematics lives here.

mod accuracy;
mod boundary;
mod check;
mod classify;
mod cover;
mod evaluate;
mod existence;
mod farey;
mod figure;
mod formula;
mod fuzz;
mod intervals;
pub(crate) mod progress;
mod range;
mod reader;
mod run;
mod verify;
mod word;

use std::process::ExitCode;

use clap::{Parser, Subcommand, error::ErrorKind};

use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
};

/// Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.
///
/// Numbers are exact everywhere: 3/8, 0.375, 1e-30, 2^-10, and sums and differences of these.
#[derive(Debug, Parser)]
#[command(name = "grazing", version, arg_required_else_help = true, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes: 0 done, or proved; 1 refuted, or a certificate that is malformed or false; \
2 wrong usage, or a file that cannot be read or written; 3 undecided.";

#[derive(Debug, Subcommand)]
enum Command {
    Verify(verify::Args),
    Check(check::Args),
    Cover(cover::Args),
    Intervals(intervals::Args),
    Classify(classify::Args),
    Word(word::Args),
    Existence(existence::Args),
    Fuzz(fuzz::Args),
    Farey(farey::Args),
    Boundary(boundary::Args),
    Figure(figure::Args),
    Formula(formula::Args),
    Evaluate(evaluate::Args),
    Accuracy(accuracy::Args),
    Run(run::Args),
}

/// How a command that did its work ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// Done, or everything asked was proved.
    Done,
    /// A statement was refuted, or a certificate rejected.
    Refuted,
    /// Something was left undecided.
    Undecided,
}

/// Parses the process's arguments, runs the command, and says how it ended.
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        // A bad value gets one line like every other error of ours; --help and misspelt options get clap's text.
        Err(error) if error.kind() == ErrorKind::ValueValidation => {
            let text = error.to_string();
            eprintln!("{}", text.lines().next().unwrap_or_default());
            return ExitCode::from(2);
        }
        Err(error) => error.exit(),
    };
    match run(cli) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Refuted) => ExitCode::from(1),
        Ok(Outcome::Undecided) => ExitCode::from(3),
        // The reader of our output has what it wanted.
        Err(error) if error.is_broken_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(if error.is_interrupted() { 3 } else { 2 })
        }
    }
}

fn run(cli: Cli) -> Result<Outcome> {
    let interrupt = Interrupt::listen()?;
    match cli.command {
        Command::Verify(args) => verify::run(&args, &interrupt),
        Command::Check(args) => check::run(&args, &interrupt),
        Command::Cover(args) => cover::run(&args, &interrupt),
        Command::Intervals(args) => intervals::run(&args, &interrupt),
        Command::Classify(args) => classify::run(&args),
        Command::Word(args) => word::run(&args, &interrupt),
        Command::Existence(args) => existence::run(&args, &interrupt),
        Command::Fuzz(args) => fuzz::run(&args, &interrupt),
        Command::Farey(args) => farey::run(&args, &interrupt),
        Command::Boundary(args) => boundary::run(&args, &interrupt),
        Command::Figure(args) => figure::run(&args, &interrupt),
        Command::Formula(args) => formula::run(&args),
        Command::Evaluate(args) => evaluate::run(&args, &interrupt),
        Command::Accuracy(args) => accuracy::run(&args, &interrupt),
        Command::Run(args) => run::run(&args, &interrupt),
    }
}

/// Runs `work` on `jobs` threads, 0 for one a core.
fn in_pool<T: Send>(jobs: usize, work: impl FnOnce() -> Result<T> + Send) -> Result<T> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    pool.map_err(|error| Error::input(format!("--jobs {jobs}: {error}")))?.install(work)
}

/// How a report that is not a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum ReportFormat {
    /// For reading.
    Text,
    /// One JSON object.
    Json,
}
