//! Tasks of kind `crisis`: where an attractor ends, by manifolds and by simulation.

use super::{
    Job, Report,
    report::{Rows, number},
};
use crate::{
    error::{Error, Result},
    oscillator::{
        Time,
        attractor::crisis::{Search, crisis},
        flow::State,
        orbit::Family,
        simulate::Simulator,
    },
    scene::{SceneFamily, branches::CrisisTask, phase},
};

pub(super) fn run(task: &CrisisTask, job: &Job, report: &mut Report) -> Result<()> {
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let bracket = (task.bracket[0], task.bracket[1]);
    let orbits = task.orbit.orbits(&family.at((bracket.0 + bracket.1) / 2.0)?)?;
    let saddle = orbits
        .into_iter()
        .find(|orbit| orbit.admissibility.is_admissible() && orbit.multipliers.values()[0].0 > 1.0)
        .ok_or_else(|| Error::input("no saddle of the pattern in the middle of the bracket"))?;
    let mut rows =
        Rows::new(&["offset", "parameter", "corner_q", "corner_u", "corner_gap", "expansion", "distance"]);
    let mut parameter = f64::NAN;
    for &offset in &task.offsets {
        job.interrupt.check()?;
        let search = Search {
            itinerary: &saddle.itinerary,
            start: saddle.z.clone(),
            phase: phase(&task.phase),
            images: task.images,
            offset,
            bracket,
        };
        let found = crisis(&family, &search)?;
        parameter = found.parameter;
        rows.push([
            number(offset),
            number(found.parameter),
            number(found.corner.state.q),
            number(found.corner.state.u),
            number(found.corner.gap),
            number(found.saddle.multipliers.values()[0].0),
            number(found.distance),
        ]);
    }
    report.table("crisis", rows);
    let mut rows = Rows::new(&["parameter", "margin", "periods", "escaped"]);
    for margin in task.margins.iter().flat_map(|margin| [-margin, *margin]) {
        let periods = persistence(task, job, parameter + margin)?;
        rows.push([
            number(parameter + margin),
            number(margin),
            periods.into(),
            (periods < task.periods).into(),
        ]);
    }
    report.table("simulated", rows);
    Ok(())
}

/// For how many periods the motion goes on having impacts.
fn persistence(task: &CrisisTask, job: &Job, parameter: f64) -> Result<u64> {
    let simulator = Simulator::new(&job.scene.plain(&[(&task.parameter, parameter)])?, &job.settings())?;
    let State { t, q, u } = job.scene.state(&task.start)?;
    let mut run = simulator.start(Time::new(0, t), q, u)?;
    let (mut last, mut impacts) = (0, 0);
    for period in 1..=task.periods {
        if period.is_multiple_of(4096) {
            job.interrupt.check()?;
        }
        run.finish(Time::new(period as i64, t));
        if run.impacts() > impacts {
            (last, impacts) = (period, run.impacts());
        }
        if period - last > task.quiet {
            return Ok(last);
        }
    }
    Ok(task.periods)
}
