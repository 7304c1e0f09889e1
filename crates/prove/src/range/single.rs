//! An orbit of one impact along its curve, proved from the touch on: past its flips, to where it folds, or
//! meets the wall once more.
//!
//! The depth is an explicit function of the phase of the impact, so that nothing has to be found but cells of
//! the phase; the checker judges each. proofs/ranges.md has the theorem.

use num_rational::BigRational;

use super::{RangeEffort, RangeEnd, write};
use crate::{
    Accepted,
    certificate::single::{Certificate, Found, Part, Word, cell_holds},
    chaos::{Term, write::decimal},
    error::Result,
    monitor::Monitor,
};

/// What is to be proved: the orbit of one impact that is born at a touch.
#[derive(Debug, Clone)]
pub struct SingleProblem {
    /// Whether there are two walls, the upper one the mirror image of the lower; then periods are half
    /// periods.
    pub mirrored: bool,
    /// The ranges of c, k, τ.
    pub ranges: [[BigRational; 2]; 3],
    /// Whether σ = 1.
    pub behind: bool,
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// From one impact to the next.
    pub periods: u64,
    /// No depth beyond this is asked for.
    pub deepest: f64,
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SingleProof {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// The greatest ν.
    pub depth: BigRational,
    /// Up to which ν, from that of the part before, the orbit is stable, unstable, or neither is proved.
    pub parts: Vec<(BigRational, Word)>,
    /// Why it goes no further.
    pub end: RangeEnd,
}

/// Into how many pieces a period is cut, one after the other.
const PIECES: [u64; 3] = [32, 96, 288];
/// The most pieces of all periods.
const ALL_PIECES: u64 = 60_000;
/// The first cell that is tried.
const FIRST: f64 = 0.5;
/// The smallest first cell.
const SMALLEST: f64 = 1e-10;
/// A step that is so small a part of the phase is the last.
const LAST: f64 = 2e-5;
/// The first of cells in which it is not known whether the orbit is stable is no longer than such a part of
/// the phase.
const OPEN: f64 = 5e-4;
/// The most cells, and parts.
const CELLS: usize = 2000;
const PARTS: usize = 60;
/// No phase is beyond this.
const FARTHEST: f64 = 3.125;

/// The largest range that is found, or why there is none.
///
/// Cost: `effort`, a piece of a motion being a leg.
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove_single(
    problem: &SingleProblem,
    effort: &RangeEffort,
    monitor: &dyn Monitor,
) -> Result<std::result::Result<SingleProof, RangeEnd>> {
    let mut search = Search {
        problem,
        certificate: Certificate {
            mirrored: problem.mirrored,
            ranges: write::ranges(&problem.ranges)?,
            behind: problem.behind,
            harmonics: write::harmonics(&problem.harmonics)?,
            periods: problem.periods,
            forward: true,
            pieces: PIECES[0],
            parts: Vec::new(),
            cells: Vec::new(),
        },
        found: Vec::new(),
    };
    let mut best = None;
    let mut end = RangeEnd::Map;
    for pieces in PIECES.into_iter().filter(|pieces| pieces * problem.periods <= ALL_PIECES) {
        search.certificate.pieces = pieces;
        end = search.run(effort, monitor)?;
        // More pieces add to what fewer had proved, if that goes through with them, too.
        match search.proof(&end)? {
            Ok(proof) => best = Some(proof),
            Err(_) if best.is_some() => break,
            Err(why) => end = why,
        }
        if end == RangeEnd::Asked || effort.is_spent() {
            break;
        }
    }
    Ok(best.ok_or(end))
}

/// The cells so far.
struct Search<'a> {
    problem: &'a SingleProblem,
    certificate: Certificate,
    found: Vec<Found>,
}

/// A depth in floats.
fn float(units: i128) -> f64 {
    units as f64 / (1u64 << 48) as f64
}

