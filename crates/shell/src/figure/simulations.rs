//! Error against time of simulations: a panel per motion, a line per method, both axes logarithmic; other
//! motions, with other impacts, apart.

use std::{io::Write, path::Path};

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, Canvas, Colour, GREEN, GREY, ORANGE, PINK, Stroke, Words, line},
    frame::{Axis, PlotFrame, power},
    legend::Legend,
    panels::{
        ACROSS, HIGH, PanelRow, PriceTable, WIDTH, caption, caption_height, corner, cross, draw_caption,
        labels, rows, sample, short, time_range, values, whisker,
    },
};
use crate::{
    error::Result,
    output::{TableCell, TableFormat},
    study::simulations::SimulationPrice,
};

/// Draws `simulations.svg` from `simulations.csv` and, if it is there, `simulations-peers.csv`.
///
/// # Errors
/// An I/O error; an input error if a table is none.
pub fn simulations_figure(folder: &Path) -> Result<()> {
    let rows = rows(folder, "simulations.csv", "simulations-peers.csv")?;
    FigurePlace::svg(folder, "simulations").draw(&draw(&rows))
}

/// Writes the table behind the figure.
///
/// # Errors
/// An I/O error from `out`.
pub fn simulations_table(prices: &[SimulationPrice], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let names =
        ["motion", "method", "setting", "error", "impacts", "missed", "time_ns", "q25", "q75", "load"];
    let mut table = PriceTable::new(out, format, "grazing-simulations 1", &names)?;
    for price in prices {
        let setting = price.tolerance.map_or(String::new(), |tolerance| format!("{tolerance:.0e}"));
        let load = price.load.map_or(String::new(), |load| format!("{load:.2}"));
        let error = format!("{:.1e}", price.error);
        let [time, q25, q75] = price.time.map(|time| TableCell::Int(time.as_nanos() as i64));
        table.row(&[
            TableCell::Text(price.name),
            TableCell::Text(if price.tolerance.is_some() { "integrator" } else { "closed form" }),
            TableCell::Text(&setting),
            TableCell::Text(&error),
            TableCell::Int(price.impacts[0]),
            TableCell::Int(price.impacts[1] - price.impacts[0]),
            time,
            q25,
            q75,
            TableCell::Text(&load),
        ])?;
    }
    table.finish()
}

/// Methods with their colours and names in the legend.
const METHODS: [(&str, Colour, &str); 5] = [
    ("C, RK4", ORANGE, "plain loop in C, RK4"),
    ("SciPy DOP853", GREEN, "SciPy, DOP853"),
    ("SciPy Radau", PINK, "SciPy, Radau"),
    ("integrator", BLUE, "this integrator"),
    ("closed form", BLACK, "closed form"),
];

/// Errors from here on are no digit at all; other motions are right of a broken line: logarithms.
const WORST: f64 = 0.5;
const BREAK: f64 = 1.2;
const OTHER: f64 = 2.4;
const END: f64 = 3.4;
const LEAST: f64 = -16.5;

fn draw(rows: &[PanelRow]) -> Canvas {
    let motions = values(rows, "motion");
    let lines = caption(
        rows.iter(),
        "Medians over repetitions; bars: quartiles. Points from right to left: smaller tolerances or steps. \
         Crosses are other motions, with more or fewer impacts than there are.",
    );
    let key = key(rows);
    let panels = 4.0 + HIGH * motions.len().div_ceil(ACROSS) as f64;
    let below = panels + 14.0 + key.height(WIDTH - 12.0);
    let mut canvas = Canvas::new(
        WIDTH,
        below + caption_height(&lines),
        "Error against time of simulations: methods side by side",
        "A panel per motion. Across: the error after ten periods, logarithmic, and right of a broken line \
         motions that missed impacts. Up: the time of a period, logarithmic. A line per method.",
    );
    for (place, &motion) in motions.iter().enumerate() {
        let of: Vec<&PanelRow> = rows.iter().filter(|row| row.text("motion") == motion).collect();
        panel(&mut canvas, &of, motion, corner(place), rows);
    }
    canvas.text("error after ten periods", (WIDTH / 2.0, panels + 3.0), Anchor::Middle);
    key.draw(&mut canvas, (6.0, panels + 10.0), WIDTH - 12.0);
    draw_caption(&mut canvas, lines, below);
    canvas
}

