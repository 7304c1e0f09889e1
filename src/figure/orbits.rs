//! Predicted orbits to leading order: figure 3 of the paper, and the orbit of any pattern of any map.

use std::{fs, ops::Range, path::Path};

use num_rational::BigRational;
use plotters::{coord::Shift, prelude::*};

use crate::{
    error::{Error, Result},
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    pattern::{Entry, Map, Pattern, PredictedPoint, Value, predicted_orbit},
};

type Drawn = std::result::Result<(), Box<dyn std::error::Error>>;

const PANEL: (u32, u32) = (520, 400);

/// One orbit and how it is labelled.
struct Panel {
    label: String,
    points: Vec<PredictedPoint>,
    positive: bool,
}

/// Writes `figure3.svg` and `figure3.csv` into `folder`: the complete single-impact orbits of period 15 at
/// (λ₁, λ₂) = (1.5, 0.5), (0.8, 0.5), (−0.5, −1.5), regions 1, 2 and 5, in the normal form (45)–(47).
///
/// # Errors
/// An I/O error.
pub fn orbits(folder: &Path) -> Result<()> {
    // Twice λ₁, λ₂ in tenths; the signs of eµ and γ for which the orbit exists.
    let panels = [(1, (15, 5), true, 1), (2, (8, 5), false, 1), (5, (-5, -15), true, -1)];
    let mut drawn = Vec::new();
    for (region, (l1, l2), positive, gamma) in panels {
        let ratio = |p: i32, q: i32| Entry::from(BigRational::new(p.into(), q.into()));
        let whole = |p| ratio(p, 1);
        let a = vec![vec![ratio(l1 + l2, 10), whole(1)], vec![ratio(-l1 * l2, 100), whole(0)]];
        let map = Map::new(a, vec![whole(0), whole(gamma)], vec![whole(1), whole(0)], whole(1), None)?;
        let sign = if positive { '>' } else { '<' };
        let tenth = |x: i32| format!("{}", f64::from(x) / 10.0).replace('-', "−");
        drawn.push(Panel {
            label: format!("region {region}: λ₁ = {}, λ₂ = {}, eµ {sign} 0", tenth(l1), tenth(l2)),
            points: predicted_orbit(&map, &[15], positive)?,
            positive,
        });
    }
    write(folder, "figure3", &drawn)
}

/// Writes `orbit.svg` and `orbit.csv` into `folder`: the orbit of a pattern, in the first two coordinates.
/// `side` is the sign of eµ for which it exists; without one the solution of (32) is drawn for eµ > 0 and
/// labelled so.
///
/// # Errors
/// As [`predicted_orbit`]; an I/O error.
pub fn orbit(map: &Map, pattern: &Pattern, side: Option<bool>, folder: &Path) -> Result<()> {
    let positive = side.unwrap_or(true);
    let points = predicted_orbit(map, pattern.periods(), positive)?;
    let what = match side {
        Some(true) => "exists for eµ > 0",
        Some(false) => "exists for eµ < 0",
        None => "existence not shown; drawn for eµ > 0",
    };
    write(folder, "orbit", &[Panel { label: format!("pattern ({pattern}): {what}"), points, positive }])
}

fn write(folder: &Path, name: &str, panels: &[Panel]) -> Result<()> {
    fs::create_dir_all(folder).map_err(|error| Error::io("create", folder, error))?;
    let picture = draw(panels).map_err(|error| Error::from(std::io::Error::other(error.to_string())))?;
    write_file(&folder.join(format!("{name}.svg")), |out| Ok(out.write_all(picture.as_bytes())?))?;
    let size = panels[0].points[0].x.len();
    // A column's name lives as long as the program; these few may.
    const NAMES: [&str; 8] = ["x1", "x2", "x3", "x4", "x5", "x6", "x7", "x8"];
    let shown = size.min(NAMES.len());
    let mut columns: Vec<Column> = ["panel", "sign_emu", "i", "k", "h"]
        .iter()
        .chain(&NAMES[..shown])
        .map(|name| Column::new(name, name, 0))
        .collect();
    if size > shown {
        columns.push(Column::new("further_x", "further_x", 0));
    }
    write_file(&folder.join(format!("{name}.csv")), |out| {
        let mut table = TableWriter::new(out, TableFormat::Csv, "grazing-orbit 1", columns)?;
        for (panel, number) in panels.iter().zip(1..) {
            for point in &panel.points {
                let numbers: Vec<String> =
                    std::iter::once(&point.gap).chain(&point.x[..shown]).map(Value::to_string).collect();
                let further: Vec<String> = point.x[shown..].iter().map(Value::to_string).collect();
                let further = further.join(" ");
                let sign = if panel.positive { 1 } else { -1 };
                let mut cells = vec![
                    TableCell::Int(number),
                    TableCell::Int(sign),
                    TableCell::Int(point.i as i64),
                    TableCell::Int(point.k as i64),
                ];
                cells.extend(numbers.iter().map(|text| TableCell::Text(text)));
                if size > shown {
                    cells.push(TableCell::Text(&further));
                }
                table.row(&cells)?;
            }
        }
        table.finish()
    })
}

