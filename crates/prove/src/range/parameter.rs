//! The depth ν as a function of a parameter of the machine: proved to run from the touch one way only, and
//! turned back into the parameter, rounded inwards.
//!
//! Seen from the motion without the wall, the wall's mean is C and its top H above that, and σν = 1 + C/H.
//! Let the parameter scale the wall's motion as a whole: by A, the amplitude if there is one harmonic. For
//! C < 0 then σν = 1 − √(R/h) with R = C²/A², a rational function of the parameter, and h = H²/A²: 1 for one
//! harmonic, else a number that may be known by bounds only. R = h is the touch, R < h beyond it and R > h
//! before, and ν increases away from the touch where R runs one way. All of this is exact; where it cannot be
//! shown, the range is shorter or there is none.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::{
    chaos::{RationalFunction, Term, touch::Touch},
    error::{Error, Result},
    motion::{Side, System},
    number::Real,
};

/// The system where the parameter is this number, or runs through these.
pub type SystemOver<'a> = &'a dyn Fn(&RationalFunction) -> Result<System<RationalFunction>>;

/// A side of a touch in a parameter p.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParameterRange {
    /// Between these the motion without the wall touches it, once; one number, if that is where.
    pub touch: [BigRational; 2],
    /// For every p from the touch, not included, to here, included, the depth is above 0 and at most as
    /// given, and it increases away from the touch.
    pub end: BigRational,
}

/// A machine near its touch, over a range of its parameter.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Touching {
    /// Whether there are two walls, each the other's mirror image as seen from the motion without them.
    pub mirrored: bool,
    /// c, k and τ, each the least and the greatest, in a time in which the wall's period is 2π: exactly where
    /// they are rational and do not change with the parameter, else rounded outwards.
    pub parameters: [[BigRational; 2]; 3],
    /// R.
    pub ratio: RationalFunction,
    /// h is from the first to the second.
    pub top: [BigRational; 2],
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// Whether damping, stiffness or restitution may change with the parameter.
    pub changes: bool,
}

impl Touching {
    /// Of a system for a range of the parameter.
    ///
    /// # Errors
    /// An input error that says what is not covered: two walls that are not mirror images, a wall's motion
    /// whose form changes with the parameter, as seen from the motion without the wall, damping, stiffness or
    /// restitution that are not between their values at the range's ends.
    pub fn of(system: &System<RationalFunction>, side: Option<Side>) -> Result<Touching> {
        let Touch { mirrored, parameters, ratio, top, harmonics } = Touch::of(system, side)?;
        let changes = parameters.iter().any(|x| x.value().is_none());
        let [damping, stiffness, restitution] = &parameters;
        let parameters = [
            beyond(damping.bounded("the damping")?),
            beyond(stiffness.bounded("the stiffness")?),
            beyond(restitution.bounded("the restitution")?),
        ];
        Ok(Touching { mirrored, parameters, ratio, top, harmonics, changes })
    }
}

/// Digits of ranges of damping, stiffness and restitution; of decimals a certificate holds so many.
const DIGITS: f64 = 11.0;
const PLACES: f64 = 14.0;

/// One number as it is, two with few digits and no less between them.
pub(super) fn outwards(ends: [BigRational; 2]) -> [BigRational; 2] {
    rounded(ends, |x| x.floor(), |x| x.ceil())
}

/// The same with more between them: whoever encloses an end finds it inside.
fn beyond(ends: [BigRational; 2]) -> [BigRational; 2] {
    rounded(ends, |x| x.ceil() - BigRational::one(), |x| x.floor() + BigRational::one())
}

fn rounded(
    [lo, hi]: [BigRational; 2],
    down: impl Fn(BigRational) -> BigRational,
    up: impl Fn(BigRational) -> BigRational,
) -> [BigRational; 2] {
    if lo == hi {
        return [lo, hi];
    }
    let size = lo.abs().max(hi.abs()).to_f64().unwrap_or(f64::INFINITY);
    let places = (DIGITS - 1.0 - size.log10().floor()).clamp(0.0, PLACES);
    let scale = BigRational::from_integer(BigInt::from(10).pow(places as u32));
    [down(lo * &scale) / &scale, up(hi * &scale) / scale]
}

