//! Tasks of kind `grazing`: a grazing bifurcation, and what is born there.

use serde_json::json;

use super::{
    Job, Report,
    orbit::{admissible, complex, yes},
    report::{Rows, number, numbers},
};
use crate::{
    error::{Error, Result},
    oscillator::{
        grazing::{self, Grazing},
        orbit::{Family, find},
    },
    pattern::{Existence, Graph, Pattern, Patterns, Report as Verdict},
    scene::{SceneFamily, orbits::GrazingTask},
};

pub(super) fn run(task: &GrazingTask, job: &Job, report: &mut Report) -> Result<()> {
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let start = family.value();
    let orbits = task.orbit.orbits(&family.at(start)?)?;
    let orbit = orbits.iter().find(|orbit| orbit.admissibility.is_admissible()).ok_or_else(|| {
        Error::input(format!("no admissible orbit to begin with at {} = {start}", task.parameter))
    })?;
    let event = grazing::locate(&family, orbit, start)?;
    let map = &event.map;
    report.say("grazing", json!({ task.parameter.as_str(): event.parameter }));
    report.say("orbit", orbit.itinerary.to_string());
    report.say("wall", event.side().name());
    report.say("t_G", event.phase());
    report.say("a_G", map.acceleration);
    report.say("A", json!(map.a));
    report.say("a1", map.multipliers.trace);
    report.say("a2", map.multipliers.determinant);
    let [first, second] = map.multipliers.values().map(complex);
    report.say("lambda1", first);
    report.say("lambda2", second);
    report.say("region", map.region().map_or("none".into(), |region| format!("{region:?}")));
    report.say("gamma", map.gamma());
    report.say("e", map.e());
    report.say("admissible", yes(event.admissible));
    report.say("residual", event.residual);
    let local = map.to_map()?;
    let graph = Graph::new(&local, task.max_period.into(), false)?;
    let mut rows = Rows::new(&[
        "pattern",
        "side",
        "coefficient",
        "found_at",
        "phases",
        "speeds",
        "lambda1",
        "lambda2",
        "admissible",
        "reason",
    ]);
    let patterns = (1..=task.max_period).flat_map(|period| Patterns::of_period(period.into()));
    for pattern in patterns.filter(Pattern::is_primitive) {
        let verdict = graph.judge(pattern.periods());
        if verdict.side().is_some() || verdict.is_open() {
            rows.push(born(task, &family, &event, &pattern, &verdict)?);
        }
        report.undecided |= verdict.is_open();
    }
    report.rows("born", rows, job)
}

/// A row: what the local theory says of a pattern, and the orbit of the true system at the distance asked for.
fn born(
    task: &GrazingTask,
    family: &SceneFamily,
    event: &Grazing,
    pattern: &Pattern,
    verdict: &Verdict,
) -> Result<[serde_json::Value; 10]> {
    let e = event.map.e();
    let name = pattern.to_string();
    let reason = verdict.reason.map_or(String::new(), |reason| reason.to_string());
    let Some(side) = verdict.side() else {
        let side = match (verdict.plus, verdict.minus) {
            (Existence::NoOrbit, _) => "open for e mu < 0",
            (_, Existence::NoOrbit) => "open for e mu > 0",
            _ => "open",
        };
        let blank = || "".into();
        return Ok([
            name.into(),
            side.into(),
            blank(),
            blank(),
            blank(),
            blank(),
            blank(),
            blank(),
            blank(),
            reason.into(),
        ]);
    };
    let away = if side { task.distance } else { -task.distance } / e;
    let periods: Vec<u64> = pattern.periods().to_vec();
    let leading = event
        .map
        .leading(&periods)
        .map_or("".into(), |leading| number(leading / e.powi(periods.len() as i32)));
    let parameter = event.parameter + away;
    let (itinerary, z) = event.start(family, &periods, verdict, parameter)?;
    let side =
        format!("{} {} {}", task.parameter, if away > 0.0 { '>' } else { '<' }, shown(event.parameter));
    let mut row: Vec<serde_json::Value> = vec![name.into(), side.into(), leading, number(parameter)];
    match find(&family.at(parameter)?, &itinerary, z) {
        Ok(orbit) => {
            let [first, second] = orbit.multipliers.values().map(complex);
            row.extend([
                numbers(orbit.impacts().map(|impact| impact.phase)),
                numbers(orbit.impacts().map(|impact| impact.speed)),
                first,
                second,
                admissible(&orbit.admissibility).into(),
                reason.into(),
            ]);
        }
        Err(error) => {
            row.extend(["", "", "", "", ""].map(Into::into));
            row.push(error.to_string().into());
        }
    }
    row.try_into().map_err(|_| Error::input("a row has ten cells"))
}

/// A parameter value for reading: rounding's leavings at 0 left out.
fn shown(value: f64) -> String {
    if value.abs() < 1e-14 { "0".into() } else { format!("{:.6}", value) }
}
