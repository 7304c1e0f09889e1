//! Certificates of kind `theorem2`: Theorem 2 on r = 1 for a range of periods.

use std::{fmt, ops::RangeInclusive};

use super::{
    Checked, Rejection,
    arithmetic::{self, Fraction, MOST, gcd, no_integer_between},
    header::{self, Header},
    lines::{Lines, Words},
};

/// The word in the header.
pub const KIND: &str = "theorem2";

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "For r = 1, every period n in the range and every s in (0, 1/2): if s lies in an open \
interval of an orbit line then u_n is not 0 and (52) and (53) hold exactly for the listed signs of e*mu and gamma; if s \
is a listed singular point then u_n = 0, if a listed boundary point then some b_{n,k} = 0 and no two b_{n,k} have \
opposite signs; at every other s two b_{n,k} have strictly opposite signs or u_n = 0. The orbit lines of each n are \
exactly the intervals of Theorem 2 (for n = 1 and 2, of the summary by period). Nothing is claimed for r < 1.";

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

/// The header's lines for a range of periods with `lines` lines after it.
pub fn header(range: &RangeInclusive<u64>, lines: u64) -> String {
    header::text(KIND, STATEMENT, range, lines)
}

/// The first line of the block of period `n` with `count` claims.
pub fn block_header(n: u64, count: usize) -> String {
    format!("n {n} {count}")
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
        let mut words = Words::new(line);
        let claim = match words.word("orbit, stretch or point")? {
            "orbit" => Claim::Orbit {
                left: words.fraction(2 * n)?,
                right: words.fraction(2 * n)?,
                emu: sign(&mut words)?,
                gamma: sign(&mut words)?,
            },
            "stretch" => {
                let (left, right) = (words.fraction(2 * n)?, words.fraction(2 * n)?);
                Claim::Stretch {
                    left,
                    right,
                    positive: index(&mut words, n)?,
                    negative: index(&mut words, n)?,
                }
            }
            "point" => {
                let at = words.fraction(2 * n)?;
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

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Checked, Rejection> {
    let header = Header::read(lines, 1..=MOST, STATEMENT)?;
    for n in header.range() {
        Block::new(n).check(lines)?;
    }
    header.finish(lines, KIND, STATEMENT)
}

/// The check of one period.
struct Block {
    n: u64,
    /// How far (0, ½) is tiled, and whether a point comes next.
    reached: Fraction,
    point_next: bool,
    theorem: Theorem,
}

impl Block {
    fn new(n: u64) -> Self {
        let zero = Fraction::new(0, 1).expect("0/1 is in lowest terms");
        Block { n, reached: zero, point_next: false, theorem: Theorem::new(n) }
    }

    fn check(mut self, lines: &mut Lines) -> Result<(), Rejection> {
        let [n, count] = header::numbers(lines, "n", ["the period", "the number of lines"], MOST)?;
        if n != self.n {
            return Err(lines.malformed(format!("expected the block of n = {}", self.n)));
        }
        for _ in 0..count {
            let line = lines.expect("a line of this block")?;
            let claim = Claim::parse(&line, n).map_err(|reason| lines.malformed(reason))?;
            self.place(claim).map_err(|reason| lines.false_claim(reason))?;
            self.prove(claim).map_err(|reason| lines.false_claim(reason))?;
        }
        if !(self.point_next && self.reached == Fraction::new(1, 2).expect("1/2 is in lowest terms")) {
            let reason = format!("the block of n = {n} ends at {} instead of 1/2", self.reached);
            return Err(lines.false_claim(reason));
        }
        if let Some((left, right, ..)) = self.theorem.next() {
            let reason = format!("Theorem 2's interval ({left}, {right}) is missing for n = {n}");
            return Err(lines.false_claim(reason));
        }
        Ok(())
    }

    /// Checks that the claim continues the tiling.
    fn place(&mut self, claim: Claim) -> Result<(), String> {
        let reached = self.reached;
        let follows = match claim {
            // For n = 1 the same interval comes twice.
            Claim::Orbit { left, right, .. } if self.n == 1 => {
                self.reached = right;
                self.point_next = true;
                left == Fraction::new(0, 1).expect("0/1 is in lowest terms") && left.less(right)
            }
            Claim::Orbit { left, right, .. } | Claim::Stretch { left, right, .. } => {
                let follows = !self.point_next && left == reached && left.less(right);
                self.reached = right;
                self.point_next = true;
                follows
            }
            Claim::Singular(at) | Claim::Boundary(at, _) | Claim::Excluded { at, .. } => {
                let follows = self.point_next && at == reached;
                self.point_next = false;
                follows
            }
        };
        if follows {
            return Ok(());
        }
        Err(format!(
            "the lines must tile (0, 1/2) by intervals and the points between them; reached {reached}"
        ))
    }

    /// Checks the claim itself.
    fn prove(&mut self, claim: Claim) -> Result<(), String> {
        let n = self.n;
        match claim {
            Claim::Orbit { left, right, emu, gamma } => {
                self.no_singularity(left, right)?;
                for k in 1..n {
                    if !no_integer_between(k, left, right) {
                        return Err(format!(
                            "sin {k} pi s, a factor of b_{{{n},{k}}}, has a zero in ({left}, {right})"
                        ));
                    }
                    if arithmetic::b_negative(n, k, left) == emu {
                        return Err(format!("b_{{{n},{k}}} has the wrong sign on ({left}, {right})"));
                    }
                }
                if (emu == gamma) == arithmetic::c_negative(n, left) {
                    return Err(format!("c_{n} has the wrong sign on ({left}, {right})"));
                }
                if self.theorem.next() != Some((left, right, emu, gamma)) {
                    return Err(format!(
                        "({left}, {right}) is not the next of Theorem 2's intervals for n = {n}"
                    ));
                }
                Ok(())
            }
            Claim::Stretch { left, right, positive, negative } => {
                self.no_singularity(left, right)?;
                for k in [positive, n - positive, negative, n - negative] {
                    if !no_integer_between(k, left, right) {
                        return Err(format!(
                            "a witness has a zero in ({left}, {right}), where sin {k} pi s = 0"
                        ));
                    }
                }
                opposite(n, positive, negative, left).map_err(|what| format!("{what} on ({left}, {right})"))
            }
            Claim::Singular(at) if at.times_is_integer(2 * n) => Ok(()),
            Claim::Singular(at) => {
                Err(format!("u_{n} is not 0 at {at}, which is no multiple of 1/{}", 2 * n))
            }
            Claim::Boundary(at, k) => {
                self.not_singular(at)?;
                if !self.zero(at, k) {
                    return Err(format!("b_{{{n},{k}}} is not 0 at {at}"));
                }
                let mut others =
                    (1..n).filter(|&k| !self.zero(at, k)).map(|k| arithmetic::b_negative(n, k, at));
                let first = others.next();
                if others.any(|sign| Some(sign) != first) {
                    return Err(format!("two b of strictly opposite sign at {at}: excluded, not a boundary"));
                }
                Ok(())
            }
            Claim::Excluded { at, positive, negative } => {
                self.not_singular(at)?;
                if let Some(k) = [positive, negative].into_iter().find(|&k| self.zero(at, k)) {
                    return Err(format!("b_{{{n},{k}}} = 0 at {at}"));
                }
                opposite(n, positive, negative, at).map_err(|what| format!("{what} at {at}"))
            }
        }
    }

    /// Whether b_{n,k} = 0 at a point that is not singular.
    fn zero(&self, at: Fraction, k: u64) -> bool {
        at.times_is_integer(k) || at.times_is_integer(self.n - k)
    }

    fn not_singular(&self, at: Fraction) -> Result<(), String> {
        if at.times_is_integer(2 * self.n) {
            return Err(format!("u_{} = 0 at {at}: singular", self.n));
        }
        Ok(())
    }

    /// Checks that no multiple of 1/(2n) lies inside: no pole, and u_n ≠ 0.
    fn no_singularity(&self, left: Fraction, right: Fraction) -> Result<(), String> {
        if no_integer_between(2 * self.n, left, right) {
            return Ok(());
        }
        Err(format!("u_{} = 0 at a multiple of 1/{} inside ({left}, {right})", self.n, 2 * self.n))
    }
}

/// Checks that b_{n,positive} > 0 > b_{n,negative} right of a point, neither having a zero or pole there.
fn opposite(n: u64, positive: u64, negative: u64, at: Fraction) -> Result<(), String> {
    if arithmetic::b_negative(n, positive, at) {
        return Err(format!("b_{{{n},{positive}}} is not > 0"));
    }
    if !arithmetic::b_negative(n, negative, at) {
        return Err(format!("b_{{{n},{negative}}} is not < 0"));
    }
    Ok(())
}

/// An interval of Theorem 2: left end, right end, eµ > 0, γ > 0.
pub(super) type Listed = (Fraction, Fraction, bool, bool);

/// Theorem 2's intervals for one n, from left to right.
pub(super) struct Theorem {
    n: u64,
    /// The next m to take.
    m: u64,
    /// The second interval of the latest m, if it has one.
    second: Option<Listed>,
}

impl Theorem {
    pub fn new(n: u64) -> Self {
        Theorem { n, m: 0, second: None }
    }

    pub fn next(&mut self) -> Option<Listed> {
        if let Some(interval) = self.second.take() {
            return Some(interval);
        }
        let (n, m) = (self.n, self.m);
        self.m = (m + 1..=n).find(|&next| gcd(next, n) == 1).unwrap_or(n);
        if m == 0 {
            let (zero, end) = (Fraction::new(0, 1)?, Fraction::new(1, 2 * n)?);
            if n == 1 {
                self.second = Some((zero, end, false, true));
            }
            return Some((zero, end, n == 1, n != 1));
        }
        if 2 * m > n {
            return None;
        }
        let n_plus = arithmetic::inverse(m, n);
        let m_plus = (m * n_plus - 1) / n;
        let at = Fraction::new(m, n)?;
        if 2 * m < n {
            self.second = Some((at, Fraction::new(m - m_plus, n - n_plus)?, true, false));
        }
        let left = if m == 1 { Fraction::new(1, 2 * n)? } else { Fraction::new(m_plus, n_plus)? };
        Some((left, at, true, true))
    }
}
