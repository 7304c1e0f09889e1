//! Scenes of format 1 in other units of length: the same orbits, events, labels, grazings and basins. Times
//! have the forcing's unit, so that lengths and velocities go with one factor.

use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};
use serde_json::Value;

use crate::samples::one_in;

/// Sinusoidal stop, linear: flips, saddle-nodes, a grazing.
const STOP: &str = r#"
[parameters]
d = 0.6
w = 4.9
mu = -0.05
[system]
damping = "2*d/w"
stiffness = "1/w^2"
[[walls]]
side = "lower"
offset = "-({L})"
harmonics = [{ k = 1, cos = "({L})*(1 + mu)" }]
restitution = 1
[[tasks]]
name = "motion"
kind = "simulate"
start = { q = "3/2*({L})" }
periods = 12
[[tasks]]
name = "orbits"
kind = "orbit"
set = { mu = 0.003 }
orbit = { pattern = [3], starts = 60 }
[[tasks]]
name = "flip"
kind = "event"
set = { mu = 0.003 }
event = "flip"
parameter = "mu"
orbit = { pattern = [3], starts = 60 }
[[tasks]]
name = "graze"
kind = "grazing"
seen = false # what is seen beyond is not periodic: its extent is of one run
parameter = "mu"
max_period = 3
[[tasks]]
name = "branch"
kind = "branch"
set = { mu = -0.05 }
parameter = "mu"
range = [-0.1, 0.01]
starts = [{ orbit = { pattern = [4], starts = 60 } }]
[[tasks]]
name = "basins"
kind = "basins"
q = { from = "-3/4*({L})", to = "2*({L})", count = 6 }
u = { from = "-({L})", to = "({L})", count = 6 }
transient = 200
"#;

/// A cubic spring between two stops, written as a formula that is not a polynomial.
const SPRING: &str = r#"
[parameters]
F = 1
[system]
force = "({L})*(-q/({L}) - (q/({L}))^3/2 - 1/5*u/({L}) + sin(q/({L}))/10 + F*cos(t))"
[[walls]]
side = "lower"
offset = "-({L})/2"
restitution = "7/10"
[[walls]]
side = "upper"
offset = "3*({L})"
restitution = "7/10"
[[tasks]]
name = "motion"
kind = "simulate"
start = { q = 0 }
periods = 20
[[tasks]]
name = "branch"
kind = "branch"
parameter = "F"
range = [0.2, 2]
starts = [{ attractor = { q = 0, u = 0 } }]
[[tasks]]
name = "free"
kind = "orbit"
set = { F = "1/10" }
orbit = { pattern = [] }
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = 0 }, { q = "({L})" }]
transient = 300
points = 50
"#;

/// What a number of a report is in: columns that are lengths or velocities.
const LENGTHS: [&str; 13] = [
    "q",
    "u",
    "speeds",
    "least_gap",
    "residual",
    "acceleration",
    "extent",
    "minimum_depth",
    "unit",
    "fastest",
    "strongest",
    "impulse",
    "largest_gap",
];
/// Columns whose numbers go with coordinates, or with the metric of a curve; what a certificate says of
/// units.
const OTHER: [&str; 5] = ["coefficient", "gamma", "e", "B", "detail"];
/// What depends on the last digits where the unit is no power of two.
const WORK: [&str; 5] = ["residual", "newton_steps", "effects", "points", "length"];
/// A multiplier beyond this is one over an impact's speed that rounding leaves where it fades.
const POLE: f64 = 1e12;

