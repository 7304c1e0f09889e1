//! Upper bounds of magnitudes: the radii of balls. Every operation rounds up.

use std::ops::{Add, Mul};

use num_bigint::BigInt;

use super::exponent::{Exponent, Misfit};

/// A bound m·2^e with 2³¹ ≤ m < 2³², or zero (m = 0), or infinity (m = 2⁶⁴ − 1).
///
/// A bound whose exponent would not fit becomes infinite, or the least one above zero: always an upper bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Radius {
    m: u64,
    e: Exponent,
}

impl Radius {
    pub const ZERO: Radius = Radius { m: 0, e: Exponent::ZERO };
    pub const INFINITE: Radius = Radius { m: u64::MAX, e: Exponent::ZERO };
    /// The least bound above zero, 2³¹·2^e for the lowest e.
    const LEAST: Radius = Radius { m: 1 << 31, e: Exponent::LOWEST };

    /// 1.
    pub fn one() -> Radius {
        Radius::new(1, 0)
    }

    /// At least m·2^e, and at most 1 + 2⁻³¹ times that (or [`LEAST`](Radius::LEAST), or infinite).
    pub fn new(m: u64, e: i128) -> Radius {
        if m == 0 {
            return Radius::ZERO;
        }
        let shift = 32 - i128::from(m.leading_zeros());
        if shift <= 0 {
            return Radius::fit(m << -shift, e + shift);
        }
        let m = ((m - 1) >> shift) + 1;
        // A carry to 2³² keeps the invariant by one more shift.
        if m >> 32 == 0 { Radius::fit(m, e + shift) } else { Radius::fit(m >> 1, e + shift + 1) }
    }

    /// m·2^e for 2³¹ ≤ m < 2³²; what is too small, m·2^e < 2³¹·2^LOWEST, is bounded by that.
    fn fit(m: u64, e: i128) -> Radius {
        match Exponent::fit(e) {
            Ok(e) => Radius { m, e },
            Err(Misfit::Below) => Radius::LEAST,
            Err(Misfit::Above) => Radius::INFINITE,
        }
    }

    /// At least |x|·2^e, and at most 1 + 2⁻³⁰ times that (or the least bound, or infinite); that itself where
    /// |x| has 32 bits between its first and its last.
    pub fn of(x: &BigInt, e: i128) -> Radius {
        let mut digits = x.magnitude().iter_u64_digits().rev();
        let Some(top) = digits.next() else { return Radius::ZERO };
        let lower = digits.len() as i128 * 64;
        let next = digits.next().unwrap_or(0);
        let zeros = i128::from(top.leading_zeros());
        let lead = if zeros == 0 { top } else { (top << zeros) | (next >> (64 - zeros)) };
        let cut = x.trailing_zeros().is_some_and(|zeros| zeros + 32 < x.bits());
        Radius::new((lead >> 32) + u64::from(cut), e + lower - zeros + 32)
    }

    pub fn is_zero(self) -> bool {
        self.m == 0
    }

    pub fn is_infinite(self) -> bool {
        self.m == u64::MAX
    }

    /// Whether this bound is less than the other.
    pub fn is_below(self, other: Radius) -> bool {
        if self.is_infinite() || other.is_infinite() {
            return !self.is_infinite();
        }
        !other.is_zero() && (self.is_zero() || (self.e, self.m) < (other.e, other.m))
    }

    /// m and e: the bound is m·2^e. Not for infinity.
    pub fn parts(self) -> (u64, i128) {
        (self.m, self.e.wide())
    }

    /// Whether the bound is at most 2^e: certain if true, off by a factor of two at most if not.
    pub fn is_within(self, e: i128) -> bool {
        self.is_zero() || (!self.is_infinite() && self.e.wide() + 32 <= e)
    }

    /// At least self/(m·2^e), for m ≥ 2³¹.
    pub fn over(self, m: u64, e: i128) -> Radius {
        if self.is_infinite() || self.is_zero() {
            return self;
        }
        Radius::new((self.m << 31) / m + 1, self.e.wide() - 31 - e)
    }
}

impl Add for Radius {
    type Output = Radius;

    fn add(self, other: Radius) -> Radius {
        if self.is_infinite() || other.is_infinite() {
            return Radius::INFINITE;
        }
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let (big, small) = if self.e >= other.e { (self, other) } else { (other, self) };
        let distance = big.e.wide() - small.e.wide();
        let small = if distance >= 32 { 1 } else { (small.m >> distance) + 1 };
        Radius::new(big.m + small, big.e.wide())
    }
}

impl Mul for Radius {
    type Output = Radius;

    fn mul(self, other: Radius) -> Radius {
        if self.is_infinite() || other.is_infinite() {
            return Radius::INFINITE;
        }
        Radius::new(self.m * other.m, self.e.wide() + other.e.wide())
    }
}
