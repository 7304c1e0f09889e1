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

/// Writes `name`.svg and `name`.csv into `folder`: a row per point, with the name of its curve, its stability
/// and its label.
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
        .margin_right(if curves.len() > 1 { 150 } else { 60 })
        .x_label_area_size(190)
        .y_label_area_size(340)
        .build_cartesian_2d(left..right, bottom..top)?;
    labelled_axes(&mut chart, 6, axes)?;
    let blue = RGBColor(0, 114, 178).filled();
    for at in scatter.iter().flat_map(|set| &set.at) {
        root.draw(&Circle::new(chart.backend_coord(at), 2, blue))?;
    }
    let pixels: Vec<Vec<(i32, i32)>> = curves
        .iter()
        .map(|curve| curve.at.iter().map(|at| chart.backend_coord(&(at.0, at.1))).collect())
        .collect();
    let mut labels = Labels::new(&pixels, 1500 - 190 - 30);
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
            labels.wanted.push(((x, y), text.clone()));
        }
    }
    // Names stand at the right ends of curves that go on to the right, one for ends that are close; else
    // beside the curve.
    let mut ends: Vec<((i32, i32), String)> = Vec::new();
    let far_right = pixels.iter().flatten().map(|at| at.0).max().unwrap_or(0);
    for (curve, path) in curves.iter().zip(&pixels) {
        let (Some(name), Some(&end)) = (short(&curve.name), path.iter().max_by_key(|at| at.0)) else {
            continue;
        };
        if curves.len() == 1 || end.0 < far_right - 20 {
            labels.wanted.push((path[path.len() * 2 / 3], name));
        } else if let Some((_, names)) = ends.iter_mut().find(|(at, _)| (at.1 - end.1).abs() < 50) {
            *names += &format!(" {name}");
        } else {
            ends.push((end, name));
        }
    }
    for ((x, y), names) in ends {
        root.draw(&Text::new(names, (x + 16, y), style(FONT - 10, HPos::Left, VPos::Center)))?;
    }
    for (text, at) in labels.placed() {
        root.draw(&Text::new(text, at, style(FONT - 10, HPos::Left, VPos::Center)))?;
    }
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}

/// What stands at a curve: what bifurcates there, or the pattern at the end of its name, in words if it has
/// no impacts. None if the name has neither.
fn short(name: &str) -> Option<String> {
    if let Some((kind, _)) = name.split_once(" of the impact pattern") {
        return Some(kind.into());
    }
    let pattern = name.strip_suffix(')')?.rsplit_once('(')?.1;
    Some(if pattern.starts_with("free") { "no impact".into() } else { format!("({pattern})") })
}

/// Texts beside points, placed where they cover no curve and no other text, as far as there is room.
struct Labels {
    /// Points of all curves, close together.
    points: Vec<(i32, i32)>,
    /// The largest y of the panel.
    bottom: i32,
    /// Point and text.
    wanted: Vec<((i32, i32), String)>,
}

impl Labels {
    fn new(paths: &[Vec<(i32, i32)>], bottom: i32) -> Labels {
        let between = |pair: &[(i32, i32)]| {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let steps = ((x1 - x0).abs().max((y1 - y0).abs()) / 10).max(1);
            (0..=steps).map(move |i| (x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps))
        };
        let points = paths.iter().flat_map(|path| path.windows(2).flat_map(between)).collect();
        Labels { points, bottom, wanted: Vec::new() }
    }

    /// Each text with its left end, half-way up.
    fn placed(&self) -> Vec<(String, (i32, i32))> {
        let mut boxes: Vec<[i32; 4]> = Vec::new();
        let mut placed = Vec::new();
        for ((x, y), text) in &self.wanted {
            let (wide, half) = (text.chars().count() as i32 * 30, 34);
            // Beside, above and below the point, ever farther away.
            let far = |d: i32| {
                let (right, left, middle) = (30, -30 - wide, -wide / 2);
                [(right, -d), (right, d), (left, -d), (left, d), (middle, -d - 20), (middle, d + 20)]
            };
            let around = [(36, 0), (-36 - wide, 0)];
            let spot = |(dx, dy): (i32, i32)| [x + dx, x + dx + wide, y + dy - half, y + dy + half];
            let cost = |spot: &[i32; 4]| {
                let [left, right, top, bottom] = *spot;
                let outside = left < 300 || right > WIDTH as i32 - 20 || top < 10 || bottom > self.bottom;
                let inside =
                    |&&(x, y): &&(i32, i32)| (left..=right).contains(&x) && (top..=bottom).contains(&y);
                let meets = |other: &&[i32; 4]| {
                    left < other[1] && other[0] < right && top < other[3] && other[2] < bottom
                };
                2000 * usize::from(outside)
                    + self.points.iter().filter(inside).count()
                    + 300 * boxes.iter().filter(meets).count()
            };
            let spots =
                far(44).into_iter().chain(around).chain([90, 140, 190, 240].into_iter().flat_map(far));
            let best = spots.map(spot).min_by_key(cost);
            let Some(best) = best else { continue };
            placed.push((text.clone(), (best[0], (best[2] + best[3]) / 2)));
            boxes.push(best);
        }
        placed
    }
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
