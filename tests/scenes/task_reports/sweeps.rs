//! Sweeps of a parameter, and what is seen beside a touch: jumps where a motion ends in closed form or where
//! a saddle-node is located by Newton's method, none where a period doubles.

use std::{
    f64::consts::PI,
    path::Path,
    sync::atomic::{AtomicU64, Ordering},
};

use grazing_scenes::{
    Error, Monitor, Result,
    certificate::check,
    run::{CertificateFile, Findings, GrazingFindings, Judgement, Status, Surroundings, TaskReport, run},
    scene::Scene,
};
use serde_json::Value;

use crate::tasks::{ball, near, number};

/// The machine of README: q″ + q′/10 + 3q/10 = F cos t below a stop at 1, in both formats.
const MACHINE: [&str; 2] = [
    r#"format = "grazing-scene 1"
[system]
damping = "1/10"
stiffness = "3/10"
forcing = [{ cos = "F" }]
[[walls]]
side = "upper"
offset = 1
restitution = 0.8
"#,
    r#"format = "grazing-scene 2"
[system]
period = "2*pi"
mass = 1
damping = "1/10"
stiffness = "3/10"
forcing = [{ cos = "F" }]
[[walls]]
name = "stop"
row = [-1]
offset = -1
restitution = 0.8
"#,
];

/// The report of the only task of a scene.
fn report(system: &str, parameters: &str, task: &str, around: Surroundings) -> Value {
    serde_json::to_value(asked(system, parameters, task, around).unwrap()).unwrap()
}

/// The same as it is, or why the scene is refused.
fn asked(system: &str, parameters: &str, task: &str, around: Surroundings) -> Result<TaskReport> {
    let (format, rest) = system.split_once('\n').unwrap();
    let text = format!(
        "{format}\ntitle = \"t\"\n[parameters]\n{parameters}\n{rest}[[tasks]]\nname = \"it\"\n{task}"
    );
    Ok(run(&Scene::from_toml(&text, "scene.toml")?, around, &mut ())?.remove(0))
}

fn machine(format: usize, task: &str) -> Value {
    report(MACHINE[format], "F = 0.5", task, Surroundings::default())
}

/// Where the free motion, of amplitude F/|k − 1 + ic|, touches the stop.
fn touch() -> f64 {
    0.7_f64.hypot(0.1)
}

/// The saddle-node at which the orbit with one impact per period ends, by Newton's method.
fn fold() -> f64 {
    let task = "kind = \"event\"\nevent = \"saddle-node\"\nparameter = \"F\"\nset = { F = 0.6 }\nreach = 3\norbit = { pattern = [1] }";
    let found = machine(0, task);
    let all = found["found"].as_array().unwrap_or_else(|| panic!("{found}"));
    number(&all.iter().find(|event| number(&event["parameter"]) > 0.4).unwrap()["parameter"])
}

fn sweep(way: &str) -> String {
    counted(way, 26)
}

fn counted(way: &str, count: u32) -> String {
    format!(
        "kind = \"diagram\"\nparameter = \"F\"\nrange = [0.4, 0.9]\ncount = {count}\nstarts = [{{ q = 0 }}]\nsweep = \"{way}\"\n\
         points = 20\ntransient = 300"
    )
}

/// Whatever values are looked at, and in either engine: a step as long as a fifth of the range, too.
#[test]
fn the_machine_of_readme_jumps_at_the_touch_and_back_at_the_saddle_node() {
    for (format, count) in [(0, 3), (0, 6), (0, 13), (0, 26), (0, 101), (1, 3), (1, 6), (1, 26)] {
        let found = machine(format, &counted("both", count));
        let jumps = found["sweep"]["jumps"].as_array().unwrap();
        assert_eq!(jumps.len(), 2, "{found}");
        for (jump, (at, ends)) in jumps.iter().zip([(touch(), "grazing"), (fold(), "saddle-node")]) {
            near(number(&jump["stays"]), at, 1e-10);
            near(number(&jump["left"]), at, 1e-10);
            assert_eq!(jump["ends"], ends, "{jump}");
        }
        if count != 26 {
            continue;
        }
        let hysteresis = found["sweep"]["hysteresis"].as_array().unwrap();
        assert_eq!(hysteresis.len(), 1, "{found}");
        near(number(&hysteresis[0]["from"]), 0.54, 1e-12);
        near(number(&hysteresis[0]["to"]), 0.70, 1e-12);
        // It depends on how it is begun where both ways differ, between the values at which it jumps.
        assert_eq!(bands_of(&found), [("free", 0.4, 0.52), ("depends", 0.54, 0.7), ("hits", 0.72, 0.9)]);
    }
}

