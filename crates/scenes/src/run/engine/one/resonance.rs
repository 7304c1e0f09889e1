//! One impact in n periods at a resonance of a linear oscillator, nθ = mπ, where Theorem 1 is silent: what is
//! born there is known (`Birth_statement`, `Exact_statement` of `proofs/coq/StatementResonance.v`).

use std::f64::consts::PI;

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{analysed, grazing::OscillatorGrazing, ranges::functions};
use crate::{
    error::Result,
    one::orbit::{Family as _, Itinerary, find},
    run::Analysed,
    search::chaos::RationalFunction,
};

/// What is born.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum ResonantBirth {
    /// Nothing, on either side.
    Nothing,
    /// One orbit beyond the touch, asymptotically stable; both its multipliers are this.
    Orbit {
        /// −τq, q = (−1)^m e^{−πcn}.
        multiplier: f64,
        /// −(1 − q)/(1 + τq): the speed of its impact over the stop's.
        speed: f64,
    },
}

impl OscillatorGrazing<'_> {
    /// What is born of one impact in n periods if nθ = mπ exactly, for numbers c, k and τ that are rational
    /// in the time in which the period is 2π and do not change with the parameter, where the motion without
    /// impacts touches one stop once a period.
    ///
    /// # Errors
    /// Those of the scene.
    pub(super) fn resonance(&self, n: u64) -> Result<Option<ResonantBirth>> {
        let (event, unit) = (&self.event, self.unit()?);
        let is_free = event.itinerary.strikes().len() == 1 && event.itinerary.periods() == 1;
        let touches_once = event.second.is_none() && event.admissible && event.map.acceleration > 0.0;
        if !(is_free && touches_once && self.half.is_none()) {
            return Ok(None);
        }
        let near =
            |way: f64| BigRational::from_float(event.parameter + way * 1e-6 * unit / event.map.e.abs());
        // Over one value of the parameter alone nothing changes with it.
        let (Some(from), Some(to)) = (near(-1.0), near(1.0)) else { return Ok(None) };
        let Some(over) = (from < to).then(|| RationalFunction::range(&from, Some(&to))) else {
            return Ok(None);
        };
        // Of coefficients that are no rational functions nothing is known.
        let Ok(system) = functions(self, &over) else { return Ok(None) };
        let Some(wall) = system.wall(event.side()) else { return Ok(None) };
        let number = |x: &RationalFunction| x.value().and_then(|[lo, hi]| (lo == hi).then_some(lo));
        let numbers = [&system.damping, &system.stiffness, &wall.restitution].map(number);
        let [Some(c), Some(k), Some(tau)] = numbers else { return Ok(None) };
        let is_linear = number(&system.cubic).is_some_and(|x| x.is_zero()) && system.smooth.is_none();
        if !is_linear || c.is_negative() || tau.is_negative() || tau > BigRational::one() {
            return Ok(None);
        }
        let Some(m) = half_turns(&c, &k, n) else { return Ok(None) };
        let is_odd = m % 2 == 1;
        let regular = !c.is_zero() || is_odd && !tau.is_one();
        if !regular || n > 1 && m % (2 * n) != 1 {
            return Ok(Some(ResonantBirth::Nothing));
        }
        let loses = BigRational::one() - &tau;
        let [c, tau, loses] = [c, tau, loses].map(|x| x.to_f64().unwrap_or(f64::NAN));
        // |q| and 1 − |q|, each with its digits, however much or little is damped.
        let fades = -PI * c * n as f64;
        let (kept, lost) = (fades.exp(), -fades.exp_m1());
        let (multiplier, speed) = match is_odd {
            true => (tau * kept, (1.0 + kept) / (loses + tau * lost)),
            false => (0.0 - tau * kept, lost / (1.0 + tau * kept)),
        };
        Ok(Some(ResonantBirth::Orbit { multiplier, speed }))
    }

    /// The orbit of one impact in n periods at a parameter and a distance d beyond the touch; the inner error
    /// is why none was found. It is looked for where the stop rises through the motion without impacts,
    /// √(2d/a_G) before its top.
    ///
    /// # Errors
    /// Those of the scene.
    pub(super) fn resonant_orbit(
        &self,
        (n, speed): (u32, f64),
        parameter: f64,
        distance: f64,
    ) -> Result<Result<Analysed>> {
        let rise = self.event.map.acceleration;
        let early = (2.0 * distance / rise).sqrt();
        let itinerary = Itinerary::at(self.event.side(), &[n])?;
        let start = vec![self.event.phase() - early, speed * rise * early];
        Ok(find(&self.family.at(parameter)?, &itinerary, start).map(|orbit| analysed(&orbit, self.job, None)))
    }
}

/// m, if n √(k − c²/4) 2π = mπ for a whole m ≥ 1.
fn half_turns(c: &BigRational, k: &BigRational, n: u64) -> Option<u64> {
    let whole = |x: i64| BigRational::from_integer(x.into());
    let square = (k * whole(4) - c * c) * BigRational::from_integer(n.into()).pow(2);
    let m = (square.is_integer() && square.is_positive()).then(|| square.numer().sqrt())?;
    (&m * &m == *square.numer()).then(|| m.to_u64()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_turns_are_exact() {
        let at = |c: [i64; 2], k: [i64; 2], n| {
            let ratio = |[a, b]: [i64; 2]| BigRational::new(a.into(), b.into());
            half_turns(&ratio(c), &ratio(k), n)
        };
        // The paper's section 4.1: w = 4.8, d = 0.6, θ = π/3.
        let all: Vec<_> = (1..=7).map(|n| at([1, 4], [25, 576], n)).collect();
        assert_eq!(all, [None, None, Some(1), None, None, Some(2), None]);
        assert_eq!(at([0, 1], [1, 1], 1), Some(2));
        assert_eq!(at([2, 1], [1, 1], 1), None);
        assert_eq!(at([3, 1], [1, 1], 1), None);
        assert_eq!(at([1, 4], [25_000_001, 576_000_000], 3), None);
    }
}
