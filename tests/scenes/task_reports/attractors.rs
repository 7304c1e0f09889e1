//! One detector of attractors: for oscillators and machines, sections, basins, diagrams and branches,
//! whatever the unit of length, and wherever stops are that no motion meets.

use std::f64::consts::PI;

use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};
use serde_json::Value;

use crate::samples::one_in;

/// The reports of a scene's tasks.
fn reports(format: u32, scene: &str) -> Vec<Value> {
    let text = format!("format = \"grazing-scene {format}\"\ntitle = \"t\"\n{scene}");
    let scene = Scene::from_toml(&text, "scene.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    reports.iter().map(|report| serde_json::to_value(report).unwrap()).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn assert_near(found: &Value, expected: f64, tolerance: f64) {
    let off = (number(found) - expected).abs();
    assert!(off <= tolerance * expected.abs().max(1e-300), "{found} is not {expected}: off by {off:e}");
}

/// A damped linear oscillator without a wall: as an oscillator and as a machine.
fn linear(damping: &str, stiffness: &str, tasks: &str) -> [Vec<Value>; 2] {
    let one =
        format!("[system]\ndamping = {damping}\nstiffness = {stiffness}\nforcing = [{{ cos = 1 }}]\n{tasks}");
    let other = one.replace("[system]", "[system]\nperiod = \"2*pi\"\nmass = 1");
    [reports(1, &one), reports(2, &other)]
}

const EVERYTHING: &str = r#"
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = 0 }, { q = 3, u = 1 }]
[[tasks]]
name = "basins"
kind = "basins"
q = { from = -2, to = 2, count = 5 }
u = { from = -2, to = 2, count = 5 }
[[tasks]]
name = "diagram"
kind = "diagram"
parameter = "F"
range = [1, 2]
count = 3
starts = [{ q = 0 }, { q = 1 }]
points = 100
"#;

/// One motion of period 1 attracts all, however slowly; its exponent is half of the damping.
#[test]
fn a_damped_linear_oscillator_has_one_motion_of_period_one() {
    let cases = [
        ("0.005", "\"4/9\""),
        ("0.004", "\"1/4\""),
        ("0.006", "\"9/16\""),
        ("0.003", "\"4/25\""),
        ("0.0071", "\"2.3717\""),
        ("0.012", "\"1/16 + 0.0001\""),
        ("0.3", "\"1e-2\""),
    ];
    for (damping, stiffness) in cases {
        let tasks = format!("[parameters]\nF = 1\n{EVERYTHING}");
        let (parameters, tasks) = tasks.split_at("[parameters]\nF = 1\n".len());
        let system = format!(
            "[system]\ndamping = {damping}\nstiffness = {stiffness}\nforcing = [{{ cos = \"F\" }}]\n"
        );
        let machine = system.replace("[system]", "[system]\nperiod = \"2*pi\"\nmass = 1");
        for (format, system) in [(1, system), (2, machine)] {
            let all = reports(format, &format!("{parameters}{system}{tasks}"));
            let case = format!("{damping} {stiffness} {format}");
            for task in &all {
                assert_eq!(task["status"], "done", "{case}: {task}");
            }
            let attractors = all[0]["attractors"].as_array().unwrap();
            assert_eq!(attractors.len(), 1, "{case}: {attractors:?}");
            assert_eq!(
                (&attractors[0]["period"], &attractors[0]["starts"]),
                (&1.into(), &2.into()),
                "{case}"
            );
            let rate = -std::f64::consts::PI * damping.parse::<f64>().unwrap();
            if damping != "0.3" {
                assert_near(&attractors[0]["lyapunov_per_period"], rate, 1e-9);
            }
            assert!(attractors[0]["standard_error"].is_null());
            let basins = all[1]["basins"].as_array().unwrap();
            assert_eq!(
                (basins.len(), &basins[0]["period"], &basins[0]["starts"]),
                (1, &1.into(), &25.into()),
                "{case}"
            );
            let windows = all[2]["windows"].as_array().unwrap();
            assert_eq!(
                (windows.len(), &windows[0]["period"], &windows[0]["values"]),
                (1, &1.into(), &3.into()),
                "{case}"
            );
            assert!(all[2]["coexisting"].as_array().unwrap().is_empty(), "{case}");
        }
    }
}

