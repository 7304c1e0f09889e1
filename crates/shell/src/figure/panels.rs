//! Pictures of time against accuracy in panels, drawn from the tables that a folder has: ours, and beside it
//! that of other programs.

use std::{collections::HashMap, io::Write, path::Path};

use super::{
    canvas::{Anchor, At, COLUMN, Canvas, Colour, Words, line},
    frame::PlotFrame,
    labels::{Labels, TextAt},
};
use crate::{
    error::{Error, Result},
    output::{Column, TableCell, TableFormat, TableWriter},
    study::computer::{PROGRAM, machine},
};

/// The width of a picture: one and a half of a journal's columns, still legible on a phone.
pub const WIDTH: f64 = 1.5 * COLUMN;
/// Panels beside one another, and the height of one.
pub const ACROSS: usize = 2;
pub const HIGH: f64 = 128.0;
/// The size of labels and captions.
pub const SMALL: f64 = 6.5;

/// A row of a table, by the names of its columns.
pub struct PanelRow(HashMap<String, String>);

/// The rows of a table of a folder and, if it is there, of another.
///
/// # Errors
/// An I/O error, or an input error if it is no CSV; both name the file.
pub fn rows(folder: &Path, table: &str, beside: &str) -> Result<Vec<PanelRow>> {
    let mut all = Vec::new();
    let files = [folder.join(table), folder.join(beside)];
    for file in files.iter().take(if files[1].exists() { 2 } else { 1 }) {
        let fail = |error: csv::Error| Error::input(format!("{}: {error}", file.display()));
        let mut reader = csv::Reader::from_path(file).map_err(fail)?;
        for row in reader.deserialize() {
            all.push(PanelRow(row.map_err(fail)?));
        }
    }
    Ok(all)
}

impl PanelRow {
    /// A cell; empty if the table has no such column.
    pub fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", String::as_str)
    }

    /// A cell that is a number.
    pub fn number(&self, column: &str) -> Option<f64> {
        self.text(column).parse().ok().filter(|x: &f64| x.is_finite())
    }

    /// `time_ns` with its quartiles; 1 where there is none.
    pub fn times(&self) -> [f64; 3] {
        ["time_ns", "q25", "q75"].map(|column| self.number(column).unwrap_or(1.0).max(1.0))
    }
}

/// Writes such a table. As CSV its rows end with the program and the machine; on a terminal these would only
/// fill it.
pub struct PriceTable<'a> {
    table: TableWriter<'a>,
    machine: Option<String>,
}

impl<'a> PriceTable<'a> {
    /// Errors: an I/O error from `out`.
    pub fn new(
        out: &'a mut dyn Write,
        format: TableFormat,
        schema: &str,
        names: &[&'static str],
    ) -> Result<PriceTable<'a>> {
        let machine = (format == TableFormat::Csv).then(machine);
        let mut columns: Vec<Column> =
            names.iter().map(|&name| Column::new(name, name, name.len())).collect();
        if machine.is_some() {
            columns.extend(["by", "machine"].map(|name| Column::new(name, name, 0)));
        }
        Ok(PriceTable { table: TableWriter::new(out, format, schema, columns)?, machine })
    }

    /// Errors: an I/O error from `out`.
    pub fn row(&mut self, cells: &[TableCell]) -> Result<()> {
        let Some(machine) = &self.machine else { return self.table.row(cells) };
        self.table.row(&[cells, &[TableCell::Text(PROGRAM), TableCell::Text(machine)]].concat())
    }

    /// Errors: an I/O error from `out`.
    pub fn finish(self) -> Result<()> {
        self.table.finish()
    }
}

/// The values of a column, each once, in the order in which they come.
pub fn values<'a>(rows: &'a [PanelRow], column: &str) -> Vec<&'a str> {
    named(rows.iter(), column)
}

fn named<'a>(rows: impl Iterator<Item = &'a PanelRow>, column: &str) -> Vec<&'a str> {
    let mut seen = Vec::new();
    for value in rows.map(|row| row.text(column)) {
        if !value.is_empty() && !seen.contains(&value) {
            seen.push(value);
        }
    }
    seen
}

/// The corner of a panel.
pub fn corner(place: usize) -> At {
    ((place % ACROSS) as f64 * WIDTH / ACROSS as f64, 4.0 + (place / ACROSS) as f64 * HIGH)
}

/// What stands below the panels, in lines that fit: what was done, then programs, machine and load.
pub fn caption<'a>(rows: impl Iterator<Item = &'a PanelRow> + Clone, what: &str) -> Vec<Words> {
    let loads = rows.clone().filter_map(|row| row.number("load"));
    let (low, high) = loads.fold((f64::INFINITY, 0.0f64), |(low, high), x| (low.min(x), high.max(x)));
    let load = if low <= high { format!(" Load {low:.1} to {high:.1}.") } else { String::new() };
    let (programs, machines) = (named(rows.clone(), "by").join("; "), named(rows, "machine").join("; "));
    let mut lines: Vec<Words> = Vec::new();
    for text in [what.to_string(), format!("{programs}. {machines}.{load}")] {
        let mut current = String::new();
        for word in text.split(' ') {
            let longer = if current.is_empty() { word.to_string() } else { format!("{current} {word}") };
            if Words::plain(&longer).width(SMALL) > 0.96 * WIDTH {
                lines.push(Words::plain(&current));
                current = word.to_string();
            } else {
                current = longer;
            }
        }
        lines.push(Words::plain(&current));
    }
    lines
}

/// The height of a caption.
pub fn caption_height(lines: &[Words]) -> f64 {
    (SMALL + 2.0) * lines.len() as f64 + 4.0
}

