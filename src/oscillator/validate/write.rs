//! A proved orbit as a certificate.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{ProvedOrbit, Stability, krawczyk};
use crate::{
    certificate::{
        self,
        orbit::{Certificate, Claim, Decimal, Fraction, Harmonic, Impact, Side, System, Wall},
    },
    error::{Error, Result},
    oscillator,
};

/// The most digits of a number in a certificate.
const DIGITS: usize = 34;

/// The text of a certificate of kind `orbit`. The checker's intervals differ from the proof's: where it does not
/// accept the box, smaller ones are tried, so that what is returned has passed the check.
///
/// # Errors
/// An input error: a coefficient of more than 34 digits, or no box that the checker accepts.
pub fn certificate(system: &oscillator::System<BigRational>, orbit: &ProvedOrbit) -> Result<String> {
    let m = orbit.impacts.len();
    let impacts = orbit.impacts.iter().enumerate().map(|(i, impact)| {
        Ok(Impact {
            side: side(impact.side),
            periods: impact.periods.into(),
            phase: decimal(&orbit.centre[i])?,
            velocity: decimal(&orbit.centre[m + i])?,
        })
    });
    let all = |numbers: &[BigRational]| numbers.iter().map(decimal).collect::<Result<Vec<_>>>();
    let mut certificate = Certificate {
        system: exact(system)?,
        claim: match orbit.stability {
            Some(Stability::Stable) => Claim::Stable,
            Some(Stability::Unstable) => Claim::Unstable,
            None => Claim::Open,
        },
        impacts: impacts.collect::<Result<_>>()?,
        radius: decimal(&orbit.radius)?,
        within: decimal(&krawczyk::near())?,
        inverse: orbit.inverse.iter().map(|row| all(row)).collect::<Result<_>>()?,
        flights: orbit.pieces.iter().map(|ends| all(ends)).collect::<Result<_>>()?,
    };
    let mut why = String::from("there is no box");
    for radius in krawczyk::radii().filter(|radius| *radius <= orbit.radius) {
        certificate.radius = decimal(&radius)?;
        let text = certificate.to_string();
        match certificate::check(&mut text.as_bytes()) {
            Ok(_) => return Ok(text),
            Err(rejection) => why = rejection.to_string(),
        }
    }
    Err(Error::input(format!("the checker does not accept this orbit: {why}")))
}

fn side(side: oscillator::Side) -> Side {
    match side {
        oscillator::Side::Lower => Side::Lower,
        oscillator::Side::Upper => Side::Upper,
    }
}

fn exact(system: &oscillator::System<BigRational>) -> Result<System> {
    let harmonics = |list: &[oscillator::Harmonic<BigRational>]| {
        let one = |h: &oscillator::Harmonic<BigRational>| {
            Ok(Harmonic { k: h.k.into(), cos: fraction(&h.cos)?, sin: fraction(&h.sin)? })
        };
        list.iter().map(one).collect::<Result<Vec<_>>>()
    };
    let wall = |wall: &oscillator::Wall<BigRational>| {
        Ok::<_, Error>(Wall {
            offset: fraction(&wall.offset)?,
            restitution: fraction(&wall.restitution)?,
            harmonics: harmonics(&wall.harmonics)?,
        })
    };
    Ok(System {
        damping: fraction(&system.damping)?,
        stiffness: fraction(&system.stiffness)?,
        force: fraction(&system.force)?,
        forcing: harmonics(&system.forcing)?,
        lower: system.lower.as_ref().map(wall).transpose()?,
        upper: system.upper.as_ref().map(wall).transpose()?,
    })
}

/// A machine integer of at most [`DIGITS`] digits.
fn integer(x: &BigInt) -> Result<i128> {
    let short = x.to_i128().filter(|_| x.magnitude().to_string().len() <= DIGITS);
    short.ok_or_else(|| {
        Error::input(format!("{x} has more than the {DIGITS} digits that a certificate holds"))
    })
}

fn fraction(x: &BigRational) -> Result<Fraction> {
    Ok(Fraction { p: integer(x.numer())?, q: integer(x.denom())? })
}

/// A number that is a decimal.
fn decimal(x: &BigRational) -> Result<Decimal> {
    let scaled =
        |places: u32| x * BigRational::from_integer(num_traits::pow(BigInt::from(10), places as usize));
    let places = (0..DIGITS as u32).find(|&places| scaled(places).is_integer());
    let places = places.ok_or_else(|| Error::input(format!("{x} is no short decimal")))?;
    Ok(Decimal { digits: integer(&scaled(places).to_integer())?, places })
}
