//! Bifurcations as a user meets them: scenes written to a file and run by the command, against values from
//! closed formulas.

mod branches;
use crate::tasks;

use std::{fs, path::Path};

use serde_json::Value;

use tasks::{ball, near, number, refused, run, task};

/// The paper's oscillator.
const NORDMARK: &str = r#"
format = "grazing-scene 1"
title = "the paper's oscillator"
[parameters]
d = 0.6
w = 4.9
mu = -0.02
[system]
damping = "2*d/w"
stiffness = "1/w^2"
[[walls]]
side = "lower"
offset = -1
harmonics = [{ cos = "1 + mu" }]
restitution = 1
"#;

/// A ball on a table that moves as a sin t, gravity 1.
const BALL: &str = r#"
format = "grazing-scene 1"
title = "a ball on a table"
[parameters]
a = 1.2
[system]
force = -1
[[walls]]
side = "lower"
offset = 0
harmonics = [{ sin = "a" }]
restitution = "3/5"
"#;

/// Two walls that mirror each other.
const SYMMETRIC: &str = r#"
format = "grazing-scene 1"
title = "between two walls"
[parameters]
D = 1.5
[system]
damping = "1/10"
stiffness = "1/4"
forcing = [{ cos = 1 }]
[[walls]]
side = "lower"
offset = "-D"
restitution = "7/10"
[[walls]]
side = "upper"
offset = "D"
restitution = "7/10"
"#;

/// One wall (Shaw and Holmes).
const ONE_SIDED: &str = r#"
format = "grazing-scene 1"
title = "one wall"
[parameters]
w = "2.7"
[system]
damping = "1/10/w"
stiffness = "1/w^2"
forcing = [{ cos = 1 }]
[[walls]]
side = "upper"
offset = "1/2"
restitution = "4/5"
"#;

const DUFFING: &str = r#"
format = "grazing-scene 1"
title = "Duffing's oscillator with a wall"
[parameters]
A = "0.3"
[system]
damping = "1/5"
stiffness = -1
cubic = 1
forcing = [{ cos = "A" }]
[[walls]]
side = "upper"
offset = "11/10"
restitution = "4/5"
"#;

fn found(report: &Value, task: usize) -> &Vec<Value> {
    report["tasks"][task]["found"].as_array().unwrap()
}

/// The labels of a branch written as JSON, each with its point.
fn labels(folder: &Path, task: &str) -> Vec<(String, Value)> {
    let text = fs::read_to_string(folder.join(format!("{task}.json"))).unwrap();
    let branch: Value = serde_json::from_str(&text).unwrap();
    let points = branch["points"].as_array().unwrap().iter();
    points.filter_map(|point| Some((point["label"].as_str()?.to_string(), point.clone()))).collect()
}

fn parameter(labels: &[(String, Value)], label: &str) -> f64 {
    let found =
        labels.iter().find(|(name, _)| name == label).unwrap_or_else(|| panic!("{label}: {labels:?}"));
    found.1["parameters"][0].as_f64().unwrap()
}

#[test]
fn a_pole_of_the_multipliers_is_no_bifurcation() {
    let folder = tempfile::tempdir().unwrap();
    let event = |name: &str, event: &str, n: u32, mu: &str| {
        let keys = format!(
            "event = \"{event}\"\nparameter = \"mu\"\nset = {{ mu = {mu} }}\norbit = {{ pattern = [{n}] }}"
        );
        task(name, "event", &keys)
    };
    let tasks = [
        event("sn4", "saddle-node", 4, "-0.02"),
        event("pd1", "flip", 1, "0.0005"),
        event("pd2", "flip", 2, "0.0005"),
        event("pd4", "flip", 4, "-0.005"),
    ];
    let written_otherwise = NORDMARK.replace("\"2*d/w\"", "\"12/49\"").replace("\"1/w^2\"", "\"100/2401\"");
    for scene in [NORDMARK, &written_otherwise] {
        let (report, code, _) = run(scene, &tasks, folder.path());
        assert_eq!(code, 3);
        let rows = found(&report, 0);
        assert_eq!(rows.len(), 1);
        // The closed form of the paper's oscillator: µ_sn = |1+p₂|/√(p₁² + (1+p₂)²) − 1.
        near(rows[0]["parameter"].as_f64().unwrap(), -0.084_338_470_089_589_2, 1e-14);
        for flip in 1..4 {
            assert!(found(&report, flip).is_empty(), "{report}");
            let text = report["tasks"][flip].to_string();
            assert!(text.contains("no flip") && text.contains("fade"), "{text}");
        }
    }
}

