//! The design chart: for which natural frequencies and damping ratios a touch gives birth to chaos, before
//! it, beyond it, on both sides or on neither.
//!
//! Every point of one colour is certain; what is open is drawn as open. Cells of one colour are one shape, so
//! that nothing shines through between them, and its steps are cut off inwards, so that edges are curves.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, ORANGE, WHITE, Words, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{
    error::Result,
    monitor::Monitor,
    output::decimal_or_fraction,
    tolerance::{ChaosChart, ChartCell, ParameterBox},
};

/// 2 to this power are the columns.
const HALVINGS: u32 = 9;

/// On which sides of the touch chaos is born, and its colour.
const CLASSES: [(&str, Colour); 6] = [
    ("before the touch only", ORANGE),
    ("beyond it only", Colour(140, 196, 230)),
    ("before and beyond it", BLUE),
    ("no chaos at the touch", WHITE),
    ("beyond it; before it not certain", Colour(120, 140, 165)),
    ("not certain, or the theory is silent", Colour(90, 90, 90)),
];

/// The class of what is certain for eµ > 0, before the touch, and for eµ < 0, beyond it.
fn class(chaos: [Option<bool>; 2]) -> usize {
    match chaos {
        [Some(true), Some(false)] => 0,
        [Some(false), Some(true)] => 1,
        [Some(true), Some(true)] => 2,
        [Some(false), Some(false)] => 3,
        [None, Some(true)] => 4,
        _ => 5,
    }
}

/// Writes the chart of a machine's box and its data, a row per cell.
///
/// # Errors
/// An input error if it is not a machine's box, or has no width or no height; an I/O error; the monitor's
/// interruption.
pub fn design(of: &ParameterBox, place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    let chart = ChaosChart::new(of, HALVINGS, monitor)?;
    let said = |one: Option<bool>| one.map_or("open", |born| if born { "yes" } else { "no" }).to_string();
    let row = |cell: &ChartCell| {
        let ends = chart.bounds(cell);
        let bounds = ends.iter().flatten().map(decimal_or_fraction);
        bounds.chain(cell.chaos.map(said)).collect()
    };
    let rows: Vec<Vec<String>> = chart.cells.iter().map(row).collect();
    let columns =
        ["ratio_lower", "ratio_upper", "damping_lower", "damping_upper", "chaos_before", "chaos_beyond"];
    place.save(&draw(&chart), &columns, &rows)
}

fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// The axis of the damping, logarithmic where its octaves were cut one by one.
fn damping_axis(rows: &[BigRational]) -> Axis {
    let (lower, upper) = (float(&rows[0]), float(&rows[rows.len() - 1]));
    let name = "damping ratio";
    if &rows[1] - &rows[0] == &rows[rows.len() - 1] - &rows[rows.len() - 2] {
        return Axis::linear(name, (lower, upper), 6);
    }
    let marks = (-9..=3).flat_map(|power| [1, 2, 5].map(|digit| (digit, power))).map(|(digit, power)| {
        let text = format!("{}", f64::from(digit) * 10f64.powi(power));
        ((f64::from(digit) * 10f64.powi(power)).log10(), Words::plain(&text))
    });
    let range = (lower.log10(), upper.log10());
    let inside = marks.filter(|(at, _)| (range.0 - 1e-9..=range.1 + 1e-9).contains(at));
    Axis::marked(name, range, true, inside.collect())
}

fn draw(chart: &ChaosChart) -> Canvas {
    let sides = [chart.columns.len() - 1, chart.rows.len() - 1];
    let mut classes = vec![0usize; sides[0] * sides[1]];
    for cell in &chart.cells {
        for row in cell.rows[0]..cell.rows[1] {
            let [first, after] = cell.columns.map(|column| row * sides[0] + column);
            classes[first..after].fill(class(cell.chaos));
        }
    }
    let mut legend = Legend::default();
    let is_seen = |class: usize| class == CLASSES.len() - 1 || classes.contains(&class);
    for (_, (name, ink)) in CLASSES.into_iter().enumerate().filter(|(class, _)| is_seen(*class)) {
        legend.add(Words::plain(name), move |canvas: &mut Canvas, (x, y): At| {
            let square = [x - 8.0, y - 3.5, x + 8.0, y + 3.5];
            canvas.rectangle(square, ink);
            canvas.rectangle(square, line(BLACK, 0.4));
        });
    }
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(
        COLUMN,
        202.0 + high,
        "Where a grazing touch gives birth to chaos",
        "Machines with one degree of freedom that touch a rigid stop once per period of the drive, by natural \
         over drive frequency and damping ratio. The colour says whether chaos is born before the touch, beyond \
         it, on both sides or on neither.",
    );
    canvas.text(Words::plain("Where a touch gives birth to chaos"), (COLUMN / 2.0, 7.0), Anchor::Middle);
    let frame = PlotFrame::new(
        [2.0, 14.0, COLUMN - 2.0, 198.0],
        Axis::linear("natural frequency / drive frequency", ends(&chart.columns), 6),
        damping_axis(&chart.rows),
    );
    let [x, y] = [&chart.columns, &chart.rows].map(|edges| edges.iter().map(float).collect::<Vec<f64>>());
    canvas.inside(frame.inside(), |canvas| {
        let (_, open) = CLASSES[CLASSES.len() - 1];
        canvas.rectangle(frame.inside(), open);
        for (class, (_, ink)) in CLASSES.into_iter().enumerate().take(CLASSES.len() - 1) {
            let loops = outlines(&classes, sides, class).into_iter().map(|corners| without_steps(&corners));
            let loops = loops.map(|corners| frame.path(corners.iter().map(|&[i, j]| (x[i], y[j]))));
            canvas.polygons(loops.collect(), ink);
        }
    });
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 199.0), COLUMN - 8.0);
    canvas
}

