//! Certificates of kind `theorem2`: Theorem 2 on r = 1 for a range of periods.
//!
//! # What is proved, and how
//!
//! On r = 1 the eigenvalues are e^{±iθ}, θ = 2πs, 0 < s < ½, and u_k = sin kθ/sin θ. For a period n and 1 ≤ k
//! ≤ n−1,
//!
//! ```text
//! b_{n,k} = (u_n − u_k − u_{n−k})/u_n = −2 sin kπs sin (n−k)πs / cos nπs                         (B1)
//! c_n = −(2 − 2 cos nθ)/u_n = −2 sin 2πs tan nπs                                                 (B2)
//! an orbit of period n exists in the case (EMU, GAMMA) if u_n ≠ 0 and
//!     EMU b_{n,k} > 0 for all k = 1, …, n−1                                                      (52)
//!     EMU GAMMA c_n > 0                                                                          (53)
//! ```
//!
//! where EMU and GAMMA, the signs of eµ and γ, are + or −. u_n = 0 exactly where 2ns is an integer. At s =
//! p/q and just right of it, sin jπs has the sign (−1)^⌊jp/q⌋, but at s itself it is 0 if q divides jp; on an
//! open interval it has a zero exactly if an integer lies strictly between j times its ends. cos nπs is sin
//! (ns + ½)π. So every sign is decided by integers, at the left end of an interval without zeros.
//!
//! Whether all b have one sign is counted. ⌊ns⌋ − ⌊ks⌋ − ⌊(n−k)s⌋ is 0 or 1. Where it is 0, b_{n,k} has the
//! sign of c_n, else the other one; so all have one sign where it is 0 for every k, or 1. Its sum over k,
//! (n−1)⌊ns⌋ − 2 Σ ⌊ks⌋, is 0 then, or n − 1.
//!
//! Theorem 2 lists for n ≥ 2, from left to right,
//!
//! ```text
//! (0, 1/(2n))                              in the case (−,+); then for m = 1, 2, … ≤ n/2 without a common
//!                                          factor with n
//! (m₊/n₊, m/n)                             in the case (+,+), but for m = 1 from 1/(2n) on
//! (m/n, (m − m₊)/(n − n₊))                 in the case (+,−), if 2m < n
//! ```
//!
//! with 1 ≤ n₊ ≤ n, m n₊ ≡ 1 modulo n and m₊ = (m n₊ − 1)/n. For n = 1 the summary by period lists (0, 1/2)
//! twice, in the cases (+,−) and (−,+).
//!
//! # Form
//!
//! ```text
//! range A B                                after the kind line: the periods, 1 ≤ A ≤ B ≤ 200000
//! lines L                                  the number of lines after the header
//! statement …                              what passing proves, word for word: STATEMENT
//! n N COUNT                                for each period in turn, with the number of lines in its block,
//!                                          at most 10^7
//! orbit P/Q P/Q EMU GAMMA                  (52), (53) hold on the open interval in the case (EMU, GAMMA),
//!                                          each + or -
//! stretch P/Q P/Q K K'                     b_{n,K} > 0 > b_{n,K'} and u_n ≠ 0 on the open interval: no orbit
//! point P/Q singular                       u_n = 0: Theorem 1 is silent
//! point P/Q boundary K                     u_n ≠ 0, b_{n,K} = 0 and no two b of opposite sign: Theorem 1 is
//!                                          silent
//! point P/Q excluded K K'                  u_n ≠ 0 and b_{n,K} > 0 > b_{n,K'} there: no orbit
//! ```
//!
//! Fractions have 0 ≤ P ≤ Q ≤ 2n, the K lie in 1, …, n−1. The lines of a block tile (0, ½) from left to
//! right, alternately an open interval and the point that ends it; the last is an interval that ends at 1/2,
//! which is no point of (0, ½). The `orbit` lines must be all intervals of Theorem 2, in order. On an
//! interval no b that is spoken of, for an orbit line no b at all, and not u_n may have a zero or a pole
//! inside. For n = 1 the block is exactly `orbit 0/1 1/2 + -` and `orbit 0/1 1/2 - +`.
//!
//! # A block by hand
//!
//! Period 4 has b_{4,k}(s) = −2 sin kπs sin (4−k)πs / cos 4πs and c_4(s) = −2 sin 2πs tan 4πs:
//!
//! ```text
//! n 4 9
//! orbit 0/1 1/8 - +       cos 4πs > 0, all sines > 0: every b < 0, c < 0
//! point 1/8 singular      2·4·(1/8) is an integer, so u_4 = 0
//! orbit 1/8 1/4 + +       cos 4πs < 0, sines still > 0: every b > 0, and c > 0
//! point 1/4 singular
//! orbit 1/4 1/3 + -       the same b; sin 4πs is now < 0, so c < 0
//! point 1/3 boundary 3    sin 3πs = 0, so b_{4,3} = b_{4,1} = 0
//! stretch 1/3 3/8 2 1     sin 3πs < 0 turns b_{4,1} < 0, while b_{4,2} > 0
//! point 3/8 singular
//! stretch 3/8 1/2 1 2     cos 4πs > 0 turns both
//! ```
//!
//! Theorem 2 lists for n = 4, m = 1, the neighbours 0/1 and 1/3 of 1/4: (−,+) on (0, 1/8), (+,+) on (1/8,
//! 1/4), (+,−) on (1/4, 1/3): the three `orbit` lines. Were the line `stretch 1/3 3/8 2 1` to read
//! `stretch 1/3 3/8 1 2`, the checker would answer: `line 13: false: b_{4,1} is not > 0 on (1/3, 3/8)`.
//!
//! # Cost
//!
//! O(1) per line, O(log n) for an `orbit` or `boundary` line, of which a true block has about n; O(n) for the
//! one `orbit` line whose ends are no neighbours, and for one that is false. Memory: one line. What long
//! blocks take is measured in docs/trust.md.

