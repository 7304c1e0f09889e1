//! Beyond a touch at which nothing is born: that no motion stays near, from the touch to a depth.
//!
//! proofs/ranges.md has the theorem. Near is a zone of phases about the touch: where the wall is above the
//! place of rest by more than a part of what it is at its top, and no farther than an angle. The wider it is,
//! the more is said and the sooner the proof ends; zones are tried from the widest, and the checker judges
//! each cell.

use num_rational::BigRational;

use super::{
    RangeEffort, RangeEnd,
    map::{Edges, Oscillator},
    oscillator, window, write,
};
use crate::{
    Accepted,
    certificate::nothing::{Cell, Certificate, Fraction, Harmonic, cell_holds},
    chaos::{Term, span::Span, write::decimal},
    error::Result,
    monitor::Monitor,
};

/// What is to be proved: beyond its touch no motion of an oscillator stays near.
#[derive(Debug, Clone)]
pub struct NothingProblem {
    /// Whether there are two walls, the upper one the mirror image of the lower.
    pub mirrored: bool,
    /// The ranges of c, k, τ.
    pub ranges: [[BigRational; 2]; 3],
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// No depth beyond this is asked for.
    pub deepest: f64,
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct NothingProof {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// The greatest ν.
    pub depth: BigRational,
    /// Within so many of the wall's periods, or half periods, every motion meets it elsewhere.
    pub periods: u64,
    /// Near are at least all phases within the window at which |g′| is up to this, at depths from
    /// [`NothingProof::FROM`] on; fewer below it. If that is not reached, in the last cell.
    pub slope: f64,
    /// Why it goes no further.
    pub end: RangeEnd,
}

impl NothingProof {
    /// From this depth on the zone is told.
    pub const FROM: f64 = 1e-2;

    /// Near are at least all phases up to this, at the same depths.
    #[must_use]
    pub fn zone(&self) -> f64 {
        let window = write::float(self.certificate.window);
        let most = |[lo, hi]: &[Fraction; 2]| {
            [lo, hi].map(|x| (x.p as f64 / x.q as f64).abs()).into_iter().fold(0.0, f64::max)
        };
        let zone = match &self.certificate.harmonics[..] {
            // Of g = cos t, |g′| is up to the slope where |t| is up to its arcsine; else where |g″| t is.
            [one] if one.order == 1 => self.slope.asin(),
            all => {
                let bend =
                    |one: &Harmonic| (one.order * one.order) as f64 * one.parts.iter().map(most).sum::<f64>();
                self.slope / all.iter().map(bend).sum::<f64>() * (1.0 - 1e-12)
            }
        };
        zone.min(window)
    }
}

/// Where the first cell ends.
const FIRST: f64 = 1e-4;
/// Zones, from the widest: the part of the height of the wall's top, as a square root, and the greatest −g′.
const ZONES: [[f64; 2]; 7] =
    [[0.6, 0.3], [0.5, 0.2], [0.4, 0.15], [0.3, 0.1], [0.2, 0.05], [0.1, 0.02], [0.05, 0.01]];
/// A narrower zone must reach so much deeper.
const WORTH: f64 = 1.1;
/// Rounds, from the fewest.
const ROUNDS: [u64; 4] = [2, 3, 5, 10];
/// Into how many parts strengths are cut.
const PARTS: [u64; 4] = [1, 2, 4, 8];
/// The longest legs.
const LONGEST: u64 = 60;
/// A cell ends so many times as deep as it begins, at first; and where less than the last is the end.
const STEP: f64 = 1.3;
const LAST: f64 = 1.005;
/// The most cells.
const CELLS: usize = 1000;

/// What is found of one zone.
struct Found {
    certificate: Certificate,
    depth: f64,
    slope: f64,
    end: RangeEnd,
}

/// The widest zone that goes deep, and its largest range; or why there is none.
///
/// Cost: `effort`, a leg being one of C3.
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove_nothing(
    problem: &NothingProblem,
    effort: &RangeEffort,
    monitor: &dyn Monitor,
) -> Result<std::result::Result<NothingProof, RangeEnd>> {
    let oscillator = oscillator(problem.mirrored, &problem.ranges, true, &problem.harmonics);
    let Some(longest) = longest(&oscillator) else { return Ok(Err(RangeEnd::Unbounded)) };
    let start = Certificate {
        mirrored: problem.mirrored,
        ranges: write::ranges(&problem.ranges)?,
        harmonics: write::harmonics(&problem.harmonics)?,
        window: decimal(window(&oscillator.profile), 3)?,
        pieces: write::PIECES,
        longest,
        rounds: 0,
        cells: Vec::new(),
    };
    let mut best: Option<Found> = None;
    let mut end = RangeEnd::Map;
    for zone in ZONES {
        let most = ROUNDS[ROUNDS.len() - 1];
        let found =
            over(&Certificate { rounds: most, ..start.clone() }, zone, problem.deepest, effort, monitor)?;
        if found.certificate.cells.is_empty() {
            end = found.end;
            // That no zone mends.
            if matches!(&end, RangeEnd::Refused(reason) if born(reason)) {
                break;
            }
        } else if best.as_ref().is_none_or(|best| found.depth > WORTH * best.depth) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|best| best.depth * WORTH >= problem.deepest) || effort.is_spent() {
            break;
        }
    }
    let Some(mut best) = best else { return Ok(Err(end)) };
    // The fewest rounds that do say the soonest by when a motion leaves.
    for rounds in ROUNDS {
        let fewer = Certificate { rounds, ..best.certificate.clone() };
        // Counted, and not ended: without it nothing is proved.
        let mut counted = || {
            let _ = effort.take(1);
            false
        };
        let mut cells = 0..fewer.cells.len();
        if cells.try_for_each(|cell| cell_holds(&fewer, cell, &mut counted)).is_ok() {
            best.certificate = fewer;
            break;
        }
        monitor.advance(0)?;
    }
    match Accepted::new(best.certificate.to_string()) {
        Err(rejection) => Ok(Err(RangeEnd::Refused(rejection.to_string()))),
        Ok(accepted) => {
            let last = best.certificate.cells[best.certificate.cells.len() - 1].depth;
            let depth = BigRational::new(last.p.into(), last.q.into());
            let (periods, slope, end) = (best.certificate.periods(), best.slope, best.end);
            Ok(Ok(NothingProof { certificate: best.certificate, accepted, depth, periods, slope, end }))
        }
    }
}

