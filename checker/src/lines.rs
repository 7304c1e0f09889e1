//! A certificate as a stream of numbered lines, and the words on a line.

use std::io::{BufRead, Read};

use super::{Rejection, arithmetic::Fraction};

/// The longest line, but for those whose reader allows more; a longer one is rejected before it is held in memory.
const LONGEST: u64 = 1000;

/// The lines of a certificate, with the number of the latest.
pub(super) struct Lines<'a> {
    input: &'a mut dyn BufRead,
    number: u64,
}

impl<'a> Lines<'a> {
    pub fn new(input: &'a mut dyn BufRead) -> Self {
        Lines::after(0, input)
    }

    /// The lines of a part that `number` lines come before.
    pub fn after(number: u64, input: &'a mut dyn BufRead) -> Self {
        Lines { input, number }
    }

    /// The number of the latest line, from 1.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// The next line without its end, or `None` after the last.
    pub fn next(&mut self) -> Result<Option<String>, Rejection> {
        self.next_within(LONGEST)
    }

    fn next_within(&mut self, longest: u64) -> Result<Option<String>, Rejection> {
        self.number += 1;
        let mut bytes = Vec::new();
        let read = (&mut *self.input).take(longest).read_until(b'\n', &mut bytes);
        match read {
            Err(source) => return Err(Rejection::Unreadable { line: self.number, source }),
            Ok(0) => {
                self.number -= 1;
                return Ok(None);
            }
            Ok(_) => {}
        }
        if bytes.pop() != Some(b'\n') {
            return Err(self.malformed("the line is too long or its end is missing"));
        }
        match String::from_utf8(bytes) {
            Ok(line) => Ok(Some(line)),
            Err(_) => Err(self.malformed("the line is not text")),
        }
    }

    /// The next line, which must exist.
    pub fn expect(&mut self, what: &str) -> Result<String, Rejection> {
        self.expect_within(LONGEST, what)
    }

    /// The next line, which must exist, of up to `longest` bytes.
    pub fn expect_within(&mut self, longest: u64, what: &str) -> Result<String, Rejection> {
        match self.next_within(longest)? {
            Some(line) => Ok(line),
            None => {
                self.number += 1;
                Err(self.malformed(format!("the file ends where {what} should stand")))
            }
        }
    }

    /// A rejection of the latest line's form.
    pub fn malformed(&self, reason: impl Into<String>) -> Rejection {
        Rejection::Malformed { line: self.number, reason: reason.into() }
    }

    /// A rejection of the latest line's claim.
    pub fn false_claim(&self, reason: impl Into<String>) -> Rejection {
        Rejection::False { line: self.number, reason: reason.into() }
    }
}

/// The words of a line, taken from left to right; an error says what was expected.
#[derive(Clone)]
pub(super) struct Words<'a> {
    rest: std::str::Split<'a, char>,
}

impl<'a> Words<'a> {
    pub fn new(line: &'a str) -> Self {
        Words { rest: line.split(' ') }
    }

    pub fn word(&mut self, what: &str) -> Result<&'a str, String> {
        self.rest.next().ok_or_else(|| format!("expected {what}, found the end of the line"))
    }

    /// A decimal number up to `most`, without sign or leading zeros.
    pub fn number(&mut self, what: &str, most: u64) -> Result<u64, String> {
        number(self.word(what)?, most).ok_or_else(|| format!("expected {what}, a number from 0 to {most}"))
    }

    /// A fraction p/q in lowest terms with 0 ≤ p/q ≤ 1 and q ≤ `most`.
    pub fn fraction(&mut self, most: u64) -> Result<Fraction, String> {
        let word = self.word("a fraction p/q")?;
        word.split_once('/')
            .and_then(|(p, q)| Fraction::new(number(p, most)?, number(q, most)?))
            .ok_or_else(|| format!("expected a fraction p/q in lowest terms, 0 <= p <= q <= {most}"))
    }

    pub fn end(&mut self) -> Result<(), String> {
        match self.rest.next() {
            None => Ok(()),
            Some(_) => Err("unexpected words at the end of the line".into()),
        }
    }
}

/// A decimal number up to `most`, without sign or leading zeros.
pub(super) fn number(word: &str, most: u64) -> Option<u64> {
    let plain = word.bytes().all(|byte| byte.is_ascii_digit());
    let canonical = plain && (word == "0" || !word.starts_with('0'));
    word.parse().ok().filter(|&value| canonical && value <= most)
}
