//! The same lists in another order.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, system, tasks};
use crate::forms::scene::{is_machine, list};

pub(super) fn reversed_tasks(base: &Table) -> Option<Form> {
    let mut form = form("order of tasks", Level::Same, base);
    tasks(&mut form.scene).reverse();
    Some(form)
}

pub(super) fn reversed_lists(base: &Table) -> Option<Form> {
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("order of stops and harmonics", level, base);
    let mut turned = false;
    let mut reverse = |table: &mut Table, key: &str| {
        if let Some(all) = table.get_mut(key).and_then(Value::as_array_mut) {
            turned |= all.len() > 1;
            all.reverse();
        }
    };
    // Names that are places in the list stay with their stops.
    if is_machine(base) {
        for (i, wall) in (1..).zip(list(&mut form.scene, "walls")) {
            wall.entry("name").or_insert(Value::String(format!("{i}")));
        }
    }
    reverse(&mut form.scene, "walls");
    reverse(system(&mut form.scene), "forcing");
    list(&mut form.scene, "walls").for_each(|wall| reverse(wall, "harmonics"));
    form.view.own_walls.reverse();
    turned.then_some(form)
}
