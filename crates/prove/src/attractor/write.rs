//! What was found, as a certificate that the checker accepts.

use num_rational::BigRational;

use super::{
    AttractorProblem, AttractorProof,
    constants::{Constants, ROOM, Rates},
    stop::Stop,
};
use crate::{
    Accepted,
    certificate::attractor::{Certificate, Decimal, Exponent, Fraction, Setting, Shown, growth},
    chaos::{Term, write::decimal},
    error::Result,
    range::{
        RangeEnd,
        write::{self, depth_fraction, float},
    },
};

/// How many times as many pieces a wall is cut into, where its enclosures need that; the most there may be.
pub(super) const PIECES: [u64; 3] = [1, 4, 20];
pub(super) const MOST_PIECES: u64 = 1000;
/// Of exponents the least depth is such a part of the greatest.
const SHALLOWER: f64 = 0.01;

/// A positive number upwards, or downwards, to so many digits.
pub(super) fn rounded(x: f64, digits: i32, up: bool) -> Result<Decimal> {
    let places = (digits - 1 - x.log10().floor() as i32).clamp(0, 14);
    let scale = 10f64.powi(places);
    let digits = if up { (x * scale).ceil() } else { (x * scale).floor() };
    decimal(digits / scale, places)
}

fn both(ends: [f64; 2], digits: i32, up: [bool; 2]) -> Result<[Decimal; 2]> {
    Ok([rounded(ends[0], digits, up[0])?, rounded(ends[1], digits, up[1])?])
}

/// The machines, the wall and the trap to a depth.
pub(super) fn setting(
    machines: &[[BigRational; 2]; 3],
    harmonics: &[Term],
    depth: Fraction,
    (stop, constants): (&Stop, &Constants),
) -> Result<Setting> {
    let shown = match stop.shown {
        Some((concave, pieces)) => Some(Shown { concave: both(concave, 6, [false; 2])?, pieces }),
        None => None,
    };
    Ok(Setting {
        ranges: write::ranges(machines)?,
        harmonics: write::harmonics(harmonics)?,
        depth,
        window: both(stop.window, 7, [true; 2])?,
        bends: both(stop.bends, 8, [false, true])?,
        shown,
        speed: rounded(constants.speed * (1.0 + 2.0 * ROOM), 7, true)?,
        slip: rounded(constants.slip * (1.0 + 2.0 * ROOM), 7, true)?,
    })
}

/// The proof to a depth, or why the checker refuses it.
pub(super) fn proof(
    problem: &AttractorProblem,
    (rates, stop, constants): (&Rates, &Stop, &Constants),
    depth: f64,
    end: RangeEnd,
) -> Result<std::result::Result<AttractorProof, String>> {
    let exponent = match constants.exponent(rates, SHALLOWER * depth) {
        Some((last, rate)) if rate > 0.0 => Some(Exponent {
            depth: depth_fraction(SHALLOWER * depth),
            rate: rounded(rate * (1.0 - 1e-3), 4, false)?,
            last,
        }),
        _ => None,
    };
    let mut certificate = Certificate {
        setting: setting(&problem.ranges, &problem.harmonics, depth_fraction(depth), (stop, constants))?,
        growth: decimal(1.0, 0)?,
        last: constants.last,
        start: rounded(constants.start * (1.0 - 1e-3), 3, false)?,
        exponent,
    };
    let units = match growth(&certificate) {
        Ok(units) => units,
        Err(why) => return Ok(Err(why)),
    };
    // Four places, and a little less for another checker's enclosures.
    let found = units as f64 / (1u64 << 48) as f64 * (1.0 - 1e-7);
    certificate.growth = decimal((found * 1e4).floor() / 1e4, 4)?;
    let mut refused = String::new();
    // It may be no exponent that is refused, or enclosures of a wall that need smaller pieces.
    let (listed, least) = (certificate.exponent, certificate.setting.shown.map_or(1, |shown| shown.pieces));
    for (exponent, pieces) in PIECES.into_iter().flat_map(|more| [(listed, more), (None, more)]) {
        certificate.exponent = exponent;
        certificate.setting.shown = certificate
            .setting
            .shown
            .map(|shown| Shown { pieces: (least * pieces).min(MOST_PIECES), ..shown });
        match Accepted::new(certificate.to_string()) {
            Ok(accepted) => {
                let exact = |x: Fraction| BigRational::new(x.p.into(), x.q.into());
                return Ok(Ok(AttractorProof {
                    depth: exact(certificate.setting.depth),
                    growth: float(certificate.growth),
                    exponent: exponent.map(|one| (exact(one.depth), float(one.rate))),
                    start: float(certificate.start),
                    certificate,
                    accepted,
                    end,
                }));
            }
            Err(why) => refused = why.to_string(),
        }
        if !refused.contains("(A1)") && exponent.is_none() {
            break;
        }
    }
    Ok(Err(refused))
}