#[test]
fn a_saddle_node_round_a_bend_is_found_and_what_is_beyond_reach_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let keys = |event: &str, reach: f64| {
        format!(
            "event = \"{event}\"\nparameter = \"a\"\nreach = {reach}\norbit = {{ pattern = [1], speed = 4 }}"
        )
    };
    let [fold, flip] = ball();
    let tasks = [task("sn", "event", &keys("saddle-node", 3.0)), task("pd", "event", &keys("flip", 3.0))];
    let (report, code, _) = run(BALL, &tasks, folder.path());
    assert_eq!(code, 0, "{report}");
    for (task, value) in [(0, fold), (1, flip)] {
        let rows = found(&report, task);
        assert_eq!(rows.len(), 1);
        near(rows[0]["parameter"].as_f64().unwrap(), value, 1e-14);
    }
    let (report, code, _) = run(BALL, &[task("sn", "event", &keys("saddle-node", 0.5))], folder.path());
    assert_eq!(code, 3);
    assert!(report.to_string().contains("a larger reach looks further"), "{report}");
}

#[test]
fn a_branch_starts_at_an_end_of_its_range_and_not_outside() {
    let folder = tempfile::tempdir().unwrap();
    let branch = |low: f64, high: f64, direction: &str| {
        let keys = format!(
            "parameter = \"a\"\nrange = [{low}, {high}]\ndirection = \"{direction}\"\n\
             starts = [{{ at = 1.2, orbit = {{ pattern = [1], speed = 4 }} }}]"
        );
        task("end", "branch", &keys)
    };
    for (low, high, direction) in
        [(0.1, 1.2, "both"), (1.2, 3.0, "both"), (0.1, 1.2, "up"), (1.2, 3.0, "down")]
    {
        let (report, code, error) = run(BALL, &[branch(low, high, direction)], folder.path());
        assert_eq!(code, 0, "{report} {error}");
    }
    let error = refused(BALL, &[branch(0.1, 1.0, "both")], folder.path());
    assert!(error.contains("at = 1.2: is not in the range from 0.1 to 1"), "{error}");
}

/// Follows a branch and switches at each label of a kind: the labels, and for each the points of the branch
/// born there.
fn switched(scene: &str, keys: &str, event: &str, folder: &Path) -> (Vec<(String, Value)>, Vec<Vec<Value>>) {
    let (report, code, error) = run(scene, &[task("br", "branch", keys)], folder);
    assert_eq!(code, 0, "{report} {error}");
    let all = labels(folder, "br");
    let head: String =
        keys.lines().filter(|line| !line.starts_with("starts")).map(|line| format!("{line}\n")).collect();
    let mut born = Vec::new();
    for (label, _) in all.iter().filter(|(label, _)| label.starts_with(event)) {
        let keys = format!(
            "{head}starts = [{{ restart = {{ file = \"br.json\", label = \"{label}\", switch = true }} }}]"
        );
        let (report, code, error) = run(scene, &[task("sw", "branch", &keys)], folder);
        assert_eq!(code, 0, "{label}: {report} {error}");
        let text = fs::read_to_string(folder.join("sw.json")).unwrap();
        let branch: Value = serde_json::from_str(&text).unwrap();
        born.push(branch["points"].as_array().unwrap().clone());
    }
    (all, born)
}

