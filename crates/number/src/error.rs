//! The one thing that goes wrong here: a text that is no number.

use std::{error, fmt};

/// Why a text was not read as a number: one line that quotes the text, and says what was expected where or
/// which limit it exceeds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParseError(Box<str>);

impl ParseError {
    pub(crate) fn new(message: impl Into<Box<str>>) -> Self {
        ParseError(message.into())
    }
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl error::Error for ParseError {}
