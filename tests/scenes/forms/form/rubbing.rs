//! Dry friction and contact in other keys.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, tasks};
use crate::forms::scene::{has_friction, list, stops, text, with_rows};

/// By what a row of friction is multiplied: its sign is a choice, and so is its length.
const FACTOR: f64 = -2.0;

/// Along −2w velocities are −2 times as large, and a coefficient of half is the same force.
pub(super) fn turned_rows(base: &Table) -> Option<Form> {
    if !has_friction(base) {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("rows of friction turned", level, base);
    with_rows(&mut form.scene);
    for friction in list(&mut form.scene, "friction") {
        let scale = |table: &mut Table, key: &str, factor: f64| match table.get_mut(key) {
            Some(Value::Array(all)) => {
                all.iter_mut().for_each(|x| *x = Value::String(format!("({factor})*({})", text(x))));
            }
            Some(one) => *one = Value::String(format!("({factor})*({})", text(one))),
            None => {}
        };
        scale(friction, "row", FACTOR);
        scale(friction, "speed", FACTOR);
        for harmonic in list(friction, "harmonics") {
            scale(harmonic, "cos", FACTOR);
            scale(harmonic, "sin", FACTOR);
        }
        scale(friction, "coefficient", 1.0 / FACTOR.abs());
        scale(friction, "static_coefficient", 1.0 / FACTOR.abs());
    }
    form.view.rubbing = FACTOR.abs();
    Some(form)
}

/// The keys of stops that give way as formulas of depth and speed.
pub(super) fn laws(base: &Table) -> Option<Form> {
    let mut form = form("compliant stops by laws", Level::Integrator, base);
    // Friction does not go with laws.
    if list(&mut form.scene, "friction").any(|friction| friction.contains_key("stop")) {
        return None;
    }
    let mut any = false;
    for stop in stops(&mut form.scene) {
        let Some(stiffness) = stop.remove("stiffness") else { continue };
        let damping = stop.remove("damping").map_or("0".into(), |damping| text(&damping));
        stop.insert("law".into(), Value::String(format!("({})*d + ({damping})*v", text(&stiffness))));
        any = true;
    }
    any.then_some(())?;
    // A law is a kink: only motions are followed.
    let taken = ["simulate", "section", "diagram", "basins", "response"];
    tasks(&mut form.scene).retain(|task| taken.contains(&task["kind"].as_str().unwrap_or("")));
    form.without.push("all but motions");
    Some(form)
}
