//! `grazing run` by the command: statuses, exit codes, warnings, sizes; and the same scene run by the
//! library.

use std::{fs, process::Command};

use grazing_scenes::{
    Error, Monitor, Result,
    run::{
        Findings, GrazingFindings, GrazingReport, Job, Status, Surroundings, TaskReport, parts, run, run_task,
    },
    scene::{Scene, Task},
};
use serde_json::Value;
use tempfile::TempDir;

mod attractors;
mod backbones;
mod bands;
mod decided;
mod drifts;
mod enclosed;
mod families;
mod limit_cycles;
mod linear_touches;
mod ranges;
mod resonances;
mod responses;
mod sweeps;
mod tolerances;
mod tolerated_ranges;
mod touches;
mod trapped;
mod unstable;

/// What a scene's one task, a `grazing`, finds, as it is shown, and its exit code.
fn grazing_found(text: &str) -> (GrazingReport, String, u8) {
    let scene = Scene::from_toml(text, "t.toml").unwrap_or_else(|error| panic!("{error}"));
    let report = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
    let (code, shown) = (report.status.outcome().code(), report.to_string());
    match report.findings {
        Some(Findings::Grazing(found)) => match *found {
            GrazingFindings::Found(found) => (*found, shown, code),
            nothing => panic!("{nothing:?}"),
        },
        other => panic!("{other:?} {shown}"),
    }
}

const HEAD: &str = "format = \"grazing-scene 1\"\ntitle = \"t\"\n";

/// Scene f: the first task fails, the others run.
const FAILING: &str = r#"
[parameters]
F = 60
w = 1
[system]
damping = "1/10"
stiffness = "3/10/w"
forcing = [{ cos = "F" }]
[[walls]]
side = "lower"
offset = -2
restitution = 0.8
[[tasks]]
name = "g"
kind = "grazing"
parameter = "F"
reach = 0.5
[[tasks]]
name = "after"
kind = "simulate"
start = { q = 0 }
periods = 3
[[tasks]]
name = "values"
kind = "orbit"
parameter = "F"
values = [1, 1e6]
orbit = { pattern = [1] }
"#;

const BALL: &str = r#"
[system]
force = -1
[[walls]]
side = "lower"
offset = 0
restitution = "1/2"
[[tasks]]
name = "drop"
kind = "simulate"
"#;

/// Exit code, standard output, standard error, folder, of a scene of format 1 unless it has its own head.
fn command(scene: &str, arguments: &[&str]) -> (i32, String, String, TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.toml");
    let head = if scene.starts_with("format") { "" } else { HEAD };
    fs::write(&path, format!("{head}{scene}")).unwrap();
    let mut command = Command::new(crate::PROGRAM);
    let output = command.arg("run").arg(&path).args(arguments).arg("-o").arg(folder.path()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr), folder)
}

fn json(scene: &str, arguments: &[&str]) -> (i32, Value, String, TempDir) {
    let arguments: Vec<&str> = arguments.iter().copied().chain(["--format", "json"]).collect();
    let (code, out, error, folder) = command(scene, &arguments);
    (code, serde_json::from_str(&out).expect(&error), error, folder)
}

#[test]
fn a_task_that_finds_nothing_does_not_end_the_rest() {
    let (code, report, error, folder) = json(FAILING, &[]);
    assert_eq!(code, 3, "{error}");
    let task = |name: &str| {
        let all = report["tasks"].as_array().unwrap();
        all.iter().find(|task| task["task"] == name).unwrap_or_else(|| panic!("{name}: {report}"))
    };
    // Nothing to begin with: said with task, file and line, on standard error too.
    assert_eq!(task("g")["status"], "nothing-found");
    assert!(!task("g")["reason"].as_str().unwrap().is_empty());
    assert_eq!(task("g")["place"]["line"], 15);
    assert!(task("g")["place"]["file"].as_str().unwrap().ends_with("s.toml"));
    // The next one runs and is kept.
    assert_eq!(task("after")["status"], "done");
    assert!(fs::read_to_string(folder.path().join("after.csv")).unwrap().lines().count() == 3 * 64 + 2);
    let effects = task("after")["effects"].as_object().unwrap();
    assert!(effects["piece"].as_u64() > Some(0) && effects["lower_gap"].as_u64() > Some(0), "{effects:?}");
    assert!(!effects.contains_key("cubic") && !effects.contains_key("upper_gap"), "{effects:?}");
    // One value has orbits or not; whatever is missing gets a sentence.
    let values = task("values");
    assert!(values["status"] == "done" || values["reason"].is_string(), "{values}");
}

