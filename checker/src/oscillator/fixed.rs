//! Intervals with end points in units of 2⁻⁹⁶, on 128-bit integers: every operation rounds outwards.

use std::ops::{Add, Mul, Neg, Sub};

/// Bits after the point.
const POINT: u32 = 96;

/// An end point at or beyond ±2³⁰ counts as infinite.
const FAR: i128 = 1 << (POINT + 30);

/// The reals from `lo` to `hi`, in units of 2⁻⁹⁶.
///
/// Invariant: −FAR < lo ≤ hi < FAR, or the whole line, of which nothing is known and which every operation
/// hands on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Interval {
    lo: i128,
    hi: i128,
}

impl Interval {
    const WHOLE: Interval = Interval { lo: -FAR, hi: FAR };
    pub const ZERO: Interval = Interval { lo: 0, hi: 0 };
    pub const ONE: Interval = Interval { lo: 1 << POINT, hi: 1 << POINT };
    /// The least interval of this kind with π in it: ⌊π·2⁹⁶⌋ and one more (tests.rs shows sin change its sign
    /// there).
    pub const PI: Interval =
        Interval { lo: 0x3243f6a8885a308d313198a2e, hi: 0x3243f6a8885a308d313198a2e + 1 };

    fn new(lo: i128, hi: i128) -> Interval {
        if lo <= -FAR || hi >= FAR { Interval::WHOLE } else { Interval { lo, hi } }
    }

    fn is_whole(self) -> bool {
        self == Interval::WHOLE
    }

    /// p/q for q > 0.
    pub fn ratio(p: i128, q: i128) -> Interval {
        let (lo, hi) = quotient(p, q);
        Interval::new(lo, hi)
    }

    pub fn integer(n: u64) -> Interval {
        Interval::ratio(n.into(), 1)
    }

    /// Whether every enclosed number is > 0.
    pub fn is_positive(self) -> bool {
        self.lo > 0
    }

    /// Whether no enclosed number is < 0.
    pub fn is_nonnegative(self) -> bool {
        self.lo >= 0
    }

    /// Whether the interval lies strictly within `radius` of every number of `centre`.
    pub fn is_within(self, radius: Interval, centre: Interval) -> bool {
        let (far, near) = (self - centre, centre - self);
        far.is_below(radius) && near.is_below(radius)
    }

    /// Whether every number of this interval is less than every number of the other.
    pub fn is_below(self, other: Interval) -> bool {
        !self.is_whole() && !other.is_whole() && self.hi < other.lo
    }

    /// Whether every number of this interval is at most every number of the other.
    pub fn is_up_to(self, other: Interval) -> bool {
        !self.is_whole() && self.hi <= other.lo
    }

    /// Every number at a distance up to `radius` ≥ 0.
    pub fn widened(self, radius: Interval) -> Interval {
        self + Interval { lo: -radius.hi, hi: radius.hi }
    }

    /// From the least number of this interval to the greatest of the other; the whole line if there are none.
    pub fn until(self, other: Interval) -> Interval {
        if self.lo <= other.hi { Interval::new(self.lo, other.hi) } else { Interval::WHOLE }
    }

    /// One unit at each end.
    pub fn outwards(self) -> Interval {
        Interval::new(self.lo - 1, self.hi + 1)
    }

    /// Its middle, as a point.
    pub fn middle(self) -> Interval {
        if self.is_whole() {
            return self;
        }
        let middle = self.lo + (self.hi - self.lo) / 2;
        Interval { lo: middle, hi: middle }
    }

    /// A point near its middle, a multiple of 2⁻⁵⁶.
    pub fn coarse_middle(self) -> Interval {
        let Interval { lo, .. } = self.middle();
        if self.is_whole() { self } else { Interval { lo: lo >> 40 << 40, hi: lo >> 40 << 40 } }
    }

    /// The numbers' magnitudes are at most 2^`exponent` units; `None` of the whole line.
    pub fn magnitude_bits(self) -> Option<u32> {
        let bits = |x: i128| 128 - x.unsigned_abs().leading_zeros();
        (!self.is_whole()).then(|| bits(self.lo).max(bits(self.hi)))
    }

    /// The greatest magnitude, as a point.
    pub fn magnitude(self) -> Interval {
        if self.is_whole() {
            return self;
        }
        let most = self.hi.max(-self.lo);
        Interval { lo: most, hi: most }
    }

