//! Theorem 2 for a range of periods: decided in parallel, summed up, written as a certificate.

use std::{io::Write, ops::RangeInclusive};

use num_rational::Ratio;
use rayon::prelude::*;

use crate::{
    certificate::{
        Fraction,
        theorem2::{Claim, block_header, header},
    },
    error::Result,
    existence::{Decision, Enclosed, Piece, Reason, decide, decide_by_enclosure, each_piece},
    monitor::{Monitor, timed},
};

/// How the signs of b_{n,k} and c_n are decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProofMethod {
    /// At every zero and pole and just right of it, by integer arithmetic.
    Exact,
    /// On whole stretches, by enclosures of the arguments.
    Interval,
    /// By both, which must agree; the pieces counted are those of the exact method.
    Both,
}

impl ProofMethod {
    /// What it computes with, as a profile names it.
    fn arithmetic(self) -> &'static str {
        match self {
            ProofMethod::Exact => "exact",
            ProofMethod::Interval => "intervals of fractions",
            ProofMethod::Both => "exact and intervals of fractions",
        }
    }
}

/// What deciding a range of periods amounted to.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Proof {
    /// The number of periods decided.
    pub periods: u64,
    /// Open intervals with an orbit.
    pub orbits: u64,
    /// Open stretches without, each with its two witnesses.
    pub stretches: u64,
    /// Points between them where u_n = 0.
    pub singular: u64,
    /// Points between them where some b is 0 and no two have opposite signs.
    pub boundary: u64,
    /// Points between them where two b have opposite signs.
    pub excluded: u64,
    /// The number of periods not reached when the work was ended early.
    pub pending: u64,
    /// The number of periods that enclosures left open.
    pub undecided: u64,
    /// The least n for which the exact method and enclosures differ: an error in one of them.
    pub contradiction: Option<u64>,
    /// The decision with the least n that differs from Theorem 2: a refutation, if there is one.
    pub refuted: Option<Decision>,
}

impl Proof {
    fn by(method: ProofMethod, n: u64) -> Result<Self> {
        if method == ProofMethod::Exact {
            let mut proof = Proof { periods: 1, ..Proof::default() };
            let refuted = each_piece(n, false, |piece| proof.count(&piece))?.is_some();
            proof.refuted = if refuted { Some(decide(n)?) } else { None };
            return Ok(proof);
        }
        let Enclosed::Decided(enclosed) = decide_by_enclosure(n)? else {
            return Ok(Proof { undecided: 1, ..Proof::default() });
        };
        if method == ProofMethod::Interval {
            return Ok(Self::of(enclosed));
        }
        let exact = decide(n)?;
        let contradiction = (findings(&exact) != findings(&enclosed)).then_some(n);
        Ok(Proof { contradiction, ..Self::of(exact) })
    }

    fn of(decision: Decision) -> Self {
        let mut proof = Proof { periods: 1, ..Proof::default() };
        decision.pieces.iter().for_each(|piece| proof.count(piece));
        proof.refuted = decision.disagreement.is_some().then_some(decision);
        proof
    }

    fn count(&mut self, piece: &Piece) {
        *match piece {
            Piece::Orbit { .. } => &mut self.orbits,
            Piece::Stretch { .. } => &mut self.stretches,
            Piece::Point { reason: Reason::Singular, .. } => &mut self.singular,
            Piece::Point { reason: Reason::Boundary(_), .. } => &mut self.boundary,
            Piece::Point { reason: Reason::Excluded { .. }, .. } => &mut self.excluded,
        } += 1;
    }

    fn merge(self, other: Self) -> Self {
        let first = [self.refuted, other.refuted].into_iter().flatten().min_by_key(|decision| decision.n);
        Proof {
            periods: self.periods + other.periods,
            orbits: self.orbits + other.orbits,
            stretches: self.stretches + other.stretches,
            singular: self.singular + other.singular,
            boundary: self.boundary + other.boundary,
            excluded: self.excluded + other.excluded,
            pending: self.pending + other.pending,
            undecided: self.undecided + other.undecided,
            contradiction: [self.contradiction, other.contradiction].into_iter().flatten().min(),
            refuted: first,
        }
    }

    /// The number of claims in a certificate for these periods, one line each.
    fn pieces(&self) -> u64 {
        self.orbits + self.stretches + self.singular + self.boundary + self.excluded
    }
}

/// What two methods must find alike, however they cut (0, ½): the intervals with an orbit, and the points
/// where some b is 0 and no two have opposite signs.
fn findings(decision: &Decision) -> Vec<Piece> {
    let finding = |piece: &Piece| match *piece {
        Piece::Orbit { .. } => Some(piece.clone()),
        // Any k with b = 0 will do.
        Piece::Point { at, reason: Reason::Boundary(_) } => {
            Some(Piece::Point { at, reason: Reason::Boundary(0) })
        }
        _ => None,
    };
    decision.pieces.iter().filter_map(finding).collect()
}

