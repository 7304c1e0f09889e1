//! Independent normal parameters: how much of their distribution lies in a cell, at least.
//!
//! With Φ the normal distribution function, a cell's part is ∏ (Φ(zᵢ') − Φ(zᵢ)) over its edges, counted in
//! deviations from the middle, and
//!
//! ```text
//! Φ(z) − ½ = e^{−z²/2}/√(2π) · Σ_{m≥0} z^{2m+1}/(1·3·…·(2m+1)),
//! ```
//!
//! all terms with the sign of z. From a term on with z² ≤ (2m+3)/2 each is at most half the one before, so
//! that the rest is at most the last one counted. In balls; no quantile is taken from anywhere.

use std::{cell::RefCell, collections::HashMap};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{
    parameters::{Coordinates, ParameterBox, is_flat},
    partition::DEEPEST,
};
use crate::{
    error::{Error, Result},
    number::{Ball, Elementary, Precision, Real},
};

/// How many deviations the cells reach; what lies beyond counts as open.
pub const DEVIATIONS: i32 = 5;

const BITS: u32 = 96;
/// z² ≤ `TERMS` for all z up to [`DEVIATIONS`], and then some.
const TERMS: i32 = 64;

/// Two independent normal parameters, or one, the other being known.
#[derive(Debug, Clone)]
pub struct NormalParameters {
    /// The middle and the deviation of each.
    parameters: [[BigRational; 2]; 2],
    /// Φ − ½ at the edges asked, between two whole numbers of 2⁻⁶².
    known: RefCell<HashMap<(usize, BigRational), [i64; 2]>>,
}

impl ParameterBox {
    /// Reads the box as middles and deviations, half its widths, of two independent normal parameters: the
    /// distribution, and the box of [`DEVIATIONS`] of them, as far as the theory goes.
    ///
    /// # Errors
    /// An input error if the box is a point, or one whose damping and stiffness are functions.
    pub fn normal(&self) -> Result<(NormalParameters, ParameterBox)> {
        if self.is_point() {
            return Err(Error::input("a distribution needs a deviation: write X±Y"));
        }
        let q = |p: i64, d: i64| BigRational::new(p.into(), d.into());
        let middle = self.centre();
        let deviation = [0, 1].map(|i| (&self.sides[i][1] - &self.sides[i][0]) * q(1, 2));
        let far = BigRational::from_integer(DEVIATIONS.into());
        let mut bounds = [0, 1].map(|i| {
            let by = &deviation[i] * &far;
            [&middle[i] - &by, &middle[i] + &by]
        });
        let (top, bottom) = match &self.coordinates {
            Coordinates::Oscillator(_) => {
                return Err(Error::input("beyond the box it is not known what damping and stiffness are"));
            }
            Coordinates::Machine => ([Some(q(1000, 1)), Some(q(1000, 1))], [false, true]),
            Coordinates::Polar => ([Some(q(1, 1)), None], [false, false]),
            Coordinates::Plane => ([None, Some(q(1, 1))], [true, false]),
        };
        for (i, [lower, upper]) in bounds.iter_mut().enumerate() {
            // Above 0, or from 0 up; a₁ has no bounds.
            if self.coordinates != Coordinates::Plane || i == 1 {
                if bottom[i] {
                    *lower = lower.clone().max(BigRational::zero());
                } else if !lower.is_positive() {
                    *lower = &self.sides[i][0] * q(1, 64);
                }
            }
            if let Some(top) = &top[i] {
                *upper = upper.clone().min(top.clone());
            }
        }
        if self.coordinates == Coordinates::Polar {
            let half = q(1, 2);
            let upper = &mut bounds[1][1];
            if *upper >= half {
                *upper = &half - (&half - &self.sides[1][1]) * q(1, 64);
            }
        }
        let wide = ParameterBox { coordinates: self.coordinates.clone(), sides: bounds.into() };
        let [m0, m1] = middle;
        let [d0, d1] = deviation;
        Ok((NormalParameters { parameters: [[m0, d0], [m1, d1]], known: RefCell::default() }, wide))
    }
}

