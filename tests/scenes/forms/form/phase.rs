//! Time counted from another phase.

use std::f64::consts::TAU;

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, system};
use crate::forms::scene::{What, each_number, is_machine, list, substituted, surfaces, text};

/// A phase less a part of a period, as a fraction from 0.
fn less(value: Option<&Value>, shift: f64) -> Value {
    let phase = value.map_or(0.0, |value| {
        let text = text(value);
        let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
        above.parse::<f64>().expect("a number") / below.parse::<f64>().expect("a number")
    });
    Value::Float((phase - shift).rem_euclid(1.0))
}

pub(super) fn shifted(name: &'static str, base: &Table, shift: f64) -> Option<Form> {
    let machine = is_machine(base);
    // Values of format 1 are rational.
    if base["system"].get("measured").is_some() || !machine && (shift * 4.0).fract() != 0.0 {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form(name, level, base);
    let turn = |harmonics: &mut Table| {
        let k = harmonics.get("k").map_or(1.0, |k| text(k).parse::<f64>().expect("a number"));
        let angle = (k * shift).rem_euclid(1.0);
        let (cos, sin) = match (angle * 4.0, machine) {
            (quarters, _) if quarters.fract() == 0.0 => {
                let [cos, sin] = [[1, 0], [0, 1], [-1, 0], [0, -1]][quarters as usize];
                (cos.to_string(), sin.to_string())
            }
            _ => (format!("cos(2*pi*{angle})"), format!("sin(2*pi*{angle})")),
        };
        let zero = Value::Integer(0);
        let (c, s) =
            (harmonics.get("cos").unwrap_or(&zero).clone(), harmonics.get("sin").unwrap_or(&zero).clone());
        harmonics.insert("cos".into(), sum(&c, &cos, &s, &sin));
        harmonics.insert("sin".into(), sum(&s, &cos, &c, &format!("-({sin})")));
    };
    list(system(&mut form.scene), "forcing").for_each(turn);
    surfaces(&mut form.scene, &mut |surface| list(surface, "harmonics").for_each(turn));
    each_number(&mut form.scene, &mut |slot| {
        if slot.what == What::Formula {
            let inner = substituted(&slot.text(), "{}", "{}", &format!("(t + 2*pi*{shift})"));
            *slot.value = Value::String(inner);
        }
    });
    for task in list(&mut form.scene, "tasks") {
        shift_task(task, shift, machine);
    }
    form.view.shift = shift;
    form.other.push("coefficient");
    // Turning points are those of a cubic through looks at multiples of a part of the period, and the
    // parameter goes on at the form's phase 0: before all is settled it is another motion.
    form.other.extend(["points.swing", "highest.swing", "highest.amplitude"]);
    Some(form)
}

/// a·x + b·y, entry by entry.
fn sum(a: &Value, x: &str, b: &Value, y: &str) -> Value {
    let one = |a: &Value, b: &Value| Value::String(format!("({})*({x}) + ({})*({y})", text(a), text(b)));
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => Value::Array(a.iter().zip(b).map(|(a, b)| one(a, b)).collect()),
        (Value::Array(a), b) => Value::Array(a.iter().map(|a| one(a, b)).collect()),
        (a, Value::Array(b)) => Value::Array(b.iter().map(|b| one(a, b)).collect()),
        (a, b) => one(a, b),
    }
}

fn shift_task(task: &mut Table, shift: f64, machine: bool) {
    let kind = task["kind"].as_str().expect("a word").to_string();
    let begin = |start: &mut Table| {
        let phase = less(start.get("phase"), shift);
        start.insert("phase".into(), phase);
    };
    let orbit = |holder: &mut Table| {
        let keys = holder.get_mut("orbit").and_then(Value::as_table_mut);
        let start = keys.and_then(|keys| keys.get_mut("start")).and_then(Value::as_array_mut);
        for time in start.into_iter().flatten().step_by(2) {
            let part = if machine { shift } else { TAU * shift };
            *time = Value::Float(text(time).parse::<f64>().expect("a number") - part);
        }
    };
    if let Some(start) = task.get_mut("start").and_then(Value::as_table_mut) {
        begin(start);
    }
    for start in list(task, "starts") {
        if ["section", "diagram"].contains(&&*kind) {
            begin(start);
        }
        if let Some(start) = start.get_mut("attractor").and_then(Value::as_table_mut) {
            begin(start);
        }
        orbit(start);
    }
    orbit(task);
    if ["section", "diagram", "basins", "map", "crisis"].contains(&&*kind) {
        let phase = less(task.get("phase"), shift);
        task.insert("phase".into(), phase);
    }
}