/// Nothing damps what resonates: it grows, for ever, and that it is not settled is said.
#[test]
fn what_is_not_settled_is_said() {
    for all in linear(
        "0",
        "\"1 + 0*e\"",
        &EVERYTHING
            .replace("\"F\"\nrange = [1, 2]", "\"e\"\nrange = [0, 1]")
            .replace("[[tasks]]\nname = \"section\"", "[parameters]\ne = 0\n[[tasks]]\nname = \"section\""),
    ) {
        for task in &all {
            assert_eq!(task["status"], "undecided", "{task}");
            assert!(task["reason"].as_str().unwrap().contains("not settled"), "{task}");
        }
        assert!(all[0]["attractors"][0]["periodic"].is_null(), "{}", all[0]);
        assert_eq!(all[1]["basins"][0]["end"], "not-settled", "{}", all[1]);
        assert_eq!(all[2]["not_settled"].as_array().unwrap().len(), 3, "{}", all[2]);
    }
    // An undamped one never settles on anything.
    for all in linear("0", "\"4.3\"", "[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{ q = 1 }]\n") {
        assert_eq!(
            (&all[0]["status"], &all[0]["attractors"][0]["periodic"]),
            (&"done".into(), &false.into())
        );
    }
}

/// λ = −0.98702: one attractor of period 1, q = 0.426311230208 every period. The numbers are of another
/// program, in 30 digits.
#[test]
fn beside_a_flip_an_orbit_has_its_least_period() {
    let scene = |unit: f64| {
        let [force, f, cos, sin, third, wall, a, b, c] =
            [0.09, 0.86, 0.25, -0.28, -0.01, -0.28, 0.5, -1.0, 0.125].map(|x| format!("{:e}", x * unit));
        format!(
            "[system]\ndamping = 0.19\nstiffness = 4.48\nforce = {force}\n\
             forcing = [{{ k = 1, cos = {f} }}, {{ k = 2, cos = {cos}, sin = {sin} }}, {{ k = 3, sin = {third} }}]\n\
             [[walls]]\nside = \"lower\"\noffset = {wall}\nrestitution = 0.92\n\
             [[tasks]]\nname = \"s\"\nkind = \"section\"\nexponents = 2\nstarts = [{{ q = {a}, u = {b} }}, {{ q = {c} }}]\n\
             [[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = {{ from = {c}, to = {a}, count = 4 }}\nu = {{ from = {b}, to = {a}, count = 4 }}\n"
        )
    };
    let all = reports(1, &scene(1.0));
    let attractors = all[0]["attractors"].as_array().unwrap();
    assert_eq!(
        (attractors.len(), &attractors[0]["period"], &attractors[0]["impacts"]),
        (1, &1.into(), &1.into())
    );
    assert_near(&attractors[0]["lyapunov_per_period"], 0.987_016_340_490f64.ln(), 1e-9);
    // The product of the multipliers is that of the impact's and of the damping's.
    let sum: f64 = all[0]["exponents"].as_array().unwrap().iter().map(|row| number(&row["per_period"])).sum();
    let known = 2.0 * 0.92f64.ln() - 2.0 * std::f64::consts::PI * 0.19;
    assert!((sum - known).abs() < 1e-10, "{sum} {known}");
    // One start leads to an orbit of period 9 with 15 impacts.
    let basins = all[1]["basins"].as_array().unwrap();
    let periods: Vec<u64> = basins.iter().map(|row| row["period"].as_u64().unwrap()).collect();
    assert_eq!(periods, [1, 9], "{basins:?}");
    assert_near(&basins[0]["q"], 0.426_311_230_208, 1e-11);
}

