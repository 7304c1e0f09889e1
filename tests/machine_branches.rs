//! Branches and bifurcations of machines: against the one-degree code, against parts that do not know of each
//! other, against data that a script of its own computed (`tests/data/make_machine_bifurcations.py`).

use std::{f64::consts::TAU, fs, path::Path, process::Command};

use serde_json::Value;

/// Section 4.2 of the paper, in seconds and with a mass of 2.
const PAPER: &str = r#"
format = "grazing-scene 2"
title = "section 4.2 of the paper as a machine, in seconds"
[parameters]
d = 0.6
w = 4.9
mu = -0.05
[system]
period = 3
mass = 2
stiffness = "2*(2*pi/3)^2/w^2"
damping = "2*(2*pi/3)*2*d/w"
[[walls]]
name = "plate"
offset = -1
harmonics = [{ k = 1, cos = "1 + mu" }]
restitution = 1
"#;

/// The same in the forcing's phase, as an oscillator.
const ALONE: &str = r#"
format = "grazing-scene 1"
title = "section 4.2 of the paper"
[parameters]
d = 0.6
w = 4.9
mu = -0.05
[system]
damping = "2*d/w"
stiffness = "1/w^2"
[[walls]]
side = "lower"
offset = -1
harmonics = [{ k = 1, cos = "1 + mu" }]
restitution = 1
"#;

/// The paper's oscillator, whose coordinate is that of the first mass, and one that is forced beside it, with
/// a stop of its own; nothing couples them, but the coordinates are sums and differences.
const PAIR: &str = r#"
format = "grazing-scene 2"
title = "two oscillators that do not know of each other"
[parameters]
d = 0.6
w = 4.9
mu = -0.05
F = 1
[system]
period = "2*pi"
# x = q1 + q2 is the paper's, y = q1 − q2 a second one of mass 1, damping 1/10, stiffness 3/10.
mass = [[2, 0], [0, 2]]
damping = [["2*d/w + 1/10", "2*d/w - 1/10"], ["2*d/w - 1/10", "2*d/w + 1/10"]]
stiffness = [["1/w^2 + 3/10", "1/w^2 - 3/10"], ["1/w^2 - 3/10", "1/w^2 + 3/10"]]
forcing = [{ cos = ["F", "-F"] }]
[[walls]]
name = "first"
row = [1, 1]
offset = -1
harmonics = [{ k = 1, cos = "1 + mu" }]
restitution = 1
[[walls]]
name = "second"
row = [1, -1]
offset = -4
restitution = 1
"#;

fn task(name: &str, kind: &str, keys: &str) -> String {
    format!("[[tasks]]\nname = \"{name}\"\nkind = \"{kind}\"\n{keys}\n")
}

/// The report of a scene's tasks as JSON, the exit code and what was written to standard error.
fn run(scene: &str, tasks: &[String], folder: &Path) -> (Value, i32, String) {
    let file = folder.join("scene.toml");
    fs::write(&file, format!("{scene}{}", tasks.concat())).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["run", "--format", "json", "-o"])
        .arg(folder)
        .arg(&file)
        .output()
        .unwrap();
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    let report = serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {error}"));
    (report, output.status.code().unwrap(), error)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} and {b} differ by {:e}", a - b);
}

/// (label, row) of a task's labelled points.
fn labels(report: &Value) -> Vec<(String, &Value)> {
    let rows = report["labels"].as_array().unwrap_or_else(|| panic!("{report}")).iter();
    rows.map(|row| (format!("{} {}", row["branch"], row["label"].as_str().unwrap()), row)).collect()
}

