//! How far from a touch what is born there goes on, proved: every bi-infinite path of a graph is a motion,
//! from the touch to a depth ν.
//!
//! proofs/ranges.md has the theorem. [`prove`] follows the motions cell by cell: ranges of strengths that the
//! map keeps are found in plain floats (`map`, `close`), and the checker judges each cell. What is proved is
//! what it accepts as a whole. Which graph is born at the touch says [`born`]; where that is nothing,
//! [`prove_nothing`] proves that no motion stays near; that there is nothing else near, [`prove_alone`]; what
//! of it goes farther than all of it, [`prove_farther`]; and each orbit of one impact, [`single_orbits`],
//! along its curve, [`prove_single`]. Which values of a machine's parameter have these depths says
//! [`TouchSide`], and of all machines of a box [`MachineBox`]. Not here: reports.
//!
//! ```
//! use grazing_scenes::certificate;
//! use grazing_scenes::number::parse_rational;
//! use grazing_scenes::search::chaos::LetterGraph;
//! use grazing_scenes::search::range::{RangeEffort, RangeProblem, prove};
//! // README's machine before it touches its stop, its orbit of one period, to ν = 1/20.
//! let at = |x| -> grazing_scenes::Result<_> { Ok([parse_rational(x)?, parse_rational(x)?]) };
//! let problem = RangeProblem {
//!     mirrored: false,
//!     ranges: [at("1/10")?, at("3/10")?, at("4/5")?],
//!     behind: false,
//!     harmonics: vec![(1, [at("1")?, at("0")?])],
//!     graph: LetterGraph::full(&[1]),
//!     deepest: 0.05,
//! };
//! let proof = prove(&problem, &RangeEffort::default(), &())?.unwrap();
//! assert_eq!(proof.depth, parse_rational("1/20")?);
//! assert!(certificate::check(&mut proof.accepted.text().as_bytes()).is_ok());
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod born;
mod close;
mod effort;
mod map;
mod nothing;
mod others;
mod parameter;
mod parts;
mod said;
mod single;
mod tolerated;
pub(crate) mod write;

use num_rational::BigRational;
use num_traits::ToPrimitive;

pub use self::{
    born::{Born, born, born_of},
    effort::RangeEffort,
    nothing::{NothingProblem, NothingProof, prove_nothing},
    parameter::{ParameterRange, SystemOver, TouchSide, Touching, depth_at, is_as_deep},
    parts::{prove_farther, single_orbits},
    said::Said,
    single::{SingleProblem, SingleProof, prove_single},
    tolerated::{MachineBox, SystemOf, ToleratedRange},
};
use self::{
    close::{Closed, close},
    map::{Edges, Oscillator},
};
use crate::{
    Accepted,
    certificate::range::{Certificate, cell_holds},
    chaos::{LetterGraph, Term, profile::Profile, span::Span},
    error::Result,
    monitor::Monitor,
};

/// What is to be proved: of an oscillator near its touch, that every path of a graph is a motion.
#[derive(Debug, Clone)]
pub struct RangeProblem {
    /// Whether there are two walls, the upper one the mirror image of the lower; then periods of the letters
    /// are half periods.
    pub mirrored: bool,
    /// The ranges of c, k, τ.
    pub ranges: [[BigRational; 2]; 3],
    /// Whether σ = 1.
    pub behind: bool,
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// The periods of the letters, and what may follow what.
    pub graph: LetterGraph,
    /// No depth beyond this is asked for.
    pub deepest: f64,
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct RangeProof {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// The greatest ν.
    pub depth: BigRational,
    /// The greatest ν up to which there are no other motions near, if that is proved.
    pub alone: Option<BigRational>,
    /// Why it goes no further.
    pub end: RangeEnd,
}

/// Why a range ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RangeEnd {
    /// All that was asked for is proved.
    Asked,
    /// Next to it no ranges of strengths are found that the map keeps.
    Map,
    /// Next to it the checker refuses the ranges that were found, with this reason.
    Refused(String),
    /// The work that may be spent is spent.
    Work,
    /// No bound is found for how long the legs of motions near are.
    Unbounded,
    /// Farther away damping, stiffness or restitution change too much for one proof.
    Wide,
}

