//! Chaos proved: every bi-infinite path of a graph of periods is an orbit of a linear oscillator with one
//! wall, or with two that are each other's mirror images.
//!
//! proofs/chaos.md has the theorem. [`prove`] looks for boxes and weights (`search`, in plain floats: `span`,
//! `map`), writes a certificate of kind `chaos` and has it checked; what is proved is what the checker
//! proves. [`Problem`] is in the normal form, to which `normal` brings an oscillator. Not here: the keys of a
//! scene, reports.
//!
//! ```
//! use grazing_scenes::certificate;
//! use grazing_scenes::number::parse_rational;
//! use grazing_scenes::search::chaos::{Problem, prove};
//! // The paper's oscillator, c = 12/49, k = 100/2401, τ = 1, over {1, 2} for every µ > 0: 0 < ν < 1.
//! let range = |lo, hi| -> grazing_scenes::Result<_> { Ok([parse_rational(lo)?, parse_rational(hi)?]) };
//! let at = |x| range(x, x);
//! let ranges = [at("12/49")?, at("100/2401")?, at("0")?, at("1")?, range("0", "1")?];
//! let harmonics = vec![(1, [at("1")?, at("0")?])];
//! let (letters, next) = (vec![1, 2], vec![vec![0, 1]; 2]);
//! let problem = Problem { mirrored: false, ranges, behind: true, harmonics, letters, next };
//! let proof = prove(&problem, &())?.unwrap();
//! assert!(proof.accepted.claim().detail("others").is_some());
//! assert!(certificate::check(&mut proof.accepted.text().as_bytes()).is_ok());
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod graph;
pub(super) mod map;
mod normal;
mod others;
pub(super) mod profile;
mod rational;
mod search;
pub(super) mod span;
mod top;
pub(super) mod touch;
pub(super) mod write;

use std::rc::Rc;

use num_rational::BigRational;
use num_traits::ToPrimitive;

pub use graph::LetterGraph;
pub use graph::born;
pub use normal::Normal;
use profile::Profile;
pub use profile::Term;
pub use rational::RationalFunction;
pub use span::Span;

use crate::{
    Accepted,
    certificate::chaos::{Certificate, Decimal, Fraction},
    error::{Error, Result},
    monitor::Monitor,
};

/// What is to be proved: for all parameters in ranges, every path of a graph.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Whether there are two walls, the upper one at −w(t − π) if the lower one is at w(t). Then f = 0, and
    /// periods are half periods.
    pub mirrored: bool,
    /// The ranges of c, k, f, τ, ν.
    pub ranges: [[BigRational; 2]; 5],
    /// Whether σ = 1.
    pub behind: bool,
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// The periods n of the letters.
    pub letters: Vec<u64>,
    /// For each letter, which may follow, increasing.
    pub next: Vec<Vec<usize>>,
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ShiftProof {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// Boxes of the velocities after and before the impacts of each letter, divided by ν, within those of
    /// the certificate.
    pub boxes: Vec<[Span; 2]>,
}

impl Problem {
    /// A number of periods, where it may be counted in halves, in words.
    fn periods(&self, n: u64) -> String {
        match (self.mirrored, n % 2) {
            (false, _) => n.to_string(),
            (true, 0) => (n / 2).to_string(),
            (true, _) => format!("{n}/2"),
        }
    }

    fn profile(&self) -> Rc<Profile> {
        Rc::new(Profile::new(&self.harmonics))
    }

    /// The velocities before the impacts that end legs of a letter, at the greatest ν and the middle of the
    /// other ranges: for given velocities after them, those of the legs that begin with the least and with
    /// the greatest s that the boxes allow.
    ///
    /// Plain floats, for a picture. Cost: 40 evaluations of a leg per velocity.
    pub fn arrivals(&self, proof: &ShiftProof, letter: usize, after: &[f64]) -> Vec<(f64, [f64; 2])> {
        let mut parameters = self.spans().map(|span| Span::point(span.middle()));
        parameters[4] = Span::point(self.spans()[4].hi);
        let side = if self.behind { 1.0 } else { -1.0 };
        let cell = map::Cell::new(self.mirrored, parameters, side, &self.profile());
        let turns = cell.turned(self.letters[letter]);
        let previous = (0..self.letters.len()).filter(|&m| self.next[m].contains(&letter));
        let strengths = previous.map(|m| cell.strength(proof.boxes[letter][0], proof.boxes[m][1]));
        let Some(first) = strengths.reduce(Span::hull) else { return Vec::new() };
        let arrival = |s: f64, after: f64| {
            let mut before = 0.0;
            for _ in 0..20 {
                // s′ = 2 (a′ + τp′)/(1 + τ), where p′ depends on s′ a little.
                let last = cell.strength(Span::point(after), Span::point(before)).middle();
                let impacts = cell.impact(Span::point(s)).zip(cell.impact(Span::point(last)));
                let Some((from, to)) = impacts else { return f64::NAN };
                before = cell.leg(turns, self.letters[letter], [&from, &to], [&from, &to]).before.middle();
            }
            before
        };
        let row = |&after: &f64| (after, [arrival(first.lo, after), arrival(first.hi, after)]);
        after.iter().map(row).filter(|(_, ends)| ends.iter().all(|p| *p < 0.0)).collect()
    }