/// An oscillator with a cubic spring, and one without, under forcing beside a wall.
fn forced(cubic: &str, tasks: &str) -> Scene {
    let text = format!(
        r#"{HEAD}
[parameters]
F = "1/2"
d = "1/5"
[system]
damping = "d"
stiffness = 1
cubic = {cubic}
forcing = [{{ cos = "F" }}]
[[walls]]
side = "lower"
offset = -0.4
restitution = 0.7
{tasks}"#
    );
    Scene::from_toml(&text, "s.toml").unwrap()
}

/// What orbits take is counted as what motions take: the integrator's steps, the pieces that are looked at
/// for minima of the gap, and the forcing in both.
#[test]
fn orbits_events_and_branches_count_their_work() {
    let tasks = r#"
[[tasks]]
name = "orbit"
kind = "orbit"
orbit = { pattern = [1] }
[[tasks]]
name = "event"
kind = "event"
parameter = "F"
event = "saddle-node"
orbit = { pattern = [1] }
[[tasks]]
name = "branch"
kind = "branch"
parameter = "F"
range = [0.4, 0.6]
starts = [{ orbit = { pattern = [1] }, at = 0.5 }]
"#;
    for (cubic, counted) in [("0", false), ("0.3", true)] {
        for report in run(&forced(cubic, tasks), Surroundings::default(), &mut ()).unwrap() {
            let count = |name: &str| {
                let found = report.effects.iter().find(|(other, _)| *other == name);
                found.map_or(0, |(_, count)| *count)
            };
            let all = format!("{} {:?} {:?}", report.task, report.status, report.effects);
            assert!(["piece", "lower_gap", "drive"].into_iter().all(|name| count(name) > 0), "{all}");
            assert_eq!((count("cubic") > 0, count("upper_gap"), count("smooth")), (counted, 0, 0), "{all}");
        }
    }
}

/// Interrupts after so many units.
struct After(std::sync::atomic::AtomicI64);

impl Monitor for After {
    fn advance(&self, units: u64) -> Result<()> {
        let left = self.0.fetch_sub(units as i64, std::sync::atomic::Ordering::Relaxed) - units as i64;
        if left <= 0 { Err(Error::interrupted("enough")) } else { Ok(()) }
    }
}

/// The report of one task, with a folder for its checkpoint or without.
fn one(scene: &Scene, task: &Task, folder: Option<&std::path::Path>, monitor: &dyn Monitor) -> TaskReport {
    let around = Surroundings { folder, monitor, ..Surroundings::default() };
    run_task(&Job::new(scene, task, around).unwrap(), &mut ())
}

/// A resumed run and parts put together have the findings and the counts of one run.
#[test]
fn counts_are_those_of_one_run_however_it_was_done() {
    let tasks = r#"
[[tasks]]
name = "basins"
kind = "basins"
q = { from = -0.3, to = 1, count = 5 }
u = { from = -1, to = 1, count = 40 }
transient = 20
longest = 4
[[tasks]]
name = "diagram"
kind = "diagram"
parameter = "F"
range = [0.3, 0.9]
count = 150
starts = [{ q = 0 }, { q = 0.5 }]
transient = 20
points = 16
longest = 4
[[tasks]]
name = "map"
kind = "map"
parameter = "F"
range = [0.3, 0.9]
count = 4
second = "d"
second_range = [0.1, 0.3]
second_count = 20
start = { q = 0 }
transient = 20
points = 16
longest = 4
"#;
    for cubic in ["0", "0.3"] {
        let scene = forced(cubic, tasks);
        for (task, done) in scene.tasks.iter().zip([20, 70, 10]) {
            let whole = one(&scene, task, None, &());
            assert!(whole.effects.iter().any(|(_, count)| *count > 0), "{}", task.name);
            let folder = tempfile::tempdir().unwrap();
            let stopped = one(&scene, task, Some(folder.path()), &After(done.into()));
            assert_ne!(stopped.status, Status::Done, "{}", task.name);
            assert!(folder.path().join(format!("{}.checkpoint", task.name)).exists(), "{}", task.name);
            let resumed = one(&scene, task, Some(folder.path()), &());
            assert_eq!(resumed.effects, whole.effects, "{}, resumed", task.name);
            let (units, _) = parts::units(task).unwrap();
            let mut records = Vec::new();
            for range in [0..units / 3, units / 3..units] {
                let job = Job::new(&scene, task, Surroundings::default()).unwrap();
                let file = folder.path().join(format!("{}.{}", task.name, range.start));
                records.extend(parts::part(&job, range, &file).unwrap());
            }
            let job = Job::new(&scene, task, Surroundings::default()).unwrap();
            let merged = parts::whole(&job, &records, &mut ());
            assert_eq!(
                (&merged.effects, &merged.findings),
                (&whole.effects, &whole.findings),
                "{}",
                task.name
            );
        }
    }
}

