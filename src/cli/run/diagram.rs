//! Tasks of kind `diagram`: what motions tend to over a parameter.

use std::path::Path;

use super::{
    Job, Report,
    branch::{Drawing, follow},
    report::{Rows, number},
    settings,
};
use crate::{
    cli::progress::Progress,
    error::{Error, Result},
    figure,
    oscillator::{
        attractor::diagram::{self, Look, Plan, Slice},
        branch::Direction,
        orbit::Family,
    },
    scene::{SceneFamily, branches::DiagramTask, phase},
};

pub(super) fn run(task: &DiagramTask, job: &Job, report: &mut Report) -> Result<()> {
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let range = (task.range[0], task.range[1]);
    let part = |i: u32| f64::from(i) / f64::from(task.count - 1);
    let plan = Plan {
        values: (0..task.count).map(|i| range.0 + part(i) * (range.1 - range.0)).collect(),
        starts: task.starts.iter().map(|start| job.scene.state(start)).collect::<Result<_>>()?,
        look: Look {
            phase: phase(&task.phase),
            transient: task.transient,
            points: task.points,
            longest: task.longest,
        },
        every: task.every,
        settings: settings(&job.scene),
    };
    let file = job.folder.join(format!("{}.checkpoint.json", job.task.name));
    if !task.resume && file.exists() {
        remove(&file)?;
    }
    let progress = Progress::new(job.interrupt, u64::from(task.count), "values");
    let system = |value| job.scene.plain(&[(&task.parameter, value)]);
    let identity = format!("{:?} {:?} {}", job.scene.system, job.scene.parameters, task.parameter);
    let slices = diagram::sweep(&plan, system, &identity, Some(&file), &progress)?;

    let drawing = Drawing { family: &family, phase: plan.look.phase, frame: task.frame };
    let branches = follow(&task.branches, &family, range, Direction::Both, &task.options, job)?;
    let curves = branches.iter().map(|branch| drawing.curve(branch)).collect::<Result<Vec<_>>>()?;
    figure::branches(
        &curves,
        &scatter(&slices, &drawing)?,
        [&task.parameter, drawing.axis()],
        job.folder,
        &job.task.name,
    )?;

    let mut rows = Rows::new(&["from", "to", "period", "impacts", "values"]);
    for window in diagram::windows(&slices) {
        rows.push([
            number(window.from),
            number(window.to),
            window.period.into(),
            window.impacts.into(),
            window.values.into(),
        ]);
    }
    report.table("windows", rows);
    let mut rows = Rows::new(&["value", "attractors", "lost"]);
    for slice in slices.iter().filter(|slice| slice.motions.len() > 1 || slice.lost > 0) {
        let name = |motion: &diagram::Motion| match motion.period {
            Some(period) => format!("period {period} with {} impacts", motion.impacts),
            None => "not periodic".to_string(),
        };
        let names: Vec<String> = slice.motions.iter().map(name).collect();
        rows.push([number(slice.value), names.join("; ").into(), slice.lost.into()]);
    }
    report.table("coexisting", rows);
    report.say("files", ["svg", "csv"].map(|end| format!("{}.{end}", job.task.name)).to_vec());
    // A finished diagram needs none, and the next may have other settings.
    remove(&file)
}

fn remove(file: &Path) -> Result<()> {
    std::fs::remove_file(file).map_err(|error| Error::io("remove", file, error))
}

fn scatter(slices: &[Slice], drawing: &Drawing) -> Result<Vec<figure::Scatter>> {
    let mut sets = Vec::new();
    for slice in slices {
        let oscillator = drawing.family.at(slice.value)?;
        for motion in &slice.motions {
            let name = match motion.period {
                Some(period) => format!("period {period} with {} impacts", motion.impacts),
                None => "attractor, not periodic".to_string(),
            };
            let at = |&[q, _]: &[f64; 2]| (slice.value, drawing.displacement(&oscillator, q));
            sets.push(figure::Scatter { name, at: motion.points.iter().map(at).collect() });
        }
    }
    Ok(sets)
}
