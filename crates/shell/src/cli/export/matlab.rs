//! MAT-files of level 4: for each matrix five numbers of 32 bits, its name, its numbers column by column,
//! first the real parts. MATLAB, Octave and SciPy read them; MATLAB's documents have the form ("MAT-File
//! Format", "Level 4").

use super::table::{Column, Table, Values};
use crate::error::{Error, Result};

/// Names that are words of the language.
const WORDS: [&str; 5] = ["end", "for", "if", "while", "function"];

/// A name that MATLAB takes: letters, digits and underscores, a letter first, at most 63.
fn variable(name: &str) -> String {
    let mut name: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).take(60).collect();
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        name.insert(0, 'x');
    }
    if WORDS.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// The table: a matrix for each column, a row for each of its rows; texts are matrices of letters.
///
/// # Errors
/// An input error if it is too long for the form.
pub(super) fn write(table: &Table) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    for column in &table.columns {
        matrix(column, table.rows, &mut bytes)?;
    }
    Ok(bytes)
}

fn matrix(column: &Column, rows: usize, bytes: &mut Vec<u8>) -> Result<()> {
    let complex = column.is_complex();
    let letters: Vec<Vec<char>> = match &column.values {
        Values::Texts(all) => all.iter().map(|text| text.chars().collect()).collect(),
        Values::Numbers { .. } => Vec::new(),
    };
    let (text, width) = match &column.values {
        Values::Texts(_) => (1, letters.iter().map(Vec::len).max().unwrap_or(0).max(1)),
        Values::Numbers { width, .. } => (0, *width),
    };
    let name = variable(&column.name);
    let size = |x: usize| i32::try_from(x).map_err(|_| Error::input("too long for a MAT-file of level 4"));
    for number in [text, size(rows)?, size(width)?, i32::from(complex), size(name.len() + 1)?] {
        bytes.extend(number.to_le_bytes());
    }
    bytes.extend(name.bytes().chain([0]));
    for part in 0..=usize::from(complex) {
        for at in 0..width {
            for row in 0..rows {
                let number = match &column.values {
                    Values::Texts(_) => f64::from(u32::from(*letters[row].get(at).unwrap_or(&' '))),
                    Values::Numbers { rows, .. } => [rows[row][at].0, rows[row][at].1][part],
                };
                bytes.extend(number.to_le_bytes());
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_variables() {
        for (name, shown) in [("q", "q"), ("2nd", "x2nd"), ("a b", "a_b"), ("end", "end_"), ("", "x")] {
            assert_eq!(variable(name), shown);
        }
    }

    /// Byte by byte as the form has it.
    #[test]
    fn a_matrix_is_its_header_its_name_and_its_columns() {
        let table = Table::read("m,s\n\"1.0, 2.0\",ab\n\"3.0, 1.0 - 4.0i\",c\n", "x.csv").unwrap();
        let bytes = write(&table).unwrap();
        let ints = |numbers: [i32; 5]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
        let floats = |numbers: &[f64]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
        let m = [ints([0, 2, 2, 1, 2]), b"m\0".to_vec(), floats(&[1.0, 3.0, 2.0, 1.0, 0.0, 0.0, 0.0, -4.0])];
        let s = [ints([1, 2, 2, 0, 2]), b"s\0".to_vec(), floats(&[97.0, 99.0, 98.0, 32.0])];
        assert_eq!(bytes, [m.concat(), s.concat()].concat());
    }
}
