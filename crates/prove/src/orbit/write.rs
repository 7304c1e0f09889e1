//! Proved orbits and events as certificates.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{
    Bounded, Condition, ProvedEvent, ProvedFreeMotion, ProvedOrbit, Quotient, Stability, Units, krawczyk,
};
use crate::{
    certificate::{
        self, event,
        orbit::{
            Certificate, Claim, Decimal, Fraction, FreeCertificate, Harmonic, Impact, Range, Side, System,
            Wall,
        },
    },
    error::{Error, Result},
    machine::Bounds,
    motion,
    number::Ball,
};

/// The most digits of a number in a certificate.
const DIGITS: usize = 34;

/// Decimals of the box within which the checker encloses a solution: as a rule, and at the most, since its
/// numbers are multiples of 2^−96.
const NEAR: u32 = 18;
const FARTHEST: u32 = 26;

/// The text of a certificate of kind `orbit`. The checker's intervals differ from the proof's: where it does
/// not accept the box, smaller ones are tried, so that what is returned has passed the check.
/// Coefficients of more than 34 digits are enclosed in intervals, version 2 of the kind.
///
/// # Errors
/// An input error: a coefficient of 2³⁰ or more, or no box that the checker accepts.
pub fn certificate(system: &motion::System<impl Bounded>, orbit: &ProvedOrbit) -> Result<String> {
    // Version 1 names coefficients exactly; where one is too long for it, or not rational, version 2 holds
    // all of them in intervals.
    let (units, system) = (orbit.units, orbit.units.bounded(system));
    match converted(units, &system, &|[lo, hi]| if lo == hi { fraction(lo) } else { Err(not_exact()) }) {
        Ok(system) => accepted(system, orbit),
        Err(_) => accepted(converted(units, &system, &between)?, orbit),
    }
}

/// The first box that the checker accepts.
///
/// The smaller box is narrower than the slowest impact by 10⁴, and its middle has six decimals more.
fn accepted<C: certificate::orbit::Version>(system: System<C>, orbit: &ProvedOrbit) -> Result<String> {
    // |V| ≥ 2^(e−1), e ≤ 0.
    let velocities = &orbit.found[orbit.impacts.len()..];
    let slowest = velocities.iter().filter_map(Ball::least_exponent).min().unwrap_or(0).min(0);
    let decimals = ((1 - slowest) as f64 * std::f64::consts::LOG10_2).ceil() as u32 + 4;
    let (centre, within) = if decimals <= NEAR {
        (orbit.centre.clone(), krawczyk::near())
    } else {
        let decimals = decimals.min(FARTHEST);
        let found = orbit.found.iter().filter_map(krawczyk::middle);
        let tenth = BigRational::new(1.into(), num_traits::pow(BigInt::from(10), decimals as usize));
        (found.map(|x| krawczyk::rounded(&x, decimals + 6)).collect(), tenth)
    };
    let mut certificate = Certificate {
        system,
        claim: claim(orbit.stability),
        impacts: impacts(&orbit.impacts, &centre)?,
        radius: decimal(&orbit.radius)?,
        within: decimal(&within)?,
        inverse: lists(&orbit.inverse)?,
        flights: lists(&orbit.pieces)?,
    };
    let mut last = "there is no box".to_string();
    for radius in krawczyk::radii().filter(|radius| *radius <= orbit.radius) {
        certificate.radius = decimal(&radius)?;
        let text = certificate.to_string();
        match refusal(&text) {
            None => return Ok(text),
            Some(why) => last = why,
        }
    }
    Err(Error::input(format!("the checker does not accept this orbit: {last}")))
}

/// The text of a certificate of kind `orbit` of a motion without impacts, version 3, which has passed the
/// check. It holds coefficients in intervals, one number each where that is a decimal of up to 34 digits.
///
/// # Errors
/// An input error: a coefficient of 2³⁰ or more, or that the checker does not accept it.
pub fn free_certificate(system: &motion::System<impl Bounded>, motion: &ProvedFreeMotion) -> Result<String> {
    let pieces = motion.pieces.iter().map(decimal).collect::<Result<_>>()?;
    let system = converted(motion.units, &motion.units.bounded(system), &between)?;
    let certificate = FreeCertificate { system, claim: claim(motion.stability), pieces };
    let text = certificate.to_string();
    let refused = |why| Err(Error::input(format!("the checker does not accept this motion: {why}")));
    refusal(&text).map_or(Ok(text), refused)
}

