//! Runs a task of a scene: one that a view made, or one of the scene's own.

use grazing_scenes::{
    Error, Result,
    num_rational::BigRational,
    run::{Findings, Job, Keeper, RunReport, Surroundings, TaskReport, run_task},
    scene::Scene,
};
use serde_json::{Value, json};

use super::{document::Changeable, request::Request, series::Series};

/// Runs the one task of a scene that the page made.
pub fn run_one(
    changeable: &Changeable,
    values: &[(String, String)],
    task: &str,
    keeper: impl FnOnce(&Job) -> Result<Series>,
) -> Result<(TaskReport, Series)> {
    let text = changeable.with(values, task)?;
    let scene = Scene::from_toml(&text, &changeable.name)?;
    let job = job(&scene, 0, &[])?;
    let mut series = keeper(&job)?;
    let report = run_task(&job, &mut series);
    Ok((report, series))
}

pub fn job<'a>(scene: &'a Scene, index: usize, changes: &'a [(String, BigRational)]) -> Result<Job<'a>> {
    let task = scene.tasks.get(index).ok_or_else(|| Error::input("the scene has no such task"))?;
    Job::new(scene, task, Surroundings { changes, ..Surroundings::default() })
}

/// A report as JSON; why there are no findings is an error.
pub fn finished(report: &TaskReport) -> Result<Value> {
    let value = serde_json::to_value(report).map_err(std::io::Error::other)?;
    match &report.findings {
        Some(_) => Ok(value),
        None => Err(Error::input(value["reason"].as_str().unwrap_or("the task failed").to_string())),
    }
}

/// The numbers and words of one task of the scene as it is; its certificates, if it proved something.
pub fn own_task(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let (text, changes) = changeable.in_place(&request.values())?;
    let scene = Scene::from_toml(&text, &changeable.name)?;
    let name = request.text("task")?;
    let index = scene.tasks.iter().position(|task| task.name == name);
    let index = index.ok_or_else(|| Error::input(format!("the scene has no task {name:?}")))?;
    let job = job(&scene, index, &changes)?;
    let report = run_task(&job, &mut () as &mut dyn Keeper);
    let all = report.findings.iter().flat_map(Findings::certificates);
    let certificates: Vec<Value> =
        all.map(|one| json!({ "file": one.file, "text": one.accepted.text() })).collect();
    let reports = [report];
    Ok(json!({
        "json": RunReport::new(&scene.title, None, &reports).to_json()?,
        "report": reports[0].to_string(),
        "certificates": certificates,
    }))
}
