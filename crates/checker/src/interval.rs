//! Intervals with end points on 128-bit integers: every operation rounds outwards.
//!
//! The unit is 2⁻⁹⁶ where what is proved is small (`motion`), and 2⁻⁴⁸ where boxes are wide and many
//! (`chaos`): there a product fits, and nothing is longer than a line.

use std::ops::{Add, Mul, Neg, Sub};

/// The reals from `lo` to `hi`, in units of 2^−`POINT`.
///
/// Invariant: −FAR < lo ≤ hi < FAR, or the whole line, of which nothing is known and which every operation
/// hands on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Fixed<const POINT: u32> {
    lo: i128,
    hi: i128,
}

impl Fixed<96> {
    /// The least interval of this kind with π in it: ⌊π·2⁹⁶⌋ and one more (the tests of `motion` show sin
    /// change its sign there).
    pub const PI: Self = Fixed { lo: 0x3243f6a8885a308d313198a2e, hi: 0x3243f6a8885a308d313198a2f };
}

impl Fixed<48> {
    /// The same: ⌊π·2⁴⁸⌋ and one more.
    pub const PI: Self = Fixed { lo: 0x3243f6a8885a3, hi: 0x3243f6a8885a4 };

    /// Between these numbers the root of its greatest number is; the whole line if that is below 0 or not
    /// known.
    pub fn root(self) -> Self {
        self.greatest().roots()
    }

    /// The `i`-th of `n` parts of it from the left; they overlap at most by rounding and leave nothing out.
    pub fn part(self, i: u64, n: u64) -> Self {
        if self.is_whole() {
            return self;
        }
        let (i, n, width) = (i128::from(i), i128::from(n), self.hi - self.lo);
        Fixed { lo: self.lo + down(width * i, n), hi: self.lo + up(width * (i + 1), n) }
    }
}

impl<const POINT: u32> Fixed<POINT> {
    /// The numbers are below 2^`ROOM`: 2³⁰, or 2¹⁵ for 48 bits.
    pub const ROOM: u32 = POINT * 5 / 16;
    /// An end point at or beyond ±2^`ROOM` counts as infinite. Four times this is below 2¹²⁸.
    const FAR: i128 = 1 << (POINT + Self::ROOM);
    pub const WHOLE: Self = Fixed { lo: -Self::FAR, hi: Self::FAR };
    pub const ZERO: Self = Fixed { lo: 0, hi: 0 };
    pub const ONE: Self = Fixed { lo: 1 << POINT, hi: 1 << POINT };
    pub const MINUS_ONE: Self = Fixed { lo: -(1 << POINT), hi: -(1 << POINT) };

    fn new(lo: i128, hi: i128) -> Self {
        if lo <= -Self::FAR || hi >= Self::FAR { Self::WHOLE } else { Fixed { lo, hi } }
    }

    fn is_whole(self) -> bool {
        // By the invariant; both ends compared would take twice as long.
        self.hi == Self::FAR
    }

    /// Whether anything is known of the numbers.
    pub fn is_known(self) -> bool {
        !self.is_whole()
    }

    /// p/q for q > 0; in units of 2⁻⁴⁸ both are below 2⁶³ in magnitude.
    pub fn ratio(p: i128, q: i128) -> Self {
        let (lo, hi) = quotient::<POINT>(p, q);
        Self::new(lo, hi)
    }

    pub fn integer(n: u64) -> Self {
        Self::ratio(n.into(), 1)
    }

    /// A number of units of 2^−`POINT`.
    pub fn units(number: i128) -> Self {
        Self::new(number, number)
    }

