//! The command line: arguments, what each command runs, exit codes. No mathematics lives here.

mod accuracy;
mod arguments;
mod boundary;
mod check;
mod choice;
mod cite;
mod classify;
mod cover;
mod decay;
mod decides;
mod evaluate;
mod existence;
mod export;
mod farey;
mod figure;
mod formula;
mod fuzz;
mod intervals;
mod merge;
mod place;
mod profile;
pub(crate) mod progress;
mod range;
mod reader;
mod returns;
mod run;
mod samples;
mod sequence;
mod shards;
mod shares;
mod shell;
mod two_impacts;
mod verify;
mod view;
mod word;

use std::{
    env, io,
    panic::{self, AssertUnwindSafe},
    path::PathBuf,
    process::ExitCode,
    sync::mpsc::{self, Sender},
    thread,
    time::{Duration, Instant},
};

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use serde_json::json;

use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    outcome::Outcome,
    output::{Destination, FileRegistry, TableFormat, remove_temporaries, say, stdout_is_untouched},
    processor::{most_memory, process_seconds, threads},
};

/// Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.
///
/// Numbers are exact everywhere: 3/8, 0.375, 1e-30, 2^-10, and sums and differences of these, with up to
/// 32768 bits in numerator and denominator (4096 in a scene).
#[derive(Debug, Parser)]
#[command(name = "grazing", version, arg_required_else_help = true, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Show no progress bars.
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Print at the end how long it took and what it used: seconds, processor seconds, peak memory.
    #[arg(short, long, global = true, conflicts_with = "quiet")]
    verbose: bool,
    /// Write a table of how much each method decided, and how long it took, on all threads together.
    #[arg(long, global = true, value_name = "FILE")]
    profile: Option<PathBuf>,
}

const EXIT_CODES: &str = "\
Exit codes: 1 if anything was refuted, or a certificate is malformed or false; else 2 if anything failed: wrong usage, \
a file that cannot be read or written; else 3 if anything was undecided, interrupted or not found; else 0. A second \
Ctrl-C ends at once with 130.";

#[derive(Debug, Subcommand)]
enum Command {
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
    Figure(Box<figure::Args>),
    Formula(formula::Args),
    Evaluate(evaluate::Args),
    Accuracy(accuracy::Args),
    Run(run::Args),
    Export(export::Args),
    Completions(shell::CompletionsArgs),
    Man(shell::ManArgs),
}

