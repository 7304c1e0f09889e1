//! The lines that certificates about oscillators have in common, as written and as read.

use std::fmt;

use super::{
    Lines, Rejection, Words, fixed::Interval, header::expect_statement, lines::LONGEST, number::Number,
};
use crate::sha256::sha256;

/// The longest numerator, denominator or decimal, in digits: below 2¹¹³.
pub(crate) const DIGITS: usize = 34;
/// The most impacts; a row of the matrix is one line.
const IMPACTS: u64 = 24;
/// The most harmonics of one function, and the largest multiple.
pub(crate) const HARMONICS: u64 = 1000;
/// The most periods between two impacts.
pub(crate) const PERIODS: u64 = 10_000;
/// The most exponentials that a check may take.
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

/// A coefficient of a system.
pub(crate) trait Coefficient: fmt::Display + Sized {
    /// Whether it is 0, whatever the parameter is.
    fn is_zero(&self) -> bool;

    /// Whether it may be below 0 whatever the parameter is, as far as that can be told without evaluating it.
    fn is_negative(&self) -> bool;

    /// Its value at a value of the parameter.
    fn enclosed<N: Number>(&self, parameter: N) -> N;

    /// Reads a word.
    fn read(words: &mut Words) -> Result<Self, String>;
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
    fn is_zero(&self) -> bool {
        self.p == 0
    }

    fn is_negative(&self) -> bool {
        self.p < 0
    }

    fn enclosed<N: Number>(&self, _: N) -> N {
        N::constant(Interval::ratio(self.p, self.q))
    }

