//! The tips of the areas of all periods beside the universal law, and how fast they approach it.

use std::collections::HashSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, pow};
use rayon::prelude::*;

use super::{
    FigurePlace,
    canvas::{At, BLACK, COLUMN, Canvas, Colour, ORANGE, RED, SKY, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{
    error::{Error, Result},
    existence::{Boundary, Interval, Lowest, intervals, tip_correction, tip_law},
    monitor::Monitor,
    output::{decimal_above, decimal_below},
};

/// Digits of r: enough for ten of (1 − r) n³ at the largest n.
const DIGITS: u32 = 20;

/// Writes the picture and its data: (1 − r_tip) n³ against k/n for every area with a tip, 4 ≤
/// n ≤ `last`, on the curve G; below, the deviation from G times n², on the curve of the next term.
///
/// # Errors
/// An input error unless 4 ≤ `last` ≤ 400; an I/O error; an interruption.
pub fn tips(last: u64, place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    if !(4..=400).contains(&last) {
        return Err(Error::input(format!(
            "N = {last}: this figure shows periods 4 to N, with N from 4 to 400"
        )));
    }
    let periods: Result<Vec<Vec<TipPoint>>> = (4..=last)
        .into_par_iter()
        .map(|n| {
            let points = intervals(n)?.filter_map(TipPoint::new).collect();
            monitor.advance(1)?;
            Ok(points)
        })
        .collect();
    let points = periods?.concat();
    let rows: Vec<Vec<String>> = points.iter().map(TipPoint::row).collect();
    let columns = ["n", "m", "sign_gamma", "k", "scaled_lower", "scaled_upper", "law", "law_next"];
    place.save(&draw(last, &points), &columns, &rows)
}

/// The tip of one area.
#[derive(Clone)]
struct TipPoint {
    interval: Interval,
    k: u64,
    /// Bounds of (1 − r_tip) n³.
    scaled: [BigRational; 2],
}

impl TipPoint {
    /// `None` for an area that reaches down to 0.
    fn new(interval: Interval) -> Option<TipPoint> {
        let k = interval.deciding?;
        let lowest =
            Boundary::new(interval.clone()).lowest(DIGITS).expect("every lowest point has been certified");
        let Lowest::Tip(tip) = lowest else { return None };
        let cube = pow(BigInt::from(interval.n), 3);
        let scaled = [tip.r.upper, tip.r.lower].map(|r| (BigRational::one() - r) * &cube);
        Some(TipPoint { interval, k, scaled })
    }

    fn t(&self) -> f64 {
        self.k as f64 / self.interval.n as f64
    }

    fn row(&self) -> Vec<String> {
        let Interval { n, m, case, .. } = self.interval;
        let (law, square) = (tip_law(self.t()).1, (n * n) as f64);
        vec![
            n.to_string(),
            m.to_string(),
            case.sign_gamma().to_string(),
            self.k.to_string(),
            decimal_below(&self.scaled[0], 9),
            decimal_above(&self.scaled[1], 9),
            format!("{law:.9}"),
            format!("{:.9}", law + tip_correction(self.t()) / square),
        ]
    }
}

/// Periods up to here have this colour and size of dot: the fewer, the larger, so that the rims of those
/// below stand out.
const SHADES: [(u64, Colour, f64); 3] = [(12, RED, 1.9), (50, ORANGE, 1.3), (u64::MAX, SKY, 0.7)];

/// A panel of (t, value) with logarithmic values: dots coloured by period, a curve on top.
fn panel(
    canvas: &mut Canvas,
    heights: [f64; 2],
    (name, decades): (&str, [i32; 2]),
    dots: &[(u64, f64, f64)],
    curve: impl Fn(f64) -> f64,
) {
    let frame = PlotFrame::new(
        [2.0, heights[0], COLUMN - 2.0, heights[1]],
        Axis::linear("k/n", (0.0, 1.0), 5),
        Axis::decades(name, decades, 1),
    )
    .with_left(38.0);
    canvas.inside(frame.inside(), |canvas| {
        for (index, (_, ink, radius)) in SHADES.into_iter().enumerate() {
            let of = |n: u64| SHADES.iter().position(|shade| n <= shade.0) == Some(index);
            // One dot for those that would cover each other.
            let mut seen = HashSet::new();
            let at = dots.iter().filter(|dot| of(dot.0) && dot.2 > 0.0).map(|dot| frame.at((dot.1, dot.2)));
            let fine = |(x, y): &At| seen.insert(((x / 0.3).round() as i64, (y / 0.3).round() as i64));
            canvas.discs(at.filter(|at| frame.holds(*at)).filter(fine).collect(), radius, ink);
        }
        let points = (1..1000).map(|i| f64::from(i) / 1000.0).map(|t| (t, curve(t)));
        canvas.line(frame.path(points.filter(|point| point.1 > 0.0)), line(BLACK, 0.35));
    });
    frame.draw(canvas);
}

fn draw(last: u64, points: &[TipPoint]) -> Canvas {
    let mut legend = Legend::default();
    for (least, (most, ink, radius)) in [4, 13, 51].into_iter().zip(SHADES) {
        if least <= last {
            let most = most.min(last);
            let name = if least == most { format!("n = {least}") } else { format!("n = {least} to {most}") };
            legend.add(name, move |canvas: &mut Canvas, at: At| canvas.disc(at, radius.max(1.0), ink));
        }
    }
    legend.add("law for large n", |canvas: &mut Canvas, (x, y): At| {
        canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(BLACK, 0.8));
    });
    let top = 4.0 + legend.height(COLUMN - 40.0);
    let mut canvas = Canvas::new(
        COLUMN,
        top + 280.0,
        &format!("The lowest points of all areas of periods 4 to {last}, and their law"),
        "Above, (1 - r) n³ at the tips over k/n, on the curve G; below, the deviation from G times n², where it is \
         positive, on the curve of the next term. Dots are coloured by period.",
    );
    legend.draw(&mut canvas, (38.0, 2.0), COLUMN - 40.0);
    let value = |point: &TipPoint| point.scaled[0].to_f64().unwrap_or(f64::NAN);
    let heights: Vec<(u64, f64, f64)> = points.iter().map(|p| (p.interval.n, p.t(), value(p))).collect();
    let rest_of = |&(n, t, scaled): &(u64, f64, f64)| (n, t, (scaled - tip_law(t).1) * (n * n) as f64);
    let rests: Vec<(u64, f64, f64)> = heights.iter().map(rest_of).collect();
    panel(&mut canvas, [top, top + 138.0], ("(1 − r) n³", [0, 5]), &heights, |t| tip_law(t).1);
    panel(&mut canvas, [top + 142.0, top + 278.0], ("((1 − r) n³ − G) n²", [0, 8]), &rests, tip_correction);
    canvas
}