/// The longest leg that the trace and the determinant of E(2π) allow, by C2 in floats.
pub(super) fn longest(oscillator: &Oscillator) -> Option<u64> {
    let depths = oscillator.depths(Span::point(0.0), &Edges::none());
    let [trace, determinant] = depths.invariants().map(Span::middle);
    let mut ratio = trace;
    for n in 2..=LONGEST {
        if ratio <= -1e-9 {
            return Some(n);
        }
        ratio = trace - determinant / ratio;
    }
    None
}

/// Whether the checker refuses because something may be born.
fn born(reason: &str) -> bool {
    reason.contains("(T)")
}

/// Cell after cell in a zone, each as deep as the checker accepts.
fn over(
    start: &Certificate,
    [height, slope]: [f64; 2],
    deepest: f64,
    effort: &RangeEffort,
    monitor: &dyn Monitor,
) -> Result<Found> {
    let mut certificate = start.clone();
    let (mut depth, mut step, mut level, mut least) = (0.0, STEP, 0, f64::INFINITY);
    let mut next = FIRST.min(deepest);
    let end = loop {
        monitor.advance(0)?;
        if depth >= deepest {
            break RangeEnd::Asked;
        }
        if certificate.cells.len() >= CELLS {
            break RangeEnd::Work;
        }
        next = write::depth(next.min(deepest));
        // (1 − g)/ν is about νS²/8, the wall being 1 at its top; −g′ is νS/2.
        let strength = (height * (8.0 / next).sqrt()).min(2.0 * slope / next);
        let written = decimal((strength * 1000.0).floor() / 1000.0, 3)?;
        let parts = PARTS[level];
        let at = certificate.cells.len();
        certificate.cells.push(Cell { depth: write::depth_fraction(next), strength: written, parts });
        match effort.judged(|| cell_holds(&certificate, at, &mut || effort.stops())) {
            Ok(()) => {
                let here = depth.max(NothingProof::FROM).min(next) * write::float(written) / 2.0;
                least = if depth > NothingProof::FROM { least.min(here) } else { here };
                depth = next;
                next = depth * step;
            }
            Err(reason) => {
                certificate.cells.pop();
                if effort.is_spent() {
                    break RangeEnd::Work;
                }
                if born(&reason) {
                    break RangeEnd::Refused(reason);
                }
                if level + 1 < PARTS.len() {
                    level += 1;
                } else if depth == 0.0 || step < LAST {
                    break RangeEnd::Refused(reason);
                } else {
                    (step, level) = (step.sqrt(), 0);
                    next = depth * step;
                }
            }
        }
    };
    Ok(Found { certificate, depth, slope: least, end })
}
