//! `grazing run` on every example; figures 8 to 10 against exact orbits; absent effects; the studies of cost
//! and accuracy.

use std::{
    collections::{HashMap, HashSet},
    f64::consts::PI,
    fs,
    path::Path,
    process::Command,
};

use grazing_scenes::{
    attractor::detection::{Detection, Fate},
    motion::{Effect, Side, Time},
    one::{
        orbit::{Itinerary, Oscillator, SingleImpact, find},
        simulate::{Settings, Simulator},
    },
    scene::Scene,
};
use grazing_study::{
    effects::{PERIODS, effects, machine_effects},
    flow_accuracy::{long_runs, returning, tolerances},
};
use tempfile::TempDir;

use crate::samples::larger;

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes");

/// Exit code, standard output, standard error, and the folder with the files.
fn grazing(arguments: &[&str]) -> (i32, String, String, TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(crate::PROGRAM);
    let output = command.args(arguments).arg("-o").arg(folder.path()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr), folder)
}

fn read(folder: &TempDir, file: &str) -> String {
    fs::read_to_string(folder.path().join(file)).unwrap()
}

fn rows(text: &str) -> Vec<HashMap<String, String>> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(Result::unwrap).collect()
}

/// Scenes that take eight to twenty seconds each: where more than the least sample is asked for.
const LONG: [&str; 3] =
    ["nordmark-2001.toml", "nordmark-2001-branches.toml", "nordmark-2001-chaos-further.toml"];

#[test]
fn every_example_runs_and_writes_what_it_says() {
    let mut count = 0;
    for file in fs::read_dir(SCENES).unwrap() {
        let path = file.unwrap().path();
        if LONG.iter().any(|long| path.ends_with(long)) && !larger(&format!("{path:?}")) {
            continue;
        }
        let (code, out, error, folder) = grazing(&["run", path.to_str().unwrap(), "--format", "json"]);
        // At the resonance of section 4.1 the theory leaves the pattern 1,3 undecided.
        let expected = if path.ends_with("nordmark-2001-w48.toml") { 3 } else { 0 };
        assert_eq!((code, error.as_str()), (expected, ""), "{path:?}");
        let report: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert_eq!(report["format"], "grazing-run 4");
        let tasks = report["tasks"].as_array().unwrap();
        assert!(!tasks.is_empty());
        for task in tasks {
            // The one task that leaves something open says so; no motion ends early.
            assert!(task["status"] == "done" || expected == 3 && task["reason"].is_string(), "{task}");
            assert!(task["ended"].as_array().is_none_or(Vec::is_empty), "{task}");
            for file in task["files"].as_array().into_iter().flatten() {
                assert!(!read(&folder, file.as_str().unwrap()).is_empty());
            }
        }
        // Nothing but what is whole: no temporary file is left.
        let hidden = |file: fs::DirEntry| file.file_name().to_string_lossy().starts_with('.');
        assert!(!fs::read_dir(folder.path()).unwrap().any(|file| hidden(file.unwrap())));
        count += 1;
    }
    assert!(count >= 6);
}