    fn read(words: &mut Words) -> Result<Self, String> {
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

impl Decimal {
    pub(crate) fn enclosed(self) -> Interval {
        Interval::ratio(self.digits, 10i128.pow(self.places))
    }

    /// The whole part and the rest in units of 10⁻³⁴, both of the number's sign: they are in order as the
    /// numbers are.
    pub(crate) fn parts(self) -> (i128, i128) {
        let scale = 10i128.pow(self.places);
        (self.digits / scale, self.digits % scale * 10i128.pow(DIGITS as u32 - self.places))
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
    for flight in flights {
        writeln!(f, "flight {}", flight.len())?;
        flight.iter().try_for_each(|end| writeln!(f, "until {end}"))?;
    }
    Ok(())
}

/// The next line, led by its name and read by `parse` to its end.
pub(crate) fn line<T>(
    lines: &mut Lines,
    name: &str,
    parse: impl FnOnce(&mut Words) -> Result<T, String>,
) -> Result<T, Rejection> {
    line_within(LONGEST, lines, name, parse)
}

/// The same, of up to `longest` bytes.
pub(crate) fn line_within<T>(
    longest: usize,
    lines: &mut Lines,
    name: &str,
    parse: impl FnOnce(&mut Words) -> Result<T, String>,
) -> Result<T, Rejection> {
    let text = lines.expect_within(longest, &format!("a line \"{name} …\""))?;
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

/// `-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?` but not `-0`, of at most [`DIGITS`] digits: every decimal number has
/// exactly one such form.
pub(crate) fn canonical_decimal(word: &str) -> Option<Decimal> {
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
pub(crate) fn in_range(x: Interval) -> bool {
    x.magnitude_bits().is_some()
}

/// A decimal without a point.
pub(crate) fn integer(word: &str) -> Option<i128> {
    canonical_decimal(word).filter(|number| number.places == 0).map(|number| number.digits)
}

/// The greatest common divisor; that of 0 and b is b.
pub(crate) fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// Reads a decimal.
pub(crate) fn decimal(words: &mut Words) -> Result<Decimal, String> {
    canonical_decimal(words.word("a decimal")?).filter(|x| in_range(x.enclosed())).ok_or_else(|| {
        format!("expected a decimal of at most {DIGITS} digits between -2^30 and 2^30, without +, -0 or needless zeros")
    })
}

fn read_harmonics<C: Coefficient>(lines: &mut Lines, count: u64) -> Result<Vec<Harmonic<C>>, Rejection> {
    let read = |words: &mut Words| {
        let k = words.number("k", HARMONICS)?;
        Ok(Harmonic { k, cos: C::read(words)?, sin: C::read(words)? })
    };
    (0..count).map(|_| line(lines, "harmonic", read)).collect()
}

fn read_wall<C: Coefficient>(lines: &mut Lines, side: Side) -> Result<Option<Wall<C>>, Rejection> {
    let head = line(lines, &side.to_string(), |words| {
        let mut rest = words.clone();
        if rest.word("none")? == "none" {
            *words = rest;
            return Ok(None);
        }
        let (offset, restitution) = (C::read(words)?, C::read(words)?);
        if restitution.is_negative() {
            return Err("a restitution is at least 0".into());
        }
        Ok(Some((offset, restitution, words.number("the number of harmonics", HARMONICS)?)))
    })?;
    let Some((offset, restitution, count)) = head else { return Ok(None) };
    Ok(Some(Wall { offset, restitution, harmonics: read_harmonics(lines, count)? }))
}

/// Reads the statement, the digest and the system that it belongs to.
pub(crate) fn read_system<C: Coefficient>(
    lines: &mut Lines,
    statement: &str,
) -> Result<System<C>, Rejection> {
    expect_statement(lines, statement)?;
    let digest = line(lines, "digest", |words| words.word("a digest").map(str::to_string))?;
    let digest_at = lines.number();
    let (damping, stiffness) = (line(lines, "damping", C::read)?, line(lines, "stiffness", C::read)?);
    let force = line(lines, "force", C::read)?;
    let count = line(lines, "forcing", |words| words.number("the number of harmonics", HARMONICS))?;
    let forcing = read_harmonics(lines, count)?;
    let (lower, upper) = (read_wall(lines, Side::Lower)?, read_wall(lines, Side::Upper)?);
    let system = System { damping, stiffness, force, forcing, lower, upper };
    let own = system.digest();
    if digest != own {
        let reason = format!("the digest is not that of the system, which is {own}");
        return Err(Rejection::False { line: digest_at, reason });
    }
    Ok(system)
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
        if !system.has(side) {
            return Err(format!("there is no {side} wall"));
        }
        let periods = words.number("the periods to the next impact", PERIODS)?;
        Ok(Impact { side, periods, phase: decimal(words)?, velocity: decimal(words)? })
    };
    let impacts: Vec<Impact> = (0..count).map(|_| line(lines, "impact", impact)).collect::<Result<_, _>>()?;
    if impacts.iter().all(|impact| impact.periods == 0) {
        return Err(lines.malformed("the periods of an orbit must not sum to 0"));
    }
    Ok(impacts)
}

/// Reads R and W.
pub(crate) fn read_radius(lines: &mut Lines) -> Result<(Decimal, Decimal), Rejection> {
    line(lines, "radius", |words| Ok((decimal(words)?, decimal(words)?)))
}

/// Reads a square matrix.
pub(crate) fn read_matrix(lines: &mut Lines, size: usize) -> Result<Vec<Vec<Decimal>>, Rejection> {
    read_matrix_within(LONGEST, lines, size)
}

/// The same, its lines of up to `longest` bytes.
pub(crate) fn read_matrix_within(
    longest: usize,
    lines: &mut Lines,
    size: usize,
) -> Result<Vec<Vec<Decimal>>, Rejection> {
    let row = |words: &mut Words| (0..size).map(|_| decimal(words)).collect::<Result<Vec<_>, _>>();
    (0..size).map(|_| line_within(longest, lines, "row", row)).collect()
}

/// Reads the pieces of so many flights, and the end of the file. `work` is a bound of the exponentials that
/// the check takes, by the number of pieces.
pub(crate) fn read_flights(
    lines: &mut Lines,
    count: usize,
    work: impl Fn(u64) -> u64,
) -> Result<Vec<Vec<Decimal>>, Rejection> {
    let mut flights = Vec::new();
    let mut pieces = 0;
    for _ in 0..count {
        let count = line(lines, "flight", |words| words.number("the number of pieces", WORK))?;
        if count == 0 {
            return Err(lines.malformed("a flight has at least one piece"));
        }
        pieces += count;
        let work = work(pieces);
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
    Ok(flights)
}
