//! What changes a touch: by how much it moves for one per cent more of each parameter, and where it is with a
//! tenth less and more of it, for the task `grazing`.
//!
//! The touch is found again with the parameter a ten-thousandth more, and as much less; half of the
//! difference is its derivative but for a part of 10⁻⁸. Where the two sides differ as at a corner, or another
//! stop is touched, nothing is said. Cost: four touches per parameter.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{
    GrazingMap, Job,
    engine::{Engine, GrazingPoint, by_engine},
    row,
};
use crate::{error::Result, scene::orbits::GrazingTask};

row! {
    /// How a parameter changes the touch.
    pub struct InfluenceRow {
        /// The parameter.
        pub parameter: String,
        /// Its value.
        pub of: f64,
        /// By how much the touch moves for 1 % more of it, to first order.
        pub change: Option<f64>,
        /// The same, in per cent of the touch.
        pub percent: Option<f64>,
        /// The touch where the parameter is nine tenths of its value; absent where another stop is touched,
        /// or none.
        pub less: Option<f64>,
        /// The same at eleven tenths.
        pub more: Option<f64>,
        /// Why one of the first two is not told.
        pub reason: Option<String>,
    }
}

/// How far a parameter is moved, as a part of its value: one over this.
const PART: i64 = 10_000;
/// What the two sides may differ by, as a part of the larger.
const UNEVEN: f64 = 0.02;
/// What a touch is known to, in what moves the gap by the size of the motion, or of itself: nearer to 0 it is
/// at 0, and what moves it by less does not move it.
const KNOWN: f64 = 1e-11;

/// The stop that is touched with a parameter moved, and where; the inner error is why none is.
type Moved = std::result::Result<(String, f64), String>;

fn touch(task: &GrazingTask, job: &Job) -> Result<Moved> {
    by_engine!(job, engine => {
        let family = engine.family(&task.parameter)?;
        let found = engine.grazing(task, &family)?;
        Ok(found.map(|point| point.report()).map(|GrazingMap { stop, parameter, .. }| (stop, parameter)))
    })
}

/// All parameters but the task's own, that with the most influence first; `unit` is what of the task's
/// parameter moves the gap by the size of the motion.
///
/// # Errors
/// An interruption.
pub(super) fn influences(
    task: &GrazingTask,
    job: &Job,
    at: &GrazingMap,
    unit: f64,
) -> Result<Vec<InfluenceRow>> {
    let others = || job.scene.parameters.iter().filter(|(name, _)| *name != task.parameter);
    job.monitor.begin(others().count() as u64, "parameters");
    let mut rows = Vec::new();
    for (name, value) in others() {
        job.check()?;
        let mut row = InfluenceRow {
            parameter: name.clone(),
            of: value.to_f64().unwrap_or(f64::NAN),
            change: None,
            percent: None,
            less: None,
            more: None,
            reason: None,
        };
        if !value.is_zero() {
            let tenth = value / BigRational::from_integer(10.into());
            let at_stop = |(stop, parameter): (String, f64)| (stop == at.stop).then_some(parameter);
            row.less = moved(task, job, name, value - &tenth)?.ok().and_then(at_stop);
            row.more = moved(task, job, name, value + &tenth)?.ok().and_then(at_stop);
        }
        match change(task, job, at, (name, value), unit)? {
            Ok(change) if at.parameter.abs() > KNOWN * unit => {
                (row.change, row.percent) = (Some(change), Some(100.0 * change / at.parameter.abs()));
            }
            Ok(change) => {
                row.change = Some(change);
                row.reason = Some("the touch is at 0, of which there is no per cent".into());
            }
            Err(why) => row.reason = Some(why),
        }
        rows.push(row);
        job.monitor.advance(1)?;
    }
    let size = |row: &InfluenceRow| row.change.map_or(-1.0, f64::abs);
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    Ok(rows)
}

/// The touch with a parameter at another value. What a value of its own forbids, as a damping below 0, is
/// told of that parameter alone.
fn moved(task: &GrazingTask, job: &Job, name: &str, there: BigRational) -> Result<Moved> {
    match job.with(&[(name.to_string(), there)]).and_then(|job| touch(task, &job)) {
        Err(error) if error.is_interrupted() => Err(error),
        Err(error) => Ok(Err(error.to_string())),
        Ok(found) => Ok(found),
    }
}

/// How the touch moves for 1 % more of a parameter, or why that is not known.
fn change(
    task: &GrazingTask,
    job: &Job,
    at: &GrazingMap,
    (name, value): (&str, &BigRational),
    unit: f64,
) -> Result<std::result::Result<f64, String>> {
    if value.is_zero() {
        return Ok(Err("it is 0, of which there is no per cent".into()));
    }
    let step = value.abs() / BigRational::from_integer(PART.into());
    let mut by = [0.0; 2];
    for (place, there) in [value - &step, value + &step].into_iter().enumerate() {
        match moved(task, job, name, there)? {
            Ok((stop, parameter)) if stop == at.stop => by[place] = parameter - at.parameter,
            Ok((stop, _)) => return Ok(Err(format!("moved a little, stop {stop} is touched first"))),
            Err(why) => return Ok(Err(format!("moved a little: {why}"))),
        }
    }
    let [below, above] = by;
    let known = KNOWN * unit.max(at.parameter.abs());
    if above.abs().max(below.abs()) <= known {
        return Ok(Ok(0.0));
    }
    if (above + below).abs() - known > UNEVEN * above.abs().max(below.abs()) {
        return Ok(Err("moved up and down, the touch moves unevenly: it may be another one".into()));
    }
    // Of 1 % more of what is below 0 there is less.
    let sign = if value.is_negative() { -1.0 } else { 1.0 };
    Ok(Ok(sign * (above - below) / 2.0 * PART as f64 / 100.0))
}
