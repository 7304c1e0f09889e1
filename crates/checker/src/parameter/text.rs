//! A certificate's contents, as written and as read, without the certificate that follows.

use std::fmt;

use super::{
    super::motion::text::{HARMONICS, decimal, read_name, read_system},
    Lines, Quotient, Rejection, Version,
};
use crate::{lines::Words, rejection::ensure, touch::text::fraction};

pub use super::super::motion::text::{Decimal, Fraction, System};

/// The most pieces.
const PIECES: u64 = 1000;
/// The most depths.
const DEPTHS: u64 = 100;

/// Where the range begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Begin {
    /// At the touch, which is between these.
    Touch([Decimal; 2]),
    /// At a value, beyond the touch.
    From(Decimal),
}

/// Up to which parameter the depth is at most this.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Depth {
    /// NU.
    pub depth: Fraction,
    /// P.
    pub parameter: Decimal,
}

/// All that a certificate of this kind holds but for the one that follows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate<C = Quotient> {
    /// The oscillator.
    pub system: System<C>,
    /// The parameter's name.
    pub name: String,
    /// Where the range begins.
    pub begin: Begin,
    /// Of several harmonics a time of the wall's top is between these.
    pub top: Option<[Decimal; 2]>,
    /// In how many pieces the range is looked at.
    pub pieces: u64,
    /// Depths, from the touch on.
    pub depths: Vec<Depth>,
}

impl Begin {
    /// The value farthest from all depths, if these are above it.
    pub(super) fn outer(self, above: bool) -> Decimal {
        match self {
            Begin::From(value) => value,
            Begin::Touch([lo, hi]) => {
                if above {
                    lo
                } else {
                    hi
                }
            }
        }
    }

    /// The value nearest to them.
    pub(super) fn inner(self, above: bool) -> Decimal {
        match self {
            Begin::From(value) => value,
            Begin::Touch([lo, hi]) => {
                if above {
                    hi
                } else {
                    lo
                }
            }
        }
    }
}

impl<C> Certificate<C> {
    /// Whether the parameter is above the touch.
    pub(super) fn is_above(&self) -> bool {
        let start = match self.begin {
            Begin::From(value) | Begin::Touch([value, _]) => value,
        };
        self.depths.first().is_some_and(|first| start.parts() < first.parameter.parts())
    }

    /// The range's ends, the touch first.
    pub(super) fn ends(&self) -> Option<[Decimal; 2]> {
        Some([self.begin.outer(self.is_above()), self.depths.last()?.parameter])
    }
}

/// The text of the certificate up to the line `kind` of the one that follows, header included.
impl<C: Version> fmt::Display for Certificate<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let system = &self.system;
        write!(f, "{}\n{}\nstatement {}\n", crate::FORMAT, C::HEAD, C::STATEMENT)?;
        write!(f, "digest {}\n{system}parameter {}\n", system.digest(), self.name)?;
        match self.begin {
            Begin::Touch([lo, hi]) => writeln!(f, "touch {lo} {hi}")?,
            Begin::From(value) => writeln!(f, "from {value}")?,
        }
        match self.top {
            Some([lo, hi]) => writeln!(f, "top {lo} {hi}")?,
            None => writeln!(f, "top none")?,
        }
        writeln!(f, "pieces {}\ndepths {}", self.pieces, self.depths.len())?;
        self.depths.iter().try_for_each(|Depth { depth, parameter }| writeln!(f, "depth {depth} {parameter}"))
    }
}

/// Two decimals, the first below the second.
fn increasing(words: &mut Words) -> Result<[Decimal; 2], String> {
    let [lo, hi] = [decimal(words)?, decimal(words)?];
    ensure(lo.parts() < hi.parts(), "the first of two ends is below the second")?;
    Ok([lo, hi])
}

fn top(words: &mut Words) -> Result<Option<[Decimal; 2]>, String> {
    let mut rest = words.clone();
    if rest.word("none")? == "none" {
        *words = rest;
        return Ok(None);
    }
    increasing(words).map(Some)
}

/// A number from 1.
fn count(lines: &mut Lines, name: &str, most: u64) -> Result<u64, Rejection> {
    let value = lines.line(name, |words| words.number("a number", most))?;
    lines.form(value > 0, format_args!("{name} is at least 1"))?;
    Ok(value)
}

/// Reads everything after the kind line up to the certificate that follows.
pub(super) fn read<C: Version>(lines: &mut Lines) -> Result<Certificate<C>, Rejection> {
    let system: System<C> = read_system(lines, C::STATEMENT)?;
    lines.form(system.harmonics() <= HARMONICS, format_args!("there are at most {HARMONICS} harmonics"))?;
    let name = lines.line("parameter", read_name)?;
    let line = lines.expect("a line \"touch …\" or \"from …\"")?;
    let begin = match Words::new(&line).name("from") {
        Ok(()) => lines.read(&line, "from", |words| decimal(words).map(Begin::From))?,
        Err(_) => lines.read(&line, "touch", |words| increasing(words).map(Begin::Touch))?,
    };
    let top = lines.line("top", top)?;
    let pieces = count(lines, "pieces", PIECES)?;
    let number = count(lines, "depths", DEPTHS)?;
    let mut depths: Vec<Depth> = Vec::new();
    for _ in 0..number {
        let next =
            lines.line("depth", |words| Ok(Depth { depth: fraction(words)?, parameter: decimal(words)? }))?;
        lines.form(next.depth.p > 0, "a depth is above 0")?;
        depths.push(next);
    }
    let certificate = Certificate { system, name, begin, top, pieces, depths };
    let above = certificate.is_above();
    let mut last = (certificate.begin.inner(above), Fraction { p: 0, q: 1 });
    for Depth { depth, parameter } in &certificate.depths {
        let beyond = match above {
            true => last.0.parts() < parameter.parts(),
            false => parameter.parts() < last.0.parts(),
        };
        lines.form(beyond, "the parameters of depths go away from the touch, and none is in it")?;
        lines.form(last.1.p * depth.q < depth.p * last.1.q, "depths increase")?;
        last = (*parameter, *depth);
    }
    Ok(certificate)
}
