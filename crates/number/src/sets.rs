//! Enclosures as sets of reals: the hull of two, what two have in common, |x|, the less and the greater.
//!
//! Of balls all of it is done by end points. An end is computed to 64 bits more than the ball has, and moved
//! outwards where that is not exact; a ball that is put together from ends at or above 0 has no number below
//! 0, so that a root or a logarithm of it still knows something.

use num_bigint::BigInt;

use super::{Ball, FloatInterval, Sign, radius::Radius};

impl Ball {
    /// The points that a ball ends at, or points beyond them by at most 2^−(bits + 62) of their size; `None`
    /// if it has no ends.
    pub(super) fn ends(&self) -> Option<[Ball; 2]> {
        let reach = self.reach()?;
        let bits = self.bits().saturating_add(64);
        // A unit of the last of `bits` places is at least what was cut, or a term too far away to be added;
        // it is added to a number of at most `bits` places, which takes no cut.
        let outside = |end: Ball, side: i32| {
            let unit = end.exponent().map_or(0, i128::from) - i128::from(bits) + 1;
            let unit = Ball::new(side.into(), unit, Radius::ZERO, bits.saturating_add(4));
            match end.radius() {
                radius if radius.is_infinite() => None,
                radius if radius.is_zero() => Some(end),
                _ => Some(end.centre() + &unit),
            }
        };
        let centre = self.centre().cut(bits);
        Some([outside(centre.clone() - &reach, -1)?, outside(centre + &reach, 1)?])
    }

    /// The radius as a point; `None` if it is infinite.
    fn reach(&self) -> Option<Ball> {
        let (m, e) = self.radius().parts();
        (!self.radius().is_infinite()).then(|| Ball::new(m.into(), e, Radius::ZERO, 64))
    }

    /// Whether no number below 0 is enclosed.
    pub(super) fn is_from_zero_on(&self) -> bool {
        self.reach().is_some_and(|reach| (self.centre() - &reach).sign_of_point() != Sign::Negative)
    }

    /// A ball of the numbers ≥ 0 in this one: where it reaches below 0, one from 0 to twice its radius r,
    /// which is at least its greatest number, since its midpoint is below r.
    pub(super) fn without_negatives(self) -> Ball {
        if self.radius().is_infinite() || self.is_from_zero_on() {
            return self;
        }
        // As many bits as a midpoint has room for.
        let (m, e) = self.radius().parts();
        let cut = 32u32.saturating_sub(self.bits());
        let m = (m >> cut) + u64::from(cut > 0);
        let e = e + i128::from(cut);
        Ball::new(m.into(), e, Radius::new(m, e), self.bits())
    }

    /// The ball of `bits` bits from one point to another that is not below it.
    fn spanning(low: &Ball, high: &Ball, bits: u32) -> Ball {
        if high.sign_of_point() != Sign::Positive && low.sign_of_point() == Sign::Negative {
            return -Ball::spanning(&-high.clone(), &-low.clone(), bits);
        }
        let middle = (low.clone() + high).halved().cut(bits).centre();
        let [below, above] =
            [middle.clone() - low, high.clone() - &middle].map(|half| half.greatest_magnitude());
        let ball = middle.widened(if below.is_below(above) { above } else { below });
        if low.sign_of_point() == Sign::Negative { ball } else { ball.without_negatives() }
    }

    /// A ball that contains both. Cost: linear in the bits, as for all that follows.
    ///
    /// ```
    /// use grazing_number::{Ball, Precision, Real};
    /// let bits = Precision::new(64);
    /// let [zero, four] = [0, 4].map(|x| Ball::integer(x, &bits));
    /// assert_eq!(zero.hull(&four).exact_text().unwrap(), "[0, 4]");
    /// ```
    #[must_use]
    pub fn hull(&self, other: &Ball) -> Ball {
        let bits = self.bits().max(other.bits());
        let (Some([a, b]), Some([c, d])) = (self.ends(), other.ends()) else { return Ball::whole(bits) };
        Ball::spanning(lesser(&a, &c), greater(&b, &d), bits)
    }

    /// A ball that contains what both contain; `None` if that is certainly nothing.
    ///
    /// ```
    /// use grazing_number::{Ball, Precision, parse_rational};
    /// let bits = Precision::new(64);
    /// let ball = |lo, hi| Ok(Ball::between(&parse_rational(lo)?, &parse_rational(hi)?, &bits));
    /// let common = ball("0", "2")?.intersection(&ball("1", "3")?).unwrap();
    /// assert_eq!(common.exact_bounds(), Some((parse_rational("1")?, parse_rational("2")?)));
    /// assert!(ball("0", "1")?.intersection(&ball("2", "3")?).is_none());
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn intersection(&self, other: &Ball) -> Option<Ball> {
        let bits = self.bits().max(other.bits());
        let (Some([a, b]), Some([c, d])) = (self.ends(), other.ends()) else {
            return Some(if self.radius().is_infinite() { other.clone() } else { self.clone() });
        };
        let (low, high) = (greater(&a, &c), lesser(&b, &d));
        let order = (high.clone() - low).sign_of_point();
        (order != Sign::Negative).then(|| Ball::spanning(low, high, bits))
    }

