//! Branches and bifurcations of machines: against the one-degree code, against parts that do not know of each
//! other, against data that a script of its own computed (`tests/data/make_machine_bifurcations.py`).

mod normal_forms;
mod touches;
use crate::tasks;

use std::{
    f64::consts::{PI, TAU},
    fs,
    process::Command,
};

use serde_json::Value;

use tasks::{PAPER_MACHINE, ball, near, number, run, task};

/// Section 4.2 of the paper in the forcing's phase, as an oscillator.
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
            task(
                "born",
                "branch",
                "parameter = \"mu\"\nrange = [0, 0.01]\noptions = { most_step = 0.05 }\nstarts = [{ restart = { file = \"all-3.json\", \
                 label = \"flip 1\", switch = true } }]",
            ),
        ]
    };
    let rate = TAU / 3.0;
    let (machine, code, error) = run(PAPER_MACHINE, &tasks(rate), folder.path());
    assert_eq!(code, 0, "{error}{machine}");
    let (alone, code, error) = run(ALONE, &tasks(1.0), folder.path());
    assert_eq!(code, 0, "{error}{alone}");
    let same = |a: &Value, b: &Value| {
        for (a, b) in a["phases"].as_array().unwrap().iter().zip(b["phases"].as_array().unwrap()) {
            let turn = number(a) - number(b);
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
            near(number(&a["multipliers"][0][0]), number(&b["multipliers"][0][0]), 1e-7);
            same(a, b);
            // The same normal form, but for the unit of ξ.
            let (periods, multiplier, power) = if i == 0 { (3, -1.0, 2) } else { (4, 1.0, 1) };
            let length = normal_forms::length(b, periods, multiplier).powi(power);
            let (own, wanted) = (number(&a["coefficient"]), number(&b["coefficient"]) / length);
            assert!((own.abs() - wanted.abs()).abs() <= 1e-6 * wanted.abs(), "{own} {wanted}");
            assert!(i == 1 || own * wanted > 0.0, "{own} {wanted}");
        } else {
            assert_eq!(a["stop"], "plate");
            near(number(&a["phase"]), number(&b["phase"]), 1e-8);
            near(number(&a["acceleration"]), number(&b["acceleration"]) * rate * rate, 1e-8);
        }
    }
    // The doubled orbit is born at the flip and grazes where the paper says.
    let (a, b) = (labels(&machine["tasks"][4]), labels(&alone["tasks"][4]));
    assert!(a.len() == b.len() && a[0].0 == "1 grazing 1" && a[0].1["pattern"] == "3,3", "{a:?} {b:?}");
    near(number(&a[0].1["parameters"][0]), number(&b[0].1["parameters"][0]), 1e-11);
    near(number(&a[0].1["parameters"][0]), 0.00609992867161, 1e-13);
    let (a, b) = (labels(&machine["tasks"][3]), labels(&alone["tasks"][3]));
    let names = |all: &[(String, &Value)]| all.iter().map(|row| row.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&a), names(&b));
    assert!(names(&a).len() >= 6 && names(&a).iter().any(|name| name == "1 grazing 1"), "{a:?}");
    for ((name, a), (_, b)) in a.iter().zip(&b) {
        near(number(&a["parameters"][0]), number(&b["parameters"][0]), 1e-12);
        assert_eq!(a["criticality"], b["criticality"], "{name}");
        // At a fade phases and multipliers are rounding's.
        if !name.contains("fade") {
            same(a, b);
        }
    }
}

