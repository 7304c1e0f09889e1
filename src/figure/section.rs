//! Stroboscopic (Poincaré) sections: attractors, periodic orbits, and the curve on which the next period
//! grazes a wall.

use std::path::Path;

use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{
    FONT, Picture, WIDTH,
    axes::{labelled_axes, padded},
    save, style,
};
use crate::error::Result;

/// How points are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// Small, for the many points of an attractor that is not periodic.
    Dot,
    /// A square: an orbit without impacts.
    Square,
    /// A ring: a stable orbit with impacts.
    Ring,
    /// A star: an unstable orbit.
    Star,
    /// A line through the points.
    Curve,
    /// A line: a stable manifold.
    StableCurve,
    /// A line: an unstable manifold.
    UnstableCurve,
}

impl Mark {
    fn is_line(self) -> bool {
        matches!(self, Mark::Curve | Mark::StableCurve | Mark::UnstableCurve)
    }
}

/// Points that belong together.
pub struct Points {
    /// What they are, for the legend and the CSV.
    pub name: String,
    /// How they are drawn.
    pub mark: Mark,
    /// Where they are.
    pub at: Vec<(f64, f64)>,
}

/// Writes `name`.svg and `name`.csv into `folder`: a row per point, with the name of its set; `axes` names
/// the coordinates.
///
/// # Errors
/// An I/O error.
pub fn section(sets: &[Points], axes: [&str; 2], folder: &Path, name: &str) -> Result<()> {
    let row = |set: &Points| {
        let set_name = set.name.clone();
        let one = move |(x, y): &(f64, f64)| vec![set_name.clone(), x.to_string(), y.to_string()];
        set.at.iter().map(one).collect::<Vec<_>>()
    };
    let rows: Vec<Vec<String>> = sets.iter().flat_map(row).collect();
    save(folder, name, draw(sets, axes), &["set", "q", "u"], &rows)
}

fn colour(mark: Mark) -> RGBColor {
    match mark {
        Mark::Dot => RGBColor(0, 114, 178),
        Mark::Square => RGBColor(0, 158, 115),
        Mark::Ring => RGBColor(0, 114, 178),
        Mark::Star => RGBColor(213, 94, 0),
        Mark::Curve => BLACK,
        Mark::StableCurve => RGBColor(86, 180, 233),
        Mark::UnstableCurve => RGBColor(230, 159, 0),
    }
}

/// Draws a mark, or for a curve a piece of it as the legend shows it.
fn draw_mark<'a>(
    area: &DrawingArea<SVGBackend<'a>, Shift>,
    mark: Mark,
    (x, y): (i32, i32),
) -> std::result::Result<(), Box<dyn std::error::Error + 'a>> {
    let ink = colour(mark).stroke_width(6);
    let line = |from: (i32, i32), to: (i32, i32)| {
        area.draw(&PathElement::new([(x + from.0, y + from.1), (x + to.0, y + to.1)], ink))
    };
    match mark {
        Mark::Dot => area.draw(&Circle::new((x, y), 4, colour(mark).filled()))?,
        Mark::Square => {
            let corners = [(-17, -17), (17, -17), (17, 17), (-17, 17), (-17, -20)];
            area.draw(&PathElement::new(corners.map(|corner| (x + corner.0, y + corner.1)), ink))?;
        }
        Mark::Ring => area.draw(&Circle::new((x, y), 18, ink))?,
        Mark::Star => {
            line((0, -22), (0, 22))?;
            line((-19, -11), (19, 11))?;
            line((-19, 11), (19, -11))?;
        }
        Mark::Curve | Mark::StableCurve | Mark::UnstableCurve => line((-40, 0), (40, 0))?,
    }
    Ok(())
}

const LINE: i32 = 92;

fn draw(sets: &[Points], axes: [&str; 2]) -> Picture {
    let mut svg = String::new();
    // The legend stands below the picture, a line a set.
    let mut legend: Vec<&Points> = Vec::new();
    for set in sets {
        if legend.iter().all(|other| other.name != set.name) {
            legend.push(set);
        }
    }
    let height = 1500 + 40 + LINE as u32 * legend.len() as u32;
    let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
    root.fill(&WHITE)?;
    let (picture, key) = root.split_vertically(1500);
    // A curve may leave the picture.
    let shown = || sets.iter().filter(|set| !set.mark.is_line()).flat_map(|set| set.at.iter());
    let ((left, right), (bottom, top)) = (padded(shown().map(|at| at.0)), padded(shown().map(|at| at.1)));
    let mut chart = ChartBuilder::on(&picture)
        .margin(30)
        .margin_right(60)
        .x_label_area_size(190)
        .y_label_area_size(280)
        .build_cartesian_2d(left..right, bottom..top)?;
    labelled_axes(&mut chart, 6, axes)?;
    let inside = |&(x, y): &(f64, f64)| (left..=right).contains(&x) && (bottom..=top).contains(&y);
    for set in sets {
        if set.mark.is_line() {
            // Only what is inside; a part ends where the curve leaves.
            for part in set.at.split(|at| !inside(at)).filter(|part| part.len() > 1) {
                let path: Vec<(i32, i32)> = part.iter().map(|at| chart.backend_coord(at)).collect();
                root.draw(&PathElement::new(path, colour(set.mark).stroke_width(6)))?;
            }
            continue;
        }
        for at in &set.at {
            draw_mark(&root, set.mark, chart.backend_coord(at)).map_err(|error| error.to_string())?;
        }
    }
    for (i, set) in (0..).zip(legend) {
        let y = LINE / 2 + i * LINE;
        draw_mark(&key, set.mark, (330, y)).map_err(|error| error.to_string())?;
        key.draw(&Text::new(set.name.clone(), (400, y), style(FONT, HPos::Left, VPos::Center)))?;
    }
    root.present()?;
    drop(chart);
    drop((picture, key));
    drop(root);
    Ok(svg)
}
