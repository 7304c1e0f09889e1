//! Theorem 2's list of intervals.

use super::super::arithmetic::{Fraction, gcd, inverse};

/// An interval of Theorem 2: left end, right end, eµ > 0, γ > 0.
pub(crate) type Listed = (Fraction, Fraction, bool, bool);

/// Theorem 2's intervals for one n, from left to right.
pub(crate) struct Theorem {
    n: u64,
    /// The next m to take.
    m: u64,
    /// The second interval of the latest m, if it has one.
    second: Option<Listed>,
}

impl Theorem {
    pub fn new(n: u64) -> Self {
        Theorem { n, m: 0, second: None }
    }

    pub fn next(&mut self) -> Option<Listed> {
        if let Some(interval) = self.second.take() {
            return Some(interval);
        }
        let (n, m) = (self.n, self.m);
        self.m = (m + 1..=n).find(|&next| gcd(next, n) == 1).unwrap_or(n);
        if m == 0 {
            let (zero, end) = (Fraction::new(0, 1)?, Fraction::new(1, 2 * n)?);
            if n == 1 {
                self.second = Some((zero, end, false, true));
            }
            return Some((zero, end, n == 1, n != 1));
        }
        if 2 * m > n {
            return None;
        }
        let n_plus = inverse(m, n);
        let m_plus = (m * n_plus - 1) / n;
        let at = Fraction::new(m, n)?;
        if 2 * m < n {
            self.second = Some((at, Fraction::new(m - m_plus, n - n_plus)?, true, false));
        }
        let left = if m == 1 { Fraction::new(1, 2 * n)? } else { Fraction::new(m_plus, n_plus)? };
        Some((left, at, true, true))
    }
}
