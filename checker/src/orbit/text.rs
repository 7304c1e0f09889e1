//! A certificate's contents, as written and as read.

use std::fmt;

use super::{Lines, Rejection, STATEMENT, Words, fixed::Interval, header::expect_statement, sha256::sha256};

/// The longest numerator, denominator or decimal, in digits: below 2¹¹³.
const DIGITS: usize = 34;
/// The most impacts; a row of the matrix is one line.
const IMPACTS: u64 = 24;
/// The most harmonics of one function, and the largest multiple.
const HARMONICS: u64 = 1000;
/// The most periods between two impacts.
const PERIODS: u64 = 10_000;
/// The most work, see [`Certificate::work`].
const WORK: u64 = 1_000_000;

/// A fraction p/q in lowest terms, q > 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    /// The numerator.
    pub p: i128,
    /// The denominator.
    pub q: i128,
}

/// `digits` / 10^`places`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decimal {
    /// All digits, as an integer.
    pub digits: i128,
    /// How many of them stand after the point.
    pub places: u32,
}

/// `cos` cos kt + `sin` sin kt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Harmonic {
    /// The multiple of the base frequency.
    pub k: u64,
    /// The coefficient of cos kt.
    pub cos: Fraction,
    /// The coefficient of sin kt.
    pub sin: Fraction,
}

/// A wall at `offset` + Σ harmonics.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wall {
    /// The mean position.
    pub offset: Fraction,
    /// An impact turns the relative velocity w into −`restitution` w.
    pub restitution: Fraction,
    /// The motion about the mean.
    pub harmonics: Vec<Harmonic>,
}

/// q″ = −`damping` q′ − `stiffness` q + `force` + Σ forcing, between its walls.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct System {
    /// The coefficient of the velocity.
    pub damping: Fraction,
    /// The coefficient of the displacement.
    pub stiffness: Fraction,
    /// A constant acceleration.
    pub force: Fraction,
    /// The harmonics of the forcing.
    pub forcing: Vec<Harmonic>,
    /// The wall below.
    pub lower: Option<Wall>,
    /// The wall above.
    pub upper: Option<Wall>,
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
pub struct Certificate {
    /// The oscillator.
    pub system: System,
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

impl Certificate {
    /// A bound of the number of exponentials that the check takes, each about 18 µs: (1 + J)(4 P + 24 m) for J harmonics in all, P pieces and m impacts.
    ///
    /// A piece takes two motions for each of at most two walls, and Krawczyk's test, twice, and the multipliers take at most 12 for each impact. A motion is one exponential, at most two for a
    /// harmonic of the forcing and one for one of a wall.
    fn work(harmonics: u64, pieces: u64, impacts: u64) -> u64 {
        (1 + harmonics) * (4 * pieces + 24 * impacts)
    }
}

impl System {
    /// The number of harmonics of the forcing and of the walls.
    fn harmonics(&self) -> u64 {
        let walls = [&self.lower, &self.upper].into_iter().flatten();
        (self.forcing.len() + walls.map(|wall| wall.harmonics.len()).sum::<usize>()) as u64
    }

    /// SHA-256 of the system's lines, in hexadecimal: the same oscillator has the same digest.
    pub fn digest(&self) -> String {
        sha256(self.to_string().as_bytes())
    }
}

impl Side {
    /// ±x: the direction away from this wall.
    pub(super) fn inward(self, x: Interval) -> Interval {
        match self {
            Side::Lower => x,
            Side::Upper => -x,
        }
    }
}

impl Decimal {
    pub(super) fn enclosed(self) -> Interval {
        Interval::ratio(self.digits, 10i128.pow(self.places))
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.p, self.q)
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.digits < 0 { "-" } else { "" };
        let scale = 10u128.pow(self.places);
        let magnitude = self.digits.unsigned_abs();
        write!(f, "{sign}{}", magnitude / scale)?;
        if self.places > 0 { write!(f, ".{:01$}", magnitude % scale, self.places as usize) } else { Ok(()) }
    }
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Side::Lower { "lower" } else { "upper" })
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