impl NormalParameters {
    /// The middle and the deviation of each parameter; 0 for one that is known.
    pub fn parameters(&self) -> &[[BigRational; 2]; 2] {
        &self.parameters
    }

    /// How much of the distribution lies in a cell, at least, in units of 2⁻⁶². Cost: O(1) balls for every
    /// edge that was not asked before.
    pub(super) fn part(&self, cell: &ParameterBox) -> u64 {
        let side = |axis: usize| -> u128 {
            if is_flat(&cell.sides[axis]) {
                return 1 << DEEPEST;
            }
            let [lower, upper] = cell.sides[axis].each_ref().map(|x| self.at(axis, x));
            u128::try_from(upper[0] - lower[1]).unwrap_or(0)
        };
        ((side(0) * side(1)) >> DEEPEST) as u64
    }

    fn at(&self, axis: usize, x: &BigRational) -> [i64; 2] {
        if let Some(known) = self.known.borrow().get(&(axis, x.clone())) {
            return *known;
        }
        let [middle, deviation] = &self.parameters[axis];
        let found = beyond_half(&((x - middle) / deviation));
        self.known.borrow_mut().insert((axis, x.clone()), found);
        found
    }
}

/// Φ(z) − ½ between two whole numbers of 2⁻⁶².
fn beyond_half(z: &BigRational) -> [i64; 2] {
    if z.is_negative() {
        let [lower, upper] = beyond_half(&-z);
        return [-upper, -lower];
    }
    let precision = Precision::new(BITS);
    let whole = |n: i32| Ball::integer(n, &precision);
    let ball = Ball::ratio(z, &precision);
    let square = ball.clone() * &ball;
    let mut term = ball;
    let mut sum = term.clone();
    for m in 1..TERMS {
        term = term * &square / &whole(2 * m + 1);
        sum = sum + &term;
    }
    // The rest, from 0 to the last term.
    let rest = term.exact_bounds().map_or_else(BigRational::one, |(_, most)| most);
    sum = sum + &Ball::between(&BigRational::zero(), &rest, &precision);
    let half = -(square / &whole(2));
    let value = half.exp(&precision) * &sum / &(Ball::pi(&precision) * &whole(2)).sqrt();
    let unit = BigRational::from_integer(BigInt::one() << DEEPEST);
    let bounds = value.exact_bounds().map(|(lo, hi)| [(lo * &unit).floor(), (hi * &unit).ceil()]);
    let most = 1i64 << (DEEPEST - 1);
    bounds.map_or([0, most], |ends| ends.map(|end| end.to_integer().to_i64().unwrap_or(most).clamp(0, most)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against tables: Φ(1) = 0.841344746068543, Φ(1.96) = 0.975002104851780 and 1 − Φ(5) =
    /// 2.866515718791939·10⁻⁷
    /// (Abramowitz and Stegun, tables 26.1 and 26.2), each to one in its last digit.
    #[test]
    fn the_normal_distribution_is_as_in_tables() {
        for (z, digits) in
            [("1", "0.341344746068543"), ("49/25", "0.475002104851780"), ("5", "0.4999997133484281")]
        {
            let q = |text: &str| crate::number::parse_rational(text).unwrap();
            let unit = BigRational::from_integer(BigInt::one() << DEEPEST);
            let [lo, hi] = beyond_half(&q(z)).map(|end| BigRational::from_integer(end.into()) / &unit);
            let last = q("1e-15");
            assert!(lo <= q(digits) + &last && q(digits) - &last <= hi, "{z}: {lo} {hi}");
            assert!(hi - lo < q("2^-58"), "{z}");
            assert_eq!(beyond_half(&-q(z)), [0, 1].map(|i| -beyond_half(&q(z))[1 - i]));
        }
    }
}
