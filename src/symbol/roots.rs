//! The roots cos(πj/n) of u_n, separated by rationals that are proved to separate them.
//!
//! At a₁ = 2rc, a₂ = r² one has u_k = r^{k−1} U_{k−1}(c), U the Chebyshev polynomials of the second kind.
//! U_{n−1}, …, U_0 is a Sturm sequence: U_{k+1} = 2c U_k − U_{k−1} gives a zero inside opposite neighbours,
//! and at a root c = cos θ of U_{n−1} both U'_{n−1} = −n cos nθ / sin²θ and U_{n−2} = −cos nθ have one sign.
//! At c = 1 all are positive. So the changes of sign at x count the roots above x, with integers alone.

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::One;

/// How many of cos(πj/n), 1 ≤ j ≤ n − 1, exceed `x`, and whether `x` is one of them; by Sturm's theorem.
///
/// Exact. Cost: n products of integers of n times the bits of `x`.
///
/// ```
/// use grazing::{number::parse_rational, symbol::roots_above};
/// assert_eq!(roots_above(3, &parse_rational("0.49")?), (1, false)); // ±1/2
/// assert_eq!(roots_above(3, &parse_rational("1/2")?), (0, true));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn roots_above(n: usize, x: &BigRational) -> (usize, bool) {
    // q^k U_k(p/q), k = −1, 0, …, n − 1.
    let (twice, square) = (x.numer() * 2, x.denom() * x.denom());
    let (mut last, mut value) = (BigInt::ZERO, BigInt::one());
    let (mut sign, mut changes) = (Sign::Plus, 0);
    for _ in 1..n {
        let next = &twice * &value - &square * last;
        (last, value) = (value, next);
        if value.sign() != Sign::NoSign && value.sign() != sign {
            sign = value.sign();
            changes += 1;
        }
    }
    (changes, value.sign() == Sign::NoSign)
}

/// Rationals p < q between which cos(πj/n), 1 ≤ j ≤ n − 1, is the only root of U_{n−1}; neither is a root.
///
/// Proved by [`roots_above`]. The lower bound for j is the upper one for j + 1.
///
/// Cost: O(log n) calls of [`roots_above`], since roots are at least about 1/n² apart.
///
/// ```
/// use grazing::{number::parse_rational, symbol::chebyshev_roots};
/// let [below, above] = chebyshev_roots(3, 1); // cos(π/3) = 1/2
/// let half = parse_rational("1/2")?;
/// assert!(below < half && half < above);
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn chebyshev_roots(n: usize, j: usize) -> [BigRational; 2] {
    [separator(n, j), separator(n, j - 1)]
}

/// A dyadic with exactly j of the roots above it and none equal to it; 1 for j = 0, −1 for j = n − 1.
fn separator(n: usize, j: usize) -> BigRational {
    let (mut low, mut high) = (-BigRational::one(), BigRational::one());
    if j == 0 {
        return high;
    }
    if j >= n - 1 {
        return low;
    }
    loop {
        let middle = (&low + &high) / BigInt::from(2);
        match roots_above(n, &middle) {
            (above, false) if above == j => return middle,
            (above, _) if above < j => high = middle,
            _ => low = middle,
        }
    }
}
