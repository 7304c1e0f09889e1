//! Matrices and vectors of a scene: written out, or read from CSV and MatrixMarket files.

use super::{
    expression::Expression,
    keys::{Entry, Value},
};
use crate::error::Result;

/// The nonzero entries of a matrix.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MatrixValue {
    /// How many rows.
    pub rows: usize,
    /// How many columns.
    pub columns: usize,
    /// Row, column and value; a place stands once.
    pub entries: Vec<(usize, usize, Expression)>,
}

/// One number for each coordinate; a single one may stand without brackets.
#[derive(Debug, Clone, PartialEq)]
pub struct CoordinateList {
    /// The numbers.
    pub(crate) entries: Vec<Expression>,
}

/// Most rows or columns.
const MOST: usize = 2000;
/// The longest file of a matrix, in bytes.
const LONGEST: u64 = 256 << 20;

impl CoordinateList {
    /// The entries for so many coordinates; none at all for a single 0.
    pub(super) fn fit(self, place: &Entry, size: usize) -> Result<Vec<Expression>> {
        if self.entries.iter().all(Expression::is_zero) && self.entries.len() <= 1 {
            return Ok(Vec::new());
        }
        if self.entries.len() != size {
            let found = self.entries.len();
            let plural = if size == 1 { "" } else { "s" };
            return Err(
                place.fail(&format!("has {found} entries; the machine has {size} coordinate{plural}"))
            );
        }
        Ok(self.entries)
    }
}

impl Value for CoordinateList {
    fn shape() -> String {
        "expression, or for several coordinates a list of them".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let entries = if entry.item.is_array() {
            entry.elements()?.iter().map(Expression::read).collect::<Result<_>>()?
        } else {
            vec![Expression::read(entry)?]
        };
        Ok(CoordinateList { entries })
    }
}

impl MatrixValue {
    /// A matrix of one entry.
    pub(super) fn single(text: &str) -> Result<Self> {
        Ok(MatrixValue { rows: 1, columns: 1, entries: vec![(0, 0, Expression::parse(text, &[])?)] })
    }

    /// The size of a square matrix, which is `size` if that is known.
    pub(super) fn square(&self, place: &Entry, size: Option<usize>) -> Result<usize> {
        let (rows, columns) = (self.rows, self.columns);
        if rows != columns {
            return Err(place.fail(&format!("has {rows} rows and {columns} columns; it must be square")));
        }
        if let Some(size) = size.filter(|&size| size != rows) {
            return Err(place.fail(&format!("has {rows} rows; mass has {size}: the sizes must fit")));
        }
        Ok(rows)
    }

    fn written(entry: &Entry) -> Result<Self> {
        let rows = entry.elements()?;
        let mut all = MatrixValue { rows: rows.len(), columns: 0, entries: Vec::new() };
        for (i, row) in rows.iter().enumerate() {
            let cells = row.elements().map_err(|_| row.fail("is not a row [ … ] of a matrix"))?;
            if i > 0 && cells.len() != all.columns {
                let (found, first) = (cells.len(), all.columns);
                return Err(row.fail(&format!("has {found} entries; the first row has {first}")));
            }
            all.columns = cells.len();
            for (j, cell) in cells.iter().enumerate() {
                let value = Expression::read(cell)?;
                if !value.is_zero() {
                    all.entries.push((i, j, value));
                }
            }
        }
        Ok(all)
    }

    /// A file beside the scene: MatrixMarket if it begins with `%%MatrixMarket`, else CSV.
    fn file(entry: &Entry) -> Result<Self> {
        let name = entry.text()?;
        let (beside, text) = entry.beside(name, LONGEST)?;
        let read = if text.starts_with("%%MatrixMarket") { market(&text) } else { table(&text) };
        let matrix =
            read.map_err(|(line, message)| entry.fail(&format!("{}:{line}: {message}", beside.display())))?;
        let number = |(i, j, text): (usize, usize, String)| {
            let value = Expression::parse(&text, &[])
                .map_err(|error| entry.fail(&format!("{}: {text}: {error}", beside.display())))?;
            Ok((i, j, value))
        };
        let entries = matrix.entries.into_iter().map(number).collect::<Result<Vec<_>>>()?;
        let entries = entries.into_iter().filter(|known| !known.2.is_zero()).collect();
        Ok(MatrixValue { rows: matrix.rows, columns: matrix.columns, entries })
    }
}

