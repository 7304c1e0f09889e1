//! The decision procedure: where on r = 1 do (52) and (53) hold, for one n, from the signs alone.
//!
//! (0, ½) is cut at the zeros and poles of b_{n,k} and c_n, all rational: the multiples of 1/(2n), where u_n
//! = 0, and the m/k, k < n. Between cuts no sign changes, so a sign just right of a cut holds up to the next
//! cut that concerns it. Two b's of strictly opposite sign forbid every orbit as far as neither has a zero or
//! pole: one such pair of witnesses settles a whole stretch of cells and all cuts inside it. Which witnesses
//! are tried first is a guess that affects only the cost; each is tested, and where no pair is found every k
//! has been.

use num_integer::Integer;
use num_rational::Ratio;

use super::{Approach, Case, Interval, Signs, intervals};
use crate::{error::Result, farey};

/// A part of (0, ½); the pieces of one n, alternately open intervals and the points between them, tile it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece {
    /// An open interval without cuts where (52), (53) hold in one case, or for n = 1 in these two.
    Orbit {
        /// The left end.
        left: Ratio<u64>,
        /// The right end.
        right: Ratio<u64>,
        /// The case.
        case: Case,
    },
    /// An open interval, perhaps with cuts, where b_{n,positive} > 0 > b_{n,negative}: no orbit.
    Stretch {
        /// The left end.
        left: Ratio<u64>,
        /// The right end.
        right: Ratio<u64>,
        /// A k with b_{n,k} > 0 throughout.
        positive: u64,
        /// A k with b_{n,k} < 0 throughout.
        negative: u64,
    },
    /// A cut between two intervals, where (52), (53) do not hold strictly.
    Point {
        /// Where.
        at: Ratio<u64>,
        /// Why not.
        reason: Reason,
    },
}

/// Why (52), (53) do not hold at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// u_n = 0: Theorem 1 is silent.
    Singular,
    /// b_{n,k} = 0 for this k, and no two b's have opposite signs: Theorem 1 is silent.
    Boundary(u64),
    /// b_{n,positive} > 0 > b_{n,negative}: no orbit.
    Excluded {
        /// A k with b_{n,k} > 0.
        positive: u64,
        /// A k with b_{n,k} < 0.
        negative: u64,
    },
}

/// What was decided for one n.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Decision {
    /// The period.
    pub n: u64,
    /// The pieces that tile (0, ½), from left to right.
    pub pieces: Vec<Piece>,
    /// The first interval in which the decision and Theorem 2 differ, as (decided, claimed); `None` proves
    /// the theorem for this n.
    pub disagreement: Option<(Option<Interval>, Option<Interval>)>,
}

/// Decides Theorem 2 for period `n`, without using its proof, and compares the result with its statement.
///
/// Cost: O(n) operations for each of the φ(n) + 1 intervals and O(1) for most others, so O(n²) in all; O(n)
/// memory.
///
/// # Errors
/// An input error unless 1 ≤ n ≤ [`MAX_PERIOD`](super::MAX_PERIOD).
pub fn decide(n: u64) -> Result<Decision> {
    let mut claimed = intervals(n)?;
    let pieces = Search { n, positive: None, negative: None }.pieces();
    let mut decided = pieces.iter().filter_map(|piece| match piece {
        Piece::Orbit { left, right, case } => Some((left, right, *case)),
        _ => None,
    });
    let disagreement = loop {
        match (decided.next(), claimed.next()) {
            (None, None) => break None,
            (Some((left, right, case)), Some(claim))
                if claim.case == case && claim.left == *left && claim.right == *right => {}
            (found, claim) => {
                let found = found.map(|(left, right, case)| Interval {
                    n,
                    m: (n * left.numer()).div_ceil(*left.denom()),
                    case,
                    left: *left,
                    right: *right,
                    deciding: None,
                });
                break Some((found, claim));
            }
        }
    };
    Ok(Decision { n, pieces, disagreement })
}

struct Search {
    n: u64,
    /// The witnesses in use.
    positive: Option<u64>,
    negative: Option<u64>,
}

impl Search {
    fn pieces(&mut self) -> Vec<Piece> {
        let half = Ratio::new_raw(1, 2);
        let mut pieces = Vec::new();
        let mut at = self.open_piece(Ratio::new_raw(0, 1), &mut pieces);
        while at != half {
            // The point goes between the pieces on its two sides, which say most about it.
            let index = pieces.len();
            let right = self.open_piece(at, &mut pieces);
            let reason = self.reason_at(&at, &pieces[index - 1], &pieces[index]);
            pieces.insert(index, Piece::Point { at, reason });
            at = right;
        }
        pieces
    }

