//! What accuracy costs: time against certain digits, both axes logarithmic.

use std::io::Write;

use super::{
    FigurePlace,
    canvas::{
        At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, GREY, ORANGE, PINK, RED, SKY, Stroke, Words, line,
    },
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{
    error::Result,
    local::Rung,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    study::{Evaluation, Measured},
};

/// Writes the picture and its data.
///
/// # Errors
/// An I/O error.
pub fn accuracy_figure(rows: &[Measured], place: &FigurePlace) -> Result<()> {
    let shown: Vec<Shown> = rows.iter().map(Shown::from).collect();
    place.draw(&draw(&shown))?;
    write_file(&place.data(), |out| accuracy_table(rows, TableFormat::Csv, out))
}

/// Writes the table behind the figure.
///
/// # Errors
/// An I/O error from `out`.
pub fn accuracy_table(rows: &[Measured], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let columns = [
        "family",
        "rung",
        "time_ns",
        "digits",
        "log10_width",
        "bits_lost",
        "log10_condition",
        "decided",
        "wrong",
        "inputs",
    ]
    .map(|name| Column::new(name, name, name.len()));
    let mut table = TableWriter::new(out, format, "grazing-accuracy 1", columns.to_vec())?;
    for row in rows {
        let number =
            |x: Option<f64>| x.filter(|x| x.is_finite()).map_or(String::new(), |x| format!("{x:.1}"));
        let (digits, width, condition) = (number(row.digits), number(row.width), number(Some(row.condition)));
        table.row(&[
            TableCell::Text(row.family.name()),
            TableCell::Text(&method(row.method)),
            TableCell::Int(row.time.as_nanos() as i64),
            TableCell::Text(&digits),
            TableCell::Text(&width),
            row.lost.map_or(TableCell::Empty, |lost| TableCell::Int(lost as i64)),
            TableCell::Text(&condition),
            TableCell::Int(row.decided as i64),
            TableCell::Int(row.wrong as i64),
            TableCell::Int(row.inputs as i64),
        ])?;
    }
    table.finish()
}

fn method(method: Evaluation) -> String {
    match method {
        Evaluation::Naive => "f64, naive".into(),
        Evaluation::Rung(Rung::Plain) => "f64".into(),
        Evaluation::Rung(rung) => rung.to_string(),
    }
}

/// What is drawn of a measurement.
struct Shown {
    family: String,
    method: String,
    /// Nanoseconds.
    time: f64,
    digits: Option<f64>,
}

impl From<&Measured> for Shown {
    fn from(row: &Measured) -> Shown {
        Shown {
            family: row.family.name().into(),
            method: method(row.method),
            time: row.time.as_nanos() as f64,
            // As the table has it.
            digits: row.digits.and_then(|x| format!("{x:.1}").parse().ok()).filter(|x: &f64| x.is_finite()),
        }
    }
}

const COLOURS: [Colour; 7] = [BLACK, BLUE, SKY, PINK, RED, ORANGE, GREEN];

/// Less than one certain digit has a column of its own, left of a broken line; this is its middle, as a
/// logarithm.
const NONE: f64 = -0.35;

/// A time in words, from its logarithm in nanoseconds.
pub(super) fn duration(exponent: i32) -> String {
    let (value, unit) = match exponent {
        ..3 => (exponent, "ns"),
        3..6 => (exponent - 3, "µs"),
        6..9 => (exponent - 6, "ms"),
        _ => (exponent - 9, "s"),
    };
    format!("{} {unit}", 10u64.pow(value.max(0) as u32))
}

fn draw(rows: &[Shown]) -> Canvas {
    let mut families: Vec<&str> = rows.iter().map(|row| row.family.as_str()).collect();
    families.dedup();
    let mut legend = Legend::default();
    for (family, ink) in families.iter().zip(COLOURS.into_iter().cycle()) {
        legend.add(Words::plain(&family.replace("->", "→")), move |canvas: &mut Canvas, at: At| {
            sample(canvas, at, ink)
        });
    }
    legend.add(Words::plain("f64 by luck"), |canvas: &mut Canvas, at: At| {
        canvas.disc(at, 2.0, line(BLACK, 0.7))
    });
    legend.add("naive formula by luck", |canvas: &mut Canvas, at: At| cross(canvas, at, BLACK));
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(
        COLUMN,
        176.0 + high,
        "What accuracy costs: b_{n,k} by method and family of inputs",
        "Time of one evaluation over certain decimal digits, both logarithmic, a line per family of inputs: f64 \
         intervals first, then 128, 256, 1024, 4096 and 16384 bits. Rings and crosses are plain floats, whose \
         digits happen to be right.",
    );
    let times = rows.iter().map(|row| row.time.log10());
    let (low, top) = times.fold((9.0, 1.0), |(low, top): (f64, f64), t| (low.min(t), top.max(t)));
    let (low, top) = (low.floor() as i32, top.ceil() as i32);
    let marks = (low..=top).map(|e| (f64::from(e), Words::plain(&duration(e))));
    let mut digits = vec![(NONE, "< 1".into())];
    digits.extend((0..=3).map(|e| (f64::from(e), format!("{}", 10u64.pow(e as u32)).into())));
    let frame = PlotFrame::new(
        [2.0, 2.0, COLUMN - 4.0, 174.0],
        Axis::marked("certain decimal digits", (-0.7, 3.9), true, digits),
        Axis::marked("time of one evaluation", (f64::from(low), f64::from(top)), true, marks.collect()),
    );
    let gap = frame.path([(10f64.powf(-0.12), 10f64.powi(low)), (10f64.powf(-0.12), 10f64.powi(top))]);
    canvas.line(gap, Stroke { dashes: Some([2.0, 2.0]), ..line(GREY, 0.4) });
    for (&family, ink) in families.iter().zip(COLOURS.into_iter().cycle()) {
        let of = |wanted: fn(&str) -> bool| {
            rows.iter().filter(move |row| row.family == family && wanted(&row.method)).filter_map(|row| {
                let digits = row.digits?;
                Some(frame.at((if digits < 1.0 { 10f64.powf(NONE) } else { digits }, row.time)))
            })
        };
        let enclosed: Vec<At> = of(|method| !matches!(method, "f64" | "f64, naive")).collect();
        canvas.line(enclosed.clone(), line(ink, 0.8));
        canvas.discs(enclosed, 1.4, ink);
        canvas.discs(of(|method| method == "f64").collect(), 2.0, line(ink, 0.7));
        of(|method| method == "f64, naive").for_each(|at| cross(&mut canvas, at, ink));
    }
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 175.0), COLUMN - 8.0);
    canvas
}

/// A line with a dot.
pub(super) fn sample(canvas: &mut Canvas, (x, y): At, ink: Colour) {
    canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(ink, 0.8));
    canvas.disc((x, y), 1.4, ink);
}

fn cross(canvas: &mut Canvas, (x, y): At, ink: Colour) {
    let d = 1.8;
    canvas.lines(
        vec![vec![(x - d, y - d), (x + d, y + d)], vec![(x - d, y + d), (x + d, y - d)]],
        line(ink, 0.7),
    );
}

#[cfg(test)]
mod tests {
    use super::{super::assert_shows_its_table, Shown, draw};

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_table() {
        let row = |row: &csv::StringRecord| Shown {
            family: row[0].into(),
            method: row[1].into(),
            time: row[2].parse().unwrap(),
            digits: row[3].parse().ok(),
        };
        assert_shows_its_table("accuracy", row, draw);
    }
}