impl Search<'_> {
    /// Cell after cell, from where the last ends; why there is no next one.
    fn run(&mut self, effort: &RangeEffort, monitor: &dyn Monitor) -> Result<RangeEnd> {
        let deepest = self.problem.deepest;
        let mut phase = self.certificate.cells.last().map_or(0.0, |last| write::float(*last));
        let mut step = if phase > 0.0 { 0.01 * phase } else { FIRST };
        loop {
            monitor.advance(0)?;
            if self.found.last().is_some_and(|cell| float(cell.reach) >= deepest) {
                return Ok(RangeEnd::Asked);
            }
            if self.certificate.cells.len() >= CELLS || effort.is_spent() {
                return Ok(RangeEnd::Work);
            }
            if phase >= FARTHEST {
                return Ok(RangeEnd::Asked);
            }
            let next = (phase + step).min(FARTHEST);
            // Four digits of what the cell adds, and no fewer of the phase itself.
            let places = (4 - (next - phase).log10().floor() as i32).clamp(0, 14);
            let last = decimal(next, places)?;
            let next = write::float(last);
            let open = self.found.last().is_some_and(|cell| cell.word == Word::Open);
            let failed = if next > phase {
                let at = self.certificate.cells.len();
                self.certificate.cells.push(last);
                match self.judge(at, effort) {
                    Ok(found) if found.word != Word::Open || open || step <= OPEN * next => {
                        self.found.push(found);
                        (phase, step) = (next, 1.6 * step);
                        continue;
                    }
                    Ok(_) => None,
                    Err(why) => Some(why),
                }
            } else {
                Some("the cell is empty".into())
            };
            if self.certificate.cells.len() > self.found.len() {
                self.certificate.cells.pop();
            }
            step *= 0.5;
            if let Some(why) = failed.filter(|_| step < (LAST * phase).max(SMALLEST)) {
                // What was ended before it was done refuses nothing.
                return Ok(if effort.is_spent() { RangeEnd::Work } else { RangeEnd::Refused(why) });
            }
        }
    }

    /// What the checker finds of the last cell; of the first in either direction.
    fn judge(&mut self, at: usize, effort: &RangeEffort) -> std::result::Result<Found, String> {
        let first = effort.judged(|| cell_holds(&self.certificate, at, &mut || effort.stops()));
        if at > 0 || first.is_ok() {
            return first;
        }
        self.certificate.forward = !self.certificate.forward;
        let second = effort.judged(|| cell_holds(&self.certificate, at, &mut || effort.stops()));
        // In the wrong direction nothing is positive; of the other the reason is told.
        match (first, second) {
            (Err(first), Err(second)) if second.contains("(S1)") || second.contains("(S2)") => {
                self.certificate.forward = !self.certificate.forward;
                Err(first)
            }
            (_, second) => second,
        }
    }

    /// All cells as a certificate that the checker accepts.
    fn proof(&mut self, end: &RangeEnd) -> Result<std::result::Result<SingleProof, RangeEnd>> {
        self.certificate.parts = parts(&self.found, self.problem.deepest);
        let Some(last) = self.certificate.parts.last() else { return Ok(Err(end.clone())) };
        let exact = |part: &Part| BigRational::new(part.depth.p.into(), part.depth.q.into());
        let depth = exact(last);
        Ok(match Accepted::new(self.certificate.to_string()) {
            Err(rejection) => Err(RangeEnd::Refused(rejection.to_string())),
            Ok(accepted) => {
                let parts = self.certificate.parts.iter().map(|part| (exact(part), part.word)).collect();
                Ok(SingleProof {
                    certificate: self.certificate.clone(),
                    accepted,
                    depth,
                    parts,
                    end: end.clone(),
                })
            }
        })
    }
}

/// Six digits of a depth, downwards; 0 of one that a certificate has no digits for.
fn six(depth: f64) -> f64 {
    if depth < 1e-13 { 0.0 } else { write::depth(depth) }
}

/// What is known of the multipliers, part by part: each word from where all other cells have ended to where
/// they begin, and nothing between.
fn parts(found: &[Found], deepest: f64) -> Vec<Part> {
    let mut all: Vec<(f64, Word)> = Vec::new();
    let Some(last) = found.last().map(|cell| float(cell.reach).min(deepest)) else { return Vec::new() };
    let mut at = 0;
    for run in found.chunk_by(|one, next| one.word == next.word) {
        // Six digits upwards, which smaller depths do not have; or from the touch on.
        let from = match at {
            0 => 0.0,
            _ => six((float(found[at - 1].greatest) * (1.0 + 1.1e-5)).max(1e-9)),
        };
        at += run.len();
        let to = six(float(run[run.len() - 1].reach).min(last));
        let before = all.last().map_or(0.0, |part| part.0);
        if run[0].word != Word::Open && from.max(before) < to {
            if from > before {
                all.push((from, Word::Open));
            }
            all.push((to, run[0].word));
        }
    }
    let last = six(last);
    if all.last().is_none_or(|part| part.0 < last) && last > 0.0 {
        all.push((last, Word::Open));
    }
    all.truncate(PARTS);
    all.into_iter().map(|(depth, word)| Part { depth: write::depth_fraction(depth), word }).collect()
}
