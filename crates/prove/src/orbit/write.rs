//! Enclosed orbits and events as certificates, which the checker has accepted, and where they are by these.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{
    Bounded, Condition, ProvedEvent, ProvedFreeMotion, ProvedOrbit, Quotient, Stability, Units, krawczyk,
};
use crate::{
    Accepted,
    certificate::{
        event,
        orbit::{
            self, Certificate, Claim, Decimal, Fraction, FreeCertificate, Harmonic, Impact, Range, Side,
            System, Wall,
        },
    },
    error::{Error, Result},
    machine::Bounds,
    motion,
    number::{Ball, Precision},
};

/// The most digits of a number in a certificate.
const DIGITS: usize = 34;

/// Decimals of the box within which the checker encloses a solution: as a rule, and at the most, since its
/// numbers are multiples of 2^−96.
const NEAR: u32 = 18;
const FARTHEST: u32 = 26;

/// An orbit, or one at an event, as its certificate has it: all that is said here the checker has accepted.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct CertifiedOrbit {
    /// The certificate.
    pub accepted: Accepted,
    /// t_i, in radians.
    pub phases: Vec<Ball>,
    /// V_i > 0, per radian.
    pub velocities: Vec<Ball>,
    /// Half the side of the box in which there is no other, in the certificate's units.
    pub radius: f64,
    /// What is claimed of its multipliers; nothing at an event.
    pub claim: Claim,
}

/// Bits of the balls of a certified orbit.
const BITS: u32 = 192;

impl CertifiedOrbit {
    /// Where the listed impacts are, each unknown being within so much of what is listed.
    fn new(
        accepted: Accepted,
        impacts: &[Impact],
        [radius, within]: [Decimal; 2],
        claim: Claim,
        units: Units,
    ) -> CertifiedOrbit {
        let precision = Precision::new(BITS);
        let within = exact(within);
        let about = |x: Decimal| Ball::between(&(exact(x) - &within), &(exact(x) + &within), &precision);
        let all = |part: fn(&Impact) -> Decimal| impacts.iter().map(|impact| about(part(impact))).collect();
        let (phases, velocities) = (all(|impact| impact.phase), all(|impact| impact.velocity));
        let radius = exact(radius).to_f64().unwrap_or(f64::NAN);
        let velocities = units.own(velocities, &precision);
        CertifiedOrbit { accepted, phases, velocities, radius, claim }
    }
}

/// A decimal as a fraction.
fn exact(x: Decimal) -> BigRational {
    BigRational::new(x.digits.into(), num_traits::pow(BigInt::from(10), x.places as usize))
}

/// A certificate of kind `orbit`. The checker's intervals differ from the enclosure's: where it does
/// not accept the box, smaller ones are tried.
/// Coefficients of more than 34 digits are enclosed in intervals, version 2 of the kind.
///
/// # Errors
/// An input error: a coefficient of 2³⁰ or more, or no box that the checker accepts.
pub fn certificate(system: &motion::System<impl Bounded>, orbit: &ProvedOrbit) -> Result<CertifiedOrbit> {
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
fn accepted<C: orbit::Version>(system: System<C>, orbit: &ProvedOrbit) -> Result<CertifiedOrbit> {
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
    let radii = || krawczyk::radii().filter(|radius| *radius <= orbit.radius);
    // If the checker does not see where the multipliers are, the orbit is proved without.
    let all = [certificate.claim, Claim::Open].into_iter().flat_map(|claim| radii().map(move |r| (claim, r)));
    for (claim, radius) in all {
        (certificate.claim, certificate.radius) = (claim, decimal(&radius)?);
        match Accepted::new(certificate.to_string()) {
            Ok(accepted) => {
                let Certificate { impacts, radius, within, claim, .. } = certificate;
                return Ok(CertifiedOrbit::new(accepted, &impacts, [radius, within], claim, orbit.units));
            }
            Err(why) => last = why.to_string(),
        }
    }
    Err(Error::input(format!("the checker does not accept this orbit: {last}")))
}

/// A certificate of kind `orbit` of a motion without impacts, version 3. It holds coefficients in intervals,
/// one number each where that is a decimal of up to 34 digits.
///
/// # Errors
/// An input error: a coefficient of 2³⁰ or more, or that the checker does not accept it.
pub fn free_certificate(
    system: &motion::System<impl Bounded>,
    motion: &ProvedFreeMotion,
) -> Result<CertifiedOrbit> {
    let pieces = motion.pieces.iter().map(decimal).collect::<Result<_>>()?;
    let system = converted(motion.units, &motion.units.bounded(system), &between)?;
    let claim = claim(motion.stability);
    let certificate = FreeCertificate { system, claim, pieces };
    let accepted = Accepted::new(certificate.to_string())
        .map_err(|why| Error::input(format!("the checker does not accept this motion: {why}")))?;
    let nowhere = [Decimal { digits: 0, places: 0 }; 2];
    Ok(CertifiedOrbit::new(accepted, &[], nowhere, claim, motion.units))
}

/// What is claimed of the multipliers.
pub(super) fn claim(stability: Option<Stability>) -> Claim {
    match stability {
        Some(Stability::Stable) => Claim::Stable,
        Some(Stability::Unstable) => Claim::Unstable,
        None => Claim::Open,
    }
}

/// A certificate of kind `event`, and the exact ends of the parameter's interval that it proves, in the
/// parameter's own unit, in decimals. `system` is the family as a function of the parameter, `name` what the
/// parameter is called. Of several boxes it has the first that the checker accepts.
///
/// # Errors
/// An input error: a coefficient that does not fit in either version, or no box that the checker accepts.
pub fn event_certificate(
    system: &motion::System<Quotient>,
    name: &str,
    event: &ProvedEvent,
) -> Result<(CertifiedOrbit, [String; 2])> {
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
) -> Result<(CertifiedOrbit, [String; 2])> {
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
        let mut accepted = match Accepted::new(certificate.to_string()) {
            Ok(accepted) => accepted,
            Err(why) => {
                last = why.to_string();
                continue;
            }
        };
        // The box that the event lies in as small as the checker's intervals allow.
        for places in [22, 21, 20] {
            let within = Decimal { digits: 1, places };
            let tightest = event::Certificate { within, ..certificate.clone() };
            if let Ok(smaller) = Accepted::new(tightest.to_string()) {
                (certificate, accepted) = (tightest, smaller);
                break;
            }
        }
        let ends = certificate.interval().map(|ends| ends.map(|end| event.units.said(end)));
        let ends = ends.ok_or_else(|| Error::input("the parameter has too many digits"))?;
        let event::Certificate { impacts, radius, within, .. } = certificate;
        let found = CertifiedOrbit::new(accepted, &impacts, [radius, within], Claim::Open, event.units);
        return Ok((found, ends));
    }
    Err(Error::input(format!("the checker does not accept this event: {last}")))
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
