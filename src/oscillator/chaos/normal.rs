//! The normal form q″ = −c q′ − k q + f above the wall σν − 1 + cos t of an oscillator with one wall and one
//! harmonic: the three steps at the head of docs/chaos.md.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};

use super::{rational::RationalFunction, write::short};
use crate::{
    error::{Error, Result},
    number::{Real, Sign},
    oscillator::{Harmonic, Side, System},
};

/// The ranges of c, k, f, τ and ν, with σ.
#[derive(Debug, Clone, PartialEq)]
pub struct Normal {
    /// Of c, k, f, τ, ν, each from the least to the greatest.
    pub ranges: [[BigRational; 2]; 5],
    /// Whether σ = 1.
    pub behind: bool,
    /// Which wall: an upper one is turned below by q → −q.
    pub side: Side,
    /// Whether the motion without the wall grazes it at the end of the parameter's range, so that this end
    /// does not belong to what is proved.
    pub open: bool,
}

type Function = RationalFunction;

impl Normal {
    /// Of a system whose coefficients are functions of a parameter; `measured` has ranges of c, k and τ where
    /// these are known by ranges only.
    ///
    /// # Errors
    /// An input error that says what the normal form does not cover: two walls, none, a cubic spring, other
    /// harmonics than the first, a motion without the wall that is not unique, a wall that does not move, a
    /// grazing within the range, a dependence too intricate to bound.
    pub fn of(system: &System<Function>, measured: Option<[[BigRational; 2]; 3]>) -> Result<Normal> {
        let (side, wall) = match (&system.lower, &system.upper) {
            (Some(wall), None) => (Side::Lower, wall),
            (None, Some(wall)) => (Side::Upper, wall),
            (Some(_), Some(_)) => return fail("two walls are not covered; leave out one that is never met"),
            (None, None) => return fail("the oscillator has no wall"),
        };
        if !is_zero(&system.cubic) {
            return fail("only linear oscillators are covered: cubic must be 0");
        }
        let (damping, stiffness) = (&system.damping, &system.stiffness);
        let ([a, b], [f, g]) = (wave(&wall.harmonics)?, wave(&system.forcing)?);
        let forced = !(is_zero(&f) && is_zero(&g));
        let falls = measured.is_none() && is_zero(damping) && is_zero(stiffness);
        if measured.is_some() && (forced || !is_zero(&system.force)) {
            return fail("with ranges of damping or stiffness there may be no forcing and no constant force");
        }
        // The motion without the wall, and the wall seen from it: C + A cos t + B sin t.
        let (mut a, mut b, mut mean) = (a, b, wall.offset.clone());
        if forced {
            let one = Function::integer(1, &());
            let detuning = stiffness.clone() - &one;
            let determinant = detuning.clone() * &detuning + &(damping.clone() * damping);
            if !determinant.is_positive() {
                return fail("the motion without the wall is not unique: undamped resonance");
            }
            a = a - &((detuning.clone() * &f - &(damping.clone() * &g)) / &determinant);
            b = b - &((detuning * &g + &(damping.clone() * &f)) / &determinant);
        }
        if measured.is_none() && !falls {
            if stiffness.sign() != Some(Sign::Positive) && stiffness.sign() != Some(Sign::Negative) {
                return fail(
                    "without a spring there may be no damping: the motion without the wall is not unique",
                );
            }
            mean = mean - &(system.force.clone() / stiffness);
        }
        let square = a.clone() * &a + &(b.clone() * &b);
        if !square.is_positive() {
            return fail("the wall must move, seen from the motion without it");
        }
        let mut force = [BigRational::zero(), BigRational::zero()];
        let (behind, open, depth) = if falls {
            // q → −q turns an upper wall down, and gravity with it.
            let pull = if side == Side::Lower { system.force.clone() } else { -system.force.clone() };
            if !(-pull.clone()).is_positive() {
                return fail("without a spring a constant force must press towards the wall");
            }
            let [lo, hi] = bounds(&(pull.clone() * &pull / &square), "the force")?;
            force = [-root(&hi, true), -root(&lo, false)];
            (true, false, [BigRational::one(), BigRational::one()])
        } else {
            let mean = if side == Side::Lower { mean } else { -mean };
            depth(&mean, &square)?
        };
        let [damping, stiffness, restitution] = match measured {
            Some(ranges) => ranges,
            None => [
                bounds(damping, "the damping")?,
                bounds(stiffness, "the stiffness")?,
                bounds(&wall.restitution, "the restitution")?,
            ],
        };
        if !restitution[0].is_positive() {
            return fail("the restitution must be positive");
        }
        let ranges = [damping, stiffness, force, restitution, depth];
        let ranges = ranges.map(|[lo, hi]| [short(&lo, false), short(&hi, true)]);
        Ok(Normal { ranges, behind, side, open })
    }
}

fn fail<T>(message: &str) -> Result<T> {
    Err(Error::input(format!("kind \"chaos\": {message}")))
}

fn is_zero(x: &Function) -> bool {
    x.sign() == Some(Sign::Zero)
}

/// The coefficients of cos t and sin t.
fn wave(list: &[Harmonic<Function>]) -> Result<[Function; 2]> {
    let mut sum = [Function::integer(0, &()), Function::integer(0, &())];
    for harmonic in list {
        if harmonic.k == 1 {
            sum = [sum[0].clone() + &harmonic.cos, sum[1].clone() + &harmonic.sin];
        } else if !(is_zero(&harmonic.cos) && is_zero(&harmonic.sin)) {
            return fail("only walls and forcing with one harmonic, k = 1, are covered");
        }
    }
    Ok(sum)
}

fn bounds(x: &Function, what: &str) -> Result<[BigRational; 2]> {
    x.bounds().map_or_else(|| fail(&format!("{what} is not bounded by its values at the range's ends")), Ok)
}

/// σ, whether ν = 0 at the range's end, and the range of ν, where σν = 1 + C/R, from C and R².
fn depth(mean: &Function, square: &Function) -> Result<(bool, bool, [BigRational; 2])> {
    let quotient = mean.clone() * mean / square;
    let [lo, hi] = bounds(&quotient, "the wall's mean over its amplitude")?;
    let one = BigRational::one();
    if mean.is_nonnegative() {
        return Ok((true, false, [&one + root(&lo, false), one + root(&hi, true)]));
    }
    if !(-mean.clone()).is_nonnegative() {
        return fail("the wall's mean position must not change its sign within the range");
    }
    let beyond = square.clone() - &(mean.clone() * mean);
    let open = beyond.constant().is_none() && beyond.ends().is_some_and(|[_, end]| end.is_zero());
    if beyond.is_positive() {
        let ends = [&one - root(&hi, true), one - root(&lo, false)];
        Ok((true, open, ends.map(|x| if x.is_negative() { BigRational::zero() } else { x })))
    } else if (-beyond).is_positive() {
        let ends = [root(&lo, false) - &one, root(&hi, true) - one];
        Ok((false, open, ends.map(|x| if x.is_negative() { BigRational::zero() } else { x })))
    } else {
        fail("the free motion grazes the wall within the range: take a range on one side of the grazing")
    }
}

/// The square root if it is rational, else one of 12 places below or above it.
fn root(x: &BigRational, up: bool) -> BigRational {
    let exact = BigRational::new(x.numer().sqrt(), x.denom().sqrt());
    if &exact * &exact == *x {
        return exact;
    }
    let scale = pow(BigInt::from(10), 12);
    let floor = (x * BigRational::from_integer(&scale * &scale)).floor().to_integer().sqrt();
    BigRational::new(if up { floor + 1 } else { floor }, scale)
}
