//! The wall's motion g(t) = Σ a cos jt + b sin jt, its top at g(0) = 1: how far it is below its top, its
//! speed and its bend, in spans.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::span::Span;

/// A harmonic of the wall's motion: its order j and the ranges of a and b.
pub type Term = (u64, [[BigRational; 2]; 2]);

/// g by its harmonics.
#[derive(Debug, Clone)]
pub(crate) struct Profile {
    terms: Vec<(f64, [Span; 2])>,
    plain: bool,
}

/// 1 − g, −g′ and −g″.
pub(crate) struct Shape {
    pub drop: Span,
    pub slope: Span,
    pub bend: Span,
}

impl Profile {
    pub(crate) fn new(terms: &[Term]) -> Profile {
        let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
        let span = |[lo, hi]: &[BigRational; 2]| Span::new(float(lo), float(hi));
        let terms: Vec<_> = terms.iter().map(|(j, both)| (*j as f64, both.each_ref().map(span))).collect();
        let plain = terms == [(1.0, [Span::point(1.0), Span::point(0.0)])];
        Profile { terms, plain }
    }

    /// Whether it is cos t.
    pub(crate) fn is_cosine(&self) -> bool {
        self.plain
    }

    /// At every phase of a span; Σ a = 1 and Σ j b = 0 are used, so that what vanishes at 0 does so here.
    pub(crate) fn at(&self, t: Span) -> Shape {
        let zero = Span::point(0.0);
        let mut shape = Shape { drop: zero, slope: zero, bend: zero };
        for &(j, [a, b]) in &self.terms {
            let (cos, sin) = (cosine(t.times(j)), cosine(t.times(j) - Span::point(FRAC_PI_2)));
            let fall = Span::point(1.0) - cos;
            shape.drop = shape.drop + a * fall - b * sin;
            shape.slope = shape.slope + (a * sin + b * fall).times(j);
            shape.bend = shape.bend + (a * cos + b * sin).times(j * j);
        }
        shape
    }

    /// The phases at which −g′ has these values, if they are between the wall's turns of bend about 0 and
    /// within π/2.
    pub(crate) fn phase(&self, y: Span) -> Option<Span> {
        if !y.is_finite() {
            return None;
        }
        if self.plain {
            return (y.magnitude() < 1.0).then(|| Span::new(y.lo.asin(), y.hi.asin()));
        }
        let one = |y: f64| {
            let mut t = 0.0f64;
            for _ in 0..40 {
                let shape = self.at(Span::point(t));
                if shape.bend.lo <= 0.0 || t.abs() >= FRAC_PI_2 {
                    return None;
                }
                let error = Span::point(y) - shape.slope;
                let step = error.middle() / shape.bend.middle();
                if step.abs() < 1e-15 {
                    return Some(Span::point(t).widened(error.magnitude() / shape.bend.lo));
                }
                t += step;
            }
            None
        };
        let both = one(y.lo)?.hull(one(y.hi)?);
        (self.at(both.hull(Span::point(0.0))).bend.lo > 0.0).then_some(both)
    }

    /// −g″ at these phases, and (1 − g)/g′².
    pub(crate) fn bends(&self, phase: Span) -> [Span; 2] {
        let bend = self.at(phase).bend;
        if self.plain {
            return [bend, Span::point(1.0).over(Span::point(1.0) + bend)];
        }
        let all = self.at(phase.hull(Span::point(0.0))).bend;
        [bend, Span::point(0.5).over(all)]
    }
}

/// The cosines of a span.
fn cosine(t: Span) -> Span {
    if !t.is_finite() || t.width() >= TAU {
        return Span::new(-1.0, 1.0);
    }
    let ends = Span::point(t.lo.cos()).hull(Span::point(t.hi.cos()));
    let holds = |x: f64| ((t.hi - x) / TAU).floor() * TAU + x >= t.lo;
    let hi = if holds(0.0) { 1.0 } else { ends.hi };
    let lo = if holds(PI) { -1.0 } else { ends.lo };
    Span::new(lo, hi)
}
