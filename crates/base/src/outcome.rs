//! How work ends, and the one order in which ends are combined.

use std::process::ExitCode;

use serde::Serialize;

use crate::error::Error;

/// How a piece of work ended, from best to worst. Work made of several parts (the tasks of a scene, the files
/// of `check`) ends as the worst of them does.
///
/// ```
/// use grazing_base::outcome::Outcome;
/// let files = [Outcome::Done, Outcome::Failed, Outcome::Refuted, Outcome::Undecided];
/// assert_eq!(files.into_iter().collect::<Outcome>(), Outcome::Refuted);
/// assert_eq!(files.map(Outcome::code), [0, 2, 1, 3]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// Done, or everything asked was proved.
    #[default]
    Done,
    /// What was looked for was not found.
    NothingFound,
    /// Something was left undecided.
    Undecided,
    /// The user ended it before it was done.
    Interrupted,
    /// Wrong usage or input, or something that cannot be read or written.
    Failed,
    /// A statement was refuted, or a certificate is malformed or false.
    Refuted,
}

impl Outcome {
    /// The worse of two.
    #[must_use]
    pub fn and(self, other: Outcome) -> Outcome {
        self.max(other)
    }

    /// The exit code: 1 if anything was refuted, else 2 if anything failed, else 3 if anything was undecided,
    /// interrupted or not found, else 0.
    pub fn code(self) -> u8 {
        match self {
            Outcome::Done => 0,
            Outcome::Refuted => 1,
            Outcome::Failed => 2,
            Outcome::NothingFound | Outcome::Undecided | Outcome::Interrupted => 3,
        }
    }

    /// The word for it in reports, as in JSON.
    pub fn word(self) -> &'static str {
        match self {
            Outcome::Done => "done",
            Outcome::NothingFound => "nothing-found",
            Outcome::Undecided => "undecided",
            Outcome::Interrupted => "interrupted",
            Outcome::Failed => "failed",
            Outcome::Refuted => "refuted",
        }
    }
}

/// How work ended that gave this error.
impl From<&Error> for Outcome {
    fn from(error: &Error) -> Outcome {
        if error.is_interrupted() { Outcome::Interrupted } else { Outcome::Failed }
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> ExitCode {
        ExitCode::from(outcome.code())
    }
}

/// The worst of several; `Done` for none.
impl FromIterator<Outcome> for Outcome {
    fn from_iter<I: IntoIterator<Item = Outcome>>(parts: I) -> Outcome {
        parts.into_iter().max().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::Outcome::*;

    #[test]
    fn the_order_is_refuted_failed_open_done() {
        let order = [Done, NothingFound, Undecided, Interrupted, Failed, Refuted];
        for (i, a) in order.into_iter().enumerate() {
            for (j, b) in order.into_iter().enumerate() {
                assert_eq!(a.and(b), order[i.max(j)]);
                // In the words of the exit codes, whichever comes first.
                let wanted = [1, 2, 3, 0].into_iter().find(|code| [a.code(), b.code()].contains(code));
                assert_eq!(Some(a.and(b).code()), wanted, "{a:?} and {b:?}");
            }
            assert_eq!(serde_json::json!(a), a.word());
        }
        assert_eq!([].into_iter().collect::<super::Outcome>(), Done);
    }
}
