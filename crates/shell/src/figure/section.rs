//! Stroboscopic (Poincaré) sections: attractors, periodic orbits, and the curve on which the next period
//! grazes a wall.

use super::{
    FigurePlace, View,
    canvas::{At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, ORANGE, RED, SKY, Words, line},
    frame::{Axis, PlotFrame, padded},
    legend::Legend,
};
use crate::error::{Error, Result};

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
    /// A ring: an unstable orbit where there is no other orbit.
    UnstableRing,
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

/// Writes the picture and its data: a row per point, with the name of its set; `axes` names the coordinates.
///
/// # Errors
/// An I/O error.
pub fn section(sets: &[Points], axes: [&str; 2], place: &FigurePlace) -> Result<()> {
    let row = |set: &Points| {
        let set_name = set.name.clone();
        let one = move |(x, y): &(f64, f64)| vec![set_name.clone(), x.to_string(), y.to_string()];
        set.at.iter().map(one).collect::<Vec<_>>()
    };
    let rows: Vec<Vec<String>> = sets.iter().flat_map(row).collect();
    let canvas = match place.view.is_whole() {
        true => draw(sets, axes, &place.view),
        false => draw(&seen(sets, axes, &place.view)?, axes, &place.view),
    };
    place.save(&canvas, &["set", "q", "u"], &rows)
}

/// What of the sets a view shows.
fn seen(sets: &[Points], axes: [&str; 2], view: &View) -> Result<Vec<Points>> {
    let plane = view.on(axes)?;
    let mut seen = Vec::new();
    for Points { name, mark, at } in sets {
        let named = |at| Points { name: name.clone(), mark: *mark, at };
        if mark.is_line() {
            let curve: Vec<_> = at.iter().map(|&(x, y)| (x, y, ())).collect();
            let pieces = plane.pieces(&curve).into_iter();
            seen.extend(pieces.map(|piece| named(piece.iter().map(|at| (at.0, at.1)).collect())));
        } else {
            seen.push(named(plane.points(at)));
        }
    }
    seen.retain(|set| !set.at.is_empty());
    if seen.is_empty() {
        return Err(Error::input("nothing is within the limits of the picture: choose others"));
    }
    Ok(seen)
}

fn colour(mark: Mark) -> Colour {
    match mark {
        Mark::Dot | Mark::Ring => BLUE,
        Mark::Square => GREEN,
        Mark::Star | Mark::UnstableRing => RED,
        Mark::Curve => BLACK,
        Mark::StableCurve => SKY,
        Mark::UnstableCurve => ORANGE,
    }
}

/// The width of the lines of curves and marks.
const THIN: f64 = 0.7;

/// Draws marks, or for curves a piece as the legend shows it.
fn draw_marks(canvas: &mut Canvas, mark: Mark, at: Vec<At>) {
    let ink = colour(mark);
    let around = |corners: &[[f64; 2]]| -> Vec<Vec<At>> {
        let shape = |&(x, y): &At| corners.iter().map(|[dx, dy]| (x + dx, y + dy)).collect();
        at.iter().map(shape).collect()
    };
    match mark {
        Mark::Dot => canvas.discs(at, 0.45, ink),
        Mark::Square => {
            canvas.polygons(around(&[[-2.2, -2.2], [2.2, -2.2], [2.2, 2.2], [-2.2, 2.2]]), line(ink, THIN))
        }
        Mark::Ring | Mark::UnstableRing => canvas.discs(at, 2.4, line(ink, THIN)),
        Mark::Star => {
            for [x, y] in [[0.0, 2.8], [2.4, 1.4], [2.4, -1.4]] {
                canvas.lines(around(&[[-x, -y], [x, y]]), line(ink, THIN));
            }
        }
        Mark::Curve | Mark::StableCurve | Mark::UnstableCurve => {
            canvas.lines(around(&[[-8.0, 0.0], [8.0, 0.0]]), line(ink, THIN));
        }
    }
}

fn draw(sets: &[Points], axes: [&str; 2], view: &View) -> Canvas {
    let mut legend = Legend::default();
    for set in sets {
        legend.add(Words::plain(&set.name), |canvas: &mut Canvas, (x, y): At| {
            // A single dot would be overlooked.
            let sample = if set.mark == Mark::Dot { -3..=3 } else { 0..=0 };
            draw_marks(canvas, set.mark, sample.map(|i| (x + 2.0 * f64::from(i), y)).collect());
        });
    }
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(
        COLUMN,
        190.0 + high,
        "A stroboscopic section: one point per forcing period",
        &format!("{} over {}: {}.", axes[1], axes[0], names(sets)),
    );
    // A curve may leave the picture.
    let shown = || sets.iter().filter(|set| !set.mark.is_line()).flat_map(|set| set.at.iter());
    let frame = PlotFrame::new(
        [2.0, 2.0, COLUMN - 2.0, 188.0],
        Axis::linear(axes[0], view.x.unwrap_or_else(|| padded(shown().map(|at| at.0))), 6),
        Axis::linear(axes[1], view.y.unwrap_or_else(|| padded(shown().map(|at| at.1))), 6),
    );
    canvas.inside(frame.inside(), |canvas| {
        for set in sets.iter().filter(|set| set.mark.is_line()) {
            canvas.line(frame.path(set.at.iter().copied()), line(colour(set.mark), THIN));
        }
    });
    // The many dots first, so that orbits stand out.
    for many in [true, false] {
        for set in sets.iter().filter(|set| !set.mark.is_line() && (set.mark == Mark::Dot) == many) {
            draw_marks(&mut canvas, set.mark, frame.path(set.at.iter().copied()));
        }
    }
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 189.0), COLUMN - 8.0);
    canvas
}

/// The names of the sets, each once.
fn names(sets: &[Points]) -> String {
    let mut names: Vec<&str> = sets.iter().map(|set| set.name.as_str()).collect();
    names.dedup();
    names.join("; ")
}
