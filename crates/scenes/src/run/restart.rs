//! Restarts of branches at points of files written before, along the same parameters or others.

use num_rational::BigRational;

use super::{
    Job,
    engine::{Engine, OrbitSource},
    row,
};
use crate::{
    continuation::{Label, PatternOf},
    error::{Error, Result},
    number::{Plain, Real},
    output::{LONGEST_INPUT, read_text},
    scene::{
        Scene,
        branches::{BranchTask, Restart},
    },
};

row! {
    /// A parameter that keeps its value at the point of a restart.
    pub struct FixedRow {
        /// Its name.
        pub name: String,
        /// Its value, in the scene's unit.
        pub value: f64,
    }
}

/// The values as a scene takes them.
pub(super) fn exact(fixed: &[FixedRow]) -> Vec<(String, BigRational)> {
    fixed.iter().filter_map(|row| Some((row.name.clone(), BigRational::from_float(row.value)?))).collect()
}

/// The point of a restart.
fn read<S: OrbitSource>(restart: &Restart, source: &S, job: &Job) -> Result<Label<PatternOf<S::Orbit>>> {
    let folder = job.folder.ok_or_else(|| Error::input("a restart needs the folder of its branch's file"))?;
    let file = folder.join(&restart.file);
    let text = read_text(&file, LONGEST_INPUT)?;
    source.label(&text, &restart.label).map_err(|error| error.context(file.display()))
}

/// The scene's own value of a parameter.
fn own(scene: &Scene, name: &str) -> Result<f64> {
    Ok(Plain::ratio(&scene.parameters[scene.parameter(name)?].1, &()).0)
}

/// What a label has of parameters that do not vary, where these are not the scene's values.
fn others<P>(label: &Label<P>, varied: &[&str], scene: &Scene) -> Result<Vec<FixedRow>> {
    let mut found = Vec::new();
    for (name, &value) in label.names.iter().zip(&label.parameters) {
        if !varied.contains(&name.as_str()) && own(scene, name)? != value {
            found.push(FixedRow { name: name.clone(), value });
        }
    }
    Ok(found)
}

/// The parameters that a task's first restart sets, for all of it: those that the branch before went along,
/// and this one does not.
///
/// # Errors
/// Those of the file.
pub(super) fn fixed<E: Engine>(task: &BranchTask, job: &Job, engine: &E) -> Result<Vec<FixedRow>> {
    let restart = task.starts.iter().find_map(|start| start.restart.as_ref());
    let Some(restart) = restart else { return Ok(Vec::new()) };
    let varied: Vec<&str> = [&task.parameter].into_iter().chain(&task.second).map(String::as_str).collect();
    let family = engine.family(&task.parameter)?;
    others(&read(restart, &engine.source(&family)?, job)?, &varied, &job.scene)
}

/// The point of a restart over the parameters of these names.
///
/// # Errors
/// Those of the file; an input error where it is at another value of a parameter that does not vary.
pub(super) fn restarted<S: OrbitSource>(
    restart: &Restart,
    varied: &[&str],
    source: &S,
    job: &Job,
) -> Result<Label<PatternOf<S::Orbit>>> {
    let label = read(restart, source, job)?;
    match others(&label, varied, &job.scene)?.first() {
        None => label.over(varied, |name| own(&job.scene, name)),
        Some(FixedRow { name, value }) => {
            Err(Error::input(format!("the restart is at {name} = {value}, and the task is not")))
        }
    }
}

/// That no bifurcation is where a restart is.
pub(super) fn no_event(Restart { file, label, .. }: &Restart) -> Error {
    Error::input(format!(
        "{label} of {file} is no bifurcation of codimension one, which is what is asked for"
    ))
}
