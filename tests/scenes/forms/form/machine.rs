//! An oscillator as a machine, and a machine with a coordinate more.

use std::f64::consts::TAU;

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, is_over_a_range, number, system, tasks, without_prove};
use crate::forms::{
    report::Texts,
    scene::{coordinates, is_machine, list, renamed, side_as_row, stops, surfaces, text, with_rows},
};

/// An oscillator as a machine of one coordinate.
pub(super) fn machine(base: &Table) -> Option<Form> {
    if is_machine(base) {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("as a machine", level, base);
    let scene = &mut form.scene;
    scene.insert("format".into(), Value::String("grazing-scene 2".into()));
    let system = system(scene);
    system.insert("period".into(), Value::String("2*pi".into()));
    system.insert("mass".into(), Value::Integer(1));
    if let Some(cubic) = system.remove("cubic") {
        let force = system.get("force").map_or("0".into(), text);
        system.insert("force".into(), Value::String(format!("{force} - ({})*q^3", text(&cubic))));
    }
    if let Some(accuracy) = scene.get_mut("accuracy").and_then(Value::as_table_mut) {
        accuracy.remove("tolerance");
    }
    for wall in stops(scene) {
        side_as_row(wall)?;
    }
    let framed = |task: &Value| task.get("frame").is_some_and(|frame| frame.as_str() != Some("fixed"));
    let impacting = |task: &Value| {
        task.get("orbit").is_some_and(|orbit| {
            orbit.get("pattern").is_some_and(|all| all.as_array().is_some_and(|all| !all.is_empty()))
        })
    };
    tasks(scene).retain(|task| {
        let kind = task["kind"].as_str().unwrap_or("");
        let refused = ["map", "crisis", "chaos"].contains(&kind)
            || kind == "validate" && task.get("event").is_some()
            || is_over_a_range(task)
            || kind == "grazing" && impacting(task);
        !refused && (kind == "branch" || !framed(task))
    });
    without_prove(scene);
    for task in list(scene, "tasks") {
        let kind = task["kind"].as_str()?.to_string();
        if ["section", "diagram", "basins"].contains(&&*kind) {
            task.insert(
                "plane".into(),
                Value::Array(["q1", "u1"].map(|name| Value::String(name.into())).to_vec()),
            );
        }
        for key in ["frame", "manifolds", "grazing_curve"] {
            task.remove(key);
        }
        if kind == "grazing" {
            task.remove("options");
            // Of several motions without impacts, the one that is meant.
            if let Some(orbit) = task.remove("orbit")
                && let Some(start) = orbit.get("start")
            {
                task.insert("orbit".into(), Table::from_iter([("start".into(), start.clone())]).into());
            }
        }
        for start in list(task, "starts") {
            start.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(orbit_of_machine);
        }
        list(task, "orbits").for_each(orbit_of_machine);
        if kind != "grazing" {
            task.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(orbit_of_machine);
        }
    }
    form.texts = Texts::Presence;
    form.common = true;
    form.without.push("machine");
    form.other.extend(["coefficient", "effects", "extent", "gap", "half", "proofs"]);
    if is_integrated(base) {
        form.other.push("criticality");
    }
    Some(form)
}

fn orbit_of_machine(keys: &mut Table) {
    if let Some(walls) = keys.remove("walls") {
        keys.insert("stops".into(), walls);
    }
    keys.entry("speed").or_insert(Value::Float(1.0));
    let free = keys.get("pattern").and_then(Value::as_array).is_none_or(Vec::is_empty);
    if free {
        keys.remove("start");
    }
    for time in keys.get_mut("start").and_then(Value::as_array_mut).into_iter().flatten().step_by(2) {
        *time = Value::Float(text(time).parse::<f64>().expect("a number") / TAU);
    }
}

/// A coordinate that nothing drives or couples, which decays by e^{−3π} in a period: q″ + 3q′ + 4q = 0 in the
/// forcing's radians.
pub(super) fn further(base: &Table) -> Option<Form> {
    let base_system = base["system"].as_table()?;
    if !is_machine(base) || base_system.get("modes").is_some() || base_system.get("measured").is_some() {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("a further coordinate", level, base);
    tasks(&mut form.scene).retain(|task| task["kind"].as_str() != Some("rest"));
    let n = coordinates(base);
    let period = number(base_system, "period", base)
        .or_else(|| Some(1.0 / number(base_system, "frequency", base)?))?;
    let (radian, system) = (period / TAU, system(&mut form.scene));
    for (key, entry) in [("mass", 1.0), ("damping", 3.0 / radian), ("stiffness", 4.0 / (radian * radian))] {
        let mut rows: Vec<Value> = match system.get(key) {
            Some(Value::Array(rows)) => rows.clone(),
            Some(Value::Table(table)) => {
                let diagonal = table.get("diagonal")?.as_array()?;
                let row = |i: usize| {
                    Value::Array(
                        (0..n)
                            .map(|j| if i == j { diagonal[i].clone() } else { Value::Integer(0) })
                            .collect(),
                    )
                };
                (0..n).map(row).collect()
            }
            Some(one) => vec![Value::Array(vec![one.clone()])],
            None => vec![Value::Array(vec![Value::Integer(0); n]); n],
        };
        rows.iter_mut()
            .for_each(|row| row.as_array_mut().into_iter().for_each(|row| row.push(Value::Integer(0))));
        let mut last = vec![Value::Integer(0); n];
        last.push(Value::Float(entry));
        rows.push(Value::Array(last));
        system.insert(key.into(), Value::Array(rows));
    }
    let widen = |table: &mut Table, key: &str| {
        if let Some(value) = table.get_mut(key) {
            match value {
                Value::Array(all) => all.push(Value::Integer(0)),
                one if text(one).parse::<f64>() == Ok(0.0) => {}
                one => *one = Value::Array(vec![one.clone(), Value::Integer(0)]),
            }
        }
    };
    widen(system, "force");
    // With several coordinates q and u have numbers.
    for one in system.get_mut("force").and_then(Value::as_array_mut).into_iter().flatten() {
        if let Value::String(text) = one {
            *text = renamed(text, &|name| ["q", "u"].contains(&name).then(|| format!("{name}1")));
        }
    }
    for harmonic in list(system, "forcing") {
        widen(harmonic, "cos");
        widen(harmonic, "sin");
    }
    with_rows(&mut form.scene);
    surfaces(&mut form.scene, &mut |surface| widen(surface, "row"));
    // Displacements, then velocities.
    let longer = |holder: &mut Table| {
        let Some(orbit) = holder.get_mut("orbit").and_then(Value::as_table_mut) else { return };
        let free = orbit.get("pattern").and_then(Value::as_array).is_none_or(Vec::is_empty);
        if let Some(start) = orbit.get_mut("start").and_then(Value::as_array_mut).filter(|_| free) {
            start.insert(n, Value::Integer(0));
            start.push(Value::Integer(0));
        }
    };
    for task in list(&mut form.scene, "tasks") {
        let start = |start: &mut Table| {
            widen(start, "q");
            widen(start, "u");
        };
        longer(task);
        list(task, "starts").for_each(longer);
        task.get_mut("start").and_then(Value::as_table_mut).into_iter().for_each(start);
        for one in list(task, "starts") {
            start(one);
            one.get_mut("attractor").and_then(Value::as_table_mut).into_iter().for_each(start);
        }
    }
    // λ² + 3λ + 4 = 0 over a period.
    let (rate, angle) = (-1.5 * TAU, 1.75_f64.sqrt() * TAU);
    let of = |times: f64| {
        [(rate * times).exp() * (angle * times).cos(), (rate * times).exp() * (angle * times).sin()]
    };
    form.view.further = (1..=3).flat_map(|i| [of(f64::from(i)), of(f64::from(i)).map(|x| x)]).collect();
    form.view.further.iter_mut().skip(1).step_by(2).for_each(|pair| pair[1] = -pair[1]);
    form.other.extend([
        "coefficient",
        "modes",
        "effects",
        "a1",
        "a2",
        "gamma",
        "ratio",
        "remains",
        "region",
        "exponents",
        "chaos",
        "chaos_open",
        "order_matters",
    ]);
    Some(form)
}

/// An oscillator as a machine with a further coordinate.
pub(super) fn machine_further(mut first: Form) -> Option<Form> {
    let second = further(&first.scene)?;
    first.other.extend(second.other);
    first.view.further = second.view.further;
    Some(Form { name: "as a machine with a further coordinate", scene: second.scene, ..first })
}
