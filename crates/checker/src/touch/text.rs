//! What certificates about an oscillator near a touch have in common, as read: numbers, ranges, the wall's
//! harmonics, lists of letters.

use crate::{
    Rejection,
    decimal::gcd,
    lines::{Lines, Words},
    rejection::ensure,
};

pub use crate::decimal::{Decimal, Fraction};

/// The longest numerator, denominator or decimal, in digits: below 2⁵⁰.
const DIGITS: usize = 15;
/// The longest line: `next` with all letters.
const LONGEST: usize = 2000;
/// The most harmonics of a wall, and the highest.
const HARMONICS: u64 = 100;
/// The greatest common denominator of the ends of harmonics' ranges.
const DENOMINATOR: i128 = 10i128.pow(30);

/// The numbers from the first to the second.
pub type Range<T> = [T; 2];

/// A term a cos jt + b sin jt of the wall.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Harmonic {
    /// j ≥ 1.
    pub order: u64,
    /// The ranges of a and b.
    pub parts: [Range<Fraction>; 2],
}

/// The next line, led by its name and read by `parse` to its end.
pub(crate) fn line<T>(
    lines: &mut Lines,
    name: &str,
    parse: impl FnOnce(&mut Words) -> Result<T, String>,
) -> Result<T, Rejection> {
    lines.line_within(LONGEST, name, parse)
}

/// A line with a number from 1.
pub(crate) fn count(lines: &mut Lines, name: &str, what: &str, most: u64) -> Result<u64, Rejection> {
    let value = line(lines, name, |words| words.number(what, most))?;
    lines.form(value > 0, format_args!("{what} is at least 1"))?;
    Ok(value)
}

pub(crate) fn decimal(words: &mut Words) -> Result<Decimal, String> {
    Decimal::read::<48>(words, DIGITS)
}

pub(crate) fn fraction(words: &mut Words) -> Result<Fraction, String> {
    Fraction::read::<48>(words, DIGITS)
}

pub(crate) fn positive(words: &mut Words, what: &str) -> Result<Decimal, String> {
    let value = decimal(words)?;
    if value.digits > 0 { Ok(value) } else { Err(format!("{what} must be positive")) }
}

/// Two decimals, the first below the second.
pub(crate) fn decimals(words: &mut Words) -> Result<Range<Decimal>, String> {
    let [lo, hi] = [decimal(words)?, decimal(words)?];
    if lo.parts() < hi.parts() { Ok([lo, hi]) } else { Err("a range's ends must increase".into()) }
}

/// Two fractions, the first at most the second.
pub(crate) fn fractions(words: &mut Words) -> Result<Range<Fraction>, String> {
    let [lo, hi] = [fraction(words)?, fraction(words)?];
    if lo.p * hi.q <= hi.p * lo.q { Ok([lo, hi]) } else { Err("a range's ends must not decrease".into()) }
}

fn harmonic(words: &mut Words) -> Result<Harmonic, String> {
    let order = words.number("the order of a harmonic", HARMONICS)?;
    ensure(order > 0, "the order of a harmonic is at least 1")?;
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
            let own = s / gcd(q.unsigned_abs(), s.unsigned_abs()) as i128;
            let common = q.checked_mul(own).filter(|&common| common <= DENOMINATOR)?;
            Some((p * own + r * (common / s) * order, common))
        })
    };
    for (part, goal) in [(0, 1), (1, 0)] {
        let (Some((least, _)), Some((greatest, _))) = (sum(part, 0, goal), sum(part, 1, goal)) else {
            return Err("the harmonics' fractions have no common denominator up to 10^30".into());
        };
        let holds = least <= 0 && greatest >= 0;
        ensure(holds, "the harmonics' cosines must sum to 1, their sines times their orders to 0")?;
    }
    Ok(())
}

/// The wall's harmonics.
pub(crate) fn read_harmonics(lines: &mut Lines) -> Result<Vec<Harmonic>, Rejection> {
    let count = line(lines, "harmonics", |words| words.number("the number of harmonics", HARMONICS))?;
    let mut harmonics: Vec<Harmonic> = Vec::new();
    for _ in 0..count {
        let next = line(lines, "harmonic", harmonic)?;
        let increases = harmonics.last().is_none_or(|last| last.order < next.order);
        lines.form(increases, "the orders of harmonics increase")?;
        harmonics.push(next);
    }
    is_wall(&harmonics).map_err(|reason| lines.malformed(reason))?;
    Ok(harmonics)
}

/// Numbers from 1 to `count`, increasing, at least one; from 0 in the result.
pub(crate) fn successors(words: &mut Words, count: u64) -> Result<Vec<usize>, String> {
    let mut all: Vec<usize> = Vec::new();
    while all.is_empty() || words.clone().end().is_err() {
        let next = words.number("the number of a letter", count)? as usize;
        let holds = next > 0 && all.last().is_none_or(|&last| next > last + 1);
        ensure(holds, "the numbers of letters begin at 1 and increase")?;
        all.push(next - 1);
    }
    Ok(all)
}

/// σ = 1 or −1; whether it is 1.
pub(crate) fn side(words: &mut Words) -> Result<bool, String> {
    match words.word("a side")? {
        "1" => Ok(true),
        "-1" => Ok(false),
        _ => Err("a side is 1 or -1".into()),
    }
}

/// g(t), or its name where its harmonics are not those of a cosine.
pub(crate) fn wall_in_words(harmonics: &[Harmonic]) -> String {
    let one = |x: Fraction| x.p == 1 && x.q == 1;
    match harmonics {
        [only] if only.order == 1 && only.parts[0].into_iter().all(one) => "cos t".into(),
        all => {
            let orders: Vec<String> = all.iter().map(|term| term.order.to_string()).collect();
            format!("g(t), of harmonics {} as the lines harmonic say", orders.join(", "))
        }
    }
}

/// p/q, or p if q is 1.
pub(crate) fn plain(x: Fraction) -> String {
    if x.q == 1 { x.p.to_string() } else { x.to_string() }
}

/// When impacts are, in words.
pub(crate) fn window(within: Decimal, mirrored: bool) -> String {
    match mirrored {
        false => format!("impacts within {within} of multiples of 2 pi"),
        true => format!(
            "impacts within {within} of multiples of pi, at the lower wall of even and at the upper wall of odd ones"
        ),
    }
}
