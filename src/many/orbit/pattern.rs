//! Impact patterns of machines: which stops an orbit hits, and how many periods apart.

use crate::{
    continuation::{ImpactPattern, sum_of_periods, times_round},
    error::{Error, Result},
};

/// An impact and the periods from its phase to the next one's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopStrike {
    /// The stop that is hit.
    pub stop: usize,
    /// n_i: the next impact is 2π n_i + t_{i+1} − t_i later.
    pub periods: u32,
}

/// The impact pattern of an orbit with the stop of each impact; or no impact and a period.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StopPattern {
    strikes: Vec<StopStrike>,
    periods: u32,
}

impl StopPattern {
    /// An orbit without impacts that repeats after `periods` periods.
    ///
    /// # Errors
    /// An input error for 0.
    pub fn free(periods: u32) -> Result<StopPattern> {
        Self::checked(Vec::new(), periods)
    }

    /// The orbit with these impacts, in this order.
    ///
    /// # Errors
    /// An input error if the periods sum to 0 or to more than 2³² − 1.
    pub fn new(strikes: Vec<StopStrike>) -> Result<StopPattern> {
        let periods = sum_of_periods(strikes.iter().map(|strike| strike.periods))?;
        Self::checked(strikes, periods)
    }

    fn checked(strikes: Vec<StopStrike>, periods: u32) -> Result<StopPattern> {
        if periods == 0 {
            return Err(Error::input("the pattern of an orbit must have a period of at least 1"));
        }
        Ok(StopPattern { strikes, periods })
    }

    /// The impacts; empty for an orbit without.
    pub fn strikes(&self) -> &[StopStrike] {
        &self.strikes
    }

    /// n, in forcing periods.
    pub fn periods(&self) -> u32 {
        self.periods
    }

    /// The same, given the names of the machine's stops.
    pub fn with_names(&self, names: &[&str]) -> String {
        let show = |strike: &StopStrike| match names {
            [_] => strike.periods.to_string(),
            many => format!("{} {}", strike.periods, many[strike.stop]),
        };
        match &self.strikes[..] {
            [] => format!("free {}", self.periods),
            all => all.iter().map(show).collect::<Vec<_>>().join(","),
        }
    }
}

impl ImpactPattern for StopPattern {
    fn impacts(&self) -> usize {
        self.strikes.len()
    }

    fn repeated(&self, times: u32) -> Result<StopPattern> {
        let periods = times_round(self.periods, times)?;
        Ok(StopPattern { strikes: self.strikes.repeat(times as usize), periods })
    }
}