fn draw(panels: &[Panel]) -> std::result::Result<String, Box<dyn std::error::Error>> {
    let mut svg = String::new();
    let columns = panels.len().min(2);
    let rows = panels.len().div_ceil(2);
    let size = (PANEL.0 * columns as u32, PANEL.1 * rows as u32 + 30);
    let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    root.fill(&WHITE)?;
    let (top, legend) = root.split_vertically(size.1 - 30);
    for (panel, area) in panels.iter().zip(top.split_evenly((rows, columns))) {
        draw_panel(panel, &area)?;
    }
    let style = ("sans-serif", 15);
    legend.draw(&Circle::new((24, 10), 4, BLACK.filled()))?;
    legend.draw(&Text::new("points of the orbit", (34, 2), style))?;
    legend.draw(&PathElement::new([(180, 10), (206, 10)], JUMP.stroke_width(2)))?;
    legend.draw(&Text::new("impact", (212, 2), style))?;
    legend.draw(&PathElement::new([(280, 10), (306, 10)], GRAZING.stroke_width(2)))?;
    legend.draw(&Text::new("h = 0", (312, 2), style))?;
    legend.draw(&Cross::new((372, 10), 5, BLACK.stroke_width(1)))?;
    legend.draw(&Text::new("fixed point", (383, 2), style))?;
    root.present()?;
    drop((top, legend));
    drop(root);
    Ok(svg)
}

const JUMP: RGBColor = RGBColor(213, 94, 0);
const GRAZING: RGBColor = RGBColor(150, 150, 150);

fn draw_panel(panel: &Panel, area: &DrawingArea<SVGBackend, Shift>) -> Drawn {
    // Drawing only: what is certain stands in the CSV.
    let middle = |value: &Value| {
        let x = value.enclosure();
        x.lo() + (x.hi() - x.lo()) / 2.0
    };
    let place = |point: &PredictedPoint| (middle(&point.x[0]), middle(&point.x[1]));
    let places: Vec<(f64, f64)> = panel.points.iter().map(place).collect();
    let range = |pick: fn(&(f64, f64)) -> f64| -> Range<f64> {
        let all = || places.iter().map(pick).chain([0.0]);
        let (lo, hi) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        let margin = 0.08 * (hi - lo).max(1e-300);
        lo - margin..hi + margin
    };
    let (x, y) = (range(|p| p.0), range(|p| p.1));
    let mut chart = ChartBuilder::on(area)
        .margin(14)
        .margin_top(10)
        .caption(&panel.label, ("sans-serif", 17))
        .x_label_area_size(42)
        .y_label_area_size(58)
        .build_cartesian_2d(x, y.clone())?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(7)
        .y_labels(7)
        .x_label_formatter(&tick)
        .y_label_formatter(&tick)
        .x_desc("x₁ / |eµ|")
        .y_desc("x₂ / |eµ|")
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 16))
        .draw()?;
    // h = 0 is a line in the plane shown only if h depends on x₁ alone there: then every impact lies on it.
    let befores: Vec<f64> = ends(panel).map(|(before, _)| place(before).0).collect();
    let afters: Vec<f64> = ends(panel).map(|(_, after)| place(after).0).collect();
    let first = befores[0];
    if befores.iter().chain(&afters).all(|x| (x - first).abs() <= 1e-9 * first.abs().max(1.0)) {
        chart.draw_series([PathElement::new([(first, y.start), (first, y.end)], GRAZING.stroke_width(1))])?;
    }
    let jumps = ends(panel)
        .map(|(before, after)| PathElement::new([place(before), place(after)], JUMP.stroke_width(2)));
    chart.draw_series(jumps)?;
    chart.draw_series(places.iter().map(|&p| Circle::new(p, 3, BLACK.filled())))?;
    chart.draw_series([Cross::new((0.0, 0.0), 5, BLACK.stroke_width(1))])?;
    // Labels where there is room for them, so that none covers another.
    let mut taken: Vec<(i32, i32)> = Vec::new();
    for (point, &p) in panel.points.iter().zip(&places) {
        let at = chart.backend_coord(&p);
        if taken.iter().all(|other| (other.0 - at.0).abs() > 16 || (other.1 - at.1).abs() > 11) {
            taken.push(at);
            let label = Text::new(point.k.to_string(), (5, -14), ("sans-serif", 12));
            chart.draw_series([EmptyElement::at(p) + label])?;
        }
    }
    Ok(())
}

/// A tick's label: no trailing zeros, no −0.
fn tick(x: &f64) -> String {
    let text = format!("{x:.4}");
    let text = match text.trim_end_matches('0').trim_end_matches('.') {
        "-0" | "0" if x.abs() > 1e-12 => format!("{x:.0e}"),
        "-0" => "0".into(),
        text => text.into(),
    };
    text.replace('-', "−")
}

/// The points just before and just after each impact.
fn ends(panel: &Panel) -> impl Iterator<Item = (&PredictedPoint, &PredictedPoint)> {
    let points = &panel.points;
    let last = points.len();
    points.iter().enumerate().filter_map(move |(index, point)| {
        let next = &points[(index + 1) % last];
        (next.k == 0).then_some((point, next))
    })
}