/// The bands of a diagram.
fn bands_of(found: &Value) -> Vec<(&str, f64, f64)> {
    let rows = found["bands"].as_array().unwrap_or_else(|| panic!("{found}"));
    rows.iter()
        .map(|row| (row["band"].as_str().unwrap(), number(&row["least"]), number(&row["most"])))
        .collect()
}

/// One motion at each value tells nothing of what else there is; of several starts one that is lost leaves
/// its value open.
#[test]
fn a_diagram_tells_bands_where_it_knows_of_several_motions() {
    let one = machine(0, &sweep("up"));
    assert_eq!(one["bands"], Value::Null);
    let starts = |starts: &str| {
        let task = counted("up", 11).replace("sweep = \"up\"\n", "").replace("[{ q = 0 }]", starts);
        machine(0, &task)
    };
    assert_eq!(starts("[{ q = 0 }]")["bands"], Value::Null);
    let several = starts("[{ q = 0 }, { q = -3 }]");
    assert_eq!(bands_of(&several), [("free", 0.4, 0.6), ("depends", 0.65, 0.65), ("hits", 0.7, 0.9)]);
    let behind = starts("[{ q = 0 }, { q = 3 }]");
    assert_eq!(bands_of(&behind), []);
}

/// Through no force at all to the other sign, where everything is half a period later: the one jump from the
/// orbit with impacts, the other back onto it.
#[test]
fn a_sweep_through_zero_jumps_on_both_sides() {
    for count in [4, 7, 20] {
        let task = counted("up", count).replace("[0.4, 0.9]", "[-0.9, 0.9]");
        let found = machine(0, &task);
        let jumps = found["sweep"]["jumps"].as_array().unwrap();
        let places: Vec<f64> = jumps.iter().map(|jump| number(&jump["left"])).collect();
        assert_eq!(places.len(), 2, "{found}");
        near(places[0], -fold(), 1e-10);
        near(places[1], touch(), 1e-10);
    }
}

/// However light the damping, the free motion is left at its touch and nowhere before.
#[test]
fn a_lightly_damped_motion_jumps_at_its_touch() {
    for (damping, count) in [("1/100", 6), ("1/1000", 3), ("1/1000", 26)] {
        let system = MACHINE[0].replace("\"1/10\"", &format!("\"{damping}\""));
        let found = report(&system, "F = 0.5", &counted("up", count), Surroundings::default());
        let jumps = found["sweep"]["jumps"].as_array().unwrap();
        assert_eq!(jumps.len(), 1, "{found}");
        let damping = 1.0 / damping[2..].parse::<f64>().unwrap();
        near(number(&jumps[0]["stays"]), 0.7_f64.hypot(damping), 1e-10);
        assert_eq!(jumps[0]["ends"], "grazing", "{found}");
    }
}

/// One way knows no hysteresis, and sees one of the jumps.
#[test]
fn one_way_has_one_jump() {
    for (way, at) in [("up", touch()), ("down", fold())] {
        let found = machine(0, &sweep(way));
        let jumps = found["sweep"]["jumps"].as_array().unwrap();
        assert_eq!((jumps.len(), &found["sweep"]["hysteresis"]), (1, &Value::Null), "{found}");
        near(number(&jumps[0]["left"]), at, 1e-10);
    }
}

/// A ball on a table: its bounce of one period doubles its period at a known amplitude, and does not jump.
#[test]
fn a_flip_is_no_jump() {
    let system = "format = \"grazing-scene 1\"\n[system]\nforce = -1\n[[walls]]\nside = \"lower\"\noffset = 0\n\
                  harmonics = [{ k = 1, sin = \"a\" }]\nrestitution = 0.6\n";
    let [fold, flip] = ball();
    let (from, to) = (flip - 0.04, flip + 0.04);
    assert!(from > fold);
    // It bounces once a period where the table's speed makes up for what is lost; half a period later it is
    // at the top of its flight, of length 2π.
    let phase = (fold / from).acos();
    let (q, at) = (from * phase.sin() + PI * PI / 2.0, (phase + PI) / (2.0 * PI));
    let task = format!(
        "kind = \"diagram\"\nparameter = \"a\"\nrange = [{from}, {to}]\ncount = 81\nphase = \"1/2\"\n\
         starts = [{{ phase = {at}, q = {q} }}]\nsweep = \"up\"\npoints = 20"
    );
    let found = report(system, &format!("a = {flip}"), &task, Surroundings::default());
    let windows = found["sweep"]["windows"].as_array().unwrap();
    let periods: Vec<_> = windows.iter().map(|row| row["period"].as_u64()).collect();
    assert!(periods.contains(&Some(1)) && periods.contains(&Some(2)), "{found}");
    let last_one = windows.iter().rfind(|row| row["period"] == 1).unwrap();
    near(number(&last_one["to"]), flip, 2e-3);
    assert_eq!(found["sweep"]["jumps"].as_array().unwrap().len(), 0, "{found}");
}

