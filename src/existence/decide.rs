//! The decision procedure: where on r = 1 do (52) and (53) hold, for one n, from the signs alone.
//!
//! (0, ½) is cut at the zeros and poles of b_{n,k} and c_n, all rational: the multiples of 1/(2n), where u_n
//! = 0, and the m/k, k < n. Between cuts no sign changes, so a sign just right of a cut holds up to the next
//! cut that concerns it. Two b's of strictly opposite sign forbid every orbit as far as neither has a zero or
//! pole: one such pair of witnesses settles a whole stretch of cells and all cuts inside it. Which witnesses
//! are tried first is a guess that affects only the cost; each is tested, and where no pair is found all k
//! are counted.
//!
//! A sweep goes from cut to cut. Of 2n and of the k and n − k of its witnesses it knows the next multiples of
//! 1/j, and so ⌊js⌋, whose parity is the sign of sin jπs, without a division. All k are counted at once: the
//! integer ⌊ns⌋ − ⌊ks⌋ − ⌊(n−k)s⌋ is 0 or 1, and 1 for (n−1)⌊ns⌋ − 2 Σ ⌊ks⌋ of them, a sum that takes O(log
//! n) operations. Just right of s, by (B1), (B2) and ⌊ns⌋ + ⌊ns + ½⌋ = ⌊2ns⌋, b_{n,k} > 0 for these if ⌊2ns⌋
//! is even, and for the others if it is odd; c_n > 0 if it is odd.

use num_integer::Integer;
use num_rational::Ratio;
use num_traits::Zero;

use super::{
    Approach, Case, Interval, Signs, intervals,
    units::{Unit, Units},
};
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
/// Cost: O(log n) operations for each of the φ(n) + 1 intervals and O(1) for most others; O(n) memory.
///
/// # Errors
/// An input error unless 1 ≤ n ≤ [`MAX_PERIOD`](super::MAX_PERIOD).
pub fn decide(n: u64) -> Result<Decision> {
    let mut pieces = Vec::new();
    let disagreement = each_piece(n, true, |piece| pieces.push(piece))?;
    Ok(Decision { n, pieces, disagreement })
}

/// As (decided, claimed), one of them `None` where the other has nothing.
type Disagreement = (Option<Interval>, Option<Interval>);

/// Decides period `n`: each piece is given to `each`, from left to right, and the first disagreement is
/// returned. Unless they are wanted in `lowest` terms, which takes a quarter of the time, fractions come as
/// they are found, and the k of a boundary is none. Cost: that of [`decide`], in O(1) memory.
///
/// # Errors
/// Those of [`decide`].
pub(crate) fn each_piece(n: u64, lowest: bool, mut each: impl FnMut(Piece)) -> Result<Option<Disagreement>> {
    let mut claimed = intervals(n)?;
    let mut disagreement = None;
    let same = |a: &Ratio<u64>, b: &Ratio<u64>| a.numer() * b.denom() == b.numer() * a.denom();
    Sweep::new(n, lowest).pieces(|piece| {
        if let Piece::Orbit { left, right, case } = &piece
            && disagreement.is_none()
        {
            let claim = claimed.next();
            let is_found = |claim: &Interval| {
                claim.case == *case && same(&claim.left, left) && same(&claim.right, right)
            };
            if !claim.as_ref().is_some_and(is_found) {
                let m = (n * left.numer()).div_ceil(*left.denom());
                let (left, right) = (left.reduced(), right.reduced());
                let found = Interval { n, m, case: *case, left, right, deciding: None };
                disagreement = Some((Some(found), claim));
            }
        }
        each(piece);
    });
    Ok(disagreement.or_else(|| claimed.next().map(|claim| (None, Some(claim)))))
}

/// The multiples of 1/j around the point that a sweep has reached.
#[derive(Debug, Clone, Copy)]
struct Multiples {
    j: u64,
    /// The first one beyond the point is next/j: there and just right of it, ⌊js⌋ = next − 1.
    next: u64,
}

impl Multiples {
    fn around(at: &Ratio<u64>, j: u64) -> Self {
        Multiples { j, next: j * at.numer() / at.denom() + 1 }
    }

    /// Whether the point is one.
    fn meet(self, at: &Ratio<u64>) -> bool {
        (self.next - 1) * at.denom() == self.j * at.numer()
    }

    /// Whether the next one lies beyond a point.
    fn beyond(self, at: &Ratio<u64>) -> bool {
        self.next * at.denom() > self.j * at.numer()
    }