fn report(scene: &str, unit: &str) -> Value {
    let text = format!("format = \"grazing-scene 1\"\ntitle = \"a unit\"\n{}", scene.replace("{L}", unit));
    let scene = Scene::from_toml(&text, "units.toml").unwrap_or_else(|error| panic!("{error}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    serde_json::to_value(&reports).unwrap()
}

/// Compares two reports, the second with lengths `unit` times those of the first; the differences.
fn compare(path: &str, key: &str, a: &Value, b: &Value, unit: f64, exact: bool, all: &mut Vec<String>) {
    // At a grazing rounding decides on which side an orbit is.
    let decided = key == "reason" && path.contains("labels");
    if OTHER.contains(&key) || key == "place" || !exact && (decided || WORK.contains(&key)) {
        return;
    }
    match (a, b) {
        (Value::Object(x), Value::Object(y)) => {
            if x.keys().ne(y.keys()) {
                all.push(format!("{path}: other keys"));
                return;
            }
            // A motion that has died down to 10⁻¹⁵⁰ is taken for rest, whatever the unit: floats end there.
            let rests = x.get("kind").is_some_and(|kind| kind == "basins");
            for (name, value) in x.iter().filter(|(name, _)| !(rests && *name == "effects")) {
                compare(&format!("{path}.{name}"), name, value, &y[name], unit, exact, all);
            }
        }
        (Value::Array(x), Value::Array(y)) => {
            if x.len() != y.len() {
                all.push(format!("{path}: {} rows for {}", y.len(), x.len()));
                return;
            }
            for (i, (x, y)) in x.iter().zip(y).enumerate() {
                compare(&format!("{path}[{i}]"), key, x, y, unit, exact, all);
            }
        }
        (Value::Number(x), Value::Number(y)) => {
            let (x, y) = (x.as_f64().unwrap(), y.as_f64().unwrap());
            let factor = match key {
                // An energy.
                "dissipated" => unit * unit,
                _ if LENGTHS.contains(&key) => unit,
                _ => 1.0,
            };
            let near = if exact {
                x * factor == y
            } else {
                // Lengths that are rounding's are 0; the rest has lost some digits by multipliers.
                let pole = key == "multipliers" && x.abs().min(y.abs()) > POLE;
                pole || (x - y / factor).abs() <= 1e-7 * x.abs().max(1e-4)
            };
            if !near {
                all.push(format!("{path}: {y:?} for {:?}", x * factor));
            }
        }
        (Value::String(x), Value::String(y)) if !exact => {
            let words = |text: &str| text.chars().filter(char::is_ascii_alphabetic).collect::<String>();
            if words(x) != words(y) {
                all.push(format!("{path}: {y} for {x}"));
            }
        }
        _ if a != b => all.push(format!("{path}: {b} for {a}")),
        _ => {}
    }
}

fn differences(scene: &str, units: &[(&str, f64)], exact: bool) -> Vec<String> {
    let own = report(scene, "1");
    let text = own.to_string();
    assert!(!text.contains("\"failed\""), "{text}");
    let mut all = Vec::new();
    for &(text, unit) in units.iter().step_by(one_in(3)) {
        let other = report(scene, text);
        let mut found = Vec::new();
        compare("", "", &own, &other, unit, exact, &mut found);
        all.extend(found.into_iter().map(|one| format!("unit {text}: {one}")));
    }
    all
}

/// Even powers of two: local maps take the square root of a length.
const BINARY: [(&str, f64); 3] = [("1/1048576", 1.0 / 1_048_576.0), ("1048576", 1_048_576.0), ("4", 4.0)];
const DECIMAL: [(&str, f64); 2] = [("1/1000000", 1e-6), ("1000000", 1e6)];

/// To the last bit: scaling by powers of two rounds nothing.
#[test]
fn units_that_are_powers_of_two_change_no_bit() {
    for scene in [STOP, SPRING] {
        let all = differences(scene, &BINARY, true);
        assert!(all.is_empty(), "{} differences:\n{}", all.len(), all[..all.len().min(20)].join("\n"));
    }
}

#[test]
fn a_millionth_and_a_million_of_the_unit_say_the_same() {
    for scene in [STOP, SPRING] {
        let all = differences(scene, &DECIMAL, false);
        assert!(all.is_empty(), "{} differences:\n{}", all.len(), all[..all.len().min(20)].join("\n"));
    }
}
