//! Ranges on the command line: of whole numbers, `N`, `A..=B` or `A-B`, and of exact ones, `X`, `A..=B` or
//! `X±Y`, also with a unit.

use std::{num::IntErrorKind, ops::RangeInclusive, str::FromStr};

use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::{
    error::{Error, Result},
    number::{parse_integer, parse_rational},
    quantity::{self, Dimension},
    source::nearest,
    typed::in_number,
};

/// A parser of whole numbers in a range, for clap.
pub(super) fn whole(range: RangeInclusive<u32>) -> impl Fn(&str) -> Result<u32> + Clone + Send + Sync {
    move |text| {
        let number = parse_integer(text)?;
        if range.contains(&number) {
            return Ok(number);
        }
        Err(Error::input(format!("{number} is not in {}..={}", range.start(), range.end())))
    }
}

/// A parser of a number from 0 to 1, for clap.
pub(super) fn share(text: &str) -> Result<f64> {
    match text.parse() {
        Ok(share) if (0.0..=1.0).contains(&share) => Ok(share),
        _ => Err(Error::input(format!("{text:?} is not a number from 0 to 1"))),
    }
}

/// A range of periods as written by the user, in order and from 1 up.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Periods(pub RangeInclusive<u64>);

impl FromStr for Periods {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let number = |part: &str| {
            let part = part.trim();
            part.parse::<u64>().map_err(|error| {
                Error::input(match error.kind() {
                    IntErrorKind::PosOverflow => format!("{part} is too large for a period"),
                    _ => format!("{part:?} is not a whole number: write N, or A..=B as in 3..=8"),
                })
            })
        };
        if text.trim_start().starts_with('-') {
            return Err(Error::input("a period is at least 1"));
        }
        let (first, last) = match text.split_once("..=").or_else(|| text.split_once('-')) {
            Some((first, last)) => (number(first)?, number(last)?),
            None => match text.split_once("..") {
                Some((first, last)) => {
                    let (first, last) = (number(first)?, number(last)?);
                    let what = if first > last { "reversed" } else { "ambiguous" };
                    let (least, most) = (first.min(last), first.max(last));
                    return Err(Error::input(format!(
                        "{first}..{last} is {what}: write {least}..={most}, which includes both ends"
                    )));
                }
                None => (number(text)?, number(text)?),
            },
        };
        if first == 0 {
            return Err(Error::input("a period is at least 1"));
        }
        if first > last {
            return Err(Error::input(format!("the range is reversed: write {last}..={first}")));
        }
        Ok(Periods(first..=last))
    }
}

impl Periods {
    /// The range, if it ends within a command's limit.
    pub fn within(&self, limit: u64, command: &str) -> Result<RangeInclusive<u64>> {
        if *self.0.end() > limit {
            return Err(Error::input(format!(
                "`grazing {command}` goes up to period {limit}, not {}",
                self.0.end()
            )));
        }
        Ok(self.0.clone())
    }

    /// The number of periods.
    pub fn count(&self) -> u64 {
        self.0.end() - self.0.start() + 1
    }
}

/// The ends of a closed interval of numbers, equal for a single one, and whether it is written `X±Y`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Span(pub [BigRational; 2], pub bool);

impl FromStr for Span {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let Measure { span, unit } = text.parse()?;
        match unit {
            None => Ok(span),
            Some(unit) => Err(Error::input(format!("{text:?} has no unit here, not {}", unit.name))),
        }
    }
}

impl Span {
    pub fn is_interval(&self) -> bool {
        self.0[0] != self.0[1]
    }
}

/// A unit of frequency: how many of the first of its kind it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    pub name: String,
    /// Units of one kind have rational ratios.
    pub kind: &'static str,
    size: BigRational,
}

impl Unit {
    /// The unit behind a number, if there is one, and where it begins.
    ///
    /// # Errors
    /// For a unit of anything else.
    fn behind(text: &str) -> Result<Option<(usize, Unit)>> {
        let found = text.char_indices().find_map(|(at, _)| Some((at, quantity::Unit::parse(&text[at..])?)));
        let Some((at, unit)) = found.filter(|(_, unit)| unit.dimension != Dimension::ONE) else {
            return Ok(None);
        };
        if unit.dimension.power(-1).is_like(Dimension::of(0, 1, 0)) && unit.pi == 0 {
            let kind = if unit.dimension.angle == 0 { "Hz" } else { "rad/s" };
            return Ok(Some((at, Unit { name: unit.text, kind, size: unit.size })));
        }
        let what = format!("{text:?} is {}: a frequency is in Hz, mHz, kHz, rpm or rad/s", unit.dimension);
        Err(Error::input(what))
    }

    /// How many of it a value in the first unit of its kind is.
    pub fn of(&self, value: &BigRational) -> BigRational {
        value / &self.size
    }
}