/// Draws it from a height on.
pub fn draw_caption(canvas: &mut Canvas, lines: Vec<Words>, top: f64) {
    for (place, words) in lines.into_iter().enumerate() {
        let y = top + (SMALL + 2.0) * (place as f64 + 0.5);
        canvas.sized(words, (4.0, y), Anchor::Start, SMALL);
    }
}

/// The range of all times as logarithms, with some room, and marks at powers of ten inside.
pub fn time_range(rows: &[PanelRow]) -> ((f64, f64), Vec<(f64, Words)>) {
    let times = rows.iter().flat_map(|row| row.times()).map(f64::log10);
    let (low, top) = times.fold((9.0f64, 1.0f64), |(low, top), t| (low.min(t), top.max(t)));
    let (low, top) = (low - 0.9, top + 0.9);
    let inside = low.ceil() as i32..=top.floor() as i32;
    let step = if inside.clone().count() > 6 { 2 } else { 1 };
    let marks = inside.step_by(step).map(|e| (f64::from(e), Words::plain(&duration(e)))).collect();
    ((low, top), marks)
}

/// A bar from the lower to the upper quartile of the time.
pub fn whisker(canvas: &mut Canvas, frame: &PlotFrame, x: f64, [_, low, high]: [f64; 3], ink: Colour) {
    canvas.line(frame.path([(x, low), (x, high)]), line(ink, 1.6));
}

/// A time in words, from its logarithm in nanoseconds.
pub fn duration(exponent: i32) -> String {
    let (value, unit) = match exponent {
        ..3 => (exponent, "ns"),
        3..6 => (exponent - 3, "µs"),
        6..9 => (exponent - 6, "ms"),
        _ => (exponent - 9, "s"),
    };
    format!("{} {unit}", 10u64.pow(value.max(0) as u32))
}

/// A time in two digits.
pub fn short(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        ..1e3 => (nanoseconds, "ns"),
        1e3..1e6 => (nanoseconds / 1e3, "µs"),
        1e6..1e9 => (nanoseconds / 1e6, "ms"),
        _ => (nanoseconds / 1e9, "s"),
    };
    if value < 9.95 { format!("{value:.1} {unit}") } else { format!("{value:.0} {unit}") }
}

/// A line with a dot.
pub fn sample(canvas: &mut Canvas, (x, y): At, ink: Colour) {
    canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(ink, 0.8));
    canvas.disc((x, y), 1.4, ink);
}

/// Two strokes across a place.
pub fn cross(canvas: &mut Canvas, (x, y): At, ink: Colour) {
    let d = 1.8;
    canvas.lines(
        vec![vec![(x - d, y - d), (x + d, y + d)], vec![(x - d, y + d), (x + d, y - d)]],
        line(ink, 0.8),
    );
}

/// Small texts beside marks of a panel: in the nearest place that covers no line, no mark and no other text,
/// and that no other mark is nearer to by half a point; where there is none, right of the mark.
pub fn labels(canvas: &mut Canvas, frame: &PlotFrame, paths: &[Vec<At>], marks: &[At], wanted: Vec<TextAt>) {
    const SIDES: [At; 8] = [
        (1.0, 0.0),
        (0.0, -1.0),
        (-1.0, -1.0),
        (1.0, -1.0),
        (-1.0, 0.0),
        (0.0, 1.0),
        (1.0, 1.0),
        (-1.0, 1.0),
    ];
    let [left, top, right, bottom] = frame.inside();
    let covered: Vec<At> = Labels::new(paths, [left, top, right, bottom])
        .points
        .into_iter()
        .chain(marks.iter().copied())
        .collect();
    let mut placed: Vec<[f64; 4]> = Vec::new();
    for ((x, y), text) in wanted {
        let words = Words::plain(&text);
        let (wide, high) = (words.width(SMALL) / 2.0, 0.5 * SMALL);
        let spot = |away: f64, (across, down): At| {
            let middle = (x + across * (wide + away), y + down * (high + away));
            [middle.0 - wide, middle.1 - high, middle.0 + wide, middle.1 + high]
        };
        let apart = |[a, b, c, d]: [f64; 4], (x, y): At| (x - x.clamp(a, c)).hypot(y - y.clamp(b, d));
        let good = |&spot: &[f64; 4]| {
            let [a, b, c, d] = spot;
            let own = apart(spot, (x, y));
            a > left + 0.2
                && b > top + 1.0
                && c < right - 1.0
                && d < bottom - 1.0
                && covered.iter().all(|&at| apart(spot, at) > 1.0)
                && marks.iter().all(|&at| apart(spot, at) > own - 0.5)
                && placed.iter().all(|&[e, f, g, h]| c < e || g < a || d < f || h < b)
        };
        let near = [2.5, 4.0, 6.0, 9.0, 13.0].into_iter();
        let found = near.flat_map(|away| SIDES.map(|side| spot(away, side))).find(good);
        let spot = found.unwrap_or_else(|| spot(2.5, SIDES[0]));
        placed.push(spot);
        canvas.sized(words, ((spot[0] + spot[2]) / 2.0, (spot[1] + spot[3]) / 2.0), Anchor::Middle, SMALL);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_two_digits() {
        assert_eq!(
            [3.04, 99.6, 1234.0, 9.96e3, 2.5e6, 3.47e7].map(short).join(", "),
            "3.0 ns, 100 ns, 1.2 µs, 10 µs, 2.5 ms, 35 ms"
        );
        assert_eq!([2, 3, 7].map(duration).join(", "), "100 ns, 1 µs, 10 ms");
    }
}
