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
        /// That unit, if the scene has units.
        pub unit: Option<String>,
    }
}

/// The values as a scene takes them.
pub(super) fn exact(fixed: &[FixedRow]) -> Vec<(String, BigRational)> {
    let exact = |row: &FixedRow| Some((row.name.clone(), BigRational::from_float(row.value)?));
    fixed.iter().filter_map(exact).collect()
}

/// The point of a restart.
fn read<S: OrbitSource>(restart: &Restart, source: &S, job: &Job) -> Result<Label<PatternOf<S::Orbit>>> {
    let folder = job.folder.ok_or_else(|| Error::input("a restart needs the folder of its branch's file"))?;
    let file = folder.join(&restart.file);
    let text = read_text(&file, LONGEST_INPUT)?;
    source.label(&text, restart.point()?).map_err(|error| error.context(file.display()))
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
            let unit = scene.unit(name).map(|unit| unit.own.clone());
            found.push(FixedRow { name: name.clone(), value, unit });
        }
    }
    Ok(found)
}

/// The parameters that a task's restarts set: those that the branches before went along, and this one does
/// not.
///
/// # Errors
/// Those of the files; an input error where starts are at different values of such a parameter, or where the
/// task sets it.
pub(super) fn fixed<E: Engine>(task: &BranchTask, job: &Job, engine: &E) -> Result<Vec<FixedRow>> {
    if task.starts.iter().all(|start| start.restart.is_none()) {
        return Ok(Vec::new());
    }
    let varied: Vec<&str> = [&task.parameter].into_iter().chain(&task.second).map(String::as_str).collect();
    let family = engine.family(&task.parameter)?;
    let source = engine.source(&family)?;
    let mut found: Option<Vec<FixedRow>> = None;
    for start in &task.starts {
        let here = match &start.restart {
            Some(restart) => others(&read(restart, &source, job)?, &varied, &job.scene)?,
            None => Vec::new(),
        };
        if let Some(FixedRow { name, value, .. }) =
            here.iter().find(|row| job.task.set.iter().any(|(name, _)| *name == row.name))
        {
            return Err(Error::input(format!(
                "the restart is at {name} = {value}, and the task sets {name}: leave that out"
            )));
        }
        if *found.get_or_insert_with(|| here.clone()) != here {
            return Err(Error::input(
                "starts are at different values of a parameter that does not vary here: give each a task",
            ));
        }
    }
    Ok(found.unwrap_or_default())
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
    if let Some(FixedRow { name, value, .. }) = others(&label, varied, &job.scene)?.first() {
        let here = own(&job.scene, name)?;
        return Err(Error::input(format!("the restart is at {name} = {value}, and this task at {here}")));
    }
    label.over(varied, |name| own(&job.scene, name))
}

/// That no bifurcation is where a restart is.
pub(super) fn no_event(restart: &Restart, so: &str) -> Error {
    let point = restart.point().map_or_else(|_| String::new(), |point| point.to_string());
    Error::input(format!("{point} of {} is no bifurcation of codimension one: {so} there", restart.file))
}
