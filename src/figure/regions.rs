//! The paper's figure 2: the five regions of the (a₁, a₂) plane.

use std::path::Path;

use plotters::{
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{FONT, Picture, WIDTH, axes::plane_axes, save, style};
use crate::error::Result;

const STEPS: u32 = 100;

/// Writes `figure2.svg` and `figure2.csv` into `folder`: regions 1–5 and the lines between them.
///
/// # Errors
/// An I/O error.
pub fn regions(folder: &Path) -> Result<()> {
    let rows: Vec<Vec<String>> = (0..4)
        .flat_map(|line| (0..=STEPS).map(move |i| (line, i)))
        .map(|(line, i)| {
            let (a1, a2) = point(line, i);
            vec![NAMES[line].to_string(), format!("{a1:.4}"), format!("{a2:.4}")]
        })
        .collect();
    save(folder, "figure2", draw(), &["line", "a1", "a2"], &rows)
}

const NAMES: [&str; 4] = ["a1 = -(a2 + 1)", "a1 = -2 sqrt(a2)", "a1 = 2 sqrt(a2)", "a1 = a2 + 1"];

/// Point i of a line; r = √a₂ runs evenly from 0 to 1.
fn point(line: usize, i: u32) -> (f64, f64) {
    let r = f64::from(i) / f64::from(STEPS);
    let a1 = [-(r * r + 1.0), -2.0 * r, 2.0 * r, r * r + 1.0][line];
    (a1, r * r)
}

fn draw() -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 1060)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(30)
        .margin_top(50)
        .margin_right(60)
        .x_label_area_size(190)
        .y_label_area_size(230)
        .build_cartesian_2d(-3f64..3.0, 0f64..1.0)?;
    // Regions 2 and 4, and 3 between them; 1 and 5 stay white.
    let line = |index: usize| (0..=STEPS).map(move |i| point(index, i));
    for (left, right, tint) in
        [(0, 1, RGBColor(213, 232, 226)), (1, 2, RGBColor(250, 236, 204)), (2, 3, RGBColor(204, 227, 240))]
    {
        let outline: Vec<(f64, f64)> =
            line(left).chain(line(right).collect::<Vec<_>>().into_iter().rev()).collect();
        chart.draw_series([Polygon::new(outline, tint.filled())])?;
    }
    plane_axes(&mut chart, 7, 1)?;
    for index in 0..4 {
        chart.draw_series([PathElement::new(line(index).collect::<Vec<_>>(), BLACK.stroke_width(5))])?;
    }
    let text = |words: &str, at: (f64, f64), size: i32, side: HPos| {
        Text::new(words.to_string(), at, style(size, side, VPos::Center))
    };
    let numbers =
        [(2.35, 0.5, "1"), (0.78, 0.055, "2"), (0.0, 0.62, "3"), (-0.78, 0.055, "4"), (-2.35, 0.5, "5")];
    chart.draw_series(numbers.map(|(a1, a2, name)| text(name, (a1, a2), 110, HPos::Center)))?;
    chart.draw_series([
        text("a₁ = a₂ + 1", (1.32, 0.2), FONT - 6, HPos::Left),
        text("a₁ = −(a₂ + 1)", (-1.32, 0.2), FONT - 6, HPos::Right),
        text("a₁ = 2√a₂", (1.12, 0.4), FONT - 6, HPos::Right),
        text("a₁ = −2√a₂", (-1.12, 0.4), FONT - 6, HPos::Left),
        text("complex eigenvalues", (0.0, 0.82), FONT - 6, HPos::Center),
    ])?;
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}
