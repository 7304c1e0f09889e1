//! The normal form q″ = −c q′ − k q + f above the wall σν − 1 + g(t) of an oscillator with a rigid wall: the
//! steps at the head of docs/chaos.md.

use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{
    fail,
    profile::Term,
    rational::RationalFunction,
    top::{Top, Wave, top},
    write::short,
};
use crate::{
    error::{Error, Result},
    motion::{Harmonic, Side, System, Wall},
    number::{Real, Sign},
};

/// The ranges of c, k, f, τ and ν, with σ and the wall's motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Normal {
    /// Whether both of two walls are met, the upper one being the mirror image −w(t − π) of the lower one.
    pub mirrored: bool,
    /// Of c, k, f, τ, ν, each from the least to the greatest.
    pub ranges: [[BigRational; 2]; 5],
    /// Whether σ = 1.
    pub behind: bool,
    /// The harmonics of g, their orders increasing.
    pub harmonics: Vec<Term>,
    /// Which wall: an upper one is turned below by q → −q.
    pub side: Side,
    /// Whether the motion without the wall grazes it at the end of the parameter's range, so that this end
    /// does not belong to what is proved.
    pub open: bool,
    /// A number that q/ν does not exceed where the other wall is never met; none if there is no other.
    pub ceiling: Option<BigRational>,
}

type Function = RationalFunction;

/// The ends of a range.
type Ends = [BigRational; 2];

impl Normal {
    /// Of a system whose coefficients are functions of a parameter; `measured` has ranges of c, k and τ where
    /// these are known by ranges only. With two walls, `side` says which one is met; without it both are.
    ///
    /// # Errors
    /// An input error that says what the normal form does not cover: no wall, two that are not each other's
    /// mirror images without `side`, a cubic spring, a motion without the wall that is not unique, a wall
    /// that does not move, a grazing within the range, a dependence too intricate to bound.
    pub fn of(
        system: &System<Function>,
        measured: Option<[[BigRational; 2]; 3]>,
        side: Option<Side>,
    ) -> Result<Normal> {
        let (side, wall, mirror) = met(system, side)?;
        check_linear(system)?;
        let (damping, stiffness) = (&system.damping, &system.stiffness);
        let forcing = waves(&system.forcing);
        let free = measured.is_none() && stiffness.is_zero();
        let falls = mirror.is_none() && free && damping.is_zero();
        if measured.is_some() && (!forcing.is_empty() || !system.force.is_zero()) {
            return fail("with ranges of damping or stiffness there may be no forcing and no constant force");
        }
        let middle = mirror.filter(|_| free);
        let rests = measured.is_none() && !falls;
        check_rest(system, middle.is_some(), rests)?;
        let response = response(damping, stiffness, &forcing)?;
        let rest = match middle {
            // Every place between the walls is one of rest.
            Some(upper) => (wall.offset.clone() + &upper.offset) / &Function::integer(2, &()),
            None if rests => system.force.clone() / stiffness,
            None => Function::integer(0, &()),
        };
        let seen = |wall: &Wall<Function>| {
            let offset = wall.offset.clone() - &rest;
            let all = minus(&waves(&wall.harmonics), &response);
            if side == Side::Lower { (offset, all) } else { (-offset, minus(&[], &all)) }
        };
        let (mean, mut motion) = seen(wall);
        // With a period of 2π/j the time is multiplied by j.
        let faster = motion.iter().fold(0, |gcd: u32, wave| gcd.gcd(&wave.0));
        if faster == 0 {
            return fail("the wall must move, seen from the motion without it");
        }
        motion.iter_mut().for_each(|wave| wave.0 /= faster);
        if let Some(upper) = mirror {
            check_mirror([wall, upper], &rest, &response, faster)?;
        }
        let top = top(&motion)?;
        let mut force = [BigRational::zero(), BigRational::zero()];
        let (behind, open, depth) = if falls {
            force = pull(&top, &system.force, side)?;
            (true, false, [BigRational::one(), BigRational::one()])
        } else {
            top.depth(&mean)?
        };
        let [damping, stiffness, restitution] = match measured {
            Some(ranges) => ranges,
            None => [
                damping.bounded("the damping")?,
                stiffness.bounded("the stiffness")?,
                wall.restitution.bounded("the restitution")?,
            ],
        };
        if !restitution[0].is_positive() {
            return fail("the restitution must be positive");
        }
        let other = if side == Side::Lower { &system.upper } else { &system.lower };
        let ceiling = other.as_ref().filter(|_| mirror.is_none()).map(|other| {
            let (height, motion) = seen(other);
            // The origin is the place of rest, but where there is none, the mean of the wall that is met.
            let height = if falls { height - &mean } else { height };
            Ok::<_, Error>(top.least(&height, &motion)? / &depth[1])
        });
        let ranges = in_own_time([damping, stiffness, force, restitution, depth], faster);
        let harmonics = top.harmonics;
        let (mirrored, ceiling) = (mirror.is_some(), ceiling.transpose()?);
        Ok(Normal { mirrored, ranges, behind, harmonics, side, open, ceiling })
    }
}

