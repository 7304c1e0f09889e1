//! The page's requests against the library run on its own, against the command line, and against theory.

use std::{fs, path::PathBuf, process::Command};

use grazing_scenes::{
    run::{Job, RunReport, Surroundings, run_task},
    scene::Scene,
};
use serde_json::{Value, json};

use super::{answered, document::Changeable, request::toml, theory::Local};

fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// A request about a scene, with what it needs besides.
fn request(text: &str, name: &str, more: Value) -> String {
    let mut all = json!({ "text": text, "name": name });
    for (key, value) in more.as_object().unwrap() {
        all[key] = value.clone();
    }
    all.to_string()
}

fn paper(more: Value) -> String {
    request(super::PAPER, "nordmark-2001.toml", more)
}

fn ask(answer: String) -> Value {
    let value: Value = serde_json::from_str(&answer).unwrap();
    assert!(value["error"].is_null(), "{value}");
    value
}

fn examples() -> Vec<(String, String)> {
    let mut all = Vec::new();
    for folder in ["scenes", "machines"] {
        for entry in fs::read_dir(root().join("examples").join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "toml") {
                let name = format!("{folder}/{}", path.file_name().unwrap().to_str().unwrap());
                all.push((name, fs::read_to_string(&path).unwrap()));
            }
        }
    }
    all.sort();
    all
}

#[test]
fn the_papers_scene_has_a_slider_for_each_parameter() {
    let found = ask(super::motion_open(&paper(json!({}))));
    let names: Vec<&str> =
        found["parameters"].as_array().unwrap().iter().map(|p| p["name"].as_str().unwrap()).collect();
    // The wall's mean, -1, has no name in the scene.
    assert_eq!(names, ["d", "w", "tau", "mu", "offset"]);
    let by = |name: &str| &found["parameters"][names.iter().position(|known| *known == name).unwrap()];
    assert_eq!(by("d")["about"], "damping ratio");
    // The range is that of the scene's own branches, 1 is a restitution's end, and w = 0 is none.
    assert_eq!(by("mu")["range"], json!([-0.1, 0.01]));
    assert_eq!(by("tau")["range"], json!([0.0, 1.0]));
    assert!(by("w")["range"][0].as_f64().unwrap() > 0.0);
    assert_eq!(by("offset")["named_here"], true);
    assert_eq!(
        (&found["parameter"], &found["frame"], &found["phase"]),
        (&json!("mu"), &json!("lower"), &json!("1/2"))
    );
    assert_eq!(found["start"], json!({ "phase": "0", "q": "1.5", "u": "0" }));
    // A value whose numerator and denominator are beyond floats has the slider of the one beside it.
    let long = super::PAPER.replace("d = 0.6 ", "d = \"0.6+2^-1200\" ");
    let long = ask(super::motion_open(&request(&long, "long.toml", json!({}))));
    assert_eq!(long["parameters"][0]["range"], by("d")["range"]);
}

/// With its numbers named the scene is the same: equal tasks give equal reports, but for lines and for the
/// values that now are parameters.
#[test]
fn a_scene_whose_numbers_have_names_moves_the_same() {
    let mut compared = 0;
    for (name, text) in examples() {
        let Ok(changeable) = Changeable::new(&text, &name) else {
            assert!(text.contains("file = "), "{name} is refused, and reads no file");
            continue;
        };
        let start = &ask(super::motion_open(&request(&text, &name, json!({}))))["start"];
        let part = |key: &str| toml(start[key].as_str().unwrap());
        let start = format!("{{ phase = {}, q = {}, u = {} }}", part("phase"), part("q"), part("u"));
        let task = format!("[[tasks]]\nname = \"page\"\nkind = \"simulate\"\nstart = {start}\nperiods = 5\n");
        let whole = |text: &str| {
            let scene = Scene::from_toml(text, &name).unwrap_or_else(|error| panic!("{error}\n{text}"));
            let last = scene.tasks.last().unwrap();
            let job = Job::new(&scene, last, Surroundings::default()).unwrap();
            let mut report = serde_json::to_value(run_task(&job, &mut ())).unwrap();
            report["place"] = Value::Null;
            report["parameters"] = Value::Null;
            report
        };
        let named = whole(&changeable.with(&[], &task).unwrap());
        assert_eq!(named, whole(&format!("{text}\n{task}")), "{name}");
        compared += 1;
    }
    assert!(compared > 15, "{compared}");
}

