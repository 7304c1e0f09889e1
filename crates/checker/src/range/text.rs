//! A certificate's contents, as written and as read.

use std::fmt;

use super::{CELLS, COST, Lines, Rejection, statement};
use crate::{
    header::expect_statement,
    lines::Words,
    rejection::ensure,
    touch::{
        graph::previous,
        text::{decimal, decimals, fraction, fractions, line, positive, read_harmonics, side, successors},
    },
};

pub use crate::touch::text::{Decimal, Fraction, Harmonic, Range};

/// The most letters.
const LETTERS: u64 = 400;
/// The most periods of a letter.
const PERIODS: u64 = 1000;
/// The most pieces of a time between windows.
const PIECES: u64 = 1000;
/// The most parts of a range of strengths.
const PARTS: u64 = 64;
/// The longest leg of other motions, and the most rounds.
const LONGEST: u64 = 1000;
const ROUNDS: u64 = 100;
/// The most parts of a cell's depths, and of them times those of both strengths.
const SLICES: u64 = 1000;
const PLACES: u64 = 1000;
/// The most steps from one cell to the next.
const STEPS: u64 = 1000;
/// The most lines edge.
const EDGES: u64 = 100_000;
/// The most legs of a cell, each between a part of one edge's strengths and one of another's.
const LEGS: u64 = 100_000;

/// A letter: a leg of a motion from one impact to the next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Letter {
    /// The periods n ≥ 1 that it lasts; between mirrored walls, half periods.
    pub periods: u64,
    /// Its entry in a vector, about the growth matrix's eigenvector.
    pub growth: Decimal,
    /// The letters that may follow, from 0, increasing.
    pub next: Vec<usize>,
}

/// What is said of the impacts between two letters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edge {
    /// Their strengths s.
    pub strengths: Range<Decimal>,
    /// m, about 1/(1 − ∂f/∂s).
    pub factor: Decimal,
    /// The weight w > 0 of s in the norm.
    pub weight: Decimal,
}

/// A cell of depths, from the end of the one before.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    /// Its greatest ν.
    pub depth: Fraction,
    /// Into how many parts the strengths of each edge are cut.
    pub parts: u64,
    /// After at most so many steps the motions at its least ν are those of the cell before.
    pub steps: u64,
    /// That there are no other motions near, if that is claimed of it.
    pub others: Option<Others>,
    /// For each edge, in the order of its first letter, then of its second.
    pub edges: Vec<Edge>,
}

/// That there are no other motions near at a cell's depths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Others {
    /// S: near is where the wall's speed is at most νS/2.
    pub strength: Decimal,
    /// Into how many parts strengths are cut.
    pub parts: u64,
    /// Into how many parts the cell's depths are cut.
    pub slices: u64,
}

/// What a proof that there are no others takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Alone {
    /// N: no leg between impacts near is longer.
    pub longest: u64,
    /// After so many rounds all strengths are in the edges' ranges.
    pub rounds: u64,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Whether there are two walls, the upper one the mirror image of the lower: versions 3 and 4.
    pub mirrored: bool,
    /// The ranges of c, k, τ, in this order.
    pub ranges: [Range<Fraction>; 3],
    /// Whether σ = 1, the place of rest being behind the wall at t = 0; else σ = −1.
    pub behind: bool,
    /// The wall's harmonics, their orders increasing.
    pub harmonics: Vec<Harmonic>,
    /// W: where phases are.
    pub window: Decimal,
    /// Into how many pieces a window, and the time between two, is cut.
    pub pieces: u64,
    /// The letters, and what may follow what.
    pub letters: Vec<Letter>,
    /// The growth rate per period, between mirrored walls per half period, lies between these.
    pub growth: Range<Decimal>,
    /// κ < 1.
    pub contraction: Decimal,
    /// Of versions 2 and 4, what their proofs that there are no others take.
    pub alone: Option<Alone>,
    /// The cells, their depths increasing.
    pub cells: Vec<Cell>,
}

/// The names of the ranges, as their lines begin.
pub(super) const RANGES: [&str; 3] = ["damping", "stiffness", "restitution"];

/// The parts of the decimal 1.
const ONE: (i128, i128) = (1, 0);

impl Certificate {
    /// Whether the growth rate that is claimed is certainly above 1, so that paths branch.
    pub(super) fn is_chaos(&self) -> bool {
        self.growth[0].parts() > ONE
    }