    /// Divided by 2^k.
    pub fn shifted_down(self, k: u32) -> Interval {
        if self.is_whole() {
            return self;
        }
        // >> rounds down, so that −(−x >> k) rounds up.
        Interval { lo: self.lo >> k, hi: -(-self.hi >> k) }
    }

    /// Divided by n ≥ 1.
    pub fn divided(self, n: i128) -> Interval {
        if self.is_whole() {
            return self;
        }
        Interval { lo: self.lo.div_euclid(n), hi: -(-self.hi).div_euclid(n) }
    }

    /// The quotients; the whole line if the divisor may be zero.
    pub fn over(self, other: Interval) -> Interval {
        if self.is_whole() || other.is_whole() || (other.lo <= 0 && other.hi >= 0) {
            return Interval::WHOLE;
        }
        if other.hi < 0 {
            return -self.over(-other);
        }
        let ends = [(self.lo, other.lo), (self.lo, other.hi), (self.hi, other.lo), (self.hi, other.hi)];
        hull(ends.map(|(x, y)| quotient(x, y)))
    }

    /// What lies between −1 and 1 of an interval that holds such a number.
    pub fn within_unit(self) -> Interval {
        Interval { lo: self.lo.max(-Interval::ONE.lo), hi: self.hi.min(Interval::ONE.hi) }
    }

    /// The squares.
    pub fn squared(self) -> Interval {
        let square = self * self;
        if square.is_whole() { square } else { Interval { lo: square.lo.max(0), ..square } }
    }
}

fn hull(parts: [(i128, i128); 4]) -> Interval {
    let (lo, hi) = parts.into_iter().fold((FAR, -FAR), |(lo, hi), part| (lo.min(part.0), hi.max(part.1)));
    Interval::new(lo, hi)
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
        // Four times FAR is below 2¹²⁸.
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
        let ends = [(self.lo, other.lo), (self.lo, other.hi), (self.hi, other.lo), (self.hi, other.hi)];
        hull(ends.map(|(x, y)| product(x, y)))
    }
}

/// The units below and above xy, ±FAR if that is too much; |x|, |y| ≤ FAR.
fn product(x: i128, y: i128) -> (i128, i128) {
    let (a, b) = (x.unsigned_abs(), y.unsigned_abs());
    // 64-bit halves: ab = high·2¹²⁸ + middle·2⁶⁴ + low.
    let half = |x: u128| (x >> 64, x & u128::from(u64::MAX));
    let ((a1, a0), (b1, b0)) = (half(a), half(b));
    let low = a0 * b0;
    // Each product of halves is below 2¹²⁶, since a1, b1 < 2⁶³.
    let middle = a1 * b0 + a0 * b1 + (low >> 64);
    let high = a1 * b1 + (middle >> 64);
    let low = (middle << 64) | (low & u128::from(u64::MAX));
    let magnitude = low >> POINT | high << (128 - POINT);
    directed(high >> POINT == 0, magnitude, low << (128 - POINT) != 0, (x < 0) != (y < 0))
}

/// The units below and above x/y for y > 0, ±FAR if that is too much.
fn quotient(x: i128, y: i128) -> (i128, i128) {
    let (numerator, divisor) = (x.unsigned_abs(), y.unsigned_abs());
    // numerator·2⁹⁶, its upper 128 bits and its lower; then long division, bit by bit.
    let (mut rest, low) = (numerator >> (128 - POINT), numerator << POINT);
    if rest >= divisor {
        return (-FAR, FAR);
    }
    let mut result = 0u128;
    for bit in (0..128).rev() {
        rest = rest << 1 | (low >> bit & 1);
        result <<= 1;
        if rest >= divisor {
            rest -= divisor;
            result |= 1;
        }
    }
    directed(true, result, rest != 0, x < 0)
}

/// ±`magnitude` and, where `more` says that something was cut off, the unit beyond; ±FAR if it does not
/// `fit`.
fn directed(fits: bool, magnitude: u128, more: bool, negative: bool) -> (i128, i128) {
    if !fits || magnitude >= FAR as u128 {
        return (-FAR, FAR);
    }
    let (down, up) = (magnitude as i128, magnitude as i128 + i128::from(more));
    if negative { (-up, -down) } else { (down, up) }
}
