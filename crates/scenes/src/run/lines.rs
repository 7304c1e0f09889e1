//! The lines of a report as text: names and values, and tables, set to a width and in words. JSON and CSV
//! files have the same names and values, in the order of their declaration, and keep the signs of patterns
//! and regions.

use std::fmt::Write;

use num_traits::One;

use super::{ColumnUnit, Row, Shown, Tabular};
use crate::{local::Region, number::parse_rational, printable::Printable, quantity::exact_text};

/// Names of lines end here.
const NAMES: usize = 16;

/// Columns that say more of what the others have said: a reader finds them to the right of those.
const DETAIL: [&str; 14] = [
    "coefficient",
    "found_at",
    "phases",
    "speeds",
    "multipliers",
    "nearest_stop",
    "least_gap",
    "largest_gap",
    "acceleration",
    "gamma",
    "e",
    "length",
    "residual",
    "newton_steps",
];

/// A cell in words, where JSON has a sign of its own.
fn in_words(column: &str, cell: String) -> String {
    match column {
        "pattern" | "orbit" => match cell.strip_prefix("free ") {
            Some("1") => "no impact".into(),
            Some(periods) => format!("no impact in {periods} periods"),
            None => cell,
        },
        "region" => Region::named(&cell).map_or(cell, |region| region.words()),
        _ => cell,
    }
}

/// Whether a cell has numbers alone, and no counts.
fn has_numbers(cell: &str) -> bool {
    cell.split(", ").all(|part| part.contains(['.', 'e', '/']) && parse_rational(part).is_ok())
}

impl ColumnUnit {
    /// The unit in which a reader is told it.
    fn name(&self) -> &str {
        self.written.as_ref().map_or(&self.own, |unit| &unit.text)
    }

    fn converts(&self) -> bool {
        self.written.as_ref().is_some_and(|unit| !unit.size.is_one())
    }

    /// The numbers of a cell in that unit, which has all digits and is told with some: what is told with all
    /// is converted exactly.
    fn converted(&self, cell: &str, (told, digits): (&str, Option<usize>)) -> String {
        let Some(unit) = self.written.as_ref().filter(|_| self.converts()) else { return told.to_string() };
        let one = |part: &str| match (part.parse::<f64>(), parse_rational(part)) {
            (Ok(x), _) if cell != told => unit.of(x).set(digits),
            (_, Ok(exact)) => exact_text(&(exact / &unit.size)).trim_matches(['(', ')']).to_string(),
            _ => part.to_string(),
        };
        cell.split(", ").map(one).collect::<Vec<_>>().join(", ")
    }
}

/// The lines of a report: name and value, or a table under its name.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    text: String,
    /// Significant digits of floats; all if it does not say.
    digits: Option<usize>,
    /// How wide they may be, in characters.
    width: Option<usize>,
    /// What columns are in.
    units: Vec<ColumnUnit>,
}

impl Lines {
    /// Lines of at most this width, where a word is no wider, with floats of so many significant digits.
    pub fn new(digits: Option<usize>, width: Option<usize>) -> Lines {
        Lines { text: String::new(), digits, width, units: Vec::new() }
    }

    /// The same, with units.
    pub fn in_units(self, units: &[ColumnUnit]) -> Lines {
        Lines { units: units.to_vec(), ..self }
    }

    fn unit(&self, column: &str) -> Option<&ColumnUnit> {
        self.units.iter().find(|unit| unit.column == column)
    }

    /// A number of a column in the unit in which it is told, which stands behind it.
    pub fn told(&self, column: &str, number: impl Shown) -> String {
        match self.unit(column) {
            Some(unit) => {
                let told = unit.converted(&number.set(None), (&number.set(self.digits), self.digits));
                format!("{told} {}", unit.name()).trim_end().to_string()
            }
            None => number.set(self.digits),
        }
    }

    /// A side of a value of the parameter, as in `F < 0.5`, in its unit.
    pub fn side(&self, side: &str) -> String {
        let told = |sign: &str| {
            let (name, value) = side.split_once(sign)?;
            let unit = self.unit("parameter").and(value.parse::<f64>().ok());
            Some(format!("{name}{sign}{}", self.told("parameter", unit?)))
        };
        told(" < ").or_else(|| told(" > ")).unwrap_or_else(|| side.to_string())
    }

