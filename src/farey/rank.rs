//! Rank of a fraction in F_N and the K-th term, without listing the sequence.
//!
//! #{(a, q) : q ≤ N, a/q ≤ x, gcd(a, q) = 1, a ≥ 1} = Σ_d µ(d) S(x, ⌊N/d⌋), S(x, M) = Σ_{q ≤ M} ⌊q x⌋. The
//! sum over d takes one term per distinct ⌊N/d⌋, with the Mertens function M(t) = Σ_{d ≤ t} µ(d) at those
//! quotients, and each S is a lattice-point count in O(log N) steps.

use num_integer::Roots;
use num_rational::Ratio;
use num_traits::PrimInt;

use super::{Gap, sequence::bracket};
use crate::error::{Error, Result};

/// Ranks within one F_N ∩ [0, 1], its Mertens table computed once. Indices count from 0 at 0/1.
#[derive(Debug, Clone)]
pub struct Ranker {
    order: u64,
    /// The distinct quotients t = ⌊N/d⌋ in decreasing order, each with Σ µ(d) over the d that give it.
    weights: Vec<(u64, i64)>,
    /// The index of 1/1: one less than the number of terms.
    last: u128,
}

impl Ranker {
    /// The largest order N allowed: its tables take 18 MB and about a second.
    pub const MAX_ORDER: u64 = 10_000_000_000;

    /// The tables for F_N, N = `order`. Cost: O(N^⅔ log log N) time, O(N^⅔) memory.
    ///
    /// # Errors
    /// An input error unless 1 ≤ `order` ≤ [`MAX_ORDER`](Self::MAX_ORDER).
    pub fn new(order: u64) -> Result<Self> {
        if !(1..=Self::MAX_ORDER).contains(&order) {
            return Err(Error::input(format!(
                "ranks are computed in F_N for 1 ≤ N ≤ {}, not for N = {order}",
                Self::MAX_ORDER
            )));
        }
        let mut ranker = Ranker { order, weights: weights(order), last: 0 };
        ranker.last = ranker.count(1, 1);
        Ok(ranker)
    }

    /// The index of the last term 1/1 of F_N: Σ_{q ≤ N} φ(q).
    pub fn last_index(&self) -> u128 {
        self.last
    }

    /// The index in F_N of the greatest term ≤ `x`, 0 ≤ x ≤ 1. Cost: O(√N log N).
    ///
    /// # Errors
    /// An input error if `x` > 1.
    pub fn rank(&self, x: &Ratio<u64>) -> Result<u128> {
        if x.numer() > x.denom() {
            return Err(Error::input(format!("{x} is above 1: ranks are counted in [0, 1]")));
        }
        // Terms are all that counts, and with the greatest one ≤ x no product below exceeds N².
        let (term, _) = bracket(x, &self.order)?;
        Ok(self.count(*term.numer(), *term.denom()))
    }

    /// The term of F_N with index `index`. Cost: O(√N log³ N).
    ///
    /// # Errors
    /// An input error if `index` is above [`last_index`](Self::last_index).
    pub fn kth(&self, index: u128) -> Result<Ratio<u64>> {
        if index > self.last {
            return Err(Error::input(format!(
                "F_{} has terms 0 to {}, so none with index {index}",
                self.order, self.last
            )));
        }
        // Descend the tree keeping rank(left) ≤ index < rank(right), by runs of equal turns: each run's
        // length is found by doubling and bisection.
        let mut gap = Gap::<u64>::unit();
        if index == self.last {
            return Ok(gap.right);
        }
        loop {
            let right = gap.right;
            let moved_left = self.advance(&mut gap.left, &right, |rank| rank <= index);
            let left = gap.left;
            let moved_right = self.advance(&mut gap.right, &left, |rank| rank > index);
            if !moved_left && !moved_right {
                return Ok(gap.left);
            }
        }
    }

    /// Moves `x` to x ⊕ k `by`, the largest k ≥ 0 for which the order and `keep(rank)` allow it.
    fn advance(&self, x: &mut Ratio<u64>, by: &Ratio<u64>, keep: impl Fn(u128) -> bool) -> bool {
        let at = |k: u64| (x.numer() + k * by.numer(), x.denom() + k * by.denom());
        let most = (self.order - x.denom()) / by.denom();
        let allowed = |k: u64| {
            let (p, q) = at(k);
            keep(self.count(p, q))
        };
        let (mut low, mut step) = (0, 1);
        while low + step <= most && allowed(low + step) {
            low += step;
            step *= 2;
        }
        while step > 0 {
            if low + step <= most && allowed(low + step) {
                low += step;
            }
            step /= 2;
        }
        let (p, q) = at(low);
        *x = Ratio::new_raw(p, q);
        low > 0
    }