/// The ball on a table, of which everything is known in closed form, as a machine without stiffness.
#[test]
fn a_ball_on_a_table_bifurcates_where_the_closed_form_says() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "format = \"grazing-scene 2\"\ntitle = \"a ball on a table\"\n[parameters]\na = 1.2\n[system]\n\
                 period = \"2*pi\"\nmass = 1\nforce = -1\n[[walls]]\nname = \"table\"\noffset = 0\n\
                 harmonics = [{ sin = \"a\" }]\nrestitution = \"3/5\"\n";
    let event = |name: &str, what: &str| {
        let keys = format!(
            "event = \"{what}\"\nparameter = \"a\"\nreach = 3\norbit = {{ pattern = [1], speed = 4 }}"
        );
        task(name, "event", &keys)
    };
    let tasks = [event("sn", "saddle-node"), event("pd", "flip")];
    let (report, code, error) = run(scene, &tasks, folder.path());
    assert_eq!(code, 0, "{error}{report}");
    for (i, value) in ball().into_iter().enumerate() {
        let found = report["tasks"][i]["found"].as_array().unwrap();
        assert_eq!(found.len(), 1, "{report}");
        near(number(&found[0]["parameter"]), value, 1e-14);
        // A period later the table moves as before: rV − 2π = −V.
        near(number(&found[0]["speeds"][0]), TAU / 1.6, 1e-12);
    }
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

/// A chain of masses, the first held to the ground: spring and damper to the ground, springs, dampers,
/// masses, the mass that is forced, the mass that the stop meets. Those of the script, by its names.
type Chain = (
    [&'static str; 2],
    &'static [&'static str],
    &'static [&'static str],
    &'static [&'static str],
    usize,
    usize,
);

fn chain(name: &str) -> Chain {
    match name {
        "driven" => (["1.6", "0.05"], &["5.5"], &["0.09"], &["1", "3"], 1, 0),
        "stopped" => (["2.9", "0.2"], &["2.7"], &["0.07"], &["1", "1"], 0, 0),
        "second" => (["0.9", "0.2"], &["1.6"], &["0.14"], &["1", "3"], 1, 1),
        "slow" => (["1.91", "0.05"], &["0.22"], &["0.02"], &["1", "1"], 0, 0),
        "stiff" => (["0.48", "0.06"], &["3.87"], &["0.04"], &["1", "0.5"], 1, 0),
        "three" => (["1.6", "0.05"], &["5.5", "3"], &["0.09", "0.05"], &["1", "3", "0.5"], 1, 0),
        other => panic!("{other}"),
    }
}

fn scene(name: &str, tau: f64) -> String {
    let (ground, springs, dampers, masses, forced, met) = chain(name);
    let n = masses.len();
    let matrix = |ground: &str, links: &[&str]| {
        let entry = |i: usize, j: usize| {
            let own = if i == j && i == 0 { ground.to_string() } else { String::new() };
            let linked = |k: usize| (k == i || k + 1 == i) && (k == j || k + 1 == j);
            let sign = if i == j { "+" } else { "-" };
            let sum: String =
                (0..n - 1).filter(|k| linked(*k)).map(|k| format!("{sign}{}", links[k])).collect();
            format!("\"0{}{own}{sum}\"", if own.is_empty() { "" } else { "+" })
        };
        let row = |i: usize| format!("[{}]", (0..n).map(|j| entry(i, j)).collect::<Vec<_>>().join(", "));
        format!("[{}]", (0..n).map(row).collect::<Vec<_>>().join(", "))
    };
    let at = |i: usize, what: &str| {
        format!("[{}]", (0..n).map(|j| if i == j { what } else { "0" }).collect::<Vec<_>>().join(", "))
    };
    format!(
        "format = \"grazing-scene 2\"\ntitle = \"{name}\"\n[parameters]\nF = 1\ntau = {tau}\n[system]\n\
         period = \"2*pi\"\nmass = {{ diagonal = [{}] }}\ndamping = {}\nstiffness = {}\n\
         forcing = [{{ cos = {} }}]\n[[walls]]\nrow = {}\noffset = -1\nrestitution = \"tau\"\n",
        masses.join(", "),
        matrix(ground[1], dampers),
        matrix(ground[0], springs),
        at(forced, "\"F\""),
        at(met, "1"),
    )
}