#[test]
fn numbers_without_a_name_get_one_and_can_be_changed() {
    let text = r#"
format = "grazing-scene 1"
title = "as in the README"   # kept

[parameters]
F = 0.5                      # amplitude

[system]
damping = "1/10"             # this, too
stiffness = "3/10"
forcing = [{ cos = "F" }, { k = 2, sin = 0.25 }]

[[walls]]
side = "upper"
offset = 1
restitution = 0.8

[[tasks]]
name = "after"
kind = "simulate"
start = { q = 0 }
periods = 3
"#;
    let changeable = Changeable::new(text, "machine.toml").unwrap();
    let names: Vec<&str> = changeable.parameters.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names, ["F", "damping", "stiffness", "forcing_sin2", "offset", "restitution"]);
    let values = [("F", "3/8"), ("damping", "0.2"), ("forcing_sin2", "1/3"), ("restitution", "2^-1")];
    let values: Vec<(String, String)> = values.map(|(name, value)| (name.into(), value.into())).into();
    // The text of the page's own scene, and the scene's own text with numbers in their places.
    let named = Scene::from_toml(&changeable.with(&values, "").unwrap(), "a").unwrap().exact(&[]).unwrap();
    let (edited, changes) = changeable.in_place(&values).unwrap();
    let placed = Scene::from_toml(&edited, "b").unwrap().with(&changes).unwrap().exact(&[]).unwrap();
    assert_eq!(named, placed);
    assert_eq!(named.damping.to_string(), "1/5");
    assert_eq!(named.upper.as_ref().unwrap().restitution.to_string(), "1/2");
    assert_eq!(
        (named.forcing[0].cos.to_string(), named.forcing[1].sin.to_string()),
        ("3/8".into(), "1/3".into())
    );
    assert_eq!(edited.lines().count(), text.lines().count());
    assert!(edited.contains("# this, too") && edited.contains("as in the README"));
    // What is not a number, and what is no parameter.
    for (name, value, says) in [("F", "much", "parameter F"), ("G", "1", "no parameter \"G\"")] {
        let error = changeable.with(&[(name.into(), value.into())], "").unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    }
}

/// Sliders are in the scene's units, and values may be typed in any.
#[test]
fn parameters_with_units_can_be_changed() {
    let text = r#"
format = "grazing-scene 3"
title = "t"
[parameters]
F = "400 mN"    # amplitude
m = "2 kg"
z = "2 %"
[system]
frequency = "4 Hz"
mass = "m + 50 g"
damping_ratio = "z"
stiffness = "0.8 N/mm"
forcing = [{ cos = "F" }]
[[stops]]
side = "upper"
offset = "1 mm"
restitution = "80 %"
"#;
    let found = ask(super::motion_open(&request(text, "s.toml", json!({}))));
    let read: Vec<[&Value; 3]> = found["parameters"].as_array().unwrap()[..3]
        .iter()
        .map(|parameter| ["name", "value", "unit"].map(|key| &parameter[key]))
        .collect();
    let wanted = [json!(["F", "0.4", "N"]), json!(["m", "2", "kg"]), json!(["z", "0.02", null])];
    assert_eq!(json!(read), json!(wanted));
    let changeable = Changeable::new(text, "s.toml").unwrap();
    for (given, exact) in [("1/2", "1/2"), ("300 mN", "3/10"), ("0.4", "2/5")] {
        let values = [("F".to_string(), given.to_string()), ("z".into(), "1/3".into())];
        let scene = Scene::from_toml(&changeable.with(&values, "").unwrap(), "s.toml").unwrap();
        let (_, changes) = changeable.in_place(&values).unwrap();
        assert_eq!(scene.parameters[0].1.to_string(), exact);
        assert_eq!(changeable.scene.with(&changes).unwrap().parameters, scene.parameters);
    }
    let error = changeable.with(&[("F".into(), "3 kg".into())], "").unwrap_err().to_string();
    assert!(error.contains("is a mass, and in s.toml F is a force"), "{error}");
    let words =
        ask(super::motion_born(&request(text, "s.toml", json!({ "parameter": "F", "max_period": 2 }))));
    let first = words["answer"][0]["text"].as_str().unwrap();
    assert!(first.contains(" mN the motion without impacts touches"), "{first}");
}

