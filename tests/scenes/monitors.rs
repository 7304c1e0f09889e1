//! Monitors of branches, against closed formulas: a ball of mass m and weight m on a table that moves as
//! a sin t. With one impact per period 2π it comes in with the relative speed V = 2π/(1 + r) where a cos t is
//! π(1 − r)/(1 + r), is pushed by 2πm, and rises from a sin t by π²/2.

use std::{
    f64::consts::{PI, TAU},
    fs,
    path::Path,
};

use serde_json::Value;

use crate::tasks::{near, number, refused, run, task};

fn ball(engine: &str) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"a ball\"\nengine = \"{engine}\"\n[parameters]\na = 1.2\nr = 0.6\nm = 3\n\
         [system]\nmass = \"m\"\nforce = \"-m\"\n[[stops]]\nside = \"lower\"\noffset = 0\nharmonics = [{{ sin = \"a\" }}]\n\
         restitution = \"r\"\n"
    )
}

const MONITORS: &str = "monitors = { top = \"q_max\", bottom = \"q_min\", far = \"swing\", hard = \"impulse/m\", again = \"speed1\", \
                        fast = \"speed\", part = \"phase\", when = \"cos(2*pi*phase)\", long = \"period\", lasting = \"multiplier*multiplier2\", \
                        mixed = \"max(speed, a) + sqrt(r)\" }\n";

fn first(more: &str) -> String {
    let keys =
        "parameter = \"a\"\nrange = [0.1, 6]\nstarts = [{ at = 1.2, orbit = { pattern = [1], speed = 4 } }]";
    task("first", "branch", &format!("{MONITORS}{more}\n{keys}"))
}

/// The part of a that a table's velocity at an impact takes.
fn along(r: f64) -> f64 {
    PI * (1.0 - r) / (1.0 + r)
}

fn table(folder: &Path, task: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(folder.join(format!("{task}-points.csv"))).unwrap();
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    reader.records().map(|row| row.unwrap().iter().map(str::to_string).collect()).collect()
}

/// The numbers of some columns, row by row.
fn columns<const N: usize>(table: &[Vec<String>], names: [&str; N]) -> Vec<[f64; N]> {
    let places =
        names.map(|name| table[0].iter().position(|known| known == name).unwrap_or_else(|| panic!("{name}")));
    table[1..].iter().map(|row| places.map(|i| row[i].parse().unwrap())).collect()
}

fn labels<'r>(report: &'r Value, task: usize, name: &str) -> Vec<&'r Value> {
    let all = report["tasks"][task]["labels"].as_array().unwrap_or_else(|| panic!("{report}")).iter();
    all.filter(|row| row["label"].as_str().unwrap().rsplit_once(' ').unwrap().0 == name).collect()
}

/// Columns, and labels where monitors take values; by both engines.
#[test]
fn monitors_are_columns_and_are_labelled_where_they_take_a_value() {
    let levels = "levels = { top = [5.5, 4.5], hard = [1], again = [6], part = [0.1, 0.5] }";
    for engine in ["one", "many"] {
        let folder = tempfile::tempdir().unwrap();
        let (report, code, error) = run(&ball(engine), &[first(levels)], folder.path());
        assert_eq!(code, 0, "{error}{report}");
        let table = table(folder.path(), "first");
        assert!(table.len() > 20);
        let r: f64 = 0.6;
        let wanted = ["parameters", "top", "bottom", "far", "hard", "again", "fast", "long", "lasting"];
        for [a, top, bottom, far, hard, again, fast, long, lasting] in columns(&table, wanted) {
            near((top - PI * PI / 2.0).hypot(along(r)), a, 1e-9);
            near(bottom, top - PI * PI / 2.0, 1e-9);
            near(far, PI * PI / 4.0, 1e-9);
            [hard, long].iter().for_each(|x| near(*x, TAU, 1e-9));
            [again, fast].iter().for_each(|x| near(*x, TAU / (1.0 + r), 1e-9));
            near(lasting, r * r, 1e-9);
        }
        for [a, when, mixed] in columns(&table, ["parameters", "when", "mixed"]) {
            near(when, along(r) / a, 1e-9);
            near(mixed, (TAU / (1.0 + r)).max(a) + r.sqrt(), 1e-9);
        }
        let tops = labels(&report, 0, "top");
        let found: Vec<f64> = tops.iter().map(|row| number(&row["monitors"]["top"])).collect();
        assert_eq!(found.len(), 2, "{report}");
        for (row, top) in tops.iter().zip(&found) {
            near((top - 5.0).abs(), 0.5, 1e-11);
            near(number(&row["parameters"][0]), (top - PI * PI / 2.0).hypot(along(r)), 1e-10);
            assert!(row["criticality"].is_null() && row["coefficient"].is_null(), "{row}");
        }
        // A phase of 1/2 is jumped over where it comes to 0 from above, and goes on from 1.
        let parts = labels(&report, 0, "part");
        assert_eq!(parts.len(), 1, "{report}");
        near(number(&parts[0]["parameters"][0]), along(r) / (0.2 * PI).cos(), 1e-10);
        // What is the same everywhere takes no value anywhere.
        assert!(labels(&report, 0, "hard").is_empty() && labels(&report, 0, "again").is_empty());
        assert_eq!(labels(&report, 0, "flip").len(), 1);
        assert_eq!(report["tasks"][0]["warnings"], serde_json::json!([]), "{report}");
    }
}

