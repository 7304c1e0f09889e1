//! Which walls an orbit meets, and how many periods apart.

use std::{f64::consts::TAU, fmt};

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
    pub fn repeated(&self, times: u32) -> Result<Itinerary> {
        let periods = times_round(self.periods, times)?;
        Ok(Itinerary { strikes: self.strikes.repeat(times as usize), periods })
    }
}

/// Times of impacts as a pattern counts them, all moved by the whole periods that bring the first into [0,
/// 2π).
pub fn counted(times: &[f64]) -> Vec<f64> {
    let Some(first) = times.first() else { return Vec::new() };
    let phase = first.rem_euclid(TAU);
    // What is negative by rounding alone is 0.
    let phase = if phase < TAU { phase } else { 0.0 };
    times.iter().map(|time| time - first + phase).collect()
}

/// The pattern (n_i) of an orbit's impacts at these times, (period, phase), in order, and the t_i that it
/// counts by: from a quarter of a period before the first impact's phase to three quarters after it. So
/// impacts at about one phase are whole periods apart, wherever in the period that phase is.
pub fn natural(times: &[(i64, f64)], periods: u32) -> Vec<(u32, f64)> {
    let Some(&(period, phase)) = times.first() else { return Vec::new() };
    // The period in which an impact is counted: a quarter of one before the first impact's phase it begins.
    let turn = |&(other, there): &(i64, f64)| other - period + ((there - phase) / TAU + 0.25).floor() as i64;
    let turns: Vec<i64> = times.iter().map(turn).chain([i64::from(periods)]).collect();
    let counted = |(i, time): (usize, &(i64, f64))| {
        let late = time.1 + TAU * (time.0 - period - turns[i]) as f64;
        ((turns[i + 1] - turns[i]).max(0) as u32, late)
    };
    times.iter().enumerate().map(counted).collect()
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
