//! The top of a wall's motion Σ A cos jt + B sin jt: when it is reached, how high it is, and the motion seen
//! from there.
//!
//! Exact for one harmonic, and for cosines with their top at 0 or π; else the top is enclosed by balls, and
//! all that follows from it.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{
    fail,
    profile::Term,
    rational::{RationalFunction, root},
};
use crate::{
    error::Result,
    number::{Ball, Elementary, Precision, Real},
};

/// An order j with the coefficients of cos jt and sin jt.
pub(super) type Wave = (u32, [RationalFunction; 2]);

/// How high the top is.
enum Height {
    /// By its square.
    Square(RationalFunction),
    /// Between bounds.
    Between(Ball),
}

/// The top.
pub(super) struct Top {
    height: Height,
    /// The motion from there on, divided by the height.
    pub harmonics: Vec<Term>,
}

/// Bits of the balls.
const BITS: u32 = 128;

/// Of a motion whose orders have no common divisor.
pub(super) fn top(motion: &[Wave]) -> Result<Top> {
    let (zero, one) = (BigRational::zero(), BigRational::one());
    if let [(_, [a, b])] = motion {
        let square = a.clone() * a + &(b.clone() * b);
        if !square.is_positive() {
            return fail("the wall must move, seen from the motion without it");
        }
        let harmonics = vec![(1, [[one.clone(), one], [zero.clone(), zero]])];
        return Ok(Top { height: Height::Square(square), harmonics });
    }
    let what = "the wall's motion";
    let ranges = motion
        .iter()
        .map(|(j, [a, b])| Ok((*j, [a.bounded(what)?, b.bounded(what)?])))
        .collect::<Result<Vec<_>>>()?;
    let at = highest(&ranges);
    let odd = (at.abs() - std::f64::consts::PI).abs() < 1e-9;
    if (odd || at.abs() < 1e-9) && motion.iter().all(|(_, [_, b])| b.is_zero()) {
        let sign = |j: u32| RationalFunction::integer(if odd && j % 2 == 1 { -1 } else { 1 }, &());
        let signed: Vec<_> = motion.iter().map(|(j, [a, _])| (*j, a.clone() * &sign(*j))).collect();
        let sum = RationalFunction::integer(0, &());
        let height = signed.iter().fold(sum, |sum, (_, a)| sum + a);
        if !height.is_positive() {
            return fail("the wall's top is not certainly above its mean");
        }
        let term = |(j, a): &(u32, RationalFunction)| {
            Ok((u64::from(*j), [(a.clone() / &height).bounded(what)?, [zero.clone(), zero.clone()]]))
        };
        let harmonics = signed.iter().map(term).collect::<Result<_>>()?;
        return Ok(Top { height: Height::Square(height.clone() * &height), harmonics });
    }
    enclosed(&ranges, at)
}

/// About where the motion with the middle of its coefficients is highest.
fn highest(ranges: &[(u32, [[BigRational; 2]; 2])]) -> f64 {
    let float = |[lo, hi]: &[BigRational; 2]| 0.5 * (lo.to_f64().unwrap_or(0.0) + hi.to_f64().unwrap_or(0.0));
    let terms: Vec<_> = ranges.iter().map(|(j, [a, b])| (f64::from(*j), float(a), float(b))).collect();
    let height = |t: f64| terms.iter().map(|(j, a, b)| a * (j * t).cos() + b * (j * t).sin()).sum::<f64>();
    let steps = 64 * ranges.last().map_or(1, |last| last.0);
    let phase = |i: u32| std::f64::consts::PI * (2.0 * f64::from(i) / f64::from(steps) - 1.0);
    // From 0 outwards, so that of two tops alike the one at 0 is taken.
    let mut phases: Vec<f64> = (0..steps).map(phase).collect();
    phases.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    let mut best = 0.0;
    for t in phases {
        if height(t) > height(best) + 1e-12 {
            best = t;
        }
    }
    let slope =
        |t: f64| terms.iter().map(|(j, a, b)| j * (b * (j * t).cos() - a * (j * t).sin())).sum::<f64>();
    let bend =
        |t: f64| terms.iter().map(|(j, a, b)| -j * j * (a * (j * t).cos() + b * (j * t).sin())).sum::<f64>();
    (0..50).fold(best, |t, _| t - if bend(t) == 0.0 { 0.0 } else { slope(t) / bend(t) })
}

