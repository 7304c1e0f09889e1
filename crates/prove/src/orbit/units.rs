//! The units in which an orbit is proved and listed in its certificate: powers of ten of the scene's own.
//!
//! Boxes are cubes, and the checker's numbers are multiples of 2⁻⁹⁶ below 2³⁰: neither tells a phase from a
//! speed. An oscillator is linear, so that its lengths may all be divided by one number, and its parameter
//! may be counted in another unit. Both are chosen so that the forces and the walls that are met are about 1,
//! and so that a parameter about 1 moves a coefficient by about its size. Near that the scene's own units are
//! kept.

use std::convert::Infallible;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, pow};

use super::{Bounded, ExpectedImpact, Jet, Quotient, coefficient::bounded, krawczyk::middle};
use crate::{
    certificate::{event, orbit::Decimal},
    error::Result,
    machine::Bounds,
    motion::{Harmonic, Side, System},
    number::{Ball, Precision, Real},
};

/// The scene's own unit is kept of what is between these in it.
const OWN: [f64; 2] = [0.01, 100.0];
/// The greatest power: beyond, nothing is chosen.
const GREATEST: i32 = 99;

/// Powers of ten: of the lengths, and of the parameter where there is one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Units {
    pub(super) lengths: i32,
    pub(super) parameter: i32,
}

/// The power of ten of a unit for numbers of this size.
fn unit(size: f64) -> i32 {
    let [least, greatest] = OWN;
    if !size.is_normal() || (least..greatest).contains(&size) {
        return 0;
    }
    let power = size.log10().floor() as i32;
    if power.abs() <= GREATEST { power } else { 0 }
}

/// 10^power.
fn ten(power: i32) -> BigRational {
    let size = pow(BigInt::from(10), power.unsigned_abs() as usize);
    if power < 0 { BigRational::new(1.into(), size) } else { size.into() }
}

/// Everything of a system that is a force or a length: what scales with the displacement.
fn lengths<R>(system: &mut System<R>) -> impl Iterator<Item = &mut R> {
    let System { force, forcing, lower, upper, .. } = system;
    let walls = [lower, upper].into_iter().flatten();
    let (offsets, moving): (Vec<_>, Vec<_>) =
        walls.map(|wall| (&mut wall.offset, wall.harmonics.iter_mut())).unzip();
    let harmonics = forcing.iter_mut().chain(moving.into_iter().flatten());
    let harmonics = harmonics.flat_map(|Harmonic { cos, sin, .. }| [cos, sin]);
    [force].into_iter().chain(offsets).chain(harmonics)
}

/// Leaves the walls of these sides: another may be anywhere.
fn keep<R>(system: &mut System<R>, met: impl Iterator<Item = Side>) {
    let (mut lower, mut upper) = (false, false);
    met.for_each(|side| *if side == Side::Lower { &mut lower } else { &mut upper } = true);
    system.lower.take_if(|_| !lower);
    system.upper.take_if(|_| !upper);
}

/// About the greatest magnitude.
fn greatest<'b>(all: impl Iterator<Item = &'b Ball>) -> f64 {
    let size = |x: &Ball| middle(x).and_then(|x| x.to_f64()).map_or(0.0, f64::abs);
    all.map(size).fold(0.0, f64::max)
}

impl Units {
    /// Those for a motion of a system that meets walls on these sides.
    pub(super) fn of(system: &System<Bounds>, met: impl Iterator<Item = Side>) -> Units {
        let mut system = system.clone();
        keep(&mut system, met);
        let size = |[x, _]: &mut Bounds| x.to_f64().map_or(0.0, f64::abs);
        Units { lengths: unit(lengths(&mut system).map(size).fold(0.0, f64::max)), parameter: 0 }
    }

    /// Those for motions of a family that meet walls on these sides, near a value of its parameter.
    ///
    /// # Errors
    /// Those of the family.
    pub(crate) fn along(
        family: impl Fn(&Jet) -> Result<System<Jet>>,
        met: impl Iterator<Item = Side>,
        at: &BigRational,
        precision: &Precision,
    ) -> Result<Units> {
        let mut system = family(&Jet::variable(Ball::ratio(at, precision), 0, 1, precision))?;
        keep(&mut system, met);
        let of = |jet: &Jet| (jet.value.clone(), jet.slopes.first().cloned());
        let coefficients = [&system.damping, &system.stiffness].map(of);
        let scaled: Vec<_> = lengths(&mut system).map(|x| of(x)).collect();
        let size = greatest(scaled.iter().map(|(value, _)| value));
        let slope = greatest(scaled.iter().filter_map(|(_, slope)| slope.as_ref()));
        // Forces and walls by their greatest; c and k as they are, their unit of time being the forcing's.
        let relative = if size > 0.0 { slope / size } else { 0.0 };
        let rate = greatest(coefficients.iter().filter_map(|(_, slope)| slope.as_ref())).max(relative);
        Ok(Units { lengths: unit(size), parameter: unit(rate.recip()) })
    }