fn write_harmonics(f: &mut fmt::Formatter<'_>, harmonics: &[Harmonic]) -> fmt::Result {
    harmonics.iter().try_for_each(|h| writeln!(f, "harmonic {} {} {}", h.k, h.cos, h.sin))
}

impl fmt::Display for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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

/// The text of the certificate, header included.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let system = &self.system;
        write!(f, "{}\nkind {}\nstatement {STATEMENT}\n", super::FORMAT, super::KIND)?;
        write!(f, "digest {}\n{system}orbit {} {}\n", system.digest(), self.impacts.len(), self.claim)?;
        for i in &self.impacts {
            writeln!(f, "impact {} {} {} {}", i.side, i.periods, i.phase, i.velocity)?;
        }
        writeln!(f, "radius {} {}", self.radius, self.within)?;
        for row in &self.inverse {
            write!(f, "row")?;
            row.iter().try_for_each(|c| write!(f, " {c}"))?;
            writeln!(f)?;
        }
        for flight in &self.flights {
            writeln!(f, "flight {}", flight.len())?;
            flight.iter().try_for_each(|end| writeln!(f, "until {end}"))?;
        }
        Ok(())
    }
}

/// The next line, led by its name and read by `parse` to its end.
fn line<T>(
    lines: &mut Lines,
    name: &str,
    parse: impl FnOnce(&mut Words) -> Result<T, String>,
) -> Result<T, Rejection> {
    let text = lines.expect(&format!("a line \"{name} …\""))?;
    let mut words = Words::new(&text);
    let read = || {
        if words.word(name)? != name {
            return Err(format!("expected a line \"{name} …\""));
        }
        let value = parse(&mut words)?;
        words.end()?;
        Ok(value)
    };
    read().map_err(|reason| lines.malformed(reason))
}

/// Whether these are digits, at least one.
fn are_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// `-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?` but not `-0`, of at most [`DIGITS`] digits: every decimal number has exactly one such form.
pub(super) fn canonical_decimal(word: &str) -> Option<Decimal> {
    let magnitude = word.strip_prefix('-').unwrap_or(word);
    let (whole, places) = match magnitude.split_once('.') {
        None => (magnitude, ""),
        Some((_, places)) if !are_digits(places) || places.ends_with('0') => return None,
        Some(parts) => parts,
    };
    let canonical = are_digits(whole) && (whole == "0" || !whole.starts_with('0')) && word != "-0";
    if !canonical || whole.len() + places.len() > DIGITS {
        return None;
    }
    let digits: i128 = format!("{whole}{places}").parse().ok()?;
    Some(Decimal {
        digits: if word.starts_with('-') { -digits } else { digits },
        places: places.len() as u32,
    })
}

/// Whether the checker's intervals can hold a number.
fn in_range(x: Interval) -> bool {
    x.magnitude_bits().is_some()
}

/// A decimal without a point.
fn integer(word: &str) -> Option<i128> {
    canonical_decimal(word).filter(|number| number.places == 0).map(|number| number.digits)
}

fn fraction(words: &mut Words) -> Result<Fraction, String> {
    let gcd = |mut a: u128, mut b: u128| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let read = |word: &str| {
        let (p, q) = word.split_once('/')?;
        let (p, q) = (integer(p)?, integer(q)?);
        (q > 0 && gcd(p.unsigned_abs(), q.unsigned_abs()) == 1).then_some(Fraction { p, q })
    };
    read(words.word("a fraction p/q")?).filter(|x| in_range(Interval::ratio(x.p, x.q))).ok_or_else(|| {
        format!(
            "expected a fraction p/q in lowest terms, of at most {DIGITS} digits each, between -2^30 and 2^30"
        )
    })
}

fn decimal(words: &mut Words) -> Result<Decimal, String> {
    canonical_decimal(words.word("a decimal")?).filter(|x| in_range(x.enclosed())).ok_or_else(|| {
        format!("expected a decimal of at most {DIGITS} digits between -2^30 and 2^30, without +, -0 or needless zeros")
    })
}

fn read_harmonics(lines: &mut Lines, count: u64) -> Result<Vec<Harmonic>, Rejection> {
    let read = |words: &mut Words| {
        let k = words.number("k", HARMONICS)?;
        Ok(Harmonic { k, cos: fraction(words)?, sin: fraction(words)? })
    };
    (0..count).map(|_| line(lines, "harmonic", read)).collect()
}