const GRAZING: &str = "kind = \"grazing\"\nparameter = \"F\"\nmax_period = 2";

#[test]
fn the_grazing_of_readme_says_that_it_jumps_and_where_it_returns() {
    for format in [0, 1] {
        let found = machine(format, GRAZING);
        let seen = found["seen"].as_array().unwrap_or_else(|| panic!("{found}"));
        let what: Vec<_> =
            seen.iter().map(|row| (row["place"].as_str().unwrap(), row["what"].as_str().unwrap())).collect();
        let expected = [("before", "stays"), ("beyond", "jumps"), ("back", "leaves"), ("rest", "hits")];
        assert_eq!(what, expected, "{found}");
        assert!(number(&seen[0]["value"]) < touch() && number(&seen[1]["value"]) > touch(), "{found}");
        near(number(&seen[2]["value"]), fold(), 1e-10);
        let (given, absent) = if format == 0 { ("extent", "gap") } else { ("gap", "extent") };
        assert!(seen.iter().all(|row| row[absent].is_null()), "{found}");
        let ends = |row: &Value| [0, 1].map(|i| number(&row[given][i]));
        // Of the oscillator the displacement, of the machine the gap below the stop.
        let (free, struck) = (ends(&seen[0]), ends(&seen[1]));
        if format == 0 {
            near(free[0], -1.0, 1e-3);
            near(free[1], 1.0, 1e-3);
            near(struck[1], 1.0, 1e-9);
            assert!((-7.0..-6.0).contains(&struck[0]), "{found}");
        } else {
            near(free[1], 2.0, 1e-3);
            near(struck[0], 0.0, 1e-9);
            assert!((7.0..8.0).contains(&struck[1]), "{found}");
        }
        assert_eq!((&seen[0]["speed"], seen[1]["speed"].is_null()), (&Value::Null, false));
        // Begun at rest it hits long before the touch: there and just below, by another task.
        let from = number(&seen[3]["value"]);
        let rest = |value: f64| {
            let task = format!(
                "kind = \"section\"\nset = {{ F = \"{value}\" }}\nstarts = [{{ q = 0 }}]\ntransient = 2000\npoints = 1"
            );
            let found = machine(format, &task);
            number(&found["attractors"][0]["impacts"])
        };
        assert_eq!([rest(from), rest(from - 1e-4)], [1.0, 0.0], "{found}");
        assert!(
            (0.55..0.65).contains(&from)
                && found["in_words"].as_str().unwrap().contains("from rest, at q = 0")
        );
    }
}

/// Where the free motion dies without swinging, a kick from the stop dies so, too: the motion stays near, and
/// what it differs by goes with the root of the distance.
#[test]
fn an_overdamped_motion_stays_near() {
    let system = MACHINE[0].replace("\"1/10\"", "2").replace("\"3/10\"", "\"1/2\"");
    let found = report(&system, "F = 1.9", GRAZING, Surroundings::default());
    let seen = found["seen"].as_array().unwrap_or_else(|| panic!("{found}"));
    let what: Vec<_> = seen.iter().map(|row| row["what"].as_str().unwrap()).collect();
    assert_eq!(what, ["stays", "stays", "free"], "{found}");
    assert!(seen[1]["motion"].as_str().unwrap().contains("impact"), "{found}");
}