fn missed(row: &PanelRow) -> f64 {
    row.number("missed").unwrap_or(0.0)
}

fn panel(canvas: &mut Canvas, rows: &[&PanelRow], motion: &str, (left, top): At, all: &[PanelRow]) {
    let mut marks: Vec<(f64, Words)> = (-4..=0).map(|e: i32| (f64::from(4 * e), power(4 * e))).collect();
    marks.push((OTHER, "other".into()));
    let (times, time_marks) = time_range(all);
    let wide = WIDTH / ACROSS as f64;
    let frame = PlotFrame::new(
        [left + 4.0, top + 10.0, left + wide - 4.0, top + HIGH - 4.0],
        Axis::marked("", (LEAST, END), true, marks),
        Axis::marked("", times, true, time_marks),
    );
    let counted = rows.iter().find_map(|row| Some(row.number("impacts")? + missed(row))).unwrap_or(0.0);
    canvas.text(
        Words::plain(&format!("{motion}: {counted} impacts")),
        (frame.left, top + 5.0),
        Anchor::Start,
    );
    let ends = [times.0, times.1].map(|t| (10f64.powf(BREAK), 10f64.powf(t)));
    canvas.line(frame.path(ends), Stroke { dashes: Some([2.0, 2.0]), ..line(GREY, 0.4) });
    // Other motions of one method below one another.
    let place = |row: &PanelRow| METHODS.iter().position(|(method, ..)| *method == row.text("method"));
    let x = |row: &PanelRow| match missed(row) {
        0.0 => 10f64.powf(row.number("error").map_or(WORST, |e| e.log10().clamp(LEAST + 0.3, WORST))),
        _ => 10f64.powf(OTHER + 0.35 * (place(row).unwrap_or(0) as f64 - 1.0)),
    };
    let at = |row: &PanelRow| frame.at((x(row), row.times()[0]));
    let (mut lines, mut marks, mut texts) = (Vec::new(), Vec::new(), Vec::new());
    for (method, ink, _) in METHODS {
        let of: Vec<&&PanelRow> = rows.iter().filter(|row| row.text("method") == method).collect();
        let same = || of.iter().filter(|row| missed(row) == 0.0);
        let points: Vec<At> = same().map(|row| at(row)).collect();
        canvas.line(points.clone(), line(ink, 0.8));
        canvas.discs(points.clone(), if method == "closed form" { 2.2 } else { 1.3 }, ink);
        marks.extend(of.iter().map(|row| at(row)));
        lines.push(points);
        for row in &of {
            whisker(canvas, &frame, x(row), row.times(), ink);
        }
        for row in of.iter().filter(|row| missed(row) != 0.0) {
            cross(canvas, at(row), ink);
        }
        // The values that matter: the closed form's time, and that of each method's smallest error.
        if let Some(row) = same().min_by(|a, b| x(a).total_cmp(&x(b))) {
            texts.push((at(row), short(row.times()[0])));
        }
    }
    labels(canvas, &frame, &lines, &marks, texts);
    frame.draw(canvas);
}

fn key(rows: &[PanelRow]) -> Legend<'static> {
    let mut legend = Legend::default();
    for (method, ink, name) in
        METHODS.into_iter().filter(|(method, ..)| rows.iter().any(|row| row.text("method") == *method))
    {
        legend.add(Words::plain(name), move |canvas: &mut Canvas, at: At| match method {
            "closed form" => canvas.disc(at, 2.2, ink),
            _ => sample(canvas, at, ink),
        });
    }
    legend.add(Words::plain("impacts missed or made up"), |canvas: &mut Canvas, at: At| {
        cross(canvas, at, GREY)
    });
    legend
}

#[cfg(test)]
mod tests {
    use super::{super::assert_shows_its_tables, *};

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_tables() {
        assert_shows_its_tables("simulations", draw);
    }
}
