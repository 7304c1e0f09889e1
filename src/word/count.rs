//! How many impact patterns a relation allows, by period.

use num_bigint::{BigInt, BigUint};
use num_traits::{One, Signed, Zero};

use super::{Edge, Relation};

/// The closed walks of a relation on periods, counted without being listed.
///
/// Periods that follow, and are followed by, the same ones are one class; a word of many letters has few.
#[derive(Debug, Clone)]
pub struct ClosedWalks {
    /// The periods of each class.
    pub(super) classes: Vec<Vec<u64>>,
    /// `follows[a][b]`: the periods of class b may follow those of class a.
    pub(super) follows: Vec<Vec<bool>>,
}

/// The number of patterns of one period, up to rotation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PatternCount {
    /// The period Σ n_i.
    pub period: u64,
    /// All of them.
    pub all: BigUint,
    /// Those that repeat no shorter one.
    pub primitive: BigUint,
}

impl ClosedWalks {
    /// The certain edges of a relation; open ones count as absent, so that counts and entropy are lower
    /// bounds there. Cost: O(V² C) for V periods in C classes that follow alike; memory: O(V²).
    pub fn new(relation: &Relation) -> ClosedWalks {
        let follows: Vec<Vec<bool>> =
            relation.edges().iter().map(|row| row.iter().map(|&edge| edge == Edge::Yes).collect()).collect();
        ClosedWalks::from_edges(relation.periods(), &follows)
    }

    /// The walks of any relation: `follows[i][j]` if `periods[j]` may follow `periods[i]`. Cost: O(V² C), C
    /// classes.
    ///
    /// # Panics
    /// Unless `follows` is a square matrix over `periods`, all of them at least 1.
    pub fn from_edges(periods: &[u64], follows: &[Vec<bool>]) -> ClosedWalks {
        let size = periods.len();
        assert!(follows.len() == size && follows.iter().all(|row| row.len() == size));
        assert!(periods.iter().all(|&n| n >= 1), "a period is at least 1");
        let alike = |i: usize, j: usize| {
            follows[i] == follows[j] && (0..size).all(|k| follows[k][i] == follows[k][j])
        };
        let mut heads: Vec<usize> = Vec::new();
        let mut classes: Vec<Vec<u64>> = Vec::new();
        for (i, &period) in periods.iter().enumerate() {
            match heads.iter().position(|&head| alike(head, i)) {
                Some(class) => classes[class].push(period),
                None => {
                    heads.push(i);
                    classes.push(vec![period]);
                }
            }
        }
        let follows = heads.iter().map(|&i| heads.iter().map(|&j| follows[i][j]).collect()).collect();
        ClosedWalks { classes, follows }
    }

    /// The number of patterns of period 1, …, `last`.
    ///
    /// With M_ab(z) = Σ z^n over the n of class b where b may follow a, the closed walks with a marked
    /// forcing period number w_n, Σ w_n zⁿ = −z d′(z)/d(z), d = det(I − M); and w_n = Σ over the divisors d
    /// of n of d·(primitive patterns of period d). Cost: O(C³ `last`²) products of integers of O(`last`)
    /// bits.
    pub fn count(&self, last: u64) -> Vec<PatternCount> {
        let last = usize::try_from(last).unwrap_or(usize::MAX);
        let determinant = self.determinant(last);
        // w·d = −z d′.
        let mut marked = vec![BigInt::zero(); last + 1];
        for n in 1..=last {
            let mut w = -BigInt::from(n) * &determinant[n];
            for (k, coefficient) in
                determinant.iter().enumerate().take(n).skip(1).filter(|(_, c)| !c.is_zero())
            {
                w -= coefficient * &marked[n - k];
            }
            marked[n] = w;
        }
        let mut primitive = vec![BigUint::zero(); last + 1];
        let mut rows = Vec::with_capacity(last);
        for n in 1..=last {
            let divisors = || (1..n).filter(|d| n.is_multiple_of(*d));
            let repeated: BigUint = divisors().map(|d| &primitive[d] * d).sum();
            debug_assert!(!marked[n].is_negative());
            primitive[n] = (marked[n].magnitude() - repeated) / n;
            let all = divisors().map(|d| &primitive[d]).sum::<BigUint>() + &primitive[n];
            rows.push(PatternCount { period: n as u64, all, primitive: primitive[n].clone() });
        }
        rows
    }