mod claim;
mod intervals;

use std::ops::RangeInclusive;

use super::{
    Proved, Rejection,
    arithmetic::{Fraction, MOST, Multiple, Signs, carries},
    header::{self, Header},
    lines::{LONGEST, Lines},
};
use crate::rejection::ensure;

pub use claim::Claim;
pub(super) use intervals::Theorem;

/// The word in the header.
pub const KIND: &str = "theorem2";

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "For r = 1, every period n in the range and every s in (0, 1/2): if s lies in an open \
interval of an orbit line then u_n is not 0 and (52) and (53) hold exactly for the listed signs of e*mu and gamma; if s \
is a listed singular point then u_n = 0, if a listed boundary point then some b_{n,k} = 0 and no two b_{n,k} have \
opposite signs; at every other s two b_{n,k} have strictly opposite signs or u_n = 0. The orbit lines of each n are \
exactly the intervals of Theorem 2 (for n = 1 and 2, of the summary by period). Nothing is claimed for r < 1.";

/// The header's lines for a range of periods with `lines` lines after it.
pub fn header(range: &RangeInclusive<u64>, lines: u64) -> String {
    header::text(KIND, STATEMENT, range, lines)
}

/// The first line of the block of period `n` with `count` claims.
pub fn block_header(n: u64, count: usize) -> String {
    format!("n {n} {count}")
}