fn fail(message: &str) -> Error {
    Error::input(message)
}

/// How many times a step is doubled or halved.
const STEPS: u32 = 60;

/// A side of a touch, where the wall is passed or not, before it is known how far a depth is.
#[derive(Debug, Clone)]
pub struct TouchSide {
    side: Option<Side>,
    /// Whether it is the one where the wall is passed, R being below h.
    behind: bool,
    /// The least and the greatest h.
    top: [BigRational; 2],
    /// The touch as in a range.
    touch: [BigRational; 2],
    /// A parameter certainly on the other side, and one certainly on this side and nearer to the touch.
    outer: BigRational,
    inner: BigRational,
    /// A small step away from the touch.
    step: BigRational,
}

/// Two numbers between which R is at a value of the parameter.
fn value(system: SystemOver, side: Option<Side>, at: &RationalFunction) -> Result<[BigRational; 2]> {
    let ratio = Touch::ratio(&system(at)?, side)?;
    ratio.value().ok_or_else(|| fail("the wall's height is not a number"))
}

/// The same of a number to all digits that count.
fn ratio(system: SystemOver, side: Option<Side>, p: &BigRational) -> Result<[BigRational; 2]> {
    // What cancels exactly, and is to, does so exactly alone.
    value(system, side, &RationalFunction::about(p))
        .or_else(|_| value(system, side, &RationalFunction::ratio(p, &())))
}

impl TouchSide {
    /// The touch near `start`, and the side where the wall is passed (`behind`, where R is below h) or not;
    /// `unit` is a small step of the parameter. None if there is no touch near.
    ///
    /// Cost: about 125 evaluations of R.
    ///
    /// # Errors
    /// As [`Touching::of`].
    pub fn of(
        system: SystemOver,
        side: Option<Side>,
        [start, unit]: [&BigRational; 2],
        behind: bool,
    ) -> Result<Option<TouchSide>> {
        let exactly = |p: &BigRational| RationalFunction::ratio(p, &());
        let [least, greatest] = Touch::of(&system(&exactly(start))?, side)?.top;
        let ratio = |p: &BigRational| ratio(system, side, p);
        let on_side = |[lo, hi]: &[BigRational; 2]| if behind { *hi < least } else { *lo > greatest };
        let on_other = |[lo, hi]: &[BigRational; 2]| if behind { *lo >= greatest } else { *hi <= least };
        // Which way, and a point on either side of the touch.
        let (left, right) = (start - unit, start + unit);
        let both = [ratio(&left)?, ratio(&right)?];
        let at_right = on_other(&both[0]) && on_side(&both[1]);
        let at_left = on_side(&both[0]) && on_other(&both[1]);
        if at_left == at_right {
            return Ok(None);
        }
        let step = if at_right { unit.clone() } else { -unit };
        let [outer, first] = if at_right { [left, right] } else { [right, left] };
        // Between these two it is not known how high the top is.
        let inner = edge(&|p| Ok(on_side(&ratio(p)?)), &first, &outer)?;
        let other = edge(&|p| Ok(on_other(&ratio(p)?)), &outer, &first)?;
        let touch = if other < inner { [other, inner.clone()] } else { [inner.clone(), other] };
        let short = simplest(&touch[0], &touch[1]);
        let is_short =
            least == greatest && value(system, side, &exactly(&short))?.iter().all(|r| *r == least);
        let touch = if is_short { [short.clone(), short] } else { touch };
        Ok(Some(TouchSide { side, behind, top: [least, greatest], touch, outer, inner, step }))
    }