/// Held while both parameters move, from its label and from a row beside it; with the bifurcations on the
/// way.
#[test]
fn a_monitor_is_held_while_two_parameters_move() {
    let over = "parameter = \"a\"\nrange = [0.1, 6]\nsecond = \"r\"\nsecond_range = [0.3, 0.9]\nhold = { top = 6.1 }\nlevels = { \
                slow = [4] }\nmonitors = { top = \"q_max\", slow = \"speed\" }";
    let x = 6.1 - PI * PI / 2.0;
    for engine in ["one", "many"] {
        let folder = tempfile::tempdir().unwrap();
        let curve = |name: &str, restart: &str| {
            let start = format!("starts = [{{ restart = {{ file = \"first.json\", {restart} }} }}]");
            task(name, "branch", &format!("{over}\n{start}"))
        };
        let (report, code, error) = run(&ball(engine), &[first("levels = { top = [6.1] }")], folder.path());
        assert_eq!(code, 0, "{error}{report}");
        let all = columns(&table(folder.path(), "first"), ["top"]);
        let off = |row: &usize| {
            if (all[*row][0] - 6.1).abs() < 1e-6 { f64::INFINITY } else { (all[*row][0] - 6.1).abs() }
        };
        let beside = (0..all.len()).min_by(|i, j| off(i).total_cmp(&off(j))).unwrap();
        assert!(off(&beside) > 1e-3);
        let tasks =
            [curve("label", "label = \"top 1\""), curve("row", &format!("label = \"row {}\"", beside + 1))];
        let (report, code, error) = run(&ball(engine), &tasks, folder.path());
        assert_eq!(code, 0, "{error}{report}");
        for (i, name) in ["label", "row"].into_iter().enumerate() {
            let all = columns(&table(folder.path(), name), ["top", "slow"]);
            let text = fs::read_to_string(folder.path().join(format!("{name}.json"))).unwrap();
            let branch: Value = serde_json::from_str(&text).unwrap();
            let points = branch["points"].as_array().unwrap();
            assert!(points.len() > 10 && points.len() == all.len());
            for (point, [top, slow]) in points.iter().zip(all) {
                let [a, r] = [0, 1].map(|i| number(&point["parameters"][i]));
                near(a, x.hypot(along(r)), 1e-9);
                near(top, 6.1, 1e-10);
                near(slow, TAU / (1.0 + r), 1e-9);
            }
            let slow = labels(&report, i, "slow");
            assert_eq!(slow.len(), 1, "{report}");
            near(number(&slow[0]["parameters"][1]), TAU / 4.0 - 1.0, 1e-9);
            // The orbit flips where a sin t is 2(1 + r²)/(1 + r)².
            let flips = labels(&report, i, "flip");
            assert_eq!(flips.len(), 1, "{report}");
            let r = number(&flips[0]["parameters"][1]);
            near(2.0 * (1.0 + r * r) / (1.0 + r).powi(2), x, 1e-8);
            assert!(flips[0]["criticality"].is_null(), "{report}");
        }
    }
}

