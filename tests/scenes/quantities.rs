//! Quantities with units: a scene that has them is the scene in bare numbers, in whatever units; what is no
//! mass is not read as one; and what else hands type.

use grazing_scenes::{
    number::parse_rational,
    run::{Findings, Surroundings, run},
    scene::Scene,
};
use num_rational::BigRational;
use proptest::prelude::*;

use crate::common;

/// A machine with a touch: {…} stand for what is written in units.
fn machine(units: &str, values: &[(&str, String)]) -> String {
    let mut text = format!(
        r#"format = "grazing-scene 3"
title = "t"
{units}
[parameters]
F = "<F>"
M = "<m>"
share = "<share>"
[system]
frequency = "<f>"
mass = "M"
damping = "<c>"
stiffness = "<k>"
forcing = [{{ cos = "F*(1 - share)" }}]
[[stops]]
side = "upper"
offset = "<gap>"
restitution = "<e>"
[[tasks]]
name = "touch"
kind = "grazing"
parameter = "F"
max_period = 3
"#
    );
    for (name, value) in values {
        text = text.replace(&format!("<{name}>"), value);
    }
    assert!(!text.contains('<'), "{text}");
    text
}

fn read(text: &str) -> Result<Scene, String> {
    Scene::from_toml(text, "s.toml").map_err(|error| {
        assert!(error.is_input() && error.to_string().lines().count() == 1, "{error}");
        error.to_string()
    })
}

fn rational(text: &str) -> BigRational {
    parse_rational(text).unwrap()
}

