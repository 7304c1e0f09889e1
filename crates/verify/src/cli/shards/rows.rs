//! Tables in shards: the rows of each period are one record, from which the table is written as in one run.
//!
//! A row is a JSON array of its cells: a whole number, a fraction as [p, q], a text or null.

use std::io::Write;

use num_rational::Ratio;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::{
    error::{Error, Result},
    output::{ShardWriter, TableCell, TableWriter},
};

/// Where the rows of a table go.
pub(crate) trait RowSink {
    /// Takes a row, one cell for each column.
    ///
    /// # Errors
    /// An I/O error.
    fn row(&mut self, cells: &[TableCell]) -> Result<()>;

    /// Hears that these were all rows of a period.
    ///
    /// # Errors
    /// An I/O error.
    fn done(&mut self, _period: u64) -> Result<()> {
        Ok(())
    }
}

impl RowSink for TableWriter<'_> {
    fn row(&mut self, cells: &[TableCell]) -> Result<()> {
        TableWriter::row(self, cells)
    }
}

/// Rows as lines, their cells with a space between: a b-file.
pub(crate) struct PlainRows<'a>(pub &'a mut dyn Write);

impl RowSink for PlainRows<'_> {
    fn row(&mut self, cells: &[TableCell]) -> Result<()> {
        let text = |cell: &TableCell| match cell {
            TableCell::Int(value) => value.to_string(),
            TableCell::Fraction(x) => format!("{}/{}", x.numer(), x.denom()),
            TableCell::Text(text) | TableCell::Maths(text) => (*text).to_string(),
            TableCell::Empty => String::new(),
        };
        Ok(writeln!(self.0, "{}", cells.iter().map(text).collect::<Vec<_>>().join(" "))?)
    }
}

/// Rows as the records of a shard.
pub(crate) struct ShardRows<'a, 'b> {
    shard: &'a mut ShardWriter<'b>,
    rows: String,
}

impl<'a, 'b> ShardRows<'a, 'b> {
    pub fn new(shard: &'a mut ShardWriter<'b>) -> Self {
        ShardRows { shard, rows: String::new() }
    }
}

impl RowSink for ShardRows<'_, '_> {
    fn row(&mut self, cells: &[TableCell]) -> Result<()> {
        let value = |cell: &TableCell| match cell {
            TableCell::Int(value) => json!(value),
            TableCell::Fraction(x) => json!([x.numer(), x.denom()]),
            TableCell::Text(text) => json!(text),
            TableCell::Maths(text) => json!({ "maths": text }),
            TableCell::Empty => Value::Null,
        };
        self.rows += &Value::from(cells.iter().map(value).collect::<Vec<_>>()).to_string();
        Ok(())
    }

    fn done(&mut self, period: u64) -> Result<()> {
        self.shard.record(period, &self.rows)?;
        self.rows.clear();
        Ok(())
    }
}

/// A cell in a shard.
#[derive(Deserialize)]
#[serde(untagged)]
enum Cell {
    Int(i64),
    Fraction([u64; 2]),
    Text(String),
    Maths { maths: String },
    Empty,
}

/// Hands on the rows of a record, each of so many cells. Cost: its length in time, a row in memory.
///
/// # Errors
/// An input error if it is no record of such rows; whatever `each` returns.
pub(super) fn rows(
    record: &str,
    columns: usize,
    mut each: impl FnMut(&[TableCell]) -> Result<()>,
) -> Result<()> {
    for row in serde_json::Deserializer::from_str(record).into_iter::<Vec<Cell>>() {
        let row = row.map_err(|error| Error::input(format!("an item is not rows of a table: {error}")))?;
        let fractions: Vec<Ratio<u64>> = row
            .iter()
            .map(|cell| match cell {
                Cell::Fraction([p, q]) => Ratio::new_raw(*p, *q),
                _ => Ratio::new_raw(0, 1),
            })
            .collect();
        let cells: Vec<TableCell> = row
            .iter()
            .zip(&fractions)
            .map(|(cell, fraction)| match cell {
                Cell::Int(value) => TableCell::Int(*value),
                Cell::Fraction(_) => TableCell::Fraction(fraction),
                Cell::Text(text) => TableCell::Text(text),
                Cell::Maths { maths } => TableCell::Maths(maths),
                Cell::Empty => TableCell::Empty,
            })
            .collect();
        if cells.len() != columns {
            return Err(Error::input(format!(
                "a row has {} cells, where the table has {columns} columns",
                cells.len()
            )));
        }
        each(&cells)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_row_is_refused() {
        let seen = |record: &str| {
            let mut count = 0;
            rows(record, 2, |_| {
                count += 1;
                Ok(())
            })
            .map(|()| count)
        };
        assert_eq!(seen("").unwrap(), 0);
        assert_eq!(seen("[1,null][\"a\",[1,0]]").unwrap(), 2);
        for wrong in ["1", "[1]", "[1,2,3]", "[1,2", "[1,[1]]", "[1,1.5]", "[1,[-1,2]]", "{}", "[1,2]x"] {
            assert!(seen(wrong).unwrap_err().is_input(), "{wrong}");
        }
    }
}
