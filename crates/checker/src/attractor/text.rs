//! A certificate's contents, as written and as read.

use std::fmt;

use super::{Rejection, STATEMENT};
use crate::{
    header::expect_statement,
    lines::{Lines, Words},
    touch::text::{count, fraction, fractions, line, positive, read_harmonics},
};

pub use crate::touch::text::{Decimal, Fraction, Harmonic, Range};

/// The most pieces of the wall.
const PIECES: u64 = 1000;
/// The most periods of returns, for the growth and for an exponent.
const PERIODS: u64 = 1000;
const RETURNS: u64 = 2000;

/// The names of the ranges, as their lines begin.
pub(super) const RANGES: [&str; 3] = ["damping", "stiffness", "restitution"];

/// How a wall of several harmonics is shown to be as it is said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shown {
    /// It is concave from −U to V.
    pub concave: [Decimal; 2],
    /// In so many pieces.
    pub pieces: u64,
}

/// How fast motions part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Exponent {
    /// For ν from this on.
    pub depth: Fraction,
    /// R: in each period.
    pub rate: Decimal,
    /// L: returns take no more periods.
    pub last: u64,
}

/// The oscillators, the wall and the trap: what both versions hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// The ranges of c, k, τ, in this order.
    pub ranges: [Range<Fraction>; 3],
    /// The wall's harmonics, their orders increasing.
    pub harmonics: Vec<Harmonic>,
    /// The greatest ν.
    pub depth: Fraction,
    /// U and V: where it is beyond the place of rest.
    pub window: [Decimal; 2],
    /// α and α′: between which it bends there.
    pub bends: [Decimal; 2],
    /// How both are shown, but of a cosine.
    pub shown: Option<Shown>,
    /// S.
    pub speed: Decimal,
    /// Z.
    pub slip: Decimal,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Of what, and where.
    pub setting: Setting,
    /// E.
    pub growth: Decimal,
    /// N.
    pub last: u64,
    /// X.
    pub start: Decimal,
    /// What is said of exponents but that they are positive.
    pub exponent: Option<Exponent>,
}

/// Whether g(t) = cos t.
fn is_cosine(harmonics: &[Harmonic]) -> bool {
    let is = |[lo, hi]: Range<Fraction>, value: i128| lo == hi && lo == Fraction { p: value, q: 1 };
    matches!(harmonics, [only] if only.order == 1 && is(only.parts[0], 1) && is(only.parts[1], 0))
}

impl Setting {
    /// Its lines, of depths from `least` on if there is such a number.
    pub(super) fn write(&self, f: &mut fmt::Formatter<'_>, least: Option<Fraction>) -> fmt::Result {
        for (name, [lo, hi]) in RANGES.iter().zip(self.ranges) {
            writeln!(f, "{name} {lo} {hi}")?;
        }
        writeln!(f, "harmonics {}", self.harmonics.len())?;
        for Harmonic { order, parts: [[a, b], [c, d]] } in &self.harmonics {
            writeln!(f, "harmonic {order} {a} {b} {c} {d}")?;
        }
        match least {
            Some(least) => writeln!(f, "depths {least} {}", self.depth)?,
            None => writeln!(f, "depth {}", self.depth)?,
        }
        let ([before, after], [least, greatest]) = (self.window, self.bends);
        writeln!(f, "window {before} {after}\nbends {least} {greatest}")?;
        if let Some(Shown { concave: [before, after], pieces }) = self.shown {
            writeln!(f, "concave {before} {after}\npieces {pieces}")?;
        }
        writeln!(f, "speed {}\nslip {}", self.speed, self.slip)
    }
}

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\nkind {}\nstatement {STATEMENT}\n", crate::FORMAT, super::KIND)?;
        self.setting.write(f, None)?;
        writeln!(f, "growth {} {}\nstart {}", self.growth, self.last, self.start)?;
        match self.exponent {
            Some(Exponent { depth, rate, last }) => writeln!(f, "exponent {depth} {rate} {last}"),
            None => writeln!(f, "exponent none"),
        }
    }
}

/// Two decimals above 0.
fn two(words: &mut Words) -> Result<[Decimal; 2], String> {
    Ok([positive(words, "each of two numbers")?, positive(words, "each of two numbers")?])
}

/// A fraction above 0.
fn positive_fraction(words: &mut Words) -> Result<Fraction, String> {
    let depth = fraction(words)?;
    if depth.p > 0 { Ok(depth) } else { Err("a depth must be positive".into()) }
}

/// A number of periods, from 1.
pub(super) fn periods(words: &mut Words, most: u64) -> Result<u64, String> {
    let number = words.number("a number of periods", most)?;
    if number > 0 { Ok(number) } else { Err("a number of periods is at least 1".into()) }
}

/// `none`, or a depth, a rate and a number of periods.
fn exponent(words: &mut Words) -> Result<Option<Exponent>, String> {
    let mut rest = words.clone();
    if rest.word("a fraction, or none")? == "none" {
        *words = rest;
        return Ok(None);
    }
    let (depth, rate) = (positive_fraction(words)?, positive(words, "an exponent")?);
    Ok(Some(Exponent { depth, rate, last: periods(words, RETURNS)? }))
}

/// Whether one fraction is at most another.
pub(super) fn is_up_to(one: Fraction, other: Fraction) -> bool {
    one.p * other.q <= other.p * one.q
}

/// The lines of the setting, and the least depth if `both` are listed.
pub(super) fn setting(lines: &mut Lines, both: bool) -> Result<(Setting, Option<Fraction>), Rejection> {
    let mut ranges = [[Fraction::ZERO; 2]; 3];
    for (range, name) in ranges.iter_mut().zip(RANGES) {
        *range = line(lines, name, fractions)?;
    }
    lines.form(ranges[2][0].p > 0, "a restitution must be positive here")?;
    let harmonics = read_harmonics(lines)?;
    let (least, depth) = match both {
        true => {
            line(lines, "depths", |words| Ok((Some(positive_fraction(words)?), positive_fraction(words)?)))?
        }
        false => (None, line(lines, "depth", positive_fraction)?),
    };
    let inside = least.is_none_or(|least| is_up_to(least, depth));
    lines.form(inside, "depths must not decrease")?;
    let (window, bends) = (line(lines, "window", two)?, line(lines, "bends", two)?);
    let shown = match is_cosine(&harmonics) {
        true => None,
        false => {
            let concave = line(lines, "concave", two)?;
            Some(Shown { concave, pieces: count(lines, "pieces", "the number of pieces", PIECES)? })
        }
    };
    let speed = line(lines, "speed", |words| positive(words, "a speed"))?;
    let slip = line(lines, "slip", |words| positive(words, "a slip"))?;
    Ok((Setting { ranges, harmonics, depth, window, bends, shown, speed, slip }, least))
}

/// Everything after the kind line, to the end.
pub(super) fn read(lines: &mut Lines) -> Result<Certificate, Rejection> {
    expect_statement(lines, STATEMENT)?;
    let (setting, _) = setting(lines, false)?;
    let (growth, last) =
        line(lines, "growth", |words| Ok((positive(words, "a growth")?, periods(words, PERIODS)?)))?;
    lines.form(growth.digits > 10i128.pow(growth.places), "a growth must be above 1")?;
    let start = line(lines, "start", |words| positive(words, "a start"))?;
    let exponent = line(lines, "exponent", exponent)?;
    let inside = exponent.is_none_or(|one| is_up_to(one.depth, setting.depth));
    lines.form(inside, "an exponent is listed from a depth up to the greatest")?;
    lines.end("the file goes on after its last line")?;
    Ok(Certificate { setting, growth, last, start, exponent })
}