/// That the born branch begins at a flip's parameter and that its impacts come apart.
fn doubled(points: &[Value], at: f64) {
    assert!(points.len() > 5, "{points:?}");
    near(points[0]["parameters"][0].as_f64().unwrap(), at, 1e-12);
    let apart = |point: &Value| {
        let z: Vec<f64> = point["unknowns"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        (z[1] - z[z.len() / 2 + 1]).abs()
    };
    assert!(apart(&points[0]) < 1e-9 && apart(&points[4]) > 1e-3, "{points:?}");
    // The flip itself is not an event of the branch that is born there.
    for point in &points[1..] {
        let same = (point["parameters"][0].as_f64().unwrap() - at).abs() < 1e-9;
        assert!(!(same && point["label"].is_string()), "{point}");
    }
}

#[test]
fn every_flip_is_switched_at_with_default_options() {
    let folder = tempfile::tempdir().unwrap();
    let orbit = |parameter: &str, range: &str, at: f64, n: u32, speed: u32| {
        format!(
            "parameter = \"{parameter}\"\nrange = {range}\n\
             starts = [{{ at = {at}, orbit = {{ pattern = [{n}], speed = {speed} }} }}]\n"
        )
    };
    let cases = [
        (BALL, orbit("a", "[0.1, 5]", 1.2, 1, 4), vec![ball()[1]]),
        // Exact values of the one-sided oscillator, from the closed form to 20 digits, computed apart.
        (ONE_SIDED, orbit("w", "[0.6, 6]", 2.2, 1, 3), vec![2.495_349_153_122_399]),
        (ONE_SIDED, orbit("w", "[1.5, 12]", 4.0, 2, 5), vec![3.190_309_322_793_962_8, 4.462_824_747_609_758]),
    ];
    for (scene, keys, flips) in cases {
        let (all, born) = switched(scene, &keys, "flip", folder.path());
        assert_eq!(born.len(), flips.len());
        for ((i, at), points) in (1..).zip(flips).zip(&born) {
            near(parameter(&all, &format!("flip {i}")), at, 2e-14 * (1.0 + at));
            doubled(points, at);
        }
    }
    let (all, born) = switched(DUFFING, &orbit("A", "[0.02, 1]", 0.3, 1, 1), "flip", folder.path());
    assert_eq!(born.len(), 4);
    for (i, points) in (1..).zip(&born) {
        doubled(points, parameter(&all, &format!("flip {i}")));
    }
}

#[test]
fn the_one_sided_branches_graze_where_the_closed_form_says() {
    let folder = tempfile::tempdir().unwrap();
    for (range, at, n, speed, value) in
        [("[0.6, 6]", 2.2, 1, 3, 0.702_732_885_720_984_2), ("[1.5, 12]", 4.0, 2, 5, 2.761_352_891_366_08)]
    {
        let keys = format!(
            "parameter = \"w\"\nrange = {range}\n\
             starts = [{{ at = {at}, orbit = {{ pattern = [{n}], speed = {speed} }} }}]"
        );
        run(ONE_SIDED, &[task("br", "branch", &keys)], folder.path());
        near(parameter(&labels(folder.path(), "br"), "grazing 1"), value, 1e-13);
    }
}

/// Where the multiplier of the half period's map is −1, from the closed form of the symmetric orbit, computed
/// apart.
const PITCHFORK: f64 = 1.177_166_961_538_611;

const STARTS: &str = "pattern = [0, 1], walls = [\"upper\", \"lower\"], start = [0.326, 1.603, 3.468, 1.603]";

#[test]
fn a_pitchfork_is_located_to_rounding_and_switched_at() {
    let folder = tempfile::tempdir().unwrap();
    let keys =
        format!("parameter = \"D\"\nrange = [0.3, 4]\nstarts = [{{ at = 1.5, orbit = {{ {STARTS} }} }}]\n");
    let (all, born) = switched(SYMMETRIC, &keys, "crossing", folder.path());
    assert_eq!(born.len(), 1);
    near(parameter(&all, "crossing 1"), PITCHFORK, 1e-14);
    // The born branch goes both ways from the middle, each half the mirror image of the other.
    let points = &born[0];
    let apart =
        |point: &Value| point["unknowns"][1].as_f64().unwrap() - point["unknowns"][3].as_f64().unwrap();
    assert!(points.len() > 10 && apart(&points[0]) * apart(&points[points.len() - 1]) < 0.0);
    assert!(points.iter().all(|point| point["parameters"][0].as_f64().unwrap() < PITCHFORK + 1e-12));
}

#[test]
fn a_pitchfork_is_not_called_a_saddle_node() {
    let folder = tempfile::tempdir().unwrap();
    let keys = format!("event = \"saddle-node\"\nparameter = \"D\"\nreach = 1\norbit = {{ {STARTS} }}");
    let (report, code, _) = run(SYMMETRIC, &[task("sn", "event", &keys)], folder.path());
    assert_eq!(code, 3);
    let text = report.to_string();
    assert!(text.contains("crossing with another branch at 1.1771669615386"), "{text}");
}

#[test]
fn the_flips_coefficient_gives_the_amplitude_of_the_doubled_orbit() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"a\"\nrange = [0.1, 5]\n\
                starts = [{ at = 1.2, orbit = { pattern = [1], speed = 4 } }]\n";
    let (all, born) = switched(BALL, keys, "flip", folder.path());
    let (report, _, _) = run(BALL, &[task("br", "branch", keys)], folder.path());
    let rows = report["tasks"][0]["labels"].as_array().unwrap();
    let flip = rows.iter().find(|row| row["label"] == "flip 1").unwrap();
    assert_eq!(flip["criticality"], "supercritical");
    assert_eq!(flip["stable"], "marginal");
    // The trace is 1 + r² − (1+r)² s with s = √(a² − a_sn²), so dλ₁/da = λ₁/(λ₁ − λ₂) times −(1+r)² a/s;
    // beside the flip the doubled orbit's amplitude ξ obeys −(1 + λ₁) = b ξ².
    let (r, at): (f64, f64) = (0.6, parameter(&all, "flip 1"));
    let s = (at * at - ball()[0] * ball()[0]).sqrt();
    let rate = -(1.0 + r).powi(2) * at / s / (1.0 - r * r);
    let point = &born[0][1];
    let z: Vec<f64> = point["unknowns"].as_array().unwrap().iter().map(number).collect();
    let amplitude = ((z[0] - z[2]) / 2.0).hypot((z[1] - z[3]) / 2.0);
    let b = -rate * (number(&point["parameters"][0]) - at) / (amplitude * amplitude);
    near(number(&flip["coefficient"]), b, 1e-3 * b);
    assert_eq!(point["stable"], true);
    // The saddle-node: a = −π/2 in these coordinates, orbits for larger a.
    let fold = rows.iter().find(|row| row["label"] == "saddle-node 1").unwrap();
    assert_eq!(fold["criticality"], "above");
}

