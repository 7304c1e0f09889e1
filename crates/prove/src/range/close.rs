//! A cell: ranges of strengths that the map keeps, factors and weights, as far as floats tell.
//!
//! The map is iterated on spans, from those of the cell before, until they change no more: the least that it
//! keeps, if there are such. Each round takes for m what makes |1 − m (1 − f_s)| least. The weights are about
//! the eigenvector of the greatest derivatives.

use super::{
    effort::RangeEffort,
    map::{Depths, Edges, Image},
};
use crate::chaos::span::Span;

/// What the map keeps in a cell.
#[derive(Debug, Clone)]
pub(super) struct Closed {
    pub strengths: Vec<Span>,
    pub factors: Vec<f64>,
    pub weights: Vec<f64>,
    pub contraction: f64,
    pub parts: u64,
}

/// Rounds of the map.
const ROUNDS: usize = 150;
/// No greater contraction is tried.
const MOST: f64 = 0.997;
/// Strengths of a certificate are smaller.
const FAR: f64 = 3e4;

/// The factors for these images: m (1 − f_s) about 1.
fn factors(images: &[Image]) -> Option<Vec<f64>> {
    let one = |image: &Image| {
        let lost = 1.0 - image.own.middle();
        (lost.abs() > 1e-6).then(|| rounded(1.0 / lost))
    };
    images.iter().map(one).collect()
}

/// To six digits or so: what a certificate has.
fn rounded(x: f64) -> f64 {
    let scale = 10f64.powi(6 - x.abs().log10().floor().clamp(-6.0, 4.0) as i32);
    (x * scale).round() / scale
}

/// Ranges about these strengths that the map keeps.
pub(super) fn close(
    depths: &Depths,
    edges: &Edges,
    start: &[f64],
    parts: u64,
    effort: &RangeEffort,
) -> Option<Closed> {
    let mut strengths: Vec<Span> = start.iter().map(|&s| Span::point(s)).collect();
    let mut m = factors(&depths.image(edges, &strengths, &vec![1.0; start.len()], parts, effort)?)?;
    let mut settled = false;
    for _ in 0..ROUNDS {
        let images = depths.image(edges, &strengths, &m, parts, effort)?;
        let small = |old: Span, new: Span| {
            (old.lo - new.lo).abs().max((old.hi - new.hi).abs()) <= 2e-3 * new.width() + 1e-12
        };
        settled = strengths.iter().zip(&images).all(|(&old, image)| small(old, image.strengths));
        strengths = images.iter().map(|image| image.strengths).collect();
        if strengths.iter().any(|span| span.magnitude() > FAR) {
            return None;
        }
        m = factors(&images)?;
        if settled {
            break;
        }
    }
    if !settled {
        return None;
    }
    [0.02, 0.06, 0.005]
        .iter()
        .find_map(|&share| widened(depths, edges, (&strengths, &m), share, parts, effort))
}

/// The same, wider by a share of the widths: the image of the last, wider by that much, round by round.
fn widened(
    depths: &Depths,
    edges: &Edges,
    (strengths, factors): (&[Span], &[f64]),
    share: f64,
    parts: u64,
    effort: &RangeEffort,
) -> Option<Closed> {
    let margins: Vec<f64> =
        strengths.iter().map(|span| share * span.width() + 1e-10 * (1.0 + span.magnitude())).collect();
    let mut image = strengths.to_vec();
    for _ in 0..40 {
        let both = image.iter().zip(&margins);
        let wide: Vec<Span> = both.map(|(span, &margin)| span.widened(margin)).collect();
        let images = depths.image(edges, &wide, factors, parts, effort)?;
        // Another checker's enclosures may be a little wider.
        let inside = |(wide, image): (&Span, &Image)| {
            image.strengths.widened(2e-3 * wide.width() + 1e-12).is_in(*wide)
        };
        if wide.iter().zip(&images).all(inside) {
            let (weights, contraction) = weights(&images, factors);
            let factors = factors.to_vec();
            let closed = Closed { strengths: wide, factors, weights, contraction, parts };
            return (contraction < MOST).then_some(closed);
        }
        image = images.iter().map(|image| image.strengths).collect();
    }
    None
}

/// Weights that make the contraction about as small as it can be, and that contraction.
fn weights(images: &[Image], factors: &[f64]) -> (Vec<f64>, f64) {
    let mut w: Vec<f64> = images.iter().map(|image| image.strengths.width() + 1e-9).collect();
    let mut best = (w.clone(), f64::INFINITY);
    for _ in 0..300 {
        let greatest = w.iter().copied().fold(0.0, f64::max);
        w.iter_mut().for_each(|x| *x = ((*x / greatest).max(1e-9) * 1e12).ceil() / 1e12);
        let rows: Vec<f64> = images
            .iter()
            .zip(factors)
            .zip(&w)
            .map(|((image, m), own)| {
                let slope = (Span::point(1.0 - m) + image.own.times(*m)).magnitude();
                let most = |list: &[(usize, f64)]| {
                    list.iter().map(|&(other, slope)| slope * w[other]).fold(0.0, f64::max)
                };
                slope * own + m.abs() * (most(&image.before) + most(&image.after))
            })
            .collect();
        let ratio = rows.iter().zip(&w).map(|(row, w)| row / w).fold(0.0, f64::max);
        if ratio < best.1 {
            best = (w.clone(), ratio);
        }
        w.iter_mut().zip(&rows).for_each(|(w, row)| *w = 0.5 * *w * ratio + 0.5 * row);
    }
    best
}
