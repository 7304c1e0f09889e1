//! The keys of a system as one formula.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, system, tasks, without_prove};
use crate::forms::scene::{brief, coordinates, has_friction, is_machine, text};

/// The keys of an oscillator as one formula, its first term with `stiffness` in place of q.
fn formula(system: &Table, displacement: &str) -> String {
    let mut all = String::new();
    let mut add = |key: &str, factor: &str| {
        if let Some(value) = system.get(key) {
            all += &format!(" - ({})*{factor}", text(value));
        }
    };
    add("damping", "u");
    add("stiffness", displacement);
    add("cubic", "q^3");
    if let Some(force) = system.get("force") {
        all += &format!(" + {}", text(force));
    }
    let mut harmonics = system.get("forcing").cloned().into_iter().collect::<Vec<_>>();
    for harmonic in harmonics.iter_mut().flat_map(|all| all.as_array_mut().into_iter().flatten()) {
        let k = harmonic.get("k").map_or("1".into(), text);
        for key in ["cos", "sin"] {
            if let Some(value) = harmonic.get(key) {
                all += &format!(" + ({})*{key}({k}*t)", text(value));
            }
        }
    }
    format!("0{all}")
}

fn only_force(form: &mut Form, force: String) {
    let system = system(&mut form.scene);
    system.clear();
    system.insert("force".into(), Value::String(force));
}

pub(super) fn as_formula(base: &Table) -> Option<Form> {
    if is_machine(base) {
        return None;
    }
    let mut form = form("keys as a formula", Level::Exact, base);
    let force = formula(base["system"].as_table()?, "q");
    only_force(&mut form, force);
    without_proofs(&mut form);
    Some(form)
}

fn without_proofs(form: &mut Form) {
    form.without.extend(["validate", "chaos"]);
    tasks(&mut form.scene)
        .retain(|task| !["validate", "chaos"].contains(&task["kind"].as_str().unwrap_or("")));
    without_prove(&mut form.scene);
    form.other.push("proofs");
}

/// The sum of squares of sine and cosine is no linear term.
pub(super) fn hidden(base: &Table) -> Option<Form> {
    let mut form = form("a formula that is not recognised", Level::Integrator, base);
    without_proofs(&mut form);
    form.other.push("range");
    if has_friction(base) && !is_integrated(base) {
        tasks(&mut form.scene).retain(|task| task["kind"].as_str() != Some("branch"));
    }
    if !is_integrated(base) {
        brief(&mut form.scene);
        form.of = Some(form.scene.clone());
    }
    if !is_machine(base) {
        let force = formula(base["system"].as_table()?, "q*(sin(q)^2 + cos(q)^2)");
        only_force(&mut form, force);
        return Some(form);
    }
    if base["system"].get("modes").is_some() {
        return None;
    }
    let n = coordinates(base);
    let zero = "0*q1*(sin(q1)^2 + cos(q1)^2)";
    let system = system(&mut form.scene);
    let known: Vec<String> = match system.get("force") {
        Some(Value::Array(all)) => all.iter().map(text).collect(),
        Some(one) if n == 1 => vec![text(one)],
        _ => vec!["0".into(); n],
    };
    // The stiffness of the first coordinate goes over into the formula, and with one coordinate all of it.
    let stiffness = match (system.get("stiffness"), n) {
        (Some(Value::Array(rows)), _) => text(&rows[0].as_array()?[0]),
        (Some(Value::Table(_)), _) => return None,
        (Some(one), _) => text(one),
        (None, _) => "0".into(),
    };
    let take = |value: &mut Value| *value = Value::Integer(0);
    match system.get_mut("stiffness") {
        Some(Value::Array(rows)) => take(&mut rows[0].as_array_mut()?[0]),
        Some(one) => take(one),
        None => {}
    }
    let forces = known.iter().enumerate().map(|(i, force)| match i {
        0 => format!("{force} - ({stiffness})*q1*(sin(q1)^2 + cos(q1)^2)"),
        _ => format!("{force} + {zero}"),
    });
    let forces = forces.map(Value::String).collect();
    system.insert("force".into(), Value::Array(forces));
    // Nothing says which way a bifurcation of a machine of formulas goes (docs/scenes.md).
    form.other.extend(["modes", "effects", "order_matters", "coefficient", "criticality"]);
    form.other.extend(["measured gap_change", "measured time_change"]);
    Some(form)
}
