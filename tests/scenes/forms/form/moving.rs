//! Moving stops in place of the force.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, number, system, tasks};
use crate::forms::{
    report::Moving,
    scene::{is_machine, list, text},
};

/// A linear oscillator seen from its motion without walls: nothing drives it, and the walls move.
pub(super) fn moving(base: &Table) -> Option<Form> {
    let known = base["system"].as_table()?;
    if is_machine(base) || is_integrated(base) || base.get("walls").is_none() {
        return None;
    }
    let mut form = form("moving stops for the force", Level::Rounding, base);
    let coefficient = |key: &str| known.get(key).map_or("0".to_string(), text);
    let (d, k) = (coefficient("damping"), coefficient("stiffness"));
    number(known, "stiffness", base).filter(|&k| k != 0.0)?;
    let mean = format!("({})/({k})", coefficient("force"));
    let mut terms: Vec<(u32, String, String)> = Vec::new();
    for harmonic in known.get("forcing").and_then(Value::as_array).into_iter().flatten() {
        let m: u32 = harmonic.get("k").map_or(1, |m| text(m).parse().expect("a number"));
        let [c, s] = ["cos", "sin"].map(|key| harmonic.get(key).map_or("0".into(), text));
        let even = format!("(({k}) - {})", m * m);
        let odd = format!("({m}*({d}))");
        let square = format!("({even}^2 + {odd}^2)");
        terms.push((
            m,
            format!("({even}*({c}) - {odd}*({s}))/{square}"),
            format!("({even}*({s}) + {odd}*({c}))/{square}"),
        ));
    }
    if terms.is_empty() {
        return None;
    }
    let system = system(&mut form.scene);
    system.remove("forcing");
    system.remove("force");
    for wall in list(&mut form.scene, "walls") {
        wall["offset"] = Value::String(format!("({}) - {mean}", text(&wall["offset"])));
        let all = wall.entry("harmonics").or_insert(Value::Array(Vec::new())).as_array_mut()?;
        for (m, cos, sin) in &terms {
            let is = |one: &&mut Value| one.get("k").map_or("1".into(), text) == m.to_string();
            let mut one = Table::new();
            if let Some(known) = all.iter_mut().find(is) {
                for (key, part) in [("cos", cos), ("sin", sin)] {
                    let old = known.get(key).map_or("0".into(), text);
                    known.as_table_mut()?.insert(key.into(), Value::String(format!("({old}) - {part}")));
                }
                continue;
            }
            one.insert("k".into(), Value::Integer((*m).into()));
            one.insert("cos".into(), Value::String(format!("-{cos}")));
            one.insert("sin".into(), Value::String(format!("-{sin}")));
            all.push(Value::Table(one));
        }
    }
    let sum = |parts: Vec<String>| parts.join(" + ");
    let q = sum(terms.iter().map(|(_, cos, _)| format!("({cos})")).chain([mean.clone()]).collect());
    let u = sum(terms.iter().map(|(m, _, sin)| format!("{m}*({sin})")).collect());
    // Only what begins at phase 0 and is looked at there.
    let phased = |task: &Value| text(task).contains("phase") || text(task).contains("frame");
    let framed = |task: &Value| ["diagram", "response"].contains(&task["kind"].as_str().unwrap_or(""));
    tasks(&mut form.scene).retain(|task| !phased(task) && !framed(task));
    for task in list(&mut form.scene, "tasks") {
        let place = |table: &mut Table, key: &str, less: &str| {
            let old = table.get(key).map_or("0".into(), text);
            table.insert(key.into(), Value::String(format!("({old}) - ({less})")));
        };
        let start = |start: &mut Table| {
            place(start, "q", &q);
            place(start, "u", &u);
        };
        let kind = task["kind"].as_str()?.to_string();
        task.get_mut("start").and_then(Value::as_table_mut).into_iter().for_each(start);
        for one in list(task, "starts") {
            if kind == "section" {
                start(one);
            }
            one.get_mut("attractor").and_then(Value::as_table_mut).into_iter().for_each(start);
        }
        if kind == "basins" {
            for (key, less) in [("q", &q), ("u", &u)] {
                let values = task[key].as_table_mut()?;
                place(values, "from", less);
                place(values, "to", less);
            }
        }
    }
    let mut one = Table::new();
    let mut at = |text: &String| {
        one.insert("x".into(), Value::String(text.clone()));
        number(&one, "x", base)
    };
    let mut all = vec![Moving { k: 0.0, cos: at(&mean)?, sin: 0.0 }];
    for (m, cos, sin) in &terms {
        all.push(Moving { k: f64::from(*m), cos: at(cos)?, sin: at(sin)? });
    }
    form.view.moving = all;
    form.without.extend(["diagram", "response", "phase"]);
    form.other.extend(["coefficient", "effects", "extent", "gap"]);
    Some(form)
}