    fn spans(&self) -> [Span; 5] {
        let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
        self.ranges.each_ref().map(|[lo, hi]| Span::new(float(lo), float(hi)))
    }
}

/// A certificate, or for each way of cutting parameters and phases why it failed, the last being the finest.
///
/// Cost: up to 16 attempts, each of up to 200 rounds, and one per letter, of at most 100,000 evaluations of a
/// leg (about 2 µs).
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove(
    problem: &Problem,
    monitor: &dyn Monitor,
) -> Result<std::result::Result<ShiftProof, Vec<String>>> {
    let wide = problem.spans().map(|span| span.width() > 0.0);
    let mut failures: Vec<String> = Vec::new();
    for level in 0..6u32 {
        let others = 1u64 << (level / 2);
        let cuts = [0, 1, 2, 3, 4].map(|i| match (wide[i], i) {
            (false, _) => 1,
            (true, 4) => 1 << level,
            (true, _) => others,
        });
        if level > 0 && !wide.contains(&true) {
            break;
        }
        for parts in search_parts(problem, level) {
            monitor.advance(0)?;
            let Some(attempt) = search::Attempt::new(problem, cuts, parts) else { continue };
            let reason = match attempt.close() {
                Err(reason) => reason,
                Ok(mut closed) => {
                    let plain = (cuts, None);
                    let mut reason = String::new();
                    for (cells, complete) in attempt.complete(&closed).into_iter().chain([plain]) {
                        (closed.cells, closed.complete) = (cells, complete);
                        let (certificate, text) = write::certificate(problem, &closed)?;
                        match Accepted::new(text) {
                            Ok(accepted) => {
                                let boxes = closed.boxes;
                                return Ok(Ok(ShiftProof { certificate, accepted, boxes }));
                            }
                            Err(rejection) => {
                                reason = format!("the checker refuses the boxes: {rejection}");
                            }
                        }
                    }
                    reason
                }
            };
            if failures.last() != Some(&reason) {
                failures.push(reason);
            }
        }
    }
    Ok(Err(failures))
}

/// Whether the conditions of a certificate hold as far as floats tell: H0 to H4 in its cells, its growth
/// rate, and that its periods tell its paths. It shares nothing with the checker but the certificate's type,
/// and rounds to nearest: margins below about 1e-12 are not seen.
pub fn holds(certificate: &Certificate) -> std::result::Result<(), String> {
    let number = |x: Fraction| BigRational::new(x.p.into(), x.q.into());
    let problem = Problem {
        mirrored: certificate.mirrored,
        ranges: certificate.ranges.map(|range| range.map(number)),
        behind: certificate.behind,
        harmonics: certificate
            .harmonics
            .iter()
            .map(|term| (term.order, term.parts.map(|range| range.map(number))))
            .collect(),
        letters: certificate.letters.iter().map(|letter| letter.periods).collect(),
        next: certificate.letters.iter().map(|letter| letter.next.clone()).collect(),
    };
    let graph = LetterGraph { letters: problem.letters.clone(), next: problem.next.clone() };
    graph.claims(certificate)?;
    let parts = certificate.letters.iter().map(|letter| letter.parts).collect();
    let attempt = search::Attempt::new(&problem, certificate.cells, parts).ok_or("too much work")?;
    attempt.holds(certificate)
}

/// What is not covered.
fn fail<T>(message: &str) -> Result<T> {
    Err(Error::input(message))
}

/// A certificate's decimal.
fn float(x: Decimal) -> f64 {
    x.digits as f64 / 10f64.powi(x.places as i32)
}

/// Into how many parts the phases of each letter's impacts are cut, in the order to try: first none, then
/// those of the longest letters, then all.
fn search_parts(problem: &Problem, level: u32) -> Vec<Vec<u64>> {
    let longest = problem.letters.iter().copied().max().unwrap_or(0);
    let with = |long: u64, short: u64| {
        problem.letters.iter().map(|&n| if n == longest { long } else { short }).collect::<Vec<u64>>()
    };
    match level {
        0 => vec![with(1, 1), with(4, 1), with(4, 4), with(16, 4)],
        1 | 2 => vec![with(1, 1), with(4, 1)],
        _ => vec![with(1, 1), with(4, 1), with(8, 2)],
    }
}