/// What the main thread waits for.
enum Event {
    /// The arguments were understood; the name of the report's format, if it is to be JSON.
    Begun(Option<&'static str>),
    /// The command ended by itself.
    Ended(u8),
    /// The user asked for an end.
    Signal,
}

/// How long a command has to end by itself. Saved states are whole at every moment, so nothing is lost by an
/// end without it.
const GRACE: Duration = Duration::from_millis(700);

/// Parses the process's arguments, runs the command, and says how it ended.
///
/// The command runs on a thread of its own. Once the user asks for an end it has a moment to finish its files
/// and its report; then the process ends without it.
pub fn main() -> ExitCode {
    let (sender, events) = mpsc::channel();
    let heard = sender.clone();
    let interrupt = match Interrupt::listen(move || drop(heard.send(Event::Signal))) {
        Ok(interrupt) => interrupt,
        Err(error) => return fail(&error, None),
    };
    let listener = interrupt.clone();
    let work = move || {
        // A panic has said so; its code is none that means anything.
        let code = panic::catch_unwind(AssertUnwindSafe(|| command(&listener, &sender)));
        let _ = sender.send(Event::Ended(code.unwrap_or(PANICKED)));
    };
    if let Err(error) = thread::Builder::new().stack_size(STACK).spawn(work) {
        return fail(&Error::from(error).context("cannot start a thread"), None);
    }
    let mut json = None;
    loop {
        match events.recv() {
            Ok(Event::Begun(format)) => json = format,
            Ok(Event::Ended(code)) => return ExitCode::from(code),
            Ok(Event::Signal) => break,
            Err(_) => return ExitCode::from(PANICKED),
        }
    }
    let deadline = Instant::now() + GRACE;
    loop {
        match events.recv_timeout(deadline.saturating_duration_since(Instant::now())) {
            Ok(Event::Begun(format)) => json = format,
            Ok(Event::Ended(code)) => return ExitCode::from(code),
            Ok(Event::Signal) => {}
            Err(_) => break,
        }
    }
    remove_temporaries();
    let error = interrupt.error();
    match interrupt.last_words().filter(|_| json.is_some() && stdout_is_untouched()) {
        Some((text, outcome)) => {
            say(format_args!("error: {error}"));
            let _ = Destination::Stdout.write(|out| Ok(out.write_all(text.as_bytes())?));
            outcome.into()
        }
        None => fail(&error, json),
    }
}

/// As Rust's own for a panic on the main thread.
const PANICKED: u8 = 101;

/// As a main thread has on most systems.
const STACK: usize = 8 << 20;

/// Parses and runs; the exit code.
fn command(interrupt: &Interrupt, events: &Sender<Event>) -> u8 {
    let read = arguments::read(Cli::command(), env::args_os());
    let cli = match read.and_then(|read| Cli::from_arg_matches(&read)) {
        Ok(cli) => cli,
        Err(error) => {
            let (wrong, printed) = arguments::tell(error);
            let lost = printed.is_err_and(|lost| lost.kind() != io::ErrorKind::BrokenPipe);
            return if lost || wrong { Outcome::Failed.code() } else { Outcome::Done.code() };
        }
    };
    let json = cli.command.json();
    let _ = events.send(Event::Begun(json));
    if cli.quiet {
        interrupt.without_bars();
    }
    if cli.profile.is_some() && !cli.command.has_profile() {
        say("error: --profile is for verify, cover, classify, fuzz, boundary and run: leave it out");
        return Outcome::Failed.code();
    }
    // Before anything asks rayon for threads, which would take the environment at its word.
    if let Err(error) = threads(0) {
        return report(&error, json).code();
    }
    let files = FileRegistry::new();
    let kept = match cli.profile.as_deref().map(|file| files.write("--profile", file)).transpose() {
        Ok(file) => file.map(|file| (file, interrupt.keep_profile())),
        Err(error) => return report(&error, json).code(),
    };
    let (verbose, start) = (cli.verbose, Instant::now());
    let outcome = match run(cli, &files, interrupt) {
        Ok(outcome) => outcome,
        Err(error) => report(&error, json),
    };
    let kept = kept.filter(|_| !files.refused());
    let written = kept.map_or(Ok(()), |(file, kept)| profile::write_profile(&file, &kept));
    let code = match reported(outcome, written) {
        Ok(outcome) => outcome.code(),
        Err(error) => report(&error, None).code(),
    };
    if verbose {
        say(cost(start.elapsed()));
    }
    code
}

/// What a command has cost, in a line.
fn cost(elapsed: Duration) -> String {
    let memory =
        most_memory().map_or(String::new(), |kb| format!(", at most {} MB of memory", kb.div_ceil(1024)));
    format!("{:.2} s, {:.2} s of processor time{memory}", elapsed.as_secs_f64(), process_seconds())
}

fn fail(error: &Error, json: Option<&'static str>) -> ExitCode {
    report(error, json).into()
}

/// Says why a command failed. An interruption is said in JSON too, if that was asked for and none of it is
/// written yet.
fn report(error: &Error, json: Option<&'static str>) -> Outcome {
    say(format_args!("error: {error}"));
    if let Some(format) = json.filter(|_| error.is_interrupted() && stdout_is_untouched()) {
        let report = json!({ "format": format, "verdict": Outcome::Interrupted.word() });
        let _ = Destination::Stdout.write(|out| Ok(writeln!(out, "{report}")?));
    }
    Outcome::from(error)
}

/// A command's outcome once its report is written, or not: what could not be written is a failure, which a
/// refutation outranks.
fn reported(outcome: Outcome, written: Result<()>) -> Result<Outcome> {
    match written {
        Ok(()) => Ok(outcome),
        Err(error) if outcome == Outcome::Refuted => {
            say(format_args!("error: {error}"));
            Ok(outcome)
        }
        Err(error) => Err(error),
    }
}

/// One JSON value, over several lines.
fn pretty(value: &serde_json::Value, out: &mut dyn io::Write) -> Result<()> {
    serde_json::to_writer_pretty(&mut *out, value).map_err(|error| Error::from(io::Error::from(error)))?;
    Ok(writeln!(out)?)
}

fn run(cli: Cli, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    match cli.command {
        Command::Verify(args) => verify::run(&args, files, interrupt),
        Command::Check(args) => check::run(&args, files, interrupt),
        Command::Merge(args) => merge::merge(&args, files, interrupt),
        Command::Cover(args) => cover::run(&args, files, interrupt),
        Command::Intervals(args) => intervals::run(&args, files, interrupt),
        Command::Classify(args) => classify::run(&args, files, interrupt),
        Command::Word(args) => word::run(&args, files, interrupt),
        Command::Decay(args) => decay::run(&args, files),
        Command::Existence(args) => existence::run(&args, files, interrupt),
        Command::Fuzz(args) => fuzz::run(&args, files, interrupt),
        Command::Farey(args) => farey::run(&args, files, interrupt),
        Command::Boundary(args) => boundary::run(&args, files, interrupt),
        Command::Sequence(args) => sequence::run(&args, files, interrupt),
        Command::Figure(args) => figure::run(&args, files, interrupt),
        Command::Formula(args) => formula::run(&args, files),
        Command::Evaluate(args) => evaluate::run(&args, files, interrupt),
        Command::Accuracy(args) => accuracy::run(&args, files, interrupt),
        Command::Run(args) => run::run(&args, files, interrupt),
        Command::Export(args) => export::run(&args, files),
        Command::Completions(args) => shell::completions(&args, files, Cli::command()),
        Command::Man(args) => shell::man(&args, files, Cli::command()),
    }
}

impl Command {
    /// Whether its methods are timed.
    fn has_profile(&self) -> bool {
        use Command::{Boundary, Classify, Cover, Fuzz, Run, Verify};
        matches!(self, Verify(_) | Cover(_) | Classify(_) | Fuzz(_) | Boundary(_) | Run(_))
    }

