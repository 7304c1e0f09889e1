//! Exact signs of b_{n,k} and c_n on r = 1, at rational s and just to the right of it.
//!
//! By (B1) and (B2), for s in (0, ½):
//! sign b_{n,k} = −sign(sin kπs · sin (n−k)πs · cos nπs) and sign c_n = −sign(sin nπs · cos nπs),
//! and sin πjp/q > 0 iff jp mod 2q lies in (0, q). Everything is integer arithmetic.

use num_rational::Ratio;

/// Where a sign is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Approach {
    /// At s itself; a zero or pole gives 0.
    At,
    /// On (s, s + ε) for every small ε > 0; never 0.
    JustRight,
}

/// The signs at one rational s = p/q in [0, ½), or just right of it.
///
/// Precondition: n ≤ [`MAX_PERIOD`](super::MAX_PERIOD) and q ≤ 2n, so that no product overflows.
#[derive(Debug, Clone, Copy)]
pub struct Signs {
    n: u64,
    p: u64,
    q: u64,
    side: Approach,
    /// −sign cos nπs.
    minus_cos: i8,
}

impl Signs {
    /// The signs for period `n` at `s`, or just right of it.
    pub fn new(n: u64, s: &Ratio<u64>, side: Approach) -> Self {
        let (p, q) = (*s.numer(), *s.denom());
        // cos y = sin(y + π/2), and nπp/q + π/2 = π(2np + q)/(2q).
        let minus_cos = -sin_sign((2 * n * p + q) % (4 * q), 2 * q, side);
        Signs { n, p, q, side, minus_cos }
    }

    /// sign sin jπs.
    fn sin(&self, j: u64) -> i8 {
        sin_sign(j * self.p % (2 * self.q), self.q, self.side)
    }

    /// Whether u_n = 0 at s: det D = 0 and Theorem 1 is silent.
    pub fn singular(&self) -> bool {
        self.side == Approach::At && (2 * self.n * self.p).is_multiple_of(self.q)
    }

    /// sign b_{n,k} by (B1), 1 ≤ k ≤ n−1; 0 also at a pole.
    pub fn b(&self, k: u64) -> i8 {
        self.minus_cos * self.sin(k) * self.sin(self.n - k)
    }

    /// sign c_n by (B2); 0 also at a pole.
    pub fn c(&self) -> i8 {
        self.minus_cos * self.sin(self.n)
    }

    /// sign b_{n,k} for k = 1, …, ⌊n/2⌋, which are all of them: b_{n,k} = b_{n,n−k}. Two additions each.
    pub fn all_b(&self) -> impl Iterator<Item = i8> {
        let Signs { n, p, q, side, minus_cos } = *self;
        // The two arguments modulo 2q, by their increments; p < 2q since s < ½.
        let (mut up, mut down) = (0, n * p % (2 * q));
        (1..=n / 2).map(move |_| {
            up += p;
            up -= if up >= 2 * q { 2 * q } else { 0 };
            down += if down < p { 2 * q } else { 0 };
            down -= p;
            // Each factor is −1, 0 or 1, so nothing wraps; a check of that costs a tenth of the time.
            minus_cos.wrapping_mul(sin_sign(up, q, side)).wrapping_mul(sin_sign(down, q, side))
        })
    }
}

/// sign sin(πt/q) for 0 ≤ t < 2q, at the point or just right of it.
fn sin_sign(t: u64, q: u64, side: Approach) -> i8 {
    let zero = side == Approach::At && (t == 0 || t == q);
    if zero {
        0
    } else if t < q {
        1
    } else {
        -1
    }
}
