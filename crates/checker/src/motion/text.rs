//! The lines that certificates about oscillators have in common, as written and as read.

use std::fmt;

use super::{Lines, Rejection, Words, header::expect_statement, number::Number};
use crate::rejection::ensure;
use crate::sha256::sha256;

pub(crate) use crate::decimal::DIGITS;
pub use crate::decimal::{Decimal, Fraction};

/// The most impacts; a row of the matrix is one line.
const IMPACTS: u64 = 24;
/// The most harmonics of one function, and the largest multiple.
pub(crate) const HARMONICS: u64 = 1000;
/// The most periods between two impacts.
pub(crate) const PERIODS: u64 = 10_000;
/// The longest name of a parameter.
const NAME: usize = 32;
/// The greatest power of ten in a unit, either way.
const POWER: u64 = 99;
/// The most exponentials that the check of an orbit may take.
const WORK: u64 = 1_000_000;

/// A coefficient of a system.
pub(crate) trait Coefficient: fmt::Display + Sized {
    /// Whether it may depend on a parameter.
    const VARIES: bool;

    /// Whether it is 0, whatever the parameter is.
    fn is_zero(&self) -> bool;

    /// Whether it may be below 0 whatever the parameter is, as far as that can be told without evaluating it.
    fn is_negative(&self) -> bool;

    /// Its value at a value of the parameter.
    fn enclosed<N: Number>(&self, parameter: N) -> N;

    /// Reads a word.
    fn read(words: &mut Words) -> Result<Self, String>;
}

/// Powers of ten: in 10^`lengths` displacements, speeds, forces and walls are listed, in 10^`parameter` the
/// parameter. A linear oscillator moves alike in all units of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Units {
    /// That of lengths.
    pub lengths: i32,
    /// That of the parameter; 0 if there is none.
    pub parameter: i32,
}

/// `cos` cos kt + `sin` sin kt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Harmonic<C = Fraction> {
    /// The multiple of the base frequency.
    pub k: u64,
    /// The coefficient of cos kt.
    pub cos: C,
    /// The coefficient of sin kt.
    pub sin: C,
}

/// A wall at `offset` + Σ harmonics.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wall<C = Fraction> {
    /// The mean position.
    pub offset: C,
    /// An impact turns the relative velocity w into −`restitution` w.
    pub restitution: C,
    /// The motion about the mean.
    pub harmonics: Vec<Harmonic<C>>,
}

/// q″ = −`damping` q′ − `stiffness` q + `force` + Σ forcing, between its walls.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct System<C = Fraction> {
    /// What all numbers are in.
    pub units: Units,
    /// The coefficient of the velocity.
    pub damping: C,
    /// The coefficient of the displacement.
    pub stiffness: C,
    /// A constant acceleration.
    pub force: C,
    /// The harmonics of the forcing.
    pub forcing: Vec<Harmonic<C>>,
    /// The wall below.
    pub lower: Option<Wall<C>>,
    /// The wall above.
    pub upper: Option<Wall<C>>,
}

/// Which wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Below.
    Lower,
    /// Above.
    Upper,
}

/// An impact: on which wall, how many periods from its phase to the next one's, about when and how fast.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Impact {
    /// The wall.
    pub side: Side,
    /// n: the next impact comes 2πn + the difference of the phases later.
    pub periods: u64,
    /// The phase in the middle of the box.
    pub phase: Decimal,
    /// The incoming relative speed in the middle of the box.
    pub velocity: Decimal,
}

impl Coefficient for Fraction {
    const VARIES: bool = false;

    fn is_zero(&self) -> bool {
        self.p == 0
    }

    fn is_negative(&self) -> bool {
        self.p < 0
    }

    fn enclosed<N: Number>(&self, _: N) -> N {
        N::constant(Fraction::enclosed(*self))
    }

    fn read(words: &mut Words) -> Result<Self, String> {
        Fraction::read::<96>(words, DIGITS)
    }
}

impl<C> System<C> {
    /// Whether there is a wall on a side.
    pub(crate) fn has(&self, side: Side) -> bool {
        match side {
            Side::Lower => self.lower.is_some(),
            Side::Upper => self.upper.is_some(),
        }
    }

    /// The number of harmonics of the forcing and of the walls.
    pub(crate) fn harmonics(&self) -> u64 {
        let walls = [&self.lower, &self.upper].into_iter().flatten();
        (self.forcing.len() + walls.map(|wall| wall.harmonics.len()).sum::<usize>()) as u64
    }
}

impl<C: fmt::Display> System<C> {
    /// SHA-256 of the system's lines, in hexadecimal: the same oscillator has the same digest.
    pub fn digest(&self) -> String {
        sha256(self.to_string().as_bytes())
    }
}

impl Side {
    /// ±x: the direction away from this wall.
    pub(crate) fn inward<N: Number>(self, x: N) -> N {
        match self {
            Side::Lower => x,
            Side::Upper => -x,
        }
    }

