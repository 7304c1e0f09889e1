//! The scenes that are asked, with orbits to begin with, and shorter tasks where motions are integrated.

use std::{
    f64::consts::TAU,
    fs,
    path::{Path, PathBuf},
};

use toml::{Table, Value};

use super::{
    draw, form,
    report::Reported,
    run,
    scene::{at_most, brief, has_friction, is_machine, list, side_as_row, stops, stops_key},
};

/// Folders of examples, and the name under which every scene is read: beside the record of one of them.
const EXAMPLES: [&str; 2] = ["examples/scenes", "examples/machines"];
pub const NAME: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/machines/scene.toml");

/// The depth of the least impacts of examples of format 1, whose lengths are about 1, and of those with
/// friction: 2⁻³⁶. Chatter that goes on below it is rounding's soon.
const MINIMUM_DEPTH: f64 = 1.0 / (1u64 << 36) as f64;

/// How far from their grazing born orbits are found in examples of format 1.
const DISTANCE: f64 = 1.0 / (1u64 << 20) as f64;

/// Most tasks `chaos` of an example: each is a proof, and one scene has eight.
const CHAOTIC: usize = 1;

/// A scene that is asked.
#[derive(Debug)]
pub enum Question {
    /// Drawn with a seed.
    Seed(u64),
    /// Drawn with a seed, with dry friction, kinks of forces, laws of stops and wear.
    Effects(u64),
    /// A file of `examples`, its tasks cut short.
    Example(PathBuf),
}

impl Question {
    /// All examples, by their files' names.
    pub fn examples() -> Vec<Question> {
        let mut all = Vec::new();
        for folder in EXAMPLES {
            let files = fs::read_dir(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(folder))
                .expect("the folder");
            let files = files.map(|file| file.expect("a file").path());
            all.extend(files.filter(|file| file.extension().is_some_and(|end| end == "toml")));
        }
        all.sort();
        all.into_iter().map(Question::Example).collect()
    }

    pub fn name(&self) -> String {
        match self {
            Question::Seed(seed) => format!("seed {seed}"),
            Question::Effects(seed) => format!("effects {seed}"),
            Question::Example(file) => file.file_stem().expect("a name").to_string_lossy().into_owned(),
        }
    }

