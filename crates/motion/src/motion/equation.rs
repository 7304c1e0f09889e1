//! The equation of motion and the walls, with coefficients of any kind: exact fractions, floats, expressions.

use std::convert::Infallible;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::Serialize;

use super::{Side, SmoothForce};

/// An oscillator q″ = −`damping` q′ − `stiffness` q − `cubic` q³ + `force` + `smooth`(t, q, q′) +
/// Σ (`cos` cos kt + `sin` sin kt), mass 1, all 2π-periodic in t, that stays between its walls Q₁(t) ≤ q ≤
/// Q₂(t) (section 3.1 of the paper). By default nothing acts and there is no wall.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct System<T> {
    /// The coefficient of the velocity.
    pub damping: T,
    /// The coefficient of the displacement.
    pub stiffness: T,
    /// The coefficient of the displacement cubed (Duffing).
    pub cubic: T,
    /// A constant acceleration: preload or gravity.
    pub force: T,
    /// The harmonics of the forcing.
    pub forcing: Vec<Harmonic<T>>,
    /// Any other smooth force; most systems have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smooth: Option<SmoothForce<T>>,
    /// The wall Q₁ below, if any.
    pub lower: Option<Wall<T>>,
    /// The wall Q₂ above, if any.
    pub upper: Option<Wall<T>>,
    /// Radians in a unit of the time in which velocities are shown; none where that is a radian. All else of
    /// the system is per radian, and no motion depends on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate: Option<T>,
}

/// One harmonic `cos` cos kt + `sin` sin kt of a 2π-periodic function.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Harmonic<T> {
    /// The multiple k ≥ 1 of the base frequency.
    pub k: u32,
    /// The coefficient of cos kt.
    pub cos: T,
    /// The coefficient of sin kt.
    pub sin: T,
}

/// A wall Q(t) = `offset` + Σ harmonics; an impact turns the velocity w relative to it into −`restitution` w
/// (67).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Wall<T> {
    /// The mean position.
    pub offset: T,
    /// The wall's motion about it.
    pub harmonics: Vec<Harmonic<T>>,
    /// τ ≥ 0: 0 sticks, 1 keeps the energy.
    pub restitution: T,
}

impl<T> System<T> {
    /// The wall on a side, if any.
    pub fn wall(&self, side: Side) -> Option<&Wall<T>> {
        match side {
            Side::Lower => self.lower.as_ref(),
            Side::Upper => self.upper.as_ref(),
        }
    }

    /// The same system with every coefficient converted.
    ///
    /// # Errors
    /// The first error of `convert`.
    pub fn try_map<U, E>(&self, mut convert: impl FnMut(&T) -> Result<U, E>) -> Result<System<U>, E> {
        Ok(System {
            damping: convert(&self.damping)?,
            stiffness: convert(&self.stiffness)?,
            cubic: convert(&self.cubic)?,
            force: convert(&self.force)?,
            forcing: convert_all(&self.forcing, &mut convert)?,
            smooth: self.smooth.as_ref().map(|force| force.try_map(&mut convert)).transpose()?,
            lower: self.lower.as_ref().map(|wall| wall.try_map(&mut convert)).transpose()?,
            upper: self.upper.as_ref().map(|wall| wall.try_map(&mut convert)).transpose()?,
            rate: self.rate.as_ref().map(&mut convert).transpose()?,
        })
    }
}

impl<T: Clone> System<T> {
    /// The same, its velocities shown per radian.
    pub fn in_radians(&self) -> System<T> {
        System { rate: None, ..self.clone() }
    }
}

impl System<f64> {
    /// Radians in a unit of the time in which velocities are shown.
    pub fn shown_rate(&self) -> f64 {
        self.rate.unwrap_or(1.0)
    }
}

impl System<BigRational> {
    /// Every coefficient rounded to the nearest float; beyond their range, to an infinity.
    pub fn rounded(&self) -> System<f64> {
        let float = |x: &BigRational| Ok::<f64, Infallible>(x.to_f64().unwrap_or(f64::NAN));
        match self.try_map(float) {
            Ok(system) => system,
            Err(never) => match never {},
        }
    }
}

impl<T> Wall<T> {
    pub(crate) fn try_map<U, E>(&self, convert: &mut impl FnMut(&T) -> Result<U, E>) -> Result<Wall<U>, E> {
        Ok(Wall {
            offset: convert(&self.offset)?,
            harmonics: convert_all(&self.harmonics, convert)?,
            restitution: convert(&self.restitution)?,
        })
    }
}

fn convert_all<T, U, E>(
    harmonics: &[Harmonic<T>],
    convert: &mut impl FnMut(&T) -> Result<U, E>,
) -> Result<Vec<Harmonic<U>>, E> {
    let one = |h: &Harmonic<T>| Ok(Harmonic { k: h.k, cos: convert(&h.cos)?, sin: convert(&h.sin)? });
    harmonics.iter().map(one).collect()
}
