//! A certificate's contents, as written and as read.

use std::fmt;

use super::{CELLS, COST, Lines, Rejection, STATEMENT_3, STATEMENT_4, Words};
use crate::{
    header::expect_statement,
    rejection::ensure,
    touch::{
        graph::previous,
        text::{decimals, fractions, line, positive, read_harmonics, side, successors},
    },
};

pub use crate::touch::text::{Decimal, Fraction, Harmonic, Range};

/// The most letters.
const LETTERS: u64 = 400;
/// The most periods of a letter.
const PERIODS: u64 = 1000;
/// The most parts of a range of phases.
const PARTS: u64 = 64;
/// The most rounds of narrowing.
const ROUNDS: u64 = 100;
/// The most pieces of a time between windows.
const PIECES: u64 = 1000;

/// A letter: a leg of an orbit from one impact to the next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Letter {
    /// The periods n ≥ 1 that it lasts; with mirrored walls, half periods.
    pub periods: u64,
    /// The velocity just after its first impact, divided by ν.
    pub after: Range<Decimal>,
    /// The velocity just before its last impact, divided by ν.
    pub before: Range<Decimal>,
    /// The weights α, β > 0 of the two in the norm.
    pub weights: [Decimal; 2],
    /// Its entry in a vector, about the growth matrix's eigenvector.
    pub growth: Decimal,
    /// Into how many parts the phases of its two impacts are cut.
    pub parts: u64,
    /// The letters that may follow, from 0, increasing.
    pub next: Vec<usize>,
}

/// That there are no other orbits near, and what its proof takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Complete {
    /// S: orbits all of whose impacts have the wall at a speed of at most νS/2.
    pub strength: Decimal,
    /// M: no leg of theirs is longer.
    pub longest: u64,
    /// Into how many parts the phases of both impacts of a leg are cut.
    pub parts: u64,
    /// After at most so many rounds all legs are in the letters' boxes.
    pub rounds: u64,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Whether there are two walls, the upper one the mirror image of the lower: version 4 of the kind.
    pub mirrored: bool,
    /// The ranges of c, k, f, τ, ν, in this order.
    pub ranges: [Range<Fraction>; 5],
    /// Into how many parts each range is cut.
    pub cells: [u64; 5],
    /// Whether σ = 1, the place of rest being behind the wall at t = 0; else σ = −1.
    pub behind: bool,
    /// The wall's harmonics, their orders increasing.
    pub harmonics: Vec<Harmonic>,
    /// W: where phases are, and where the gap is convex.
    pub window: Decimal,
    /// Into how many pieces a window, and the time between two, is cut.
    pub pieces: u64,
    /// The letters, and what may follow what.
    pub letters: Vec<Letter>,
    /// κ < 1.
    pub contraction: Decimal,
    /// q/ν stays below this; with mirrored walls |q|/ν does.
    pub reach: Decimal,
    /// The growth rate per period, with mirrored walls per half period, lies between these.
    pub growth: Range<Decimal>,
    /// Whether it is proved that there are no other orbits near.
    pub complete: Option<Complete>,
}

/// The names of the ranges, as their lines begin.
pub(super) const RANGES: [&str; 5] = ["damping", "stiffness", "force", "restitution", "depth"];

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
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (version, statement) = if self.mirrored { (4, STATEMENT_4) } else { (3, STATEMENT_3) };
        write!(f, "{}\nkind {} {version}\nstatement {statement}\n", crate::FORMAT, super::KIND)?;
        for (name, [lo, hi]) in RANGES.iter().zip(self.ranges) {
            writeln!(f, "{name} {lo} {hi}")?;
        }
        writeln!(f, "side {}", if self.behind { "1" } else { "-1" })?;
        writeln!(f, "harmonics {}", self.harmonics.len())?;
        for Harmonic { order, parts: [[a, b], [c, d]] } in &self.harmonics {
            writeln!(f, "harmonic {order} {a} {b} {c} {d}")?;
        }
        let [c, k, force, restitution, depth] = self.cells;
        writeln!(f, "cells {c} {k} {force} {restitution} {depth}")?;
        writeln!(f, "window {}\npieces {}\nletters {}", self.window, self.pieces, self.letters.len())?;
        for letter in &self.letters {
            let Letter {
                periods, after: [a, b], before: [c, d], weights: [alpha, beta], growth, parts, ..
            } = letter;
            writeln!(f, "letter {periods} {a} {b} {c} {d} {alpha} {beta} {growth} {parts}")?;
        }
        for letter in &self.letters {
            write!(f, "next")?;
            letter.next.iter().try_for_each(|next| write!(f, " {}", next + 1))?;
            writeln!(f)?;
        }
        let [lo, hi] = self.growth;
        writeln!(f, "contraction {}\nreach {}\ngrowth {lo} {hi}", self.contraction, self.reach)?;
        match self.complete {
            None => writeln!(f, "complete no"),
            Some(Complete { strength, longest, parts, rounds }) => {
                writeln!(f, "complete {strength} {longest} {parts} {rounds}")
            }
        }
    }
}

fn letter(words: &mut Words) -> Result<Letter, String> {
    let periods = words.number("the periods", PERIODS)?;
    let (after, before) = (decimals(words)?, decimals(words)?);
    let weights = [positive(words, "a weight")?, positive(words, "a weight")?];
    let growth = positive(words, "a growth vector's entry")?;
    let parts = words.number("the number of parts", PARTS)?;
    ensure(periods > 0 && parts > 0, "periods and parts are at least 1")?;
    Ok(Letter { periods, after, before, weights, growth, parts, next: Vec::new() })
}

