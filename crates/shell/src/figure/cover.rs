//! The paper's figure 5: the areas in which orbits of one period exist, straight from the leaves of a checked
//! cover.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{
    FigurePlace,
    canvas::{Anchor, At, COLUMN, Canvas, Colour, GREY, Paint, line},
    colour,
    frame::PlotFrame,
    iterate::{above, plane_frame, region_lines, region4},
    legend::{Legend, ROW},
    title,
};
use crate::{
    certificate::cover::Leaf,
    error::Result,
    existence::Case,
    search::cover::{Chart, Cover},
};

/// Edge leaves smaller than this in the plane look like lines.
pub const FINEST: f64 = 0.015;
/// The lower panel begins here.
const BOTTOM: f64 = 0.9;

/// Writes the picture and its data: where single-impact orbits of period `n` exist,
/// coloured by case; the upper part again, enlarged. What is coloured in region 3 are the leaves of `cover`,
/// which are the rows of the data. Regions 2 and 4 are drawn from the closed form.
///
/// # Errors
/// An I/O error.
pub fn areas(n: u64, cover: &Cover, place: &FigurePlace) -> Result<()> {
    let mut tiles = Vec::new();
    cover.leaves(|chart, leaf, cell| tiles.push(Tile::new(chart, leaf, chart.bounds(&cell))));
    let rows: Vec<Vec<String>> = tiles.iter().map(Tile::row).collect();
    let columns = ["kind", "sign_emu", "sign_gamma", "r_lower", "r_upper", "s_lower", "s_upper"];
    place.save(&draw(n, &tiles), &columns, &rows)
}

/// A leaf and its box.
struct Tile {
    leaf: Leaf,
    case: Option<Case>,
    bounds: [[BigRational; 2]; 2],
}

impl Tile {
    fn new(chart: &Chart, leaf: Leaf, bounds: [[BigRational; 2]; 2]) -> Tile {
        let has_case = matches!(leaf, Leaf::Orbit { .. } | Leaf::Edge { .. });
        let case = chart.strip.interval.as_ref().filter(|_| has_case).map(|interval| interval.case);
        Tile { leaf, case, bounds }
    }

    fn row(&self) -> Vec<String> {
        let kind = match self.leaf {
            Leaf::None { .. } => "none",
            Leaf::Orbit { .. } => "orbit",
            Leaf::Edge { .. } => "edge",
            Leaf::Open => "open",
        };
        let sign = |of: fn(Case) -> i8| self.case.map_or(String::new(), |case| of(case).to_string());
        let ends = self.bounds.iter().flatten().map(BigRational::to_string);
        [kind.to_string(), sign(Case::sign_emu), sign(Case::sign_gamma)].into_iter().chain(ends).collect()
    }

    fn is_edge(&self) -> bool {
        matches!(self.leaf, Leaf::Edge { .. })
    }

    /// The box as a polygon of the plane, above a height; sides of constant s are arcs of parabolas.
    fn outline(&self, bottom: f64) -> Option<Vec<(f64, f64)>> {
        let [[r0, r1], [s0, s1]] =
            self.bounds.each_ref().map(|ends| ends.each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN)));
        let r0 = r0.max(bottom.sqrt());
        let steps = (((r1 - r0) / 0.005).ceil() as u32).max(1);
        let side = |s: f64| {
            (0..=steps).map(move |i| {
                let r = r0 + (r1 - r0) * f64::from(i) / f64::from(steps);
                (2.0 * r * (s * TAU).cos(), r * r)
            })
        };
        (r0 < r1).then(|| side(s0).chain(side(s1).rev()).collect())
    }
}