/// Section 4's orbit of period 3 with λ = −0.959: not of period 6.
#[test]
fn an_orbit_of_period_three_is_not_of_period_six() {
    let scene = r#"
[parameters]
d = 0.6
w = 4.9
tau = 0.724137931034483
mu = 0.00461538461538462
[system]
damping = "2*d/w"
stiffness = "1/w^2"
[[walls]]
side = "lower"
offset = -1
harmonics = [{ k = 1, cos = "1 + mu" }]
restitution = "tau"
[[tasks]]
name = "s"
kind = "section"
starts = [{ phase = "1/2", q = 2.6 }]
[[tasks]]
name = "o"
kind = "orbit"
orbit = { pattern = [3] }
"#;
    let all = reports(1, scene);
    let attractor = &all[0]["attractors"][0];
    assert_eq!((&attractor["period"], &attractor["impacts"]), (&3.into(), &1.into()), "{attractor}");
    // The orbit's multipliers, from its impacts.
    let orbits = all[1]["orbits"].as_array().unwrap();
    let exponent = |orbit: &Value| {
        number(&orbit["multipliers"][0][0]).hypot(number(&orbit["multipliers"][0][1])).ln() / 3.0
    };
    let stable = orbits.iter().find(|orbit| orbit["stable"] == true && orbit["admissible"] == true).unwrap();
    assert_near(&attractor["lyapunov_per_period"], exponent(stable), 1e-8);
}

const TWO_WELLS: &str = r#"
[parameters]
F = 0.1
[system]
period = "2*pi"
mass = 1
damping = 0.25
stiffness = -1
force = "-q^3"
forcing = [{ cos = "F" }]
"#;

/// Where a stop is that no motion meets changes no digit; the attractors are those of two wells.
#[test]
fn a_stop_that_is_never_met_changes_nothing() {
    let tasks = r#"
[[tasks]]
name = "section"
kind = "section"
starts = [{ q = 1 }, { q = -1 }]
points = 100
[[tasks]]
name = "basins"
kind = "basins"
q = { from = -1, to = 1, count = 4 }
u = { from = -1, to = 1, count = 4 }
[[tasks]]
name = "diagram"
kind = "diagram"
parameter = "F"
range = [0.1, 0.35]
count = 3
starts = [{ q = 1 }, { q = -1 }]
points = 100
"#;
    let stop = |place: f64| {
        format!("[[walls]]\nname = \"guard\"\nrow = [1]\noffset = {place:e}\nrestitution = 0.5\n")
    };
    let bare = |mut all: Vec<Value>| {
        for task in &mut all {
            let task = task.as_object_mut().unwrap();
            task.retain(|key, _| !["effects", "warnings", "place"].contains(&key.as_str()));
        }
        all
    };
    let free = bare(reports(2, &format!("{TWO_WELLS}{tasks}")));
    assert_eq!(free[0]["attractors"].as_array().unwrap().len(), 2, "{}", free[0]);
    let places: Vec<f64> =
        free[1]["basins"].as_array().unwrap().iter().map(|row| number(&row["q"])).collect();
    assert!(
        places.len() == 2 && (places[0] + 0.903_801_8).abs() < 1e-7 && (places[1] - 1.094_925_4).abs() < 1e-7,
        "{places:?}"
    );
    for place in [-2e4, -30.0, -2e8].into_iter().step_by(one_in(3)) {
        assert_eq!(bare(reports(2, &format!("{TWO_WELLS}{}{tasks}", stop(place)))), free, "{place}");
    }
}

