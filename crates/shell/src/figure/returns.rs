//! First-return times to a line over the angle and the modulus of the eigenvalues, below and above 1.

use std::cmp::Ordering;

use num_rational::BigRational;
use rayon::prelude::*;

use super::{
    FigurePlace,
    canvas::{At, BLACK, BLUE, COLUMN, Canvas, Colour, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{
    error::Result,
    local::{Forward, Ladder},
    monitor::Monitor,
    word::{Returns, Word},
};

/// Rows of r, and points of s in each.
const ROWS: u32 = 120;
const COLUMNS: u32 = 480;
/// The largest r.
const MOST: u32 = 3;
/// This many times or more have one colour.
const DARKEST: usize = 9;
/// The most letters of a word.
const LETTERS: usize = 60;

/// Neighbouring points of a row with the same times.
struct Run {
    row: u32,
    from: u32,
    to: u32,
    times: Vec<u64>,
}

/// Writes the picture and its data: for 0 < r < 3 and 0 < s < ½, at the middles of 120 × 480 cells, how many
/// first-return times there are, and which.
///
/// # Errors
/// An I/O error; the monitor's interruption.
pub fn returns(place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    let rows: Vec<Vec<Run>> =
        (0..ROWS).into_par_iter().map(|row| runs(row, monitor)).collect::<Result<_>>()?;
    let runs: Vec<Run> = rows.into_iter().flatten().collect();
    let data: Vec<Vec<String>> = runs
        .iter()
        .map(|run| {
            let times: Vec<String> = run.times.iter().map(u64::to_string).collect();
            let [r, left, right] =
                [modulus(run.row), angle(run.from), angle(run.to - 1)].map(|x| x.to_string());
            vec![r, left, right, times.join(" ")]
        })
        .collect();
    place.save(&draw(&runs), &["r", "first_s", "last_s", "times"], &data)
}

/// The middle of a row.
fn modulus(row: u32) -> BigRational {
    BigRational::new((MOST * (2 * row + 1)).into(), (2 * ROWS).into())
}

/// The middle of a cell in its row.
fn angle(column: u32) -> BigRational {
    BigRational::new((2 * column + 1).into(), (4 * COLUMNS).into())
}

fn runs(row: u32, monitor: &dyn Monitor) -> Result<Vec<Run>> {
    let ladder = Ladder::default();
    let mut runs: Vec<Run> = Vec::new();
    for column in 0..COLUMNS {
        let forward = Forward::polar(modulus(row), angle(column))?;
        let word = Word::at(&ladder, &forward.point, true, LETTERS, &())?;
        let modulus = if forward.reversed { Ordering::Greater } else { Ordering::Less };
        let times = Returns::new(&word, forward.region, modulus)?.times();
        match runs.last_mut().filter(|run| run.times == times) {
            Some(run) => run.to = column + 1,
            None => runs.push(Run { row, from: column, to: column + 1, times }),
        }
    }
    monitor.advance(1)?;
    Ok(runs)
}

fn shade(count: usize) -> Colour {
    BLUE.tint(0.08 + 0.92 * (count.clamp(2, DARKEST) - 2) as f64 / (DARKEST - 2) as f64)
}

fn draw(runs: &[Run]) -> Canvas {
    let mut legend = Legend::default();
    for count in 2..=DARKEST {
        let name = if count == DARKEST { format!("{count} or more") } else { count.to_string() };
        legend.add(name, move |canvas: &mut Canvas, (x, y): At| {
            canvas.rectangle([x - 7.0, y - 3.5, x + 7.0, y + 3.5], shade(count));
            canvas.rectangle([x - 7.0, y - 3.5, x + 7.0, y + 3.5], line(BLACK, 0.3));
        });
    }
    let top = 4.0 + legend.height(COLUMN - 30.0);
    let mut canvas = Canvas::new(
        COLUMN,
        top + 230.0,
        "How many first-return times a line has, over angle and modulus of the eigenvalues",
        "The plane of s from 0 to 1/2 and r from 0 to 3, darker where points of a line have more first-return times. \
         Below r = 1 these are the areas of orbits at a grazing bifurcation; above, upside down by 1/r, the return \
         times of a border collision, with one more.",
    );
    legend.draw(&mut canvas, (26.0, 2.0), COLUMN - 30.0);
    let frame = PlotFrame::new(
        [2.0, top, COLUMN - 4.0, canvas.height - 2.0],
        Axis::linear("s", (0.0, 0.5), 5),
        Axis::linear("r", (0.0, f64::from(MOST)), 6),
    );
    canvas.inside(frame.inside(), |canvas| {
        for count in 2..=DARKEST {
            let of = runs.iter().filter(|run| run.times.len().clamp(2, DARKEST) == count);
            let cells = of.map(|run| {
                let [left, right] =
                    [run.from, run.to].map(|column| 0.5 * f64::from(column) / f64::from(COLUMNS));
                // A little over the row above, so that nothing shines through.
                let [low, high] = [f64::from(run.row), f64::from(run.row) + 1.02]
                    .map(|row| f64::from(MOST) * row / f64::from(ROWS));
                frame.path([(left, low), (right, low), (right, high), (left, high)])
            });
            canvas.polygons(cells.collect(), shade(count));
        }
        canvas.line(frame.path([(0.0, 1.0), (0.5, 1.0)]), line(BLACK, 0.5));
    });
    frame.draw(&mut canvas);
    canvas
}
