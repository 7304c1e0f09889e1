//! How the rows of a table are set, in every format, and fast: tables of numbers run to billions of rows.
//!
//! A row is appended to a buffer and depends on no other, so threads can set rows apart. What goes before the
//! first row and after the last is in `table`.

use super::{
    escape,
    table::{Column, Print, TableCell, TableFormat},
};
use crate::printable::{Printable, csv_field};

/// How rows are set.
#[derive(Debug, Clone)]
pub struct RowSetter {
    pub(super) format: TableFormat,
    pub(super) columns: Vec<Column>,
    /// Whether a plain table leaves out what print does.
    pub(super) narrow: bool,
}

impl RowSetter {
    /// Appends a row, one cell for each column, to rows set before: in JSON all but the first follow a comma.
    /// Cost: O(1) per digit and letter.
    pub fn set(&self, rows: &mut Vec<u8>, cells: &[TableCell]) {
        debug_assert_eq!(cells.len(), self.columns.len());
        match self.format {
            TableFormat::Table => self.aligned(rows, cells),
            TableFormat::Csv => csv(rows, cells),
            TableFormat::Json => self.json(rows, cells),
            TableFormat::Latex | TableFormat::LatexSiunitx => self.latex(rows, cells),
            TableFormat::Markdown => markdown(rows, cells),
        }
    }

    /// Whether rows are set as CSV.
    pub fn is_csv(&self) -> bool {
        self.format == TableFormat::Csv
    }

    fn json(&self, rows: &mut Vec<u8>, cells: &[TableCell]) {
        rows.extend_from_slice(if rows.is_empty() { b"{" } else { b",\n{" });
        for (index, (cell, column)) in cells.iter().zip(&self.columns).enumerate() {
            rows.extend_from_slice(if index > 0 { b",\"" } else { b"\"" });
            rows.extend_from_slice(column.name.as_bytes());
            rows.extend_from_slice(b"\":");
            match cell {
                TableCell::Int(_) => plain(rows, cell),
                TableCell::Fraction(_) => within(rows, b"\"", b"\"", cell),
                TableCell::Text(text) | TableCell::Maths(text) => {
                    rows.extend_from_slice(json_string(text).as_bytes());
                }
                TableCell::Empty => rows.extend_from_slice(b"null"),
            }
        }
        rows.push(b'}');
    }

    fn latex(&self, rows: &mut Vec<u8>, cells: &[TableCell]) {
        let siunitx = self.format == TableFormat::LatexSiunitx;
        let (begin, end): (&[u8], &[u8]) = if siunitx { (b"\\num{", b"}") } else { (b"$", b"$") };
        let printed = cells.iter().zip(&self.columns).filter(|(_, column)| column.print != Print::Omitted);
        for (index, (cell, _)) in printed.enumerate() {
            rows.extend_from_slice(if index > 0 { b" & " } else { b"" });
            match cell {
                // A whole number is not written as a fraction in print.
                TableCell::Fraction(x) if *x.denom() == 1 => {
                    rows.extend_from_slice(begin);
                    integer(rows, *x.numer());
                    rows.extend_from_slice(end);
                }
                TableCell::Int(_) => within(rows, begin, end, cell),
                TableCell::Fraction(_) | TableCell::Maths(_) => within(rows, b"$", b"$", cell),
                TableCell::Text(text) if siunitx && escape::is_decimal(text) => {
                    within(rows, begin, end, cell)
                }
                TableCell::Text(text) => rows.extend_from_slice(escape::latex_cell(text).as_bytes()),
                TableCell::Empty => {}
            }
        }
        rows.extend_from_slice(b" \\\\\n");
    }

