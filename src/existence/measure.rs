//! How much of the line r = 1 a period takes: the total length of its intervals of s, from a formula.
//!
//! **L_n = (1/n) Σ 1/k**, over the k from 1 to n that are prime to n. The intervals on the two sides of m/n
//! have the lengths 1/(n n₋) and 1/(n n₊); for m = 1 the pieces (0, 1/(2n)) and (1/(2n), 1/n) together have
//! 1/n, and n₊ = 1. Here n₊ is the inverse of m modulo n, and n₋ = n − n₊ that of n − m. As m runs through
//! the units below n/2, m and n − m run through all units, and so do their inverses. `proofs/` has the proof.
//!
//! At a random s, all equally likely, period n ≥ 3 exists with probability 2L_n in one case or another.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::intervals::check_period;
use crate::{
    error::{Error, Result},
    monitor::Monitor,
};

/// The largest period whose measure is given as a fraction: that of a million has 430,000 digits.
pub const MAX_EXACT: u64 = 1_000_000;

/// L_n, in lowest terms.
///
/// Cost: for the k without a prime factor above √n, n divisions of a number of O(√n) bits; for the others a
/// tree of products of O(n) bits in all. Memory: O(n^1.5) bits.
///
/// # Errors
/// An input error unless 3 ≤ n ≤ [`MAX_EXACT`].
///
/// ```
/// use grazing::existence::{intervals, measure};
/// // (1/8)(1 + 1/3 + 1/5 + 1/7)
/// assert_eq!(measure(8)?.to_string(), "22/105");
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn measure(n: u64) -> Result<BigRational> {
    if !(3..=MAX_EXACT).contains(&n) {
        return Err(Error::input(format!(
            "the measure of a period is a fraction for n from 3 to {MAX_EXACT}, not for {n}"
        )));
    }
    let least = least_factors(n);
    let root = n.isqrt();
    // E, a multiple of every k ≤ n that is prime to n and has no prime factor above √n.
    let small = (2..=root).filter(|&p| least[p as usize] as u64 == p && !n.is_multiple_of(p));
    let common: BigUint = small.map(|p| p.pow(n.ilog(p))).map(BigUint::from).product();
    // largest[k]: the largest prime factor of k; `smooth`: E Σ 1/k over those k.
    let mut largest = vec![1u32; n as usize + 1];
    let mut smooth = BigUint::zero();
    // harmonic[j] = E (1 + … + 1/j) over the same for j ≤ √n.
    let mut harmonic = vec![BigUint::zero(); root as usize + 1];
    let mut large = Vec::new();
    for k in 1..=n {
        let factor = least[k as usize];
        largest[k as usize] = if k == 1 { 1 } else { factor.max(largest[(k / u64::from(factor)) as usize]) };
        let unit = k.gcd(&n) == 1;
        if unit && u64::from(largest[k as usize]) <= root {
            smooth += &common / k;
        }
        if k <= root {
            harmonic[k as usize] = smooth.clone();
        }
        if unit && k > root && u64::from(factor) == k {
            large.push(k);
        }
    }
    // The k with the large prime p are p j, j ≤ n/p < √n: together harmonic[n/p]/p. If p divides that, the
    // fraction is an integer; else p stays in the denominator, as no other term has it.
    let mut terms = Vec::new();
    for p in large {
        let sum = &harmonic[(n / p) as usize];
        if (sum % p).is_zero() { smooth += sum / p } else { terms.push((sum.clone(), BigUint::from(p))) }
    }
    let (top, bottom) = sum(terms);
    let top = &smooth * &bottom + top;
    // Of E n alone factors cancel.
    let rest = common * n;
    let cancel = (&top % &rest).gcd(&rest);
    let fraction = (top / &cancel, bottom * (rest / cancel));
    Ok(BigRational::new_raw(BigInt::from(fraction.0), BigInt::from(fraction.1)))
}

/// The sum of fractions over the product of their denominators, by halves.
fn sum(mut terms: Vec<(BigUint, BigUint)>) -> (BigUint, BigUint) {
    while terms.len() > 1 {
        let mut pairs = terms.into_iter();
        let mut next = Vec::with_capacity(pairs.len() / 2 + 1);
        while let Some((a, b)) = pairs.next() {
            next.push(match pairs.next() {
                Some((c, d)) => (a * &d + c * &b, b * d),
                None => (a, b),
            });
        }
        terms = next;
    }
    terms.pop().unwrap_or((BigUint::zero(), BigUint::one()))
}

/// The least prime factor of every number up to `last`.
fn least_factors(last: u64) -> Vec<u32> {
    let mut least = vec![0u32; last as usize + 1];
    for p in 2..=last as usize {
        if least[p] == 0 {
            for multiple in (p..=last as usize).step_by(p) {
                if least[multiple] == 0 {
                    // At most MAX_PERIOD.
                    least[multiple] = p as u32;
                }
            }
        }
    }
    least
}

