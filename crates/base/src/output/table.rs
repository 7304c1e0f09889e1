//! Tables of any length, written row by row in constant memory: what they consist of, their heads and ends.

use std::{borrow::Cow, io::Write};

use num_rational::Ratio;

use super::{
    Destination,
    row::{RowSetter, csv_header, json_string},
    say,
};
use crate::error::Result;

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableFormat {
    /// Aligned columns, for reading.
    Table,
    /// Comma-separated values with a header.
    Csv,
    /// One object with a format name and an array of rows.
    Json,
    /// A LaTeX longtable with booktabs rules.
    Latex,
    /// The same with the numbers in siunitx's \\num.
    LatexSiunitx,
    /// A Markdown table.
    Markdown,
}

impl TableFormat {
    /// Whether it is LaTeX: set for a page, with a caption.
    pub fn is_print(self) -> bool {
        matches!(self, TableFormat::Latex | TableFormat::LatexSiunitx)
    }
}

/// A column: its name and how it is set.
#[derive(Debug, Clone)]
pub struct Column {
    /// The name in CSV, JSON and plain tables.
    pub(crate) name: Cow<'static, str>,
    /// The heading in LaTeX.
    pub(crate) latex: Cow<'static, str>,
    /// The least width in a plain table.
    pub(crate) width: usize,
    /// How it is set in LaTeX.
    pub(crate) print: Print,
}

/// How a column is set in LaTeX.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Print {
    /// On one line, to the right: numbers.
    Right,
    /// On one line, to the left: a word.
    Left,
    /// In lines of this many per cent of the text width: sentences.
    Lines(u8),
    /// Not at all: data too wide for a page, which the other formats have.
    Omitted,
}

impl Column {
    /// A column at least `width` characters wide.
    pub fn new(name: &'static str, latex: &'static str, width: usize) -> Self {
        let (name, latex) = (Cow::Borrowed(name), Cow::Borrowed(latex));
        Column { width: width.max(name.len()), name, latex, print: Print::Right }
    }

    /// A column with a name that the program does not know beforehand.
    pub fn named(name: &str) -> Self {
        Column {
            name: Cow::Owned(name.to_string()),
            latex: Cow::Owned(name.to_string()),
            ..Column::new("", "", name.len())
        }
    }

    /// The same column, set in LaTeX as `print` says.
    pub fn print(self, print: Print) -> Self {
        Column { print, ..self }
    }
}

/// What stands above a LaTeX table, once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Caption {
    /// Text, in LaTeX.
    pub text: String,
    /// What `\ref` finds it by.
    pub label: String,
}

/// What a table stands in.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Setting<'a> {
    /// What is above it in LaTeX.
    pub caption: Option<&'a Caption>,
    /// The columns of the terminal that shows it. A plain table that is wider leaves out what print does:
    /// [`Print::Omitted`].
    pub width: Option<usize>,
}

impl Setting<'_> {
    /// That of a table at a destination, without a caption.
    pub fn at(destination: &Destination) -> Self {
        Setting { caption: None, width: destination.columns() }
    }
}

