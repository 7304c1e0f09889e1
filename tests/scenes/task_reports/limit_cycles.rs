//! Limit cycles of what nothing drives: their periods and multipliers against closed forms, in both engines.

use std::f64::consts::PI;

use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};
use serde_json::Value;

fn reports(format: u32, scene: &str) -> Vec<Value> {
    let text = format!("format = \"grazing-scene {format}\"\ntitle = \"t\"\n{scene}");
    let scene = Scene::from_toml(&text, "scene.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    reports.iter().map(|report| serde_json::to_value(report).unwrap()).collect()
}

fn assert_near(found: &Value, expected: f64, tolerance: f64) {
    let off = (found.as_f64().unwrap_or(f64::NAN) - expected).abs();
    assert!(off <= tolerance, "{found} is not {expected}: off by {off:e}");
}

/// The period and the only multiplier beside 1 of the limit cycle of one coordinate.
fn assert_cycle(report: &Value, [period, multiplier, tolerance]: [f64; 3]) {
    let row = &report["orbits"][0];
    assert_near(&row["period"], period, tolerance);
    let all = row["multipliers"].as_array().unwrap_or_else(|| panic!("{report}"));
    assert_eq!((all.len(), &row["stable"]), (1, &Value::from(true)), "{row}");
    assert_near(&all[0][0], multiplier, 10.0 * tolerance);
}

const TASK: &str = r#"
[[tasks]]
name = "cycle"
kind = "orbit"
cycle = { q = 0.1, u = 0.2 }
transient = 30
"#;

/// x″ + 2ζx′ + x = F sign x′: half a cycle is a half turn about F, of a known time and decay. Whatever the
/// unit of time is called a period.
#[test]
fn a_thrust_along_the_velocity_has_a_cycle_in_closed_form() {
    let (zeta, half) = (0.1f64, PI / (1.0f64 - 0.01).sqrt());
    for unit in ["\"2*pi\"", "1", "17"] {
        let system = format!(
            "[system]\nperiod = {unit}\nmass = 1\ndamping = 0.2\nstiffness = 1\nforce = \"0.3*sign(u)\"\n"
        );
        let report = reports(2, &format!("{system}{}", TASK.replace("= 30", "= 100"))).remove(0);
        assert_cycle(&report, [2.0 * half, (-2.0 * zeta * half).exp(), 1e-10]);
    }
}

/// Of x″ − 2ax′ + x = 0 with a wall at −1, x(t) is a formula, and so are the time t back to the wall and the
/// speed: bisected here.
fn bouncing(a: f64, restitution: f64) -> [f64; 2] {
    let w = (1.0 - a * a).sqrt();
    let motion = |v: f64, t: f64| {
        let (sin, cos) = (w * t).sin_cos();
        let b = (v + a) / w;
        let (x, grow) = (-cos + b * sin, (a * t).exp());
        [grow * x, grow * (a * x + w * (sin + b * cos))]
    };
    let bisect = |mut low: f64, mut high: f64, is_low: &dyn Fn(f64) -> bool| {
        for _ in 0..200 {
            let middle = (low + high) / 2.0;
            if is_low(middle) { low = middle } else { high = middle }
        }
        low
    };
    let back = |v: f64| bisect(PI / 2.0 / w, 1.9 * PI / w, &|t| motion(v, t)[0] > -1.0);
    let speed = |v: f64| -motion(v, back(v))[1];
    let v = bisect(0.01, 10.0, &|v| restitution * speed(v) > v);
    let h = 1e-4;
    [back(v), restitution * (speed(v + h) - speed(v - h)) / (2.0 * h)]
}

#[test]
fn an_oscillator_with_negative_damping_bounces_off_a_wall() {
    let [period, multiplier] = bouncing(0.1, 0.4);
    let one = format!(
        "[system]\ndamping = -0.2\nstiffness = 1\n[[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 0.4\n{TASK}"
    );
    let many = one
        .replace("[system]", "[system]\nperiod = \"2*pi\"\nmass = 1")
        .replace("side = \"lower\"", "name = \"lower\"\nrow = [1]");
    for (format, scene) in [(1, one), (2, many)] {
        let report = reports(format, &scene).remove(0);
        assert_cycle(&report, [period, multiplier, 1e-8]);
        assert_near(&report["orbits"][0]["period"], period, 1e-11);
        assert_eq!(report["orbits"][0]["impacts"], 1, "{report}");
    }
}

/// Its period is in many papers, to more digits than here.
#[test]
fn van_der_pol_goes_round_in_its_known_period() {
    let one = format!("[system]\ndamping = 0\nstiffness = 1\nforce = \"(1 - q^2)*u\"\n{TASK}");
    let many = one.replace("[system]", "[system]\nperiod = \"2*pi\"\nmass = 1");
    let periods: Vec<f64> = [(1, one), (2, many)]
        .iter()
        .map(|(format, scene)| {
            let report = reports(*format, scene).remove(0);
            report["orbits"][0]["period"].as_f64().unwrap_or_else(|| panic!("{report}"))
        })
        .collect();
    assert!(periods.iter().all(|period| (period - 6.663_286_859_323).abs() < 1e-11), "{periods:?}");
}

/// What is driven, what comes to rest and what comes nearer to it have none, and each is told why.
#[test]
fn where_there_is_no_limit_cycle_it_is_said_why() {
    let scene = |forcing: &str, damping: &str| {
        let system = format!("[system]\nperiod = \"2*pi\"\nmass = 1\ndamping = {damping}\nstiffness = 1\n");
        reports(2, &format!("{system}{forcing}{TASK}")).remove(0)
    };
    for (forcing, damping, why) in [
        ("forcing = [{ cos = 1 }]\n", "0.1", "a drive moves the system"),
        ("", "20", "comes not back"),
        ("", "0.9", "is at rest"),
        ("", "0.02", "Newton's method found no limit cycle"),
    ] {
        let report = scene(forcing, damping);
        let reason = report["missing"][0]["reason"].as_str().unwrap_or_else(|| panic!("{report}"));
        assert!(reason.contains(why), "{reason}");
    }
}

/// What would be dropped in silence is refused.
#[test]
fn a_cycle_has_no_other_orbit_beside_it_and_its_transient_belongs_to_it() {
    for (keys, wrong) in [
        ("cycle = { q = 1 }\norbit = { period = 2 }", "beside `cycle` nothing else is looked for"),
        ("cycle = { q = 1 }\norbit = { start = [0, 1] }", "beside `cycle` nothing else is looked for"),
        ("orbit = { period = 2 }\ntransient = 7", "is of a limit cycle: give `cycle` with it"),
    ] {
        let system = "[system]\nperiod = 1\nmass = 1\nstiffness = 1\n";
        let head = "format = \"grazing-scene 3\"\ntitle = \"t\"\n";
        let text = format!("{head}{system}[[tasks]]\nname = \"o\"\nkind = \"orbit\"\n{keys}\n");
        let error = Scene::from_toml(&text, "s.toml").unwrap_err().to_string();
        assert!(error.starts_with("s.toml:") && error.contains(wrong), "{error}");
    }
}

/// The woodpecker toy of Glocker (1995): it falls along its pole in a rhythm of its own, with rests, friction
/// under stops and several impacts. Another program's time stepping (Moreau's, steps of 1e-5) has a beak hit
/// every 0.14600 s and 0.0195 m.
#[test]
fn a_woodpecker_falls_in_its_rhythm() {
    let scene = r#"
[system]
period = 0.145
mass = [["0.0045 + 0.0003", "0.0045*0.010", "0.0045*0.015"], ["0.0045*0.010", "5e-9 + 0.0045*0.010^2", "0.0045*0.010*0.015"], ["0.0045*0.015", "0.0045*0.010*0.015", "7e-7 + 0.0045*0.015^2"]]
damping = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]
stiffness = [[0, 0, 0], [0, 0.0056, -0.0056], [0, -0.0056, 0.0056]]
force = ["-0.0048*9.81", "-0.0045*9.81*0.010", "-0.0045*9.81*0.015"]
[[stops]]
name = "beak"
row = [0, 0, -0.02]
offset = "-(0.010 + 0.015 - 0.0201 - 0.0025)"
restitution = 0.5
[[stops]]
name = "lower"
row = [0, 0.0058, 0]
offset = "-(0.0031 - 0.0025)"
restitution = 0
[[stops]]
name = "upper"
row = [0, -0.0058, 0]
offset = "-(0.0031 - 0.0025)"
restitution = 0
[[friction]]
name = "beak slides"
row = [1, 0.010, "0.015 - 0.0201"]
stop = "beak"
coefficient = 0.3
[[friction]]
name = "lower slides"
row = [1, 0.0031, 0]
stop = "lower"
coefficient = 0.3
[[friction]]
name = "upper slides"
row = [1, 0.0031, 0]
stop = "upper"
coefficient = 0.3
[[tasks]]
name = "cycle"
kind = "orbit"
cycle = { q = [0, -0.1034, -0.2788], u = [-0.3411, 0, -7.4583] }
transient = 30
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = [0, -0.1034, -0.2788], u = [-0.3411, 0, -7.4583] }]
transient = 0
points = 1
longest = 1
"#;
    let all = reports(3, scene);
    let row = &all[0]["orbits"][0];
    assert_near(&row["period"], 0.146, 5e-5);
    assert_near(&row["drift"][0], -0.0195, 1e-4);
    assert_eq!((row["multipliers"].as_array().map(Vec::len), &row["stable"]), (Some(4), &Value::from(true)));
    let warnings = all[1]["warnings"].to_string();
    assert!(warnings.contains("nothing drives the motion"), "{}", all[1]);
}