    /// Right-aligned, with two spaces between; none at the end of the line.
    fn aligned(&self, rows: &mut Vec<u8>, cells: &[TableCell]) {
        let begin = rows.len();
        let shown = cells
            .iter()
            .zip(&self.columns)
            .filter(|(_, column)| !(self.narrow && column.print == Print::Omitted));
        for (index, (cell, column)) in shown.enumerate() {
            let start = rows.len();
            plain(rows, cell);
            let end = rows.len();
            let padding = column.width.saturating_sub(end - start) + if index > 0 { 2 } else { 0 };
            // The padding goes before the cell.
            rows.resize(end + padding, b' ');
            rows.copy_within(start..end, start + padding);
            rows[start..start + padding].fill(b' ');
        }
        let text = rows[begin..].trim_ascii_end().len();
        rows.truncate(begin + text);
        rows.push(b'\n');
    }
}

/// A record of texts, as the header of CSV is.
pub(super) fn csv_header(rows: &mut Vec<u8>, names: &[&str]) {
    for (index, name) in names.iter().enumerate() {
        if index > 0 {
            rows.push(b',');
        }
        rows.extend_from_slice(csv_field(name).as_bytes());
    }
    rows.push(b'\n');
}

pub(super) fn json_string(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

fn csv(rows: &mut Vec<u8>, cells: &[TableCell]) {
    let start = rows.len();
    for (index, cell) in cells.iter().enumerate() {
        if index > 0 {
            rows.push(b',');
        }
        match cell {
            TableCell::Text(text) => rows.extend_from_slice(csv_field(text).as_bytes()),
            other => plain(rows, other),
        }
    }
    // A line with nothing on it would be no row.
    rows.extend_from_slice(if rows.len() == start { b"\"\"\n" } else { b"\n" });
}

fn markdown(rows: &mut Vec<u8>, cells: &[TableCell]) {
    for cell in cells {
        rows.extend_from_slice(b"| ");
        match cell {
            TableCell::Text(text) => rows.extend_from_slice(escape::markdown(text).as_bytes()),
            other => plain(rows, other),
        }
        rows.push(b' ');
    }
    rows.extend_from_slice(b"|\n");
}

/// A cell between two texts.
fn within(rows: &mut Vec<u8>, begin: &[u8], end: &[u8], cell: &TableCell) {
    rows.extend_from_slice(begin);
    plain(rows, cell);
    rows.extend_from_slice(end);
}

/// A cell with nothing around it.
fn plain(rows: &mut Vec<u8>, cell: &TableCell) {
    match cell {
        TableCell::Int(value) => {
            if *value < 0 {
                rows.push(b'-');
            }
            integer(rows, value.unsigned_abs());
        }
        TableCell::Fraction(x) => {
            integer(rows, *x.numer());
            rows.push(b'/');
            integer(rows, *x.denom());
        }
        TableCell::Text(text) | TableCell::Maths(text) => {
            rows.extend_from_slice(Printable(text).text().as_bytes());
        }
        TableCell::Empty => {}
    }
}

/// Numbers below this have at most eight digits, which one word holds.
const EIGHT: u64 = 100_000_000;

/// The four digits of every number below 10⁴, the first in the lowest byte.
static FOUR: [u32; 10_000] = {
    let mut all = [0; 10_000];
    let mut value = 0;
    while value < 10_000 {
        let v = value as u32;
        let [a, b, c, d] = [v / 1000, v / 100 % 10, v / 10 % 10, v % 10];
        all[value] = a | (b << 8) | (c << 16) | (d << 24) | 0x3030_3030;
        value += 1;
    }
    all
};

/// Numbers on their way to a buffer of rows, several rows at a time: a long buffer knows its length in memory
/// only, and each number would wait for the one before.
pub struct Numbers<'a> {
    rows: &'a mut Vec<u8>,
    bytes: [u8; 1024],
    length: usize,
}

impl<'a> Numbers<'a> {
    /// Nothing yet.
    pub fn new(rows: &'a mut Vec<u8>) -> Self {
        Numbers { rows, bytes: [0; 1024], length: 0 }
    }

    /// Appends the digits of a number, and a sign of ASCII. Cost: some instructions below 10,000, else O(1)
    /// per digit.
    #[inline]
    pub fn number(&mut self, value: u64, sign: u8) {
        if value >= 10_000 {
            return self.long(value, sign);
        }
        let zeros = leading_zeros(value);
        let digits = u64::from(FOUR[value as usize]) | (u64::from(sign) << 32);
        self.word(digits >> (8 * zeros), 5 - zeros);
    }

