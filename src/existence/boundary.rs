//! The lower edge r = R(s) of each area of Conjecture 1, enclosed to any number of digits.
//!
//! Let k decide existence (S3), j = n − k and e = |ns − m|. In the sine form (62), with whole turns removed
//! from every angle, b_{n,k} sin 2πe equals
//!
//! ```text
//! h(r) = r^j sin 2πe + rⁿ sin(2π(1 − je)/n) − sin(2π(1 + ke)/n).
//! ```
//!
//! Wherever the first two sines are not negative (their signs are found in integers, at every point) h
//! increases for r > 0, so one sign change of h, certified at two fractions, encloses R(s), and nothing else
//! can be the edge. That this b decides is S3; it is not used to enclose the curve b_{n,k} = 0. The lowest
//! point of the edge is in `tip`.

use std::fmt;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed, ToPrimitive, Zero, pow};

use super::{Case, Interval};
use crate::{
    error::{Error, Result},
    number::{Angle, Ball, Circular, FloatInterval, Plain, Precision, Real, Sign},
};

/// A closed interval of fractions that certainly contains a number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Enclosure {
    /// Not above the number.
    pub lower: BigRational,
    /// Not below the number.
    pub upper: BigRational,
}

/// `[lower, upper]`, exact.
impl fmt::Display for Enclosure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.lower, self.upper)
    }
}

impl Enclosure {
    /// Exactly 0.
    pub fn zero() -> Self {
        Enclosure { lower: BigRational::zero(), upper: BigRational::zero() }
    }

    /// The squares of numbers that are not negative; of r, this is a₂.
    #[must_use]
    pub fn square(&self) -> Self {
        Enclosure { lower: &self.lower * &self.lower, upper: &self.upper * &self.upper }
    }

    /// The midpoint.
    pub fn middle(&self) -> BigRational {
        (&self.lower + &self.upper) / BigInt::from(2)
    }
}

/// The lower edge of an area: where, above its interval on r = 1, the orbit ceases to exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Boundary {
    interval: Interval,
}

impl Boundary {
    /// The edge of the area above one of Theorem 2's intervals.
    pub fn new(interval: Interval) -> Self {
        Boundary { interval }
    }

    /// The interval on r = 1.
    pub fn interval(&self) -> &Interval {
        &self.interval
    }

    /// j = n − k for the deciding k; none where nothing bounds the area from below (m = 0).
    pub(super) fn j(&self) -> Option<u64> {
        self.interval.deciding.map(|k| self.interval.n - k)
    }

    /// s at distance e = |ns − m| on the area's side of m/n.
    pub(super) fn s_at(&self, e: &BigRational) -> BigRational {
        let Interval { n, m, case, .. } = self.interval;
        let m = BigRational::from_integer(m.into());
        (if case == Case::PlusPlus { m - e } else { m + e }) / BigInt::from(n)
    }

    /// R(s), no wider than 2·10^−`digits`/100; exactly 0 where no r > 0 forbids the orbit.
    ///
    /// `None` if h was not seen to increase or its signs were not certain (neither has been met). Cost: three
    /// sines and, for each doubling of the digits, O(log n) products, at 4·`digits` + O(log n) bits.
    ///
    /// # Errors
    /// An input error unless s lies inside the interval.
    pub fn at(&self, s: &BigRational, digits: u32) -> Result<Option<Enclosure>> {
        let Interval { n, m, left, right, .. } = &self.interval;
        if *s <= big(left) || *s >= big(right) {
            return Err(Error::input(format!("s = {s} is outside the interval {left} < s < {right}")));
        }
        let Some(j) = self.j() else { return Ok(Some(Enclosure::zero())) };
        let e = (s * BigInt::from(*n) - BigRational::from_integer((*m).into())).abs();
        Ok(Section::new(*n, j, &e).root(digits, &Precision::new(bits(*n, digits))))
    }

    /// R(s), no wider than 2·`within`, for pictures: by `f64` intervals where these can tell, else as
    /// [`at`](Boundary::at).
    ///
    /// Cost: some microseconds for the intervals; they can tell for most s if `within` is above 2⁻⁴⁰.
    ///
    /// # Errors
    /// An input error unless s lies inside the interval and `within` is positive.
    pub fn near(&self, s: &BigRational, within: &BigRational) -> Result<Option<Enclosure>> {
        if !within.is_positive() {
            return Err(Error::input(format!("an enclosure within {within}: it must be above 0")));
        }
        let Interval { n, m, left, right, .. } = &self.interval;
        let inside = *s > big(left) && *s < big(right);
        if let (true, Some(j)) = (inside, self.j()) {
            let e = (s * BigInt::from(*n) - BigRational::from_integer((*m).into())).abs();
            if let Some(found) = Section::new(*n, j, &e).root_by_intervals(within) {
                return Ok(Some(found));
            }
        }
        // 10^−(digits + 2) ≤ 2^−exponent < within.
        let exponent = (within.denom().bits() + 1).saturating_sub(within.numer().bits());
        let digits = u32::try_from(exponent * 302 / 1000).unwrap_or(u32::MAX);
        self.at(s, digits.clamp(1, 1 << 24))
    }
}

