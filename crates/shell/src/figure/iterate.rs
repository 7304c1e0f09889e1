//! The paper's figure 4: the iterate boundaries b_{n,k} = 0 that bound areas, in the (a₁, a₂) plane.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::{
    FigurePlace,
    canvas::{Anchor, At, COLUMN, Canvas, GREY, line},
    colour,
    frame::{Axis, PlotFrame},
    intervals::check_last,
    legend::{Legend, ROW},
    title,
};
use crate::{
    error::Result,
    existence::{Boundary, Case, Interval, intervals},
    local::Plane,
    number::{Angle, Ball, Circular, Precision, Sign},
    output::decimal_near,
};

/// Points a curve in region 3; and in region 4.
const STEPS: u64 = 60;
const DECIMALS: u32 = 8;

/// Writes the picture and its data: for 3 ≤ n ≤ `last` and each k coprime to n the part
/// of b_{n,k} = 0 that bounds an area, labelled n,k for n ≤ 5; the upper part again, enlarged.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 40; an I/O error.
pub fn iterate_boundaries(last: u64, place: &FigurePlace) -> Result<()> {
    check_last(last)?;
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
    place.save(&draw(&curves), &["n", "k", "m", "sign_gamma", "a1", "a2"], &rows)
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

pub(super) fn plane(point: &[BigRational; 2]) -> (f64, f64) {
    let [a1, a2] = point.each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN));
    (a1, a2)
}

/// A panel for a₂ between `bottom` and 1, with the regions' lines in grey and all curves.
fn panel(canvas: &mut Canvas, [top, low]: [f64; 2], bottom: f64, curves: &[Curve]) -> PlotFrame {
    let frame = plane_frame([top, low], bottom);
    for path in region_lines(bottom) {
        canvas.line(frame.path(path), line(GREY, 0.5));
    }
    // The labelled curves last, so that they lie above the others.
    for curve in curves.iter().rev() {
        let width = if curve.interval.n <= 5 { 0.9 } else { 0.4 };
        let parts = above(&curve.points.iter().map(plane).collect::<Vec<_>>(), bottom);
        let parts = parts.into_iter().map(|part| frame.path(part)).collect();
        canvas.lines(parts, line(colour(curve.interval.case), width));
    }
    frame.draw(canvas);
    frame
}

/// The plane above a height, in a part of a picture between two heights; frames below one another are
/// aligned.
pub(super) fn plane_frame([top, low]: [f64; 2], bottom: f64) -> PlotFrame {
    let (x, y) = (Axis::linear("a₁", (-2.0, 2.0), 4), Axis::linear("a₂", (bottom, 1.0), 5));
    PlotFrame::new([2.0, top, COLUMN - 4.0, low], x, y).with_left(36.0)
}

/// The lines between the regions above a height, from left to right.
pub(super) fn region_lines(bottom: f64) -> Vec<Vec<(f64, f64)>> {
    let parabola: Vec<(f64, f64)> =
        (-200..=200).map(|i| f64::from(i) / 100.0).map(|a1| (a1, a1 * a1 / 4.0)).collect();
    let straight = |sign: f64| vec![(sign * (1.0 + bottom), bottom), (sign * 2.0, 1.0)];
    let mut lines = vec![straight(-1.0)];
    lines.extend(above(&parabola, bottom));
    lines.push(straight(1.0));
    lines
}

/// The parts of a path at or above a height, cut there.
pub(super) fn above(path: &[(f64, f64)], height: f64) -> Vec<Vec<(f64, f64)>> {
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

fn draw(curves: &[Curve]) -> Canvas {
    let last = curves.last().map_or(0, |curve| curve.interval.n);
    let mut legend = Legend::default();
    for case in [Case::PlusPlus, Case::PlusMinus] {
        legend.add(title(case), move |canvas: &mut Canvas, (x, y): At| {
            canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(colour(case), 1.2));
        });
    }
    let key = legend.height(COLUMN - 40.0);
    let mut canvas = Canvas::new(
        COLUMN,
        304.0 + key,
        &format!("The curves b_(n,k) = 0 that bound areas, n from 3 to {last}"),
        "Above, the (a1, a2) plane for 0 < a2 < 1; below, the part above a2 = 0.9. Orange curves bound areas of the \
         case (+,+), green ones those of (+,-); those up to n = 5 are labelled n,k.",
    );
    let name = format!("b_{{n,k}} = 0, 3 ≤ n ≤ {last}");
    canvas.text(name, (COLUMN - 4.0, 2.0 + ROW / 2.0), Anchor::End);
    legend.draw(&mut canvas, (36.0, 2.0 + ROW), COLUMN - 40.0);
    let frame = panel(&mut canvas, [16.0 + key, 162.0 + key], 0.0, curves);
    for curve in curves.iter().filter(|curve| curve.interval.n <= 5) {
        let name = format!("{},{}", curve.interval.n, curve.k);
        let (at, (dx, dy), anchor) = anchor(curve);
        let (x, y) = frame.at(at);
        canvas.sized(name, (x + dx, y + dy), anchor, 7.0);
    }
    panel(&mut canvas, [168.0 + key, 302.0 + key], 0.9, curves);
    canvas
}

/// Where a curve's label stands: a point of the curve, an offset from it, the side.
fn anchor(curve: &Curve) -> ((f64, f64), (f64, f64), Anchor) {
    let low = |height: f64| {
        let above = curve.points.iter().map(plane).filter(|point| point.1 >= height);
        above.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, 0.0))
    };
    match (curve.interval.n, curve.k) {
        (3, 2) => (low(0.5), (-2.5, 2.5), Anchor::End),
        (4, 3) => (low(0.5), (-3.0, 0.0), Anchor::End),
        (5, 4) => (low(0.45), (-3.0, 0.0), Anchor::End),
        (3, 1) => (low(0.4), (3.0, 0.0), Anchor::Start),
        (5, 3) => (low(0.62), (3.0, 0.0), Anchor::Start),
        _ => (low(0.0), (0.0, 6.0), Anchor::Middle),
    }
}
