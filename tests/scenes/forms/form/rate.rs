//! Harmonics of a multiple, in that multiple of the period.

use toml::{Table, Value};

use super::{Form, Level, is_integrated, system, tasks, units::in_units};
use crate::forms::scene::{What, each_number, is_machine, list, substituted, surfaces, text};

/// Every harmonic twice its number, in twice the period. An oscillator's period is 2π, so that its unit of
/// time becomes twice as long.
pub(super) fn half_rate(base: &Table) -> Option<Form> {
    if base["system"].get("measured").is_some() {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let time = if is_machine(base) { 1.0 } else { 0.5 };
    let mut form = Form { level, ..in_units("harmonics doubled, half the rate", base, [1.0, time, 1.0]) };
    let double = |table: &mut Table| {
        let k: i64 = table.get("k").map_or(1, |k| text(k).parse().expect("a number"));
        table.insert("k".into(), Value::Integer(2 * k));
    };
    let system = system(&mut form.scene);
    list(system, "forcing").for_each(double);
    if let Some(period) = system.get_mut("period") {
        *period = Value::String(format!("2*({})", text(period)));
    }
    if let Some(frequency) = system.get_mut("frequency") {
        *frequency = Value::String(format!("({})/2", text(frequency)));
    }
    surfaces(&mut form.scene, &mut |surface| list(surface, "harmonics").for_each(double));
    each_number(&mut form.scene, &mut |slot| {
        if slot.what == What::Formula {
            *slot.value = Value::String(substituted(&slot.text(), "{}", "{}", "(2*t)"));
        }
    });
    tasks(&mut form.scene).retain(|task| {
        let even =
            |key: &str, default: i64| task.get(key).map_or(default, |n| n.as_integer().unwrap_or(1)) % 2 == 0;
        match task["kind"].as_str() {
            Some("simulate") => {
                even("periods", 10)
                    && even("transient", 0)
                    && task.get("start").is_some_and(|start| start.get("phase").is_none())
            }
            // One impact in an even number of periods.
            Some("orbit") => {
                let orbit = task.get("orbit").and_then(Value::as_table);
                orbit.is_some_and(|orbit| match orbit.get("pattern").and_then(Value::as_array) {
                    Some(all) => all.len() == 1 && all[0].as_integer().is_some_and(|n| n % 2 == 0),
                    None => false,
                })
            }
            _ => false,
        }
    });
    for task in list(&mut form.scene, "tasks") {
        if let Some(orbit) = task.get_mut("orbit").and_then(Value::as_table_mut) {
            let periods = orbit["pattern"][0].as_integer().unwrap_or(2);
            orbit.insert("pattern".into(), vec![Value::Integer(periods / 2)].into());
            if let Some(start) = orbit.get_mut("start").and_then(Value::as_array_mut) {
                let time: f64 = text(&start[0]).parse().expect("a number");
                start[0] = Value::Float(time / 2.0);
            }
            continue;
        }
        let number = |task: &Table, key: &str, default: i64| {
            task.get(key).and_then(Value::as_integer).unwrap_or(default)
        };
        let [periods, transient, samples] =
            [number(task, "periods", 10), number(task, "transient", 0), number(task, "samples", 64)];
        task.insert("periods".into(), Value::Integer(periods / 2));
        task.insert("transient".into(), Value::Integer(transient / 2));
        task.insert("samples".into(), Value::Integer(2 * samples));
    }
    form.view.rounds = 2.0;
    form.without.push("all but simulate and orbits of even periods");
    form.other.extend(["effects", "periods", "period", "pattern", "ended_at", "modes", "speed"]);
    Some(form)
}
