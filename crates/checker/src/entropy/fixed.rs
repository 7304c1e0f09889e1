//! Nonnegative numbers as multiples of 2⁻⁶⁰, rounded up or down. All are below 2⁴, so products fit 128 bits.

use super::Fraction;

/// 1.
pub(super) const ONE: u128 = 1 << 60;

/// The powers of a fraction below 1.
pub(super) struct Powers {
    p: u128,
    q: u128,
}

impl Powers {
    pub fn new(z: Fraction) -> Powers {
        let (p, q) = z.parts();
        Powers { p: p.into(), q: q.into() }
    }

    /// zⁿ, rounded up or down in each step.
    pub fn power(&self, n: u64, up: bool) -> u128 {
        let round = if up { self.q - 1 } else { 0 };
        (0..n).fold(ONE, |x, _| (x * self.p + round) / self.q)
    }
}

/// 1 − x, for 0 ≤ x < 1.
pub(super) fn rest(x: u128) -> u128 {
    ONE - x
}

/// xy.
pub(super) fn product(x: u128, y: u128, up: bool) -> u128 {
    (x * y + if up { ONE - 1 } else { 0 }) / ONE
}

/// x/y.
pub(super) fn quotient(x: u128, y: u128, up: bool) -> u128 {
    (x * ONE + if up { y - 1 } else { 0 }) / y
}

/// Whether M v < v, entry by entry, and v > 0; else the first entry for which not.
pub(super) fn bounded(size: usize, entry: impl Fn(usize, usize) -> u128, v: &[u64]) -> Result<(), usize> {
    for i in 0..size {
        let sum: u128 = (0..size).map(|j| entry(i, j) * u128::from(v[j])).sum();
        if sum >= u128::from(v[i]) * ONE {
            return Err(i);
        }
    }
    Ok(())
}
