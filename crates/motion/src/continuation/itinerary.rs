//! Impact patterns of orbits: which stops are hit, in which order, and how many periods apart.

use std::fmt;

use super::periods::{halved, sum_of_periods, times_round};
use crate::{
    error::{Error, Result},
    motion::{Side, event::Place},
};

/// An impact and the periods from its phase to the next one's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Strike<P> {
    /// The stop that is hit.
    pub place: P,
    /// n_i: the next impact is 2π n_i + t_{i+1} − t_i later. May be 0, as long as that time is positive.
    pub periods: u32,
}

/// The impact pattern (n₁, …, n_m) of an orbit with the stop of each impact; or no impact and a period.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Itinerary<P> {
    strikes: Vec<Strike<P>>,
    periods: u32,
}

impl<P: Place> Itinerary<P> {
    /// An orbit without impacts that repeats after `periods` periods.
    ///
    /// # Errors
    /// An input error for 0.
    pub fn free(periods: u32) -> Result<Self> {
        Self::checked(Vec::new(), periods)
    }

    /// The orbit with these impacts, in this order.
    ///
    /// # Errors
    /// An input error if the periods sum to 0 or to more than 2³² − 1.
    pub fn new(strikes: Vec<Strike<P>>) -> Result<Self> {
        let periods = sum_of_periods(strikes.iter().map(|strike| strike.periods))?;
        Self::checked(strikes, periods)
    }

    /// The pattern (n₁, …, n_m) with every impact at one stop.
    ///
    /// # Errors
    /// As [`Itinerary::new`].
    pub fn at(place: P, periods: &[u32]) -> Result<Self> {
        Self::new(periods.iter().map(|&periods| Strike { place, periods }).collect())
    }

    fn checked(strikes: Vec<Strike<P>>, periods: u32) -> Result<Self> {
        if periods == 0 {
            return Err(Error::input("the pattern of an orbit must have a period of at least 1"));
        }
        Ok(Itinerary { strikes, periods })
    }

    /// The impacts; empty for an orbit without.
    pub fn strikes(&self) -> &[Strike<P>] {
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
    pub(crate) fn repeated(&self, times: u32) -> Result<Self> {
        let periods = times_round(self.periods, times)?;
        Ok(Itinerary { strikes: self.strikes.repeat(times as usize), periods })
    }

    /// The orbit gone round once, if this is one gone round twice whose impacts after half of them are
    /// `later` in t than the first ones; `None` if it is not twice another.
    pub(crate) fn once(&self, later: impl FnOnce(usize) -> f64) -> Option<Self> {
        if self.strikes.is_empty() {
            let half = Self::free(self.periods / 2).ok()?;
            return (half.repeated(2).ok().as_ref() == Some(self)).then_some(half);
        }
        let (first, second) = self.strikes.split_at(self.strikes.len() / 2);
        if first.len() != second.len() || first.iter().zip(second).any(|(a, b)| a.place != b.place) {
            return None;
        }
        let periods: Vec<u32> = first.iter().map(|strike| strike.periods).collect();
        let periods = halved(&periods, self.periods, later(first.len()))?;
        let strikes = first.iter().zip(periods).map(|(strike, periods)| Strike { periods, ..*strike });
        Self::new(strikes.collect()).ok()
    }

    /// `3,3`; with the names of stops `1,0 top`, as `name` gives them, where there are several; without
    /// impacts `free 1`.
    pub fn with_names<N: fmt::Display>(&self, name: impl Fn(P) -> Option<N>) -> String {
        let show = |strike: &Strike<P>| match name(strike.place) {
            None => strike.periods.to_string(),
            Some(name) => format!("{} {name}", strike.periods),
        };
        match &self.strikes[..] {
            [] => format!("free {}", self.periods),
            all => all.iter().map(show).collect::<Vec<_>>().join(","),
        }
    }
}

/// `3,3`; with the upper wall `1,0 upper`; without impacts `free 1`.
impl fmt::Display for Itinerary<Side> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.with_names(|side| (side == Side::Upper).then_some("upper")))
    }
}
