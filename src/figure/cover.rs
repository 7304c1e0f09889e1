//! The paper's figure 5: the areas in which orbits of one period exist, straight from the leaves of a checked
//! cover.

use std::{f64::consts::TAU, path::Path};

use num_rational::BigRational;
use num_traits::ToPrimitive;
use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{
    FONT, GREY, Picture, WIDTH,
    axes::{Panel, plane_axes},
    colour,
    iterate::region4,
    label, save, style,
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

/// Writes `figure5.svg` and `figure5.csv` into `folder`: where single-impact orbits of period `n` exist,
/// coloured by case; the upper part again, enlarged. What is coloured in region 3 are the leaves of `cover`,
/// which are the rows of the data. Regions 2 and 4 are drawn from the closed form.
///
/// # Errors
/// An I/O error.
pub fn areas(n: u64, cover: &Cover, folder: &Path) -> Result<()> {
    let mut tiles = Vec::new();
    cover.leaves(|chart, leaf, cell| tiles.push(Tile::new(chart, leaf, chart.bounds(&cell))));
    let rows: Vec<Vec<String>> = tiles.iter().map(Tile::row).collect();
    let columns = ["kind", "sign_emu", "sign_gamma", "r_lower", "r_upper", "s_lower", "s_upper"];
    save(folder, "figure5", draw(n, &tiles), &columns, &rows)
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

/// A tint half-way to white.
fn light(ink: RGBColor) -> RGBColor {
    let mix = |part: u8| part / 2 + 127;
    RGBColor(mix(ink.0), mix(ink.1), mix(ink.2))
}

/// A panel for a₂ between `bottom` and 1.
fn panel<'a, 'b>(
    area: &'a DrawingArea<SVGBackend<'b>, Shift>,
    bottom: f64,
    n: u64,
    tiles: &[Tile],
) -> std::result::Result<Panel<'a, 'b>, Box<dyn std::error::Error + 'a>>
where
    'b: 'a,
{
    let mut chart = ChartBuilder::on(area)
        .margin(30)
        .margin_right(50)
        .x_label_area_size(190)
        .y_label_area_size(250)
        .build_cartesian_2d(-2f64..2.0, bottom..1.0)?;
    // Evenly in r, since a₁ = 2√a₂ is steep at 0.
    let heights = |low: f64, high: f64| {
        let (low, high) = (low.sqrt(), high.sqrt());
        (0..=200).map(move |i| (low + (high - low) * f64::from(i) / 200.0).powi(2))
    };
    let two = heights(bottom, 1.0)
        .map(|a2| (2.0 * a2.sqrt(), a2))
        .chain(heights(bottom, 1.0).map(|a2| (a2 + 1.0, a2)).rev());
    chart.draw_series([Polygon::new(two.collect::<Vec<_>>(), colour(Case::MinusPlus).filled())])?;
    if n % 2 == 1 {
        chart.draw_series([Polygon::new(four(n, bottom), colour(Case::PlusMinus).filled())])?;
    }
    for tile in tiles {
        let (Some(case), Some(outline)) = (tile.case, tile.outline(bottom)) else { continue };
        let ink = if matches!(tile.leaf, Leaf::Edge { .. }) { light(colour(case)) } else { colour(case) };
        chart.draw_series([Polygon::new(outline, ink.filled())])?;
    }
    plane_axes(&mut chart, 5, if bottom > 0.0 { 2 } else { 1 })?;
    let lines: [fn(f64) -> f64; 4] =
        [|a2| -1.0 - a2, |a2| -2.0 * a2.sqrt(), |a2| 2.0 * a2.sqrt(), |a2| 1.0 + a2];
    for line in lines {
        let path: Vec<(f64, f64)> = heights(bottom, 1.0).map(|a2| (line(a2), a2)).collect();
        chart.draw_series([PathElement::new(path, GREY.stroke_width(3))])?;
    }
    Ok(chart)
}

/// The picture with an outline of its own colour round each polygon, one unit to each side: vertices are
/// whole units, and tiles that share a side need not share vertices there.
fn outlined(svg: &str) -> String {
    let mut all = String::with_capacity(svg.len() * 5 / 4);
    for line in svg.split_inclusive('\n') {
        let ink =
            line.strip_prefix("<polygon ").and_then(|rest| rest.split_once("fill=\"")?.1.split_once('"'));
        match ink {
            Some((ink, _)) => {
                all.push_str(&format!("<polygon stroke=\"{ink}\" stroke-width=\"2\" "));
                all.push_str(&line["<polygon ".len()..]);
            }
            None => all.push_str(line),
        }
    }
    all
}

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

fn draw(n: u64, tiles: &[Tile]) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 2300)).into_drawing_area();
    root.fill(&WHITE)?;
    let (legend, rest) = root.split_vertically(100);
    let (upper, lower) = rest.split_vertically(1200);
    let mut x = 250;
    for case in [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus] {
        legend.draw(&Rectangle::new([(x, 35), (x + 60, 85)], colour(case).filled()))?;
        legend.draw(&Text::new(label(case), (x + 80, 60), style(FONT, HPos::Left, VPos::Center)))?;
        x += 340;
    }
    let title = format!("period {n}");
    legend.draw(&Text::new(title, (WIDTH as i32 - 50, 60), style(FONT, HPos::Right, VPos::Center)))?;
    panel(&upper, 0.0, n, tiles).map_err(|error| error.to_string())?;
    panel(&lower, BOTTOM, n, tiles).map_err(|error| error.to_string())?;
    root.present()?;
    drop((legend, upper, lower, rest));
    drop(root);
    // Without this, white shines through between tiles that share a side.
    Ok(outlined(&svg).replacen("<svg ", "<svg shape-rendering=\"crispEdges\" ", 1))
}
