//! The functions of `f64` intervals: balls at the end points, rounded outwards.
//!
//! No function here is computed in floats. An end point is a ball without a radius, exactly; the ball's
//! function ([`Elementary`], [`Transcendental`]) encloses its value to 64 bits, and `outwards` takes the
//! floats next to the ball's ends. So each end is the nearest float on its side, or, where that lies within
//! some 2⁻⁶¹ of the value's size, perhaps the next one. What remains to be proved is where a function has its
//! least and greatest values over an interval:
//!
//! - log, log1p, √, exp, expm1, sinh and atan rise: at the ends. cosh is even and rises over |x|.
//! - sin and cos, over less than π: their critical points are π apart, so that at most one is inside. If the
//!   slopes at the ends have one sign, there is none, and the range is that of the ends; if they have two,
//!   there is one, with value 1 where the first is positive and −1 where it is negative. An end where the
//!   slope is exactly 0 is the critical point itself. Intervals up to 6 wide are halved first, wider ones
//!   give [−1, 1].
//! - tan, over less than π: between two poles it rises, and over one pole tan of the upper end is the lesser,
//!   being that of a point π below, which lies before the lower end on its branch.
//! - x^y = e^(y log x) over a box: y log x is linear in y and in log x, so that its extremes are at corners,
//!   those with log 0 = −∞ and infinite ends as limits, and 0·∞ = 0 as for products of intervals.
//!
//! Ends beyond ±1000 may be taken as ±1000 by exp, expm1, sinh and cosh: e^1000 lies above all floats and
//! e^−1000 below all positive ones, so that the floats next to their values are the same; and infinite ends
//! by atan as the largest float, whose outer neighbour of atan lies beyond ±π/2. Cost: some microseconds.

use std::sync::LazyLock;

use num_traits::float::FloatCore;

use super::{
    Ball, Elementary, FloatInterval, Precision, Real, Sign, Transcendental, float_sine::enclose,
    radius::Radius,
};

/// 64 bits and their π, made once.
static BITS: LazyLock<Precision> = LazyLock::new(|| Precision::new(64));

/// A finite float, exactly.
fn point(x: f64) -> Ball {
    let (mantissa, exponent, sign) = FloatCore::integer_decode(x);
    let ball = Ball::new(mantissa.into(), exponent.into(), Radius::ZERO, 64);
    if sign < 0 { -ball } else { ball }
}

/// An interval of one float.
fn exactly(x: f64) -> FloatInterval {
    FloatInterval::from_bounds(x, x)
}

/// The floats next to the ends of a ball.
fn outwards(ball: &Ball) -> FloatInterval {
    let Some([low, high]) = ball.ends() else { return FloatInterval::WHOLE };
    FloatInterval::from_bounds(around(&low).lo(), around(&high).hi())
}

/// The floats next to a point, or it itself.
fn around(point: &Ball) -> FloatInterval {
    let magnitude = point.mid().magnitude();
    let excess = magnitude.bits().saturating_sub(64);
    let cut = magnitude.trailing_zeros().is_some_and(|zeros| zeros < excess);
    let Some(m) = (magnitude >> excess).iter_u64_digits().next() else {
        return exactly(0.0);
    };
    // Within ±2⁶³, and what is beyond the floats stays there.
    let e = (point.unit_exponent() + i128::from(excess)).clamp(-1 << 40, 1 << 40) as i64;
    let near = enclose(m, u64::from(cut), e);
    if point.mid().sign() == num_bigint::Sign::Minus { -near } else { near }
}

/// A function that rises, of an interval whose ends are first brought within `limit`; an upper end of ∞ that
/// is within it gives ∞.
fn rising(x: FloatInterval, limit: f64, at: impl Fn(&Ball) -> Ball) -> FloatInterval {
    let value = |end: f64| match end.clamp(-limit, limit) {
        f64::INFINITY => FloatInterval::from_bounds(f64::MAX, f64::INFINITY),
        end => outwards(&at(&point(end))),
    };
    let low = value(x.lo());
    if x.lo() == x.hi() { low } else { FloatInterval::from_bounds(low.lo(), value(x.hi()).hi()) }
}

/// A logarithm: a rising function of numbers above an edge, where it tends to −∞.
fn logarithm(x: FloatInterval, edge: f64, at: impl Fn(&Ball) -> Ball) -> FloatInterval {
    if x.lo() < edge || x.hi() == edge {
        return FloatInterval::WHOLE;
    }
    if x.lo() > edge {
        return rising(x, f64::INFINITY, at);
    }
    let high = rising(FloatInterval::from_bounds(x.hi(), x.hi()), f64::INFINITY, at);
    FloatInterval::from_bounds(f64::NEG_INFINITY, high.hi())
}

