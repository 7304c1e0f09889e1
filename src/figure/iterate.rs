//! The paper's figure 4: the iterate boundaries b_{n,k} = 0 that bound areas, in the (a₁, a₂) plane.

use std::path::Path;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{
    FONT, GREY, Picture, WIDTH,
    axes::{Panel, plane_axes},
    colour, label, save, style,
};
use crate::{
    error::{Error, Result},
    existence::{Boundary, Case, Interval, intervals},
    local::Plane,
    number::{Angle, Ball, Circular, Precision, Sign},
    output::decimal_near,
};

/// Points a curve in region 3; and in region 4.
const STEPS: u64 = 60;
const DECIMALS: u32 = 8;

/// Writes `figure4.svg` and `figure4.csv` into `folder`: for 3 ≤ n ≤ `last` and each k coprime to n the part
/// of b_{n,k} = 0 that bounds an area, labelled n,k for n ≤ 5; the upper part again, enlarged.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 40; an I/O error.
pub fn iterate_boundaries(last: u64, folder: &Path) -> Result<()> {
    if !(3..=40).contains(&last) {
        return Err(Error::input(format!(
            "--n {last}: this figure shows periods 3 to N, with N from 3 to 40"
        )));
    }
    let mut curves = Vec::new();
    for n in 3..=last {
        for interval in intervals(n)?.filter(|interval| interval.deciding.is_some()) {
            curves.push(Curve::new(interval)?);
        }
    }
    let mut rows = Vec::new();
    for Curve { interval, k, points } in &curves {
        let head = [
            interval.n.to_string(),
            k.to_string(),
            interval.m.to_string(),
            interval.case.sign_gamma().to_string(),
        ];
        rows.extend(points.iter().map(|point| {
            let place = point.each_ref().map(|x| decimal_near(x, DECIMALS));
            head.iter().cloned().chain(place).collect::<Vec<String>>()
        }));
    }
    save(folder, "figure4", draw(&curves), &["n", "k", "m", "sign_gamma", "a1", "a2"], &rows)
}

/// The active part of b_{n,k} = 0 as points (a₁, a₂) within 10⁻⁸.
pub(super) struct Curve {
    interval: Interval,
    k: u64,
    pub(super) points: Vec<[BigRational; 2]>,
}

impl Curve {
    pub(super) fn new(interval: Interval) -> Result<Curve> {
        let (n, k) = (interval.n, interval.deciding.unwrap_or_default());
        let ratio = |p: u64, q: u64| BigRational::new(p.into(), q.into());
        let [mut left, right] = [&interval.left, &interval.right].map(|x| ratio(*x.numer(), *x.denom()));
        if k == n - 1 {
            // To the right of this, nothing bounds the area.
            left = ratio(1, 2 * (n - 1));
        }
        let boundary = Boundary::new(interval.clone());
        let precision = Precision::new(96);
        let mut points = Vec::new();
        for i in 0..=STEPS {
            let s = &left + (&right - &left) * ratio(i, STEPS);
            let r = match i {
                0 if k == n - 1 => BigRational::zero(),
                // There R is not 1, and region 4 goes on.
                STEPS if k == n - 2 => continue,
                0 | STEPS => BigRational::one(),
                _ => boundary.at(&s, DECIMALS)?.expect("every edge has been certified").middle(),
            };
            let cosine = Ball::cos(&Angle::new(&(s * BigInt::from(2))), &precision);
            let (lower, upper) = cosine.exact_bounds().expect("a cosine is bounded");
            points.push([(lower + upper) * &r, &r * &r]);
        }
        if k == n - 2 {
            points.extend(region4(n));
        }
        Ok(Curve { interval, k, points })
    }
}

/// b_{n,n−2} = 0 in region 4, from top to bottom, by halving in exact arithmetic.
pub(super) fn region4(n: u64) -> Vec<[BigRational; 2]> {
    let positive = |a1: &BigRational, a2: &BigRational| {
        let plane = Plane::new(a1.clone(), a2.clone()).expect("a2 > 0");
        let exact = plane.exact_numerator(n, n - 2, u64::MAX, &());
        let (numerator, u) = exact.ok().flatten().expect("no limit and no interruption");
        Sign::from(&numerator) == Sign::from(&u)
    };
    let mut points = Vec::new();
    for i in (1..STEPS).rev() {
        let r = BigRational::new(i.into(), STEPS.into());
        let a2 = &r * &r;
        // b > 0 on a₁ = −(a₂ + 1); where it is also on a₁ = −2√a₂, the curve is in region 3.
        let (mut left, mut right) = (-(&a2 + BigInt::from(1)), r * BigInt::from(-2));
        if positive(&right, &a2) {
            continue;
        }
        for _ in 0..30 {
            let middle = (&left + &right) / BigInt::from(2);
            let end = if positive(&middle, &a2) { &mut left } else { &mut right };
            *end = middle;
        }
        points.push([left, a2]);
    }
    points.push([-BigRational::one(), BigRational::zero()]);
    points
}