/// The same seen from the forcing: the mass rests before a stop that moves, and has no width of its own. What
/// it does beyond the touch is measured by how the gap moves, in either format.
#[test]
fn a_mass_at_rest_before_a_moving_stop_stays_near() {
    for format in [0, 1] {
        let moving = [
            "offset = 1\nharmonics = [{ k = 1, cos = \"-F\" }]",
            "offset = -1\nharmonics = [{ k = 1, cos = \"F\" }]",
        ];
        let still = MACHINE[format].replace("forcing = [{ cos = \"F\" }]\n", "");
        let system = still.replace("\"1/10\"", "2").replace("\"3/10\"", "\"1/2\"");
        let system = system.replace(["offset = 1", "offset = -1"][format], moving[format]);
        let found = report(&system, "F = 0.9", GRAZING, Surroundings::default());
        let seen = found["seen"].as_array().unwrap_or_else(|| panic!("{found}"));
        let what: Vec<_> = seen.iter().map(|row| row["what"].as_str().unwrap()).collect();
        assert_eq!(what, ["stays", "stays", "free"], "{found}");
        near(number(&found["parameter"]), 1.0, 1e-9);
        assert!(seen[1]["motion"].as_str().unwrap().contains("impact"), "{found}");
        assert!(!seen[1]["motion"].as_str().unwrap().contains("no impact"), "{found}");
    }
}

/// Weak damping is waited for: a disturbance of the motion without impacts shrinks by e^(−π/500) per period,
/// to a 23rd in 500 of them, and what is seen is its amplitude F/|k − 1 + ic| all the same.
#[test]
fn a_motion_that_settles_slowly_is_waited_for() {
    let system = MACHINE[0].replace("\"1/10\"", "\"1/500\"");
    let found = report(&system, "F = 0.5", GRAZING, Surroundings::default());
    let seen = found["seen"].as_array().unwrap_or_else(|| panic!("{found}"));
    let free: Vec<_> =
        seen.iter().filter(|row| row["motion"].as_str() == Some("period 1, no impact")).collect();
    assert_eq!(free.len(), 2, "{found}");
    for (row, within) in free.iter().zip([1e-9, 1e-3]) {
        let amplitude = number(&row["value"]) / 0.7_f64.hypot(0.002);
        near(number(&row["extent"][0]), -amplitude, within);
        near(number(&row["extent"][1]), amplitude, within);
    }
}

/// Between two stops no motion goes farther than they are: it is by its impacts that it has jumped.
#[test]
fn a_jump_between_two_stops_is_told_by_the_impacts() {
    let mirror = MACHINE[0].to_string() + "[[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 0.8\n";
    let found = report(&mirror, "F = 0.5", GRAZING, Surroundings::default());
    let seen = found["seen"].as_array().unwrap_or_else(|| panic!("{found}"));
    let what: Vec<_> = seen.iter().map(|row| row["what"].as_str().unwrap()).collect();
    assert_eq!(what, ["stays", "jumps", "leaves", "hits"], "{found}");
    // At 1, where the free motion turns with the acceleration 1, an impact that grows with the root of the
    // depth has a speed of some 0.01.
    assert!(number(&seen[1]["speed"]) > 0.5, "{found}");
}

#[test]
fn what_is_seen_is_left_out_where_it_is_not_asked_for() {
    let found = machine(0, &format!("{GRAZING}\nseen = false"));
    assert_eq!((&found["seen"], found["seen_open"].as_str()), (&Value::Null, Some("it is not asked for")));
}

/// Without damping the motion that touches does not attract: what is seen there depends on the start.
#[test]
fn nothing_is_seen_beside_a_motion_that_does_not_attract() {
    let system = MACHINE[0].replace("\"1/10\"", "0");
    let found = report(&system, "F = 0.5", GRAZING, Surroundings::default());
    assert_eq!(found["seen"], Value::Null);
    assert!(found["seen_open"].as_str().unwrap().contains("does not attract"), "{found}");
}