impl Value for MatrixValue {
    fn shape() -> String {
        "list of rows, each a list of expressions; one expression for a single coordinate; `{ diagonal = [ … ] }`; \
         or `{ file = \"…\" }`, a CSV or MatrixMarket file beside the scene"
            .to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let matrix = if entry.item.is_table_like() {
            entry.only(&["file", "diagonal"])?;
            match (entry.get("file")?, entry.get("diagonal")?) {
                (Some(file), None) => MatrixValue::file(&file)?,
                (None, Some(diagonal)) => {
                    let all =
                        diagonal.elements()?.iter().map(Expression::read).collect::<Result<Vec<_>>>()?;
                    let size = all.len();
                    let entries = all.into_iter().enumerate().map(|(i, value)| (i, i, value)).collect();
                    MatrixValue { rows: size, columns: size, entries }
                }
                _ => return Err(entry.fail("takes either `file` or `diagonal`")),
            }
        } else if entry.item.is_array() {
            MatrixValue::written(entry)?
        } else {
            MatrixValue { rows: 1, columns: 1, entries: vec![(0, 0, Expression::read(entry)?)] }
        };
        if !(1..=MOST).contains(&matrix.rows) || !(1..=MOST).contains(&matrix.columns) {
            let (rows, columns) = (matrix.rows, matrix.columns);
            return Err(
                entry.fail(&format!("has {rows} rows and {columns} columns; 1 to {MOST} are allowed"))
            );
        }
        Ok(matrix)
    }
}

/// A matrix as it stands in a file, numbers as text.
struct Read {
    rows: usize,
    columns: usize,
    entries: Vec<(usize, usize, String)>,
}

/// What is wrong and in which line.
type Wrong = (usize, String);

/// Numbers, in lines, apart by commas, semicolons, spaces or tabs; `#` begins a comment.
fn table(text: &str) -> std::result::Result<Read, Wrong> {
    let mut read = Read { rows: 0, columns: 0, entries: Vec::new() };
    for (line, content) in (1..).zip(text.lines()) {
        let content = content.split('#').next().unwrap_or_default().trim();
        if content.is_empty() {
            continue;
        }
        let apart = |c: char| c == ',' || c == ';' || (!content.contains([',', ';']) && c.is_whitespace());
        let cells: Vec<&str> = if content.contains([',', ';']) {
            content.split(apart).map(str::trim).collect()
        } else {
            content.split_whitespace().collect()
        };
        if read.rows > 0 && cells.len() != read.columns {
            return Err((line, format!("has {} numbers; the first row has {}", cells.len(), read.columns)));
        }
        if cells.len() > MOST || read.rows >= MOST {
            return Err((line, format!("more than {MOST} rows or columns")));
        }
        for (j, cell) in cells.iter().enumerate() {
            read.entries.push((read.rows, j, number(cell, line)?));
        }
        (read.rows, read.columns) = (read.rows + 1, cells.len());
    }
    if read.rows == 0 {
        return Err((1, "holds no numbers".to_string()));
    }
    Ok(read)
}

/// The text of a number.
fn number(text: &str, line: usize) -> std::result::Result<String, Wrong> {
    let finite = text.parse::<f64>().is_ok_and(f64::is_finite);
    if finite && text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
        return Ok(text.trim_start_matches('+').to_string());
    }
    Err((line, format!("{text:?} is not a number: this is a file of numbers only, or a MatrixMarket file")))
}

/// What the first lines of a MatrixMarket file say.
struct Market<'t> {
    layout: &'t str,
    symmetry: &'t str,
    rows: usize,
    columns: usize,
    /// How many entries follow, with their places; without it all of them follow, by columns.
    count: Option<usize>,
}

/// MatrixMarket: array or coordinate, real or integer, general, symmetric or skew-symmetric.
fn market(text: &str) -> std::result::Result<Read, Wrong> {
    let head = text.lines().next().unwrap_or_default().to_lowercase();
    let (layout, symmetry) = market_kind(&head)?;
    let mut lines = (1..).zip(text.lines()).skip(1).filter(|(_, line)| {
        let line = line.trim();
        !line.is_empty() && !line.starts_with('%')
    });
    let (line, sizes) = lines.next().ok_or((1, "has no line of sizes".to_string()))?;
    let market = Market::of(layout, symmetry, line, sizes)?;
    let places = market.places();
    let expected = market.count.unwrap_or(places.len());
    let mut read = Read { rows: market.rows, columns: market.columns, entries: Vec::new() };
    let mut seen = std::collections::BTreeSet::new();
    let (mut found, mut last) = (0, line);
    for (line, content) in lines {
        last = line;
        let (i, j, text) = if market.count.is_none() && found == expected {
            let words = content.split_whitespace().count();
            let wrong = || format!("more than the {expected} entries expected");
            return Err((line, if words == 1 { wrong() } else { market.wrong_words(words) }));
        } else {
            market.entry(line, content, places.get(found).copied())?
        };
        if !seen.insert((i, j)) {
            return Err((line, format!("row {}, column {} stands here twice", i + 1, j + 1)));
        }
        if (symmetry == "symmetric" && i < j) || (symmetry == "skew-symmetric" && i <= j) {
            let (row, column) = (i + 1, j + 1);
            let why =
                format!("row {row}, column {column}: a {symmetry} file holds what is below the diagonal");
            return Err((line, why));
        }
        let value = number(text, line)?;
        if i != j && symmetry == "symmetric" {
            read.entries.push((j, i, value.clone()));
        } else if symmetry == "skew-symmetric" {
            let turned = value.strip_prefix('-').map_or(format!("-{value}"), str::to_string);
            read.entries.push((j, i, turned));
        }
        read.entries.push((i, j, value));
        found += 1;
    }
    if found != expected {
        return Err((last, format!("ends after {found} of {expected} entries")));
    }
    Ok(read)
}

