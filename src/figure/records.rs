//! The record picture: which single-impact orbits exist, read off the powers of λ seen from 1.
//!
//! With complex eigenvalues, 0 < r ≤ 1, period n exists iff λⁿ sets a record in direction, seen from 1, among
//! λ, …, λⁿ.

use std::{f64::consts::PI, path::Path};

use num_rational::BigRational;
use num_traits::ToPrimitive;
use plotters::{
    prelude::*,
    style::text_anchor::{HPos, VPos},
};

use super::{FONT, GREY, Picture, WIDTH, colour, label, save, style};
use crate::{
    error::{Error, Result},
    existence::{Case, by_definition},
    local::{Ladder, Point, Polar},
};

/// Writes `records.svg` and `records.csv` into `folder`: λ, λ², …, λ^`last` for λ = r e^{2πis}, and the ray
/// from 1 through each λⁿ for which period n exists, with its case.
///
/// The cases are decided by (52), (53), from certain signs; the drawing is in plain floats.
///
/// # Errors
/// An input error unless 1 ≤ `last` ≤ 60, 0 < r ≤ 1 and 0 < s < ½; an I/O error.
pub fn records(r: &BigRational, s: &BigRational, last: u64, folder: &Path) -> Result<()> {
    if !(1..=60).contains(&last) {
        return Err(Error::input(format!(
            "--n {last}: this figure shows periods 1 to N, with N from 1 to 60"
        )));
    }
    let point = Point::Polar(Polar::new(r.clone(), s.clone())?);
    let ladder = Ladder::default();
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    let (modulus, turn) = (float(r), float(s));
    let powers: Vec<Power> = (1..=last)
        .map(|n| {
            let (length, angle) = (modulus.powi(n as i32), 2.0 * PI * turn * n as f64);
            let at = (length * angle.cos(), length * angle.sin());
            Power { n, at, cases: by_definition(&ladder, &point, n).cases(n) }
        })
        .collect();
    let row = |power: &Power| {
        let cases: Vec<String> = power.cases.iter().map(Case::to_string).collect();
        vec![power.n.to_string(), format!("{:.6}", power.at.0), format!("{:.6}", power.at.1), cases.join(" ")]
    };
    let rows: Vec<Vec<String>> = powers.iter().map(row).collect();
    let title = format!("λ = r exp(2πis), r = {modulus}, s = {turn}");
    save(folder, "records", draw(modulus, turn, &title, &powers), &["n", "re", "im", "cases"], &rows)
}

/// Labels on either side of the circle, those of the least periods; there is room for no more.
const LABELS: usize = 19;

/// λⁿ and the cases in which period n exists: none or one, for n = 1 two.
struct Power {
    n: u64,
    at: (f64, f64),
    cases: Vec<Case>,
}

fn draw(modulus: f64, turn: f64, title: &str, powers: &[Power]) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 1700)).into_drawing_area();
    root.fill(&WHITE)?;
    // The unit disc with room for labels around it; one unit is the same both ways.
    let (centre, unit) = ((950.0, 800.0), 620.0);
    let pixel =
        |(x, y): (f64, f64)| ((centre.0 + unit * x).round() as i32, (centre.1 - unit * y).round() as i32);
    let on_circle = |angle: f64, radius: f64| (radius * angle.cos(), radius * angle.sin());
    let circle: Vec<(i32, i32)> =
        (0..=360).map(|i| pixel(on_circle(PI * f64::from(i) / 180.0, 1.0))).collect();
    root.draw(&PathElement::new(circle, GREY.stroke_width(3)))?;
    let end = powers.last().map_or(0, |power| power.n);
    let spiral: Vec<(i32, i32)> = (0..=end * 60)
        .map(|i| {
            let t = i as f64 / 60.0;
            pixel(on_circle(2.0 * PI * turn * t, modulus.powf(t)))
        })
        .collect();
    root.draw(&PathElement::new(spiral, RGBColor(215, 215, 215).stroke_width(3)))?;

    // A ray from 1 in direction π − φ leaves the disc at angle π − 2φ: labels stand around the circle, to its
    // right and left.
    let rays = powers.iter().filter(|power| !power.cases.is_empty());
    let (right, left): (Vec<_>, Vec<_>) = rays
        .map(|power| (on_circle(PI - 2.0 * power.at.1.atan2(1.0 - power.at.0), 1.0), power))
        .partition(|(end, _)| end.0 >= 0.0);
    for (side, mut rays) in [(1.0, right), (-1.0, left)] {
        for (end, power) in &rays {
            root.draw(&PathElement::new(
                [(1.0, 0.0), *end].map(pixel),
                colour(power.cases[0]).stroke_width(5),
            ))?;
        }
        rays.truncate(LABELS);
        rays.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
        let mut heights: Vec<f64> = rays.iter().map(|(end, _)| 1.11 * end.1).collect();
        spread(&mut heights, 0.12);
        for ((end, power), height) in rays.iter().zip(heights) {
            // On a circle around the disc, but never nearer to the middle than the ray's end.
            let distance = (1.11f64.powi(2) - height * height).max(0.0).sqrt().max(end.0.abs() + 0.02);
            let place = (side * distance, height);
            root.draw(&PathElement::new([*end, place].map(pixel), colour(power.cases[0]).stroke_width(5)))?;
            // Period 1 exists in two cases, (+,−) and (−,+).
            let case = if power.n == 1 { "(±,∓)".to_string() } else { label(power.cases[0]) };
            let words = format!("{} {case}", power.n);
            let (x, y) = pixel(place);
            let (x, anchor) = if side > 0.0 { (x + 12, HPos::Left) } else { (x - 12, HPos::Right) };
            root.draw(&Text::new(words, (x, y), style(FONT, anchor, VPos::Center)))?;
        }
    }
    for power in powers {
        let (radius, ink) = power.cases.first().map_or((9, GREY), |&case| (17, colour(case)));
        root.draw(&Circle::new(pixel(power.at), radius, ink.filled()))?;
    }
    root.draw(&Text::new(
        title.to_string(),
        (WIDTH as i32 - 30, 1680),
        style(FONT, HPos::Right, VPos::Bottom),
    ))?;
    root.draw(&Circle::new(pixel((1.0, 0.0)), 13, BLACK.filled()))?;
    root.draw(&Text::new("1", pixel((1.04, 0.0)), style(FONT, HPos::Left, VPos::Center)))?;
    root.present()?;
    drop(root);
    Ok(svg)
}

/// Moves increasing heights apart until neighbours differ by `least`, each about as little as the others
/// allow, within ±1.22.
fn spread(heights: &mut [f64], least: f64) {
    for _ in 0..1000 {
        for height in heights.iter_mut() {
            *height = height.clamp(-1.22, 1.22);
        }
        for i in 1..heights.len() {
            let lack = least - (heights[i] - heights[i - 1]);
            if lack > 0.0 {
                heights[i] += lack / 2.0;
                heights[i - 1] -= lack / 2.0;
            }
        }
    }
}
