//! A certificate's contents, as written and as read.

use std::fmt;

use super::{Lines, Rejection, STATEMENT, STATEMENT_2};
use crate::{
    header::expect_statement,
    lines::Words,
    touch::text::{count, fraction, fractions, line, positive, read_harmonics},
};

pub use crate::touch::text::{Decimal, Fraction, Harmonic, Range};

/// The most pieces of the window.
const PIECES: u64 = 1000;
/// The most periods of a leg, and the most rounds.
const PERIODS: u64 = 100;
const ROUNDS: u64 = 100;
/// The most cells.
const CELLS: u64 = 10_000;
/// The most parts of the strengths.
const PARTS: u64 = 64;
/// The most that a check may cost, in exponentials.
const COST: u64 = 6_000_000;
/// Exponentials, for each harmonic, of an impact whose phase is an interval, and of that with its middle.
const IMPACT: u64 = 23;
const BOTH: u64 = IMPACT + 13;

/// The names of the ranges, as their lines begin.
pub(super) const RANGES: [&str; 3] = ["damping", "stiffness", "restitution"];

/// A cell of depths, from the end of the one before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// Its greatest ν.
    pub depth: Fraction,
    /// S: near is where the wall's speed is at most νS/2.
    pub strength: Decimal,
    /// Into how many parts strengths are cut.
    pub parts: u64,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Whether there are two walls, the upper one the mirror image of the lower: version 2.
    pub mirrored: bool,
    /// The ranges of c, k, τ, in this order.
    pub ranges: [Range<Fraction>; 3],
    /// The wall's harmonics, their orders increasing.
    pub harmonics: Vec<Harmonic>,
    /// W: where phases are.
    pub window: Decimal,
    /// Into how many pieces the window is cut.
    pub pieces: u64,
    /// N: no leg between impacts near is longer; between mirrored walls in half periods.
    pub longest: u64,
    /// R: after so many rounds no legs are left.
    pub rounds: u64,
    /// The cells, their depths increasing.
    pub cells: Vec<Cell>,
}

impl Certificate {
    /// Within so many periods, or half periods, every motion leaves.
    #[must_use]
    pub fn periods(&self) -> u64 {
        (2 * self.rounds + 2) * (self.longest + 1)
    }

    /// The cost of the check; below 10¹⁸.
    pub(super) fn cost(&self) -> u64 {
        let (harmonics, longest) = (self.harmonics.len() as u64, self.longest);
        let cells = self.cells.iter().map(|cell| {
            let round = longest.pow(2) * cell.parts * BOTH * harmonics;
            let legs = (longest + (self.rounds - 1) * longest.pow(3)) * cell.parts.pow(2) * (longest + 5);
            longest + 1 + IMPACT * harmonics + self.rounds * round + legs
        });
        let first = (self.pieces + 2) * harmonics + longest + 1 + longest.pow(2);
        cells.fold(first, u64::saturating_add)
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
        writeln!(f, "harmonics {}", self.harmonics.len())?;
        for Harmonic { order, parts: [[a, b], [c, d]] } in &self.harmonics {
            writeln!(f, "harmonic {order} {a} {b} {c} {d}")?;
        }
        writeln!(f, "window {}\npieces {}\nlongest {}", self.window, self.pieces, self.longest)?;
        writeln!(f, "rounds {}\ncells {}", self.rounds, self.cells.len())?;
        let line = |Cell { depth, strength, parts }: &Cell| format!("cell {depth} {strength} {parts}");
        self.cells.iter().try_for_each(|cell| writeln!(f, "{}", line(cell)))
    }
}

fn cell(words: &mut Words) -> Result<Cell, String> {
    let (depth, strength) = (fraction(words)?, positive(words, "a strength")?);
    Ok(Cell { depth, strength, parts: words.number("the number of parts", PARTS)? })
}

/// Everything after the kind line of version 1, or of version 2, of mirrored walls, to the end.
pub(super) fn read(lines: &mut Lines, mirrored: bool) -> Result<Certificate, Rejection> {
    expect_statement(lines, if mirrored { STATEMENT_2 } else { STATEMENT })?;
    let mut ranges = [[Fraction::ZERO; 2]; 3];
    for (range, name) in ranges.iter_mut().zip(RANGES) {
        *range = line(lines, name, fractions)?;
    }
    lines.form(ranges[2][0].p > 0, "a restitution must be positive here")?;
    let harmonics = read_harmonics(lines)?;
    let window = line(lines, "window", |words| positive(words, "a window"))?;
    let pieces = count(lines, "pieces", "the number of pieces", PIECES)?;
    let longest = count(lines, "longest", "the longest leg", PERIODS)?;
    let rounds = count(lines, "rounds", "the number of rounds", ROUNDS)?;
    let number = count(lines, "cells", "the number of cells", CELLS)?;
    let mut cells: Vec<Cell> = Vec::new();
    for _ in 0..number {
        let Cell { depth, strength, parts } = line(lines, "cell", cell)?;
        let last = cells.last().map_or(Fraction::ZERO, |cell| cell.depth);
        lines.form(last.p * depth.q < depth.p * last.q, "the depths of cells increase, from 0")?;
        lines.form(parts > 0, "there must be at least 1 part")?;
        cells.push(Cell { depth, strength, parts });
    }
    let certificate = Certificate { mirrored, ranges, harmonics, window, pieces, longest, rounds, cells };
    let cost = certificate.cost();
    lines.form(
        cost <= COST,
        format_args!("the check would cost {cost} exponentials, more than {COST}: fewer cells, parts, rounds, pieces or harmonics, or shorter legs"),
    )?;
    lines.end("the file goes on after its last line")?;
    Ok(certificate)
}
