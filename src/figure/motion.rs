//! A motion between its walls: displacement over time.

use std::path::Path;

use plotters::{
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{
    FONT, GREY, Picture, WIDTH,
    axes::{labelled_axes, padded},
    save, style,
};
use crate::error::Result;

/// A motion as it is drawn and tabulated.
pub struct Motion {
    /// What stands above the picture.
    pub title: String,
    /// Time in forcing periods, displacement, velocity.
    pub points: Vec<[f64; 3]>,
    /// The walls at the same times.
    pub walls: Vec<Vec<f64>>,
    /// Time in forcing periods and displacement of each impact.
    pub impacts: Vec<(f64, f64)>,
}

/// Writes `name`.svg and `name`.csv into `folder`.
///
/// # Errors
/// An I/O error.
pub fn motion(motion: &Motion, folder: &Path, name: &str) -> Result<()> {
    let row = |point: &[f64; 3]| point.iter().map(f64::to_string).collect();
    let rows: Vec<Vec<String>> = motion.points.iter().map(row).collect();
    save(folder, name, draw(motion), &["periods", "q", "u"], &rows)
}

const BLUE: RGBColor = RGBColor(0, 114, 178);
const RED: RGBColor = RGBColor(213, 94, 0);

fn draw(motion: &Motion) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 1000)).into_drawing_area();
    root.fill(&WHITE)?;
    let heights = || motion.points.iter().map(|point| point[1]).chain(motion.walls.iter().flatten().copied());
    let (bottom, top) = padded(heights());
    let times = (motion.points.first().map_or(0.0, |p| p[0]), motion.points.last().map_or(1.0, |p| p[0]));
    let mut chart = ChartBuilder::on(&root)
        .margin(30)
        .margin_top(110)
        .margin_right(60)
        .x_label_area_size(190)
        .y_label_area_size(260)
        .build_cartesian_2d(times.0..times.1.max(times.0 + 1e-9), bottom..top)?;
    labelled_axes(&mut chart, 8, ["forcing periods", "q"])?;
    for wall in &motion.walls {
        let path: Vec<(f64, f64)> = motion.points.iter().zip(wall).map(|(point, &q)| (point[0], q)).collect();
        chart.draw_series([PathElement::new(path, GREY.stroke_width(9))])?;
    }
    let mut path: Vec<(f64, f64)> = motion.points.iter().map(|point| (point[0], point[1])).collect();
    path.extend(&motion.impacts);
    path.sort_by(|a, b| a.0.total_cmp(&b.0));
    chart.draw_series([PathElement::new(path, BLUE.stroke_width(5))])?;
    chart.draw_series(motion.impacts.iter().map(|&at| Circle::new(at, 13, RED.filled())))?;
    let count = motion.impacts.len();
    let note = match count {
        0 => "no impacts".to_string(),
        1 => "1 impact".to_string(),
        _ => format!("{count} impacts"),
    };
    root.draw(&Text::new(motion.title.clone(), (30, 55), style(FONT, HPos::Left, VPos::Center)))?;
    root.draw(&Text::new(note, (WIDTH as i32 - 30, 55), style(FONT, HPos::Right, VPos::Center)))?;
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}
