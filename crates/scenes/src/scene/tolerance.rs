//! How exactly a task's parameters are known.

use num_rational::BigRational;
use num_traits::Signed;

use super::{
    grammar::LIMIT_BITS,
    keys::{Entry, Value},
};
use crate::{error::Result, number::parse_rational_within};

/// How exactly a parameter is known.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Tolerance {
    /// Up to this part of its value.
    Relative(BigRational),
    /// Up to this.
    Absolute(BigRational),
    /// It is one of these.
    Between([BigRational; 2]),
}

impl Tolerance {
    /// What it may be if it is about this value.
    pub(crate) fn about(&self, value: &BigRational) -> [BigRational; 2] {
        match self {
            Tolerance::Relative(part) => {
                let by = part * value.abs();
                [value - &by, value + by]
            }
            Tolerance::Absolute(by) => [value - by, value + by],
            Tolerance::Between(ends) => ends.clone(),
        }
    }
}

/// The tolerances of parameters, in the scene's order.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerances(pub(crate) Vec<(String, Tolerance)>);

impl Value for Tolerances {
    fn shape() -> String {
        "table of tolerances: `\"2%\"`, a number or two".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.of_parameters(Tolerance::read).map(Tolerances)
    }
}

impl Tolerance {
    fn read(entry: &Entry) -> Result<Tolerance> {
        const FORMS: &str = "write \"2%\" of its value, a number that it is known up to, or its least and greatest value, [a, b]";
        if entry.item.as_array().is_some() {
            let ends = entry.elements()?.iter().map(Entry::number).collect::<Result<Vec<_>>>()?;
            let two: std::result::Result<[BigRational; 2], _> = ends.try_into();
            return match two {
                Ok([lower, upper]) if lower <= upper => Ok(Tolerance::Between([lower, upper])),
                Ok(_) => Err(entry.fail("has its ends in the wrong order: the least value comes first")),
                Err(_) => Err(entry.fail(&format!("is no tolerance: {FORMS}"))),
            };
        }
        let found = match entry.item.as_str() {
            None => Tolerance::Absolute(entry.number()?),
            Some(text) => {
                let text = text.trim();
                let text = text.strip_prefix('±').or(text.strip_prefix("+-")).unwrap_or(text).trim();
                let number = |text: &str| {
                    parse_rational_within(text.trim(), LIMIT_BITS)
                        .map_err(|error| entry.fail(&format!("{error}; {FORMS}")))
                };
                match text.strip_suffix('%') {
                    Some(part) => Tolerance::Relative(number(part)? / BigRational::from_integer(100.into())),
                    None => Tolerance::Absolute(match entry.quantity(text, &[])? {
                        Some(found) => found.value().map_err(|error| entry.fail(&error.to_string()))?,
                        None => number(text)?,
                    }),
                }
            }
        };
        match &found {
            Tolerance::Relative(by) | Tolerance::Absolute(by) if by.is_negative() => {
                Err(entry.fail("is below 0; a tolerance is how far a value may be off"))
            }
            _ => Ok(found),
        }
    }
}