#[test]
fn errors_have_the_line_and_the_key_of_the_command_line() {
    let broken = super::PAPER.replace("stiffness = \"1/w^2\"", "stiffnes = \"1/w^2\"");
    let answer: Value =
        serde_json::from_str(&super::motion_open(&request(&broken, "s.toml", json!({})))).unwrap();
    let error = &answer["error"];
    let line = super::PAPER.lines().position(|line| line.starts_with("stiffness")).unwrap() + 1;
    assert_eq!(error["line"], line);
    assert_eq!(error["key"], "system");
    assert!(error["message"].as_str().unwrap().contains("the nearest known key is \"stiffness\""), "{error}");
    // Errors without a line, and requests that are none.
    let answer: Value = serde_json::from_str(&super::motion_open("{")).unwrap();
    assert!(answer["error"]["line"].is_null() && answer["error"]["message"].is_string());
    let negative = paper(json!({ "values": { "tau": "-1" } }));
    let answer: Value = serde_json::from_str(&super::motion_series(&negative)).unwrap();
    assert!(answer["error"]["message"].as_str().unwrap().contains("a restitution is at least 0"), "{answer}");
    let answer: Value = serde_json::from_str(&super::motion_series(&paper(json!({ "periods": 0 })))).unwrap();
    assert!(answer["error"]["message"].as_str().unwrap().contains("from 1 to 2000"), "{answer}");
}

/// The series is that of the library; at every impact it has the speeds before and after, of which the law of
/// impacts holds.
#[test]
fn impacts_turn_the_relative_velocity() {
    let found = ask(super::motion_series(&paper(json!({
        "values": { "mu": "0.003" }, "start": { "phase": "0", "q": "1", "u": "0" }, "transient": 200, "periods": 20,
    }))));
    let strikes = found["strikes"].as_array().unwrap();
    assert!(strikes.len() > 3 && found["report"]["impacts"] == strikes.len());
    let (times, rates): (Vec<f64>, Vec<f64>) = (floats(&found["times"]), floats(&found["rates"]));
    for strike in strikes {
        let time = strike["time"].as_f64().unwrap();
        let i = times.iter().position(|t| *t == time).unwrap();
        let wall = -1.003 * (std::f64::consts::TAU * strike["phase"].as_f64().unwrap()).sin();
        let speed = strike["speed"].as_f64().unwrap();
        assert_eq!(times[i + 1], time);
        assert!((rates[i] - (wall - speed)).abs() < 1e-9 && (rates[i + 1] - (wall + speed)).abs() < 1e-9);
    }
    assert!(times.is_sorted());
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap_or(f64::NAN)).collect()
}

/// All numbers of a list, those of lists in it too.
fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .map_or_else(|| value.as_f64().into_iter().collect(), |all| all.iter().flat_map(numbers).collect())
}