    /// A system with its lengths in this unit.
    pub(super) fn scaled<R: Real>(self, mut system: System<R>, context: &R::Context) -> System<R> {
        if self.lengths != 0 {
            let factor = R::ratio(&ten(-self.lengths), context);
            lengths(&mut system).for_each(|x| *x = x.clone() * &factor);
        }
        system
    }

    /// The same of a system each coefficient of which lies between two numbers.
    pub(super) fn bounded(self, system: &System<impl Bounded>) -> System<Bounds> {
        let mut system = bounded(system);
        if self.lengths != 0 {
            let factor = ten(-self.lengths);
            lengths(&mut system).flatten().for_each(|x| *x *= &factor);
        }
        system
    }

    /// A family in these units.
    pub(super) fn family(
        self,
        family: impl Fn(&Jet) -> Result<System<Jet>>,
        precision: &Precision,
    ) -> impl Fn(&Jet) -> Result<System<Jet>> {
        move |parameter| {
            let system = match self.parameter {
                0 => family(parameter),
                power => family(&(parameter.clone() * &Jet::ratio(&ten(power), precision))),
            };
            Ok(self.scaled(system?, precision))
        }
    }

    /// The same of coefficients as functions of the parameter.
    pub(super) fn function(self, system: &System<Quotient>) -> System<Quotient> {
        let in_unit = |x: &Quotient| Ok::<_, Infallible>(x.clone().in_unit(&ten(self.parameter)));
        let Ok(system) = self.scaled(system.clone(), &()).try_map(in_unit);
        system
    }

    /// Where impacts are expected.
    pub(super) fn impacts(self, impacts: &[ExpectedImpact]) -> Vec<ExpectedImpact> {
        let one = |impact: &ExpectedImpact| ExpectedImpact {
            velocity: impact.velocity * 10f64.powi(-self.lengths),
            ..*impact
        };
        impacts.iter().map(one).collect()
    }

    /// A value of the parameter, in its unit.
    pub(crate) fn parameter(self, value: &BigRational) -> BigRational {
        value * ten(-self.parameter)
    }

    /// The same of a float.
    pub(super) fn about(self, parameter: f64) -> f64 {
        parameter * 10f64.powi(-self.parameter)
    }

    /// Lengths in this unit, in the scene's.
    pub(super) fn own(self, lengths: Vec<Ball>, precision: &Precision) -> Vec<Ball> {
        back(lengths, self.lengths, precision)
    }

    /// A parameter in its unit, in the scene's.
    pub(super) fn own_parameter(self, value: Ball, precision: &Precision) -> Ball {
        back(vec![value], self.parameter, precision).swap_remove(0)
    }

    /// A decimal value of the parameter in its unit, in the scene's, in digits.
    pub(super) fn said(self, value: Decimal) -> String {
        let places = value.places as i32 - self.parameter;
        if value.digits == 0 || places == value.places as i32 {
            return value.to_string();
        }
        let sign = if value.digits < 0 { "-" } else { "" };
        let digits = value.digits.unsigned_abs().to_string();
        if places <= 0 {
            return format!("{sign}{digits}{}", "0".repeat(places.unsigned_abs() as usize));
        }
        let digits = format!("{digits:0>width$}", width = places as usize + 1);
        let (whole, part) = digits.split_at(digits.len() - places as usize);
        match part.trim_end_matches('0') {
            "" => format!("{sign}{whole}"),
            part => format!("{sign}{whole}.{part}"),
        }
    }

    /// As the certificate lists them.
    pub(super) fn listed(self) -> event::Units {
        event::Units { lengths: self.lengths, parameter: self.parameter }
    }
}

fn back(all: Vec<Ball>, power: i32, precision: &Precision) -> Vec<Ball> {
    if power == 0 {
        return all;
    }
    let unit = Ball::ratio(&ten(power), precision);
    all.into_iter().map(|x| x * &unit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_decades_and_the_scenes_own_near_one() {
        let units = [1.0, 0.7, 99.0, 0.0, 100.0, 1234.0, 0.0099, 3e-9, 1e9].map(unit);
        assert_eq!(units, [0, 0, 0, 0, 2, 3, -3, -9, 9]);
        assert_eq!([f64::INFINITY, f64::NAN, 1e-120].map(unit), [0; 3]);
    }

    #[test]
    fn values_are_said_in_the_scenes_unit() {
        let said =
            |digits, places, parameter| Units { lengths: 0, parameter }.said(Decimal { digits, places });
        assert_eq!(said(-1234, 2, 0), "-12.34");
        assert_eq!(said(-1234, 2, 1), "-123.4");
        assert_eq!(said(1234, 2, 4), "123400");
        assert_eq!(said(1234, 2, -3), "0.01234");
        assert_eq!(said(-1200, 0, -1), "-120");
        assert_eq!(said(0, 0, 5), "0");
    }
}