/// An orbit of two masses has the impulses and the turning points that a simulation on it has, with impacts
/// and with a stop that gives way.
#[test]
fn monitors_of_a_machine_are_those_of_its_motion() {
    let scene = |stop: &str| {
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"two masses\"\n[parameters]\nA = 70\n[system]\nfrequency = 2\n\
             mass = [[2, 0], [0, 0.5]]\ndamping = [[12, -2], [-2, 2]]\nstiffness = [[400, -200], [-200, 200]]\n\
             forcing = [{{ cos = [\"A\", 0] }}]\n[[stops]]\nrow = [-1, 1]\noffset = -0.05\n{stop}\n"
        )
    };
    let monitors = "monitors = { left = \"swing1\", top = \"q2_max\", low = \"q2_min\", push = \"impulse\", time = \"period\" }";
    for stop in ["restitution = 0.8", "stiffness = 2000\ndamping = 1"] {
        let folder = tempfile::tempdir().unwrap();
        let branch = format!(
            "parameter = \"A\"\nrange = [60, 80]\n{monitors}\nlevels = {{ left = [0.3] }}\nstarts = [{{ at = 70, attractor = {{ q = 0 }} \
             }}]"
        );
        let response = "parameter = \"A\"\nrange = [70, 80]\ncount = 3\nsweep = \"up\"\nseen = true";
        let tasks = [
            task("b", "branch", &branch),
            task("s", "simulate", "start = { q = 0 }\ntransient = 400\nperiods = 4\nsamples = 10"),
            task("r", "response", response),
        ];
        let (report, code, error) = run(&scene(stop), &tasks, folder.path());
        assert_eq!(code, 0, "{error}{report}");
        let all = table(folder.path(), "b");
        let place = |name: &str| all[0].iter().position(|known| known == name).unwrap();
        let row = all
            .iter()
            .find(|row| row[place("parameters")] == "70.0" && row[place("stable")] == "yes")
            .unwrap();
        let value = |name: &str| row[place(name)].parse::<f64>();
        let text = fs::read_to_string(folder.path().join("r.csv")).unwrap();
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let head = reader.headers().unwrap().clone();
        let [at, what, far] =
            ["value", "coordinate", "swing"].map(|name| head.iter().position(|known| known == name).unwrap());
        let seen: Vec<(String, f64)> = reader
            .records()
            .map(Result::unwrap)
            .filter(|row| &row[at] == "70.0" && &row[0] == "up")
            .map(|row| (row[what].to_string(), row[far].parse().unwrap()))
            .collect();
        let swing =
            |name: &str| seen.iter().find(|known| known.0 == name).unwrap_or_else(|| panic!("{seen:?}")).1;
        near(value("left").unwrap(), swing("q1"), 1e-7);
        near(0.5 * (value("top").unwrap() - value("low").unwrap()), swing("q2"), 1e-7);
        let pushed = number(&report["tasks"][1]["stops"][0]["impulse"]);
        assert!(pushed > 0.0);
        match value("push") {
            // The four periods take two seconds.
            Ok(push) => near(push / value("time").unwrap(), pushed / 2.0, 1e-8 * pushed),
            Err(_) => assert!(stop.contains("damping") && row[place("push")].is_empty()),
        }
    }
}

