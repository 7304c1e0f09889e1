//! Motions that are periodic up to a drift of coordinates that nothing holds.

use std::f64::consts::TAU;

use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};
use serde_json::Value;

fn reports(scene: &str) -> Vec<Value> {
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{scene}");
    let scene = Scene::from_toml(&text, "scene.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    reports.iter().map(|report| serde_json::to_value(report).unwrap()).collect()
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
}

fn moduli(row: &Value) -> Vec<f64> {
    let all = row["multipliers"].as_array().unwrap().iter();
    all.map(numbers).map(|pair| pair[0].hypot(pair[1])).collect()
}

/// Two masses on a rail that meet, pulled along it.
fn pair(stop: &str, force: &str, tasks: &str) -> String {
    format!(
        r#"
[parameters]
f = 0.2
[system]
period = "2*pi"
mass = {{ diagonal = [1, 2] }}
damping = [["1/10", 0], [0, "3/10"]]
{force}
forcing = [{{ cos = [1, 0] }}]
[[stops]]
name = "between"
row = [-1, 1]
offset = "-1/2"
{stop}
{tasks}"#
    )
}

const LINEAR: &str = "stiffness = [[1, -1], [-1, 1]]\nforce = [\"f\", 0]";
const CUBIC: &str = "force = [\"f - (q1-q2) - (q1-q2)^3\", \"(q1-q2) + (q1-q2)^3\"]";
const BOTH: &str = r#"
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = [0, 0] }, { q = [5, 5], u = [0.1, 0] }]
exponents = 3
points = 100
[[tasks]]
name = "branch"
kind = "branch"
parameter = "f"
range = [0.19, 0.21]
starts = [{ attractor = { q = [3, 3] } }]
"#;

/// What they do to each other they do to both: the mean velocity is the mean force over the dampings' sum.
/// Attractors from starts far apart are one, and `section` and `branch` come to the same by different routes:
/// the first by vectors carried along, the second by the equations of the pattern.
#[test]
fn what_is_pulled_drifts_by_force_over_damping() {
    let stops = ["restitution = 0.7", "stiffness = 20\ndamping = 0.1"];
    for (stop, force) in [(stops[0], LINEAR), (stops[1], LINEAR), (stops[1], CUBIC)] {
        let all = reports(&pair(stop, force, BOTH));
        let attractors = all[0]["attractors"].as_array().unwrap();
        assert_eq!(
            (attractors.len(), attractors[0]["starts"].as_u64()),
            (1, Some(2)),
            "{stop}: {attractors:?}"
        );
        let drift = numbers(&attractors[0]["drift"]);
        assert!(drift.iter().all(|x| (x - 0.2 / 0.4 * TAU).abs() < 1e-11), "{stop}: {drift:?}");
        let exponents = all[0]["exponents"].as_array().unwrap();
        assert_eq!(exponents.len(), 3);

        let text = serde_json::to_string(&all[1]).unwrap();
        assert_eq!(all[1]["status"], "done", "{text}");
        let starts = &all[1]["starts"][0];
        assert_eq!(starts["forward"], "a parameter is at its bound", "{text}");
    }
}

/// At each value of the branch, in its table, and at one by `orbit` from a start a long way off.
#[test]
fn an_orbit_is_the_same_wherever_along_the_drift_it_begins() {
    let tasks = r#"
[[tasks]]
name = "near"
kind = "orbit"
orbit = { start = [0, 0, 0.5, 0.5] }
parameter = "f"
values = [0.1, 0.2]
[[tasks]]
name = "far"
kind = "orbit"
orbit = { start = [900, 900, 0.5, 0.5] }
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = [0, 0] }]
exponents = 3
"#;
    let all = reports(&pair("stiffness = 20\ndamping = 0.1", LINEAR, tasks));
    let near = all[0]["orbits"].as_array().unwrap();
    for (row, f) in near.iter().zip([0.1, 0.2]) {
        let drift = numbers(&row["drift"]);
        assert!(drift.iter().all(|x| (x - f / 0.4 * TAU).abs() < 1e-12), "{f}: {drift:?}");
    }
    let far = &all[1]["orbits"][0];
    let [a, b] = [&near[1], far].map(moduli);
    assert_eq!(a.len(), 3, "the multiplier 1 along the drift is no other's: {a:?}");
    assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-9), "{a:?} {b:?}");
    let exponents = all[2]["exponents"].as_array().unwrap();
    for (row, modulus) in exponents.iter().zip(&a) {
        let exponent = row["per_period"].as_f64().unwrap();
        assert!((exponent - modulus.ln()).abs() < 1e-9, "{exponent} {modulus}");
    }
}

/// The capsule of Liu et al. (2013); its progress by another program's own integration of the events.
const CAPSULE: &str = r#"
[system]
period = "2*pi/0.95"
mass = { diagonal = [1, 5] }
damping = [["0.02", "-0.02"], ["-0.02", "0.02"]]
stiffness = [[1, -1], [-1, 1]]
forcing = [{ cos = [1.6, 0] }]
[[stops]]
name = "front"
row = [-1, 1]
offset = "-0.02"
stiffness = 15
[[friction]]
name = "ground"
row = [0, 1]
normal = 1
coefficient = 1
[[tasks]]
name = "simulate"
kind = "simulate"
start = { q = [0, 0] }
transient = 300
periods = 100
[[tasks]]
name = "more"
kind = "simulate"
start = { q = [0, 0] }
transient = 300
periods = 200
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = [0, 0] }, { q = [2, 2] }]
transient = 300
points = 100
[[tasks]]
name = "orbit"
kind = "orbit"
orbit = { start = [344.1268039099494, 343.5930197235848, 1.399368951887116, 0.1911813361635602] }
"#;

#[test]
fn a_capsule_makes_progress() {
    let all = reports(CAPSULE);
    let [before, after] = [0, 1].map(|i| numbers(&all[i]["q"]));
    let simulated = (after[1] - before[1]) / 100.0;
    assert!((simulated - 1.15814635).abs() < 5e-9, "{simulated}");
    let attractors = all[2]["attractors"].as_array().unwrap();
    assert_eq!((attractors.len(), &attractors[0]["period"]), (1, &Value::from(1)), "{attractors:?}");
    let orbit = &all[3]["orbits"][0];
    assert_eq!((&orbit["stable"], &orbit["admissible"]), (&Value::from(true), &Value::from(true)));
    for row in [&attractors[0], orbit] {
        let drift = numbers(&row["drift"]);
        assert!(drift.iter().all(|x| (x - simulated).abs() < 1e-11), "{drift:?} {simulated}");
    }
    let largest = moduli(orbit)[0].ln();
    assert!((attractors[0]["lyapunov_per_period"].as_f64().unwrap() - largest).abs() < 1e-8);
}

/// A spring to the ground, however it acts, holds what would drift; so does a formula that tells of a place.
#[test]
fn what_is_held_does_not_drift() {
    let held = CUBIC.replacen("f - ", "f - 0.01*tanh(q1) - ", 1);
    let tasks = BOTH.split("[[tasks]]\nname = \"branch\"").next().unwrap();
    for force in [held, LINEAR.replace("[[1, ", "[[1.01, ")] {
        let all = reports(&pair("stiffness = 20\ndamping = 0.1", &force, &tasks.replace("[5, 5]", "[1, 1]")));
        let attractors = all[0]["attractors"].as_array().unwrap();
        assert!(attractors.iter().all(|row| numbers(&row["drift"]).is_empty()), "{attractors:?}");
    }
}
