//! The same scene in other words: parameters with other names, or their values in place of them.

use toml::{Table, Value};

use super::{Form, Level, form, tasks};
use crate::forms::scene::{each_text, list, renamed, text};

pub(super) fn renamed_parameters(base: &Table) -> Option<Form> {
    let mut form = form("parameters renamed", Level::Exact, base);
    let names: Vec<String> = base.get("parameters")?.as_table()?.keys().cloned().collect();
    let new = |name: &str| names.iter().any(|known| known == name).then(|| format!("{name}_of_the_scene"));
    let keys = |table: &mut Table| {
        *table = std::mem::take(table)
            .into_iter()
            .map(|(name, value)| (new(&name).unwrap_or(name), value))
            .collect();
    };
    let mut whole = Value::Table(form.scene);
    each_text(&mut whole, &mut |text| *text = renamed(text, &new));
    let Value::Table(mut scene) = whole else { unreachable!("it was a table") };
    keys(scene["parameters"].as_table_mut()?);
    for task in list(&mut scene, "tasks") {
        for key in ["parameter", "second"] {
            if let Some(name) = task.get(key).and_then(Value::as_str).and_then(new) {
                task.insert(key.into(), Value::String(name));
            }
        }
        for key in ["set", "cell"] {
            if let Some(set) = task.get_mut(key).and_then(Value::as_table_mut) {
                keys(set);
            }
        }
    }
    form.scene = scene;
    form.view.parameters.iter_mut().for_each(|name| *name = format!("{name}_of_the_scene"));
    Some(form)
}

pub(super) fn inlined(base: &Table) -> Option<Form> {
    let mut form = form("parameters inlined", Level::Same, base);
    let values = base.get("parameters")?.as_table()?.clone();
    let whole = |task: &Value| ["parameter", "set", "cell"].iter().all(|key| task.get(key).is_none());
    tasks(&mut form.scene).retain(whole);
    form.scene.remove("parameters");
    let mut scene = Value::Table(form.scene);
    each_text(&mut scene, &mut |known| {
        *known = renamed(known, &|name| Some(format!("({})", text(values.get(name)?))));
    });
    let Value::Table(scene) = scene else { unreachable!("it was a table") };
    form.scene = scene;
    form.without = vec!["parameter"];
    Some(form)
}
