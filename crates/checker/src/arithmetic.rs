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

    /// Whether every fraction x/y between the two has y ≥ n: they are neighbours p/q < p'/q', for which y =
    /// q(p'y − q'x) + q'(xq − py) ≥ q + q'.
    pub(super) fn nothing_below(self, right: Fraction, n: u64) -> bool {
        right.p * self.q == self.p * right.q + 1 && self.q + right.q >= n
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

/// j·s as ⌊j·s⌋.
#[derive(Debug, Clone, Copy)]
pub(super) struct Multiple {
    j: u64,
    floor: u64,
}

impl Multiple {
    pub fn of(s: Fraction, j: u64) -> Multiple {
        Multiple { j, floor: j * s.p / s.q }
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

/// For how many k, 0 < k < n, ⌊ks⌋ + ⌊(n−k)s⌋ is one less than ⌊ns⌋; for the others they are equal. So their
/// number is the sum of ⌊ns⌋ − ⌊ks⌋ − ⌊(n−k)s⌋ over k.
pub(super) fn carries(n: u64, s: Fraction) -> u64 {
    (n - 1) * (n * s.p / s.q) - 2 * floors(n, s.p, s.q, 0)
}

/// Σ ⌊(kp + c)/q⌋ over 0 ≤ k < n, n ≥ 1, q > 0.
///
/// With p, c < q it is the number of points (k, y) of integers with 0 ≤ k < n and 1 ≤ y ≤ (kp + c)/q. There
/// are none with y > Y = ⌊last/q⌋, last = np + c. Of y = Y − i there are those with n > k ≥ (yq − c)/p,
/// ⌊(last − yq)/p⌋ = ⌊(iq + last mod q)/p⌋ of them: the same sum again, over 0 ≤ i < Y.
fn floors(n: u64, p: u64, q: u64, c: u64) -> u64 {
    let whole = n * (n - 1) / 2 * (p / q) + n * (c / q);
    let (p, c) = (p % q, c % q);
    let last = n * p + c;
    if last < q { whole } else { whole + floors(last / q, q, p, last % q) }
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

    fn carries_by_definition(n: u64, s: Fraction) -> u64 {
        let floor = |j| Multiple::of(s, j).floor;
        (1..n).filter(|&k| floor(k) + floor(n - k) < floor(n)).count() as u64
    }

    #[test]
    fn carries_are_counted() {
        for q in 1..=60 {
            for s in (0..=q).filter_map(|p| Fraction::new(p, q)) {
                (1..=60).for_each(|n| assert_eq!(carries(n, s), carries_by_definition(n, s), "{n} {s}"));
            }
        }
    }

    /// With the largest numbers that are allowed.
    #[test]
    fn counts_do_not_overflow() {
        let (n, q) = (MOST, 2 * MOST);
        for (p, q) in [(1, 1), (1, 2), (1, q), (3, q), (n - 1, q), (q - 1, q), (123_456, 199_999)] {
            let s = Fraction::new(p, q).unwrap();
            assert_eq!(carries(n, s), carries_by_definition(n, s), "{s}");
        }
    }

    /// Of all fractions between two.
    #[test]
    fn between_neighbours_denominators_are_large() {
        let all: Vec<Fraction> =
            (1..=12).flat_map(|q| (0..=q).filter_map(move |p| Fraction::new(p, q))).collect();
        for (&left, &right) in all.iter().flat_map(|left| all.iter().map(move |right| (left, right))) {
            let least = (1..=30).find(|&j| !Multiple::of(left, j).no_integer_before(right));
            for n in 1..=30 {
                let holds = left.nothing_below(right, n);
                assert!(!holds || least.is_none_or(|least| least >= n), "{left} {right} {n}");
                assert!(holds || right.p * left.q != left.p * right.q + 1 || least.unwrap() < n);
            }
        }
    }
}