    /// The number of terms in (0, p/q], for p ≤ q ≤ N.
    fn count(&self, p: u64, q: u64) -> u128 {
        let sum: i128 = self
            .weights
            .iter()
            .map(|&(t, weight)| i128::from(weight) * floor_sum::<u128>(t.into(), p.into(), q.into()) as i128)
            .sum();
        sum as u128
    }
}

/// The index in F_N ∩ [0, 1] of the greatest term ≤ `x`, N = `order`; 0 for 0/1. Cost: O(N^⅔ log log N).
///
/// # Errors
/// As [`Ranker::new`] and [`Ranker::rank`].
///
/// ```
/// use grazing::farey::{kth, rank};
/// use num_rational::Ratio;
/// assert_eq!(rank(&Ratio::new(1, 2), 1_000_000)?, 151_981_776_196);
/// assert_eq!(kth(151_981_776_196, 1_000_000)?, Ratio::new(1, 2));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn rank(x: &Ratio<u64>, order: u64) -> Result<u128> {
    Ranker::new(order)?.rank(x)
}

/// The term of F_N ∩ [0, 1] with index `index` (0 for 0/1), N = `order`.
/// Cost: O(N^⅔ log log N + √N log³ N).
///
/// # Errors
/// As [`Ranker::new`] and [`Ranker::kth`].
pub fn kth(index: u128, order: u64) -> Result<Ratio<u64>> {
    Ranker::new(order)?.kth(index)
}

/// Σ_{i=1}^{n} ⌊i p/q⌋ for p ≤ q, by Euclid's algorithm on lattice points. Below n (n + 1)/2.
///
/// Precondition: (n + 1) (n + q) fits the type.
pub(crate) fn floor_sum<T: PrimInt>(n: T, p: T, q: T) -> T {
    let (one, two) = (T::one(), T::one() + T::one());
    let (mut n, mut a, mut b, mut m) = (n + one, p, T::zero(), q);
    // Invariant: the answer is `sum` + sign · Σ_{i=0}^{n-1} ⌊(a i + b)/m⌋, all terms counted from above.
    let mut sum = T::zero();
    loop {
        sum = sum + n * (n - one) / two * (a / m) + n * (b / m);
        (a, b) = (a % m, b % m);
        let top = a * n + b;
        if top < m {
            return sum;
        }
        (n, b) = (top / m, top % m);
        (m, a) = (a, m);
    }
}

/// The distinct quotients of `order` with the sums of µ over the divisors that give them.
fn weights(order: u64) -> Vec<(u64, i64)> {
    let mertens = Mertens::new(order);
    let mut weights = Vec::new();
    let (mut d, mut below) = (1, 0);
    while d <= order {
        let quotient = order / d;
        let last = order / quotient;
        let upto = mertens.at(last);
        weights.push((quotient, upto - below));
        (d, below) = (last + 1, upto);
    }
    weights
}

/// M(t) = Σ_{d ≤ t} µ(d) at every quotient t = ⌊N/d⌋.
struct Mertens {
    order: u64,
    /// M(t) for t below about N^⅔, by a sieve.
    small: Vec<i32>,
    /// M(⌊N/d⌋) at index d, for the quotients beyond the sieve.
    large: Vec<i64>,
}

impl Mertens {
    fn new(order: u64) -> Self {
        let bound = order.cbrt().pow(2).max(order.sqrt()) + 1;
        let small = mertens_table(bound as usize);
        let beyond = order / bound;
        let mut mertens = Mertens { order, small, large: vec![0; beyond as usize + 1] };
        for d in (1..=beyond).rev() {
            // Σ_{i ≤ t} M(⌊t/i⌋) = 1.
            let t = order / d;
            let mut value = 1;
            let mut i = 2;
            while i <= t {
                let quotient = t / i;
                let last = t / quotient;
                value -= (last - i + 1) as i64 * mertens.at(quotient);
                i = last + 1;
            }
            mertens.large[d as usize] = value;
        }
        mertens
    }

    fn at(&self, t: u64) -> i64 {
        match self.small.get(t as usize) {
            Some(&value) => i64::from(value),
            None => self.large[(self.order / t) as usize],
        }
    }
}

/// M(0), …, M(bound) by the linear sieve of smallest prime factors.
fn mertens_table(bound: usize) -> Vec<i32> {
    let mut mu = vec![0i32; bound + 1];
    let mut composite = vec![false; bound + 1];
    let mut primes = Vec::new();
    mu[1] = 1;
    for i in 2..=bound {
        if !composite[i] {
            primes.push(i);
            mu[i] = -1;
        }
        for &p in &primes {
            if i * p > bound {
                break;
            }
            composite[i * p] = true;
            if i % p == 0 {
                break;
            }
            mu[i * p] = -mu[i];
        }
    }
    for i in 1..=bound {
        mu[i] += mu[i - 1];
    }
    mu
}
