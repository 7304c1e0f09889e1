//! The tips of the areas of all periods beside the universal law, and how fast they approach it.

use std::{collections::HashSet, path::Path};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, pow};
use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, VPos},
};
use rayon::prelude::*;

use super::{FONT, Picture, WIDTH, save, style};
use crate::{
    error::{Error, Result},
    existence::{Boundary, Interval, Lowest, intervals, tip_correction, tip_law},
    monitor::Monitor,
    output::{decimal_above, decimal_below},
};

/// Digits of r: enough for ten of (1 − r) n³ at the largest n.
const DIGITS: u32 = 20;

/// Writes `tips.svg` and `tips.csv` into `folder`: (1 − r_tip) n³ against k/n for every area with a tip, 4 ≤
/// n ≤ `last`, on the curve G; below, the deviation from G times n², on the curve of the next term.
///
/// # Errors
/// An input error unless 4 ≤ `last` ≤ 400; an I/O error; an interruption.
pub fn tips(last: u64, folder: &Path, monitor: &dyn Monitor) -> Result<()> {
    if !(4..=400).contains(&last) {
        return Err(Error::input(format!(
            "--n {last}: this figure shows periods 4 to N, with N from 4 to 400"
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
    save(folder, "tips", draw(last, &points), &columns, &rows)
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

/// A panel of (t, value) with logarithmic values: dots coloured by period, a curve on top.
fn panel(
    area: &DrawingArea<SVGBackend, Shift>,
    (name, decades): (&str, [i32; 2]),
    dots: &[(u64, f64, f64)],
    curve: impl Fn(f64) -> f64,
) -> std::result::Result<(), Box<dyn std::error::Error>> {
    let mut chart = ChartBuilder::on(area)
        .margin(30)
        .margin_right(60)
        .x_label_area_size(190)
        .y_label_area_size(270)
        .build_cartesian_2d(0f64..1.0, f64::from(decades[0])..f64::from(decades[1]))?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(6)
        .y_labels((decades[1] - decades[0] + 1) as usize)
        .x_label_formatter(&|t| format!("{t:.1}"))
        .y_label_formatter(&|y| format!("10{}", superscript(y.round() as i32)))
        .x_desc("k/n")
        .y_desc(name)
        .label_style(("sans-serif", FONT))
        .axis_desc_style(("sans-serif", FONT + 2))
        .axis_style(BLACK.stroke_width(3))
        .set_all_tick_mark_size(16)
        .draw()?;
    // One dot for those that would cover each other; the large periods first.
    let mut seen = HashSet::new();
    for &(n, t, value) in dots.iter().rev() {
        let at = (t, value.log10());
        let (x, y) = chart.backend_coord(&at);
        let (lowest, highest) = (f64::from(decades[0]), f64::from(decades[1]));
        if at.1 > lowest && at.1 < highest && seen.insert((x / 5, y / 5, shade(n).rgb())) {
            chart.draw_series([Circle::new(at, 8, shade(n).filled())])?;
        }
    }
    let line = (0..400).map(|i| f64::from(i) / 400.0).map(|t| (t, curve(t).log10()));
    let shown = line.filter(|point: &(f64, f64)| point.1 < f64::from(decades[1]));
    chart.draw_series([PathElement::new(shown.collect::<Vec<_>>(), BLACK.stroke_width(4))])?;
    Ok(())
}

fn superscript(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| {
            if c == '-' {
                '⁻'
            } else {
                ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][c as usize - '0' as usize]
            }
        })
        .collect()
}

const SHADES: [(u64, &str, RGBColor); 3] = [
    (12, "n ≤ 12", RGBColor(213, 94, 0)),
    (50, "n ≤ 50", RGBColor(230, 159, 0)),
    (u64::MAX, "n > 50", RGBColor(86, 180, 233)),
];

fn shade(n: u64) -> RGBColor {
    SHADES.iter().find(|shade| n <= shade.0).map_or(BLACK, |shade| shade.2)
}

fn draw(last: u64, points: &[TipPoint]) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 2300)).into_drawing_area();
    root.fill(&WHITE)?;
    let (legend, rest) = root.split_vertically(100);
    let (upper, lower) = rest.split_vertically(1100);
    let mut x = 290;
    for (_, name, ink) in SHADES {
        legend.draw(&Circle::new((x, 60), 16, ink.filled()))?;
        legend.draw(&Text::new(name, (x + 35, 60), style(FONT, HPos::Left, VPos::Center)))?;
        x += 360;
    }
    legend.draw(&PathElement::new([(x, 60), (x + 80, 60)], BLACK.stroke_width(4)))?;
    legend.draw(&Text::new(
        format!("law; all n ≤ {last}"),
        (x + 105, 60),
        style(FONT, HPos::Left, VPos::Center),
    ))?;
    let value = |point: &TipPoint| point.scaled[0].to_f64().unwrap_or(f64::NAN);
    let heights: Vec<(u64, f64, f64)> = points.iter().map(|p| (p.interval.n, p.t(), value(p))).collect();
    let rest_of = |&(n, t, scaled): &(u64, f64, f64)| (n, t, (scaled - tip_law(t).1) * (n * n) as f64);
    let rests: Vec<(u64, f64, f64)> = heights.iter().map(rest_of).collect();
    panel(&upper, ("(1 − r) n³", [0, 5]), &heights, |t| tip_law(t).1)?;
    panel(&lower, ("((1 − r) n³ − G) n²", [0, 8]), &rests, tip_correction)?;
    root.present()?;
    drop((legend, upper, lower, rest));
    drop(root);
    Ok(svg)
}