/// A panel for a₂ between `bottom` and 1.
fn panel(canvas: &mut Canvas, heights: [f64; 2], bottom: f64, n: u64, tiles: &[Tile]) -> PlotFrame {
    let frame = plane_frame(heights, bottom);
    canvas.inside(frame.inside(), |canvas| {
        // Region 2, between the right arm of the parabola and the line.
        let parabola = above(
            &(0..=200).map(|i| f64::from(i) / 100.0).map(|a1| (a1, a1 * a1 / 4.0)).collect::<Vec<_>>(),
            bottom,
        );
        let mut two: Vec<(f64, f64)> = parabola.into_iter().flatten().collect();
        two.push((1.0 + bottom, bottom));
        let whole = |ink: Colour| Paint { fill: Some(ink), stroke: Some(line(ink, SEAM)) };
        canvas.polygon(frame.path(two), whole(colour(Case::MinusPlus)));
        if n % 2 == 1 {
            canvas.polygon(frame.path(four(n, bottom)), whole(colour(Case::PlusMinus)));
        }
        for case in CASES {
            for edge in [false, true] {
                let of = tiles.iter().filter(|tile| tile.case == Some(case) && tile.is_edge() == edge);
                let outlines = of.filter_map(|tile| tile.outline(bottom)).map(|outline| frame.path(outline));
                let ink = if edge { colour(case).tint(0.5) } else { colour(case) };
                canvas.polygons(outlines.collect(), whole(ink));
            }
        }
        for path in region_lines(bottom) {
            canvas.line(frame.path(path), line(GREY, 0.5));
        }
    });
    frame.draw(canvas);
    frame
}

/// The cases in which orbits of a period n > 2 exist in these regions.
const CASES: [Case; 3] = [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus];
/// Tiles of one colour overlap by half of this: they need not share vertices where they share a side.
const SEAM: f64 = 0.12;

/// The part of region 4, n odd, where b_{n,n−2} > 0, above a height.
fn four(n: u64, bottom: f64) -> Vec<(f64, f64)> {
    // From the bottom up along the curve, and along region 4's other edge where the curve is in region 3.
    let curve = region4(n).into_iter().rev().map(|[a1, a2]| {
        let [a1, a2] = [a1, a2].map(|x| x.to_f64().unwrap_or(f64::NAN));
        (a1, a2)
    });
    let mut right: Vec<(f64, f64)> = curve.filter(|point| point.1 >= bottom).collect();
    let reached = right.last().map_or(bottom, |point| point.1);
    right.extend(
        (0..=50).map(|i| reached + (1.0 - reached) * f64::from(i) / 50.0).map(|a2| (-2.0 * a2.sqrt(), a2)),
    );
    right.extend([(-2.0, 1.0), (-1.0 - bottom, bottom)]);
    right
}

fn draw(n: u64, tiles: &[Tile]) -> Canvas {
    let mut legend = Legend::default();
    let drawn = |case| case == Case::MinusPlus || tiles.iter().any(|tile| tile.case == Some(case));
    for case in CASES.into_iter().filter(|&case| drawn(case)) {
        legend.add(title(case), move |canvas: &mut Canvas, (x, y): At| {
            canvas.rectangle([x - 8.0, y - 3.5, x + 8.0, y + 3.5], colour(case));
        });
    }
    let key = legend.height(COLUMN - 40.0);
    let mut canvas = Canvas::new(
        COLUMN,
        304.0 + key,
        &format!("Where single-impact orbits of period {n} exist"),
        "Above, the (a1, a2) plane for 0 < a2 < 1; below, the part above a2 = 0.9. The colour of an area says for which \
         signs of e mu and gamma the orbit exists; pale are the boxes that an edge passes through.",
    );
    canvas.text(format!("period {n}"), (COLUMN - 4.0, 2.0 + ROW / 2.0), Anchor::End);
    legend.draw(&mut canvas, (36.0, 2.0 + ROW), COLUMN - 40.0);
    panel(&mut canvas, [16.0 + key, 162.0 + key], 0.0, n, tiles);
    panel(&mut canvas, [168.0 + key, 302.0 + key], BOTTOM, n, tiles);
    canvas
}
