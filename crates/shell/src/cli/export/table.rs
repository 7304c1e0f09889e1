//! A table as columns of numbers, of lists of numbers, or of texts.

use crate::error::{Error, Result};

/// A number: its real and its imaginary part.
pub(super) type Complex = (f64, f64);

/// What a column holds.
pub(super) enum Values {
    /// So many numbers in each row, NaN where the row has fewer.
    Numbers { width: usize, rows: Vec<Vec<Complex>> },
    /// Texts.
    Texts(Vec<String>),
}

/// A column.
pub(super) struct Column {
    pub name: String,
    pub values: Values,
}

/// A table with its columns.
pub(super) struct Table {
    pub columns: Vec<Column>,
    pub rows: usize,
}

/// Columns that are texts, even where all of them look like numbers.
const TEXTS: [&str; 2] = ["pattern", "label"];

impl Table {
    /// Reads a CSV file with a row of names.
    ///
    /// # Errors
    /// An input error for what is no such file.
    pub fn read(text: &str, file: &str) -> Result<Table> {
        let wrong = |error: csv::Error| Error::input(format!("{file}: {error}"));
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names: Vec<String> = reader.headers().map_err(wrong)?.iter().map(String::from).collect();
        if names.iter().all(|name| name.trim().is_empty()) {
            return Err(Error::input(format!("{file}: no table: its first line names no column")));
        }
        if let Some((i, name)) = names.iter().enumerate().find(|(i, name)| names[..*i].contains(name)) {
            let message =
                format!("{file}:1: two columns are called {name:?}, the second is column {}", i + 1);
            return Err(Error::input(message));
        }
        let mut cells: Vec<Vec<String>> = names.iter().map(|_| Vec::new()).collect();
        for record in reader.records() {
            for (column, cell) in cells.iter_mut().zip(&record.map_err(wrong)?) {
                column.push(cell.to_string());
            }
        }
        let rows = cells.first().map_or(0, Vec::len);
        let columns = names
            .into_iter()
            .zip(cells)
            .map(|(name, cells)| Column { values: Values::of(&name, cells), name });
        Ok(Table { columns: columns.collect(), rows })
    }

    /// The column of a name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }
}

impl Values {
    fn of(name: &str, cells: Vec<String>) -> Values {
        let lists: Option<Vec<Vec<Complex>>> = match TEXTS.contains(&name) {
            true => None,
            false => cells.iter().map(|cell| numbers(cell)).collect(),
        };
        let Some(mut rows) = lists else { return Values::Texts(cells) };
        let width = rows.iter().map(Vec::len).max().unwrap_or(0).max(1);
        rows.iter_mut().for_each(|row| row.resize(width, (f64::NAN, 0.0)));
        Values::Numbers { width, rows }
    }
}

impl Column {
    /// Whether a number has an imaginary part.
    pub fn is_complex(&self) -> bool {
        let Values::Numbers { rows, .. } = &self.values else { return false };
        rows.iter().flatten().any(|&(_, im)| im != 0.0)
    }

    /// The text of a row, empty where it is a number.
    pub fn text(&self, row: usize) -> &str {
        match &self.values {
            Values::Texts(all) => &all[row],
            Values::Numbers { .. } => "",
        }
    }
}

/// The numbers of a cell, as a report sets them: `0.5, 1e-3 - 2.0i`; none if it is something else.
fn numbers(cell: &str) -> Option<Vec<Complex>> {
    if cell.is_empty() {
        return Some(Vec::new());
    }
    let number = |text: &str| match text.strip_suffix('i') {
        None => Some((text.parse().ok()?, 0.0)),
        Some(complex) => {
            let (re, im, sign) = match complex.split_once(" - ") {
                Some((re, im)) => (re, im, -1.0),
                None => complex.split_once(" + ").map(|(re, im)| (re, im, 1.0))?,
            };
            Some((re.parse().ok()?, sign * im.parse::<f64>().ok()?))
        }
    };
    cell.split(", ").map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_numbers_lists_or_texts() {
        let text = "t,speeds,multipliers,stable,pattern\n0.5,\"1.0, 2e-3\",\"1.0 + 2.0i, 1.0 - 2.0i\",yes,4\n,,,no,3\n";
        let table = Table::read(text, "x.csv").unwrap();
        assert_eq!(table.rows, 2);
        let of = |name| match &table.column(name).unwrap().values {
            Values::Numbers { width, rows } => (*width, rows.clone()),
            Values::Texts(_) => panic!("{name}"),
        };
        assert_eq!(of("multipliers").1[0], [(1.0, 2.0), (1.0, -2.0)]);
        let (width, speeds) = of("speeds");
        assert!(width == 2 && speeds[0] == [(1.0, 0.0), (0.002, 0.0)] && speeds[1][0].0.is_nan());
        assert!(of("t").1[1][0].0.is_nan());
        for (name, first) in [("stable", "yes"), ("pattern", "4")] {
            assert_eq!(table.column(name).unwrap().text(0), first);
        }
        for wrong in ["", "\n\n", "a,b\n1\n"] {
            assert!(Table::read(wrong, "x.csv").is_err(), "{wrong:?}");
        }
    }
}
