//! Lyapunov exponents: the mean growth of vectors that a motion's derivative carries along, kept
//! orthonormal; the largest exponent needs one vector.

use std::f64::consts::TAU;

use super::dynamics::{Dynamics, Motion, Tangents, check_count};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    motion::{RunEnd, Time},
};

/// An exponent and what it rests on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent {
    /// The mean rate of growth per unit of time; times 2π, per forcing period. −∞ once the oscillator has
    /// come to rest on a wall, where neighbours meet.
    pub rate: f64,
    /// The standard error of the rate, from the means over 20 equal stretches of the run taken as
    /// independent; NaN for a run of one period. It does not see what is slower than a stretch.
    pub standard_error: f64,
    /// The rate over the second half of the run: how far the two differ tells how far the mean has settled.
    pub second_half: f64,
    /// Impacts passed.
    pub impacts: u64,
    /// [`RunEnd::Reached`], or why the run was shorter than asked for.
    pub end: RunEnd,
}

/// Into how many stretches a run is divided, if it has that many periods.
pub(crate) const BATCHES: u64 = 20;

/// The largest `count` exponents, with multiplicity, the largest first, of the motion from a start, over
/// `transient` and then `periods` forcing periods. Tangencies and the square root at them are passed as if
/// there were no wall; an impact of velocity w stretches by O(1/w). Those of one motion share impacts and
/// end. Asks `monitor` whether to go on. Cost: the motion's, and that of `count` vectors in each flight.
///
/// # Errors
/// No periods; those of [`Dynamics::begin`]; the monitor's; a count that is not from 1 to the dimension.
pub fn exponents<D: Dynamics>(
    dynamics: &D,
    start: &D::Start,
    count: usize,
    transient: u64,
    periods: u64,
    monitor: &dyn Monitor,
) -> Result<Vec<Exponent>> {
    if periods == 0 {
        return Err(Error::input("periods = 0: the exponent is a mean over at least one"));
    }
    check_count(count, dynamics.dimension())?;
    let chunk = <D::Motion<'_> as Motion>::CHUNK;
    let mut run = dynamics.begin(start)?;
    let time = run.time();
    let later = |periods: u64| Time { period: time.period.saturating_add_unsigned(periods), ..time };
    let (mut end, mut passed) = (RunEnd::Reached, 0);
    while passed < transient && end == RunEnd::Reached {
        passed = (passed + chunk).min(transient);
        end = run.pass(later(passed))?;
        monitor.advance(0)?;
    }
    let before = run.impacts();
    let mut carried = dynamics.tangents(run, count);
    // Growths and time of each stretch.
    let mut stretches: Vec<(Vec<f64>, f64)> = Vec::new();
    let batches = BATCHES.min(periods);
    let goal = |i: u64| (u128::from(periods) * u128::from(i) / u128::from(batches)) as u64;
    for i in 1..=batches {
        let (begin, mut growth) = (carried.time(), vec![0.0; count]);
        let mut at = goal(i - 1);
        while at < goal(i) && end == RunEnd::Reached {
            at = (at + chunk).min(goal(i));
            // Apart, so that the sum's rounding does not depend on how many stretches there were before.
            let mut part = vec![0.0; count];
            end = carried.grow(later(transient + at), &mut part)?;
            growth.iter_mut().zip(part).for_each(|(sum, x)| *sum += x);
            monitor.advance(0)?;
        }
        stretches.push((growth, carried.time().since(begin)));
    }
    let impacts = carried.impacts() - before;
    let one = |k: usize| {
        let mean = |all: &[(Vec<f64>, f64)]| {
            let (growth, time) = all.iter().fold((0.0, 0.0), |sum, one| (sum.0 + one.0[k], sum.1 + one.1));
            growth / time.max(TAU * f64::EPSILON)
        };
        let (rate, n) = (mean(&stretches), stretches.len() as f64);
        let off = stretches.iter().map(|one| (mean(std::slice::from_ref(one)) - rate).powi(2)).sum::<f64>();
        Exponent {
            rate,
            standard_error: (off / (n * (n - 1.0))).sqrt(),
            second_half: mean(&stretches[stretches.len() / 2..]),
            impacts,
            end,
        }
    };
    Ok((0..count).map(one).collect())
}