    /// Appends the open piece that starts at `left`; returns its right end.
    fn open_piece(&mut self, left: Ratio<u64>, pieces: &mut Vec<Piece>) -> Ratio<u64> {
        let n = self.n;
        let signs = Signs::new(n, &left, Approach::JustRight);
        self.find_witnesses(&signs, &left);
        if let (Some(positive), Some(negative)) = (self.positive, self.negative) {
            let factors = [2 * n, positive, n - positive, negative, n - negative];
            let right = next_multiple(&left, factors);
            pieces.push(Piece::Stretch { left, right, positive, negative });
            return right;
        }
        // All signs agree up to the next cut: the next zero of any b is the next term of F_{n−1}.
        let zeros =
            if n == 1 { 1 } else { *farey::next(&left, &(n - 1)).expect("far below overflow").denom() };
        let right = next_multiple(&left, [2 * n, zeros]);
        let c_positive = signs.c() > 0;
        let b_positive = n == 1 || self.positive.is_some();
        pieces.push(Piece::Orbit { left, right, case: Case::from_signs(b_positive, c_positive) });
        if n == 1 {
            pieces.push(Piece::Orbit { left, right, case: Case::from_signs(false, c_positive) });
        }
        right
    }

    /// Sets the witnesses for the signs just right of `left`: those at hand, a guess, or the first of all k;
    /// one is `None` exactly if no b has that sign there.
    fn find_witnesses(&mut self, signs: &Signs, left: &Ratio<u64>) {
        let find = |sign: i8, known: Option<u64>| {
            let fits = |k: &u64| signs.b(*k) == sign;
            known.filter(fits).or_else(|| self.guesses(left).find(fits))
        };
        let (mut positive, mut negative) = (find(1, self.positive), find(-1, self.negative));
        if positive.is_none() || negative.is_none() {
            for (k, sign) in (1..).zip(signs.all_b()) {
                let witness = if sign > 0 { &mut positive } else { &mut negative };
                witness.get_or_insert(k);
                if positive.is_some() && negative.is_some() {
                    break;
                }
            }
        }
        (self.positive, self.negative) = (positive, negative);
    }

    /// Likely witnesses right of s = p/q: k near 1/(2s), where sin kπs is about 1 and b about 2; and where
    /// m/n is the multiple of 1/n nearest to the piece, n/gcd(m,n) and the denominators of its Farey
    /// neighbours.
    fn guesses(&self, s: &Ratio<u64>) -> impl Iterator<Item = u64> + use<> {
        let (n, p, q) = (self.n, *s.numer(), *s.denom());
        let quarter_turn = (q + p) / (2 * p).max(1);
        let m = (2 * n * p / q).div_ceil(2);
        let g = m.gcd(&n);
        let neighbours = if g == 1 && n > 1 { farey::neighbours(&Ratio::new_raw(m, n)).ok() } else { None };
        let others = match neighbours {
            Some(pair) => [*pair.left.denom(), *pair.right.denom()],
            None => [n / g, 0],
        };
        [quarter_turn, others[0], others[1]].into_iter().filter(move |&k| 0 < k && k < n)
    }

    fn reason_at(&self, at: &Ratio<u64>, before: &Piece, after: &Piece) -> Reason {
        let signs = Signs::new(self.n, at, Approach::At);
        if signs.singular() {
            return Reason::Singular;
        }
        let (
            Piece::Stretch { positive: p0, negative: n0, .. },
            Piece::Stretch { positive: p1, negative: n1, .. },
        ) = (before, after)
        else {
            // All b have one sign on one side, and each is continuous here: none has the opposite sign. The
            // cut is m/k for some k < n, so that sin kπs = 0, and its denominator is such a k.
            return Reason::Boundary(*at.denom());
        };
        let known = [*p0, *p1, *n0, *n1].map(|k| (k, signs.b(k)));
        let (mut positive, mut negative) = (None, None);
        for (k, sign) in known.into_iter().chain((1..).zip(signs.all_b())) {
            match sign {
                0 => {}
                1 => positive = positive.or(Some(k)),
                _ => negative = negative.or(Some(k)),
            }
            if let (Some(positive), Some(negative)) = (positive, negative) {
                return Reason::Excluded { positive, negative };
            }
        }
        Reason::Boundary(*at.denom())
    }
}

/// The first fraction after `left` that is a multiple of some 1/j, by cross-multiplication.
fn next_multiple<const J: usize>(left: &Ratio<u64>, factors: [u64; J]) -> Ratio<u64> {
    let after = |j: u64| (j * left.numer() / left.denom() + 1, j);
    let (p, q) = factors
        .map(after)
        .into_iter()
        .reduce(|a, b| if b.0 * a.1 < a.0 * b.1 { b } else { a })
        .expect("J > 0");
    Ratio::new(p, q)
}
