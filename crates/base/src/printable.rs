//! Text of others on its way out: names that a scene gives, file names, what stands in a file that is wrong.
//! It may not move the cursor of a terminal, turn the direction of a line, break it, or be a formula of a
//! spreadsheet.
//!
//! Every error message and every line of a report passes through [`Printable`]; cells of tables do too, and
//! those of CSV through [`csv_field`]. What LaTeX needs besides is in `output::escape`, and what SVG
//! needs in the shell.

use std::{
    borrow::Cow,
    fmt::{self, Write},
};

/// Whether a character shows as itself and leaves the others as they are.
pub fn is_printable(c: char) -> bool {
    !(c.is_control()
        || matches!(c,
            // Marks that turn the direction of text, join, separate or hide it.
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}'
            | '\u{fffe}' | '\u{ffff}'))
}

/// Text on one line: a character that is not printable is written as `\n`, `\u{1b}` and so on.
#[derive(Debug, Clone, Copy)]
pub struct Printable<'a>(pub &'a str);

impl<'a> Printable<'a> {
    /// The text; the same if there is nothing to change.
    pub(crate) fn text(self) -> Cow<'a, str> {
        // Of most text, and the fastest to tell.
        if self.0.bytes().all(|byte| (b' '..=b'~').contains(&byte)) || self.0.chars().all(is_printable) {
            Cow::Borrowed(self.0)
        } else {
            Cow::Owned(self.to_string())
        }
    }
}

impl fmt::Display for Printable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '\n' => f.write_str("\\n"),
            '\t' => f.write_str("\\t"),
            '\r' => f.write_str("\\r"),
            c if is_printable(c) => f.write_char(c),
            c => write!(f, "\\u{{{:x}}}", u32::from(c)),
        })
    }
}

/// Text as a field of CSV: printable, in quotes if a reader would break it, each of its own doubled (RFC
/// 4180). One that a spreadsheet would take for a formula is led by `'`; numbers and lists of numbers stay.
pub fn csv_field(text: &str) -> Cow<'_, str> {
    let mut field = Printable(text).text();
    if is_formula(&field) {
        field = Cow::Owned(format!("'{field}"));
    }
    if field.contains([',', '"']) {
        field = Cow::Owned(format!("\"{}\"", field.replace('"', "\"\"")));
    }
    field
}

/// Whether a spreadsheet would compute with a cell that is no number: it begins with `=` or `@`, or with a
/// sign and has anything that numbers, and those that are complex, do not have.
fn is_formula(text: &str) -> bool {
    const OF_NUMBERS: &str = "0123456789.,+-/eEi ";
    match text.trim_start().chars().next() {
        Some('=' | '@') => true,
        Some('+' | '-') => !text.chars().all(|c| OF_NUMBERS.contains(c)) && text.parse::<f64>().is_err(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_letter_is_written_out() {
        for (text, shown) in [
            ("a µ → “b” 日本 \u{1f600}", "a µ → “b” 日本 \u{1f600}"),
            ("\u{1b}[31mred\u{7}", "\\u{1b}[31mred\\u{7}"),
            ("one\ntwo\r\tthree", "one\\ntwo\\r\\tthree"),
            ("abc\u{202e}fed\u{2066}", "abc\\u{202e}fed\\u{2066}"),
            ("\u{9b}31m\u{feff}\u{200b}", "\\u{9b}31m\\u{feff}\\u{200b}"),
        ] {
            assert_eq!(Printable(text).text(), shown);
            assert_eq!(Printable(text).to_string(), shown);
        }
    }

    #[test]
    fn numbers_are_no_formulas() {
        for number in ["-1.5e-30", "+2", "-0.5 - 0.25i", "-1, -2", "-3/8", "-", "+", "-inf", "1", "a=b", ""] {
            assert!(!is_formula(number), "{number}");
        }
        for (text, field) in [
            ("=1+1", "'=1+1"),
            (" =1+1", "' =1+1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
            ("-2+HYPERLINK(\"x\",\"y\")", "\"'-2+HYPERLINK(\"\"x\"\",\"\"y\"\")\""),
            ("\t=1", "\\t=1"),
            ("left, right", "\"left, right\""),
        ] {
            assert_eq!(csv_field(text), field);
        }
    }
}