/// Where the free motion has ended, the orbit with one impact per period is what attracts: each proof is
/// taken by the checker, is of that pattern and stable, and its speed is the one of the orbit that Newton's
/// method finds from afar.
#[test]
fn attractors_of_a_sweep_are_proved() {
    for format in [0, 1] {
        let task = "kind = \"diagram\"\nparameter = \"F\"\nrange = [0.75, 0.9]\ncount = 4\nsweep = \"down\"\n\
                    starts = [{ q = 0 }]\npoints = 20\ntransient = 300\nprove = true";
        let report = asked(MACHINE[format], "F = 0.5", task, Surroundings::default()).unwrap();
        assert_eq!(report.status, Status::Done, "{report}");
        let Some(Findings::Diagram(found)) = &report.findings else { panic!("{report}") };
        let proofs = found.proofs.as_ref().unwrap();
        assert_eq!((proofs.rows.len(), proofs.certificates.len(), proofs.others), (4, 4, 0), "{report}");
        for (row, CertificateFile { file, accepted }) in proofs.rows.iter().zip(&proofs.certificates) {
            let text = accepted.text();
            let proof = &row.proved;
            assert_eq!(
                (proof.verdict, proof.stable, proof.certificate.as_ref()),
                ("proved", Some(Judgement::Yes), Some(file))
            );
            check(&mut text.as_bytes()).unwrap();
            assert!(text.contains("stable"), "{text}");
            let task =
                format!("kind = \"orbit\"\nset = {{ F = {:?} }}\norbit = {{ pattern = [1] }}", row.value);
            let orbits = machine(format, &task)["orbits"].clone();
            let speeds: Vec<f64> =
                orbits.as_array().unwrap().iter().map(|orbit| number(&orbit["speeds"][0])).collect();
            let speed: f64 = proof.speeds.as_ref().unwrap()[0].parse().unwrap();
            assert!(speeds.iter().any(|known| (known - speed).abs() < 1e-9), "{speed}: {speeds:?}");
        }
        let values: Vec<f64> = proofs.rows.iter().map(|row| row.value).collect();
        assert_eq!(values, [0.9, 0.85, 0.8, 0.75]);
    }
}

/// Without a sweep, too: both attractors where there are two, each seen from its start.
#[test]
fn attractors_of_a_diagram_are_proved() {
    for format in [0, 1] {
        let task = "kind = \"diagram\"\nparameter = \"F\"\nrange = [0.5, 0.6]\ncount = 2\n\
                    starts = [{ q = 0 }, { q = -6, u = 1 }]\npoints = 20\ntransient = 300\nprove = true";
        let report = asked(MACHINE[format], "F = 0.5", task, Surroundings::default()).unwrap();
        assert_eq!(report.status, Status::Done, "{report}");
        let Some(Findings::Diagram(found)) = &report.findings else { panic!("{report}") };
        let proofs = found.proofs.as_ref().unwrap();
        let told: Vec<_> = proofs
            .rows
            .iter()
            .map(|row| (row.seen.as_str(), row.value, row.proved.pattern.as_deref().unwrap_or_default()))
            .collect();
        let patterns = [("start 1", 0.5, "free 1"), ("start 1", 0.6, "free 1"), ("start 2", 0.6, "1")];
        assert_eq!(told, patterns, "{report}");
        // As many as the diagram has seen, each proved and stable.
        assert_eq!(found.slices.iter().map(|slice| slice.motions.len()).sum::<usize>(), 3, "{report}");
        assert!(proofs.rows.iter().all(|row| row.proved.stable == Some(Judgement::Yes)), "{report}");
        assert_eq!((proofs.certificates.len(), proofs.others), (3, 0), "{report}");
        for text in proofs.certificates.iter().map(|one| one.accepted.text()) {
            check(&mut text.as_bytes()).unwrap();
        }
        let json = serde_json::to_value(&report).unwrap();
        assert_eq!(json["proofs"].as_array().map(Vec::len), Some(3), "{json}");
    }
}

/// A motion without impacts and one with, each with its certificate.
#[test]
fn what_is_seen_beside_a_touch_is_proved() {
    for format in [0, 1] {
        let report =
            asked(MACHINE[format], "F = 0.5", &format!("{GRAZING}\nprove = true"), Surroundings::default())
                .unwrap();
        assert_eq!(report.status, Status::Done, "{report}");
        let Some(Findings::Grazing(found)) = &report.findings else { panic!("{report}") };
        let GrazingFindings::Found(found) = &**found else { panic!("{report}") };
        let proofs = found.proofs.as_ref().unwrap();
        let told: Vec<_> = proofs
            .rows
            .iter()
            .map(|row| (row.seen.as_str(), row.proved.pattern.as_deref().unwrap_or_default()))
            .collect();
        assert_eq!(
            told,
            [("before", "free 1"), ("beyond", "1"), ("back", "free 1"), ("rest", "1")],
            "{report}"
        );
        for (row, one) in proofs.rows.iter().zip(&proofs.certificates) {
            let text = one.accepted.text();
            assert_eq!((row.proved.verdict, row.proved.stable), ("proved", Some(Judgement::Yes)));
            let checked = check(&mut text.as_bytes()).unwrap();
            assert_eq!(checked.kind, ["orbit", "machine-orbit"][format]);
            let free = !["beyond", "rest"].contains(&row.seen.as_str());
            assert_eq!(text.contains("\norbit 0 stable\n"), free, "{text}");
            // Of the motion that touches, (1, 0) at its turn, the multipliers are those of the free flow.
            if let Some(trace) = row.proved.trace.as_ref().filter(|_| free) {
                let omega = (0.3_f64 - 0.05 * 0.05).sqrt();
                let of_the_flow = 2.0 * (-0.1 * PI).exp() * (2.0 * PI * omega).cos();
                near(trace.parse().unwrap(), of_the_flow, 1e-12);
            }
        }
    }
}

