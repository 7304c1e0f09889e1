//! The second proof of Theorem 2 for one n: by enclosures over whole stretches of s, with no sign at a point
//! needed but at cuts.
//!
//! On a closed stretch each argument j s of (B1), (B2) is enclosed in an interval of rationals. If no integer
//! lies inside it, sin πjs has one sign on the open stretch, whatever it does at the ends; else nothing is
//! concluded. The theorem's intervals are taken as a guess and every factor's sign is proved on each; what
//! lies between is cut at the multiples of 1/(2n), where u_n = 0, and on every part two b's of opposite sign
//! are searched and proved. This shares no sign, cut or witness with [`decide`](super::decide()).
//!
//! One pair always does for a whole part (so an undecided part would be an error here). Let ns = m ± δ, 0 < δ
//! < ½, and ⌊x⌋ + {x} = x. Right of m/n, b_{n,k} > 0 iff {ks} > δ, which holds for k = ⌈n/(2m+1)⌉; left of it
//! b_{n,k} > 0 iff {ks} < 1 − δ, which holds for k = 1. And b_{n,k} < 0 for k = n/g if g = gcd(m, n) > 1,
//! else beyond the theorem's interval for the k that decides (S3).

use num_integer::Integer;
use num_rational::Ratio;

use super::{Case, Decision, Interval, Piece, Reason, intervals};
use crate::error::Result;

/// What enclosures show for one n.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Enclosed {
    /// Everything is decided: the pieces tile (0, ½) or there is a disagreement, after which they end.
    Decided(Decision),
    /// On a stretch of period `n` the enclosures show neither the signs claimed nor two of opposite sign.
    Undecided {
        /// The period.
        n: u64,
        /// The left end.
        left: Ratio<u64>,
        /// The right end.
        right: Ratio<u64>,
    },
}

/// Proves or refutes Theorem 2 for period `n` by enclosures.
///
/// Cost: O(n) operations for each of at most 2n parts, fewer where the last witnesses serve again; O(n)
/// memory.
///
/// # Errors
/// An input error unless 1 ≤ n ≤ [`MAX_PERIOD`](super::MAX_PERIOD).
pub fn decide_by_enclosure(n: u64) -> Result<Enclosed> {
    let mut cover = Cover { n, pieces: Vec::new(), witnesses: [None; 2], sines: Vec::new() };
    let disagreement = match cover.all(intervals(n)?) {
        Ok(()) => None,
        Err(Failure::Refuted(disagreement)) => Some(*disagreement),
        Err(Failure::Undecided(stretch)) => {
            let (left, right) = (stretch.left(), stretch.right());
            return Ok(Enclosed::Undecided { n, left, right });
        }
    };
    Ok(Enclosed::Decided(Decision { n, pieces: cover.pieces, disagreement }))
}

/// A closed stretch of s, or a point, as `[low, high] / unit`.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    low: u64,
    high: u64,
    unit: u64,
}

impl Stretch {
    fn new(left: &Ratio<u64>, right: &Ratio<u64>) -> Self {
        let unit = left.denom().lcm(right.denom());
        let over = |x: &Ratio<u64>| x.numer() * (unit / x.denom());
        Stretch { low: over(left), high: over(right), unit }
    }

    fn point(at: &Ratio<u64>) -> Self {
        Stretch { low: *at.numer(), high: *at.numer(), unit: *at.denom() }
    }

    fn left(&self) -> Ratio<u64> {
        Ratio::new(self.low, self.unit)
    }

    fn right(&self) -> Ratio<u64> {
        Ratio::new(self.high, self.unit)
    }

    /// The signs of sin πjs throughout the open stretch, or at the point, for j = 0, …, `last`: those of
    /// [`sin`](Stretch::sin), with one addition each in place of a division; 0 where the enclosure of j s
    /// shows none.
    fn sines(&self, last: u64, signs: &mut Vec<i8>) {
        signs.clear();
        signs.push(0);
        let is_point = self.low == self.high;
        // j · low = half turns · unit + rest, and low < unit.
        let (mut rest, mut width, mut sign) = (0, 0, 1);
        for _ in 0..last {
            rest += self.low;
            width += self.high - self.low;
            if width > self.unit {
                signs.resize(last as usize + 1, 0);
                return;
            }
            if rest >= self.unit {
                rest -= self.unit;
                sign = -sign;
            }
            let is_shown = rest + width <= self.unit && !(is_point && rest == 0);
            signs.push(if is_shown { sign } else { 0 });
        }
    }

    /// The sign of sin π(j s + h/2) throughout the open stretch, or at the point, if the enclosure of j s +
    /// h/2 shows it.
    fn sin(&self, j: u64, h: u64) -> Option<i8> {
        let unit = 2 * u128::from(self.unit);
        let argument = |s: u64| 2 * u128::from(j) * u128::from(s) + u128::from(h) * u128::from(self.unit);
        let (low, high) = (argument(self.low), argument(self.high));
        if low == high && low % unit == 0 {
            return Some(0);
        }
        let half_turns = low / unit;
        (high <= (half_turns + 1) * unit).then_some(if half_turns % 2 == 0 { 1 } else { -1 })
    }

