//! How the arguments are read: what looks like a negative number is a value, of every option and wherever a
//! value may stand, and it is for the value's own parser to refuse it. And what clap's errors are told as.

use std::ffi::OsString;

use clap::{ArgMatches, Command, error::ContextKind, error::ContextValue, error::ErrorKind};

use super::{EVERYTHING, Short};
use crate::output::say;

/// Reads the process's arguments.
///
/// # Errors
/// Clap's: what cannot be read, and `--help`, `--version`.
pub(super) fn read(
    cli: Command,
    short: Option<Short>,
    arguments: impl Iterator<Item = OsString>,
) -> Result<ArgMatches, clap::Error> {
    let mut arguments: Vec<OsString> = arguments.collect();
    // The first is the program's name.
    let first = arguments.iter().skip(1).position(|argument| !argument.to_string_lossy().starts_with('-'));
    if let (Some((command, is_meant)), Some(first)) = (short, first)
        && is_meant(&arguments[first + 1].to_string_lossy())
    {
        arguments.insert(first + 1, command.into());
    }
    let cli = with_negatives(cli);
    let mut options = Vec::new();
    long_options(&cli, &mut options);
    let mut read: Vec<OsString> = Vec::new();
    for argument in arguments {
        let before = read.last_mut().filter(|_| is_negative(&argument));
        match before.filter(|before| options.iter().any(|option| before.as_os_str() == option.as_str())) {
            // So that -1/4 and -3..=5, which are no numbers to clap, reach the option, too.
            Some(option) => {
                option.push("=");
                option.push(argument);
            }
            None => read.push(argument),
        }
    }
    let negative = read.iter().filter(|argument| is_negative(argument)).cloned().collect::<Vec<_>>();
    cli.try_get_matches_from(read).map_err(|mut error| {
        // Of -.5 clap names the sign and the point alone, as if these were an option.
        if let Some(ContextValue::String(part)) = error.get(ContextKind::InvalidArg)
            && let Some(whole) = negative
                .iter()
                .map(|text| text.to_string_lossy())
                .find(|text| text.starts_with(part.as_str()))
        {
            error.insert(ContextKind::InvalidArg, ContextValue::String(whole.into_owned()));
        }
        error
    })
}

/// Whether it is a sign and a digit, and what follows these.
fn is_negative(argument: &OsString) -> bool {
    let text = argument.to_string_lossy();
    text.strip_prefix('-')
        .is_some_and(|rest| rest.trim_start_matches('.').starts_with(|c: char| c.is_ascii_digit()))
}

/// The same command, whose values may be negative numbers.
fn with_negatives(command: Command) -> Command {
    command
        .mut_args(|arg| if arg.get_action().takes_values() { arg.allow_negative_numbers(true) } else { arg })
        .mut_subcommands(with_negatives)
}

/// The options of all commands that take a value, as they are written.
fn long_options(command: &Command, found: &mut Vec<String>) {
    for arg in command.get_arguments().filter(|arg| arg.get_action().takes_values()) {
        let names = arg.get_long_and_visible_aliases().into_iter().flatten();
        found
            .extend(names.chain(arg.get_all_aliases().into_iter().flatten()).map(|name| format!("--{name}")));
    }
    command.get_subcommands().for_each(|command| long_options(command, found));
}

/// Says what is wrong with the arguments, or prints what was asked for; whether that was an error, and
/// whether it could be printed. Commands that are `elsewhere` have another program.
pub(super) fn tell(mut error: clap::Error, elsewhere: &[&str]) -> (bool, std::io::Result<()>) {
    if let Some(ContextValue::String(command)) = error.get(ContextKind::InvalidSubcommand)
        && elsewhere.contains(&command.as_str())
    {
        say(format_args!("error: `{command}` is a command of the program `grazing`: {EVERYTHING}"));
        return (true, Ok(()));
    }
    let invalid = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(argument)) => Some(argument.clone()),
        _ => None,
    };
    match (error.kind(), invalid) {
        // A bad value gets one line like every other error of ours; --help and misspelt options get clap's
        // text.
        (ErrorKind::ValueValidation, _) => {
            let text = error.to_string();
            say(text.lines().next().unwrap_or_default());
            (true, Ok(()))
        }
        (ErrorKind::UnknownArgument, Some(argument)) if is_negative(&OsString::from(&argument)) => {
            say(format_args!(
                "error: invalid value '{argument}': whole numbers here begin at 0 or 1, and ranges are A..=B"
            ));
            (true, Ok(()))
        }
        (kind, invalid) => {
            // That `-- -x` would pass it as a value helps with names of files alone.
            if kind == ErrorKind::UnknownArgument && invalid.is_some_and(|argument| argument.starts_with('-'))
            {
                error.remove(ContextKind::Suggested);
            }
            (error.use_stderr(), error.print())
        }
    }
}