/// Bits behind the point of an enclosure. Sums of less than 2⁸ fit 128 bits with them.
const BITS: u32 = 120;

/// The most decimals asked of an enclosure: for n up to 10⁷ it is narrower than 10⁻²⁸.
pub const MAX_DECIMALS: u32 = 24;

/// A number between two multiples of 2⁻¹²⁰.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NarrowBounds {
    lower: u128,
    upper: u128,
}

impl NarrowBounds {
    /// Both bounds, exactly.
    pub fn exact(&self) -> (BigRational, BigRational) {
        let ratio = |x: u128| BigRational::new(BigInt::from(x), BigInt::one() << BITS);
        (ratio(self.lower), ratio(self.upper))
    }

    /// The number rounded to `decimals` decimals, from 1 to [`MAX_DECIMALS`]: every digit is certain. Should
    /// the enclosure not decide the last ones, there are fewer; with none left it is the lower bound's.
    pub fn decimals(&self, decimals: u32) -> String {
        let rounded = |x: u128, decimals: u32| -> BigUint {
            (BigUint::from(x) * 10u32.pow(decimals.min(9)) * 10u64.pow(decimals - decimals.min(9))
                + (BigUint::one() << (BITS - 1)))
                >> BITS
        };
        let mut decimals = decimals.min(MAX_DECIMALS);
        loop {
            let digits = rounded(self.lower, decimals);
            if digits != rounded(self.upper, decimals) && decimals > 0 {
                decimals -= 1;
                continue;
            }
            let width = decimals as usize + 1;
            let digits = format!("{digits:0>width$}");
            let (whole, rest) = digits.split_at(digits.len() - decimals as usize);
            return if rest.is_empty() { whole.to_string() } else { format!("{whole}.{rest}") };
        }
    }
}

/// What [`measures`] finds of a period.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct PeriodMeasure {
    /// The period n.
    pub n: u64,
    /// L_n.
    pub length: NarrowBounds,
    /// 2(L_3 + … + L_n): how many of the periods 3 to n exist at a random s, in the mean.
    pub mean: NarrowBounds,
}

/// The measures of the periods from 3 to `last`, each with the mean number of periods up to it, handed to
/// `each` in order.
///
/// Σ 1/k = Σ_d µ(d)/d (1 + 1/2 + … + d/n) over the divisors d of n. Cost: O(log n) divisions per period in
/// the mean. Memory: 20 bytes per period.
///
/// # Errors
/// An input error unless `last` ≤ [`MAX_PERIOD`](super::MAX_PERIOD); that of `each`; the monitor's
/// interruption.
pub fn measures(
    last: u64,
    monitor: &dyn Monitor,
    mut each: impl FnMut(PeriodMeasure) -> Result<()>,
) -> Result<()> {
    check_period(last)?;
    let least = least_factors(last);
    // harmonic[m] ≤ 2¹²⁰ (1 + … + 1/m) < harmonic[m] + m.
    let mut harmonic = vec![0u128; last as usize + 1];
    for m in 1..=last as usize {
        harmonic[m] = harmonic[m - 1] + (1 << BITS) / m as u128;
    }
    let mut mean = NarrowBounds { lower: 0, upper: 0 };
    for n in 3..=last {
        // (d, µ(d)) for the squarefree divisors.
        let mut divisors = vec![(1u64, true)];
        let mut rest = n;
        while rest > 1 {
            let p = u64::from(least[rest as usize]);
            while rest.is_multiple_of(p) {
                rest /= p;
            }
            divisors.extend(divisors.clone().into_iter().map(|(d, even)| (d * p, !even)));
        }
        // Sums of the terms with µ = 1 and with µ = −1, and by how much each may be too small: a quotient by
        // less than 1, harmonic[n/d]/d by (n/d)/d.
        let (mut sums, mut slack) = ([0u128; 2], [0u128; 2]);
        for (d, even) in divisors {
            sums[usize::from(even)] += harmonic[(n / d) as usize] / u128::from(d);
            slack[usize::from(even)] += u128::from(n / d / d) + 2;
        }
        let lower = (sums[1] - sums[0] - slack[0]) / u128::from(n);
        let upper = (sums[1] + slack[1] - sums[0]) / u128::from(n) + 1;
        mean = NarrowBounds { lower: mean.lower + 2 * lower, upper: mean.upper + 2 * upper };
        each(PeriodMeasure { n, length: NarrowBounds { lower, upper }, mean })?;
        if n % 4096 == 0 {
            monitor.advance(0)?;
        }
    }
    Ok(())
}
