//! log, log1p, expm1, x^y, atan, tan, sinh and cosh of enclosed numbers, and the constants e and ln 2.
//!
//! # Of balls
//!
//! A value at a point x is exp's, sin's and cos's, or `inverse`'s, each with its own bound, and ball
//! arithmetic bounds what joins them; where that cancels, it has as many bits more:
//!
//! - expm1 x = e^x − 1 loses −log₂ |x| bits, which e^x has more; below 2^(−b−8) it is x within x², since |e^x
//!   − 1 − x| ≤ x² for |x| ≤ 1.
//! - sinh x = (u + u/(1 + u))/2 for x ≥ 0 and u = expm1 x: two numbers ≥ 0. cosh x = (e^x + e^−x)/2.
//! - tan x = sin x/cos x, both to 32 bits more than b.
//! - x^y = e^(y log x): an error in y log x, below 2⁶², becomes a relative one; log x has 80 bits more.
//!
//! Of a ball, m ± r, it is f(m) ± r·max |f′|, with f′ enclosed over the ball (mean value theorem), if that
//! enclosure of f′ has 8 certain bits: then the slope does not vary more than that over the ball, and the
//! result is at most 1 + 2⁻⁷ times as wide as the range, and rounding. Else f rises over the ball, or falls,
//! and it is the hull of the values at both ends. cosh is even: it rises over |x|. tan rises between its
//! poles: over less than π there is none if and only if tan of the upper end is above that of the lower end.

use super::{
    Ball, Elementary, Plain, Precision, Real, Sign,
    elementary::{exp, point_exp, point_sin_cos},
    inverse,
    radius::Radius,
};

/// A rung with more functions of its own numbers.
///
/// Each result is of every enclosed x for which the function is defined and real. If it is not for some of
/// them, nothing is known of the result; an interval may touch the edge of a domain.
///
/// ```
/// use grazing_number::{Ball, Precision, Transcendental, parse_rational};
/// let bits = Precision::new(128);
/// let x = Ball::between(&parse_rational("0.5")?, &parse_rational("0.5")?, &bits);
/// assert_eq!(format!("{:.20}", x.log(&bits)), "[-0.69314718055994530942 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.log1p(&bits)), "[0.40546510810816438198 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.expm1(&bits)), "[0.64872127070012814685 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.pow(&x, &bits)), "[0.70710678118654752440 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.atan(&bits)), "[0.46364760900080611621 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.tan(&bits)), "[0.54630248984379051326 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.sinh(&bits)), "[0.52109530549374736162 +/- 1e-20]");
/// assert_eq!(format!("{:.20}", x.cosh(&bits)), "[1.1276259652063807852 +/- 1e-19]");
/// assert_eq!(format!("{:.20}", Ball::e(&bits)), "[2.7182818284590452354 +/- 1e-19]");
/// assert_eq!(format!("{:.20}", Ball::ln_2(&bits)), "[0.69314718055994530942 +/- 1e-20]");
/// assert!((x.clone() - &x.clone()).log(&bits).exact_bounds().is_none(), "log 0");
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
pub trait Transcendental: Elementary {
    /// e.
    fn e(context: &Self::Context) -> Self {
        Self::integer(1, context).exp(context)
    }

    /// ln 2.
    fn ln_2(context: &Self::Context) -> Self {
        Self::integer(2, context).log(context)
    }

    /// log x, to base e, for x > 0.
    #[must_use]
    fn log(&self, context: &Self::Context) -> Self;

    /// log(1 + x) for x > −1, with all its digits for x near 0.
    #[must_use]
    fn log1p(&self, context: &Self::Context) -> Self;

    /// e^x − 1, with all its digits for x near 0.
    #[must_use]
    fn expm1(&self, context: &Self::Context) -> Self;

    /// x^y for x > 0, and 0 for x = 0 and y > 0. Of negative x nothing is known, not even for whole y: a
    /// whole power is a product.
    #[must_use]
    fn pow(&self, exponent: &Self, context: &Self::Context) -> Self;

    /// atan x, between −π/2 and π/2.
    #[must_use]
    fn atan(&self, context: &Self::Context) -> Self;

    /// tan x; nothing is known of the result if a pole may be enclosed.
    #[must_use]
    fn tan(&self, context: &Self::Context) -> Self;

    /// sinh x.
    #[must_use]
    fn sinh(&self, context: &Self::Context) -> Self;

    /// cosh x.
    #[must_use]
    fn cosh(&self, context: &Self::Context) -> Self;
}

/// No guarantee: the platform's own functions.
impl Transcendental for Plain {
    fn log(&self, (): &()) -> Plain {
        Plain(self.0.ln())
    }

    fn log1p(&self, (): &()) -> Plain {
        Plain(self.0.ln_1p())
    }

    fn expm1(&self, (): &()) -> Plain {
        Plain(self.0.exp_m1())
    }

    fn pow(&self, exponent: &Plain, (): &()) -> Plain {
        Plain(self.0.powf(exponent.0))
    }

    fn atan(&self, (): &()) -> Plain {
        Plain(self.0.atan())
    }

    fn tan(&self, (): &()) -> Plain {
        Plain(self.0.tan())
    }

    fn sinh(&self, (): &()) -> Plain {
        Plain(self.0.sinh())
    }

    fn cosh(&self, (): &()) -> Plain {
        Plain(self.0.cosh())
    }
}

/// f of a ball by one slope, if f does not turn or bend much there.
fn steady(x: &Ball, at: &dyn Fn(&Ball) -> Ball, slope: &dyn Fn(&Ball) -> Ball) -> Option<Ball> {
    if x.radius().is_zero() {
        return Some(at(x));
    }
    let slope = slope(&x.clone().cut(64));
    let steady = slope.certain_bits().is_none_or(|bits| bits >= 8);
    steady.then(|| at(&x.centre()).widened(slope.greatest_magnitude() * x.radius()))
}