    /// Its ends in these units.
    pub fn in_units(self) -> [i128; 2] {
        [self.lo, self.hi]
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
    pub fn is_within(self, radius: Self, centre: Self) -> bool {
        let (far, near) = (self - centre, centre - self);
        far.is_below(radius) && near.is_below(radius)
    }

    /// Whether every number of this interval is less than every number of the other.
    pub fn is_below(self, other: Self) -> bool {
        !self.is_whole() && !other.is_whole() && self.hi < other.lo
    }

    /// Whether every number of this interval is at most every number of the other.
    pub fn is_up_to(self, other: Self) -> bool {
        !self.is_whole() && self.hi <= other.lo
    }

    /// Every number at a distance up to `radius` ≥ 0.
    pub fn widened(self, radius: Self) -> Self {
        self + Fixed { lo: -radius.hi, hi: radius.hi }
    }

    /// What holds all of these.
    fn of(parts: [(i128, i128); 4]) -> Self {
        let widest = (Self::FAR, -Self::FAR);
        let (lo, hi) = parts.into_iter().fold(widest, |(lo, hi), part| (lo.min(part.0), hi.max(part.1)));
        Fixed::new(lo, hi)
    }

    /// From the least number of both to the greatest.
    pub fn hull(self, other: Self) -> Self {
        Fixed::new(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    /// What is in both; `None` if certainly nothing is.
    pub fn common(self, other: Self) -> Option<Self> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Fixed { lo, hi })
    }

    /// What is in both, given that some number is; the first if there is none.
    pub fn meet(self, other: Self) -> Self {
        self.common(other).unwrap_or(self)
    }

    /// Its numbers that may be at least some number of the other; `None` if certainly none is.
    pub fn at_least(self, other: Self) -> Option<Self> {
        if self.is_whole() {
            return Some(self);
        }
        let lo = self.lo.max(other.lo);
        (lo <= self.hi).then_some(Fixed { lo, ..self })
    }

    /// What is left of it, given that its numbers are at least the least of the other.
    pub fn raised(self, other: Self) -> Self {
        self.at_least(other).unwrap_or(self)
    }

    /// Its least number, as a point.
    pub fn least(self) -> Self {
        if self.is_whole() { self } else { Fixed { hi: self.lo, ..self } }
    }

    /// Its greatest number, as a point.
    pub fn greatest(self) -> Self {
        if self.is_whole() { self } else { Fixed { lo: self.hi, ..self } }
    }

    /// The roots, to a unit or some 2⁻⁶³ of themselves; the whole line if one may be of a number below 0.
    pub fn roots(self) -> Self {
        if self.is_whole() || self.lo < 0 {
            return Self::WHOLE;
        }
        // With P = POINT: √(x 2^−P) = √(x 2^s) 2^(P/2 − s/2) 2^−P for an even s with x 2^s < 2¹²⁷.
        let root = |x: i128| {
            let s = ((x | 1).leading_zeros() - 1).min(POINT) & !1;
            ((x << s).isqrt(), (POINT - s) / 2)
        };
        let ((lo, down), (hi, up)) = (root(self.lo), root(self.hi));
        Self::new(lo << down, (hi + 1) << up)
    }

    /// The halves.
    pub fn half(self) -> Self {
        self.shifted_down(1)
    }

    /// From the least number of this interval to the greatest of the other; the whole line if there are none.
    pub fn until(self, other: Self) -> Self {
        if self.lo <= other.hi { Self::new(self.lo, other.hi) } else { Self::WHOLE }
    }

    /// One unit at each end.
    pub fn outwards(self) -> Self {
        Self::new(self.lo - 1, self.hi + 1)
    }

    /// Its middle, as a point.
    pub fn middle(self) -> Self {
        if self.is_whole() {
            return self;
        }
        let middle = self.lo + (self.hi - self.lo) / 2;
        Fixed { lo: middle, hi: middle }
    }

    /// A point near its middle, a multiple of 2⁻⁵⁶.
    pub fn coarse_middle(self) -> Self {
        let Fixed { lo, .. } = self.middle();
        if self.is_whole() { self } else { Fixed { lo: lo >> 40 << 40, hi: lo >> 40 << 40 } }
    }

    /// The numbers' magnitudes are at most 2^`exponent` units; `None` of the whole line.
    pub fn magnitude_bits(self) -> Option<u32> {
        let bits = |x: i128| 128 - x.unsigned_abs().leading_zeros();
        (!self.is_whole()).then(|| bits(self.lo).max(bits(self.hi)))
    }

    /// The least and the greatest magnitude, and whether the numbers are below 0; `None` if some are and some
    /// are above.
    fn magnitudes(self) -> Option<(i128, i128, bool)> {
        match self {
            Fixed { lo: 0.., .. } => Some((self.lo, self.hi, false)),
            Fixed { hi: ..=0, .. } => Some((-self.hi, -self.lo, true)),
            _ => None,
        }
    }

    /// The greatest magnitude, as a point.
    pub fn magnitude(self) -> Self {
        if self.is_whole() {
            return self;
        }
        let most = self.hi.max(-self.lo);
        Fixed { lo: most, hi: most }
    }

    /// Divided by 2^k.
    pub fn shifted_down(self, k: u32) -> Self {
        if self.is_whole() {
            return self;
        }
        // >> rounds down, so that −(−x >> k) rounds up.
        Fixed { lo: self.lo >> k, hi: -(-self.hi >> k) }
    }

    /// Divided by n ≥ 1.
    pub fn divided(self, n: i128) -> Self {
        if self.is_whole() {
            return self;
        }
        Fixed { lo: down(self.lo, n), hi: up(self.hi, n) }
    }

    /// The quotients; the whole line if the divisor may be zero.
    pub fn over(self, other: Self) -> Self {
        if self.is_whole() || other.is_whole() || (other.lo <= 0 && other.hi >= 0) {
            return Self::WHOLE;
        }
        if other.hi < 0 {
            return -self.over(-other);
        }
        let least = quotient::<POINT>(self.lo, if self.lo < 0 { other.lo } else { other.hi });
        let most = quotient::<POINT>(self.hi, if self.hi < 0 { other.hi } else { other.lo });
        Self::new(least.0, most.1)
    }

    /// What lies between −1 and 1 of an interval that holds such a number.
    pub fn within_unit(self) -> Self {
        Fixed { lo: self.lo.max(-Self::ONE.lo), hi: self.hi.min(Self::ONE.hi) }
    }

    /// The squares.
    pub fn squared(self) -> Self {
        let square = self * self;
        if square.is_whole() { square } else { Fixed { lo: square.lo.max(0), ..square } }
    }
}

impl<const POINT: u32> Neg for Fixed<POINT> {
    type Output = Self;