/// The same scene in metres and newtons and in bare numbers of millimetres and tonnes: the same labels, and
/// the units of the columns that have one.
#[test]
fn monitors_have_units() {
    let scene = |units: &str, [m, k, c, a, gap]: [&str; 5]| {
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"a mass\"\n{units}\n[parameters]\nF = {a}\n[system]\nfrequency = 2\nmass = {m}\n\
             damping = {c}\nstiffness = {k}\nforcing = [{{ cos = \"F\" }}]\n[[stops]]\nside = \"upper\"\noffset = {gap}\nrestitution = 0.8\n"
        )
    };
    let task = |range: &str, level: &str, more: &str| {
        let keys = format!(
            "parameter = \"F\"\nrange = {range}\nstarts = [{{ attractor = {{ q = 0 }} }}]\nmonitors = {{ work = \"impulse*speed/period\", \
             share = \"impulse/(F*period)\", impulse = \"swing{more}\" }}\nlevels = {{ work = [{level}] }}"
        );
        task("b", "branch", &keys)
    };
    let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let written = scene("", ["\"2 kg\"", "\"0.4 N/mm\"", "\"3 N s/m\"", "\"20 N\"", "\"20 mm\""]);
    let bare =
        scene("[units]\nlength = \"mm\"\ntime = \"s\"\nmass = \"t\"", ["0.002", "0.4", "0.003", "20", "20"]);
    let tasks = [task("[\"15 N\", \"40 N\"]", "\"30 W\"", " - 1 mm"), task("[15, 40]", "3e4", " - 1")];
    let found: Vec<Vec<Value>> = [written, bare]
        .iter()
        .zip(&tasks)
        .zip(&folders)
        .map(|((scene, task), folder)| {
            let (report, code, error) = run(scene, std::slice::from_ref(task), folder.path());
            assert_eq!(code, 0, "{error}{report}");
            labels(&report, 0, "work").into_iter().cloned().collect()
        })
        .collect();
    assert!(!found[0].is_empty() && found[0].len() == found[1].len(), "{found:?}");
    for (a, b) in found[0].iter().zip(&found[1]) {
        let both = |name: &str| [a, b].map(|row| number(&row["monitors"][name]));
        near(number(&a["parameters"][0]), number(&b["parameters"][0]), 1e-9);
        near(both("work")[0], 30.0, 1e-9);
        near(both("work")[1], 3e4, 1e-6);
        near(both("share")[0], both("share")[1], 1e-10);
        near(1000.0 * both("impulse")[0], both("impulse")[1], 1e-8);
    }
    let units = fs::read_to_string(folders[0].path().join("b-units.csv")).unwrap();
    assert!(units.contains("b-points.csv,speeds,m/s") && !units.contains("impulse"), "{units}");
    let written = scene("", ["\"2 kg\"", "\"0.4 N/mm\"", "\"3 N s/m\"", "\"20 N\"", "\"20 mm\""]);
    for (level, more, wanted) in [
        ("\"300 mN\"", "", "work is a power"),
        ("0.3", " - 1 s", "subtracts a length and a time"),
        ("0.3", " - 1", "a number without a unit"),
    ] {
        let said = refused(&written, &[task("[\"15 N\", \"40 N\"]", level, more)], folders[0].path());
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}

#[test]
fn what_cannot_be_evaluated_is_refused_or_an_empty_cell_that_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let keys =
        "parameter = \"a\"\nrange = [0.1, 6]\nstarts = [{ at = 1.2, orbit = { pattern = [1], speed = 4 } }]";
    let refusal = |more: &str| {
        let said = refused(&ball("one"), &[task("b", "branch", &format!("{keys}\n{more}"))], folder.path());
        said.replace('\n', " ")
    };
    for (more, wanted) in [
        ("monitors = { x = \"impulze\" }", "the nearest is \"impulse\""),
        ("monitors = { grazing = \"speed\" }", "label"),
        ("monitors = { x = \"speed\" }\nlevels = { y = [1] }", "there is no monitor \"y\""),
        ("monitors = { x = \"speed\" }\nhold = { x = 1 }", "give `second`"),
    ] {
        assert!(refusal(more).contains(wanted), "{more}: {}", refusal(more));
    }
    let empty = "monitors = { third = \"speed3\", odd = \"sqrt(1 - a)\" }\nlevels = { third = [1] }";
    let free = "parameter = \"A\"\nrange = [0.1, 0.9]\nstarts = [{ orbit = {} }]\nmonitors = { push = \"impulse\", far = \"swing\" }";
    let (report, code, error) =
        run(&ball("one"), &[task("b", "branch", &format!("{keys}\n{empty}"))], folder.path());
    assert_eq!(code, 0, "{error}{report}");
    let said = report["tasks"][0]["warnings"].to_string();
    assert!(
        said.contains("third has no value at")
            && said.contains("speed3 is not there: the orbit has 1 of its kind"),
        "{said}"
    );
    assert!(said.contains("odd has no value at") && said.contains("not finite"), "{said}");
    assert!(report["tasks"][0]["labels"][0]["monitors"]["third"].is_null());
    // Without impacts the swing is that of the resonance curve.
    let scene = "format = \"grazing-scene 3\"\ntitle = \"a mass\"\n[parameters]\nA = 0.5\n[system]\ndamping = 0.3\nstiffness = 4\n\
                 forcing = [{ cos = \"A\" }]\n[[stops]]\nside = \"upper\"\noffset = 5\nrestitution = 0.8\n";
    let (report, code, error) = run(scene, &[task("b", "branch", free)], folder.path());
    assert_eq!(code, 0, "{error}{report}");
    let said = report["tasks"][0]["warnings"].to_string();
    assert!(
        said.contains("push has no value")
            && said.contains("impulse is not there: the orbit has 0 of its kind"),
        "{said}"
    );
    for [a, far] in columns(&table(folder.path(), "b"), ["parameters", "far"]) {
        near(far, a / 3f64.hypot(0.3), 1e-12);
    }
}
