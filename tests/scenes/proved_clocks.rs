//! Proofs in every unit of time: a period that is a rational multiple of π has the certificates of 2π, any
//! other the same verdicts and ends.

use std::{collections::BTreeMap, f64::consts::TAU};

use grazing_scenes::certificate;
use serde_json::Value;

use crate::tasks::{run, task};

/// q″ + q′/20 + 19/30 q = F cos t below a stop at 1, in a time of which a radian takes 1/`rate`.
fn scene(period: &str, rate: &str) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"clocks\"\n[parameters]\nF = 0.3\n[system]\n{period}\n\
         damping = \"({rate})/20\"\nstiffness = \"19/30*({rate})^2\"\nforcing = [{{ cos = \"F*({rate})^2\" }}]\n\
         [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = 0.8\n"
    )
}

/// What is proved.
#[derive(Debug, Default)]
struct Found {
    verdicts: Vec<String>,
    /// Phases, parameters of events and ends of ranges; speeds per radian.
    numbers: Vec<f64>,
    /// By the names of their files.
    certificates: BTreeMap<String, String>,
}

fn found(period: &str, rate: &str, radians: f64) -> Found {
    let tasks = [
        task("orbit", "validate", "orbit = { pattern = [1] }"),
        task("touch", "validate", "orbit = { pattern = [] }\nevent = \"grazing\"\nparameter = \"F\""),
        task("over", "validate", "orbit = { pattern = [1] }\nparameter = \"F\"\nfrom = 0.29\nto = 0.31"),
        task("grazing", "grazing", "parameter = \"F\"\nseen = false\nrange = true"),
        task(
            "seen",
            "diagram",
            "parameter = \"F\"\nrange = [0.2, 0.3]\ncount = 2\nstarts = [{ q = 0 }]\nprove = true",
        ),
    ];
    let folder = tempfile::tempdir().unwrap();
    let (report, code, error) = run(&scene(period, rate), &tasks, folder.path());
    assert_eq!(code, 0, "{period}: {error} {report}");
    let mut found = Found::default();
    let number = |x: &Value| x.as_f64().or_else(|| x.as_str().and_then(|x| x.parse().ok()));
    for task in report["tasks"].as_array().unwrap() {
        assert_eq!(task["engine"]["name"], "one", "{period}: {task}");
        let rows = ["proofs", "range"].iter().filter_map(|key| task[*key].as_array()).flatten();
        for row in rows {
            found.verdicts.push(format!("{} {} {}", task["task"], row["verdict"], row["stable"]));
            let ends = ["parameter", "lower", "upper", "touch", "end"];
            found.numbers.extend(ends.iter().filter_map(|name| number(&row[*name])));
            found.numbers.extend(row["phases"].as_array().into_iter().flatten().filter_map(number));
            let speeds = row["speeds"].as_array().into_iter().flatten().filter_map(number);
            found.numbers.extend(speeds.map(|speed| speed / radians));
            let Some(name) = row["certificate"].as_str() else { continue };
            let text = std::fs::read_to_string(folder.path().join(name)).unwrap();
            certificate::check(&mut text.as_bytes()).unwrap();
            found.certificates.insert(name.into(), text);
        }
    }
    found
}

#[test]
fn what_is_proved_is_so_in_every_unit_of_time() {
    let own = found("", "1", 1.0);
    assert!(own.certificates.len() >= 7 && own.numbers.len() >= 12, "{own:?}");
    assert!(
        own.verdicts.iter().all(|verdict| verdict.contains("proved") || verdict.contains("nothing")),
        "{own:?}"
    );
    // All that is computed is the same, to the last bit.
    for (period, rate) in [("period = \"2*pi/7\"", "7"), ("frequency = \"3/(4*pi)\"", "3/2")] {
        assert_eq!(
            found(period, rate, rate.parse().unwrap_or(1.5)).certificates,
            own.certificates,
            "{period}"
        );
    }
    for (period, rate, radians) in [
        ("frequency = 4", "8*pi", 4.0 * TAU),
        ("period = \"1/1000\"", "2000*pi", 1000.0 * TAU),
        ("period = 3", "2*pi/3", TAU / 3.0),
    ] {
        let there = found(period, rate, radians);
        assert_eq!(there.verdicts, own.verdicts, "{period}");
        assert_eq!(there.numbers.len(), own.numbers.len(), "{period}: {there:?} for {own:?}");
        for (x, y) in there.numbers.iter().zip(&own.numbers) {
            assert!((x - y).abs() <= 1e-9 * y.abs().max(1e-3), "{period}: {x} for {y}");
        }
    }
}
