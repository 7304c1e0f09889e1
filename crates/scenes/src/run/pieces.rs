//! Branches proved piece by piece: between saddle-nodes, each as a task `validate` proves an orbit over a
//! range.
//!
//! Along a piece the parameter runs one way, so that there is one orbit at each value. It is proved from an
//! orbit of its middle on, both ways; its ends are bifurcations or the ends of the branch, and next to a
//! bifurcation something is always left. Not here: the proofs (`search`), the branches (`branch`).

use std::ops::Range;

use num_rational::BigRational;
use serde::{Serialize, Serializer};

use super::{
    CertificateFile, Job, Lines, StabilityRow, Status,
    engine::{Engine, RangeProver},
    row,
    stretch::Stretch,
};
use crate::{
    continuation::{BranchPoint, FollowedOrbit, OrbitBranch},
    error::Result,
    number::parse_rational,
    search::orbit::{ProvedBranch, Verdict},
};

/// Bits of the enclosures: as a task `validate` has them unless it says otherwise.
const BITS: u32 = 128;
/// A piece counts as proved if no greater part of it is left at either end.
const LEFT: f64 = 0.01;

row! {
    /// A piece of a branch, and over which values of the parameter its orbit is proved.
    pub struct PieceRow {
        /// The branch, counted from 1.
        pub branch: usize,
        /// The least value of the parameter on the piece.
        pub from: f64,
        /// The greatest.
        pub to: f64,
        /// "proved", "refuted" or "undecided".
        pub verdict: &'static str,
        /// The least value for which it is proved.
        pub lower: Option<String>,
        /// The greatest.
        pub upper: Option<String>,
        /// Where it is stable or not, part by part.
        pub stability: Vec<StabilityRow>,
        /// Why it is not proved, or why no further.
        pub reason: Option<String>,
        /// The file of its certificate.
        pub certificate: Option<String>,
    }
}

/// What is proved of branches.
#[derive(Debug, Clone, PartialEq)]
pub struct PieceProofs {
    /// A row for each piece.
    pub rows: Vec<PieceRow>,
    /// The certificates.
    pub certificates: Vec<CertificateFile>,
}

/// The rows alone.
impl Serialize for PieceProofs {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        self.rows.serialize(serializer)
    }
}

/// Proves the pieces of branches, and names for each point of each branch the certificate of an orbit there,
/// near that point's, if there is one. A branch without a piece, and what cannot be proved, has a row that
/// says why.
///
/// # Errors
/// An interruption.
pub(super) fn prove<E: Engine>(
    branches: &[OrbitBranch<E::Orbit>],
    parameter: &str,
    engine: &E,
    job: &Job,
) -> Result<(PieceProofs, Vec<Vec<Option<String>>>)> {
    let prover = told(engine.range_prover(parameter, BITS))?;
    let mut found = PieceProofs { rows: Vec::new(), certificates: Vec::new() };
    let mut marks = Vec::new();
    let all: Vec<Vec<Range<usize>>> = branches.iter().map(|branch| pieces(&branch.points)).collect();
    job.monitor.begin(all.iter().map(|pieces| pieces.len() as u64).sum(), "pieces");
    for ((branch, pieces), number) in branches.iter().zip(all).zip(1..) {
        let mut own = vec![None; branch.points.len()];
        if pieces.is_empty() {
            let why = "no two points of it that follow each other are orbits".to_string();
            found.rows.push(PieceRow::open(number, &branch.points, Verdict::<()>::Undecided(why)));
        }
        for piece in pieces {
            job.monitor.advance(1)?;
            let points = &branch.points[piece.clone()];
            let verdict = match &prover {
                Ok(prover) => told(one(prover.as_ref(), points))?.unwrap_or_else(Verdict::Undecided),
                Err(why) => Verdict::Undecided(why.clone()),
            };
            let Verdict::Proved(proof) = verdict else {
                found.rows.push(PieceRow::open(number, points, verdict));
                continue;
            };
            let file = format!("{}-{}.certificate", job.task.name, found.certificates.len() + 1);
            for (mark, point) in own[piece].iter_mut().zip(points) {
                let at = point.parameters[0];
                if prover.as_ref().is_ok_and(|prover| prover.holds(&proof, &point.orbit, at)) {
                    *mark = Some(file.clone());
                }
            }
            found.rows.push(PieceRow::proved(number, points, Stretch::of(&proof), &file));
            found.certificates.push(CertificateFile { file, accepted: proof.accepted });
        }
        marks.push(own);
    }
    Ok((found, marks))
}

/// An error that is no interruption as the reason that it is.
fn told<T>(found: Result<T>) -> Result<std::result::Result<T, String>> {
    match found {
        Ok(found) => Ok(Ok(found)),
        Err(error) if error.is_interrupted() => Err(error),
        Err(error) => Ok(Err(error.to_string())),
    }
}

