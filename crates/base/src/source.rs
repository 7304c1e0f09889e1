//! TOML sources: errors that name file, line, key and value; exact numbers; the key that was meant.

use std::ops::Range;

use num_rational::BigRational;
use toml_edit::{Document, Value};

use crate::{
    error::{Error, Result, Spot},
    number::{LIMIT_BITS, parse_rational_within},
    output::LONGEST_SCENE,
    typed::{in_line, in_number},
};

/// The most values of a file, counted by the signs before them.
const MOST_VALUES: usize = 200_000;

/// The text of a TOML file, and the name that leads its error messages.
#[derive(Debug, Clone, PartialEq)]
pub struct Source<'a> {
    /// The text.
    pub text: &'a str,
    /// The name.
    pub name: &'a str,
}

impl Source<'_> {
    /// The text as TOML.
    pub fn document(&self) -> Result<Document<&str>> {
        if self.text.len() as u64 > LONGEST_SCENE {
            return Err(self.fail(None, &format!("has more than {LONGEST_SCENE} bytes")));
        }
        // Each value takes hundreds of bytes while a file is read, whatever it takes in the file.
        let marks = self.text.bytes().filter(|byte| matches!(byte, b',' | b'=' | b'[' | b'{')).count();
        if marks > MOST_VALUES {
            let message = format!(
                "has {marks} commas, equals signs and opening brackets: at most {MOST_VALUES}; large matrices go into \
                 files of their own"
            );
            return Err(self.fail(None, &message));
        }
        Document::parse(self.text).map_err(|error| {
            let hint = if error.message().contains("integer") || error.message().contains("float") {
                " (a number TOML cannot hold can be written as a string)"
            } else {
                ""
            };
            let line = error.span().and_then(|span| self.text.lines().nth(self.line(&span) - 1));
            let meant = line.and_then(in_line).map_or(String::new(), |meant| format!("; {meant}"));
            let what = error.message().replace('\n', "; ").replace(", expected nothing", "");
            let what = what.replace("duplicate key", "stands there twice: leave one out");
            let entry = line.and_then(|line| line.split_once('='));
            let entry = entry.map(|(key, value)| (short(key), short(value)));
            // The name of a table, where there is no key.
            let shown = line.filter(|line| entry.is_none() && !line.trim().is_empty());
            let shown = shown.map_or(String::new(), |line| format!("{}: ", short(line)));
            self.error(error.span(), entry, &format!("{shown}{what}{hint}{meant}"))
        })
    }

    /// The line on which something stands, counted from 1.
    pub fn line(&self, span: &Range<usize>) -> usize {
        let before = &self.text.as_bytes()[..span.start.min(self.text.len())];
        before.iter().filter(|&&byte| byte == b'\n').count() + 1
    }

    /// `name:line: message`.
    pub fn fail(&self, span: Option<Range<usize>>, message: &str) -> Error {
        self.error(span, None, message)
    }

    /// `name:line: key = value: message`, a long value cut short.
    pub fn at(&self, key: &str, span: Option<Range<usize>>, message: &str) -> Error {
        let value = span.clone().and_then(|span| self.text.get(span)).unwrap_or_default();
        self.error(span, Some((key.to_string(), short(value))), message)
    }

    fn error(&self, span: Option<Range<usize>>, entry: Option<(String, String)>, message: &str) -> Error {
        let line = span.map(|span| self.line(&span));
        let place = line.map_or(self.name.to_string(), |line| format!("{}:{line}", self.name));
        let entered = entry.as_ref().map_or(String::new(), |(key, value)| format!("{key} = {value}: "));
        let (key, value) = entry.unzip();
        let spot = Spot { file: self.name.into(), line, key, value, problem: message.into() };
        Error::input(format!("{place}: {entered}{message}")).at(spot)
    }

    /// The characters of a number: those of a string, or the source text of a TOML number and not the float
    /// that TOML makes of it.
    pub fn number_text(&self, value: &Value) -> Option<String> {
        match value {
            Value::String(text) => Some(text.value().clone()),
            Value::Integer(_) | Value::Float(_) => {
                Some(value.span().and_then(|span| self.text.get(span)).unwrap_or_default().replace('_', ""))
            }
            _ => None,
        }
    }

    /// An exact number of at most [`LIMIT_BITS`] bits in numerator and denominator.
    pub fn exact(&self, key: &str, value: &Value) -> Result<BigRational> {
        self.exact_within(key, value, LIMIT_BITS)
    }

    /// An exact number of at most `bits` bits in numerator and denominator.
    pub fn exact_within(&self, key: &str, value: &Value, bits: u32) -> Result<BigRational> {
        let text = self.number_text(value).ok_or_else(|| self.at(key, value.span(), "is not a number"))?;
        parse_rational_within(&text, bits).map_err(|error| {
            let meant = in_number(&text).map_or(String::new(), |meant| format!("; {meant}"));
            self.at(key, value.span(), &format!("{error}{meant}"))
        })
    }
}