/// An exact number; what hands type is told with what to write.
fn read(text: &str) -> Result<BigRational> {
    parse_rational(text).map_err(|error| {
        let unit = text.trim_start_matches(|c: char| !c.is_alphabetic());
        let near = nearest(unit, FREQUENCIES)
            .map(|near| format!("there is no unit {unit:?}; the nearest is {near:?}"));
        match in_number(text).or(near) {
            Some(meant) => Error::input(format!("{error}; {meant}")),
            None => error.into(),
        }
    })
}

/// Units of frequency.
const FREQUENCIES: [&str; 5] = ["Hz", "mHz", "kHz", "rpm", "rad/s"];

fn hundred() -> BigRational {
    BigRational::from_integer(100.into())
}

/// A closed interval with a unit or without one, in the first unit of its kind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measure {
    pub span: Span,
    pub unit: Option<Unit>,
}

/// `X`, `A..=B`, `X±Y` or `X±P%`, and `+-` for `±`; a unit stands behind a number, or behind the last for
/// all.
impl FromStr for Measure {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let mut known: Option<Unit> = None;
        let mut units = Vec::new();
        let mut number = |part: &str| {
            let part = part.trim();
            let (digits, unit) = match Unit::behind(part)? {
                Some((at, unit)) => (part[..at].trim_end(), Some(unit)),
                None => (part, None),
            };
            units.push(unit.is_some());
            if let (Some(unit), Some(before)) = (&unit, &known)
                && unit != before
            {
                return Err(Error::input(format!(
                    "{text:?} has two units: {} and {}",
                    before.name, unit.name
                )));
            }
            known = known.take().or(unit);
            read(digits)
        };
        let both = text.split_once("±").or_else(|| text.split_once("+-"));
        let [lower, upper] = if let Some((middle, by)) = both {
            let middle = number(middle)?;
            let by = match by.trim().strip_suffix('%') {
                Some(percent) => read(percent.trim_end())? / hundred() * middle.abs(),
                None => number(by)?,
            };
            if by.is_negative() {
                return Err(Error::input(format!("{text:?}: a tolerance is not negative")));
            }
            [&middle - &by, middle + by]
        } else if let Some((lower, upper)) = text.split_once("..=") {
            let ends = [number(lower)?, number(upper)?];
            if ends[0] > ends[1] {
                return Err(Error::input(format!(
                    "the interval is reversed: write {}..={}",
                    upper.trim(),
                    lower.trim()
                )));
            }
            ends
        } else {
            // A share: of nothing it would be a tolerance.
            let value = match text.trim().strip_suffix('%') {
                Some(percent) => read(percent.trim_end())? / hundred(),
                None => number(text)?,
            };
            [value.clone(), value]
        };
        // The last unit is everybody's, the first alone is that of a percentage or of a mistake.
        if units.first() == Some(&true) && units.last() == Some(&false) {
            return Err(Error::input(format!("{text:?}: the unit stands behind the last number")));
        }
        let size = known.as_ref().map_or_else(BigRational::one, |unit| unit.size.clone());
        Ok(Measure { span: Span([lower * &size, upper * size], both.is_some()), unit: known })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends(text: &str) -> Option<[String; 2]> {
        text.parse::<Measure>().ok().map(|measure| measure.span.0.map(|end| end.to_string()))
    }

    #[test]
    fn tolerances_are_read_in_every_form() {
        let some = |lower: &str, upper: &str| Some([lower.to_string(), upper.to_string()]);
        assert_eq!(ends("12.5Hz±4%"), some("12", "13"));
        assert_eq!(ends("12.5 +- 0.5 Hz"), some("12", "13"));
        assert_eq!(ends("12.5Hz±0.5Hz"), some("12", "13"));
        assert_eq!(ends("12..=13kHz"), some("12000", "13000"));
        assert_eq!(ends("750rpm"), some("25/2", "25/2"));
        assert_eq!(ends("-2±50%"), some("-3", "-1"));
        assert_eq!(ends("1/3"), some("1/3", "1/3"));
        for wrong in [
            "12.5Hz±0.5",
            "12Hz..=13",
            "12Hz±1kHz",
            "3mm",
            "90deg/s",
            "3±-1",
            "2..=1",
            "Hz",
            "1±%",
            "1±2±3",
            "",
        ] {
            assert_eq!(ends(wrong), None, "{wrong}");
        }
        assert!("0.02Hz".parse::<Span>().unwrap_err().is_input());
        assert_eq!((ends("4 %"), ends("-2%")), (some("1/25", "1/25"), some("-1/50", "-1/50")));
        for (typed, told) in [
            ("3,7Hz", "3,7 has a decimal comma: write 3.7"),
            ("\u{2212}3.7 Hz", "is not the minus of a keyboard: write -"),
            ("3.7hz", "there is no unit \"hz\"; the nearest is \"Hz\""),
            ("nan", "every number is finite"),
            ("0.1+/-20%", "+/- is written ± or +-"),
        ] {
            let error = typed.parse::<Measure>().unwrap_err().to_string();
            assert!(error.contains(told), "{typed}: {error}");
        }
    }
}
