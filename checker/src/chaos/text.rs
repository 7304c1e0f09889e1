//! A certificate's contents, as written and as read.

use std::fmt;

use super::{CELLS, COST, Lines, Rejection, STATEMENT_3, STATEMENT_4, Words, fixed::Interval};
use crate::header::expect_statement;

/// The longest numerator, denominator or decimal, in digits: below 2⁵⁰.
const DIGITS: usize = 15;
/// The most letters.
const LETTERS: u64 = 400;
/// The most periods of a letter.
const PERIODS: u64 = 1000;
/// The most parts of a range of phases.
const PARTS: u64 = 64;
/// The most harmonics of a wall, and the highest.
const HARMONICS: u64 = 100;
/// The greatest common denominator of the ends of harmonics' ranges.
const DENOMINATOR: i128 = 10i128.pow(30);
/// The most rounds of narrowing.
const ROUNDS: u64 = 100;
/// The most pieces of a time between windows.
const PIECES: u64 = 1000;

/// A fraction p/q in lowest terms, q > 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    /// The numerator.
    pub p: i64,
    /// The denominator.
    pub q: i64,
}

/// `digits` / 10^`places`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decimal {
    /// All digits, as an integer.
    pub digits: i64,
    /// How many of them stand after the point.
    pub places: u32,
}

/// The numbers from the first to the second.
pub type Range<T> = [T; 2];

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

/// A term a cos jt + b sin jt of the wall.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Harmonic {
    /// j ≥ 1.
    pub order: u64,
    /// The ranges of a and b.
    pub parts: [Range<Fraction>; 2],
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

impl Fraction {
    pub(super) fn enclosed(self) -> Interval {
        Interval::ratio(self.p.into(), self.q.into())
    }
}

impl Decimal {
    pub(super) fn enclosed(self) -> Interval {
        Interval::ratio(self.digits.into(), 10i128.pow(self.places))
    }
}

impl Certificate {
    /// Whether the growth rate that is claimed is certainly above 1, so that paths branch.
    pub(super) fn is_chaos(&self) -> bool {
        scaled(self.growth[0]) > ONE
    }