/// The stable orbit of period 4 of the paper at µ = −0.05, as the scene's own task finds it by a search.
#[test]
fn multipliers_are_those_of_the_orbit_that_a_search_finds() {
    let found = ask(super::motion_section(&paper(json!({
        "values": { "mu": "-0.05" }, "start": { "q": "2" }, "phase": "1/2", "frame": "lower", "transient": 1000,
    }))));
    let row = &found["report"]["attractors"][0];
    assert_eq!((&row["period"], &row["impacts"]), (&json!(4), &json!(1)));
    let orbit = &found["orbit"]["report"]["orbits"][0];
    assert_eq!(
        (&orbit["stable"], &orbit["admissible"], &orbit["pattern"]),
        (&json!(true), &json!(true), &json!("4"))
    );
    let scene = super::PAPER.to_string()
        + "\n[[tasks]]\nname = \"search\"\nkind = \"orbit\"\norbit = { pattern = [4] }\n";
    let scene = Scene::from_toml(&scene, "search").unwrap();
    let job = Job::new(&scene, scene.tasks.last().unwrap(), Surroundings::default()).unwrap();
    let searched = serde_json::to_value(run_task(&job, &mut ())).unwrap();
    let stable = searched["orbits"].as_array().unwrap().iter().find(|row| row["stable"] == true).unwrap();
    for key in ["multipliers", "speeds"] {
        for (one, other) in numbers(&orbit[key]).iter().zip(numbers(&stable[key])) {
            assert!((one - other).abs() < 1e-9, "{key}: {orbit} {stable}");
        }
    }
    // The motion at rest, which has no impacts, and one that is not periodic.
    let rest =
        ask(super::motion_section(&paper(json!({ "values": { "mu": "-0.05" }, "start": { "q": "0" } }))));
    assert_eq!(rest["orbit"]["report"]["orbits"][0]["pattern"], "free 1");
    let chaos =
        ask(super::motion_section(&paper(json!({ "values": { "mu": "0.003" }, "start": { "q": "1" } }))));
    assert!(chaos["orbit"].is_null() && chaos["report"]["attractors"][0]["periodic"] == false);
}

/// Pieces of a diagram are, bit for bit, the parts of the whole.
#[test]
fn a_diagram_in_pieces_is_the_whole() {
    let piece = |first: u64, last: u64| {
        let found = ask(super::motion_attractor(&paper(json!({
            "parameter": "mu", "from": "-0.03", "to": "1/300", "count": 8, "first": first, "last": last,
            "start": { "q": "1" }, "phase": "1/2", "frame": "lower", "transient": 100, "points": 20,
        }))));
        found["slices"].as_array().unwrap().clone()
    };
    let pieces: Vec<Value> =
        [piece(0, 2), piece(3, 3), piece(4, 6), piece(7, 7)].into_iter().flatten().collect();
    assert_eq!(pieces, piece(0, 7));
    assert_eq!(pieces.len(), 8);
}

/// The predicted speeds are, to first order, those of the orbits that Newton's method finds in the true
/// system 10⁻⁶ from the grazing.
#[test]
fn predicted_speeds_are_those_of_the_true_system_near_by() {
    let mut compared = 0;
    for (name, parameter) in [
        ("scenes/nordmark-2001.toml", "mu"),
        ("scenes/nordmark-2001-w48.toml", "mu"),
        ("machines/two-masses.toml", "F0"),
    ] {
        let text = fs::read_to_string(root().join("examples").join(name)).unwrap();
        // At 12 N, as in its scene, the two masses hit each other already; the range has free motions.
        let more = json!({ "parameter": parameter, "max_period": 4, "from": "1", "to": "20" });
        let found = ask(super::motion_born(&request(&text, name, more)));
        let report = &found["report"];
        let at = report["parameter"].as_f64().unwrap();
        for (row, slopes) in
            report["born"].as_array().unwrap().iter().zip(found["slopes"].as_array().unwrap())
        {
            if slopes.is_null() || row["speeds"].is_null() {
                continue;
            }
            let away = (row["found_at"].as_f64().unwrap() - at).abs();
            for (slope, speed) in floats(slopes).iter().zip(floats(&row["speeds"])) {
                assert!((slope * away / speed - 1.0).abs() < 2e-3, "{name}: {row} {slopes}");
                compared += 1;
            }
        }
    }
    assert!(compared >= 10, "{compared}");
}