/// F, tau, V, phase and the largest multiplier at an event of the script's.
fn known(machine: &str, event: &str) -> [f64; 6] {
    let text = include_str!("../data/machine_bifurcations.csv");
    let start = format!("{machine},{event},");
    let row = text.lines().find_map(|line| line.strip_prefix(&start)).unwrap_or_else(|| panic!("{start}"));
    let numbers: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

/// Coupled machines of two and three masses against the script: saddle-node, flip, Neimark–Sacker point,
/// grazing.
#[test]
fn events_of_coupled_machines_are_where_an_independent_script_has_them() {
    let folder = tempfile::tempdir().unwrap();
    for (name, tau, force, periods, start, events) in [
        ("driven", 0.9, 2.62, 1, [0.947, 0.166], &["saddle-node", "neimark-sacker"][..]),
        ("stopped", 0.7, 0.54, 1, [0.547, 0.34], &["neimark-sacker"]),
        ("second", 0.85, 1.15, 2, [0.584, 0.443], &["flip"]),
        ("three", 0.9, 3.9, 1, [0.9355, 0.255], &["neimark-sacker", "grazing"]),
    ] {
        let one = |what: &&str| {
            let keys = format!(
                "event = \"{what}\"\nparameter = \"F\"\nset = {{ F = {force} }}\norbit = {{ pattern = [{periods}], start = {start:?} }}"
            );
            task(what, "event", &keys)
        };
        let tasks: Vec<String> = events.iter().map(one).collect();
        let (report, code, error) = run(&scene(name, tau), &tasks, folder.path());
        assert_eq!(code, 0, "{name}: {error}{report}");
        for (i, event) in events.iter().enumerate() {
            let [force, _, speed, phase, re, im] = known(name, event);
            let found = &report["tasks"][i]["found"][0];
            near(number(&found["parameter"]), force, 1e-11 * force);
            // Along a branch that turns back the parameter is known better than the orbit.
            near(number(&found["speeds"][0]), speed, 1e-8);
            near(number(&found["phases"][0]), phase, 1e-8);
            let first = &found["multipliers"][0];
            near(number(&first[0]), re, 1e-7);
            near(number(&first[1]).abs(), im, 1e-7);
            if *event != "grazing" {
                normal_forms::agrees(found, name, event);
            }
            let stable = if *event == "grazing" { Value::Bool(true) } else { Value::from("marginal") };
            // What is not critical may be outside the unit circle.
            assert!(
                found["stable"] == stable || found["stable"] == false && *event == "saddle-node",
                "{found}"
            );
        }
    }
}

/// In whatever unit forces and lengths are, an event is found within a reach of the machine's own size, and
/// has the same coefficient; a reach that is given is in the parameter's unit.
#[test]
fn how_far_an_event_is_looked_for_goes_with_the_units() {
    let folder = tempfile::tempdir().unwrap();
    for unit in [1e-6, 1e6] {
        let text = scene("second", 0.85).replace("offset = -1", &format!("offset = {:e}", -unit));
        let event = |name: &str, reach: &str| {
            let keys = format!(
                "event = \"flip\"\nparameter = \"F\"\nset = {{ F = {:e} }}\norbit = {{ pattern = [2], start = [0.584, {:e}] }}\n{reach}",
                1.15 * unit,
                0.443 * unit
            );
            task(name, "event", &keys)
        };
        let far = |reach: f64| format!("reach = {:e}", reach * unit);
        let tasks = [event("own", ""), event("far", &far(0.05)), event("near", &far(0.03))];
        let (report, code, error) = run(&text, &tasks, folder.path());
        assert_eq!(code, 3, "{error}{report}");
        for i in 0..2 {
            let found = &report["tasks"][i]["found"][0];
            let force = known("second", "flip")[0];
            near(number(&found["parameter"]) / unit, force, 1e-10);
            normal_forms::agrees(found, "second", "flip");
        }
        let nothing = report["tasks"][2].to_string();
        assert!(
            nothing.contains("beyond reach") && report["tasks"][2]["status"] == "nothing-found",
            "{nothing}"
        );
    }
}

/// Curves in force and restitution: each meets its point of codimension two where the script has it.
#[test]
fn points_of_codimension_two_are_where_an_independent_script_has_them() {
    let folder = tempfile::tempdir().unwrap();
    for (name, tau, force, range, second, start, events) in [
        (
            "driven",
            0.95,
            2.61,
            [2.6, 2.615],
            [0.94, 1.0],
            [0.9495, 0.154],
            &[("neimark-sacker", "1:1-resonance"), ("saddle-node", "1:1-resonance")][..],
        ),
        ("slow", 0.85, 1.2005, [1.198, 1.202], [0.8, 0.9], [0.5085, 0.079], &[("flip", "1:2-resonance")]),
        ("stiff", 0.85, 0.75, [0.65, 0.76], [0.78, 0.87], [0.87, 2.5], &[("flip", "fold-flip")]),
    ] {
        let keys = format!(
            "parameter = \"F\"\nrange = {range:?}\nstarts = [{{ at = {force}, orbit = {{ pattern = [1], start = {start:?} }} }}]\n\
             options = {{ step = 0.05, most_step = 0.2 }}"
        );
        let mut tasks = vec![task("one", "branch", &keys)];
        for (event, _) in events {
            let keys = format!(
                "parameter = \"F\"\nrange = {range:?}\nsecond = \"tau\"\nsecond_range = {second:?}\n\
                 starts = [{{ restart = {{ file = \"one.json\", label = \"{event} 1\" }} }}]\n\
                 options = {{ step = 0.05, most_step = 0.2 }}"
            );
            tasks.push(task(&format!("two-{event}"), "branch", &keys));
        }
        let (report, code, error) = run(&scene(name, tau), &tasks, folder.path());
        assert_eq!(code, 0, "{name}: {error}{report}");
        for (i, (_, label)) in events.iter().enumerate() {
            let [force, tau, speed, ..] = known(name, label);
            let all = labels(&report["tasks"][i + 1]);
            let found = all.iter().find(|(known, _)| *known == format!("1 {label} 1"));
            let (_, row) = found.unwrap_or_else(|| panic!("{label}: {all:?}"));
            near(number(&row["parameters"][0]), force, 1e-9);
            near(number(&row["parameters"][1]), tau, 1e-8);
            near(number(&row["speeds"][0]), speed, 1e-8);
        }
    }
}

/// What continuation cannot do with machines is said.
#[test]
fn what_is_not_done_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let orbit = "starts = [{ orbit = { pattern = [4], start = [0.878, 1.41] } }]";
    let keys = format!("parameter = \"mu\"\nrange = [-0.1, 0.01]\nframe = \"lower\"\n{orbit}");
    let file = folder.path().join("scene.toml");
    fs::write(&file, format!("{PAPER_MACHINE}{}", task("a", "branch", &keys))).unwrap();
    let output = Command::new(crate::PROGRAM).arg("run").arg(&file).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(
        error.contains("frame") && error.contains("moves with a stop with one degree of freedom"),
        "{error}"
    );
    // A label of another machine.
    let keys = format!("parameter = \"mu\"\nrange = [-0.1, 0.01]\noptions = {{ most_step = 0.3 }}\n{orbit}");
    let (report, code, error) = run(PAPER_MACHINE, &[task("one", "branch", &keys)], folder.path());
    assert_eq!(code, 0, "{error}{report}");
    let keys = "parameter = \"mu\"\nrange = [-0.1, 0.01]\nstarts = [{ restart = { file = \"one.json\", label = \"grazing 1\" } }]";
    let (report, code, _) = run(PAIR, &[task("other", "branch", keys)], folder.path());
    assert_eq!(code, 2, "{report}");
    let reason = report["tasks"][0]["reason"].as_str().unwrap();
    assert!(reason.contains("wall \"plate\""), "{reason}");
}

