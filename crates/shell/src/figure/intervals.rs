//! Theorem 2's intervals as bars, one row for each period.

use num_rational::Ratio;

use super::{
    FigurePlace,
    canvas::{At, BLACK, COLUMN, Canvas, line},
    colour,
    frame::{Axis, PlotFrame},
    legend::Legend,
    title,
};
use crate::{
    error::{Error, Result},
    existence::{Case, Interval, intervals as theorem},
};

/// The height of a period's row.
const HIGH: f64 = 11.0;

/// Refuses periods that no picture of periods 3 to N shows.
pub(super) fn check_last(last: u64) -> Result<()> {
    if (3..=40).contains(&last) {
        return Ok(());
    }
    Err(Error::input(format!("N = {last}: this figure shows periods 3 to N, with N from 3 to 40")))
}

/// Writes the picture and its data: where single-impact orbits exist on r = 1, 3 ≤ n
/// ≤ `last`.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 40; an I/O error.
pub fn intervals(last: u64, place: &FigurePlace) -> Result<()> {
    check_last(last)?;
    let mut all = Vec::new();
    for n in 3..=last {
        all.extend(theorem(n)?);
    }
    let fraction = |x: &Ratio<u64>| format!("{}/{}", x.numer(), x.denom());
    let rows: Vec<Vec<String>> = all
        .iter()
        .map(|i| {
            let signs = [i.case.sign_emu().to_string(), i.case.sign_gamma().to_string()];
            [vec![i.n.to_string()], signs.to_vec(), vec![fraction(&i.left), fraction(&i.right)]].concat()
        })
        .collect();
    let columns = ["n", "sign_emu", "sign_gamma", "left", "right"];
    place.save(&draw(last, &all), &columns, &rows)
}

fn draw(last: u64, all: &[Interval]) -> Canvas {
    let mut legend = Legend::default();
    for case in [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus] {
        legend.add(title(case), move |canvas: &mut Canvas, (x, y): At| {
            canvas.rectangle([x - 8.0, y - 3.5, x + 8.0, y + 3.5], colour(case));
        });
    }
    legend.add("m/n, lowest terms", |canvas: &mut Canvas, (x, y): At| {
        canvas.line(vec![(x, y - 4.5), (x, y + 4.5)], line(BLACK, 0.8));
    });
    let top = 2.0 + legend.height(COLUMN - 26.0);
    let rows = (last - 2) as f64;
    let mut canvas = Canvas::new(
        COLUMN,
        HIGH * rows + top + 32.0,
        &format!("Theorem 2's intervals for periods 3 to {last}"),
        "A row per period n: the intervals of s on which the single-impact orbit exists without damping, r = 1, \
         coloured by the signs of e mu and gamma; a black line at each m/n in lowest terms.",
    );
    legend.draw(&mut canvas, (24.0, 2.0), COLUMN - 26.0);
    let marks = (3..=last).map(|n| (n as f64, n.to_string().into())).collect();
    let frame = PlotFrame::new(
        [2.0, top, COLUMN - 2.0, canvas.height - 2.0],
        Axis::linear("s = θ/2π", (0.0, 0.5), 5),
        // From the top down.
        Axis::marked("n", (last as f64 + 0.6, 2.4), false, marks),
    );
    // Drawing only: what is exact stands in the CSV.
    let number = |x: &Ratio<u64>| *x.numer() as f64 / *x.denom() as f64;
    for case in [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus] {
        let bars = all.iter().filter(|i| i.case == case).map(|i| {
            let (n, left, right) = (i.n as f64, number(&i.left), number(&i.right));
            frame.path([(left, n - 0.33), (right, n - 0.33), (right, n + 0.33), (left, n + 0.33)])
        });
        canvas.polygons(bars.collect(), colour(case));
    }
    // The multiples m/n in lowest terms, which separate (+,+) from (+,−).
    let marks = all.iter().filter(|i| i.case == Case::PlusPlus).map(|i| {
        let (s, n) = (number(&i.right), i.n as f64);
        frame.path([(s, n - 0.42), (s, n + 0.42)])
    });
    canvas.lines(marks.collect(), line(BLACK, 0.8));
    frame.draw(&mut canvas);
    canvas
}
