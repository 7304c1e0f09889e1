//! The Check panel: certificates of any kind, by the trusted checker.

use std::io::{BufRead, Read, Result};

use grazing_check::{FORMAT, Rejection, Sha256};
use serde_json::{Value, json};

/// Bytes that are read, and told.
struct Told<'a> {
    rest: &'a [u8],
    total: usize,
    tell: &'a mut dyn FnMut(usize, usize),
}

impl Read for Told<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.rest.read(buffer)?;
        (self.tell)(self.total - self.rest.len(), self.total);
        Ok(count)
    }
}

impl BufRead for Told<'_> {
    fn fill_buf(&mut self) -> Result<&[u8]> {
        Ok(self.rest)
    }

    fn consume(&mut self, count: usize) {
        self.rest = &self.rest[count..];
        (self.tell)(self.total - self.rest.len(), self.total);
    }
}

/// Checks a certificate of any kind; `progress` is told the bytes read and their number, after every line.
///
/// `verdict` is `proved`, `false`, `malformed` or `undecided`; `what` says what a malformed file is: a
/// `shard`, text behind a byte order `mark` or in `utf-16`, a certificate of another `format`, of another
/// `version` of its kind or of an `unknown` kind; none of these. `known` lists the kinds. `title` is what is
/// proved, in a word. `line` (from 1) and `reason` say where and why it was rejected.
pub fn check(bytes: &[u8], progress: &mut dyn FnMut(usize, usize)) -> String {
    let mut hash = Sha256::default();
    hash.update(bytes);
    let common = json!({ "bytes": bytes.len(), "sha256": hash.finish() });
    let answer = grazing_check::check(&mut Told { rest: bytes, total: bytes.len(), tell: progress });
    let found = match answer {
        Ok(checked) => json!({
            "verdict": "proved",
            "kind": checked.kind,
            "title": checked.title,
            "range": checked.range.as_ref().map(|range| [range.start(), range.end()]),
            "detail": checked.detail,
            "lines": checked.lines,
            "statement": checked.statement,
        }),
        Err(rejection) => rejected(bytes, &rejection),
    };
    let (Value::Object(mut all), Value::Object(more)) = (common, found) else { unreachable!("two objects") };
    all.extend(more);
    Value::Object(all).to_string()
}

fn rejected(bytes: &[u8], rejection: &Rejection) -> Value {
    let (verdict, line, reason) = match rejection {
        Rejection::Malformed { line, reason } => ("malformed", *line, reason.clone()),
        Rejection::False { line, reason } => ("false", *line, reason.clone()),
        Rejection::Undecided { line, reason } => ("undecided", *line, reason.clone()),
        Rejection::Unreadable { line, source } => ("malformed", *line, source.to_string()),
        Rejection::Interrupted { line } => ("interrupted", *line, rejection.to_string()),
    };
    json!({
        "verdict": verdict,
        "line": line,
        "reason": reason,
        "kind": kind(bytes),
        "what": what(bytes, line),
        "known": grazing_check::kinds().collect::<Vec<_>>(),
    })
}

/// The first lines' text; none where it is not text.
fn head(bytes: &[u8]) -> impl Iterator<Item = &str> {
    bytes
        .split(|&byte| byte == b'\n')
        .take(2)
        .map_while(|line| str::from_utf8(line).ok())
        .map(|line| line.strip_suffix('\r').unwrap_or(line))
}

/// What the kind line says.
fn kind(bytes: &[u8]) -> Option<&str> {
    head(bytes).nth(1)?.strip_prefix("kind ")
}

/// What a file is that was rejected in its first two lines.
fn what(bytes: &[u8], line: u64) -> Option<&'static str> {
    match line {
        1 if bytes.starts_with(b"\xef\xbb\xbf") => Some("mark"),
        1 if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") => Some("utf-16"),
        1 => {
            let first = head(bytes).next()?;
            if first.starts_with("grazing-shard ") {
                Some("shard")
            } else {
                (first != FORMAT && first.starts_with("grazing-certificate ")).then_some("format")
            }
        }
        2 => {
            let name = kind(bytes)?.split(' ').next()?;
            let known = grazing_check::kinds().any(|kind| kind.split(' ').next() == Some(name));
            Some(if known { "version" } else { "unknown" })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Value {
        serde_json::from_str(&check(text.as_bytes(), &mut |_, _| {})).unwrap()
    }

    #[test]
    fn what_is_no_certificate_is_named() {
        for (text, what) in [
            ("grazing-shard 1\n", json!("shard")),
            ("grazing-certificate 2\nkind cover\n", json!("format")),
            ("grazing-certificate 1\nkind cover 7\n", json!("version")),
            ("grazing-certificate 1\r\nkind cover 7\r\n", json!("version")),
            ("grazing-certificate 1\nkind coverage\n", json!("unknown")),
            ("grazing-certificate 1\nkind cover\nrange\n", json!(null)),
            ("", json!(null)),
            ("something else\n", json!(null)),
            ("\u{feff}grazing-certificate 1\nkind cover\n", json!("mark")),
        ] {
            let found = of(text);
            assert_eq!((&found["verdict"], &found["what"]), (&json!("malformed"), &what), "{text:?}");
        }
        // What an editor saves as "Unicode".
        let wide: Vec<u8> = "\u{feff}grazing".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let found: Value = serde_json::from_str(&check(&wide, &mut |_, _| {})).unwrap();
        assert_eq!(found["what"], "utf-16");
    }
}
