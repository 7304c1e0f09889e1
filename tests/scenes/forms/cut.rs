//! A run and its parts: what adds up along a motion is, over the parts of a run that is cut anywhere, what it
//! is of the whole. Runs are cut at places that are drawn, and within contacts, rests and sticking.

use std::{collections::BTreeMap, fs};

use grazing_scenes::{
    Result,
    run::{Job, Keeper, SeriesPoint, StopEvent, Surroundings, run_task},
    scene::Scene,
};
use serde_json::Value as Json;
use toml::{Table, Value};

use super::{
    draw::{self, Random},
    scenes::{NAME, Question},
};
use crate::samples::samples;

/// Periods of a run.
const PERIODS: f64 = 3.0;
/// Cuts of a run at places that are drawn, and within what lasts.
const ANYWHERE: u64 = 2;
const WITHIN: usize = 3;
/// Sums of parts are those of the whole within this of their size: a part begins at rounded numbers.
const NEAR: f64 = 1e-8;

/// Where a motion is: the phase as a fraction of the period, displacements, velocities.
#[derive(Clone)]
struct Place {
    phase: f64,
    state: [Json; 2],
}

/// What was told of a run.
struct Part {
    /// How often each thing happened.
    counts: BTreeMap<String, u64>,
    /// What adds up.
    sums: BTreeMap<String, f64>,
    end: Place,
    /// When what lasts began and ended, in periods from the beginning.
    lasting: Vec<[f64; 2]>,
    depth: f64,
    period: f64,
}

/// When contact, rest and sticking begin and end, by their stops.
#[derive(Default)]
struct Lasting {
    open: BTreeMap<usize, f64>,
    all: Vec<[f64; 2]>,
}

impl Keeper for Lasting {
    fn sample(&mut self, _: &SeriesPoint) -> Result<()> {
        Ok(())
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        let now = event.time.periods();
        match event.event {
            "touch" | "stick" => {
                self.open.insert(event.stop, now);
            }
            "release" => self.all.extend(self.open.remove(&event.stop).map(|from| [from, now])),
            _ => {}
        }
        Ok(())
    }
}

const COUNTS: [&str; 6] = ["impacts", "tangencies", "rests", "sticks", "reversals", "crossings"];

/// The run of a scene from a place, of so many periods.
fn run(
    scene: &Table,
    from: &Place,
    periods: f64,
    known: Option<(f64, f64)>,
) -> std::result::Result<Part, String> {
    let mut scene = scene.clone();
    let mut task: Table = toml::from_str("name = \"m\"\nkind = \"simulate\"\nsamples = 8").expect("a table");
    let [q, u] = from.state.each_ref().map(|list| Value::try_from(list).expect("a list"));
    let start = [("phase", Value::Float(from.phase)), ("q", q), ("u", u)];
    task.insert(
        "start".into(),
        Value::Table(start.map(|(key, value)| (key.into(), value)).into_iter().collect()),
    );
    match known {
        Some((period, depth)) => {
            task.insert("duration".into(), Value::Float(periods * period));
            // Without the key it goes with the start.
            let accuracy = scene.entry("accuracy").or_insert(Value::Table(Table::new()));
            accuracy.as_table_mut().expect("a table").insert("minimum_depth".into(), Value::Float(depth));
        }
        None => drop(task.insert("periods".into(), Value::Integer(periods as i64))),
    }
    scene.insert("tasks".into(), vec![Value::Table(task)].into());
    let text = toml::to_string(&scene).expect("a table");
    let scene = Scene::from_toml(&text, NAME).map_err(|error| error.to_string())?;
    let job =
        Job::new(&scene, &scene.tasks[0], Surroundings::default()).map_err(|error| error.to_string())?;
    let mut lasting = Lasting::default();
    let report = run_task(&job, &mut lasting);
    if let Some(reason) = report.status.reason() {
        return Err(reason.to_string());
    }
    let told = serde_json::to_value(&report).expect("a report");
    let number = |value: &Json| value.as_f64().expect("a number");
    let whole = number(&told["ended_at"]) - from.phase;
    let (mut counts, mut sums) = (BTreeMap::new(), BTreeMap::new());
    counts.insert("order_matters".to_string(), told["order_matters"].as_u64().expect("a number"));
    for table in ["stops", "friction", "kinks", "wear"] {
        for (i, row) in told[table].as_array().into_iter().flatten().enumerate() {
            for (column, value) in row.as_object().expect("a row") {
                let name = format!("{table} {i} {column}");
                match column.as_str() {
                    count if COUNTS.contains(&count) => {
                        counts.insert(name, value.as_u64().expect("a number"));
                    }
                    "dissipated" | "volume" | "path" | "impulse" => {
                        sums.insert(name, number(value));
                    }
                    "stuck" => {
                        sums.insert(name, whole * number(value));
                    }
                    _ => {}
                }
            }
        }
    }
    let end =
        Place { phase: number(&told["ended_at"]).fract(), state: ["q", "u"].map(|key| told[key].clone()) };
    let [depth, period] = ["minimum_depth", "period"].map(|key| number(&told[key]));
    let lasting = lasting.all.into_iter().map(|ends| ends.map(|time| time - from.phase)).collect();
    Ok(Part { counts, sums, end, lasting, depth, period })
}