#[test]
fn every_machine_runs_and_touches_its_stops_if_it_has_any() {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("examples/machines");
    let (mut count, mut closed_ones) = (0, 0);
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let (code, text, error, out) = grazing(&["run", path.to_str().unwrap(), "--format", "json"]);
        assert_eq!(code, 0, "{path:?}: {text} {error}");
        let report: serde_json::Value = serde_json::from_str(&text).unwrap();
        for task in report["tasks"].as_array().unwrap() {
            if task["kind"] != "simulate" {
                continue;
            }
            let stops = task["stops"].as_array().unwrap();
            let impacts: u64 = stops.iter().map(|stop| stop["impacts"].as_u64().unwrap()).sum();
            let rubbed = task["friction"].as_array().is_some_and(|all| !all.is_empty());
            assert!(impacts > 0 || rubbed && stops.is_empty(), "{path:?}: {task}");
            for stop in stops {
                let compliant = stop["peak_force"].is_number();
                assert!(
                    compliant
                        || stop["least_gap"].as_f64().unwrap() >= -task["minimum_depth"].as_f64().unwrap(),
                    "{path:?}: {stop}"
                );
            }
            // The events in the file are those of the report.
            let events = read(&out, &format!("{}-events.csv", task["task"].as_str().unwrap()));
            // What events took is what their stops took.
            let energy = |line: &str| line.rsplit(',').next().unwrap().parse::<f64>().unwrap_or(0.0);
            let told: f64 = events.lines().skip(1).map(energy).sum();
            let taken: f64 = stops.iter().map(|stop| stop["dissipated"].as_f64().unwrap()).sum();
            // Contacts begin and end in turn, unless one lasts where the series begins or ends.
            let bounds: Vec<bool> = events
                .lines()
                .filter(|line| {
                    line.starts_with("touch,") || line.starts_with("release,") && !line.ends_with(",,")
                })
                .map(|line| line.starts_with("touch,"))
                .collect();
            let closed = bounds.first() != Some(&false) && bounds.last() != Some(&true);
            closed_ones += u32::from(closed);
            // An undamped spring takes nothing, to the last bit.
            let takes = !stops.is_empty() && !path.ends_with("bilinear.toml");
            assert_eq!(taken > 0.0, takes, "{path:?}: {task}");
            assert!(!closed || (told - taken).abs() <= 1e-9 * taken, "{path:?}: {told} {taken}");
            assert_eq!(
                events
                    .lines()
                    .filter(|line| line.starts_with("impact,") || line.starts_with("touch,"))
                    .count() as u64,
                impacts
            );
        }
        count += 1;
    }
    assert!(count >= 10 && closed_ones >= 8, "{count} {closed_ones}");
}

#[test]
fn what_cannot_run_says_why_and_writes_nothing() {
    let scene = format!("{SCENES}/free.toml");
    for (arguments, message) in [
        (&["run", "no-such.toml"][..], "error: cannot read no-such.toml: "),
        (&["run", &scene, "--only", "fre"], &format!("error: --only fre: {scene} has the tasks free\n")),
        (
            &["run", &scene, "--set", "v=1"],
            &format!("error: {scene}: the scene has no parameter \"v\"; there are d, w\n"),
        ),
        (
            &["run", &scene, "--set", "w"],
            "error: invalid value 'w' for '--set <NAME=VALUE>': write NAME=VALUE",
        ),
        (
            &["run", &scene, "--set", "w=0"],
            &format!(
                "error: {scene}:12: system.damping = \"2*d/w\": divides by zero (with d = 1/10, w = 0)\n"
            ),
        ),
    ] {
        let (code, out, error, folder) = grazing(arguments);
        assert_eq!((code, out.as_str()), (2, ""), "{error}");
        assert!(error.starts_with(message), "{error}\n{message}");
        assert!(fs::read_dir(folder.path()).unwrap().next().is_none());
    }
}

