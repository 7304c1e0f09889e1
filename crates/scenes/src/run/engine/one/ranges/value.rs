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
        range::{ParameterRange, RangeEnd, ToleratedRange, Touching, depth_at},
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
/// Depths of all machines are within such a part of that of the scene's, and of what is known.
const APART: f64 = 0.01;
const DEEP: f64 = 0.9;
/// Depths are looked at that are wider by so many times what they are between, one after the other.
const ROOM: [u32; 3] = [0, 1, 4];
/// How often what lies between is halved.
const HALVINGS: u32 = 20;

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

/// The nearest number to `limit` that holds, from one that does, about; none where that does not.
fn nearest([mut holding, mut limit]: [f64; 2], holds: &dyn Fn(f64) -> Result<bool>) -> Result<Option<f64>> {
    if holds(limit)? {
        return Ok(Some(limit));
    }
    if !holds(holding)? {
        return Ok(None);
    }
    for _ in 0..HALVINGS {
        let middle = (holding * limit).sqrt();
        if holds(middle)? { holding = middle } else { limit = middle }
    }
    Ok(Some(holding))
}

/// The side beyond the touch.
struct Beyond {
    /// Between which values of the parameter it is, or all machines have theirs.
    touch: [BigRational; 2],
    /// Whether those beyond are greater.
    above: bool,
    /// The touches of all machines.
    all: Option<ToleratedRange>,
}

impl Beyond {
    /// The touch that is nearest to what is beyond.
    fn inner(&self) -> &BigRational {
        &self.touch[usize::from(self.above)]
    }

    /// Whether one value is farther than another.
    fn is_past(&self, one: &BigRational, other: &BigRational) -> bool {
        one != other && (one > other) == self.above
    }
}

impl Near<'_> {
    /// A row for the scene's own value, or why there is none; nothing where it is not beyond the touch, or
    /// among those that a row proves already.
    pub(super) fn value(&self, known: &RangeRow) -> Result<Option<std::result::Result<SideRange, String>>> {
        if self.mirrored {
            return Ok(None);
        }
        let (scene, varied) = (&self.point.job.scene, &self.point.task.parameter);
        let Some((_, value)) = scene.parameters.iter().find(|(name, _)| name == varied) else {
            return Ok(None);
        };
        let beyond = match self.beyond() {
            Err(error) if error.is_interrupted() => return Err(error),
            Err(_) | Ok(None) => return Ok(None),
            Ok(Some(beyond)) => beyond,
        };
        let proved = known.end.as_ref().filter(|_| known.verdict == PROVED);
        let proved = proved.map(|end| parse_rational(end)).transpose()?;
        if !beyond.is_past(value, beyond.inner()) || proved.is_some_and(|end| !beyond.is_past(value, &end)) {
            return Ok(None);
        }
        match self.proved_at(value, &beyond) {
            Err(error) if error.is_interrupted() => Err(error),
            Err(error) => Ok(Some(Err(error.to_string()))),
            Ok(found) => Ok(Some(found)),
        }
    }

    /// What is beyond the touch, or beyond those of all machines.
    fn beyond(&self) -> Result<Option<Beyond>> {
        let near = BigRational::new(1.into(), NEAR.into());
        let Some(ParameterRange { touch, end }) = self.parameters(true, &near)? else { return Ok(None) };
        let above = end > touch[1];
        let Of::All(all) = &self.of else { return Ok(Some(Beyond { touch, above, all: None })) };
        let range = all.range(self.start.each_ref(), &near, true)?;
        Ok(range.map(|range| Beyond { touch: range.touches.clone(), above, all: Some(range) }))
    }

    /// Between which depths all machines are between two values of the parameter, the nearer first.
    fn depths(&self, [near, far]: [&BigRational; 2], beyond: &Beyond) -> Result<Option<[BigRational; 2]>> {
        let system = |at: &RationalFunction| functions(self.point, at);
        let (Some(least), Some(greatest)) = (depth_at(&system, None, near)?, depth_at(&system, None, far)?)
        else {
            return Ok(None);
        };
        let Of::All(all) = &self.of else { return Ok(Some([depth(least, false), depth(greatest, true)])) };
        let as_deep = |x: f64| Ok(all.are_as_deep(near, &depth(x, false), true));
        let no_deeper = |x: f64| -> Result<bool> {
            let end = all.range(self.start.each_ref(), &depth(x, true), true)?.and_then(|range| range.end);
            Ok(end.is_some_and(|end| !beyond.is_past(far, &end)))
        };
        let least = nearest([APART * least, least], &as_deep)?;
        let greatest = nearest([DEEP.min(greatest / APART), greatest], &no_deeper)?;
        Ok(least.zip(greatest).map(|(least, greatest)| [depth(least, false), depth(greatest, true)]))
    }

    fn proved_at(
        &self,
        value: &BigRational,
        beyond: &Beyond,
    ) -> Result<std::result::Result<SideRange, String>> {
        let way = (value - beyond.inner()) / BigRational::from(BigInt::from(NEXT_TO));
        let ends = around(value, &way);
        let [near, far] = if beyond.above { [&ends[0], &ends[1]] } else { [&ends[1], &ends[0]] };
        let Some(depths) = self.depths([near, far], beyond)? else {
            return Ok(Err("the depth is not known there".into()));
        };
        let ranges = match &self.of {
            Of::One(_) => {
                let over = RationalFunction::range(&ends[0], Some(&ends[1]));
                Touching::of(&functions(self.point, &over)?, None)?.parameters
            }
            Of::All(_) => self.about.clone(),
        };
        let mut refused = String::new();
        // Of all machines the checker's enclosures of depths are wider than what these are between.
        for times in ROOM {
            let room = (&depths[1] - &depths[0]) * BigRational::from(BigInt::from(times));
            let [least, deepest] = [&depths[0] - &room, &depths[1] + &room];
            if !least.is_positive() {
                return Ok(Err("it is too near to the touch".into()));
            }
            let (ranges, harmonics) = (ranges.clone(), self.harmonics.clone());
            let problem = CellsProblem { ranges, harmonics, depths: [least, deepest.clone()] };
            let proof = match prove_cells(&problem, self.point.job.monitor)? {
                Ok(proof) => proof,
                Err(RangeEnd::Map) => return Ok(Err(NO_WEIGHTS.into())),
                Err(end) => return Ok(Err(why_attractor(&end, self.most))),
            };
            let (touch, marks) = (beyond.touch.clone(), [[deepest.clone(), far.clone()]]);
            let text = match self.around(proof.accepted.text(), touch, Some(near.clone()), &marks) {
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => {
                    refused = error.to_string();
                    continue;
                }
                Ok(text) => text,
            };
            let open = match &beyond.all {
                None => RangeRow::open(true, PROVED, None),
                Some(range) => RangeRow::of_all(true, range, &deepest, &self.start[1], String::new()),
            };
            let row = RangeRow {
                of: ATTRACTOR,
                own_value: Some(decimal_or_fraction(value)),
                near: Some(ends.each_ref().map(decimal_or_fraction)),
                depth: Some(deepest.to_string()),
                growth: Some(proof.growth),
                rate: Some(proof.rate),
                end: None,
                share: None,
                reason: None,
                ..open
            };
            return Ok(Ok(SideRange { row, proofs: vec![text] }));
        }
        Ok(Err(refused))
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
