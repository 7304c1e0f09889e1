//! The command line: arguments, what each command runs, exit codes. No mathematics lives here.
//!
//! A program is an enum of its commands with [`Commands`]: [`Theory`] is the one of `grazing-verify`, and
//! part of that of the program with every command.

mod arguments;
mod boundary;
mod check;
mod choice;
pub mod cite;
mod classify;
mod cover;
mod decay;
mod decides;
mod evaluate;
mod existence;
mod farey;
mod formula;
mod fuzz;
mod intervals;
mod merge;
pub mod place;
mod profile;
pub mod progress;
pub mod range;
mod reader;
mod returns;
mod samples;
mod sequence;
pub mod shards;
mod shares;
mod theory;
mod two_impacts;
mod verify;
mod word;

use std::{
    env, io,
    panic::{self, AssertUnwindSafe},
    path::{Path, PathBuf},
    process::ExitCode,
    sync::mpsc::{self, Sender},
    thread,
    time::{Duration, Instant},
};

use clap::{Command, CommandFactory, FromArgMatches, Parser, Subcommand};
use serde_json::json;

pub use theory::Theory;

pub use crate::outcome::Outcome;
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    output::{Destination, FileRegistry, remove_temporaries, say, stdout_is_untouched},
    pattern::{Map, Pattern},
    processor::{most_memory, process_seconds, threads},
};

/// Draws the predicted orbit of a pattern, for a sign of eµ, into a folder, with its data.
pub type OrbitPicture = fn(&Map, &Pattern, Option<bool>, &Path) -> Result<()>;

/// A command whose name may be left out, and before which words.
pub type Short = (&'static str, fn(&str) -> bool);

/// A question, and the commands that answer it, each with what it tells.
pub type Question = (&'static str, &'static [(&'static str, &'static str)]);

/// The commands of a program.
pub trait Commands: Subcommand {
    /// The program's name.
    const NAME: &'static str;
    /// Commands that it has not, but the program with every command.
    const ELSEWHERE: &'static [&'static str] = &[];
    /// The command whose name may be left out.
    const SHORT: Option<Short> = None;
    /// All commands by the questions that they answer, for the list of them; if empty the list is clap's.
    const QUESTIONS: &'static [Question] = &[];
    /// Draws a pattern's orbit, in a program with pictures.
    const ORBIT: Option<OrbitPicture> = None;

    /// Does what the command says.
    ///
    /// # Errors
    /// Those of the command.
    fn run(self, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome>;

    /// Whether its methods are timed.
    fn has_profile(&self) -> bool;

    /// The name of the report's format, if it is to be JSON.
    fn json(&self) -> Option<&'static str>;

    /// The program that shards of the task with these words are by.
    fn program(_words: &[String]) -> String {
        crate::program()
    }

    /// Puts together the shards of a task that is not the theory's; `None` of one that no command has.
    ///
    /// # Errors
    /// Those of the task's command.
    fn merge(_: &shards::ShardSet, _: &shards::Merged, _: &Interrupt) -> Result<Option<Outcome>> {
        Ok(None)
    }
}

/// The line that installs the program with every command.
pub const EVERYTHING: &str = "cargo install --path crates/shell --features print";

/// Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.
///
/// Numbers are exact everywhere: 3/8, 0.375, 1e-30, 2^-10, and sums and differences of these, with up to
/// 32768 bits in numerator and denominator (4096 in a scene).
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, after_help = EXIT_CODES)]
struct Cli<C: Subcommand> {
    #[command(subcommand)]
    command: C,
    /// Show no progress bars.
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Print at the end the time and memory that it took.
    #[arg(short, long, global = true, conflicts_with = "quiet")]
    verbose: bool,
    /// Write where the time went, as CSV.
    #[arg(long, global = true, value_name = "FILE")]
    profile: Option<PathBuf>,
}

/// The definition of a program's command line.
pub fn command<C: Commands>() -> Command {
    let command = Cli::<C>::command().name(C::NAME).bin_name(C::NAME);
    if C::QUESTIONS.is_empty() {
        return command;
    }
    let mut list = String::new();
    for (question, commands) in C::QUESTIONS {
        list += &format!("{question}\n");
        for (name, tells) in *commands {
            list += &format!("  {name:<12} {tells}\n");
        }
    }
    command.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{list}\nOptions:\n{{options}}{{after-help}}"
    ))
}

const EXIT_CODES: &str = "\
Exit codes: 1 if anything was refuted, or a certificate is malformed or false; else 2 if anything failed: wrong usage, \
a file that cannot be read or written; else 3 if anything was undecided, interrupted or not found; else 0. A second \
Ctrl-C ends at once with 130.";

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
pub fn main<C: Commands>() -> ExitCode {
    let (sender, events) = mpsc::channel();
    let heard = sender.clone();
    let interrupt = match Interrupt::listen(move || drop(heard.send(Event::Signal))) {
        Ok(interrupt) => interrupt,
        Err(error) => return fail(&error, None),
    };
    let listener = interrupt.clone();
    let work = move || {
        // A panic has said so; its code is none that means anything.
        let code = panic::catch_unwind(AssertUnwindSafe(|| started::<C>(&listener, &sender)));
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
fn started<C: Commands>(interrupt: &Interrupt, events: &Sender<Event>) -> u8 {
    let read = arguments::read(command::<C>(), C::SHORT, env::args_os());
    let cli = match read.and_then(|read| Cli::<C>::from_arg_matches(&read)) {
        Ok(cli) => cli,
        Err(error) => {
            let (wrong, printed) = arguments::tell(error, C::ELSEWHERE);
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
    let outcome = match cli.command.run(&files, interrupt) {
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
pub fn reported(outcome: Outcome, written: Result<()>) -> Result<Outcome> {
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
pub fn pretty(value: &serde_json::Value, out: &mut dyn io::Write) -> Result<()> {
    serde_json::to_writer_pretty(&mut *out, value).map_err(|error| Error::from(io::Error::from(error)))?;
    Ok(writeln!(out)?)
}

/// Runs `work` on `jobs` threads, 0 for one per core.
pub fn in_pool<T: Send>(jobs: usize, work: impl FnOnce() -> Result<T> + Send) -> Result<T> {
    let jobs = threads(jobs)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    pool.map_err(|error| Error::input(format!("--jobs {jobs}: {error}")))?.install(work)
}

/// How a report is written that print has as a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum PrintFormat {
    /// For reading.
    Text,
    /// One JSON object.
    Json,
    /// LaTeX, with booktabs rules.
    Latex,
}

impl PrintFormat {
    /// The same without print, which is text.
    pub fn report(self) -> ReportFormat {
        if self == PrintFormat::Json { ReportFormat::Json } else { ReportFormat::Text }
    }
}

/// How a report that is not a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum ReportFormat {
    /// For reading.
    Text,
    /// One JSON object.
    Json,
}