/// The most lines of a block.
const COUNT: u64 = 10_000_000;

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let header = Header::read(lines, 1..=MOST, STATEMENT)?;
    for n in header.range() {
        Block::new(n).check(lines)?;
    }
    header.finish(lines)
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
        Block { n, reached: Fraction::ZERO, point_next: false, theorem: Theorem::new(n) }
    }

    fn check(mut self, lines: &mut Lines) -> Result<(), Rejection> {
        let [n, count] = header::numbers(lines, "n", [("the period", MOST), ("the number of lines", COUNT)])?;
        lines.form(n == self.n, format_args!("expected the block of n = {}", self.n))?;
        for _ in 0..count {
            let parse = |line: &str| Claim::parse_from(line, n, self.reached);
            let claim = lines.parsed(LONGEST, "a line of this block", parse)?;
            self.place(claim).map_err(|reason| lines.false_claim(reason))?;
            self.prove(claim).map_err(|reason| lines.false_claim(reason))?;
        }
        if !(self.point_next && self.reached == Fraction::HALF) {
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
            // For n = 1 the same interval comes twice, which the list of Theorem 2's intervals sees to, and
            // nothing else.
            Claim::Orbit { left, right, .. } if self.n == 1 => {
                left == Fraction::ZERO && right == Fraction::HALF
            }
            _ if self.n == 1 => return Err("the block of n = 1 is two orbit lines".into()),
            Claim::Orbit { left, right, .. } | Claim::Stretch { left, right, .. } => {
                !self.point_next && left == reached && left.less(right) && !Fraction::HALF.less(right)
            }
            Claim::Singular(at) | Claim::Boundary(at, _) | Claim::Excluded { at, .. } => {
                self.point_next && at == reached && at.less(Fraction::HALF)
            }
        };
        ensure(
            follows,
            format_args!(
                "the lines must tile (0, 1/2) by intervals and the points between them; reached {reached}"
            ),
        )?;
        match claim {
            Claim::Orbit { right, .. } | Claim::Stretch { right, .. } => {
                (self.reached, self.point_next) = (right, true);
            }
            _ => self.point_next = false,
        }
        Ok(())
    }

    /// Checks the claim itself.
    fn prove(&mut self, claim: Claim) -> Result<(), String> {
        let n = self.n;
        match claim {
            Claim::Orbit { left, right, emu, gamma } => {
                self.orbit(left, right, emu, gamma)?;
                let holds = self.theorem.next() == Some((left, right, emu, gamma));
                ensure(
                    holds,
                    format_args!("({left}, {right}) is not the next of Theorem 2's intervals for n = {n}"),
                )
            }
            Claim::Stretch { left, right, positive, negative } => {
                self.no_singularity(left, right)?;
                for k in [positive, n - positive, negative, n - negative] {
                    let holds = Multiple::of(left, k).no_integer_before(right);
                    ensure(
                        holds,
                        format_args!("a witness has a zero in ({left}, {right}), where sin {k} pi s = 0"),
                    )?;
                }
                opposite(n, positive, negative, left).map_err(|what| format!("{what} on ({left}, {right})"))
            }
            Claim::Singular(at) if at.times_is_integer(2 * n) => Ok(()),
            Claim::Singular(at) => {
                Err(format!("u_{n} is not 0 at {at}, which is no multiple of 1/{}", 2 * n))
            }
            Claim::Boundary(at, k) => self.boundary(at, k),
            Claim::Excluded { at, positive, negative } => {
                self.not_singular(at)?;
                if let Some(k) = [positive, negative].into_iter().find(|&k| self.zero(at, k)) {
                    return Err(format!("b_{{{n},{k}}} = 0 at {at}"));
                }
                opposite(n, positive, negative, at).map_err(|what| format!("{what} at {at}"))
            }
        }
    }

    /// Checks that every b_{n,k}, of which b_{n,n−k} is another name, and c_n have the signs required on the
    /// whole interval.
    fn orbit(&self, left: Fraction, right: Fraction, emu: bool, gamma: bool) -> Result<(), String> {
        let n = self.n;
        self.no_singularity(left, right)?;
        let zero = |&j: &u64| !Multiple::of(left, j).no_integer_before(right);
        if !left.nothing_below(right, n)
            && let Some(j) = (1..n).find(zero)
        {
            let what = format!("sin {j} pi s, a factor of b_{{{n},{j}}}");
            return Err(format!("{what}, has a zero in ({left}, {right})"));
        }
        // Those that carry have not the sign of c.
        let signs = Signs::new(n, left);
        let wanted = if emu == signs.c_negative() { n - 1 } else { 0 };
        if carries(n, left) != wanted {
            let wrong = |&k: &u64| signs.b_negative(Multiple::of(left, k), Multiple::of(left, n - k)) == emu;
            let k = (1..n).find(wrong).expect("not all have the right sign");
            return Err(format!("b_{{{n},{k}}} has the wrong sign on ({left}, {right})"));
        }
        let holds = (emu == gamma) != signs.c_negative();
        ensure(holds, format_args!("c_{n} has the wrong sign on ({left}, {right})"))
    }

    /// Checks that b_{n,k} = 0 at the point, and that all b that are not 0 there have one sign.
    fn boundary(&self, at: Fraction, k: u64) -> Result<(), String> {
        let n = self.n;
        self.not_singular(at)?;
        ensure(self.zero(at, k), format_args!("b_{{{n},{k}}} is not 0 at {at}"))?;
        // What is 0 does not carry: q divides k for ⌊(n−1)/q⌋ of them, n − k for as many others, as it does
        // not divide n.
        let (carry, zeros) = (carries(n, at), 2 * ((n - 1) / at.parts().1));
        let holds = carry == 0 || carry + zeros == n - 1;
        ensure(holds, format_args!("two b of strictly opposite sign at {at}: excluded, not a boundary"))
    }

    /// Whether b_{n,k} = 0 at a point that is not singular.
    fn zero(&self, at: Fraction, k: u64) -> bool {
        at.times_is_integer(k) || at.times_is_integer(self.n - k)
    }

    fn not_singular(&self, at: Fraction) -> Result<(), String> {
        ensure(!at.times_is_integer(2 * self.n), format_args!("u_{} = 0 at {at}: singular", self.n))
    }

    /// Checks that no multiple of 1/(2n) lies inside: no pole, and u_n ≠ 0.
    fn no_singularity(&self, left: Fraction, right: Fraction) -> Result<(), String> {
        if Multiple::of(left, 2 * self.n).no_integer_before(right) {
            return Ok(());
        }
        Err(format!("u_{} = 0 at a multiple of 1/{} inside ({left}, {right})", self.n, 2 * self.n))
    }
}

/// Checks that b_{n,positive} > 0 > b_{n,negative} right of a point, neither having a zero or pole there.
fn opposite(n: u64, positive: u64, negative: u64, at: Fraction) -> Result<(), String> {
    let signs = Signs::new(n, at);
    let is_negative = |k| signs.b_negative(Multiple::of(at, k), Multiple::of(at, n - k));
    ensure(!is_negative(positive), format_args!("b_{{{n},{positive}}} is not > 0"))?;
    ensure(is_negative(negative), format_args!("b_{{{n},{negative}}} is not < 0"))
}
