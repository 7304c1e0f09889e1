//! The record picture: which single-impact orbits exist, read off the powers of λ seen from 1.
//!
//! With complex eigenvalues, 0 < r ≤ 1, period n exists iff λⁿ sets a record in direction, seen from 1, among
//! λ, …, λⁿ.

use std::f64::consts::PI;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, COLUMN, Canvas, Colour, GREY, line},
    colour, label,
    legend::{Legend, ROW},
    title,
};
use crate::{
    error::{Error, Result},
    existence::{Case, by_definition},
    local::{Ladder, Point, Polar},
};

/// Writes the picture and its data: λ, λ², …, λ^`last` for λ = r e^{2πis}, and the ray
/// from 1 through each λⁿ for which period n exists, with its case.
///
/// The cases are decided by (52), (53), from certain signs; the drawing is in plain floats.
///
/// # Errors
/// An input error unless 1 ≤ `last` ≤ 60, 0 < r ≤ 1 and 0 < s < ½; an I/O error.
pub fn records(r: &BigRational, s: &BigRational, last: u64, place: &FigurePlace) -> Result<()> {
    if !(1..=60).contains(&last) {
        return Err(Error::input(format!(
            "N = {last}: this figure shows periods 1 to N, with N from 1 to 60"
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
    place.save(&draw(modulus, turn, &powers), &["n", "re", "im", "cases"], &rows)
}

/// Labels on either side of the circle, those of the least periods; there is room for no more.
const LABELS: usize = 21;

/// λⁿ and the cases in which period n exists: none or one, for n = 1 two.
struct Power {
    n: u64,
    at: (f64, f64),
    cases: Vec<Case>,
}

const FAINT: Colour = Colour(205, 205, 205);
/// The middle of the circle, and its radius.
const CENTRE: At = (122.0, 106.0);
const UNIT: f64 = 78.0;

fn draw(modulus: f64, turn: f64, powers: &[Power]) -> Canvas {
    let last = powers.last().map_or(0, |power| power.n);
    let mut legend = Legend::default();
    let exists = powers.iter().filter(|power| !power.cases.is_empty()).collect::<Vec<_>>();
    for case in [Case::MinusPlus, Case::PlusPlus, Case::PlusMinus, Case::MinusMinus] {
        if exists.iter().any(|power| power.cases[0] == case) {
            legend.add(format!("orbit {}", title(case)), move |canvas: &mut Canvas, at: At| {
                canvas.line(vec![(at.0 - 9.0, at.1), (at.0 + 9.0, at.1)], line(colour(case), 0.7));
                canvas.disc(at, 2.2, colour(case));
            });
        }
    }
    if exists.len() < powers.len() {
        legend.add("no orbit of period n", |canvas: &mut Canvas, at: At| canvas.disc(at, 1.3, GREY));
    }
    let mut canvas = Canvas::new(
        COLUMN,
        CENTRE.1 + UNIT + 28.0 + ROW + legend.height(COLUMN - 8.0),
        &format!("The powers of λ = r exp(2πis) up to n = {last}, seen from 1"),
        "A ray from 1 through each power for which an orbit of that period exists, labelled with the period and the \
         signs of e mu and gamma; grey are the powers without an orbit.",
    );
    let place = |(x, y): (f64, f64)| (CENTRE.0 + UNIT * x, CENTRE.1 - UNIT * y);
    let on_circle = |angle: f64, radius: f64| (radius * angle.cos(), radius * angle.sin());
    canvas.disc(CENTRE, UNIT, line(GREY, 0.5));
    let spiral: Vec<At> = (0..=last * 60)
        .map(|i| {
            let t = i as f64 / 60.0;
            place(on_circle(2.0 * PI * turn * t, modulus.powf(t)))
        })
        .collect();
    canvas.line(spiral, line(FAINT, 0.4));

    // A ray from 1 in direction π − φ leaves the disc at angle π − 2φ: labels stand around the circle, to its
    // right and left.
    let (right, left): (Vec<_>, Vec<_>) = exists
        .iter()
        .map(|power| (on_circle(PI - 2.0 * power.at.1.atan2(1.0 - power.at.0), 1.0), *power))
        .partition(|(end, _)| end.0 >= 0.0);
    let unlabelled = left.len().saturating_sub(LABELS) + right.len().saturating_sub(LABELS);
    for (side, mut rays) in [(1.0, right), (-1.0, left)] {
        for (end, power) in &rays {
            canvas.line([(1.0, 0.0), *end].map(place).to_vec(), line(colour(power.cases[0]), 0.6));
        }
        rays.truncate(LABELS);
        rays.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
        let mut heights: Vec<f64> = rays.iter().map(|(end, _)| 1.11 * end.1).collect();
        spread(&mut heights, 9.2 / UNIT);
        for ((end, power), height) in rays.iter().zip(heights) {
            // On a circle around the disc, but never nearer to the middle than the ray's end.
            let distance = (1.11f64.powi(2) - height * height).max(0.0).sqrt().max(end.0.abs() + 0.02);
            let at = (side * distance, height);
            canvas.line([*end, at].map(place).to_vec(), line(colour(power.cases[0]), 0.6));
            // Period 1 exists in two cases, (+,−) and (−,+).
            let case = if power.n == 1 { "(±,∓)".to_string() } else { label(power.cases[0]) };
            let (x, y) = place(at);
            let (x, anchor) = if side > 0.0 { (x + 1.5, Anchor::Start) } else { (x - 1.5, Anchor::End) };
            canvas.text(format!("{} {case}", power.n), (x, y), anchor);
        }
    }
    for power in powers {
        let (radius, ink) = power.cases.first().map_or((1.3, GREY), |&case| (2.2, colour(case)));
        canvas.disc(place(power.at), radius, ink);
    }
    canvas.disc(place((1.0, 0.0)), 1.7, BLACK);
    let (x, y) = place((1.0, 0.0));
    canvas.text("1", (x + 4.0, y), Anchor::Start);
    let below = CENTRE.1 + UNIT + 26.0;
    let title = format!("λ = r e^{{2πi s}}, r = {modulus}, s = {turn}, n ≤ {last}");
    canvas.text(title, (4.0, below + ROW / 2.0), Anchor::Start);
    let (mut below, room) = (below + ROW, "no room for the labels of the later periods");
    if unlabelled > 0 {
        canvas.text(format!("{unlabelled} more rays: {room}"), (4.0, below + ROW / 2.0), Anchor::Start);
        canvas.height += ROW;
        below += ROW;
    }
    legend.draw(&mut canvas, (4.0, below), COLUMN - 8.0);
    canvas
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
