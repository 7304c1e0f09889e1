//! The paper's figure 2: the five regions of the (a₁, a₂) plane.

use super::{
    FigurePlace,
    canvas::{Anchor, BLACK, COLUMN, Canvas, Colour, line},
    frame::{Axis, PlotFrame},
};
use crate::error::Result;

const STEPS: u32 = 100;

/// Writes the picture and its data: regions 1–5 and the lines between them.
///
/// # Errors
/// An I/O error.
pub fn regions(place: &FigurePlace) -> Result<()> {
    let rows: Vec<Vec<String>> = (0..4)
        .flat_map(|line| (0..=STEPS).map(move |i| (line, i)))
        .map(|(line, i)| {
            let (a1, a2) = point(line, i);
            vec![NAMES[line].to_string(), format!("{a1:.4}"), format!("{a2:.4}")]
        })
        .collect();
    place.save(&draw(), &["line", "a1", "a2"], &rows)
}

const NAMES: [&str; 4] = ["a1 = -(a2 + 1)", "a1 = -2 sqrt(a2)", "a1 = 2 sqrt(a2)", "a1 = a2 + 1"];

/// Point i of a line; r = √a₂ runs evenly from 0 to 1.
fn point(line: usize, i: u32) -> (f64, f64) {
    let r = f64::from(i) / f64::from(STEPS);
    let a1 = [-(r * r + 1.0), -2.0 * r, 2.0 * r, r * r + 1.0][line];
    (a1, r * r)
}

fn draw() -> Canvas {
    let mut canvas = Canvas::new(
        COLUMN,
        132.0,
        "The five regions of the (a1, a2) plane",
        "Lines a1 = ±(a2 + 1) and the parabola a1 = ±2 sqrt(a2) divide 0 < a2 < 1 into regions 1 to 5, from right \
         to left; in region 3, inside the parabola, the eigenvalues are complex.",
    );
    let frame = PlotFrame::new(
        [2.0, 4.0, COLUMN - 2.0, 130.0],
        Axis::linear("a₁", (-3.0, 3.0), 6),
        Axis::linear("a₂", (0.0, 1.0), 5),
    );
    // Regions 2 and 4, and 3 between them; 1 and 5 stay white.
    let side = |index: usize| (0..=STEPS).map(move |i| point(index, i));
    for (left, right, tint) in
        [(0, 1, Colour(213, 232, 226)), (1, 2, Colour(250, 236, 204)), (2, 3, Colour(204, 227, 240))]
    {
        let outline = side(left).chain(side(right).collect::<Vec<_>>().into_iter().rev());
        canvas.polygon(frame.path(outline), tint);
    }
    frame.draw(&mut canvas);
    canvas.lines((0..4).map(|index| frame.path(side(index))).collect(), line(BLACK, 0.8));
    for (a1, a2, name) in
        [(2.35, 0.5, "1"), (0.78, 0.055, "2"), (0.0, 0.65, "3"), (-0.78, 0.055, "4"), (-2.35, 0.5, "5")]
    {
        canvas.sized(name, frame.at((a1, a2)), Anchor::Middle, 12.0);
    }
    for (words, at, anchor) in [
        ("a₁ = a₂ + 1", (1.32, 0.2), Anchor::Start),
        ("a₁ = −(a₂ + 1)", (-1.32, 0.2), Anchor::End),
        ("a₁ = 2√a₂", (1.2, 0.46), Anchor::End),
        ("a₁ = −2√a₂", (-1.2, 0.46), Anchor::Start),
        ("complex eigenvalues", (0.0, 0.84), Anchor::Middle),
    ] {
        canvas.text(words, frame.at(at), anchor);
    }
    canvas
}