/// (57) for one impact: V/|eµ| = (p_n − q_n)/(1 + τ) with p_n and q_n of the map's closed forms.
#[test]
fn predicted_speeds_follow_the_closed_form_of_one_impact() {
    let (a1, a2, tau, acceleration) = (0.48, 0.21f64, 1.0, 1.0);
    let local = Local {
        a: vec![vec![0.0, 1.0], vec![-a2, a1]],
        b: vec![0.0, (2.0f64 * acceleration).sqrt() * (1.0 + tau)],
        c: vec![1.0, 0.0],
        acceleration,
        e: -1.0,
    };
    let u = |n: i32| -> f64 {
        let (mut now, mut next) = (0.0, 1.0);
        for _ in 0..n {
            (now, next) = (next, a1 * next - a2 * now);
        }
        now
    };
    for n in 1..=4 {
        let p = (u(n + 1) - 1.0) / u(n);
        let q = (a2.powi(n) + a2 * u(n - 1)) / u(n);
        // x(n) = (−1, −y): of A = [[0, 1], [−a₂, a₁]] the second coordinates are those of words, up to sign.
        let [speed] = local.speeds(&[n as u64]).unwrap()[..] else { panic!() };
        assert!((speed - (p - q).abs() / (1.0 + tau)).abs() < 1e-12, "{n}: {speed} {p} {q}");
    }
}

#[test]
fn the_theory_in_words() {
    let found = ask(super::motion_born(&paper(json!({ "parameter": "mu", "max_period": 4 }))));
    let all = |value: &Value, key: &str| {
        let text = |one: &Value| if key.is_empty() { one.clone() } else { one[key].clone() };
        let texts = value.as_array().unwrap().iter().map(|one| text(one).as_str().unwrap().to_string());
        texts.collect::<Vec<_>>().join("\n")
    };
    let words = all(&found["sentences"], "");
    assert!(words.contains("a₁ = 0.480348, a₂ = 0.214652, region 3, γ > 0"), "{words}");
    assert!(words.contains("mu > 0, case (−,+): the orbits of periods 1, 2, 3 with one impact"), "{words}");
    assert!(words.contains("chaos") && words.contains("entropy 0.609378"), "{words}");
    assert!(words.contains("mu < 0, case (+,+): the orbit of period 4 with one impact"), "{words}");
    // What it does is told in the words of the report.
    let answer = all(&found["answer"], "text");
    assert!(answer.starts_with("At mu = 0 the motion without impacts touches stop"), "{answer}");
    assert!(answer.contains("Just beyond, at mu = 0.0002, "), "{answer}");
    let bands = found["report"]["bands_in_words"].as_str().unwrap();
    assert!(answer.ends_with(bands) && bands.contains("always hits"), "{answer}");
    assert_eq!(
        found["place"]["a1"].as_str().unwrap().parse::<f64>().unwrap(),
        found["report"]["a1"].as_f64().unwrap()
    );
}

/// The branch of period 3 begins where the theory says and loses its stability at the paper's flip.
#[test]
fn a_branch_starts_along_the_prediction() {
    let found = ask(super::motion_born(&paper(json!({ "parameter": "mu", "max_period": 3 }))));
    let rows = found["report"]["born"].as_array().unwrap();
    let i = rows.iter().position(|row| row["pattern"] == "3").unwrap();
    let row = &rows[i];
    let branch = ask(super::motion_branch(&paper(json!({
        "parameter": "mu", "from": "-0.01", "to": "0.01", "pattern": "3", "wall": "lower",
        "at": [row["found_at"]], "phases": row["phases"], "speeds": row["speeds"],
        "grazing": [found["report"]["parameter"]], "slopes": found["slopes"][i],
    }))));
    let points = branch["points"].as_array().unwrap();
    assert!(points.len() > 5);
    let flip = points.iter().find(|point| point["label"] == "flip 1").unwrap();
    // The paper's µ_pd, in its digits.
    assert!((flip["parameter"].as_f64().unwrap() - 0.005479).abs() < 5e-7, "{flip}");
    let valid = branch["within_tenth"].as_f64().unwrap();
    assert!(valid > 1e-5 && valid < 0.01, "{valid}");
}