    #[cold]
    fn long(&mut self, value: u64, sign: u8) {
        self.flush();
        long_integer(self.rows, value);
        self.rows.push(sign);
    }

    /// Appends the first bytes of a word, at most 8, the lowest first.
    #[inline]
    pub fn word(&mut self, word: u64, bytes: usize) {
        if self.length > self.bytes.len() - 8 {
            self.flush();
        }
        self.bytes[self.length..self.length + 8].copy_from_slice(&word.to_le_bytes());
        self.length += bytes;
    }

    fn flush(&mut self) {
        self.rows.extend_from_slice(&self.bytes[..self.length]);
        self.length = 0;
    }
}

impl Drop for Numbers<'_> {
    fn drop(&mut self) {
        self.flush();
    }
}

/// The digits of a number; of most, those of a table.
#[inline]
fn integer(rows: &mut Vec<u8>, value: u64) {
    if value >= 10_000 {
        return long_integer(rows, value);
    }
    // Leading zeros are shifted out, and lie behind the end.
    let zeros = leading_zeros(value);
    rows.extend_from_slice(&(FOUR[value as usize] >> (8 * zeros)).to_le_bytes());
    rows.truncate(rows.len() - zeros);
}

/// How many of the four digits of a number below 10⁴ are leading zeros, but of 0 three.
#[inline]
fn leading_zeros(value: u64) -> usize {
    3 - usize::from(value > 9) - usize::from(value > 99) - usize::from(value > 999)
}

/// The digits of a number that has two or more.
fn long_integer(rows: &mut Vec<u8>, value: u64) {
    if value < EIGHT {
        let digits = eight_digits(value);
        // The first digit is in the lowest byte. Leading zeros are shifted out, and lie behind the end.
        let zeros = digits.trailing_zeros() / 8;
        let text = (digits | ASCII) >> (8 * zeros);
        rows.extend_from_slice(&text.to_le_bytes());
        return rows.truncate(rows.len() - zeros as usize);
    }
    integer(rows, value / EIGHT);
    rows.extend_from_slice(&(eight_digits(value % EIGHT) | ASCII).to_le_bytes());
}

const ASCII: u64 = 0x3030_3030_3030_3030;

/// The eight digits of a number below 10⁸, the first in the lowest byte.
///
/// Three times every part is split into quotient and remainder, all parts of the word at once: two of four
/// digits, four of two, eight of one. The quotients are exact. For x < 10⁴, with 10486 = (2²⁰ + 24)/100,
/// 10486x/2²⁰ exceeds x/100 by 24x/(100·2²⁰) < 1/400; for x < 100, with 103 = (2¹⁰ + 6)/10, 103x/2¹⁰ exceeds
/// x/10 by 6x/(10·2¹⁰) < 1/17. Neither reaches the next multiple of 1/100 or of 1/10. No product leaves its
/// part: 10486·9999 < 2³² and 103·99 < 2¹⁶; the masks keep the quotients, below 2⁷ and 2⁴.
fn eight_digits(value: u64) -> u64 {
    let fours = (value / 10_000) | ((value % 10_000) << 32);
    let hundreds = ((fours * 10_486) >> 20) & 0x7f_0000_007f;
    let pairs = hundreds | ((fours - 100 * hundreds) << 16);
    let tens = ((pairs * 103) >> 10) & 0x000f_000f_000f_000f;
    tens | ((pairs - 10 * tens) << 8)
}

#[cfg(test)]
mod tests {
    use num_rational::Ratio;
    use proptest::prelude::*;

    use super::*;

    fn text(rows: Vec<u8>) -> String {
        String::from_utf8(rows).unwrap()
    }

    /// Every number of up to six digits, both sides of every power of ten, and the ends.
    #[test]
    fn digits_are_those_of_the_standard_library() {
        let powers = (0..20).map(|e| 10u64.pow(e));
        let hard = powers.flat_map(|p| [p - 1, p, p + 1, p / 100 * 99]).chain([u64::MAX, u64::MAX - 1]);
        for value in (0..1_000_000).chain(hard) {
            let mut rows = Vec::new();
            integer(&mut rows, value);
            assert_eq!(text(rows), value.to_string());
        }
    }

