//! Branches of periodic orbits over a parameter, with attractors behind them: stable solid, unstable broken.

use std::path::Path;

use plotters::{
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{
    FONT, Picture, WIDTH,
    axes::{labelled_axes, padded},
    save, style,
};
use crate::error::Result;

/// A branch as it is drawn.
pub struct DrawnBranch {
    /// What it is, for the CSV.
    pub name: String,
    /// Parameter, displacement, whether stable.
    pub at: Vec<(f64, f64, bool)>,
    /// Labels: parameter, displacement, text.
    pub labels: Vec<(f64, f64, String)>,
}

/// Points of attractors.
pub struct Scatter {
    /// What they are, for the CSV.
    pub name: String,
    /// Parameter, displacement.
    pub at: Vec<(f64, f64)>,
}

/// Writes `name`.svg and `name`.csv into `folder`: a row per point, with the name of its curve, its stability and its label.
///
/// # Errors
/// An I/O error.
pub fn branches(
    curves: &[DrawnBranch],
    scatter: &[Scatter],
    axes: [&str; 2],
    folder: &Path,
    name: &str,
) -> Result<()> {
    let mut rows = Vec::new();
    for curve in curves {
        for (x, y, stable) in &curve.at {
            let label = curve.labels.iter().find(|label| (label.0, label.1) == (*x, *y));
            rows.push(vec![
                curve.name.clone(),
                x.to_string(),
                y.to_string(),
                if *stable { "stable" } else { "unstable" }.to_string(),
                label.map_or(String::new(), |label| label.2.clone()),
            ]);
        }
    }
    for set in scatter {
        let row = |(x, y): &(f64, f64)| {
            vec![set.name.clone(), x.to_string(), y.to_string(), "attracting".into(), String::new()]
        };
        rows.extend(set.at.iter().map(row));
    }
    save(folder, name, draw(curves, scatter, axes), &["set", "parameter", "q", "stability", "label"], &rows)
}

/// Lengths of a dash and of the gap after it.
const DASH: [f64; 2] = [34.0, 20.0];

fn draw(curves: &[DrawnBranch], scatter: &[Scatter], axes: [&str; 2]) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 1500)).into_drawing_area();
    root.fill(&WHITE)?;
    let all = || {
        let lines = curves.iter().flat_map(|curve| curve.at.iter().map(|at| (at.0, at.1)));
        lines.chain(scatter.iter().flat_map(|set| set.at.iter().copied()))
    };
    let ((left, right), (bottom, top)) = (padded(all().map(|at| at.0)), padded(all().map(|at| at.1)));
    let mut chart = ChartBuilder::on(&root)
        .margin(30)
        .margin_right(60)
        .x_label_area_size(190)
        .y_label_area_size(280)
        .build_cartesian_2d(left..right, bottom..top)?;
    labelled_axes(&mut chart, 6, axes)?;
    let blue = RGBColor(0, 114, 178).filled();
    for at in scatter.iter().flat_map(|set| &set.at) {
        root.draw(&Circle::new(chart.backend_coord(at), 2, blue))?;
    }
    let mut marked = Vec::new();
    for curve in curves {
        // A stretch has the stability that both its ends have, or of two the one that is not the event's.
        let mut end = 0;
        for stretch in curve.at.chunk_by(|a, b| a.2 == b.2) {
            end += stretch.len();
            let next = curve.at.get(end);
            let path: Vec<(i32, i32)> =
                stretch.iter().chain(next).map(|at| chart.backend_coord(&(at.0, at.1))).collect();
            let pieces = if stretch[0].2 { vec![path] } else { dashes(&path) };
            for piece in pieces {
                root.draw(&PathElement::new(piece, BLACK.stroke_width(6)))?;
            }
        }
        for (x, y, text) in &curve.labels {
            let (x, y) = chart.backend_coord(&(*x, *y));
            // Where branches meet, the first to be drawn says it for all.
            if marked.iter().any(|(a, b): &(i32, i32)| (a - x).abs() + (b - y).abs() < 60) {
                continue;
            }
            marked.push((x, y));
            root.draw(&Circle::new((x, y), 12, BLACK.filled()))?;
            let anchor = if x > 1500 { HPos::Right } else { HPos::Left };
            let shift = if x > 1500 { -24 } else { 24 };
            let rising = rising(curve.at.iter().map(|at| chart.backend_coord(&(at.0, at.1))), (x, y));
            // Beside the curve: below it where it goes up on the text's side.
            let below = rising == (shift > 0);
            let place = (x + shift, if below { y + 36 } else { y - 36 });
            root.draw(&Text::new(text.clone(), place, style(FONT - 10, anchor, VPos::Center)))?;
        }
    }
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}

/// Whether a path goes up to the right where it passes a point, by the neighbours of its vertex that is nearest; y counts downwards.
fn rising(path: impl Iterator<Item = (i32, i32)>, (x, y): (i32, i32)) -> bool {
    let all: Vec<(i32, i32)> = path.collect();
    let far = |at: &(i32, i32)| (at.0 - x).abs() + (at.1 - y).abs();
    let Some(nearest) = (0..all.len()).min_by_key(|&i| far(&all[i])) else { return false };
    let (before, after) = (all[nearest.saturating_sub(1)], all[(nearest + 1).min(all.len() - 1)]);
    i64::from(after.0 - before.0) * i64::from(after.1 - before.1) < 0
}

/// A path broken into dashes.
fn dashes(path: &[(i32, i32)]) -> Vec<Vec<(i32, i32)>> {
    let (mut all, mut dash, mut left, mut on) = (Vec::new(), Vec::new(), DASH[0], true);
    for pair in path.windows(2) {
        let (mut from, to) = ((f64::from(pair[0].0), f64::from(pair[0].1)), pair[1]);
        let to = (f64::from(to.0), f64::from(to.1));
        loop {
            let rest = (to.0 - from.0).hypot(to.1 - from.1);
            if on {
                dash.push((from.0.round() as i32, from.1.round() as i32));
            }
            if rest < left {
                left -= rest;
                break;
            }
            let part = left / rest;
            from = (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1));
            if on {
                dash.push((from.0.round() as i32, from.1.round() as i32));
                all.push(std::mem::take(&mut dash));
            }
            on = !on;
            left = DASH[usize::from(!on)];
        }
    }
    if let (true, Some(&last)) = (on, path.last()) {
        dash.push(last);
        all.push(dash);
    }
    all
}
