//! The keys of the task `chaos`.

use std::fmt;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::keys::{Entry, StopName, Value, keys};
use crate::{error::Result, motion::Side};

keys! {
    /// Proves, for every parameter in a range, that every bi-infinite word over an alphabet of periods is an
    /// orbit: exactly one in given boxes, and admissible. Writes a certificate. For linear oscillators with
    /// one rigid stop that is met, or with two that are both met and each other's mirror images, half a
    /// period apart. See chaos.md.
    pub struct ChaosTask {
        /// the periods n between impacts; where both stops are met also halves, as in `["1/2", "3/2"]`,
        /// after which the other stop is met; `"auto"` takes those born at the grazing, and leaves out the
        /// longest until the proof succeeds
        alphabet: Alphabet = "\"auto\"",
        /// for each period of the alphabet, in its order, the periods that may follow it; if empty, all of
        /// them
        follow: Vec<Vec<Periods>> = "[]",
        /// a parameter that varies: the proof is for all its values above `from`, up to `to`
        parameter: Option<String>,
        /// the end of its range that is not included
        from: Option<BigRational>,
        /// the end that is included, unless the motion without the stop grazes there; if absent, the range
        /// has no upper end
        to: Option<BigRational>,
        /// other parameters that vary, each with its least and greatest value, as in `{ d = [0.59, 0.61] }`;
        /// only damping, stiffness and restitution may depend on them
        cell: ParameterCell = "{}",
        /// of two stops the one that is met; that the other is out of reach is proved too; if absent, both
        /// are met
        stop: Option<StopName>,
        /// a period and a number: boxes are told apart by how many of that period follow, up to that number
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