/// What is proved of a piece.
fn one<O: FollowedOrbit>(
    prover: &dyn RangeProver<O>,
    points: &[BranchPoint<O>],
) -> Result<Verdict<ProvedBranch>> {
    let open = |why: &str| Ok(Verdict::Undecided(why.into()));
    let Some(start) = start(points) else { return open("no orbit on it to begin with: take smaller steps") };
    if start.orbit.pattern().strikes().is_empty() {
        return open("a motion without impacts is not proved over a range");
    }
    let [from, to] = ends(points);
    prover.prove(&start.orbit, &exact(start.parameters[0])?, [exact(from)?, exact(to)?])
}

/// The least and the greatest value of the parameter at the ends of a piece.
fn ends<O>(points: &[BranchPoint<O>]) -> [f64; 2] {
    let at = |point: Option<&BranchPoint<O>>| point.map_or(f64::NAN, |point| point.parameters[0]);
    let [first, last] = [at(points.first()), at(points.last())];
    [first.min(last), first.max(last)]
}

/// A float as it is printed.
fn exact(x: f64) -> Result<BigRational> {
    Ok(parse_rational(&format!("{x:e}"))?)
}

/// The longest runs of points, neighbours sharing their end, along which the parameter runs one way and
/// solutions are orbits; at a bifurcation in an end that may be undecided.
fn pieces<O: FollowedOrbit>(points: &[BranchPoint<O>]) -> Vec<Range<usize>> {
    let sound = |pair: &[BranchPoint<O>]| {
        let good = |point: &BranchPoint<O>| point.orbit.is_orbit();
        let event = |point: &BranchPoint<O>| point.event.is_some();
        (good(&pair[0]) && (good(&pair[1]) || event(&pair[1]))) || (event(&pair[0]) && good(&pair[1]))
    };
    let way = |pair: &[BranchPoint<O>]| {
        let step = pair[1].parameters[0] - pair[0].parameters[0];
        (step != 0.0 && sound(pair)).then_some(step > 0.0)
    };
    let ways: Vec<Option<bool>> = points.windows(2).map(way).collect();
    let mut all = Vec::new();
    let mut begin = 0;
    for run in ways.chunk_by(|a, b| a == b) {
        let end = begin + run.len();
        if run[0].is_some() {
            all.push(begin..end + 1);
        }
        begin = end;
    }
    all
}

/// The orbit nearest to the middle of a piece at which nothing happens.
fn start<O: FollowedOrbit>(points: &[BranchPoint<O>]) -> Option<&BranchPoint<O>> {
    let at = |point: &BranchPoint<O>| point.parameters[0];
    let middle = f64::midpoint(at(points.first()?), at(points.last()?));
    let plain = points.iter().filter(|point| point.event.is_none() && point.orbit.is_orbit());
    plain.min_by(|a, b| (at(a) - middle).abs().total_cmp(&(at(b) - middle).abs()))
}

impl PieceRow {
    /// Of a piece that is not proved.
    fn open<O, T>(branch: usize, points: &[BranchPoint<O>], verdict: Verdict<T>) -> PieceRow {
        let [from, to] = ends(points);
        let word = verdict.word();
        let reason = match verdict {
            Verdict::Refuted(why) | Verdict::Undecided(why) => Some(why),
            Verdict::Proved(_) => None,
        };
        PieceRow {
            branch,
            from,
            to,
            verdict: word,
            lower: None,
            upper: None,
            stability: Vec::new(),
            reason,
            certificate: None,
        }
    }

    /// Of one that is.
    fn proved<O>(branch: usize, points: &[BranchPoint<O>], stretch: Stretch, file: &str) -> PieceRow {
        let Stretch { lower, upper, stability, ends: reason, .. } = stretch;
        PieceRow {
            lower: Some(lower),
            upper: Some(upper),
            stability,
            reason,
            certificate: Some(file.into()),
            ..PieceRow::open(branch, points, Verdict::Proved(()))
        }
    }

    /// Between which values of the parameter it is proved, about.
    #[must_use]
    pub fn over(&self) -> Option<[f64; 2]> {
        let value = |text: &Option<String>| text.as_ref()?.parse::<f64>().ok();
        Some([value(&self.lower)?, value(&self.upper)?])
    }

    /// The parts of the piece that are not proved, below and above.
    fn left(&self) -> [f64; 2] {
        let length = self.to - self.from;
        self.over().map_or([1.0; 2], |[lower, upper]| {
            [lower - self.from, self.to - upper].map(|left| (left / length).max(0.0))
        })
    }
}

impl PieceProofs {
    /// What is left open.
    pub(super) fn status(&self) -> Status {
        let open = |row: &&PieceRow| row.left().iter().any(|left| *left > LEFT);
        let said = |row: &PieceRow| {
            let reason = row.reason.as_deref().unwrap_or_default();
            let PieceRow { branch, from, to, .. } = row;
            format!(
                "branch {branch}, from {from} to {to}, is not proved to a hundredth of its length: {reason}"
            )
        };
        let refuted = self.rows.iter().find(|row| row.verdict == "refuted");
        match (refuted, self.rows.iter().find(open)) {
            (Some(row), _) => Status::refuted(said(row)),
            (None, Some(row)) => Status::undecided(said(row)),
            (None, None) => Status::Done,
        }
    }

    pub(super) fn lines(&self, lines: &mut Lines) {
        lines.table("proofs", &self.rows);
    }
}