/// A key set to 0 and one that is absent, a term added and taken away again: the same bits.
#[test]
fn a_zero_and_nothing_give_the_same_output() {
    let base = "format = \"grazing-scene 1\"\ntitle = \"t\"\n[system]\nstiffness = 0.3\ndamping = 0.02\nforcing = [{ k = 2, cos = 0.4 }]\nEXTRA\n\
        [[walls]]\nside = \"lower\"\noffset = -0.05\nrestitution = 0.9\nHARMONICS\n\
        [[tasks]]\nname = \"t\"\nkind = \"simulate\"\nstart = { q = 1 }\nperiods = 30\nsamples = 8\n";
    let output = |text: &str| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("s.toml");
        fs::write(&path, text).unwrap();
        let (code, out, error, files) = grazing(&["run", path.to_str().unwrap()]);
        assert_eq!(code, 0, "{error}\n{text}");
        (out, read(&files, "t.csv"), read(&files, "t-events.csv"), read(&files, "t.svg"))
    };
    let plain = output(&base.replace("EXTRA", "").replace("HARMONICS", ""));
    assert!(rows(&plain.2).len() > 5);
    // Periods and phases, which are fractions of one, ascend.
    let times: Vec<f64> = rows(&plain.2)
        .iter()
        .map(|row| {
            let [period, phase] = ["period", "phase"].map(|name| row[name].parse::<f64>().unwrap());
            assert!((0.0..1.0).contains(&phase), "{row:?}");
            period + phase
        })
        .collect();
    let one_per_period = |pair: &[f64]| (0.8..1.2).contains(&(pair[1] - pair[0]));
    assert!(times.windows(2).all(one_per_period), "{times:?}");
    for (extra, harmonics) in [
        ("cubic = 0", ""),
        ("force = \"1 - 1\"", ""),
        ("cubic = -0.0", "harmonics = []"),
        ("", "harmonics = [{ k = 1, cos = 0 }, { k = 3, sin = \"0/7\" }]"),
    ] {
        let text = base.replace("EXTRA", extra).replace("HARMONICS", harmonics);
        assert_eq!(output(&text), plain, "{extra} {harmonics}");
    }
    let zero = base.replace("k = 2, cos = 0.4 }", "k = 2, cos = 0.4 }, { k = 5, cos = 0 }");
    assert_eq!(output(&zero.replace("EXTRA", "").replace("HARMONICS", "")), plain);
}

fn paper(mu: f64) -> Scene {
    let path = Path::new(SCENES).join("nordmark-2001.toml");
    let scene = Scene::from_toml(&fs::read_to_string(path).unwrap(), "paper").unwrap();
    let mu = grazing_scenes::number::parse_rational(&mu.to_string()).unwrap();
    scene.with(&[("mu".to_string(), mu)]).unwrap()
}

/// The points (q − (Q₁ − offset), u − Q₁′) at t = π of the period-4 orbits, from the exact formulas for one
/// impact.
fn exact(mu: f64, n: u32, stable: bool) -> Vec<[f64; 2]> {
    let system = paper(mu).plain(&[]).unwrap();
    let oscillator = Oscillator::new(system.clone(), 1e-13).unwrap();
    let single = SingleImpact::new(&system, Side::Lower, n).unwrap();
    let speeds = single.speeds();
    let speed = speeds.into_iter().find(|&speed| single.multipliers(speed).is_stable() == stable).unwrap();
    let itinerary = Itinerary::at(Side::Lower, &[n]).unwrap();
    let orbit = find(&oscillator, &itinerary, vec![single.phase(speed), speed]).unwrap();
    assert!((orbit.z[1] - speed).abs() < 1e-9);
    (0..n)
        .map(|i| {
            let state = orbit.state(&oscillator, PI + 2.0 * PI * f64::from(i)).unwrap();
            [state.q + (1.0 + mu), state.u]
        })
        .collect()
}

/// Those of a set of a figure's CSV.
fn points(csv: &str, set: &str) -> Vec<[f64; 2]> {
    let number = |row: &HashMap<String, String>, key| row[key].parse::<f64>().unwrap();
    rows(csv).iter().filter(|row| row["set"] == set).map(|row| [number(row, "q"), number(row, "u")]).collect()
}

fn same(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let near = |x: &[f64; 2], y: &[f64; 2]| (x[0] - y[0]).abs() + (x[1] - y[1]).abs() < 1e-5;
    a.len() == b.len() && a.iter().all(|x| b.iter().any(|y| near(x, y)))
}

