//! The units modulo n with their inverses, many at a time.
//!
//! By Montgomery's trick: the inverse of a product gives that of each factor by products alone, so a block
//! takes one run of Euclid's algorithm. What is no unit is struck out by the primes of n before.

use std::ops::Range;

/// A unit m modulo n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Unit {
    /// m.
    pub(crate) m: u64,
    /// n₊ in 1..n, or 1 for n = 2, with m n₊ ≡ 1 modulo n.
    pub(crate) inverse: u64,
    /// (m n₊ − 1)/n.
    pub(crate) quotient: u64,
}

/// The units of a range, ascending. Memory: O(1).
pub(super) struct Units {
    modulus: Modulus,
    /// The primes of n.
    primes: Vec<u64>,
    /// What is not looked at yet.
    rest: Range<u64>,
    /// The units of a block.
    units: Vec<u32>,
    /// Their inverses; on the way there, the product of those before each in its chain.
    inverses: Vec<u32>,
    /// Those that were given.
    given: usize,
}

/// Candidates in a block: few enough that the first unit comes soon.
const BLOCK: usize = 512;

/// Products run in so many chains side by side, as each waits for the one before.
const CHAINS: usize = 8;

impl Units {
    /// The units m modulo `n` of a range. Cost: O(√n), then O(1) each and O(log n) per block.
    ///
    /// Precondition: 2 ≤ n < 2²⁴, and 1 ≤ m < n in the range.
    pub fn new(n: u64, range: Range<u64>) -> Units {
        debug_assert!((2..1 << 24).contains(&n) && range.start >= 1 && range.end <= n);
        let primes = primes_of(n);
        let (units, inverses) = (Vec::new(), Vec::new());
        Units { modulus: Modulus::new(n), primes, rest: range, units, inverses, given: 0 }
    }

    /// The next block.
    fn fill(&mut self) {
        let start = self.rest.start;
        let end = self.rest.end.min(start + BLOCK as u64);
        self.rest.start = end;
        let length = (end - start) as usize;
        let mut struck = [false; BLOCK];
        for &p in &self.primes {
            let first = (p - start % p) % p;
            struck[..length].iter_mut().skip(first as usize).step_by(p as usize).for_each(|at| *at = true);
        }
        self.units.clear();
        let candidates = (start..end).zip(&struck);
        self.units.extend(candidates.filter(|(_, struck)| !**struck).map(|(m, _)| m as u32));
        self.inverses.clear();
        self.inverses.resize(self.units.len(), 0);
        self.given = 0;
        self.invert();
    }

    fn invert(&mut self) {
        let modulus = self.modulus;
        // Of each chain; the k-th has every CHAINS-th unit, from the k-th on.
        let mut products = [1; CHAINS];
        for (units, before) in self.units.chunks(CHAINS).zip(self.inverses.chunks_mut(CHAINS)) {
            for ((&m, before), product) in units.iter().zip(before).zip(&mut products) {
                *before = *product as u32;
                *product = modulus.product(*product, u64::from(m));
            }
        }
        let mut before = [1; CHAINS];
        for k in 1..CHAINS {
            before[k] = modulus.product(before[k - 1], products[k - 1]);
        }
        let all = modulus.product(before[CHAINS - 1], products[CHAINS - 1]);
        let mut inverse = inverse(all, modulus.n);
        // Of the product of what is left of each chain.
        let mut inverses = [0; CHAINS];
        for k in (0..CHAINS).rev() {
            inverses[k] = modulus.product(inverse, before[k]);
            inverse = modulus.product(inverse, products[k]);
        }
        for (units, found) in self.units.chunks(CHAINS).zip(self.inverses.chunks_mut(CHAINS)).rev() {
            for ((&m, found), inverse) in units.iter().zip(found).zip(&mut inverses) {
                *found = modulus.product(*inverse, u64::from(*found)) as u32;
                *inverse = modulus.product(*inverse, u64::from(m));
            }
        }
    }
}

impl Iterator for Units {
    type Item = Unit;

    #[inline]
    fn next(&mut self) -> Option<Unit> {
        while self.given == self.units.len() {
            if self.rest.is_empty() {
                return None;
            }
            self.fill();
        }
        let (m, inverse) = (u64::from(self.units[self.given]), u64::from(self.inverses[self.given]));
        self.given += 1;
        let (quotient, remainder) = self.modulus.divide(m * inverse);
        debug_assert_eq!(remainder, 1);
        Some(Unit { m, inverse, quotient })
    }
}