/// sin, or cos if `cosine`, of an interval.
fn wave(x: FloatInterval, cosine: bool) -> FloatInterval {
    let unit = FloatInterval::from_bounds(-1.0, 1.0);
    // To nearest: 3 and 6 are far enough below π and 2π.
    let width = x.hi() - x.lo();
    if width.is_nan() || width > 6.0 {
        return unit;
    }
    if width > 3.0 {
        let middle = x.lo() + width / 2.0;
        let half = |lo, hi| wave(FloatInterval::from_bounds(lo, hi), cosine);
        return half(x.lo(), middle).hull(half(middle, x.hi()));
    }
    let [(low, rises), (high, falls)] = [x.lo(), x.hi()].map(|end| {
        let (sin, cos) = point(end).sin_cos(&BITS);
        let (value, slope) = if cosine { (cos, -sin) } else { (sin, cos) };
        (outwards(&value), slope.sign())
    });
    let range = match (rises, falls) {
        (Some(Sign::Positive), Some(Sign::Negative)) => low.hull(high).hull(exactly(1.0)),
        (Some(Sign::Negative), Some(Sign::Positive)) => low.hull(high).hull(exactly(-1.0)),
        (Some(_), Some(_)) => low.hull(high),
        _ => unit,
    };
    range.max(exactly(-1.0)).min(exactly(1.0))
}

impl Elementary for FloatInterval {
    fn pi((): &()) -> FloatInterval {
        outwards(&Ball::pi(&BITS))
    }

    fn exp(&self, (): &()) -> FloatInterval {
        rising(*self, 1000.0, |x| x.exp(&BITS))
    }

    fn sin_cos(&self, (): &()) -> (FloatInterval, FloatInterval) {
        (wave(*self, false), wave(*self, true))
    }

    fn sqrt(&self) -> FloatInterval {
        if self.lo() < 0.0 { FloatInterval::WHOLE } else { rising(*self, f64::INFINITY, Ball::sqrt) }
    }
}

/// Each end is a float next to the true range's, or the one after it.
impl Transcendental for FloatInterval {
    fn log(&self, (): &()) -> FloatInterval {
        logarithm(*self, 0.0, |x| x.log(&BITS))
    }

    fn log1p(&self, (): &()) -> FloatInterval {
        logarithm(*self, -1.0, |x| x.log1p(&BITS))
    }

    fn expm1(&self, (): &()) -> FloatInterval {
        rising(*self, 1000.0, |x| x.expm1(&BITS)).max(exactly(-1.0))
    }

    fn pow(&self, exponent: &FloatInterval, (): &()) -> FloatInterval {
        if self.lo() < 0.0 {
            return FloatInterval::WHOLE;
        }
        let corner = |x: f64, y: f64| {
            if x > 0.0 && x.is_finite() && y.is_finite() {
                let power = outwards(&point(x).pow(&point(y), &BITS));
                // Beyond e^2⁶² too much to be a ball.
                if power != FloatInterval::WHOLE {
                    return power;
                }
            }
            // y log x is 0, −∞ or ∞, or as good as that.
            let size = if x == 1.0 || y == 0.0 { 0.0 } else { (x - 1.0).signum() * y.signum() };
            match size {
                0.0 => exactly(1.0),
                1.0 => FloatInterval::from_bounds(f64::MAX, f64::INFINITY),
                _ => exactly(0.0),
            }
        };
        let edge = |y: f64| corner(self.lo(), y).hull(corner(self.hi(), y));
        if self.hi() == 0.0 && exponent.lo() <= 0.0 {
            return FloatInterval::WHOLE;
        }
        edge(exponent.lo()).hull(edge(exponent.hi()))
    }

    fn atan(&self, (): &()) -> FloatInterval {
        rising(*self, f64::MAX, |x| x.atan(&BITS))
    }

    fn tan(&self, (): &()) -> FloatInterval {
        if !(self.lo().is_finite() && self.hi().is_finite()) {
            return FloatInterval::WHOLE;
        }
        let less_than_pi = Ball::pi(&BITS) - &(point(self.hi()) - &point(self.lo()));
        if less_than_pi.sign() != Some(Sign::Positive) {
            return FloatInterval::WHOLE;
        }
        let [low, high] = [self.lo(), self.hi()].map(|end| point(end).tan(&BITS));
        let rises = self.lo() == self.hi() || (high.clone() - &low).sign() == Some(Sign::Positive);
        if rises { outwards(&low).hull(outwards(&high)) } else { FloatInterval::WHOLE }
    }

    fn sinh(&self, (): &()) -> FloatInterval {
        rising(*self, 1000.0, |x| x.sinh(&BITS))
    }

    fn cosh(&self, (): &()) -> FloatInterval {
        rising(self.abs(), 1000.0, |x| x.cosh(&BITS)).max(exactly(1.0))
    }
}
