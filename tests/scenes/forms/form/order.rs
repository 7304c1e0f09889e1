//! The same lists in another order.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, system, tasks};
use crate::forms::scene::{is_machine, stops_key, surfaces, with_names};

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
        with_names(&mut form.scene);
    }
    reverse(&mut form.scene, stops_key(base));
    reverse(&mut form.scene, "friction");
    reverse(system(&mut form.scene), "forcing");
    surfaces(&mut form.scene, &mut |surface| reverse(surface, "harmonics"));
    form.view.own_walls.reverse();
    form.view.own_friction.reverse();
    turned.then_some(form)
}
