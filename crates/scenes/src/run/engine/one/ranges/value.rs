//! That chaos attracts at the scene's own value of the parameter, by cells with weights: where the formulas
//! do not reach it.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Signed, ToPrimitive};

use super::{
    super::super::super::range::{ATTRACTOR, PROVED, RangeRow, SideRange, why_attractor},
    Near, Of, functions,
};
use crate::{
    error::Result,
    number::parse_rational,
    output::decimal_or_fraction,
    search::{
        attractor::{CellsProblem, prove_cells},
        chaos::RationalFunction,
        range::{ParameterRange, RangeEnd, Touching, depth_at},
    },
};

/// Proved is of all values as near as one in so many of the way from the touch.
const NEXT_TO: i64 = 1_000_000;
/// One over a depth next to the touch.
const NEAR: i64 = 1000;
/// Why nothing is proved.
const NO_WEIGHTS: &str =
    "no weights of cells are found by which displacements grow, and in a window there are none";
/// Depths are widened by such a part, and have so many places.
const WIDER: f64 = 1e-9;
const PLACES: u32 = 14;

/// Two numbers in few digits, on either side of one and at most about so far from it.
fn around(value: &BigRational, near: &BigRational) -> [BigRational; 2] {
    let size = near.abs().to_f64().filter(|size| *size > 0.0).map_or(0.0, f64::log10);
    let scale = BigRational::from(BigInt::from(10).pow((1.0 - size.floor()).clamp(0.0, 30.0) as u32));
    let (scaled, steps) =
        (value * &scale, (near.abs() * &scale).floor().max(BigRational::from(BigInt::from(1))));
    [(&scaled - &steps).floor() / &scale, (scaled + steps).ceil() / scale]
}

/// A depth as a fraction, downwards or upwards.
fn depth(x: f64, up: bool) -> BigRational {
    let scale = 10f64.powi(PLACES as i32);
    let digits = if up { (x * (1.0 + WIDER) * scale).ceil() } else { (x * (1.0 - WIDER) * scale).floor() };
    BigRational::new(BigInt::from(digits as i64), BigInt::from(10).pow(PLACES))
}

impl Near<'_> {
    /// A row for the scene's own value, or why there is none; nothing where it is not beyond the touch, or
    /// among those that a row proves already.
    pub(super) fn value(&self, known: &RangeRow) -> Result<Option<std::result::Result<SideRange, String>>> {
        if self.mirrored || matches!(self.of, Of::All(_)) {
            return Ok(None);
        }
        let (scene, varied) = (&self.point.job.scene, &self.point.task.parameter);
        let Some((_, value)) = scene.parameters.iter().find(|(name, _)| name == varied) else {
            return Ok(None);
        };
        // Which side is beyond the touch.
        let near = BigRational::new(1.into(), NEAR.into());
        let ParameterRange { touch, end } = match self.parameters(true, &near) {
            Err(error) if error.is_interrupted() => return Err(error),
            Err(_) | Ok(None) => return Ok(None),
            Ok(Some(range)) => range,
        };
        let above = end > touch[1];
        let inner = if above { &touch[1] } else { &touch[0] };
        let is_past = |one: &BigRational, other: &BigRational| one != other && (one > other) == above;
        let proved = known.end.as_ref().filter(|_| known.verdict == PROVED);
        let proved = proved.map(|end| parse_rational(end)).transpose()?;
        if !is_past(value, inner) || proved.is_some_and(|end| !is_past(value, &end)) {
            return Ok(None);
        }
        match self.proved_at(value, &touch, above) {
            Err(error) if error.is_interrupted() => Err(error),
            Err(error) => Ok(Some(Err(error.to_string()))),
            Ok(found) => Ok(Some(found)),
        }
    }

    fn proved_at(
        &self,
        value: &BigRational,
        touch: &[BigRational; 2],
        above: bool,
    ) -> Result<std::result::Result<SideRange, String>> {
        let inner = if above { &touch[1] } else { &touch[0] };
        let ends = around(value, &((value - inner) / BigRational::from(BigInt::from(NEXT_TO))));
        let system = |at: &RationalFunction| functions(self.point, at);
        let over = RationalFunction::range(&ends[0], Some(&ends[1]));
        let Touching { parameters, .. } = Touching::of(&system(&over)?, None)?;
        let [near, far] = if above { [&ends[0], &ends[1]] } else { [&ends[1], &ends[0]] };
        let (Some(least), Some(greatest)) = (depth_at(&system, None, near)?, depth_at(&system, None, far)?)
        else {
            return Ok(Err("the depth is not known there".into()));
        };
        let depths = [depth(least, false), depth(greatest, true)];
        if !depths[0].is_positive() {
            return Ok(Err("it is too near to the touch".into()));
        }
        let harmonics = self.harmonics.clone();
        let problem = CellsProblem { ranges: parameters, harmonics, depths: depths.clone() };
        let proof = match prove_cells(&problem, self.point.job.monitor)? {
            Ok(proof) => proof,
            Err(RangeEnd::Map) => return Ok(Err(NO_WEIGHTS.into())),
            Err(end) => return Ok(Err(why_attractor(&end, self.most))),
        };
        let [_, deepest] = &depths;
        let text = self.around(
            proof.accepted.text(),
            touch.clone(),
            Some(near.clone()),
            &[[deepest.clone(), far.clone()]],
        )?;
        let row = RangeRow {
            of: ATTRACTOR,
            own_value: Some(decimal_or_fraction(value)),
            near: Some(ends.map(|end| decimal_or_fraction(&end))),
            depth: Some(deepest.to_string()),
            growth: Some(proof.growth),
            rate: Some(proof.rate),
            ..RangeRow::open(true, PROVED, None)
        };
        Ok(Ok(SideRange { row, proofs: vec![text] }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_between_decimals_next_to_it() {
        for (value, near) in [("1/3", "1/1000000"), ("1/20", "1/20000000"), ("-7", "3"), ("2", "0.25")] {
            let [value, near] = [value, near].map(|text| parse_rational(text).unwrap());
            let [lo, hi] = around(&value, &near);
            assert!(lo < value && value < hi, "{lo} {hi}");
            assert!(&hi - &lo <= &near * parse_rational("5").unwrap() + parse_rational("2").unwrap() * &near);
        }
        assert!(depth(0.05, false) < parse_rational("1/20").unwrap());
        assert!(depth(0.05, true) > parse_rational("1/20").unwrap());
    }
}