    /// The scene, with its orbits to begin with.
    pub fn scene(&self) -> Table {
        let read = |text: &str| toml::from_str(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        match self {
            Question::Seed(seed) => prepared(read(&draw::drawn(*seed))),
            Question::Effects(seed) => prepared(read(&draw::with_effects(*seed))),
            Question::Example(file) => {
                prepared(shorter(older(read(&fs::read_to_string(file).expect("a scene")))))
            }
        }
    }
}

/// An example in the older format in which forms are made, but for what older formats do not have.
fn older(mut scene: Table) -> Table {
    let units = ["mass", "modes"].iter().any(|key| scene["system"].get(key).is_some());
    if units {
        stops(&mut scene).for_each(|stop| {
            side_as_row(stop);
        });
    }
    if has_friction(&scene) || scene.contains_key("units") {
        scene.iter_mut().for_each(|(_, value)| older_orbits(value, None));
        return scene;
    }
    let format = if units { "grazing-scene 2" } else { "grazing-scene 1" };
    assert_eq!(scene.insert("format".into(), format.into()), Some("grazing-scene 3".into()));
    if let Some(stops) = scene.remove("stops") {
        scene.insert("walls".into(), stops);
    }
    scene.iter_mut().for_each(|(_, value)| older_orbits(value, (!units).then_some(1.0)));
    scene
}

/// What begins at angles begins at numbers of what one radian is; of format 1, where that is given, orbits
/// name walls for stops, too.
fn older_orbits(value: &mut Value, of_one: Option<f64>) {
    match value {
        Value::Array(all) => all.iter_mut().for_each(|value| older_orbits(value, of_one)),
        Value::Table(table) => {
            if table.contains_key("pattern") {
                if of_one.is_some()
                    && let Some(stops) = table.remove("stops")
                {
                    table.insert("walls".into(), stops);
                }
                for phase in table.get_mut("start").and_then(Value::as_array_mut).into_iter().flatten() {
                    if let Some(angle) = phase.as_str() {
                        let angle = angle.strip_suffix(" rad").expect("an angle").parse::<f64>();
                        *phase = Value::Float(angle.expect("a number") * of_one.unwrap_or(1.0 / TAU));
                    }
                }
            }
            table.iter_mut().for_each(|(_, value)| older_orbits(value, of_one));
        }
        _ => {}
    }
}

/// Examples are made to be looked at: their motions are long, their grids fine. How many impacts a chatter
/// has goes with the minimum depth, which without a key is told by the size of the gap in the scene's own
/// frame, and where nothing holds a body by what forces do in a radian: here it has one.
fn shorter(mut scene: Table) -> Table {
    let machine = is_machine(&scene);
    if !machine || has_friction(&scene) {
        let accuracy = scene.entry("accuracy").or_insert(Value::Table(Table::new())).as_table_mut();
        accuracy.expect("a table").entry("minimum_depth").or_insert(Value::Float(MINIMUM_DEPTH));
    }
    let mut chaotic = 0;
    scene.get_mut("tasks").and_then(Value::as_array_mut).expect("tasks").retain(|task| {
        chaotic += usize::from(task["kind"].as_str() == Some("chaos"));
        task["kind"].as_str() != Some("chaos") || chaotic <= CHAOTIC
    });
    for task in list(&mut scene, "tasks") {
        if task["kind"].as_str() == Some("grazing") {
            task.entry("seen").or_insert(Value::Boolean(false));
            // Without the key each format has its own.
            if !machine {
                task.entry("distance").or_insert(Value::Float(DISTANCE));
            }
        }
        let most = [
            ("transient", 100),
            ("points", 60),
            ("periods", 12),
            ("longest", 16),
            ("samples", 64),
            ("count", 5),
        ];
        most.into_iter().for_each(|(key, most)| at_most(task, key, most));
        for key in ["q", "u"] {
            if let Some(values) = task.get_mut(key).and_then(Value::as_table_mut) {
                at_most(values, "count", 3);
            }
        }
    }
    scene
}

/// The keys of an orbit and the parameters that are set for it.
type Asked = (Value, Table);

/// The scene with its orbits of impacts from where they are: what a search from random starts finds is no
/// column, but all that begins there is. Where a search is cheap it says where; where motions are
/// integrated, the last impacts of a motion do, if it has any.
fn prepared(mut scene: Table) -> Table {
    let place = match form::is_integrated(&scene) {
        true => place_by_motion,
        false => place_by_search,
    };
    let mut known: Vec<(Asked, Option<[f64; 4]>)> = Vec::new();
    let snapshot = scene.clone();
    let mut fill = |holder: &mut Table, set: &Table| {
        let Some(orbit) = holder.get_mut("orbit").and_then(Value::as_table_mut) else { return };
        let count = orbit.get("pattern").and_then(Value::as_array).map_or(0, Vec::len);
        if count == 0 || count > 2 || orbit.contains_key("start") {
            return;
        }
        let asked = (Value::Table(orbit.clone()), set.clone());
        let at = match known.iter().find(|(other, _)| *other == asked) {
            Some((_, at)) => *at,
            None => {
                let at = place(&snapshot, &asked.0, set);
                known.push((asked, at));
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
        let mut set = task.get("set").and_then(Value::as_table).cloned().unwrap_or_default();
        fill(task, &set);
        let varied = task.get("parameter").and_then(Value::as_str).map(String::from);
        for start in list(task, "starts") {
            if let (Some(varied), Some(at)) = (&varied, start.get("at")) {
                set.insert(varied.clone(), at.clone());
            }
            fill(start, &set);
        }
    }
    // Soft stops and friction divide motions into pieces, whose ends are searched for.
    let soft = |wall: &Value| wall.get("stiffness").is_some();
    let all = scene.get(stops_key(&scene)).and_then(Value::as_array);
    let through_soft = all.is_some_and(|all| all.iter().any(soft));
    if through_soft || form::is_integrated(&scene) || has_friction(&scene) {
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

/// Where a search at these parameters finds an orbit: times and speeds of its impacts.
fn place_by_search(scene: &Table, orbit: &Value, set: &Table) -> Option<[f64; 4]> {
    let mut task: Table = toml::from_str("name = \"search\"\nkind = \"orbit\"").expect("a table");
    task.insert("orbit".into(), orbit.clone());
    task.insert("set".into(), set.clone().into());
    let found = run_only(scene, task)?;
    let report = serde_json::to_value(&found.report).expect("a report");
    let rows: Vec<&serde_json::Value> = report["orbits"].as_array()?.iter().collect();
    let good = rows.iter().find(|row| row["admissible"] == true).or(rows.first())?;
    let mut at = [0.0; 4];
    let numbers =
        |key: &str| good[key].as_array().into_iter().flatten().filter_map(serde_json::Value::as_f64);
    // Reports have fractions of the period, format 1 radians.
    let turn = if is_machine(scene) { 1.0 } else { TAU };
    for (i, (phase, speed)) in numbers("phases").zip(numbers("speeds")).take(2).enumerate() {
        at[2 * i..2 * i + 2].copy_from_slice(&[phase * turn, speed]);
    }
    Some(at)
}

/// The last impacts of the scene's first motion at these parameters, two in one period where there are.
fn place_by_motion(scene: &Table, _: &Value, set: &Table) -> Option<[f64; 4]> {
    let simulates = |task: &&Value| task["kind"].as_str() == Some("simulate");
    let mut task = scene["tasks"].as_array()?.iter().find(simulates)?.as_table()?.clone();
    task.insert("set".into(), set.clone().into());
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