/// Events and branches over the paper's µ: the same labels at the same values, the same speeds, multipliers
/// and phases, stop by stop.
#[test]
fn one_degree_of_freedom_bifurcates_as_by_the_one_degree_code() {
    let folder = tempfile::tempdir().unwrap();
    let tasks = |speed: f64| {
        let orbit =
            |n: &str, far: f64| format!("{{ pattern = [{n}], speed = {}, starts = 60 }}", speed * far);
        let event = |name: &str, what: &str, mu: f64, orbit: String| {
            let keys =
                format!("event = \"{what}\"\nparameter = \"mu\"\nset = {{ mu = {mu} }}\norbit = {orbit}");
            task(name, "event", &keys)
        };
        let starts = format!(
            "parameter = \"mu\"\nrange = [-0.1, 0.01]\nstarts = [{{ at = -0.05, orbit = {{}} }}, {{ at = -0.05, orbit = {} }}, \
             {{ at = 0.003, orbit = {} }}]\noptions = {{ most_step = 0.05 }}",
            orbit("4", 1.0),
            orbit("3", 1.0)
        );
        vec![
            event("pd", "flip", 0.005, orbit("3", 1.0)),
            event("sn", "saddle-node", -0.08, orbit("4", 1.0)),
            event("gr", "grazing", -0.03, orbit("4", 1.0)),
            task("all", "branch", &starts),
        ]
    };
    let rate = TAU / 3.0;
    let (machine, code, error) = run(PAPER, &tasks(rate), folder.path());
    assert_eq!(code, 0, "{error}{machine}");
    let (alone, code, error) = run(ALONE, &tasks(1.0), folder.path());
    assert_eq!(code, 0, "{error}{alone}");
    let same = |a: &Value, b: &Value| {
        let phase = |value: &Value| number(value) / TAU;
        for (a, b) in a["phases"].as_array().unwrap().iter().zip(b["phases"].as_array().unwrap()) {
            let turn = number(a) - phase(b);
            near(turn, turn.round(), 1e-9);
        }
        for (a, b) in a["speeds"].as_array().unwrap().iter().zip(b["speeds"].as_array().unwrap()) {
            near(number(a), number(b) * rate, 1e-9);
        }
        assert!(a["stable"] == b["stable"] && a["admissible"] == b["admissible"], "{a} {b}");
    };
    for i in 0..3 {
        let (a, b) = (&machine["tasks"][i], &alone["tasks"][i]);
        assert_eq!(a["found"].as_array().unwrap().len(), 1, "{a}");
        let (a, b) = (&a["found"][0], &b["found"][0]);
        near(number(&a["parameter"]), number(&b["parameter"]), 1e-12);
        if i < 2 {
            near(number(&a["multipliers"][0][0]), number(&b["lambda1"][0]), 1e-7);
            same(a, b);
        } else {
            assert_eq!(a["stop"], "plate");
            near(number(&a["phase"]), number(&b["phase"]) / TAU, 1e-8);
            near(number(&a["acceleration"]), number(&b["acceleration"]) * rate * rate, 1e-8);
        }
    }
    let (a, b) = (labels(&machine["tasks"][3]), labels(&alone["tasks"][3]));
    let names = |all: &[(String, &Value)]| all.iter().map(|row| row.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&a), names(&b));
    assert!(names(&a).len() >= 6 && names(&a).iter().any(|name| name == "1 grazing 1"), "{a:?}");
    for ((name, a), (_, b)) in a.iter().zip(&b) {
        near(number(&a["parameters"][0]), number(&b["parameters"][0]), 1e-12);
        // At a fade phases and multipliers are rounding's.
        if !name.contains("fade") {
            same(a, b);
        }
    }
    let note = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["run", "--only", "pd", "-o"])
        .arg(folder.path())
        .arg({
            let file = folder.path().join("paper.toml");
            fs::write(&file, format!("{PAPER}{}", tasks(rate)[0])).unwrap();
            file
        })
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&note.stdout).into_owned();
    assert!(text.contains("criticality is not computed for machines"), "{text}");
}

/// The orbit of the first oscillator beside the free motion of the second: its bifurcations are where they
/// are alone, until the second grazes its own stop.
#[test]
fn uncoupled_oscillators_bifurcate_where_each_does() {
    let folder = tempfile::tempdir().unwrap();
    let orbit = "{ pattern = [4], stops = [\"first\"], start = [0.878, 0.676] }";
    let three = "{ pattern = [3], stops = [\"first\"], start = [0.9917, 0.064] }";
    let event = |name: &str, what: &str, parameter: &str, mu: f64, reach: f64, orbit: &str| {
        let keys = format!(
            "event = \"{what}\"\nparameter = \"{parameter}\"\nset = {{ mu = {mu} }}\nreach = {reach}\norbit = {orbit}"
        );
        task(name, "event", &keys)
    };
    let tasks = [
        event("sn", "saddle-node", "mu", -0.03, 1.5, orbit),
        event("pd", "flip", "mu", 0.005, 0.5, three),
        event("gr", "grazing", "mu", -0.03, 0.5, orbit),
        event("other", "grazing", "F", -0.03, 3.0, orbit),
    ];
    let (report, code, error) = run(PAIR, &tasks, folder.path());
    assert_eq!(code, 0, "{error}{report}");
    let found = |i: usize| &report["tasks"][i]["found"][0];
    // Of section 4.2, as in docs/branches.md.
    near(number(&found(0)["parameter"]), -0.08433847008959, 1e-13);
    near(number(&found(1)["parameter"]), 0.00547904622125, 1e-13);
    near(number(&found(2)["parameter"]), -0.02444745630583, 1e-13);
    assert_eq!(found(2)["stop"], "first");
    // The second, y″ + y′/10 + 3y/10 = F cos t, has the amplitude F/|3/10 − 1 + i/10| and grazes y = −4 where
    // that is 4.
    near(number(&found(3)["parameter"]), 4.0 * (0.7f64 * 0.7 + 0.01).sqrt(), 1e-12);
    assert_eq!(found(3)["stop"], "second");
    // The multipliers of both are there: the second's are those of its damping.
    let modulus = (-0.1 * TAU * 4.0 / 2.0).exp();
    let all = found(0)["multipliers"].as_array().unwrap();
    let sizes: Vec<f64> = all.iter().map(|x| number(&x[0]).hypot(number(&x[1]))).collect();
    assert!(sizes.iter().filter(|size| (*size - modulus).abs() < 1e-10).count() == 2, "{sizes:?}");
}
