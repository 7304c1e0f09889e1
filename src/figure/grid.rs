//! A plane whose points belong to a few classes: basins of attraction, maps over two parameters.

use super::{
    FigurePlace,
    canvas::{At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, ORANGE, PINK, RED, SKY, Words, YELLOW, line},
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

/// A plane of parameters whose points belong to a few classes.
pub type ParameterMap = Grid;

/// Writes the picture of a map; its data, a table of its own, is the caller's.
///
/// # Errors
/// An I/O error.
pub fn parameter_map(map: &ParameterMap, axes: [&str; 2], place: &FigurePlace) -> Result<()> {
    let (columns, step) = (map.x.len(), map.x.len().max(map.y.len()).div_ceil(DRAWN));
    let thin = |all: &[f64]| all.iter().copied().step_by(step).collect();
    let cells = map.cells.chunks(columns).step_by(step).flat_map(|row| row.iter().copied().step_by(step));
    let drawn = Grid { x: thin(&map.x), y: thin(&map.y), cells: cells.collect(), names: map.names.clone() };
    let about = "Each point of a grid of parameters has the colour of the period of the motion there.";
    place.draw(&draw(&drawn, axes, ["Attractors over two parameters", about]))
}

/// White, greys, then the palette; classes beyond it repeat.
fn colour(class: usize) -> Colour {
    const GREYS: [u8; 3] = [255, 90, 170];
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
    let mut canvas = Canvas::new(COLUMN, 190.0 + high, title, about);
    let (columns, rows) = (grid.x.len(), grid.y.len());
    // A single row or column is as wide as one.
    let span = |all: &[f64]| {
        let half =
            if all.len() > 1 { (all[all.len() - 1] - all[0]) / (all.len() - 1) as f64 / 2.0 } else { 0.5 };
        (all[0] - half, all[all.len() - 1] + half)
    };
    let ((x0, x1), (y0, y1)) = (span(&grid.x), span(&grid.y));
    let frame = PlotFrame::new(
        [2.0, 2.0, COLUMN - 2.0, 188.0],
        Axis::linear(axes[0], (x0, x1), 6),
        Axis::linear(axes[1], (y0, y1), 6),
    );
    let edge = |i: usize, j: usize| {
        (x0 + (x1 - x0) * i as f64 / columns as f64, y0 + (y1 - y0) * j as f64 / rows as f64)
    };
    // All of a class is one shape, so that nothing shines through: runs of it in a row are rectangles.
    for &class in &shown {
        let mut runs = Vec::new();
        for (j, row) in grid.cells.chunks(columns).enumerate() {
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
        canvas.polygons(runs, colour(class));
    }
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 189.0), COLUMN - 8.0);
    canvas
}
