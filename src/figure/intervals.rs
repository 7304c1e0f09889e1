//! Theorem 2's intervals as bars, one row for each period.

use std::path::Path;

use num_rational::Ratio;
use plotters::prelude::*;

use super::{Picture, colour, save};
use crate::{
    error::{Error, Result},
    existence::{Case, Interval, intervals as theorem},
};

const WIDTH: u32 = 760;
const ROW: u32 = 26;

/// Writes `intervals.svg` and `intervals.csv` into `folder`: where single-impact orbits exist on r = 1, 3 ≤ n
/// ≤ `last`.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 40; an I/O error.
pub fn intervals(last: u64, folder: &Path) -> Result<()> {
    if !(3..=40).contains(&last) {
        return Err(Error::input(format!(
            "--n {last}: this figure shows periods 3 to N, with N from 3 to 40"
        )));
    }
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
    save(folder, "intervals", draw(last, &all), &columns, &rows)
}

fn draw(last: u64, all: &[Interval]) -> Picture {
    let mut svg = String::new();
    let rows = (last - 2) as u32;
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 110 + ROW * rows)).into_drawing_area();
    root.fill(&WHITE)?;
    // Drawing only: what is exact stands in the CSV.
    let place = |x: &Ratio<u64>| *x.numer() as f64 / *x.denom() as f64;
    let mut chart = ChartBuilder::on(&root)
        .margin_right(24)
        .margin_top(44)
        .x_label_area_size(52)
        .y_label_area_size(64)
        .build_cartesian_2d(0f64..0.5, (last as f64 + 0.6)..2.4)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(11)
        .y_labels(rows as usize + 2)
        .x_label_formatter(&|s| format!("{s:.2}"))
        .y_label_formatter(&|n| if n.fract() == 0.0 { format!("{n}") } else { String::new() })
        .x_desc("s = θ/2π")
        .y_desc("period n")
        .label_style(("sans-serif", 15))
        .axis_desc_style(("sans-serif", 17))
        .draw()?;
    for case in [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus] {
        let bars = all.iter().filter(|i| i.case == case).map(|i| {
            let n = i.n as f64;
            Rectangle::new([(place(&i.left), n - 0.33), (place(&i.right), n + 0.33)], colour(case).filled())
        });
        chart.draw_series(bars)?;
    }
    // The multiples m/n in lowest terms, which separate (+,+) from (+,−).
    let marks = all.iter().filter(|i| i.case == Case::PlusPlus).map(|i| {
        let (s, n) = (place(&i.right), i.n as f64);
        PathElement::new([(s, n - 0.42), (s, n + 0.42)], BLACK)
    });
    chart.draw_series(marks)?;
    let mut x = 64;
    for case in [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus] {
        root.draw(&Rectangle::new([(x, 15), (x + 26, 31)], colour(case).filled()))?;
        let label = format!("{case}").replace('-', "−");
        root.draw(&Text::new(label, (x + 33, 16), ("sans-serif", 16)))?;
        x += 100;
    }
    root.draw(&PathElement::new([(x + 4, 12), (x + 4, 34)], BLACK))?;
    root.draw(&Text::new("m/n in lowest terms", (x + 13, 16), ("sans-serif", 16)))?;
    let right = WIDTH as i32 - 24;
    let style = ("sans-serif", 15).into_text_style(&root).pos(plotters::style::text_anchor::Pos::new(
        plotters::style::text_anchor::HPos::Right,
        plotters::style::text_anchor::VPos::Top,
    ));
    root.draw(&Text::new("cases (sign eµ, sign γ), r = 1", (right, 16), style))?;
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}
