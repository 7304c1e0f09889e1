//! The periods of a pattern, counted without overflow, and the times of impacts that it counts by.

use std::f64::consts::TAU;

use crate::error::{Error, Result};

/// The sum of a pattern's periods.
///
/// # Errors
/// An input error if it is more than 2³² − 1.
pub(crate) fn sum_of_periods(periods: impl IntoIterator<Item = u32>) -> Result<u32> {
    let sum = periods.into_iter().try_fold(0u32, u32::checked_add);
    sum.ok_or_else(|| Error::input("the pattern's periods sum to more than 2^32 - 1"))
}

/// The period of an orbit gone round some times: an error as of [`sum_of_periods`].
pub(crate) fn times_round(periods: u32, times: u32) -> Result<u32> {
    let all = periods.checked_mul(times);
    all.ok_or_else(|| Error::input(format!("{times} times {periods} periods are more than 2^32 - 1")))
}

/// The periods between the impacts of an orbit gone round once, from the first half of those of one gone
/// round twice: t_1 is `later` in its second half, and the last impact of the first half closes the circle.
pub(crate) fn halved(first: &[u32], period: u32, later: f64) -> Option<Vec<u32>> {
    let mut periods = first.to_vec();
    let last = periods.last_mut()?;
    *last = u32::try_from(i64::from(*last) + (later / TAU).round() as i64).ok()?;
    let sum = periods.iter().try_fold(0u32, |sum, periods| sum.checked_add(*periods))?;
    (sum.checked_mul(2) == Some(period)).then_some(periods)
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
