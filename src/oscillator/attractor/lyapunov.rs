//! The largest Lyapunov exponent: a tangent vector carried by the flow's derivative and by saltation matrices at impacts.

use std::f64::consts::TAU;

use crate::{
    error::{Error, Result},
    oscillator::{
        Time,
        algebra::apply,
        flow::Flow,
        simulate::{End, Event, Simulator},
    },
};

/// An exponent and what it rests on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent {
    /// The mean rate of growth per unit of time; times 2π, per forcing period. −∞ once the oscillator has come to rest on a wall, where
    /// neighbours meet.
    pub rate: f64,
    /// The same over the second half of the run: how far the two differ tells how far the mean has settled.
    pub second_half: f64,
    /// Impacts passed.
    pub impacts: u64,
    /// [`End::Reached`], or why the run was shorter than asked for.
    pub end: End,
}

/// Follows the motion from (q, u) at `time` over `transient` and then `periods` forcing periods. Tangencies and the square root at them are
/// passed as if there were no wall; an impact of velocity w stretches by O(1/w).
///
/// # Errors
/// A start behind a wall, or no periods.
pub fn lyapunov(
    simulator: &Simulator,
    time: Time,
    [q, u]: [f64; 2],
    transient: u64,
    periods: u64,
) -> Result<Exponent> {
    if periods == 0 {
        return Err(Error::input("periods = 0: the exponent is a mean over at least one"));
    }
    let later = |periods: u64| Time { period: time.period.saturating_add_unsigned(periods), ..time };
    let mut run = simulator.start(time, q, u)?;
    let mut end = run.finish(later(transient));
    let start = run.impacts();
    // Any direction but, by ill luck, the stable one.
    let (mut tangent, mut growth) = ([0.6, 0.8], [0.0; 2]);
    let (mut state, mut now) = (run.state(), run.time());
    let goals = [later(transient + periods / 2), later(transient + periods)];
    for (half, goal) in goals.into_iter().enumerate() {
        while end == End::Reached {
            let event = run.next(goal);
            let then = event.time().unwrap_or(run.time());
            let (arrival, matrix) = simulator.flow().advance_linearised(state, then.since(now));
            tangent = apply(&matrix, tangent);
            match event {
                Event::Impact(impact) => {
                    let contact = simulator.contact(impact.side).expect("a wall that was met");
                    tangent = apply(&contact.saltation(simulator.flow(), arrival), tangent);
                }
                Event::Stick(_) | Event::Release(_) => tangent = [0.0; 2],
                Event::Tangency(_) | Event::End(End::Reached) => {}
                Event::End(other) => end = other,
            }
            let size = tangent[0].hypot(tangent[1]);
            growth[half] += size.ln();
            if size > 0.0 {
                tangent = tangent.map(|x| x / size);
            }
            (state, now) = (run.state(), run.time());
            if event == Event::End(End::Reached) {
                break;
            }
        }
    }
    let (whole, second) = (now.since(later(transient)), now.since(goals[0]));
    let rate = (growth[0] + growth[1]) / whole.max(TAU * f64::EPSILON);
    Ok(Exponent { rate, second_half: growth[1] / second, impacts: run.impacts() - start, end })
}