/// What differs between a run and its parts.
fn differences(
    name: &str,
    scene: &Table,
    from: &Place,
    random: &mut Random,
    tried: &mut [u64; 2],
) -> Vec<String> {
    let Ok(whole) = run(scene, from, PERIODS, None) else { return vec![] };
    let known = Some((whole.period, whole.depth));
    let drawn = (0..ANYWHERE).map(|_| PERIODS * (0.1 + 0.8 * random.part()));
    let mut cuts: Vec<f64> = drawn.collect();
    let step = whole.lasting.len().div_ceil(WITHIN).max(1);
    let inside = whole.lasting.iter().step_by(step).filter(|[from, to]| to - from > 1e-4);
    cuts.extend(inside.map(|[from, to]| from + (to - from) * (0.2 + 0.6 * random.part())));
    let mut all = Vec::new();
    for cut in cuts {
        tried[0] += 1;
        let first = run(scene, from, cut, known).expect("it ran before");
        let second = match run(scene, &first.end, PERIODS - cut, known) {
            Ok(second) => second,
            // Of some modes places are told, and amplitudes not.
            Err(reason) if reason.contains("the shapes at the coordinates") => return vec![],
            Err(reason) => panic!("{name}: {reason}"),
        };
        for (what, count) in &whole.counts {
            let sum = first.counts[what] + second.counts[what];
            tried[1] += u64::from(*count > 0);
            if sum != *count {
                all.push(format!("{name}, cut at {cut}: {what}: {count}, of the parts {sum}"));
            }
        }
        for (what, value) in &whole.sums {
            let parts = [first.sums[what], second.sums[what]];
            tried[1] += u64::from(*value > 0.0);
            let size = value.abs().max(parts[0].abs()).max(parts[1].abs());
            if (parts[0] + parts[1] - value).abs() > NEAR * size + 1e-14 {
                all.push(format!("{name}, cut at {cut}: {what}: {value}, of the parts {parts:?}"));
            }
            if parts.iter().any(|part| *part < -1e-14) {
                all.push(format!("{name}, cut at {cut}: {what} falls: {parts:?}"));
            }
        }
    }
    all
}

/// A scene with its first motion's start; without its orbits and other tasks.
fn asked(mut scene: Table) -> Option<(Table, Place)> {
    let tasks = scene.remove("tasks")?;
    let motion = tasks.as_array()?.iter().find(|task| task["kind"].as_str() == Some("simulate"))?;
    let start = motion["start"].as_table()?;
    let list =
        |key: &str| serde_json::to_value(start.get(key).unwrap_or(&Value::Integer(0))).expect("a list");
    let phase = start.get("phase").and_then(Value::as_float).unwrap_or(0.0);
    Some((scene, Place { phase, state: ["q", "u"].map(list) }))
}

fn compared(all: impl Iterator<Item = (String, Table)>) {
    let (mut tried, mut found, mut random) = ([0; 2], Vec::new(), Random(7));
    for (name, scene) in all {
        let Some((scene, from)) = asked(scene) else { continue };
        found.extend(differences(&name, &scene, &from, &mut random, &mut tried));
    }
    println!("{} cuts, {} sums above 0", tried[0], tried[1]);
    assert!(found.is_empty(), "{} of {} differ:\n{}", found.len(), tried[1], found.join("\n"));
    assert!(tried[1] > tried[0], "{tried:?}: there is nothing to add up");
}

/// A mass of 1 on a spring of 100, which it is in at the end or at the beginning: without damping nothing is
/// lost, and with it what mass and spring have less.
#[test]
fn what_a_stop_stores_is_not_lost() {
    let place = |q: f64, u: f64| Place { phase: 0.0, state: [q, u].map(|x| serde_json::json!([x])) };
    let (comes, leaves) = ((place(0.1, -1.0), 0.1 + 0.05 * std::f64::consts::PI), (place(-0.1, 0.0), 1.0));
    for (damping, lost) in [(0, [0.0, 0.0]), (4, [0.214_503_383_574, 0.214_129_986_208])] {
        let scene = read(&format!(
            "format = \"grazing-scene 3\"\ntitle = \"a spring\"\n[system]\nperiod = 1\nmass = 1\n\
             [[stops]]\nside = \"lower\"\noffset = 0\nstiffness = 100\ndamping = {damping}\nwear = 2\n"
        ));
        for ((from, duration), lost) in [&comes, &leaves].into_iter().zip(lost) {
            let part = run(&scene, from, *duration, Some((1.0, 1e-12))).unwrap();
            let [taken, worn] = ["stops 0 dissipated", "wear 0 volume"].map(|name| part.sums[name]);
            assert!((taken - lost).abs() <= 1e-11 * lost && worn == 2.0 * taken, "{taken} {worn} {lost}");
        }
    }
}

fn read(text: &str) -> Table {
    toml::from_str(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn the_parts_of_a_drawn_motion_add_up_to_it() {
    compared((1..=samples(12)).map(|seed| (format!("seed {seed}"), read(&draw::drawn(seed)))));
}

#[test]
fn the_parts_of_a_drawn_motion_with_effects_add_up_to_it() {
    compared((1..=samples(8)).map(|seed| (format!("effects {seed}"), read(&draw::with_effects(seed)))));
}

#[test]
fn the_parts_of_the_motions_of_examples_add_up_to_them() {
    compared(Question::examples().into_iter().filter_map(|question| {
        let Question::Example(file) = &question else { return None };
        Some((question.name(), read(&fs::read_to_string(file).expect("a scene"))))
    }));
}
