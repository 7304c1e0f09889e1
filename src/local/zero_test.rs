//! Whether b_{n,k} is exactly zero at a rational (r, s): algebra, no enclosures.
//!
//! 2i·M = r^j(ζⁿ − ζ⁻ⁿ) − (ζ^k − ζ^−k) − rⁿ(ζ^j − ζ^−j), ζ a primitive q-th root of unity, s = p/q. A
//! polynomial f has f(ζ) = 0 iff f·Π (x^{q/ℓ} − 1), over the primes ℓ | q, vanishes modulo x^q − 1: the
//! factors are zero at every q-th root of unity but the primitive ones. That product has at most 6·2^ω(q)
//! terms, however large q is.
//!
//! Most q need none of this: in a vanishing sum of at most six roots of unity with rational coefficients, of
//! which no part vanishes, the ratio of two roots is a 30th root of unity (H. B. Mann, Mathematika 12 (1965)
//! 107–117: one whose order is a product of distinct primes up to the number of terms). So ζⁿ has such a
//! ratio to one of ζ⁻ⁿ, ζ^±k, ζ^±j, and q divides 30 times one of 2n, j, n + k, k, n + j. Only completeness
//! rests on it: what it rules out is left to enclosures.

use std::collections::BTreeMap;

use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, Pow, ToPrimitive, Zero, pow};

use super::Polar;

/// The primes that divide q are sought below this by trial division; one more may be left over, below its
/// square.
const TRIAL: u32 = 1 << 20;

/// More distinct primes than this and the product is not written out.
const PRIMES: usize = 12;

/// Whether M = 0; `None` if q could not be factored within [`TRIAL`] or has more than [`PRIMES`] primes.
///
/// Decides every n, k and r for such q. Cost: five remainders for all q but some below 2⁷⁰, where at most
/// [`TRIAL`] divisions of q by a word and O(6·2^ω(q)) sums follow.
pub(super) fn numerator_vanishes(point: &Polar, n: u64, k: u64) -> Option<bool> {
    if is_ruled_out(point.s().denom().magnitude(), n, k) { Some(false) } else { by_division(point, n, k) }
}

/// Whether M ≠ 0 by Mann's theorem.
fn is_ruled_out(q: &BigUint, n: u64, k: u64) -> bool {
    let wide = u128::from;
    let differences = [2 * wide(n), wide(n - k), wide(n) + wide(k), wide(k), wide(n) + wide(n - k)];
    q.to_u128().is_none_or(|q| differences.iter().all(|d| !(30 * d).is_multiple_of(q)))
}

/// Whether M = 0, by division by the cyclotomic polynomial.
fn by_division(point: &Polar, n: u64, k: u64) -> Option<bool> {
    let q = point.s().denom().magnitude();
    let p = point.s().numer().magnitude();
    let primes = prime_factors(q.clone())?;
    // Exponent of e^{2πi/q} → coefficients of 1, r^j, rⁿ; each at most 6·2^12 in size.
    let mut sum: BTreeMap<BigUint, [i64; 3]> = BTreeMap::new();
    for (index, which, coefficient) in [(n, 1, 1), (k, 0, -1), (n - k, 2, -1)] {
        let exponent = p * index % q;
        let mirror = (q - &exponent) % q;
        sum.entry(exponent).or_default()[which] += coefficient;
        sum.entry(mirror).or_default()[which] -= coefficient;
    }
    for prime in primes {
        let step = q / prime;
        let mut product: BTreeMap<BigUint, [i64; 3]> = BTreeMap::new();
        for (exponent, coefficients) in sum {
            let shifted = (&exponent + &step) % q;
            for (place, sign) in [(shifted, 1), (exponent, -1)] {
                let entry = product.entry(place).or_default();
                for (total, c) in entry.iter_mut().zip(coefficients) {
                    *total += sign * c;
                }
            }
        }
        sum = product;
    }
    Some(sum.values().all(|&coefficients| combination_vanishes(coefficients, point.r(), n, k)))
}

fn prime_factors(mut q: BigUint) -> Option<Vec<BigUint>> {
    let mut primes = Vec::new();
    for candidate in std::iter::once(2).chain((3..TRIAL).step_by(2)) {
        if q.is_one() || primes.len() > PRIMES {
            break;
        }
        if (&q % candidate).is_zero() {
            while (&q % candidate).is_zero() {
                q /= candidate;
            }
            primes.push(BigUint::from(candidate));
        }
    }
    if !q.is_one() {
        if q >= BigUint::from(TRIAL).pow(2u32) {
            return None;
        }
        primes.push(q);
    }
    (primes.len() <= PRIMES).then_some(primes)
}