    pub(crate) fn read(words: &mut Words) -> Result<Side, String> {
        match words.word("lower or upper")? {
            "lower" => Ok(Side::Lower),
            "upper" => Ok(Side::Upper),
            _ => Err("expected lower or upper".into()),
        }
    }
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Side::Lower { "lower" } else { "upper" })
    }
}

impl fmt::Display for Impact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "impact {} {} {} {}", self.side, self.periods, self.phase, self.velocity)
    }
}

fn write_harmonics<C: fmt::Display>(f: &mut fmt::Formatter<'_>, harmonics: &[Harmonic<C>]) -> fmt::Result {
    harmonics.iter().try_for_each(|h| writeln!(f, "harmonic {} {} {}", h.k, h.cos, h.sin))
}

impl<C: fmt::Display> fmt::Display for System<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Units { lengths, parameter } = self.units;
        if self.units != Units::default() {
            writeln!(f, "units {lengths} {parameter}")?;
        }
        writeln!(f, "damping {}\nstiffness {}\nforce {}", self.damping, self.stiffness, self.force)?;
        writeln!(f, "forcing {}", self.forcing.len())?;
        write_harmonics(f, &self.forcing)?;
        for (side, wall) in [(Side::Lower, &self.lower), (Side::Upper, &self.upper)] {
            match wall {
                None => writeln!(f, "{side} none")?,
                Some(wall) => {
                    writeln!(f, "{side} {} {} {}", wall.offset, wall.restitution, wall.harmonics.len())?;
                    write_harmonics(f, &wall.harmonics)?;
                }
            }
        }
        Ok(())
    }
}

/// The lines of a matrix, and those of the pieces of all flights.
pub(crate) fn write_proof(
    f: &mut fmt::Formatter<'_>,
    inverse: &[Vec<Decimal>],
    flights: &[Vec<Decimal>],
) -> fmt::Result {
    for row in inverse {
        write!(f, "row")?;
        row.iter().try_for_each(|c| write!(f, " {c}"))?;
        writeln!(f)?;
    }
    flights.iter().try_for_each(|flight| write_flight(f, flight))
}

/// The lines of the pieces of one flight.
pub(crate) fn write_flight(f: &mut fmt::Formatter<'_>, ends: &[Decimal]) -> fmt::Result {
    writeln!(f, "flight {}", ends.len())?;
    ends.iter().try_for_each(|end| writeln!(f, "until {end}"))
}

/// Reads a decimal.
pub(crate) fn decimal(words: &mut Words) -> Result<Decimal, String> {
    Decimal::read::<96>(words, DIGITS)
}

/// Reads a multiple of the base frequency.
pub(crate) fn multiple(words: &mut Words, least: u64) -> Result<u64, String> {
    let k = words.number("k", HARMONICS)?;
    ensure(k >= least, format_args!("k counts from {least}"))?;
    Ok(k)
}

/// Reads harmonics, k from `least` on.
pub(crate) fn read_harmonics<C: Coefficient>(
    lines: &mut Lines,
    count: u64,
    least: u64,
) -> Result<Vec<Harmonic<C>>, Rejection> {
    let read = |words: &mut Words| {
        Ok(Harmonic { k: multiple(words, least)?, cos: C::read(words)?, sin: C::read(words)? })
    };
    (0..count).map(|_| lines.line("harmonic", read)).collect()
}

fn read_wall<C: Coefficient>(lines: &mut Lines, side: Side) -> Result<Option<Wall<C>>, Rejection> {
    let head = lines.line(&side.to_string(), |words| {
        let mut rest = words.clone();
        if rest.word("none")? == "none" {
            *words = rest;
            return Ok(None);
        }
        let (offset, restitution) = (C::read(words)?, C::read(words)?);
        ensure(!restitution.is_negative(), "a restitution is at least 0")?;
        Ok(Some((offset, restitution, words.number("the number of harmonics", HARMONICS)?)))
    })?;
    let Some((offset, restitution, count)) = head else { return Ok(None) };
    Ok(Some(Wall { offset, restitution, harmonics: read_harmonics(lines, count, 0)? }))
}

/// Reads the statement, the digest and `what` it is of, which `read` reads.
pub(crate) fn read_digested<T: fmt::Display>(
    lines: &mut Lines,
    statement: &str,
    what: &str,
    read: impl FnOnce(&mut Lines) -> Result<T, Rejection>,
) -> Result<T, Rejection> {
    expect_statement(lines, statement)?;
    let digest = lines.line("digest", |words| words.word("a digest").map(str::to_string))?;
    let line = lines.number();
    let value = read(lines)?;
    let own = sha256(value.to_string().as_bytes());
    if digest == own {
        return Ok(value);
    }
    let reason = format!("the digest is not that of the {what}, which is {own}");
    Err(Rejection::False { line, reason })
}

/// A whole number from −99 to 99.
pub(crate) fn power(words: &mut Words) -> Result<i32, String> {
    let word = words.word("a power of ten")?;
    let magnitude = word.strip_prefix('-').unwrap_or(word);
    let value = crate::lines::number(magnitude, POWER).filter(|_| word != "-0");
    let value = value.ok_or(format!("expected a whole number from -{POWER} to {POWER}"))? as i32;
    Ok(if word.starts_with('-') { -value } else { value })
}

