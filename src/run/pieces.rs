//! Branches proved piece by piece: between saddle-nodes, each as a task `validate` proves an orbit over a
//! range.
//!
//! Along a piece the parameter runs one way, so that there is one orbit at each value. It is proved from an
//! orbit of its middle on, both ways; its ends are bifurcations or the ends of the branch, and next to a
//! bifurcation something is always left. Not here: the proofs (`search`), the branches (`branch`).

use std::ops::Range;

use num_rational::BigRational;
use serde::{Serialize, Serializer};

use super::{Job, Judgement, Lines, StabilityRow, Status, engine::Engine, row};
use crate::{
    certificate::orbit::{Claim, Decimal},
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
    /// The certificates: file and text.
    pub certificates: Vec<(String, String)>,
}

/// The rows alone.
impl Serialize for PieceProofs {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        self.rows.serialize(serializer)
    }
}

/// What a proof over a range says.
pub(super) struct Stretch {
    /// The least and the greatest value of the parameter.
    pub lower: String,
    pub upper: String,
    /// Whether the orbit is stable; none if that differs.
    pub stable: Option<Judgement>,
    pub stability: Vec<StabilityRow>,
    /// Why it goes no further, if it does not.
    pub ends: Option<String>,
}

impl Stretch {
    pub fn of(proof: &ProvedBranch) -> Stretch {
        let parts = proof.certificate.parts();
        let end = |part: Option<&(Claim, [Decimal; 2])>, end: usize| {
            part.map_or_else(String::new, |(_, ends)| ends[end].to_string())
        };
        let stable = match parts[..] {
            [(Claim::Stable, _)] => Some(Judgement::Yes),
            [(Claim::Unstable, _)] => Some(Judgement::No),
            [(Claim::Open, _)] => Some(Judgement::Marginal),
            _ => None,
        };
        let (lower, upper) = (end(parts.first(), 0), end(parts.last(), 1));
        let said = |(claim, [from, to]): (Claim, [Decimal; 2])| {
            let word = match claim {
                Claim::Stable => "stable",
                Claim::Unstable => "unstable",
                Claim::Open => return None,
            };
            Some(StabilityRow { word, from: Some(from.to_string()), to: to.to_string() })
        };
        let stability = parts.into_iter().filter_map(said).collect();
        let ways = ["down", "up"].iter().zip(&proof.ends);
        let short: Vec<String> =
            ways.filter_map(|(way, end)| Some(format!("{way}: {}", end.as_ref()?))).collect();
        let ends = (!short.is_empty()).then(|| short.join("; "));
        Stretch { lower, upper, stable, stability, ends }
    }
}

/// Proves the pieces of branches, and names for each point of each branch the certificate of an orbit there,
/// near that point's, if there is one.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub(super) fn prove<E: Engine>(
    branches: &[OrbitBranch<E::Orbit>],
    parameter: &str,
    engine: &E,
    job: &Job,
) -> Result<(PieceProofs, Vec<Vec<Option<String>>>)> {
    let prover = engine.range_prover(parameter, BITS)?;
    let mut found = PieceProofs { rows: Vec::new(), certificates: Vec::new() };
    let mut marks: Vec<Vec<Option<String>>> =
        branches.iter().map(|branch| vec![None; branch.points.len()]).collect();
    let all: Vec<(usize, Range<usize>)> = branches
        .iter()
        .enumerate()
        .flat_map(|(i, branch)| pieces(&branch.points).into_iter().map(move |piece| (i, piece)))
        .collect();
    job.monitor.begin(all.len() as u64, "pieces");
    for (i, piece) in all {
        job.monitor.advance(1)?;
        let points = &branches[i].points[piece.clone()];
        let Some(start) = start(points) else { continue };
        let ends = [points[0].parameters[0], points[points.len() - 1].parameters[0]];
        let [from, to] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let over = [exact(from)?, exact(to)?];
        let verdict = match start.orbit.pattern().strikes() {
            [] => Verdict::Undecided("a motion without impacts is not proved over a range".into()),
            _ => prover.prove(&start.orbit, &exact(start.parameters[0])?, over)?,
        };
        let mut row = PieceRow {
            branch: i + 1,
            from,
            to,
            verdict: verdict.word(),
            lower: None,
            upper: None,
            stability: Vec::new(),
            reason: None,
            certificate: None,
        };
        match verdict {
            Verdict::Refuted(why) | Verdict::Undecided(why) => row.reason = Some(why),
            Verdict::Proved(proof) => {
                let Stretch { lower, upper, stability, ends, .. } = Stretch::of(&proof);
                (row.lower, row.upper, row.stability, row.reason) =
                    (Some(lower), Some(upper), stability, ends);
                let file = format!("{}-{}.certificate", job.task.name, found.certificates.len() + 1);
                for (mark, point) in marks[i][piece].iter_mut().zip(points) {
                    if prover.holds(&proof, &point.orbit, point.parameters[0]) {
                        *mark = Some(file.clone());
                    }
                }
                row.certificate = Some(file.clone());
                found.certificates.push((file, proof.text));
            }
        }
        found.rows.push(row);
    }
    Ok((found, marks))
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