    fn neg(self) -> Self {
        Fixed { lo: -self.hi, hi: -self.lo }
    }
}

impl<const POINT: u32> Add for Fixed<POINT> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_whole() || other.is_whole() {
            return Self::WHOLE;
        }
        Self::new(self.lo + other.lo, self.hi + other.hi)
    }
}

impl<const POINT: u32> Sub for Fixed<POINT> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const POINT: u32> Mul for Fixed<POINT> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_whole() || other.is_whole() {
            return Self::WHOLE;
        }
        if POINT <= 48 {
            // The least product down, the greatest up: as if each were rounded both ways. Times a number at
            // least 0 the lower end gives the lower product, times one below 0 the higher.
            let by = |x: i128| {
                let (low, high) = (short_product(x, other.lo), short_product(x, other.hi));
                if x >= 0 { (low, high) } else { (high, low) }
            };
            let ((a, b), (c, d)) = (by(self.lo), by(self.hi));
            return Fixed::new(a.min(c) >> POINT, -(-b.max(d) >> POINT));
        }
        if let (Some((a, b, left)), Some((c, d, right))) = (self.magnitudes(), other.magnitudes()) {
            let found = Fixed::new(product::<POINT>(a, c).0, product::<POINT>(b, d).1);
            return if left == right { found } else { -found };
        }
        let ends = [(self.lo, other.lo), (self.lo, other.hi), (self.hi, other.lo), (self.hi, other.hi)];
        Self::of(ends.map(|(x, y)| product::<POINT>(x, y)))
    }
}

