//! What a proof costs: bits and time by distance to grazing, time by period; size and checking time of
//! certificates by n, a line per kind.

use std::io::Write;

use super::{
    FigurePlace,
    canvas::{
        Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, GREY, ORANGE, PINK, RED, SKY, Stroke, Words,
        line,
    },
    frame::{Axis, PlotFrame},
    legend::Legend,
    panels::duration,
};
use crate::{
    error::Result,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    study::ProofCost,
};

/// Writes the picture and its data.
///
/// # Errors
/// An I/O error.
pub fn proof_figure(costs: &[ProofCost], place: &FigurePlace) -> Result<()> {
    let shown: Vec<Shown> = costs.iter().map(Shown::from).collect();
    place.draw(&draw(&shown))?;
    write_file(&place.data(), |out| proof_table(costs, TableFormat::Csv, out))
}

/// Writes the table behind the figure.
///
/// # Errors
/// An I/O error from `out`.
pub fn proof_table(costs: &[ProofCost], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let columns =
        ["study", "kind", "distance", "n", "bits", "prove_ns", "bytes", "check_ns", "load", "reason"]
            .map(|name| Column::new(name, name, name.len()));
    let mut table = TableWriter::new(out, format, "grazing-proofs 1", columns.to_vec())?;
    let integer = |x: Option<i64>| x.map_or(TableCell::Empty, TableCell::Int);
    for cost in costs {
        let distance = cost.digits.map_or(String::new(), |digits| format!("1e-{digits}"));
        let load = cost.load.map_or(String::new(), |load| format!("{load:.2}"));
        table.row(&[
            TableCell::Text(cost.study.name()),
            TableCell::Text(cost.kind),
            TableCell::Text(&distance),
            TableCell::Int(cost.n as i64),
            integer(cost.bits.map(i64::from)),
            integer(cost.prove.map(|time| time.as_nanos() as i64)),
            integer(cost.bytes.map(|bytes| bytes as i64)),
            integer(cost.check.map(|time| time.as_nanos() as i64)),
            TableCell::Text(&load),
            TableCell::Text(cost.reason.as_deref().unwrap_or_default()),
        ])?;
    }
    table.finish()
}

/// What is drawn of a row of the table.
struct Shown {
    study: String,
    kind: String,
    /// −log₁₀ of the distance.
    digits: Option<f64>,
    n: f64,
    bits: Option<f64>,
    /// Nanoseconds.
    prove: Option<f64>,
    bytes: Option<f64>,
    /// Nanoseconds.
    check: Option<f64>,
}

impl From<&ProofCost> for Shown {
    fn from(cost: &ProofCost) -> Shown {
        let time = |time: std::time::Duration| time.as_nanos() as f64;
        Shown {
            study: cost.study.name().into(),
            kind: cost.kind.into(),
            digits: cost.digits.map(f64::from),
            n: cost.n as f64,
            bits: cost.bits.map(f64::from),
            prove: cost.prove.map(time),
            bytes: cost.bytes.map(|bytes| bytes as f64),
            check: cost.check.map(time),
        }
    }
}

/// The width of the picture, two of a journal's columns, and the height of a panel.
const WIDTH: f64 = 2.0 * COLUMN + 12.0;
const HIGH: f64 = 130.0;
const COLOURS: [Colour; 8] = [BLACK, RED, GREEN, SKY, BLUE, ORANGE, PINK, GREY];

type Pick = fn(&Shown) -> Option<f64>;

