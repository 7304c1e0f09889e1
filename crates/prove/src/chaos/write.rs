//! What the search found, as a certificate.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, pow};

use super::{Problem, graph::LetterGraph, search::Closed, span::Span};
use crate::{
    certificate::chaos::{Certificate, Decimal, Fraction, Harmonic, Letter},
    error::{Error, Result},
};

/// The most digits of a number in a certificate.
const DIGITS: usize = 15;

/// The certificate and its text.
pub(super) fn certificate(problem: &Problem, closed: &Closed) -> Result<(Certificate, String)> {
    let graph = LetterGraph { letters: problem.letters.clone(), next: problem.next.clone() };
    let (rate, vector) = graph.growth_either_way();
    // An entry of 13 places is so far from its true value, in proportion.
    let least = vector.iter().copied().fold(1.0, f64::min);
    let margin = (1e-11f64).max(2e-12 / least);
    let range = |span: Span| -> Result<[Decimal; 2]> {
        let places = (places(span) + 3).min(13);
        Ok([decimal(span.lo, places)?, decimal(span.hi, places)?])
    };
    let letters = (0..problem.letters.len()).map(|n| {
        Ok(Letter {
            periods: problem.letters[n],
            after: range(closed.boxes[n][0])?,
            before: range(closed.boxes[n][1])?,
            weights: [decimal(closed.weights[n][0], 9)?, decimal(closed.weights[n][1], 9)?],
            growth: decimal(vector[n], 13)?,
            parts: closed.parts[n],
            next: problem.next[n].clone(),
        })
    });
    let letters = letters.collect::<Result<Vec<_>>>()?;
    let fractions =
        |[lo, hi]: &[BigRational; 2]| -> Result<[Fraction; 2]> { Ok([fraction(lo)?, fraction(hi)?]) };
    let ranges = problem.ranges.iter().map(fractions).collect::<Result<Vec<_>>>()?;
    let harmonics = problem
        .harmonics
        .iter()
        .map(|(order, [a, b])| Ok(Harmonic { order: *order, parts: [fractions(a)?, fractions(b)?] }));
    let certificate = Certificate {
        mirrored: problem.mirrored,
        ranges: ranges.try_into().map_err(|_| Error::input("five ranges"))?,
        behind: problem.behind,
        harmonics: harmonics.collect::<Result<_>>()?,
        cells: closed.cells,
        window: decimal(closed.window, 3)?,
        pieces: closed.pieces,
        letters,
        // Another checker's enclosures may be a little wider.
        contraction: decimal((closed.contraction * 1005.0 + 1.0).ceil() / 1000.0, 3)?,
        reach: decimal((closed.reach * 11.0).ceil() / 10.0 + 0.1, 1)?,
        growth: [decimal(rate - margin, 12)?, decimal(rate + margin, 12)?],
        complete: closed.complete,
    };
    let text = certificate.to_string();
    Ok((certificate, text))
}

/// The decimals that a range's ends are rounded to: two or three digits of its width.
pub(crate) fn places(span: Span) -> i32 {
    (2 - span.width().max(1e-11).log10().floor() as i32).clamp(0, 13)
}

/// Rounded to so many places.
pub(crate) fn decimal(x: f64, places: i32) -> Result<Decimal> {
    let digits = (x * 10f64.powi(places)).round();
    if digits.abs() >= 1e15 || !digits.is_finite() {
        return Err(Error::input(format!("{x} has more than the {DIGITS} digits that a certificate holds")));
    }
    let (mut digits, mut places) = (digits as i128, places.max(0) as u32);
    while places > 0 && digits % 10 == 0 {
        (digits, places) = (digits / 10, places - 1);
    }
    Ok(Decimal { digits, places })
}

pub(crate) fn fraction(x: &BigRational) -> Result<Fraction> {
    let part = |n: &BigInt| n.to_i128().filter(|n| n.unsigned_abs() < 10u128.pow(DIGITS as u32));
    let both = part(x.numer()).zip(part(x.denom()));
    let (p, q) = both.ok_or_else(|| {
        Error::input(format!("{x} has more than the {DIGITS} digits that a certificate holds"))
    })?;
    Ok(Fraction { p, q })
}

/// The fraction itself if it is short enough for a certificate, else the nearest of 12 places below or above.
pub(super) fn short(x: &BigRational, up: bool) -> BigRational {
    if fraction(x).is_ok() {
        return x.clone();
    }
    let scale = BigRational::from_integer(pow(BigInt::from(10), 12));
    let scaled = x * &scale;
    (if up { scaled.ceil() } else { scaled.floor() }) / scale
}