    /// The sign of b_{n,k} = −2 sin kπs sin (n−k)πs / cos nπs (B1); where cos nπs = 0, 0.
    fn b(&self, n: u64, k: u64) -> Option<i8> {
        Some(-self.sin(k, 0)? * self.sin(n - k, 0)? * self.sin(n, 1)?)
    }

    /// The sign of c_n = −2 sin 2πs sin nπs / cos nπs (B2).
    fn c(&self, n: u64) -> Option<i8> {
        Some(-self.sin(2, 0)? * self.sin(n, 0)? * self.sin(n, 1)?)
    }
}

type Outcome = std::result::Result<(), Failure>;

enum Failure {
    /// What was found and what is claimed instead.
    Refuted(Box<(Option<Interval>, Option<Interval>)>),
    Undecided(Stretch),
}

impl Failure {
    fn refuted(found: Option<Interval>, claim: Option<Interval>) -> Self {
        Failure::Refuted(Box::new((found, claim)))
    }
}

struct Cover {
    n: u64,
    pieces: Vec<Piece>,
    /// The last k with b > 0 and the last with b < 0.
    witnesses: [Option<u64>; 2],
    /// Of the stretch that is looked at.
    sines: Vec<i8>,
}

impl Cover {
    fn all(&mut self, claims: impl Iterator<Item = Interval>) -> Outcome {
        let mut done = Ratio::new_raw(0, 1);
        for claim in claims {
            // n = 1 claims two cases on the same interval.
            if claim.left >= done {
                self.gap(done, claim.left)?;
            }
            self.orbit(&claim)?;
            done = claim.right;
        }
        self.gap(done, Ratio::new_raw(1, 2))
    }

    /// Every b has the sign of eµ and c that of eµγ on the open interval.
    fn orbit(&mut self, claim: &Interval) -> Outcome {
        let stretch = Stretch::new(&claim.left, &claim.right);
        let (b, c) = (claim.case.sign_emu(), claim.case.sign_emu() * claim.case.sign_gamma());
        let as_claimed = |found: Option<i8>, sign: i8| match found {
            None => Err(Failure::Undecided(stretch)),
            Some(found) if found == sign => Ok(()),
            Some(_) => Err(Failure::refuted(None, Some(claim.clone()))),
        };
        // b_{n,k} = −2 sin kπs sin (n−k)πs / cos nπs (B1), which is b_{n,n−k}.
        stretch.sines(self.n, &mut self.sines);
        let Some(cosine) = stretch.sin(self.n, 1) else { return Err(Failure::Undecided(stretch)) };
        let all = &self.sines[1..self.n as usize];
        let signs = all.iter().zip(all.iter().rev()).take(self.n as usize / 2);
        for (k, other) in signs {
            let sign = -k * other * cosine;
            as_claimed((sign != 0).then_some(sign), b)?;
        }
        as_claimed(stretch.c(self.n), c)?;
        let Interval { left, right, case, .. } = *claim;
        self.pieces.push(Piece::Orbit { left, right, case });
        Ok(())
    }

    /// Between two intervals, ends included but for 0 and ½: no orbit.
    fn gap(&mut self, left: Ratio<u64>, right: Ratio<u64>) -> Outcome {
        let mut left = left;
        loop {
            let inside = *left.numer() > 0 && left < Ratio::new_raw(1, 2);
            if inside {
                self.point(&Stretch::point(&left))?;
            }
            if left == right {
                return Ok(());
            }
            let singular = Ratio::new(2 * self.n * left.numer() / left.denom() + 1, 2 * self.n);
            let cut = singular.min(right);
            self.part(Stretch::new(&left, &cut))?;
            left = cut;
        }
    }

    /// An open stretch between cuts.
    fn part(&mut self, stretch: Stretch) -> Outcome {
        let (decided, _) = self.look(&stretch);
        match self.witnesses {
            [Some(positive), Some(negative)] => {
                let (left, right) = (stretch.left(), stretch.right());
                self.pieces.push(Piece::Stretch { left, right, positive, negative });
                Ok(())
            }
            _ if decided => Err(self.unclaimed(&stretch)),
            _ => Err(Failure::Undecided(stretch)),
        }
    }

    fn point(&mut self, at: &Stretch) -> Outcome {
        let reason = if at.sin(2 * self.n, 0) == Some(0) {
            Reason::Singular
        } else {
            match (self.look(at), self.witnesses) {
                (_, [Some(positive), Some(negative)]) => Reason::Excluded { positive, negative },
                ((_, Some(zero)), _) => Reason::Boundary(zero),
                _ => return Err(self.unclaimed(at)),
            }
        };
        self.pieces.push(Piece::Point { at: at.left(), reason });
        Ok(())
    }