#[test]
fn the_text_report_names_task_status_and_effects() {
    let (code, out, error, _folder) = command(FAILING, &["--only", "after"]);
    assert_eq!((code, error.as_str()), (0, ""));
    assert!(out.starts_with("after\n  kind             simulate\n  status           done\n"), "{out}");
    assert!(out.lines().last().unwrap().starts_with("  effects          piece "), "{out}");
}

#[test]
fn the_library_runs_what_the_command_runs() {
    let scene = Scene::from_toml(&format!("{HEAD}{BALL}start = {{ q = 0.5 }}\n"), "ball.toml").unwrap();
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    let (_, by_command, _, _folder) = json(&format!("{BALL}start = {{ q = 0.5 }}\n"), &[]);
    let task = &by_command["tasks"][0];
    assert_eq!(reports[0].status, Status::Done);
    let by_library = serde_json::to_value(&reports[0]).unwrap();
    for key in ["q", "u", "impacts", "rests", "effects", "end", "extent"] {
        assert_eq!(by_library[key], task[key], "{key}");
        assert!(!task[key].is_null(), "{key}");
    }
}

#[test]
fn restitution_above_one_and_tiny_motions_are_warned_of() {
    let lively = BALL.replace("1/2", "3/2");
    let (code, report, _, _folder) = json(&format!("{lively}start = {{ q = 0.5 }}\nperiods = 1\n"), &[]);
    let warnings = &report["tasks"][0]["warnings"];
    assert_eq!((code, warnings.as_array().unwrap().len()), (0, 1), "{warnings}");
    assert!(warnings[0].as_str().unwrap().contains("restitution of wall lower is 1.5"), "{warnings}");
    let (_, report, _, _folder) = json(&format!("{BALL}start = {{ q = 5e-10 }}\nperiods = 1\n"), &[]);
    let warnings = &report["tasks"][0]["warnings"];
    assert!(warnings[0].as_str().unwrap().contains("minimum_depth = 1e-12"), "{warnings}");
    let (_, report, _, _folder) = json(&format!("{BALL}start = {{ q = 5e-8 }}\nperiods = 1\n"), &[]);
    assert!(report["tasks"][0]["warnings"].as_array().unwrap().is_empty());
}

#[test]
fn friction_at_an_eccentric_impact_may_gain_energy_and_then_the_run_says_so() {
    // Impulses Λ along w = (1, 0) and Λₜ along t = (−1/2, √3/2) bring w·u from −1 to e and t·u from 3/10 to
    // 0: Λ(1 − 1/4) = 1 + e − 3/20, Λₜ = Λ/2 − 3/10. Of the energy they take Λ(1 − e)/2 − 3Λₜ/20.
    let found = |restitution: f64| {
        let scene = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[system]\nfrequency = \"1/(2*pi)\"\nmass = [[1, 0], [0, 1]]\n[[stops]]\nrow = [1, 0]\n\
             offset = 0\nrestitution = {restitution}\n[[friction]]\nrow = [-0.5, \"sqrt(3)/2\"]\nstop = \"1\"\n\
             coefficient = 0.5\n[[tasks]]\nname = \"hit\"\nkind = \"simulate\"\nperiods = 1\n\
             start = {{ q = [0.1, 0], u = [-1, \"-0.4/sqrt(3)\"] }}\n"
        );
        let (code, report, error, _folder) = json(&scene, &[]);
        assert_eq!((code, error.as_str()), (0, ""));
        let task = &report["tasks"][0];
        let impulse = (1.0 + restitution - 0.15) / 0.75;
        let lost = impulse * (1.0 - restitution) / 2.0 - 0.15 * (impulse / 2.0 - 0.3);
        let dissipated = task["stops"][0]["dissipated"].as_f64().unwrap();
        assert!((dissipated - lost).abs() < 1e-12, "{dissipated} {lost}");
        task["warnings"].clone()
    };
    assert_eq!(found(0.5), Value::Array(Vec::new()));
    let gained = found(1.0);
    assert!(
        gained[0].as_str().unwrap().starts_with("1 times an impact gave the motion energy: a restitution"),
        "{gained}"
    );
}

