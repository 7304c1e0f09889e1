//! The box and the statement, as they are written.

use std::fmt;

use super::MOST;
use crate::{
    decimal::Fraction,
    lines::{Words, number},
    rejection::ensure,
    touch::text::{Range, fractions, plain},
};

/// What the two parameters are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coordinates {
    /// w and z.
    Machine,
    /// r and s.
    Polar,
    /// a₁ and a₂.
    Plane,
}

/// A box of them.
#[derive(Debug)]
pub(super) struct Area {
    pub coordinates: Coordinates,
    pub ends: [Range<Fraction>; 2],
}

impl Area {
    pub fn read(words: &mut Words) -> Result<Area, String> {
        let coordinates = match words.word("machine, polar or plane")? {
            "machine" => Coordinates::Machine,
            "polar" => Coordinates::Polar,
            "plane" => Coordinates::Plane,
            _ => return Err("expected machine, polar or plane".into()),
        };
        let ends = [fractions(words)?, fractions(words)?];
        let [[first, first_last], [second, second_last]] = ends;
        let up_to = |x: Fraction, most: i128| x.p <= most * x.q;
        let (holds, rule) = match coordinates {
            Coordinates::Machine => (
                first.p > 0 && second.p >= 0 && up_to(first_last, 1000) && up_to(second_last, 1000),
                "0 < w <= 1000 and 0 <= z <= 1000",
            ),
            Coordinates::Polar => (
                first.p > 0 && second.p > 0 && up_to(first_last, 1) && 2 * second_last.p < second_last.q,
                "0 < r <= 1 and 0 < s < 1/2",
            ),
            Coordinates::Plane => (second.p > 0 && up_to(second_last, 1), "0 < a2 <= 1"),
        };
        ensure(holds, format_args!("the box must have {rule}"))?;
        Ok(Area { coordinates, ends })
    }
}

impl fmt::Display for Area {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = match self.coordinates {
            Coordinates::Machine => ["natural over drive frequency", "damping ratio"],
            Coordinates::Polar => ["r", "s"],
            Coordinates::Plane => ["a1", "a2"],
        };
        let range = |i: usize| {
            let [lo, hi] = self.ends[i].map(plain);
            format!("{} from {lo} to {hi}", names[i])
        };
        write!(f, "{}, {}", range(0), range(1))
    }
}

/// What may hold at a point.
#[derive(Debug)]
pub(super) enum Claim {
    /// For a sign of eµ period n occurs.
    Period { positive: bool, n: u64 },
    /// These letters, `true` for U, and no others; of period n the n-th.
    Word { positive: bool, letters: Vec<Option<bool>> },
    /// Two periods occur with one letter; γ > 0 if it is free.
    Chaos { positive: bool, gamma: Option<bool> },
}

fn sign(words: &mut Words, of: &str) -> Result<bool, String> {
    match words.word(of)? {
        "+" => Ok(true),
        "-" => Ok(false),
        _ => Err(format!("expected the sign of {of}, + or -")),
    }
}

fn period(words: &mut Words) -> Result<u64, String> {
    let n = words.number("a period", MOST)?;
    ensure(n > 0, "a period is at least 1")?;
    Ok(n)
}

impl Claim {
    pub fn read(words: &mut Words, area: &Area) -> Result<Claim, String> {
        let kind = words.word("period, word or chaos")?;
        let positive = sign(words, "e mu")?;
        match kind {
            "period" => Ok(Claim::Period { positive, n: period(words)? }),
            "word" => {
                let mut letters = vec![None; period(words)? as usize];
                let mut last = 0;
                // Words are taken to the end of the line.
                while words.clone().end().is_err() {
                    let word = words.word("a period and its letter")?;
                    let upper = word.ends_with('U');
                    let n = word.strip_suffix(['U', 'D']).and_then(|n| number(n, letters.len() as u64));
                    let n = n.filter(|&n| n > last).ok_or("expected a later period and its letter")?;
                    letters[n as usize - 1] = Some(upper);
                    last = n;
                }
                Ok(Claim::Word { positive, letters })
            }
            "chaos" if area.coordinates == Coordinates::Machine => Ok(Claim::Chaos { positive, gamma: None }),
            "chaos" => Ok(Claim::Chaos { positive, gamma: Some(sign(words, "gamma")?) }),
            _ => Err("expected period, word or chaos".into()),
        }
    }

    /// What the second share rests on besides.
    pub fn condition(&self) -> &'static str {
        match self {
            Claim::Chaos { .. } => "; the second by the word theorem",
            _ => "",
        }
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = |positive: &bool| if *positive { "> 0" } else { "< 0" };
        match self {
            Claim::Period { positive, n } => write!(f, "period {n} occurs for e mu {}", side(positive)),
            Claim::Word { positive, letters } => {
                write!(f, "of the periods 1 to {} for e mu {} occur", letters.len(), side(positive))?;
                let listed = (1..).zip(letters).filter_map(|(n, letter)| Some((n, (*letter)?)));
                let listed: Vec<String> =
                    listed.map(|(n, upper)| format!(" {n}{}", if upper { 'U' } else { 'D' })).collect();
                write!(f, "{}", if listed.is_empty() { " none".into() } else { listed.concat() })
            }
            Claim::Chaos { positive, gamma } => {
                write!(f, "chaos is born for e mu {}", side(positive))?;
                gamma.map_or(Ok(()), |gamma| write!(f, ", gamma {}", side(&gamma)))
            }
        }
    }
}