#[test]
fn the_papers_bifurcations_go_the_way_the_paper_says() {
    let folder = tempfile::tempdir().unwrap();
    let event = |event: &str, mu: &str, n: u32| {
        let keys = format!(
            "event = \"{event}\"\nparameter = \"mu\"\nset = {{ mu = {mu} }}\norbit = {{ pattern = [{n}] }}"
        );
        task(event, "event", &keys)
    };
    let tasks = [event("saddle-node", "-0.05", 4), event("flip", "0.003", 3)];
    let (report, code, _) = run(NORDMARK, &tasks, folder.path());
    assert_eq!(code, 0);
    assert_eq!(found(&report, 0)[0]["criticality"], "above");
    assert_eq!(found(&report, 1)[0]["criticality"], "subcritical");
    let pair = &found(&report, 1)[0]["multipliers"][0];
    near(number(&pair[0]), -1.0, 1e-12);
    assert_eq!(pair[1], 0.0);
}

/// The published flip and the closed form's saddle-node of section 4, whatever form the damping has.
#[test]
fn damping_in_a_formula_is_in_the_bifurcations() {
    let folder = tempfile::tempdir().unwrap();
    let event = |event: &str, mu: &str, n: u32| {
        let keys = format!(
            "event = \"{event}\"\nparameter = \"mu\"\nset = {{ mu = {mu} }}\norbit = {{ pattern = [{n}] }}"
        );
        task(event, "event", &keys)
    };
    let tasks = [event("flip", "0.005", 3), event("saddle-node", "-0.08", 4)];
    for force in ["-2*d/w*u", "-2*d/w*u + 0*exp(q)*u + 0*sin(u)"] {
        let scene = NORDMARK.replace("damping = \"2*d/w\"", &format!("force = \"{force}\""));
        let (report, code, _) = run(&scene, &tasks, folder.path());
        assert_eq!(code, 0, "{force}: {report}");
        let at = |i: usize| number(&found(&report, i)[0]["parameter"]);
        near(at(0), 0.005_479_046_22, 1e-11);
        near(at(1), -0.084_338_470_089_589_2, 1e-11);
    }
}

