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
    /// The stream failed before its end.
    Unreadable {
        /// The line, counted from 1.
        line: u64,
        /// The system's reason.
        source: io::Error,
    },
}

impl Rejection {
    /// Whether the certificate could not be read at all, which says nothing about it.
    pub fn is_unreadable(&self) -> bool {
        matches!(self, Rejection::Unreadable { .. })
    }
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::Malformed { line, reason } => write!(f, "line {line}: malformed: {reason}"),
            Rejection::False { line, reason } => write!(f, "line {line}: false: {reason}"),
            Rejection::Undecided { line, reason } => write!(f, "line {line}: undecided: {reason}"),
            Rejection::Unreadable { line, source } => write!(f, "line {line}: cannot be read: {source}"),
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