/// Into how many parts strengths are cut, one after the other.
const PARTS: [u64; 3] = [1, 3, 6];
/// Where a step becomes so small a part of the depth, strengths are cut into more parts.
const RAISED: f64 = 0.03;
/// A step that is so small a part of the depth is the last: of a graph, and of a single edge, whose strengths
/// are few, so that parts gain little and small steps cost little.
const LAST: f64 = 5e-4;
const LAST_OF_ONE: f64 = 1e-4;
/// The smallest depth.
const SMALLEST: f64 = 1e-11;
/// The most cells.
const CELLS: usize = 1000;

/// The largest range that is found, or why there is none.
///
/// Cost: `effort`.
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove(
    problem: &RangeProblem,
    effort: &RangeEffort,
    monitor: &dyn Monitor,
) -> Result<std::result::Result<RangeProof, RangeEnd>> {
    let mut search = Search::new(problem, effort)?;
    let end = search.run(monitor)?;
    let Search { mut certificate, contraction, .. } = search;
    // Each cell holds with the greatest contraction; the true one says more. As a whole it may cost too much.
    let loose = std::mem::replace(&mut certificate.contraction, write::contraction(contraction)?);
    let mut refused = None;
    while let Some(last) = certificate.cells.last() {
        let depth = BigRational::new(last.depth.p.into(), last.depth.q.into());
        match Accepted::new(certificate.to_string()) {
            Ok(accepted) => {
                let end = refused.map_or(end, RangeEnd::Refused);
                let alone = None;
                return Ok(Ok(RangeProof { certificate, accepted, depth, alone, end }));
            }
            Err(_) if certificate.contraction != loose => certificate.contraction = loose,
            Err(rejection) => {
                refused = Some(rejection.to_string());
                certificate.cells.pop();
            }
        }
        monitor.advance(0)?;
    }
    Ok(Err(refused.map_or(end, RangeEnd::Refused)))
}

/// The same proof with claims that there are no other motions near, where they are found; as it was else. For
/// a graph that is all that is born.
///
/// Cost: `effort`, a leg being one of C3.
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove_alone(
    problem: &RangeProblem,
    proof: RangeProof,
    effort: &RangeEffort,
    monitor: &dyn Monitor,
) -> Result<RangeProof> {
    let oscillator = oscillator(problem.mirrored, &problem.ranges, problem.behind, &problem.harmonics);
    let Some(mut found) = others::alone(&proof.certificate, &oscillator, effort, monitor)? else {
        return Ok(proof);
    };
    // As a whole it may cost too much: then the last cells do without.
    while let Some(last) = found.cells.iter().rposition(|cell| cell.others.is_some()) {
        if let Ok(accepted) = Accepted::new(found.to_string()) {
            let depth = found.cells[last].depth;
            let alone = Some(BigRational::new(depth.p.into(), depth.q.into()));
            return Ok(RangeProof { certificate: found, accepted, alone, ..proof });
        }
        found.cells[last / 2..].iter_mut().for_each(|cell| cell.others = None);
        monitor.advance(0)?;
    }
    Ok(proof)
}

/// The cells so far.
struct Search<'a> {
    problem: &'a RangeProblem,
    oscillator: Oscillator,
    edges: Edges,
    certificate: Certificate,
    effort: &'a RangeEffort<'a>,
    /// Where the next cell begins, and the strengths there.
    depth: f64,
    strengths: Vec<f64>,
    /// The place in `PARTS` that closed the last cell.
    level: usize,
    /// The greatest of all cells.
    contraction: f64,
}

