//! Between two points of a curve: a guess at others from both tangents, and where a function changes sign.

use super::curve::{CurvePoint, difference, dot, largest};
use crate::error::Result;

/// The cubic through two points of a curve with their tangents, at the fraction s of the way along `normal`.
pub(super) fn cubic(a: &CurvePoint, b: &CurvePoint, normal: &[f64], s: f64) -> Vec<f64> {
    let reach = dot(&difference(&b.u, &a.u), normal);
    let [departs, arrives] = [a, b].map(|end| reach / dot(normal, &end.tangent));
    let at = |i: usize| {
        let (chord, from, to) = (b.u[i] - a.u[i], departs * a.tangent[i], arrives * b.tangent[i]);
        a.u[i] + s * (from + s * (3.0 * chord - 2.0 * from - to + s * (from + to - 2.0 * chord)))
    };
    (0..a.u.len()).map(at).collect()
}

/// Where a function changes sign, by the Illinois rule with bisections: to a few units in the last place of
/// its argument or, where those are larger, of the unknowns; with its argument's point; no point if the
/// function fails there.
pub(super) fn root(
    function: impl Fn(f64) -> Result<(Option<f64>, CurvePoint)>,
    mut a: (f64, f64),
    mut b: (f64, f64),
) -> (f64, Option<CurvePoint>) {
    let width = b.0 - a.0;
    let mut kept = None;
    let mut best: (f64, f64, Option<CurvePoint>) = (a.0, f64::INFINITY, None);
    for round in 0..100 {
        let secant = b.0 - b.1 * (b.0 - a.0) / (b.1 - a.1);
        let inside = round % 8 < 7 && secant > a.0 && secant < b.0;
        let middle = if inside { secant } else { (a.0 + b.0) / 2.0 };
        let Ok((Some(value), place)) = function(middle) else { return (middle, None) };
        // A length along the curve is known no better than the unknowns are.
        let rounding = (1e-15 * width).max(2.0 * f64::EPSILON * (1.0 + largest(&place.u)));
        if value.abs() <= best.1 {
            best = (middle, value.abs(), Some(place));
        }
        if value == 0.0 || middle == a.0 || middle == b.0 {
            break;
        }
        // The end that stays twice counts half.
        let upper = (value < 0.0) == (b.1 < 0.0);
        let other = if upper { &mut a } else { &mut b };
        if kept == Some(upper) {
            other.1 /= 2.0;
        }
        kept = Some(upper);
        *(if upper { &mut b } else { &mut a }) = (middle, value);
        if b.0 - a.0 <= rounding {
            break;
        }
    }
    (best.0, best.2)
}

#[cfg(test)]
mod tests {
    use std::{cell::Cell, f64::consts::FRAC_PI_3};

    use super::*;

    /// The point of the unit circle at an angle.
    fn point(angle: f64) -> CurvePoint {
        let (sin, cos) = angle.sin_cos();
        CurvePoint { u: vec![cos, sin], tangent: vec![-sin, cos], residual: 0.0, steps: 1 }
    }

    /// To fourth order, and along the direction asked for.
    #[test]
    fn the_cubic_keeps_to_the_curve_and_to_its_part_of_the_way() {
        for (width, tolerance) in [(0.2, 1e-4), (0.02, 1e-8), (0.002, 1e-12)] {
            for first in [0.0, 0.15] {
                let (a, b, normal) = (point(first), point(first + width), [0.0, 1.0]);
                for s in [0.0, 0.25, 0.7, 1.0] {
                    let u = cubic(&a, &b, &normal, s);
                    assert!((norm(&u) - 1.0).abs() < tolerance, "{width} {s}: {u:?}");
                    let along = a.u[1] + s * (b.u[1] - a.u[1]);
                    assert!((u[1] - along).abs() < 1e-15, "{width} {s}: {u:?}");
                }
            }
        }
    }

    fn norm(u: &[f64]) -> f64 {
        dot(u, u).sqrt()
    }

    /// To rounding, and no evaluations are spent on digits that the unknowns do not have.
    #[test]
    fn a_root_is_known_as_well_as_the_unknowns_are() {
        let found = |scale: f64| {
            let count = Cell::new(0);
            let f = |angle: f64| {
                count.set(count.get() + 1);
                let mut place = point(angle);
                place.u.iter_mut().for_each(|u| *u *= scale);
                // What rounding leaves of the unknowns.
                Ok((Some((scale + (0.5 - angle.cos())) - scale), place))
            };
            let (angle, place) = root(f, (0.9, 0.5 - 0.9f64.cos()), (1.2, 0.5 - 1.2f64.cos()));
            let off = (angle - FRAC_PI_3).abs();
            assert!(off < 4.0 * f64::EPSILON * (1.0 + scale), "{scale}: {off:e}");
            assert!((place.unwrap().u[0] - 0.5 * scale).abs() < 1e-14 * (1.0 + scale * scale));
            count.get()
        };
        let counts = [found(1.0), found(100.0), found(1e4)];
        assert!(counts.iter().all(|count| *count <= 10), "{counts:?}");
    }

    /// A jump has no zero: its place all the same, and an end.
    #[test]
    fn a_jump_is_found_by_bisection() {
        let f = |x: f64| Ok((Some(if x < 0.3 { -1.0 } else { 2.0 }), point(x)));
        let (x, place) = root(f, (0.0, -1.0), (1.0, 2.0));
        assert!((x - 0.3).abs() < 4e-15 && place.is_some(), "{x}");
        let (_, place) = root(|x| Ok((None, point(x))), (0.0, -1.0), (1.0, 2.0));
        assert!(place.is_none());
    }
}
