//! What the search found, as a certificate.

use num_rational::BigRational;

use super::{RangeProblem, close::Closed};
use crate::{
    certificate::range::{Cell, Certificate, Decimal, Edge, Fraction, Harmonic, Letter},
    chaos::{
        LetterGraph, Term,
        write::{decimal, fraction, places},
    },
    error::Result,
};

/// Into how many pieces a window and a time between are cut.
pub(super) const PIECES: u64 = 32;

/// No greater contraction is written.
const MOST: f64 = 0.999;

/// A contraction as a certificate has it: rounded up, and a little more, for another checker's enclosures.
pub(super) fn contraction(x: f64) -> Result<Decimal> {
    decimal(((x * 1005.0 + 1.0).ceil() / 1000.0).min(MOST), 3)
}

/// Bounds of the growth rate, with a vector that proves them. Of a graph that is not connected they are
/// coarse: every letter has at least one successor, and at most so many.
fn rates(graph: &LetterGraph) -> (f64, f64, Vec<f64>) {
    if !graph.is_connected() {
        let most = graph.next.iter().map(Vec::len).max().unwrap_or(1);
        return (1.0, most as f64 + 1.0, vec![1.0; graph.letters.len()]);
    }
    let (rate, vector) = graph.growth_either_way();
    let margin = (1e-11f64).max(2e-12 / vector.iter().copied().fold(1.0, f64::min));
    // Of one cycle the rate is 1 itself.
    let low = if rate < 1.0 + 1e-9 { 1.0 } else { rate - margin };
    (low.max(1.0), rate + margin, vector)
}

fn fractions([lo, hi]: &[BigRational; 2]) -> Result<[Fraction; 2]> {
    Ok([fraction(lo)?, fraction(hi)?])
}

/// The ranges of c, k, τ.
pub(crate) fn ranges(
    [damping, stiffness, restitution]: &[[BigRational; 2]; 3],
) -> Result<[[Fraction; 2]; 3]> {
    Ok([fractions(damping)?, fractions(stiffness)?, fractions(restitution)?])
}

/// The wall's harmonics.
pub(crate) fn harmonics(all: &[Term]) -> Result<Vec<Harmonic>> {
    all.iter()
        .map(|(order, [a, b])| Ok(Harmonic { order: *order, parts: [fractions(a)?, fractions(b)?] }))
        .collect()
}

/// All but the cells.
pub(super) fn head(problem: &RangeProblem, window: f64) -> Result<Certificate> {
    let (low, high, vector) = rates(&problem.graph);
    let graph = &problem.graph;
    let letters = graph.letters.iter().zip(&graph.next).zip(vector).map(|((&periods, next), growth)| {
        Ok(Letter { periods, growth: decimal(growth, 13)?, next: next.clone() })
    });
    Ok(Certificate {
        mirrored: problem.mirrored,
        ranges: ranges(&problem.ranges)?,
        behind: problem.behind,
        harmonics: harmonics(&problem.harmonics)?,
        window: decimal(window, 3)?,
        pieces: PIECES,
        letters: letters.collect::<Result<_>>()?,
        growth: [decimal(low, 12)?, decimal(high, 12)?],
        contraction: contraction(MOST)?,
        alone: None,
        cells: Vec::new(),
    })
}

/// A cell up to a depth.
pub(super) fn cell(closed: &Closed, depth: f64) -> Result<Cell> {
    let edges = (0..closed.strengths.len()).map(|edge| {
        let span = closed.strengths[edge];
        let places = (places(span) + 3).min(13);
        let strengths: [Decimal; 2] = [decimal(span.lo, places)?, decimal(span.hi, places)?];
        Ok(Edge {
            strengths,
            factor: short(closed.factors[edge])?,
            weight: decimal(closed.weights[edge], 12)?,
        })
    });
    Ok(Cell {
        depth: depth_fraction(depth),
        parts: closed.parts,
        steps: 0,
        others: None,
        edges: edges.collect::<Result<_>>()?,
    })
}

/// A decimal of about seven digits.
fn short(x: f64) -> Result<Decimal> {
    decimal(x, (6 - x.abs().log10().floor().clamp(-6.0, 4.0) as i32).max(0))
}

/// A depth of six digits, and of 15 places at most, downwards.
pub(crate) fn depth(x: f64) -> f64 {
    let (p, q) = parts(x);
    p as f64 / q as f64
}

/// The same as a fraction.
pub(crate) fn depth_fraction(x: f64) -> Fraction {
    let (p, q) = parts(x);
    Fraction { p, q }
}

fn parts(x: f64) -> (i128, i128) {
    let places = (5 - x.log10().floor() as i32).clamp(0, 14) as u32;
    let mut q = 10i128.pow(places);
    // What is nearly a number of so many digits is that one.
    let mut p = (x * q as f64 * (1.0 + 1e-12)).floor() as i128;
    let divisor = num_integer::gcd(p, q);
    (p, q) = (p / divisor, q / divisor);
    (p, q)
}

/// A certificate's decimal.
pub(crate) fn float(x: Decimal) -> f64 {
    x.to_string().parse().unwrap_or(f64::INFINITY)
}