    /// Looks for witnesses until there are two, those of the last stretch first; whether every sign was
    /// decided, and a k with b = 0.
    fn look(&mut self, stretch: &Stretch) -> (bool, Option<u64>) {
        let last = std::mem::take(&mut self.witnesses);
        for k in last.into_iter().flatten() {
            self.witness(k, stretch.b(self.n, k));
        }
        if self.witnesses.iter().all(Option::is_some) {
            return (true, None);
        }
        stretch.sines(self.n, &mut self.sines);
        let cosine = stretch.sin(self.n, 1);
        let (mut decided, mut zero) = (cosine.is_some(), None);
        // b_{n,k} = b_{n,n−k}.
        for k in 1..=self.n / 2 {
            let [one, other] = [k, self.n - k].map(|j| self.sines[j as usize]);
            match -one * other * cosine.unwrap_or(0) {
                0 if stretch.low == stretch.high => zero = Some(k),
                0 => decided = false,
                sign => self.witness(k, Some(sign)),
            }
            if self.witnesses.iter().all(Option::is_some) {
                break;
            }
        }
        (decided, zero)
    }

    fn witness(&mut self, k: u64, b: Option<i8>) {
        match b {
            Some(1) => self.witnesses[0] = Some(k),
            Some(-1) => self.witnesses[1] = Some(k),
            _ => {}
        }
    }

    /// All b have one sign where no orbit is claimed.
    fn unclaimed(&self, stretch: &Stretch) -> Failure {
        let Some(c) = stretch.c(self.n) else { return Failure::Undecided(*stretch) };
        let (left, right) = (stretch.left(), stretch.right());
        let m = (2 * self.n * left.numer() / left.denom()).div_ceil(2);
        let case = Case::from_signs(self.witnesses[0].is_some(), c > 0);
        Failure::refuted(Some(Interval { n: self.n, m, case, left, right, deciding: None }), None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cover(n: u64, claims: impl IntoIterator<Item = Interval>) -> (usize, Option<Failure>) {
        let mut cover = Cover { n, pieces: Vec::new(), witnesses: [None; 2], sines: Vec::new() };
        let failure = cover.all(claims.into_iter()).err();
        (cover.pieces.len(), failure)
    }

    /// An interval that is missing among the claims is found, with its m and its case.
    #[test]
    fn a_missing_interval_is_reported_as_it_is() {
        for n in 3..=20 {
            let claims: Vec<_> = intervals(n).unwrap().collect();
            for (i, missing) in claims.iter().enumerate() {
                let others = claims.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, c)| c.clone());
                // Where the gap is cut, or another piece of it is open, the report names that piece.
                let Some(Failure::Refuted(report)) = cover(n, others).1 else { continue };
                let (Some(found), None) = *report else { panic!("n = {n}: nothing is found") };
                assert_eq!((found.n, found.m, found.case), (n, missing.m, missing.case));
                assert!(missing.left <= found.left && found.right <= missing.right);
            }
            let reported = |i: usize| {
                let others = claims.iter().enumerate().filter(move |(j, _)| *j != i).map(|(_, c)| c.clone());
                matches!(cover(n, others).1, Some(Failure::Refuted(_)))
            };
            assert!((0..claims.len()).filter(|&i| reported(i)).count() >= 2, "n = {n}");
        }
    }

    /// Every claim that differs from the theorem is refuted or left open, none proved.
    #[test]
    fn false_claims_are_not_proved() {
        for n in 2..=20 {
            let claims: Vec<_> = intervals(n).unwrap().collect();
            assert!(cover(n, claims.clone()).1.is_none());
            for i in 0..claims.len() {
                let altered = |change: &dyn Fn(&mut Vec<Interval>)| {
                    let mut claims = claims.clone();
                    change(&mut claims);
                    cover(n, claims).1
                };
                let flipped =
                    Case::from_signs(claims[i].case.sign_emu() < 0, claims[i].case.sign_gamma() > 0);
                assert!(matches!(altered(&|c| c[i].case = flipped), Some(Failure::Refuted(_))));
                let others = claims.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, c)| c.clone());
                assert!(cover(n, others).1.is_some(), "n = {n}");
                // Ends moved by 1/(8n²), less than any two cuts are apart, and mixed up by none.
                let little = Ratio::new(1, 8 * n * n);
                assert!(altered(&|c| c[i].left += little).is_some(), "n = {n}, left end inwards");
                assert!(altered(&|c| c[i].right -= little).is_some(), "n = {n}, right end inwards");
                if i + 1 < claims.len() && claims[i + 1].left > claims[i].right {
                    assert!(altered(&|c| c[i].right += little).is_some(), "n = {n}, right end outwards");
                }
            }
        }
    }
}