/// What is claimed of the multipliers.
pub(super) fn claim(stability: Option<Stability>) -> Claim {
    match stability {
        Some(Stability::Stable) => Claim::Stable,
        Some(Stability::Unstable) => Claim::Unstable,
        None => Claim::Open,
    }
}

/// The text of a certificate of kind `event`, and the ends of the parameter's interval that it proves, in
/// decimals. `system` is the family as a function of the parameter, `name` what the parameter is called. Of
/// several boxes it has the first that the checker accepts, so that what is returned has passed.
///
/// # Errors
/// An input error: a coefficient that does not fit in either version, or no box that the checker accepts.
pub fn event_certificate(
    system: &motion::System<Quotient>,
    name: &str,
    event: &ProvedEvent,
) -> Result<(String, [String; 2])> {
    let (units, system) = (event.units, event.units.function(system));
    match converted(units, &system, &quotient) {
        // Only version 2 knows orbits without impacts.
        Ok(system) if !event.impacts.is_empty() => accepted_event(system, name, event),
        Ok(_) | Err(_) => accepted_event(converted(units, &system, &range_quotient)?, name, event),
    }
}

/// The first box that the checker accepts.
fn accepted_event<C: event::Version + Clone>(
    system: System<C>,
    name: &str,
    event: &ProvedEvent,
) -> Result<(String, [String; 2])> {
    let m = event.impacts.len();
    let mut certificate = event::Certificate {
        system,
        // The checker's names are short and of ASCII letters.
        name: if name.is_ascii() && name.len() <= 32 { name.into() } else { "p".into() },
        parameter: decimal(&event.centre[2 * m])?,
        event: match event.condition {
            Condition::SaddleNode => event::Event::SaddleNode,
            Condition::Flip => event::Event::Flip,
            Condition::Grazing { after, side: touched, .. } => event::Event::Grazing(event::Contact {
                after,
                side: side(touched),
                time: decimal(&event.centre[2 * m + 1])?,
            }),
        },
        impacts: impacts(&event.impacts, &event.centre)?,
        radius: decimal(&event.radius)?,
        within: decimal(&krawczyk::near())?,
        inverse: lists(&event.inverse)?,
        flights: lists(&event.pieces)?,
    };
    let mut last = "there is no box".to_string();
    for radius in krawczyk::radii().filter(|radius| *radius <= event.radius) {
        certificate.radius = decimal(&radius)?;
        let Some(why) = refusal(&certificate.to_string()) else {
            // The box that the event lies in as small as the checker's intervals allow.
            let mut tightest = certificate.clone();
            for places in [22, 21, 20] {
                tightest.within = Decimal { digits: 1, places };
                if refusal(&tightest.to_string()).is_none() {
                    certificate = tightest;
                    break;
                }
            }
            let ends = certificate.interval().map(|ends| ends.map(|end| event.units.said(end)));
            let ends = ends.ok_or_else(|| Error::input("the parameter has too many digits"))?;
            return Ok((certificate.to_string(), ends));
        };
        last = why;
    }
    Err(Error::input(format!("the checker does not accept this event: {last}")))
}

/// Why the checker does not accept a certificate.
pub(super) fn refusal(text: &str) -> Option<String> {
    certificate::check(&mut text.as_bytes()).err().map(|rejection| rejection.to_string())
}

fn impacts(list: &[super::ExpectedImpact], centre: &[BigRational]) -> Result<Vec<Impact>> {
    let one = |(i, impact): (usize, &super::ExpectedImpact)| {
        Ok(Impact {
            side: side(impact.side),
            periods: impact.periods.into(),
            phase: decimal(&centre[i])?,
            velocity: decimal(&centre[list.len() + i])?,
        })
    };
    list.iter().enumerate().map(one).collect()
}

pub(super) fn lists(lists: &[Vec<BigRational>]) -> Result<Vec<Vec<Decimal>>> {
    lists.iter().map(|list| list.iter().map(decimal).collect()).collect()
}

pub(super) fn side(side: motion::Side) -> Side {
    match side {
        motion::Side::Lower => Side::Lower,
        motion::Side::Upper => Side::Upper,
    }
}