    /// Goes on to a point that lies no further than the next one.
    fn advance(&mut self, to: &Ratio<u64>) {
        self.next += u64::from(self.next * to.denom() == self.j * to.numer());
    }
}

/// A k, and the zeros of sin kπs and sin (n−k)πs.
#[derive(Debug, Clone, Copy)]
struct Witness {
    k: u64,
    zeros: [Multiples; 2],
}

/// A gap of F_{n−1}, the zeros of all b.
#[derive(Debug, Clone, Copy)]
struct Gap {
    /// Its right end.
    right: Multiples,
    /// Σ ⌊ks⌋ over 0 < k < n, for s in the gap or its left end.
    floors: u64,
}

/// From left to right through (0, ½).
struct Sweep {
    n: u64,
    /// Whether points are in lowest terms.
    lowest: bool,
    /// The point reached.
    at: Ratio<u64>,
    /// The multiples of 1/(2n).
    turns: Multiples,
    /// A k with b_{n,k} > 0 just right of the point, and one with b_{n,k} < 0.
    witnesses: [Option<Witness>; 2],
    /// The gap that was asked for last.
    gap: Gap,
    /// The units m modulo n still to come, for guesses, and the last one taken; at first 0/n, beside 0/1.
    units: Units,
    unit: Unit,
}

impl Sweep {
    fn new(n: u64, lowest: bool) -> Self {
        let at = Ratio::new_raw(0, 1);
        Sweep {
            n,
            lowest,
            at,
            turns: Multiples::around(&at, 2 * n),
            witnesses: [None; 2],
            gap: Gap { right: Multiples { j: 1, next: 0 }, floors: 0 },
            units: Units::new(n.max(2), 1..n / 2 + 1),
            unit: Unit { m: 0, inverse: 1, quotient: 0 },
        }
    }

    fn pieces(mut self, mut each: impl FnMut(Piece)) {
        while 2 * self.at.numer() < *self.at.denom() {
            let stretch = self.witnesses.iter().all(Option::is_some);
            self.find_witnesses();
            if !self.at.numer().is_zero() {
                each(Piece::Point { at: self.at, reason: self.reason(stretch) });
            }
            let right = self.open_piece(&mut each);
            self.turns.advance(&right);
            let zeros = self.witnesses.iter_mut().flatten().flat_map(|witness| &mut witness.zeros);
            zeros.for_each(|zeros| zeros.advance(&right));
            self.at = right;
        }
    }

    /// Hands on the open piece that starts here; returns its right end.
    fn open_piece(&mut self, each: &mut impl FnMut(Piece)) -> Ratio<u64> {
        let left = self.at;
        if let [Some(positive), Some(negative)] = &self.witnesses {
            let ([a, b], [c, d]) = (positive.zeros, negative.zeros);
            let right = self.first_next([self.turns, a, b, c, d]);
            each(Piece::Stretch { left, right, positive: positive.k, negative: negative.k });
            return right;
        }
        // All signs agree up to the next cut.
        let zeros = self.gap().right;
        let right = self.first_next([self.turns, zeros]);
        let c_positive = self.turns.next.is_multiple_of(2);
        let b_positive = self.n == 1 || self.witnesses[0].is_some();
        each(Piece::Orbit { left, right, case: Case::from_signs(b_positive, c_positive) });
        if self.n == 1 {
            each(Piece::Orbit { left, right, case: Case::from_signs(false, c_positive) });
        }
        right
    }

    /// The first of some next multiples, by cross-multiplication.
    fn first_next<const J: usize>(&self, multiples: [Multiples; J]) -> Ratio<u64> {
        let first = multiples.into_iter().reduce(|a, b| if b.next * a.j < a.next * b.j { b } else { a });
        let Multiples { j, next } = first.expect("J > 0");
        if self.lowest { Ratio::new(next, j) } else { Ratio::new_raw(next, j) }
    }

    /// Whether b_{n,k} > 0 just right of the point: by (B1), if ⌊ks⌋ + ⌊(n−k)s⌋ + ⌊ns + ½⌋ is odd; the last
    /// is ⌊(⌊2ns⌋ + 1)/2⌋.
    fn is_positive(&self, witness: &Witness) -> bool {
        let [low, high] = witness.zeros;
        !(low.next + high.next + self.turns.next / 2).is_multiple_of(2)
    }