/// ⌊x/y⌋ for y > 0: of words, one instruction.
fn down(x: i128, y: i128) -> i128 {
    match (i64::try_from(x), i64::try_from(y)) {
        (Ok(x), Ok(y)) => x.div_euclid(y).into(),
        _ => x.div_euclid(y),
    }
}

/// ⌈x/y⌉ for y > 0.
fn up(x: i128, y: i128) -> i128 {
    -down(-x, y)
}

/// xy of ends of known intervals in units of 2⁻⁴⁸, which are below FAR = 2⁶³ in magnitude: of words, one
/// instruction.
fn short_product(x: i128, y: i128) -> i128 {
    debug_assert!([x, y].iter().all(|&x| i64::try_from(x).is_ok()), "{x}, {y} are ends");
    i128::from(x as i64) * i128::from(y as i64)
}

/// The units below and above xy, ±FAR or beyond if that is too much; |x|, |y| ≤ FAR.
fn product<const POINT: u32>(x: i128, y: i128) -> (i128, i128) {
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
    directed::<POINT>(high >> POINT == 0, magnitude, low << (128 - POINT) != 0, (x < 0) != (y < 0))
}

/// The units below and above x/y for y > 0, ±FAR or beyond if that is too much.
fn quotient<const POINT: u32>(x: i128, y: i128) -> (i128, i128) {
    if POINT <= 48 {
        return (down(x << POINT, y), up(x << POINT, y));
    }
    let (numerator, divisor) = (x.unsigned_abs(), y.unsigned_abs());
    // numerator·2^POINT, its upper 128 bits and its lower; then long division, bit by bit.
    let (mut rest, low) = (numerator >> (128 - POINT), numerator << POINT);
    if rest >= divisor {
        return (-Fixed::<POINT>::FAR, Fixed::<POINT>::FAR);
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
    directed::<POINT>(true, result, rest != 0, x < 0)
}

/// ±`magnitude` and, where `more` says that something was cut off, the unit beyond; ±FAR if it does not
/// `fit`.
fn directed<const POINT: u32>(fits: bool, magnitude: u128, more: bool, negative: bool) -> (i128, i128) {
    let far = Fixed::<POINT>::FAR;
    if !fits || magnitude >= far as u128 {
        return (-far, far);
    }
    let (down, up) = (magnitude as i128, magnitude as i128 + i128::from(more));
    if negative { (-up, -down) } else { (down, up) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Products of every sign, of points and of zero among them: to the unit, by integers that have room.
    #[test]
    fn products_are_rounded_outwards_by_less_than_a_unit() {
        fn holds<const POINT: u32>([a, b]: [i128; 2], [c, d]: [i128; 2]) -> bool {
            let found = Fixed::<POINT>::new(a, b) * Fixed::new(c, d);
            let all = [a * c, a * d, b * c, b * d];
            let (least, greatest) = (all.into_iter().min().unwrap(), all.into_iter().max().unwrap());
            let unit = 1 << POINT;
            found.in_units() == [least.div_euclid(unit), -(-greatest).div_euclid(unit)]
        }
        // The upper half of what is drawn: the lower bits of such a sequence come back soon.
        let mut state = 5u64;
        let mut random = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 32) % below
        };
        // Below 2⁵⁵, so that those of 48 bits have room, too; half of them multiples of 2⁴⁸.
        let mut end = || {
            let x = i128::from(random(1 << 32) << 23 | random(1 << 23)) >> random(56);
            let x = if random(2) == 0 { x } else { (x & 0x7f) << 48 };
            if random(2) == 0 { x } else { -x }
        };
        for _ in 0..20_000 {
            let [a, b, c, d] = std::array::from_fn(|_| end());
            for (x, y) in [([a.min(b), a.max(b)], [c.min(d), c.max(d)]), ([a, a], [c.min(d), c.max(d)])] {
                assert!(holds::<48>(x, y) && holds::<96>(x, y) && holds::<96>(y, x), "{x:?} {y:?}");
            }
        }
    }
}
