//! A certificate as a stream of numbered lines, and the words on a line.

use std::{
    fmt,
    io::{BufRead, Read},
};

use super::{
    Rejection,
    arithmetic::Fraction,
    rejection::{Fault, ensure},
};

/// The longest line in bytes, without its end, but for those whose reader allows more; a longer one is
/// rejected before it is held in memory.
pub(super) const LONGEST: usize = 1000;

/// The lines of a certificate, with the number of the latest.
pub(super) struct Lines<'a> {
    input: &'a mut dyn BufRead,
    stop: &'a mut dyn FnMut() -> bool,
    number: u64,
    /// The latest line.
    bytes: Vec<u8>,
}

impl<'a> Lines<'a> {
    /// The lines of a part that `number` lines come before; `stop` is asked again and again whether the work
    /// should end.
    pub fn after(number: u64, input: &'a mut dyn BufRead, stop: &'a mut dyn FnMut() -> bool) -> Self {
        Lines { input, stop, number, bytes: Vec::new() }
    }

    /// The number of the latest line, from 1.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// Ends the work if the caller wants it.
    pub fn go_on(&mut self) -> Result<(), Fault> {
        if (self.stop)() { Err(Fault::Interrupted) } else { Ok(()) }
    }

    /// The next line without its end, or `None` after the last.
    pub fn next(&mut self) -> Result<Option<String>, Rejection> {
        Ok(self.next_within(LONGEST)?.map(String::from))
    }

    /// A line ends with a line feed, with a carriage return and a line feed, or with the file.
    fn next_within(&mut self, longest: usize) -> Result<Option<&str>, Rejection> {
        self.number += 1;
        self.go_on().map_err(|fault| self.rejection(fault))?;
        self.bytes.clear();
        // Two bytes more, for the end of the line.
        let read = (&mut *self.input).take(longest as u64 + 2).read_until(b'\n', &mut self.bytes);
        match read {
            // What is read may have been cut short by the caller's wish to end.
            Err(_) if (self.stop)() => return Err(self.rejection(Fault::Interrupted)),
            Err(source) => return Err(Rejection::Unreadable { line: self.number, source }),
            Ok(0) => {
                self.number -= 1;
                return Ok(None);
            }
            Ok(_) => {}
        }
        if self.bytes.last() == Some(&b'\n') {
            self.bytes.pop();
            if self.bytes.last() == Some(&b'\r') {
                self.bytes.pop();
            }
        }
        if self.bytes.len() > longest {
            return Err(self.malformed(format!("the line is longer than {longest} bytes")));
        }
        match str::from_utf8(&self.bytes) {
            Ok(line) => Ok(Some(line)),
            Err(_) => Err(self.malformed("the line is not text")),
        }
    }

    /// The next line, which must exist.
    pub fn expect(&mut self, what: &str) -> Result<String, Rejection> {
        self.expect_within(LONGEST, what)
    }

    /// The next line, which must exist, of up to `longest` bytes.
    pub fn expect_within(&mut self, longest: usize, what: &str) -> Result<String, Rejection> {
        self.parsed(longest, what, |line| Ok(line.to_string()))
    }

    /// The same, as `parse` reads it.
    pub fn parsed<T>(
        &mut self,
        longest: usize,
        what: &str,
        parse: impl FnOnce(&str) -> Result<T, String>,
    ) -> Result<T, Rejection> {
        match self.next_within(longest)?.map(parse) {
            Some(read) => read.map_err(|reason| self.malformed(reason)),
            None => {
                self.number += 1;
                Err(self.malformed(format!("the file ends where {what} should stand")))
            }
        }
    }

    /// The next line, led by its name and read by `parse` to its end.
    pub fn line<T>(
        &mut self,
        name: &str,
        parse: impl FnOnce(&mut Words) -> Result<T, String>,
    ) -> Result<T, Rejection> {
        self.line_within(LONGEST, name, parse)
    }

    /// The same, of up to `longest` bytes.
    pub fn line_within<T>(
        &mut self,
        longest: usize,
        name: &str,
        parse: impl FnOnce(&mut Words) -> Result<T, String>,
    ) -> Result<T, Rejection> {
        let text = self.expect_within(longest, &format!("a line \"{name} …\""))?;
        self.read(&text, name, parse)
    }

    /// The latest line, which is this, led by its name.
    pub fn read<T>(
        &self,
        text: &str,
        name: &str,
        parse: impl FnOnce(&mut Words) -> Result<T, String>,
    ) -> Result<T, Rejection> {
        let mut words = Words::new(text);
        let read = || {
            words.name(name)?;
            let value = parse(&mut words)?;
            words.end()?;
            Ok(value)
        };
        read().map_err(|reason: String| self.malformed(reason))
    }