    /// |x| for every enclosed x.
    ///
    /// ```
    /// use grazing_number::{Ball, Precision, parse_rational};
    /// let bits = Precision::new(64);
    /// let (two, three) = (parse_rational("2")?, parse_rational("3")?);
    /// let ball = Ball::between(&-two, &three, &bits).abs();
    /// assert_eq!(ball.exact_bounds(), Some((parse_rational("0")?, three)));
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    #[must_use]
    pub fn abs(&self) -> Ball {
        let Some([low, high]) = self.ends().filter(|_| !self.is_from_zero_on()) else { return self.clone() };
        match high.sign_of_point() {
            Sign::Positive => Ball::spanning(&Ball::zero(1), greater(&-low, &high), self.bits()),
            _ => -self.clone(),
        }
    }

    /// The lesser of x and y for every enclosed pair.
    ///
    /// ```
    /// use grazing_number::{Ball, Precision, Real};
    /// let bits = Precision::new(64);
    /// let [one, four] = [1, 4].map(|x| Ball::integer(x, &bits));
    /// assert_eq!((one.min(&four).to_string(), one.max(&four).to_string()), ("1".into(), "4".into()));
    /// ```
    #[must_use]
    pub fn min(&self, other: &Ball) -> Ball {
        -(-self.clone()).max(&-other.clone())
    }

    /// The greater of x and y for every enclosed pair; an example is at [`min`](Ball::min).
    #[must_use]
    pub fn max(&self, other: &Ball) -> Ball {
        let bits = self.bits().max(other.bits());
        let (Some([a, b]), Some([c, d])) = (self.ends(), other.ends()) else { return Ball::whole(bits) };
        Ball::spanning(greater(&a, &c), greater(&b, &d), bits)
    }

    /// x/2.
    pub(super) fn halved(&self) -> Ball {
        self.scaled(-1)
    }

    /// The sign of a midpoint.
    fn sign_of_point(&self) -> Sign {
        let mid: &BigInt = self.mid();
        mid.into()
    }
}

/// The greater of two points.
fn greater<'a>(x: &'a Ball, y: &'a Ball) -> &'a Ball {
    if (x.clone() - y).sign_of_point() == Sign::Negative { y } else { x }
}

/// The lesser of two points.
fn lesser<'a>(x: &'a Ball, y: &'a Ball) -> &'a Ball {
    if (x.clone() - y).sign_of_point() == Sign::Negative { x } else { y }
}

impl FloatInterval {
    /// The interval from the least to the greatest end of both.
    ///
    /// ```
    /// use grazing_number::FloatInterval;
    /// let [x, y] = [(1.0, 2.0), (4.0, 8.0)].map(|(lo, hi)| FloatInterval::from_bounds(lo, hi));
    /// assert_eq!(x.hull(y), FloatInterval::from_bounds(1.0, 8.0));
    /// assert_eq!(x.intersection(y), None);
    /// assert_eq!(x.hull(y).intersection(y), Some(y));
    /// assert_eq!(x.hull(-y).abs(), FloatInterval::from_bounds(0.0, 8.0));
    /// assert_eq!((x.min(x.hull(y)), x.max(y)), (x, y));
    /// ```
    #[must_use]
    pub fn hull(self, other: FloatInterval) -> FloatInterval {
        FloatInterval::from_bounds(self.lo().min(other.lo()), self.hi().max(other.hi()))
    }

    /// What both contain; `None` if that is nothing. Examples of this and what follows are at
    /// [`hull`](FloatInterval::hull).
    pub fn intersection(self, other: FloatInterval) -> Option<FloatInterval> {
        let (lo, hi) = (self.lo().max(other.lo()), self.hi().min(other.hi()));
        (lo <= hi).then(|| FloatInterval::from_bounds(lo, hi))
    }

    /// |x| for every enclosed x.
    #[must_use]
    pub fn abs(self) -> FloatInterval {
        self.max(-self).max(FloatInterval::from_bounds(0.0, 0.0))
    }

    /// The lesser of x and y for every enclosed pair.
    #[must_use]
    pub fn min(self, other: FloatInterval) -> FloatInterval {
        FloatInterval::from_bounds(self.lo().min(other.lo()), self.hi().min(other.hi()))
    }

    /// The greater of x and y for every enclosed pair.
    #[must_use]
    pub fn max(self, other: FloatInterval) -> FloatInterval {
        FloatInterval::from_bounds(self.lo().max(other.lo()), self.hi().max(other.hi()))
    }
}