/// A branch that starts where a motion settles, one that starts at its label, and the curve of its grazing
/// over two parameters, which ends at the same places by both codes.
#[test]
fn branches_start_at_attractors_and_labels_and_go_on_in_two_parameters() {
    let folder = tempfile::tempdir().unwrap();
    let rate = TAU / 3.0;
    let tasks = |name: &str, u: f64| {
        let over = "parameter = \"mu\"\nrange = [-0.1, 0.01]\noptions = { step = 0.05, most_step = 0.3 }\n";
        let restart = |label: &str| {
            format!("starts = [{{ restart = {{ file = \"{name}.json\", label = \"{label} 1\" }} }}]\n")
        };
        [
            task(
                name,
                "branch",
                &format!(
                    "set = {{ mu = -0.03 }}\n{over}starts = [{{ attractor = {{ phase = \"1/2\", q = 2.6, u = {u} }} }}]"
                ),
            ),
            task(&format!("{name}-again"), "branch", &format!("{over}{}", restart("saddle-node"))),
            task(
                &format!("{name}-curve"),
                "branch",
                &format!("{over}second = \"w\"\nsecond_range = [4.85, 4.95]\n{}", restart("grazing")),
            ),
        ]
    };
    let (machine, code, error) = run(PAPER_MACHINE, &tasks("machine", 0.31 * rate), folder.path());
    assert_eq!(code, 0, "{error}{machine}");
    let (alone, code, error) = run(ALONE, &tasks("alone", 0.31), folder.path());
    assert_eq!(code, 0, "{error}{alone}");
    for i in 0..2 {
        let (a, b) = (labels(&machine["tasks"][i]), labels(&alone["tasks"][i]));
        assert!(a.len() >= 2 && a.len() == b.len(), "{a:?} {b:?}");
        for ((name, a), (known, b)) in a.iter().zip(&b) {
            assert!(name == known && a["pattern"] == "4", "{a} {b}");
            near(number(&a["parameters"][0]), number(&b["parameters"][0]), 1e-12);
        }
    }
    let ends = |name: &str| {
        let text = fs::read_to_string(folder.path().join(format!("{name}-curve.json"))).unwrap();
        let branch: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(branch["ends"][0], "a parameter is at its bound");
        assert_eq!(branch["ends"][1], "a parameter is at its bound");
        let points = branch["points"].as_array().unwrap();
        let place = |point: &Value| [0, 1].map(|i| number(&point["parameters"][i]));
        [place(&points[0]), place(&points[points.len() - 1])]
    };
    for (a, b) in ends("machine").iter().zip(ends("alone")) {
        assert!(a[1] == b[1] && a[1] != 4.9, "{a:?} {b:?}");
        near(a[0], b[0], 1e-9);
    }
}