/// What cannot be proved is refused before anything runs, at the key.
#[test]
fn proofs_of_what_no_certificate_holds_are_refused() {
    let sweep = sweep("up") + "\nprove = true";
    let cubic = MACHINE[0].replace("stiffness", "cubic = 1\nstiffness");
    let soft = MACHINE[1].replace("restitution = 0.8", "stiffness = 100");
    let blind = format!("{GRAZING}\nseen = false\nprove = true");
    for (system, task, why) in [
        (cubic.as_str(), sweep.as_str(), "cubic must be 0"),
        (&soft, &sweep, "stop stop is another"),
        (MACHINE[0], &blind, "`seen = false` leaves out"),
    ] {
        let error = asked(system, "F = 0.5", task, Surroundings::default()).unwrap_err().to_string();
        assert!(error.contains(why) && error.contains("scene.toml:"), "{error}");
    }
}

/// The paper's oscillator beyond its touch is chaotic: how far a chaotic motion goes in some periods is
/// partly chance, and no jump.
#[test]
fn chance_is_no_jump() {
    let text = include_str!("../../../examples/scenes/nordmark-2001.toml");
    let scene = text.split("[[tasks]]").next().unwrap();
    let task = "kind = \"diagram\"\nparameter = \"mu\"\nrange = [0.001, 0.0037]\ncount = 28\nstarts = [{ q = 1 }]\n\
                sweep = \"up\"\npoints = 64\ntransient = 300";
    let text = format!("{scene}[[tasks]]\nname = \"it\"\n{task}");
    let scene = Scene::from_toml(&text, "scene.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let found = serde_json::to_value(&run(&scene, Surroundings::default(), &mut ()).unwrap()[0]).unwrap();
    let windows = found["sweep"]["windows"].as_array().unwrap();
    assert!(windows.iter().all(|row| row["period"].is_null()), "{found}");
    assert_eq!(found["sweep"]["jumps"].as_array().unwrap().len(), 0, "{found}");
}

/// README's picture has the machine where its formulas put it.
#[test]
fn a_grazing_says_where_it_is_in_the_picture() {
    for format in [0, 1] {
        let found = machine(format, &format!("{GRAZING}\nseen = false"));
        near(number(&found["ratio"]), (0.3 - 0.0025_f64).sqrt(), 1e-9);
        near(number(&found["remains"]), (-0.1 * PI).exp(), 1e-9);
    }
}

/// Ends a run after so many values.
struct Impatient(AtomicU64);

impl Monitor for Impatient {
    fn advance(&self, units: u64) -> Result<()> {
        let left = self.0.load(Ordering::Relaxed);
        if units > left {
            return Err(Error::interrupted("enough"));
        }
        self.0.store(left - units, Ordering::Relaxed);
        Ok(())
    }
}

#[test]
fn a_resumed_sweep_is_the_uninterrupted_one() {
    let folder = tempfile::tempdir().unwrap();
    let with = |folder: Option<&Path>, patience: u64| {
        let monitor = Impatient(AtomicU64::new(patience));
        let around = Surroundings { folder, monitor: &monitor, ..Surroundings::default() };
        report(MACHINE[0], "F = 0.5", &sweep("both"), around)
    };
    let whole = with(None, u64::MAX);
    for patience in [7, 30] {
        assert_eq!(with(Some(folder.path()), patience)["status"], "interrupted");
    }
    let resumed = with(Some(folder.path()), u64::MAX);
    assert_eq!(resumed["status"], "done");
    for key in ["sweep", "not_settled", "values"] {
        assert_eq!(resumed[key], whole[key], "{key}");
    }
}
