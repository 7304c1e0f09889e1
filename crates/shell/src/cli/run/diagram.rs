//! The files of tasks of kind `diagram`.

use super::{
    Job,
    branch::{Drawing, curve},
    validate::proofs,
};
use crate::{
    continuation::{BranchPoint, Direction},
    error::Result,
    figure,
    many::{Family as _, orbit::Orbit},
    one::orbit::Family as _,
    run::{DiagramFindings, MachineSource, OrbitSource, OscillatorSource, follow},
    scene::{MachineSceneFamily, SceneFamily, branches::DiagramTask, phase},
};

pub(super) fn keep(found: &DiagramFindings, task: &DiagramTask, job: &Job) -> Result<Vec<String>> {
    let across = job.axis(&task.parameter);
    if let Some([drawn, _]) = &found.plane {
        let axes = [across.name.as_str(), drawn];
        let mut sets = scatter(found, |_| Ok(Box::new(|q| q)))?;
        let mut curves = machine_curves(task, job)?;
        across.convert(&mut curves, &mut sets);
        figure::branches(&curves, &sets, axes, &job.place())?;
        return Ok(job.figure().into_iter().chain(tables(found, job)?).collect());
    }
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let range = task.bounds();
    let drawing = Drawing { family: &family, phase: phase(&task.phase), frame: task.frame };
    let source = OscillatorSource::new(&family, job)?;
    let (branches, _) = follow(
        &task.branches,
        (&source, &[]),
        (&task.parameter, range),
        Direction::Both,
        &task.options,
        job,
    )?;
    let mut curves = branches.iter().map(|branch| drawing.curve(branch)).collect::<Result<Vec<_>>>()?;
    let height = |value: f64| -> Result<Height> {
        let oscillator = drawing.family.at(value)?;
        let drawing = &drawing;
        Ok(Box::new(move |q| drawing.displacement(&oscillator, q)))
    };
    let mut sets = scatter(found, height)?;
    across.convert(&mut curves, &mut sets);
    figure::branches(&curves, &sets, [&across.name, drawing.axis()], &job.place())?;
    Ok(job.figure().into_iter().chain(tables(found, job)?).collect())
}

fn tables(found: &DiagramFindings, job: &Job) -> Result<Vec<String>> {
    let mut files = match &found.sweep {
        Some(sweep) => vec![job.csv(&sweep.windows, "-windows.csv")?, job.csv(&sweep.jumps, "-jumps.csv")?],
        None => vec![job.csv(&found.windows, "-windows.csv")?],
    };
    if let Some(bands) = &found.bands {
        files.push(job.csv(bands, "-bands.csv")?);
    }
    files.extend(proofs(found.proofs.as_ref(), job)?);
    Ok(files)
}

/// The branches of a machine, seen on the first axis of the plane.
fn machine_curves(task: &DiagramTask, job: &Job) -> Result<Vec<figure::DrawnBranch>> {
    if task.branches.is_empty() {
        return Ok(Vec::new());
    }
    let (machine, family) = (job.scene.machine(&[])?, MachineSceneFamily::new(&job.scene, &task.parameter)?);
    let source = MachineSource::new(&family, &machine, job)?;
    let (branches, _) = follow(
        &task.branches,
        (&source, &[]),
        (&task.parameter, task.bounds()),
        Direction::Both,
        &task.options,
        job,
    )?;
    let at = phase(&task.phase);
    let drawn = |point: &BranchPoint<Orbit>| {
        let parameter = point.parameters[0];
        let state = source.patterns.state(parameter, &point.orbit, at)?;
        let planar = job.planar(&family.at(parameter)?.0, &[], &task.plane)?;
        Ok(planar.point(&state).at[0])
    };
    branches.iter().map(|branch| curve(branch, &source.named(&branch.itinerary), &drawn)).collect()
}

/// What is drawn of the first number of a point.
type Height<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

fn scatter<'a>(
    found: &DiagramFindings,
    height: impl Fn(f64) -> Result<Height<'a>>,
) -> Result<Vec<figure::Scatter>> {
    let mut sets = Vec::new();
    for (i, slice) in found.slices.iter().enumerate() {
        let up = found.sweep.as_ref().map(|_| i < found.upwards);
        let way = match up {
            None => "",
            Some(true) => "up: ",
            Some(false) => "down: ",
        };
        let height = height(slice.value)?;
        for motion in &slice.motions {
            let name = match motion.period {
                Some(period) => format!("period {period} with {} impacts", motion.impacts),
                None if motion.undecided => "not settled".to_string(),
                None => "attractor, not periodic".to_string(),
            };
            let at = |&[q, _]: &[f64; 2]| (slice.value, height(q));
            let name = format!("{way}{name}");
            sets.push(figure::Scatter { name, up, at: motion.points.iter().map(at).collect() });
        }
    }
    Ok(sets)
}