/// Decides Theorem 2 for every period in `range`, on all threads of the current pool; on an interruption, for
/// those reached so far, and the rest is counted as pending.
///
/// Cost: O(n log n) operations for each period n, in O(n) memory a thread. One unit of progress per period.
///
/// # Errors
/// An input error if a period is out of bounds.
pub fn prove_theorem2(
    range: RangeInclusive<u64>,
    method: ProofMethod,
    monitor: &dyn Monitor,
) -> Result<Proof> {
    // The long periods first, so that no thread is left alone with them at the end.
    let periods: Vec<u64> = range.collect();
    periods
        .into_par_iter()
        .rev()
        .with_max_len(8)
        .map(|n| {
            if monitor.advance(0).is_err() {
                return Ok(Proof { pending: 1, ..Proof::default() });
            }
            let proof = timed(monitor, method.arithmetic(), || Proof::by(method, n))?;
            // An interruption now is noticed before the next period.
            let _ = monitor.advance(1);
            Ok(proof)
        })
        .try_reduce(Proof::default, |a, b| Ok(a.merge(b)))
}

/// Writes the certificate for `range`, whose [`Proof`] is known; the decisions are made again as they are
/// written, so that memory stays O(n) times the number of threads.
///
/// # Errors
/// As [`prove_theorem2`]; an I/O error from `out`; an interruption.
pub fn write_theorem2(
    range: RangeInclusive<u64>,
    proof: &Proof,
    out: &mut dyn Write,
    monitor: &dyn Monitor,
) -> Result<()> {
    let lines = proof.pieces() + proof.periods;
    assemble_theorem2(&range.clone(), lines, out, |out| {
        theorem2_blocks(range, monitor, |_, text| Ok(out.write_all(text.as_bytes())?))
    })
}

/// Hands on the blocks of a range of periods in order, decided in parallel. Cost: O(n log n) operations
/// for each period n, on all threads; memory: the blocks of 64 periods, each O(n) bytes.
///
/// # Errors
/// As [`prove_theorem2`]; whatever `each` returns; an interruption.
pub fn theorem2_blocks(
    range: RangeInclusive<u64>,
    monitor: &dyn Monitor,
    mut each: impl FnMut(u64, &str) -> Result<()>,
) -> Result<()> {
    let periods: Vec<u64> = range.collect();
    for chunk in periods.chunks(64) {
        let blocks: Result<Vec<String>> = chunk.par_iter().map(|&n| theorem2_block(n)).collect();
        for (&n, text) in chunk.iter().zip(blocks?) {
            each(n, &text)?;
            monitor.advance(1)?;
        }
    }
    Ok(())
}

/// The certificate of the periods in `range` with their blocks given, in order; `lines` is the number of
/// lines of all blocks. Whether it is true is for the checker to say. Cost: that of `blocks`.
///
/// # Errors
/// An I/O error from `out`; whatever `blocks` returns.
pub fn assemble_theorem2(
    range: &RangeInclusive<u64>,
    lines: u64,
    out: &mut dyn Write,
    blocks: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    out.write_all(header(range, lines).as_bytes())?;
    blocks(out)
}

/// The block of one period in a certificate. Cost: that of deciding it, O(n log n) operations.
///
/// # Errors
/// An input error if the period is out of bounds.
fn theorem2_block(n: u64) -> Result<String> {
    use std::fmt::Write;
    let decision = decide(n)?;
    let mut text = block_header(n, decision.pieces.len());
    text.push('\n');
    for piece in &decision.pieces {
        writeln!(text, "{}", claim(piece)).expect("writing to a String cannot fail");
    }
    Ok(text)
}

/// A decided piece as a claim.
fn claim(piece: &Piece) -> Claim {
    let fraction = |x: &Ratio<u64>| {
        Fraction::new(*x.numer(), *x.denom()).expect("cuts are in lowest terms and within [0, 1/2]")
    };
    match piece {
        Piece::Orbit { left, right, case } => Claim::Orbit {
            left: fraction(left),
            right: fraction(right),
            emu: case.sign_emu() > 0,
            gamma: case.sign_gamma() > 0,
        },
        Piece::Stretch { left, right, positive, negative } => Claim::Stretch {
            left: fraction(left),
            right: fraction(right),
            positive: *positive,
            negative: *negative,
        },
        Piece::Point { at, reason } => match *reason {
            Reason::Singular => Claim::Singular(fraction(at)),
            Reason::Boundary(k) => Claim::Boundary(fraction(at), k),
            Reason::Excluded { positive, negative } => {
                Claim::Excluded { at: fraction(at), positive, negative }
            }
        },
    }
}
