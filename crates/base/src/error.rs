//! The crate's one error type.
//!
//! A library function fails for one of a few reasons, told apart by predicates (`is_input`, `is_io`, …),
//! and its message is one line that names the thing at fault, its value and, where there is one, the fix.
//! The certificate checker has an error type of its own, so that it depends on nothing here.

use std::{error, fmt, io, path::Path};

use crate::{number::ParseError, printable::Printable};

/// What went wrong, on one line, with the cause where the system gave one.
#[derive(Debug)]
pub struct Error(Box<Inner>);

/// A result with the crate's error.
pub type Result<T> = std::result::Result<T, Error>;

#[derive(Debug)]
struct Inner {
    kind: Kind,
    message: String,
    source: Option<io::Error>,
    spot: Option<Box<Spot>>,
}

/// What of a file is at fault. The message of the error says all of it in words.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Spot {
    /// The file, as it was named.
    pub file: String,
    /// The line, counted from 1, where it is known.
    pub line: Option<usize>,
    /// The key, where one is at fault.
    pub key: Option<String>,
    /// Its value as it stands in the file, cut short if it is long.
    pub value: Option<String>,
    /// What is wrong, and the fix: the end of the message.
    pub problem: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Input,
    Overflow,
    Io,
    Interrupted,
    Limit,
}

impl Error {
    /// The caller's value is outside what the function is defined for.
    pub fn input(message: impl Into<String>) -> Self {
        Self::new(Kind::Input, message.into(), None)
    }

    /// A result does not fit the integer type that was asked for; a wider one (or `BigInt`) would do.
    pub fn overflow(message: impl Into<String>) -> Self {
        Self::new(Kind::Overflow, message.into(), None)
    }

    /// The system refused `action` (as in "write", "open") on `path`.
    pub fn io(action: &str, path: &Path, source: io::Error) -> Self {
        let problem = format!("cannot {action} {}: {source}", path.display());
        let spot = Spot { file: path.display().to_string(), problem: problem.clone(), ..Spot::default() };
        Self::new(Kind::Io, problem, Some(source)).at(spot)
    }

    /// The user asked for an end (Ctrl-C) before the work was done.
    pub fn interrupted(done: impl Into<String>) -> Self {
        Self::new(Kind::Interrupted, done.into(), None)
    }

    /// More work than is done, and so given up.
    pub fn limit(message: impl Into<String>) -> Self {
        Self::new(Kind::Limit, message.into(), None)
    }

    fn new(kind: Kind, message: String, source: Option<io::Error>) -> Self {
        Error(Box::new(Inner { kind, message, source, spot: None }))
    }

    /// The same error, with what of a file is at fault.
    pub(crate) fn at(mut self, mut spot: Spot) -> Self {
        // As in the message; the file's name is one to open.
        for text in [spot.key.as_mut(), spot.value.as_mut(), Some(&mut spot.problem)].into_iter().flatten() {
            *text = Printable(text).to_string();
        }
        self.0.spot = Some(Box::new(spot));
        self
    }

    /// What of a file is at fault, for errors of files and of what stands in them.
    pub fn spot(&self) -> Option<&Spot> {
        self.0.spot.as_deref()
    }

    /// The same error, its message led by where it happened: `"context: message"`.
    #[must_use]
    pub fn context(mut self, context: impl fmt::Display) -> Self {
        self.0.message = format!("{context}: {}", self.0.message);
        self
    }

    /// Whether a value given by the caller is at fault.
    pub fn is_input(&self) -> bool {
        self.0.kind == Kind::Input
    }

    /// Whether a result did not fit its integer type.
    pub fn is_overflow(&self) -> bool {
        self.0.kind == Kind::Overflow
    }

    /// Whether a file or stream could not be read or written.
    pub fn is_io(&self) -> bool {
        self.0.kind == Kind::Io
    }

    /// Whether the user ended the work early.
    pub fn is_interrupted(&self) -> bool {
        self.0.kind == Kind::Interrupted
    }

    /// Whether it was given up because it takes more work than is done.
    pub fn is_limit(&self) -> bool {
        self.0.kind == Kind::Limit
    }

    /// Whether the reader of our output went away, which for a command is no failure.
    pub(crate) fn is_broken_pipe(&self) -> bool {
        self.0.source.as_ref().is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe)
    }
}

/// A text that is no number.
impl From<ParseError> for Error {
    fn from(source: ParseError) -> Self {
        Self::input(source.to_string())
    }
}

/// A stream that failed; say which with [`Error::context`].
impl From<io::Error> for Error {
    fn from(source: io::Error) -> Self {
        Self::new(Kind::Io, source.to_string(), Some(source))
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Printable(&self.0.message).fmt(f)
    }
}

impl error::Error for Error {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        self.0.source.as_ref().map(|e| e as _)
    }
}