/// Division by n as a multiplication.
#[derive(Debug, Clone, Copy)]
struct Modulus {
    n: u64,
    /// ⌊(2⁶⁴ − 1)/n⌋.
    factor: u64,
}

impl Modulus {
    fn new(n: u64) -> Modulus {
        Modulus { n, factor: u64::MAX / n }
    }

    /// Quotient and remainder of x < 2⁴⁸. The factor is 2⁶⁴/n less at most 1 + 1/n, so the first quotient is
    /// less than x/n by no more than 2⁻¹⁵, and its floor is at most one too small.
    #[inline]
    fn divide(self, x: u64) -> (u64, u64) {
        let quotient = ((u128::from(x) * u128::from(self.factor)) >> 64) as u64;
        let rest = x - quotient * self.n;
        if rest >= self.n { (quotient + 1, rest - self.n) } else { (quotient, rest) }
    }

    /// a b modulo n, both below 2²⁴.
    #[inline]
    fn product(self, a: u64, b: u64) -> u64 {
        self.divide(a * b).1
    }
}

/// The primes of n, ascending, by trial division.
fn primes_of(mut n: u64) -> Vec<u64> {
    let (mut primes, mut p) = (Vec::new(), 2);
    while p * p <= n {
        if n.is_multiple_of(p) {
            primes.push(p);
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        p += if p == 2 { 1 } else { 2 };
    }
    if n > 1 {
        primes.push(n);
    }
    primes
}

/// The inverse modulo n of a unit m < n < 2³¹, by Euclid's algorithm.
fn inverse(m: u64, n: u64) -> u64 {
    // Bézout coefficients of m stay within n in absolute value.
    let (mut a, mut b) = (n as u32, m as u32);
    let (mut x, mut y) = (0i32, 1i32);
    while b != 0 {
        let quotient = a / b;
        (a, b) = (b, a - quotient * b);
        (x, y) = (y, x - quotient as i32 * y);
    }
    debug_assert_eq!(a, 1);
    if x < 0 { n - u64::from(x.unsigned_abs()) } else { x as u64 }
}

#[cfg(test)]
mod tests {
    use num_integer::Integer;
    use proptest::prelude::*;

    use super::*;

    /// By the definition: every m of the range with gcd(m, n) = 1, and what solves m x = 1 + n y.
    fn are_units(n: u64, range: Range<u64>) {
        let found: Vec<Unit> = Units::new(n, range.clone()).collect();
        let wanted: Vec<u64> = range.filter(|m| m.gcd(&n) == 1).collect();
        assert_eq!(found.iter().map(|unit| unit.m).collect::<Vec<_>>(), wanted, "modulo {n}");
        for Unit { m, inverse, quotient } in found {
            assert!((1..n).contains(&inverse) && m * inverse == 1 + n * quotient, "{m} modulo {n}");
        }
    }

    #[test]
    fn all_units_of_small_moduli() {
        (2..=600).for_each(|n| are_units(n, 1..n));
    }

    /// Primes, a power of 2, a product of many primes, and one of two large ones.
    #[test]
    fn blocks_end_anywhere() {
        let length = BLOCK as u64;
        for n in [1_021, 4_096, 30_030, 9_699_690, 9_999_991, 10_000_000, 3_137 * 3_163, (1 << 24) - 1] {
            for start in [1, 2, 1_000, n - length - 2, n - 2, n - 1] {
                for more in [0, 1, CHAINS as u64, length - 1, length, length + 1, 2 * length + 1] {
                    are_units(n, start.min(n - 1)..(start + more).min(n));
                }
            }
        }
    }

    proptest! {
        #[test]
        fn a_division_is_that_of_the_processor(n in 2u64..1 << 24, x in 0u64..1 << 48, near in 0u64..3) {
            let multiple = x / n * n;
            for x in [x, multiple, multiple.saturating_sub(near), (1 << 48) - 1 - near] {
                prop_assert_eq!(Modulus::new(n).divide(x), (x / n, x % n));
            }
        }

        #[test]
        fn any_range_of_any_modulus(n in 2u64..1 << 24, start: u64, length in 0u64..1_100) {
            let start = 1 + start % (n - 1);
            are_units(n, start..(start + length).min(n));
        }
    }
}
