//! The largest Lyapunov exponent of an oscillator's motion.

use crate::{
    attractor::lyapunov::{Exponent, exponents},
    error::{Error, Result},
    monitor::Monitor,
    motion::{State, Time},
    one::simulate::Simulator,
};

/// The largest exponent of the motion from (q, u) at `time`: see [`exponents`].
///
/// # Errors
/// A start behind a wall, or no periods; the monitor's.
pub fn lyapunov(
    simulator: &Simulator,
    time: Time,
    [q, u]: [f64; 2],
    transient: u64,
    periods: u64,
    monitor: &dyn Monitor,
) -> Result<Exponent> {
    let start = State { t: time.phase, q, u };
    let all = exponents(simulator, &start, 1, transient, periods, monitor)?;
    all.into_iter().next().ok_or_else(|| Error::input("no exponent"))
}
