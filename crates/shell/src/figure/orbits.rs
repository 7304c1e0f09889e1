//! Predicted orbits to leading order: figure 3 of the paper, and the orbit of any pattern of any map.

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, COLUMN, Canvas, GREY, RED, Words, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{
    error::Result,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    pattern::{Entry, Map, Pattern, PredictedPoint, Value, predicted_orbit},
};
use num_rational::BigRational;

/// One orbit and how it is labelled.
struct Panel {
    label: String,
    points: Vec<PredictedPoint>,
    positive: bool,
}

/// Writes the picture and its data: the complete single-impact orbits of period 15 at
/// (λ₁, λ₂) = (1.5, 0.5), (0.8, 0.5), (−0.5, −1.5), regions 1, 2 and 5, in the normal form (45)–(47).
///
/// # Errors
/// An I/O error.
pub fn orbits(place: &FigurePlace) -> Result<()> {
    // Twice λ₁, λ₂ in tenths; the signs of eµ and γ for which the orbit exists.
    let panels = [(1, (15, 5), true, 1), (2, (8, 5), false, 1), (5, (-5, -15), true, -1)];
    let mut drawn = Vec::new();
    for (region, (l1, l2), positive, gamma) in panels {
        let ratio = |p: i32, q: i32| Entry::from(BigRational::new(p.into(), q.into()));
        let whole = |p| ratio(p, 1);
        let a = vec![vec![ratio(l1 + l2, 10), whole(1)], vec![ratio(-l1 * l2, 100), whole(0)]];
        let map = Map::new(a, vec![whole(0), whole(gamma)], vec![whole(1), whole(0)], whole(1), None)?;
        let side = if positive { "before" } else { "beyond" };
        let tenth = |x: i32| format!("{}", f64::from(x) / 10.0).replace('-', "−");
        drawn.push(Panel {
            label: format!("{side} the touch, region {region}: λ₁ = {}, λ₂ = {}", tenth(l1), tenth(l2)),
            points: predicted_orbit(&map, &[15], positive)?,
            positive,
        });
    }
    write(place, &drawn)
}

/// Writes the picture and its data: the orbit of a pattern, in the first two coordinates.
/// `side` is the sign of eµ for which it exists; without one the solution of (32) is drawn for eµ > 0 and
/// labelled so.
///
/// # Errors
/// As [`predicted_orbit`]; an I/O error.
pub fn orbit(map: &Map, pattern: &Pattern, side: Option<bool>, place: &FigurePlace) -> Result<()> {
    let positive = side.unwrap_or(true);
    let points = predicted_orbit(map, pattern.periods(), positive)?;
    let what = match side {
        Some(true) => "before the touch, eµ > 0",
        Some(false) => "beyond the touch, eµ < 0",
        None => "existence not shown; drawn before the touch",
    };
    write(place, &[Panel { label: format!("pattern ({pattern}): {what}"), points, positive }])
}

