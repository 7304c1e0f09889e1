//! Upper bounds of magnitudes: the radii of balls. Every operation rounds up.

use std::ops::{Add, Mul};

use num_bigint::BigInt;

/// A bound m·2^e with 2³¹ ≤ m < 2³², or zero (m = 0), or infinity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Radius {
    m: u64,
    e: i64,
}

impl Radius {
    pub const ZERO: Radius = Radius { m: 0, e: 0 };
    pub const ONE: Radius = Radius { m: 1 << 31, e: -31 };
    pub const INFINITE: Radius = Radius { m: u64::MAX, e: i64::MAX };

    /// At least m·2^e, and at most 1 + 2⁻³¹ times that.
    pub fn new(m: u64, e: i64) -> Radius {
        if m == 0 {
            return Radius::ZERO;
        }
        let shift = 32 - i64::from(m.leading_zeros());
        if shift <= 0 {
            return Radius { m: m << -shift, e: e + shift };
        }
        let m = ((m - 1) >> shift) + 1;
        // A carry to 2³² keeps the invariant by one more shift.
        if m >> 32 == 0 { Radius { m, e: e + shift } } else { Radius { m: m >> 1, e: e + shift + 1 } }
    }

    /// At least |x|·2^e, and at most 1 + 2⁻³⁰ times that.
    pub fn of(x: &BigInt, e: i64) -> Radius {
        let mut digits = x.magnitude().iter_u64_digits().rev();
        let Some(top) = digits.next() else { return Radius::ZERO };
        let lower = digits.len() as i64 * 64;
        let next = digits.next().unwrap_or(0);
        let zeros = i64::from(top.leading_zeros());
        let lead = if zeros == 0 { top } else { (top << zeros) | (next >> (64 - zeros)) };
        Radius::new((lead >> 32) + 1, e + lower - zeros + 32)
    }

    pub fn is_zero(self) -> bool {
        self.m == 0
    }

    pub fn is_infinite(self) -> bool {
        self.e == i64::MAX
    }

    /// Whether this bound is less than the other.
    pub fn is_below(self, other: Radius) -> bool {
        !other.is_zero() && (self.is_zero() || (self.e, self.m) < (other.e, other.m))
    }

    /// m and e: the bound is m·2^e.
    pub fn parts(self) -> (u64, i64) {
        (self.m, self.e)
    }

    /// An e with bound ≤ 2^e, for a bound that is not zero; `i64::MAX` for infinity.
    pub fn exponent(self) -> i64 {
        self.e.saturating_add(32)
    }

    /// At least self/(m·2^e), for m ≥ 2³¹.
    pub fn over(self, m: u64, e: i64) -> Radius {
        if self.is_infinite() || self.is_zero() {
            return self;
        }
        Radius::new((self.m << 31) / m + 1, self.e - 31 - e)
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
        let distance = big.e - small.e;
        let small = if distance >= 32 { 1 } else { (small.m >> distance) + 1 };
        Radius::new(big.m + small, big.e)
    }
}

impl Mul for Radius {
    type Output = Radius;

    fn mul(self, other: Radius) -> Radius {
        if self.is_infinite() || other.is_infinite() {
            return Radius::INFINITE;
        }
        Radius::new(self.m * other.m, self.e + other.e)
    }
}