    /// The next line, before which one with another name may stand.
    pub fn perhaps<S, T>(
        &mut self,
        other: &str,
        parse_other: impl FnOnce(&mut Words) -> Result<S, String>,
        name: &str,
        parse: impl FnOnce(&mut Words) -> Result<T, String>,
    ) -> Result<(Option<S>, T), Rejection> {
        let text = self.expect(&format!("a line \"{name} …\""))?;
        if Words::new(&text).name(other).is_ok() {
            let first = self.read(&text, other, parse_other)?;
            return Ok((Some(first), self.line(name, parse)?));
        }
        Ok((None, self.read(&text, name, parse)?))
    }

    /// The file must end here.
    pub fn end(&mut self, reason: impl fmt::Display) -> Result<(), Rejection> {
        let ends = self.next()?.is_none();
        self.form(ends, reason)
    }

    /// Rejects the latest line's form, unless it `holds` what it should.
    pub fn form(&self, holds: bool, reason: impl fmt::Display) -> Result<(), Rejection> {
        ensure(holds, reason).map_err(|reason| self.malformed(reason))
    }

    /// Rejects the latest line's claim, unless it `holds`.
    pub fn claim(&self, holds: bool, reason: impl fmt::Display) -> Result<(), Rejection> {
        ensure(holds, reason).map_err(|reason| self.false_claim(reason))
    }

    /// What is wrong with the latest line.
    pub fn rejection(&self, fault: Fault) -> Rejection {
        fault.on(self.number)
    }

    /// A rejection of the latest line's form.
    pub fn malformed(&self, reason: impl Into<String>) -> Rejection {
        self.rejection(Fault::Malformed(reason.into()))
    }

    /// A rejection of the latest line's claim.
    pub fn false_claim(&self, reason: impl Into<String>) -> Rejection {
        self.rejection(Fault::False(reason.into()))
    }
}

/// The words of a line, taken from left to right; an error says what was expected.
#[derive(Clone)]
pub(super) struct Words<'a> {
    /// What follows the space after the latest word; none after the last word.
    rest: Option<&'a str>,
}

impl<'a> Words<'a> {
    pub fn new(line: &'a str) -> Self {
        Words { rest: Some(line) }
    }

    pub fn word(&mut self, what: &str) -> Result<&'a str, String> {
        let rest = self.rest.ok_or_else(|| format!("expected {what}, found the end of the line"))?;
        let end = rest.bytes().position(|byte| byte == b' ');
        self.rest = end.map(|end| &rest[end + 1..]);
        Ok(&rest[..end.unwrap_or(rest.len())])
    }

    /// The word that a line begins with.
    pub fn name(&mut self, name: &str) -> Result<(), String> {
        if self.word(name)? == name { Ok(()) } else { Err(format!("expected a line \"{name} …\"")) }
    }

    /// A decimal number up to `most`, without sign or leading zeros.
    pub fn number(&mut self, what: &str, most: u64) -> Result<u64, String> {
        number(self.word(what)?, most).ok_or_else(|| format!("expected {what}, a number from 0 to {most}"))
    }

    /// A fraction p/q in lowest terms with 0 ≤ p/q ≤ 1 and q ≤ `most`.
    pub fn fraction(&mut self, most: u64) -> Result<Fraction, String> {
        self.fraction_again(most, Fraction::ZERO)
    }

    /// The same; if it is this one, known already, no gcd is taken again.
    pub fn fraction_again(&mut self, most: u64, known: Fraction) -> Result<Fraction, String> {
        let word = self.word("a fraction p/q")?;
        word.split_once('/')
            .and_then(|(p, q)| {
                let parts = (number(p, most)?, number(q, most)?);
                if parts == known.parts() { Some(known) } else { Fraction::new(parts.0, parts.1) }
            })
            .ok_or_else(|| format!("expected a fraction p/q in lowest terms, 0 <= p <= q <= {most}"))
    }

    pub fn end(&mut self) -> Result<(), String> {
        ensure(self.rest.is_none(), "unexpected words at the end of the line")
    }
}

/// A decimal number up to `most`, without sign or leading zeros.
pub(super) fn number(word: &str, most: u64) -> Option<u64> {
    let mut value: u64 = 0;
    for byte in word.bytes() {
        let digit = byte.is_ascii_digit().then(|| u64::from(byte - b'0'))?;
        value = value.checked_mul(10)?.checked_add(digit)?;
    }
    let canonical = word == "0" || !(word.is_empty() || word.starts_with('0'));
    (canonical && value <= most).then_some(value)
}