    /// Sets the witnesses just right of the point: those at hand, a guess, or the first of all k; one is
    /// `None` exactly if no b has that sign there.
    fn find_witnesses(&mut self) {
        for index in 0..2 {
            let fits = |witness: &Witness| self.is_positive(witness) == (index == 0);
            if !self.witnesses[index].as_ref().is_some_and(fits) {
                self.witnesses[index] = None;
            }
        }
        for guess in [Self::quarter_turn, Self::near_multiple] {
            if self.witnesses.iter().all(Option::is_some) {
                return;
            }
            let k = guess(self);
            if (1..self.n).contains(&k) {
                let witness = self.witness(k);
                self.witnesses[usize::from(!self.is_positive(&witness))].get_or_insert(witness);
            }
        }
        if self.witnesses[0].is_none() {
            self.witnesses[0] = self.first(Approach::JustRight, 1).map(|k| self.witness(k));
        }
        if self.witnesses[1].is_none() && self.negatives() > 0 {
            self.witnesses[1] = self.first(Approach::JustRight, -1).map(|k| self.witness(k));
        }
    }

    fn witness(&self, k: u64) -> Witness {
        Witness { k, zeros: [k, self.n - k].map(|j| Multiples::around(&self.at, j)) }
    }

    /// A likely witness: k near 1/(2s), where sin kπs is about 1 and b about 2.
    fn quarter_turn(&mut self) -> u64 {
        let (p, q) = (*self.at.numer(), *self.at.denom());
        (q + p) / (2 * p).max(1)
    }

    /// A likely witness: where m/n is the multiple of 1/n nearest to the piece, n/gcd(m,n), or if that is n
    /// the denominator of a Farey neighbour; that of the other has the same b.
    fn near_multiple(&mut self) -> u64 {
        let m = self.turns.next / 2;
        while self.unit.m < m
            && let Some(unit) = self.units.next()
        {
            self.unit = unit;
        }
        if self.unit.m == m { self.unit.inverse } else { self.n / m.gcd(&self.n) }
    }

    /// The gap of F_{n−1} in which the point lies, or whose left end it is; for n = 1, of F_1.
    fn gap(&mut self) -> Gap {
        let at = self.at;
        if !self.gap.right.beyond(&at) {
            let floors = farey::floor_sum(self.n - 1, *at.numer(), *at.denom());
            self.gap = Gap { right: self.next_term(), floors };
        }
        self.gap
    }

    /// Its right end. It is guessed: two fractions in [0, 1] whose cross product is 1 and whose denominators
    /// have the sum n are neighbours in F_{n−1}.
    fn next_term(&self) -> Multiples {
        let (p, q) = (*self.at.numer(), *self.at.denom());
        let Unit { m, inverse, quotient } = self.unit;
        let right = Multiples { j: self.n - inverse, next: m - quotient };
        let neighbours = right.next * inverse == quotient * right.j + 1;
        if neighbours && quotient * q <= p * inverse && right.beyond(&self.at) {
            return right;
        }
        let next = farey::next(&self.at, &(self.n - 1).max(1)).expect("far below overflow");
        Multiples { j: *next.denom(), next: *next.numer() }
    }

    /// For how many k is b_{n,k} < 0 just right of the point.
    fn negatives(&mut self) -> u64 {
        let (all, turns) = (self.n - 1, self.turns.next - 1);
        let less = all * (turns / 2) - 2 * self.gap().floors;
        if turns.is_multiple_of(2) { all - less } else { less }
    }

    /// The first k whose b has this sign at the point or just right of it, by trying every k.
    fn first(&self, side: Approach, sign: i8) -> Option<u64> {
        let signs = Signs::new(self.n, &self.at, side);
        (1..).zip(signs.all_b()).find(|&(_, found)| found == sign).map(|(k, _)| k)
    }

    /// Why the point does not lie in an orbit's interval; on its left lies a `stretch` or none.
    fn reason(&self, stretch: bool) -> Reason {
        if self.turns.meet(&self.at) {
            return Reason::Singular;
        }
        let boundary = Reason::Boundary(*self.at.denom());
        let ([Some(positive), Some(negative)], true) = (&self.witnesses, stretch) else {
            // All b have one sign on one side, and each is continuous here: none has the opposite sign. The
            // cut is m/k for some k < n, so that sin kπs = 0, and its denominator is such a k.
            return boundary;
        };
        // A witness has its sign at the point, too, if it is not 0.
        let strict = |witness: &Witness, sign| {
            let zero = witness.zeros.iter().any(|zeros| zeros.meet(&self.at));
            if zero { self.first(Approach::At, sign) } else { Some(witness.k) }
        };
        match (strict(positive, 1), strict(negative, -1)) {
            (Some(positive), Some(negative)) => Reason::Excluded { positive, negative },
            _ => boundary,
        }
    }
}
