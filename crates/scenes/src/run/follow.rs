//! How a motion is followed for its time series: a transient passes, then it goes from one point to the next.

use std::f64::consts::TAU;

use crate::{
    error::Result,
    monitor::Monitor,
    motion::{RunEnd, Time},
    scene::{simulate::SimulateTask, values::ROUNDED},
};

/// A motion whose points and events are kept.
pub(super) trait SampledMotion {
    /// Periods between two looks at whether to go on.
    const CHUNK: u64;

    /// Passes to a time, keeping nothing.
    fn pass(&mut self, until: Time) -> RunEnd;

    /// Follows the motion to a time, keeping its events.
    ///
    /// # Errors
    /// The keeper's.
    fn record(&mut self, until: Time) -> Result<RunEnd>;

    /// Keeps the point where the motion is.
    ///
    /// # Errors
    /// The keeper's.
    fn sample(&mut self, at: Time) -> Result<()>;
}

/// Follows a motion that begins at `phase` through the transient of a task and then for `span` periods, whole
/// ones or not; the end is why it was followed no farther, [`RunEnd::Reached`] if all of it was.
///
/// # Errors
/// The motion's; the monitor's.
pub(super) fn follow<M: SampledMotion>(
    (task, span): (&SimulateTask, f64),
    phase: f64,
    motion: &mut M,
    monitor: &dyn Monitor,
) -> Result<RunEnd> {
    let (mut end, mut passed) = (RunEnd::Reached, 0);
    while passed < task.transient && end == RunEnd::Reached {
        let next = (passed + M::CHUNK).min(task.transient);
        end = motion.pass(Time::new(next as i64, phase));
        monitor.advance(next - passed)?;
        passed = next;
    }
    let samples = u64::from(task.samples);
    let asked = span * samples as f64;
    let whole = (asked * (1.0 + ROUNDED)).floor();
    // The last point is where the motion ends, at a sample's time or between two.
    let last = (asked - whole > ROUNDED * asked).then_some(asked);
    for sample in (0..=whole as u64).map(|sample| sample as f64).chain(last) {
        if end != RunEnd::Reached {
            break;
        }
        let period = (sample / samples as f64).floor();
        let (period, part) = (period as u64, sample - period * samples as f64);
        if part == 0.0 && period > 0 && period.is_multiple_of(M::CHUNK) {
            monitor.advance(M::CHUNK)?;
        }
        let until = Time::new((task.transient + period) as i64, phase + TAU * part / f64::from(task.samples));
        end = motion.record(until)?;
        if end == RunEnd::Reached {
            motion.sample(until)?;
        }
    }
    Ok(end)
}
