//! A range of depths as a range of a machine's parameter: the certificate of kind `parameter` around one of
//! kind `range`, `single`, `nothing` or `attractor`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, pow};

use crate::{
    Accepted,
    certificate::{
        self,
        parameter::{Begin, Certificate, Decimal, Depth, Fraction, Version, rises_after},
    },
    error::{Error, Result},
    motion::{Side, System},
    number::Precision,
    orbit::{Jet, Quotient, Units, decimal, in_quotients, in_ranges},
};

/// A machine, its parameter, and the depths of its certificate.
pub struct Said<'a> {
    /// The oscillator at a value of the parameter, in radians.
    pub family: &'a dyn Fn(&Jet) -> Result<System<Jet>>,
    /// The same as a function of it.
    pub system: &'a System<Quotient>,
    /// What the parameter is called.
    pub name: &'a str,
    /// The parameter at the touch is between these.
    pub touch: [BigRational; 2],
    /// The value of the parameter from which on it is proved, if that is not the touch.
    pub from: Option<BigRational>,
    /// About when the wall's top is, where it has several harmonics.
    pub top: Option<f64>,
    /// Depths and the parameters up to which they are not passed, both away from the touch.
    pub depths: &'a [[BigRational; 2]],
}

/// In how many pieces the range is looked at, until that is enough.
const PIECES: [u64; 4] = [1, 8, 64, 1000];
/// Digits of the touch; of several harmonics, of which the top is known to fewer.
const DIGITS: [i32; 2] = [20, 18];
/// Decimals of the time of the top, and how far from a float's it is looked for: few enough for a second
/// reader.
const PLACES: u32 = 20;
const NEAR: f64 = 1e-7;
/// Of the balls that units are chosen by.
const BITS: u32 = 128;

impl Said<'_> {
    /// The certificate around this one, which has passed the check.
    ///
    /// # Errors
    /// An input error that says what a certificate cannot hold, or why the checker refuses it.
    pub fn around(&self, inner: &str) -> Result<Accepted> {
        let met = [(Side::Lower, &self.system.lower), (Side::Upper, &self.system.upper)];
        let met = met.into_iter().filter(|(_, wall)| wall.is_some()).map(|(side, _)| side);
        let units = Units::along(self.family, met, &self.touch[0], &Precision::new(BITS))?;
        match in_quotients(units, self.system) {
            Ok(system) => self.accepted(units, system, inner),
            Err(_) => self.accepted(units, in_ranges(units, self.system)?, inner),
        }
    }

    fn accepted<C: Version>(
        &self,
        units: Units,
        system: certificate::parameter::System<C>,
        inner: &str,
    ) -> Result<Accepted> {
        let begin = match &self.from {
            Some(from) => Begin::From(decimal(&units.parameter(from))?),
            None => {
                let digits = DIGITS[usize::from(self.top.is_some())];
                Begin::Touch(around(self.touch.each_ref().map(|end| units.parameter(end)), digits)?)
            }
        };
        let depth = |[depth, parameter]: &[BigRational; 2]| {
            let number = |x: &BigInt| x.to_i128().ok_or_else(|| Error::input("a depth has too many digits"));
            let depth = Fraction { p: number(depth.numer())?, q: number(depth.denom())? };
            Ok::<_, Error>(Depth { depth, parameter: decimal(&units.parameter(parameter))? })
        };
        // The checker's names are short and of ASCII letters.
        let name = if self.name.is_ascii() && self.name.len() <= 32 { self.name } else { "p" };
        let depths = self.depths.iter().map(depth).collect::<Result<_>>()?;
        let mut certificate = Certificate { system, name: name.into(), begin, top: None, pieces: 1, depths };
        certificate.top = self.top.map(|about| top(&certificate, about)).transpose()?;
        let Some((_, inner)) = inner.split_once('\n') else { return Err(Error::input("no certificate")) };
        let mut last = String::new();
        for pieces in PIECES {
            certificate.pieces = pieces;
            match Accepted::new(format!("{certificate}{inner}")) {
                Ok(accepted) => return Ok(accepted),
                Err(why) => last = why.to_string(),
            }
            // Smaller pieces help with nothing else.
            if !last.contains("(P2)") {
                break;
            }
        }
        Err(Error::input(last))
    }
}

/// Decimals beyond both ends.
fn around([lo, hi]: [BigRational; 2], digits: i32) -> Result<[Decimal; 2]> {
    let size =
        lo.abs().to_f64().filter(|size| size.is_normal()).map_or(0, |size| size.log10().floor() as i32);
    let scale = pow(BigInt::from(10), (digits - 1 - size).clamp(0, 26) as usize);
    let scaled = |x: BigRational| x * BigRational::from_integer(scale.clone());
    let ends = [scaled(lo).floor().to_integer() - 1, scaled(hi).ceil().to_integer() + 1];
    let [lo, hi] = ends.map(|end| decimal(&BigRational::new(end, scale.clone())));
    Ok([lo?, hi?])
}

/// The time of the top, by halving.
fn top<C: Version>(certificate: &Certificate<C>, about: f64) -> Result<[Decimal; 2]> {
    let found = || Error::input("the wall's top was not found");
    let scale = 10f64.powi(12);
    let [mut lo, mut hi] = [about - NEAR, about + NEAR]
        .map(|t| BigInt::from((t * scale).round() as i64) * pow(BigInt::from(10), PLACES as usize - 12));
    let time = |t: &BigInt| decimal(&BigRational::new(t.clone(), pow(BigInt::from(10), PLACES as usize)));
    let rises = |t: &BigInt| Ok::<_, Error>(rises_after(certificate, time(t)?));
    if (rises(&lo)?, rises(&hi)?) != (Some(true), Some(false)) {
        return Err(found());
    }
    loop {
        let middle: BigInt = (&lo + &hi) / 2;
        if middle == lo || middle == hi {
            return Ok([time(&lo)?, time(&hi)?]);
        }
        match rises(&middle)? {
            Some(true) => lo = middle,
            Some(false) => hi = middle,
            // As near as the checker's numbers tell.
            None => return Ok([time(&lo)?, time(&hi)?]),
        }
    }
}
