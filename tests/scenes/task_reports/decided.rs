//! Motions that come nearer too slowly to be seen to the end, that grow, or that never settle: what is said
//! of them, held against closed forms.

use std::f64::consts::PI;

use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};
use serde_json::Value;

use crate::tasks::{near, number};

fn reports(scene: &str) -> Vec<Value> {
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{scene}");
    let scene = Scene::from_toml(&text, "scene.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    reports.iter().map(|report| serde_json::to_value(report).unwrap()).collect()
}

/// A mass on a spring, with dry friction of 0.3 and a force cos wt.
const RUBBED: &str = "[system]\nperiod = \"2*pi/w\"\nstiffness = 1\nforcing = [{ cos = 1 }]\n\
                      [[friction]]\nnormal = 1\ncoefficient = 0.3\n";

/// The amplitude of its motion that never rests: Den Hartog, Trans. ASME 53 (1931).
fn den_hartog(w: f64) -> f64 {
    let (beyond, turn) = (1.0 / (1.0 - w * w), PI / w);
    let loss = 0.3 * turn.sin() / (w * (1.0 + turn.cos()));
    (beyond * beyond - loss * loss).sqrt()
}

/// Friction takes the same from each swing, so of 340 widths little in a hundred periods: the motion is known
/// to come nearer all the same, from everywhere.
#[test]
fn dry_friction_has_one_motion_from_everywhere() {
    let tasks = "[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{ q = 340 }]\ntransient = 100\npoints = 200\n\
                 [[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = { from = -400, to = 400, count = 9 }\n\
                 u = { from = -1, to = 1, count = 2 }\n\
                 [[tasks]]\nname = \"r\"\nkind = \"response\"\nparameter = \"w\"\nrange = [1.1, 1.3]\ncount = 3\n";
    let all = reports(&format!("[parameters]\nw = 1.1\n{RUBBED}{tasks}"));
    assert_eq!(all[0]["attractors"][0]["period"], 1, "{}", all[0]);
    let basins = all[1]["basins"].as_array().unwrap();
    assert_eq!(
        (basins.len(), &basins[0]["period"], &basins[0]["starts"]),
        (1, &1.into(), &18.into()),
        "{}",
        all[1]
    );
    near(number(&all[2]["highest"][0]["swing"]), den_hartog(1.1), 1e-8);
}

/// At the resonance, which nothing but friction bounds, the motion grows: it is not settled, and in no
/// maximum, hysteresis or jump; beyond it the sweep goes on from where it last was.
#[test]
fn what_grows_at_a_resonance_is_in_no_maximum() {
    let task = "[[tasks]]\nname = \"r\"\nkind = \"response\"\nparameter = \"w\"\nrange = [0.8, 1.2]\ncount = 5\n\
                transient = 400\n";
    let found = reports(&format!("[parameters]\nw = 0.8\n{RUBBED}{task}")).remove(0);
    assert_eq!(found["status"]["word"].as_str().or(found["status"].as_str()), Some("undecided"), "{found}");
    assert_eq!(found["not_settled"], serde_json::json!([1.0, 1.0]), "{found}");
    for row in found["highest"].as_array().unwrap() {
        near(number(&row["swing"]), den_hartog(0.9).max(den_hartog(1.1)), 1e-8);
    }
    assert_eq!(found["sweep"]["hysteresis"], serde_json::json!([]), "{found}");
    assert_eq!(found["sweep"]["jumps"], serde_json::json!([]), "{found}");
}

/// A stop that is never met, and damping that takes 10⁻⁹ of the swing in a third of a period: the motion
/// without impacts attracts all starts before the stop, in closed form.
#[test]
fn damping_however_light_is_damping() {
    let tasks = "[[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = { from = -4, to = 4, count = 9 }\n\
                 u = { from = -1, to = 1, count = 2 }\n";
    for engine in ["one", "many"] {
        let system = format!(
            "engine = \"{engine}\"\n[system]\ndamping = 1e-9\nstiffness = \"0.37\"\nforcing = [{{ cos = 1 }}]\n\
             [[stops]]\nside = \"lower\"\noffset = -20\nrestitution = 0.8\n{tasks}"
        );
        let found = reports(&system).remove(0);
        let basins = found["basins"].as_array().unwrap();
        assert_eq!((basins.len(), &basins[0]["starts"]), (1, &18.into()), "{found}");
        near(number(&basins[0]["q"]), 1.0 / (0.37 - 1.0), 1e-8);
    }
}

/// The part of i times an irrational number beyond a whole one: draws that fill [0, 1).
fn drawn(i: u32, slope: f64) -> f64 {
    (f64::from(i) * slope).fract()
}

/// Machine i of those that lose little, and the displacement that its motion has at phase 0: 18 of one linear
/// coordinate, 12 of two, stops that are never met, damping from 10⁻³ to 10⁻⁹; the rest have friction alone.
fn loses_little(i: u32) -> (String, Option<f64>) {
    if i > 30 {
        let w = if i.is_multiple_of(2) {
            1.05 + 0.6 * drawn(i, 0.618034)
        } else {
            0.5 + 0.4 * drawn(i, 0.618034)
        };
        return (format!("[parameters]\nw = {w}\n{RUBBED}"), None);
    }
    let damping = 10f64.powf(-3.0 - 6.0 * drawn(i, 0.618034));
    // Away from the resonance at 1 by a tenth at least.
    let stiffness =
        if i.is_multiple_of(3) { 0.1 + 0.8 * drawn(i, 0.414214) } else { 1.1 + 9.0 * drawn(i, 0.732051) };
    let system = if i <= 18 {
        let engine = ["many", "one"][i as usize % 2];
        format!(
            "engine = \"{engine}\"\n[system]\ndamping = {damping}\nstiffness = {stiffness}\n\
             forcing = [{{ cos = 1 }}]\n[[stops]]\nside = \"lower\"\n"
        )
    } else {
        // Each mass hangs on a wall, and on the other: forced alike, they tend to move alike.
        let between = 0.2 + drawn(i, 0.236068);
        format!(
            "[system]\nperiod = \"2*pi\"\nmass = {{ diagonal = [1, 1] }}\ndamping = {{ diagonal = [{damping}, {damping}] }}\n\
             stiffness = [[{0}, {1}], [{1}, {0}]]\nforcing = [{{ cos = [1, 1] }}]\n[[stops]]\nrow = [1, 0]\n",
            stiffness + between,
            -between
        )
    };
    let away = stiffness - 1.0;
    (system + "offset = -300\nrestitution = 0.8\n", Some(away / (away * away + damping * damping)))
}

/// One motion, of period 1, attracts every start of machines that lose little, as closed forms say.
#[test]
fn machines_that_lose_little_have_one_motion() {
    for i in 1..=41 {
        let (system, displacement) = loses_little(i);
        let (plane, start) = if (19..=30).contains(&i) {
            ("plane = [\"q1\", \"u2\"]\n", "[2, -1]")
        } else {
            ("", if displacement.is_some() { "2" } else { "60" })
        };
        let reach = if displacement.is_some() { 4 } else { 100 };
        let found = reports(&format!(
            "{system}[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{{ q = {start} }}]\n\
             [[tasks]]\nname = \"b\"\nkind = \"basins\"\n{plane}q = {{ from = -{reach}, to = {reach}, count = 2 }}\n\
             u = {{ from = -1, to = 1, count = 2 }}\n"
        ));
        let [section, basins] = [("attractors", &found[0]), ("basins", &found[1])].map(|(key, of)| &of[key]);
        assert_eq!(
            (section.as_array().unwrap().len(), &section[0]["period"]),
            (1, &1.into()),
            "{i}: {}",
            found[0]
        );
        let all = basins.as_array().unwrap();
        assert_eq!(
            (all.len(), &all[0]["period"], &all[0]["starts"]),
            (1, &1.into(), &4.into()),
            "{i}: {}",
            found[1]
        );
        if let Some(displacement) = displacement {
            near(number(&all[0]["q"]), displacement, 1e-8 * displacement.abs().max(1.0));
        }
    }
}

/// Without damping motions neither come nearer nor part: none is on an orbit.
#[test]
fn without_damping_a_motion_wanders() {
    let task = "[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{ q = 0.3 }]\n";
    let found =
        reports(&format!("[system]\nstiffness = \"0.37\"\nforcing = [{{ cos = 1 }}]\n{task}")).remove(0);
    assert_eq!(found["attractors"][0]["periodic"], false, "{found}");
}

/// Ueda's oscillator: the exponents of a period add up to −2π times the damping, in either engine.
#[test]
fn the_exponents_add_up_to_the_damping() {
    for engine in ["one", "many"] {
        let scene = format!(
            "engine = \"{engine}\"\n[system]\ndamping = 0.05\nstiffness = 0\ncubic = 1\nforcing = [{{ cos = 7.5 }}]\n\
             [[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{{ q = 2.5 }}]\npoints = 200\nexponents = 2\n"
        );
        let found = reports(&scene).remove(0);
        let rows = found["exponents"].as_array().unwrap();
        let [first, second] = [0, 1].map(|i| number(&rows[i]["per_period"]));
        assert!(first > 0.3, "{found}");
        near(first + second, -0.05 * 2.0 * PI, 1e-3);
    }
}

/// An orbit of two periods is one, whichever of them it is found at: of three masses beside a soft stop,
/// whose search comes to it at either.
#[test]
fn an_orbit_of_two_periods_is_listed_once() {
    let turn = "2*pi/10";
    let scene = format!(
        "[system]\nperiod = \"2*pi\"\n\
         mass = [[1.15625, 0, 0], [0, 1.984375, 0], [0, 0, 1.59375]]\n\
         damping = [[0.546875, -0.3125, 0], [-0.3125, 0.59375, -0.28125], [0, -0.28125, 0.28125]]\n\
         stiffness = [[1.921875, -0.5, 0], [-0.5, 1.125, -0.625], [0, -0.625, 0.625]]\n\
         forcing = [{{ cos = [\"cos({turn})\", 0, 0], sin = [\"-sin({turn})\", 0, 0] }}]\n\
         [[stops]]\nname = \"stop\"\nrow = [0, 0, -1]\noffset = -0.29296875\nstiffness = 12.515625\ndamping = 0.5\n\
         [[tasks]]\nname = \"two\"\nkind = \"orbit\"\norbit = {{ period = 2, starts = 3 }}\n"
    );
    let [report] = &reports(&scene)[..] else { panic!("one task") };
    let all = report["orbits"].as_array().unwrap();
    let [orbit] = &all[..] else { panic!("{all:?}") };
    let multiplier = orbit["multipliers"][0][0].as_f64().unwrap();
    assert!(orbit["pattern"] == "free 2" && (multiplier - 0.560739).abs() < 1e-6, "{orbit}");
}