/// Orbits drawn along a branch: those without impacts are ellipses, those with one begin and end at the stop,
/// by either engine the same, and the last is the branch's last.
#[test]
fn orbits_of_a_branch_are_drawn() {
    let told = ["one", "many"].map(|engine| {
        let stop = if engine == "one" { "side = \"upper\"\noffset = 1" } else { "row = [-1]\noffset = -1" };
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"{engine}\"\n[parameters]\nF = 0.6\n[system]\nperiod = 2\ndamping = \"0.1*pi\"\n\
             stiffness = \"0.3*pi^2\"\nforcing = [{{ cos = \"F*pi^2\" }}]\n[[stops]]\n{stop}\nrestitution = 0.8\n"
        );
        let branch = |name: &str, pattern: &str| {
            let keys = format!("parameter = \"F\"\nrange = [0.3, 0.7]\ndrawn = 3\nstarts = [{{ orbit = {{ pattern = {pattern} }} }}]");
            task(name, "branch", &keys)
        };
        let folder = tempfile::tempdir().unwrap();
        let (found, code, error) = run(&text, &[branch("free", "[]"), branch("one", "[1]")], folder.path());
        assert_eq!(code, 0, "{error}{found}");
        ["free", "one"].map(|name| {
            assert!(folder.path().join(format!("{name}-orbits.svg")).is_file());
            let text = std::fs::read_to_string(folder.path().join(format!("{name}-orbits.csv"))).unwrap();
            let row = |line: &str| -> (String, [f64; 2]) {
                let cells: Vec<&str> = line.split(',').collect();
                (cells[..cells.len() - 3].join(","), [cells[cells.len() - 3], cells[cells.len() - 2]].map(|x| x.parse().unwrap()))
            };
            text.lines().skip(1).map(row).collect::<Vec<_>>()
        })
    });
    for (name, [q, u]) in &told[0][0] {
        let force: f64 = name.rsplit(" = ").next().unwrap().trim_matches('"').parse().unwrap();
        let amplitude = force / 0.7f64.hypot(0.1);
        near(q.hypot(u / PI), amplitude, 1e-9);
    }
    for (one, many) in told[0][0].iter().zip(&told[1][0]) {
        assert_eq!(one.0, many.0);
        near(one.1[0], many.1[0], 1e-7);
        near(one.1[1], many.1[1], 1e-7);
    }
    assert_eq!(told[0][0].len(), told[1][0].len());
    // Which way round the fold comes first is the engine's.
    for [_, impacts] in &told {
        let orbits: Vec<_> = impacts.chunk_by(|a, b| a.0 == b.0).collect();
        let named = |wanted: &str| orbits.iter().filter(|orbit| orbit[0].0.contains(wanted)).count();
        assert!(orbits.len() >= 4 && named("saddle-node") == 1 && named("F = 0.7") == 2, "{orbits:?}");
        for orbit in orbits {
            let [first, last] = [orbit[0].1, orbit[orbit.len() - 1].1];
            near(first[0], 1.0, 1e-6);
            near(last[0], 1.0, 1e-6);
            near(first[1], -0.8 * last[1], 1e-5);
        }
    }
}

