//! The largest Lyapunov exponent: a tangent vector carried by the flow's derivative and by saltation matrices
//! at impacts.

use std::f64::consts::TAU;

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    oscillator::{
        Time,
        algebra::apply,
        flow::{Flow, State},
        simulate::{Event, Run, RunEnd, Simulator},
    },
};

/// An exponent and what it rests on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent {
    /// The mean rate of growth per unit of time; times 2π, per forcing period. −∞ once the oscillator has
    /// come to rest on a wall, where neighbours meet.
    pub rate: f64,
    /// The standard error of the rate, from the means over [`BATCHES`] equal stretches of the run taken as
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
pub const BATCHES: u64 = 20;

/// Periods between two looks at whether to go on.
const CHUNK: u64 = 256;

/// A motion with a vector that its derivative carries along.
struct Carried<'a> {
    simulator: &'a Simulator,
    run: Run<'a>,
    tangent: [f64; 2],
    state: State,
    now: Time,
    end: RunEnd,
}

impl Carried<'_> {
    /// The logarithm of the vector's growth up to `goal`.
    fn grow(&mut self, goal: Time) -> f64 {
        let mut growth = 0.0;
        while self.end == RunEnd::Reached {
            let event = self.run.next(goal);
            let then = event.time().unwrap_or(self.run.time());
            let flow = self.simulator.flow();
            let (arrival, matrix) = flow.advance_linearised(self.state, then.since(self.now));
            let mut tangent = apply(&matrix, self.tangent);
            match event {
                Event::Impact(impact) => {
                    let contact = self.simulator.contact(impact.side).expect("a wall that was met");
                    tangent = apply(&contact.saltation(flow, arrival), tangent);
                }
                Event::Stick(_) | Event::Release(_) => tangent = [0.0; 2],
                Event::Tangency(_) | Event::End(RunEnd::Reached) => {}
                Event::End(other) => self.end = other,
            }
            let size = tangent[0].hypot(tangent[1]);
            growth += size.ln();
            self.tangent = if size > 0.0 { tangent.map(|x| x / size) } else { tangent };
            (self.state, self.now) = (self.run.state(), self.run.time());
            if event == Event::End(RunEnd::Reached) {
                break;
            }
        }
        growth
    }
}

/// Follows the motion from (q, u) at `time` over `transient` and then `periods` forcing periods. Tangencies
/// and the square root at them are passed as if there were no wall; an impact of velocity w stretches by
/// O(1/w). Asks `monitor` whether to go on.
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
    if periods == 0 {
        return Err(Error::input("periods = 0: the exponent is a mean over at least one"));
    }
    let later = |periods: u64| Time { period: time.period.saturating_add_unsigned(periods), ..time };
    let mut run = simulator.start(time, q, u)?;
    let (mut end, mut passed) = (RunEnd::Reached, 0);
    while passed < transient && end == RunEnd::Reached {
        passed = (passed + CHUNK).min(transient);
        end = run.finish(later(passed));
        monitor.advance(0)?;
    }
    let start = run.impacts();
    let (state, now) = (run.state(), run.time());
    // Any direction but, by ill luck, the stable one.
    let mut carried = Carried { simulator, run, tangent: [0.6, 0.8], state, now, end };
    // Growth and time of each stretch.
    let mut stretches: Vec<(f64, f64)> = Vec::new();
    let count = BATCHES.min(periods);
    let goal = |i: u64| (u128::from(periods) * u128::from(i) / u128::from(count)) as u64;
    for i in 1..=count {
        let (begin, mut growth) = (carried.now, 0.0);
        let mut at = goal(i - 1);
        while at < goal(i) && carried.end == RunEnd::Reached {
            at = (at + CHUNK).min(goal(i));
            growth += carried.grow(later(transient + at));
            monitor.advance(0)?;
        }
        stretches.push((growth, carried.now.since(begin)));
    }
    let mean = |all: &[(f64, f64)]| {
        let (growth, time) = all.iter().fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
        growth / time.max(TAU * f64::EPSILON)
    };
    let (rate, n) = (mean(&stretches), stretches.len() as f64);
    let off = stretches.iter().map(|one| (mean(&[*one]) - rate).powi(2)).sum::<f64>();
    Ok(Exponent {
        rate,
        standard_error: (off / (n * (n - 1.0))).sqrt(),
        second_half: mean(&stretches[stretches.len() / 2..]),
        impacts: carried.run.impacts() - start,
        end: carried.end,
    })
}
