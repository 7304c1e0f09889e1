//! A plane whose points belong to a few classes: basins of attraction.

use std::path::Path;

use plotters::{
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{FONT, Picture, WIDTH, axes::labelled_axes, save, style};
use crate::error::Result;

/// Classes on a grid.
pub struct Grid {
    /// The columns' and the rows' coordinates, evenly spaced.
    pub x: Vec<f64>,
    /// The rows' coordinates.
    pub y: Vec<f64>,
    /// The class of each point, row by row.
    pub cells: Vec<usize>,
    /// What the classes are.
    pub names: Vec<String>,
}

/// Writes `name`.svg and `name`.csv into `folder`.
///
/// # Errors
/// An I/O error.
pub fn grid(grid: &Grid, axes: [&str; 2], folder: &Path, name: &str) -> Result<()> {
    let row = |(i, &class): (usize, &usize)| {
        let (x, y) = (grid.x[i % grid.x.len()], grid.y[i / grid.x.len()]);
        vec![x.to_string(), y.to_string(), grid.names[class].clone()]
    };
    let rows: Vec<Vec<String>> = grid.cells.iter().enumerate().map(row).collect();
    save(folder, name, draw(grid, axes), &["q", "u", "ends"], &rows)
}

/// White, greys, then the palette of Okabe and Ito; classes beyond it repeat.
fn colour(class: usize) -> RGBColor {
    const GREYS: [u8; 3] = [255, 90, 170];
    const COLOURS: [(u8, u8, u8); 7] = [
        (0, 114, 178),
        (230, 159, 0),
        (0, 158, 115),
        (204, 121, 167),
        (86, 180, 233),
        (213, 94, 0),
        (240, 228, 66),
    ];
    match GREYS.get(class) {
        Some(&grey) => RGBColor(grey, grey, grey),
        None => {
            let (r, g, b) = COLOURS[(class - GREYS.len()) % COLOURS.len()];
            RGBColor(r, g, b)
        }
    }
}

const LINE: i32 = 92;

fn draw(grid: &Grid, axes: [&str; 2]) -> Picture {
    let mut svg = String::new();
    let shown: Vec<usize> = (0..grid.names.len()).filter(|class| grid.cells.contains(class)).collect();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 1540 + LINE as u32 * shown.len() as u32))
        .into_drawing_area();
    root.fill(&WHITE)?;
    let (picture, key) = root.split_vertically(1500);
    let (columns, rows) = (grid.x.len(), grid.y.len());
    let (x0, x1, y0, y1) = (grid.x[0], grid.x[columns - 1], grid.y[0], grid.y[rows - 1]);
    let (dx, dy) = ((x1 - x0) / (columns - 1) as f64 / 2.0, (y1 - y0) / (rows - 1) as f64 / 2.0);
    let mut chart = ChartBuilder::on(&picture)
        .margin(30)
        .margin_right(60)
        .x_label_area_size(190)
        .y_label_area_size(280)
        .build_cartesian_2d(x0 - dx..x1 + dx, y0 - dy..y1 + dy)?;
    // Runs of one class in a row are one rectangle, each a unit larger than its share, so that nothing shines
    // through.
    let edge = |i: usize, j: usize| {
        chart.backend_coord(&(x0 - dx + 2.0 * dx * i as f64, y0 - dy + 2.0 * dy * j as f64))
    };
    for (j, row) in grid.cells.chunks(columns).enumerate() {
        let mut start = 0;
        for i in 1..=columns {
            if i == columns || row[i] != row[start] {
                let ((left, bottom), (right, top)) = (edge(start, j), edge(i, j + 1));
                root.draw(&Rectangle::new(
                    [(left, top - 1), (right + 1, bottom)],
                    colour(row[start]).filled(),
                ))?;
                start = i;
            }
        }
    }
    labelled_axes(&mut chart, 6, axes)?;
    for (i, &class) in (0..).zip(&shown) {
        let y = LINE / 2 + i * LINE;
        key.draw(&Rectangle::new([(290, y - 30), (370, y + 30)], colour(class).filled()))?;
        key.draw(&Rectangle::new([(290, y - 30), (370, y + 30)], BLACK.stroke_width(2)))?;
        key.draw(&Text::new(grid.names[class].clone(), (400, y), style(FONT, HPos::Left, VPos::Center)))?;
    }
    root.present()?;
    drop(chart);
    drop((picture, key));
    drop(root);
    Ok(svg)
}
