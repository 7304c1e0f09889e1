//! Which walls an orbit meets, and how many periods apart.

use std::fmt;

use crate::{
    continuation::{sum_of_periods, times_round},
    error::{Error, Result},
    motion::Side,
};

/// An impact and the periods from its phase to the next one's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Strike {
    /// The wall that is met.
    pub side: Side,
    /// n_i: the next impact is 2π n_i + t_{i+1} − t_i later. May be 0, as long as that time is positive.
    pub periods: u32,
}

/// The impact pattern (n₁, …, n_m) of an orbit with the wall of each impact; or no impact and a period.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Itinerary {
    strikes: Vec<Strike>,
    periods: u32,
}

impl Itinerary {
    /// An orbit without impacts that repeats after `periods` periods.
    ///
    /// # Errors
    /// An input error for 0.
    pub fn free(periods: u32) -> Result<Itinerary> {
        Self::checked(Vec::new(), periods)
    }

    /// The orbit with these impacts, in this order.
    ///
    /// # Errors
    /// An input error if the periods sum to 0 or to more than 2³² − 1.
    pub fn new(strikes: Vec<Strike>) -> Result<Itinerary> {
        let periods = sum_of_periods(strikes.iter().map(|strike| strike.periods))?;
        Self::checked(strikes, periods)
    }

    /// The pattern (n₁, …, n_m) with every impact at one wall.
    ///
    /// # Errors
    /// As [`Itinerary::new`].
    pub fn at(side: Side, periods: &[u32]) -> Result<Itinerary> {
        Self::new(periods.iter().map(|&periods| Strike { side, periods }).collect())
    }

    fn checked(strikes: Vec<Strike>, periods: u32) -> Result<Itinerary> {
        if periods == 0 {
            return Err(Error::input("the pattern of an orbit must have a period of at least 1"));
        }
        Ok(Itinerary { strikes, periods })
    }

    /// The impacts; empty for an orbit without.
    pub fn strikes(&self) -> &[Strike] {
        &self.strikes
    }

    /// n, in forcing periods.
    pub fn periods(&self) -> u32 {
        self.periods
    }

    /// The same orbit gone round `times` times.
    ///
    /// # Errors
    /// An input error if the period is more than 2³² − 1.
    pub(crate) fn repeated(&self, times: u32) -> Result<Itinerary> {
        let periods = times_round(self.periods, times)?;
        Ok(Itinerary { strikes: self.strikes.repeat(times as usize), periods })
    }
}

/// `3,3`; with the upper wall `1,0 upper`; without impacts `free 1`.
impl fmt::Display for Itinerary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.strikes.is_empty() {
            return f.pad(&format!("free {}", self.periods));
        }
        let show = |strike: &Strike| match strike.side {
            Side::Lower => strike.periods.to_string(),
            Side::Upper => format!("{} upper", strike.periods),
        };
        f.pad(&self.strikes.iter().map(show).collect::<Vec<_>>().join(","))
    }
}