    /// For each letter the letters that may precede it, from 0, increasing.
    pub(super) fn previous(&self) -> Vec<Vec<usize>> {
        previous(self.letters.iter().map(|letter| &letter.next[..]))
    }

    /// How many pairs of edges follow each other.
    pub(super) fn pairs(&self) -> u64 {
        let each = self.letters.iter().zip(self.previous());
        each.map(|(letter, previous)| previous.len() as u64 * letter.next.len() as u64).sum()
    }

    /// The edges: first and second letter, from 0, in the order of the lines.
    pub(super) fn edges(&self) -> Vec<[usize; 2]> {
        let all = self.letters.iter().enumerate();
        all.flat_map(|(u, letter)| letter.next.iter().map(move |&v| [u, v])).collect()
    }
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let version = 1 + u8::from(self.alone.is_some()) + 2 * u8::from(self.mirrored);
        let said = if version == 1 { String::new() } else { format!(" {version}") };
        let statement = statement(version);
        write!(f, "{}\nkind {}{said}\nstatement {statement}\n", crate::FORMAT, super::KIND)?;
        for (name, [lo, hi]) in RANGES.iter().zip(self.ranges) {
            writeln!(f, "{name} {lo} {hi}")?;
        }
        writeln!(f, "side {}", if self.behind { "1" } else { "-1" })?;
        writeln!(f, "harmonics {}", self.harmonics.len())?;
        for Harmonic { order, parts: [[a, b], [c, d]] } in &self.harmonics {
            writeln!(f, "harmonic {order} {a} {b} {c} {d}")?;
        }
        writeln!(f, "window {}\npieces {}\nletters {}", self.window, self.pieces, self.letters.len())?;
        for letter in &self.letters {
            writeln!(f, "letter {} {}", letter.periods, letter.growth)?;
        }
        for letter in &self.letters {
            write!(f, "next")?;
            letter.next.iter().try_for_each(|next| write!(f, " {}", next + 1))?;
            writeln!(f)?;
        }
        let [lo, hi] = self.growth;
        writeln!(f, "growth {lo} {hi}\ncontraction {}", self.contraction)?;
        if let Some(Alone { longest, rounds }) = self.alone {
            writeln!(f, "longest {longest}\nrounds {rounds}")?;
        }
        writeln!(f, "cells {}", self.cells.len())?;
        for Cell { depth, parts, steps, others, edges } in &self.cells {
            writeln!(f, "cell {depth} {parts} {steps}")?;
            match others {
                Some(Others { strength, parts, slices }) => {
                    writeln!(f, "others {strength} {parts} {slices}")?
                }
                None if self.alone.is_some() => writeln!(f, "others no")?,
                None => {}
            }
            for Edge { strengths: [lo, hi], factor, weight } in edges {
                writeln!(f, "edge {lo} {hi} {factor} {weight}")?;
            }
        }
        Ok(())
    }
}

fn letter(words: &mut Words) -> Result<Letter, String> {
    let periods = words.number("the periods", PERIODS)?;
    let growth = positive(words, "a growth vector's entry")?;
    ensure(periods > 0, "periods are at least 1")?;
    Ok(Letter { periods, growth, next: Vec::new() })
}

fn edge(words: &mut Words) -> Result<Edge, String> {
    Ok(Edge { strengths: decimals(words)?, factor: decimal(words)?, weight: positive(words, "a weight")? })
}

fn others(words: &mut Words) -> Result<Option<Others>, String> {
    let mut probe = words.clone();
    if probe.word("no, or a strength")? == "no" {
        words.word("no")?;
        return Ok(None);
    }
    let (strength, parts) = (positive(words, "a strength")?, words.number("the number of parts", PARTS)?);
    let slices = words.number("the number of slices", SLICES)?;
    ensure(parts > 0 && slices > 0, "there is at least 1 part and 1 slice")?;
    ensure(parts * parts * slices <= PLACES, format_args!("K² D is at most {PLACES}"))?;
    Ok(Some(Others { strength, parts, slices }))
}

/// The longest leg, and the rounds.
fn read_alone(lines: &mut Lines) -> Result<Alone, Rejection> {
    let longest = line(lines, "longest", |words| words.number("the longest leg", LONGEST))?;
    let rounds = line(lines, "rounds", |words| words.number("the number of rounds", ROUNDS))?;
    lines.form(longest > 0 && rounds > 0, "the longest leg and the rounds are at least 1")?;
    Ok(Alone { longest, rounds })
}

