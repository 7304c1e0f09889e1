//! A certificate's contents, as written and as read.

use std::fmt;

use super::{Lines, Rejection, STATEMENT, STATEMENT_2};
use crate::{
    header::expect_statement,
    lines::Words,
    touch::text::{count, fraction, fractions, line, positive, read_harmonics, side},
};

pub use crate::touch::text::{Decimal, Fraction, Harmonic, Range};

/// The most periods from one impact to the next.
const PERIODS: u64 = 1000;
/// The most pieces of a period, and of all.
const PIECES: u64 = 1000;
const ALL_PIECES: u64 = 100_000;
/// The most parts.
const PARTS: u64 = 100;
/// The most cells.
const CELLS: u64 = 10_000;
/// The last phase: below π.
const LAST: Decimal = Decimal { digits: 3141, places: 3 };
/// The most that a check may cost, in exponentials.
const COST: u64 = 50_000_000;

/// The names of the ranges, as their lines begin.
pub(super) const RANGES: [&str; 3] = ["damping", "stiffness", "restitution"];

/// What is said of the orbit in a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Word {
    /// Both multipliers are inside the unit circle.
    Stable,
    /// One is outside.
    Unstable,
    /// Nothing.
    Open,
}

/// A part of the depths, from the end of the one before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// Its greatest ν.
    pub depth: Fraction,
    /// What is said there.
    pub word: Word,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Whether there are two walls, the upper one the mirror image of the lower: version 2.
    pub mirrored: bool,
    /// The ranges of c, k, τ, in this order.
    pub ranges: [Range<Fraction>; 3],
    /// Whether σ = 1.
    pub behind: bool,
    /// The wall's harmonics, their orders increasing.
    pub harmonics: Vec<Harmonic>,
    /// n: from one impact to the next; between mirrored walls half periods.
    pub periods: u64,
    /// Whether D = 1.
    pub forward: bool,
    /// Into how many pieces a period, or half period, is cut.
    pub pieces: u64,
    /// The parts, their depths increasing.
    pub parts: Vec<Part>,
    /// Where each cell ends: Dt, increasing.
    pub cells: Vec<Decimal>,
}

/// The words.
const WORDS: [Word; 3] = [Word::Stable, Word::Unstable, Word::Open];

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Word::Stable => "stable",
            Word::Unstable => "unstable",
            Word::Open => "open",
        })
    }
}

impl Certificate {
    /// The cost of the check; below 10¹⁸.
    pub(super) fn cost(&self) -> u64 {
        let (harmonics, pieces) = (self.harmonics.len() as u64, self.pieces);
        let all = self.periods * pieces;
        let first = 2 * pieces + self.periods + 1 + all;
        let cell = 2 * harmonics * (pieces + 2) + all * (2 + harmonics);
        first + self.cells.len() as u64 * cell * (1 + u64::from(self.mirrored))
    }

