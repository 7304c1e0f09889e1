//! The keys of the task `chaos`.

use std::fmt;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::keys::{Entry, StopName, Value, keys};
use crate::{error::Result, motion::Side};

keys! {
    /// [Proves](chaos.md), for every parameter in a range, that every bi-infinite word over an alphabet of
    /// periods is one admissible orbit. Linear oscillators; one rigid stop met, or two that mirror each other
    /// half a period apart.
    pub struct ChaosTask {
        /// periods between impacts, with both stops halves; `"auto"`: those born at the grazing, without the
        /// longest until it succeeds
        alphabet: Alphabet = "\"auto\"",
        /// per period of the alphabet, what may follow; if empty, all
        follow: Vec<Vec<Periods>> = "[]",
        /// what varies: proved for values above `from`, up to `to`
        parameter: Option<String>,
        /// end that is not included
        from: Option<BigRational>,
        /// end that is included, unless the motion grazes there; if absent, none
        to: Option<BigRational>,
        /// other parameters, as `{ d = [0.59, 0.61] }`: damping, stiffness, restitution
        cell: ParameterCell = "{}",
        /// of two the one met, the other proved out of reach; if absent, both
        stop: Option<StopName>,
        /// a period and a number: boxes are told apart by how many of it follow, up to that
        history: Vec<Periods> = "[]",
    }
}

impl ChaosTask {
    /// On which side the stop is that is met.
    pub(super) fn side(&self) -> Option<Side> {
        self.stop.as_ref()?.side
    }
}

/// The periods, or that they are to be found.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Alphabet {
    /// Those born at the grazing.
    Auto,
    /// These.
    Periods(Vec<Periods>),
}

impl Value for Alphabet {
    fn shape() -> String {
        format!("`\"auto\"` or {}", Vec::<Periods>::shape())
    }

    fn read(entry: &Entry) -> Result<Self> {
        if entry.item.as_str().is_some() {
            return entry.word(&[("auto", ())]).map(|()| Alphabet::Auto);
        }
        Vec::<Periods>::read(entry).map(Alphabet::Periods)
    }
}

/// A whole or half number of periods.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Periods {
    /// Twice that number.
    pub(crate) halves: u64,
}

impl Periods {
    /// How many periods, if that is a whole number.
    pub(crate) fn whole(self) -> Option<u64> {
        self.halves.is_multiple_of(2).then_some(self.halves / 2)
    }
}

impl fmt::Display for Periods {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.whole() {
            Some(whole) => whole.fmt(f),
            None => write!(f, "{}/2", self.halves),
        }
    }
}

impl Value for Periods {
    fn shape() -> String {
        "whole or half number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let twice = BigRational::read(entry)? * BigRational::from_integer(2.into());
        let halves = twice.is_integer().then(|| twice.to_integer().to_u64()).flatten();
        let halves = halves.filter(|halves| *halves <= 1 << 53);
        halves
            .map(|halves| Periods { halves })
            .ok_or_else(|| entry.fail("is not a whole or half number of periods, as 2 or \"3/2\""))
    }
}

/// Ranges of parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterCell(pub(crate) Vec<(String, [BigRational; 2])>);

impl Value for ParameterCell {
    fn shape() -> String {
        "table of pairs of numbers".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let range = |value: &Entry| match <[BigRational; 2]>::try_from(Vec::<BigRational>::read(value)?) {
            Ok(range) if range[0] < range[1] => Ok(range),
            _ => Err(value.fail("must be two numbers that increase")),
        };
        entry.of_parameters(range).map(ParameterCell)
    }
}

/// The longest period of an alphabet.
pub(crate) const LONGEST: u64 = 100;
