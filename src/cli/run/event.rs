//! Tasks of kind `event`: a bifurcation of an orbit.

use serde_json::json;

use super::{
    Job, Report,
    orbit::{admissible, complex, yes},
    report::{Rows, number, numbers},
};
use crate::{
    error::Result,
    oscillator::{
        branch::critical,
        grazing::{self, Grazing},
        orbit::{Family, Orbit},
    },
    scene::{SceneFamily, orbits::EventTask},
};

pub(super) fn run(task: &EventTask, job: &Job, report: &mut Report) -> Result<()> {
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let start = family.value();
    report.say("event", task.event.word());
    let orbits: Vec<Orbit> = task
        .orbit
        .orbits(&family.at(start)?)?
        .into_iter()
        .filter(|orbit| orbit.admissibility.is_admissible())
        .collect();
    report.say("orbits", orbits.len());
    let mut found: Vec<f64> = Vec::new();
    let mut new = |parameter: f64| {
        let known = found.iter().any(|old| (old - parameter).abs() <= 1e-9 * (1.0 + parameter.abs()));
        found.push(parameter);
        !known
    };
    let mut failures = Vec::new();
    match task.event.bifurcation() {
        Some(kind) => {
            let mut rows = Rows::new(&[
                "parameter",
                "pattern",
                "phases",
                "speeds",
                "lambda1",
                "lambda2",
                "admissible",
                "residual",
            ]);
            for orbit in &orbits {
                match critical::locate(&family, kind, orbit, start, task.reach) {
                    Ok(event) if new(event.parameter) => {
                        let orbit = event.orbit;
                        let [first, second] = orbit.multipliers.values().map(complex);
                        rows.push([
                            number(event.parameter),
                            orbit.itinerary.to_string().into(),
                            numbers(orbit.impacts().map(|impact| impact.phase)),
                            numbers(orbit.impacts().map(|impact| impact.speed)),
                            first,
                            second,
                            admissible(&orbit.admissibility).into(),
                            number(orbit.residual),
                        ]);
                    }
                    Ok(_) => {}
                    Err(error) => failures.push(error.to_string()),
                }
            }
            report.rows("found", rows, job)?;
        }
        None => {
            let mut rows = Rows::new(&[
                "parameter",
                "pattern",
                "phase",
                "a_G",
                "lambda1",
                "lambda2",
                "region",
                "gamma",
                "e",
                "admissible",
                "residual",
            ]);
            for orbit in &orbits {
                match grazing::locate(&family, orbit, start) {
                    Ok(event) if new(event.parameter) => rows.push(grazing_cells(&event, orbit)),
                    Ok(_) => {}
                    Err(error) => failures.push(error.to_string()),
                }
            }
            report.rows("found", rows, job)?;
        }
    }
    report.undecided |= found.is_empty();
    if found.is_empty() {
        report.say("failures", json!(failures));
    }
    Ok(())
}

fn grazing_cells(event: &Grazing, orbit: &Orbit) -> [serde_json::Value; 11] {
    let map = &event.map;
    let [first, second] = map.multipliers.values().map(complex);
    [
        number(event.parameter),
        orbit.itinerary.to_string().into(),
        number(event.phase()),
        number(map.acceleration),
        first,
        second,
        map.region().map_or("none".into(), |region| format!("{region:?}").into()),
        number(map.gamma()),
        number(map.e()),
        yes(event.admissible).into(),
        number(event.residual),
    ]
}