    /// From here on floats have all their digits: bounds are not to be rounded.
    pub fn exact(&mut self) {
        self.digits = None;
    }

    /// A value as text, with the digits of these lines.
    pub fn set(&self, value: impl Shown) -> String {
        value.set(self.digits)
    }

    /// A line.
    pub fn say(&mut self, name: &str, value: impl Shown) {
        let text = self.set(&value);
        let value = if has_numbers(&text) { self.told(name, value) } else { in_words(name, text) };
        self.line(&format!("  {name:<NAMES$} "), &value);
    }

    /// A line, of what is known.
    pub fn say_known<T: Shown + Clone>(&mut self, name: &str, value: &Option<T>) {
        if let Some(value) = value {
            self.say(name, value.clone());
        }
    }

    /// The fields of a row that are wanted, each a name and a text, a line each.
    pub fn fields<R: Row>(&mut self, row: &R, wanted: impl Fn(&(&'static str, String)) -> bool) {
        let cells = row.cells(self.digits);
        for (name, cell) in R::fields().into_iter().zip(cells).filter(wanted) {
            self.say(name, cell);
        }
    }

    /// A table, columns aligned to the right, what matters first, without those that are empty; where it is
    /// too wide, a block for each row, with what is not empty; "none" if there are no rows.
    pub fn table<T: Tabular>(&mut self, name: &str, table: &T) {
        let (names, mut rows) = (table.columns(), table.cells(self.digits));
        if rows.is_empty() {
            return self.say(name, "none");
        }
        let mut heads: Vec<String> = names.iter().map(ToString::to_string).collect();
        let all = if self.units.is_empty() { Vec::new() } else { table.cells(None) };
        if let Some(i) = names.iter().position(|name| *name == "side") {
            rows.iter_mut().for_each(|row| row[i] = self.side(&row[i]));
        }
        for (i, head) in heads.iter_mut().enumerate() {
            let Some(unit) = self.unit(names[i]).filter(|_| all.iter().any(|row| has_numbers(&row[i])))
            else {
                continue;
            };
            if !unit.name().is_empty() {
                *head = format!("{head} ({})", unit.name());
            }
            if unit.converts() {
                rows.iter_mut()
                    .zip(&all)
                    .for_each(|(row, all)| row[i] = unit.converted(&all[i], (&row[i], self.digits)));
            }
        }
        let _ = writeln!(self.text, "  {name}");
        let told = |&i: &usize| rows.iter().any(|row| !row[i].is_empty());
        let (detail, first): (Vec<usize>, Vec<usize>) =
            (0..names.len()).filter(told).partition(|&i| DETAIL.contains(&names[i]));
        let order = [first, detail].concat();
        let shown = |row: &Vec<String>, i: usize| Printable(&in_words(names[i], row[i].clone())).to_string();
        let cells: Vec<Vec<String>> =
            rows.iter().map(|row| order.iter().map(|&i| shown(row, i)).collect()).collect();
        let heads: Vec<String> = order.iter().map(|&i| heads[i].clone()).collect();
        let widths: Vec<usize> = (0..heads.len())
            .map(|i| {
                let widest = cells.iter().map(|row| row[i].chars().count()).max().unwrap_or(0);
                widest.max(heads[i].chars().count())
            })
            .collect();
        let whole = 4 + widths.iter().sum::<usize>() + 2 * widths.len().saturating_sub(1);
        if self.width.is_some_and(|width| whole > width) {
            return self.blocks(&heads, &cells);
        }
        for row in std::iter::once(&heads).chain(&cells) {
            let line: Vec<String> =
                row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}")).collect();
            let _ = writeln!(self.text, "    {}", line.join("  ").trim_end());
        }
    }

    /// Each row's names and values under its number.
    fn blocks(&mut self, heads: &[String], cells: &[Vec<String>]) {
        let names = heads.iter().map(|head| head.chars().count()).max().unwrap_or(0);
        for (index, row) in cells.iter().enumerate() {
            let number = (index + 1).to_string();
            let known = heads.iter().zip(row).filter(|(_, cell)| !cell.is_empty());
            for (at, (name, cell)) in known.enumerate() {
                let number = if at == 0 { number.as_str() } else { "" };
                self.line(&format!("  {number:>4}  {name:<names$}  "), cell);
            }
        }
    }

    /// A line that begins so, broken at blanks where it is too wide.
    fn line(&mut self, begin: &str, value: &str) {
        let value = Printable(value).to_string();
        let indent = begin.chars().count();
        let room = self.width.map_or(usize::MAX, |width| width.saturating_sub(indent).max(NAMES));
        self.text.push_str(begin);
        let mut used: usize = 0;
        for word in value.split(' ') {
            let wide = word.chars().count();
            if used > 0 && used.saturating_add(1 + wide) > room {
                let _ = write!(self.text, "\n{:indent$}", "");
                used = 0;
            } else if used > 0 {
                self.text.push(' ');
                used += 1;
            }
            self.text.push_str(word);
            used += wide;
        }
        self.text.push('\n');
    }

    /// All of them.
    pub fn text(&self) -> &str {
        &self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::{Complex, row};

    row! {
        /// A row.
        pub struct Example {
            /// A name.
            pub name: String,
            /// Floats.
            pub values: Vec<f64>,
            /// Or nothing.
            pub reason: Option<String>,
        }
    }

    fn rows() -> Vec<Example> {
        let row = |name: &str, reason: Option<&str>| Example {
            name: name.into(),
            values: vec![1.0 / 3.0, -2e-17 / 3.0, 1e6 / 3.0],
            reason: reason.map(String::from),
        };
        vec![row("one", None), row("two", Some("it leaves"))]
    }

    #[test]
    fn floats_have_the_digits_asked_for_and_the_nearest_value() {
        for (x, digits, text) in [
            (1.0 / 3.0, Some(6), "0.333333"),
            (2e-17 / 3.0, Some(3), "6.67e-18"),
            (9.999_999, Some(6), "10.0"),
            (0.5, Some(6), "0.5"),
            (0.5, Some(0), "0.5"),
            (f64::MAX, Some(1), "1.7976931348623157e308"),
            (f64::NAN, Some(6), "NaN"),
            (-0.0, Some(6), "-0.0"),
            (1.0 / 3.0, None, "0.3333333333333333"),
        ] {
            assert_eq!(x.set(digits), text, "{x} {digits:?}");
        }
        assert_eq!(Complex(1.0 / 3.0, -2.0 / 3.0).set(Some(2)), "0.33 - 0.67i");
    }

    #[test]
    fn what_is_too_wide_becomes_blocks_and_loses_nothing() {
        let mut wide = Lines::new(Some(6), None);
        wide.table("rows", &rows());
        assert!(
            wide.text().lines().count() == 4 && wide.text().contains("one  0.333333, -6.66667e-18, 333333.0")
        );
        let mut narrow = Lines::new(Some(6), Some(40));
        narrow.table("rows", &rows());
        let expected = [
            "  rows",
            "     1  name    one",
            "        values  0.333333, -6.66667e-18,",
            "                333333.0",
            "     2  name    two",
            "        values  0.333333, -6.66667e-18,",
            "                333333.0",
            "        reason  it leaves",
            "",
        ];
        assert_eq!(narrow.text(), expected.join("\n"));
        let words = |lines: &Lines| lines.text().split_whitespace().filter(|word| word.len() > 7).count();
        assert_eq!(words(&wide), words(&narrow));
    }

    #[test]
    fn lines_are_broken_at_blanks_and_bounds_are_not_rounded() {
        let mut lines = Lines::new(Some(3), Some(36));
        lines.say("why", "it is too long for a line");
        lines.say("x", 1.0 / 3.0);
        lines.exact();
        lines.say("x", 1.0 / 3.0);
        let expected = [
            "  why              it is too long",
            "                   for a line",
            "  x                0.333",
            "  x                0.3333333333333333",
            "",
        ];
        assert_eq!(lines.text(), expected.join("\n"));
    }
}