#[test]
fn a_series_too_long_is_refused_before_the_work() {
    let (code, out, error, folder) =
        command(&format!("{BALL}start = {{ q = 1 }}\nperiods = 100000001\nsamples = 1\n"), &[]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(error.contains("100000001 points, more than 100000000"), "{error}");
    assert!(!folder.path().join("drop.csv").exists());
}

#[test]
fn a_division_by_zero_names_the_point_at_which_it_happens() {
    let diagram = "[parameters]\nw = 1\n[system]\nstiffness = \"1/w\"\ndamping = 1\n[[tasks]]\nname = \"d\"\nkind = \"diagram\"\n\
        parameter = \"w\"\nrange = [-1, 1]\ncount = 3\ntransient = 10\npoints = 4\nlongest = 1\nstarts = [{ q = 1 }]\n";
    let (code, report, error, _folder) = json(diagram, &[]);
    assert_eq!(code, 2);
    let reason = report["tasks"][0]["reason"].as_str().unwrap();
    assert!(reason.contains("divides by zero (with w = 0)"), "{reason}");
    assert!(error.contains("s.toml:6: system.stiffness"), "{error}");
}

#[test]
fn values_of_a_diagram_are_the_floats_nearest_to_exact_ones() {
    let diagram = "[parameters]\nw = 1\n[system]\nstiffness = \"w\"\ndamping = 1\n[[tasks]]\nname = \"d\"\nkind = \"diagram\"\n\
        parameter = \"w\"\nrange = [0.8, 0.9]\ncount = 11\ntransient = 40\npoints = 4\nlongest = 1\nstarts = [{ q = 0 }]\n";
    let (code, _, error, folder) = json(diagram, &[]);
    assert_eq!(code, 0, "{error}");
    let text = fs::read_to_string(folder.path().join("d.csv")).unwrap();
    let values: Vec<&str> = text.lines().skip(1).map(|line| line.split(',').nth(1).unwrap()).collect();
    let exact = ["0.8", "0.81", "0.82", "0.83", "0.84", "0.85", "0.86", "0.87", "0.88", "0.89", "0.9"];
    assert_eq!(values, exact);
}

#[test]
fn words_of_other_programs_are_answered_and_far_ones_not_guessed_at() {
    for (key, answer) in [
        ("mass = 2", "the mass is 1"),
        ("gravity = 9.81", "`force` of [system]"),
        ("friction = 0.1", "dry friction stands in [[friction]]"),
        ("temperature = 1", "known here are damping, stiffness, cubic, force, forcing"),
    ] {
        let (code, _, error, _folder) = command(&BALL.replace("force = -1", key), &[]);
        assert_eq!(code, 2);
        assert!(error.contains(answer), "{error}");
    }
}

/// 10⁵ periods of 64 samples: the picture stays as small as one of a few thousand points.
#[test]
fn pictures_of_long_series_are_thinned() {
    let swing = "[system]\nstiffness = 0.37\ndamping = 0.1\nforcing = [{ cos = 1 }]\n[[walls]]\nside = \"lower\"\noffset = -0.5\n\
        restitution = 0.8\n[[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = { q = 0 }\nsamples = 16\nperiods = ";
    let (code, _, error, folder) = json(&format!("{swing}20000\n"), &[]);
    assert_eq!(code, 0, "{error}");
    let size = |name: &str| fs::metadata(folder.path().join(name)).unwrap().len();
    assert!(size("m.csv") > 8_000_000, "{}", size("m.csv"));
    assert!(size("m.svg") < 2_500_000, "{}", size("m.svg"));
    // Of short ones only points go where the line is straight.
    let (_, _, _, short) = json(&format!("{swing}2\n"), &[]);
    let svg = fs::read_to_string(short.path().join("m.svg")).unwrap();
    let lines = svg.match_indices("<path d=\"").map(|(at, _)| svg[at..].split('"').nth(1).unwrap());
    let numbers = |line: &str| line.split(['M', 'l', ' ', '-', 'Z']).filter(|part| !part.is_empty()).count();
    let corners = lines.map(|line| numbers(line) / 2).max().unwrap();
    let events = fs::read_to_string(short.path().join("m-events.csv")).unwrap();
    let impacts = events.lines().filter(|line| line.starts_with("impact")).count();
    let all = 2 * 16 + 1 + impacts;
    assert!(2 * corners > all && corners <= all, "{corners} of {all}");
}

/// Names of tasks are names of files: two that may write the same are an error at the second, before either
/// runs.
#[test]
fn tasks_that_would_write_one_file_are_refused() {
    let task = |name: &str, kind: &str, rest: &str| {
        format!("[[tasks]]\nname = \"{name}\"\nkind = \"{kind}\"\n{rest}\n")
    };
    let start = "start = { q = 0.5 }\nperiods = 1";
    let (orbit, pattern) = ("orbit", "orbit = { pattern = [1] }");
    let branch = "parameter = \"a\"\nrange = [0, 1]\nstarts = [{ at = 0.5, orbit = { pattern = [1] } }]";
    let wall = BALL.split("[[tasks]]").next().unwrap();
    let head = format!("[parameters]\na = 1\n{wall}");
    let cases = [
        (("drop", "simulate", start), ("drop-events", orbit, pattern), "drop-events.csv"),
        (("drop-events", orbit, pattern), ("drop", "simulate", start), "drop-events.csv"),
        (("Drop", "simulate", start), ("drop", orbit, pattern), "drop.csv"),
        (("br-2", "branch", branch), ("br", "branch", branch), "br-2.json"),
        (("br", "branch", branch), ("br-points", "validate", pattern), "br-points.csv"),
    ];
    for (first, second, file) in cases {
        let scene =
            format!("{head}{}{}", task(first.0, first.1, first.2), task(second.0, second.1, second.2));
        let (code, out, error, folder) = command(&scene, &[]);
        assert_eq!((code, out.as_str()), (2, ""), "{error}");
        let said = format!("this task and the task {} would both write {file}: rename one", first.0);
        let line = HEAD.lines().count()
            + scene.lines().position(|line| line.contains(&format!("\"{}\"", second.0))).unwrap()
            + 1;
        assert!(error.contains(&said) && error.contains(&format!("s.toml:{line}: ")), "{error}");
        let written: Vec<_> =
            fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(written, ["s.toml"], "{file}");
    }
    // One of them alone may run.
    let scene = format!("{head}{}{}", task("drop", "simulate", start), task("drop-events", orbit, pattern));
    assert_eq!(command(&scene, &["--only", "drop"]).0, 0);
}

/// The word theorem at the paper's grazing: the full shift over 1, 2, 3 for e mu < 0 and γ > 0, nothing that
/// branches for e mu > 0. At w = 4.8, where s = 1/6 and u_3 = 0, rounding leaves period 3 open, and 1 and 2
/// give a lower bound.
#[test]
fn a_grazing_task_says_whether_chaos_is_born() {
    let report = |scene: &str| {
        let folder = tempfile::tempdir().unwrap();
        let path = format!("{}/../../examples/scenes/{scene}", env!("CARGO_MANIFEST_DIR"));
        let run = |format: &str| {
            let mut command = Command::new(crate::PROGRAM);
            let command = command.args(["run", &path, "--only", "grazing", "--format", format, "-o"]);
            String::from_utf8(command.arg(folder.path()).output().unwrap().stdout).unwrap()
        };
        let json: Value = serde_json::from_str(&run("json")).unwrap();
        (json["tasks"][0]["chaos"].clone(), run("text"))
    };
    let row = |chaos: &Value, emu: i64| {
        let rows = chaos.as_array().unwrap();
        assert_eq!(rows.len(), 2);
        rows.iter().find(|row| row["sign_emu"] == emu).unwrap().clone()
    };
    let near = |row: &Value, expected: f64| {
        let found: f64 = row["entropy"].as_str().unwrap().parse().unwrap();
        assert!((found - expected).abs() < 1e-14, "{row}");
    };
    let (chaos, text) = report("nordmark-2001.toml");
    let (plus, minus) = (row(&chaos, 1), row(&chaos, -1));
    assert_eq!((&plus["chaos"], &plus["periods"]), (&Value::from(false), &Value::from(vec![1, 4])));
    assert_eq!((&minus["chaos"], &minus["periods"]), (&Value::from(true), &Value::from(vec![1, 2, 3])));
    assert_eq!((&minus["sign_gamma"], &minus["at_least"]), (&Value::from(1), &Value::from(false)));
    // z + z² + z³ = 1: the tribonacci constant.
    near(&minus, 1.839_286_755_214_161_1f64.ln());
    let line = text.lines().find(|line| line.trim_start().starts_with("chaos ")).expect(&text);
    assert!(
        line.contains("none for mu ") && line.contains("born for mu ") && line.contains("(-,+)"),
        "{line}"
    );

    let (chaos, text) = report("nordmark-2001-w48.toml");
    let minus = row(&chaos, -1);
    assert_eq!((&minus["periods"], &minus["at_least"]), (&Value::from(vec![1, 2]), &Value::from(true)));
    near(&minus, ((1.0 + 5f64.sqrt()) / 2.0).ln());
    assert!(text.contains("entropy at least 0.48121"), "{text}");
}

/// A force that changes in less than the shortest step: tasks say where, in text, JSON and exit code.
#[test]
fn a_force_that_is_too_steep_is_named_with_its_place() {
    let steep = "[system]\nforce = \"-q + tanh((q - 0.1)/1e-11)\"\n[[tasks]]\nname = \"steep\"\n";
    for task in [
        "kind = \"simulate\"\nstart = { q = 0.3, u = -1 }\nperiods = 3\n",
        "kind = \"orbit\"\norbit = { pattern = [], start = [0.3, -1] }\n",
    ] {
        let scene = format!("{steep}{task}");
        let (code, report, error, _folder) = json(&scene, &[]);
        let task = &report["tasks"][0];
        let reason = task["reason"].as_str().unwrap_or_else(|| panic!("{report}"));
        assert_eq!(code, 3, "{error}{report}");
        assert!(reason.contains("where its force is too steep"), "{reason}");
        // The motion comes to q = 0.1 and no farther.
        let (_, after) = reason.split_once("at q = ").unwrap_or_else(|| panic!("{reason}"));
        let (q, rest) = after.split_once(", u = ").unwrap_or_else(|| panic!("{reason}"));
        assert!((q.parse::<f64>().unwrap() - 0.1).abs() < 1e-6, "{reason}");
        let (u, bend) = rest.split_once(" with the acceleration ").unwrap_or_else(|| panic!("{reason}"));
        let [u, bend] = [u, bend].map(|text| text.trim().parse::<f64>().unwrap());
        // With energy u²/2 + q²/2 − |q − 0.1| at the start; the force is between −1.1 and 0.9.
        let energy = 0.5 + 0.045 - 0.2;
        assert!((u + (2.0f64 * (energy - 0.005)).sqrt()).abs() < 1e-5, "{reason}");
        assert!(bend.abs() <= 1.1 + 1e-9, "{reason}");
        let (code, out, error, _folder) = command(&scene, &[]);
        assert!(code == 3 && format!("{out}{error}").contains(reason), "{out}{error}");
    }
}

/// Of a row of A, as text: 6 digits, 3 if asked for, and with 17 the floats of JSON.
#[test]
fn text_has_the_digits_asked_for_and_json_has_all() {
    let path = format!("{}/../../examples/scenes/nordmark-2001.toml", env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| {
        let mut command = Command::new(crate::PROGRAM);
        let command = command.args(["run", &path, "--only", "grazing", "-o"]).arg(folder.path());
        String::from_utf8(command.args(arguments).output().unwrap().stdout).unwrap()
    };
    let row = |arguments: &[&str]| -> Vec<f64> {
        let text = run(arguments);
        let line = text.lines().find_map(|line| line.trim_start().strip_prefix("A ")).expect(&text);
        line.split(',').map(|x| x.trim().parse().unwrap()).collect()
    };
    let json: Value = serde_json::from_str(&run(&["--format", "json"])).unwrap();
    let all: Vec<f64> =
        json["tasks"][0]["A"][0].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    assert_eq!(row(&["--digits", "17"]), all);
    for (arguments, digits) in [(&[][..], 6), (&["--digits", "3"], 3)] {
        let rounded = |x: &f64| format!("{x:.*e}", digits - 1).parse::<f64>().unwrap();
        assert_eq!(row(arguments), all.iter().map(rounded).collect::<Vec<_>>());
        assert_ne!(row(arguments), all);
    }
    for (wrong, why) in [
        ("0", "from 1 to 17"),
        ("18", "from 1 to 17"),
        ("100000", "from 1 to 17"),
        ("-1", "negative"),
        ("1/2", "whole"),
    ] {
        let mut command = Command::new(crate::PROGRAM);
        let output = command.args(["run", &path, "--digits", wrong]).output().unwrap();
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{wrong}: {error}");
        assert!(error.contains("--digits") && error.contains(why), "{wrong}: {error}");
    }
}

/// A run may be asked for in the scene's unit of time, by both engines: it ends there, with a last point.
#[test]
fn a_duration_ends_where_it_says() {
    let scene = |engine: &str, system: &str, keys: &str| {
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = {engine:?}\n[parameters]\nT = 2.5\n[system]\n{system}\nstiffness = 2\n\
             [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nsamples = 8\nstart = {{ q = 1 }}\n{keys}\n"
        )
    };
    let [radians, other] = ["damping = 0.1", "period = 3\nmass = 1\ndamping = 0.1"];
    for (engine, system, period) in
        [("one", radians, std::f64::consts::TAU), ("one", other, 3.0), ("many", other, 3.0)]
    {
        for (keys, time) in
            [("duration = \"3*T\"", 7.5), ("duration = 0.01", 0.01), ("duration = 6\ntransient = 2", 6.0)]
        {
            let text = scene(engine, system, keys);
            let (code, output, error, folder) = command(&text, &[]);
            assert_eq!(code, 0, "{output} {error}");
            let rows = fs::read_to_string(folder.path().join("m.csv")).unwrap();
            let last: Vec<f64> =
                rows.lines().last().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
            let begin = if keys.contains("transient") { 2.0 * period } else { 0.0 };
            assert!((last[0] - begin - time).abs() < 1e-12 * (1.0 + begin), "{system} {keys}: {last:?}");
            let points = (8.0 * time / period).floor() + 1.0 + f64::from(8.0 * time / period % 1.0 > 1e-9);
            assert_eq!(rows.lines().count() as f64 - 1.0, points, "{rows}");
            // q = e^{−t/20} (cos ωt + sin ωt/(20 ω)), ω² = 2 − 1/400.
            let (t, w) = (begin + time, (2.0f64 - 1.0 / 400.0).sqrt());
            let q = (-t / 20.0).exp() * ((w * t).cos() + (w * t).sin() / (20.0 * w));
            assert!((last[2] - q).abs() < 1e-12, "{last:?} {q}");
        }
        // No time twice or backwards: 0.3 of 0.1 is not 3 in floats, nor is a third of 7/3.
        for (period, duration) in [("0.1", "0.3"), ("1/3", "7/9"), ("0.1", "1.1"), ("3", "\"3 - 2^-40\"")] {
            if system == radians {
                continue;
            }
            let text =
                scene(engine, &format!("period = \"{period}\"\nmass = 1"), &format!("duration = {duration}"));
            let text = text.replace("= 7/9", "= \"7/9\"");
            let (code, output, error, folder) = command(&text, &["--format", "json"]);
            assert_eq!(code, 0, "{output} {error}");
            let rows = fs::read_to_string(folder.path().join("m.csv")).unwrap();
            let times: Vec<f64> =
                rows.lines().skip(1).map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
            assert!(times.windows(2).all(|pair| pair[0] < pair[1]), "{times:?}");
            let number = |text: &str| {
                let parts: Vec<f64> = text.split('/').map(|x| x.parse().unwrap()).collect();
                parts[0] / parts.get(1).unwrap_or(&1.0)
            };
            let wanted = if duration.contains('^') { 3.0 - 2f64.powi(-40) } else { number(duration) };
            assert!((times[times.len() - 1] - wanted).abs() < 1e-14 * wanted, "{duration}: {times:?}");
            let report: Value = serde_json::from_str(&output).unwrap();
            let periods = (wanted / number(period) * (1.0 - 1e-14)).ceil();
            assert_eq!(report["tasks"][0]["periods"], periods, "{duration}");
        }
        for (keys, answer) in [
            ("duration = 3\nperiods = 2", "stands beside `periods`"),
            ("duration = 0", "is not positive"),
            ("duration = \"-T\"", "is not positive"),
            ("duration = 1e300", "more than 100000000"),
            ("duration = \"1/0\"", "divides by zero"),
        ] {
            let (code, _, error, _folder) = command(&scene(engine, system, keys), &[]);
            assert!(code == 2 && error.contains(answer) && error.contains("duration"), "{keys}: {error}");
        }
    }
}
