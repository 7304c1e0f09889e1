//! How a task ended.

use std::fmt;

use serde::Serialize;

use crate::{error::Error, motion::RunEnd, outcome::Outcome};

/// Where something stands in a file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Place {
    /// The file, as it was named.
    pub file: String,
    /// The line, counted from 1, where it is known.
    pub line: Option<usize>,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}", self.file),
            None => f.write_str(&self.file),
        }
    }
}

/// How a task ended, with the reason where there is one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(tag = "status", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Status {
    /// What was asked for was computed, found or proved.
    Done,
    /// The search went through all that it was to go through, and there was nothing.
    NothingFound {
        /// What was looked for, and where.
        reason: String,
    },
    /// A statement is certainly false.
    Refuted {
        /// Which, and why.
        reason: String,
    },
    /// Something is left open.
    Undecided {
        /// What, and why.
        reason: String,
    },
    /// The user ended it.
    Interrupted {
        /// What was under way.
        reason: String,
    },
    /// It was not begun, because the run was interrupted.
    Pending,
    /// It could not be done.
    Failed {
        /// Why.
        reason: String,
        /// The task in the scene.
        #[serde(skip)]
        at: Place,
        /// Whether a file or stream is at fault rather than the scene.
        io: bool,
    },
}

impl Status {
    /// How the task counts for what it is part of.
    pub fn outcome(&self) -> Outcome {
        match self {
            Status::Done => Outcome::Done,
            Status::NothingFound { .. } => Outcome::NothingFound,
            Status::Undecided { .. } => Outcome::Undecided,
            Status::Interrupted { .. } | Status::Pending => Outcome::Interrupted,
            Status::Failed { .. } => Outcome::Failed,
            Status::Refuted { .. } => Outcome::Refuted,
        }
    }

    /// How a motion ended after so many forcing periods, in this state and with this acceleration.
    pub(super) fn of_motion(end: RunEnd, periods: f64, [q, u, bend]: [&[f64]; 3]) -> Status {
        match end {
            RunEnd::Reached | RunEnd::Event => Status::Done,
            end => {
                let of = |all: &[f64]| match all {
                    [one] => format!("{one:?}"),
                    // A list of dozens is no place; the report has them all.
                    all if all.len() > 10 => format!("of largest entry {}", largest(all)),
                    all => format!("{all:?}"),
                };
                Status::undecided(format!(
                    "the motion ended after {periods:.6} of the periods asked for, {}: at q = {}, u = {} with the acceleration {}",
                    end.why(),
                    of(q),
                    of(u),
                    of(bend)
                ))
            }
        }
    }

    /// Nothing found, for this reason.
    pub(crate) fn nothing(reason: impl Into<String>) -> Status {
        Status::NothingFound { reason: reason.into() }
    }

    /// Left open, for this reason.
    pub(crate) fn undecided(reason: impl Into<String>) -> Status {
        Status::Undecided { reason: reason.into() }
    }

    /// Certainly false, for this reason.
    pub(crate) fn refuted(reason: impl Into<String>) -> Status {
        Status::Refuted { reason: reason.into() }
    }

    pub(super) fn of_error(error: &Error, at: Place) -> Status {
        let reason = error.to_string();
        match error.is_interrupted() {
            true => Status::Interrupted { reason },
            false => Status::Failed { reason, at, io: error.is_io() },
        }
    }

    /// Its word in a report.
    pub fn word(&self) -> &'static str {
        match self {
            Status::Done => "done",
            Status::NothingFound { .. } => "nothing found",
            Status::Refuted { .. } => "refuted",
            Status::Undecided { .. } => "undecided",
            Status::Interrupted { .. } => "interrupted",
            Status::Pending => "not reached",
            Status::Failed { .. } => "failed",
        }
    }

    /// Why, unless it is done or was not begun.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Status::Done | Status::Pending => None,
            Status::NothingFound { reason }
            | Status::Refuted { reason }
            | Status::Undecided { reason }
            | Status::Interrupted { reason }
            | Status::Failed { reason, .. } => Some(reason),
        }
    }

    /// Whether the user ended it, or the run before it.
    pub fn is_interrupted(&self) -> bool {
        matches!(self, Status::Interrupted { .. } | Status::Pending)
    }

    /// Whether it could not be done.
    pub fn is_failed(&self) -> bool {
        matches!(self, Status::Failed { .. })
    }

    /// Whether all is done.
    pub fn is_done(&self) -> bool {
        *self == Status::Done
    }
}

/// The word, then the reason, then the place of a failure unless the reason names the file.
impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())?;
        if let Some(reason) = self.reason() {
            write!(f, ": {reason}")?;
        }
        match self {
            Status::Failed { reason, at, .. } if !reason.contains(&at.file) => write!(f, " ({at})"),
            _ => Ok(()),
        }
    }
}

/// The entry of largest modulus.
fn largest(all: &[f64]) -> f64 {
    all.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(f64::NAN)
}