/// f of a ball over which it rises or falls.
fn monotone(x: &Ball, at: &dyn Fn(&Ball) -> Ball, slope: &dyn Fn(&Ball) -> Ball) -> Ball {
    steady(x, at, slope).unwrap_or_else(|| match x.ends() {
        Some([low, high]) => at(&low).hull(&at(&high)),
        None => Ball::whole(x.bits()),
    })
}

fn one_plus(x: &Ball) -> Ball {
    Ball::integer_at(1, x.bits()) + x
}

/// log x to `bits` bits.
fn log(x: &Ball, context: &Precision, bits: u32) -> Ball {
    if x.sign() != Some(Sign::Positive) {
        return Ball::whole(bits);
    }
    monotone(x, &|x| inverse::log(x, context, bits), &|x| Ball::integer_at(1, 64) / x)
}

/// e^x − 1 of a point.
fn point_expm1(x: &Ball, bits: u32) -> Ball {
    match x.exponent() {
        None => Ball::zero(bits),
        Some(e) if e < -i64::from(bits) - 8 => {
            let size = x.greatest_magnitude();
            x.clone().widened(size * size).cut(bits)
        }
        Some(e) => {
            let more = bits + 16 + (-e).max(0) as u32;
            (point_exp(x, more) - &Ball::integer_at(1, more)).cut(bits)
        }
    }
}

/// sinh x of a point.
fn point_sinh(x: &Ball, bits: u32) -> Ball {
    if x.sign() == Some(Sign::Negative) {
        return -point_sinh(&-x.clone(), bits);
    }
    let u = point_expm1(x, bits + 8);
    (u.clone() + &(u.clone() / &one_plus(&u))).scaled(-1).cut(bits)
}

/// cosh x of a point.
fn point_cosh(x: &Ball, bits: u32) -> Ball {
    let power = point_exp(x, bits + 8);
    (Ball::integer_at(1, bits + 8) / &power + &power).scaled(-1).cut(bits)
}

/// For b bits: width at most 3 times that of the correctly rounded enclosure for a point, and for wide
/// arguments at most 1 + 2⁻⁷ times the width of the true range more (of x^y, as if x and y did not know of
/// each other). Cost: O(√b) products of b bits.
impl Transcendental for Ball {
    fn log(&self, context: &Precision) -> Ball {
        log(self, context, context.bits())
    }

    fn log1p(&self, context: &Precision) -> Ball {
        let bits = context.bits();
        if self.greatest_magnitude().is_within(-2) {
            return monotone(self, &|x| inverse::log1p(x, bits).cut(bits), &|x| {
                Ball::integer_at(1, 64) / &one_plus(x)
            });
        }
        log(&one_plus(&self.clone().cut(bits.max(self.bits()) + 64)), context, bits)
    }

    fn expm1(&self, context: &Precision) -> Ball {
        monotone(self, &|x| point_expm1(x, context.bits()), &|x| exp(x, 64))
    }

    fn pow(&self, exponent: &Ball, context: &Precision) -> Ball {
        let bits = context.bits();
        if self.sign() == Some(Sign::Positive) {
            return exp(&(log(self, context, bits + 80) * exponent), bits);
        }
        // From 0 on: x^y rises with x for y > 0.
        let high = self.ends().filter(|_| self.is_from_zero_on() && exponent.sign() == Some(Sign::Positive));
        let zero = Ball::zero(bits);
        high.map_or(Ball::whole(bits), |[_, high]| match high.sign() {
            Some(Sign::Zero) => zero,
            _ => zero.hull(&high.pow(exponent, context)),
        })
    }

    fn atan(&self, context: &Precision) -> Ball {
        if self.radius().is_infinite() {
            let right = Ball::pi(context).scaled(-1);
            return right.hull(&-right.clone());
        }
        monotone(self, &|x| inverse::atan(x, context), &|x| {
            Ball::integer_at(1, 64) / &one_plus(&(x.clone() * x))
        })
    }

    /// From 2^4096 on nothing is known.
    fn tan(&self, context: &Precision) -> Ball {
        let bits = context.bits();
        if self.exponent().is_some_and(|e| e > 4096) {
            return Ball::whole(bits);
        }
        let at = |x: &Ball| {
            let (sin, cos) = point_sin_cos(x, context);
            (sin / &cos).cut(bits)
        };
        let slope = |x: &Ball| {
            let cos = x.sin_cos(context).1;
            Ball::integer_at(1, 64) / &(cos.clone() * &cos)
        };
        steady(self, &at, &slope).unwrap_or_else(|| {
            // The ends that are computed, which of a long number are far beyond its own.
            let narrow = |[low, high]: &[Ball; 2]| {
                !Radius::new(3, 0).is_below((high.clone() - low).greatest_magnitude())
            };
            let ends = self.ends().filter(narrow).map(|ends| ends.map(|end| at(&end)));
            let rising = ends.filter(|[low, high]| (high.clone() - low).sign() == Some(Sign::Positive));
            rising.map_or(Ball::whole(bits), |[low, high]| low.hull(&high))
        })
    }

    fn sinh(&self, context: &Precision) -> Ball {
        let slope = |x: &Ball| (exp(x, 64) + &exp(&-x.clone(), 64)).scaled(-1);
        monotone(self, &|x| point_sinh(x, context.bits()), &slope)
    }

    fn cosh(&self, context: &Precision) -> Ball {
        let slope = |x: &Ball| (exp(x, 64) - &exp(&-x.clone(), 64)).scaled(-1);
        monotone(&self.abs(), &|x| point_cosh(x, context.bits()), &slope)
    }
}
