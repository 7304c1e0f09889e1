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

/// The kinds of certificates in order, each with its line.
struct Kinds<'a>(Vec<&'a str>);

impl<'a> Kinds<'a> {
    fn of(rows: &'a [Shown]) -> Kinds<'a> {
        let mut kinds: Vec<&str> = Vec::new();
        for row in rows.iter().filter(|row| row.check.is_some()) {
            if !kinds.contains(&row.kind.as_str()) {
                kinds.push(&row.kind);
            }
        }
        Kinds(kinds)
    }

    /// A second version has the colour of the first, and dashes.
    fn colour(&self, kind: &str) -> Colour {
        let first = kind.trim_end_matches(" 2");
        let mut firsts = self.0.iter().filter(|other| !other.ends_with(" 2"));
        COLOURS[firsts.position(|other| *other == first).unwrap_or(0) % COLOURS.len()]
    }

    fn stroke(&self, kind: &str) -> Stroke {
        Stroke { dashes: kind.ends_with(" 2").then_some([2.4, 1.6]), ..line(self.colour(kind), 0.9) }
    }

    fn legend(&self) -> Legend<'_> {
        let mut legend = Legend::default();
        for kind in &self.0 {
            let (ink, stroke) = (self.colour(kind), self.stroke(kind));
            legend.add(Words::plain(kind), move |canvas: &mut Canvas, (x, y): At| {
                canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], stroke);
                canvas.disc((x, y), 1.4, ink);
            });
        }
        legend
    }
}

/// Distances to grazing, from 1 down to 10 to this power and a half more.
fn distances(widest: f64) -> Axis {
    let marks = (0..=widest as i32).step_by(if widest > 12.0 { 5 } else { 2 });
    let marks = marks.map(|e| (f64::from(-e), super::frame::power(-e))).collect();
    Axis::marked("distance to grazing, µ", (-widest - 0.5, 0.0), true, marks)
}

fn across(row: &Shown) -> Option<f64> {
    row.digits.map(|digits| 10f64.powf(-digits))
}

fn draw(rows: &[Shown]) -> Canvas {
    let kinds = Kinds::of(rows);
    let legend = kinds.legend();
    let high = legend.height(WIDTH - 12.0);
    let mut canvas = Canvas::new(
        WIDTH,
        2.0 * HIGH + high + 8.0,
        "What a proof costs: orbits near grazing, and certificates",
        "Four panels: the bits with which an orbit is proved by its distance to grazing; the time of the proof by \
         the same; the size of certificates by n, a line per kind; the time to check them.",
    );
    let half = WIDTH / 2.0;
    let (near, certificates): (Vec<&Shown>, Vec<&Shown>) =
        rows.iter().partition(|row| row.study == "distance");
    let widest = near.iter().filter_map(|row| row.digits).fold(2.0, f64::max);
    bits(&mut canvas, &near, widest, kinds.colour("orbit"));
    let panels = [
        Panel {
            title: "time of that proof",
            up: |row| row.prove,
            corners: [half + 4.0, 14.0, WIDTH - 4.0, HIGH],
            widest: Some(widest),
            in_time: true,
        },
        Panel {
            title: "bytes of certificates",
            up: |row| row.bytes,
            corners: [4.0, HIGH + 18.0, half - 6.0, 2.0 * HIGH + 4.0],
            widest: None,
            in_time: false,
        },
        Panel {
            title: "time to check them",
            up: |row| row.check,
            corners: [half + 4.0, HIGH + 18.0, WIDTH - 4.0, 2.0 * HIGH + 4.0],
            widest: None,
            in_time: true,
        },
    ];
    for panel in &panels {
        panel.draw(&mut canvas, if panel.widest.is_some() { &near } else { &certificates }, &kinds);
    }
    legend.draw(&mut canvas, (6.0, 2.0 * HIGH + 8.0), WIDTH - 12.0);
    canvas
}

/// The bits of proofs near grazing, on a linear scale.
fn bits(canvas: &mut Canvas, near: &[&Shown], widest: f64, ink: Colour) {
    let most = near.iter().filter_map(|row| row.bits).fold(64.0, f64::max);
    let frame = PlotFrame::new(
        [4.0, 14.0, WIDTH / 2.0 - 6.0, HIGH],
        distances(widest),
        Axis::linear("bits", (0.0, 1.1 * most), 6),
    );
    canvas.text("bits to prove an orbit of period 3", (frame.left, 7.0), Anchor::Start);
    let points: Vec<At> = near.iter().filter_map(|row| Some(frame.at((across(row)?, row.bits?)))).collect();
    canvas.line(points.clone(), line(ink, 0.9));
    canvas.discs(points, 1.4, ink);
    frame.draw(canvas);
}

/// One number of the rows, on a scale of decades.
struct Panel {
    title: &'static str,
    up: fn(&Shown) -> Option<f64>,
    corners: [f64; 4],
    /// By the distance to grazing, to so many digits; without it by n.
    widest: Option<f64>,
    in_time: bool,
}

impl Panel {
    fn draw(&self, canvas: &mut Canvas, rows: &[&Shown], kinds: &Kinds) {
        let of: Vec<&Shown> =
            rows.iter().copied().filter(|row| (self.up)(row).is_some_and(|y| y > 0.0)).collect();
        let logs = of.iter().filter_map(|row| (self.up)(row)).map(f64::log10);
        let (low, top) = logs.fold((f64::MAX, f64::MIN), |(low, top), y| (low.min(y), top.max(y)));
        if low > top {
            return;
        }
        let (low, top) = (low.floor() as i32, top.ceil() as i32);
        let y = if self.in_time {
            let marks = (low..=top).map(|e| (f64::from(e), Words::plain(&duration(e)))).collect();
            Axis::marked("", (f64::from(low), f64::from(top)), true, marks)
        } else {
            Axis::decades("", [low, top], 1)
        };
        let x = self.widest.map_or_else(|| Axis::decades("n", [0, 3], 1), distances);
        let frame = PlotFrame::new(self.corners, x, y);
        canvas.text(self.title, (frame.left, self.corners[1] - 7.0), Anchor::Start);
        for &kind in &kinds.0 {
            let at = |row: &&Shown| {
                let x = if self.widest.is_some() { across(row)? } else { row.n };
                Some(frame.at((x, (self.up)(row)?)))
            };
            let points: Vec<At> = of.iter().filter(|row| row.kind == kind).filter_map(at).collect();
            canvas.line(points.clone(), kinds.stroke(kind));
            canvas.discs(points, 1.4, kinds.colour(kind));
        }
        frame.draw(canvas);
    }
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