/// The top near a phase, by balls: the slope is positive a little before, negative a little after, and falls
/// between.
fn enclosed(ranges: &[(u32, [[BigRational; 2]; 2])], at: f64) -> Result<Top> {
    let precision = Precision::new(BITS);
    let terms: Vec<(i32, [Ball; 2])> = ranges
        .iter()
        .map(|(j, both)| (*j as i32, both.each_ref().map(|[lo, hi]| Ball::between(lo, hi, &precision))))
        .collect();
    let turned = |t: &Ball| {
        // A cos j(t + s) + B sin j(t + s) = a cos js + b sin js.
        let one = |(j, [a, b]): &(i32, [Ball; 2])| {
            let (sin, cos) = (Ball::integer(*j, &precision) * t).sin_cos(&precision);
            let first = a.clone() * &cos + &(b.clone() * &sin);
            (*j, [first, b.clone() * &cos - &(a.clone() * &sin)])
        };
        terms.iter().map(one).collect::<Vec<_>>()
    };
    let sum = |all: &[(i32, [Ball; 2])], part: usize, order: u32| {
        let term = |(j, both): &(i32, [Ball; 2])| Ball::integer(j.pow(order), &precision) * &both[part];
        all.iter().map(term).fold(Ball::integer(0, &precision), |sum, term| sum + &term)
    };
    let Some(centre) = BigRational::from_float(at) else { return fail("the wall's top was not found") };
    for halvings in (8..=50).rev() {
        let radius = BigRational::new(1.into(), num_bigint::BigInt::one() << halvings);
        let (lo, hi) = (&centre - &radius, &centre + &radius);
        let [left, right] = [&lo, &hi].map(|t| sum(&turned(&Ball::ratio(t, &precision)), 1, 1));
        let all = turned(&Ball::between(&lo, &hi, &precision));
        let (height, bend) = (sum(&all, 0, 0), sum(&all, 0, 2));
        if [left, -right, bend, height.clone()].iter().any(|x| positive(x).is_none()) {
            continue;
        }
        let places = |x: Ball| {
            let Some((lo, hi)) = x.exact_bounds() else { return fail("the wall's top is not bounded") };
            let scale = BigRational::from_integer(num_bigint::BigInt::from(10u64.pow(13)));
            Ok([(lo * &scale).floor() / &scale, (hi * &scale).ceil() / &scale])
        };
        let harmonics = all
            .into_iter()
            .map(|(j, both)| {
                let [a, b] = both.map(|part| places(part / &height));
                Ok((j.unsigned_abs().into(), [a?, b?]))
            })
            .collect::<Result<_>>()?;
        return Ok(Top { height: Height::Between(height), harmonics });
    }
    fail("where the wall is highest is not certain: take a smaller range")
}

/// Its least number if that is positive.
fn positive(x: &Ball) -> Option<BigRational> {
    x.exact_bounds().map(|(lo, _)| lo).filter(Signed::is_positive)
}

impl Top {
    /// The height, from its least to its greatest.
    fn ball(&self) -> Result<[BigRational; 2]> {
        match &self.height {
            Height::Square(square) => {
                let [lo, hi] = square.bounded("the wall's amplitude")?;
                Ok([root(&lo, false), root(&hi, true)])
            }
            Height::Between(ball) => match ball.exact_bounds() {
                Some((lo, hi)) => Ok([lo, hi]),
                None => fail("the wall's top is not bounded"),
            },
        }
    }

    /// The least and the greatest of the height's square.
    pub fn square(&self) -> Result<[BigRational; 2]> {
        match &self.height {
            Height::Square(square) => square.bounded("the wall's amplitude"),
            Height::Between(_) => Ok(self.ball()?.map(|x| &x * &x)),
        }
    }

    /// The range of a number that does not change its sign, divided by the height.
    pub fn ratio(&self, x: &RationalFunction, what: &str) -> Result<[BigRational; 2]> {
        match &self.height {
            Height::Square(square) => {
                let [lo, hi] = (x.clone() * x / square).bounded(what)?;
                let (lo, hi) = (root(&lo, false), root(&hi, true));
                Ok(if x.is_nonnegative() { [lo, hi] } else { [-hi, -lo] })
            }
            Height::Between(_) => {
                let [least, most] = self.ball()?;
                let [lo, hi] = x.bounded(what)?;
                let lower = if lo.is_negative() { &least } else { &most };
                let upper = if hi.is_negative() { &most } else { &least };
                Ok([lo / lower, hi / upper])
            }
        }
    }

    /// σ, whether ν = 0 at the range's end, and the range of ν, where σν = 1 + C/H, from the mean C.
    pub fn depth(&self, mean: &RationalFunction) -> Result<(bool, bool, [BigRational; 2])> {
        let one = BigRational::one();
        let grazes =
            "the free motion grazes the wall within the range: take a range on one side of the grazing";
        let Height::Square(square) = &self.height else {
            let [lo, hi] = self.ratio(mean, "the wall's mean over its amplitude")?.map(|x| &one + x);
            return match (lo.is_positive(), hi.is_negative()) {
                (true, _) => Ok((true, false, [lo, hi])),
                (_, true) => Ok((false, false, [-hi, -lo])),
                _ => fail(grazes),
            };
        };
        if mean.is_nonnegative() {
            let [lo, hi] = self.ratio(mean, "the wall's mean over its amplitude")?;
            return Ok((true, false, [&one + lo, one + hi]));
        }
        if !(-mean.clone()).is_nonnegative() {
            return fail("the wall's mean position must not change its sign within the range");
        }
        let [lo, hi] = self.ratio(mean, "the wall's mean over its amplitude")?;
        let beyond = square.clone() - &(mean.clone() * mean);
        let open = beyond.constant().is_none()
            && beyond.ends().is_some_and(|[_, end]| end.iter().all(Zero::is_zero));
        let least = |x: BigRational| if x.is_negative() { BigRational::zero() } else { x };
        if beyond.is_positive() {
            Ok((true, open, [&one + lo, one + hi].map(least)))
        } else if (-beyond).is_positive() {
            Ok((false, open, [-(&one + hi), -(one + lo)].map(least)))
        } else {
            fail(grazes)
        }
    }

    /// A number that mean + motion, divided by the height, is never below.
    pub fn least(&self, mean: &RationalFunction, motion: &[Wave]) -> Result<BigRational> {
        let what = "the other wall";
        let mut least = mean.bounded(what)?[0].clone();
        for part in motion.iter().flat_map(|wave| &wave.1) {
            let [lo, hi] = part.bounded(what)?;
            least -= lo.abs().max(hi.abs());
        }
        let [lo, hi] = self.ball()?;
        Ok(if least.is_negative() { least / lo } else { least / hi })
    }
}