impl<'a> Search<'a> {
    fn new(problem: &'a RangeProblem, effort: &'a RangeEffort<'a>) -> Result<Search<'a>> {
        let oscillator = oscillator(problem.mirrored, &problem.ranges, problem.behind, &problem.harmonics);
        let window = window(&oscillator.profile);
        Ok(Search {
            problem,
            oscillator,
            edges: Edges::new(&problem.graph),
            certificate: write::head(problem, window)?,
            effort,
            depth: 0.0,
            strengths: Vec::new(),
            level: 0,
            contraction: 0.0,
        })
    }

    /// Cell after cell, each as deep as closes; why there is no next one.
    fn run(&mut self, monitor: &dyn Monitor) -> Result<RangeEnd> {
        let touch = self.oscillator.depths(Span::point(0.0), &self.edges);
        let Some(strengths) = touch.born(&self.edges) else { return Ok(RangeEnd::Map) };
        self.strengths = strengths;
        let mut step = self.problem.deepest;
        let (levels, last) = if self.edges.edges.len() == 1 { (1, LAST_OF_ONE) } else { (PARTS.len(), LAST) };
        loop {
            monitor.advance(0)?;
            if self.depth >= self.problem.deepest {
                return Ok(RangeEnd::Asked);
            }
            if self.certificate.cells.len() >= CELLS {
                return Ok(RangeEnd::Work);
            }
            let next = write::depth((self.depth + step).min(self.problem.deepest));
            let failed = match self.cell(next)? {
                None => {
                    step = 1.7 * (next - self.depth);
                    self.depth = next;
                    continue;
                }
                Some(end) => end,
            };
            if self.effort.is_spent() {
                return Ok(RangeEnd::Work);
            }
            step = 0.5 * step.min(next - self.depth);
            if step < RAISED * self.depth && self.level + 1 < levels {
                self.level += 1;
                step = 8.0 * RAISED * self.depth;
            }
            if step < (last * self.depth).max(SMALLEST) {
                return Ok(failed);
            }
        }
    }

    /// A cell from the last to a depth; or what it fails by.
    fn cell(&mut self, next: f64) -> Result<Option<RangeEnd>> {
        let depths = self.oscillator.depths(Span::new(self.depth, next), &self.edges);
        let parts = PARTS[self.level];
        let closed = close(&depths, &self.edges, &self.strengths, parts, self.effort);
        let Some(closed) = closed else { return Ok(Some(RangeEnd::Map)) };
        Ok(self.judge(&closed, next)?.err().map(RangeEnd::Refused))
    }

    /// Whether the checker accepts a cell; then it is added.
    fn judge(&mut self, closed: &Closed, next: f64) -> Result<std::result::Result<(), String>> {
        let first = self.certificate.cells.is_empty();
        let mut cell = write::cell(closed, next)?;
        let at = self.certificate.cells.len();
        let mut reason = String::new();
        for steps in if first { vec![0] } else { vec![10, 100] } {
            cell.steps = steps;
            self.certificate.cells.push(cell.clone());
            let effort = self.effort;
            match effort.judged(|| cell_holds(&self.certificate, at, &mut || effort.stops())) {
                Ok(()) => {
                    self.strengths = closed.strengths.iter().map(|span| span.middle()).collect();
                    self.contraction = self.contraction.max(closed.contraction);
                    return Ok(Ok(()));
                }
                Err(why) => reason = why,
            }
            self.certificate.cells.pop();
            if !reason.contains("(link)") {
                break;
            }
        }
        Ok(Err(reason))
    }
}

/// The oscillator in floats.
fn oscillator(
    mirrored: bool,
    ranges: &[[BigRational; 2]; 3],
    behind: bool,
    harmonics: &[Term],
) -> Oscillator {
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    let parameters = ranges.each_ref().map(|[lo, hi]| Span::new(float(lo), float(hi)));
    let side = if behind { 1.0 } else { -1.0 };
    Oscillator { mirrored, parameters, side, profile: std::rc::Rc::new(Profile::new(harmonics)) }
}

/// A window on which the wall is convex.
fn window(profile: &Profile) -> f64 {
    const WINDOWS: [f64; 9] = [1.2, 1.0, 0.8, 0.6, 0.4, 0.3, 0.2, 0.1, 0.05];
    let convex = |window: &f64| {
        let whole = Span::new(-window, *window);
        (0..64).all(|piece| profile.at(whole.part(piece, 64)).bend.lo > 0.0)
    };
    WINDOWS.into_iter().find(convex).unwrap_or(0.02)
}
