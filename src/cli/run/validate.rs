//! Tasks of kind `validate`: orbits and bifurcations proved, from approximations found as the tasks `orbit` and `event` do.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde_json::Value;

use super::{
    Job, Report,
    report::{Rows, number},
};
use crate::{
    error::{Error, Result},
    number::{Ball, Precision, Real, certain_digits},
    oscillator::{
        branch::critical,
        grazing,
        orbit::{Family, Itinerary, Orbit, Oscillator},
        validate::{self, Condition, Impact, Jet, Stability, Verdict},
    },
    output::write_file,
    scene::{SceneFamily, orbits::Event, validate::ValidateTask},
};

/// The most digits shown of an enclosed number.
const DIGITS: u32 = 20;

pub(super) fn run(task: &ValidateTask, job: &Job, report: &mut Report) -> Result<()> {
    match (task.event, &task.parameter) {
        (Some(event), Some(parameter)) => events(task, event, parameter, job, report),
        _ => orbits(task, job, report),
    }
}

/// Proves each orbit that is found and writes its certificate.
fn orbits(task: &ValidateTask, job: &Job, report: &mut Report) -> Result<()> {
    let precision = Precision::new(task.bits);
    let mut rows = Rows::new(&[
        "verdict",
        "pattern",
        "phases",
        "speeds",
        "only_within",
        "trace",
        "det",
        "stable",
        "certificate",
    ]);
    let system = job.scene.exact(&[])?;
    let oscillator = Oscillator::new(job.system.clone(), job.scene.accuracy.tolerance)?;
    for orbit in task.orbit.orbits(&oscillator)? {
        job.interrupt.check()?;
        let pattern = Value::from(orbit.itinerary.to_string());
        let proof = match validate::orbit(&system, &impacts(&orbit.itinerary, &orbit.z), &precision)? {
            Verdict::Proved(proof) => proof,
            failed => {
                report.undecided |= matches!(failed, Verdict::Undecided(_));
                report.refuted |= matches!(failed, Verdict::Refuted(_));
                let none = || Value::from("");
                rows.push([why(&failed), pattern, none(), none(), none(), none(), none(), none(), none()]);
                continue;
            }
        };
        let certificate = match validate::certificate(&system, &proof) {
            Ok(text) => {
                let file = format!("{}-{}.certificate", job.task.name, rows.len() + 1);
                write_file(&job.folder.join(&file), |out| Ok(out.write_all(text.as_bytes())?))?;
                file
            }
            Err(error) => format!("none: {error}"),
        };
        rows.push([
            "proved".into(),
            pattern,
            all(&proof.phases),
            all(&proof.velocities),
            number(proof.radius.to_f64().unwrap_or(f64::NAN)),
            digits(&proof.trace),
            digits(&proof.determinant),
            match proof.stability {
                Some(Stability::Stable) => "yes",
                Some(Stability::Unstable) => "no",
                None => "undecided",
            }
            .into(),
            certificate.into(),
        ]);
    }
    report.undecided |= rows.is_empty();
    report.rows("orbits", rows, job)
}

/// Proves the event near each approximate one.
fn events(task: &ValidateTask, event: Event, name: &str, job: &Job, report: &mut Report) -> Result<()> {
    let precision = Precision::new(task.bits);
    let family = SceneFamily::new(&job.scene, name)?;
    let start = family.value();
    let exact = |parameter: &Jet| {
        let values = job.scene.parameters.iter().map(|(other, value)| {
            if other == name { parameter.clone() } else { Jet::ratio(value, &precision) }
        });
        let values: Vec<Jet> = values.collect();
        job.scene.system.try_map(|expression| expression.evaluate(&values, &precision))
    };
    report.say("event", event.word());
    let mut rows =
        Rows::new(&["verdict", "parameter", "width", "pattern", "phases", "speeds", "only_within"]);
    let mut found: Vec<BigRational> = Vec::new();
    let orbits = task.orbit.orbits(&family.at(start)?)?;
    for orbit in orbits.iter().filter(|orbit| orbit.admissibility.is_admissible()) {
        job.interrupt.check()?;
        let Ok((guess, parameter, condition)) = approximate(&family, event, orbit, start, task.reach) else {
            continue;
        };
        let pattern = Value::from(orbit.itinerary.to_string());
        match validate::event(exact, &guess, parameter, condition, &precision)? {
            Verdict::Proved(proof) => {
                let Some((lo, hi)) = proof.parameter.exact_bounds() else { continue };
                // The same event from another orbit of its branch.
                if found.iter().any(|other| lo <= *other && *other <= hi) {
                    continue;
                }
                rows.push([
                    "proved".into(),
                    digits(&proof.parameter),
                    number((&hi - &lo).to_f64().unwrap_or(f64::NAN)),
                    pattern,
                    all(&proof.phases),
                    all(&proof.velocities),
                    number(proof.radius.to_f64().unwrap_or(f64::NAN)),
                ]);
                found.push((lo + hi) / BigRational::from_integer(2.into()));
            }
            failed => {
                report.undecided |= matches!(failed, Verdict::Undecided(_));
                report.refuted |= matches!(failed, Verdict::Refuted(_));
                let none = || Value::from("");
                rows.push([why(&failed), number(parameter), none(), pattern, none(), none(), none()]);
            }
        }
    }
    report.undecided |= rows.is_empty();
    report.rows("events", rows, job)
}

/// Impacts, parameter and condition near which the event is expected.
fn approximate(
    family: &SceneFamily,
    event: Event,
    orbit: &Orbit,
    start: f64,
    reach: f64,
) -> Result<(Vec<Impact>, f64, Condition)> {
    let Some(kind) = event.bifurcation() else {
        let found = grazing::locate(family, orbit, start)?;
        // The tangency is the first of its impacts: what comes before it flies on to what comes after.
        let mut all = impacts(&found.itinerary, &found.z);
        let touch = all.remove(0);
        let last = all.last_mut().ok_or_else(|| Error::input("the orbit that grazes has no impact"))?;
        let time = TAU * f64::from(last.periods) + touch.phase - last.phase;
        last.periods += touch.periods;
        let after = all.len() - 1;
        return Ok((all, found.parameter, Condition::Grazing { after, side: touch.side, time }));
    };
    let found = critical::locate(family, kind, orbit, start, reach)?;
    let condition = match kind {
        critical::Bifurcation::SaddleNode => Condition::SaddleNode,
        critical::Bifurcation::Flip => Condition::Flip,
    };
    Ok((impacts(&found.orbit.itinerary, &found.orbit.z), found.parameter, condition))
}

/// The impacts of a solution t_1, V_1, …, t_m, V_m of the pattern equations.
fn impacts(itinerary: &Itinerary, z: &[f64]) -> Vec<Impact> {
    let strikes = itinerary.strikes().iter().zip(z.chunks(2));
    strikes
        .map(|(strike, z)| Impact { side: strike.side, periods: strike.periods, phase: z[0], velocity: z[1] })
        .collect()
}

fn why<T>(verdict: &Verdict<T>) -> Value {
    match verdict {
        Verdict::Proved(_) => "proved".into(),
        Verdict::Refuted(why) => format!("refuted: {why}").into(),
        Verdict::Undecided(why) => format!("undecided: {why}").into(),
    }
}

/// The certain digits of an enclosed number.
fn digits(x: &Ball) -> Value {
    let text = x.exact_bounds().and_then(|(lo, hi)| certain_digits(&lo, &hi, DIGITS));
    text.unwrap_or_else(|| "?".into()).into()
}

fn all(values: &[Ball]) -> Value {
    values.iter().map(digits).collect::<Vec<_>>().into()
}
