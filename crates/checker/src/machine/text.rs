//! A certificate's contents, as written and as read.

use std::fmt;

use super::{
    super::{
        lines::Words,
        motion::text::{
            Coefficient, HARMONICS, PERIODS, decimal, multiple, power, read_digested, read_flights,
            read_harmonics, read_matrix, read_radius, write_proof,
        },
        orbit::Claim,
        sha256::sha256,
    },
    Harmonic, Lines, Range, Rejection, STATEMENT,
};
use crate::rejection::ensure;

pub use super::super::motion::text::Decimal;

/// The most coordinates.
const COORDINATES: u64 = 8;
/// The most stops.
const STOPS: u64 = 16;
/// The most unknowns, 2n + 1 for each impact.
const UNKNOWNS: u64 = 84;
/// The longest line with numbers for all coordinates or unknowns, in bytes.
const LONGEST: usize = 4000;

/// A harmonic of the force.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Load {
    /// The multiple of the base frequency, from 1.
    pub k: u64,
    /// The coefficients of the cosine.
    pub cos: Vec<Range>,
    /// The coefficients of the sine.
    pub sin: Vec<Range>,
}

/// A rigid stop: `row`·q − `offset` − Σ `harmonics` stays ≥ 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stop {
    /// w.
    pub row: Vec<Range>,
    /// Its mean place.
    pub offset: Range,
    /// An impact turns the gap's rate w into −`restitution` w.
    pub restitution: Range,
    /// Its motion about the mean, k from 1.
    pub harmonics: Vec<Harmonic<Range>>,
}

/// M q″ + C q′ + K q = f₀ + Σ f_k(t), period T, with stops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Machine {
    /// T.
    pub period: Range,
    /// M, C, K and forces are listed in units of 10^`unit`.
    pub unit: i32,
    /// M, the lower triangle by rows.
    pub mass: Vec<Vec<Range>>,
    /// C by rows.
    pub damping: Vec<Vec<Range>>,
    /// K by rows.
    pub stiffness: Vec<Vec<Range>>,
    /// f₀.
    pub force: Vec<Range>,
    /// Its harmonics.
    pub forcing: Vec<Load>,
    /// The stops.
    pub stops: Vec<Stop>,
}

/// An impact: on which stop, how many periods from its phase to the next one's, about when and in which
/// state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Impact {
    /// The stop, from 0.
    pub stop: usize,
    /// n: the next impact comes 2πn + the difference of the phases later.
    pub periods: u64,
    /// The phase in the middle of the box.
    pub phase: Decimal,
    /// Displacements and velocities just before the impact, in the middle of the box.
    pub state: Vec<Decimal>,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// The machine.
    pub machine: Machine,
    /// The claim about stability.
    pub claim: Claim,
    /// The unit of each displacement, then of each velocity, in which the radii are meant.
    pub scales: Vec<Decimal>,
    /// The pattern, and the middle of the box.
    pub impacts: Vec<Impact>,
    /// Half the side of the box in which the orbit is the only one.
    pub radius: Decimal,
    /// Half the side of the smaller box in which the other claims are proved.
    pub within: Decimal,
    /// The preconditioner: near the inverse of the equations' derivative.
    pub inverse: Vec<Vec<Decimal>>,
    /// For each flight, the times since its impact at which pieces end.
    pub flights: Vec<Vec<Decimal>>,
}

impl Machine {
    /// n.
    pub fn size(&self) -> usize {
        self.mass.len()
    }

    /// SHA-256 of the machine's lines, in hexadecimal: the same machine has the same digest.
    pub fn digest(&self) -> String {
        sha256(self.to_string().as_bytes())
    }

    pub(super) fn harmonics(&self) -> u64 {
        (self.forcing.len() + self.stops.iter().map(|stop| stop.harmonics.len()).sum::<usize>()) as u64
    }
}

/// Words separated by spaces, after the first.
pub(super) struct List<'a, T>(pub &'a [T]);

impl<T: fmt::Display> fmt::Display for List<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|x| write!(f, " {x}"))
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "coordinates {}\nperiod {}\nunit {}", self.size(), self.period, self.unit)?;
        let all = [("mass", &self.mass), ("damping", &self.damping), ("stiffness", &self.stiffness)];
        for (name, matrix) in all {
            matrix.iter().try_for_each(|row| writeln!(f, "{name}{}", List(row)))?;
        }
        writeln!(f, "force{}\nforcing {}", List(&self.force), self.forcing.len())?;
        for Load { k, cos, sin } in &self.forcing {
            writeln!(f, "harmonic {k}{}{}", List(cos), List(sin))?;
        }
        writeln!(f, "stops {}", self.stops.len())?;
        for stop in &self.stops {
            writeln!(f, "stop {} {} {}", stop.offset, stop.restitution, stop.harmonics.len())?;
            writeln!(f, "direction{}", List(&stop.row))?;
            stop.harmonics.iter().try_for_each(|h| writeln!(f, "harmonic {} {} {}", h.k, h.cos, h.sin))?;
        }
        Ok(())
    }
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let machine = &self.machine;
        write!(f, "{}\nkind {}\nstatement {STATEMENT}\n", super::FORMAT, super::KIND)?;
        write!(f, "digest {}\n{machine}orbit {} {}\n", machine.digest(), self.impacts.len(), self.claim)?;
        writeln!(f, "scales{}", List(&self.scales))?;
        for Impact { stop, periods, phase, state } in &self.impacts {
            writeln!(f, "impact {} {periods} {phase}{}", stop + 1, List(state))?;
        }
        writeln!(f, "radius {} {}", self.radius, self.within)?;
        write_proof(f, &self.inverse, &self.flights)
    }
}

