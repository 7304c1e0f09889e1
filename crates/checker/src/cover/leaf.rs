//! The claims at the leaves of a tree: their text, and their proof on a box.

use std::fmt;

use super::expansion::{Expansion, Patch};
use crate::rejection::ensure;

/// What is claimed of the closed box of a leaf, up to the factor 1/r^{k−1} > 0 and, in the sine form, sin θ >
/// 0: T_{n,k} for N_{n,k}.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Leaf {
    /// N_{n,positive} > 0 > N_{n,negative}: no orbit.
    None {
        /// A k with N_{n,k} > 0.
        positive: u64,
        /// A k with N_{n,k} < 0.
        negative: u64,
    },
    /// Every N_{n,k} has the strict sign.
    Orbit {
        /// Whether it is > 0.
        positive: bool,
    },
    /// All N_{n,k} have the strict sign t where t N_{n,deciding} > 0, and where it is not, some other has; t
    /// N_{n,deciding}, divided as above, grows with r.
    Edge {
        /// Whether t = 1.
        positive: bool,
        /// The index that decides.
        deciding: u64,
        /// Whether t N_{n,deciding}, divided as above, falls (−1) or grows (1) with s; 0: nothing is claimed.
        across: i8,
    },
    /// Nothing.
    Open,
}

impl fmt::Display for Leaf {
    /// The token in a certificate, but for the abbreviation `n`: `N3,1;`, `P;`, `m5;`, `m5l;`, `O;`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Leaf::None { positive, negative } => write!(f, "N{positive},{negative};"),
            Leaf::Orbit { positive } => f.write_str(if positive { "P;" } else { "M;" }),
            Leaf::Edge { positive, deciding, across } => {
                let kind = if positive { 'p' } else { 'm' };
                let across = match across {
                    0 => "",
                    1.. => "r",
                    _ => "l",
                };
                write!(f, "{kind}{deciding}{across};")
            }
            Leaf::Open => f.write_str("O;"),
        }
    }
}

impl Leaf {
    /// Reads the leaf that `text` begins with, for period `n`, and what follows it. `latest` is the None leaf
    /// before it in its strip's text, if there is one, which the token `n` repeats; it is brought up to date.
    ///
    /// # Errors
    /// What was expected.
    pub fn read<'a>(text: &'a str, n: u64, latest: &mut Option<Leaf>) -> Result<(Self, &'a str), String> {
        if let Some(after) = text.strip_prefix('n') {
            return latest.map(|leaf| (leaf, after)).ok_or_else(|| "n without an N before it".into());
        }
        let (token, after) = text.split_once(';').ok_or("expected r, s, n or a leaf that ends in ;")?;
        let leaf = Leaf::parse(token, n)?;
        if matches!(leaf, Leaf::None { .. }) {
            *latest = Some(leaf);
        }
        Ok((leaf, after))
    }

    /// Appends what [`read`](Self::read) reads.
    pub fn write(&self, text: &mut String, latest: &mut Option<Leaf>) {
        if *latest == Some(*self) {
            text.push('n');
            return;
        }
        if matches!(self, Leaf::None { .. }) {
            *latest = Some(*self);
        }
        *text += &self.to_string();
    }

    /// Reads a token without its semicolon, for period `n`.
    ///
    /// # Errors
    /// What was expected.
    pub fn parse(token: &str, n: u64) -> Result<Self, String> {
        let index = |digits: &str| {
            super::number(digits, n - 1)
                .filter(|&k| k > 0)
                .ok_or_else(|| format!("expected k from 1 to {} in {token:?}", n - 1))
        };
        match token.split_at_checked(1) {
            Some(("N", rest)) => {
                let (positive, negative) =
                    rest.split_once(',').ok_or_else(|| format!("expected two k in {token:?}"))?;
                Ok(Leaf::None { positive: index(positive)?, negative: index(negative)? })
            }
            Some((sign @ ("P" | "M"), "")) => Ok(Leaf::Orbit { positive: sign == "P" }),
            Some((sign @ ("p" | "m"), rest)) => {
                let digits = rest.trim_end_matches(|c: char| c.is_ascii_lowercase());
                let across = match &rest[digits.len()..] {
                    "" => 0,
                    "l" => -1,
                    "r" => 1,
                    _ => return Err(format!("expected nothing, l or r after the k of {token:?}")),
                };
                Ok(Leaf::Edge { positive: sign == "p", deciding: index(digits)?, across })
            }
            Some(("O", "")) => Ok(Leaf::Open),
            _ => Err(format!("expected a leaf, found {token:?}")),
        }
    }

    /// Proves the claim on a box. Cost: O(1) products for `None`, O(n) for `Orbit` and `Edge`.
    pub(super) fn prove(&self, patch: &Patch) -> Result<(), String> {
        let (n, slack) = (patch.n(), patch.slack);
        let sign = |positive| if positive { 1 } else { -1 };
        match *self {
            Leaf::Open => Ok(()),
            Leaf::None { positive, negative } => {
                for (k, t, relation) in [(positive, 1, '>'), (negative, -1, '<')] {
                    ensure(patch.shows(k, t), format_args!("N_{{{n},{k}}} {relation} 0 is not shown"))?;
                }
                Ok(())
            }
            Leaf::Orbit { positive } => {
                let t = sign(positive);
                match patch.terms().position(|term| !term.shows(t)) {
                    Some(at) => Err(format!("the sign of N_{{{n},{}}} is not shown", at + 1)),
                    None => Ok(()),
                }
            }
            Leaf::Edge { positive, deciding, across } => {
                let t = sign(positive);
                let decider = patch.expansion(deciding);
                let mut alone = false;
                for (k, term) in (1..n).zip(patch.terms()).filter(|&(k, _)| k != deciding) {
                    if term.shows(t) {
                        alone = true;
                    } else if !term.expansion().shows_beyond(&decider, t, slack) {
                        return Err(format!(
                            "that N_{{{n},{deciding}}} decides over N_{{{n},{k}}} is not shown"
                        ));
                    }
                }
                ensure(alone, "no N has the sign on the whole box")?;
                grows(&decider, t, slack, across)
            }
        }
    }
}

fn grows(decider: &Expansion, t: i64, slack: i64, across: i8) -> Result<(), String> {
    let [up, right] = decider.slopes(slack).map(|slope| t * slope);
    ensure(up == 1, "that the deciding N grows with r is not shown")?;
    ensure(across == 0 || right == i64::from(across), "how the deciding N depends on s is not shown")
}