/// Two stops, one far away: born orbits and branches are those of the near one alone.
#[test]
fn a_farther_stop_changes_no_branch_and_no_born_orbit() {
    let scene = |far: &str| {
        format!(
            "[parameters]\nF = 1\n[system]\nperiod = \"2*pi\"\nmass = 1\ndamping = 0.4\nstiffness = 3\n\
             forcing = [{{ cos = \"F\" }}]\n[[walls]]\nname = \"near\"\nrow = [1]\noffset = -0.3\nrestitution = 0.5\n{far}\
             [[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"F\"\nset = {{ F = 0.6 }}\n\
             [[tasks]]\nname = \"b\"\nkind = \"branch\"\nparameter = \"F\"\nrange = [0.8, 1.2]\nstarts = [{{ attractor = {{ q = 0 }} }}]\n"
        )
    };
    let near = reports(2, &scene(""));
    let far =
        reports(2, &scene("[[walls]]\nname = \"far\"\nrow = [-1]\noffset = -20000\nrestitution = 0.5\n"));
    assert_eq!((&near[0]["status"], &near[1]["status"]), (&far[0]["status"], &far[1]["status"]), "{near:?}");
    // The patterns of a machine with several stops name them.
    let named = |text: &str| text.replace(" near", "");
    for key in ["found_at", "phases", "speeds", "multipliers"] {
        let of = |all: &[Value]| -> Vec<Value> {
            all[0]["born"].as_array().unwrap().iter().map(|row| row[key].clone()).collect()
        };
        assert_eq!(of(&near), of(&far), "{key}");
    }
    assert!(!near[0]["born"].as_array().unwrap().is_empty());
    assert_eq!(near[1]["points"], far[1]["points"]);
    assert_eq!(named(&near[1]["starts"].to_string()), named(&far[1]["starts"].to_string()));
}

/// Lengths in another unit, a power of two: every number with a length is that many times as large, to the
/// bit, and nothing else changes.
#[test]
fn another_unit_of_length_changes_no_bit() {
    let scene = |format: u32, unit: f64| {
        let [f, wall, low, high] = [1.1, -0.4, -0.3, 1.7].map(|x| format!("{:e}", x * unit));
        let (system, wall_keys) = match format {
            1 => ("", "side = \"lower\""),
            _ => ("period = \"2*pi\"\nmass = 1\n", "row = [1]"),
        };
        format!(
            "[system]\n{system}damping = 0.11\nstiffness = 0.7\nforcing = [{{ cos = {f} }}]\n\
             [[walls]]\n{wall_keys}\noffset = {wall}\nrestitution = 0.8\n\
             [[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{{ q = {high} }}, {{ q = {low} }}]\n\
             [[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = {{ from = {low}, to = {high}, count = 5 }}\nu = {{ from = {low}, to = {high}, count = 3 }}\n"
        )
    };
    for format in [1, 2] {
        let one = reports(format, &scene(format, 1.0));
        assert_eq!((&one[0]["status"], &one[1]["status"]), (&"done".into(), &"done".into()), "{one:?}");
        // What is contact without impact is 10⁻¹² in an oscillator's scene.
        for power in if format == 1 { [-3, 3] } else { [-30, 30] } {
            let unit = 2f64.powi(power);
            let other = reports(format, &scene(format, unit));
            assert_eq!(one[0]["attractors"], other[0]["attractors"], "{format} {power}");
            let rows = |all: &[Value]| all[1]["basins"].as_array().unwrap().clone();
            assert_eq!(rows(&one).len(), rows(&other).len());
            for (a, b) in rows(&one).iter().zip(rows(&other)) {
                assert_eq!(
                    (&a["end"], &a["period"], &a["impacts"], &a["starts"]),
                    (&b["end"], &b["period"], &b["impacts"], &b["starts"])
                );
                if a["end"] == "periodic" {
                    for key in ["q", "u"] {
                        assert_eq!(
                            (number(&a[key]) * unit).to_bits(),
                            number(&b[key]).to_bits(),
                            "{format} {power} {key}"
                        );
                    }
                }
            }
        }
    }
}

/// Lightly damped, an elastic stop: the attractor on which a branch starts is the same orbit, gone round
/// once, as an oscillator and as a machine.
#[test]
fn a_branch_starts_on_the_orbit_gone_round_once() {
    let tasks = "[[tasks]]\nname = \"b\"\nkind = \"branch\"\nparameter = \"F\"\nrange = [0.99, 1.01]\n";
    let oscillator = format!(
        "[parameters]\nF = 1\n[system]\ndamping = 0.0006\nstiffness = 4.3\nforcing = [{{ cos = \"F\" }}]\n\
         [[walls]]\nside = \"lower\"\noffset = -0.05\nrestitution = 1\n{tasks}starts = [{{ attractor = {{ q = 1, u = 0 }} }}]\n"
    );
    let machine = oscillator
        .replace("[system]", "[system]\nperiod = \"2*pi\"\nmass = 1")
        .replace("side = \"lower\"", "row = [1]");
    for (format, scene) in [(1, oscillator), (2, machine)] {
        let all = reports(format, &scene);
        assert_eq!(
            (&all[0]["status"], &all[0]["starts"][0]["pattern"]),
            (&"done".into(), &"0,0,0,1".into()),
            "{}",
            all[0]
        );
    }
}

