//! How many patterns exist: closed walks by period, and their growth rate with an enclosure.

use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{Existence, Graph, Scalar};
use crate::number::{Ball, FloatInterval, Precision, Real, Sign};

/// The existing patterns of one sign of eµ over the periods ≤ P: a graph whose node n takes n steps.
#[derive(Debug, Clone)]
pub struct Walks {
    /// `follows[i][j]`: the period j + 1 may follow i + 1.
    follows: Vec<Vec<bool>>,
}

/// The exponential growth rate of the number of closed walks, log 1/z with z the least positive root of det(I − M(z)),
/// M_ij = z^{n_j} on edges. For P → ∞ it can only grow: a lower bound for the graph on all periods.
#[derive(Debug, Clone, PartialEq)]
pub enum Growth {
    /// There is no closed walk: no pattern exists.
    Empty,
    /// The closed walks do not branch, z = 1: patterns exist, their number is bounded.
    Zero,
    /// Enclosures of z and of log 1/z.
    Positive {
        /// z.
        z: FloatInterval,
        /// log 1/z.
        rate: FloatInterval,
    },
}

impl Walks {
    /// The certain edges of a graph for a sign of eµ; open ones are left out.
    pub fn new(graph: &Graph, positive: bool) -> Walks {
        let edge = |from, to| graph.edge(from, to, positive) == Existence::Orbit;
        let last = graph.last();
        Walks { follows: (1..=last).map(|from| (1..=last).map(|to| edge(from, to)).collect()).collect() }
    }

    /// The walks of a given relation on the periods 1, …, P: `follows[i][j]` if j + 1 may follow i + 1.
    pub fn from_matrix(follows: Vec<Vec<bool>>) -> Walks {
        Walks { follows }
    }

    /// The same over the periods 1, …, `last` only.
    #[must_use]
    pub fn up_to(&self, last: u64) -> Walks {
        let size = (last as usize).min(self.follows.len());
        Walks { follows: self.follows[..size].iter().map(|row| row[..size].to_vec()).collect() }
    }

    /// The number of patterns with Σ n_i = n up to rotation, for n = 1, …, `last`: (all, primitive).
    ///
    /// w_n, the closed walks of n steps with a marked step, are Σ_d d·(primitive patterns of period d) over the divisors d of n.
    /// Cost: O(`last`·P·edges) additions of numbers of O(`last`) bits.
    pub fn patterns(&self, last: u64) -> Vec<(BigUint, BigUint)> {
        let last = last as usize;
        let size = self.follows.len();
        let mut marked = vec![BigUint::zero(); last + 1];
        for start in 0..size.min(last) {
            // arrivals[t][j]: walks from `start` at time 0 to j at time t.
            let mut arrivals = vec![vec![BigUint::zero(); size]; last + 1];
            arrivals[0][start] = BigUint::one();
            for t in 0..=last {
                let here = std::mem::take(&mut arrivals[t]);
                if t > 0 {
                    marked[t] += &here[start] * (start + 1);
                }
                for (i, count) in
                    here.iter().enumerate().filter(|(i, count)| t + i < last && !count.is_zero())
                {
                    for (j, _) in self.follows[i].iter().enumerate().filter(|(_, follows)| **follows) {
                        arrivals[t + i + 1][j] += count;
                    }
                }
            }
        }
        let mut primitive = vec![BigUint::zero(); last + 1];
        let mut rows = Vec::with_capacity(last);
        for n in 1..=last {
            let divisors = || (1..n).filter(|d| n.is_multiple_of(*d));
            let repeated: BigUint = divisors().map(|d| &primitive[d] * d).sum();
            primitive[n] = (&marked[n] - repeated) / n;
            let all = divisors().map(|d| &primitive[d]).sum::<BigUint>() + &primitive[n];
            rows.push((all, primitive[n].clone()));
        }
        rows
    }

