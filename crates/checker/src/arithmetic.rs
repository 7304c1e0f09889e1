//! The checker's own arithmetic: small fractions, signs of sin πjs over intervals, modular inverses.
//!
//! Precondition throughout: periods are at most [`MOST`] and denominators at most twice that, so that every
//! product of two numbers stays below 2·10¹¹ and nothing overflows 64 bits. (r_max, a [`Fraction`] too, is
//! only ever read and shown.)

use std::fmt;

/// The largest period a certificate may speak of.
pub(super) const MOST: u64 = 200_000;

/// A fraction p/q in lowest terms with 0 ≤ p ≤ q, q ≥ 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    p: u64,
    q: u64,
}

impl Fraction {
    pub(super) const ZERO: Fraction = Fraction { p: 0, q: 1 };
    pub(super) const HALF: Fraction = Fraction { p: 1, q: 2 };

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
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.p, self.q)
    }
}

/// j·s as ⌊j·s⌋ and what is left over, which a step from j to j ± 1 brings up to date by additions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Multiple {
    s: Fraction,
    j: u64,
    floor: u64,
    /// j p − q floor, from 0 to q − 1.
    rest: u64,
}

impl Multiple {
    pub fn of(s: Fraction, j: u64) -> Multiple {
        Multiple { s, j, floor: j * s.p / s.q, rest: j * s.p % s.q }
    }

    pub fn j(self) -> u64 {
        self.j
    }

    /// To j + 1.
    pub fn up(&mut self) {
        self.j += 1;
        self.rest += self.s.p;
        // p ≤ q: the floor rises by at most 1.
        if self.rest >= self.s.q {
            self.rest -= self.s.q;
            self.floor += 1;
        }
    }

    /// To j − 1.
    pub fn down(&mut self) {
        self.j -= 1;
        if self.rest < self.s.p {
            self.rest += self.s.q;
            self.floor -= 1;
        }
        self.rest -= self.s.p;
    }

    pub fn is_integer(self) -> bool {
        self.rest == 0
    }

    /// Whether ⌊j s⌋ is odd: sin πjs < 0 just right of s, and at s unless it is 0 there.
    pub fn is_odd(self) -> bool {
        self.floor % 2 == 1
    }

    /// Whether no integer lies strictly between j·s and j·right: sin πjx has no zero in s < x < right.
    pub fn no_integer_before(self, right: Fraction) -> bool {
        self.j * right.p <= (self.floor + 1) * right.q
    }
}

/// The signs just right of a point, on an interval without multiples of 1/(2n).
#[derive(Debug, Clone, Copy)]
pub(super) struct Signs {
    /// Whether sin nπs < 0.
    sine: bool,
    /// Whether cos nπs = sin (ns + ½)π < 0: whether ⌊ns + ½⌋ = ⌊(2np + q)/(2q)⌋ is odd.
    cosine: bool,
}

impl Signs {
    pub fn new(n: u64, Fraction { p, q }: Fraction) -> Signs {
        Signs { sine: n * p / q % 2 == 1, cosine: (2 * n * p + q) / (2 * q) % 2 == 1 }
    }

    /// Whether b_{n,k} = −2 sin kπs sin (n−k)πs / cos nπs < 0, given the multiples k and n − k; none of the
    /// three is zero.
    pub fn b_negative(self, k: Multiple, rest: Multiple) -> bool {
        !(k.is_odd() ^ rest.is_odd() ^ self.cosine)
    }

    /// Whether c_n = −2 sin 2πs tan nπs < 0.
    pub fn c_negative(self) -> bool {
        !(self.sine ^ self.cosine)
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_and_jumps_agree() {
        for (p, q) in [(0, 1), (1, 1), (1, 2), (3, 7), (7, 16)] {
            let s = Fraction::new(p, q).unwrap();
            let (mut up, mut down) = (Multiple::of(s, 0), Multiple::of(s, 60));
            for j in 0..=60 {
                for (j, walked) in [(j, up), (60 - j, down)] {
                    let jumped = Multiple::of(s, j);
                    assert_eq!((walked.j, walked.floor, walked.rest), (j, jumped.floor, jumped.rest));
                }
                if j < 60 {
                    up.up();
                    down.down();
                }
            }
        }
    }
}
