//! The record picture: which single-impact orbits exist, read off the powers of λ seen from 1.
//!
//! For r < 1 or r = 1 and complex eigenvalues, period n exists iff λⁿ sets a record in direction, seen from 1, among λ, …, λⁿ.

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

/// Writes `records.svg` and `records.csv` into `folder`: λ, λ², …, λ^`last` for λ = r e^{2πis}, and the ray from 1 through each
/// λⁿ for which period n exists, with its case.
///
/// The cases are decided by (52), (53), from certain signs; the drawing is in plain floats.
///
/// # Errors
/// An input error unless 1 ≤ `last` ≤ 60, 0 < r ≤ 1 and 0 < s < ½; an I/O error.
pub fn records(r: &BigRational, s: &BigRational, last: u64, folder: &Path) -> Result<()> {
    if !(1..=60).contains(&last) {
        return Err(Error::input(format!("--n {last}: this figure shows periods 1 to N, with N from 1 to 60")));
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

/// λⁿ and the cases in which period n exists: none or one, for n = 1 two.
struct Power {
    n: u64,
    at: (f64, f64),
    cases: Vec<Case>,
}

fn draw(modulus: f64, turn: f64, title: &str, powers: &[Power]) -> Picture {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (WIDTH, 1640)).into_drawing_area();
    root.fill(&WHITE)?;
    // The unit disc with room for labels around it; one unit is the same both ways.
    let (centre, unit) = ((960.0, 780.0), 640.0);
    let pixel = |(x, y): (f64, f64)| ((centre.0 + unit * x).round() as i32, (centre.1 - unit * y).round() as i32);
    let on_circle = |angle: f64, radius: f64| (radius * angle.cos(), radius * angle.sin());
    let circle: Vec<(i32, i32)> = (0..=360).map(|i| pixel(on_circle(PI * f64::from(i) / 180.0, 1.0))).collect();
    root.draw(&PathElement::new(circle, GREY.stroke_width(3)))?;
    let end = powers.last().map_or(0, |power| power.n);
    let spiral: Vec<(i32, i32)> = (0..=end * 60)
        .map(|i| {
            let t = i as f64 / 60.0;
            pixel(on_circle(2.0 * PI * turn * t, modulus.powf(t)))
        })
        .collect();
    root.draw(&PathElement::new(spiral, RGBColor(215, 215, 215).stroke_width(3)))?;

    // A ray from 1 in direction π − φ leaves the disc at angle π − 2φ: labels stand around the circle.
    let mut rays: Vec<(f64, &Power)> = powers
        .iter()
        .filter(|power| !power.cases.is_empty())
        .map(|power| (PI - 2.0 * power.at.1.atan2(1.0 - power.at.0), power))
        .collect();
    rays.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut angles: Vec<f64> = rays.iter().map(|ray| ray.0).collect();
    spread(&mut angles, 0.16);
    for ((angle, power), place) in rays.iter().zip(&angles) {
        let ink = colour(power.cases[0]);
        let stops = [(1.0, 0.0), on_circle(*angle, 1.0), on_circle(*place, 1.09)].map(pixel);
        root.draw(&PathElement::new(stops, ink.stroke_width(5)))?;
        let words: Vec<String> = power.cases.iter().map(|&case| label(case)).collect();
        let side = if place.cos() < -0.2 { HPos::Right } else if place.cos() > 0.2 { HPos::Left } else { HPos::Center };
        let height = if place.sin() > 0.9 { VPos::Bottom } else if place.sin() < -0.9 { VPos::Top } else { VPos::Center };
        let words = format!("{} {}", power.n, words.join(" "));
        root.draw(&Text::new(words, pixel(on_circle(*place, 1.11)), style(FONT, side, height)))?;
    }
    for power in powers {
        let (radius, ink) = power.cases.first().map_or((9, GREY), |&case| (17, colour(case)));
        root.draw(&Circle::new(pixel(power.at), radius, ink.filled()))?;
    }
    root.draw(&Text::new(title.to_string(), (WIDTH as i32 - 30, 1620), style(FONT, HPos::Right, VPos::Bottom)))?;
    root.draw(&Circle::new(pixel((1.0, 0.0)), 13, BLACK.filled()))?;
    root.draw(&Text::new("1", pixel((1.04, 0.0)), style(FONT, HPos::Left, VPos::Center)))?;
    root.present()?;
    drop(root);
    Ok(svg)
}

/// Moves increasing angles apart until neighbours differ by `least`, each as little as the others allow.
fn spread(angles: &mut [f64], least: f64) {
    for _ in 0..200 {
        for i in 1..angles.len() {
            let lack = least - (angles[i] - angles[i - 1]);
            if lack > 0.0 {
                angles[i] += lack / 2.0;
                angles[i - 1] -= lack / 2.0;
            }
        }
    }
}
