//! The price of a sign: the time of a decision against the distance to where the sign changes, a panel per
//! family of places, a line per method.

use std::{io::Write, path::Path};

use super::{
    FigurePlace,
    canvas::{
        Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, GREY, ORANGE, PINK, RED, SKY, Stroke, TYPE,
        Words, line,
    },
    frame::{Axis, PlotFrame},
    legend::Legend,
    panels::{PanelRow, duration, rows, values},
};
use crate::{
    error::Result,
    output::{Column, TableCell, TableFormat, TableWriter},
    study::SignPrice,
};

/// Draws `signs.svg` from `signs.csv` and, if it is there, `signs-peers.csv`.
///
/// # Errors
/// An I/O error; an input error if a table is none.
pub fn sign_price_figure(folder: &Path) -> Result<()> {
    let rows = rows(folder, "signs.csv", "signs-peers.csv")?;
    FigurePlace::svg(folder, "signs").draw(&draw(&rows))
}

/// Writes the table behind the figure.
///
/// # Errors
/// An I/O error from `out`.
pub fn sign_price_table(prices: &[SignPrice], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let columns = [
        "family", "method", "distance", "rung", "inputs", "decided", "wrong", "time_ns", "q25", "q75", "load",
    ]
    .map(|name| Column::new(name, name, name.len()));
    let mut table = TableWriter::new(out, format, "grazing-signs 1", columns.to_vec())?;
    for price in prices {
        let [time, q25, q75] = price.time.map(|time| TableCell::Int(time.as_nanos() as i64));
        let load = price.load.map_or(String::new(), |load| format!("{load:.2}"));
        table.row(&[
            TableCell::Text(price.family.name()),
            TableCell::Text(&price.method.name()),
            TableCell::Text(&price.digits.map_or("0".to_string(), |digits| format!("1e-{digits}"))),
            TableCell::Text(&price.rung.map_or(String::new(), |rung| rung.to_string())),
            TableCell::Int(price.inputs as i64),
            TableCell::Int(price.decided as i64),
            TableCell::Int(price.wrong as i64),
            time,
            q25,
            q75,
            TableCell::Text(&load),
        ])?;
    }
    table.finish()
}

/// What is drawn of a row of the table.
struct Shown {
    family: String,
    method: String,
    /// −log₁₀ of the distance; `None`: at the place.
    digits: Option<f64>,
    rung: String,
    /// Whether each of the inputs was decided.
    decided: bool,
    /// Inputs with a wrong sign, from 0 to 1.
    wrong: f64,
    /// Nanoseconds.
    time: f64,
}

impl From<&PanelRow> for Shown {
    fn from(row: &PanelRow) -> Shown {
        Shown {
            family: row.text("family").into(),
            method: row.text("method").into(),
            digits: row.text("distance").strip_prefix("1e-").and_then(|digits| digits.parse().ok()),
            rung: row.text("rung").into(),
            decided: row.text("decided") == row.text("inputs"),
            wrong: row.number("wrong").unwrap_or(0.0) / row.number("inputs").unwrap_or(1.0).max(1.0),
            time: row.times()[0],
        }
    }
}

/// Methods whose lines are drawn, with their colours, widths and dashes.
const LINES: [(&str, Colour, f64, Option<[f64; 2]>); 8] = [
    ("f64 interval", BLACK, 0.8, None),
    ("128 bits", SKY, 0.8, None),
    ("512 bits", SKY, 0.8, None),
    ("4096 bits", BLUE, 0.8, None),
    ("exact", ORANGE, 0.8, None),
    ("verdict", BLACK, 0.8, Some([2.0, 1.6])),
    ("Arb", GREEN, 0.8, None),
    ("ladder", RED, 1.4, None),
];
/// Methods that promise nothing, with the colour of their wrong signs.
const CARELESS: [(&str, Colour); 2] = [("f64, naive", PINK), ("plain f64", GREY)];

/// Where a distance of 0 is drawn, and where the axis breaks before it: −log₁₀ of a distance.
const ZERO: f64 = 6000.0;
const BREAK: f64 = 2500.0;
/// The width of the picture, two of a journal's columns, and the size of a panel.
const WIDTH: f64 = 2.0 * COLUMN + 12.0;
const ACROSS: usize = 3;
const HIGH: f64 = 118.0;
/// The height of the strip under a panel that has the shares of wrong signs.
const STRIP: f64 = 14.0;

fn draw(table: &[PanelRow]) -> Canvas {
    let families = values(table, "family");
    let rows: Vec<Shown> = table.iter().map(Shown::from).collect();
    let wide = WIDTH / ACROSS as f64;
    let down = (families.len() + 1).div_ceil(ACROSS);
    let mut canvas = Canvas::new(
        WIDTH,
        16.0 + HIGH * down as f64,
        "The price of a sign: time of a decision by distance to where the sign changes",
        "A panel per family of places. Across: the relative distance from 1/10 to 10 to the power −1000, and 0. \
         Up: the time of one decision. A line per method, only where each sign was decided. Bars under a \
         panel: the share of signs that plain floats get wrong.",
    );
    let times = rows.iter().map(|row| row.time.log10());
    let (low, top) = times.fold((9.0, 1.0), |(low, top): (f64, f64), t| (low.min(t), top.max(t)));
    let (low, top) = (low.floor() as i32, top.ceil() as i32);
    for (place, &family) in families.iter().enumerate() {
        let of: Vec<&Shown> = rows.iter().filter(|row| row.family == family).collect();
        let corner = ((place % ACROSS) as f64 * wide, 4.0 + (place / ACROSS) as f64 * HIGH);
        panel(&mut canvas, &of, corner, (low, top));
    }
    let corner = ((families.len() % ACROSS) as f64 * wide, 4.0 + (families.len() / ACROSS) as f64 * HIGH);
    key(&mut canvas, (corner.0 + 10.0, corner.1 + 6.0), wide - 14.0);
    let name = "relative distance to where the sign changes";
    canvas.text(name, (WIDTH / 2.0, 10.0 + HIGH * down as f64), Anchor::Middle);
    canvas
}

