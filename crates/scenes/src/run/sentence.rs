//! Sentences of a report, each with a mark that says on what it rests. What they say is in the modules of
//! what they are about.

use std::fmt;

use serde::Serialize;

use super::Lines;

/// On what a sentence of a report rests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// A certificate says it, which the checker has accepted.
    Proved,
    /// A root found in floats, with its residual, or what follows from it by the theory.
    Located,
    /// Motions that were followed in floats, from as many starts and for as long as the report says.
    Seen,
}

impl fmt::Display for Mark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Mark::Proved => "proved",
            Mark::Located => "located",
            Mark::Seen => "seen",
        })
    }
}

/// A sentence and its mark.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Sentence {
    /// On what it rests; of several things that it says, the weakest.
    pub mark: Mark,
    /// The sentence.
    pub text: String,
    /// Whether it says more than a page of answer does.
    pub detail: bool,
}

impl Sentence {
    /// A line for each, under its mark.
    pub(super) fn lines(all: &[Sentence], lines: &mut Lines) {
        for Sentence { mark, text, .. } in all {
            lines.say(&mark.to_string(), text.as_str());
        }
    }
}

impl Mark {
    /// A sentence with this mark.
    pub(super) fn of(self, text: impl Into<String>) -> Sentence {
        Sentence { mark: self, text: text.into(), detail: false }
    }

    /// A sentence that says more than a page of answer does.
    pub(super) fn in_detail(self, text: impl Into<String>) -> Sentence {
        Sentence { detail: true, ..self.of(text) }
    }
}