    /// The parameters up to a depth, of the same system; none if ν is not shown to increase even on a short
    /// range.
    ///
    /// Cost: about 125 evaluations of R.
    ///
    /// # Errors
    /// As [`Touching::of`].
    pub fn range(&self, system: SystemOver, depth: &BigRational) -> Result<Option<ParameterRange>> {
        let TouchSide { side, behind, top: [least, greatest], touch, outer, inner, step } = self;
        let one = BigRational::one();
        // ν ≤ depth, whatever h is: √R ≥ (1 − depth) √h beyond, √R ≤ (1 + depth) √h before.
        let limit = if *behind { &one - depth } else { &one + depth };
        let square = if limit.is_positive() { &limit * &limit } else { BigRational::zero() };
        let square = square * if *behind { greatest } else { least };
        let inside = |p: &BigRational| -> Result<bool> {
            let [lo, hi] = ratio(system, *side, p)?;
            Ok(if *behind { hi < *least && lo >= square } else { lo > *greatest && hi <= square })
        };
        if !inside(inner)? {
            return Ok(None);
        }
        let mut end = farthest(&inside, inner, step)?;
        // R runs one way from the outer point to the end.
        for _ in 0..STEPS {
            let (from, to) = if *outer < end { (outer, &end) } else { (&end, outer) };
            let over = RationalFunction::range(from, Some(to));
            if Touch::ratio(&system(&over)?, *side)?.runs_one_way() {
                return Ok(Some(ParameterRange { touch: touch.clone(), end }));
            }
            end = shorter(inner, &end);
        }
        Ok(None)
    }
}

/// Whether the depth at a parameter is certainly at least this.
///
/// # Errors
/// As [`Touching::of`].
pub fn is_as_deep(
    system: SystemOver,
    side: Option<Side>,
    parameter: &BigRational,
    depth: &BigRational,
    behind: bool,
) -> Result<bool> {
    let system = system(&RationalFunction::ratio(parameter, &()))?;
    let Touch { ratio, top: [least, greatest], .. } = Touch::of(&system, side)?;
    let Some([lo, hi]) = ratio.value() else { return Ok(false) };
    let one = BigRational::one();
    // √R ≤ (1 − depth) √h beyond, √R ≥ (1 + depth) √h before, whatever h is.
    let limit = if behind { one - depth } else { one + depth };
    let square = &limit * &limit;
    Ok(!limit.is_negative() && if behind { hi <= square * least } else { lo >= square * greatest })
}

/// The depth beyond the touch at a parameter, about.
///
/// # Errors
/// As [`Touching::of`].
pub fn depth_at(system: SystemOver, side: Option<Side>, parameter: &BigRational) -> Result<Option<f64>> {
    let Touch { ratio, top: [least, greatest], .. } =
        Touch::of(&system(&RationalFunction::ratio(parameter, &()))?, side)?;
    let Some([lo, hi]) = ratio.value() else { return Ok(None) };
    // ν = 1 − √(1 − x), where x may be small.
    let x = BigRational::one() - (lo + hi) / (least + greatest);
    Ok(x.to_f64().filter(|x| *x < 1.0).map(|x| x / (1.0 + (1.0 - x).sqrt())))
}

/// The fraction of the least denominator from lo to hi.
pub(super) fn simplest(lo: &BigRational, hi: &BigRational) -> BigRational {
    if hi.is_negative() {
        return -simplest(&-hi, &-lo);
    }
    if !lo.is_positive() {
        return BigRational::zero();
    }
    let whole = lo.floor();
    match lo.ceil() {
        above if above <= *hi => above,
        _ => &whole + simplest(&(hi - &whole).recip(), &(lo - &whole).recip()).recip(),
    }
}

/// A number about halfway.
pub(super) fn shorter(one: &BigRational, other: &BigRational) -> BigRational {
    (one + other) / BigRational::from_integer(2.into())
}

/// The farthest p from a start that is inside, by steps that double, then by halving; inside itself.
pub(super) fn farthest(
    inside: &dyn Fn(&BigRational) -> Result<bool>,
    start: &BigRational,
    step: &BigRational,
) -> Result<BigRational> {
    let two = BigRational::from_integer(2.into());
    let (mut good, mut step) = (start.clone(), step.clone());
    let mut bad = None;
    for _ in 0..STEPS {
        let next = &good + &step;
        if !inside(&next)? {
            bad = Some(next);
            break;
        }
        good = next;
        step *= &two;
    }
    match bad {
        Some(bad) => edge(inside, &good, &bad),
        None => Ok(good),
    }
}