/// A stop given twice is met once.
#[test]
fn a_stop_that_is_there_twice_is_hit_once() {
    let scene = |stops: usize| {
        let walls: String = (0..stops)
            .map(|i| format!("[[walls]]\nname = \"s{i}\"\nrow = [1]\noffset = -0.2\nrestitution = 0.6\n"))
            .collect();
        format!(
            "[system]\nperiod = \"2*pi\"\nmass = 1\ndamping = 0.2\nstiffness = 0.4\nforcing = [{{ cos = 1 }}]\n{walls}\
             [[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{{ q = 0.1 }}]\n\
             [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = {{ q = 0.1 }}\nperiods = 50\n"
        )
    };
    let [one, two, three] = [1, 2, 3].map(|stops| reports(2, &scene(stops)));
    assert!(number(&one[0]["attractors"][0]["impacts"]) > 0.0, "{}", one[0]);
    let impacts = |all: &[Value]| -> f64 {
        all[1]["stops"].as_array().unwrap().iter().map(|row| number(&row["impacts"])).sum()
    };
    for several in [two, three] {
        for key in ["period", "impacts", "impacts_per_period"] {
            assert_eq!(one[0]["attractors"][0][key], several[0]["attractors"][0][key], "{key}");
        }
        assert_eq!(impacts(&one), impacts(&several));
    }
}

/// A mass m at speed v on a spring k is pushed back with v √(km) at most; a damper alone with cv at once;
/// where a stop is not met the force is 0.
#[test]
fn the_peak_force_of_a_stop_that_gives_way_is_reported() {
    let scene = |stiffness: f64, damping: f64| {
        format!(
            "[system]\nperiod = 1\nmass = 2.5\n\
             [[walls]]\nname = \"pad\"\nrow = [1]\noffset = -1\nstiffness = {stiffness:e}\ndamping = {damping:e}\n\
             [[walls]]\nname = \"away\"\nrow = [-1]\noffset = -100\nstiffness = 5\n\
             [[walls]]\nname = \"rigid\"\nrow = [-1]\noffset = -3\nrestitution = 1\n\
             [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = {{ q = 0, u = -0.7 }}\nperiods = 8\nsamples = 3\n"
        )
    };
    for stiffness in [1e3, 1e7] {
        let all = reports(2, &scene(stiffness, 0.0));
        let stops = &all[0]["stops"];
        assert_near(&stops[0]["peak_force"], 0.7 * (stiffness * 2.5f64).sqrt(), 1e-9);
        assert!(stops[0]["strongest"].is_null() && stops[2]["peak_force"].is_null(), "{stops}");
        assert_eq!(number(&stops[1]["peak_force"]), 0.0);
        // The momentum of a mass that is turned round.
        assert_near(&stops[2]["strongest"], 2.0 * 2.5 * 0.7, 1e-9);
    }
    // With ζ > 1/2 the force is largest where contact begins.
    let (stiffness, damping) = (1e3, 200.0);
    let all = reports(2, &scene(stiffness, damping));
    assert_near(&all[0]["stops"][0]["peak_force"], damping * 0.7, 1e-9);
}

