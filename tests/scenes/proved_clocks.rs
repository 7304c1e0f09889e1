//! Proofs in every unit of time: a period that is a rational multiple of π has the certificates of 2π, any
//! other the same verdicts and ends.

use std::{collections::BTreeMap, f64::consts::TAU};

use grazing_scenes::{certificate, number::parse_rational};
use num_traits::Signed;
use serde_json::Value;

use crate::{
    samples::{larger, one_in},
    tasks::{run, task},
};

/// q″ + q′/20 + k q = F cos t below a stop at 1, in a time of which a radian takes 1/`rate`.
fn scene(period: &str, rate: &str, damping: &str, stiffness: &str) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"clocks\"\n[parameters]\nF = 0.3\n[system]\n{period}\n\
         {damping}\nstiffness = \"{stiffness}*({rate})^2\"\nforcing = [{{ cos = \"F*({rate})^2\" }}]\n\
         [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = 0.8\n"
    )
}

/// The same with k = 19/30: its touch is at F² = (11/30)² + 1/400.
fn clocked(period: &str, rate: &str) -> String {
    scene(period, rate, &format!("damping = \"({rate})/20\""), "19/30")
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

fn found(scene: &str, radians: f64) -> Found {
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
    let (report, code, error) = run(scene, &tasks, folder.path());
    assert_eq!(code, 0, "{scene}: {error} {report}");
    let mut found = Found::default();
    let number = |x: &Value| x.as_f64().or_else(|| x.as_str().and_then(|x| x.parse().ok()));
    for task in report["tasks"].as_array().unwrap() {
        assert_eq!(task["engine"]["name"], "one", "{scene}: {task}");
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
    let own = found(&clocked("", "1"), 1.0);
    assert!(own.certificates.len() >= 7 && own.numbers.len() >= 12, "{own:?}");
    assert!(
        own.verdicts.iter().all(|verdict| verdict.contains("proved") || verdict.contains("nothing")),
        "{own:?}"
    );
    // All that is computed is the same, to the last bit.
    let rational = [("frequency = \"3/(4*pi)\"", "3/2", 1.5), ("period = \"2*pi/7\"", "7", 7.0)];
    for (period, rate, radians) in rational.into_iter().step_by(one_in(2)) {
        assert_eq!(found(&clocked(period, rate), radians).certificates, own.certificates, "{period}");
    }
    let irrational = [
        ("frequency = 4", "8*pi", 4.0 * TAU),
        ("period = \"1/1000\"", "2000*pi", 1000.0 * TAU),
        ("period = 3", "2*pi/3", TAU / 3.0),
    ];
    for (period, rate, radians) in irrational.into_iter().step_by(one_in(3)) {
        let there = found(&clocked(period, rate), radians);
        assert_eq!(there.verdicts, own.verdicts, "{period}");
        assert_eq!(there.numbers.len(), own.numbers.len(), "{period}: {there:?} for {own:?}");
        for (x, y) in there.numbers.iter().zip(&own.numbers) {
            assert!((x - y).abs() <= 1e-9 * y.abs().max(1e-3), "{period}: {x} for {y}");
        }
    }
}

/// c = 2 ζ √k, exactly where √k is rational.
#[test]
fn a_damping_ratio_is_the_damping_that_it_makes() {
    let of = |period: &str, rate: &str, damping: &str, radians: f64| {
        found(&scene(period, rate, damping, "16/25"), radians)
    };
    let own = of("", "1", "damping = \"1/20\"", 1.0);
    assert_eq!(of("", "1", "damping_ratio = \"1/32\"", 1.0).certificates, own.certificates);
    let there = of("frequency = 4", "8*pi", "damping_ratio = \"1/32\"", 4.0 * TAU);
    assert_eq!(there.verdicts, own.verdicts);
    for (x, y) in there.numbers.iter().zip(&own.numbers) {
        assert!((x - y).abs() <= 1e-9 * y.abs().max(1e-3), "{x} for {y}");
    }
}

/// What is printed of a touch is in the range that begins there, and as near as 17 digits are.
#[test]
fn a_touch_is_rounded_into_its_range() {
    let rational = |text: &str| parse_rational(text).unwrap();
    let square = rational("11/30") * rational("11/30") + rational("1/400");
    for (period, rate) in [("", "1"), ("frequency = 4", "8*pi")] {
        let folder = tempfile::tempdir().unwrap();
        let tasks = [task("grazing", "grazing", "parameter = \"F\"\nseen = false\nrange = true")];
        let (report, ..) = run(&clocked(period, rate), &tasks, folder.path());
        let mut sides = BTreeMap::new();
        for row in report["tasks"][0]["range"].as_array().unwrap() {
            let (side, touch) = (row["side"].as_str().unwrap(), rational(row["touch"].as_str().unwrap()));
            let off = &touch * &touch / &square - rational("1");
            assert_eq!(off.is_negative(), side == "before", "{period}: {row}");
            assert!(off.abs() < rational("1e-15"), "{period}: {row}");
            sides.insert(side.to_string(), touch);
        }
        assert_eq!(sides.len(), 2);
    }
}

/// Chaos that attracts over the drive's own frequency: the period, and all in it, changes with the parameter.
#[test]
fn a_frequency_in_hertz_has_its_range() {
    if !larger("the range of a frequency in hertz, a proof of many machines") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let scene = "format = \"grazing-scene 3\"\ntitle = \"hertz\"\n[parameters]\nf = \"40 Hz\"\n[system]\n\
                 frequency = \"f\"\nmass = \"2 kg\"\ndamping = \"120 N s/m\"\nstiffness = \"0.8 N/mm\"\n\
                 forcing = [{ cos = \"130 N\" }]\n[[stops]]\nside = \"upper\"\noffset = \"1 mm\"\n\
                 restitution = \"80 %\"\n";
    let tasks = [task("grazing", "grazing", "parameter = \"f\"\nseen = false\nattractor = true")];
    let (report, code, error) = run(scene, &tasks, folder.path());
    assert_eq!(code, 0, "{error}");
    let row = &report["tasks"][0]["range"][0];
    assert_eq!((&row["verdict"], &row["case"]), (&"proved".into(), &"chaos".into()), "{row}");
    assert_eq!(row["left"], Value::Null);
    // The amplitude over the gap is 1 at the touch, and no greater than the depth says at the end.
    let number = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    let amplitude = |f: f64| 130.0 / (800.0 - 2.0 * (TAU * f).powi(2)).hypot(120.0 * TAU * f) / 1e-3;
    let (touch, end) = (number(&row["touch"]), number(&row["end"]));
    assert!((amplitude(touch) - 1.0).abs() < 1e-14 && end < touch, "{row}");
    let depth = parse_rational(row["depth"].as_str().unwrap()).unwrap();
    let inside = depth - parse_rational(&format!("{}", 1.0 - 1.0 / amplitude(end))).unwrap();
    assert!(inside > parse_rational("-1e-14").unwrap() && inside < parse_rational("1e-3").unwrap(), "{row}");
    for cell in row["cells"].as_array().unwrap() {
        let text =
            std::fs::read_to_string(folder.path().join(cell["certificate"].as_str().unwrap())).unwrap();
        assert!(text.contains("\nparameter f\n"), "{text}");
        certificate::check(&mut text.as_bytes()).unwrap();
    }
}
