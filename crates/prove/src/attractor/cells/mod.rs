//! Beyond a touch of an overdamped oscillator at one depth: that what is trapped there is chaotic, proved by
//! cells with weights, kind `attractor 2`.
//!
//! Where displacements shrink at some impacts, in gaps between the windows of λ₁ < 2/3 and where the formulas
//! give too much away, they grow over a few. Contacts are cut into cells by their speed; weights are looked
//! for by which every return from a cell grows. Where a cycle of cells forbids that, its cells are cut in
//! two, until there are too many: in a window there is a stable orbit, and no weights. proofs/attractor.md
//! has the theorem, and the checker judges.

mod returns;
#[cfg(test)]
mod tests;
mod weights;
mod write;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use self::{
    returns::Returns,
    weights::{Asked, Graph},
};
use super::{
    constants::{Constants, Rates},
    stop::Stop,
};
use crate::{
    Accepted,
    certificate::attractor::cells::Certificate,
    chaos::{Term, profile::Profile, span::Span},
    error::Result,
    monitor::Monitor,
    range::{RangeEnd, write::float as float_of},
};

/// What is to be proved: between two depths an overdamped oscillator has a trap, and all in it is chaotic.
#[derive(Debug, Clone)]
pub struct CellsProblem {
    /// The ranges of c, k, τ.
    pub ranges: [[BigRational; 2]; 3],
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// The least and the greatest ν.
    pub depths: [BigRational; 2],
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct CellsProof {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// The least and the greatest ν.
    pub depths: [BigRational; 2],
    /// G: by this factor at least displacements grow from contact to contact, times their weights.
    pub growth: f64,
    /// R: in each period by e^R at least.
    pub rate: f64,
}

/// How many cells there are at first. No more are cut when there are more than this, or a check would look at
/// more returns.
const FIRST: usize = 128;
const MOST: usize = 1200;
const WORK: u64 = 40_000;
/// The least growth that is looked for, as its logarithm.
const LEAST: f64 = 1e-3;
/// The greatest growth that is looked for.
const GREATEST: f64 = 3.0;
/// How often cells are cut for more growth, and for how much more.
const BETTER: usize = 8;
const ABOVE: f64 = 1.02;
/// The greatest weight.
const HEAVIEST: f64 = 1e6;
/// Such a part of the most that weights can prove is asked of them, for impacts and for periods.
const PART: f64 = 0.97;
const NEARLY: f64 = 0.995;

/// A proof, or why there is none: the oscillator may not be overdamped, the wall have more than one top, or
/// no weights be found.
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove_cells(
    problem: &CellsProblem,
    monitor: &dyn Monitor,
) -> Result<std::result::Result<CellsProof, RangeEnd>> {
    prove_from(problem, (FIRST, BETTER), monitor)
}

/// The same with so many cells at first, cut so often.
fn prove_from(
    problem: &CellsProblem,
    (first, better): (usize, usize),
    monitor: &dyn Monitor,
) -> Result<std::result::Result<CellsProof, RangeEnd>> {
    let refused = |why: &str| Ok(Err(RangeEnd::Refused(why.into())));
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    let Some(rates) = Rates::of(problem.ranges.each_ref().map(|ends| ends.each_ref().map(float))) else {
        return refused("the oscillator may not be overdamped");
    };
    let [least, greatest] = problem.depths.each_ref().map(float);
    let Some(stop) = Stop::of(&Profile::new(&problem.harmonics), greatest) else {
        return refused("the stop is not seen to have one top in a period");
    };
    let Some(constants) = Constants::of(&rates, &stop, greatest) else {
        return refused("no trap is found");
    };
    let mut certificate = write::head(problem, &stop, &constants)?;
    let setting = &certificate.setting;
    let [speed, slip] = [setting.speed, setting.slip].map(float_of);
    let returns = Returns::new(&rates, &stop, Span::new(least, greatest), [speed, slip]);
    let Some(graph) = grown(&returns, speed, (first, better), monitor)? else {
        return Ok(Err(RangeEnd::Map));
    };
    let Some(weights) = weights(&graph) else { return Ok(Err(RangeEnd::Map)) };
    write::cells(&mut certificate, &graph, &weights)?;
    write::proof(certificate, problem.depths.clone(), graph.growth(&weights))
}

/// Whether there are not too many cells.
fn is_small(graph: &Graph) -> bool {
    let cells = graph.ends.len();
    cells <= MOST && cells as u64 * graph.listed() <= WORK
}

/// Only impacts are asked to grow.
fn impacts(impact: f64) -> Asked {
    Asked { impact, period: 0.0 }
}

/// Cells by which every cycle grows; none where one may not.
fn grown(
    returns: &Returns,
    speed: f64,
    (first, better): (usize, usize),
    monitor: &dyn Monitor,
) -> Result<Option<Graph>> {
    let Some(mut graph) = Graph::new(returns, speed, first) else { return Ok(None) };
    while let Err(cells) = graph.potential(impacts(LEAST)) {
        monitor.advance(0)?;
        graph = match graph.cut(returns, &cells) {
            Some(finer) if is_small(&finer) => finer,
            _ => return Ok(None),
        };
    }
    // The cells that hold the growth back are cut.
    for _ in 0..better {
        monitor.advance(0)?;
        let most = graph.most(impacts, [LEAST, GREATEST]);
        let Err(cells) = graph.potential(impacts(most * ABOVE)) else { break };
        match graph.cut(returns, &cells) {
            Some(finer) if is_small(&finer) => graph = finer,
            _ => break,
        }
    }
    Ok(Some(graph))
}

/// Weights of these cells by which each impact and each period grow by much.
fn weights(graph: &Graph) -> Option<Vec<u64>> {
    let impact = NEARLY * graph.most(impacts, [LEAST, GREATEST]);
    let asked = |period: f64| Asked { impact: PART * impact, period };
    let period = graph.most(asked, [0.0, impact]);
    let potential = graph.potential(asked(NEARLY * period)).ok()?;
    let top = potential.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let weight = |x: &f64| ((x - top).exp() * HEAVIEST).round().max(1.0) as u64;
    Some(potential.iter().map(weight).collect())
}