impl Boundary {
    /// The bits of the balls by which its points are found to so many digits.
    pub fn bits(&self, digits: u32) -> u32 {
        bits(self.interval.n, digits)
    }
}

/// A fraction of machine integers as one of any size.
fn big(x: &Ratio<u64>) -> BigRational {
    BigRational::new_raw((*x.numer()).into(), (*x.denom()).into())
}

/// Enough bits for `digits` decimals: at R the terms of h differ by a relative 10^−`digits` at worst, and
/// powers and second differences in e cost a few times log₂ n.
pub(super) fn bits(n: u64, digits: u32) -> u32 {
    4 * digits + 64 + 8 * n.ilog2()
}

/// x^exponent by repeated squaring.
pub(super) fn power<T: Real>(x: &T, exponent: u64, context: &T::Context) -> T {
    let mut result = T::integer(1, context);
    for bit in (0..64 - exponent.leading_zeros()).rev() {
        result = result.clone() * &result;
        if exponent >> bit & 1 == 1 {
            result = result * x;
        }
    }
    result
}

/// 10^−digits.
pub(super) fn unit(digits: u32) -> BigRational {
    BigRational::new_raw(BigInt::one(), pow(BigInt::from(10), digits as usize))
}

/// The midpoint of a ball.
pub(super) fn middle(ball: &Ball) -> Option<BigRational> {
    ball.exact_bounds().map(|(lower, upper)| Enclosure { lower, upper }.middle())
}

/// h as a function of r at one e.
#[derive(Debug, Clone)]
pub(super) struct Section {
    n: u64,
    j: u64,
    /// The angles of the three sines, in turns.
    pub turns: [BigRational; 3],
    pub angles: [Angle; 3],
}

/// The three sines, on one rung.
pub(super) type Sines<T> = [T; 3];

impl Section {
    pub fn new(n: u64, j: u64, e: &BigRational) -> Self {
        let [one, n_, j_, k_] = [1, n, j, n - j].map(|i| BigRational::from_integer(i.into()));
        let turns = [e.clone(), (&one - &j_ * e) / &n_, (&one + &k_ * e) / &n_];
        let angles = turns.each_ref().map(|turn| Angle::new(&(turn * BigInt::from(2))));
        Section { n, j, turns, angles }
    }

    /// Whether h is certain to increase for r > 0: its powers have no negative coefficient and r^j a positive
    /// one. Exact.
    pub fn increases(&self) -> bool {
        self.angles[0].sin_sign() == Sign::Positive && self.angles[1].sin_sign() != Sign::Negative
    }

    pub fn sines<T: Circular>(&self, context: &T::Context) -> Sines<T> {
        self.angles.each_ref().map(|angle| T::sin(angle, context))
    }

    /// h(r).
    pub fn value<T: Circular>(&self, sines: &Sines<T>, r: &BigRational, context: &T::Context) -> T {
        let r = T::ratio(r, context);
        let (short, long) = (power(&r, self.j, context), power(&r, self.n - self.j, context));
        (long * &sines[1] + &sines[0]) * &short - &sines[2]
    }

    /// r h'(r).
    pub fn slope<T: Circular>(&self, sines: &Sines<T>, r: &BigRational, context: &T::Context) -> T {
        let r = T::ratio(r, context);
        let (short, long) = (power(&r, self.j, context), power(&r, self.n - self.j, context));
        let [n, j] = [self.n, self.j].map(|i| T::ratio(&BigRational::from_integer(i.into()), context));
        (long * &sines[1] * &n + &(j * &sines[0])) * &short
    }

    /// The zero of h in [0, 1] by halving in plain floats: a guess, good to about 1e-16/(1 − R).
    pub fn guess(&self) -> BigRational {
        let sines = self.sines::<Plain>(&());
        let [a, b, c] = [&sines[0], &sines[1], &sines[2]].map(|sine| sine.0);
        let (mut low, mut high) = (0f64, 1f64);
        for _ in 0..60 {
            let r = (low + high) / 2.0;
            let short = power(&Plain(r), self.j, &()).0;
            let long = power(&Plain(r), self.n - self.j, &()).0;
            *(if (a + b * long) * short > c { &mut high } else { &mut low }) = r;
        }
        BigRational::from_float(high).unwrap_or_else(BigRational::one)
    }