    /// For each letter the letters that may precede it, from 0, increasing.
    pub(super) fn previous(&self) -> Vec<Vec<usize>> {
        let mut all = vec![Vec::new(); self.letters.len()];
        for (m, letter) in self.letters.iter().enumerate() {
            letter.next.iter().for_each(|&n| all[n].push(m));
        }
        all
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
        let (mut digits, mut places) = (self.digits.unsigned_abs(), self.places as usize);
        while places > 0 && digits.is_multiple_of(10) {
            (digits, places) = (digits / 10, places - 1);
        }
        let text = format!("{digits:0width$}", width = places + 1);
        let (whole, rest) = text.split_at(text.len() - places);
        write!(f, "{sign}{whole}{}{rest}", if places > 0 { "." } else { "" })
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

/// The next line, led by its name and read by `parse` to its end.
fn line<T>(
    lines: &mut Lines,
    name: &str,
    parse: impl FnOnce(&mut Words) -> Result<T, String>,
) -> Result<T, Rejection> {
    let text = lines.expect_within(LONGEST, &format!("a line \"{name} …\""))?;
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

/// The longest line: `next` with all letters.
const LONGEST: usize = 2000;

/// `-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?` but not `-0`: every decimal has exactly one such form.
fn canonical(word: &str) -> Option<Decimal> {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let magnitude = word.strip_prefix('-').unwrap_or(word);
    let (whole, places) = match magnitude.split_once('.') {
        None => (magnitude, ""),
        Some((_, places)) if !digits(places) || places.ends_with('0') => return None,
        Some(parts) => parts,
    };
    let plain = digits(whole) && (whole == "0" || !whole.starts_with('0')) && word != "-0";
    if !plain || whole.len() + places.len() > DIGITS {
        return None;
    }
    let value: i64 = format!("{whole}{places}").parse().ok()?;
    Some(Decimal { digits: if word.starts_with('-') { -value } else { value }, places: places.len() as u32 })
}

fn decimal(words: &mut Words) -> Result<Decimal, String> {
    let value = canonical(words.word("a decimal")?).filter(|x| x.enclosed().bits().is_some());
    value.ok_or_else(|| format!("expected a decimal of at most {DIGITS} digits between -2^15 and 2^15"))
}

fn positive(words: &mut Words, what: &str) -> Result<Decimal, String> {
    let value = decimal(words)?;
    if value.digits > 0 { Ok(value) } else { Err(format!("{what} must be positive")) }
}

/// Two decimals, the first below the second.
fn decimals(words: &mut Words) -> Result<Range<Decimal>, String> {
    let [lo, hi] = [decimal(words)?, decimal(words)?];
    if scaled(lo) < scaled(hi) { Ok([lo, hi]) } else { Err("a range's ends must increase".into()) }
}

/// 1 in units of 10⁻¹⁵.
const ONE: i128 = 10i128.pow(DIGITS as u32);

/// A decimal in units of 10⁻¹⁵, of at most 30 digits.
fn scaled(x: Decimal) -> i128 {
    i128::from(x.digits) * 10i128.pow(DIGITS as u32 - x.places)
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

fn fraction(words: &mut Words) -> Result<Fraction, String> {
    let read = |word: &str| {
        let (p, q) = word.split_once('/')?;
        let whole = |word| canonical(word).filter(|number| number.places == 0).map(|number| number.digits);
        let (p, q) = (whole(p)?, whole(q)?);
        (q > 0 && gcd(p.unsigned_abs().into(), q.unsigned_abs().into()) == 1).then_some(Fraction { p, q })
    };
    let value = read(words.word("a fraction p/q")?).filter(|x| x.enclosed().bits().is_some());
    value.ok_or_else(|| {
        format!(
            "expected a fraction p/q in lowest terms, of at most {DIGITS} digits each, between -2^15 and 2^15"
        )
    })
}

/// Two fractions, the first at most the second.
fn fractions(words: &mut Words) -> Result<Range<Fraction>, String> {
    let [lo, hi] = [fraction(words)?, fraction(words)?];
    let ordered = i128::from(lo.p) * i128::from(hi.q) <= i128::from(hi.p) * i128::from(lo.q);
    if ordered { Ok([lo, hi]) } else { Err("a range's ends must not decrease".into()) }
}

fn letter(words: &mut Words) -> Result<Letter, String> {
    let periods = words.number("the periods", PERIODS)?;
    let (after, before) = (decimals(words)?, decimals(words)?);
    let weights = [positive(words, "a weight")?, positive(words, "a weight")?];
    let growth = positive(words, "a growth vector's entry")?;
    let parts = words.number("the number of parts", PARTS)?;
    if periods == 0 || parts == 0 {
        return Err("periods and parts are at least 1".into());
    }
    Ok(Letter { periods, after, before, weights, growth, parts, next: Vec::new() })
}

fn harmonic(words: &mut Words) -> Result<Harmonic, String> {
    let order = words.number("the order of a harmonic", HARMONICS)?;
    if order == 0 {
        return Err("the order of a harmonic is at least 1".into());
    }
    Ok(Harmonic { order, parts: [fractions(words)?, fractions(words)?] })
}

/// Whether Σ a = 1 and Σ j b = 0 for some numbers of the ranges.
fn is_wall(harmonics: &[Harmonic]) -> Result<(), String> {
    // The sum p/q of the least numbers, or of the greatest, of all a (part 0) or all j b (part 1), less
    // `goal`; |p| is at most 2¹⁵·100·100 q.
    let sum = |part: usize, end: usize, goal: i128| {
        harmonics.iter().try_fold((-goal, 1i128), |(p, q), one| {
            let order = if part == 1 { i128::from(one.order) } else { 1 };
            let Fraction { p: r, q: s } = one.parts[part][end];
            let (r, s) = (i128::from(r), i128::from(s));
            let own = s / gcd(q.unsigned_abs(), s.unsigned_abs()) as i128;
            let common = q.checked_mul(own).filter(|&common| common <= DENOMINATOR)?;
            Some((p * own + r * (common / s) * order, common))
        })
    };
    for (part, goal) in [(0, 1), (1, 0)] {
        let (Some((least, _)), Some((greatest, _))) = (sum(part, 0, goal), sum(part, 1, goal)) else {
            return Err("the harmonics' fractions have no common denominator up to 10^30".into());
        };
        if least > 0 || greatest < 0 {
            return Err("the harmonics' cosines must sum to 1, their sines times their orders to 0".into());
        }
    }
    Ok(())
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
    if longest == 0 || parts == 0 || rounds == 0 {
        return Err("the longest leg, parts and rounds are at least 1".into());
    }
    Ok(Some(Complete { strength, longest, parts, rounds }))
}

/// Numbers from 1 to `count`, increasing, at least one; from 0 in the result.
fn successors(words: &mut Words, count: u64) -> Result<Vec<usize>, String> {
    let mut all: Vec<usize> = Vec::new();
    while all.is_empty() || words.clone().end().is_err() {
        let next = words.number("the number of a letter", count)? as usize;
        if next == 0 || all.last().is_some_and(|&last| next <= last + 1) {
            return Err("the numbers of letters begin at 1 and increase".into());
        }
        all.push(next - 1);
    }
    Ok(all)
}

/// Reads everything after the kind line of version 3, or of version 4, of mirrored walls.
pub(super) fn read(lines: &mut Lines, mirrored: bool) -> Result<Certificate, Rejection> {
    expect_statement(lines, if mirrored { STATEMENT_4 } else { STATEMENT_3 })?;
    let mut ranges = [[Fraction { p: 0, q: 1 }; 2]; 5];
    for (i, name) in RANGES.into_iter().enumerate() {
        ranges[i] = line(lines, name, fractions)?;
        let [lo, hi] = ranges[i];
        let (no, free) = (Fraction { p: 0, q: 1 }, |[lo, hi]: Range<Fraction>| lo.p == 0 && hi.p == 0);
        let problem = match name {
            "restitution" if lo.p <= 0 => Some("a restitution must be positive here"),
            "depth" if lo.p < 0 || hi.p <= 0 => Some("the depth must be at least 0, and somewhere positive"),
            "force" if mirrored && [lo, hi] != [no, no] => Some("with mirrored walls the force is 0/1 0/1"),
            "force" if [lo, hi] != [no, no] && !(free(ranges[0]) && free(ranges[1])) => {
                Some("a force other than 0/1 needs damping and stiffness 0/1: else move the origin")
            }
            "depth" if lo.p == 0 && !free(ranges[2]) => Some("with a force the depth must be positive"),
            _ => None,
        };
        if let Some(problem) = problem {
            return Err(lines.malformed(problem));
        }
    }
    let behind = line(lines, "side", |words| match words.word("a side")? {
        "1" => Ok(true),
        "-1" => Ok(false),
        _ => Err("a side is 1 or -1".into()),
    })?;
    let count = line(lines, "harmonics", |words| words.number("the number of harmonics", HARMONICS))?;
    let mut harmonics: Vec<Harmonic> = Vec::new();
    for _ in 0..count {
        let next = line(lines, "harmonic", harmonic)?;
        if harmonics.last().is_some_and(|last| last.order >= next.order) {
            return Err(lines.malformed("the orders of harmonics increase"));
        }
        harmonics.push(next);
    }
    is_wall(&harmonics).map_err(|reason| lines.malformed(reason))?;
    let cells = line(lines, "cells", |words| {
        let mut cells = [0; 5];
        for cell in &mut cells {
            *cell = words.number("a number of parts", CELLS)?;
        }
        Ok(cells)
    })?;
    let product = cells.iter().try_fold(1u64, |product, &cell| product.checked_mul(cell));
    if !product.is_some_and(|product| (1..=CELLS).contains(&product)) {
        return Err(lines.malformed(format!("there must be 1 to {CELLS} cells in all")));
    }
    let window = line(lines, "window", |words| positive(words, "a window"))?;
    let pieces = line(lines, "pieces", |words| words.number("a number of pieces", PIECES))?;
    if pieces == 0 {
        return Err(lines.malformed("there must be at least 1 piece"));
    }
    let count = line(lines, "letters", |words| words.number("the number of letters", LETTERS))?;
    if count == 0 {
        return Err(lines.malformed("there must be at least 1 letter"));
    }
    let mut letters = Vec::new();
    for _ in 0..count {
        letters.push(line(lines, "letter", letter)?);
    }
    for letter in &mut letters {
        letter.next = line(lines, "next", |words| successors(words, count))?;
    }
    let mut followed = vec![false; letters.len()];
    letters.iter().flat_map(|letter| &letter.next).for_each(|&n| followed[n] = true);
    if let Some(n) = followed.iter().position(|followed| !followed) {
        return Err(lines.malformed(format!("letter {} follows no letter, so that it is on no path", n + 1)));
    }
    let contraction = line(lines, "contraction", |words| positive(words, "a contraction"))?;
    if scaled(contraction) >= ONE {
        return Err(lines.malformed("a contraction must be below 1"));
    }
    let reach = line(lines, "reach", |words| positive(words, "the reach"))?;
    let growth = line(lines, "growth", decimals)?;
    if scaled(growth[0]) < ONE {
        return Err(lines.malformed("a growth rate is at least 1"));
    }
    let complete = line(lines, "complete", complete)?;
    if complete.is_some() && !(behind && ranges[2].iter().all(|force| force.p == 0)) {
        return Err(lines.malformed("completeness is for side 1 and force 0/1"));
    }
    let certificate = Certificate {
        mirrored,
        ranges,
        behind,
        harmonics,
        cells,
        window,
        pieces,
        letters,
        contraction,
        reach,
        growth,
        complete,
    };
    let cost = certificate.cost();
    if cost > COST {
        return Err(lines.malformed(format!(
            "the check would cost {cost} exponentials, more than {COST}: fewer cells, parts, pieces, letters, harmonics or rounds"
        )));
    }
    if lines.next()?.is_some() {
        return Err(lines.malformed("the file goes on after its last line"));
    }
    Ok(certificate)
}
