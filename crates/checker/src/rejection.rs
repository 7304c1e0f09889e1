//! Why a certificate was not accepted.

use std::{error, fmt, io};

/// A certificate is rejected: where, and why.
#[derive(Debug)]
pub enum Rejection {
    /// The text is not of the documented form.
    Malformed {
        /// The line, counted from 1.
        line: u64,
        /// What was expected.
        reason: String,
    },
    /// The text is well formed and a claim in it is false or missing.
    False {
        /// The line, counted from 1.
        line: u64,
        /// The claim that fails.
        reason: String,
    },
    /// Every claim in the text is proved, but it leaves something undecided, so that its statement is not.
    Undecided {
        /// The line of the first gap, counted from 1.
        line: u64,
        /// What is left open.
        reason: String,
    },
    /// The stream failed before its end, which says nothing about the certificate.
    Unreadable {
        /// The line, counted from 1; 0 if the file could not be opened.
        line: u64,
        /// The system's reason.
        source: io::Error,
    },
    /// The caller wanted an end before the check was done, which says nothing about the certificate.
    Interrupted {
        /// The line that was being read or checked, counted from 1.
        line: u64,
    },
}

/// What is wrong with the line at hand, said where its number is not known.
#[derive(Debug)]
pub(crate) enum Fault {
    Malformed(String),
    False(String),
    Interrupted,
}

impl Fault {
    /// The same fault, its reason led by where it is.
    pub fn at(self, place: String) -> Fault {
        match self {
            Fault::Malformed(reason) => Fault::Malformed(format!("{place}: {reason}")),
            Fault::False(reason) => Fault::False(format!("{place}: {reason}")),
            Fault::Interrupted => Fault::Interrupted,
        }
    }

    /// The same, its line known.
    pub fn on(self, line: u64) -> Rejection {
        match self {
            Fault::Malformed(reason) => Rejection::Malformed { line, reason },
            Fault::False(reason) => Rejection::False { line, reason },
            Fault::Interrupted => Rejection::Interrupted { line },
        }
    }

    /// Its reason.
    pub fn reason(self) -> String {
        match self {
            Fault::Malformed(reason) | Fault::False(reason) => reason,
            Fault::Interrupted => "the check was ended before it was done".into(),
        }
    }
}

/// Asked now and then whether the work should go on.
pub(crate) type GoOn<'a> = &'a mut dyn FnMut() -> Result<(), Fault>;

/// Goes on unless it is `stopped`.
pub(crate) fn unless(stopped: bool) -> Result<(), Fault> {
    if stopped { Err(Fault::Interrupted) } else { Ok(()) }
}

/// The reason, unless what it denies `holds`.
pub(crate) fn ensure(holds: bool, reason: impl fmt::Display) -> Result<(), String> {
    if holds { Ok(()) } else { Err(reason.to_string()) }
}

/// A false claim for this reason, unless it `holds`.
pub(crate) fn claim(holds: bool, reason: impl fmt::Display) -> Result<(), Fault> {
    ensure(holds, reason).map_err(Fault::False)
}

impl Rejection {
    /// The verdict in a word: `rejected`, `undecided`, `unreadable` or `interrupted`.
    pub fn verdict(&self) -> &'static str {
        match self {
            Rejection::Malformed { .. } | Rejection::False { .. } => "rejected",
            Rejection::Undecided { .. } => "undecided",
            Rejection::Unreadable { .. } => "unreadable",
            Rejection::Interrupted { .. } => "interrupted",
        }
    }
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::Malformed { line, reason } => write!(f, "line {line}: malformed: {reason}"),
            Rejection::False { line, reason } => write!(f, "line {line}: false: {reason}"),
            Rejection::Undecided { line, reason } => write!(f, "line {line}: {reason}"),
            Rejection::Unreadable { line: 0, source } => write!(f, "cannot be opened: {source}"),
            Rejection::Unreadable { line, source } => write!(f, "line {line}: cannot be read: {source}"),
            Rejection::Interrupted { line } => {
                write!(f, "line {line}: the check was ended before it was done")
            }
        }
    }
}

impl error::Error for Rejection {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        match self {
            Rejection::Unreadable { source, .. } => Some(source),
            _ => None,
        }
    }
}
