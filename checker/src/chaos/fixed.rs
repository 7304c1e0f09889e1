//! Intervals with end points in units of 2⁻⁴⁸, on 128-bit integers: every operation rounds outwards.
//!
//! Numbers below 2¹⁵ have 63 bits, so that a product fits and nothing here is longer than a line. The proofs
//! of this kind need few digits: their boxes are wide.

use std::ops::{Add, Mul, Neg, Sub};

/// Bits after the point.
const POINT: u32 = 48;

/// An end point at or beyond ±2¹⁵ counts as infinite.
const FAR: i128 = 1 << (POINT + 15);

/// The reals from `lo` to `hi`, in units of 2⁻⁴⁸.
///
/// Invariant: −FAR < lo ≤ hi < FAR, or the whole line, of which nothing is known and which every operation
/// hands on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Interval {
    lo: i128,
    hi: i128,
}

impl Interval {
    pub const WHOLE: Interval = Interval { lo: -FAR, hi: FAR };
    pub const ZERO: Interval = Interval { lo: 0, hi: 0 };
    pub const ONE: Interval = Interval { lo: 1 << POINT, hi: 1 << POINT };
    /// The least interval of this kind with π in it: ⌊π·2⁴⁸⌋ and one more.
    pub const PI: Interval = Interval { lo: 0x3_243f_6a88_85a3, hi: 0x3_243f_6a88_85a4 };

    fn new(lo: i128, hi: i128) -> Interval {
        if lo <= -FAR || hi >= FAR { Interval::WHOLE } else { Interval { lo, hi } }
    }

    fn is_whole(self) -> bool {
        self == Interval::WHOLE
    }

    /// p/q for q > 0, both below 2⁶³ in magnitude.
    pub fn ratio(p: i128, q: i128) -> Interval {
        Interval::new(down(p << POINT, q), up(p << POINT, q))
    }

    /// The part of the line on which both intervals' numbers lie: from the least to the greatest.
    pub fn hull(self, other: Interval) -> Interval {
        Interval::new(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    /// What is in both, given that some number is; the first if there is none.
    pub fn meet(self, other: Interval) -> Interval {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        if lo <= hi { Interval { lo, hi } } else { self }
    }

    /// What is in both; `None` if certainly nothing is.
    pub fn common(self, other: Interval) -> Option<Interval> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Interval { lo, hi })
    }

    /// Its numbers that may be at least some number of the other; `None` if certainly none is.
    pub fn at_least(self, other: Interval) -> Option<Interval> {
        if self.is_whole() {
            return Some(self);
        }
        let lo = self.lo.max(other.lo);
        (lo <= self.hi).then_some(Interval { lo, ..self })
    }

    /// What is left of it, given that its numbers are at least the least of the other.
    pub fn raised(self, other: Interval) -> Interval {
        self.at_least(other).unwrap_or(self)
    }

    /// The `i`-th of `n` parts of it from the left; they overlap at most by rounding and leave nothing out.
    pub fn part(self, i: u64, n: u64) -> Interval {
        if self.is_whole() {
            return self;
        }
        let (i, n, width) = (i128::from(i), i128::from(n), self.hi - self.lo);
        Interval { lo: self.lo + down(width * i, n), hi: self.lo + up(width * (i + 1), n) }
    }

    /// Its middle, as a point.
    pub fn middle(self) -> Interval {
        if self.is_whole() {
            return self;
        }
        let middle = self.lo + (self.hi - self.lo) / 2;
        Interval { lo: middle, hi: middle }
    }

    /// Its least number, as a point.
    pub fn least(self) -> Interval {
        if self.is_whole() { self } else { Interval { hi: self.lo, ..self } }
    }

    /// Its greatest number, as a point.
    pub fn greatest(self) -> Interval {
        if self.is_whole() { self } else { Interval { lo: self.hi, ..self } }
    }

    /// The greatest magnitude of its numbers, as a point.
    pub fn magnitude(self) -> Interval {
        let most = self.hi.max(-self.lo);
        Interval::new(most, most)
    }

    /// Whether every enclosed number is > 0.
    pub fn is_positive(self) -> bool {
        self.lo > 0
    }

    /// Whether every number of this interval is at most every number of the other.
    pub fn is_up_to(self, other: Interval) -> bool {
        !self.is_whole() && !other.is_whole() && self.hi <= other.lo
    }

    /// Whether every number of this interval is less than every number of the other.
    pub fn is_below(self, other: Interval) -> bool {
        !self.is_whole() && !other.is_whole() && self.hi < other.lo
    }

    /// From one number to another, given by intervals: every number that may lie between.
    pub fn until(self, other: Interval) -> Interval {
        self.hull(other)
    }

    /// One unit at each end.
    pub fn outwards(self) -> Interval {
        Interval::new(self.lo - 1, self.hi + 1)
    }

    /// Divided by 2^k.
    pub fn shifted_down(self, k: u32) -> Interval {
        if self.is_whole() { self } else { Interval { lo: self.lo >> k, hi: -(-self.hi >> k) } }
    }

    /// Divided by n ≥ 1.
    pub fn divided(self, n: i128) -> Interval {
        if self.is_whole() { self } else { Interval { lo: down(self.lo, n), hi: up(self.hi, n) } }
    }

    /// The halves.
    pub fn half(self) -> Interval {
        self.shifted_down(1)
    }

    /// The quotients; the whole line if the divisor may be zero.
    pub fn over(self, other: Interval) -> Interval {
        if self.is_whole() || other.is_whole() || (other.lo <= 0 && other.hi >= 0) {
            return Interval::WHOLE;
        }
        if other.hi < 0 {
            return -self.over(-other);
        }
        let (lo, hi) = (self.lo << POINT, self.hi << POINT);
        let least = down(lo, if lo < 0 { other.lo } else { other.hi });
        let most = up(hi, if hi < 0 { other.hi } else { other.lo });
        Interval::new(least, most)
    }

    /// The squares.
    pub fn squared(self) -> Interval {
        let square = self * self;
        if square.is_whole() { square } else { Interval { lo: square.lo.max(0), ..square } }
    }

    /// The least k with all magnitudes at most 2ᵏ⁻⁴⁸; `None` of the whole line.
    pub fn bits(self) -> Option<u32> {
        let most = self.hi.max(-self.lo).unsigned_abs();
        (!self.is_whole()).then(|| 128 - most.leading_zeros())
    }
}

/// ⌊x/y⌋ for y > 0.
fn down(x: i128, y: i128) -> i128 {
    x.div_euclid(y)
}

/// ⌈x/y⌉ for y > 0.
fn up(x: i128, y: i128) -> i128 {
    -(-x).div_euclid(y)
}

impl Neg for Interval {
    type Output = Interval;

    fn neg(self) -> Interval {
        Interval { lo: -self.hi, hi: -self.lo }
    }
}

impl Add for Interval {
    type Output = Interval;

    fn add(self, other: Interval) -> Interval {
        if self.is_whole() || other.is_whole() {
            return Interval::WHOLE;
        }
        Interval::new(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub for Interval {
    type Output = Interval;

    fn sub(self, other: Interval) -> Interval {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Interval;

    fn mul(self, other: Interval) -> Interval {
        if self.is_whole() || other.is_whole() {
            return Interval::WHOLE;
        }
        // Both factors are below 2⁶³ in magnitude.
        let (a, b, c, d) = (self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi);
        let (least, most) = (a.min(b).min(c).min(d), a.max(b).max(c).max(d));
        Interval::new(least >> POINT, -(-most >> POINT))
    }
}
