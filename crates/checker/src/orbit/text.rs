//! A certificate's contents, as written and as read.

use std::fmt;

use super::{
    super::lines::Words,
    super::motion::text::{
        read_count, read_flights, read_impacts, read_matrix, read_radius, read_system, write_proof,
    },
    Decimal, Fraction, Impact, Lines, Rejection, System, Version,
};

use crate::lines::LONGEST;

/// What is claimed of the multipliers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Claim {
    /// All strictly inside the unit circle.
    Stable,
    /// One strictly outside.
    Unstable,
    /// Nothing.
    Open,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate<C = Fraction> {
    /// The oscillator.
    pub system: System<C>,
    /// The claim about stability.
    pub claim: Claim,
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

/// A bound of the number of exponentials that the check takes: (1 + 2J)(4 P + 24 m) for J harmonics in all, P
/// pieces and m impacts.
///
/// A piece takes two motions for each of at most two walls, and Krawczyk's test, twice, and the multipliers
/// take at most 12 for each impact. A motion is one exponential, and at most two for each harmonic.
pub(super) fn work(harmonics: u64, pieces: u64, impacts: u64) -> u64 {
    (1 + 2 * harmonics) * (4 * pieces + 24 * impacts)
}

impl Claim {
    /// In words.
    pub(crate) fn said(self) -> &'static str {
        match self {
            Claim::Stable => "stable",
            Claim::Unstable => "unstable",
            Claim::Open => "open: nothing is claimed",
        }
    }

    pub(crate) fn read(words: &mut Words) -> Result<Claim, String> {
        match words.word("stable, unstable or open")? {
            "stable" => Ok(Claim::Stable),
            "unstable" => Ok(Claim::Unstable),
            "open" => Ok(Claim::Open),
            _ => Err("expected stable, unstable or open".into()),
        }
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Claim::Stable => "stable",
            Claim::Unstable => "unstable",
            Claim::Open => "open",
        })
    }
}

/// The text of the certificate, header included.
impl<C: Version> fmt::Display for Certificate<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let system = &self.system;
        write!(f, "{}\n{}\nstatement {}\n", super::FORMAT, C::HEAD, C::STATEMENT)?;
        write!(f, "digest {}\n{system}orbit {} {}\n", system.digest(), self.impacts.len(), self.claim)?;
        self.impacts.iter().try_for_each(|impact| writeln!(f, "{impact}"))?;
        writeln!(f, "radius {} {}", self.radius, self.within)?;
        write_proof(f, &self.inverse, &self.flights)
    }
}

/// Reads everything after the kind line.
pub(super) fn read<C: Version>(lines: &mut Lines) -> Result<Certificate<C>, Rejection> {
    let system: System<C> = read_system(lines, C::STATEMENT)?;
    let (m, claim) = lines.line("orbit", |words| Ok((read_count(words)?, Claim::read(words)?)))?;
    let impacts = read_impacts(lines, &system, m)?;
    let (radius, within) = read_radius(lines)?;
    let inverse = read_matrix(LONGEST, lines, 2 * impacts.len())?;
    let flights = read_flights(lines, impacts.len(), |pieces| work(system.harmonics(), pieces, m))?;
    Ok(Certificate { system, claim, impacts, radius, within, inverse, flights })
}