/// A bound of the work of a check, in exponentials of 2 × 2 matrices: one of a (2n + 1) × (2n + 1) matrix
/// counts as (2n + 1)³/4, or 7 at least. It is (8P + 20M) of those, and (1 + 2J)(4P + 12M) for the harmonics;
/// J harmonics in all, P pieces and M impacts.
pub(super) fn work(size: u64, harmonics: u64, pieces: u64, impacts: u64) -> u64 {
    let one = (2 * size + 1).pow(3).div_ceil(4);
    one * (8 * pieces + 20 * impacts) + (1 + 2 * harmonics) * (4 * pieces + 12 * impacts)
}

fn ranges(words: &mut Words, count: usize) -> Result<Vec<Range>, String> {
    (0..count).map(|_| Range::read(words)).collect()
}

fn decimals(words: &mut Words, count: usize) -> Result<Vec<Decimal>, String> {
    (0..count).map(|_| decimal(words)).collect()
}

fn read_rows(
    lines: &mut Lines,
    name: &str,
    lengths: impl Iterator<Item = usize>,
) -> Result<Vec<Vec<Range>>, Rejection> {
    lengths.map(|length| lines.line_within(LONGEST, name, |words| ranges(words, length))).collect()
}

fn read_stop(lines: &mut Lines, n: usize) -> Result<Stop, Rejection> {
    let (offset, restitution, count) = lines.line("stop", |words| {
        let [offset, restitution] = [Range::read(words)?, Range::read(words)?];
        ensure(restitution.lower.digits >= 0, "a restitution is at least 0")?;
        Ok((offset, restitution, words.number("the number of harmonics", HARMONICS)?))
    })?;
    let row = lines.line_within(LONGEST, "direction", |words| ranges(words, n))?;
    let harmonics = read_harmonics(lines, count, 1)?;
    Ok(Stop { row, offset, restitution, harmonics })
}

pub(super) fn read_machine(lines: &mut Lines) -> Result<Machine, Rejection> {
    let size = lines.line("coordinates", |words| words.number("the number of coordinates", COORDINATES))?;
    lines.form(size > 0, "a machine has at least one coordinate")?;
    let n = size as usize;
    let period = lines.line("period", Range::read)?;
    let unit = lines.line("unit", power)?;
    let mass = read_rows(lines, "mass", 1..=n)?;
    let [damping, stiffness] = [
        read_rows(lines, "damping", std::iter::repeat_n(n, n))?,
        read_rows(lines, "stiffness", std::iter::repeat_n(n, n))?,
    ];
    let force = lines.line_within(LONGEST, "force", |words| ranges(words, n))?;
    let count = lines.line("forcing", |words| words.number("the number of harmonics", HARMONICS))?;
    let load = |words: &mut Words| {
        Ok(Load { k: multiple(words, 1)?, cos: ranges(words, n)?, sin: ranges(words, n)? })
    };
    let forcing =
        (0..count).map(|_| lines.line_within(LONGEST, "harmonic", load)).collect::<Result<_, _>>()?;
    let count = lines.line("stops", |words| words.number("the number of stops", STOPS))?;
    let stops = (0..count).map(|_| read_stop(lines, n)).collect::<Result<_, _>>()?;
    Ok(Machine { period, unit, mass, damping, stiffness, force, forcing, stops })
}

/// Reads a unit for each displacement and each velocity.
pub(super) fn read_scales(lines: &mut Lines, n: usize) -> Result<Vec<Decimal>, Rejection> {
    let scales = lines.line_within(LONGEST, "scales", |words| decimals(words, 2 * n))?;
    lines.form(scales.iter().all(|scale| scale.digits > 0), "scales are above 0")?;
    Ok(scales)
}

/// Reads everything after the kind line.
pub(super) fn read(lines: &mut Lines) -> Result<Certificate, Rejection> {
    let machine = read_digested(lines, STATEMENT, "machine", read_machine)?;
    let (n, size) = (machine.size(), machine.size() as u64);
    let most = UNKNOWNS / (2 * size + 1);
    let (m, claim) = lines
        .line("orbit", |words| Ok((words.number("the number of impacts", most)?, Claim::read(words)?)))?;
    let scales = read_scales(lines, n)?;
    let impact = |words: &mut Words| {
        let stop = words.number("a stop", machine.stops.len() as u64)?;
        ensure(stop > 0, "stops are counted from 1")?;
        let periods = words.number("the periods to the next impact", PERIODS)?;
        Ok(Impact {
            stop: stop as usize - 1,
            periods,
            phase: decimal(words)?,
            state: decimals(words, 2 * n)?,
        })
    };
    let impacts: Vec<Impact> =
        (0..m).map(|_| lines.line_within(LONGEST, "impact", impact)).collect::<Result<_, _>>()?;
    lines
        .form(impacts.iter().any(|impact| impact.periods > 0), "the periods of an orbit must not sum to 0")?;
    let (radius, within) = read_radius(lines)?;
    let inverse = read_matrix(LONGEST, lines, (2 * n + 1) * impacts.len())?;
    let harmonics = machine.harmonics();
    let flights = read_flights(lines, impacts.len(), |pieces| work(size, harmonics, pieces, m))?;
    Ok(Certificate { machine, claim, scales, impacts, radius, within, inverse, flights })
}