#[test]
fn figures_8_to_10_show_what_the_captions_say() {
    let draw = |number: &str| {
        let (code, _, error, folder) = grazing(&["figure", number]);
        assert_eq!(code, 0, "{error}");
        read(&folder, &format!("figure{number}.csv"))
    };
    // A stable orbit without impacts, an unstable and a stable one of period 4 with one impact.
    let csv = draw("8");
    assert!(same(&points(&csv, "stable, period 1 with 0 impacts"), &[[0.95, 0.0]]));
    assert!(same(&points(&csv, "stable, period 4 with 1 impact"), &exact(-0.05, 4, true)));
    assert!(same(&points(&csv, "unstable, impact pattern (4)"), &exact(-0.05, 4, false)));

    // A noisy attractor of period 4, with points on both sides of the curve: it lies in four parts, met in
    // turn.
    let csv = draw("9");
    assert!(same(&points(&csv, "stable, period 1 with 0 impacts"), &[[0.976, 0.0]]));
    assert!(same(&points(&csv, "unstable, impact pattern (4)"), &exact(-0.024, 4, false)));
    let noisy = points(&csv, "attractor, not periodic");
    assert_eq!(noisy.len(), 2000);
    let curve = points(&csv, "where the next period grazes the lower stop");
    let left_of_curve = |point: &[f64; 2]| {
        let pair = curve.windows(2).find(|pair| (pair[0][1] - point[1]) * (pair[1][1] - point[1]) <= 0.0)?;
        let slope = (pair[1][0] - pair[0][0]) / (pair[1][1] - pair[0][1]);
        Some(point[0] < pair[0][0] + slope * (point[1] - pair[0][1]))
    };
    let mut near = 0;
    for part in 0..4 {
        let points: Vec<_> = noisy.iter().skip(part).step_by(4).collect();
        let wide =
            points.iter().map(|p| p[0]).fold((9.0f64, -9.0f64), |(low, high), q| (low.min(q), high.max(q)));
        assert!(wide.1 - wide.0 < 1.0, "part {part} goes from {} to {}", wide.0, wide.1);
        let left = points.iter().filter(|point| left_of_curve(point) == Some(true)).count();
        near += usize::from(left > 0 && left < points.len());
    }
    assert_eq!(near, 1, "one of the four parts lies across the curve");

    // One attractor, which the unstable orbit of period 3 is part of.
    let csv = draw("10");
    let (attractor, orbit) = (points(&csv, "attractor, not periodic"), exact(0.003, 3, false));
    assert!(same(&points(&csv, "unstable, impact pattern (3)"), &orbit));
    for point in orbit {
        let distance = |x: &[f64; 2]| (x[0] - point[0]).hypot(x[1] - point[1]);
        assert!(attractor.iter().map(distance).fold(9.0, f64::min) < 0.03);
    }
}

#[test]
fn basins_over_phases_are_those_of_their_starts() {
    let folder = tempfile::tempdir().unwrap();
    let paper = fs::read_to_string(Path::new(SCENES).join("nordmark-2001.toml")).unwrap();
    let head = &paper[..paper.find("[[tasks]]").unwrap()];
    let task = "[[tasks]]\nname = \"phases\"\nkind = \"basins\"\nset = { mu = -0.05 }\nplane = [\"phase\", \"q\"]\n\
                start = { q = 0, u = 0.3 }\nq = { from = -0.5, to = 0.75, count = 11 }\n\
                u = { from = -2.5, to = 3, count = 12 }\nphase = 0.25\ntransient = 200\nlongest = 8\n";
    let file = folder.path().join("phases.toml");
    fs::write(&file, format!("{head}{task}")).unwrap();
    let (code, out, error, written) = grazing(&["run", file.to_str().unwrap(), "--format", "json"]);
    assert_eq!((code, error.as_str()), (0, ""));
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["tasks"][0]["plane"], serde_json::json!(["phase", "q"]));
    let simulator =
        Simulator::new(&self::paper(-0.05).exact(&[]).unwrap().rounded(), &Settings::default()).unwrap();
    let detection = Detection { phase: PI / 2.0, transient: 200, longest: 8, ..Detection::default() };
    let (mut seen, mut count) = (HashSet::new(), 0);
    for row in rows(&read(&written, "phases.csv")) {
        let [phase, q] = ["q", "u"].map(|column| row[column].parse::<f64>().unwrap());
        let expected = match simulator.start(Time::new(0, 2.0 * PI * phase.rem_euclid(1.0)), q, 0.3) {
            Err(_) => "behind a stop".to_string(),
            Ok(mut run) => match detection.detect(&simulator, &mut run, &()).unwrap() {
                Fate::Periodic(cycle) => {
                    let plural = if cycle.impacts == 1 { "" } else { "s" };
                    format!("period {}, {} impact{plural}", cycle.period(), cycle.impacts)
                }
                Fate::Irregular => "not periodic".to_string(),
                other => panic!("{other:?}"),
            },
        };
        assert_eq!(row["ends"], expected, "phase {phase}, q {q}");
        seen.insert(expected);
        count += 1;
    }
    assert!(count == 132 && seen.len() >= 3, "{count} {seen:?}");
}