pub(super) fn place(point: &[BigRational; 2]) -> (f64, f64) {
    let [a1, a2] = point.each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN));
    (a1, a2)
}

/// A panel for a₂ between `bottom` and 1, with the regions' lines in grey and all curves.
fn panel<'a, 'b>(
    area: &'a DrawingArea<SVGBackend<'b>, Shift>,
    bottom: f64,
    curves: &[Curve],
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
    plane_axes(&mut chart, 5, if bottom > 0.0 { 2 } else { 1 })?;
    let parabola: Vec<(f64, f64)> =
        (-200..=200).map(|i| f64::from(i) / 100.0).map(|a1| (a1, a1 * a1 / 4.0)).collect();
    let line = |sign: f64| vec![(sign * (1.0 + bottom), bottom), (sign * 2.0, 1.0)];
    for path in above(&parabola, bottom).into_iter().chain([line(-1.0), line(1.0)]) {
        chart.draw_series([PathElement::new(path, GREY.stroke_width(3))])?;
    }
    // The labelled curves last, so that they lie above the others.
    for curve in curves.iter().rev() {
        let points: Vec<(f64, f64)> = curve.points.iter().map(place).collect();
        let width = if curve.interval.n <= 5 { 7 } else { 3 };
        let ink = colour(curve.interval.case).stroke_width(width);
        for part in above(&points, bottom) {
            chart.draw_series([PathElement::new(part, ink)])?;
        }
    }
    Ok(chart)
}

/// The parts of a path at or above a height, cut there.
fn above(path: &[(f64, f64)], height: f64) -> Vec<Vec<(f64, f64)>> {
    let mut parts = vec![Vec::new()];
    for (index, &(x, y)) in path.iter().enumerate() {
        if let Some(&(x0, y0)) = index.checked_sub(1).map(|before| &path[before])
            && (y0 < height) != (y < height)
        {
            let crossing = (x0 + (x - x0) * (height - y0) / (y - y0), height);
            parts.last_mut().expect("never empty").push(crossing);
            if y < height {
                parts.push(Vec::new());
            }
        }
        if y >= height {
            parts.last_mut().expect("never empty").push((x, y));
        }
    }
    parts.retain(|part| part.len() > 1);
    parts
}

fn draw(curves: &[Curve]) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 2300)).into_drawing_area();
    root.fill(&WHITE)?;
    let (legend, rest) = root.split_vertically(100);
    let (upper, lower) = rest.split_vertically(1200);
    let last = curves.last().map_or(0, |curve| curve.interval.n);
    let mut x = 250;
    for case in [Case::PlusPlus, Case::PlusMinus] {
        legend.draw(&PathElement::new([(x, 60), (x + 80, 60)], colour(case).stroke_width(9)))?;
        legend.draw(&Text::new(label(case), (x + 100, 60), style(FONT, HPos::Left, VPos::Center)))?;
        x += 340;
    }
    let title = format!("b(n,k) = 0, 3 ≤ n ≤ {last}");
    legend.draw(&Text::new(title, (WIDTH as i32 - 50, 60), style(FONT, HPos::Right, VPos::Center)))?;
    {
        let chart = panel(&upper, 0.0, curves).map_err(|error| error.to_string())?;
        for curve in curves.iter().filter(|curve| curve.interval.n <= 5) {
            let name = format!("{},{}", curve.interval.n, curve.k);
            let (at, (dx, dy), side) = anchor(curve);
            let (x, y) = chart.backend_coord(&at);
            root.draw(&Text::new(name, (x + dx, y + dy), style(FONT, side, VPos::Center)))?;
        }
    }
    panel(&lower, 0.9, curves).map_err(|error| error.to_string())?;
    root.present()?;
    drop((legend, upper, lower, rest));
    drop(root);
    Ok(svg)
}

/// Where a curve's label stands: a point of the curve, an offset from it in units of the picture, the side.
fn anchor(curve: &Curve) -> ((f64, f64), (i32, i32), HPos) {
    let low = |height: f64| {
        let above = curve.points.iter().map(place).filter(|point| point.1 >= height);
        above.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, 0.0))
    };
    match (curve.interval.n, curve.k) {
        (3, 2) => (low(0.5), (-20, 20), HPos::Right),
        (4, 3) => (low(0.5), (-24, 0), HPos::Right),
        (5, 4) => (low(0.45), (-24, 0), HPos::Right),
        (3, 1) => (low(0.4), (24, 0), HPos::Left),
        (5, 3) => (low(0.62), (24, 0), HPos::Left),
        _ => (low(0.0), (0, 52), HPos::Center),
    }
}
