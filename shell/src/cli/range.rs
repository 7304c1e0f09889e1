//! Ranges on the command line: of whole numbers, `N`, `A..=B` or `A-B`, and of exact ones, `X` or `A..=B`.

use std::{num::IntErrorKind, ops::RangeInclusive, str::FromStr};

use num_rational::BigRational;

use crate::{
    error::{Error, Result},
    number::{parse_integer, parse_rational},
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
pub(super) struct Periods(pub RangeInclusive<u64>);

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

/// The ends of a closed interval of numbers, equal for a single one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Span(pub [BigRational; 2]);

impl FromStr for Span {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let (lower, upper) = match text.split_once("..=") {
            Some((lower, upper)) => (parse_rational(lower)?, parse_rational(upper)?),
            None => (parse_rational(text)?, parse_rational(text)?),
        };
        if lower > upper {
            return Err(Error::input(format!("the interval is reversed: write {upper}..={lower}")));
        }
        Ok(Span([lower, upper]))
    }
}

impl Span {
    pub fn is_interval(&self) -> bool {
        self.0[0] != self.0[1]
    }
}