#[test]
fn exponents_of_periodic_motions_are_their_multipliers() {
    let scene = format!("{SCENES}/nordmark-2001.toml");
    let (_, out, _, _folder) = grazing(&["run", &scene, "--only", "figure8", "--format", "json"]);
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    let attractors = report["tasks"][0]["attractors"].as_array().unwrap();
    let exponent = |i: usize| attractors[i]["lyapunov_per_period"].as_f64().unwrap();
    assert!((exponent(0) + 2.0 * PI * 0.6 / 4.9).abs() < 0.02);
    let single = SingleImpact::new(&paper(-0.05).plain(&[]).unwrap(), Side::Lower, 4).unwrap();
    let stable = single.speeds().into_iter().map(|v| single.multipliers(v)).find(|m| m.is_stable()).unwrap();
    let largest = stable.values().map(|(re, im)| re.hypot(im)).into_iter().fold(0.0, f64::max);
    assert!((exponent(1) - largest.ln() / 4.0).abs() < 0.01, "{} {largest}", exponent(1));
}

#[test]
fn absent_effects_are_never_evaluated() {
    for effect in effects() {
        let (counts, impacts) = effect.count(PERIODS).unwrap();
        for what in Effect::ALL {
            let needed = effect.needs.contains(&what);
            assert_eq!(counts.of(what) > 0, needed, "{}: {} {}", effect.name, what.name(), counts.of(what));
        }
        assert_eq!(impacts > 1000, effect.name.ends_with("hit"), "{}: {impacts}", effect.name);
    }
}

#[test]
fn absent_effects_of_machines_are_never_evaluated() {
    for effect in machine_effects() {
        let (counts, impacts) = effect.count(PERIODS).unwrap();
        for (what, count) in Effect::OF_MACHINES.iter().zip(counts) {
            let needed = effect.needs.contains(what);
            assert_eq!(count > 0, needed, "{}: {} {count}", effect.name, what.name());
        }
        assert_eq!(impacts > 1000, effect.name.ends_with("hit"), "{}: {impacts}", effect.name);
    }
}

#[test]
fn error_falls_with_the_tolerance_down_to_the_closed_form() {
    for case in returning() {
        let closed = case.measure(None).unwrap();
        assert!(closed.error < 1e-10, "{closed:?}");
        let errors: Vec<f64> =
            tolerances().into_iter().map(|tolerance| case.measure(Some(tolerance)).unwrap().error).collect();
        assert_eq!(errors.len(), 11);
        // Four orders of magnitude of tolerance are at least two of error, nearly grazing or not.
        for (coarse, fine) in errors.iter().zip(&errors[4..]) {
            assert!(fine < &(coarse / 100.0) || coarse > &1e-3, "{}: {coarse:e} {fine:e}", case.name);
        }
        assert!(errors[10] < 1e-9, "{errors:?}");
    }
}