    /// Whether E₁₂ = 0 exactly, E being that of all the periods: nω = m/2 for a whole m > 0, of half periods
    /// nω = m, where ω² = k − c²/4; of c = a/b and k that are single numbers, n²(4kb² − a²) = (mb)² or
    /// (2mb)². Where these have more digits than fit it is not seen.
    pub(super) fn is_resonant(&self) -> bool {
        let [damping, stiffness, _] = self.ranges;
        let (Fraction { p: a, q: b }, Fraction { p, q }) = (damping[0], stiffness[0]);
        // At most (2·1000·10¹⁵)², far below 2¹²⁷.
        let n = i128::from(self.periods);
        let (spring, loss) = ((2 * n * b).pow(2), (n * a).pow(2));
        let square = (spring % q == 0).then(|| (spring / q).checked_mul(p)).flatten();
        let single = damping[0] == damping[1] && stiffness[0] == stiffness[1];
        square.and_then(|square| square.checked_sub(loss)).filter(|square| single && *square > 0).is_some_and(
            |square| {
                let (root, unit) = (square.isqrt(), if self.mirrored { 2 * b } else { b });
                root * root == square && root % unit == 0
            },
        )
    }
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (version, statement) = if self.mirrored { (" 2", STATEMENT_2) } else { ("", STATEMENT) };
        write!(f, "{}\nkind {}{version}\nstatement {statement}\n", crate::FORMAT, super::KIND)?;
        for (name, [lo, hi]) in RANGES.iter().zip(self.ranges) {
            writeln!(f, "{name} {lo} {hi}")?;
        }
        let sign = |positive: bool| if positive { "1" } else { "-1" };
        writeln!(f, "side {}\nharmonics {}", sign(self.behind), self.harmonics.len())?;
        for Harmonic { order, parts: [[a, b], [c, d]] } in &self.harmonics {
            writeln!(f, "harmonic {order} {a} {b} {c} {d}")?;
        }
        writeln!(f, "periods {}\ndirection {}", self.periods, sign(self.forward))?;
        writeln!(f, "pieces {}\nparts {}", self.pieces, self.parts.len())?;
        self.parts.iter().try_for_each(|Part { depth, word }| writeln!(f, "part {depth} {word}"))?;
        writeln!(f, "cells {}", self.cells.len())?;
        self.cells.iter().try_for_each(|phase| writeln!(f, "cell {phase}"))
    }
}

fn part(words: &mut Words) -> Result<Part, String> {
    let depth = fraction(words)?;
    let said = words.word("stable, unstable or open")?;
    let word = WORDS.into_iter().find(|word| word.to_string() == said);
    Ok(Part { depth, word: word.ok_or("a part is called stable, unstable or open")? })
}

/// Everything after the kind line of version 1, or of version 2, of mirrored walls, to the end.
pub(super) fn read(lines: &mut Lines, mirrored: bool) -> Result<Certificate, Rejection> {
    expect_statement(lines, if mirrored { STATEMENT_2 } else { STATEMENT })?;
    let mut ranges = [[Fraction::ZERO; 2]; 3];
    for (range, name) in ranges.iter_mut().zip(RANGES) {
        *range = line(lines, name, fractions)?;
    }
    lines.form(ranges[2][0].p > 0, "a restitution must be positive here")?;
    let behind = line(lines, "side", side)?;
    let harmonics = read_harmonics(lines)?;
    let periods = count(lines, "periods", "the number of periods", PERIODS)?;
    let forward = line(lines, "direction", side)?;
    let pieces = count(lines, "pieces", "the number of pieces", PIECES)?;
    lines.form(periods * pieces <= ALL_PIECES, "there are too many pieces: at most 100000 in all periods")?;
    let number = count(lines, "parts", "the number of parts", PARTS)?;
    let mut parts: Vec<Part> = Vec::new();
    for _ in 0..number {
        let next = line(lines, "part", part)?;
        let last = parts.last().map_or(Fraction::ZERO, |part| part.depth);
        let increases = last.p * next.depth.q < next.depth.p * last.q;
        lines.form(increases, "the depths of parts increase, from 0")?;
        parts.push(next);
    }
    let number = count(lines, "cells", "the number of cells", CELLS)?;
    let mut cells: Vec<Decimal> = Vec::new();
    for _ in 0..number {
        let next = line(lines, "cell", |words| positive(words, "a phase"))?;
        let increases = cells.last().is_none_or(|last| last.parts() < next.parts());
        lines.form(increases, "the phases of cells increase, from 0")?;
        lines.form(next.parts() <= LAST.parts(), format_args!("a phase is at most {LAST}"))?;
        cells.push(next);
    }
    let certificate =
        Certificate { mirrored, ranges, behind, harmonics, periods, forward, pieces, parts, cells };
    let cost = certificate.cost();
    lines.form(
        cost <= COST,
        format_args!(
            "the check would cost {cost} exponentials, more than {COST}: fewer cells, pieces or harmonics"
        ),
    )?;
    lines.end("the file goes on after its last line")?;
    Ok(certificate)
}
