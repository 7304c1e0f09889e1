//! The lines of a block as claims, and their text.

use std::fmt;

use super::super::{arithmetic::Fraction, lines::Words};

/// One line of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Claim {
    /// (52), (53) hold on the open interval in this case.
    Orbit {
        /// The left end.
        left: Fraction,
        /// The right end.
        right: Fraction,
        /// Whether eµ > 0.
        emu: bool,
        /// Whether γ > 0.
        gamma: bool,
    },
    /// b_{n,positive} > 0 > b_{n,negative} on the open interval.
    Stretch {
        /// The left end.
        left: Fraction,
        /// The right end.
        right: Fraction,
        /// A k with b_{n,k} > 0.
        positive: u64,
        /// A k with b_{n,k} < 0.
        negative: u64,
    },
    /// u_n = 0 at the point.
    Singular(Fraction),
    /// b_{n,k} = 0 at the point, and no two b have opposite signs.
    Boundary(Fraction, u64),
    /// b_{n,positive} > 0 > b_{n,negative} at the point.
    Excluded {
        /// The point.
        at: Fraction,
        /// A k with b_{n,k} > 0.
        positive: u64,
        /// A k with b_{n,k} < 0.
        negative: u64,
    },
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = |positive: bool| if positive { '+' } else { '-' };
        match self {
            Claim::Orbit { left, right, emu, gamma } => {
                write!(f, "orbit {left} {right} {} {}", sign(*emu), sign(*gamma))
            }
            Claim::Stretch { left, right, positive, negative } => {
                write!(f, "stretch {left} {right} {positive} {negative}")
            }
            Claim::Singular(at) => write!(f, "point {at} singular"),
            Claim::Boundary(at, k) => write!(f, "point {at} boundary {k}"),
            Claim::Excluded { at, positive, negative } => {
                write!(f, "point {at} excluded {positive} {negative}")
            }
        }
    }
}

impl Claim {
    /// Reads a line of the block of period `n`.
    ///
    /// # Errors
    /// What was expected.
    pub fn parse(line: &str, n: u64) -> Result<Self, String> {
        Claim::parse_from(line, n, Fraction::ZERO)
    }

    /// The same, of a line that should begin at a fraction.
    pub(super) fn parse_from(line: &str, n: u64, begin: Fraction) -> Result<Self, String> {
        let mut words = Words::new(line);
        let claim = match words.word("orbit, stretch or point")? {
            "orbit" => Claim::Orbit {
                left: words.fraction_again(2 * n, begin)?,
                right: words.fraction(2 * n)?,
                emu: sign(&mut words)?,
                gamma: sign(&mut words)?,
            },
            "stretch" => {
                let (left, right) = (words.fraction_again(2 * n, begin)?, words.fraction(2 * n)?);
                Claim::Stretch {
                    left,
                    right,
                    positive: index(&mut words, n)?,
                    negative: index(&mut words, n)?,
                }
            }
            "point" => {
                let at = words.fraction_again(2 * n, begin)?;
                match words.word("singular, boundary or excluded")? {
                    "singular" => Claim::Singular(at),
                    "boundary" => Claim::Boundary(at, index(&mut words, n)?),
                    "excluded" => Claim::Excluded {
                        at,
                        positive: index(&mut words, n)?,
                        negative: index(&mut words, n)?,
                    },
                    _ => return Err("expected singular, boundary or excluded".into()),
                }
            }
            _ => return Err("expected orbit, stretch or point".into()),
        };
        words.end()?;
        Ok(claim)
    }
}

fn sign(words: &mut Words) -> Result<bool, String> {
    match words.word("+ or -")? {
        "+" => Ok(true),
        "-" => Ok(false),
        _ => Err("expected + or -".into()),
    }
}

/// A k with 1 ≤ k ≤ n−1.
fn index(words: &mut Words, n: u64) -> Result<u64, String> {
    match words.number("k", n - 1)? {
        0 => Err(format!("expected k from 1 to {}", n - 1)),
        k => Ok(k),
    }
}