/// Ranges of c, k, the force, τ and the depth where the time is multiplied by j, widened to short decimals.
fn in_own_time([damping, stiffness, force, restitution, depth]: [Ends; 5], j: u32) -> [Ends; 5] {
    let once = BigRational::from_integer(j.into());
    let twice = &once * &once;
    let scaled = |range: Ends, by: &BigRational| range.map(|x| x / by);
    let all = [scaled(damping, &once), scaled(stiffness, &twice), scaled(force, &twice), restitution, depth];
    all.map(|[lo, hi]| [short(&lo, false), short(&hi, true)])
}

/// Refuses a system without one motion that no wall disturbs; `middle` if every place between its walls is
/// one of rest, `rests` if the spring is to say where it rests.
fn check_rest(system: &System<Function>, middle: bool, rests: bool) -> Result<()> {
    if middle && !system.force.is_zero() {
        return asymmetric("a constant force that no spring balances presses towards one of them");
    }
    if rests && !middle && !matches!(system.stiffness.sign(), Some(Sign::Positive | Sign::Negative)) {
        return fail("without a spring there may be no damping: the motion without the wall is not unique");
    }
    Ok(())
}

/// The wall that is met, its side, and the wall above it where both are met.
#[expect(clippy::type_complexity, reason = "each is named by its one caller")]
pub(super) fn met(
    system: &System<Function>,
    side: Option<Side>,
) -> Result<(Side, &Wall<Function>, Option<&Wall<Function>>)> {
    match (&system.lower, &system.upper, side) {
        (Some(wall), None, None) | (Some(wall), _, Some(Side::Lower)) => Ok((Side::Lower, wall, None)),
        (None, Some(wall), None) | (_, Some(wall), Some(Side::Upper)) => Ok((Side::Upper, wall, None)),
        (Some(wall), Some(upper), None) => Ok((Side::Lower, wall, Some(upper))),
        (None, None, None) => fail("the oscillator has no wall"),
        _ => fail("there is no wall on the side that is given"),
    }
}

pub(super) fn check_linear(system: &System<Function>) -> Result<()> {
    if !system.cubic.is_zero() {
        return fail("only linear oscillators are covered: cubic must be 0");
    }
    if system.smooth.is_some() {
        return fail("only linear oscillators are covered: force must not depend on q, u or t");
    }
    Ok(())
}

/// The range of a constant force that presses towards the wall, over what makes the wall's top 1.
fn pull(top: &Top, force: &Function, side: Side) -> Result<[BigRational; 2]> {
    // q → −q turns an upper wall down, and gravity with it.
    let pull = if side == Side::Lower { force.clone() } else { -force.clone() };
    if !(-pull.clone()).is_positive() {
        return fail("without a spring a constant force must press towards the wall");
    }
    top.ratio(&pull, "the force")
}