    /// The name of the report's format, if it is to be JSON.
    fn json(&self) -> Option<&'static str> {
        let report = |format: ReportFormat, name| (format == ReportFormat::Json).then_some(name);
        let table = |format: TableFormat, name| (format == TableFormat::Json).then_some(name);
        match self {
            Command::Verify(args) => report(args.format, "grazing-verify 1"),
            Command::Check(args) => report(args.format, "grazing-check 2"),
            // Of a certificate, `check`'s; what the shards are of is not known yet.
            Command::Merge(args) => report(args.format, "grazing-check 2"),
            Command::Cover(args) => report(args.format, "grazing-cover 1"),
            Command::Intervals(args) => {
                let name = if args.is_measure() { "grazing-measure 1" } else { "grazing-intervals 1" };
                (args.format == intervals::Format::Json).then_some(name)
            }
            Command::Classify(args) => table(args.format, args.json_name()),
            Command::Word(args) => (args.format == word::Format::Json).then_some(args.json_name()),
            Command::Decay(args) => report(args.format, "grazing-decay 1"),
            Command::Existence(args) => table(args.format, "grazing-existence 1"),
            Command::Fuzz(args) => report(args.format, "grazing-fuzz 2"),
            Command::Farey(args) => report(args.format, "grazing-farey 1"),
            Command::Boundary(args) => table(args.format, "grazing-boundary 1"),
            Command::Evaluate(args) => report(args.format.report(), "grazing-evaluate 1"),
            Command::Run(args) => report(args.format.report(), "grazing-run 4"),
            Command::Sequence(_)
            | Command::Figure(_)
            | Command::Formula(_)
            | Command::Accuracy(_)
            | Command::Export(_)
            | Command::Completions(_)
            | Command::Man(_) => None,
        }
    }
}

/// Runs `work` on `jobs` threads, 0 for one per core.
fn in_pool<T: Send>(jobs: usize, work: impl FnOnce() -> Result<T> + Send) -> Result<T> {
    let jobs = threads(jobs)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    pool.map_err(|error| Error::input(format!("--jobs {jobs}: {error}")))?.install(work)
}

/// How a report is written that print has as a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum PrintFormat {
    /// For reading.
    Text,
    /// One JSON object.
    Json,
    /// LaTeX, with booktabs rules.
    Latex,
}

impl PrintFormat {
    /// The same without print, which is text.
    fn report(self) -> ReportFormat {
        if self == PrintFormat::Json { ReportFormat::Json } else { ReportFormat::Text }
    }
}

/// How a report that is not a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum ReportFormat {
    /// For reading.
    Text,
    /// One JSON object.
    Json,
}