/// A mass m at speed v leaves a stop of damping ratio ζ that lets go where it would pull with e v, e =
/// exp(−ζ(π − 2 asin ζ)/√(1 − ζ²)), after (π − 2 asin ζ)/(ω √(1 − ζ²)); a rigid one with τ v. What is lost is
/// the contact's. Undamped, nothing is.
#[test]
fn contacts_take_the_energy_that_is_lost_and_as_long_as_they_last() {
    let (m, v) = (2.5f64, 0.7f64);
    for (stiffness, ratio) in [(1e3f64, 0.3f64), (1e7, 0.05), (40.0, 0.9), (1e3, 0.0)] {
        let damping = 2.0 * ratio * (stiffness * m).sqrt();
        let scene = format!(
            "[system]\nperiod = 1\nmass = {m}\n\
             [[walls]]\nname = \"pad\"\nrow = [1]\noffset = -1\nstiffness = {stiffness:e}\ndamping = {damping:e}\n\
             [[walls]]\nname = \"rigid\"\nrow = [-1]\noffset = -1\nrestitution = 0.6\n\
             [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = {{ q = 0, u = -{v} }}\nperiods = 40\nsamples = 3\n"
        );
        let all = reports(2, &scene);
        let stops = &all[0]["stops"];
        let root = (1.0 - ratio * ratio).sqrt();
        let angle = (PI - 2.0 * ratio.asin()) / root;
        let left = (-ratio * angle).exp();
        let [pad, rigid] = [0, 1].map(|i| number(&stops[i]["impacts"]) as i32);
        assert!(pad >= 1 && (pad - rigid).abs() <= 1, "{stops}");
        // Pad and rigid stop in turn, each loss a share of what is left.
        let (mut energy, mut lost) = (0.5 * m * v * v, [0.0; 2]);
        for i in 0..pad + rigid {
            let keeps = if i % 2 == 0 { left * left } else { 0.36 };
            lost[(i % 2) as usize] += energy * (1.0 - keeps);
            energy *= keeps;
        }
        assert!((number(&stops[0]["dissipated"]) - lost[0]).abs() < 1e-10, "{stops} {lost:?}");
        assert_near(&stops[1]["dissipated"], lost[1], 1e-10);
        assert_near(&stops[0]["longest"], angle / (stiffness / m).sqrt(), 1e-9);
        assert!(stops[1]["longest"].is_null(), "{stops}");
    }
}

/// What is said of a scene that is refused, when it is read or when it is run.
fn refusal(format: u32, scene: &str) -> String {
    let text = format!("format = \"grazing-scene {format}\"\ntitle = \"t\"\n{scene}");
    match Scene::from_toml(&text, "scene.toml") {
        Err(error) => error.to_string(),
        Ok(_) => {
            let all = reports(format, scene);
            assert_eq!(all[0]["status"], "failed", "{}", all[0]);
            all[0]["reason"].as_str().unwrap().to_string()
        }
    }
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let system = "[system]\ndamping = 0.2\nstiffness = 0.3\nforcing = [{ cos = 1 }]\n\
                  [[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 0.5\n";
    let machine = system
        .replace("[system]", "[system]\nperiod = \"2*pi\"\nmass = 1")
        .replace("side = \"lower\"", "row = [1]");
    for (format, system) in [(1, system.to_string()), (2, machine)] {
        for ends in ["from = 2, to = -2", "from = 1, to = 1"] {
            let grid = format!("q = {{ {ends}, count = 3 }}\nu = {{ from = -1, to = 1, count = 3 }}");
            let task = format!("[[tasks]]\nname = \"b\"\nkind = \"basins\"\n{grid}\n");
            let reason = refusal(format, &format!("{system}{task}"));
            assert!(reason.contains("not below `to`") && reason.contains("scene.toml"), "{reason}");
        }
        for pattern in ["[4294967295, 7]", "[4294967295, 1]", "[2147483648, 2147483648]"] {
            let orbit = format!("orbit = {{ pattern = {pattern}, starts = 3 }}");
            let task = format!("[[tasks]]\nname = \"o\"\nkind = \"orbit\"\n{orbit}\n");
            let reason = refusal(format, &format!("{system}{task}"));
            assert!(
                reason.contains("more than 2^32 - 1") || reason.contains("more than 4294967295"),
                "{reason}"
            );
        }
    }
}