/// Of a quantity its name, units with their sizes in SI units, and that of the unit made of t, mm and s.
type Known = (&'static str, &'static [(&'static str, &'static str)], &'static str);

const UNITS: [Known; 8] = [
    ("F", &[("N", "1"), ("mN", "1/1000"), ("kN", "1000"), ("kg m/s^2", "1")], "1"),
    ("m", &[("kg", "1"), ("g", "1/1000"), ("t", "1000"), ("mg", "1e-6")], "1000"),
    ("f", &[("Hz", "1"), ("kHz", "1000"), ("rpm", "1/60"), ("/s", "1")], "1"),
    ("c", &[("N s/m", "1"), ("kg/s", "1"), ("N*s/mm", "1000"), ("N·s/m", "1")], "1000"),
    ("k", &[("N/m", "1"), ("N/mm", "1000"), ("kN/m", "1000"), ("MN/m", "1e6")], "1000"),
    ("gap", &[("m", "1"), ("mm", "1/1000"), ("in", "127/5000"), ("\u{3bc}m", "1e-6")], "1/1000"),
    ("share", &[("%", "1/100"), ("", "1"), ("%", "1/100"), ("", "1")], "1"),
    ("e", &[("%", "1/100"), ("", "1"), ("%", "1/100"), ("", "1")], "1"),
];

/// Each quantity as it is written, as a bare number in SI units, and in t, mm and s.
fn written(digits: &[(u32, usize)]) -> [Vec<(&'static str, String)>; 3] {
    let mut all = [Vec::new(), Vec::new(), Vec::new()];
    for ((name, units, other), (digits, choice)) in UNITS.into_iter().zip(digits) {
        let (unit, size) = units[choice % units.len()];
        let number = rational(&format!("{digits}/1000"));
        let text = match unit {
            "" => format!("{number}"),
            // A unit of its own power.
            "/s" => format!("({number})/(1 s)"),
            unit => format!("({number}) {unit}"),
        };
        let si = number * rational(size);
        for (i, text) in [text, si.to_string(), (&si / rational(other)).to_string()].into_iter().enumerate() {
            all[i].push((name, text));
        }
    }
    all
}

const SI: &str = "[units]\nlength = \"m\"\ntime = \"s\"\nmass = \"kg\"";
const SMALL: &str = "[units]\nlength = \"mm\"\ntime = \"s\"\nmass = \"t\"";

proptest! {
    #![proptest_config(common::config())]

    /// Every value is the same fraction.
    #[test]
    fn a_scene_with_units_is_that_in_bare_numbers(digits in prop::collection::vec((1u32..1000, 0usize..4), 8)) {
        let [units, si, small] = written(&digits);
        let scene = |head: &str, values: &[(&'static str, String)]| read(&machine(head, values)).unwrap();
        for (head, bare) in [("", scene(SI, &si)), (SI, scene(SI, &si)), (SMALL, scene(SMALL, &small))] {
            let scene = scene(head, &units);
            prop_assert_eq!(&scene.parameters, &bare.parameters);
            prop_assert_eq!(scene.written().unwrap(), bare.written().unwrap());
            prop_assert_eq!(scene.units, bare.units);
        }
    }
}

/// Of one machine, whole reports; those of the scene with units have them in their sentences.
#[test]
fn reports_are_the_same() {
    let values = |all: [&str; 8]| -> Vec<(&'static str, String)> {
        UNITS.iter().map(|known| known.0).zip(all.map(str::to_string)).collect()
    };
    let report = |head: &str, all: [&str; 8]| {
        let scene = read(&machine(head, &values(all))).unwrap();
        let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
        let mut report = serde_json::to_value(&reports[0]).unwrap();
        let words = report.as_object_mut().unwrap().remove("in_words").unwrap();
        for told in ["place", "sentences", "bands_in_words"] {
            report.as_object_mut().unwrap().remove(told).unwrap();
        }
        report["units"].as_object_mut().unwrap().retain(|_, unit| unit != "N");
        (report, words.as_str().unwrap().to_string())
    };
    let (units, words) = report("", ["0.4 N", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "0 %", "80 %"]);
    let (bare, plain) = report(SI, ["0.4", "2", "4", "3", "800", "0.001", "0", "0.8"]);
    assert_eq!(units, bare);
    assert!(words.starts_with("At F = 0.4") && words.contains(" N the motion"), "{words}");
    assert_eq!(
        words.replacen(" N the motion", " the motion", 1).matches("F = ").count(),
        plain.matches("F = ").count()
    );
    // Sentences keep the unit that was written, whatever the scene's are.
    let (_, small) = report(SMALL, ["0.4 N", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "0 %", "80 %"]);
    assert_eq!(small, words);
    let (_, milli) = report("", ["400 mN", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "0 %", "80 %"]);
    assert!(milli.contains(" mN the motion"), "{milli}");
}

/// Tables for a reader have their units in their heads, the parameter in the one in which it is written; JSON
/// says which are the scene's.
#[test]
fn reports_name_their_units() {
    let values = |all: [&str; 8]| -> Vec<(&'static str, String)> {
        UNITS.iter().map(|known| known.0).zip(all.map(str::to_string)).collect()
    };
    let given = values(["400 mN", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "0 %", "80 %"]);
    let tasks = "range = { effort = 20000 }\n[[tasks]]\nname = \"motion\"\nkind = \"simulate\"\nperiods = 3\nstart = { q = 0 }\n";
    let reports = |text: &str| run(&read(text).unwrap(), Surroundings::default(), &mut ()).unwrap();
    let both = reports(&(machine("", &given) + tasks));
    let [touch, motion] = &both[..] else { panic!("{both:?}") };
    let (text, json) = (format!("{touch:.6}"), serde_json::to_value(touch).unwrap());
    let json_motion = serde_json::to_value(motion).unwrap();
    assert_eq!(["radius", "rest", "q"].map(|of| json_motion["units"][of].as_str().unwrap()), ["s", "s", "m"]);
    for wanted in ["F = 400 mN, M = 2 kg, share = 0\n", "value (mN)", "fastest (m/s)", "strongest (N s)"] {
        assert!(text.contains(wanted), "{wanted}: {text}");
    }
    let grazing = text.lines().find(|line| line.trim().starts_with("grazing")).unwrap();
    let told = grazing.strip_suffix(" mN").unwrap_or_else(|| panic!("{grazing}"));
    let told: f64 = told.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((told - 1000.0 * json["parameter"].as_f64().unwrap()).abs() < 1e-3, "{told} {json}");
    assert_eq!(
        ["parameter", "fastest", "acceleration", "gap", "touch"]
            .map(|column| json["units"][column].as_str().unwrap()),
        ["N", "m/s", "m/s^2", "m", "N"]
    );
    // Ends of what is proved, exactly.
    let range = json["range"].as_array().unwrap().iter().find(|row| row["end"].is_string()).unwrap();
    for end in ["touch", "end"] {
        let milli = rational(range[end].as_str().unwrap()) * rational("1000");
        let is_told = |word: &str| parse_rational(word).is_ok_and(|found| found == milli);
        assert!(text.split_whitespace().any(is_told), "{milli}: {text}");
    }
    let text = format!("{motion:.6}");
    assert!(text.contains("extent") && text.contains(" m\n") && text.contains("dissipated (J)"), "{text}");
    // What turns has angles; without units there are none.
    let turning = values(["4 Nm", "2 kg m^2", "4 Hz", "3 Nm s", "800 Nm", "1 mrad", "0 %", "80 %"]);
    let turning = reports(&machine("", &turning));
    let json = serde_json::to_value(&turning[0]).unwrap();
    assert_eq!(["fastest", "gap"].map(|column| json["units"][column].as_str().unwrap()), ["rad/s", "rad"]);
    let words = json["in_words"].as_str().unwrap();
    assert!(words.contains(" rad/s, an impulse of up to ") && words.contains(" N m s"), "{words}");
    let bare = values(["4", "2", "4", "3", "800", "0.001", "0", "0.8"]);
    let bare = serde_json::to_value(&reports(&machine("", &bare))[0]).unwrap();
    assert_eq!(bare["units"], serde_json::json!({}));
}

/// Newtons where millinewtons are the scene's, and the like.
#[test]
fn another_order_of_magnitude_is_noted_beside_the_touch() {
    let words = |force: &str, gap: &str| {
        let values = [force, "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", gap, "0 %", "80 %"];
        let values: Vec<_> = UNITS.iter().map(|known| known.0).zip(values.map(str::to_string)).collect();
        let reports = run(&read(&machine("", &values)).unwrap(), Surroundings::default(), &mut ()).unwrap();
        serde_json::to_value(&reports[0]).unwrap()["in_words"].as_str().unwrap().to_string()
    };
    let noted = words("400 N", "1 mm");
    assert!(
        noted.contains("In the scene F = 400 N, ") && noted.contains(" times the touch: check"),
        "{noted}"
    );
    assert!(words("400 mN", "1 m").contains("In the scene F = 400 mN, "));
    for (force, gap) in [("400 mN", "1 mm"), ("5 N", "1 mm"), ("40", "0.001")] {
        assert!(!words(force, gap).contains("In the scene"), "{force} {gap}");
    }
}

/// A machine, c, k and the restitution, driven a part µ beyond the touch of its stops, and a little more, its
/// time multiplied by a rate.
fn chaotic(stops: &[(&str, i32)], [c, k, e]: [&str; 3], [period, rate, more]: [&str; 3]) -> String {
    let stop = |(side, offset): &(&str, i32)| {
        format!("[[stops]]\nside = \"{side}\"\noffset = {offset}\nrestitution = \"{e}\"\n")
    };
    let drive = format!("(1 + mu)*({more})*({rate})^2");
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nmu = \"1/1000\"\n[system]\n{period}\n\
         damping = \"({c})*({rate})\"\nstiffness = \"({k})*({rate})^2\"\n\
         forcing = [{{ cos = \"{drive}*({k} - 1)\", sin = \"-{drive}*{c}\" }}]\n{}[[tasks]]\n\
         name = \"chaos\"\nkind = \"chaos\"\nparameter = \"mu\"\nfrom = 0\nto = 0.002\n",
        stops.iter().map(stop).collect::<String>()
    )
}

/// What the scene scaled by hand has, exactly where π cancels, else with the same verdict: a wall that
/// moves, a force, a force between two stops.
#[test]
fn chaos_is_proved_in_hertz() {
    let report = |text: &str| {
        let mut reports = run(&read(text).unwrap(), Surroundings::default(), &mut ()).unwrap();
        let Some(Findings::Chaos(found)) = reports.remove(0).findings else { panic!("{text}") };
        found
    };
    let text = include_str!("../../examples/scenes/nordmark-2001-chaos.toml");
    let end = text.find("# And while mu").unwrap();
    let hertz = text[..end]
        .replace("damping = \"2*d/w\"", "frequency = 4\ndamping = \"2*d/w*8*pi\"")
        .replace("stiffness = \"1/w^2\"", "stiffness = \"64*pi^2/w^2\"");
    let (own, hertz) = (report(&text[..end]), report(&hertz));
    assert!(own.proved && own.proof == hertz.proof && own.alphabet == [1, 2]);
    let by_hand = ["", "1", "1"];
    let machines = [
        (&[("lower", -1)][..], ["12/49", "100/2401", "1"]),
        (&[("lower", -1), ("upper", 1)], ["1/8", "25/16", "4/5"]),
    ];
    for (stops, machine) in machines {
        let own = report(&chaotic(stops, machine, by_hand));
        let rate = report(&chaotic(stops, machine, ["frequency = 4", "8*pi", "1"]));
        assert!(own.proved && own.proof == rate.proof && own.alphabet.len() > 1, "{own:?}");
        // Nothing is a multiple of π, and the touch not quite where it was.
        let decimals = ["frequency = 4", "25.1327", "10001/10000"];
        let decimals = report(&chaotic(stops, machine, decimals));
        assert_eq!((decimals.proved, &decimals.alphabet), (true, &own.alphabet), "{decimals:?}");
        assert!((decimals.depth[0] - 1e-4).abs() < 5e-5, "{decimals:?}");
        assert_eq!(decimals.entropy, own.entropy);
        // Before the touch and beyond it: refused as by hand.
        let error = read(&chaotic(stops, machine, ["frequency = 4", "25.1327", "9999/10000"])).unwrap_err();
        assert!(error.contains("grazes the wall within the range"), "{error}");
    }
    // Two restitutions that are not rational are one where they are written so.
    let both = |lower: &str, upper: &str| {
        let (stops, [c, k, _]) = machines[1];
        let text = chaotic(stops, [c, k, "E"], by_hand);
        read(&text.replacen("\"E\"", lower, 1).replacen("\"E\"", upper, 1))
    };
    both("\"sqrt(2/3)\"", "\"sqrt(2/3)\"").unwrap();
    let error = both("\"sqrt(2/3)\"", "\"exp(-0.2)\"").unwrap_err();
    assert!(error.contains("must be given by the same expression, not sqrt(2/3) and exp(-0.2)"), "{error}");
}

/// As `--set` and Python's `set` give values: with a unit where the scene's parameter has one.
#[test]
fn a_parameter_is_set_in_any_unit() {
    let values = |all: [&str; 8]| -> Vec<(&'static str, String)> {
        UNITS.iter().map(|known| known.0).zip(all.map(str::to_string)).collect()
    };
    let units = values(["4 N", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "0 %", "80 %"]);
    let set =
        |scene: &Scene, name: &str, text: &str| scene.values(&[(name, text)]).map(|all| all[0].1.clone());
    for (head, ton) in [("", "1"), (SMALL, "1000")] {
        let scene = read(&machine(head, &units)).unwrap();
        for text in ["500 mN", "(1/2) N", "0.5 kg m/s^2", "0.5"] {
            assert_eq!(set(&scene, "F", text).unwrap(), rational("1/2"), "{head}: {text}");
        }
        assert_eq!(set(&scene, "M", "3 kg").unwrap(), rational("3") / rational(ton), "{head}");
        assert_eq!(set(&scene, "share", "5 %").unwrap(), rational("1/20"), "{head}");
        for (name, text, told) in [
            ("F", "3 kg", "F = \"3 kg\": is a mass, and in s.toml F is a force"),
            ("M", "3 N + 1 kg", "adds a force and a mass"),
            ("F", "3 Nm/kg", "is length^2 time^-2, and in s.toml F is a force"),
            ("F", "soft", "F = \"soft\""),
            ("F", "", "F = \"\""),
            ("F", "nan", "nan is no number here: every number is finite"),
            ("F", "0,5 N", "0,5 has a decimal comma: write 0.5"),
            ("G", "1 N", "no parameter \"G\""),
        ] {
            let error = set(&scene, name, text).unwrap_err();
            assert!(error.is_input() && error.to_string().contains(told), "{head}: {text}: {error}");
        }
        let twice = scene.values(&[("F", "1"), ("F", "2 N")]).unwrap_err().to_string();
        assert!(twice.contains("given twice"), "{twice}");
    }
    let bare = read(&machine(SI, &values(["4", "2", "4", "3", "800", "0.001", "0", "0.8"]))).unwrap();
    let error = set(&bare, "F", "5 N").unwrap_err().to_string();
    assert!(error.contains("F has no unit"), "{error}");
    // And in the file.
    let given = machine(SI, &values(["4", "2", "4", "3", "800", "0.001", "0", "0.8"]));
    let given = given.replacen("max_period = 3", "set = { F = \"5 kg\" }", 1);
    let error = read(&given).unwrap_err();
    assert!(error.contains("set.F = \"5 kg\": is a mass, and F has no unit in [parameters]"), "{error}");
}

/// A good scene, and what each change of it is told.
#[test]
fn what_does_not_go_together_is_told() {
    let values = ["4 N", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "2 %", "80 %"];
    let values: Vec<_> = UNITS.iter().map(|known| known.0).zip(values.map(str::to_string)).collect();
    let good = machine("", &values);
    read(&good).unwrap();
    for (from, to, message) in [
        (
            "mass = \"M\"",
            "mass = \"2 kg + 3 N\"",
            "s.toml:10: system.mass = \"2 kg + 3 N\": adds a mass and a force",
        ),
        ("mass = \"M\"", "mass = \"M + F\"", "system.mass = \"M + F\": adds a mass and a force"),
        (
            "mass = \"M\"",
            "mass = \"F\"",
            "system.mass = \"F\": is a force; here stands a mass, in kg or the like",
        ),
        ("mass = \"M\"", "mass = \"M + 1\"", "adds a mass and a number without a unit: give it one"),
        ("mass = \"M\"", "mass = \"2 M\"", "M at character 3 is a parameter: write 2*M"),
        (
            "\"4 Hz\"",
            "\"4 hz\"",
            "system.frequency = \"4 hz\": there is no unit \"hz\", at character 3; the nearest is \"Hz\"",
        ),
        ("\"4 Hz\"", "\"1/4 s\"", "…/4 s, at character 3, is read in two ways: write (…/4) s, or …/(4 s)"),
        ("\"4 Hz\"", "\"4 s\"", "is a time; here stands a frequency, in Hz or the like"),
        ("damping =", "zeta =", "unknown key \"zeta\": the damping ratio is `damping_ratio` of [system]"),
        ("damping =", "c =", "unknown key \"c\": the damping is `damping` of [system]"),
        ("stiffness =", "k =", "unknown key \"k\": the spring is `stiffness` of [system]"),
        ("frequency =", "f =", "unknown key \"f\": it is called `frequency`"),
        ("restitution =", "e =", "unknown key \"e\": it is called `restitution`"),
        ("offset =", "gap =", "unknown key \"gap\": where it stands is `offset`"),
        ("\"4 Hz\"", "\"4 Hz + 3 rad/s\"", "an angular frequency is 2*pi times a frequency"),
        (
            "\"1 mm\"",
            "\"1 N\"",
            "stops[1].offset = \"1 N\": is a force; here stands a length, in m or the like",
        ),
        ("\"1 mm\"", "\"sin(1 mm)\"", "takes sin of a length: that is of a plain number or an angle"),
        (
            "\"0.8 N/mm\"",
            "\"0.8 N m\"",
            "is an energy or a torque; here stands a stiffness, in N/m or the like",
        ),
        ("\"0.8 N/mm\"", "\"max(1 N/m, 2 kg)\"", "subtracts a stiffness and a mass"),
        ("\"80 %\"", "\"80 mm\"", "is a length; here stands a plain number"),
        ("\"4 N\"", "\"4 N + 1 m\"", "parameters.F = \"4 N + 1 m\": adds a force and a length"),
        ("\"4 N\"", "\"4 deg\"", "pi is irrational"),
        ("max_period = 3", "max_period = \"3 s\"", "is a time; here stands a plain number"),
        (
            "max_period = 3",
            "set = { F = \"3 kg\" }",
            "tasks[1].set.F = \"3 kg\": is a mass; here stands a force",
        ),
        ("max_period = 3", "tolerance = { M = \"3 N\" }", "is a force; here stands a mass"),
    ] {
        assert!(good.contains(from), "{from}");
        let error = read(&good.replacen(from, to, 1)).expect_err(to);
        assert!(error.contains(message), "{to}\n  found    {error}\n  expected {message}");
    }
    for (from, to) in [
        ("mass = \"M\"", "mass = \"M + 500 g\""),
        ("mass = \"M\"", "mass = \"F/(9.81 m/s^2)\""),
        ("mass = \"M\"", "mass = \"2\""),
        ("\"0.8 N/mm\"", "\"M*(20 rad/s)^2\""),
        ("\"0.8 N/mm\"", "\"800 N/m\""),
        ("\"4 Hz\"", "\"sqrt((800 N/m)/M)/(2*pi)\""),
        ("\"1 mm\"", "\"0 + 1 mm\""),
        ("max_period = 3", "set = { F = \"300 mN\", M = 3 }"),
        ("max_period = 3", "tolerance = { M = \"20 g\", F = \"2%\" }"),
    ] {
        read(&good.replacen(from, to, 1)).unwrap_or_else(|error| panic!("{to}: {error}"));
    }
}

/// The older formats have no units, and say which has.
#[test]
fn older_formats_name_the_one_that_has_units() {
    for value in ["parameters.d = \"2 mm\"", "system.damping = \"2 kg/s\""] {
        let text = format!("format = \"grazing-scene 1\"\ntitle = \"t\"\n{value}\n");
        let error = read(&text).unwrap_err();
        let why =
            "has a unit, which needs format = \"grazing-scene 3\" (`grazing run --upgrade` writes that)";
        assert!(error.starts_with("s.toml:3: ") && error.ends_with(why), "{error}");
    }
}

/// Hertz and radians per second differ by 2π, and by no more.
#[test]
fn angles_per_time_become_cycles() {
    let values = ["4 N", "2 kg", "4 Hz", "3 N s/m", "0.8 N/mm", "1 mm", "2 %", "80 %"];
    let values: Vec<_> = UNITS.iter().map(|known| known.0).zip(values.map(str::to_string)).collect();
    let good = machine("", &values).replacen("F = \"4 N\"", "F = \"4 N\"\nw = \"25 rad/s\"", 1);
    let period = |text: &str| {
        let scene =
            read(&good.replacen("\"4 Hz\"", text, 1)).unwrap_or_else(|error| panic!("{text}: {error}"));
        std::f64::consts::TAU / scene.rounded().unwrap().shown_rate()
    };
    let wanted = std::f64::consts::TAU / 25.0;
    for text in ["\"25 rad/s\"", "\"w\"", "\"w/(2*pi)\"", "\"25/(2*pi) * (1 Hz)\""] {
        assert!((period(text) - wanted).abs() < 1e-14, "{text}: {}", period(text));
    }
    assert!((period("\"1500 rpm\"") - 0.04).abs() < 1e-15);
    for text in ["w/pi^2", "(4500/pi) deg/s", "w + w/(2*pi)"] {
        let error = read(&good.replacen("4 Hz", text, 1)).expect_err(text);
        assert!(error.contains("mixes angles and cycles"), "{text}: {error}");
    }
}

/// What other keyboards and other programs type.
const HANDS: [(&str, &str, &str); 34] = [
    ("d = 0.1", "d = nan", "s.toml:4: parameters.d = nan: \"nan\" is not a number: "),
    ("d = 0.1", "d = nan", "nan is no number here: every number is finite"),
    ("d = 0.1", "d = inf", "inf is no number here: every number is finite"),
    (
        "stiffness = 1",
        "stiffness = inf",
        "s.toml:6: system.stiffness = inf: unknown parameter \"inf\" at character 1; inf is no number here",
    ),
    ("d = 0.1", "d = 0,5", "0,5 has a decimal comma: write 0.5"),
    (
        "d = 0.1",
        "d = \"0,5\"",
        "s.toml:4: parameters.d = \"0,5\": \"0,5\" is not a number: expected `+` or `-`, found ','",
    ),
    ("d = 0.1", "d = \"0,5\"", "0,5 has a decimal comma: write 0.5"),
    ("stiffness = 1", "stiffness = \"2,25*d\"", "found ','; 2,25 has a decimal comma: write 2.25"),
    ("d = 0.1", "d = \u{2212}1", "s.toml:4: "),
    ("d = 0.1", "d = \u{2212}1", "\u{2212} (U+2212) is not the minus of a keyboard: write -"),
    (
        "stiffness = 1",
        "stiffness = \"1 \u{2212} d\"",
        "\u{2212} (U+2212) is not the minus of a keyboard: write -",
    ),
    ("d = 0.1", "d = \"\u{2212}1\"", "\u{2212} (U+2212) is not the minus of a keyboard: write -"),
    ("title = \"t\"", "title = “t”", "s.toml:2: "),
    ("title = \"t\"", "title = “t”", "“ is not one of the quotes of a keyboard: write \"…\""),
    ("d = 0.1", "d = 4 %", "a number with a unit is a text: write d = \"4 %\""),
    ("stiffness = 1", "stiffness = 2 N/m", "a number with a unit is a text: write stiffness = \"2 N/m\""),
    ("stiffness = 1", "stiffness = 2*d", "a formula is a text: write stiffness = \"2*d\""),
    (
        "[[stops]]",
        "[stops]",
        "s.toml:8: stops = [stops]: is one table, not a list of them: write [[stops]] above each",
    ),
    ("d = 0.1", "pi = 3", "s.toml:4: parameters.pi = 3: is 3.14159… in every expression, and no parameter"),
    ("d = 0.1", "d = \"3 \u{b5}m/\u{3bc}m\"", ""),
    ("d = 0.1", "d = \"1.000,5\"", "1.000,5 has a decimal comma: write 1000.5"),
    ("d = 0.1", "d = \"1,000.5\"", "1,000.5 has a comma between thousands: write 1000.5"),
    ("d = 0.1", "d = \"400 000 mN\"", "400 000 has spaces between its digits: write 400000"),
    ("d = 0.1", "d = \"4·10^2\"", "· is no product of numbers here: write *"),
    ("d = 0.1", "d = \"½\"", "½ is one character: write 1/2"),
    ("d = 0.1", "d = \"0.1", "the closing quote is missing: write d = \"0.1\""),
    ("d = 0.1", "δ = 0.1", "a name is a letter from a to z, then letters, digits and _"),
    ("stiffness = 1", "stiffness = \"3 N-s/m\"", "as a unit s stands behind a number, or behind a space"),
    (
        "stiffness = 1",
        "stiffness = 1\nfrequency = 0",
        "system.frequency = 0: makes no period: it must be positive",
    ),
    (
        "stiffness = 1",
        "stiffness = 1\nforcing = { cos = 1 }",
        "is one table, not a list of them: write [{ cos = 1 }]",
    ),
    (
        "stiffness = 1",
        "stiffness = 1\nforcing = [{ k = 2, cos = d }]",
        "a formula is a text: write cos = \"d\"",
    ),
    ("stiffness = 1", "stiffness = 1\nforcing = [{ cos = 0,5 }]", "0,5 has a decimal comma: write 0.5"),
    ("stiffness = 1", "stiffness = 1\nforcing = [{ k = 2, cos = 100, sin = 200 }]", ""),
    ("restitution = 1", "restitution = 80 %", "a number with a unit is a text: write restitution = \"80 %\""),
];

#[test]
fn what_hands_type_is_told() {
    let good = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nd = 0.1\n[system]\nstiffness = 1\n\
                damping = \"d\"\n[[stops]]\nside = \"lower\"\noffset = -1\nrestitution = 1\n[[tasks]]\nname = \"m\"\n\
                kind = \"simulate\"\nperiods = 1\nstart = { q = 0.5 }\n";
    let warnings = |text: &str| -> Vec<String> {
        let reports = run(&read(text).unwrap(), Surroundings::default(), &mut ()).unwrap();
        let report = serde_json::to_value(&reports[0]).unwrap();
        let all = report["warnings"].as_array().unwrap();
        all.iter().map(|one| one.as_str().unwrap().to_string()).collect()
    };
    assert_eq!(warnings(good), [""; 0]);
    for (from, to, message) in HANDS {
        assert!(good.contains(from), "{from}");
        match read(&good.replacen(from, to, 1)) {
            Ok(_) => assert_eq!(message, "", "{to}"),
            Err(error) => {
                assert!(
                    !message.is_empty() && error.contains(message),
                    "{to}\n  found    {error}\n  expected {message}"
                );
            }
        }
    }
    for (key, means) in [("damping", "feeds energy in"), ("stiffness", "the place of rest repels")] {
        let told = warnings(&good.replacen(&format!("{key} = "), &format!("{key} = -1 # "), 1));
        assert!(told.iter().any(|told| told.contains(&format!("the {key} is negative: "))), "{told:?}");
        assert!(told.iter().any(|told| told.contains(means)), "{told:?}");
    }
    // What is allowed and hardly meant, by both engines.
    for engine in ["one", "many"] {
        let good = good.replacen("[parameters]\n", &format!("engine = {engine:?}\n[parameters]\n"), 1);
        let told = warnings(&good.replacen("restitution = 1", "restitution = 1.5", 1));
        assert!(
            told[0].starts_with("the restitution of stop lower is ") && told[0].contains("above 1"),
            "{told:?}"
        );
        let told = warnings(&good.replacen("d = 0.1", "d = 0.1\nzeta = \"4 %\"", 1));
        assert!(told[0].starts_with("the parameter zeta acts on nothing"), "{told:?}");
    }
}