fn panel(canvas: &mut Canvas, rows: &[&Shown], (left, top): At, (least, most): (i32, i32)) {
    let wide = WIDTH / ACROSS as f64;
    let mut marks: Vec<(f64, Words)> =
        (0..=3).map(|e: i32| (f64::from(e), format!("10^{{−{}}}", 10u32.pow(e as u32)).into())).collect();
    marks.push((ZERO.log10(), "0".into()));
    let step = if most - least > 5 { 2 } else { 1 };
    let times = (least..=most).filter(|e| (e - least) % step == 0);
    let times = times.map(|e| (f64::from(e), Words::plain(&duration(e)))).collect();
    let frame = PlotFrame::new(
        [left + 4.0, top + 10.0, left + wide - 4.0, top + HIGH - 4.0],
        Axis::marked("", (-0.2, ZERO.log10() + 0.2), true, marks),
        Axis::marked("", (f64::from(least) - 0.8, f64::from(most)), true, times),
    );
    let title = rows[0].family.replace("->", "→").replace("c_n", "c_{n}");
    canvas.text(Words::from(title), (frame.left, top + 5.0), Anchor::Start);
    let [inner, up, right, bottom] = frame.inside();
    let across = |digits: Option<f64>| frame.at((digits.unwrap_or(ZERO), 10f64.powi(least))).0;
    let gap = across(Some(BREAK));
    canvas.line(vec![(gap, up), (gap, bottom)], Stroke { dashes: Some([2.0, 2.0]), ..line(GREY, 0.4) });
    // Shares of wrong signs, in a strip of their own.
    canvas.line(vec![(inner, bottom - STRIP), (right, bottom - STRIP)], line(GREY, 0.4));
    for (place, (method, ink)) in (0..).zip(CARELESS) {
        for row in rows.iter().filter(|row| row.method == method && row.wrong > 0.0) {
            let x = across(row.digits) + 3.2 * f64::from(place) - 3.2;
            canvas.rectangle([x, bottom - row.wrong * STRIP, x + 2.8, bottom], ink);
        }
    }
    for (method, ink, width, dashes) in LINES {
        let of = rows.iter().filter(|row| row.method == method && row.decided);
        let points: Vec<(&Shown, At)> =
            of.map(|row| (*row, frame.at((row.digits.unwrap_or(ZERO), row.time)))).collect();
        // The line ends before the break: 0 is no small distance.
        let before = points.iter().filter(|(row, _)| row.digits.is_some()).map(|(_, at)| *at);
        canvas.line(before.collect(), Stroke { dashes, ..line(ink, width) });
        for (row, at) in &points {
            let ink = if method == "ladder" { rung_colour(&row.rung) } else { ink };
            canvas.disc(*at, if method == "ladder" { 2.0 } else { 1.1 }, ink);
        }
    }
    frame.draw(canvas);
}

/// The colour of the rung that decided.
fn rung_colour(rung: &str) -> Colour {
    match rung {
        "f64 interval" => BLACK,
        "exact" => ORANGE,
        _ => BLUE,
    }
}

fn key(canvas: &mut Canvas, corner: At, width: f64) {
    let mut legend = Legend::default();
    for (name, method) in [
        ("f64 intervals", "f64 interval"),
        ("balls of 128 and 512 bits", "128 bits"),
        ("balls of 4096 bits", "4096 bits"),
        ("integers", "exact"),
        ("Arb, precision doubled", "Arb"),
        ("whole verdict of the period", "verdict"),
    ] {
        for (_, ink, width, dashes) in LINES.into_iter().filter(|(known, ..)| *known == method) {
            legend.add(Words::plain(name), move |canvas: &mut Canvas, (x, y): At| {
                canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], Stroke { dashes, ..line(ink, width) });
                canvas.disc((x, y), 1.1, ink);
            });
        }
    }
    legend.add("ladder; dots: decided by", |canvas: &mut Canvas, (x, y): At| {
        canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(RED, 1.4));
    });
    for (name, ink) in [("intervals", BLACK), ("balls", BLUE), ("integers ", ORANGE)] {
        legend.add(name, move |canvas: &mut Canvas, at: At| canvas.disc(at, 2.0, ink));
    }
    for (name, (_, ink)) in ["wrong signs: naive f64", "wrong signs: f64"].into_iter().zip(CARELESS) {
        legend.add(Words::plain(name), move |canvas: &mut Canvas, (x, y): At| {
            canvas.rectangle([x - 1.4, y - 0.4 * TYPE, x + 1.4, y + 0.4 * TYPE], ink);
        });
    }
    legend.draw(canvas, corner, width);
}

#[cfg(test)]
mod tests {
    use super::{super::assert_shows_its_tables, draw};

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_tables() {
        assert_shows_its_tables("signs", draw);
    }
}
