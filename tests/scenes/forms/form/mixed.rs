//! Other coordinates: q = T p with q₁ = p₁ and qᵢ = pᵢ + pᵢ₋₁/2. Rows and forces turn with Tᵀ, the matrices
//! with Tᵀ and T.

use toml::{Table, Value};

use super::{Form, Level, form, is_integrated, system, tasks};
use crate::forms::scene::{coordinates, is_machine, list, renamed, surfaces, text};

/// A sum of halves: each a text, and how often it is halved.
fn sum(parts: impl Iterator<Item = (String, u32)>) -> Value {
    let kept = parts.filter(|(text, _)| text.parse::<f64>() != Ok(0.0));
    let all: Vec<String> = kept.map(|(text, halves)| format!("({text})/{}", 1 << halves)).collect();
    if all.is_empty() { Value::Integer(0) } else { Value::String(all.join(" + ")) }
}

/// Tᵀ x.
fn turned(all: &[Value]) -> Value {
    let entry = |i: usize| sum((i..all.len().min(i + 2)).map(|a| (text(&all[a]), (a - i) as u32)));
    Value::Array((0..all.len()).map(entry).collect())
}

fn turn(table: &mut Table, key: &str) {
    if let Some(Value::Array(all)) = table.get(key) {
        let all = turned(all);
        table.insert(key.into(), all);
    }
}

/// T⁻¹ x.
fn inverse(all: &[f64]) -> Vec<f64> {
    let mut p: Vec<f64> = Vec::new();
    all.iter().for_each(|q| p.push(q - p.last().map_or(0.0, |last| last / 2.0)));
    p
}

/// Tᵀ M T.
fn congruent(matrix: &Value, n: usize) -> Option<Value> {
    let zero = || Value::Integer(0);
    let rows: Vec<Vec<Value>> = match matrix {
        Value::Array(rows) => rows.iter().map(|row| row.as_array().cloned()).collect::<Option<_>>()?,
        Value::Table(table) => {
            let diagonal = table.get("diagonal")?.as_array()?;
            (0..n)
                .map(|i| (0..n).map(|j| if i == j { diagonal[i].clone() } else { zero() }).collect())
                .collect()
        }
        _ => return None,
    };
    let entry = |i: usize, j: usize| {
        let pairs = (i..n.min(i + 2)).flat_map(|a| (j..n.min(j + 2)).map(move |b| (a, b)));
        sum(pairs.map(|(a, b)| (text(&rows[a][b]), (a - i + b - j) as u32)))
    };
    let row = |i: usize| Value::Array((0..n).map(|j| entry(i, j)).collect());
    Some(Value::Array((0..n).map(row).collect()))
}

pub(super) fn mixed(base: &Table) -> Option<Form> {
    let known = base["system"].as_table()?;
    let n = coordinates(base);
    if !is_machine(base)
        || n < 2
        || ["modes", "measured", "damping_ratio"].iter().any(|key| known.contains_key(*key))
    {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("coordinates mixed", level, base);
    let system = system(&mut form.scene);
    for key in ["mass", "damping", "stiffness"] {
        if let Some(matrix) = known.get(key) {
            system.insert(key.into(), congruent(matrix, n)?);
        }
    }
    // Of the old coordinates in formulas first, then the sums of forces.
    for one in system.get_mut("force").and_then(Value::as_array_mut).into_iter().flatten() {
        let of = |name: &str| {
            let (letter, i) = (name.get(..1)?, name.get(1..)?.parse::<usize>().ok()?);
            (["q", "u"].contains(&letter) && i > 1).then(|| format!("({name} + {letter}{}/2)", i - 1))
        };
        *one = Value::String(renamed(&text(one), &of));
    }
    turn(system, "force");
    for harmonic in list(system, "forcing") {
        ["cos", "sin"].into_iter().for_each(|key| turn(harmonic, key));
    }
    surfaces(&mut form.scene, &mut |surface| turn(surface, "row"));
    // The other coordinates of a grid's points stay where they are.
    tasks(&mut form.scene).retain(|task| task["kind"].as_str() != Some("basins"));
    let begin = |start: &mut Table| {
        for key in ["q", "u"] {
            if let Some(Value::Array(all)) = start.get(key) {
                let all: Option<Vec<f64>> = all.iter().map(|x| text(x).parse().ok()).collect();
                let all = inverse(&all.expect("starts are numbers"));
                start.insert(key.into(), all.into_iter().map(Value::Float).collect::<Vec<_>>().into());
            }
        }
    };
    let orbit = |holder: &mut Table| {
        let Some(orbit) = holder.get_mut("orbit").and_then(Value::as_table_mut) else { return };
        let free = orbit.get("pattern").and_then(Value::as_array).is_none_or(Vec::is_empty);
        if let Some(start) = orbit.get("start").and_then(Value::as_array).filter(|_| free) {
            let all: Vec<f64> = start.iter().map(|x| text(x).parse().expect("a number")).collect();
            let all = [inverse(&all[..n]), inverse(&all[n..])].concat();
            orbit.insert("start".into(), all.into_iter().map(Value::Float).collect::<Vec<_>>().into());
        }
    };
    for task in list(&mut form.scene, "tasks") {
        orbit(task);
        list(task, "starts").for_each(orbit);
        task.get_mut("start").and_then(Value::as_table_mut).into_iter().for_each(begin);
        for one in list(task, "starts") {
            begin(one);
            one.get_mut("attractor").and_then(Value::as_table_mut).into_iter().for_each(begin);
        }
    }
    form.view.mixed = true;
    form.without.push("basins");
    // What counts as periodic is told in the form's own coordinates, and so when a motion is.
    form.other.extend(["coefficient", "effects", "matrix", "B", "C", "points"]);
    Some(form)
}