#[test]
fn a_diagram_draws_branches() {
    let folder = tempfile::tempdir().unwrap();
    let rate = TAU / 3.0;
    let keys = |speed: f64, more: &str| {
        format!(
            "parameter = \"mu\"\nrange = [-0.1, 0.01]\ncount = 2\ntransient = 1\npoints = 2\nstarts = [{{ q = 3 }}]\n\
             options = {{ most_step = 0.2 }}\nbranches = [{{ at = -0.05, orbit = {{ pattern = [4], speed = {speed}, starts = 60 }} }}]\n{more}"
        )
    };
    let drawn = |scene: &str, name: &str, keys: &str| -> Vec<(String, [f64; 2])> {
        let (report, code, error) = run(scene, &[task(name, "diagram", keys)], folder.path());
        assert_eq!(code, 0, "{error}{report}");
        let text = fs::read_to_string(folder.path().join(format!("{name}.csv"))).unwrap();
        let mut rows = csv::Reader::from_reader(text.as_bytes());
        let all = rows.records().map(|row| row.unwrap()).filter(|row| !row[4].is_empty());
        all.map(|row| (row[4].to_string(), [1, 2].map(|i| row[i].parse().unwrap()))).collect()
    };
    let machine = drawn(PAPER_MACHINE, "machine", &keys(rate, "plane = [\"q1\", \"u1\"]\n"));
    let alone = drawn(ALONE, "alone", &keys(1.0, ""));
    assert!(machine.len() >= 2 && machine.len() == alone.len(), "{machine:?} {alone:?}");
    for ((label, a), (known, b)) in machine.iter().zip(&alone) {
        assert_eq!(label, known);
        near(a[0], b[0], 1e-12);
        near(a[1], b[1], 1e-7);
    }
}