/// Reads the powers of ten of units that are not all 1.
fn read_units<C: Coefficient>(words: &mut Words) -> Result<Units, String> {
    let [lengths, parameter] = [power(words)?, power(words)?];
    ensure(C::VARIES || parameter == 0, "there is no parameter that could have a unit")?;
    ensure((lengths, parameter) != (0, 0), "units are listed where they are not 1")?;
    Ok(Units { lengths, parameter })
}

/// Reads the statement, the digest and the system that it belongs to.
pub(crate) fn read_system<C: Coefficient>(
    lines: &mut Lines,
    statement: &str,
) -> Result<System<C>, Rejection> {
    read_digested(lines, statement, "system", |lines| {
        let (units, damping) = lines.perhaps("units", read_units::<C>, "damping", C::read)?;
        let (units, stiffness) = (units.unwrap_or_default(), lines.line("stiffness", C::read)?);
        let force = lines.line("force", C::read)?;
        let count = lines.line("forcing", |words| words.number("the number of harmonics", HARMONICS))?;
        let forcing = read_harmonics(lines, count, 0)?;
        let (lower, upper) = (read_wall(lines, Side::Lower)?, read_wall(lines, Side::Upper)?);
        Ok(System { units, damping, stiffness, force, forcing, lower, upper })
    })
}

/// Reads the number of impacts.
pub(crate) fn read_count(words: &mut Words) -> Result<u64, String> {
    words.number("the number of impacts", IMPACTS)
}

/// Reads the impacts of a pattern, all on walls that there are.
pub(crate) fn read_impacts<C: Coefficient>(
    lines: &mut Lines,
    system: &System<C>,
    count: u64,
) -> Result<Vec<Impact>, Rejection> {
    let impact = |words: &mut Words| {
        let side = Side::read(words)?;
        ensure(system.has(side), format_args!("there is no {side} wall"))?;
        let periods = words.number("the periods to the next impact", PERIODS)?;
        Ok(Impact { side, periods, phase: decimal(words)?, velocity: decimal(words)? })
    };
    let impacts: Vec<Impact> = (0..count).map(|_| lines.line("impact", impact)).collect::<Result<_, _>>()?;
    lines
        .form(impacts.iter().any(|impact| impact.periods > 0), "the periods of an orbit must not sum to 0")?;
    Ok(impacts)
}

/// Reads a parameter's name: a letter or _, then letters, digits or _.
pub(crate) fn read_name(words: &mut Words) -> Result<String, String> {
    let letter = |byte: u8| byte.is_ascii_alphabetic() || byte == b'_';
    let name = words.word("the parameter's name")?;
    let bytes = name.as_bytes();
    let holds = bytes.first().is_some_and(|&first| letter(first))
        && bytes.len() <= NAME
        && bytes.iter().all(|&byte| letter(byte) || byte.is_ascii_digit());
    ensure(holds, format_args!("expected a name of at most {NAME} letters, digits and _"))?;
    Ok(name.to_string())
}

/// Reads R and W.
pub(crate) fn read_radius(lines: &mut Lines) -> Result<(Decimal, Decimal), Rejection> {
    lines.line("radius", |words| Ok((decimal(words)?, decimal(words)?)))
}

/// Reads a square matrix, its lines of up to `longest` bytes.
pub(crate) fn read_matrix(
    longest: usize,
    lines: &mut Lines,
    size: usize,
) -> Result<Vec<Vec<Decimal>>, Rejection> {
    let row = |words: &mut Words| (0..size).map(|_| decimal(words)).collect::<Result<Vec<_>, _>>();
    (0..size).map(|_| lines.line_within(longest, "row", row)).collect()
}

/// Reads the pieces of so many flights, and the end of the file. `work` is a bound of the exponentials that
/// the check takes, by the number of pieces.
pub(crate) fn read_flights(
    lines: &mut Lines,
    count: usize,
    work: impl Fn(u64) -> u64,
) -> Result<Vec<Vec<Decimal>>, Rejection> {
    let (flights, _) = read_pieces(lines, count, WORK, work)?;
    lines.end("the file goes on after the last flight")?;
    Ok(flights)
}

/// Reads the pieces of so many flights, which may make the check take up to `most`; and how many they are.
pub(crate) fn read_pieces(
    lines: &mut Lines,
    count: usize,
    most: u64,
    work: impl Fn(u64) -> u64,
) -> Result<(Vec<Vec<Decimal>>, u64), Rejection> {
    let mut flights = Vec::new();
    let mut pieces = 0;
    for _ in 0..count {
        let count = lines.line("flight", |words| words.number("the number of pieces", most))?;
        lines.form(count > 0, "a flight has at least one piece")?;
        pieces += count;
        let work = work(pieces);
        let reason = format_args!(
            "the check would take up to {work} exponentials, more than {most}: fewer pieces or harmonics"
        );
        lines.form(work <= most, reason)?;
        flights.push((0..count).map(|_| lines.line("until", decimal)).collect::<Result<_, _>>()?);
    }
    Ok((flights, pieces))
}