    #[derive(Debug, Clone)]
    enum Owned {
        Int(i64),
        Fraction(Ratio<u64>),
        Text(String),
        Empty,
    }

    fn cell() -> impl Strategy<Value = Owned> {
        prop_oneof![
            any::<i64>().prop_map(Owned::Int),
            (-200_000i64..200_000).prop_map(Owned::Int),
            (any::<u64>(), 1..u64::MAX).prop_map(|(p, q)| Owned::Fraction(Ratio::new_raw(p, q))),
            "[a-c,\"\n\r |%é]{0,6}".prop_map(Owned::Text),
            Just(Owned::Empty),
        ]
    }

    proptest! {
        /// CSV by the package `csv`, JSON by `serde_json`, aligned text by the standard library.
        #[test]
        fn rows_are_those_of_others(rows in prop::collection::vec(prop::collection::vec(cell(), 3), 1..4)) {
            // Line ends are written out.
            let shown = |text: &str| text.replace('\n', "\\n").replace('\r', "\\r");
            let columns: Vec<Column> =
                [("n", 4), ("left", 12), ("last", 0)].map(|(name, width)| Column::new(name, name, width)).into();
            let names = columns.iter().map(|column| &*column.name);
            let words = |cell: &Owned| match cell {
                Owned::Int(value) => value.to_string(),
                Owned::Fraction(x) => format!("{}/{}", x.numer(), x.denom()),
                Owned::Text(text) => text.clone(),
                Owned::Empty => String::new(),
            };
            let set = |format| {
                let setter = RowSetter { format, columns: columns.clone(), narrow: false };
                let mut all = Vec::new();
                for row in &rows {
                    let cells: Vec<TableCell> = row.iter().map(|cell| match cell {
                        Owned::Int(value) => TableCell::Int(*value),
                        Owned::Fraction(x) => TableCell::Fraction(x),
                        Owned::Text(text) => TableCell::Text(text),
                        Owned::Empty => TableCell::Empty,
                    }).collect();
                    setter.set(&mut all, &cells);
                }
                text(all)
            };
            let mut csv = csv::Writer::from_writer(Vec::new());
            for row in &rows {
                csv.write_record(row.iter().map(|cell| shown(&words(cell)))).unwrap();
            }
            prop_assert_eq!(set(TableFormat::Csv), text(csv.into_inner().unwrap()));
            let json: Vec<String> = rows.iter().map(|row| {
                let cells = names.clone().zip(row).map(|(name, cell)| match cell {
                    Owned::Int(value) => format!("\"{name}\":{value}"),
                    Owned::Empty => format!("\"{name}\":null"),
                    other => format!("\"{name}\":{}", serde_json::to_string(&words(other)).unwrap()),
                });
                format!("{{{}}}", cells.collect::<Vec<_>>().join(","))
            }).collect();
            prop_assert_eq!(set(TableFormat::Json), json.join(",\n"));
            let aligned: String = rows.iter().map(|row| {
                // Widths count bytes.
                let cells = columns.iter().zip(row).map(|(column, cell)| {
                    let text = shown(&words(cell));
                    " ".repeat(column.width.saturating_sub(text.len())) + &text
                });
                format!("{}\n", cells.collect::<Vec<_>>().join("  ").trim_end())
            }).collect();
            prop_assert_eq!(set(TableFormat::Table), aligned);
        }
    }

    #[test]
    fn a_record_of_nothing_is_a_record() {
        let setter =
            RowSetter { format: TableFormat::Csv, columns: vec![Column::new("a", "", 0)], narrow: false };
        let mut rows = Vec::new();
        setter.set(&mut rows, &[TableCell::Empty]);
        setter.set(&mut rows, &[TableCell::Text("")]);
        assert_eq!(text(rows), "\"\"\n\"\"\n");
    }
}