#[test]
fn long_runs_stay_on_their_exact_motion() {
    for row in long_runs(4).unwrap() {
        let periods = row.periods as f64;
        if row.name.starts_with("section") {
            assert!(row.distance < 1e-13, "{row:?}");
        } else if let Some(energy) = row.energy {
            assert!(energy < 1e-14 * (1.0 + periods), "{row:?}");
        } else {
            assert!(row.distance < 1e-14 * (1.0 + periods), "{row:?}");
        }
    }
}

#[test]
fn figures_6_and_7_make_their_folder_and_leave_no_checkpoint() {
    for (number, files) in [("6", 8), ("7", 3)] {
        let outside = tempfile::tempdir().unwrap();
        let folder = outside.path().join("new");
        let output =
            Command::new(crate::PROGRAM).args(["figure", number, "-o"]).arg(&folder).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let names: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(names.len(), files, "{names:?}");
        assert!(names.iter().all(|name| !name.to_string_lossy().contains("checkpoint")), "{names:?}");
    }
}

/// z″ = −sin t comes within the depth of the stop before t = 0, rises, not to 0, and is pressed from 0 on:
/// the mass rests there until the force turns, at t = π. By both engines, and by the one that follows many
/// at once.
#[test]
fn what_touches_and_is_pressed_before_it_opens_comes_to_rest() {
    let depth = 1e-10f64;
    let start = |(m, part): (f64, f64)| {
        let (t, tm) = (-2e-3f64, -m);
        let q = -part * depth - (t.powi(3) - tm.powi(3)) / 6.0 + tm * tm * (t - tm) / 2.0;
        format!("{{ phase = {:?}, q = {q:?}, u = {:?} }}", 1.0 + t / (2.0 * PI), (tm * tm - t * t) / 2.0)
    };
    // The first minimum at −m, that part of the depth below 0; then it rises by 2m³/3.
    let starts = [
        (1e-4, 0.9),
        (2e-4, 0.9),
        (3e-4, 0.9),
        (4e-4, 0.9),
        (1e-4, 0.99),
        (2e-4, 0.99),
        (1e-4, 0.5),
        (2e-4, 0.5),
    ];
    for engine in ["one", "many"] {
        for restitution in [0.7, 0.0] {
            let stop = if engine == "one" { "side = \"lower\"" } else { "row = [1]" };
            let all: Vec<String> = starts.map(start).into();
            let tasks = |(i, start): (usize, &String)| {
                format!("[[tasks]]\nname = \"m{i}\"\nkind = \"simulate\"\nstart = {start}\nperiods = 1\n")
            };
            let text = format!(
                "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"{engine}\"\n[system]\nforce = 0\nstiffness = 0\n\
                 forcing = [{{ sin = -1 }}]\n[[stops]]\n{stop}\noffset = 0\nrestitution = {restitution}\n\
                 [accuracy]\nminimum_depth = {depth:?}\n[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{}]\n\
                 transient = 0\npoints = 2\n{}",
                all.join(", "),
                all.iter().enumerate().map(tasks).collect::<String>()
            );
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("it.toml");
            fs::write(&file, text).unwrap();
            let (code, out, err, files) = grazing(&["run", file.to_str().unwrap()]);
            assert!(code == 0 || code == 3, "{out}{err}");
            for i in 0..starts.len() {
                let events = rows(&read(&files, &format!("m{i}-events.csv")));
                let told: Vec<&str> = events.iter().map(|row| row["event"].as_str()).collect();
                assert!(told.contains(&"stick"), "{engine} {i}: {told:?}");
                let release = events.iter().find(|row| row["event"] == "release").unwrap();
                let phase: f64 = release["phase"].parse().unwrap();
                assert!((phase - 0.5).abs() < 1e-9, "{engine} {i}: {release:?}");
            }
        }
    }
}
