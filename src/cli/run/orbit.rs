//! Tasks of kind `orbit`: periodic orbits of a pattern.

use serde_json::Value;

use super::{
    Job, Report,
    report::{Rows, number, numbers},
};
use crate::{
    error::Result,
    number::{Plain, Real},
    oscillator::orbit::{Admissibility, Oscillator},
    scene::orbits::OrbitTask,
};

pub(super) fn run(task: &OrbitTask, job: &Job, report: &mut Report) -> Result<()> {
    let mut rows = Rows::new(&[
        "value",
        "pattern",
        "phases",
        "speeds",
        "lambda1",
        "lambda2",
        "stable",
        "admissible",
        "least_gap",
        "residual",
    ]);
    let tolerance = job.scene.accuracy.tolerance;
    let mut at = |value: Option<f64>| -> Result<()> {
        let system = match (&task.parameter, value) {
            (Some(parameter), Some(value)) => job.scene.plain(&[(parameter, value)])?,
            _ => job.system.clone(),
        };
        for orbit in task.orbit.orbits(&Oscillator::new(system, tolerance)?)? {
            let [first, second] = orbit.multipliers.values().map(complex);
            rows.push([
                value.map_or("".into(), number),
                orbit.itinerary.to_string().into(),
                numbers(orbit.impacts().map(|impact| impact.phase)),
                numbers(orbit.impacts().map(|impact| impact.speed)),
                first,
                second,
                yes(orbit.multipliers.is_stable()).into(),
                admissible(&orbit.admissibility).into(),
                orbit.least.map_or("none".into(), |least| number(least.gap)),
                number(orbit.residual),
            ]);
        }
        Ok(())
    };
    match &task.parameter {
        None => at(None)?,
        Some(_) => task.values.iter().try_for_each(|value| at(Some(Plain::ratio(value, &()).0)))?,
    }
    report.undecided |= rows.is_empty();
    report.rows("orbits", rows, job)
}

/// A number, or text if it is not real.
pub(super) fn complex((re, im): (f64, f64)) -> Value {
    match im {
        0.0 => number(re),
        _ => format!("{re:?} {} {:?}i", if im < 0.0 { '-' } else { '+' }, im.abs()).into(),
    }
}

pub(super) fn yes(is: bool) -> &'static str {
    if is { "yes" } else { "no" }
}

pub(super) fn admissible(found: &Admissibility) -> String {
    match found {
        Admissibility::Admissible => "yes".into(),
        Admissibility::Outgoing(i) => format!("no: impact {} does not come in", i + 1),
        Admissibility::Excursion(at) => {
            format!("no: behind the {} wall {:.6} after impact {}", at.side.name(), at.after, at.leg + 1)
        }
    }
}
