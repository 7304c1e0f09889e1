//! What certificates about a range of periods begin with, and their end.

use std::ops::RangeInclusive;

use super::{
    FORMAT, Proved, Rejection,
    lines::{LONGEST, Lines},
};

/// The header's lines.
pub(super) fn text(kind: &str, statement: &str, range: &RangeInclusive<u64>, lines: u64) -> String {
    let (first, last) = (range.start(), range.end());
    format!("{FORMAT}\nkind {kind}\nrange {first} {last}\nlines {lines}\nstatement {statement}\n")
}

/// A header that has been read up to its statement.
pub(super) struct Header {
    first: u64,
    last: u64,
    /// The line that tells the number of lines, and its number.
    claimed: String,
    claimed_at: u64,
    /// The number of the header's last line.
    end: u64,
}

impl Header {
    /// Reads what follows the kind line: the range, which must lie within `periods`, the number of lines and
    /// the statement.
    pub fn read(
        lines: &mut Lines,
        periods: RangeInclusive<u64>,
        statement: &str,
    ) -> Result<Header, Rejection> {
        let (least, most) = periods.into_inner();
        let [first, last] = numbers(lines, "range", [("the first period", most), ("the last period", most)])?;
        let holds = least <= first && first <= last;
        lines.form(holds, format_args!("the range must be {least} <= first <= last"))?;
        let claimed = lines.expect("the number of lines")?;
        let claimed_at = lines.number();
        expect_statement(lines, statement)?;
        Ok(Header { first, last, claimed, claimed_at, end: lines.number() })
    }

    /// The periods n covered.
    pub fn range(&self) -> RangeInclusive<u64> {
        self.first..=self.last
    }

    /// Checks that the file ends here, after as many lines as the header says.
    pub fn finish(self, lines: &mut Lines) -> Result<Proved, Rejection> {
        lines.end("the file goes on after the last period of its range")?;
        let body = lines.number() - self.end;
        if self.claimed != format!("lines {body}") {
            let reason = format!("{body} lines follow the header, so this should be \"lines {body}\"");
            return Err(Rejection::Malformed { line: self.claimed_at, reason });
        }
        Ok(Proved::plain(Some(self.range()), Vec::new()))
    }
}

/// Reads the statement, which must be this one.
pub(super) fn expect_statement(lines: &mut Lines, statement: &str) -> Result<(), Rejection> {
    let longest = LONGEST.max(statement.len() + 100);
    let line = lines.expect_within(longest, "the statement")?;
    let same = line.strip_prefix("statement ") == Some(statement);
    lines.form(same, "the statement is not, word for word, that of this kind and version")
}

/// Reads a line of a name and two numbers, each with what it is and the most that it may be.
pub(super) fn numbers(
    lines: &mut Lines,
    name: &str,
    [one, two]: [(&str, u64); 2],
) -> Result<[u64; 2], Rejection> {
    lines.line(name, |words| Ok([words.number(one.0, one.1)?, words.number(two.0, two.1)?]))
}