#[test]
fn both_walls_grazed_at_once_are_the_half_periods_map_or_open() {
    let folder = tempfile::tempdir().unwrap();
    let tasks = [task("g", "grazing", "parameter = \"D\"\nmax_period = 3\ndistance = 1e-5")];
    let (report, code, error) = run(SYMMETRIC, &tasks, folder.path());
    let answer = &report["tasks"][0];
    assert_eq!(code, 0, "{report} {error}");
    // The response's amplitude: 1/|s − 1 + ic|.
    near(number(&answer["parameter"]), 1.0 / 0.75f64.hypot(0.1), 1e-13);
    assert_eq!(answer["half"], true);
    // A is minus the flow over half a period: its determinant is e^{−πc}.
    near(number(&answer["a2"]), (-0.1 * std::f64::consts::PI).exp(), 1e-14);
    let born = answer["born"].as_array().unwrap();
    assert!(!born.is_empty());
    for row in born {
        // What the theory says is there in the true system, with impacts at both walls.
        assert_eq!(row["admissible"], true, "{row}");
        let odd =
            row["pattern"].as_str().unwrap().split(',').map(|n| n.parse::<u32>().unwrap()).sum::<u32>() % 2;
        let impacts = row["phases"].as_array().unwrap().len();
        assert_eq!(impacts, row["pattern"].as_str().unwrap().split(',').count() << odd);
    }
    let lopsided = SYMMETRIC.replacen("7/10", "6/10", 1);
    let (report, code, _) = run(&lopsided, &tasks, folder.path());
    assert_eq!(code, 3);
    assert!(report["tasks"][0]["born"].as_array().unwrap().is_empty());
    assert!(report["tasks"][0]["open"].as_str().unwrap().contains("grazes twice"), "{report}");
    assert_eq!(report["tasks"][0]["admissible"], "marginal");
}

#[test]
fn what_is_refuted_is_named_and_what_is_missing_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let (report, code, _) =
        run(NORDMARK, &[task("v", "validate", "orbit = { pattern = [4] }")], folder.path());
    let rows = report["tasks"][0]["proofs"].as_array().unwrap();
    let refuted = rows.iter().find(|row| row["verdict"] == "refuted").expect("an excursion behind the wall");
    assert_eq!(code, 1);
    assert_eq!(report["tasks"][0]["status"], "refuted");
    assert_eq!(refuted["solution"].as_array().unwrap().len(), 2);
    assert!(report["tasks"][0]["reason"].as_str().unwrap().contains("pattern 4 near"), "{report}");
    let keys = "event = \"saddle-node\"\nparameter = \"a\"\norbit = { pattern = [1], speed = 4 }";
    let (report, code, _) = run(BALL, &[task("v", "validate", keys)], folder.path());
    assert_eq!(code, 3);
    assert!(report["tasks"][0]["reason"].as_str().unwrap().contains("a larger reach"), "{report}");
}

