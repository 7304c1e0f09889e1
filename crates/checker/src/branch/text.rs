//! A certificate's contents, as written and as read.

use std::fmt;

use super::{
    super::motion::text::{
        Decimal, Impact, PERIODS, Side, System, decimal, read_count, read_matrix, read_name, read_pieces,
        read_radius, read_system, write_proof,
    },
    CELLS, Claim, KIND, Lines, RangeQuotient, Rejection, STATEMENT, WORK,
};
use crate::lines::{LONGEST, Words};
use crate::rejection::ensure;

/// An impact of the pattern: on which wall, and how many periods from its phase to the next one's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Strike {
    /// The wall.
    pub side: Side,
    /// The periods.
    pub periods: u64,
}

/// About where an impact is in a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Line {
    /// The phase at the cell's middle.
    pub phase: Decimal,
    /// The incoming relative speed there.
    pub velocity: Decimal,
    /// How both change with the parameter.
    pub rates: [Decimal; 2],
}

/// A part of the range.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    /// The least and the greatest value of the parameter.
    pub parameter: [Decimal; 2],
    /// The claim about stability.
    pub claim: Claim,
    /// For each impact, the line about which it is.
    pub lines: Vec<Line>,
    /// Within this of the line the orbit is the only one.
    pub radius: Decimal,
    /// Within this it lies.
    pub within: Decimal,
    /// The preconditioner: near the inverse of the equations' derivative.
    pub inverse: Vec<Vec<Decimal>>,
    /// For each flight, the times since its impact at which pieces end.
    pub flights: Vec<Vec<Decimal>>,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// The oscillator.
    pub system: System<RangeQuotient>,
    /// The parameter's name.
    pub name: String,
    /// The pattern.
    pub strikes: Vec<Strike>,
    /// The range, in parts.
    pub cells: Vec<Cell>,
}

/// A bound of the exponentials that a cell takes, one with a derivative counted four times: (1 + 2J)(4P +
/// 6M(8M + 11)) for J harmonics in all, P pieces and M impacts.
///
/// A piece is as of kind `orbit`. The equations take at most 3(1 + 2J) for each impact, and are evaluated
/// four times at points, twice along the line and twice in each of 2M directions.
fn work(harmonics: u64, pieces: u64, impacts: u64) -> u64 {
    (1 + 2 * harmonics) * (4 * pieces + 6 * impacts * (8 * impacts + 11))
}

impl Certificate {
    /// The range by what is claimed of stability: neighbouring cells of one claim together.
    #[must_use]
    pub fn parts(&self) -> Vec<(Claim, [Decimal; 2])> {
        let mut parts: Vec<(Claim, [Decimal; 2])> = Vec::new();
        for cell in &self.cells {
            match parts.last_mut().filter(|(claim, _)| *claim == cell.claim) {
                Some((_, [_, to])) => *to = cell.parameter[1],
                None => parts.push((cell.claim, cell.parameter)),
            }
        }
        parts
    }

    /// The pattern as of an orbit whose impacts are nowhere.
    pub(super) fn impacts(&self) -> Vec<Impact> {
        let nowhere = Decimal { digits: 0, places: 0 };
        let one =
            |&Strike { side, periods }: &Strike| Impact { side, periods, phase: nowhere, velocity: nowhere };
        self.strikes.iter().map(one).collect()
    }
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let system = &self.system;
        write!(f, "{}\nkind {KIND}\nstatement {STATEMENT}\n", super::FORMAT)?;
        write!(f, "digest {}\n{system}parameter {}\n", system.digest(), self.name)?;
        writeln!(f, "branch {}", self.strikes.len())?;
        self.strikes
            .iter()
            .try_for_each(|strike| writeln!(f, "strike {} {}", strike.side, strike.periods))?;
        writeln!(f, "cells {}", self.cells.len())?;
        self.cells.iter().try_for_each(|cell| write!(f, "{cell}"))
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "cell {} {} {}", self.parameter[0], self.parameter[1], self.claim)?;
        for Line { phase, velocity, rates: [first, second] } in &self.lines {
            writeln!(f, "at {phase} {velocity} {first} {second}")?;
        }
        writeln!(f, "radius {} {}", self.radius, self.within)?;
        write_proof(f, &self.inverse, &self.flights)
    }
}

/// Reads everything after the kind line.
pub(super) fn read(lines: &mut Lines) -> Result<Certificate, Rejection> {
    let system: System<RangeQuotient> = read_system(lines, STATEMENT)?;
    let name = lines.line("parameter", read_name)?;
    let count = lines.line("branch", read_count)?;
    lines.form(count > 0, "a branch has at least one impact")?;
    let strike = |words: &mut Words| {
        let side = Side::read(words)?;
        ensure(system.has(side), format_args!("there is no {side} wall"))?;
        Ok(Strike { side, periods: words.number("the periods to the next impact", PERIODS)? })
    };
    let strikes: Vec<Strike> = (0..count).map(|_| lines.line("strike", strike)).collect::<Result<_, _>>()?;
    let lasts = strikes.iter().any(|strike| strike.periods > 0);
    lines.form(lasts, "the periods of an orbit must not sum to 0")?;
    let number = lines.line("cells", |words| words.number("the number of cells", CELLS))?;
    lines.form(number > 0, "there is at least one cell")?;
    let (mut cells, mut spent): (Vec<Cell>, u64) = (Vec::new(), 0);
    for _ in 0..number {
        let last = cells.last().map(|cell| cell.parameter[1]);
        cells.push(read_cell(lines, (&system, count), last, &mut spent)?);
    }
    lines.end("the file goes on after the last cell")?;
    Ok(Certificate { system, name, strikes, cells })
}

/// Reads a block, which begins where the one before ends.
fn read_cell(
    lines: &mut Lines,
    (system, impacts): (&System<RangeQuotient>, u64),
    last: Option<Decimal>,
    spent: &mut u64,
) -> Result<Cell, Rejection> {
    let (parameter, claim) = lines.line("cell", |words| {
        let parameter = [decimal(words)?, decimal(words)?];
        ensure(parameter[0].parts() < parameter[1].parts(), "a cell ends after it begins")?;
        ensure(last.is_none_or(|last| last == parameter[0]), "a cell begins where the one before ends")?;
        Ok((parameter, Claim::read(words)?))
    })?;
    let at = |words: &mut Words| {
        let [phase, velocity] = [decimal(words)?, decimal(words)?];
        Ok(Line { phase, velocity, rates: [decimal(words)?, decimal(words)?] })
    };
    let all = (0..impacts).map(|_| lines.line("at", at)).collect::<Result<_, _>>()?;
    let (radius, within) = read_radius(lines)?;
    let inverse = read_matrix(LONGEST, lines, 2 * impacts as usize)?;
    let before = *spent;
    let cost = |pieces| before + work(system.harmonics(), pieces, impacts);
    let (flights, pieces) = read_pieces(lines, impacts as usize, WORK, cost)?;
    *spent = cost(pieces);
    Ok(Cell { parameter, claim, lines: all, radius, within, inverse, flights })
}
