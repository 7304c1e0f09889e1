//! A plane whose points belong to a few classes: basins of attraction, maps over two parameters.

use std::collections::BTreeSet;

use super::{
    FigurePlace,
    canvas::{
        Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, ORANGE, PINK, RED, SKY, TYPE, Words, YELLOW,
        line,
    },
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::error::Result;

/// Classes on a grid.
pub struct Grid {
    /// The columns' coordinates, evenly spaced.
    pub x: Vec<f64>,
    /// The rows' coordinates.
    pub y: Vec<f64>,
    /// The class of each point, row by row.
    pub cells: Vec<usize>,
    /// What the classes are.
    pub names: Vec<String>,
}

/// Writes the picture and its data: a row per point.
///
/// # Errors
/// An I/O error.
pub fn grid(grid: &Grid, axes: [&str; 2], place: &FigurePlace) -> Result<()> {
    let row = |(i, &class): (usize, &usize)| {
        let (x, y) = (grid.x[i % grid.x.len()], grid.y[i / grid.x.len()]);
        vec![x.to_string(), y.to_string(), grid.names[class].clone()]
    };
    let rows: Vec<Vec<String>> = grid.cells.iter().enumerate().map(row).collect();
    let about = "Each start on a grid has the colour of the attractor that its motion ends on.";
    place.save(&draw(grid, axes, ["Basins of attraction", about]), &["q", "u", "ends"], &rows)
}

/// The most points of a map that are drawn along each axis: every second, third, … beyond.
const DRAWN: usize = 400;

/// A plane of parameters.
pub struct ParameterMap {
    /// What the motion at each point ends on, by classes.
    pub ends: Grid,
    /// The largest Lyapunov exponent of each point, times the forcing period, where it has one.
    pub exponents: Vec<Option<f64>>,
}

/// Writes the picture of a map, what motions end on above their exponents; its data, a table of its own, is
/// the caller's.
///
/// # Errors
/// An I/O error.
pub fn parameter_map(map: &ParameterMap, axes: [&str; 2], place: &FigurePlace) -> Result<()> {
    let all = &map.ends;
    let (columns, step) = (all.x.len(), all.x.len().max(all.y.len()).div_ceil(DRAWN));
    let thin = |all: &[f64]| all.iter().copied().step_by(step).collect();
    let places: Vec<usize> = (0..all.y.len())
        .step_by(step)
        .flat_map(|row| (0..columns).step_by(step).map(move |column| row * columns + column))
        .collect();
    let cells = places.iter().map(|&place| all.cells[place]).collect();
    let ends = Grid { x: thin(&all.x), y: thin(&all.y), cells, names: all.names.clone() };
    let exponents: Vec<Option<f64>> = places.iter().map(|&place| map.exponents[place]).collect();
    let about = "Each point of a grid of parameters has the colour of the period of the motion there, and below \
                 that of its Lyapunov exponent.";
    let mut canvas = draw(&ends, axes, ["Attractors over two parameters", about]);
    let top = canvas.height;
    let scale = Scale::new(&exponents, &ends.cells);
    canvas.height += HIGH + if scale.is_some() { 24.0 } else { 0.0 };
    // Points that no motion stays at are as above.
    let class = |(exponent, &end): (&Option<f64>, &usize)| match &scale {
        Some(scale) if end >= NO_MOTION => GREYS.len() + scale.class(*exponent),
        _ => end,
    };
    let cells: Vec<usize> = exponents.iter().zip(&ends.cells).map(class).collect();
    let ink = |class: usize| match class.checked_sub(GREYS.len()) {
        Some(class) => Scale::colour(class),
        None => colour(class),
    };
    panel(&mut canvas, top, (&ends.x, &ends.y, &cells), axes, ink);
    if let Some(scale) = scale {
        scale.draw(&mut canvas, top + HIGH);
    }
    place.draw(&canvas)
}

/// How many colours exponents of one sign have.
const SHADES: usize = 6;

/// Colours of exponents: blue below 0, red above, the paler the nearer to it; black where it is −∞.
struct Scale {
    least: f64,
    most: f64,
    /// Whether a motion has the exponent −∞.
    rests: bool,
}

impl Scale {
    /// The scale of these; none if there is no exponent but 0.
    fn new(exponents: &[Option<f64>], ends: &[usize]) -> Option<Scale> {
        let all = || exponents.iter().flatten().copied();
        let (least, most) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        let rests = exponents.iter().zip(ends).any(|(one, &end)| one.is_none() && end >= NO_MOTION);
        (least < most || rests).then_some(Scale { least, most, rests })
    }

    /// From the least exponents up, then −∞; 0 is not positive.
    fn class(&self, exponent: Option<f64>) -> usize {
        let Some(exponent) = exponent else { return 2 * SHADES };
        let shade = |share: f64| ((share * SHADES as f64) as usize).min(SHADES - 1);
        if exponent > 0.0 {
            SHADES + shade(exponent / self.most)
        } else {
            SHADES - 1 - if self.least < 0.0 { shade(exponent / self.least) } else { 0 }
        }
    }

    fn colour(class: usize) -> Colour {
        let share = |shade: usize| (shade + 1) as f64 / SHADES as f64;
        match class.checked_sub(SHADES) {
            Some(SHADES) => BLACK,
            Some(shade) => RED.tint(share(shade)),
            None => BLUE.tint(share(SHADES - 1 - class)),
        }
    }

    /// The colours in a row, with the exponents between which they stand.
    fn draw(&self, canvas: &mut Canvas, top: f64) {
        let mut edges: Vec<f64> = Vec::new();
        let mut classes: Vec<usize> = Vec::new();
        if self.least < 0.0 {
            edges.extend((1..=SHADES).rev().map(|i| self.least * i as f64 / SHADES as f64));
            classes.extend(0..SHADES);
        }
        edges.push(0.0);
        if self.most > 0.0 {
            edges.extend((1..=SHADES).map(|i| self.most * i as f64 / SHADES as f64));
            classes.extend(SHADES..2 * SHADES);
        }
        let name = Words::plain("exponent");
        let mut left = 14.0 + name.width(TYPE);
        canvas.text(name, (4.0, top + 5.0), Anchor::Start);
        if self.rests {
            canvas.rectangle([left, top, left + 12.0, top + 10.0], BLACK);
            canvas.text(Words::plain("−∞"), (left + 6.0, top + 17.0), Anchor::Middle);
            left += 28.0;
        }
        let width = (COLUMN - 16.0 - left) / classes.len() as f64;
        for (i, &class) in classes.iter().enumerate() {
            let x = left + width * i as f64;
            let square = [x, top, x + width, top + 10.0];
            canvas.rectangle(square, Scale::colour(class));
            canvas.rectangle(square, line(BLACK, 0.3));
        }
        if classes.is_empty() {
            return;
        }
        // The ends, 0, and every second other where there is room.
        for (i, edge) in edges.iter().enumerate() {
            let ends = i == 0 || i + 1 == edges.len() || *edge == 0.0;
            if ends || (edges.len() <= SHADES + 1 && i % 2 == 0) {
                let text =
                    if *edge == 0.0 { "0".to_string() } else { format!("{edge:.2}").replace('-', "−") };
                canvas.text(Words::plain(&text), (left + width * i as f64, top + 17.0), Anchor::Middle);
            }
        }
    }
}

/// The first classes, of points that are on no periodic motion.
const GREYS: [u8; 3] = [255, 90, 170];

/// How high a panel is.
const HIGH: f64 = 190.0;

/// As many of them have no motion that stays: behind a stop, beyond every bound.
const NO_MOTION: usize = 2;

/// White, greys, then the palette; classes beyond it repeat.
fn colour(class: usize) -> Colour {
    const COLOURS: [Colour; 7] = [BLUE, ORANGE, GREEN, PINK, SKY, RED, YELLOW];
    match GREYS.get(class) {
        Some(&grey) => Colour(grey, grey, grey),
        None => COLOURS[(class - GREYS.len()) % COLOURS.len()],
    }
}

fn draw(grid: &Grid, axes: [&str; 2], [title, about]: [&str; 2]) -> Canvas {
    let mut legend = Legend::default();
    let shown: Vec<usize> = (0..grid.names.len()).filter(|class| grid.cells.contains(class)).collect();
    for &class in &shown {
        legend.add(Words::plain(&grid.names[class]), move |canvas: &mut Canvas, (x, y): At| {
            let square = [x - 8.0, y - 3.5, x + 8.0, y + 3.5];
            canvas.rectangle(square, colour(class));
            canvas.rectangle(square, line(BLACK, 0.3));
        });
    }
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(COLUMN, HIGH + high, title, about);
    panel(&mut canvas, 0.0, (&grid.x, &grid.y, &grid.cells), axes, colour);
    legend.draw(&mut canvas, (4.0, HIGH - 1.0), COLUMN - 8.0);
    canvas
}

/// Draws cells, row by row, in a frame whose top is there.
fn panel(
    canvas: &mut Canvas,
    top: f64,
    (x, y, cells): (&[f64], &[f64], &[usize]),
    axes: [&str; 2],
    ink: impl Fn(usize) -> Colour,
) {
    let (columns, rows) = (x.len(), y.len());
    // A single row or column is as wide as one.
    let span = |all: &[f64]| {
        let half =
            if all.len() > 1 { (all[all.len() - 1] - all[0]) / (all.len() - 1) as f64 / 2.0 } else { 0.5 };
        (all[0] - half, all[all.len() - 1] + half)
    };
    let ((x0, x1), (y0, y1)) = (span(x), span(y));
    let frame = PlotFrame::new(
        [2.0, top + 2.0, COLUMN - 2.0, top + HIGH - 2.0],
        Axis::linear(axes[0], (x0, x1), 6),
        Axis::linear(axes[1], (y0, y1), 6),
    );
    let edge = |i: usize, j: usize| {
        (x0 + (x1 - x0) * i as f64 / columns as f64, y0 + (y1 - y0) * j as f64 / rows as f64)
    };
    let classes: BTreeSet<usize> = cells.iter().copied().collect();
    // All of a class is one shape, so that nothing shines through: runs of it in a row are rectangles.
    for class in classes {
        let mut runs = Vec::new();
        for (j, row) in cells.chunks(columns).enumerate() {
            let mut start = 0;
            for run in row.chunk_by(|a, b| a == b) {
                let end = start + run.len();
                if run[0] == class {
                    runs.push(frame.path([
                        edge(start, j),
                        edge(end, j),
                        edge(end, j + 1),
                        edge(start, j + 1),
                    ]));
                }
                start = end;
            }
        }
        canvas.polygons(runs, ink(class));
    }
    frame.draw(canvas);
}