#[test]
fn a_start_without_an_orbit_is_said_and_the_others_go_on() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"a\"\nrange = [0.1, 3]\nstarts = [\n\
                { at = 1.2, orbit = { pattern = [1], speed = 4 } }, { at = 1.2, orbit = { pattern = [9] } }]";
    let (report, code, _) = run(BALL, &[task("br", "branch", keys)], folder.path());
    assert_eq!(code, 3);
    let starts = report["tasks"][0]["starts"].as_array().unwrap();
    assert!(starts.iter().any(|row| row["start"] == 1 && row["branch"] == 1));
    let lost = starts.iter().find(|row| row["start"] == 2).unwrap();
    assert!(lost["branch"].is_null() && lost["reason"].is_string());
    assert!(!labels(folder.path(), "br").is_empty());
}

/// The paper's orbit at rest grazes at µ = 0 for every w; there θ = 2π·0.8/w, and u_n = 0 where nθ is a
/// multiple of π.
#[test]
fn resonant_grazings_and_gamma_zero_are_labelled_along_the_curve_of_grazings() {
    let folder = tempfile::tempdir().unwrap();
    let rest = "parameter = \"mu\"\nrange = [-0.1, 0.1]\nstarts = [{ at = -0.02, orbit = { pattern = [] } }]";
    let (report, code, error) = run(NORDMARK, &[task("rest", "branch", rest)], folder.path());
    assert_eq!(code, 0, "{report} {error}");
    let curve = "parameter = \"mu\"\nrange = [-0.1, 0.1]\nsecond = \"w\"\nsecond_range = [1.5, 10]\n\
                 starts = [{ restart = { file = \"rest.json\", label = \"grazing 1\" } }]";
    let (report, code, error) = run(NORDMARK, &[task("curve", "branch", curve)], folder.path());
    assert_eq!(code, 0, "{report} {error}");
    let found: Vec<(String, f64)> = labels(folder.path(), "curve")
        .into_iter()
        .map(|(label, point)| (label.split(' ').next().unwrap().to_string(), number(&point["parameters"][1])))
        .collect();
    let mut expected = vec![("gamma-zero".to_string(), 1.6)];
    for n in 2..=6u32 {
        for k in (1..n).filter(|k| gcd(*k, n) == 1) {
            let w = 1.6 * f64::from(n) / f64::from(k);
            if (1.5..10.0).contains(&w) {
                expected.push((format!("resonant-grazing-{n}"), w));
            }
        }
    }
    for (name, w) in &expected {
        let there = found.iter().any(|(label, at)| label == name && (at - w).abs() < 1e-9);
        assert!(there, "{name} at {w}: {found:?}");
    }
    assert_eq!(found.len(), expected.len(), "{found:?}");
    let svg = fs::read_to_string(folder.path().join("curve.svg")).unwrap();
    assert!(svg.contains("resonant-grazing-3"));
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// What is not there is not a failure: no grazing within reach, and no orbit to begin with.
#[test]
fn a_grazing_out_of_reach_is_nothing_found() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"a\"\nreach = 0.3\norbit = { pattern = [1], speed = 4 }";
    let (report, code, error) = run(BALL, &[task("g", "grazing", keys)], folder.path());
    assert_eq!((code, &report["tasks"][0]["status"]), (3, &"nothing-found".into()), "{report} {error}");
    assert!(
        report["tasks"][0]["reason"].as_str().unwrap().contains("a larger reach looks further"),
        "{report}"
    );
    let keys = "parameter = \"a\"\norbit = { pattern = [9] }";
    let (report, code, _) = run(BALL, &[task("g", "grazing", keys)], folder.path());
    assert_eq!((code, &report["tasks"][0]["status"]), (3, &"nothing-found".into()), "{report}");
    assert!(report["tasks"][0]["reason"].as_str().unwrap().contains("no admissible orbit"), "{report}");
}
