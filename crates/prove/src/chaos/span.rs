//! Intervals of floats without directed rounding: they guide the search and promise nothing. What is proved,
//! the checker proves.

use std::ops::{Add, Mul, Neg, Sub};

/// The numbers from `lo` to `hi`, about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// The least.
    pub lo: f64,
    /// The greatest.
    pub hi: f64,
}

impl Span {
    /// Of nothing is known.
    pub(crate) const WHOLE: Span = Span { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// From one number to another.
    pub(crate) fn new(lo: f64, hi: f64) -> Span {
        if lo <= hi { Span { lo, hi } } else { Span::WHOLE }
    }

    /// One number.
    pub(crate) fn point(x: f64) -> Span {
        Span::new(x, x)
    }

    /// From the least to the greatest of both.
    pub(crate) fn hull(self, other: Span) -> Span {
        Span { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    pub(crate) fn meet(self, other: Span) -> Span {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        if lo <= hi { Span { lo, hi } } else { self }
    }

    /// What is in both, if anything is.
    pub(crate) fn common(self, other: Span) -> Option<Span> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Span { lo, hi })
    }

    pub(crate) fn part(self, i: u64, n: u64) -> Span {
        let at = |i: u64| self.lo + self.width() * i as f64 / n as f64;
        Span { lo: at(i), hi: at(i + 1) }
    }

    /// Its middle.
    pub(crate) fn middle(self) -> f64 {
        0.5 * (self.lo + self.hi)
    }

    /// Its length.
    pub(crate) fn width(self) -> f64 {
        self.hi - self.lo
    }

    pub(crate) fn magnitude(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    pub(crate) fn is_finite(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Whether it lies in the other.
    pub(crate) fn is_in(self, other: Span) -> bool {
        other.lo <= self.lo && self.hi <= other.hi
    }

    pub(crate) fn widened(self, by: f64) -> Span {
        Span { lo: self.lo - by, hi: self.hi + by }
    }

    pub(crate) fn squared(self) -> Span {
        let square = self * self;
        Span { lo: square.lo.max(0.0), ..square }
    }

    pub(crate) fn over(self, other: Span) -> Span {
        if other.lo <= 0.0 && other.hi >= 0.0 {
            return Span::WHOLE;
        }
        self * Span::new(1.0 / other.hi, 1.0 / other.lo)
    }

    pub(crate) fn times(self, x: f64) -> Span {
        self * Span::point(x)
    }
}

impl Neg for Span {
    type Output = Span;

    fn neg(self) -> Span {
        Span { lo: -self.hi, hi: -self.lo }
    }
}

impl Add for Span {
    type Output = Span;

    fn add(self, other: Span) -> Span {
        Span { lo: self.lo + other.lo, hi: self.hi + other.hi }
    }
}

impl Sub for Span {
    type Output = Span;

    fn sub(self, other: Span) -> Span {
        self + -other
    }
}

impl Mul for Span {
    type Output = Span;

    fn mul(self, other: Span) -> Span {
        if !self.is_finite() || !other.is_finite() {
            return Span::WHOLE;
        }
        let all = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        Span {
            lo: all.iter().copied().fold(f64::INFINITY, f64::min),
            hi: all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        }
    }
}
