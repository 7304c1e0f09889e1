//! An oscillator with a rigid wall about the touch of the motion without it, as a function of a parameter:
//! what [`Normal`](super::Normal) has over a range on one side of it, without the depth.

use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Zero;

use super::{
    fail,
    normal::{check_linear, check_mirror, met, minus, response, waves},
    profile::Term,
    rational::RationalFunction as Function,
    top::{Wave, top},
};
use crate::{
    error::Result,
    motion::{Side, System},
    number::{Real, Sign},
};

/// An oscillator about a touch of its wall, of mean C < 0 and top H as seen from the motion without it, in a
/// time in which the wall's period is 2π: σν = 1 + C/H. C and a scale A > 0 of the wall's motion depend on a
/// parameter, H/A does not.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Touch {
    /// Whether both of two walls are met, each the other's mirror image.
    pub mirrored: bool,
    /// c, k and τ.
    pub parameters: [Function; 3],
    /// C²/A².
    pub ratio: Function,
    /// H²/A² is at least the first and at most the second: both are 1 for one harmonic.
    pub top: [BigRational; 2],
    /// The harmonics of g, their orders increasing.
    pub harmonics: Vec<Term>,
}

/// The same before its top is known.
struct Moved {
    mirrored: bool,
    parameters: [Function; 3],
    ratio: Function,
    /// The wall's motion, A being 1.
    form: Vec<Wave>,
}

impl Touch {
    /// Of a system whose coefficients are functions of a parameter.
    ///
    /// # Errors
    /// An input error that says what is not covered: what [`Normal::of`](super::Normal::of) does not cover,
    /// no spring, a wall whose form changes with the parameter, one that the
    /// motion without it crosses with its mean.
    pub(crate) fn of(system: &System<Function>, side: Option<Side>) -> Result<Touch> {
        let Moved { mirrored, parameters, ratio, form } = Moved::of(system, side)?;
        let top = top(&form)?;
        Ok(Touch { mirrored, parameters, ratio, top: top.square()?, harmonics: top.harmonics })
    }

    /// C²/A² alone.
    ///
    /// # Errors
    /// As [`Touch::of`].
    pub(crate) fn ratio(system: &System<Function>, side: Option<Side>) -> Result<Function> {
        Moved::of(system, side).map(|moved| moved.ratio)
    }
}

impl Moved {
    fn of(system: &System<Function>, side: Option<Side>) -> Result<Moved> {
        let (side, wall, mirror) = met(system, side)?;
        check_linear(system)?;
        let (damping, stiffness) = (&system.damping, &system.stiffness);
        if !matches!(stiffness.sign(), Some(Sign::Positive | Sign::Negative)) {
            return fail("without a spring there is no one motion without the wall");
        }
        let response = response(damping, stiffness, &waves(&system.forcing))?;
        let rest = system.force.clone() / stiffness;
        let offset = wall.offset.clone() - &rest;
        let motion = minus(&waves(&wall.harmonics), &response);
        let (mean, mut motion) =
            if side == Side::Lower { (offset, motion) } else { (-offset, minus(&[], &motion)) };
        let faster = motion.iter().fold(0, |gcd: u32, wave| gcd.gcd(&wave.0));
        motion.iter_mut().for_each(|wave| wave.0 /= faster);
        if let Some(upper) = mirror {
            check_mirror([wall, upper], &rest, &response, faster)?;
        }
        let (scale, form) = scaled(&motion)?;
        if !scale.is_positive() || !(-mean.clone()).is_positive() {
            return fail(
                "seen from the motion without it, the wall must move, with its mean behind the motion's",
            );
        }
        let once = Function::ratio(&BigRational::from_integer(faster.into()), &());
        let parameters =
            [damping.clone() / &once, stiffness.clone() / &(once.clone() * &once), wall.restitution.clone()];
        let ratio = mean.clone() * &mean / &scale;
        Ok(Moved { mirrored: mirror.is_some(), parameters, ratio, form })
    }
}

/// A² and a motion that does not change with the parameter, of which this one is A times; of one harmonic A
/// is its amplitude, whatever its phase.
fn scaled(motion: &[Wave]) -> Result<(Function, Vec<Wave>)> {
    let [one, zero] = [1, 0].map(|n| Function::integer(n, &()));
    if let [(order, [a, b])] = motion {
        return Ok((a.clone() * a + &(b.clone() * b), vec![(*order, [one, zero])]));
    }
    // By its first coefficient that is not 0, with its sign.
    let all = motion.iter().flat_map(|(_, both)| both);
    let Some(first) = all.into_iter().find(|part| !part.is_zero()) else { return Ok((zero, Vec::new())) };
    // Its sign must be known: A > 0, and with the other sign the form would be upside down.
    let scale = [first.clone(), -first.clone()].into_iter().find(Function::is_positive);
    let Some(scale) = scale else {
        return fail("seen from the motion without it, the sign of the wall's motion is not certain");
    };
    let fixed = |part: &Function| {
        if part.value().is_some() && scale.value().is_some() {
            return Ok(part.clone() / &scale);
        }
        // Not constant as it stands, a quotient may be so when common factors are gone.
        let shares = part.ends().zip(scale.ends());
        let share =
            shares.and_then(|([[part, _], _], [[scale, _], _])| (!scale.is_zero()).then(|| part / scale));
        let share = Function::ratio(&share.unwrap_or_else(BigRational::zero), &());
        if !(part.clone() - &(share.clone() * &scale)).is_zero() {
            return fail(
                "seen from the motion without it, the form of the wall's motion changes with the parameter",
            );
        }
        Ok(share)
    };
    let form = motion.iter().map(|(order, [a, b])| Ok((*order, [fixed(a)?, fixed(b)?])));
    Ok((scale.clone() * &scale, form.collect::<Result<_>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 + 2x − x²/10 + 3x³ + 5x⁴ is positive for x > 0, as its square's coefficients all are; its own are
    /// not all. Which way up the wall moves is not to be guessed.
    #[test]
    fn a_scale_whose_sign_is_not_certain_is_refused() {
        let x = Function::range(&BigRational::zero(), None);
        let ratio = |p: i64, q: i64| Function::ratio(&BigRational::new(p.into(), q.into()), &());
        let terms = [(1, 1), (2, 1), (-1, 10), (3, 1), (5, 1)];
        let sum = terms.iter().rev().fold(ratio(0, 1), |sum, &(p, q)| sum * &x + &ratio(p, q));
        assert!((sum.clone() * &sum).is_positive() && !sum.is_positive());
        let both = |sum: &Function| vec![(1, [sum.clone(), ratio(0, 1)]), (2, [sum.clone(), ratio(0, 1)])];
        for sum in [sum.clone(), -sum] {
            let error = scaled(&both(&sum)).unwrap_err().to_string();
            assert!(error.contains("the sign of the wall's motion is not certain"), "{error}");
        }
        let x = Function::range(
            &BigRational::new(1.into(), 2.into()),
            Some(&BigRational::from_integer(2.into())),
        );
        for sign in [1, -1] {
            let (scale, form) = scaled(&both(&(ratio(3 * sign, 1) * &x))).unwrap();
            assert!((scale - &(ratio(9, 1) * &x * &x)).is_zero());
            assert_eq!(form, both(&ratio(sign, 1)));
        }
    }
}