/// A text on one line, cut short if it is long.
fn short(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.chars().count() > 60 { line.chars().take(57).chain(['…']).collect() } else { line }
}

/// Says that a key is unknown, and which of those known is near, or what the known ones are.
pub fn unknown(key: &str, known: &[&str]) -> String {
    match nearest(key, known.iter().copied()) {
        Some(nearest) => format!("unknown key {key:?}; the nearest known key is {nearest:?}"),
        None if known.is_empty() => format!("unknown key {key:?}; none is known here"),
        None => format!("unknown key {key:?}; known here are {}", known.join(", ")),
    }
}

/// To follow a word that is unknown: which of the known ones is near, or what they are.
pub fn hint<'a>(word: &str, known: impl IntoIterator<Item = &'a str> + Clone) -> String {
    match nearest(word, known.clone()) {
        Some(near) => format!("the nearest is {near:?}"),
        None => {
            let all: Vec<&str> = known.into_iter().collect();
            if all.is_empty() {
                "there are none".to_string()
            } else {
                format!("there are {}", all.join(", "))
            }
        }
    }
}

/// The known word that takes the fewest changes, if these are few: at most one for every three letters,
/// rounded up, and fewer than the word has. A change of case costs nothing; what a word begins with, or the
/// other way round, is near it.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = |word: &str| word.chars().count();
    let near = |other: &&str| {
        let letters = length(word).max(length(other));
        let changes = distance(word, other).0;
        let (one, two) = (word.to_lowercase(), other.to_lowercase());
        let begins = one.len().min(two.len()) >= 3 && (one.starts_with(&two) || two.starts_with(&one));
        begins || (changes <= letters.div_ceil(3) && changes < length(word).min(length(other)))
    };
    known.into_iter().filter(near).min_by_key(|other| distance(word, other))
}

/// The number of letters to insert, remove or replace (Levenshtein), a change of case counting least.
fn distance(a: &str, b: &str) -> (usize, bool) {
    let (lower_a, lower_b) = (a.to_lowercase(), b.to_lowercase());
    let mut row: Vec<usize> = (0..=lower_b.chars().count()).collect();
    for (i, x) in lower_a.chars().enumerate() {
        let mut corner = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in lower_b.chars().enumerate() {
            let replaced = corner + usize::from(x != y);
            corner = row[j + 1];
            row[j + 1] = replaced.min(corner + 1).min(row[j] + 1);
        }
    }
    (row[row.len() - 1], a != b)
}

#[cfg(test)]
mod tests {
    use super::{nearest, unknown};

    #[test]
    fn only_what_is_near_is_hinted_at() {
        let keys = ["damping", "stiffness", "cubic", "force", "forcing"];
        for (word, near) in [
            ("dampng", Some("damping")),
            ("Stiffness", Some("stiffness")),
            ("forse", Some("force")),
            ("forc", Some("force")),
            ("stiff", Some("stiffness")),
            ("mass", None),
            ("gravity", None),
            ("v", None),
            ("", None),
        ] {
            assert_eq!(nearest(word, keys), near, "{word:?}");
        }
        assert_eq!(nearest("v", ["d", "w"]), None);
        assert_eq!(unknown("v", &["d", "w"]), "unknown key \"v\"; known here are d, w");
    }
}
