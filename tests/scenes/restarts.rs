//! Branches that begin at a point of a branch along another parameter, against closed formulas: a ball on a
//! table that moves as a sin t, gravity 1, with one impact of relative speed 2π/(1 + r) per period.

use std::{f64::consts::PI, fs, path::Path};

use serde_json::Value;

use crate::tasks::{near, number, run, task};

fn ball(engine: &str) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"a ball\"\nengine = \"{engine}\"\n[parameters]\na = 1.2\nr = 0.6\n\
         [system]\nforce = -1\n[[stops]]\nside = \"lower\"\noffset = 0\nharmonics = [{{ sin = \"a\" }}]\nrestitution = \"r\"\n"
    )
}

/// The amplitude at which the orbit flips.
fn flip(r: f64) -> f64 {
    (PI * (1.0 - r) / (1.0 + r)).hypot(2.0 * (1.0 + r * r) / (1.0 + r).powi(2))
}

fn first() -> String {
    let keys =
        "parameter = \"a\"\nrange = [0.1, 6]\nstarts = [{ at = 1.2, orbit = { pattern = [1], speed = 4 } }]";
    task("first", "branch", keys)
}

fn from(name: &str, restart: &str, keys: &str) -> String {
    task(
        name,
        "branch",
        &format!("{keys}\nstarts = [{{ restart = {{ file = \"first.json\", {restart} }} }}]"),
    )
}

fn points(folder: &Path, task: &str) -> Vec<Value> {
    let text = fs::read_to_string(folder.join(format!("{task}.json"))).unwrap();
    let branch: Value = serde_json::from_str(&text).unwrap();
    branch["points"].as_array().unwrap().clone()
}

const OVER_R: &str = "parameter = \"r\"\nrange = [0.3, 0.9]";

/// The second parameter begins at the scene's value, the first keeps that of the label or row, and is said:
/// both engines follow the orbits of that amplitude, and label where they flip.
#[test]
fn a_branch_goes_on_along_another_parameter() {
    for engine in ["one", "many"] {
        let folder = tempfile::tempdir().unwrap();
        let tasks =
            [first(), from("label", "label = \"flip 1\"", OVER_R), from("row", "label = \"row 7\"", OVER_R)];
        let (report, code, error) = run(&ball(engine), &tasks, folder.path());
        assert_eq!(code, 0, "{error}{report}");
        let all = points(folder.path(), "first");
        let labelled = all.iter().find(|point| point["label"] == "flip 1").unwrap();
        for (task, start) in [("label", labelled), ("row", &all[6])] {
            let a = number(&start["parameters"][0]);
            let found =
                report["tasks"].as_array().unwrap().iter().find(|found| found["task"] == task).unwrap();
            assert_eq!(
                (found["fixed"][0]["name"].as_str(), number(&found["fixed"][0]["value"])),
                (Some("a"), a)
            );
            let followed = points(folder.path(), task);
            assert!(followed.iter().any(|point| number(&point["parameters"][0]) == 0.6), "{engine} {task}");
            for point in &followed {
                let r = number(&point["parameters"][0]);
                let speed = number(point["unknowns"].as_array().unwrap().last().unwrap());
                near(speed, 2.0 * PI / (1.0 + r), 1e-9);
                if point["label"].as_str().is_some_and(|label| label.starts_with("flip")) {
                    near(flip(r), a, 1e-9);
                }
                assert_eq!(point["admissible"], true, "{engine} {task}: {point}");
            }
        }
        // The orbit of that amplitude is born where a = π(1 − r)/(1 + r).
        let a = number(&labelled["parameters"][0]);
        let born = &report["tasks"][1]["labels"][0];
        assert_eq!(born["label"], "saddle-node 1");
        near(number(&born["parameters"][0]), (PI - a) / (PI + a), 1e-9);
    }
}

/// The parameters of a file have names: the curve of flips is the same, whichever of them is the task's first
/// one, and a point of it begins a branch along either.
#[test]
fn parameters_are_told_by_their_names() {
    let folder = tempfile::tempdir().unwrap();
    let [a, r] = ["[0.1, 6]", "[0.3, 0.9]"];
    let curve = |first: (&str, &str), second: (&str, &str)| {
        format!(
            "parameter = \"{}\"\nrange = {}\nsecond = \"{}\"\nsecond_range = {}",
            first.0, first.1, second.0, second.1
        )
    };
    let row = "parameter = \"r\"\nrange = [0.3, 0.9]\nstarts = [{ restart = { file = \"ra.json\", label = \"row 5\" } }]";
    let tasks = [
        first(),
        from("ar", "label = \"flip 1\"", &curve(("a", a), ("r", r))),
        from("ra", "label = \"flip 1\"", &curve(("r", r), ("a", a))),
        task("row", "branch", row),
    ];
    let (report, code, error) = run(&ball("one"), &tasks, folder.path());
    assert_eq!(code, 0, "{error}{report}");
    for (task, [a, r]) in [("ar", [0, 1]), ("ra", [1, 0])] {
        let all = points(folder.path(), task);
        assert!(all.len() > 5);
        all.iter().for_each(|point| {
            near(number(&point["parameters"][a]), flip(number(&point["parameters"][r])), 1e-9)
        });
    }
    let at = number(&points(folder.path(), "ra")[4]["parameters"][1]);
    assert_eq!(number(&report["tasks"][3]["fixed"][0]["value"]), at);
}

#[test]
fn a_restart_that_is_not_one_point_is_refused_or_fails_and_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let mixed = "parameter = \"r\"\nrange = [0.3, 0.9]\nstarts = [{ restart = { file = \"first.json\", label = \"row 3\" } }, { restart = \
                 { file = \"first.json\", label = \"row 4\" } }]";
    let curve = "parameter = \"a\"\nrange = [0.1, 6]\nsecond = \"r\"\nsecond_range = [0.3, 0.9]";
    for (task, wanted) in [
        (from("again", "label = \"row 0\"", OVER_R), "no label \"row 0\"; it has"),
        (
            from("again", "label = \"row 5\", switch = true", "parameter = \"a\"\nrange = [0.1, 6]"),
            "is no bifurcation",
        ),
        (from("again", "label = \"row 5\"", curve), "is no bifurcation of codimension one"),
        (task("again", "branch", mixed), "and the task is not"),
    ] {
        let (report, code, error) = run(&ball("one"), &[first(), task], folder.path());
        assert!(code == 2 && error.contains(wanted), "{wanted}: {error}{report}");
    }
}