fn draw(rows: &[Shown]) -> Canvas {
    let mut kinds: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|row| row.check.is_some()) {
        if !kinds.contains(&row.kind.as_str()) {
            kinds.push(&row.kind);
        }
    }
    // A second version has the colour of the first, and dashes.
    let first = |kind: &str| kind.trim_end_matches(" 2").to_string();
    let colour = |kind: &str| {
        let mut firsts = kinds.iter().filter(|other| !other.ends_with(" 2"));
        COLOURS[firsts.position(|other| *other == first(kind)).unwrap_or(0) % COLOURS.len()]
    };
    let stroke =
        |kind: &str| Stroke { dashes: kind.ends_with(" 2").then_some([2.4, 1.6]), ..line(colour(kind), 0.9) };
    let mut legend = Legend::default();
    for kind in &kinds {
        let (ink, stroke) = (colour(kind), stroke(kind));
        legend.add(Words::plain(kind), move |canvas: &mut Canvas, (x, y): At| {
            canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], stroke);
            canvas.disc((x, y), 1.4, ink);
        });
    }
    let high = legend.height(WIDTH - 12.0);
    let mut canvas = Canvas::new(
        WIDTH,
        2.0 * HIGH + high + 8.0,
        "What a proof costs: orbits near grazing, and certificates",
        "Four panels: the bits with which an orbit is proved by its distance to grazing; the time of the proof by \
         the same; the size of certificates by n, a line per kind; the time to check them.",
    );
    let half = WIDTH / 2.0;
    let near = rows.iter().filter(|row| row.study == "distance").collect::<Vec<_>>();
    let across = |row: &Shown| row.digits.map(|digits| 10f64.powf(-digits));
    let widest = near.iter().filter_map(|row| row.digits).fold(2.0, f64::max);
    let distances = || {
        let marks = (0..=widest as i32).step_by(if widest > 12.0 { 5 } else { 2 });
        let marks = marks.map(|e| (f64::from(-e), super::frame::power(-e))).collect();
        Axis::marked("distance to grazing, µ", (-widest - 0.5, 0.0), true, marks)
    };
    // Bits, linear.
    let most = near.iter().filter_map(|row| row.bits).fold(64.0, f64::max);
    let frame = PlotFrame::new(
        [4.0, 14.0, half - 6.0, HIGH],
        distances(),
        Axis::linear("bits", (0.0, 1.1 * most), 6),
    );
    canvas.text("bits to prove an orbit of period 3", (frame.left, 7.0), Anchor::Start);
    let points: Vec<At> = near.iter().filter_map(|row| Some(frame.at((across(row)?, row.bits?)))).collect();
    canvas.line(points.clone(), line(colour("orbit"), 0.9));
    canvas.discs(points, 1.4, colour("orbit"));
    frame.draw(&mut canvas);
    let panels: [(&str, Pick, [f64; 4], bool); 3] = [
        ("time of that proof", |row| row.prove, [half + 4.0, 14.0, WIDTH - 4.0, HIGH], true),
        ("bytes of certificates", |row| row.bytes, [4.0, HIGH + 18.0, half - 6.0, 2.0 * HIGH + 4.0], false),
        (
            "time to check them",
            |row| row.check,
            [half + 4.0, HIGH + 18.0, WIDTH - 4.0, 2.0 * HIGH + 4.0],
            true,
        ),
    ];
    for (place, (title, up, corners, in_time)) in panels.into_iter().enumerate() {
        let by_distance = place == 0;
        let of: Vec<&Shown> = rows
            .iter()
            .filter(|row| (row.study == "distance") == by_distance && up(row).is_some_and(|y| y > 0.0))
            .collect();
        let logs = of.iter().filter_map(|row| up(row)).map(f64::log10);
        let (low, top) = logs.fold((f64::MAX, f64::MIN), |(low, top), y| (low.min(y), top.max(y)));
        if low > top {
            continue;
        }
        let (low, top) = (low.floor() as i32, top.ceil() as i32);
        let y = if in_time {
            let marks = (low..=top).map(|e| (f64::from(e), Words::plain(&duration(e)))).collect();
            Axis::marked("", (f64::from(low), f64::from(top)), true, marks)
        } else {
            Axis::decades("", [low, top], 1)
        };
        let x = if by_distance { distances() } else { Axis::decades("n", [0, 3], 1) };
        let frame = PlotFrame::new(corners, x, y);
        canvas.text(title, (frame.left, corners[1] - 7.0), Anchor::Start);
        for &kind in &kinds {
            let at =
                |row: &&Shown| Some(frame.at((if by_distance { across(row)? } else { row.n }, up(row)?)));
            let points: Vec<At> = of.iter().filter(|row| row.kind == kind).filter_map(at).collect();
            canvas.line(points.clone(), stroke(kind));
            canvas.discs(points, 1.4, colour(kind));
        }
        frame.draw(&mut canvas);
    }
    legend.draw(&mut canvas, (6.0, 2.0 * HIGH + 8.0), WIDTH - 12.0);
    canvas
}

#[cfg(test)]
mod tests {
    use super::{super::assert_shows_its_table, Shown, draw};

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_table() {
        let row = |row: &csv::StringRecord| {
            let number = |i: usize| row[i].parse::<f64>().ok();
            Shown {
                study: row[0].into(),
                kind: row[1].into(),
                digits: row[2].strip_prefix("1e-").map(|digits| digits.parse().unwrap()),
                n: number(3).unwrap(),
                bits: number(4),
                prove: number(5),
                bytes: number(6),
                check: number(7),
            }
        };
        assert_shows_its_table("proofs", row, draw);
    }
}