fn write(place: &FigurePlace, panels: &[Panel]) -> Result<()> {
    place.draw(&draw(panels))?;
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
    write_file(&place.data(), |out| {
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

/// The height of a panel.
const PANEL: f64 = 172.0;
/// The size of the numbers beside points.
const SMALL: f64 = 6.5;

fn draw(panels: &[Panel]) -> Canvas {
    let mut legend = Legend::default();
    legend.add("point of the orbit", |canvas: &mut Canvas, at: At| canvas.disc(at, 1.2, BLACK));
    legend.add("impact", |canvas: &mut Canvas, (x, y): At| {
        canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(RED, 0.7));
    });
    if panels.iter().any(|panel| panel.grazing().is_some()) {
        legend.add("h = 0", |canvas: &mut Canvas, (x, y): At| {
            canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(GREY, 0.5));
        });
    }
    legend.add("fixed point", fixed);
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(
        COLUMN,
        PANEL * panels.len() as f64 + high + 4.0,
        "Orbits as the local theory predicts them, to leading order",
        "The points of an orbit in the plane of the first two coordinates, numbered from the impact on, and the jump \
         that the impact makes.",
    );
    for (panel, top) in panels.iter().zip((0..).map(|i| 2.0 + PANEL * f64::from(i))) {
        draw_panel(panel, top, &mut canvas);
    }
    legend.draw(&mut canvas, (4.0, PANEL * panels.len() as f64 + 2.0), COLUMN - 8.0);
    canvas
}

fn fixed(canvas: &mut Canvas, (x, y): At) {
    let d = 2.0;
    canvas.lines(
        vec![vec![(x - d, y - d), (x + d, y + d)], vec![(x - d, y + d), (x + d, y - d)]],
        line(BLACK, 0.5),
    );
}

/// In the plane that is shown. Drawing only: what is certain stands in the CSV.
fn place_of(point: &PredictedPoint) -> (f64, f64) {
    let middle = |value: &Value| {
        let x = value.enclosure();
        x.lo() + (x.hi() - x.lo()) / 2.0
    };
    (middle(&point.x[0]), middle(&point.x[1]))
}

impl Panel {
    /// Where h = 0 is, if it is a line x₁ = const in the plane shown: then every impact lies on it.
    fn grazing(&self) -> Option<f64> {
        let all: Vec<f64> =
            ends(self).flat_map(|(before, after)| [before, after].map(|p| place_of(p).0)).collect();
        let first = *all.first()?;
        all.iter().all(|x| (x - first).abs() <= 1e-9 * first.abs().max(1.0)).then_some(first)
    }
}

fn draw_panel(panel: &Panel, top: f64, canvas: &mut Canvas) {
    let places: Vec<(f64, f64)> = panel.points.iter().map(place_of).collect();
    let range = |pick: fn(&(f64, f64)) -> f64| {
        let all = || places.iter().map(pick).chain([0.0]);
        let (lo, hi) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        let margin = 0.09 * (hi - lo).max(1e-300);
        (lo - margin, hi + margin)
    };
    let (x, y) = (range(|p| p.0), range(|p| p.1));
    canvas.text(panel.label.as_str(), (COLUMN / 2.0, top + 5.0), Anchor::Middle);
    let frame = PlotFrame::new(
        [2.0, top + 10.0, COLUMN - 2.0, top + PANEL - 6.0],
        Axis::linear("x₁/|eµ|", x, 6),
        Axis::linear("x₂/|eµ|", y, 6),
    );
    if let Some(x) = panel.grazing() {
        canvas.line(frame.path([(x, y.0), (x, y.1)]), line(GREY, 0.5));
    }
    let jumps = ends(panel).map(|(before, after)| frame.path([place_of(before), place_of(after)]));
    canvas.lines(jumps.collect(), line(RED, 0.7));
    let at = frame.path(places);
    canvas.discs(at.clone(), 1.2, BLACK);
    fixed(canvas, frame.at((0.0, 0.0)));
    for (text, place) in numbers(panel, &at, &frame) {
        canvas.sized(Words::plain(&text), place, Anchor::Middle, SMALL);
    }
    frame.draw(canvas);
}

/// A number beside each point, or one text beside points so close together that their numbers would cover one
/// another: `3–7, 12`.
fn numbers(panel: &Panel, at: &[At], frame: &PlotFrame) -> Vec<(String, At)> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, place) in at.iter().enumerate() {
        let near = |group: &&mut Vec<usize>| {
            group.iter().any(|&other| (at[other].0 - place.0).hypot(at[other].1 - place.1) < 5.0)
        };
        match groups.iter_mut().find(near) {
            Some(group) => group.push(index),
            None => groups.push(vec![index]),
        }
    }
    let mut taken: Vec<[f64; 4]> = at.iter().map(|(x, y)| [x - 1.3, x + 1.3, y - 1.3, y + 1.3]).collect();
    // Nor do numbers cover the jumps.
    for (before, after) in ends(panel) {
        let (before, after) = (frame.at(place_of(before)), frame.at(place_of(after)));
        taken.extend((0..=40).map(|i| f64::from(i) / 40.0).map(|t| {
            let (x, y) = (before.0 + t * (after.0 - before.0), before.1 + t * (after.1 - before.1));
            [x - 0.5, x + 0.5, y - 0.5, y + 0.5]
        }));
    }
    let mut placed = Vec::new();
    for group in groups {
        let text = ranges(group.iter().map(|&index| panel.points[index].k));
        let wide = Words::plain(&text).width(SMALL);
        let middle =
            |pick: fn(&At) -> f64| group.iter().map(|&i| pick(&at[i])).sum::<f64>() / group.len() as f64;
        let (x, y) = (middle(|at| at.0), middle(|at| at.1));
        let spot =
            |(dx, dy): (f64, f64)| [x + dx - wide / 2.0, x + dx + wide / 2.0, y + dy - 3.0, y + dy + 3.0];
        let beside = |d: f64| {
            let s = wide / 2.0 + d;
            [
                (0.0, -d - 3.0),
                (0.0, d + 3.0),
                (s, 0.0),
                (-s, 0.0),
                (s, -d - 1.0),
                (-s, -d - 1.0),
                (s, d + 1.0),
                (-s, d + 1.0),
            ]
        };
        let cost = |spot: &[f64; 4]| {
            let meets = |b: &&[f64; 4]| spot[0] < b[1] && b[0] < spot[1] && spot[2] < b[3] && b[2] < spot[3];
            let out = !frame.holds((spot[0], spot[2])) || !frame.holds((spot[1], spot[3]));
            taken.iter().filter(meets).count() + 50 * usize::from(out)
        };
        let spots = [2.0, 4.0, 7.0, 11.0].into_iter().flat_map(beside).map(spot);
        let Some(best) = spots.min_by_key(cost) else { continue };
        taken.push(best);
        placed.push((text, ((best[0] + best[1]) / 2.0, (best[2] + best[3]) / 2.0)));
    }
    placed
}

/// Increasing numbers, runs of them by their ends.
fn ranges(all: impl Iterator<Item = u64>) -> String {
    let mut runs: Vec<(u64, u64)> = Vec::new();
    for k in all {
        match runs.last_mut() {
            Some(run) if run.1 + 1 == k => run.1 = k,
            _ => runs.push((k, k)),
        }
    }
    let text = |&(first, last): &(u64, u64)| match last - first {
        0 => first.to_string(),
        1 => format!("{first}, {last}"),
        _ => format!("{first}–{last}"),
    };
    runs.iter().map(text).collect::<Vec<_>>().join(", ")
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