/// A linear system in these units with its coefficients as the checker reads them.
pub(super) fn converted<T, C>(
    units: Units,
    system: &motion::System<T>,
    convert: &dyn Fn(&T) -> Result<C>,
) -> Result<System<C>> {
    let harmonics = |list: &[motion::Harmonic<T>]| {
        let one = |h: &motion::Harmonic<T>| {
            Ok(Harmonic { k: h.k.into(), cos: convert(&h.cos)?, sin: convert(&h.sin)? })
        };
        list.iter().map(one).collect::<Result<Vec<_>>>()
    };
    let wall = |wall: &motion::Wall<T>| {
        Ok::<_, Error>(Wall {
            offset: convert(&wall.offset)?,
            restitution: convert(&wall.restitution)?,
            harmonics: harmonics(&wall.harmonics)?,
        })
    };
    Ok(System {
        units: units.listed(),
        damping: convert(&system.damping)?,
        stiffness: convert(&system.stiffness)?,
        force: convert(&system.force)?,
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

fn quotient(x: &Quotient) -> Result<event::Quotient> {
    let not_exact =
        || Error::input("a coefficient is too large an expression of the parameter, or not rational");
    let [numerator, denominator] = x.polynomials().ok_or_else(not_exact)?;
    let integers = |list: &[BigInt]| list.iter().map(integer).collect::<Result<Vec<_>>>();
    Ok(event::Quotient { numerator: integers(&numerator)?, denominator: integers(&denominator)? })
}

fn not_exact() -> Error {
    Error::input("a coefficient is not rational")
}

/// Decimals of at most [`DIGITS`] digits as near below and above two numbers as there are.
fn between([lo, hi]: &Bounds) -> Result<Range> {
    range_of(lo, hi)
}

/// The same of all numbers from `lo` to `hi`.
pub(crate) fn range_of(lo: &BigRational, hi: &BigRational) -> Result<Range> {
    let whole = [lo, hi].map(|x| x.abs().to_integer().to_string().len()).into_iter().max().unwrap_or(1);
    if whole > DIGITS {
        return Err(Error::input(format!("{hi} is beyond the range of a certificate")));
    }
    let scale = num_traits::pow(BigInt::from(10), DIGITS - whole);
    let end = |x: &BigRational, round: fn(&BigRational) -> BigRational| {
        let scaled = round(&(x * BigRational::from_integer(scale.clone())));
        decimal(&BigRational::new(scaled.to_integer(), scale.clone()))
    };
    Ok(Range { lower: end(lo, BigRational::floor)?, upper: end(hi, BigRational::ceil)? })
}

/// A system in these units with exact quotients, if all are, and are short.
pub(crate) fn in_quotients(
    units: Units,
    system: &motion::System<Quotient>,
) -> Result<System<event::Quotient>> {
    converted(units, &units.function(system), &quotient)
}

/// The same with quotients of ranges.
pub(crate) fn in_ranges(
    units: Units,
    system: &motion::System<Quotient>,
) -> Result<System<event::RangeQuotient>> {
    converted(units, &units.function(system), &range_quotient)
}

/// A quotient divided by the greatest magnitude in its denominator, in intervals.
pub(super) fn range_quotient(x: &Quotient) -> Result<event::RangeQuotient> {
    let too_large = || Error::input("a coefficient is too large an expression of the parameter");
    let [numerator, denominator] = x.enclosures().ok_or_else(too_large)?;
    let greatest = denominator.iter().flatten().map(Signed::abs).max().ok_or_else(too_large)?;
    let part = |x: &BigInt| BigRational::new(x.clone(), greatest.clone());
    let ranges = |list: &[[BigInt; 2]]| -> Result<Vec<Range>> {
        list.iter().map(|[lo, hi]| range_of(&part(lo), &part(hi))).collect()
    };
    Ok(event::RangeQuotient { numerator: ranges(numerator)?, denominator: ranges(denominator)? })
}

/// A number that is a decimal.
pub(crate) fn decimal(x: &BigRational) -> Result<Decimal> {
    let scaled =
        |places: u32| x * BigRational::from_integer(num_traits::pow(BigInt::from(10), places as usize));
    let places = (0..DIGITS as u32).find(|&places| scaled(places).is_integer());
    let places = places.ok_or_else(|| Error::input(format!("{x} is no short decimal")))?;
    Ok(Decimal { digits: integer(&scaled(places).to_integer())?, places })
}