/// Refuses a lower and an upper wall that are not each other's mirror images, as seen from the motion without
/// walls: its place of rest and its waves. Seen from there they have a period of 2π/`faster`.
pub(super) fn check_mirror(
    [wall, upper]: [&Wall<Function>; 2],
    rest: &Function,
    response: &[Wave],
    faster: u32,
) -> Result<()> {
    let middle = wall.offset.clone() + &upper.offset;
    if !(middle - &(rest.clone() * &Function::integer(2, &()))).is_zero() {
        return asymmetric("their means are not at the same distance from the motion without walls");
    }
    // In that period's time −w(t − π) has −(−1)ʲ times the coefficients of w. So where j is odd the motion
    // without walls is its own image, and is not asked for: it may be known between two numbers only.
    let is_even = |j: u32| j.is_multiple_of(2 * faster);
    let image = |(j, [a, b]): &Wave| match is_even(*j) {
        true => (*j, [-a.clone(), -b.clone()]),
        false => (*j, [a.clone(), b.clone()]),
    };
    let images: Vec<Wave> = waves(&wall.harmonics).iter().map(image).collect();
    let even = response.iter().filter(|wave| is_even(wave.0));
    let twice = |x: &Function| x.clone() + x;
    let even: Vec<Wave> = even.map(|(j, [a, b])| (*j, [twice(a), twice(b)])).collect();
    if let Some((j, _)) = minus(&images, &minus(&waves(&upper.harmonics), &even)).first() {
        return asymmetric(&format!(
            "seen from the motion without walls, harmonic {j} of the upper one is not that of the lower one's image"
        ));
    }
    // Two of which the same is known are one: who makes the system compares what is not rational.
    if wall.restitution != upper.restitution && !(wall.restitution.clone() - &upper.restitution).is_zero() {
        return asymmetric("their restitutions differ");
    }
    Ok(())
}

/// Why two walls are not each other's mirror images.
fn asymmetric<T>(what: &str) -> Result<T> {
    fail(&format!(
        "both walls are met, since there is no key side, and then they must be each other's images under q(t) -> -q(t - half a period): {what}. Or side must say which wall is met, the other being out of reach"
    ))
}

/// The coefficients of cos jt and sin jt for each order j, increasing; none that are zero.
pub(super) fn waves(list: &[Harmonic<Function>]) -> Vec<Wave> {
    let terms = list.iter().map(|harmonic| (harmonic.k, [harmonic.cos.clone(), harmonic.sin.clone()]));
    gathered(terms.collect())
}

/// The difference of two motions.
pub(super) fn minus(one: &[Wave], other: &[Wave]) -> Vec<Wave> {
    let negative = other.iter().map(|(j, [a, b])| (*j, [-a.clone(), -b.clone()]));
    gathered(one.iter().cloned().chain(negative).collect())
}

fn gathered(mut terms: Vec<Wave>) -> Vec<Wave> {
    terms.sort_by_key(|term| term.0);
    let mut all: Vec<Wave> = Vec::new();
    for (j, [a, b]) in terms {
        match all.last_mut() {
            Some((order, sum)) if *order == j => *sum = [sum[0].clone() + &a, sum[1].clone() + &b],
            _ => all.push((j, [a, b])),
        }
    }
    all.retain(|(_, [a, b])| !(a.is_zero() && b.is_zero()));
    all
}

/// The forced motion without the wall.
pub(super) fn response(damping: &Function, stiffness: &Function, forcing: &[Wave]) -> Result<Vec<Wave>> {
    let one = |(j, [f, g]): &Wave| {
        let order = Function::ratio(&BigRational::from_integer((*j).into()), &());
        let detuning = stiffness.clone() - &(order.clone() * &order);
        let drag = order * damping;
        let determinant = detuning.clone() * &detuning + &(drag.clone() * &drag);
        if !determinant.is_positive() {
            return fail("the motion without the wall is not unique: undamped resonance");
        }
        let a = (detuning.clone() * f - &(drag.clone() * g)) / &determinant;
        let b = (detuning * g + &(drag * f)) / &determinant;
        Ok((*j, [a, b]))
    };
    forcing.iter().map(one).collect()
}