    /// One step of Newton's method for h(r) = 0, which is convex: from the second step on, downwards.
    pub fn newton(&self, sines: &Sines<Ball>, r: &BigRational, precision: &Precision) -> Option<BigRational> {
        let step = self.value(sines, r, precision) / &self.slope(sines, r, precision);
        let factor = Ball::integer(1, precision) - &step;
        middle(&(factor * &Ball::ratio(r, precision)))
    }

    /// The zero of h within `within` on either side, certified by `f64` intervals; `None` where they cannot.
    fn root_by_intervals(&self, within: &BigRational) -> Option<Enclosure> {
        if !self.increases() {
            return None;
        }
        if self.angles[2].sin_sign() != Sign::Positive {
            return Some(Enclosure::zero());
        }
        let sines = self.sines::<FloatInterval>(&());
        let guess = self.guess();
        let lower = (&guess - within).max(BigRational::zero());
        let upper = (&guess + within).min(BigRational::one());
        let sign = |r: &BigRational| self.value(&sines, r, &()).sign();
        let certain = sign(&lower) == Some(Sign::Negative) && sign(&upper) == Some(Sign::Positive);
        certain.then_some(Enclosure { lower, upper })
    }

    /// The zero of h within 10^−(`digits` + 2) on either side; `None` if that could not be made certain.
    pub fn root(&self, digits: u32, precision: &Precision) -> Option<Enclosure> {
        if !self.increases() {
            return None;
        }
        // h(0) ≥ 0: then h > 0 for every r > 0.
        if self.angles[2].sin_sign() != Sign::Positive {
            return Some(Enclosure::zero());
        }
        let sines = self.sines::<Ball>(precision);
        let unit = unit(digits + 2);
        let mut r = self.guess();
        // Each step doubles the digits; more only if r is tiny.
        for _ in 0..64 {
            let lower = (&r - &unit).max(BigRational::zero());
            let upper = (&r + &unit).min(BigRational::one());
            let sign = |r: &BigRational| self.value(&sines, r, precision).sign();
            if sign(&lower) == Some(Sign::Negative) && sign(&upper) == Some(Sign::Positive) {
                return Some(Enclosure { lower, upper });
            }
            r = self.newton(&sines, &r, precision)?;
        }
        None
    }
}

/// A fraction as a float, for guesses.
pub(super) fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::existence::intervals;

    /// Both routes enclose one number, for wide and for narrow wishes.
    #[test]
    fn intervals_and_balls_enclose_the_same_edge() {
        let mut quick = 0;
        for interval in [3, 7, 12, 101].into_iter().flat_map(|n| intervals(n).unwrap()) {
            let boundary = Boundary::new(interval);
            let [left, right] = [&boundary.interval.left, &boundary.interval.right].map(big);
            for (i, exponent) in (1..8).zip([3u32, 10, 20, 30, 38, 60, 200]) {
                let s = &left + (&right - &left) * BigRational::new(i.into(), 8.into());
                let within = BigRational::new(BigInt::one(), BigInt::one() << exponent);
                let near = boundary.near(&s, &within).unwrap().unwrap();
                let at = boundary.at(&s, 70).unwrap().unwrap();
                assert!(&near.upper - &near.lower <= &within * BigInt::from(2), "{} {s}", boundary.interval);
                assert!(near.lower <= at.upper && at.lower <= near.upper, "{} {s}", boundary.interval);
                if let Some(j) = boundary.j() {
                    let e = (&s * BigInt::from(boundary.interval.n)
                        - BigRational::from_integer(boundary.interval.m.into()))
                    .abs();
                    let found = Section::new(boundary.interval.n, j, &e).root_by_intervals(&within);
                    quick += usize::from(found.is_some());
                }
            }
        }
        assert!(quick > 300, "{quick}");
        let boundary = Boundary::new(intervals(5).unwrap().nth(1).unwrap());
        assert!(boundary.near(&big(&boundary.interval.left), &unit(3)).is_err());
        assert!(boundary.near(&BigRational::new(3.into(), 20.into()), &BigRational::zero()).is_err());
    }

    /// Beyond je = 1 the coefficient of rⁿ is negative: the check says so, and nothing is enclosed.
    #[test]
    fn the_check_of_monotonicity_can_fail() {
        let precision = Precision::new(100);
        let section = |p: i64, q: i64| Section::new(7, 3, &BigRational::new(p.into(), q.into()));
        assert!(section(33, 100).increases());
        assert!(section(33, 100).root(10, &precision).is_some());
        assert!(!section(34, 100).increases());
        assert_eq!(section(34, 100).root(10, &precision), None);
    }
}