/// Layout and symmetry of a first line in lower case.
fn market_kind(head: &str) -> std::result::Result<(&str, &str), Wrong> {
    let words: Vec<&str> = head.split_whitespace().collect();
    let [_, "matrix", layout, field, symmetry] = words[..] else {
        return Err((
            1,
            "the first line must read %%MatrixMarket matrix array|coordinate real general|symmetric".into(),
        ));
    };
    if !["array", "coordinate"].contains(&layout) {
        return Err((1, format!("{layout:?}: a matrix is of layout array or coordinate")));
    }
    if !["real", "integer", "double"].contains(&field) {
        return Err((1, format!("{field:?}: entries must be real")));
    }
    if !["general", "symmetric", "skew-symmetric"].contains(&symmetry) {
        return Err((1, format!("{symmetry:?}: a matrix must be general, symmetric or skew-symmetric")));
    }
    Ok((layout, symmetry))
}

impl<'t> Market<'t> {
    /// With the line of sizes.
    fn of(
        layout: &'t str,
        symmetry: &'t str,
        line: usize,
        sizes: &str,
    ) -> std::result::Result<Market<'t>, Wrong> {
        let sizes: Vec<usize> = sizes
            .split_whitespace()
            .map(|word| word.parse().map_err(|_| (line, format!("{word:?} is not a size"))))
            .collect::<std::result::Result<_, _>>()?;
        let (rows, columns, count) = match (layout, &sizes[..]) {
            ("array", &[rows, columns]) => (rows, columns, None),
            ("coordinate", &[rows, columns, count]) => (rows, columns, Some(count)),
            _ => {
                let takes = if layout == "array" { 2 } else { 3 };
                return Err((line, format!("has {} sizes; {layout} takes {takes}", sizes.len())));
            }
        };
        if rows > MOST || columns > MOST {
            return Err((line, format!("{rows} × {columns}: at most {MOST} rows and columns are allowed")));
        }
        if symmetry != "general" && rows != columns {
            return Err((line, format!("is {symmetry} and has {rows} rows and {columns} columns")));
        }
        Ok(Market { layout, symmetry, rows, columns, count })
    }

    /// The places of the entries that follow by columns.
    fn places(&self) -> Vec<(usize, usize)> {
        if self.count.is_some() {
            return Vec::new();
        }
        let first = |j: usize| match self.symmetry {
            "general" => 0,
            "symmetric" => j,
            _ => j + 1,
        };
        (0..self.columns).flat_map(|j| (first(j)..self.rows).map(move |i| (i, j))).collect()
    }

    /// The place and the text of an entry; `next` is the place of the next one by columns.
    fn entry<'l>(
        &self,
        line: usize,
        content: &'l str,
        next: Option<(usize, usize)>,
    ) -> std::result::Result<(usize, usize, &'l str), Wrong> {
        let index = |word: &str, most: usize| {
            let place = word.parse().ok().filter(|place| (1..=most).contains(place));
            let wrong = || (line, format!("{word:?} is not an index from 1 to {most}"));
            place.map(|place: usize| place - 1).ok_or_else(wrong)
        };
        let words: Vec<&str> = content.split_whitespace().collect();
        match (next, &words[..]) {
            (Some((i, j)), &[text]) if self.count.is_none() => Ok((i, j, text)),
            (_, &[i, j, text]) if self.count.is_some() => {
                Ok((index(i, self.rows)?, index(j, self.columns)?, text))
            }
            _ => Err((line, self.wrong_words(words.len()))),
        }
    }

    fn wrong_words(&self, words: usize) -> String {
        let takes = if self.count.is_none() { 1 } else { 3 };
        format!("has {words} words; {} takes {takes}", self.layout)
    }
}
