//! The checker's own arithmetic: small fractions, signs of sin πjs over intervals, modular inverses.
//!
//! Precondition throughout: periods are at most [`MOST`] and denominators at most twice that, so that every
//! product of two numbers stays below 4·10¹⁴ and nothing overflows 64 bits.

use std::fmt;

/// The largest period a certificate may speak of.
pub(super) const MOST: u64 = 10_000_000;

/// A fraction p/q in lowest terms with 0 ≤ p ≤ q, q ≥ 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    p: u64,
    q: u64,
}

impl Fraction {
    /// p/q, if it is in lowest terms and within [0, 1].
    pub fn new(p: u64, q: u64) -> Option<Self> {
        (q > 0 && p <= q && gcd(p, q) == 1).then_some(Fraction { p, q })
    }

    /// p and q.
    pub(super) fn parts(self) -> (u64, u64) {
        (self.p, self.q)
    }

    /// Whether self < other, by cross-multiplication.
    pub(super) fn less(self, other: Fraction) -> bool {
        self.p * other.q < other.p * self.q
    }

    /// Whether j·self is an integer.
    pub(super) fn times_is_integer(self, j: u64) -> bool {
        (j * self.p).is_multiple_of(self.q)
    }

    /// Whether ⌊j·self⌋ is odd, that is sin πjs < 0 at and just right of self unless it is 0.
    pub(super) fn floor_is_odd(self, j: u64) -> bool {
        j * self.p / self.q % 2 == 1
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.p, self.q)
    }
}

/// Whether no integer lies strictly between j·left and j·right: sin πjs has no zero on the open interval.
pub(super) fn no_integer_between(j: u64, left: Fraction, right: Fraction) -> bool {
    j * right.p <= (j * left.p / left.q + 1) * right.q
}

/// The common sign, as "is negative", of b_{n,k} on an open interval without zero or pole of it: by (B1),
/// −2 sin kπs sin (n−k)πs / cos nπs with cos nπs = sin π(ns + ½).
pub(super) fn b_negative(n: u64, k: u64, left: Fraction) -> bool {
    !(left.floor_is_odd(k) ^ left.floor_is_odd(n - k) ^ cos_negative(n, left))
}

/// The sign, as "is negative", of c_n on an open interval without multiples of 1/(2n): by (B2),
/// −2 sin 2πs tan nπs.
pub(super) fn c_negative(n: u64, left: Fraction) -> bool {
    !(left.floor_is_odd(n) ^ cos_negative(n, left))
}

/// The sign of cos nπs right of `left`: ⌊ns + ½⌋ = ⌊(2np + q)/(2q)⌋ is odd.
fn cos_negative(n: u64, left: Fraction) -> bool {
    (2 * n * left.p + left.q) / (2 * left.q) % 2 == 1
}

pub(super) fn gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// The x in 1..=n with m x ≡ 1 modulo n, for coprime 1 ≤ m ≤ n, by descent: if n y ≡ −1 modulo m, then
/// m x = n y + 1.
pub(super) fn inverse(m: u64, n: u64) -> u64 {
    if m == 1 {
        return 1;
    }
    let y = m - inverse(n % m, m);
    (n * y + 1) / m
}
