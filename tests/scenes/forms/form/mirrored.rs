//! Displacements with the other sign.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated};
use crate::forms::scene::{What, each_number, is_machine, list, substituted, with_rows};

pub(super) fn mirrored(base: &Table) -> Option<Form> {
    let mut form = form("mirrored", Level::Exact, base);
    let machine = is_machine(base);
    if machine {
        with_rows(&mut form.scene);
    }
    each_number(&mut form.scene, &mut |mut slot| match slot.what {
        What::Force | What::Start => slot.scale(-1.0),
        What::Place if !machine => slot.scale(-1.0),
        What::Row => slot.scale(-1.0),
        What::Formula => {
            let inner = substituted(&slot.text(), "(-{})", "(-{})", "t");
            *slot.value = Value::String(format!("-({inner})"));
        }
        _ => {}
    });
    for task in list(&mut form.scene, "tasks").filter(|task| task["kind"].as_str() == Some("basins")) {
        for key in ["q", "u"] {
            let values = task[key].as_table_mut()?;
            let [from, to] = ["from", "to"].map(|key| values[key].clone());
            values.insert("from".into(), to);
            values.insert("to".into(), from);
        }
    }
    if !machine {
        let mut whole = Value::Table(form.scene);
        swap_sides(&mut whole);
        let Value::Table(scene) = whole else { unreachable!("it was a table") };
        form.scene = scene;
        form.view.own_walls.iter_mut().chain(&mut form.view.walls).for_each(|side| *side = other_side(side));
    }
    form.view.mirrored = true;
    // Response of a machine is by amplitude and phase, whose half turn is rounded.
    form.level = if machine { Level::Rounding } else { Level::Exact };
    if machine && is_integrated(base) {
        form.level = Level::Integrator;
    }
    // The first start that leads to an attractor is another, and the first point that is shown of it.
    form.rounded = &["basins", "orbit", "event", "branch", "grazing", "validate"];
    form.other.extend(["basins.q", "basins.u"]);
    form.other.push("coefficient");
    Some(form)
}

fn other_side(side: &str) -> String {
    match side {
        "lower" => "upper".into(),
        "upper" => "lower".into(),
        other => other.into(),
    }
}

fn swap_sides(value: &mut Value) {
    match value {
        Value::String(text) => *text = other_side(text),
        Value::Array(all) => all.iter_mut().for_each(swap_sides),
        Value::Table(table) => table.iter_mut().for_each(|(_, value)| swap_sides(value)),
        _ => {}
    }
}