/// One entry of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableCell<'a> {
    /// A whole number.
    Int(i64),
    /// An exact fraction, written p/q even for integers.
    Fraction(&'a Ratio<u64>),
    /// Text.
    Text(&'a str),
    /// A formula in LaTeX's maths mode, which is text elsewhere.
    Maths(&'a str),
    /// Nothing.
    Empty,
}

/// Writes the rows of one table.
pub struct TableWriter<'a> {
    out: &'a mut dyn Write,
    setter: RowSetter,
    /// Whether there are rows.
    begun: bool,
    text: Vec<u8>,
}

impl<'a> TableWriter<'a> {
    /// Begins a table; `name` identifies its layout to machines (the `format` key in JSON).
    ///
    /// # Errors
    /// An I/O error from `out`.
    pub fn new(
        out: &'a mut dyn Write,
        format: TableFormat,
        name: &str,
        columns: Vec<Column>,
    ) -> Result<Self> {
        Self::set(out, format, name, columns, Setting::default())
    }

    /// The same in its setting. Columns that do not fit a terminal are said to be left out.
    ///
    /// # Errors
    /// An I/O error from `out`.
    pub fn set(
        out: &'a mut dyn Write,
        format: TableFormat,
        name: &str,
        columns: Vec<Column>,
        setting: Setting<'_>,
    ) -> Result<Self> {
        let names: Vec<&str> = columns.iter().map(|column| &*column.name).collect();
        let mut narrow = false;
        match format {
            TableFormat::Table => {
                let all: usize = columns.iter().map(|column| column.width + 2).sum();
                narrow = setting.width.is_some_and(|width| all > width + 2);
                let (omitted, shown): (Vec<&Column>, Vec<_>) =
                    columns.iter().partition(|column| narrow && column.print == Print::Omitted);
                if !omitted.is_empty() {
                    let names: Vec<&str> = omitted.iter().map(|column| &*column.name).collect();
                    say(format_args!(
                        "note: the terminal is too narrow for {}; --format csv and -o FILE have them",
                        names.join(", ")
                    ));
                }
                let heads = shown.iter().map(|column| format!("{:>1$}", column.name, column.width));
                writeln!(out, "{}", heads.collect::<Vec<_>>().join("  "))?;
            }
            TableFormat::Csv => {
                let mut header = Vec::new();
                csv_header(&mut header, &names);
                out.write_all(&header)?;
            }
            TableFormat::Json => writeln!(out, "{{\"format\":{},\"rows\":[", json_string(name))?,
            TableFormat::Latex | TableFormat::LatexSiunitx => {
                let (printed, omitted): (Vec<&Column>, Vec<_>) =
                    columns.iter().partition(|column| column.print != Print::Omitted);
                let heads: Vec<&str> = printed.iter().map(|column| &*column.latex).collect();
                let shape = printed.iter().map(|column| match column.print {
                    Print::Right | Print::Omitted => "r".into(),
                    Print::Left => "l".into(),
                    Print::Lines(share) => {
                        format!(">{{\\raggedright\\arraybackslash}}p{{0.{share:02}\\linewidth}}")
                    }
                });
                let siunitx = if format == TableFormat::LatexSiunitx { ",siunitx" } else { "" };
                writeln!(
                    out,
                    "% {name}: \\input this file after \\usepackage{{amsmath,array,booktabs,longtable{siunitx}}}"
                )?;
                if !omitted.is_empty() {
                    let names: Vec<&str> = omitted.iter().map(|column| &*column.name).collect();
                    writeln!(out, "% Columns that only CSV, JSON and Markdown have: {}", names.join(", "))?;
                }
                // Wide tables in smaller type, closer together, so that they fit a page of A4.
                let (size, gap) = match heads.len() {
                    0..=5 => ("", 6),
                    6 => ("\\small", 4),
                    _ => ("\\footnotesize", 3),
                };
                let wide = setting.caption.map_or("", |_| "\\setlength{\\LTcapwidth}{\\linewidth}");
                writeln!(out, "{{{size}\\setlength{{\\tabcolsep}}{{{gap}pt}}{wide}")?;
                writeln!(out, "\\begin{{longtable}}{{{}}}", shape.collect::<String>())?;
                let head = format!("\\toprule\n{} \\\\\n\\midrule", heads.join(" & "));
                if let Some(Caption { text, label }) = setting.caption {
                    writeln!(out, "\\caption{{{text}}}\\label{{{label}}} \\\\\n{head}\n\\endfirsthead")?;
                }
                writeln!(out, "{head}\n\\endhead")?;
                writeln!(out, "\\bottomrule\n\\endfoot")?;
            }
            TableFormat::Markdown => {
                writeln!(out, "| {} |", names.join(" | "))?;
                writeln!(out, "|{}", " ---: |".repeat(columns.len()))?;
            }
        }
        let setter = RowSetter { format, columns, narrow };
        Ok(TableWriter { out, setter, begun: false, text: Vec::new() })
    }

    /// Writes a row, one cell for each column.
    ///
    /// # Errors
    /// An I/O error from the stream.
    pub fn row(&mut self, cells: &[TableCell]) -> Result<()> {
        let mut text = std::mem::take(&mut self.text);
        text.clear();
        self.setter.set(&mut text, cells);
        let written = self.rows_set(&text);
        self.text = text;
        written
    }

    /// What sets rows for [`rows_set`](Self::rows_set), in any thread.
    pub fn setter(&self) -> RowSetter {
        self.setter.clone()
    }

    /// Writes rows as [`setter`](Self::setter) has set them, from an empty buffer on.
    ///
    /// # Errors
    /// An I/O error from the stream.
    pub fn rows_set(&mut self, rows: &[u8]) -> Result<()> {
        if rows.is_empty() {
            return Ok(());
        }
        if self.begun && self.setter.format == TableFormat::Json {
            self.out.write_all(b",\n")?;
        }
        self.begun = true;
        Ok(self.out.write_all(rows)?)
    }

    /// Ends the table after its rows, or after those there are if an interruption ended them: JSON is closed
    /// and says so.
    ///
    /// # Errors
    /// That of the rows; an I/O error from the stream.
    pub fn end(self, rows: Result<()>) -> Result<()> {
        match rows {
            Ok(()) => self.finish(),
            Err(error) => {
                if error.is_interrupted() {
                    match self.setter.format {
                        TableFormat::Json => writeln!(self.out, "\n],\"verdict\":\"interrupted\"}}")?,
                        TableFormat::Latex | TableFormat::LatexSiunitx => {
                            writeln!(self.out, "\\end{{longtable}}}}\n% interrupted: rows are missing")?;
                        }
                        TableFormat::Table | TableFormat::Csv | TableFormat::Markdown => {}
                    }
                }
                Err(error)
            }
        }
    }

    /// Ends the table.
    ///
    /// # Errors
    /// An I/O error from the stream.
    pub fn finish(self) -> Result<()> {
        match self.setter.format {
            TableFormat::Json => writeln!(self.out, "\n]}}")?,
            TableFormat::Latex | TableFormat::LatexSiunitx => writeln!(self.out, "\\end{{longtable}}}}")?,
            TableFormat::Table | TableFormat::Csv | TableFormat::Markdown => {}
        }
        Ok(())
    }
}

/// `x` rounded to `digits` decimals, a tie to the even digit. The result is a rounded value, not an
/// enclosure: label it so. Cost: one division per digit. Precondition: the denominator is below 2⁶⁰.
///
pub fn decimal(x: &Ratio<u64>, digits: usize) -> String {
    let q = *x.denom();
    let mut rest = x.numer() % q;
    let mut all: Vec<u8> = (x.numer() / q).to_string().bytes().collect();
    let whole = all.len();
    for _ in 0..digits {
        rest *= 10;
        all.push(b'0' + (rest / q) as u8);
        rest %= q;
    }
    let odd = all.last().is_some_and(|digit| digit % 2 == 1);
    let carry = 2 * rest > q || (2 * rest == q && odd);
    let mut whole = whole;
    if carry {
        let nines = all.iter().rev().take_while(|&&digit| digit == b'9').count();
        let start = all.len() - nines;
        all[start..].fill(b'0');
        match start.checked_sub(1) {
            Some(last) => all[last] += 1,
            None => {
                all.insert(0, b'1');
                whole += 1;
            }
        }
    }
    let text: String = all.into_iter().map(char::from).collect();
    if digits == 0 { text } else { format!("{}.{}", &text[..whole], &text[whole..]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_terminal_that_is_too_narrow_has_what_print_has() {
        let written = |width| {
            let columns = vec![
                Column::new("n", "$n$", 3),
                Column::new("wide", "wide", 10).print(Print::Omitted),
                Column::new("last", "last", 0),
            ];
            let mut out = Vec::new();
            let setting = Setting { width, ..Setting::default() };
            let mut table = TableWriter::set(&mut out, TableFormat::Table, "", columns, setting).unwrap();
            table.row(&[TableCell::Int(1), TableCell::Text("x"), TableCell::Int(2)]).unwrap();
            table.finish().unwrap();
            String::from_utf8(out).unwrap()
        };
        let whole = "  n        wide  last\n  1           x     2\n";
        assert_eq!([written(None), written(Some(21))], [whole; 2]);
        assert_eq!(written(Some(20)), "  n  last\n  1     2\n");
    }

    #[test]
    fn a_tie_goes_to_the_even_digit_and_nines_carry() {
        for (p, q, digits, text) in
            [(1, 8, 2, "0.12"), (3, 8, 2, "0.38"), (2, 3, 4, "0.6667"), (999, 1000, 2, "1.00")]
        {
            assert_eq!(decimal(&Ratio::new(p, q), digits), text);
        }
    }
}
