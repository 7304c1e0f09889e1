//! A stop that moves as a record says: by both engines the motion of the same stop with its harmonics, and
//! what is refused.

use std::{f64::consts::TAU, fs, path::Path};

use tempfile::tempdir;

use super::tasks::{near, refused, run, task};

/// A mass beside a cam of two harmonics about 3 mm, at 4 Hz.
fn scene(side: &str, engine: &str, motion: &str) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"a cam\"\nengine = {engine:?}\n[units]\nlength = \"mm\"\nmass = \"kg\"\n\
         time = \"s\"\n[system]\nfrequency = \"4 Hz\"\nmass = 2\nstiffness = \"800 N/m\"\ndamping = \"3 N s/m\"\n\
         [[stops]]\nside = {side:?}\nrestitution = 0.7\n{motion}\n"
    )
}

/// The record over more than two periods, in samples that are not even.
fn record(folder: &Path, sign: f64) {
    let sample = |i: u32| {
        let t = 0.05 + 0.6 * f64::from(i) / 240.0 + 0.0003 * f64::from(i % 7);
        let place = 3.0 + 2.0 * (TAU * 4.0 * t).cos() + 0.5 * (TAU * 8.0 * t).sin();
        format!("{t:e},{i},{:e}\n", sign * place)
    };
    let rows: String = (0..240).map(sample).collect();
    fs::write(folder.join("cam.csv"), format!("time,count,position\n{rows}")).unwrap();
}

#[test]
fn a_measured_stop_is_the_stop_with_its_harmonics() {
    let simulate = [task("run", "simulate", "start = { q = 0, u = 150 }\nperiods = 12")];
    let mut events = 0;
    for (side, sign) in [("upper", 1.0), ("lower", -1.0)] {
        for engine in ["one", "many"] {
            let folder = tempdir().unwrap();
            let folder = folder.path();
            record(folder, sign);
            let known = format!(
                "offset = {}\nharmonics = [{{ k = 1, cos = {} }}, {{ k = 2, sin = {} }}]",
                sign * 4.0,
                sign * 2.0,
                sign * 0.5
            );
            // The mean adds to the offset.
            let measured = format!("offset = {sign}\nmeasured = {{ file = \"cam.csv\", harmonics = 3 }}");
            let all = [known, measured].map(|motion| {
                let (report, code, error) = run(&scene(side, engine, &motion), &simulate, folder);
                assert_eq!(code, 0, "{error}");
                // Forty samples of the third period.
                let warned =
                    report.to_string().contains("samples of cam.csv are beyond its last whole period");
                assert_eq!(warned, motion.contains("measured"), "{report}");
                assert_eq!(report["tasks"][0]["engine"]["name"], engine, "{report}");
                fs::read_to_string(folder.join("run-events.csv")).unwrap()
            });
            let [known, measured] = all.each_ref().map(|text| text.lines().collect::<Vec<_>>());
            assert_eq!(known.len(), measured.len(), "{side} {engine}");
            for (a, b) in known.iter().zip(&measured).skip(1) {
                let [a, b] = [a, b].map(|line| line.split(',').collect::<Vec<_>>());
                for (a, b) in a.iter().zip(&b) {
                    match (a.parse::<f64>(), b.parse::<f64>()) {
                        (Ok(a), Ok(b)) => near(a, b, 1e-9 * (1.0 + a.abs())),
                        _ => assert_eq!(a, b),
                    }
                }
                events += 1;
            }
        }
    }
    assert!(events > 40, "{events}");
}

#[test]
fn what_is_wrong_with_a_measured_stop_is_said() {
    let folder = tempdir().unwrap();
    record(folder.path(), 1.0);
    fs::write(folder.path().join("force.csv"), "time,force\n0,1\n0.1,2\n").unwrap();
    for (motion, said) in [
        (
            "harmonics = [{ cos = 1 }]\nmeasured = { file = \"cam.csv\", harmonics = 3 }",
            ": stands beside `harmonics`: give one of them",
        ),
        (
            "measured = { file = \"force.csv\", harmonics = 1 }",
            "force.csv:1: has no column \"position\": the first line names the columns, as in time,position",
        ),
        ("measured = { file = \"cam.csv\", harmonics = 0 }", "is outside 1 to 100"),
        ("measured = { file = \"cam.csv\" }", "harmonics"),
        (
            "measured = { file = \"cam.csv\", harmonics = 2, period = \"0.31 s\" }",
            "is not the period of the record",
        ),
        ("measured = { file = \"cam.csv\", harmonics = 2, period = \"0.25 kg\" }", "is a mass"),
        ("measured = { file = \"cam.csv\", harmonics = 2, once = true }", "unknown key"),
        (
            "measured = { file = \"cam.csv\", harmonics = 2 }\n[system.measured]\nfile = \"force.csv\"\nonce = true",
            "is periodic, and the force is a record of one run",
        ),
    ] {
        let text = scene("upper", "auto", &format!("offset = 0\n{motion}"));
        let error = refused(&text, &[task("run", "simulate", "start = { q = 0 }")], folder.path());
        assert!(error.contains(said), "{motion}\n  {error}");
    }
    // What stands still is told of as little as what its harmonics say.
    let still: String = (0..50).map(|i| format!("{},0.1\n", 0.01 * f64::from(i))).collect();
    fs::write(folder.path().join("still.csv"), format!("time,position\n{still}")).unwrap();
    let text = scene("upper", "auto", "offset = 1\nmeasured = { file = \"still.csv\", harmonics = 2 }");
    let simulate = [task("run", "simulate", "start = { q = 0, u = 100 }\nperiods = 1")];
    let (report, code, _) = run(&text, &simulate, folder.path());
    assert!(code == 0 && !report.to_string().contains("from a sample"), "{report}");
    // Fewer harmonics than the motion has are told of.
    let text = scene("upper", "auto", "offset = 0\nmeasured = { file = \"cam.csv\", harmonics = 1 }");
    let (report, code, _) =
        run(&text, &[task("run", "simulate", "start = { q = 0 }\nperiods = 1")], folder.path());
    let warned = report.to_string().contains("the stop upper moves as 1 harmonic says, up to 5.0");
    assert!(code == 0 && warned, "{report}");
}
