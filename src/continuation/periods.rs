//! The periods of a pattern, counted without overflow.

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