/// The same numbers as the command line: twenty scenes and values of parameters, byte for byte but for the
/// names of files, which the page does not write.
#[test]
fn tasks_print_what_the_command_line_prints() {
    type Case = (&'static str, &'static str, &'static [(&'static str, &'static str)]);
    let cases: [Case; 23] = [
        ("scenes/nordmark-2001.toml", "motion", &[]),
        ("scenes/nordmark-2001.toml", "motion", &[("mu", "0.003")]),
        (
            "scenes/nordmark-2001.toml",
            "motion",
            &[("d", "1/3"), ("w", "5.1"), ("tau", "0.7"), ("mu", "0.02")],
        ),
        ("scenes/nordmark-2001.toml", "figure8", &[]),
        ("scenes/nordmark-2001.toml", "grazing", &[]),
        ("scenes/nordmark-2001.toml", "grazing", &[("w", "4.8")]),
        ("scenes/nordmark-2001.toml", "mu_pd", &[]),
        ("scenes/nordmark-2001.toml", "mu_sn", &[]),
        ("scenes/nordmark-2001.toml", "mu_gr4", &[("tau", "0.95")]),
        ("scenes/nordmark-2001.toml", "period-4", &[]),
        ("scenes/bouncing-ball.toml", "bounces", &[]),
        ("scenes/bouncing-ball.toml", "bounces", &[("a", "1/2")]),
        ("scenes/two-sided.toml", "", &[]),
        ("scenes/duffing-wall.toml", "", &[]),
        ("scenes/free.toml", "", &[]),
        ("machines/two-masses.toml", "settled", &[]),
        ("machines/two-masses.toml", "settled", &[("F0", "15.5")]),
        ("machines/valve.toml", "cycles", &[]),
        ("machines/print-hammer.toml", "", &[("preload", "11")]),
        ("machines/mems-switch.toml", "switching", &[]),
        ("machines/belt.toml", "squeal", &[("v", "0.2")]),
        ("machines/belt.toml", "pushed", &[]),
        ("machines/capsule.toml", "walk", &[]),
    ];
    let folder = std::env::temp_dir().join(format!("grazing-web-{}", std::process::id()));
    for (file, task, values) in cases {
        let path = root().join("examples").join(file);
        let text = fs::read_to_string(&path).unwrap();
        let first = || Scene::from_toml(&text, file).unwrap().tasks[0].name.clone();
        let task = if task.is_empty() { first() } else { task.to_string() };
        let set: serde_json::Map<String, Value> =
            values.iter().map(|(name, value)| (name.to_string(), json!(value))).collect();
        let asked = request(&text, &path.display().to_string(), json!({ "task": task, "values": set }));
        let found = ask(super::motion_task(&asked));
        let mut command = Command::new(program());
        command.args(["run", "--format", "json", "--only", &task, "-o"]).arg(&folder).arg(&path);
        for (name, value) in values {
            command.args(["--set", &format!("{name}={value}")]);
        }
        let output = command.output().unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        assert_eq!(
            without_files(found["json"].as_str().unwrap()),
            without_files(printed.trim_end()),
            "{file} {task}"
        );
    }
    fs::remove_dir_all(&folder).unwrap();
}

/// The command line: GRAZING, or what the root has built.
fn program() -> PathBuf {
    if let Some(given) = std::env::var_os("GRAZING") {
        return given.into();
    }
    let target = std::env::var_os("GRAZING_TARGET").map_or_else(|| root().join("target"), PathBuf::from);
    let built = ["debug", "release"].map(|profile| target.join(profile).join("grazing"));
    built
        .into_iter()
        .find(|path| path.exists())
        .expect("build the command line first: `cargo build` in the root, or set GRAZING to the program")
}

/// A report without the list of its files.
fn without_files(text: &str) -> String {
    let mut lines = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        match line.trim() {
            "\"files\": []" => lines.push(line.replace("[]", "…")),
            "\"files\": [" => {
                lines.push(line.replace('[', "…"));
                inside = true;
            }
            "]" if inside => inside = false,
            _ if inside => {}
            _ => lines.push(line.to_string()),
        }
    }
    lines.join("\n")
}