    /// det(I − M(z)) up to z^`last`, by elimination over power series: every pivot has the constant term 1.
    fn determinant(&self, last: usize) -> Vec<BigInt> {
        let series = |class: &[u64]| {
            let mut terms = vec![BigInt::zero(); last + 1];
            for &n in class.iter().filter(|&&n| n <= last as u64) {
                terms[n as usize] -= 1;
            }
            terms
        };
        let columns: Vec<Vec<BigInt>> = self.classes.iter().map(|class| series(class)).collect();
        let entry = |a: usize, b: usize| {
            let mut terms =
                if self.follows[a][b] { columns[b].clone() } else { vec![BigInt::zero(); last + 1] };
            terms[0] += i32::from(a == b);
            terms
        };
        let size = self.classes.len();
        let mut rows: Vec<Vec<Vec<BigInt>>> =
            (0..size).map(|a| (0..size).map(|b| entry(a, b)).collect()).collect();
        let mut determinant = vec![BigInt::zero(); last + 1];
        determinant[0] = BigInt::one();
        for k in 0..size {
            determinant = product(&determinant, &rows[k][k]);
            let (head, tail) = rows.split_at_mut(k + 1);
            let pivot = &head[k];
            for row in tail.iter_mut().filter(|row| row[k].iter().any(|term| !term.is_zero())) {
                let factor = quotient(&row[k], &pivot[k]);
                for (entry, above) in row[k + 1..].iter_mut().zip(&pivot[k + 1..]) {
                    for (term, change) in entry.iter_mut().zip(product(&factor, above)) {
                        *term -= change;
                    }
                }
            }
        }
        determinant
    }
}

/// The product of two series, cut where they are.
fn product(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut terms = vec![BigInt::zero(); a.len()];
    for (i, x) in a.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
        for (term, y) in terms[i..].iter_mut().zip(b).filter(|(_, y)| !y.is_zero()) {
            *term += x * y;
        }
    }
    terms
}

/// a/b for a series b that begins with 1.
fn quotient(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut terms = a.to_vec();
    for n in 0..terms.len() {
        for k in 1..=n {
            if !b[k].is_zero() && !terms[n - k].is_zero() {
                let change = &b[k] * &terms[n - k];
                terms[n] -= change;
            }
        }
    }
    terms
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Necklaces: every composition of n up to rotation is a pattern of the full shift over 1, 2, 3, ….
    #[test]
    fn the_full_shift_has_a_pattern_for_every_cyclic_composition() {
        let periods: Vec<u64> = (1..=20).collect();
        let full = ClosedWalks::from_edges(&periods, &vec![vec![true; 20]; 20]);
        assert_eq!(full.classes.len(), 1);
        let found: Vec<u64> = full.count(20).iter().map(|row| u64::try_from(&row.all).unwrap()).collect();
        // Binary necklaces of n beads less one: a mark at the start of each period, at least one mark.
        let necklaces = |n: u64| {
            let totient = |d: u64| (1..=d).filter(|k| num_integer::gcd(*k, d) == 1).count() as u64;
            (1..=n).filter(|d| n.is_multiple_of(*d)).map(|d| totient(d) << (n / d)).sum::<u64>() / n
        };
        assert_eq!(found, (1..=20).map(|n| necklaces(n) - 1).collect::<Vec<_>>());
    }

    /// Against walking: patterns listed one by one over a relation without symmetry.
    #[test]
    fn counts_agree_with_listing() {
        let periods = [2, 1, 3, 5];
        let follows =
            [[1, 1, 0, 1], [1, 0, 1, 0], [0, 1, 1, 1], [1, 0, 0, 0]].map(|row| row.map(|e| e == 1).to_vec());
        let rows = ClosedWalks::from_edges(&periods, &follows).count(14);
        for row in rows {
            let mut classes = std::collections::BTreeSet::new();
            let mut stack: Vec<Vec<usize>> = (0..4).map(|i| vec![i]).collect();
            while let Some(walk) = stack.pop() {
                let length: u64 = walk.iter().map(|&i| periods[i]).sum();
                if length == row.period && follows[walk[walk.len() - 1]][walk[0]] {
                    let rotate = |by: usize| [&walk[by..], &walk[..by]].concat();
                    classes.insert((0..walk.len()).map(rotate).min().unwrap());
                }
                if length < row.period {
                    let next = (0..4).filter(|&j| follows[walk[walk.len() - 1]][j]);
                    stack.extend(next.map(|j| [&walk[..], &[j]].concat()));
                }
            }
            assert_eq!(BigUint::from(classes.len()), row.all, "period {}", row.period);
        }
    }
}