/// Whether a + b r^j + c rⁿ = 0, j = n − k, for |a|, |b|, |c| < 2³¹, r = x/y in lowest terms, 0 < x < y.
///
/// That is a yⁿ + b x^j y^k + c xⁿ = 0, where y^k | c and x^j | a: for large n one divisor outgrows its
/// multiple, and no large power is ever written out.
fn combination_vanishes([a, b, c]: [i64; 3], r: &BigRational, n: u64, k: u64) -> bool {
    let j = n - k;
    let (x, y) = (r.numer(), r.denom());
    let power = |base: &BigInt, exponent: u64| pow(base.clone(), exponent.to_usize().unwrap_or(usize::MAX));
    if (a, b, c) == (0, 0, 0) {
        return true;
    }
    if n <= 64 {
        return (a * power(y, n) + b * power(x, j) * power(y, k) + c * power(x, n)).is_zero();
    }
    if k >= 32 {
        // y^k ≥ 2³² > |c|, so c = 0 and a y^j + b x^j = 0, where y^j | b and x^j | a.
        return c == 0 && j < 32 && (a * power(y, j) + b * power(x, j)).is_zero();
    }
    // j ≥ 33. If a ≠ 0: x^j | a forces x = 1, and then |a| yⁿ ≥ 2³³ y^k outweighs the other two terms.
    a == 0 && (b * power(y, k) + c * power(x, k)).is_zero()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_rational;

    fn vanishes(r: &str, s: &str, n: u64, k: u64) -> Option<bool> {
        let number = |text| parse_rational(text).unwrap();
        numerator_vanishes(&Polar::new(number(r), number(s)).unwrap(), n, k)
    }

    #[test]
    fn finds_zeros_and_only_zeros() {
        assert_eq!(vanishes("1/2", "1/5", 5, 2), Some(false));
        // M = 0 with all three sines zero (a singular point), for n far beyond any power written out.
        assert_eq!(vanishes("1/2", "1/4", 4, 2), Some(true));
        assert_eq!(vanishes("2/3", "5/12", 1_200_000_000, 12), Some(true));
        assert_eq!(vanishes("2/3", "5/12", 1_200_000_000, 13), Some(false));
        // A denominator with two large primes, 1048583·1048589, is beyond the test where it divides k.
        assert_eq!(vanishes("1/2", "1/1099532599387", 5, 2), Some(false));
        assert_eq!(vanishes("1/2", "1/1099532599387", 1_099_532_599_394, 1_099_532_599_387), None);
    }

    /// Mann's theorem rules out no zero, and but for zeros and some others, everything.
    #[test]
    fn what_is_ruled_out_is_no_zero() {
        let half = parse_rational("1/2").unwrap();
        let (mut zeros, mut ruled_out) = (0, 0);
        for (q, n) in (3..100u64).flat_map(|q| (2..14).map(move |n| (q, n))) {
            let s = BigRational::new(1.into(), q.into());
            for k in 1..n {
                let zero = by_division(&Polar::new(half.clone(), s.clone()).unwrap(), n, k).unwrap();
                let out = is_ruled_out(&q.into(), n, k);
                assert!(!(zero && out), "q = {q}, n = {n}, k = {k}");
                (zeros, ruled_out) = (zeros + u32::from(zero), ruled_out + u32::from(out));
            }
        }
        assert!(zeros > 20 && ruled_out > 2000, "{zeros} {ruled_out}");
    }

    #[test]
    fn combinations_agree_with_powers_written_out() {
        for n in 65..70u64 {
            for k in [1, 2, 31, 32, 33, n - 2, n - 1] {
                for (x, y) in [(1, 2), (1, 3), (2, 3)] {
                    let r = BigRational::new(BigInt::from(x), BigInt::from(y));
                    for coefficients in [
                        [0, 1, -1],
                        [1, 0, 0],
                        [0, 2, -4],
                        [0, 4, -9],
                        [2, -1, 0],
                        [4, -9, 0],
                        [0, 1, -2],
                        [1, -2, 0],
                        [1, -4, 1],
                    ] {
                        let [a, b, c] = coefficients.map(|c| BigRational::from_integer(BigInt::from(c)));
                        let power = |e: u64| pow(r.clone(), e as usize);
                        let expected = (a + b * power(n - k) + c * power(n)).is_zero();
                        assert_eq!(
                            combination_vanishes(coefficients, &r, n, k),
                            expected,
                            "{coefficients:?} {r} {n} {k}"
                        );
                    }
                }
            }
        }
    }
}