fn ends(edges: &[BigRational]) -> (f64, f64) {
    (float(&edges[0]), float(&edges[edges.len() - 1]))
}

/// The outlines of all squares of a class on a grid, as corners of the grid; those of holes run the other way
/// round.
fn outlines(classes: &[usize], [wide, high]: [usize; 2], class: usize) -> Vec<Vec<[usize; 2]>> {
    let of = |i: usize, j: usize| i < wide && j < high && classes[j * wide + i] == class;
    // Sides of squares with another class on the right.
    let mut next: BTreeMap<[usize; 2], Vec<[usize; 2]>> = BTreeMap::new();
    for (i, j) in (0..high).flat_map(|j| (0..wide).map(move |i| (i, j))).filter(|&(i, j)| of(i, j)) {
        let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        let beside = [of(i, j.wrapping_sub(1)), of(i + 1, j), of(i, j + 1), of(i.wrapping_sub(1), j)];
        for side in (0..4).filter(|&side| !beside[side]) {
            next.entry(corners[side]).or_default().push(corners[(side + 1) % 4]);
        }
    }
    let mut loops = Vec::new();
    while let Some((&start, _)) = next.first_key_value() {
        let mut path: Vec<[usize; 2]> = vec![start];
        let mut at = start;
        while let Some(ways) = next.get_mut(&at) {
            let to = ways.pop().unwrap_or(start);
            if ways.is_empty() {
                next.remove(&at);
            }
            // A corner in the middle of a straight line is none.
            if let [.., before, last] = path[..]
                && ((before[0] == last[0] && last[0] == to[0]) || (before[1] == last[1] && last[1] == to[1]))
            {
                path.pop();
            }
            path.push(to);
            at = to;
            if at == start {
                break;
            }
        }
        path.pop();
        loops.push(path);
    }
    loops
}

/// An outline without the corners of steps: those between two inner ones, on a step that is one square high
/// or wide. What is cut off is half a row of squares of the class, so what stays is of the class.
fn without_steps(corners: &[[usize; 2]]) -> Vec<[usize; 2]> {
    let n = corners.len();
    let to = |i: usize| [0, 1].map(|k| corners[(i + 1) % n][k] as i64 - corners[i % n][k] as i64);
    let turns_out = |i: usize| {
        let ([a, b], [c, d]) = (to(i + n - 1), to(i));
        a * d > b * c
    };
    let is_step = |i: usize| {
        let [before, after] = [to(i + n - 1), to(i)].map(|[a, b]| a.abs() + b.abs());
        turns_out(i) && !turns_out(i + n - 1) && !turns_out(i + 1) && before.min(after) == 1
    };
    (0..n).filter(|&i| !is_step(i)).map(|i| corners[i]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a staircase the line through its inner corners stays; other corners stay.
    #[test]
    fn steps_become_a_line() {
        let stairs = [[0, 0], [9, 0], [9, 1], [6, 1], [6, 2], [3, 2], [3, 3], [0, 3]];
        assert_eq!(without_steps(&stairs), [[0, 0], [9, 0], [9, 1], [6, 1], [3, 2], [3, 3], [0, 3]]);
        let wide = [[0, 0], [9, 0], [9, 2], [6, 2], [6, 4], [3, 4], [3, 6], [0, 6]];
        assert_eq!(without_steps(&wide), wide);
    }

    /// The outlines of a class enclose as many squares as it has, holes taken off.
    #[test]
    fn outlines_enclose_their_class() {
        let text = "..xx.x xxx.xx x.xx.x xxxxxx .x..x.";
        let rows: Vec<&str> = text.split(' ').collect();
        let classes: Vec<usize> = rows.concat().bytes().map(|byte| usize::from(byte == b'x')).collect();
        for class in [0, 1] {
            let loops = outlines(&classes, [6, rows.len()], class);
            let area = |path: &Vec<[usize; 2]>| {
                let pairs = path.iter().zip(path.iter().cycle().skip(1));
                pairs.map(|(a, b)| (a[0] * b[1]) as i64 - (b[0] * a[1]) as i64).sum::<i64>()
            };
            let squares = classes.iter().filter(|&&own| own == class).count() as i64;
            assert_eq!(loops.iter().map(area).sum::<i64>(), 2 * squares);
            assert!(class == 0 || loops.iter().any(|path| area(path) < 0), "a hole");
        }
    }
}