/// The letters, and what may follow each.
fn read_letters(lines: &mut Lines) -> Result<Vec<Letter>, Rejection> {
    let count = line(lines, "letters", |words| words.number("the number of letters", LETTERS))?;
    lines.form(count > 0, "there must be at least 1 letter")?;
    let mut letters = (0..count).map(|_| line(lines, "letter", letter)).collect::<Result<Vec<_>, _>>()?;
    for letter in &mut letters {
        letter.next = line(lines, "next", |words| successors(words, count))?;
    }
    match previous(letters.iter().map(|letter| &letter.next[..])).iter().position(Vec::is_empty) {
        None => Ok(letters),
        Some(n) => {
            Err(lines.malformed(format!("letter {} follows no letter, so that it is on no path", n + 1)))
        }
    }
}

/// The cells, each from the end of the one before.
fn read_cells(lines: &mut Lines, edges: u64, alone: bool) -> Result<Vec<Cell>, Rejection> {
    let count = line(lines, "cells", |words| words.number("the number of cells", CELLS))?;
    lines.form(count > 0, "there must be at least 1 cell")?;
    let few = count.saturating_mul(edges) <= EDGES;
    lines.form(few, format_args!("{count} cells of {edges} edges are more than {EDGES} lines"))?;
    let mut cells = Vec::new();
    let mut last = Fraction::ZERO;
    for _ in 0..count {
        let mut cell = line(lines, "cell", |words| {
            let depth = fraction(words)?;
            let parts = words.number("the number of parts", PARTS)?;
            ensure(parts > 0, "there is at least 1 part")?;
            let steps = words.number("the number of steps", STEPS)?;
            Ok(Cell { depth, parts, steps, others: None, edges: Vec::new() })
        })?;
        if alone {
            cell.others = line(lines, "others", others)?;
        }
        lines.form(last.p * cell.depth.q < cell.depth.p * last.q, "the depths of cells increase, from 0")?;
        let linked = !cells.is_empty() || cell.steps == 0;
        lines.form(linked, "the first cell has no other before it: its steps are 0")?;
        last = cell.depth;
        for _ in 0..edges {
            cell.edges.push(line(lines, "edge", edge)?);
        }
        cells.push(cell);
    }
    Ok(cells)
}

/// Reads everything after the kind line.
pub(super) fn read(lines: &mut Lines, version: u8) -> Result<Certificate, Rejection> {
    let (mirrored, second) = (version > 2, version.is_multiple_of(2));
    expect_statement(lines, statement(version))?;
    let mut ranges = [[Fraction::ZERO; 2]; 3];
    for (range, name) in ranges.iter_mut().zip(RANGES) {
        *range = line(lines, name, fractions)?;
    }
    lines.form(ranges[2][0].p > 0, "a restitution must be positive here")?;
    let behind = line(lines, "side", side)?;
    let harmonics = read_harmonics(lines)?;
    let window = line(lines, "window", |words| positive(words, "a window"))?;
    let pieces = line(lines, "pieces", |words| words.number("a number of pieces", PIECES))?;
    lines.form(pieces > 0, "there must be at least 1 piece")?;
    let letters = read_letters(lines)?;
    let growth = line(lines, "growth", decimals)?;
    lines.form(growth[0].parts() >= ONE, "a growth rate is at least 1")?;
    let contraction = line(lines, "contraction", |words| positive(words, "a contraction"))?;
    lines.form(contraction.parts() < ONE, "a contraction must be below 1")?;
    let alone = if second { Some(read_alone(lines)?) } else { None };
    let edges = letters.iter().map(|letter| letter.next.len() as u64).sum();
    let cells = read_cells(lines, edges, second)?;
    let certificate = Certificate {
        mirrored,
        ranges,
        behind,
        harmonics,
        window,
        pieces,
        letters,
        growth,
        contraction,
        alone,
        cells,
    };
    let cost = certificate.cost();
    let reason = format_args!(
        "the check would cost {cost} exponentials, more than {COST}: fewer cells, parts, steps, pieces, letters or harmonics"
    );
    lines.form(cost <= COST, reason)?;
    let parts = certificate.cells.iter().map(|cell| cell.parts).max().unwrap_or(1);
    let legs = certificate.pairs() * parts.pow(2);
    lines.form(legs <= LEGS, format_args!("a cell would have {legs} legs, more than {LEGS}"))?;
    lines.end("the file goes on after its last line")?;
    Ok(certificate)
}