fn complete(words: &mut Words) -> Result<Option<Complete>, String> {
    if words.clone().word("no").is_ok_and(|word| word == "no") {
        words.word("no")?;
        return Ok(None);
    }
    let strength = positive(words, "a strength")?;
    let longest = words.number("the longest leg", PERIODS)?;
    let parts = words.number("the number of parts", PARTS)?;
    let rounds = words.number("the number of rounds", ROUNDS)?;
    ensure(longest > 0 && parts > 0 && rounds > 0, "the longest leg, parts and rounds are at least 1")?;
    Ok(Some(Complete { strength, longest, parts, rounds }))
}

/// The ranges of c, k, f, τ, ν.
fn read_ranges(lines: &mut Lines, mirrored: bool) -> Result<[Range<Fraction>; 5], Rejection> {
    let mut ranges = [[Fraction::ZERO; 2]; 5];
    for (i, name) in RANGES.into_iter().enumerate() {
        ranges[i] = line(lines, name, fractions)?;
        let [lo, hi] = ranges[i];
        let free = |[lo, hi]: Range<Fraction>| lo.p == 0 && hi.p == 0;
        let problem = match name {
            "restitution" if lo.p <= 0 => Some("a restitution must be positive here"),
            "depth" if lo.p < 0 || hi.p <= 0 => Some("the depth must be at least 0, and somewhere positive"),
            "force" if mirrored && !free([lo, hi]) => Some("with mirrored walls the force is 0/1 0/1"),
            "force" if !(free([lo, hi]) || free(ranges[0]) && free(ranges[1])) => {
                Some("a force other than 0/1 needs damping and stiffness 0/1: else move the origin")
            }
            "depth" if lo.p == 0 && !free(ranges[2]) => Some("with a force the depth must be positive"),
            _ => None,
        };
        lines.form(problem.is_none(), problem.unwrap_or_default())?;
    }
    Ok(ranges)
}

/// Into how many parts each range is cut.
fn read_cells(lines: &mut Lines) -> Result<[u64; 5], Rejection> {
    let cells = line(lines, "cells", |words| {
        let mut cells = [0; 5];
        for cell in &mut cells {
            *cell = words.number("a number of parts", CELLS)?;
        }
        Ok(cells)
    })?;
    let product = cells.iter().try_fold(1u64, |product, &cell| product.checked_mul(cell));
    let some = product.is_some_and(|product| (1..=CELLS).contains(&product));
    lines.form(some, format_args!("there must be 1 to {CELLS} cells in all"))?;
    Ok(cells)
}

/// The letters, and what may follow each.
fn read_letters(lines: &mut Lines) -> Result<Vec<Letter>, Rejection> {
    let count = line(lines, "letters", |words| words.number("the number of letters", LETTERS))?;
    lines.form(count > 0, "there must be at least 1 letter")?;
    let mut letters = (0..count).map(|_| line(lines, "letter", letter)).collect::<Result<Vec<_>, _>>()?;
    for letter in &mut letters {
        letter.next = line(lines, "next", |words| successors(words, count))?;
    }
    let mut followed = vec![false; letters.len()];
    letters.iter().flat_map(|letter| &letter.next).for_each(|&n| followed[n] = true);
    match followed.iter().position(|followed| !followed) {
        None => Ok(letters),
        Some(n) => {
            Err(lines.malformed(format!("letter {} follows no letter, so that it is on no path", n + 1)))
        }
    }
}

/// Reads everything after the kind line of version 3, or of version 4, of mirrored walls.
pub(super) fn read(lines: &mut Lines, mirrored: bool) -> Result<Certificate, Rejection> {
    expect_statement(lines, if mirrored { STATEMENT_4 } else { STATEMENT_3 })?;
    let ranges = read_ranges(lines, mirrored)?;
    let behind = line(lines, "side", side)?;
    let (harmonics, cells) = (read_harmonics(lines)?, read_cells(lines)?);
    let window = line(lines, "window", |words| positive(words, "a window"))?;
    let pieces = line(lines, "pieces", |words| words.number("a number of pieces", PIECES))?;
    lines.form(pieces > 0, "there must be at least 1 piece")?;
    let letters = read_letters(lines)?;
    let contraction = line(lines, "contraction", |words| positive(words, "a contraction"))?;
    lines.form(contraction.parts() < ONE, "a contraction must be below 1")?;
    let reach = line(lines, "reach", |words| positive(words, "the reach"))?;
    let growth = line(lines, "growth", decimals)?;
    lines.form(growth[0].parts() >= ONE, "a growth rate is at least 1")?;
    let complete = line(lines, "complete", complete)?;
    let held = behind && ranges[2].iter().all(|force| force.p == 0);
    lines.form(complete.is_none() || held, "completeness is for side 1 and force 0/1")?;
    let certificate = Certificate {
        mirrored,
        ranges,
        cells,
        behind,
        harmonics,
        window,
        pieces,
        letters,
        contraction,
        reach,
        growth,
        complete,
    };
    let cost = certificate.cost();
    let reason = format_args!(
        "the check would cost {cost} exponentials, more than {COST}: fewer cells, parts, pieces, letters, harmonics or rounds"
    );
    lines.form(cost <= COST, reason)?;
    lines.end("the file goes on after its last line")?;
    Ok(certificate)
}