fn read_wall(lines: &mut Lines, side: Side) -> Result<Option<Wall>, Rejection> {
    let head = line(lines, &side.to_string(), |words| {
        let mut rest = words.clone();
        if rest.word("none")? == "none" {
            *words = rest;
            return Ok(None);
        }
        let (offset, restitution) = (fraction(words)?, fraction(words)?);
        if restitution.p < 0 {
            return Err("a restitution is at least 0".into());
        }
        Ok(Some((offset, restitution, words.number("the number of harmonics", HARMONICS)?)))
    })?;
    let Some((offset, restitution, count)) = head else { return Ok(None) };
    Ok(Some(Wall { offset, restitution, harmonics: read_harmonics(lines, count)? }))
}

/// Reads everything after the kind line.
pub(super) fn read(lines: &mut Lines) -> Result<Certificate, Rejection> {
    expect_statement(lines, STATEMENT)?;
    let digest = line(lines, "digest", |words| words.word("a digest").map(str::to_string))?;
    let digest_at = lines.number();
    let (damping, stiffness) = (line(lines, "damping", fraction)?, line(lines, "stiffness", fraction)?);
    let force = line(lines, "force", fraction)?;
    let count = line(lines, "forcing", |words| words.number("the number of harmonics", HARMONICS))?;
    let forcing = read_harmonics(lines, count)?;
    let (lower, upper) = (read_wall(lines, Side::Lower)?, read_wall(lines, Side::Upper)?);
    let system = System { damping, stiffness, force, forcing, lower, upper };
    if digest != system.digest() {
        let reason = format!("the digest is not that of the system, which is {}", system.digest());
        return Err(Rejection::False { line: digest_at, reason });
    }
    let (m, claim) = line(lines, "orbit", |words| {
        let m = words.number("the number of impacts", IMPACTS)?;
        let claim = match words.word("stable, unstable or open")? {
            "stable" => Claim::Stable,
            "unstable" => Claim::Unstable,
            "open" => Claim::Open,
            _ => return Err("expected stable, unstable or open".into()),
        };
        Ok((m, claim))
    })?;
    let impact = |words: &mut Words| {
        let (side, wall) = match words.word("lower or upper")? {
            "lower" => (Side::Lower, &system.lower),
            "upper" => (Side::Upper, &system.upper),
            _ => return Err("expected lower or upper".into()),
        };
        wall.as_ref().ok_or_else(|| format!("there is no {side} wall"))?;
        let periods = words.number("the periods to the next impact", PERIODS)?;
        Ok(Impact { side, periods, phase: decimal(words)?, velocity: decimal(words)? })
    };
    let impacts: Vec<Impact> = (0..m).map(|_| line(lines, "impact", impact)).collect::<Result<_, _>>()?;
    if impacts.iter().all(|impact| impact.periods == 0) {
        return Err(lines.malformed("the periods of an orbit must not sum to 0"));
    }
    let (radius, within) = line(lines, "radius", |words| Ok((decimal(words)?, decimal(words)?)))?;
    let row = |words: &mut Words| (0..2 * m).map(|_| decimal(words)).collect::<Result<Vec<_>, _>>();
    let inverse = (0..2 * m).map(|_| line(lines, "row", row)).collect::<Result<_, _>>()?;
    let mut flights = Vec::new();
    let mut pieces = 0;
    for _ in 0..m {
        let count = line(lines, "flight", |words| words.number("the number of pieces", WORK))?;
        if count == 0 {
            return Err(lines.malformed("a flight has at least one piece"));
        }
        pieces += count;
        let work = Certificate::work(system.harmonics(), pieces, m);
        if work > WORK {
            return Err(lines.malformed(format!(
                "the check would take up to {work} exponentials, more than {WORK}: fewer pieces or harmonics"
            )));
        }
        flights.push((0..count).map(|_| line(lines, "until", decimal)).collect::<Result<_, _>>()?);
    }
    if lines.next()?.is_some() {
        return Err(lines.malformed("the file goes on after the last flight"));
    }
    Ok(Certificate { system, claim, impacts, radius, within, inverse, flights })
}
