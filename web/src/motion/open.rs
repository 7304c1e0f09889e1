//! What a scene is that was opened: its sliders and tasks, and what its own tasks look at.

use grazing_scenes::{
    Result,
    motion::Contact,
    scene::{Body, Kind, Scene},
};
use serde_json::{Value, json};

use super::{document::Parameter, request::Request};

pub fn open(request: &Request) -> Result<Value> {
    let mut changeable = request.scene()?;
    changeable.keep_ranges_apart_from_errors();
    let scene = &changeable.scene;
    let parameters: Vec<Value> = changeable.parameters.iter().map(described).collect();
    let tasks: Vec<Value> = scene
        .tasks
        .iter()
        .map(|task| json!({ "name": task.name, "kind": task.kind.word(), "group": task.group }))
        .collect();
    let (walls, coordinates) = match &scene.body {
        Body::Oscillator(_) => {
            let walls = Contact::of(&scene.rounded()?)?;
            (walls.iter().map(|wall| wall.side.name().to_string()).collect(), 0)
        }
        Body::Machine(_) => {
            let machine = scene.machine(&[])?;
            (machine.stops.iter().map(|stop| stop.name.clone()).collect::<Vec<_>>(), machine.points())
        }
        _ => (Vec::new(), 0),
    };
    Ok(json!({
        "title": scene.title,
        "parameters": parameters,
        "tasks": tasks,
        "walls": walls,
        "machine": coordinates > 0,
        "coordinates": coordinates,
        "parameter": varied(scene),
        "start": match start_of(&changeable.text) {
            Some(start) => start,
            None => start_apart(scene)?,
        },
        "phase": raw(&changeable.text, "phase"),
        "frame": raw(&changeable.text, "frame"),
        "plane": plane_of(scene),
    }))
}

fn described(parameter: &Parameter) -> Value {
    json!({
        "name": parameter.name,
        "value": parameter.value,
        "unit": parameter.unit,
        "about": parameter.about,
        "range": parameter.range,
        "named_here": parameter.place.is_some(),
    })
}

/// The parameter that the scene's own tasks vary first.
fn varied(scene: &Scene) -> Option<String> {
    let of = |kind: &Kind| match kind {
        Kind::GrazingTask(task) => Some(task.parameter.clone()),
        Kind::DiagramTask(task) => Some(task.parameter.clone()),
        Kind::BranchTask(task) => Some(task.parameter.clone()),
        Kind::EventTask(task) => Some(task.parameter.clone()),
        Kind::MapTask(task) => Some(task.parameter.clone()),
        _ => None,
    };
    scene.tasks.iter().find_map(|task| of(&task.kind))
}

/// The plane of the scene's first section of a machine.
fn plane_of(scene: &Scene) -> Option<Vec<String>> {
    let of = |kind: &Kind| match kind {
        Kind::SectionTask(task) => Some(task.plane.clone()),
        Kind::DiagramTask(task) => Some(task.plane.clone()),
        _ => None,
    };
    scene.tasks.iter().filter_map(|task| of(&task.kind)).find(|plane| plane.len() == 2)
}

/// The tasks of a scene's text.
fn tasks_of(text: &str) -> Vec<toml_edit::Item> {
    let Ok(document) = toml_edit::Document::parse(text) else { return Vec::new() };
    let tasks = document.as_item().get("tasks");
    (0..).map_while(|i| tasks.and_then(|tasks| tasks.get(i)).cloned()).collect()
}

/// Text without its quotes, or another value as it is written.
fn plain(item: &toml_edit::Item) -> String {
    item.as_str().map_or_else(|| item.to_string().trim().to_string(), ToString::to_string)
}

/// The value of a key of the scene's first section or diagram, as text.
fn raw(text: &str, key: &str) -> Option<String> {
    tasks_of(text).iter().find_map(|task| {
        let kind = task.get("kind")?.as_str()?;
        let found = task.get(key)?;
        ["section", "diagram"].contains(&kind).then(|| plain(found))
    })
}

/// Where the scene's first motion starts: phase, q and u as texts.
fn start_of(text: &str) -> Option<Value> {
    let tasks = tasks_of(text);
    let start = tasks.iter().find_map(|task| task.get("start").or_else(|| task.get("starts")?.get(0)))?;
    let part = |key: &str| start.get(key).map(plain);
    Some(json!({
        "phase": part("phase").unwrap_or_else(|| "0".into()),
        "q": part("q")?,
        "u": part("u").unwrap_or_else(|| "0".into()),
    }))
}

/// A state at rest that is behind no wall of an oscillator: q = 0 if it is not.
fn start_apart(scene: &Scene) -> Result<Value> {
    let mut q = 0.0f64;
    if let Body::Oscillator(_) = scene.body {
        let walls = Contact::of(&scene.rounded()?)?;
        let at = |sign: f64| {
            walls.iter().find(|wall| wall.side.sign() == sign).map(|wall| wall.position.at(0.0)[0])
        };
        q = match (at(1.0), at(-1.0)) {
            (Some(low), Some(high)) if q < low || q > high => (low + high) / 2.0,
            (Some(low), None) if q < low => low + 1.0,
            (None, Some(high)) if q > high => high - 1.0,
            _ => q,
        };
    }
    Ok(json!({ "phase": "0", "q": format!("{q:?}"), "u": "0" }))
}