    /// The growth rate, z to 2^−40. Cost: O(P³) for each of 40 steps.
    ///
    /// z is bracketed by pivots: I − M(z) with M ≥ 0 is an M-matrix, that is z below the root, iff elimination without
    /// exchanges meets positive pivots only. No point tried is a root: det(I − M) and its leading minors are integer
    /// polynomials with constant term 1, whose rational roots are ±1/q, and the points tried are odd/2^b, odd ≥ 3.
    pub fn growth(&self) -> Growth {
        let core = self.recurrent();
        if core.is_empty() {
            return Growth::Empty;
        }
        let reach = self.reach();
        let branches = |&i: &usize| core.iter().filter(|&&j| self.follows[i][j] && reach[j][i]).count() > 1;
        if !core.iter().any(branches) {
            return Growth::Zero;
        }
        // At most one walk for each composition of n: z ≥ 1/2.
        let (mut lo, mut hi) = (half(), BigRational::one());
        for _ in 0..40 {
            let middle = (&lo + &hi) * half();
            let below = self.below_root(&core, &FloatInterval::ratio(&middle, &()), &()).or_else(|| {
                [128, 1024].iter().find_map(|&bits| {
                    let bits = Precision::new(bits);
                    self.below_root(&core, &Ball::ratio(&middle, &bits), &bits)
                })
            });
            match below {
                Some(true) => lo = middle,
                Some(false) => hi = middle,
                None => break,
            }
        }
        let z = FloatInterval::from_bounds(
            FloatInterval::ratio(&lo, &()).lo(),
            FloatInterval::ratio(&hi, &()).hi(),
        );
        Growth::Positive { z, rate: logarithm(FloatInterval::integer(1, &()) / &z) }
    }

    /// `reach[i][j]`: some walk leads from i to j.
    fn reach(&self) -> Vec<Vec<bool>> {
        let mut reach = self.follows.clone();
        for k in 0..reach.len() {
            let through = reach[k].clone();
            for row in reach.iter_mut().filter(|row| row[k]) {
                row.iter_mut().zip(&through).for_each(|(entry, &more)| *entry |= more);
            }
        }
        reach
    }

    /// The nodes on closed walks.
    fn recurrent(&self) -> Vec<usize> {
        let reach = self.reach();
        (0..reach.len()).filter(|&i| reach[i][i]).collect()
    }

    /// Whether z lies below the least root for the nodes of `core`, if the rung can tell.
    fn below_root<T: Scalar>(&self, core: &[usize], z: &T, context: &T::Context) -> Option<bool> {
        let mut powers = vec![T::integer(1, context)];
        for n in 0..self.follows.len() {
            powers.push(powers[n].clone() * z);
        }
        let entry = |i: usize, j: usize| {
            let one = T::integer(i32::from(i == j), context);
            if self.follows[i][j] { one - &powers[j + 1] } else { one }
        };
        let mut rows: Vec<Vec<T>> =
            core.iter().map(|&i| core.iter().map(|&j| entry(i, j)).collect()).collect();
        for k in 0..rows.len() {
            match rows[k][k].sign() {
                Some(Sign::Positive) => {}
                Some(_) => return Some(false),
                None => return None,
            }
            let (head, tail) = rows.split_at_mut(k + 1);
            let pivot = &head[k];
            for row in tail {
                let factor = row[k].clone() / &pivot[k];
                for (entry, above) in row[k + 1..].iter_mut().zip(&pivot[k + 1..]) {
                    *entry = entry.clone() - &(factor.clone() * above);
                }
            }
        }
        Some(true)
    }
}

fn half() -> BigRational {
    BigRational::new(1.into(), 2.into())
}

/// log w for 1 ≤ w ≤ 2 (or an enclosure that reaches little beyond): 2 Σ t^{2k+1}/(2k+1), t = (w−1)/(w+1) ≤ 0.34; the terms
/// from k = 20 on add up to less than 2·0.34⁴¹/41/(1 − 0.34²) < 10⁻¹⁹.
fn logarithm(w: FloatInterval) -> FloatInterval {
    let one = FloatInterval::integer(1, &());
    let t = (w - &one) / &(w + &one);
    let square = t * &t;
    let mut power = t;
    let mut sum = FloatInterval::from_bounds(-1e-19, 1e-19);
    for k in 0..20 {
        sum = sum + &(power / &FloatInterval::integer(2 * k + 1, &()));
        power = power * &square;
    }
    sum + &sum
}
