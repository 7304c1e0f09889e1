//! The scenes that are asked, with orbits to begin with, and shorter tasks where motions are integrated.

use std::f64::consts::TAU;

use toml::{Table, Value};

use super::{
    draw, form,
    report::Reported,
    run,
    scene::{brief, is_machine, list},
};

/// The scene that is drawn with a seed, and what it is called.
pub fn of_seed(seed: u64) -> (String, Table) {
    let drawn = draw::drawn(seed);
    let scene = toml::from_str(&drawn.text).unwrap_or_else(|error| panic!("{error}\n{}", drawn.text));
    (format!("seed {seed}, {:?}", drawn.system), prepared(scene))
}

/// The scene with its orbits of impacts from where they are at F = 1: what a search from random starts
/// finds is no column, but all that begins there is. Where a search is cheap it says where; where motions
/// are integrated, the last impacts of a motion do, if it has any.
fn prepared(mut scene: Table) -> Table {
    let place = match form::is_integrated(&scene) {
        true => place_by_motion,
        false => place_by_search,
    };
    let mut known: Vec<(Value, Option<[f64; 4]>)> = Vec::new();
    let snapshot = scene.clone();
    let mut fill = |holder: &mut Table| {
        let Some(orbit) = holder.get_mut("orbit").and_then(Value::as_table_mut) else { return };
        let count = orbit.get("pattern").and_then(Value::as_array).map_or(0, Vec::len);
        if count == 0 {
            return;
        }
        let keys = Value::Table(orbit.clone());
        let at = match known.iter().find(|(other, _)| *other == keys) {
            Some((_, at)) => *at,
            None => {
                let at = place(&snapshot, &keys);
                known.push((keys, at));
                at
            }
        };
        if let Some(at) = at {
            let start = at[..2 * count].iter().map(|&x| Value::Float(x)).collect::<Vec<_>>();
            orbit.insert("start".into(), start.into());
        }
        // Where nothing was found, little is looked for.
        orbit.insert("starts".into(), Value::Integer(4));
    };
    for task in list(&mut scene, "tasks") {
        fill(task);
        list(task, "starts").for_each(&mut fill);
    }
    // Soft stops divide motions into pieces, whose ends are searched for.
    let soft = |wall: &Value| wall.get("stiffness").is_some();
    let through_soft = scene.get("walls").and_then(Value::as_array).is_some_and(|all| all.iter().any(soft));
    if through_soft || form::is_integrated(&scene) {
        brief(&mut scene);
    }
    scene
}

/// Runs one task in place of all.
fn run_only(scene: &Table, task: Table) -> Option<Reported> {
    let mut only = scene.clone();
    only.insert("tasks".into(), vec![Value::Table(task)].into());
    run(&only).ok()?.0.into_iter().next()
}

/// Where a search at the scene's parameters finds an orbit: times and speeds of its impacts.
fn place_by_search(scene: &Table, orbit: &Value) -> Option<[f64; 4]> {
    let mut task: Table = toml::from_str("name = \"search\"\nkind = \"orbit\"").expect("a table");
    task.insert("orbit".into(), orbit.clone());
    let found = run_only(scene, task)?;
    let report = serde_json::to_value(&found.report).expect("a report");
    let rows: Vec<&serde_json::Value> = report["orbits"].as_array()?.iter().collect();
    let good = rows.iter().find(|row| row["admissible"] == true).or(rows.first())?;
    let mut at = [0.0; 4];
    let numbers =
        |key: &str| good[key].as_array().into_iter().flatten().filter_map(serde_json::Value::as_f64);
    for (i, (phase, speed)) in numbers("phases").zip(numbers("speeds")).take(2).enumerate() {
        at[2 * i..2 * i + 2].copy_from_slice(&[phase, speed]);
    }
    Some(at)
}

/// The last impacts of a motion from the start of the scene's first task, two in one period where there are.
fn place_by_motion(scene: &Table, _: &Value) -> Option<[f64; 4]> {
    let mut task = scene["tasks"].as_array()?.first()?.as_table()?.clone();
    task.insert("periods".into(), Value::Integer(40));
    let motion = run_only(scene, task)?.impacts();
    let turn = if is_machine(scene) { 1.0 } else { TAU };
    let last = motion.len().checked_sub(1)?;
    let pair = (1..=last).rev().find(|&i| motion[i][0].floor() == motion[i - 1][0].floor()).unwrap_or(0);
    let of = |[time, speed]: [f64; 2]| [time.fract() * turn, speed];
    let [[t, v], [s, w]] = match pair {
        0 => [of(motion[last]); 2],
        i => [of(motion[i - 1]), of(motion[i])],
    };
    Some([t, v, s, w])
}