/// The scene of the page's views runs, and has the tasks of all views.
#[test]
fn the_scene_of_the_views_runs_on_the_command_line() {
    let found = ask(super::motion_scene(&paper(json!({
        "values": { "mu": "-0.02", "offset": "-1.01" }, "parameter": "mu", "from": "-0.05", "to": "0.01", "count": 5,
        "start": { "phase": "0", "q": "1", "u": "0" }, "phase": "1/2", "frame": "lower", "transient": 20, "points": 20,
    }))));
    let scene = Scene::from_toml(found["text"].as_str().unwrap(), "views").unwrap();
    let names: Vec<&str> = scene.tasks.iter().map(|task| task.name.as_str()).collect();
    assert_eq!(names, ["motion", "section", "attractor", "born"]);
    assert_eq!(scene.exact(&[]).unwrap().lower.unwrap().offset.to_string(), "-101/100");
    for task in &scene.tasks {
        let report = run_task(&Job::new(&scene, task, Surroundings::default()).unwrap(), &mut ());
        assert!(report.findings.is_some(), "{report}");
        assert!(RunReport::new(&scene.title, None, &[report]).to_json().unwrap().contains("grazing-run 4"));
    }
}

/// What the page asks of every example: it opens, moves, and has a section; what cannot be is said.
#[test]
fn every_example_is_shown_or_refused_in_words() {
    for (name, text) in examples() {
        let open: Value =
            serde_json::from_str(&super::motion_open(&request(&text, &name, json!({})))).unwrap();
        if !open["error"].is_null() {
            assert!(open["error"]["message"].as_str().unwrap().len() > 20, "{name}: {open}");
            continue;
        }
        let seen = if open["machine"] == true { "q1" } else { "" };
        let more = json!({ "start": open["start"], "seen": seen, "transient": 5, "periods": 2, "points": 3 });
        for answer in [super::motion_series, super::motion_section] {
            let found: Value = serde_json::from_str(&answer(&request(&text, &name, more.clone()))).unwrap();
            let message = found["error"]["message"].as_str().unwrap_or_default();
            assert!(found["error"].is_null() || !message.contains("page's request"), "{name}: {message}");
            assert!(found["error"].is_null(), "{name}: {message}");
        }
    }
    assert_eq!(answered("[]", |_| Ok(json!(1))), "1");
}

/// A response's answer is a picture: the page's program is without it, and says who has it.
#[test]
fn what_the_page_leaves_out_is_refused_in_words() {
    let text = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nstiffness = 2\n\
                damping = 1\nforcing = [{ cos = 1 }]\n[[tasks]]\nname = \"swing\"\nkind = \"response\"\nparameter = \"w\"\n\
                range = [1, 2]\n[[tasks]]\nname = \"orbit\"\nkind = \"orbit\"\norbit = { pattern = [] }\n";
    let said = |task: &str| {
        let found = ask(super::motion_task(&request(text, "t.toml", json!({ "task": task }))));
        found["report"].as_str().unwrap().to_string()
    };
    let report = said("swing");
    assert!(report.contains("failed: ") && report.contains("`grazing run` has them"), "{report}");
    assert!(said("orbit").contains("done"), "{}", said("orbit"));
}