/// About the last p that is inside on the way from one that is to one that is not; inside itself.
pub(super) fn edge(
    inside: &dyn Fn(&BigRational) -> Result<bool>,
    good: &BigRational,
    bad: &BigRational,
) -> Result<BigRational> {
    let (mut good, mut bad) = (good.clone(), bad.clone());
    for _ in 0..STEPS {
        let middle = shorter(&good, &bad);
        if inside(&middle)? { good = middle } else { bad = middle }
    }
    Ok(good)
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;

    use super::{TouchSide, simplest};
    use crate::{
        chaos::RationalFunction,
        motion::{Harmonic, Side, System, Wall},
        number::{Ball, Elementary, Precision, Real, parse_rational},
    };

    /// 2q″ + 6q′ + 800q = 2/5 cos wt below 1/1000, w as it is or 2π times a number of hertz.
    fn driven(frequency: &RationalFunction, turn: &RationalFunction) -> System<RationalFunction> {
        let number = |p: i64, q: i64| RationalFunction::ratio(&BigRational::new(p.into(), q.into()), &());
        let w = frequency.clone() * turn;
        let square = w.clone() * &w;
        let wall = Wall { offset: number(1, 1000), harmonics: Vec::new(), restitution: number(4, 5) };
        let drive = Harmonic { k: 1, cos: number(1, 5) / &square, sin: number(0, 1) };
        System {
            rate: None,
            damping: number(3, 1) / &w,
            stiffness: number(400, 1) / &square,
            cubic: number(0, 1),
            force: number(0, 1),
            forcing: vec![drive],
            smooth: None,
            lower: None,
            upper: Some(wall),
        }
    }

    #[test]
    fn a_frequency_has_its_range_in_hertz_too() {
        let at = |text: &str| parse_rational(text).unwrap();
        let (lo, hi) = Ball::pi(&Precision::new(256)).exact_bounds().unwrap();
        let turn = RationalFunction::between([&(&lo * at("2")), &(&hi * at("2"))]);
        for (behind, depth) in [(false, "1/10"), (true, "1/10")] {
            let range = |turn: &RationalFunction, start: &str| {
                let system = |frequency: &RationalFunction| Ok(driven(frequency, turn));
                let unit = at(start) * at("1e-6");
                let touch = TouchSide::of(&system, None::<Side>, [&at(start), &unit], behind).unwrap();
                touch.unwrap().range(&system, &at(depth)).unwrap().unwrap()
            };
            let own = range(&RationalFunction::integer(1, &()), "24.2144771");
            let hertz = range(&turn, "3.85385373");
            // The digits of π that are known are more than those of an edge.
            let same = |hertz: &BigRational, own: &BigRational| {
                let apart = hertz * &lo * at("2") / own - at("1");
                assert!(apart < at("1e-17") && apart > at("-1e-17"), "{hertz} {own}");
            };
            same(&hertz.touch[0], &own.touch[0]);
            same(&hertz.touch[1], &own.touch[1]);
            same(&hertz.end, &own.end);
            assert!(hertz.touch[0] < hertz.touch[1]);
        }
    }

    #[test]
    fn the_simplest_fraction_is_the_first_by_denominator() {
        let at = |text: &str| parse_rational(text).unwrap();
        for (lo, hi) in [
            ("1/3", "2/5"),
            ("0.3141", "0.3142"),
            ("-7/5", "-4/3"),
            ("-1", "1/7"),
            ("22/7", "22/7"),
            ("2.5", "9"),
        ] {
            let (lo, hi) = (at(lo), at(hi));
            let least = (1..).find_map(|q: i64| {
                let q = num_rational::BigRational::from_integer(q.into());
                let p = (&lo * &q).ceil();
                (&p / &q <= hi).then(|| p / q)
            });
            let found = simplest(&lo, &hi);
            assert!(lo <= found && found <= hi);
            assert_eq!(found.denom(), least.unwrap().denom(), "{lo} {hi}");
        }
    }
}
