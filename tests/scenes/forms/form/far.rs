//! A stop that is never met.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, tasks};
use crate::forms::{
    report::FAR,
    scene::{coordinates, is_machine, list, stops_key},
};

/// Patterns name their walls where there are several.
fn name_walls(scene: &mut Table, key: &str, name: &str) {
    let fill = |keys: &mut Table| {
        let count = keys.get("pattern").and_then(Value::as_array).map_or(0, Vec::len);
        if count > 0 && !keys.contains_key(key) {
            keys.insert(key.into(), Value::Array(vec![Value::String(name.into()); count]));
        }
    };
    for task in list(scene, "tasks") {
        for start in list(task, "starts") {
            start.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(fill);
        }
        for branch in list(task, "branches") {
            branch.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(fill);
        }
        list(task, "orbits").for_each(fill);
        if task["kind"].as_str() == Some("chaos") {
            task.entry("side").or_insert(Value::String(name.into()));
        }
        task.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(fill);
    }
}

pub(super) fn far_stop(base: &Table) -> Option<Form> {
    let mut form = form("a stop that is never met", Level::Rounding, base);
    if is_integrated(base) {
        form.level = Level::Integrator;
    }
    let mut wall = Table::new();
    let own = &form.view.own_walls;
    let only = (own.len() == 1).then(|| own[0].clone());
    if is_machine(base) {
        let taken = |name: &String| own.contains(name);
        let name = ["guard", "buffer"].map(String::from).into_iter().find(|name| !taken(name))?;
        let row = (0..coordinates(base)).map(|i| Value::Integer(i64::from(i == 0))).collect();
        wall.insert("name".into(), Value::String(name.clone()));
        wall.insert("row".into(), Value::Array(row));
        wall.insert("offset".into(), Value::Float(-FAR));
        form.view.far = Some(name);
    } else {
        let side = match own.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            [] | ["upper"] => "lower",
            ["lower"] => "upper",
            _ => return None,
        };
        wall.insert("side".into(), Value::String(side.into()));
        wall.insert("offset".into(), Value::Float(if side == "lower" { -FAR } else { FAR }));
        form.view.far = Some(side.into());
    }
    wall.insert("restitution".into(), Value::Float(0.5));
    form.view.own_walls.extend(form.view.far.clone());
    form.scene
        .entry(stops_key(base))
        .or_insert(Value::Array(Vec::new()))
        .as_array_mut()?
        .push(Value::Table(wall));
    if let Some(name) = only {
        name_walls(&mut form.scene, if is_machine(base) { "stops" } else { "walls" }, &name);
    }
    // Of a proof for all values of a parameter some reach it.
    let endless = |task: &Value| task.get("parameter").is_some() && task.get("to").is_none();
    tasks(&mut form.scene).retain(|task| task["kind"].as_str() != Some("chaos") || !endless(task));
    // What is said of a second wall of a proof is said of this one.
    form.other.extend(["effects", "largest_gap", "ceiling"]);
    Some(form)
}
